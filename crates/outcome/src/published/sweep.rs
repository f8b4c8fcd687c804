//! `extrados.sweep/1`.

use super::{Run, WarningObject, kilo};
use crate::sweep::{Sweep, SweepPoint};
use serde::Serialize;

/// The result of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepObject {
    schema: &'static str,
    status: &'static str,
    bridge: String,
    governing: Option<Position>,
    positions_not_converged: usize,
    step_m: f64,
    positions: Vec<Position>,
    assumptions: Vec<String>,
    warnings: Vec<WarningObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    threads: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wall_seconds: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Position {
    position_m: f64,
    offset_m: f64,
    status: &'static str,
    load_factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factor_at_most: Option<f64>,
    last_stable_load_kn_per_m: Option<f64>,
    last_stable_load_kn: Option<f64>,
    collapse_load_kn_per_m: Option<f64>,
    collapse_load_kn: Option<f64>,
    first_axle: usize,
    last_axle: usize,
}

impl SweepObject {
    /// The object for a sweep over a bridge of the given name and width [m].
    pub fn new(bridge: &str, width: f64, sweep: &Sweep, run: &Run) -> SweepObject {
        let position = |p: &SweepPoint| Position {
            position_m: p.position,
            offset_m: p.offset,
            status: p.status.word(),
            load_factor: p.load_factor,
            load_factor_at_most: p.load_factor_at_most,
            last_stable_load_kn_per_m: p.collapse_load.map(kilo),
            last_stable_load_kn: p.collapse_load.map(|l| kilo(l * width)),
            collapse_load_kn_per_m: p.collapse_load.map(kilo),
            collapse_load_kn: p.collapse_load.map(|l| kilo(l * width)),
            first_axle: p.axles[0] + 1,
            last_axle: p.axles[1] + 1,
        };
        SweepObject {
            schema: "extrados.sweep/1",
            status: sweep.ended().word(),
            bridge: bridge.to_string(),
            governing: sweep.governing.map(|k| position(&sweep.points[k])),
            positions_not_converged: sweep.positions_not_converged(),
            step_m: sweep.step,
            positions: sweep.points.iter().map(position).collect(),
            assumptions: sweep.assumptions.clone(),
            warnings: run.file_warnings.iter().cloned().chain(sweep.warnings.iter().map(WarningObject::from)).collect(),
            threads: (run.threads > 0).then_some(run.threads),
            wall_seconds: (run.threads > 0).then_some(run.wall_seconds),
        }
    }
}
