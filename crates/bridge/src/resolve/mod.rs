//! From the tables to the bridge, each reporting everything that is wrong with it, and whether its parts fit together.

mod geometry;

use crate::fields::*;
use crate::findings::Findings;
use crate::library;
use crate::model::{Bridge, Masonry};
use crate::plausible;
use crate::tree::Table;

pub(crate) use geometry::Layout;

/// Reads the whole file. There is a bridge only if nothing is missing; whether it can be used is for the findings.
pub(crate) fn resolve(file: &Table<'_>, findings: &mut Findings) -> Option<Bridge> {
    let general = structure::general(file, findings);
    let mut spans = structure::spans(file, findings);
    let defects = spans.as_mut().map(|spans| defect::defects(file, spans, findings));
    let width = general.as_ref().map(|general| general.width);
    let piers = file.all("pier", findings, |table, findings| support::pier(table, width, findings));
    let abutments = support::abutments(file, findings);
    let masonry = file.table("masonry", findings).and_then(|table| Masonry::of(&table, findings));
    let joint = material::joint(file, "joint", findings);
    let ring_joint = if file.has("ring_joint") { material::joint(file, "ring_joint", findings) } else { joint };
    let parts = wall::Parts { width, masonry: masonry.as_ref(), joint: joint.as_ref(), abutments: abutments.as_ref() };
    let spandrel_wall = wall::spandrel_wall(file, &parts, findings);
    let edges = edge::edges(file, width, findings);
    let cover = cover::cover(file, width, findings);
    let cover = road::lay(file, cover, spans.as_deref(), piers.as_deref(), findings);
    let continuum = continuum::continuum(file, cover.as_ref(), findings);
    let service = service::service(file, cover.as_ref(), findings);
    let particles = particles::particles(file, cover.as_ref(), findings);
    let calibration = crate::calibration::calibration(file, findings);
    let dispersal = loading::dispersal(file, cover.as_ref(), findings);
    let lengths = spans.as_ref().zip(piers.as_ref()).map(|(spans, piers)| Layout::new(spans, piers));
    let carriageway =
        file.optional("carriageway", findings, |table, findings| sweep::carriageway(table, width, findings));
    let cracks = carriageway.as_ref().and_then(Option::as_ref).map_or(&[][..], |asked| &asked.cracks);
    let strip = width.map(|width| crate::model::widest_strip(width, cracks));
    let widths = loading::Widths { barrel: width, strip };
    let load = |table: &Table<'_>, findings: &mut Findings| loading::load(table, widths, lengths.as_ref(), findings);
    let loads = file.all("load", findings, load);
    let passage = passage::passage(file, strip, spans.as_deref(), lengths.as_ref(), findings);
    let places = (spans.as_deref(), lengths.as_ref());
    let load_test = load_test::load_test(file, passage.as_ref(), strip, places, findings);
    let fill_pressure = file.optional("fill_pressure", findings, crate::model::FillPressure::of);
    let sweep = file.optional("sweep", findings, sweep::sweep);
    let plan = plan::plan(file, width, spans.as_ref().map(Vec::len), findings);

    if let (Some(spans), Some(piers)) = (&spans, &piers) {
        structure::count_blocks(file, spans, piers, findings);
        geometry::check(file, spans, piers, (masonry.as_ref(), joint.as_ref()), cover.as_ref(), findings);
    }
    if let (Some(plan), Some(loads)) = (&plan, &loads) {
        let wall_joint = spandrel_wall.as_ref().and_then(Option::as_ref).map(|wall| &wall.joint);
        plan::check(file, plan, loads, [joint.as_ref(), ring_joint.as_ref(), wall_joint], masonry.as_ref(), findings);
        loading::check_blocks(file, plan, loads, matches!(particles, Some(Some(_))), findings);
    }
    plausible::check(file, spans.as_deref(), masonry.as_ref(), joint.as_ref(), findings);

    let general = general?;
    let general_skew = carriageway.as_ref().and_then(|asked| asked.as_ref()?.skew).unwrap_or(0.0);
    let spans = spans?;
    defects??;
    let mut piers = piers?;
    if let [one] = &piers[..] {
        piers = vec![one.clone(); spans.len() - 1];
    }
    let (parapet, kerb) = edges?;
    Some(Bridge {
        from_library: file.written().map_or_else(Vec::new, |written| library::from_library(file.section, written)),
        name: general.name,
        width: general.width,
        gravity: general.gravity,
        spans: spans.into_iter().map(|placed| skewed(placed, general_skew)).collect(),
        piers,
        abutments: abutments?,
        masonry: masonry?,
        joint: joint?,
        ring_joint: ring_joint?,
        spandrel_wall: spandrel_wall?,
        parapet,
        kerb,
        particles: particles?,
        calibration: calibration?,
        cover: cover?,
        loads: loads?,
        dispersal: dispersal?,
        plan: plan?,
        continuum: continuum?,
        fill_pressure: fill_pressure?,
        carriageway: carriageway?,
        sweep: sweep?,
        service: service?,
        passage: passage?,
        load_test: load_test?,
    })
}

/// A span with its own skew, or with that of the bridge.
fn skewed(placed: structure::PlacedSpan, general: f64) -> crate::model::Span {
    crate::model::Span { skew: placed.skew.unwrap_or(general), ..placed.span }
}
