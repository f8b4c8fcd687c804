//! What is printed of an axle: the axle that is carried, and no load on a width that nobody asked for.

use crate::stage::{Stage, number};
use crate::tiny::BRIDGE;

/// An axle of 100 kN on 2.5 m of a bridge that is 4 m wide: 100 kN times the factor, not the load per metre times 4 m.
#[test]
fn an_axle_is_told_with_its_factor_and_not_times_the_width_of_the_bridge() {
    let stage = Stage::new("axles-carried");
    let axle = "load = { kind = \"axles\", axle_forces = [\"100 kN\"], axle_spacings = [], contact_length = \"0.3 m\", effective_width = \"2.5 m\", at = \"1/4 of span 1\" }";
    let line = BRIDGE.lines().find(|line| line.starts_with("load =")).expect("a load");
    stage.write("bridge.toml", BRIDGE.replace(line, axle));
    let words = ["collapse", "bridge.toml", "--method", "limit", "--out", "out"];
    let (answer, ending) = stage.object(&words);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let (load, factor) = (number(&answer, "last_stable_load_kn_per_m"), number(&answer, "load_factor"));
    assert!((factor - load / 40.0).abs() < 1e-6 * factor, "{factor} {load}");
    let carried = answer["axles"][0]["carried_kn"][0].as_f64().expect("a number");
    assert!((carried - 100.0 * factor).abs() < 1e-6 * carried, "{answer}");
    let printed = stage.run(&words).stdout;
    assert!(printed.contains(&format!("{carried:.0} kN   {factor:.3} times 100 kN")), "{printed}");
    assert!(!printed.contains("over 4.00 m") && !printed.contains(&format!("{:.0} kN", 4.0 * load)), "{printed}");
}

/// Limit analysis knows no particles, and no more does the second opinion beside it: discrete elements are asked of the same bridge.
#[test]
fn a_second_opinion_is_given_where_the_fill_is_particles() {
    let stage = Stage::with_example("axles-particles", "bridgemill");
    let sweep =
        "\n[sweep]\nrule = \"cs-454\"\nvehicles = [\"cs454-single\"]\nstep = \"1 m\"\ndiscrete_elements = true\n";
    stage.write("bridge/swept.toml", stage.read("bridge/case-3.toml") + sweep);
    let (answer, ending) = stage.object(&["collapse", "bridge/swept.toml", "--sweep"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let second = &answer["discrete_elements"];
    assert_eq!((second["status"].as_str(), second["reason"].as_str()), (Some("collapsed"), None), "{second}");
    let [limit, found] = ["limit_adequacy_factor", "adequacy_factor"].map(|key| number(second, key));
    assert!(found > 0.8 * limit && found < 1.05 * limit, "{found} beside {limit}");
    assert_eq!(number(&answer["governing"], "adequacy_factor"), found.min(limit));
}
