//! A load test as its users meet it: what to expect, a table of readings, the moduli, what cannot be used.

use crate::stage::{Stage, number};
use crate::tiny::BRIDGE;
use crate::update::{SOUGHT, parameter};

/// The tiny bridge as a road with a lorry at rest; readings are in a table that nobody has written yet.
fn road() -> String {
    let (before, rest) = BRIDGE.split_once("[train]").expect("a train");
    let (_, after) = rest.split_once("[passage]").expect("a passage");
    let sensors = after.split_once("[[sensor]]").map_or(String::new(), |(_, sensors)| format!("[[sensor]]{sensors}"));
    let lorry = "[vehicle]\nname = \"lorry\"\naxle_loads = [\"8 t\", \"18 t\"]\naxle_spacings = [\"3.6 m\"]\n";
    let mut text = format!("{before}{lorry}\n[load_test]\nreadings = \"readings.csv\"\n");
    for (name, front) in [("one", 0.6), ("two", 1.4), ("three", 2.2), ("four", 3.0), ("five", 3.8), ("six", 5.0)] {
        text += &format!("[[load_test.position]]\nname = \"{name}\"\nvehicle = {{ front_axle = \"{front} m\" }}\n");
    }
    text + &sensors
}

/// What the twin of a passage seeks, without its records.
fn sought() -> String {
    let (_, parameters) = SOUGHT.split_once("[[parameter]]").expect("parameters");
    format!("\n[[parameter]]{parameters}")
}

/// What is expected before anybody has read anything is a table that a load test reads; the moduli behind it are found again.
#[test]
fn moduli_are_found_from_a_table_of_readings() {
    let stage = Stage::new("load-test-twin");
    let bridge = road();
    stage.write("truth.toml", bridge.replace("\"10 GPa\"", "\"13 GPa\"").replace("\"100 MPa\"", "\"170 MPa\""));
    let (expected, ending) = stage.object(&["respond", "truth.toml", "--out", "truth"]);
    assert_eq!(ending.code, Some(0), "{expected}");
    let positions = expected["positions"].as_array().expect("positions");
    assert_eq!((positions.len(), positions[1]["name"].as_str()), (6, Some("two")));
    let unknowns = number(&expected, "degrees_of_freedom");
    assert!(unknowns > 100.0 && number(&expected, "condensed_degrees_of_freedom") < unknowns, "{expected}");
    let first = expected["channels"][0]["name"].as_str().expect("a name");
    let values: Vec<f64> = positions.iter().filter_map(|one| one["channels"][first].as_f64()).collect();
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(values.len() == 6 && (least - number(&expected["channels"][0], "minimum")).abs() < 1e-12, "{values:?}");
    assert!(positions[0].get("readings").is_none() && expected["channels"][0]["time_of_peak_s"].is_null());
    let table = stage.read("truth/positions.csv");
    assert!(
        table.starts_with("position,crown_mm,quarter_mm,strain_microstrain") && table.lines().count() == 7,
        "{table}"
    );
    assert!(!stage.folder.join("truth/channels.csv").exists(), "nothing crossed");

    stage.write("bridge.toml", format!("{bridge}{}", sought()));
    let (missing, ending) = stage.object(&["update", "bridge.toml"]);
    assert_eq!((ending.code, missing["errors"][0]["code"].as_str()), (Some(2), Some("F101")), "{missing}");
    stage.write("readings.csv", format!("# synthetic: twin\n{table}"));
    let (found, ending) = stage.object(&["update", "bridge.toml", "--out", "found"]);
    assert_eq!(ending.code, Some(0), "{found}");
    assert!((parameter(&found, "stone") / 13.0 - 1.0).abs() < 5e-3, "{}", found["parameters"]);
    assert!((parameter(&found, "fill") / 170.0 - 1.0).abs() < 5e-3, "{}", found["parameters"]);
    assert!(found["warnings"].to_string().contains("computed and not measured: readings.csv"), "{}", found["warnings"]);
    assert_eq!(found["positions"].as_array().map(Vec::len), Some(6));
    assert!(stage.read("found/readings.csv").lines().count() == 7);
    // The summary of what to expect has what was read below it.
    let shown = stage.run(&["respond", "bridge.toml", "--out", "shown"]);
    assert!(shown.stdout.contains("6 positions at rest") && shown.stdout.contains("  read"), "{}", shown.stdout);
    let (checked, ending) = stage.object(&["check", "bridge.toml"]);
    assert_eq!(ending.code, Some(0), "{checked}");
}

/// Before anyone goes out `check` tells which positions and sensors tell most; nothing can be found yet.
#[test]
fn a_load_test_that_nobody_has_read_is_planned() {
    let stage = Stage::new("load-test-plan");
    let unread =
        road().replace("readings = \"readings.csv\"\n", "uncertainty = { \"crown\" = \"0.01 mm\" }\n") + &sought();
    stage.write("bridge.toml", &unread);
    let (checked, ending) = stage.object(&["check", "bridge.toml"]);
    assert_eq!(ending.code, Some(0), "{checked}");
    let plan = &checked["plan"];
    let ordered = |list: &str| {
        let bits: Vec<f64> =
            plan[list].as_array().expect("a list").iter().map(|one| number(one, "information_bit")).collect();
        assert!(bits.len() > 1 && bits.iter().sum::<f64>() < number(plan, "information_bit") + 1e-6, "{plan}");
        bits
    };
    assert!(ordered("positions").is_sorted_by(|a, b| a >= b) && ordered("sensors")[0] > 1.0, "{plan}");
    let sought = plan["parameters"].as_array().expect("parameters");
    for one in sought {
        let interval = &plan["interval_95"][one["name"].as_str().expect("a name")];
        let end = |of: &serde_json::Value, k: usize| of[k].as_f64().expect("a number");
        let width = |of: &serde_json::Value| end(of, 1) - end(of, 0);
        assert!(width(interval) < width(&one["range"]) && end(interval, 0) <= number(one, "start"), "{plan}");
    }
    let words = stage.run(&["check", "bridge.toml"]).stdout;
    for part in
        ["What the load test would tell", "before the test", "the whole test", "No uncertainty is stated for quarter"]
    {
        assert!(words.contains(part), "{words}");
    }
    let (refused, ending) = stage.object(&["update", "bridge.toml"]);
    assert_eq!((ending.code, refused["errors"][0]["code"].as_str()), (Some(2), Some("F130")), "{refused}");
    assert!(refused["errors"][0]["message"].to_string().contains("nothing was read yet"), "{refused}");
    let (expected, ending) = stage.object(&["respond", "bridge.toml"]);
    assert_eq!(ending.code, Some(0), "{expected}");
}

#[test]
fn a_table_of_readings_is_refused_with_its_lines_where_it_is_needed() {
    let stage = Stage::new("load-test-table");
    stage.write("bridge.toml", format!("{}{}", road(), sought()));
    stage.write("readings.csv", "position,crown [mm],crown strain [microstrain]\none,-0.1,2\nseven,-0.1,3\ntwo,x,\n");
    let (refused, ending) = stage.object(&["update", "bridge.toml"]);
    assert_eq!((ending.code, refused["errors"][0]["code"].as_str()), (Some(2), Some("F130")), "{refused}");
    let words = refused["errors"][0]["message"].as_str().expect("a message");
    for part in [
        "line 1: \"crown strain [microstrain]\" is no sensor",
        "line 3: there is no position \"seven\"",
        "line 4, crown: ",
    ] {
        assert!(words.contains(part), "{words}");
    }
    let (expected, ending) = stage.object(&["respond", "bridge.toml"]);
    assert_eq!(ending.code, Some(0), "what to expect needs no readings: {expected}");
    stage.write("beside.toml", road().replace("front_axle = \"5 m\"", "front_axle = \"500 m\""));
    for command in ["respond", "check"] {
        let (refused, ending) = stage.object(&[command, "beside.toml"]);
        assert_eq!((ending.code, refused["errors"][0]["code"].as_str()), (Some(2), Some("F108")), "{refused}");
        assert!(
            refused["errors"][0]["message"].to_string().contains("position \\\"six\\\" of [load_test]"),
            "{refused}"
        );
    }
}
