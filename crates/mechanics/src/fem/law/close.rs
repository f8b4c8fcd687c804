//! How answers of laws are closed.

use super::elastic::Elastic;
use super::response::{Four, Memory, Response};

/// Share of elasticity that tangents keep where a law may have none left: at an apex, a corner, a crack. Stress has no part of
/// it, so that answers are the same; equations of balance keep an inverse.
const KEPT: f64 = 1e-6;

/// Closes an answer whose tangent may vanish.
pub(super) fn softened(
    elastic: &Elastic,
    strain: &Four,
    old: &Memory,
    stress: Four,
    mut tangent: [[f64; 4]; 4],
) -> Response {
    for (row, whole) in tangent.iter_mut().zip(elastic.tangent()) {
        for (entry, whole) in row.iter_mut().zip(whole) {
            *entry += KEPT * (whole - *entry);
        }
    }
    flowed(elastic, strain, old, stress, tangent)
}

/// Closes an answer: what of the strain is not elastic becomes the new memory.
pub(super) fn flowed(elastic: &Elastic, strain: &Four, old: &Memory, stress: Four, tangent: [[f64; 4]; 4]) -> Response {
    let kept = elastic.strain(&stress);
    let plastic: Four = std::array::from_fn(|i| strain[i] - kept[i]);
    let more: Four = std::array::from_fn(|i| plastic[i] - old.plastic[i]);
    let length = (more[0] * more[0] + more[1] * more[1] + more[2] * more[2] + 0.5 * more[3] * more[3]).sqrt();
    Response { stress, tangent, memory: Memory { plastic, hardening: old.hardening + length }, yields: true }
}
