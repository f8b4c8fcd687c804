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

/// Layers that are particles weigh what they weigh wherever they are not taken for particles, and so do slabs on them and backing of them.
#[test]
fn particles_weigh_by_every_method_and_in_every_question() {
    let stage = Stage::with_example("axles-weight", "bridgemill");
    let file = stage
        .read("bridge/case-3.toml")
        .replace("voussoirs = 62", "voussoirs = 15")
        .replace("through = \"block\"\nblock_weight", "# block_weight");
    let backing = "\n[backing]\nheight = \"1.5 m\"\ndensity = \"2300 kg/m^3\"\nas = \"particles\"\n";
    let sweep = "\n[sweep]\nrule = \"cs-454\"\nvehicles = [\"cs454-single\"]\nstep = \"2 m\"\n";
    let movement = "\n[support_movement]\nsupport = \"right abutment\"\nhorizontal = 1.0\nincrement = \"1 mm\"\nlimit = \"10 mm\"\n";
    let slab = |text: &str| {
        let at = text.rfind("as = \"particles\"").expect("a layer");
        text[..at].to_owned() + "as = \"blocks\"\nblock_length = \"2 m\"" + &text[at + "as = \"particles\"".len()..]
    };
    let bodies = slab(&file) + backing + sweep;
    let weight = (bodies.clone() + movement).replace("as = \"particles\"", "as = \"weight\"");
    let weight = weight.replace("as = \"blocks\"\nblock_length = \"2 m\"", "as = \"weight\"");
    let head = weight.find("[particles]").expect("a section")..weight.find("[masonry]").expect("a section");
    stage.write("bridge/weight.toml", weight[..head.start].to_owned() + &weight[head.end..]);
    stage.write("bridge/bodies.toml", bodies + movement);
    let told = "Layers that are particles in the file, and slabs on them, are weight here";
    let both = |words: &[&str], keys: &[&str]| {
        let [(bodies, said), (weight, silent)] = ["bridge/bodies.toml", "bridge/weight.toml"].map(|file| {
            let line = [&[words[0], file], &words[1..]].concat();
            let (answer, ending) = stage.object(&line);
            assert!(matches!(ending.code, Some(0 | 3)), "{line:?}: {}", ending.stderr);
            let said = answer.to_string().contains(told);
            (keys.iter().fold(answer, |part, key| part[*key].clone()), said)
        });
        assert!(!weight.is_null(), "{words:?} {keys:?}");
        assert_eq!(bodies, weight, "{words:?}");
        assert!(said && !silent, "{words:?}: {said} {silent}");
    };
    for method in ["limit", "path", "fe"] {
        both(&["collapse", "--method", method], &["last_stable_load_kn_per_m"]);
    }
    both(&["collapse", "--sweep"], &["governing", "adequacy_factor"]);
    both(&["collapse", "--analysis", "thickness"], &["minimum_thickness_m"]);
    both(&["collapse", "--analysis", "support-movement"], &["max_compressive_stress_mpa"]);
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
