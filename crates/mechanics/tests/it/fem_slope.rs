//! A slope whose strength is divided until it slides: D. V. Griffiths and P. A. Lane (1999), Slope stability analysis by finite elements,
//! Géotechnique 49, 387-403, example 1: 2 to 1, without foundation, friction 20 degrees, cohesion 0.05 of weight times height, flow at constant
//! volume. Their factor is 1.4, Bishop and Morgenstern's 1.38.

use crate::fem_tools::{carried, grid, held, model, node, of};
use mechanics::fem::law::{Elastic, Material, MohrCoulomb, Plane};
use mechanics::fem::{Element, Kinematics, Outcome, Settings, Status, Target};
use mechanics::plane::vec2;

/// Height [m], and width of the crest [m].
const HEIGHT: f64 = 10.0;
const CREST: f64 = 12.0;

fn slope(element: Element, factor: f64, (nx, ny): (usize, usize)) -> Outcome {
    let place = |s: f64, t: f64| vec2(s * (CREST + 2.0 * HEIGHT * (1.0 - t)), HEIGHT * t);
    let mesh = grid(nx, ny, place);
    let supports: Vec<_> = (0..=nx)
        .map(|i| held(node(nx, i, 0), true, true))
        .chain((1..=ny).map(|j| held(node(nx, 0, j), true, false)))
        .collect();
    // 20 kN/m^3 by the tools' density and this gravity.
    let gravity = 10.0;
    let soil = MohrCoulomb {
        elastic: Elastic { modulus: 1e8, ratio: 0.3 },
        cohesion: 0.05 * 20e3 * HEIGHT / factor,
        friction_angle: (20f64.to_radians().tan() / factor).atan(),
        dilatancy_angle: 0.0,
        tension_cutoff: None,
    };
    let model = model(mesh, of(Material::MohrCoulomb(soil), Plane::Strain, element), &supports, Kinematics::Small);
    let target = Target { forces: model.weight(vec2(0.0, -gravity)), imposed: vec![] };
    let settings = Settings { load_steps: 1, iteration_limit: 200, cut_limit: 4, ..Settings::default() };
    carried(&model, &target, &settings).2
}

/// Elements with modes stand to within a few per cent of the published factor and fail just above it.
#[test]
fn a_slope_stands_up_to_its_factor_with_either_element() {
    for element in [Element::Q4, Element::QM6] {
        for factor in [1.0, 1.36] {
            let outcome = slope(element, factor, (32, 10));
            assert_eq!(outcome.status, Status::Completed, "{element:?} {factor}: {:?}", outcome.steps.last());
        }
    }
    let fails = slope(Element::QM6, 1.45, (32, 10));
    assert_eq!(fails.status, Status::NotConverged, "{:?}", fails.steps.last());
}

/// Plain elements stand well beyond it: a quarter of them lock, and the run says so.
#[test]
fn plain_elements_that_lock_are_told() {
    let outcome = slope(Element::Q4, 1.5, (32, 10));
    let locking = outcome.steps.last().unwrap().locking;
    assert!(outcome.status == Status::Completed && locking > 80, "{:?}: {locking} lock", outcome.status);
}
