//! Laws of solids in states whose answer is known.

use crate::fem_law::{FILL, cone, invariants, pyramid, size};
use mechanics::fem::law::{
    Cone, DruckerPrager, Elastic, Law, Material, Memory, MohrCoulomb, NoTension, Plane, Solid, VonMises,
};

const FRESH: Memory = Memory { plastic: [0.0; 4], hardening: 0.0 };

fn sheet(material: Material) -> Solid {
    Solid { material, plane: Plane::Stress }
}

#[test]
fn a_sheet_has_the_stiffness_of_a_sheet() {
    let law = Elastic { modulus: 210e9, ratio: 0.3 };
    let answer = sheet(Material::Elastic(law)).respond(&[1e-3, -2e-4, 99.0, 3e-4], &FRESH);
    let factor = 210e9 / (1.0 - 0.09);
    let expected = [factor * (1e-3 - 0.3 * 2e-4), factor * (-2e-4 + 0.3 * 1e-3), 0.0, 210e9 / 2.6 * 3e-4];
    for i in 0..4 {
        assert!((answer.stress[i] - expected[i]).abs() < 1e-12 * factor);
    }
    assert!((answer.tangent[0][0] / factor - 1.0).abs() < 1e-12 && (answer.tangent[0][1] / factor - 0.3).abs() < 1e-12);
    assert!(answer.tangent[2] == [0.0; 4]);
}

#[test]
fn a_sheet_yields_on_the_ellipse_of_von_mises() {
    let k = 100e3;
    let law = sheet(Material::VonMises(VonMises { elastic: FILL, strength: k }));
    for strain in [[2e-2, 0.0, 0.0, 0.0], [2e-2, 2e-2, 0.0, 0.0], [2e-2, -2e-2, 0.0, 1e-2], [0.0, 1e-2, 0.0, 5e-2]] {
        let [x, y, z, xy] = law.respond(&strain, &FRESH).stress;
        assert_eq!(z, 0.0);
        assert!(((x * x + y * y - x * y) / 3.0 + xy * xy - k * k).abs() < 1e-9 * k * k);
    }
}

#[test]
fn simple_shear_stops_at_the_strength() {
    let law = VonMises { elastic: FILL, strength: 100e3 };
    let answer = law.respond(&[0.0, 0.0, 0.0, 0.1], &FRESH);
    assert!((answer.stress[3] - 100e3).abs() < 1e-6 && answer.tangent[3][3].abs() < 1e-9 * FILL.shear());
    // Taken back, it answers as stiff as at first, from what has flowed.
    let back = law.respond(&[0.0, 0.0, 0.0, 0.1 - 1e-4], &answer.memory);
    assert!(!back.yields && (back.stress[3] - (100e3 - 1e-4 * FILL.shear())).abs() < 1e-6);
}

#[test]
fn a_confined_column_yields_at_its_cohesion_per_metre() {
    // φ 30°, ν 0.19, K0 = 0.235 below Ka = 1/3: yields as soon as 2 c √Ka < (Ka - K0) of the pressure.
    let elastic = Elastic { modulus: 170e6, ratio: 0.19 };
    let pressure = 20e3;
    let rest = 0.19 / 0.81;
    let needed = (1.0 / 3.0 - rest) * pressure / (2.0 * (1.0_f64 / 3.0).sqrt());
    for (cohesion, yields) in [(needed * 1.001, false), (needed * 0.999, true)] {
        let law = MohrCoulomb { elastic, cohesion, ..pyramid(0.0, 30.0, 0.0) };
        let strain = elastic.strain(&[-rest * pressure, -pressure, -rest * pressure, 0.0]);
        assert_eq!(law.respond(&strain, &FRESH).yields, yields);
    }
    // Without cohesion it settles on the active pressure.
    let law = MohrCoulomb { elastic, ..pyramid(0.0, 30.0, 0.0) };
    let stress = law.respond(&[0.0, -1e-3, 0.0, 0.0], &FRESH).stress;
    assert!((stress[0] / stress[1] - 1.0 / 3.0).abs() < 1e-12 && (stress[2] / stress[1] - 1.0 / 3.0).abs() < 1e-12);
}

#[test]
fn without_tension_cracks_open_and_close() {
    let law = NoTension { elastic: FILL };
    // Pressed one way and stretched the other with nothing across: a strut.
    let strut = sheet(Material::NoTension(law)).respond(&[1e-3, -2e-3, 0.0, 0.0], &FRESH);
    assert!(strut.stress[0].abs() < 1e-6 && (strut.stress[1] + 50e6 * 2e-3).abs() < 1e-6);
    assert!((strut.tangent[1][1] - 50e6).abs() < 1e2 && strut.tangent[0][0].abs() < 1e2);
    // Aslant: the strut stands along the greatest compression.
    let (sin, cos) = 0.4_f64.sin_cos();
    let [a, b] = [1e-3, -2e-3];
    let aslant = [a * cos * cos + b * sin * sin, a * sin * sin + b * cos * cos, 0.0, 2.0 * (a - b) * sin * cos];
    let turned = sheet(Material::NoTension(law)).respond(&aslant, &FRESH);
    assert!((turned.stress[0] + turned.stress[1] + 50e6 * 2e-3).abs() < 1e-6);
    // Cracked through and pressed again: as if nothing had been.
    let open = law.respond(&[1e-2, 1e-2, 1e-2, 0.0], &FRESH);
    assert!(size(&open.stress) < 1e-6 && open.memory.plastic[0] == 1e-2);
    let shut = law.respond(&[-1e-3, -1e-3, 0.0, 0.0], &open.memory);
    assert_eq!(shut.stress, FILL.stress(&[-1e-3, -1e-3, 0.0, 0.0]));
}

#[test]
fn a_tension_cutoff_cuts_off_tension_alone() {
    let with = DruckerPrager { tension_cutoff: Some(1e3), ..cone(Cone::Compression, 10e3, 30.0, 0.0) };
    let without = cone(Cone::Compression, 10e3, 30.0, 0.0);
    let pressed = [-5e-3, -1e-3, -3e-3, 1e-3];
    assert_eq!(with.respond(&pressed, &FRESH), without.respond(&pressed, &FRESH));
    let stretched = [5e-3, 0.0, 0.0, 1e-3];
    assert!(without.respond(&stretched, &FRESH).stress[0] > 5e3);
    assert!(with.respond(&stretched, &FRESH).stress[0] < 1e3 + 1e-6);
    // Sheared hard with pressure at nought, both take part: a Mohr circle that touches the cut-off, on the cone.
    let stress = with.respond(&[1e-3, -1e-3, 0.0, 4e-3], &FRESH).stress;
    let (sum, root) = invariants(&stress);
    let great = 0.5 * (stress[0] + stress[1]) + (0.5 * (stress[0] - stress[1])).hypot(stress[3]);
    assert!((great - 1e3).abs() < 1e-6 && (root + with.alpha * sum - with.strength).abs() < 1e-6, "{stress:?}");
}
