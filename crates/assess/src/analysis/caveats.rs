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
/// The ground carries abutments that can move.
pub const GROUND_HOLDS: &str = "The ground below foundations and abutments is rigid and resists any force, and an abutment that is fixed neither \
                                slides nor tilts: settlement, bearing and scour are not checked, and each of them lowers the load.";
/// The load of sliding joints is found by an iteration.
pub const NO_BOUND: &str = "Where joints slide without dilation the load is the lowest that the iteration found from \
                            its starts, and no bound: other states of self-stress may carry less.";
/// A mechanism that is not in the plane.
pub const OUT_OF_PLANE: &str = "A plane model does not include spandrel walls that lean or slide outwards, cracks \
                                along the barrel, or edges that separate from it.";

/// Where forces along the bridge act.
pub const ALONG: &str = "Forces along the bridge act at the surface and are shared out as the vertical load disperses; all of them reach the \
                         rings or the ground right below, none the ground before and behind.";

/// Adds what concerns this analysis of a bridge.
pub fn add(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    let soil = c.limit().is_some_and(|l| l.continuum.is_some());
    let spreads = !soil && d.fill.is_none() && d.road.is_none() && bridge.dispersal.rule != DispersalRule::None;
    if spreads && !bridge.cover.layers.is_empty() {
        c.assumptions.push(FILL_UNDER_WHEELS.into());
    }
    let can_move = bridge.abutments.iter().any(|abutment| abutment.body.is_some());
    c.assumptions.push(if can_move { GROUND_HOLDS } else { SUPPORTS_HOLD }.into());
    c.assumptions.push(OUT_OF_PLANE.into());
    c.assumptions.extend(cracks(bridge));
    c.assumptions.extend(moved(bridge));
    c.assumptions.extend(water(bridge));
    if bridge.loads.iter().any(|load| load.horizontal != 0.0) {
        c.assumptions.push(ALONG.into());
    }
    c.warnings.extend(skew(bridge));
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

/// What a plane model leaves open of skew spans, worst first.
pub fn skew(bridge: &Bridge) -> Option<Warning> {
    let told: Vec<String> = bridge
        .spans
        .iter()
        .enumerate()
        .filter(|(_, span)| span.skew > 1e-6)
        .map(|(k, span)| {
            let degrees = span.skew.to_degrees();
            let square = span.span * span.skew.cos();
            format!("span {} by {degrees:.0} degrees ({:.2} m along the road, {square:.2} m square)", k + 1, span.span)
        })
        .collect();
    (!told.is_empty()).then(|| {
        let message = format!(
            "the bridge is skew and the model is square, of its spans along the road: {}; the load of a skew barrel was not found",
            told.join(", ")
        );
        Warning::new(warning::SKEW, message)
    })
}

/// What longitudinal cracks mean for a load per metre of width.
fn cracks(bridge: &Bridge) -> Option<String> {
    let cracks = bridge.carriageway.as_ref().map_or(&[][..], |asked| &asked.cracks);
    let strips: Vec<String> =
        bridge::strips(bridge.width, cracks).iter().map(|[from, to]| format!("{:.2} m", to - from)).collect();
    (strips.len() > 1).then(|| {
        format!(
            "Longitudinal cracks through the barrel leave strips of {}: each carries by itself what stands on it, and no load passes a \
             crack. The load per metre of width is that of every strip; vehicles of a sweep stand where they load one most, and an \
             effective width of the file holds for loads that stand on one strip alone.",
            strips.join(", ")
        )
    })
}

/// What a support that has moved before the loads came means for them.
pub fn moved(bridge: &Bridge) -> Option<String> {
    let before = bridge.plan.support_movement?.before.filter(|_| bridge.plan.analysis == bridge::Analysis::Load)?;
    Some(format!(
        "A support has moved by {:.1} mm before the loads came: blocks followed it as the mechanism that their weight allows, joints that \
         opened are brought together again halfway, and the loads act on that shape. Loads may have to turn joints back that opened before the \
         bridge carries this much: the nearer a movement is to the one that brings the bridge down, the less this load says. A joint that is to \
         stay open is a defect, \"open-joint\". The cover weighs what it weighed as built.",
        1e3 * before
    ))
}

/// What water in the pores of the fill does.
pub fn water(bridge: &Bridge) -> Option<String> {
    let water = bridge.cover.water?;
    Some(format!(
        "Water stands in the pores of the lowest layer up to {:.2} m above the left springing: below it the layer weighs {:.0} kg/m^3, and the \
         water presses on the backs whatever moves. The intrados is dry, backing holds no water, and what water does to strength, to walls and \
         to foundations is left out.",
        water.level, water.saturated_density
    ))
}

/// Whether a span has rings that lie on one another.
fn several_rings(d: &Discretised) -> bool {
    d.origins.iter().any(|origin| matches!(origin, Origin::Voussoir { ring: 1.., .. }))
}
