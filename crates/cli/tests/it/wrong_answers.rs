//! Small bridges and blocks whose answers were wrong once, with what is right and why ("Answers that were wrong" in docs/verification).

use crate::stage::{Stage, codes, number};
use serde_json::Value;

/// A segmental arch of 6 m with 0.4 m of fill, and what a test adds.
fn arch(cover: &str, masonry: &str, joint: &str, more: &str) -> String {
    format!(
        "[bridge]\nname = \"arch\"\nwidth = \"3 m\"\n\n[[span]]\nprofile = \"segmental\"\nspan = \"6 m\"\nrise = \"1.5 m\"\n\
        thickness = \"0.4 m\"\nvoussoirs = 30\n\n[abutment]\ntop_width = \"2 m\"\nheight = \"2 m\"\n\n[[cover]]\nlayer = \"fill\"\n\
        thickness = \"0.4 m\"\ndensity = \"1900 kg/m^3\"\n{cover}\n[masonry]\ndensity = \"2200 kg/m^3\"\n{masonry}\n[joint]\n{joint}\n\
        [dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n[[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.3 m\"\n\
        position = \"1.5 m\"\n\n{more}"
    )
}

/// A block between two fixed ones whose faces lean outwards by so much [m] over its height of 1 m.
fn key(lean: f64) -> String {
    let (left, right) = (-lean, 1.0 + lean);
    format!(
        "[model]\nname = \"key\"\nwidth = \"1 m\"\n[[material]]\nname = \"m\"\ndensity = \"2000 kg/m^3\"\ncompressive_strength = \"unlimited\"\n\
        [[joint]]\nfriction_angle = \"40 deg\"\ncohesion = \"0 kPa\"\n\
        [[block]]\nname = \"left\"\nmaterial = \"m\"\nrole = \"support\"\noutline_m = [[-1, 0], [0, 0], [{left}, 1], [-1, 1]]\n\
        [[block]]\nname = \"right\"\nmaterial = \"m\"\nrole = \"support\"\noutline_m = [[1, 0], [2, 0], [2, 1], [{right}, 1]]\n\
        [[block]]\nname = \"key\"\nmaterial = \"m\"\noutline_m = [[0, 0], [1, 0], [{right}, 1], [{left}, 1]]\n\
        [[load]]\nblock = \"key\"\ndown = \"1 kN/m\"\n"
    )
}

fn answer(stage: &Stage, text: &str, words: &[&str]) -> (Value, Option<i32>) {
    stage.write("asked.toml", text);
    let (answer, ending) = stage.object(&[&["collapse", "asked.toml"], words].concat());
    (answer, ending.code)
}

#[test]
fn a_continuum_that_carries_no_known_load_says_zero_and_why() {
    let cover = "as = \"continuum\"\nfriction_angle = \"35 deg\"\ncohesion = \"0 kPa\"\n";
    let more = "[analysis]\nmethod = \"limit\"\n[continuum]\nbound_ratio = 1.05\nelements = 300\n";
    let joint = "friction_angle = \"35 deg\"\ncohesion = \"0 kPa\"\n";
    let (found, _) =
        answer(&Stage::new("wrong-continuum"), &arch(cover, "compressive_strength = \"8 MPa\"\n", joint, more), &[]);
    let [headline, lower, upper] =
        ["headline_kn_per_m", "lower_bound_kn_per_m", "upper_bound_kn_per_m"].map(|key| number(&found, key));
    // A lower bound less what its residuals are worth was -2.4e-6.
    assert!(headline == 0.0 && lower == 0.0 && upper > 1.0, "{headline} {lower} {upper}");
    assert!(codes(&found).contains(&"A113"), "{}", found["warnings"]);
}

#[test]
fn finite_elements_do_not_lead_where_their_joints_would_slide() {
    let masonry = "compressive_strength = \"unlimited\"\nelastic_modulus = \"1000 GPa\"\npoisson_ratio = 0.0\n";
    let joint = "normal_stiffness = \"10 GPa/m\"\nshear_stiffness = \"4 GPa/m\"\nfriction_angle = \"12 deg\"\ncohesion = \"0 kPa\"\n";
    let stage = Stage::new("wrong-sliding");
    let text = arch("", masonry, joint, "");
    let (elements, _) = answer(&stage, &text, &["--method", "fe"]);
    let (rigid, _) = answer(&stage, &text, &["--method", "limit"]);
    let [led, slides] = [&elements, &rigid].map(|found| number(found, "headline_kn_per_m"));
    // Joints that cannot slide carry 111.6; what friction of 12 degrees holds leads.
    assert!(
        (led / slides - 1.0).abs() < 1e-6 && number(&elements, "last_stable_load_kn_per_m") > 1.2 * led,
        "{led} {slides}"
    );
    assert!(codes(&elements).contains(&"A205"), "{}", elements["warnings"]);
}

#[test]
fn a_key_that_friction_alone_holds_has_no_load_and_a_wider_one_locks() {
    let stage = Stage::new("wrong-key");
    // Without a lean, compressions that nobody knows hold it: there is no load, below zero least of all (it was -19.36 kN/m).
    let (jammed, ending) = answer(&stage, &key(0.0), &["--method", "limit"]);
    assert_eq!((ending, jammed["status"].as_str()), (Some(3), Some("not-converged")), "{jammed}");
    assert!(jammed["collapse_load_kn_per_m"].is_null() && codes(&jammed).contains(&"A206"), "{jammed}");
    // Wider above, it goes nowhere (it was said to collapse at 365,392 kN/m).
    let (locked, ending) = answer(&stage, &key(0.05), &["--method", "limit"]);
    assert_eq!((ending, locked["status"].as_str()), (Some(0), Some("locks")), "{locked}");
    assert!(locked["collapse_load_kn_per_m"].is_null(), "{locked}");
}

#[test]
#[ignore = "three rings, a minute; .ci/slow"]
fn three_rings_fall_steadily_with_their_strength() {
    let rings = |strength: &str| {
        format!(
            "[bridge]\nname = \"rings\"\nwidth = \"1 m\"\n[[span]]\nprofile = \"segmental\"\nspan = \"8 m\"\nrise = \"2 m\"\n\
            [[span.ring]]\nthickness = \"0.225 m\"\nvoussoirs = 31\n[[span.ring]]\nthickness = \"0.225 m\"\nvoussoirs = 33\n\
            [[span.ring]]\nthickness = \"0.225 m\"\nvoussoirs = 35\n[masonry]\ndensity = \"2200 kg/m^3\"\n\
            compressive_strength = \"{strength}\"\n[joint]\nfriction_angle = \"35 deg\"\ncohesion = \"0 kPa\"\n\
            [ring_joint]\nfriction_angle = \"30 deg\"\ncohesion = \"0 kPa\"\n[[cover]]\nlayer = \"fill\"\nthickness = \"0.2 m\"\n\
            density = \"1800 kg/m^3\"\n[dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n[[load]]\nkind = \"knife-edge\"\n\
            force = \"1 kN/m\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n"
        )
    };
    let stage = Stage::new("wrong-rings");
    let loads: Vec<f64> = ["1 MPa", "0.7 MPa", "0.5 MPa"]
        .map(|strength| number(&answer(&stage, &rings(strength), &["--method", "limit"]).0, "headline_kn_per_m"))
        .into();
    // From 0.7 MPa down the iteration ended nowhere.
    assert!(loads.windows(2).all(|pair| pair[1] < pair[0] && pair[1] > 0.6 * pair[0]), "{loads:?}");
}
