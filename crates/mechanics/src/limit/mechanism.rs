//! What moves: hinges and sliding joints read from the velocities.

use super::equilibrium::Equilibrium;
use super::outcome::{Hinge, JointMotion, Mechanism};
use crate::blocks::BlockModel;
use crate::plane::Vec2;

/// Motions smaller than this share of the fastest one are round-off of the solver (its tolerance is 1e-9), not motion.
const STILL: f64 = 1e-6;

/// The mechanism of scaled velocities; `None` when nothing moves.
pub(super) fn mechanism(model: &BlockModel, equilibrium: &Equilibrium, velocities: &[f64]) -> Option<Mechanism> {
    let velocities = model.to_one_metre(&equilibrium.motions(velocities))?;
    let centroids = &equilibrium.centroids;
    let (mut motions, mut hinges, mut sliding) = (Vec::new(), Vec::new(), Vec::new());
    for (index, joint) in equilibrium.joints.iter().enumerate() {
        let (v1, w1) = velocities[joint.first];
        let (v2, w2) = velocities[joint.second];
        let relative =
            |at: Vec2| v2 + (at - centroids[joint.second]).left() * w2 - v1 - (at - centroids[joint.first]).left() * w1;
        let openings: Vec<f64> = joint.points.iter().map(|&at| relative(at).dot(joint.normal)).collect();
        let mut closed = 0;
        for k in 1..openings.len() {
            if openings[k] < openings[closed] {
                closed = k;
            }
        }
        let slide = relative(joint.points[closed]).dot(joint.tangent());
        let rotation = w2 - w1;
        motions.push(JointMotion { rotation, sliding: slide, opening: openings[closed] });
        // A point that opens no faster than its joint slides is in contact (dilation of associated sliding).
        let touching = openings[closed] <= STILL + joint.strength.friction.min(1e3) * slide.abs() * (1.0 + STILL);
        if slide.abs() > STILL && touching {
            sliding.push(index);
        }
        if rotation.abs() * joint.length > STILL && touching {
            hinges.push(Hinge { joint: index, point: closed, at: joint.points[closed], rotation });
        }
    }
    Some(Mechanism { velocities, joints: motions, hinges, sliding })
}
