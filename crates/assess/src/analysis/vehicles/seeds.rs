//! Mechanisms that bound slow cases before any was answered.

use super::factored::Footprint;
use bridge::Bridge;
use mechanics::limit::Ground;
use mechanics::watch::CancelToken;
use structure::discretise::Discretised;
use structure::discretise::dispersal::{Strip, spread};
use structure::discretise::springings::ranges;

/// Places in a span under which an axle gives the mechanisms to begin with.
const SEEDS: usize = 12;

/// Mechanisms under an axle at many places, to begin with: wherever a vehicle stands, one of them lies near.
pub(super) fn seeds(
    bridge: &Bridge,
    d: &Discretised,
    ground: &Ground,
    foot: &Footprint,
    token: &CancelToken,
) -> Vec<Vec<f64>> {
    let mut sweeper = ground.sweeper().paced(token);
    let mut motions = Vec::new();
    for (span, [left, _]) in bridge.spans.iter().zip(ranges(bridge)) {
        for place in 0..=SEEDS {
            let middle = left + span.span * place as f64 / SEEDS as f64;
            let strip =
                Strip { middle, length: foot.length, force: 1e3, horizontal: foot.horizontal, is_pressure: false };
            let spread = spread(strip, foot.dispersal, &d.surface, &d.extrados);
            if !spread.forces.is_empty() && !token.is_cancelled() {
                let effect = sweeper.effect(&spread.forces);
                motions.push(sweeper.motion(&effect));
            }
        }
    }
    motions
}
