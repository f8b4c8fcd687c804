//! What the pages of `docs/` say against a method, said in every result that it concerns. The table of all such sentences is
//! `docs/theory/limits.md`.

use bridge::{Bridge, DispersalRule};
use outcome::collapse::Collapse;
use outcome::collapse::FlowRule;
use outcome::note::{self, Note};
use outcome::warning::{self, Warning};
use structure::discretise::{Discretised, Origin};

/// Adds what concerns this analysis of a bridge.
pub(super) fn add(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    let soil = c.limit().is_some_and(|l| l.continuum.is_some());
    let spreads = !soil && d.fill.is_none() && d.road.is_none() && bridge.dispersal.rule != DispersalRule::None;
    if spreads && !bridge.cover.layers.is_empty() {
        c.assumptions.push(note::Fill::BearingNotChecked.into());
    }
    let can_move = bridge.abutments.iter().any(|abutment| abutment.body.is_some());
    c.assumptions.push(if can_move { note::Barrel::GroundHolds } else { note::Barrel::SupportsHold }.into());
    c.assumptions.push(note::Barrel::OutOfPlane.into());
    c.assumptions.extend(from_library(bridge));
    c.assumptions.extend(cracks(bridge));
    c.assumptions.extend(moved(bridge));
    c.assumptions.extend(water(bridge));
    if bridge.loads.iter().any(|load| load.horizontal != 0.0) {
        c.assumptions.push(note::Barrel::ForcesAlong.into());
    }
    c.warnings.extend(skew(bridge));
    if c.limit().is_some_and(|l| l.friction == FlowRule::NonAssociated) {
        c.assumptions.push(note::Blocks::NoBound.into());
    }
    if c.limit().is_some() && several_rings(d) && !c.picture.sliding.is_empty() {
        c.warnings.push(warning::Joints::RingsShare.into());
    }
    if let Some(seed) = c.packing.as_ref().map(|p| p.seed) {
        c.warnings.push(warning::Cover::OnePacking { seed }.into());
    }
}

/// What the file takes from the library of materials.
pub(super) fn from_library(bridge: &Bridge) -> Option<Note> {
    let values = bridge.from_library.clone();
    (!values.is_empty()).then(|| note::Barrel::FromLibrary { values }.into())
}

/// What a plane model leaves open of skew spans, worst first.
pub(super) fn skew(bridge: &Bridge) -> Option<Warning> {
    let skew = bridge.spans.iter().enumerate().filter(|(_, span)| span.skew > 1e-6);
    let spans: Vec<_> = skew.map(|(k, span)| (k, span.skew, span.span)).collect();
    (!spans.is_empty()).then(|| warning::Cover::Skew { spans }.into())
}

/// What longitudinal cracks mean for a load per metre of width.
fn cracks(bridge: &Bridge) -> Option<Note> {
    let cracks = bridge.carriageway.as_ref().map_or(&[][..], |asked| &asked.cracks);
    let strips: Vec<f64> = bridge::strips(bridge.width, cracks).iter().map(|[from, to]| to - from).collect();
    (strips.len() > 1).then(|| note::Barrel::Cracks { strips }.into())
}

/// What a support that has moved before the loads came means for them.
pub(super) fn moved(bridge: &Bridge) -> Option<Note> {
    let by = bridge.plan.support_movement?.before.filter(|_| bridge.plan.analysis == bridge::Analysis::Load)?;
    Some(note::Barrel::SupportMoved { by }.into())
}

/// What water in the pores of the fill does.
pub(super) fn water(bridge: &Bridge) -> Option<Note> {
    let water = bridge.cover.water?;
    Some(note::Fill::Water { level: water.level, saturated_density: water.saturated_density }.into())
}

/// Whether a span has rings that lie on one another.
fn several_rings(d: &Discretised) -> bool {
    d.origins.iter().any(|origin| matches!(origin, Origin::Voussoir { ring: 1.., .. }))
}
