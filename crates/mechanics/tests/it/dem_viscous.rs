//! What damping costs on the Bridgemill arch, and the largest stress of the filled arch in the stress formulation.

use crate::dem_bridgemill::{INCREMENT, bridgemill, paper, run};
use mechanics::dem::{ContactLength, Damping, Outcome, Status};

/// The collapse load in steps of 100 kN over the width.
fn step(outcome: &Outcome) -> f64 {
    assert_eq!(outcome.status, Status::Collapsed);
    outcome.collapse_factor.unwrap() / INCREMENT
}

/// Viscous damping that is critical in the lowest mode of the arch as built finds the same load at 2.4 times the
/// iterations of adaptive damping (127,260 beside 53,720), not three times: up to the seventh load step the joints
/// stay closed, that mode is still the lowest, and critical damping in it cannot be bettered; both take about 1,700
/// iterations a step. The price comes with the open joints, whose lowest frequency falls while the damping stays:
/// a step then takes twice
/// as long, the last ones before collapse three times, and the collapse itself nine times.
#[test]
fn viscous_damping_pays_when_joints_open() {
    let arch = bridgemill(false, 1.0);
    let adaptive = run(&arch, None, &paper(Damping::Adaptive, ContactLength::Fixed));
    let viscous = run(&arch, None, &paper(Damping::Viscous(1.0), ContactLength::Fixed));
    assert_eq!((step(&adaptive), step(&viscous)), (18.0, 18.0));
    assert_eq!(adaptive.path.len(), viscous.path.len());
    let ratio = viscous.iterations_total as f64 / adaptive.iterations_total as f64;
    assert!(ratio > 2.2, "{ratio}");
    let stage = |k: usize| viscous.path[k].iterations as f64 / adaptive.path[k].iterations as f64;
    for k in 0..=6 {
        assert!((0.8..1.25).contains(&stage(k)), "step {k}: {}", stage(k));
    }
    for k in 16..=18 {
        assert!(stage(k) > 2.5, "step {k}: {}", stage(k));
    }
}

/// The paper reads 10.57 MPa for case 2 with contact lengths that follow the joint. Half the compressed part gives
/// 10.48 MPa with adaptive and 10.60 MPa with local damping: the state before collapse keeps the shear of the path on
/// which it was reached, so 2 % is about twice what damping alone decides.
#[test]
fn case_2_has_the_papers_stress_in_the_stress_formulation() {
    let arch = bridgemill(true, 1.0);
    for damping in [Damping::Adaptive, Damping::Local(0.7)] {
        let outcome = run(&arch, None, &paper(damping, ContactLength::Updated));
        assert_eq!(step(&outcome), 28.0, "{damping:?}");
        assert!((outcome.max_compressive_stress / 10.57e6 - 1.0).abs() < 0.02, "{}", outcome.max_compressive_stress);
    }
}
