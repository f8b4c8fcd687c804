//! Normal traffic in the lanes beside an abnormal vehicle.
//!
//! What both carry together follows from what each carries by itself. If the bridge is in balance under λ_A times the loads A, and under
//! λ_B times the loads B, it is in balance under every mean of the two, for the states that joints can carry are a convex set: under λ times
//! A and B together with 1/λ = 1/λ_A + 1/λ_B at least, wherever B stands. On the width that both share, the traffic beside is therefore worth
//! so many of the first vehicle's loads as that vehicle carries more often by itself.

use super::across::room;
use super::search;
use super::traffic::Traffic;
use crate::analysis::AnalysisError;
use crate::analysis::parallel::portion;
use crate::vehicles::{BesideLane, Chosen, named_beside};
use bridge::{Bridge, SweepPlan};
use mechanics::watch::Watch;
use outcome::note;
use outcome::vehicles::{Swept, Weights};
use rules::Rule;

/// What is clear between the wheels of two vehicles abreast [m] (BD 21: 0.7 m, recalled).
const CLEAR: f64 = 0.7;

/// What a vehicle by itself asks of a metre of width: the width that carries it over its adequacy factor [m].
fn asked(one: &Swept) -> Option<f64> {
    let width = one.across.uniform.iter().copied().filter(|w| w.is_finite()).fold(one.across.axles, f64::max);
    one.factor().filter(|factor| *factor > 0.0).map(|factor| width / factor)
}

/// The vehicles, each with what stands in the lanes beside it where its rule asks for that and the carriageway has room.
pub(super) fn loaded(
    bridge: &Bridge,
    (rule, plan): (&Rule, &SweepPlan),
    mut vehicles: Vec<Chosen>,
    (weights, step): (&[Weights], f64),
    watch: &mut dyn Watch,
) -> Result<Vec<Chosen>, AnalysisError> {
    let mut own = bridge.clone();
    let carriageway = own.carriageway.get_or_insert_default();
    (carriageway.lanes, carriageway.edge_distance) = (Some(1), None);
    carriageway.cracks.clear();
    let count = vehicles.len() as f64;
    for (k, chosen) in vehicles.iter_mut().enumerate() {
        let Some(beside) = chosen.acting.beside.clone() else { continue };
        let lanes = room(bridge, chosen).0 - 1;
        if lanes == 0 {
            continue;
        }
        let traffic = match named_beside(bridge, plan, rule, &beside.vehicles) {
            Ok(traffic) => traffic,
            Err(why) => {
                chosen.acting.left_out.push(format!("traffic in the lanes beside {}: {why}", chosen.vehicle.code));
                continue;
            }
        };
        let mut all = vec![chosen.clone()];
        all.extend(traffic);
        let part = &mut portion(watch, [k as f64 / count, (k + 1) as f64 / count]);
        let by_itself = search::all(&Traffic::new(&own, (rule, plan), (&all, weights))?, (step, true), part)?;
        let [first, others @ ..] = &by_itself[..] else { continue };
        let worst = others
            .iter()
            .zip(&all[1..])
            .filter_map(|(one, of)| Some((asked(one)?, one, of)))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        let (Some(alone), Some((more, swept, of))) = (asked(first), worst) else { continue };
        let share = beside.share * more / alone;
        let apart = 0.5 * (chosen.vehicle.wheel_track_m + of.vehicle.wheel_track_m) + CLEAR;
        chosen.abreast = std::iter::once(1.0).chain(std::iter::repeat_n(share, lanes)).collect();
        chosen.beside = Some(BesideLane {
            code: of.vehicle.code.clone(),
            share,
            apart,
            narrower: first.across.axles - swept.across.axles,
        });
    }
    Ok(vehicles)
}

/// What is assumed of lanes beside, in words.
pub(super) fn told(vehicles: &[Chosen]) -> impl Iterator<Item = note::Moving> {
    vehicles.iter().filter_map(|chosen| {
        let (lane, rule) = (chosen.beside.as_ref()?, chosen.acting.beside.as_ref()?);
        Some(note::Moving::LanesBeside {
            vehicle: chosen.vehicle.code.clone(),
            beside: lane.code.clone(),
            loads: rule.share,
            times: lane.share,
            source: rule.source.clone(),
        })
    })
}
