//! Named cases side by side, and the report that is signed.

use crate::stage::{Stage, number};

#[test]
fn cases_are_what_their_files_would_be() {
    let stage = Stage::with_example("cases", "packhorse");
    let (answer, ending) = stage.object(&["cases", "bridge/cases.toml"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    let cases = answer["cases"].as_array().expect("cases");
    let factor = |name: &str| {
        let one = cases.iter().find(|one| one["name"] == name).expect("a case");
        one["load_factor"].as_f64().expect("a factor")
    };
    // By hand: the file with the crowd alone, 1.5 times as much, on lighter fill.
    let text = stage.read("bridge/cases.toml");
    let (own, _) = text.split_once("\n[[case]]").expect("cases");
    let (before, rest) = own.split_once("[[load]]").expect("loads");
    let (vehicle, crowd) = rest.split_once("[[load]]").expect("two loads");
    let crowd = format!("{before}[[load]]{crowd}").replace("5 kPa", "7.5 kPa").replace("1800 kg", "1620 kg");
    stage.write("crowd.toml", crowd);
    let by_hand = stage.object(&["collapse", "crowd.toml"]).0;
    let expected = number(&by_hand, "last_stable_load_kn_per_m") / number(&by_hand, "reference_load_kn_per_m");
    assert!((factor("crowd on half the span") / expected - 1.0).abs() < 1e-9, "{expected}");
    let thin = format!("{before}[[load]]{vehicle}").replace("thickness = \"0.33 m\"", "thickness = \"0.27 m\"");
    stage.write("thin.toml", thin);
    let by_hand = stage.object(&["collapse", "thin.toml"]).0;
    let expected = number(&by_hand, "last_stable_load_kn_per_m") / number(&by_hand, "reference_load_kn_per_m") / 1.5;
    assert!((factor("vehicle, ring thinner by 60 mm") / expected - 1.0).abs() < 1e-9, "{expected}");
    // The least governs, and every case has its table row and its drawings.
    let least = cases.iter().map(|one| one["load_factor"].as_f64().expect("a factor")).fold(f64::INFINITY, f64::min);
    assert_eq!(answer["load_factor"].as_f64(), Some(least));
    assert_eq!(answer["governing_case"], "crowd on half the span");
    assert_eq!(stage.read("out/cases/cases.csv").lines().count(), 1 + cases.len());
    for name in ["cases.svg", "tables.xlsx", "case-1/mechanism.png", "case-4/mechanism.svg"] {
        assert!(stage.folder.join("out/cases").join(name).is_file(), "{name}");
    }
}

#[test]
fn a_file_without_cases_says_what_to_write() {
    let stage = Stage::with_example("no-cases", "tiny");
    let (answer, ending) = stage.object(&["cases", "bridge/bridge.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F108")), "{answer}");
}

#[test]
fn a_report_can_be_signed_and_checked() {
    let stage = Stage::with_example("signature", "packhorse");
    let text = stage.read("bridge/bridge.toml");
    // One vehicle, and a photograph that is there beside one that is not.
    let text = text
        .replace("vehicles = [\"gb-restrictions\"]", "vehicles = [\"gb-3t\"]")
        .replace("0.25 m\"\n\n[assess]", "1 m\"\n\n[assess]");
    let inspections = "\n[[document.inspection]]\npart = \"barrel\"\nfinding = \"spalled <b>\"\nphotograph = \"a.png\"\n\n\
                       [[document.inspection]]\npart = \"parapet\"\nfinding = \"leans\"\nphotograph = \"b.jpg\"\n";
    stage.write("bridge/one.toml", format!("{text}{inspections}"));
    stage.write("bridge/a.png", b"\x89PNG\r\n\x1a\n");
    let (answer, ending) = stage.object(&["assess", "bridge/one.toml", "--skip", "sensitivity"]);
    assert!(matches!(ending.code, Some(0 | 1)), "{}", ending.stderr);
    let page = stage.read("out/one/report.html");
    for words in [
        "PH/012",
        "ring thickness inside: drill at the crown",
        "assumed, gritstone rubble",
        "data:image/png;base64,iVBORw0KGgo=",
        "spalled &#60;b&#62;",
        "Check sheet",
        "Dead loads and reactions at rest",
        "m between wheels +",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("<b>\"") && page.contains("b.jpg: "), "a photograph that is missing is named");
    // Vertical reactions carry the dead load.
    let statics = &answer["statics"];
    let up: f64 = statics["reactions"]
        .as_array()
        .expect("reactions")
        .iter()
        .map(|one| one["vertical_kn_per_m"].as_f64().expect("a force"))
        .sum();
    assert!((up / number(statics, "dead_load_kn_per_m") - 1.0).abs() < 1e-6, "{statics}");
}

#[test]
fn cases_are_checked_in_an_assessment() {
    let stage = Stage::with_example("cases-assessed", "packhorse");
    let text = stage.read("bridge/cases.toml");
    stage.write("bridge/cases.toml", format!("{text}\n[assess]\nadequacy_factor = 1.0\n"));
    let skip = ["--skip", "sensitivity", "--skip", "collapse"];
    let (answer, _) = stage.object(&[&["assess", "bridge/cases.toml"], &skip[..]].concat());
    let made: Vec<&serde_json::Value> =
        answer["checks"].as_array().expect("checks").iter().filter(|one| one["code"] == "C206").collect();
    assert_eq!(made.len(), 4, "{answer}");
    assert!(made.iter().all(|one| number(one, "value") > 1.0), "{made:?}");
    assert!(stage.read("out/cases/report.html").contains("Named cases"));
}
