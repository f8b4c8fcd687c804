//! Strip footings by finite elements beside the bounds, on the same ground and of the same strength.

use crate::continuum_tools::{between, ends, footing, rough, soil};
use crate::fem_verify_footing::{SOIL, factor};
use mechanics::fem::Element;
use mechanics::fem::law::{Cone, DruckerPrager, Material};
use mechanics::limit::continuum::Wanted;

/// The rough footing of `fem_verify_footing` on ground of a width and a depth [m], in cohesions.
fn footings(degrees: f64, (width, depth): (f64, f64), cohesion: f64, ratio: f64) {
    let angle = degrees.to_radians();
    let cone = DruckerPrager::matching(SOIL, Cone::PlaneStrain, cohesion, angle, angle);
    let on = |mesh| factor((width, depth), mesh, Material::DruckerPrager(cone), Element::QM6, cohesion);
    let found = [(4, 1.44), (8, 1.44f64.sqrt()), (16, 1.44f64.sqrt().sqrt())].map(on);
    // The same ground at half the size: without weight there is no length that could matter.
    let earth = soil(1.0, degrees, 0.0);
    let case = footing(earth, rough(&earth), 0.5 * width, 0.5 * depth);
    let bounds = case.bounds(Wanted { ratio, elements: 2500, first: 200, ..Wanted::default() });
    assert!(bounds.ratio().unwrap() <= ratio, "{:?}", bounds.rounds);
    between(found, ends(&bounds));
}

#[test]
fn finite_elements_lie_between_the_bounds_of_a_footing_on_clay() {
    footings(0.0, (5.0, 2.5), 100e3, 1.02);
}

#[test]
fn finite_elements_lie_between_the_bounds_of_a_footing_on_soil_with_friction() {
    footings(20.0, (8.0, 4.0), 10e3, 1.02);
    footings(30.0, (14.0, 6.0), 10e3, 1.04);
}
