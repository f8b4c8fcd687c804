//! Two files side by side.

use crate::stage::{Stage, number};

#[test]
fn a_repair_is_named_and_its_effect_told() {
    let stage = Stage::with_example("compare-repair", "defects");
    let before = stage.read("bridge/bridge.toml").replace("voussoirs = 60", "voussoirs = 24");
    stage.write("bridge/bridge.toml", &before);
    // The first defect is mended, and a length is written in another unit.
    let (head, rest) = before.split_once("\n[[defect]]").expect("a defect");
    let rest = &rest[rest.find("\n[[").expect("another")..];
    stage.write("after.toml", format!("{head}{rest}"));
    let (answer, ending) = stage.object(&["compare", "bridge/bridge.toml", "after.toml"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    let carried = |file: &str| number(&stage.object(&["collapse", file]).0, "last_stable_load_kn_per_m");
    let (first, second) = (carried("bridge/bridge.toml"), carried("after.toml"));
    assert!(second > 1.01 * first, "{first} {second}");
    let of = |name: &str| {
        answer["numbers"]
            .as_array()
            .and_then(|all| all.iter().find(|one| one["name"] == name))
            .cloned()
            .expect("a number")
    };
    let load = of("last_stable_load_kn_per_m");
    assert_eq!((load["before"].as_f64(), load["after"].as_f64()), (Some(first), Some(second)));
    let change = load["change_percent"].as_f64().expect("a change");
    assert!((change - 100.0 * (second / first - 1.0)).abs() < 1e-9);
    assert!(
        answer["verdict"]
            .as_str()
            .is_some_and(|words| words.contains("the second carries") && words.contains("% more"))
    );
    assert!(
        !answer["assumptions_before_only"].as_array().expect("a list").is_empty(),
        "the defect is an assumption of the first alone"
    );
    for name in ["differences.csv", "answers.csv", "tables.xlsx", "before/mechanism.png", "after/mechanism.svg"] {
        assert!(stage.folder.join("out/bridge-and-after").join(name).is_file(), "{name}");
    }
    let table = stage.read("out/bridge-and-after/differences.csv");
    assert!(table.lines().skip(1).all(|line| line.starts_with("defect")), "{table}");
}

#[test]
fn what_is_the_same_in_another_unit_is_no_difference() {
    let stage = Stage::new("compare-units");
    let stiff = "[joint]\nnormal_stiffness = \"4.84 GPa/m\"\nshear_stiffness = \"0.573 GPa/m\"";
    let text = include_str!("../../../bridge/tests/it/files/road.toml").replace("[joint]", stiff);
    stage.write("own.toml", &text);
    let line = text.lines().find(|line| line.starts_with("thickness")).expect("a thickness");
    let metres: f64 =
        line.split('"').nth(1).and_then(|q| q.split(' ').next()).and_then(|n| n.parse().ok()).expect("metres");
    stage.write("same.toml", text.replace(line, &format!("thickness = \"{} mm\"", 1e3 * metres)));
    let (answer, _) = stage.object(&["compare", "own.toml", "same.toml"]);
    assert_eq!(answer["differences"], serde_json::json!([]), "{}", answer["differences"]);
    assert!(
        answer["verdict"].as_str().is_some_and(|words| words.contains("both carry the same")),
        "{}",
        answer["verdict"]
    );
    // A ring that is thicker, by another method: the result says that the methods differ.
    let thicker = text.replace(line, &format!("thickness = \"{} mm\"", 1.1e3 * metres));
    stage.write("thicker.toml", format!("{thicker}\n[analysis]\nmethod = \"path\"\n"));
    let (answer, _) = stage.object(&["compare", "own.toml", "thicker.toml"]);
    assert!(answer["cautions"].to_string().contains("different methods"), "{answer}");
    assert_eq!(
        answer["differences"].as_array().map(Vec::len),
        Some(2),
        "the thickness and the plan: {}",
        answer["differences"]
    );
}

#[test]
fn both_files_are_read_before_anything_is_computed() {
    let stage = Stage::with_example("compare-refused", "tiny");
    let text = stage.read("bridge/bridge.toml");
    stage.write("one.toml", text.replace("span = ", "spam = "));
    stage.write("other.toml", text.replace("profile = ", "profil = "));
    let ending = stage.run(&["compare", "one.toml", "other.toml"]);
    assert_eq!(ending.code, Some(2));
    assert!(ending.stderr.contains("one.toml:") && ending.stderr.contains("other.toml:"), "{}", ending.stderr);
    let drawing = Stage::with_example("compare-blocks", "drawing");
    let (answer, ending) = drawing.object(&["compare", "bridge/bridge.toml", "bridge/bridge.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F107")));
}
