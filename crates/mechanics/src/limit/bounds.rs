//! Both bounds, recomputed from what the solver returned.

use super::compliance::{Resistance, Stiffness};
use super::equilibrium::Equilibrium;
use super::joints::Strength;

/// A load factor and how far what it rests on misses being admissible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bound {
    /// Scaled load factor.
    pub factor: f64,
    /// Largest violation, scaled.
    pub violation: f64,
}

/// The factor of the variable loads that the forces balance best, and the largest force they leave out of balance.
pub(super) fn lower(equilibrium: &Equilibrium, forces: &[f64]) -> Bound {
    let without = equilibrium.residual(forces, 0.0);
    let dot = |a: &[f64]| a.iter().zip(&equilibrium.variable).map(|(x, p)| x * p).sum::<f64>();
    let factor = -dot(&without) / dot(&equilibrium.variable);
    let violation = equilibrium.residual(forces, factor).iter().fold(0.0f64, |m, r| m.max(r.abs()));
    Bound { factor, violation }
}

/// Largest force by which a joint exceeds its strength, or an answer to movement its bounds, scaled.
pub(super) fn yield_violation(equilibrium: &Equilibrium, forces: &[f64]) -> f64 {
    let answers = equilibrium.restraints.iter().map(|r| (-forces[r.column]).max(forces[r.column] - r.most));
    answers.fold((-room(equilibrium, forces)).max(0.0), f64::max)
}

/// The least force that is left to any limit of any joint, scaled; negative where one is exceeded.
pub(super) fn room(equilibrium: &Equilibrium, forces: &[f64]) -> f64 {
    let unit = equilibrium.force;
    let mut room = f64::INFINITY;
    for joint in &equilibrium.joints {
        let (c, n, strength) = (joint.column, joint.points.len(), &joint.strength);
        let tension = strength.tension / unit;
        let total: f64 = forces[c..c + n].iter().sum();
        let curvature = strength.curvature(n) * unit;
        let least = curvature * (total + n as f64 * tension).powi(2);
        for k in 0..n {
            room = room.min(forces[c + k] - (least - tension));
        }
        if strength.friction.is_finite() {
            room = room.min(strength.friction * total + strength.cohesion / unit - forces[c + n].abs());
        }
    }
    room
}

/// The work equation: `factor p . u = -w . u + dissipation`, with the largest dissipation that each joint's strength
/// allows for the way it moves (associated flow). `violation` is the largest velocity that would dissipate without
/// bound. A motion in which the loads do no work bounds nothing, and its factor is infinite.
pub(super) fn upper(equilibrium: &Equilibrium, velocities: &[f64]) -> Bound {
    let work = resistance(equilibrium, velocities);
    let variable: f64 = equilibrium.variable.iter().zip(velocities).map(|(p, u)| p * u).sum();
    let factor = if variable > 0.0 { work.factor / variable } else { f64::INFINITY };
    Bound { factor, ..work }
}

/// What a motion needs of variable loads: what it dissipates less the work of the permanent loads, and the violation, as in [`upper`].
pub(super) fn resistance(equilibrium: &Equilibrium, velocities: &[f64]) -> Bound {
    let dot = |a: &[f64]| a.iter().zip(velocities).map(|(x, y)| x * y).sum::<f64>();
    let deformations = equilibrium.deformations(velocities);
    let (mut work, mut violation) = (-dot(&equilibrium.permanent), 0.0f64);
    for joint in &equilibrium.joints {
        let (d, v) = dissipation(&joint.strength, equilibrium.force, &deformations[joint.columns()]);
        work += d;
        violation = violation.max(v);
    }
    // A force that answers movement works where its point moves against it.
    for r in &equilibrium.restraints {
        work += r.most * (-deformations[r.column]).max(0.0);
    }
    Bound { factor: work, violation }
}

/// Largest dissipation of a joint that opens and slides as given (openings of its points, then sliding), and the
/// velocity that its flow rule does not allow.
fn dissipation(strength: &Strength, unit: f64, motion: &[f64]) -> (f64, f64) {
    let n = motion.len() - 1;
    let sliding = motion[n].abs();
    let (friction, mut violation) =
        if strength.friction.is_finite() { (strength.friction, 0.0) } else { (0.0, sliding) };
    let (tension, cohesion) = (strength.tension / unit, strength.cohesion / unit);
    // Shear at its limit leaves each compression `c` to dissipate `-c * excess`.
    let excess: Vec<f64> = motion[..n].iter().map(|o| o - friction * sliding).collect();
    let low = excess.iter().copied().fold(f64::INFINITY, f64::min);
    let high = excess.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // Least total compression, shifted by the tension: the apex of the friction cone may lie above full tension.
    let full = n as f64 * tension;
    let least =
        if friction > 0.0 && strength.friction.is_finite() { (full - cohesion / friction).max(0.0) } else { 0.0 };
    let curvature = strength.curvature(n) * unit;
    let shifted = if curvature > 0.0 {
        // Total `t`, `curvature t^2` of it at the wider side, the rest at the narrower: a concave parabola in `t`.
        let bend = 2.0 * curvature * (high - low);
        let most = 0.5 / curvature;
        let t = if bend > 0.0 {
            (-low / bend).clamp(least, most)
        } else if low < 0.0 {
            most
        } else {
            least
        };
        -(t * low + curvature * t * t * (high - low))
    } else {
        violation = violation.max(-low);
        -least * low.max(0.0)
    };
    (shifted + tension * excess.iter().sum::<f64>() + cohesion * sliding, violation)
}

/// The lower of the upper bounds of the velocities as they are and repaired; where joints cannot crush, the one that
/// obeys the flow rule better. Its violation is relative to the fastest velocity.
pub(super) fn least_upper(equilibrium: &Equilibrium, forces: &[f64], velocities: &[f64]) -> Bound {
    let of = |velocities: &[f64]| {
        let fastest = velocities.iter().fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()));
        let bound = upper(equilibrium, velocities);
        Bound { violation: bound.violation / fastest, ..bound }
    };
    let raw = of(velocities);
    if !equilibrium.crushes() && raw.violation < ADMISSIBLE {
        return raw;
    }
    let Some(repaired) = repair(equilibrium, forces, velocities) else { return raw };
    let repaired = of(&repaired);
    let better =
        repaired.violation < raw.violation || (repaired.violation <= raw.violation && repaired.factor < raw.factor);
    if better && repaired.factor.is_finite() { repaired } else { raw }
}

/// Violations of the flow rule up to this, relative to the fastest velocity, are left as they are.
const ADMISSIBLE: f64 = 1e-9;

/// Slack, relative to all permanent loads, below which a limit counts as reached: between the tolerance of the solver
/// and the forces of a loaded joint.
const REACHED: f64 = 1e-6;

/// Velocities near the given ones whose joints move only along the normals of the limits that their forces reach, as
/// the flow rule demands. What is taken out is the error of the solver. `None` where that cannot be done.
fn repair(equilibrium: &Equilibrium, forces: &[f64], velocities: &[f64]) -> Option<Vec<f64>> {
    let each = equilibrium.joints.iter();
    let forbidden = each.map(|joint| forbidden(&joint.strength, equilibrium.force, &forces[joint.columns()]));
    let mut stiffness = Stiffness::new(equilibrium, forbidden.collect())?;
    let mut repaired = velocities.to_vec();
    // Each pass takes out all but about 1e-12 over the stiffness of what the flow rule forbids.
    for _ in 0..3 {
        let out_of_balance = equilibrium.balance(vec![0.0; equilibrium.rows], &stiffness.forces(&repaired));
        for (u, d) in repaired.iter_mut().zip(stiffness.solve(&out_of_balance)) {
            *u -= d;
        }
    }
    repaired.iter().all(|u| u.is_finite()).then_some(repaired)
}

/// Projects a joint's motion on what is orthogonal to the normals of all limits that its forces reach.
fn forbidden(strength: &Strength, unit: f64, forces: &[f64]) -> Resistance {
    let n = forces.len() - 1;
    let tension = strength.tension / unit;
    let total: f64 = forces[..n].iter().sum();
    let shifted = total + n as f64 * tension;
    let curvature = strength.curvature(n) * unit;
    let mut projection = [[0.0; 3]; 3];
    for (k, row) in projection.iter_mut().enumerate().take(n + 1) {
        row[k] = 1.0;
    }
    let mut free = |normal: [f64; 3]| {
        let along = projection.map(|row| row[0] * normal[0] + row[1] * normal[1] + row[2] * normal[2]);
        let size: f64 = along.iter().map(|a| a * a).sum();
        // A normal in the span of the others frees nothing more.
        if size > 1e-20 {
            for (row, a) in projection.iter_mut().zip(along) {
                for (v, b) in row.iter_mut().zip(along) {
                    *v -= a * b / size;
                }
            }
        }
    };
    for k in 0..n {
        if forces[k] + tension - curvature * shifted * shifted < REACHED {
            let mut normal = [0.0; 3];
            normal[..n].fill(-2.0 * curvature * shifted);
            normal[k] += 1.0;
            free(normal);
        }
    }
    for sign in [1.0, -1.0] {
        let strongest = strength.friction * total + strength.cohesion / unit;
        if strength.friction.is_finite() && strongest + sign * forces[n] < REACHED {
            let mut normal = [0.0; 3];
            normal[..n].fill(strength.friction);
            normal[n] = sign;
            free(normal);
        }
    }
    projection
}
