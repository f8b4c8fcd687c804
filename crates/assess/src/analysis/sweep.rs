//! Limit analysis with the loads moved over the bridge.

use super::report::Status;
use super::{AnalysisError, by_limit};
use crate::discretise::{Discretised, bridge_length, dispersal};
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
    if bridge.loads.iter().any(|load| load.block.is_some()) {
        return Err(AnalysisError::MovedBlock);
    }
    let [from, to] = range.unwrap_or([0.0, bridge_length(bridge)]);
    let last = positions.max(2) - 1;
    let mut d = by_limit::prepared(bridge)?;
    d.loading.variable.clear();
    let settings = by_limit::single(bridge, &d);
    let places: Vec<f64> = (0..=last).map(|k| from + (to - from) * k as f64 / last as f64).collect();
    let points: Vec<SweepPoint> = places
        .par_chunks(CHUNK)
        .map(|places| stretch(bridge, &d, &settings, places, first, subsets))
        .collect::<Result<Vec<_>, _>>()?
        .concat();
    let governing = points
        .iter()
        .enumerate()
        .filter_map(|(k, p)| p.load_factor.map(|f| (k, f)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(k, _)| k);
    Ok(Sweep { points, governing })
}

/// Positions that one thread takes at a time; the equations are set up once for them.
const CHUNK: usize = 8;

/// A run of neighbouring axles at a position.
struct Case {
    position: usize,
    axles: [usize; 2],
    force: f64,
}

fn stretch(
    bridge: &Bridge,
    d: &Discretised,
    settings: &limit::Settings,
    places: &[f64],
    first: f64,
    subsets: bool,
) -> Result<Vec<SweepPoint>, AnalysisError> {
    let vehicle = bridge.loads.iter().any(|l| matches!(l.kind, LoadKind::Axles { .. }));
    let (mut cases, mut loads, mut points) = (Vec::new(), Vec::new(), Vec::new());
    for (position, &place) in places.iter().enumerate() {
        let offset = place - first;
        let spreads: Vec<_> = bridge
            .loads
            .iter()
            .flat_map(|load| dispersal::strips(&load.kind, load.position + offset))
            .map(|strip| d.spread(bridge, strip))
            .collect();
        let n = spreads.len();
        let runs: Vec<[usize; 2]> = match subsets && vehicle {
            true => (0..n).flat_map(|a| (a..n).map(move |b| [a, b])).collect(),
            false => vec![[0, n - 1]],
        };
        for axles in runs {
            let chosen = &spreads[axles[0]..=axles[1]];
            let forces: Vec<_> = chosen.iter().flat_map(|s| s.forces.iter().copied()).collect();
            if !forces.is_empty() {
                cases.push(Case { position, axles, force: chosen.iter().map(|s| s.strip.force).sum() });
                loads.push(forces);
            }
        }
        points.push(SweepPoint {
            offset,
            position: place,
            status: Status::Locks,
            load_factor: None,
            collapse_load: None,
            axles: [0, n - 1],
        });
    }
    let found = limit::sweep(&d.model, &d.loading, &loads, settings)?;
    for (case, answer) in cases.iter().zip(&found.places) {
        let point = &mut points[case.position];
        match answer.factor {
            Some(factor) if point.load_factor.is_none_or(|worst| factor < worst) => {
                point.status = by_limit::status(answer.status);
                point.load_factor = Some(factor);
                point.collapse_load = Some(factor * case.force);
                point.axles = case.axles;
            }
            None if point.load_factor.is_none() => point.status = by_limit::status(answer.status),
            _ => {}
        }
    }
    Ok(points)
}
