//! Soil that is held out of its plane by panels that bear no more than they can.

use crate::continuum_tools::{Case, SMOOTH, body, ground, soil};
use mechanics::blocks::Held;
use mechanics::limit::continuum::{Bears, Continuum, Panel, Region, Side, Wanted};
use mechanics::plane::{Vec2, vec2};

/// More than anything asks for.
const ENOUGH: f64 = 1e3;

/// Soil with a cohesion of 1 Pa and 30 degrees of friction, 4 m long and 1 m high between smooth walls under a surcharge of 2 Pa, and pushed
/// together.
fn pressed(panels: Vec<Panel>) -> Case {
    let corners = [vec2(0.0, 0.0), vec2(4.0, 0.0), vec2(4.0, 1.0), vec2(0.0, 1.0)];
    let [a, b, c, d] = corners;
    let surcharge = Side { ends: [c, d], bears: Bears::Load { permanent: vec2(0.0, -2.0), variable: Vec2::ZERO } };
    let sides = vec![ground(a, b, SMOOTH), ground(b, c, SMOOTH), surcharge, body(d, a, SMOOTH)];
    let region = Region { outline: corners.to_vec(), soil: soil(1.0, 30.0, 0.0) };
    let earth = Continuum { regions: vec![region], sides, water: None, panels };
    let free = Held { x: false, y: true, rotation: true };
    Case::driven(vec2(-0.2, 0.0), 0.2, 1.0, free, vec2(1.0, 0.0), earth)
}

fn panel(ends: [f64; 2], force: f64, moment: f64) -> Panel {
    Panel { ends, foot: 0.0, force, moment }
}

/// What cohesion adds, and the passive pressure with it under the surcharge alone.
const COHESIVE: f64 = 2.0 * 1.732_050_807_568_877_2;
const PASSIVE: f64 = 3.0 * 2.0 + COHESIVE;

#[test]
fn soil_resists_what_the_smaller_pressure_beside_it_allows() {
    // Over 4 m^2 the resultant is spread evenly; more than the surcharge is of no use.
    for (panels, exact) in [
        (vec![], PASSIVE),
        (vec![panel([-1.0, 5.0], ENOUGH, ENOUGH)], PASSIVE),
        (vec![panel([-1.0, 5.0], 2.0, ENOUGH)], 3.0 * 0.5 + COHESIVE),
        (vec![panel([-1.0, 5.0], 0.0, ENOUGH)], COHESIVE),
    ] {
        let bounds = pressed(panels).bounds(Wanted { ratio: 1.01, elements: 400, first: 60, ..Wanted::default() });
        let both = [bounds.lower.as_ref().unwrap().factor, bounds.upper.as_ref().unwrap().factor];
        // The residuals are worth 1e-6 of the load, and three times that is taken off the lower bound.
        assert!(
            both[0] <= exact && both[1] >= exact && both.iter().all(|f| (f / exact - 1.0).abs() < 3e-6),
            "{both:?} {exact}"
        );
        assert!(bounds.upper.unwrap().flow_violation < 1e-6 && bounds.lower.unwrap().yield_violation < 1e-8);
    }
}

#[test]
fn a_panel_that_tilts_is_pressed_at_its_foot() {
    // The pressure of the surcharge up to a height, and none above: its moment over 4 m is what the panel bears.
    let height = 0.4;
    let moment = 4.0 * 2.0 * 0.5 * height * height;
    let exact = 3.0 * 2.0 * height + COHESIVE;
    let bounds = pressed(vec![panel([-1.0, 5.0], ENOUGH, moment)]).brackets(exact, 1.03, 1500);
    let [slide, tilt] = bounds.upper.unwrap().panels[0];
    assert!(tilt > 1e3 * slide.abs(), "it tilts: {slide} {tilt}");
}

#[test]
fn the_weakest_panel_counts_where_all_carry_one_force() {
    let panels = vec![panel([-1.0, 2.0], 3.0, ENOUGH), panel([2.0, 3.0], 0.4, ENOUGH), panel([3.0, 5.0], 0.5, ENOUGH)];
    let bounds = pressed(panels).bounds(Wanted { ratio: 1.02, elements: 1500, first: 200, ..Wanted::default() });
    // Whole triangles are counted to a panel: the edges of panels are as sharp as the mesh.
    let exact = 3.0 * 0.4 + COHESIVE;
    let (lower, upper) = (bounds.lower.unwrap().factor, bounds.upper.unwrap().factor);
    assert!(
        lower <= upper && (lower / exact - 1.0).abs() < 0.03 && (upper / exact - 1.0).abs() < 0.03,
        "{lower} {exact} {upper}"
    );
}

#[test]
fn soil_whose_weight_cannot_be_held_does_not_stand() {
    // A surcharge of 2 Pa needs a third of it beside it, less what cohesion gives: 2 = 3 s + 2 c sqrt(3).
    let mut earth = pressed(vec![panel([-1.0, 5.0], 0.4, ENOUGH)]).soil;
    earth.regions[0].soil.cohesion = 0.1;
    earth.sides[3] = ground(vec2(0.0, 1.0), vec2(0.0, 0.0), SMOOTH);
    let bounds = Case::alone(earth).bounds(Wanted { ratio: 1.05, elements: 200, first: 60, ..Wanted::default() });
    let carried = (3.0 * 0.1 + 0.1 * COHESIVE) / 2.0;
    assert!((bounds.share.unwrap() - carried).abs() < 1e-4, "{:?} {carried}", bounds.share);
}
