//! Levels of loading, traffic beside, overload, shallow cover, and tables that nobody published.

use rules::{Confidence, library, read_load_model};

/// 40 and 44 t are the whole of normal traffic by CS 454: six load cases beside the vehicle's own.
#[test]
fn a_level_holds_every_load_case_of_its_table() {
    let library = library().unwrap();
    let labels = |code: &str| -> Vec<String> {
        library.vehicle(code).unwrap().1.patterns().into_iter().map(|pattern| pattern.label).collect()
    };
    let all = library.model("cs-454").unwrap();
    for code in ["gb-40t", "gb-44t"] {
        let own = labels(code);
        for case in &all.vehicles {
            let of_case = own.iter().filter(|label| label.split(',').next() == Some(case.code.as_str())).count();
            assert_eq!(of_case, case.patterns().len(), "{code} {}", case.code);
        }
        assert_eq!(own.len(), 1 + all.vehicles.iter().map(|v| v.patterns().len()).sum::<usize>());
    }
    // CS 454, Table 7.3.1a: heaviest axle of each level [t], alone or within.
    for (code, tonnes) in [
        ("gb-3t", 2.0),
        ("gb-7.5t", 5.5),
        ("gb-10t", 7.0),
        ("gb-13t", 9.0),
        ("gb-18t", 11.5),
        ("gb-26t", 11.5),
        ("gb-40t", 11.5),
        ("gb-44t", 11.5),
        ("gb-fire-1", 10.0),
        ("gb-fire-2", 5.0),
    ] {
        let vehicle = library.vehicle(code).unwrap().1;
        let of_level = vehicle.level.iter().flat_map(|other| &other.axle_loads_kn);
        let heaviest = vehicle.axle_loads_kn.iter().chain(of_level).fold(0.0, |most: f64, load| most.max(*load));
        assert!((heaviest - 9.81 * tonnes).abs() < 1e-6, "{code}: {heaviest}");
    }
    assert!(labels("gb-26t").iter().any(|label| label.starts_with("cs454-bogie-9.5")), "two of 9.5 t");
}

/// A name that is not there, or stands on the road in another way, is told.
#[test]
fn a_level_of_unknown_vehicles_is_refused() {
    let text = "code = \"mine\"\ntitle = \"t\"\nways = \"road\"\nsource = { text = \"t\", date = \"2026\", confidence = \"read\" }\n\
        [[vehicle]]\ncode = \"a\"\ntitle = \"a\"\naxle_loads_kn = [90.0]\nspacings_m = []\naxles_may_be_dropped = true\n\
        wheel_track_m = 1.8\ncontact_length_m = 0.3\nwith = [\"NAME\"]\n";
    for (name, problems) in [("cs454-single", 0), ("hb-45", 1), ("crane", 1)] {
        let mut library = library().unwrap();
        library.models.push(read_load_model("mine.toml", &text.replace("NAME", name)).unwrap());
        assert_eq!(library.join_levels().len(), problems, "{name}");
    }
}

/// CS 458: 1.2 on the critical axle and 1.1 on the others, beside what motion adds and the factor on loads.
#[test]
fn axles_of_sv_are_overloaded() {
    let library = library().unwrap();
    let acting = library.rule("cs-454").unwrap().acting(library.model("sv").unwrap()).unwrap();
    let [all, critical] = acting.axle_factors(5.0, 0.5);
    assert!((all - 1.1 * 1.16 * 1.1).abs() < 1e-12 && (all * critical - 1.1 * 1.16 * 1.2).abs() < 1e-12);
    for model in ["sv", "hb"] {
        let acting = library.rule("cs-454").unwrap().acting(library.model(model).unwrap()).unwrap();
        assert_eq!(acting.beside.map(|beside| beside.vehicles), Some(vec!["cs-454".to_owned()]), "{model}");
    }
}

/// AASHTO LRFD, 3.6.1.2.6: wheels spread through more than 2 ft of fill, and not through less.
#[test]
fn shallow_fill_spreads_nothing_by_aashto() {
    let library = library().unwrap();
    let rule = library.rule("aashto-mbe").unwrap();
    for depth in [0.0, 0.25, 0.6] {
        assert_eq!(
            (rule.dispersal.length_at(depth), rule.dispersal.width_at(depth, 1.8)),
            (0.25, 1.8 + 0.51),
            "{depth}"
        );
    }
    assert!((rule.dispersal.length_at(0.62) - (0.25 + 1.15 * 0.62)).abs() < 1e-12);
    assert!((rule.effective_width(1.8, 1.0, 9.0) - (1.8 + 0.51 + 1.15)).abs() < 1e-12);
    // Every other rule spreads from the surface on.
    let others = library.rules.iter().filter(|rule| rule.code != "aashto-mbe");
    assert!(others.into_iter().all(|rule| rule.dispersal.least_depth_m == 0.0));
}

/// EN 1991-2, Annex A: lines of 240 kN are three strips on 4.5 m, and occupy two lanes; lines of 150 and 200 kN are two strips on one lane.
#[test]
fn special_vehicles_stand_on_strips_of_1_2_m() {
    let library = library().unwrap();
    for vehicle in &library.model("lm3").unwrap().vehicles {
        let heavy = vehicle.axle_loads_kn[0] == 240.0;
        // Middles of the outer strips of 1.2 m, 0.3 m apart.
        let (track, lanes) = if heavy { (3.0, 2) } else { (1.5, 1) };
        assert_eq!((vehicle.wheel_track_m, vehicle.lanes), (track, lanes), "{}", vehicle.code);
        let total: f64 = vehicle.axle_loads_kn.iter().sum();
        let named: f64 = vehicle.code.split('-').nth(1).unwrap().parse().unwrap();
        assert_eq!(total, named, "{}", vehicle.code);
    }
}

/// `[[published]]` is what somebody else printed; numbers from the same loads by hand are `[[checked]]`.
#[test]
fn numbers_by_hand_are_not_called_published() {
    let library = library().unwrap();
    let hb = library.model("hb").unwrap();
    assert!(hb.published.is_empty() && !hb.checked.is_empty());
    for model in &library.models {
        assert!(
            model.published.iter().all(|table| table.source.confidence != Confidence::Calculated),
            "{}",
            model.code
        );
        assert!(model.checked.iter().all(|table| table.source.confidence == Confidence::Calculated), "{}", model.code);
    }
    let text = include_str!("../data/loads/hb.toml").replacen("[[checked]]", "[[published]]", 1);
    let wrong = read_load_model("hb.toml", &text).unwrap_err();
    assert!(wrong.len() == 1 && wrong[0].message.contains("[[checked]]"), "{wrong:?}");
}
