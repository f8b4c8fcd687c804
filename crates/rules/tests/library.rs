//! The library reads without complaint, and its numbers are the published ones.

use rules::{Confidence, Impact, Pattern, library, read_load_model, read_rule};

#[test]
fn every_file_is_read_and_every_source_is_named() {
    let library = library().unwrap_or_else(|problems| panic!("{problems:?}"));
    assert_eq!(library.models.len(), 8);
    assert_eq!(library.rules.len(), 4);
    let codes: Vec<&str> = library.vehicles().map(|(_, v)| v.code.as_str()).collect();
    for (k, code) in codes.iter().enumerate() {
        assert!(!codes[..k].contains(code), "{code} is there twice");
    }
}

#[test]
fn every_load_model_gives_its_own_published_table() {
    let library = library().unwrap();
    let rule = library.rule("irs-bridge-rules");
    let mut rows = 0;
    for model in &library.models {
        let checked = rules::check(model, rule);
        assert!(!checked.is_empty(), "{} is checked against nothing", model.code);
        for row in &checked {
            assert!(row.agrees(), "{row:?}: {:+.2e}", row.difference());
        }
        rows += checked.len();
    }
    assert!(rows > 55, "{rows}");
}

#[test]
fn published_numbers_that_no_vehicle_gives_are_still_read() {
    let library = library().unwrap();
    let model = library.model("25t-2008").unwrap();
    assert_eq!(model.published(rules::Quantity::EudlBending, 12.0), Some(1377.32));
    let between = model.published(rules::Quantity::EudlBending, 11.0).unwrap();
    assert!((between - 0.5 * (1108.53 + 1377.32)).abs() < 1e-9);
    assert_eq!(model.published(rules::Quantity::EudlBending, 20.0), None);
}

#[test]
fn dynamic_augment_falls_with_fill() {
    let library = library().unwrap();
    let rule = library.rule("irs-bridge-rules").unwrap();
    let at = |depth: f64| rule.impact.design_augment(6.0, depth).unwrap();
    let total = 0.15 + 8.0 / 12.0;
    assert!((at(0.0) - total).abs() < 1e-12);
    assert!((at(0.45) - 0.75 * total).abs() < 1e-12, "half of (2 - d / 0.9)");
    assert!((at(0.9) - 0.5 * total).abs() < 1e-12);
    assert!((at(2.4) - 0.25 * total).abs() < 1e-12);
    assert_eq!(at(4.0), 0.0);
    // The railway paper's design CDA of about 0.60 belongs to a cushion of about 0.48 m.
    assert!((at(0.48) - 0.60).abs() < 0.005, "{}", at(0.48));
    assert_eq!(rule.load_factors(6.0, 0.9)[0], 1.0 + 0.5 * total);
}

#[test]
fn widths_and_lengths_are_those_of_the_rules() {
    let library = library().unwrap();
    let road = library.rule("cs-454").unwrap();
    assert!((road.dispersal.length_at(0.5) - 0.8).abs() < 1e-12);
    assert!((road.dispersal.width_at(0.5, 1.8) - 3.8).abs() < 1e-12);
    assert_eq!(road.dispersal.slope(), 2.0);
    assert_eq!(road.effective_width(1.8, 0.5, 3.0), 3.0, "at most the barrel");
    assert_eq!(road.load_factors(5.0, 0.5), [1.9, 1.8]);
    assert!(
        matches!(&road.impact, Impact::CriticalAxle { factor } if factor.source.confidence == Confidence::Recalled)
    );
}

/// Condition multiplies what the bridge carries, the model factor divides it.
#[test]
fn a_poor_condition_and_a_doubtful_model_lessen_the_capacity() {
    let rule = include_str!("../data/rules/cs-454.toml");
    let with = |name: &str, value: &str| {
        let own =
            rule.replacen(&format!("[factors.{name}]\nvalue = 1.0"), &format!("[factors.{name}]\nvalue = {value}"), 1);
        read_rule("own.toml", &own).unwrap().capacity_factor()
    };
    assert_eq!((with("condition", "0.8"), with("model", "1.25")), (0.8, 0.8));
}

#[test]
fn patterns_are_every_distance_with_every_lift_off() {
    let library = library().unwrap();
    let patterns = |code: &str| library.vehicle(code).unwrap().1.patterns();
    let hb = patterns("hb-45");
    let lengths: Vec<f64> = hb.iter().map(Pattern::length).collect();
    assert!(lengths.iter().zip([9.6, 14.6, 19.6, 24.6, 29.6]).all(|(a, b)| (a - b).abs() < 1e-9), "{lengths:?}");
    assert_eq!(hb.len(), 5);
    assert!(hb.iter().all(Pattern::is_symmetric));
    let bogie = patterns("cs454-bogie-8");
    assert_eq!(bogie.len(), 2 * 3);
    assert!(!bogie[1].is_symmetric() && bogie[1].label.contains("lift-off 1.5/0.5"), "{:?}", bogie[1]);
    let lm71 = &patterns("lm71")[0];
    assert!(lm71.is_symmetric() && lm71.stretches.len() == 2);
    let back = lm71.reversed().reversed();
    assert!(back.axles.iter().zip(&lm71.axles).all(|(a, b)| (a.offset - b.offset).abs() < 1e-12));
}

#[test]
fn complaints_name_file_and_key() {
    let wrong = read_load_model("mine.toml", "code = \"mine\"\ntitle = 3\n").unwrap_err();
    assert_eq!((wrong[0].file.as_str(), wrong[0].line, wrong[0].key.as_str()), ("mine.toml", 2, "title"));
    let text = "code = \"mine\"\ntitle = \"t\"\nways = \"road\"\n\
        source = { text = \"\", date = \"2026\", confidence = \"read\" }\n\
        [[vehicle]]\ncode = \"a\"\ntitle = \"a\"\naxle_loads_kn = [10.0, -1.0]\nspacings_m = []\n\
        axles_may_be_dropped = false\nwheel_track_m = 1.8\ncontact_length_m = 0\n";
    let wrong = read_load_model("mine.toml", text).unwrap_err();
    let keys: Vec<&str> = wrong.iter().map(|p| p.key.as_str()).collect();
    assert_eq!(
        keys,
        ["source", "vehicle[0].axle_loads_kn", "vehicle[0].spacings_m", "vehicle[0].contact_length_m"],
        "all at once"
    );
    // No factor is silently one: a rule without its condition factor is no rule.
    let rule = include_str!("../data/rules/cs-454.toml");
    for name in ["weight_favourable", "surfacing_weight"] {
        let other = rule.replacen(&format!("[factors.{name}]"), "[factors.something_else]", 1);
        let wrong = read_rule("mine.toml", &other).unwrap_err();
        assert!(wrong[0].message.contains("something_else"), "{wrong:?}");
    }
    let cut = rule.find("[factors.condition]").unwrap();
    let wrong = read_rule("mine.toml", &rule[..cut]).unwrap_err();
    assert!(wrong[0].message.contains("condition"), "{wrong:?}");
    assert!(read_rule("mine.toml", "\u{0}=[").is_err());
}

/// Moments and reactions by adding up, over a fine grid of sections and places: another road to the same numbers.
#[test]
fn greatest_values_are_those_of_a_fine_grid() {
    let library = library().unwrap();
    let mut checked = 0;
    for (_, vehicle) in library.vehicles() {
        for pattern in vehicle.patterns().iter().take(3) {
            for span in [2.3, 7.1, 15.0] {
                let (moment, shear) = by_grid(pattern, span);
                let bending = rules::greatest_bending(pattern, span);
                let found = [bending.value / moment, rules::greatest_shear(pattern, span).value / shear];
                // A grid misses the peak: by the square of its step for moments, by its step for shears.
                assert!((1.0 - 1e-9..1.0 + 4e-3).contains(&found[0]), "{} {span}: {found:?}", vehicle.code);
                assert!((1.0 - 1e-9..1.0 + 2e-2).contains(&found[1]), "{} {span}: {found:?}", vehicle.code);
                checked += 1;
            }
        }
    }
    assert!(checked > 50);
}

fn by_grid(pattern: &Pattern, span: f64) -> (f64, f64) {
    let (mut moment, mut shear) = (0.0f64, 0.0f64);
    let reach = pattern.length() + 2.0 * span;
    for k in 0..=((span + reach) / 0.02) as usize {
        let s = 0.02 * k as f64 - 0.5 * span;
        let mut loads: Vec<(f64, f64)> = pattern.axles.iter().map(|a| (a.force, s - a.offset)).collect();
        const CELLS: usize = 60;
        for stretch in &pattern.stretches {
            let [a, b] = [(s - stretch.to).clamp(0.0, span), (s - stretch.from).clamp(0.0, span)];
            let cell = (b - a) / CELLS as f64;
            loads.extend((0..CELLS).map(|c| (stretch.force * cell, a + cell * (c as f64 + 0.5))));
        }
        loads.retain(|(_, at)| (0.0..=span).contains(at));
        let left: f64 = loads.iter().map(|(p, at)| p * (1.0 - at / span)).sum();
        let right: f64 = loads.iter().map(|(p, at)| p * at / span).sum();
        shear = shear.max(left).max(right);
        for section in 1..80 {
            let x = span * section as f64 / 80.0;
            let beside: f64 = loads.iter().filter(|(_, at)| *at < x).map(|(p, at)| p * (x - at)).sum();
            moment = moment.max(left * x - beside);
        }
    }
    (moment, shear)
}
