//! Limit analysis with the loads moved over the bridge.

use super::report::Status;
use super::{AnalysisError, by_limit};
use crate::discretise::{bridge_length, discretise};
use bridge::{Bridge, LoadKind};
use mechanics::limit;
use rayon::prelude::*;

/// The load at one position.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepPoint {
    /// How far the loads were moved from where the file places them [m].
    pub offset: f64,
    /// Position of the first load's reference point [m].
    pub position: f64,
    /// How the worst subset of axles ended.
    pub status: Status,
    /// Least load factor over the subsets of axles.
    pub load_factor: Option<f64>,
    /// Collapse load of the governing subset [N/m].
    pub collapse_load: Option<f64>,
    /// First and last axle of the governing subset, over all loads in the order of the file.
    pub axles: [usize; 2],
}

/// A sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Positions from left to right.
    pub points: Vec<SweepPoint>,
    /// Index of the position with the least load factor.
    pub governing: Option<usize>,
}

/// Moves all loads of the file together so that the first load's reference point runs from `from` to `to` [m] in
/// `positions` equal steps, both ends included. With `subsets`, every run of neighbouring axles is tried: an axle on the
/// far side of an arch can help it. Positions are independent, so results do not depend on the number of threads.
pub fn sweep(
    bridge: &Bridge,
    range: Option<[f64; 2]>,
    positions: usize,
    subsets: bool,
) -> Result<Sweep, AnalysisError> {
    let first = bridge.loads.first().ok_or(AnalysisError::NoLoad)?.position;
    let [from, to] = range.unwrap_or([0.0, bridge_length(bridge)]);
    let last = positions.max(2) - 1;
    let points: Vec<SweepPoint> = (0..=last)
        .into_par_iter()
        .map(|k| {
            let position = from + (to - from) * k as f64 / last as f64;
            at(bridge, position - first, position, subsets)
        })
        .collect::<Result<_, _>>()?;
    let governing = points
        .iter()
        .enumerate()
        .filter_map(|(k, p)| p.load_factor.map(|f| (k, f)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(k, _)| k);
    Ok(Sweep { points, governing })
}

fn at(bridge: &Bridge, offset: f64, position: f64, subsets: bool) -> Result<SweepPoint, AnalysisError> {
    let mut moved = bridge.clone();
    for load in &mut moved.loads {
        load.position += offset;
    }
    moved.plan.support_movement = None;
    let mut d = discretise(&moved)?;
    let settings = by_limit::settings(bridge);
    let axles = d.spreads.len();
    let vehicle = bridge.loads.iter().any(|l| matches!(l.kind, LoadKind::Axles { .. }));
    let runs: Vec<[usize; 2]> = if subsets && vehicle {
        (0..axles).flat_map(|a| (a..axles).map(move |b| [a, b])).collect()
    } else {
        vec![[0, axles - 1]]
    };
    let mut worst = SweepPoint {
        offset,
        position,
        status: Status::Locks,
        load_factor: None,
        collapse_load: None,
        axles: [0, axles - 1],
    };
    for run in runs {
        let chosen = &d.spreads[run[0]..=run[1]];
        d.loading.variable = chosen.iter().flat_map(|s| s.forces.iter().copied()).collect();
        let load: f64 = chosen.iter().map(|s| s.strip.force).sum();
        if d.loading.variable.is_empty() {
            continue;
        }
        let outcome = limit::collapse_load(&d.model, &d.loading, &settings)?;
        let status = by_limit::status(&outcome);
        if let Some(factor) = outcome.factor
            && worst.load_factor.is_none_or(|w| factor < w)
        {
            worst = SweepPoint {
                status,
                load_factor: Some(factor),
                collapse_load: Some(factor * load),
                axles: run,
                ..worst
            };
        } else if worst.load_factor.is_none() {
            worst.status = status;
        }
    }
    Ok(worst)
}
