//! What is carried leads: on the screen, in the object, in sweeps, with walls.

use crate::stage::{Stage, number, object};

fn walls() -> String {
    let text = include_str!("../../../../verification/walls/spandrel-wall-dem/bridge.toml");
    text.replace("method = \"dem\"", "method = \"limit\"")
}

#[test]
fn the_load_that_is_carried_leads_the_screen_and_the_object() {
    let stage = Stage::with_example("carried-leads", "tiny");
    let ending = stage.run(&["collapse", "bridge/bridge.toml", "--out", "o", "--details"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let at = |text: &str, words: &str| text.find(words).unwrap_or_else(|| panic!("{words} is not in\n{text}"));
    assert!(at(&ending.stdout, "carried") < at(&ending.stdout, "last stable load"));
    assert!(at(&ending.stdout, "last stable load") < at(&ending.stdout, "collapse load"));
    let text = stage.read("o/result.json");
    for suffix in ["_kn_per_m", "_kn"] {
        let [headline, stable, collapse] =
            ["headline", "last_stable_load", "collapse_load"].map(|key| at(&text, &format!("\"{key}{suffix}\"")));
        assert!(headline < stable && stable < collapse);
    }
    let answer = object(&text);
    assert_eq!(answer["headline_kn_per_m"], answer["lower_bound_kn_per_m"]);
}

#[test]
fn both_strips_are_asked_for_and_lead_with_their_sum() {
    let stage = Stage::new("carried-walls");
    stage.write("plain.toml", walls().replace("strip = \"wall\"", "").replace("through = \"block\"", ""));
    let (plain, ending) = stage.object(&["collapse", "plain.toml", "--out", "plain"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!(plain.get("combination").is_none(), "walls count only where somebody asks for them");
    stage.write("both.toml", walls().replace("strip = \"wall\"", "strip = \"both\""));
    let (both, _) = stage.object(&["collapse", "both.toml", "--out", "both"]);
    let sum = number(&both["combination"], "headline_total_kn");
    let parts: f64 = (0..2).map(|k| number(&both["combination"]["components"][k], "headline_kn")).sum();
    assert!((sum / parts - 1.0).abs() < 1e-12);
    for key in ["headline_kn", "last_stable_load_kn"] {
        assert!((number(&both, key) / sum - 1.0).abs() < 1e-12, "{key}");
    }
}

/// Two rings that slide on one another, under one axle: the way without dilation may or may not have an end.
#[test]
fn a_sweep_is_not_completed_on_a_governing_run_without_an_answer() {
    let stage = Stage::with_example("carried-sweep", "two-ring");
    let text = stage.read("bridge/bridge.toml").replace("voussoirs = 40", "voussoirs = 16");
    let plan = "\n[sweep]\nvehicles = [\"cs454-single\"]\nstep = \"0.5 m\"\nsubsets = false\ndirections = \"right\"\n";
    stage.write("bridge/sweep.toml", format!("{text}{plan}"));
    let (answer, ending) = stage.object(&["collapse", "bridge/sweep.toml", "--sweep", "--out", "o"]);
    let vehicle = &answer["vehicles"][0];
    let open = number(&answer, "positions_not_converged");
    if answer["status"] == "completed" {
        assert_eq!((ending.code, open), (Some(0), 0.0));
        assert_eq!(answer["collapse"]["status"], "collapsed");
        let run = &answer["collapse"];
        let factor = number(run, "headline_kn_per_m") / number(run, "reference_load_kn_per_m");
        assert!(number(&answer["governing"], "adequacy_factor") <= factor * (1.0 + 1e-6));
    } else {
        assert_eq!((&answer["status"], ending.code), (&"undetermined".into(), Some(3)), "{}", ending.stderr);
        assert!(open > 0.0 && answer["governing"]["adequacy_factor"].is_null());
        assert!(vehicle["adequacy_factor"].is_null() && vehicle["status"] == "not-converged");
        let codes: Vec<_> =
            answer["warnings"].as_array().expect("warnings").iter().map(|w| w["code"].clone()).collect();
        assert!(codes.contains(&"A175".into()) && codes.contains(&"A101".into()), "{codes:?}");
    }
}
