//! `extrados.sweep/1`.

use super::{Object, kilo, list, not_counted, object, warnings};
use crate::note;
use crate::sweep::{Sweep, SweepPoint};

/// The result of a sweep over a bridge of the given name and width [m].
pub fn sweep(bridge: &str, width: f64, sweep: &Sweep) -> Object {
    let position = |p: &SweepPoint| {
        object! {
            position_m: p.position,
            offset_m: p.offset,
            status: p.status,
            load_factor: p.load_factor,
            load_factor_at_most?: p.load_factor_at_most,
            rigid_factor?: p.rigid_factor,
            deformable_factor?: p.deformable_factor,
            lower_bound_factor?: p.upper_factor.and(p.load_factor),
            upper_bound_factor?: p.upper_factor,
            last_stable_load_kn_per_m: p.collapse_load.map(kilo),
            last_stable_load_kn: p.collapse_load.map(|l| kilo(l * width)),
            collapse_load_kn_per_m: p.collapse_load.map(kilo),
            collapse_load_kn: p.collapse_load.map(|l| kilo(l * width)),
            first_axle: p.axles[0] + 1,
            last_axle: p.axles[1] + 1,
        }
    };
    object! {
        schema: "extrados.sweep/1",
        status: sweep.ended(),
        bridge: bridge,
        governing: sweep.governing.map(|k| position(&sweep.points[k])),
        ..not_counted(&sweep.not_counted),
        positions_not_converged: sweep.positions_not_converged(),
        step_m: sweep.step,
        positions: list(&sweep.points, position),
        assumptions: note::words(&sweep.assumptions),
        warnings: warnings(&sweep.warnings),
    }
}
