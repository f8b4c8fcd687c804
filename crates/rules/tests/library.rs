//! The library reads without complaint, and its numbers are the published ones.

use rules::{Confidence, Impact, Pattern, library, read_load_model, read_rule};

#[test]
fn every_file_is_read_and_every_source_is_named() {
    let library = library().unwrap_or_else(|problems| panic!("{problems:?}"));
    assert_eq!(library.models.len(), 19);
    assert_eq!(library.rules.len(), 6);
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
    assert!(rows > 900, "{rows}");
}

/// What is known of each without its drawing: the length of a wagon is its mass over its mass per metre, and trucks weigh what they are called.
#[test]
fn wagons_and_trucks_weigh_what_they_are_called() {
    let library = library().unwrap();
    let known = [
        ("a", 16.0, 5.0),
        ("b2", 18.0, 6.4),
        ("c3", 20.0, 7.2),
        ("c4", 20.0, 8.0),
        ("d2", 22.5, 6.4),
        ("d4", 22.5, 8.0),
        ("e5", 25.0, 8.8),
    ];
    for (name, axle, per_metre) in known {
        let (model, wagon) = library.vehicle(&format!("en15528-{name}")).unwrap();
        assert_eq!((model.grades.as_str(), wagon.grade.to_lowercase().as_str()), ("line category", name));
        let pattern: &Pattern = &wagon.patterns()[0];
        assert!(pattern.axles.iter().all(|one| (one.force - axle * 9.81e3).abs() < 10.0));
        // From the first axle of a wagon to that of the next.
        let length = pattern.axles[4].offset - pattern.axles[0].offset;
        assert!((length / (4.0 * axle / per_metre) - 1.0).abs() < 6e-3, "{name}: {length}");
    }
    for (name, tons) in [
        ("aashto-type-3", 25.0),
        ("aashto-type-3s2", 36.0),
        ("aashto-type-3-3", 40.0),
        ("aashto-su4", 27.0),
        ("aashto-su5", 31.0),
        ("aashto-su6", 34.75),
        ("aashto-su7", 38.75),
    ] {
        let truck = library.vehicle(name).unwrap().1;
        let weight: f64 = truck.axle_loads_kn.iter().sum();
        assert!((weight / (tons * 2.0 * 4.4482216) - 1.0).abs() < 1e-3, "{name}: {weight}");
    }
}

#[test]
fn published_numbers_that_no_vehicle_gives_are_still_read() {
    let library = library().unwrap();
    let model = library.model("25t-2008").unwrap();
    let of_bending = model.published.iter().filter(|table| table.quantity == rules::PublishedQuantity::EudlBending);
    let rows: Vec<_> = of_bending.flat_map(|table| table.spans_m.iter().zip(&table.values)).collect();
    let at = |span: f64| rows.iter().find(|row| *row.0 == span).map(|row| *row.1);
    assert_eq!([at(12.0), at(11.0), at(20.0)], [Some(1377.32), Some(1282.66), None]);
}

#[test]
fn dynamic_augment_falls_with_fill() {
    let library = library().unwrap();
    let rule = library.rule("irs-bridge-rules").unwrap();
    let at = |depth: f64| rule.impact_of("25t-2008").unwrap().factors(6.0, depth)[0] - 1.0;
    let total = 0.15 + 8.0 / 12.0;
    assert!((at(0.0) - total).abs() < 1e-12);
    assert!((at(0.45) - 0.75 * total).abs() < 1e-12, "half of (2 - d / 0.9)");
    assert!((at(0.9) - 0.5 * total).abs() < 1e-12);
    assert!((at(2.4) - 0.25 * total).abs() < 1e-12);
    assert_eq!(at(4.0), 0.0);
    // The railway paper's design CDA of about 0.60 belongs to a cushion of about 0.48 m.
    assert!((at(0.48) - 0.60).abs() < 0.005, "{}", at(0.48));
    let acting = rule.acting(library.model("25t-2008").unwrap()).unwrap();
    assert_eq!(acting.axle_factors(6.0, 0.9)[0], 1.0 + 0.5 * total);
}

#[test]
fn widths_and_lengths_are_those_of_the_rules() {
    let library = library().unwrap();
    let road = library.rule("cs-454").unwrap();
    assert!((road.dispersal.length_at(0.5) - 0.8).abs() < 1e-12);
    assert!((road.dispersal.width_at(0.5, 1.8) - 3.8).abs() < 1e-12);
    assert_eq!(road.dispersal.slope(), 2.0);
    assert_eq!(road.effective_width(1.8, 0.5, 3.0), 3.0, "at most the barrel");
    let acting = road.acting(library.model("cs-454").unwrap()).unwrap();
    assert_eq!(acting.axle_factors(5.0, 0.5), [1.9, 1.8]);
    assert!(
        matches!(&acting.impact, Impact::CriticalAxle { factor } if factor.source.confidence == Confidence::Recalled)
    );
}

/// Loads that contain what motion adds get nothing on top, loads at rest get what their own standard adds, and a rule that
/// was not made for a load model refuses it.
#[test]
fn a_rule_acts_on_the_load_models_it_is_made_for() {
    let library = library().unwrap();
    let acting = |rule: &str, model: &str| library.rule(rule).unwrap().acting(library.model(model).unwrap());
    let factors =
        |rule: &str, model: &str, length: f64, depth: f64| acting(rule, model).unwrap().axle_factors(length, depth);
    assert_eq!(factors("cs-454", "hb", 5.0, 0.5), [1.3, 1.0], "HB contains impact");
    for (rule, model) in [
        ("cs-454", "lm1"),
        ("cs-454", "hl-93"),
        ("cs-454", "25t-2008"),
        ("irs-bridge-rules", "lm71"),
        ("nr-civ-025", "25t-2008"),
        ("en-1991-2", "cs-454"),
    ] {
        assert!(acting(rule, model).is_none(), "{rule} takes {model}");
    }
    // The dynamic allowance of HL-93 falls with depth, to nothing at 8 ft; the lane load has none.
    let hl = acting("characteristic", "hl-93").unwrap();
    assert!((hl.axle_factors(5.0, 0.0)[0] - 1.33).abs() < 1e-12);
    assert!((hl.axle_factors(5.0, 1.2192)[0] - (1.0 + 0.33 * 0.5)).abs() < 1e-12);
    assert_eq!((hl.axle_factors(5.0, 3.0)[0], hl.uniform_factor(5.0, 0.0)), (1.0, 1.0));
    assert_eq!([1, 2, 3, 4].map(|lanes| hl.presence(lanes)), [1.2, 1.0, 0.85, 1.0]);
    // Dynamic factor 3 over half the span, less under more than a metre of cover.
    let phi = |length: f64, depth: f64| factors("characteristic", "lm71", length, depth)[0];
    assert_eq!(phi(6.0, 0.5), 2.0);
    let twenty = 2.16 / (10f64.sqrt() - 0.2) + 0.73;
    assert!((phi(20.0, 0.5) - twenty).abs() < 1e-12 && (phi(20.0, 2.0) - (twenty - 0.1)).abs() < 1e-12);
    assert_eq!(phi(300.0, 0.5), 1.0);
    assert_eq!(factors("characteristic", "lm1", 5.0, 0.5), [1.0, 1.0]);
    // An engineer's own file says what the rule does with it.
    let hb = include_str!("../data/loads/hb.toml").replacen("code = \"hb\"", "code = \"crane\"", 1);
    let rule = library.rule("cs-454").unwrap();
    assert!(rule.acting(&read_load_model("crane.toml", &hb).unwrap()).is_none());
    let source = "source = { text = \"permit\", date = \"2026\", confidence = \"read\" }";
    let own = format!(
        "{hb}\n[[under]]\nrule = \"CS-454\"\nlive_load = {{ value = 1.5, {source} }}\nimpact = {{ kind = \"included\", {source} }}\n"
    );
    let crane = read_load_model("crane.toml", &own).unwrap();
    assert_eq!(rule.acting(&crane).unwrap().axle_factors(5.0, 0.5), [1.5, 1.0]);
    // A general impact in a rule of one's own takes every model of its ways.
    let text = include_str!("../data/rules/cs-454.toml");
    let general = format!("{text}\n[impact]\nkind = \"all-axles\"\nfactor = {{ value = 1.4, {source} }}\n");
    let mine = read_rule("mine.toml", &general).unwrap();
    assert_eq!(mine.acting(library.model("lm1").unwrap()).unwrap().axle_factors(5.0, 0.5), [1.9 * 1.4, 1.0]);
    assert!(mine.acting(library.model("lm71").unwrap()).is_none());
}

/// Each rail has a strip of its own, which grows to the distance of the rails and no further.
#[test]
fn network_rail_spreads_each_rail_over_a_strip_of_its_own() {
    let library = library().unwrap();
    let rail = library.rule("nr-civ-025").unwrap();
    let width = |depth: f64| rail.effective_width(1.5, depth, 20.0);
    assert!((width(0.0) - 1.6).abs() < 1e-12, "two strips of 0.8 m");
    assert!((width(0.3) - 2.8).abs() < 1e-12, "two strips of 1.4 m");
    assert!((width(0.35) - 3.0).abs() < 1e-12 && (width(1.5) - 3.0).abs() < 1e-12, "no more than 1.5 m each");
}

/// Every published row is covered: none lies below the table, none far above it.
#[test]
fn the_indian_loading_covers_its_table_up_to_fourteen_metres() {
    let library = library().unwrap();
    let model = library.model("25T-2008").unwrap();
    assert!(model.published.iter().all(|table| table.not_from_vehicle.is_empty()));
    let rows = rules::check(model, library.rule("irs-bridge-rules"));
    for row in &rows {
        assert!(
            row.agrees() && row.difference() > -1.1e-3 && row.difference() < 0.053,
            "{row:?}: {}",
            row.difference()
        );
    }
    assert_eq!(model.span_limit.as_ref().unwrap().longest_m, 14.0);
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
    let lines: Vec<usize> = wrong.iter().map(|p| p.line).collect();
    assert_eq!(lines, [4, 8, 9, 12], "each with its place");
    // Slips of every kind are reported at once.
    let slips = text
        .replace("ways = \"road\"", "ways = \"water\"")
        .replace("axle_loads_kn", "axle_loads")
        .replace("= 1.8", "= \"1.8 m\"");
    let keys: Vec<(usize, String)> =
        read_load_model("mine.toml", &slips).unwrap_err().into_iter().map(|p| (p.line, p.key)).collect();
    let wanted =
        [(3, "ways"), (5, "vehicle[0].axle_loads_kn"), (8, "vehicle[0].axle_loads"), (11, "vehicle[0].wheel_track_m")];
    assert_eq!(keys, wanted.map(|(line, key)| (line, key.to_owned())));
    // No factor is silently one: a rule without its condition factor is no rule.
    let rule = include_str!("../data/rules/cs-454.toml");
    for name in ["weight_favourable", "surfacing_weight"] {
        let other = rule.replacen(&format!("[factors.{name}]"), "[factors.something_else]", 1);
        let wrong = read_rule("mine.toml", &other).unwrap_err();
        assert!(wrong.iter().any(|p| p.message.contains("something_else")), "{wrong:?}");
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
                let found = [bending / moment, rules::greatest_shear(pattern, span) / shear];
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

/// What the reader takes and what the list of keys says are the same: every key of every file of the library has a card, and
/// a card without a field would be refused by the reader.
#[test]
fn the_list_of_keys_is_what_the_reader_takes() {
    let with = |text: &str| rules::read_rule("r.toml", text);
    let rule = include_str!("../data/rules/cs-454.toml");
    let source = "source = { text = \"t\", date = \"2026\", confidence = \"read\", note = \"n\" }";
    for impact in [
        format!("kind = \"included\"\n{source}"),
        format!(
            "kind = \"all-axles\"\nfactor = {{ value = 1.2, {source} }}\nfill = {{ depth_m = 1.0, share = 0.5, vanishing_m = 1.0, {source} }}"
        ),
        format!("kind = \"critical-axle\"\nfactor = {{ value = 1.2, {source} }}"),
        format!("kind = \"augment\"\nbase = 0.15\nnumerator_m = 8.0\naddend_m = 6.0\nmost = 1.0\n{source}"),
        format!(
            "kind = \"root\"\nnumerator = 2.16\nsubtrahend = 0.2\nconstant = 0.73\nshare = 0.5\nleast = 1.0\nmost = 2.0\n{source}\n\
             cover = {{ from_m = 1.0, per_m = 0.1, {source} }}"
        ),
    ] {
        let text = format!("{rule}\n[impact]\n{impact}\n");
        assert!(with(&text).is_ok(), "{impact}: {:?}", with(&text));
    }
    let page = include_str!("../../../docs/input/vehicles.md");
    fn look(shape: &rules::shape::Shape, page: &str) {
        use rules::shape::Kind;
        for key in shape.keys {
            assert!(
                page.contains(&format!("`{}`", key.name)),
                "docs/input/vehicles.md lacks `{}` of {}",
                key.name,
                shape.name
            );
            match key.kind {
                Kind::Table(inner) | Kind::Tables(inner) => look(inner, page),
                Kind::Tagged(forms) => forms.iter().for_each(|form| look(form.1, page)),
                _ => {}
            }
        }
    }
    let example = page.split("```toml\n").nth(2).unwrap().split("```").next().unwrap();
    let lorry = read_load_model("our-lorry.toml", example).unwrap();
    assert_eq!(library().unwrap().rule("cs-454").unwrap().acting(&lorry).unwrap().axle_factors(5.0, 0.5), [1.9, 1.8]);
    look(rules::LoadModel::SHAPE, page);
    look(rules::Rule::SHAPE, page);
}
