//! Rings that lie on one another: their load hangs on no coincidence of their joints.

use crate::stage::{Stage, number};
use std::fs;
use std::path::Path;

/// The example of two rings, coarser, and with the friction asked for.
fn rings(stage: &Stage, friction: &str) -> String {
    let text = stage.read("bridge/bridge.toml").replace("voussoirs = 40", "voussoirs = 24");
    format!("{text}\n[analysis]\nmethod = \"limit\"\nfriction = \"{friction}\"\n")
}

fn load(stage: &Stage, text: &str) -> f64 {
    stage.write("rings.toml", text);
    number(&stage.object(&["collapse", "rings.toml"]).0, "collapse_load_kn_per_m")
}

#[test]
fn aligned_ring_joints_do_not_lock() {
    let stage = Stage::with_example("rings-aligned", "two-ring");
    for friction in ["associated", "automatic"] {
        let text = rings(&stage, friction);
        let aligned = load(&stage, &text);
        // The other quarter.
        let mirrored = load(&stage, &text.replace("1/4 of span 1", "3/4 of span 1"));
        assert!((mirrored / aligned - 1.0).abs() < 1e-6, "{friction}: {aligned} {mirrored}");
        // Another count in the upper ring, and so in both: no joint lies on a joint, or all do.
        let last = text.rfind("voussoirs = 24").expect("rings");
        let other = load(&stage, &format!("{}voussoirs = 25{}", &text[..last], &text[last + 14..]));
        let both = load(&stage, &text.replace("voussoirs = 24", "voussoirs = 25"));
        assert!((other / aligned - 1.0).abs() < 0.04, "{friction}: {aligned} {other}");
        assert!((both / aligned - 1.0).abs() < 0.04, "{friction}: {aligned} {both}");
        // Rounding that goes to nothing.
        let rounded =
            |by: &str| load(&stage, &text.replace("[masonry]\n", &format!("[masonry]\nrounding = \"{by}\"\n")));
        // A contact point of joints 215 mm long moves by the rounding: a thousandth of them at 0.1 mm.
        assert!((rounded("0.000001 mm") / aligned - 1.0).abs() < 1e-4, "{friction}");
        assert!((rounded("0.1 mm") / aligned - 1.0).abs() < 1e-2, "{friction}");
    }
}

/// A laboratory arch of three half-brick rings that snap from state to state where they are rough: what is given is the largest load on the way,
/// and how far it falls behind it stands beside it.
#[test]
fn rings_that_come_and_go_carry_the_largest_load_and_say_how_far_it_falls() {
    let stage = Stage::new("rings-lower");
    let case = "../../verification/rings/laboratory-3-m-3-rings/case.toml";
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let case = fs::read_to_string(root.join(case)).expect("the case");
    let text = fs::read_to_string(root.join("../../verification/rings/laboratory.toml")).expect("its input");
    let (before, after) = text.split_once("[[span.ring]]").expect("rings");
    let after = &after[after.find("[masonry]").expect("masonry")..];
    let line = case.lines().find_map(|line| line.strip_prefix("\"span.0.ring\" = ")).expect("rings of the case");
    let text = format!("{before}ring = {line}\n\n{after}");
    stage.write("rough.toml", &text);
    let (rough, _) = stage.object(&["collapse", "rough.toml"]);
    assert_eq!(rough["status"], "collapsed");
    let [load, associated] = ["collapse_load_kn_per_m", "associated_load_kn_per_m"].map(|key| number(&rough, key));
    let spread = rough["non_associated_spread_kn_per_m"].as_array().expect("both ends");
    let [least, most] = [0, 1].map(|k| spread[k].as_f64().expect("a load"));
    assert!(
        (most / load - 1.0).abs() < 1e-6 && 1.01 * least < load && load < associated,
        "{load} {spread:?} {associated}"
    );
}
