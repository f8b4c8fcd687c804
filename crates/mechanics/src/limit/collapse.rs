//! The collapse load.

use super::bounds;
use super::compliance::Stiffness;
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};
use super::level::{WithDilation, without_dilation};
use super::mechanism::mechanism;
use super::outcome::{JointForces, Outcome, PointForces, Resultant, Status};
use super::program::{Program, Solution};
use super::proven::{Roomy, proven, roomy};
use super::rest::{Rest, share};
use super::settings::{Friction, Settings};
use super::smooth::smooth;
use super::stiff::WithoutDilation;
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
    let (interfaces, mut equilibrium) = Equilibrium::of_free(model, loading, settings)?;
    equilibrium.token = token.clone();
    let found = largest_factor(&equilibrium);
    Ok(outcome(model, &equilibrium, interfaces, &found, settings.friction, &Rest::default()))
}

/// What a solved program means by this friction; nothing where the work was stopped on the way.
pub(super) fn outcome(
    model: &BlockModel,
    equilibrium: &Equilibrium,
    interfaces: Vec<Interface>,
    found: &Found,
    friction: Friction,
    at_rest: &Rest,
) -> Outcome {
    let mut outcome = report(model, equilibrium, interfaces, found);
    by_friction(friction, (model, equilibrium), found, at_rest, &mut outcome);
    if equilibrium.token.is_cancelled() {
        let Outcome { interfaces, iterations, friction, .. } = outcome;
        return Outcome { status: Status::Cancelled, friction, interfaces, iterations, ..Outcome::default() };
    }
    outcome
}

/// Puts the answer without dilation in place of the one with it, where it counts by this friction.
fn by_friction(
    friction: Friction,
    (model, equilibrium): (&BlockModel, &Equilibrium),
    found: &Found,
    at_rest: &Rest,
    outcome: &mut Outcome,
) {
    if friction == Friction::Associated || !matches!(found.status, Status::Solved | Status::Locks) {
        return;
    }
    let slides = outcome.mechanism.as_ref().is_some_and(|m| !m.sliding.is_empty());
    let beside = WithDilation { status: found.status, factor: found.solution.factor, slides };
    let level = without_dilation(equilibrium, &beside, at_rest);
    let scale = equilibrium.factor_scale;
    if !level.governs(friction, &beside) {
        return;
    }
    outcome.friction = Friction::NonAssociated;
    match level {
        WithoutDilation::Load { solution, spread, comes_and_goes } => {
            outcome.comes_and_goes = comes_and_goes;
            outcome.status = Status::Solved;
            outcome.iterations += solution.iterations;
            outcome.spread = Some(spread.map(|f| f * scale));
            state(equilibrium, &solution, outcome);
            outcome.mechanism = mechanism(model, equilibrium, &solution.velocities);
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
            let carried = smooth(model, equilibrium, sliding).filter(|factor| *factor > 0.0);
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
    /// Scaled joint forces that carry them, or carry most of them.
    pub solution: Solution,
    /// A state with room to every limit, once it is asked for.
    roomy: OnceLock<Option<Roomy>>,
    /// How blocks rest under them, once it is asked for.
    pub at_rest: Rest,
}

impl Carried {
    /// A state of the permanent loads with room to every limit, where there is one.
    pub(super) fn roomy(&self, equilibrium: &Equilibrium) -> Option<&Roomy> {
        self.roomy.get_or_init(|| roomy(equilibrium)).as_ref()
    }
    /// Whether they are known to be carried.
    pub(super) fn is_carried(&self) -> bool {
        self.carried == Some(true)
    }
}

/// Asks whether the permanent loads are carried. Any state of equilibrium within strength proves it; the elastic one
/// is tried before a program looks for the best.
pub(super) fn carried(equilibrium: &Equilibrium) -> Carried {
    let solution = match elastic_state(equilibrium) {
        Some(forces) => {
            let velocities = vec![0.0; equilibrium.rows];
            Solution { solved: true, forces, factor: 1.0, velocities, iterations: 0 }
        }
        None => share(equilibrium),
    };
    let carried = solution.solved.then_some(solution.factor >= 1.0 - 1e-6);
    Carried { carried, solution, roomy: OnceLock::new(), at_rest: Rest::default() }
}

/// Maximises the load factor, and asks what is wrong where there is no largest one.
pub(super) fn largest_factor(equilibrium: &Equilibrium) -> Found {
    let carried = carried(equilibrium);
    let found = largest_factor_of_carried(equilibrium, &carried);
    Found { iterations: found.iterations + carried.solution.iterations, ..found }
}

/// The same where it is known whether the permanent loads are carried.
pub(super) fn largest_factor_of_carried(equilibrium: &Equilibrium, stands: &Carried) -> Found {
    if stands.carried == Some(false) {
        return Found { status: Status::NoEquilibrium, solution: stands.solution.clone(), iterations: 0 };
    }
    let mut solution = Program::of_the_factor(equilibrium).solve(TOLERANCE);
    let iterations = solution.iterations;
    // Where the permanent loads are carried the largest factor is zero at least.
    if stands.is_carried() {
        solution.factor = if solution.factor > 0.0 { solution.factor } else { 0.0 };
    }
    if solution.solved && stands.is_carried() {
        return Found { status: Status::Solved, solution, iterations };
    }
    if stands.is_carried()
        && let Some(roomy) = stands.roomy(equilibrium)
        && let Some(solution) = proven(equilibrium, roomy, &solution)
    {
        return Found { status: Status::Solved, solution, iterations };
    }
    let locked = locks(equilibrium);
    let status = if locked.solved && locked.factor > 0.5 { Status::Locks } else { Status::NotConverged };
    Found { status, solution, iterations: iterations + locked.iterations }
}

/// The forces of elastic joints under the permanent loads, if no joint exceeds its strength.
fn elastic_state(equilibrium: &Equilibrium) -> Option<Vec<f64>> {
    let mut stiffness = Stiffness::alike(equilibrium)?;
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
    (left < 1e-12 && bounds::yield_violation(equilibrium, &forces) <= 0.0).then_some(forces)
}

/// Whether the variable loads alone can grow without end: forces that no strength limits carry them.
pub(super) fn locks(equilibrium: &Equilibrium) -> Solution {
    // Without any strength in force units the largest share is all or nothing; crushing limits every load.
    let mut endless = equilibrium.with_strengths(|s| {
        let crushing = if s.crushing.is_finite() { 0.0 } else { s.crushing };
        Strength { tension: 0.0, cohesion: 0.0, crushing, ..*s }
    });
    endless.restraints.iter_mut().for_each(|r| r.most = 0.0);
    let cap = Some(if endless.crushes() { 0.0 } else { 1.0 });
    let constant_loads = &vec![0.0; endless.rows];
    Program { constant_loads, cap, ..Program::of_the_factor(&endless) }.solve(1e-8)
}

fn report(model: &BlockModel, equilibrium: &Equilibrium, interfaces: Vec<Interface>, found: &Found) -> Outcome {
    let solution = &found.solution;
    let Found { status, iterations, .. } = *found;
    let mut outcome = Outcome { status, interfaces, iterations, ..Outcome::default() };
    if matches!(found.status, Status::Solved | Status::NoEquilibrium) {
        outcome.mechanism = mechanism(model, equilibrium, &solution.velocities);
    }
    if found.status == Status::Solved {
        state(equilibrium, solution, &mut outcome);
        outcome.associated_factor = outcome.factor;
        let upper = bounds::least_upper(equilibrium, &solution.forces, &solution.velocities);
        outcome.upper_bound = Some(upper.factor * equilibrium.factor_scale);
        outcome.flow_violation = upper.violation;
    }
    outcome
}

/// The forces of a solution, and how far they are from being admissible.
fn state(equilibrium: &Equilibrium, solution: &Solution, outcome: &mut Outcome) {
    outcome.factor = Some(solution.factor * equilibrium.factor_scale);
    let lower = bounds::lower(equilibrium, &solution.forces);
    outcome.lower_bound = Some(lower.factor.max(0.0) * equilibrium.factor_scale);
    // Permanent loads sum to one in their scaled form, and so do the variable ones.
    let loads = 1.0 + solution.factor.abs();
    outcome.equilibrium_residual = lower.violation / loads;
    outcome.yield_violation = bounds::yield_violation(equilibrium, &solution.forces) / loads;
    outcome.forces = joint_forces(equilibrium, &solution.forces);
    outcome.resultants = resultants(equilibrium, &outcome.forces);
}

/// Forces in newtons per metre, the shear shared in proportion to the compression.
pub(super) fn joint_forces(equilibrium: &Equilibrium, forces: &[f64]) -> Vec<JointForces> {
    let of = |joint: &Joint| {
        let mut compressions: Vec<f64> = forces[joint.columns()].iter().map(|f| f * equilibrium.force).collect();
        let shear = compressions.pop().expect("a joint has a shear");
        let total: f64 = compressions.iter().map(|c| c.abs()).sum();
        let share = |c: f64| if total > 0.0 { c.abs() / total } else { 1.0 / compressions.len() as f64 };
        let point =
            |(&at, &compression): (&Vec2, &f64)| PointForces { at, compression, shear: shear * share(compression) };
        JointForces { points: joint.points.iter().zip(&compressions).map(point).collect(), shear }
    };
    equilibrium.joints.iter().map(of).collect()
}

/// The resultants of all joints.
pub(super) fn resultants(equilibrium: &Equilibrium, forces: &[JointForces]) -> Vec<Option<Resultant>> {
    equilibrium.joints.iter().zip(forces).map(|(joint, forces)| resultant(joint, forces)).collect()
}

/// The resultant of a joint in compression.
fn resultant(joint: &Joint, forces: &JointForces) -> Option<Resultant> {
    let total = forces.compression();
    let gross: f64 = forces.points.iter().map(|p| p.compression.abs()).sum();
    // Below round-off of the force unit there is no line of action to speak of.
    if total <= 1e-9 * gross || total <= 0.0 {
        return None;
    }
    let at = forces.points.iter().fold(Vec2::ZERO, |sum, p| sum + p.at * (p.compression / total));
    Some(Resultant { at, force: joint.normal * total + joint.tangent() * forces.shear })
}
