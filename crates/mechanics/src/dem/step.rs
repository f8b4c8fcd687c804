//! One step: search, resist, integrate.

use super::account::energy;
use super::model::Model;
use super::particles::Cells;
use super::search::{find_pairs, search};
use super::settings::{Damping, Settings};
use super::state::State;
use super::stiffness;
use super::touch::{Reaction, Touch, Velocities};
use crate::acting::Resultant;
use crate::contact::{Bond, ContactLength};
use crate::plane::Pose;

/// Scratch, disposable.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    /// What acts on each block at `factor`.
    acting: Vec<Resultant>,
    factor: Option<f64>,
    /// Grid of the search for neighbours of particles.
    pub(super) cells: Cells,
}

impl Workspace {
    fn act(&mut self, model: &Model, factor: f64) {
        if self.factor != Some(factor) {
            self.acting = (0..model.len()).map(|i| model.acting(i, factor)).collect();
            self.factor = Some(factor);
        }
    }
}

/// What one step tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepReport {
    /// A bound on how far any point moved in this step [m]; not finite if a number broke.
    pub moved: f64,
    /// The same for the particles' centres.
    pub particles_moved: f64,
    /// Whether the neighbours of particles were searched anew.
    pub searched: bool,
}

/// The state in which the blocks are built: at rest, touching where they touch.
pub fn begin(model: &Model, settings: &Settings) -> State {
    let n = model.len();
    let mut state = State {
        poses: model.poses(),
        velocities: vec![[0.0; 3]; n],
        contact_forces: vec![[0.0; 3]; n],
        previous_forces: vec![[0.0; 3]; n],
        particles: model.particles.begin(),
        ..State::default()
    };
    find_pairs(model, &mut state, settings.contact_length);
    state.particles.search(&model.particles, model.blocks(&state.poses), &mut Cells::default(), 0);
    // Mortar lies between faces. Two corners that touch have none: a bond across them would hold both beds that meet there.
    for touch in state.touches.iter_mut().filter(|touch| touch.count == 2) {
        for memory in &mut touch.memory {
            memory.bonded = true;
        }
        touch.bond = Bond::default();
    }
    state.time_step = settings.time_step_factor * critical_time_step(model, &state, settings);
    if !state.particles.discs.is_empty() {
        // Particles may press on one another where they are built.
        state.initial_energy -= energy(model, &state).drift();
    }
    if let Damping::Viscous(share) = settings.damping {
        state.viscosity = 2.0 * share * stiffness::smallest_frequency(model, &state);
    }
    state
}

/// `2 / omega` [s], Bathe 1982, with the largest frequency of the contact stiffness system; with particles, whose pairs
/// change all the time, with a bound on it that costs one pass over the contacts.
pub fn critical_time_step(model: &Model, state: &State, settings: &Settings) -> f64 {
    if state.particles.discs.is_empty() {
        return exact_critical_time_step(model, state);
    }
    of_frequency(stiffness::squares(model, state, settings.scaled_inertia).into_iter().fold(0.0, f64::max).sqrt())
}

/// `2 / omega` [s] with the largest frequency by power iteration, also where there are particles.
pub fn exact_critical_time_step(model: &Model, state: &State) -> f64 {
    of_frequency(stiffness::largest_frequency(model, state))
}

/// Without any contact nothing limits the step; a hundredth of a second resolves a fall.
fn of_frequency(omega: f64) -> f64 {
    if omega > 0.0 { 2.0 / omega } else { 0.01 }
}

/// One step of the discrete element method.
#[inline]
pub fn step(model: &Model, state: &mut State, work: &mut Workspace, settings: &Settings) -> StepReport {
    // Velocities of the half step behind acted for as long as the step did that they were made for.
    let behind = state.time_step;
    if search(model, state, settings.contact_length) {
        state.time_step = state.time_step.min(settings.time_step_factor * critical_time_step(model, state, settings));
    }
    let searched = state.particles.search(&model.particles, model.blocks(&state.poses), &mut work.cells, state.steps);
    if searched {
        if settings.scaled_inertia {
            scale_inertia(model, state);
        }
        state.time_step = settings.time_step_factor * critical_time_step(model, state, settings);
    }
    match settings.contact_length {
        ContactLength::Fixed => resist(state, behind, Touch::resist::<false>),
        ContactLength::Updated => resist(state, behind, Touch::resist::<true>),
        ContactLength::Distributed => resist(state, behind, Touch::resist_distributed),
    }
    let blocks = model.blocks(&state.poses);
    let (velocities, on_blocks) = (&state.velocities, &mut state.contact_forces);
    state.dissipated += state.particles.resist(&model.particles, blocks, velocities, behind, on_blocks);
    work.act(model, state.factor);
    // From half a step behind to half a step ahead.
    let between = 0.5 * (behind + state.time_step);
    match settings.damping {
        Damping::Adaptive => adapt(model, state, behind),
        Damping::None => state.viscosity = 0.0,
        Damping::Local(_) | Damping::Viscous(_) => {}
    }
    let moved = match settings.damping {
        Damping::Local(share) => integrate::<true>(model, state, work, share, between),
        _ => integrate::<false>(model, state, work, 0.0, between),
    };
    let steps = (between, state.time_step);
    let (particles_moved, damped) = state.particles.integrate(settings.damping, state.viscosity, steps);
    state.damped += damped;
    // How far they went bounds the next search.
    state.particles.travel += particles_moved.max(moved);
    StepReport { moved, particles_moved, searched }
}

/// Gives the particles the inertia that suits their springs; what their motion gains by it is booked with the damping.
fn scale_inertia(model: &Model, state: &mut State) {
    let before = state.particles.true_inertia(&model.particles);
    let squares = stiffness::squares(model, state, true);
    let gained = state.particles.scale_inertia(&before, &squares[model.len()..]);
    state.damped -= gained;
}

/// Contact forces from where the blocks are and how they got there, gathered per block in the fixed order of the
/// touches.
#[inline(always)]
fn resist(state: &mut State, dt: f64, one: impl Fn(&mut Touch, (&Pose, &Pose), Velocities, f64) -> Option<Reaction>) {
    let (poses, velocities) = (&state.poses[..], &state.velocities[..]);
    let forces = &mut state.contact_forces[..];
    forces.fill([0.0; 3]);
    let mut dissipated = 0.0;
    for touch in &mut state.touches {
        let (first, second) = (touch.one as usize, touch.two as usize);
        let bodies = (&poses[first], &poses[second]);
        if let Some(r) = one(touch, bodies, (&velocities[first], &velocities[second]), dt) {
            let on = &mut forces[first];
            *on = [on[0] - r.force.x, on[1] - r.force.y, on[2] + r.on_one];
            let on = &mut forces[second];
            *on = [on[0] + r.force.x, on[1] + r.force.y, on[2] + r.on_two];
            dissipated += r.dissipated;
        }
    }
    state.dissipated += dissipated;
}

/// Newton's law, damped; positions follow the new velocities (central differences). `dt` [s] is the time between the old
/// and the new velocities; it differs from the time step where that has just changed. Returns a bound on how far any point moved [m],
/// not finite if a number broke.
fn integrate<const LOCAL: bool>(model: &Model, state: &mut State, work: &Workspace, local: f64, dt: f64) -> f64 {
    let (ahead, viscosity) = (state.time_step, state.viscosity);
    let half = 0.5 * viscosity * dt;
    // Central differences with damping at mid-step: v' (1 + h) = v (1 - h) + a dt, h = viscosity dt / 2.
    let (share, slow) = (1.0 / (1.0 + half), 2.0 * half / (1.0 + half));
    let (mut fastest, mut check, mut damped) = (0.0_f64, 0.0, 0.0);
    let bodies = state.poses.iter_mut().zip(&mut state.velocities).zip(&state.contact_forces);
    for (((pose, v), contact), (acting, body)) in bodies.zip(work.acting.iter().zip(&model.bodies)) {
        let force = [
            contact[0] + acting.force.x,
            contact[1] + acting.force.y,
            contact[2] + pose.rotation.cos * acting.cross - pose.rotation.sin * acting.dot,
        ];
        for c in 0..3 {
            let old = v[c];
            // A prevented motion keeps the velocity that is imposed on it: no inverse mass, no damping.
            if LOCAL {
                // The damping force opposes the mean of the old and the new velocity, so that it never gives energy:
                // opposing the old one alone would stiffen contacts up to (1 + share) times and make every step above
                // 1 / sqrt(1 + share) of the critical one unstable. It is never larger than what takes out the most.
                let push = force[c] * (body.inverse_mass[c] * dt);
                let most = local * push.abs();
                let against = (old + 0.5 * push).max(-most).min(most);
                v[c] = old + push - against;
                damped += against * body.mass[c] * (0.5 * (old + v[c]));
            } else {
                let fade = slow * body.free[c];
                v[c] = old + (force[c] * (body.inverse_mass[c] * dt) * share - fade * old);
                let mean = 0.5 * (old + v[c]);
                damped += viscosity * dt * body.free[c] * body.mass[c] * mean * mean;
            }
        }
        pose.position.x += v[0] * ahead;
        pose.position.y += v[1] * ahead;
        pose.rotation = pose.rotation.advanced(v[2] * ahead);
        let speed = v[0].abs() + v[1].abs() + v[2].abs() * body.reach;
        fastest = fastest.max(speed);
        check += speed;
    }
    state.damped += damped;
    let moved = fastest * ahead;
    state.travel += moved;
    state.feature_travel += moved;
    state.steps += 1;
    if f64::is_finite(check) { moved } else { f64::NAN }
}

/// Sets the viscosity to critical at the frequency of the present motion, its Rayleigh quotient (Underwood 1983,
/// Papadrakakis 1981). Bridgemill case 1 and 2 take 53,660 and 77,480 iterations so (tolerance 1e-5); at 0.8 of
/// critical 46,720 and 69,540, at 0.5 of it 59,720 and 90,160. Critical leaves the margin against swinging.
fn adapt(model: &Model, state: &mut State, behind: f64) {
    let (mut stiff, mut kinetic) = (0.0, 0.0);
    let rows =
        state.velocities.iter().zip(&model.bodies).zip(state.contact_forces.iter().zip(&mut state.previous_forces));
    for ((v, body), (force, previous)) in rows {
        for c in 0..3 {
            let free = v[c] * body.free[c];
            stiff -= free * (force[c] - previous[c]);
            kinetic += free * v[c] * body.mass[c];
        }
        *previous = *force;
    }
    let (of_particles, moving) = state.particles.rayleigh();
    stiff += of_particles;
    kinetic += moving;
    let square = stiff / (kinetic * behind);
    if kinetic > 0.0 && square.is_finite() {
        state.viscosity = 2.0 * square.max(0.0).sqrt();
    }
}
