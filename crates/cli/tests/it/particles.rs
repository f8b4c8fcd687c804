//! Fill as particles: what a run leaves in its folder, and packings that are used again.

use crate::stage::{Stage, number};

/// Case 3 with few particles and few load steps.
fn small() -> String {
    let text = include_str!("../../../../examples/bridgemill/case-3.toml");
    let text = text.replace("count = 1984", "count = 240").replace("load_limit = \"10 MN\"", "load_limit = \"250 kN\"");
    assert!(text.contains("count = 240") && text.contains("250 kN"), "case 3 has another form");
    text
}

#[test]
fn a_saved_packing_gives_the_same_run_bit_for_bit() {
    let stage = Stage::new("particles-packing");
    let text = small();
    stage.write("grown.toml", &text);
    let (grown, ending) = stage.object(&["collapse", "grown.toml", "--out", "grown"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let names = stage.names("grown");
    for name in ["packing", "force-chains", "displacement", "fill-stress", "bridge"].map(|n| format!("{n}.svg")) {
        assert!(names.contains(&name), "{name} is not among {names:?}");
    }
    for name in ["animation.png", "particles.csv", "particle-contacts.csv", "packing.csv"] {
        assert!(names.iter().any(|n| n == name), "{name} is not among {names:?}");
    }
    assert!(stage.names("grown/paraview").iter().any(|n| n == "particles.pvd"));
    assert_eq!(stage.read("grown/particles.csv").lines().count(), 241);
    let codes = grown["warnings"].as_array().expect("warnings");
    assert!(codes.iter().any(|one| one["code"] == "A125"), "one packing is one sample: {codes:?}");
    let packing = &grown["packing"];
    assert!((0.6..0.95).contains(&number(packing, "solid_fraction")), "{packing}");
    for key in ["coordination", "mean_stress_kpa", "smallest_diameter_m", "largest_diameter_m", "settlement_mm", "seed"]
    {
        assert!(packing[key].is_number(), "{key} in {packing}");
    }

    stage.write("packing.csv", stage.read("grown/packing.csv"));
    stage.write("saved.toml", text.replace("count = 240", "count = 240\nfile = \"packing.csv\""));
    let (saved, ending) = stage.object(&["collapse", "saved.toml", "--out", "saved"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    for table in ["path", "particles", "particle-contacts", "contacts", "blocks"].map(|n| format!("{n}.csv")) {
        assert!(stage.read(&format!("grown/{table}")) == stage.read(&format!("saved/{table}")), "{table} differs");
    }
    assert!(saved["packing"]["seed"].is_null(), "a packing from a file has no seed");
    let rows = |folder: &str| -> Vec<String> {
        let text = stage.read(&format!("{folder}/packing.csv"));
        text.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect()
    };
    assert_eq!(rows("grown"), rows("saved"));

    let circles = |file: &str| {
        let (answer, _) = stage.object(&["check", file, "--out", "drawn"]);
        assert_eq!(answer["status"], "completed");
        stage.read("drawn/bridge.svg").matches("<circle").count()
    };
    assert_eq!([circles("grown.toml"), circles("saved.toml")], [0, 240]);
}

#[test]
fn a_packing_that_cannot_be_used_is_told_with_its_lines() {
    let stage = Stage::new("particles-unusable");
    let text = small().replace("count = 240", "count = 240\nfile = \"packing.csv\"");
    stage.write("bridge.toml", text);
    let refused = |code: &str, words: &[&str]| {
        for command in ["check", "collapse"] {
            let (answer, ending) = stage.object(&[command, "bridge.toml"]);
            assert_eq!(ending.code, Some(2), "{command}: {}", ending.stderr);
            assert_eq!(answer["errors"][0]["code"], code, "{command}: {answer}");
            words.iter().for_each(|word| assert!(ending.stderr.contains(word), "{word}: {}", ending.stderr));
        }
    };
    refused("F101", &["packing.csv"]);
    stage.write("packing.csv", "# mine\nx_m,y_m,radius_m\n1,2,0.1\n1,2\n1,x,0.1\n");
    refused("F120", &["line 4: radius_m is missing", "line 5: y_m is \"x\""]);
    // Inside the fill of the left haunch, and in the river.
    stage.write("packing.csv", "x_m,y_m,radius_m\n-1,2,0.1\n9,-3,0.1\n");
    refused("F108", &["1 of the 2 particles", "x = 9.000 m, y = -3.000 m"]);
}
