//! Every vehicle of the library by a second calculation, families against what defines them, and Route Availability numbers.

use rules::{Library, Pattern, Stretch, Vehicle, library, read_load_model};

const SPANS: [f64; 20] =
    [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 25.0, 30.0, 40.0];

fn vehicle<'a>(library: &'a Library, code: &str) -> &'a Vehicle {
    library.vehicle(code).unwrap_or_else(|| panic!("no vehicle {code}")).1
}

/// Moment at a section, or the left reaction, with the first axle at `s`: ordinates of influence lines, and areas under them
/// for uniform loads.
fn effect(pattern: &Pattern, span: f64, section: Option<f64>, s: f64) -> f64 {
    let ordinate = |at: f64| match section {
        _ if at < -1e-9 || at > span + 1e-9 => 0.0,
        None => 1.0 - at / span,
        Some(x) => at.min(x) * (span - at.max(x)) / span,
    };
    let area = |stretch: &Stretch| {
        let [a, b] = [(s - stretch.to).clamp(0.0, span), (s - stretch.from).clamp(0.0, span)];
        // The influence line is straight on either side of the section: the trapezoidal rule is exact on each.
        let corner = section.unwrap_or(a).clamp(a, b);
        0.5 * (corner - a) * (ordinate(a) + ordinate(corner)) + 0.5 * (b - corner) * (ordinate(corner) + ordinate(b))
    };
    pattern.axles.iter().map(|axle| axle.force * ordinate(s - axle.offset)).sum::<f64>()
        + pattern.stretches.iter().map(|stretch| stretch.force * area(stretch)).sum::<f64>()
}

/// Places of the first axle that are tried for one section: each axle and each end of a uniform load at the section and at
/// the supports, and between them where uniform loads move.
fn places(pattern: &Pattern, span: f64, section: f64) -> Vec<f64> {
    let ends = pattern.stretches.iter().flat_map(|s| [s.from, s.to]).filter(|end| end.is_finite());
    let edges: Vec<f64> = pattern.axles.iter().map(|axle| axle.offset).chain(ends).collect();
    let mut places: Vec<f64> = edges.iter().flat_map(|edge| [section + edge, *edge, span + edge]).collect();
    places.push(0.0);
    places.sort_by(f64::total_cmp);
    if pattern.stretches.iter().any(|s| s.from.is_finite() || s.to.is_finite()) {
        let last = places[places.len() - 1] + span;
        places.push(last);
        let within =
            |pair: &[f64]| (1..8).map(|k| pair[0] + (pair[1] - pair[0]) * f64::from(k) / 8.0).collect::<Vec<_>>();
        let between: Vec<f64> = places.windows(2).flat_map(within).collect();
        places.extend(between);
    }
    places
}

/// Greatest moment and shear by trying.
fn by_trial(pattern: &Pattern, span: f64) -> [f64; 2] {
    let mut most = [0.0f64; 2];
    for section in (1..60).map(|k| span * f64::from(k) / 60.0) {
        for s in places(pattern, span, section) {
            most[0] = most[0].max(effect(pattern, span, Some(section), s));
        }
    }
    for pattern in [pattern.clone(), pattern.reversed()] {
        for s in places(&pattern, span, 0.0) {
            most[1] = most[1].max(effect(&pattern, span, None, s));
        }
    }
    most
}

/// Trial never finds more, and misses a peak by half a per cent at most.
#[test]
fn every_vehicle_on_twenty_spans_is_that_of_a_second_calculation() {
    let library = library().unwrap();
    let mut checked = 0;
    for (_, vehicle) in library.vehicles() {
        for pattern in vehicle.patterns() {
            for span in SPANS {
                let tried = by_trial(&pattern, span);
                let found = [rules::greatest_bending(&pattern, span), rules::greatest_shear(&pattern, span)];
                for (k, (tried, found)) in tried.iter().zip(found).enumerate() {
                    let over = found / tried - 1.0;
                    assert!(
                        (-1e-9..5e-3).contains(&over),
                        "{} {span} m, {k}: {found} {tried} {over:+.1e}",
                        vehicle.code
                    );
                }
                checked += 1;
            }
        }
    }
    assert!(checked > 2000, "{checked}");
}

/// A category of lines is an axle load and a mass per metre: the reference wagons have both. The masses per metre are from
/// memory.
#[test]
fn reference_wagons_have_the_mass_per_metre_of_their_category() {
    let library = library().unwrap();
    for (code, axle, per_metre) in [
        ("a", 16.0, 5.0),
        ("b1", 18.0, 5.0),
        ("b2", 18.0, 6.4),
        ("c2", 20.0, 6.4),
        ("c3", 20.0, 7.2),
        ("c4", 20.0, 8.0),
        ("d2", 22.5, 6.4),
        ("d3", 22.5, 7.2),
        ("d4", 22.5, 8.0),
        ("d5", 22.5, 8.8),
        ("e4", 25.0, 8.0),
        ("e5", 25.0, 8.8),
    ] {
        let train = &vehicle(&library, &format!("en15528-{code}")).patterns()[0];
        assert_eq!(train.axles.len(), 16, "four wagons");
        let wagon = train.axles[4].offset;
        let mass = train.axles.iter().take(4).map(|a| a.force / 9810.0).sum::<f64>();
        assert!((train.axles[0].force / 9810.0 - axle).abs() < 1e-6, "{code}");
        assert!((mass / wagon - per_metre).abs() < 0.02, "{code}: {}", mass / wagon);
    }
}

/// Weights of the vehicles that are named after them.
#[test]
fn vehicles_weigh_what_they_are_called() {
    let library = library().unwrap();
    let weight = |code: &str| vehicle(&library, code).axle_loads_kn.iter().sum::<f64>();
    for (code, tonnes) in
        [("3", 3.0), ("7.5", 7.5), ("10", 10.0), ("13", 13.0), ("18", 18.0), ("26", 26.0), ("40", 40.0), ("44", 44.0)]
    {
        assert!((weight(&format!("gb-{code}t")) - 9.81 * tonnes).abs() < 1e-6, "{code}");
    }
    const TON: f64 = 2.0 * 4.448_221_6;
    for (code, tons) in [
        ("type-3", 25.0),
        ("type-3s2", 36.0),
        ("type-3-3", 40.0),
        ("su4", 27.0),
        ("su5", 31.0),
        ("su6", 34.75),
        ("su7", 38.75),
    ] {
        assert!((weight(&format!("aashto-{code}")) - TON * tons).abs() < 1e-4, "{code}");
    }
    for (code, newtons) in [("600-150", 600.0), ("1500-200", 1500.0), ("2400-200-200", 2400.0), ("3600-200", 3600.0)] {
        assert_eq!(weight(&format!("lm3-{code}")), newtons);
    }
    assert_eq!(weight("sv-196"), 1945.0);
}

/// Bogies with the axle loads of Network Rail's table have the numbers of that table, and each vehicle of the library its own.
#[test]
fn a_vehicle_has_a_route_availability_number() {
    let library = library().unwrap();
    let number = |vehicle: &Vehicle| library.route_availability(vehicle, &SPANS).unwrap().number;
    for n in 1..=15 {
        assert_eq!(number(vehicle(&library, &format!("ra{n}"))), n);
    }
    let wagons = |tonnes: f64| {
        let axles = [0.0, 1.8, 4.4, 6.2].map(|at| (9810.0 * tonnes, at));
        Vehicle::of_axles("wagons", "bogies of two wagons", &axles, 0.25, 1.5)
    };
    for (tonnes, n) in [(16.5, 3), (19.0, 5), (22.8, 8), (25.4, 10)] {
        assert_eq!(number(&wagons(tonnes)), n, "{tonnes} t");
    }
    // One axle alone: a quarter of the force per unit in bending, all of it in shear, wherever the reference has one as well.
    let one = Vehicle::of_axles("axle", "one axle", &[(245_250.0, 0.0)], 0.25, 1.5);
    let found = library.route_availability(&one, &[1.0, 20.0]).unwrap();
    assert_eq!(found.units.len(), 1, "20 m is beyond the reference loading");
    let units = 25.0 / 1.27;
    assert!((found.units[0].bending / units - 1.0).abs() < 1e-3 && (found.units[0].shear / units - 1.0).abs() < 1e-3);
    assert_eq!(library.route_availability(&one, &[20.0]), None);
    // More of the same is worth more.
    let [double, single] =
        [90.0, 45.0].map(|tonnes| rules::equivalent_units(&wagons(tonnes), &wagons(45.0), 1.0, &SPANS));
    for (a, b) in double.iter().zip(&single) {
        assert!((a.governing() - 2.0).abs() < 1e-9 && (b.bending - 1.0).abs() < 1e-9, "{a:?} {b:?}");
    }
}

/// Two uniform loads with a gap, and no axle: what is read, and what is refused.
#[test]
fn a_vehicle_may_be_uniform_loads_alone() {
    let library = library().unwrap();
    let sw = &vehicle(&library, "sw-2").patterns()[0];
    assert_eq!((sw.axles.len(), sw.length()), (0, 57.0));
    assert!(sw.is_symmetric());
    assert_eq!((sw.stretches[1].from, sw.stretches[1].to), (32.0, 57.0));
    // Both parts with the gap over midspan of a longer span: less than one part in the middle with the other beside it.
    let [bending, shear] = rules::greatest_of(vehicle(&library, "sw-0"), 40.0);
    let part = 133e3 * 15.0 * (40.0 / 4.0 - 15.0 / 8.0);
    assert!(bending > part && bending < 133e3 * 40.0 * 40.0 / 8.0, "{bending} {part}");
    // First part from the support on, the second 20.3 to 35.3 m from it.
    assert!((shear / (133e3 * 15.0 * ((1.0 - 7.5 / 40.0) + (1.0 - 27.8 / 40.0))) - 1.0).abs() < 1e-9, "{shear}");
    let text = |uniform: &str| {
        format!(
            "code = \"mine\"\ntitle = \"t\"\nways = \"rail\"\nsource = {{ text = \"t\", date = \"2026\", confidence = \"read\" }}\n\
             [[vehicle]]\ncode = \"a\"\ntitle = \"a\"\naxle_loads_kn = []\nspacings_m = []\nuniform = [{uniform}]\n\
             axles_may_be_dropped = false\nwheel_track_m = 1.5\ncontact_length_m = 0.25\n"
        )
    };
    let part = "{ load_kn_per_m = 80.0, place = \"part\", length_m = 6.4, may_be_dropped = false }";
    assert!(read_load_model("mine.toml", &text(part)).is_ok());
    for (wrong, key) in [
        (String::new(), "vehicle[0].axle_loads_kn"),
        (part.replace(", length_m = 6.4", ""), "vehicle[0].uniform[0].length_m"),
        (part.replace("6.4", "-1.0"), "vehicle[0].uniform[0].length_m"),
        (part.replace("\"part\"", "\"everywhere\""), "vehicle[0].uniform[0].length_m"),
    ] {
        let found = read_load_model("mine.toml", &text(&wrong)).unwrap_err();
        assert_eq!(found.iter().map(|p| p.key.as_str()).collect::<Vec<_>>(), [key], "{wrong}");
    }
}

/// Every load model has a rule besides the one without safety; new ones are taken only by name, so that a sweep of all that a
/// rule is made for stays what it was.
#[test]
fn every_load_model_has_a_rule() {
    let library = library().unwrap();
    for model in &library.models {
        let rules: Vec<&str> =
            library.rules.iter().filter(|rule| rule.acting(model).is_some()).map(|rule| rule.code.as_str()).collect();
        assert!(rules.contains(&"characteristic"), "{} has no rule", model.code);
        assert!(rules.len() > 1 || model.code == "cooper-e80", "{}: {rules:?}", model.code);
    }
    let listed: Vec<&str> = library.models.iter().filter(|m| !m.only_by_name).map(|m| m.code.as_str()).collect();
    assert_eq!(listed, ["25t-2008", "hml-30t", "lm71", "cooper-e80", "hl-93", "lm1", "cs-454", "ra"]);
    let rating = library.rule("aashto-mbe").unwrap().acting(library.model("aashto-legal").unwrap()).unwrap();
    assert!((rating.axle_factors(5.0, 0.0)[0] - 1.45 * 1.33).abs() < 1e-12);
    assert_eq!(rating.presence(1), 1.2);
}
