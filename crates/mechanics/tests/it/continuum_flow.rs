//! Flow that dilates less than by the friction angle, by iteration.

use crate::continuum_tools::{Case, SMOOTH, footing, soil};
use mechanics::limit::Settings;
use mechanics::limit::continuum::{Continuum, Flow, Setting, Wanted, Which, bound_on, collapse_bounds, flow_on};
use mechanics::watch::CancelToken;

/// The associated lower bound, that of strength reduced after Davis, and the iteration, on one mesh.
fn compared(case: &Case, dilatancy: f64) -> (f64, f64, Flow) {
    let (settings, token) = (Settings::default(), CancelToken::default());
    let wanted = Wanted { ratio: 1.01, elements: 450, first: 200, ..Wanted::default() };
    let found = collapse_bounds(&case.setting(), &wanted, &token).unwrap();
    let mut reduced = case.soil.clone();
    reduced.regions.iter_mut().for_each(|region| region.soil = region.soil.reduced(1.0, dilatancy));
    let on = |soil: &Continuum| {
        let setting = Setting::new(&case.model, &case.loading, &settings, soil).unwrap();
        bound_on(Which::Lower, &setting, &found.mesh, &token)
    };
    let flow = flow_on(dilatancy, &case.setting(), &found.mesh, &token);
    (on(&case.soil).unwrap(), on(&reduced).unwrap(), flow.unwrap())
}

#[test]
fn soil_that_dilates_by_its_friction_angle_needs_no_iteration() {
    let (associated, _, flow) = compared(&footing(soil(1.0, 30.0, 0.0), SMOOTH, 6.0, 3.0), 30f64.to_radians());
    assert!(flow.settled && flow.rounds == 3, "{flow:?}");
    assert!((flow.factor / associated - 1.0).abs() < 1e-6 && flow.excess < 1e-6, "{flow:?} {associated}");
}

#[test]
fn soil_that_does_not_dilate_carries_less_and_no_less_than_davis_says() {
    // Neither is exact. The less a soil dilates, the less it carries; at the edge of the
    // footing stresses stay a little beyond the true strength, and the result says by how much.
    let case = footing(soil(1.0, 30.0, 0.0), SMOOTH, 6.0, 3.0);
    let mut before = f64::INFINITY;
    for degrees in [15.0f64, 5.0, 0.0] {
        let (associated, reduced, flow) = compared(&case, degrees.to_radians());
        assert!(flow.settled, "{flow:?}");
        assert!(reduced < flow.factor && flow.factor < associated, "{reduced} {flow:?} {associated}");
        assert!(flow.factor < before && flow.excess < 0.05, "{flow:?} {before}");
        before = flow.factor;
    }
}

#[test]
fn clay_has_nothing_to_dilate() {
    let (associated, reduced, flow) = compared(&footing(soil(1.0, 0.0, 0.0), SMOOTH, 2.0, 1.2), 0.0);
    assert!((reduced / associated - 1.0).abs() < 1e-9);
    assert!((flow.factor / associated - 1.0).abs() < 1e-6, "{flow:?} {associated}");
}
