//! Steps through time: Newmark's method and that of Hilber, Hughes and Taylor.

use super::dofs::{HELD, dof};
use super::element::mass;
use super::factor::FactorError;
use super::model::Model;
use super::newton::{Aim, balance};
use super::outcome::{Outcome, Status};
use super::settings::Settings;
use super::state::State;
use super::workspace::Workspace;
use crate::ids::Id;
use crate::watch::{Asking, Progress, Watch};

/// Rayleigh damping: a part of the mass and a part of the stiffness at rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Damping {
    /// Factor on the mass [1/s].
    pub mass: f64,
    /// Factor on the stiffness [s].
    pub stiffness: f64,
}

impl Damping {
    /// The factors that give `ratio` of critical damping at two circular frequencies [rad/s].
    pub fn of(ratio: f64, [one, two]: [f64; 2]) -> Damping {
        Damping { mass: 2.0 * ratio * one * two / (one + two), stiffness: 2.0 * ratio / (one + two) }
    }
}

/// Mass, damping and scheme of a model: made once, used for every step.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Shift of the instant at which stiffness and damping are taken.
    alpha: f64,
    /// Weights of the new acceleration in displacements and in velocities.
    beta: f64,
    gamma: f64,
    step: f64,
    /// Lower triangles in the places of the pattern.
    mass: Vec<f64>,
    damping: Vec<f64>,
}

impl Motion {
    /// Consistent mass (equation 8), Rayleigh damping on the stiffness of the model at rest, steps of `step` [s] by the scheme of Hilber, Hughes
    /// and Taylor, which damps what the step cannot resolve and keeps second order: `alpha` between -1/3 and 0, which is Newmark's with
    /// average acceleration.
    ///
    /// # Errors
    /// An element or a spring that has no answer at rest.
    pub fn new(
        model: &Model,
        work: &mut Workspace,
        alpha: f64,
        damping: Damping,
        step: f64,
    ) -> Result<Motion, FactorError> {
        let rest = State::new(model);
        work.stiffness(model, &rest)?;
        let entries = work.pattern.entries();
        let mass = masses(model, work);
        let mix = mass.iter().zip(&work.values[..entries]);
        let damping = mix.map(|(mass, stiffness)| damping.mass * mass + damping.stiffness * stiffness).collect();
        let alpha = alpha.clamp(-1.0 / 3.0, 0.0);
        Ok(Motion { alpha, beta: 0.25 * (1.0 - alpha) * (1.0 - alpha), gamma: 0.5 - alpha, step, mass, damping })
    }

    /// Kinetic energy [J/m].
    pub fn kinetic_energy(&self, model: &Model, work: &Workspace, state: &State) -> f64 {
        let velocities = model.dofs.of_free(&state.velocities);
        let mut momentum = vec![0.0; velocities.len()];
        work.pattern.multiply(&self.mass, &[], &velocities, &mut momentum);
        0.5 * super::gmres::dot(&velocities, &momentum)
    }

    /// What a step from `state` adds to the equations of balance: acceleration and velocity at its end are linear in the
    /// displacements there (equations 17 and 18).
    fn inertia(&self, model: &Model, work: &Workspace, state: &State, internal: &[f64], forces: &[f64]) -> Inertia {
        let Motion { beta, gamma, alpha, step: h, .. } = *self;
        let [u, v, a] =
            [&state.displacements, &state.velocities, &state.accelerations].map(|all| model.dofs.of_free(all));
        let weight = 1.0 + alpha;
        let by_mass = 1.0 / (beta * h * h);
        let by_damping = weight * gamma / (beta * h);
        let matrix = self.mass.iter().zip(&self.damping).map(|(m, c)| by_mass * m + by_damping * c).collect();
        // Where the body would be without new acceleration, and the velocity that damping then sees.
        let ahead: Vec<f64> = (0..u.len()).map(|i| u[i] + h * v[i] + h * h * (0.5 - beta) * a[i]).collect();
        let coasting = |i: usize| v[i] + h * (1.0 - gamma) * a[i];
        let seen: Vec<f64> = (0..u.len()).map(|i| weight * coasting(i) - alpha * v[i]).collect();
        let mut constant = vec![0.0; u.len()];
        work.pattern.multiply(&self.damping, &[], &seen, &mut constant);
        for (i, component) in model.dofs.free.iter().enumerate() {
            let component = *component as usize;
            // Internal forces and loads of the step's start, weighted with -alpha.
            constant[i] = -constant[i] + alpha * (internal[component] - forces[component]);
        }
        Inertia { weight, matrix, ahead, constant }
    }

    /// Velocity and acceleration at the end of a step.
    fn update(&self, model: &Model, before: &[f64], state: &mut State) {
        let Motion { beta, gamma, step: h, .. } = *self;
        for component in &model.dofs.free {
            let i = *component as usize;
            let (v, a) = (state.velocities[i], state.accelerations[i]);
            let moved = state.displacements[i] - before[i];
            let new = (moved - h * v) / (beta * h * h) - (0.5 - beta) / beta * a;
            state.velocities[i] = v + h * ((1.0 - gamma) * a + gamma * new);
            state.accelerations[i] = new;
        }
    }
}

/// Inertia and damping in the equations of one step.
#[derive(Debug)]
pub(super) struct Inertia {
    /// Weight of internal forces and loads at the end of the step.
    weight: f64,
    matrix: Vec<f64>,
    ahead: Vec<f64>,
    constant: Vec<f64>,
}

impl Inertia {
    /// Adds what inertia and damping resist to the tangent.
    pub(super) fn stiffen(&self, work: &mut Workspace) {
        work.values.iter_mut().chain(&mut work.skew).for_each(|value| *value *= self.weight);
        work.values.iter_mut().zip(&self.matrix).for_each(|(value, more)| *value += more);
    }

    /// What is out of balance at the free components, inertia and damping counted.
    pub(super) fn unbalanced(&self, model: &Model, work: &Workspace, forces: &[f64]) -> Vec<f64> {
        let mut right = work.unbalanced(model, forces);
        let u = model.dofs.of_free(&work.trial.displacements);
        let moved: Vec<f64> = self.ahead.iter().zip(&u).map(|(ahead, u)| ahead - u).collect();
        right.iter_mut().zip(&self.constant).for_each(|(right, constant)| *right = self.weight * *right + constant);
        work.pattern.multiply(&self.matrix, &[], &moved, &mut right);
        right
    }
}

/// The consistent mass in the places of the pattern.
fn masses(model: &Model, work: &Workspace) -> Vec<f64> {
    let mut values = vec![0.0; work.pattern.places()];
    for (id, quad) in model.mesh.quads.pairs() {
        let density = model.section(id).density;
        let mass = mass(&model.corners(id));
        let mut slots = work.pattern.slots(id.index()).iter();
        for i in 0..8 {
            for (j, slot) in (0..=i).zip(&mut slots) {
                let (one, two) = (dof(quad.nodes[i / 2], i % 2), dof(quad.nodes[j / 2], j % 2));
                let both = model.dofs.equation[one] != HELD && model.dofs.equation[two] != HELD;
                if i % 2 == j % 2 && both {
                    values[*slot as usize] += density * mass[i / 2][j / 2];
                }
            }
        }
    }
    values.truncate(work.pattern.entries());
    values
}

/// Sets the accelerations that balance the forces of a state which starts to move (equation 16); `forces` are on all components [N/m].
///
/// # Errors
/// An element or a spring that has no answer to the state, or masses without an inverse.
pub fn at_rest(
    model: &Model,
    state: &mut State,
    work: &mut Workspace,
    motion: &Motion,
    forces: &[f64],
) -> Result<(), FactorError> {
    work.stiffness(model, state)?;
    let mut right = work.unbalanced(model, forces);
    let velocities = model.dofs.of_free(&state.velocities);
    let mut damped = vec![0.0; right.len()];
    work.pattern.multiply(&motion.damping, &[], &velocities, &mut damped);
    right.iter_mut().zip(&damped).for_each(|(right, damped)| *right -= damped);
    let entries = work.pattern.entries();
    work.values[..entries].copy_from_slice(&motion.mass);
    work.skewed = false;
    work.factorise()?;
    let accelerations = work.solve(&right, 1e-12)?;
    for (component, acceleration) in model.dofs.free.iter().zip(&accelerations) {
        state.accelerations[*component as usize] = *acceleration;
    }
    state.forces.copy_from_slice(forces);
    Ok(())
}

/// Takes a state through `steps` of time. `forces` gives the nodal forces [N/m] at the end of each step, `after` sees the state there.
/// Held components stay where they are.
pub fn transient(
    (model, settings): (&Model, &Settings),
    (state, work): (&mut State, &mut Workspace),
    (motion, steps): (&Motion, u64),
    forces: &mut dyn FnMut(u64) -> Vec<f64>,
    after: &mut dyn FnMut(u64, &State, &Workspace),
    watch: &mut dyn Watch,
) -> Outcome {
    let mut asking = Asking::new(watch);
    let mut outcome = Outcome { status: Status::Completed, reached: 0.0, iterations: 0, steps: Vec::new() };
    if work.stiffness(model, state).is_err() {
        outcome.status = Status::NotConverged;
        return outcome;
    }
    let mut internal = work.internal.clone();
    for step in 0..steps {
        let progress =
            Progress { stage: "time".to_owned(), fraction: Some(outcome.reached), steps: outcome.iterations };
        if asking.tell(progress) {
            outcome.status = Status::Cancelled;
            return outcome;
        }
        let aim = Aim { forces: forces(step), displacements: state.displacements.clone() };
        let inertia = motion.inertia(model, work, state, &internal, &state.forces);
        let attempt = balance(model, state, work, (&aim, Some(&inertia)), settings, &mut asking);
        outcome.iterations += u64::from(attempt.took.iterations);
        let reached = (step + 1) as f64 / steps as f64;
        outcome.steps.push(attempt.step(model, work, reached));
        if attempt.end != Status::Completed {
            outcome.status = attempt.end;
            return outcome;
        }
        let before = state.displacements.clone();
        internal.copy_from_slice(&work.internal);
        work.keep(state, &aim.forces);
        motion.update(model, &before, state);
        outcome.reached = reached;
        after(step, state, work);
    }
    outcome
}
