//! Defects of rings: told, drawn, felt, and refused where a method would leave them out.

use crate::stage::{Stage, number};

fn assumes(answer: &serde_json::Value, words: &str) -> bool {
    let all = answer["assumptions"].as_array().expect("assumptions");
    all.iter().any(|one| one.as_str().is_some_and(|one| one.contains(words)))
}

/// Sections of a file but those whose header is this.
fn without(text: &str, header: &str) -> String {
    let (mut kept, mut keeps) = (String::new(), true);
    for line in text.lines() {
        if line.starts_with('[') {
            keeps = !line.starts_with(header);
        }
        if keeps {
            kept += line;
            kept.push('\n');
        }
    }
    kept
}

#[test]
fn the_example_carries_what_its_page_says() {
    let stage = Stage::with_example("defects-example", "defects");
    let text = stage.read("bridge/bridge.toml");
    stage.write("sound.toml", without(&text, "[[defect]]"));
    let (found, _) = stage.object(&["collapse", "bridge/bridge.toml"]);
    let (sound, _) = stage.object(&["collapse", "sound.toml"]);
    let carried = |answer| number(answer, "last_stable_load_kn_per_m");
    // The page gives one decimal.
    assert!((carried(&found) - 74.0).abs() < 0.06 && (carried(&sound) - 110.1).abs() < 0.06);
    assert!(assumes(&found, "mortar lost to 60 mm from the intrados") && assumes(&found, "rings 1 and 2 separated"));
    assert!(!assumes(&sound, "Defect"));
    let drawing = stage.read("out/bridge/bridge.svg");
    assert_eq!(drawing.matches("class=\"defect\"").count(), 4, "a line for each");
    assert!(drawing.contains("80 mm of stone lost on the intrados"));
}

#[test]
fn the_path_and_discrete_elements_run_on_defects() {
    let stage = Stage::with_example("defects-methods", "bridgemill");
    let text = stage.read("bridge/case-1.toml");
    let defects = "\n[[defect]]\nkind = \"lost-mortar\"\nfrom = \"9 m\"\nto = \"16 m\"\ndepth = \"100 mm\"\n\n\
                   [[defect]]\nkind = \"thin-ring\"\nface = \"extrados\"\nfrom = \"3 m\"\nto = \"6 m\"\ndepth = \"60 mm\"\n";
    stage.write("spoilt.toml", format!("{text}{defects}"));
    stage.write("sound.toml", &text);
    for method in [&["--method", "path"][..], &["--method", "dem", "--resolution", "20 kN/m"][..]] {
        let load = |file: &str| {
            let words: Vec<&str> = ["collapse", file].into_iter().chain(method.iter().copied()).collect();
            number(&stage.object(&words).0, "last_stable_load_kn_per_m")
        };
        let (spoilt, sound) = (load("spoilt.toml"), load("sound.toml"));
        assert!(spoilt < 0.9 * sound && spoilt > 0.5 * sound, "{method:?}: {spoilt} of {sound}");
    }
}

#[test]
fn what_knows_no_defects_refuses_them() {
    let stage = Stage::with_example("defects-refused", "bridgemill");
    let text = stage.read("bridge/case-1.toml");
    stage.write("bridge/bridge.toml", format!("{text}\n[[defect]]\nkind = \"lost-mortar\"\ndepth = \"50 mm\"\n"));
    for (flag, value, words) in [
        ("--method", "fe", "finite elements of one ring do not know defects: write method = "),
        (
            "--analysis",
            "thickness",
            "the least thickness does not take defects into account: write analysis = \"load\"",
        ),
    ] {
        let ending = stage.run(&["collapse", "bridge/bridge.toml", flag, value]);
        assert!(ending.code == Some(2) && ending.stderr.contains(words), "{}", ending.stderr);
    }
}
