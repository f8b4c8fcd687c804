//! Rings that lie on one another: their load hangs on no coincidence of their joints.

use crate::stage::{Stage, number};

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
