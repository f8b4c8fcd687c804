//! Bodies of soil that several tests share, in plane strain.

use crate::limit_models::{block, dry, model};
use mechanics::blocks::{BlockModel, Held, Loading, PointForce};
use mechanics::ids::{BlockId, Id, Table};
use mechanics::limit::Settings;
use mechanics::limit::continuum::{
    Bears, Bounds, BoundsStatus, Contact, Continuum, Region, Setting, Side, Soil, Wanted, collapse_bounds,
};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::CancelToken;

/// A wall or a block that soil slides along and does not leave.
pub(crate) const SMOOTH: Contact = Contact { friction: 0.0, cohesion: 0.0, tension: f64::INFINITY };

/// Soil of a cohesion [Pa], a friction angle [degrees] and a unit weight [N/m^3].
pub(crate) fn soil(cohesion: f64, degrees: f64, weight: f64) -> Soil {
    Soil {
        cohesion,
        friction_angle: degrees.to_radians(),
        tension: f64::INFINITY,
        crushing: f64::INFINITY,
        weight: vec2(0.0, -weight),
        variable_weight: Vec2::ZERO,
    }
}

/// A contact as strong as the soil.
pub(crate) fn rough(soil: &Soil) -> Contact {
    Contact { friction: soil.friction_angle.tan(), cohesion: soil.cohesion, tension: f64::INFINITY }
}

/// A side that touches ground.
pub(crate) fn ground(a: Vec2, b: Vec2, contact: Contact) -> Side {
    Side { ends: [a, b], bears: Bears::Body { block: None, contact } }
}

/// A side that touches the only block.
pub(crate) fn body(a: Vec2, b: Vec2, contact: Contact) -> Side {
    Side { ends: [a, b], bears: Bears::Body { block: Some(BlockId::new(0)), contact } }
}

/// Soil, and perhaps one weightless block that a force drives.
pub(crate) struct Case {
    pub model: BlockModel,
    pub loading: Loading,
    pub soil: Continuum,
}

impl Case {
    /// Soil alone.
    pub(crate) fn alone(soil: Continuum) -> Case {
        let mut model = model(vec![], dry(0.5));
        model.blocks = Table::default();
        Case { model, loading: Loading::default(), soil }
    }
    /// A rectangle from `low`, of a width and a height, that moves where it is not held, driven by a force at its middle.
    pub(crate) fn driven(low: Vec2, width: f64, height: f64, held: Held, force: Vec2, soil: Continuum) -> Case {
        let outline = Polygon::rectangle(low, width, height).unwrap();
        let at = outline.centroid();
        let mut model = model(vec![block(outline, 0.0, 1.0, held)], dry(0.5));
        model.gravity = Vec2::ZERO;
        let variable = vec![PointForce { block: BlockId::new(0), at, force }];
        Case { model, loading: Loading { variable, ..Loading::default() }, soil }
    }
    pub(crate) fn setting(&self) -> Setting<'_> {
        Setting::new(&self.model, &self.loading, &Settings::default(), &self.soil).unwrap()
    }
    pub(crate) fn bounds(&self, wanted: Wanted) -> Bounds {
        collapse_bounds(&self.setting(), &wanted, &CancelToken::default()).unwrap()
    }
    /// Both bounds, which are wanted within a ratio and hold an exact value between them on every mesh.
    pub(crate) fn brackets(&self, exact: f64, ratio: f64, elements: usize) -> Bounds {
        let bounds = self.bounds(Wanted { ratio, elements, first: 200, ..Wanted::default() });
        assert_eq!(bounds.status, BoundsStatus::Bounded);
        for round in &bounds.rounds {
            let (lower, upper) = (round.lower.unwrap(), round.upper.unwrap());
            let size = exact.abs() * 1e-6;
            assert!(lower <= exact + size && exact <= upper + size, "{lower} {exact} {upper}");
        }
        for pair in bounds.rounds.windows(2) {
            let size = exact.abs() * 3e-4;
            assert!(
                pair[0].lower.unwrap() <= pair[1].lower.unwrap() + size,
                "a finer mesh holds the coarser field: {pair:?}"
            );
            assert!(
                pair[1].upper.unwrap() <= pair[0].upper.unwrap() + size,
                "a finer mesh holds the coarser motion: {pair:?}"
            );
        }
        let reached = bounds.ratio().unwrap();
        assert!(reached <= ratio, "{reached} after {} triangles", bounds.mesh.triangles.len());
        assert!(bounds.lower.as_ref().unwrap().equilibrium_residual < 1e-6);
        assert!(bounds.lower.as_ref().unwrap().yield_violation < 1e-6);
        assert!(bounds.upper.as_ref().unwrap().flow_violation < 1e-5);
        bounds
    }
}

/// Half of a strip footing 1 m wide on a layer `width` m wide and `depth` m deep, to the right of its middle; per metre of the strip, a factor
/// of one is a mean pressure of 1 Pa.
pub(crate) fn footing(soil: Soil, base: Contact, width: f64, depth: f64) -> Case {
    let corners = [vec2(0.0, -depth), vec2(width, -depth), vec2(width, 0.0), vec2(0.5, 0.0), vec2(0.0, 0.0)];
    let [a, b, c, d, e] = corners;
    let sides = vec![ground(a, b, rough(&soil)), ground(b, c, SMOOTH), body(d, e, base), ground(e, a, SMOOTH)];
    let held = Held { x: true, y: false, rotation: true };
    let earth =
        Continuum { regions: vec![Region { outline: corners.to_vec(), soil }], sides, water: None, panels: Vec::new() };
    Case::driven(vec2(0.0, 0.0), 0.5, 0.2, held, vec2(0.0, -0.5), earth)
}

/// Soil 1 m high behind a wall at x = 0 that moves level, and nothing else; a factor of one is 1 N/m on the wall, towards the soil (passive)
/// or away from it.
pub(crate) fn wall(soil: Soil, contact: Contact, towards: bool, width: f64) -> Case {
    let corners = [vec2(0.0, 0.0), vec2(width, 0.0), vec2(width, 1.0), vec2(0.0, 1.0)];
    let [a, b, c, d] = corners;
    let sides = vec![ground(a, b, rough(&soil)), ground(b, c, SMOOTH), body(d, a, contact)];
    let held = Held { x: false, y: true, rotation: true };
    let earth =
        Continuum { regions: vec![Region { outline: corners.to_vec(), soil }], sides, water: None, panels: Vec::new() };
    let force = vec2(if towards { 1.0 } else { -1.0 }, 0.0);
    Case::driven(vec2(-0.2, 0.0), 0.2, 1.0, held, force, earth)
}

/// The load that three meshes tend to if their errors form a geometric series; each has elements half as long as the one before.
pub(crate) fn extrapolated([coarse, middle, fine]: [f64; 3]) -> f64 {
    let [first, second] = [coarse - middle, middle - fine];
    // Errors of first order halve, those of order one half fall to 0.71.
    assert!(0.0 < second && second < 0.7 * first, "errors shrink as meshes do: {coarse} {middle} {fine}");
    fine - second * second / (first - second)
}

/// The lower and the upper bound.
pub(crate) fn ends(bounds: &Bounds) -> [f64; 2] {
    assert_eq!(bounds.status, BoundsStatus::Bounded);
    [bounds.lower.as_ref().unwrap().factor, bounds.upper.as_ref().unwrap().factor]
}

/// Finite elements never carry less than the lower bound, and no more than the upper one and the error of their mesh.
pub(crate) fn between(found: [f64; 3], [lower, upper]: [f64; 2]) {
    let limit = extrapolated(found);
    let error = found[2] - limit;
    assert!(found[2] > lower, "{found:?} below {lower}");
    assert!(found[2] <= upper + error, "{found:?}, less an error of {error}, above {upper}");
    assert!(limit >= lower, "{found:?} tend to {limit}, below {lower}");
}
