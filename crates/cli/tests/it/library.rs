//! The vehicles, rules and materials of the library, as `extrados vehicles` and `extrados materials` list them.

use crate::stage::Stage;
use serde_json::Value;

/// Strings under a key of every entry.
fn each<'a>(list: &'a Value, key: &str) -> Vec<&'a str> {
    list.as_array().expect("a list").iter().map(|one| one[key].as_str().expect("a text")).collect()
}

/// Everything that a file may name is listed with its loads, its source and how sure that is, and a file that names it is read.
#[test]
fn vehicles_and_rules_are_listed_with_loads_sources_and_confidence() {
    let stage = Stage::with_example("library", "bridgemill");
    let (answer, ending) = stage.object(&["vehicles"]);
    assert_eq!((ending.code, answer["schema"].as_str()), (Some(0), Some("extrados.vehicles/1")), "{}", ending.stderr);
    let (vehicles, rules) = (&answer["vehicles"], &answer["rules"]);
    for list in [vehicles, rules] {
        for key in ["title", "source", "date"] {
            assert!(each(list, key).iter().all(|text| !text.is_empty()), "{key}: {list}");
        }
        let sure = each(list, "confidence");
        assert!(sure.iter().all(|word| ["read", "calculated", "recalled", "assumed"].contains(word)), "{sure:?}");
    }
    for vehicle in vehicles.as_array().expect("vehicles") {
        let count = |key: &str| vehicle[key].as_array().map_or(0, Vec::len);
        assert!(count("axle_loads_kn") + count("uniform") > 0, "{vehicle}");
        assert_eq!(count("spacings_m"), count("axle_loads_kn").saturating_sub(1), "{vehicle}");
    }
    let text = stage.run(&["vehicles"]).stdout;
    for code in each(vehicles, "code").into_iter().chain(each(rules, "code")) {
        assert!(text.contains(code), "{code} is not in\n{text}");
    }
    assert!(text.contains("cs454-bogie-10") && text.contains("irs-bridge-rules"), "{text}");
    // What somebody published is told apart from numbers worked out by hand; a level names its load cases, a rule what it asks for.
    for words in
        ["69 published numbers in 7 tables", "no published table", "and with it cs454-single", "asks for: braking"]
    {
        assert!(text.contains(words), "{words} is not in\n{text}");
    }
    let hb = vehicles.as_array().expect("vehicles").iter().find(|one| one["code"] == "hb-45").expect("hb-45");
    assert_eq!((&hb["published_numbers"], &hb["checked_numbers"]), (&0.into(), &2.into()));
    // A misspelt name in a file is told with names that stand in this list.
    let file = stage.read("bridge/vehicles.toml").replacen("[dispersal]", "vehicles = [\"hb-46\"]\n\n[dispersal]", 1);
    stage.write("bridge/slip.toml", file);
    let (slip, _) = stage.object(&["check", "bridge/slip.toml"]);
    let said = slip["errors"][0]["message"].as_str().unwrap_or_default().to_owned()
        + slip["errors"][0]["help"].as_str().unwrap_or_default();
    assert!(said.contains("hb-45") && each(vehicles, "code").contains(&"hb-45"), "{slip}");
}

/// A name gives one vehicle, the vehicles of a load model, or a rule with its factors, in capitals or not.
#[test]
fn a_name_gives_one_of_them_and_an_unknown_one_is_refused() {
    let stage = Stage::new("library-one");
    let (one, _) = stage.object(&["vehicles", "HB-45"]);
    assert_eq!((each(&one["vehicles"], "code"), one["rules"].as_array().map(Vec::len)), (vec!["hb-45"], Some(0)));
    let (model, _) = stage.object(&["vehicles", "hb"]);
    let codes = each(&model["vehicles"], "code");
    assert!(codes.len() > 1 && codes.contains(&"hb-45"), "{codes:?}");
    let (both, _) = stage.object(&["vehicles", "cs-454"]);
    let factors = &both["rules"][0]["factors"];
    assert!(each(factors, "name").contains(&"live load") && !each(&both["vehicles"], "code").is_empty(), "{both}");
    assert!(stage.run(&["vehicles", "cs-454"]).stdout.contains("live load: 1.9"));
    let (none, ending) = stage.object(&["vehicles", "hb-46"]);
    assert_eq!((ending.code, none["errors"][0]["code"].as_str()), (Some(2), Some("F126")), "{none}");
    assert!(none["errors"][0]["help"].as_str().is_some_and(|help| help.contains("extrados vehicles")), "{none}");
}

/// Every value of every material fits its key in each table that the material fills: in order, in the unit of the key, within its limits.
#[test]
fn materials_fit_the_tables_that_they_fill() {
    use bridge::quantity::parse;
    let stage = Stage::new("materials");
    let (answer, ending) = stage.object(&["materials"]);
    assert_eq!((ending.code, answer["schema"].as_str()), (Some(0), Some("extrados.materials/1")), "{}", ending.stderr);
    let sections = bridge::fields::sections_of(&bridge::fields::FILE);
    for one in answer["materials"].as_array().expect("materials") {
        let code = one["code"].as_str().expect("a code");
        for value in one["values"].as_array().expect("values") {
            let key = value["key"].as_str().expect("a key");
            let [low, middle, high] = ["least", "usual", "most"].map(|end| {
                let text = value[end].as_str().expect(end);
                parse(text).unwrap_or_else(|_| panic!("{code} {key}: {text}"))
            });
            assert!(low.si() <= middle.si() && middle.si() <= high.si(), "{code} {key}");
            let unit = low.unit.symbol;
            assert!(unit == middle.unit.symbol && unit == high.unit.symbol, "{code} {key}");
            for table in one["tables"].as_array().expect("tables").iter().filter_map(Value::as_str) {
                let section = sections.iter().find(|section| section.path == table);
                let field = section.and_then(|section| section.field(key));
                let field = field.unwrap_or_else(|| panic!("[{table}] has no {key}"));
                assert!(low.si() >= field.limits.least && high.si() <= field.limits.most, "{code} {table}.{key}");
            }
        }
    }
    let (masonry, _) = stage.object(&["materials", "masonry"]);
    assert!(each(&masonry["materials"], "code").contains(&"granite"), "{masonry}");
    assert!(stage.run(&["materials", "granite"]).stdout.contains("SMART"));
    assert_eq!(stage.run(&["materials", "cheese"]).code, Some(2));
}
