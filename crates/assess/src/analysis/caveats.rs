//! What the pages of `docs/` say against a method, said in every result that it concerns. The table of all such sentences is
//! `docs/theory/limits.md`.

use bridge::{Bridge, DispersalRule};
use outcome::collapse::Collapse;
use outcome::collapse::FlowRule;
use outcome::warning::{self, Warning};
use structure::discretise::{Discretised, Origin};

/// Fill under a wheel is not asked whether it bears the wheel.
pub const FILL_UNDER_WHEELS: &str =
    "Dispersal is a rule: bearing failure of the fill under a wheel or a loading beam is not checked.";
/// Supports carry whatever reaches them.
pub const SUPPORTS_HOLD: &str = "Abutments and the ground below foundations are rigid and resist any force: spreading, \
                                 settlement, bearing and scour are not checked, and each of them lowers the load.";
/// The load of sliding joints is found by an iteration.
pub const NO_BOUND: &str = "Where joints slide without dilation the load is the lowest that the iteration found from \
                            its starts, and no bound: other states of self-stress may carry less.";
/// A mechanism that is not in the plane.
pub const OUT_OF_PLANE: &str = "A plane model does not include spandrel walls that lean or slide outwards, cracks \
                                along the barrel, or edges that separate from it.";

/// Adds what concerns this analysis of a bridge.
pub fn add(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    let soil = c.limit().is_some_and(|l| l.continuum.is_some());
    let spreads = !soil && d.fill.is_none() && d.road.is_none() && bridge.dispersal.rule != DispersalRule::None;
    if spreads && !bridge.cover.layers.is_empty() {
        c.assumptions.push(FILL_UNDER_WHEELS.into());
    }
    c.assumptions.push(SUPPORTS_HOLD.into());
    c.assumptions.push(OUT_OF_PLANE.into());
    if c.limit().is_some_and(|l| l.friction == FlowRule::NonAssociated) {
        c.assumptions.push(NO_BOUND.into());
    }
    if c.limit().is_some() && several_rings(d) && !c.sliding_joints.is_empty() {
        let message = "rings slide on one another: limit analysis takes the state of self-stress that carries most; \
                       for nine bridges with two rings discrete elements gave 0.66 to 0.82 of its load";
        c.warnings.push(Warning::new(warning::RINGS_SHARE, message));
    }
    if let Some(seed) = c.packing.as_ref().map(|p| p.seed) {
        let which = seed.map_or("a packing from a file".to_owned(), |seed| format!("seed {seed}"));
        let message =
            format!("the load is that of one packing ({which}): others of the same recipe differ by tens of per cent");
        c.warnings.push(Warning::new(warning::ONE_PACKING, message));
    }
}

/// Whether a span has rings that lie on one another.
fn several_rings(d: &Discretised) -> bool {
    d.origins.iter().any(|origin| matches!(origin, Origin::Voussoir { ring: 1.., .. }))
}
