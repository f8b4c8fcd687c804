//! Slender rings that snap from state to state before they give way: what they carry follows thickness, strength and place without a jump, and never
//! falls where a ring is thicker or stronger. Their ways were once ended by the number of chords of crushing that they passed.

use super::*;
use mechanics::watch::Unwatched;

/// Two rings over 10 m: of a thickness and a strength, with the load at a share of the span. What they carry, followed to its end [kN/m].
fn carried(thickness: f64, strength: f64, at: f64) -> f64 {
    let ring = |count: usize| format!("{{ thickness = \"{thickness} m\", voussoirs = {count} }}");
    let text = format!(
        r#"
bridge = {{ name = "t", width = "5.0 m" }}
span = [{{ profile = "segmental", span = "10 m", rise = "2.5 m", ring = [{}, {}] }}]
masonry = {{ density = "2200 kg/m^3", compressive_strength = "{strength} MPa", rounding = "5 mm" }}
joint = {{ friction_angle = "35 deg", cohesion = "0 kPa" }}
ring_joint = {{ friction_angle = "30 deg", cohesion = "0 kPa" }}
cover = [{{ layer = "fill", thickness = "0.4 m", density = "1900 kg/m^3" }}]
dispersal = {{ rule = "uniform", slope = "2:1" }}
load = [{{ kind = "knife-edge", force = "1 kN/m", length = "0.3 m", position = "{} m" }}]
analysis = {{ method = "limit" }}
"#,
        ring(44),
        ring(46),
        10.0 * at
    );
    let bridge = bridge::read(text.as_bytes()).bridge.expect("a bridge");
    let found = collapse(&bridge, None, &mut Unwatched).unwrap();
    assert!(found.limit().is_some_and(|own| !own.comes_and_goes), "{thickness} {strength} {at}");
    found.carried().unwrap() / 1e3
}

/// Loads in a row, of which neighbours differ by no more than a share, and none is less than the one before by more than a thousandth: which of two
/// neighbouring states is met last on the way decides that much.
fn rise_without_a_jump(loads: &[f64], share: f64) {
    for pair in loads.windows(2) {
        let [before, after] = [pair[0], pair[1]];
        assert!(after > before * (1.0 - 1e-3) && after < before * (1.0 + share), "{loads:?}");
    }
}

#[test]
fn loads_rise_with_thickness_and_strength() {
    let thicker: Vec<f64> = (0..6).map(|k| carried(0.230 + 0.003 * f64::from(k), 10.0, 0.25)).collect();
    rise_without_a_jump(&thicker, 0.04);
    let stronger = [30.0, 35.0, 40.0, 60.0, 150.0, 250.0].map(|f| carried(0.230, f, 0.25));
    rise_without_a_jump(&stronger, 0.02);
}

/// A load that is moved by a millimetre carries as much.
#[test]
fn loads_follow_their_place() {
    let along: Vec<f64> = (0..5).map(|k| carried(0.238, 10.0, 0.2496 + 0.0002 * f64::from(k))).collect();
    let (least, most) = along.iter().fold((f64::INFINITY, 0.0f64), |(a, b), load| (a.min(*load), b.max(*load)));
    assert!(most < least * 1.005, "{along:?}");
}
