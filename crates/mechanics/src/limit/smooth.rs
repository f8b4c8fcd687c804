//! A lower answer where the iteration without dilation finds no end: no friction in the joints that slide.
//!
//! Sliding without dilation is not associated, so that forces within the friction cones prove nothing by themselves.
//! They do for a smaller strength to which level sliding is normal and which lies inside every cone that the true forces
//! may reach (D. Radenkovic, "Théorèmes limites pour un matériau de Coulomb à dilatation non standardisée", C. R. Acad.
//! Sci. Paris 252, 1961, second theorem). Level sliding is normal to `|S| <= constant` alone, and inside every cone
//! `|S| <= friction N` with `N >= 0` lies only `S = 0`.
//!
//! Written out: let forces `f` with these strengths balance the factor `a`, and let true forces `g` move at `b` as a
//! mechanism whose joints open about their points everywhere and slide level in the joints without friction. By
//! virtual work `(a - b) P` is the sum of `(f - g)` times the motions, `P > 0` being what the load does. Opening points have
//! `g = 0` and `f >= 0`, sliding joints `f = 0` and `g` against the motion: no term is positive, so `a <= b`.
//!
//! What it bounds are mechanisms in which no other joint slides. Joints that slide in the mechanism found lose their
//! friction too, until none does.

use super::bounds;
use super::collapse::largest_factor;
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};
use super::mechanism::mechanism;
use super::outcome::Status;
use crate::blocks::BlockModel;

/// Most times that further joints lose their friction.
const ROUNDS: usize = 10;

/// Scaled load factor without friction and cohesion in the joints that slide; `None` where that carries nothing.
/// `sliding` are those of the associated mechanism.
pub(super) fn smooth(
    model: &BlockModel,
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    sliding: &[usize],
) -> Option<f64> {
    let mut strengths = strengths.to_vec();
    let mut slides = vec![false; joints.len()];
    let mut more = sliding.to_vec();
    for _ in 0..ROUNDS {
        for &joint in &more {
            slides[joint] = true;
            strengths[joint] = Strength { friction: 0.0, cohesion: 0.0, ..strengths[joint] };
        }
        let found = largest_factor(equilibrium, joints, &strengths);
        if found.status != Status::Solved {
            return None;
        }
        let moving = mechanism(model, equilibrium, joints, &found.solution.velocities)?;
        more = moving.sliding.into_iter().filter(|&joint| !slides[joint]).collect();
        if more.is_empty() {
            return Some(bounds::lower(equilibrium, &found.solution.forces).factor);
        }
    }
    None
}
