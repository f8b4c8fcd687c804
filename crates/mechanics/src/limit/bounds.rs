//! Both bounds, recomputed from what the solver returned.

use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};

/// A load factor and how far what it rests on misses being admissible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bound {
    /// Scaled load factor.
    pub factor: f64,
    /// Largest violation, scaled.
    pub violation: f64,
}

/// Largest force by which a joint exceeds its strength, scaled.
pub(super) fn yield_violation(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    forces: &[f64],
) -> f64 {
    let unit = equilibrium.force;
    let mut worst = 0.0f64;
    for ((joint, strength), &c) in joints.iter().zip(strengths).zip(&equilibrium.first_column) {
        let n = joint.points.len();
        let tension = strength.tension / unit;
        let total: f64 = forces[c..c + n].iter().sum();
        let curvature = strength.curvature(n) * unit;
        let least = curvature * (total + n as f64 * tension).powi(2);
        for k in 0..n {
            worst = worst.max(least - tension - forces[c + k]);
        }
        if strength.friction.is_finite() {
            worst = worst.max(forces[c + n].abs() - strength.friction * total - strength.cohesion / unit);
        }
    }
    worst
}

/// The work equation: `factor p . u = -w . u + dissipation`, with the largest dissipation that each joint's strength
/// allows for the way it moves (associated flow). `violation` is the largest velocity that would dissipate without
/// bound.
pub(super) fn upper(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength], velocities: &[f64]) -> Bound {
    let dot = |a: &[f64]| a.iter().zip(velocities).map(|(x, y)| x * y).sum::<f64>();
    let deformations = equilibrium.deformations(velocities);
    let (mut work, mut violation) = (-dot(&equilibrium.permanent), 0.0f64);
    for ((joint, strength), &c) in joints.iter().zip(strengths).zip(&equilibrium.first_column) {
        let (d, v) = dissipation(strength, equilibrium.force, &deformations[c..c + joint.forces()]);
        work += d;
        violation = violation.max(v);
    }
    Bound { factor: work / dot(&equilibrium.variable), violation }
}

/// Largest dissipation of a joint that opens and slides as given (openings of its points, then sliding), and the
/// velocity that its flow rule does not allow.
fn dissipation(strength: &Strength, unit: f64, motion: &[f64]) -> (f64, f64) {
    let n = motion.len() - 1;
    let sliding = motion[n].abs();
    let (friction, mut violation) = if strength.friction.is_finite() { (strength.friction, 0.0) } else { (0.0, sliding) };
    let (tension, cohesion) = (strength.tension / unit, strength.cohesion / unit);
    // Shear at its limit leaves each compression `c` to dissipate `-c * excess`.
    let excess: Vec<f64> = motion[..n].iter().map(|o| o - friction * sliding).collect();
    let low = excess.iter().copied().fold(f64::INFINITY, f64::min);
    let high = excess.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // Least total compression, shifted by the tension: the apex of the friction cone may lie above full tension.
    let full = n as f64 * tension;
    let least = if friction > 0.0 && strength.friction.is_finite() { (full - cohesion / friction).max(0.0) } else { 0.0 };
    let curvature = strength.curvature(n) * unit;
    let shifted = if curvature > 0.0 {
        // Total `t`, `curvature t^2` of it at the wider side, the rest at the narrower: a concave parabola in `t`.
        let bend = 2.0 * curvature * (high - low);
        let most = 0.5 / curvature;
        let t = if bend > 0.0 { (-low / bend).clamp(least, most) } else if low < 0.0 { most } else { least };
        -(t * low + curvature * t * t * (high - low))
    } else {
        violation = violation.max(-low);
        -least * low.max(0.0)
    };
    (shifted + tension * excess.iter().sum::<f64>() + cohesion * sliding, violation)
}
