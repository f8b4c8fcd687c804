//! What `vary` repeats: the bridge as its file and the files beside it have it, and sweeps with their own outcomes.

use crate::stage::{Stage, number};

#[test]
fn vary_keeps_a_saved_packing() {
    let stage = Stage::new("varying-packing");
    let text = include_str!("../../../../examples/bridgemill/case-3.toml");
    let text = text.replace("count = 1984", "count = 120").replace("load_limit = \"10 MN\"", "load_limit = \"150 kN\"");
    stage.write("grown.toml", &text);
    assert_eq!(stage.run(&["collapse", "grown.toml", "--out", "grown"]).code, Some(0));
    stage.write("packing.csv", stage.read("grown/packing.csv"));
    // Another seed would pack otherwise.
    let saved = text.replace("count = 120", "count = 120\nfile = \"packing.csv\"");
    let seeded = saved.replace("\nseed = 1\n", "\nseed = 77\n");
    assert_ne!(saved, seeded, "case 3 has another form");
    stage.write("saved.toml", &seeded);
    let (alone, ending) = stage.object(&["collapse", "saved.toml", "--out", "alone"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let (study, ending) = stage.object(&["vary", "saved.toml", "--set", "joint.friction_angle=35deg,36deg"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let own = &study["baseline"]["outcomes"];
    for key in ["iterations_total", "last_stable_load_kn_per_m"] {
        assert_eq!(number(own, key), number(&alone, key), "{key}: {own}");
    }
}

#[test]
fn vary_takes_load_factor_and_governing_position() {
    let stage = Stage::with_example("varying-sweep", "tiny");
    let file = "bridge/bridge.toml";
    let (swept, _) = stage.object(&["collapse", file, "--sweep"]);
    let set = ["--set", "span.thickness=0.30m,0.40m"];
    for outcome in ["load_factor", "governing_position_m"] {
        let words = ["vary", file, set[0], set[1], "--outcome", outcome];
        let (study, ending) = stage.object(&words);
        assert_eq!((ending.code, study["outcome"].as_str()), (Some(0), Some(outcome)), "{}", ending.stderr);
        assert_eq!(study["command"], "sweep");
        let own = number(&study["baseline"]["outcomes"], "load_factor");
        let alone = number(&swept["governing"], "load_factor");
        assert!((own / alone - 1.0).abs() < 1e-9, "{own} {alone}");
    }
    let (study, _) = stage.object(&["vary", file, set[0], set[1], "--sweep"]);
    assert_eq!(study["outcome"], "load_factor");
    let thicker = study["sensitivity"][0]["trend"].as_str();
    assert_eq!(thicker, Some("rising"), "{study}");
}

#[test]
fn vary_takes_adequacy_under_vehicles() {
    let stage = Stage::with_example("varying-vehicles", "bridgemill");
    let text = stage.read("bridge/vehicles.toml");
    let line = |key: &str| text.lines().find(|line| line.starts_with(key)).map(str::to_owned);
    let mut few = text.replace("confirm = true", "confirm = false");
    if let Some(own) = line("vehicles") {
        few = few.replace(&own, "vehicles = [\"lm1\"]");
    } else {
        few = few.replace("\n[sweep]\n", "\n[sweep]\nvehicles = [\"lm1\"]\n");
    }
    match line("step") {
        Some(own) => few = few.replace(&own, "step = \"1.5 m\""),
        None => few = few.replace("\n[sweep]\n", "\n[sweep]\nstep = \"1.5 m\"\n"),
    }
    stage.write("bridge/few.toml", &few);
    let words = ["vary", "bridge/few.toml", "--set", "span.thickness=-5%,+5%", "--outcome", "adequacy_factor"];
    let (study, ending) = stage.object(&words);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let own = &study["baseline"]["outcomes"];
    assert!(number(own, "adequacy_factor") > 0.0 && own["governing_position_m"].is_number(), "{own}");
    assert_eq!(study["sensitivity"][0]["trend"], "rising", "a thicker ring carries more: {study}");
}

#[test]
fn values_are_printed_with_the_digits_that_people_write() {
    let stage = Stage::with_example("varying-digits", "tiny");
    let words = ["vary", "bridge/bridge.toml", "--method", "limit", "--set", "span.thickness=0.267m..0.8m:4"];
    let ending = stage.run(&words);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let digits = |text: &str| text.split(|c: char| !c.is_ascii_digit()).map(str::len).max().unwrap_or(0);
    assert!(digits(&ending.stdout) <= 5, "{}", ending.stdout);
    let texts: String =
        stage.read("out/bridge-vary/tornado.svg").split('>').filter_map(|part| part.split('<').next()).collect();
    assert!(!texts.contains("666666"), "{texts}");
}
