//! Springings at unequal levels, piers, abutments that can move, hollow spandrels: felt, drawn, and refused where they are not known.

use crate::stage::{Stage, number};

const GRADIENT: &str = include_str!("../../../bridge/tests/it/files/gradient.toml");

#[test]
fn each_part_is_felt_and_drawn() {
    let stage = Stage::new("gradient");
    let carried = |text: &str| {
        stage.write("bridge.toml", text);
        let (answer, ending) = stage.object(&["collapse", "bridge.toml"]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        (number(&answer, "last_stable_load_kn_per_m"), answer)
    };
    let (whole, answer) = carried(GRADIENT);
    for code in ["A202", "A203", "A204"] {
        assert!(answer["warnings"].to_string().contains(code), "{code}");
    }
    let drawn = stage.read("out/bridge/bridge.svg");
    // The pier's height from its bottom to the lower springing, and the difference of the springings.
    assert!(drawn.contains("4 m") && drawn.contains("0.25 m"), "dimensions");
    for (from, to) in [
        ("right_springing = \"0.25 m\"", "right_springing = \"0.05 m\""),
        ("roof = \"2.2 m\"", "roof = \"1.5 m\""),
        ("thickness = \"1.2 m\"", "thickness = \"2.4 m\""),
        ("width_share = 0.5", "width_share = 1.0"),
    ] {
        assert!(GRADIENT.contains(from), "{from}");
        let (changed, _) = carried(&GRADIENT.replace(from, to));
        assert!((changed / whole - 1.0).abs() > 1e-6, "{to}: {changed} {whole}");
    }
    // The second span is no part of the mechanism of a load on the first: it is drawn where its springings are.
    carried(&GRADIENT.replace("step = \"0.05 m\"", "step = \"0.10 m\""));
    assert_ne!(stage.read("out/bridge/bridge.svg"), drawn, "a higher step");
    let (fixed, answer) = carried(&GRADIENT.replace("as = \"blocks\"", "as = \"fixed\""));
    assert!(fixed >= whole * (1.0 - 1e-6), "{fixed} {whole}");
    assert!(!answer["warnings"].to_string().contains("A203"));
}

#[test]
fn what_cannot_be_is_named_with_its_place() {
    let stage = Stage::new("gradient-wrong");
    for (from, to, code, words) in [
        ("\"0.25 m\"", "\"8.0 m\"", "B229", "falls from its right springing"),
        ("step = \"0.05 m\"", "step = \"1.5 m\"", "B230", "a stair between its two springings"),
        ("roof = \"2.2 m\"", "roof = \"0.2 m\"", "B231", "the floor is at 1 m"),
        ("[\"8.7 m\"", "[\"9.7 m\"", "B231", "one at 8.9 m or left of it"),
        ("thickness = \"1.2 m\"", "thickness = \"12 m\"", "B232", "thicker than the bridge is wide"),
        ("earth_coefficient = 0.33", "earth_coefficient = 3.0", "B10", "earth_coefficient"),
        ("height = \"4.0 m\"", "base_width = \"2 m\"\nheight = \"4.0 m\"", "B016", "exclude one another"),
    ] {
        stage.write("wrong.toml", GRADIENT.replacen(from, to, 1));
        let ending = stage.run(&["check", "wrong.toml"]);
        assert!(
            ending.code == Some(2) && ending.stderr.contains(code) && ending.stderr.contains(words),
            "{to}: {}",
            ending.stderr
        );
    }
    let tiny = include_str!("../../../../examples/tiny/bridge.toml");
    stage.write("wrong.toml", format!("{tiny}\n[abutment]\nas = \"blocks\"\n"));
    let ending = stage.run(&["check", "wrong.toml"]);
    assert!(ending.code == Some(2) && ending.stderr.matches("B011").count() == 2, "{}", ending.stderr);
    assert!(ending.stderr.contains("earth_coefficient") && ending.stderr.contains("ground_friction_angle"));
}
