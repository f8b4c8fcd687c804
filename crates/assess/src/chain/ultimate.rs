//! The file's own loads at collapse, moved over the bridge; and a support that moves.

use super::spoken;
use crate::analysis::{self, AnalysisError, Collapse, Sweep};
use crate::discretise::bridge_length;
use crate::warning;
use crate::wire::{CollapseObject, MovementFacts, Run, UltimateFacts};
use bridge::{Analysis, Bridge, LoadKind, Method, Strip};
use mechanics::watch::Watch;
use serde_json::Value;

/// What the stage found: facts, the collapse at the governing position, and the sweep where loads could be moved.
#[derive(Debug, Clone, PartialEq)]
pub struct Ultimate {
    /// For checks and reports.
    pub facts: UltimateFacts,
    /// For drawing.
    pub collapse: Collapse,
    /// For drawing.
    pub sweep: Option<Sweep>,
}

/// Distance between positions [m], where the bridge is not so long that it would take more than [`MOST_POSITIONS`].
const STEP: f64 = 0.25;
const MOST_POSITIONS: usize = 101;

/// The bridge for limit analysis: between its walls, fill as weight, loads through the cover.
fn rigid(bridge: &Bridge) -> Bridge {
    let mut own = bridge.clone();
    (own.plan.analysis, own.plan.method, own.plan.strip) = (Analysis::Load, Method::Limit, Strip::Fill);
    own.loads.iter_mut().for_each(|load| load.block = None);
    own.particles = None;
    own.cover.layers.iter_mut().for_each(|layer| layer.particles = false);
    own
}

/// The factor on the run of axles that governs, at one position [m] of the first load: what is needed to see it change.
pub fn at_position(bridge: &Bridge, position: f64) -> Result<UltimateFacts, AnalysisError> {
    let own = by_weight_alone(bridge);
    let sweep = analysis::sweep(&rigid(own.as_ref().unwrap_or(bridge)), Some([position, position + 1e-3]), 2, true)?;
    let found = sweep.points.first();
    Ok(UltimateFacts {
        status: found.map_or("not-converged", |point| point.status.word()).to_owned(),
        load_factor: found.and_then(|point| point.load_factor),
        position_m: Some(position),
        ..UltimateFacts::default()
    })
}

/// The bridge with its fill as weight alone, where it presses.
pub fn by_weight_alone(bridge: &Bridge) -> Option<Bridge> {
    let mut own = bridge.clone();
    own.fill_pressure.as_mut().filter(|fill| fill.applies)?.applies = false;
    Some(own)
}

/// Moves the loads of the file over the bridge by limit analysis, and draws the collapse where they are worst. With fill that presses
/// both ends are made, and the lower one counts.
pub fn ultimate(bridge: &Bridge) -> Result<Ultimate, AnalysisError> {
    let found = moved(bridge)?;
    let Some(bare) = by_weight_alone(bridge) else { return Ok(found) };
    let lower = moved(&bare)?;
    let [with, without] = [&found, &lower].map(|one| one.facts.load_factor);
    let told = |factor: Option<f64>| factor.map_or("no factor".to_owned(), |factor| format!("{factor:.3}"));
    let message = format!(
        "factor on the loads of the file: {} by weight alone, {} with fill pressure; the lower one counts",
        told(without),
        told(with)
    );
    // A bridge that does not stand by weight alone has no factor: that is the lower end.
    let mut counts = if with.is_some_and(|with| without.is_some_and(|without| with < without)) { found } else { lower };
    counts.facts.load_factor_with_fill_pressure = with;
    counts.facts.warnings.push([warning::PRESSURE_RANGE.to_owned(), message]);
    Ok(counts)
}

fn moved(bridge: &Bridge) -> Result<Ultimate, AnalysisError> {
    let own = rigid(bridge);
    let length = bridge_length(&own);
    let positions = 1 + ((length / STEP).ceil() as usize).clamp(20, MOST_POSITIONS - 1);
    let sweep = analysis::sweep(&own, None, positions, true)?;
    let worst = sweep.governing.map(|k| sweep.points[k].clone());
    let file = analysis::collapse_by_limit(&own)?;
    let at_file = factor(&file);
    let mut facts = UltimateFacts {
        load: bridge.loads.iter().map(|load| load.name.as_str()).collect::<Vec<_>>().join(", "),
        method: match bridge.fill_pressure.is_some_and(|fill| fill.applies) {
            true => "limit analysis, rigid blocks as built, fill that presses where the ring moves into it",
            false => "limit analysis, rigid blocks as built, fill by its weight and dispersal alone",
        }
        .to_owned(),
        positions: sweep.points.len(),
        reference_load_kn_per_m: file.reference_load / 1e3,
        ..UltimateFacts::default()
    };
    // The file's own place may lie between two positions of the sweep.
    let moved = worst.filter(|worst| worst.load_factor < at_file.or(Some(f64::INFINITY)));
    let collapse = match &moved {
        Some(worst) => analysis::collapse_by_limit(&with_axles(&own, worst.offset, worst.axles))?,
        None => file,
    };
    facts.status = collapse.status.word().to_owned();
    facts.load_factor = moved.as_ref().map_or(at_file, |worst| worst.load_factor);
    facts.position_m = match &moved {
        Some(worst) => Some(worst.position),
        None => own.loads.first().map(|load| load.position),
    };
    facts.collapse_load_kn_per_m = collapse.collapse_load.map(|load| load / 1e3);
    facts.assumptions.clone_from(&collapse.assumptions);
    facts.warnings = spoken(&collapse.warnings);
    facts.object = object(&collapse);
    Ok(Ultimate { facts, collapse, sweep: Some(sweep) })
}

fn factor(found: &Collapse) -> Option<f64> {
    found.collapse_load.map(|load| load / found.reference_load)
}

/// The loads moved by an offset [m], with only a run of their axles.
fn with_axles(bridge: &Bridge, offset: f64, axles: [usize; 2]) -> Bridge {
    let mut own = bridge.clone();
    let mut first = 0;
    own.loads.retain_mut(|load| {
        load.position += offset;
        let LoadKind::Axles { axles: list, .. } = &mut load.kind else {
            first += 1;
            return (axles[0]..=axles[1]).contains(&(first - 1));
        };
        let begin = first;
        first += list.len();
        let mut k = begin;
        list.retain(|_| {
            k += 1;
            (axles[0]..=axles[1]).contains(&(k - 1))
        });
        !list.is_empty()
    });
    own
}

/// The movement of the file's support that makes a mechanism.
pub fn movement(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let mut own = bridge.clone();
    own.plan.analysis = Analysis::SupportMovement;
    analysis::collapse(&own, None, watch)
}

/// Its facts.
pub fn movement_facts(bridge: &Bridge, found: &Collapse) -> MovementFacts {
    let support = bridge.plan.support_movement.map_or(0, |movement| movement.support);
    let name = match support {
        0 => "left abutment".to_owned(),
        k if k == bridge.spans.len() => "right abutment".to_owned(),
        k => format!("pier {k}"),
    };
    let report = found.support.as_ref();
    MovementFacts {
        status: found.status.word().to_owned(),
        last_stable_mm: report.and_then(|report| report.last_stable).map(|m| 1e3 * m),
        collapse_mm: report.and_then(|report| report.collapse).map(|m| 1e3 * m),
        support: name,
        warnings: spoken(&found.warnings),
        object: object(found),
    }
}

/// The object of `extrados collapse`.
fn object(found: &Collapse) -> Value {
    serde_json::to_value(CollapseObject::new(found, &Run::default())).unwrap_or_default()
}
