//! The collapse load.

use super::bounds;
use super::compliance::{Resistance, Stiffness};
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength, joints};
use super::level::{Governs, WithDilation, WithoutDilation, without_dilation};
use super::mechanism::mechanism;
use super::outcome::{JointForces, Outcome, PointForces, Resultant, Status};
use super::program::{Ending, Interpretation, Program, Solution};
use super::proven::{Roomy, proven, roomy};
use super::rest::{Rest, share};
use super::settings::{Friction, Settings};
use super::smooth::smooth;
use crate::blocks::{BlockModel, Interface, Loading, ModelError};
use crate::plane::Vec2;
use crate::watch::CancelToken;
use std::sync::OnceLock;

/// Relative gap and residuals to which programs are solved: well below the 1e-6 to which both bounds must agree.
pub(super) const TOLERANCE: f64 = 1e-9;

/// The largest factor of the variable loads that the blocks can carry together with gravity and the permanent loads.
///
/// # Errors
/// Nothing that is free to move, particles, or a block whose rounding leaves nothing of an edge.
pub fn collapse_load(model: &BlockModel, loading: &Loading, settings: &Settings) -> Result<Outcome, ModelError> {
    collapse_load_while(model, loading, settings, &CancelToken::default())
}

/// The same while `token` goes on; [`Status::Cancelled`] where it ends on the way.
///
/// # Errors
/// Those of [`collapse_load`].
pub fn collapse_load_while(
    model: &BlockModel,
    loading: &Loading,
    settings: &Settings,
    token: &CancelToken,
) -> Result<Outcome, ModelError> {
    if model.blocks.iter().all(|b| b.held.is_fixed()) {
        return Err(ModelError::NothingFree);
    }
    let (interfaces, joints) = joints(model, settings)?;
    let equilibrium = Equilibrium { token: token.clone(), ..Equilibrium::new(model, loading, &joints) };
    let strengths: Vec<Strength> = joints.iter().map(|j| j.strength).collect();
    let found = largest_factor(&equilibrium, &joints, &strengths);
    let mut outcome = report(model, &equilibrium, &joints, &strengths, interfaces, &found);
    let parts = (model, &equilibrium, &joints[..], &strengths[..]);
    by_friction(settings.friction, parts, &found, &Rest::default(), &mut outcome);
    if token.is_cancelled() {
        let Outcome { interfaces, iterations, friction, .. } = outcome;
        return Ok(Outcome::without_numbers(Status::Cancelled, friction, interfaces, iterations));
    }
    Ok(outcome)
}

/// Puts the answer without dilation in place of the one with it, where it counts by this friction.
pub(super) fn by_friction(
    friction: Friction,
    (model, equilibrium, joints, strengths): (&BlockModel, &Equilibrium, &[Joint], &[Strength]),
    found: &Found,
    at_rest: &Rest,
    outcome: &mut Outcome,
) {
    if friction == Friction::Associated || !matches!(found.status, Status::Solved | Status::Locks) {
        return;
    }
    let slides = outcome.mechanism.as_ref().is_some_and(|m| !m.sliding.is_empty());
    let beside = WithDilation { status: found.status, factor: found.solution.factor, slides };
    let level = without_dilation(equilibrium, joints, strengths, &beside, at_rest);
    let scale = equilibrium.factor_scale;
    if level.governs(friction, &beside) == Governs::WithDilation {
        return;
    }
    outcome.friction = Friction::NonAssociated;
    match level {
        WithoutDilation::Load(level) => {
            outcome.status = Status::Solved;
            outcome.iterations += level.solution.iterations;
            outcome.spread = Some(level.spread.map(|f| f * scale));
            state(equilibrium, joints, strengths, &level.solution, outcome);
            outcome.mechanism = mechanism(model, equilibrium, joints, &level.solution.velocities);
        }
        WithoutDilation::Locks => outcome.status = Status::Locks,
        WithoutDilation::Jammed => {
            (outcome.status, outcome.jammed) = (Status::NotConverged, true);
            (outcome.factor, outcome.lower_bound) = (None, None);
        }
        // Blocks that lock with dilatancy may still slide without: no load is known, only one that is carried.
        WithoutDilation::Unsettled => {
            outcome.status = Status::NotConverged;
            let sliding = outcome.mechanism.as_ref().map_or(&[][..], |m| &m.sliding[..]);
            let carried = smooth(model, equilibrium, joints, strengths, sliding).filter(|factor| *factor > 0.0);
            (outcome.factor, outcome.lower_bound) = (None, carried.map(|f| f * scale));
        }
    }
}

/// A solved program and what it means.
pub(super) struct Found {
    pub status: Status,
    pub solution: Solution,
    pub iterations: u32,
}

/// Whether the permanent loads are carried.
pub(super) struct Carried {
    /// `None` when the program was not solved.
    carried: Option<bool>,
    solution: Solution,
    /// A state with room to every limit, once it is asked for.
    roomy: OnceLock<Option<Roomy>>,
    /// How blocks rest under them, once it is asked for.
    pub at_rest: Rest,
}

impl Carried {
    /// A state of the permanent loads with room to every limit, where there is one.
    pub(super) fn roomy(&self, equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> Option<&Roomy> {
        self.roomy.get_or_init(|| roomy(equilibrium, joints, strengths)).as_ref()
    }
    /// Whether they are known to be carried.
    pub(super) fn is_carried(&self) -> bool {
        self.carried == Some(true)
    }
    /// Scaled joint forces that carry them, or carry most of them.
    pub(super) fn forces(&self) -> &[f64] {
        &self.solution.forces
    }
}

/// Asks whether the permanent loads are carried. Any state of equilibrium within strength proves it; the elastic one
/// is tried before a program looks for the best.
pub(super) fn carried(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> Carried {
    if let Some(forces) = elastic_state(equilibrium, joints, strengths) {
        let velocities = vec![0.0; equilibrium.rows];
        let solution = Solution { ending: Ending::Solved, forces, factor: 1.0, velocities, iterations: 0 };
        return Carried { carried: Some(true), solution, roomy: OnceLock::new(), at_rest: Rest::default() };
    }
    let solution = share(equilibrium, joints, strengths, 1e-8);
    let carried = (solution.ending == Ending::Solved).then_some(solution.factor >= 1.0 - 1e-6);
    Carried { carried, solution, roomy: OnceLock::new(), at_rest: Rest::default() }
}

/// Maximises the load factor, and asks what is wrong where there is no largest one.
pub(super) fn largest_factor(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> Found {
    let carried = carried(equilibrium, joints, strengths);
    let found = largest_factor_of_carried(equilibrium, joints, strengths, &carried);
    Found { iterations: found.iterations + carried.solution.iterations, ..found }
}

/// The same where it is known whether the permanent loads are carried.
pub(super) fn largest_factor_of_carried(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    stands: &Carried,
) -> Found {
    if stands.carried == Some(false) {
        return Found { status: Status::NoEquilibrium, solution: stands.solution.clone(), iterations: 0 };
    }
    let mut solution = Program::of_the_factor(equilibrium, joints, strengths).solve(TOLERANCE);
    let iterations = solution.iterations;
    // Where the permanent loads are carried the largest factor is zero at least.
    if stands.carried == Some(true) {
        solution.factor = if solution.factor > 0.0 { solution.factor } else { 0.0 };
    }
    if solution.ending == Ending::Solved && stands.carried == Some(true) {
        return Found { status: Status::Solved, solution, iterations };
    }
    if stands.carried == Some(true)
        && let Some(roomy) = stands.roomy(equilibrium, joints, strengths)
        && let Some(solution) = proven(equilibrium, joints, strengths, roomy, &solution)
    {
        return Found { status: Status::Solved, solution, iterations };
    }
    let locked = locks(equilibrium, joints, strengths);
    let status =
        if locked.ending == Ending::Solved && locked.factor > 0.5 { Status::Locks } else { Status::NotConverged };
    Found { status, solution, iterations: iterations + locked.iterations }
}

/// The forces of elastic joints under the permanent loads, if no joint exceeds its strength.
fn elastic_state(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> Option<Vec<f64>> {
    let alike: Vec<Resistance> = joints.iter().map(|_| [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).collect();
    let mut stiffness = Stiffness::new(equilibrium, joints, &alike)?;
    let mut forces = vec![0.0; equilibrium.columns.len()];
    // The second pass takes out what the first leaves of the loads.
    for _ in 0..2 {
        let left: Vec<f64> = equilibrium.residual(&forces, 0.0).iter().map(|r| -r).collect();
        let velocities = stiffness.solve(&left);
        for (f, d) in forces.iter_mut().zip(stiffness.forces(&velocities)) {
            *f += d;
        }
    }
    let left = equilibrium.residual(&forces, 0.0).iter().fold(0.0f64, |m, r| m.max(r.abs()));
    (left < 1e-12 && bounds::yield_violation(equilibrium, joints, strengths, &forces) <= 0.0).then_some(forces)
}

/// Whether the variable loads alone can grow without end: forces that no strength limits carry them.
pub(super) fn locks(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> Solution {
    // Without any strength in force units the largest share is all or nothing; crushing limits every load.
    let endless: Vec<Strength> = strengths
        .iter()
        .map(|s| Strength {
            tension: 0.0,
            cohesion: 0.0,
            crushing: if s.crushing.is_finite() { 0.0 } else { s.crushing },
            ..*s
        })
        .collect();
    let equilibrium = &equilibrium.unrestrained();
    let rest = vec![0.0; equilibrium.rows];
    let scaled_loads = &equilibrium.variable;
    let crushes = endless.iter().any(|s| s.crushing == 0.0);
    let cap = if crushes { Some(0.0) } else { Some(1.0) };
    Program {
        equilibrium,
        joints,
        strengths: &endless,
        scaled_loads,
        constant_loads: &rest,
        cap,
        objective: Vec::new(),
        interpretation: Interpretation::Factor,
    }
    .solve(1e-8)
}

pub(super) fn report(
    model: &BlockModel,
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    interfaces: Vec<Interface>,
    found: &Found,
) -> Outcome {
    let solution = &found.solution;
    let mut outcome = Outcome::without_numbers(found.status, Friction::Associated, interfaces, found.iterations);
    if matches!(found.status, Status::Solved | Status::NoEquilibrium) {
        outcome.mechanism = mechanism(model, equilibrium, joints, &solution.velocities);
    }
    if found.status == Status::Solved {
        state(equilibrium, joints, strengths, solution, &mut outcome);
        outcome.associated_factor = outcome.factor;
        let upper = bounds::least_upper(equilibrium, joints, strengths, &solution.forces, &solution.velocities);
        outcome.upper_bound = Some(upper.factor * equilibrium.factor_scale);
        outcome.flow_violation = upper.violation;
    }
    outcome
}

/// The forces of a solution, and how far they are from being admissible.
fn state(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    solution: &Solution,
    outcome: &mut Outcome,
) {
    outcome.factor = Some(solution.factor * equilibrium.factor_scale);
    let lower = bounds::lower(equilibrium, &solution.forces);
    outcome.lower_bound = Some(lower.factor.max(0.0) * equilibrium.factor_scale);
    // Permanent loads sum to one in their scaled form, and so do the variable ones.
    let loads = 1.0 + solution.factor.abs();
    outcome.equilibrium_residual = lower.violation / loads;
    outcome.yield_violation = bounds::yield_violation(equilibrium, joints, strengths, &solution.forces) / loads;
    outcome.forces = joint_forces(equilibrium, joints, &solution.forces);
    outcome.resultants = joints.iter().zip(&outcome.forces).map(|(j, f)| resultant(j, f)).collect();
}

/// Forces in newtons per metre, the shear shared in proportion to the compression.
pub(super) fn joint_forces(equilibrium: &Equilibrium, joints: &[Joint], forces: &[f64]) -> Vec<JointForces> {
    joints
        .iter()
        .zip(&equilibrium.first_column)
        .map(|(joint, &c)| {
            let n = joint.points.len();
            let compressions: Vec<f64> = forces[c..c + n].iter().map(|f| f * equilibrium.force).collect();
            let shear = forces[c + n] * equilibrium.force;
            let total: f64 = compressions.iter().map(|c| c.abs()).sum();
            let share = |c: f64| if total > 0.0 { c.abs() / total } else { 1.0 / n as f64 };
            let points = joint.points.iter().zip(&compressions);
            JointForces {
                points: points
                    .map(|(&at, &compression)| PointForces { at, compression, shear: shear * share(compression) })
                    .collect(),
                shear,
            }
        })
        .collect()
}

/// The resultant of a joint in compression.
pub(super) fn resultant(joint: &Joint, forces: &JointForces) -> Option<Resultant> {
    let total = forces.compression();
    let gross: f64 = forces.points.iter().map(|p| p.compression.abs()).sum();
    // Below round-off of the force unit there is no line of action to speak of.
    if total <= 1e-9 * gross || total <= 0.0 {
        return None;
    }
    let at = forces.points.iter().fold(Vec2::ZERO, |sum, p| sum + p.at * (p.compression / total));
    Some(Resultant { at, force: joint.normal * total + joint.tangent() * forces.shear })
}
