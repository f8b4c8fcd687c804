//! The way back to a cone about the hydrostatic axis: √J2 + α I1 ≤ k, flow along √J2 + β I1.
//!
//! Both flow and stress stay in the plane of the hydrostatic axis and the trial deviator, where the cone is a straight line:
//! closed form on its flank and at its apex (de Souza Neto, Perić, Owen 2008, section 8.3).

use super::elastic::Elastic;
use super::response::Four;

/// Yields are told from rounding by this share of the stresses they are made of.
pub(super) const ROUNDING: f64 = 1e-13;

/// Stress [Pa] and tangent [Pa] on the cone; none where the trial stress is admissible.
#[inline]
pub(super) fn back(elastic: &Elastic, trial: &Four, alpha: f64, beta: f64, k: f64) -> Option<(Four, [[f64; 4]; 4])> {
    let (bulk, shear) = (elastic.bulk(), elastic.shear());
    let sum = trial[0] + trial[1] + trial[2];
    let mean = sum / 3.0;
    let deviator = [trial[0] - mean, trial[1] - mean, trial[2] - mean, trial[3]];
    let radius = root_j2(&deviator);
    let excess = radius + alpha * sum - k;
    if !(excess > ROUNDING * (radius + (alpha * sum).abs() + k)) {
        return None;
    }
    let resistance = shear + 9.0 * bulk * alpha * beta;
    let flow = excess / resistance;
    let left = radius - shear * flow;
    if left < 0.0 {
        // The flank has ended: the apex is the only point of the cone that flow can reach, and it does not move.
        let apex = k / (3.0 * alpha);
        return Some(([apex, apex, apex, 0.0], [[0.0; 4]; 4]));
    }
    let share = left / radius;
    let mean = mean - 3.0 * bulk * beta * flow;
    let stress =
        [mean + share * deviator[0], mean + share * deviator[1], mean + share * deviator[2], share * deviator[3]];

    let along = deviator.map(|d| d / radius);
    let push = volumetric(3.0 * bulk * beta, shear, &along);
    let feel = volumetric(3.0 * bulk * alpha, shear, &along);
    let turn = shear * shear * flow / radius;
    let lame = bulk - 2.0 * shear * share / 3.0;
    let mut tangent = [[0.0; 4]; 4];
    for i in 0..4 {
        for j in 0..4 {
            let elastic = match (i, j) {
                (3, 3) => shear * share,
                (3, _) | (_, 3) => 0.0,
                _ if i == j => lame + 2.0 * shear * share,
                _ => lame,
            };
            tangent[i][j] = elastic - push[i] * feel[j] / resistance + turn * along[i] * along[j];
        }
    }
    Some((stress, tangent))
}

/// √J2 of a deviator.
pub(super) fn root_j2(deviator: &Four) -> f64 {
    let [x, y, z, xy] = deviator;
    (0.5 * (x * x + y * y + z * z) + xy * xy).sqrt()
}

fn volumetric(volume: f64, shear: f64, along: &Four) -> Four {
    [volume + shear * along[0], volume + shear * along[1], volume + shear * along[2], shear * along[3]]
}
