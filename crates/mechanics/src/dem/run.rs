//! The stages of a quasi-static run: self-weight, then loads in increments, then refinement below the increment.

use super::account::{contacts, energy, frame, set_factor};
use super::model::Model;
use super::outcome::{Frame, Outcome, PathPoint, Status};
use super::relax::{Settled, Stage, culprit, settle};
use super::settings::{Program, Settings};
use super::state::State;
use super::step::{Workspace, begin, critical_time_step, exact_critical_time_step, step};
use super::stiffness;
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::ids::BlockId;
use crate::kept;
use crate::plane::Vec2;
use crate::watch::{Progress, Watch, Wish};
use serde::{Deserialize, Serialize};

/// Iterations between looks at the onlooker.
const CHUNK: u64 = 5_000;

/// Iterations in which a moved support reaches its speed, and in which it stops again: many of the shortest period, so
/// that it sets nothing ringing. Numerical damping would brake what moves along as long as it rings.
const RAMP: u64 = 2_000;

/// Fastest that a support may move, as a share of the speed of a fall from half the mean block size. An abutment that
/// runs away from its arch faster than the arch comes down lets go of it and is hit afterwards.
const SUPPORT_SPEED: f64 = 0.01;

/// A run and all it has found so far; what a checkpoint holds.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Run {
    pub state: State,
    pub stage: Stage,
    /// The state at the last factor that came to rest.
    pub stable: Option<State>,
    /// Factors between which the collapse lies.
    pub low: Option<f64>,
    pub high: Option<f64>,
    /// Increments applied.
    pub increments: u64,
    pub path: Vec<PathPoint>,
    pub frames: Vec<Frame>,
    pub last_stable_frame: Option<u64>,
    pub max_stress: f64,
    /// Iterations spent on states that were given up when the run went back to a stable one.
    pub given_up: u64,
    pub stalled: bool,
    pub critical_time_step: f64,
    pub single_mass_time_step: f64,
}

/// Brings the blocks to rest under their own weight and the permanent forces, then raises the load factor in steps
/// until they collapse or the limit is reached. `resume` takes up a state that [`Watch::keep`] was offered, for the
/// same model, loading, program and settings; the numbers are those of an undisturbed run.
///
/// # Errors
/// Those of [`Model::new`], a watched block that is not there, or a `resume` of something else.
pub fn collapse(
    model: &BlockModel,
    loading: &Loading,
    program: &Program,
    settings: &Settings,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Outcome, ModelError> {
    let model = Model::new(model, loading)?;
    collapse_from(&model, &|| begin(&model, settings), program, settings, resume, watch)
}

/// The same for a model that is set up, from a state of it: where another run has left it. `resume` needs no state.
///
/// # Errors
/// A watched block that is not there, or a `resume` of something else.
pub fn collapse_from(
    model: &Model,
    state: &dyn Fn() -> State,
    program: &Program,
    settings: &Settings,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Outcome, ModelError> {
    let (run, status) = drive(model, state, program, settings, resume, watch)?;
    Ok(finish(model, run, status))
}

/// Blocks and particles after they were let go.
#[derive(Debug, Clone)]
pub struct Rested {
    /// How it ended: [`Status::StableToLastLoad`] when they rest.
    pub status: Status,
    /// Where they are.
    pub state: State,
    /// Out-of-balance force at the end, relative to the acting forces.
    pub unbalanced_ratio: f64,
}

/// Brings a model to rest under its own weight and the permanent forces.
///
/// # Errors
/// A `resume` of something else.
pub fn rest(
    model: &Model,
    state: &dyn Fn() -> State,
    settings: &Settings,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Rested, ModelError> {
    let program = Program { increment: 1.0, limit: 0.0, resolution: None, watched: (BlockId(0), Vec2::ZERO) };
    let (run, status) = drive(model, state, &program, settings, resume, watch)?;
    let unbalanced_ratio = run.path.last().map_or(run.stage.ratio, |point| point.unbalanced_ratio);
    Ok(Rested { status, unbalanced_ratio, state: run.state })
}

/// Stage after stage until the run ends.
fn drive(
    model: &Model,
    state: &dyn Fn() -> State,
    program: &Program,
    settings: &Settings,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<(Run, Status), ModelError> {
    model.check_block(program.watched.0)?;
    let belongs = kept::fingerprint(&(model, program, settings));
    let mut run = match resume {
        Some(bytes) => Run::from_bytes(model, belongs, bytes)?,
        None => start(model, state(), settings),
    };
    let mut work = Workspace::default();
    loop {
        let settled = advance(model, &mut run, &mut work, settings, CHUNK);
        if let Settled::Going = settled {
            watch.keep(&|| kept::write(belongs, &run));
            if watch.look(&progress(&run, program)) == Wish::Stop {
                watch.keep(&|| kept::write(belongs, &run));
                return Ok((run, Status::Cancelled));
            }
            continue;
        }
        if let Some(status) = decide(model, &mut run, settled, program) {
            return Ok((run, status));
        }
    }
}

pub(super) fn start(model: &Model, state: State, settings: &Settings) -> Run {
    let exact = model.particles.len() <= EXACT_UP_TO;
    Run {
        stage: Stage::new(model, &state),
        critical_time_step: if exact {
            exact_critical_time_step(model, &state)
        } else {
            critical_time_step(model, &state, settings)
        },
        single_mass_time_step: stiffness::single_mass_time_step(model, &state),
        state,
        ..Run::default()
    }
}

/// Most particles for which the critical time step is reported from the eigenvalue; the bound is reported above.
const EXACT_UP_TO: usize = 20_000;

/// Runs the present stage for so many steps at the most. The numbers do not depend on how many.
pub(super) fn advance(model: &Model, run: &mut Run, work: &mut Workspace, settings: &Settings, most: u64) -> Settled {
    if model.moves_supports() && run.state.support_factor != run.state.factor {
        return walk_supports(model, &mut run.state, work, settings, most);
    }
    let Run { state, stage, frames, .. } = run;
    settle(model, state, stage, work, (settings, most), &mut |s| frames.push(frame(model, s)))
}

/// Walks moved supports some of the way to where the load factor wants them: evenly faster up to their speed, and
/// evenly slower towards the end.
fn walk_supports(model: &Model, state: &mut State, work: &mut Workspace, settings: &Settings, most: u64) -> Settled {
    // Without gravity there is no speed of a fall: a thousandth of a block while the speed is reached.
    let without_weight = 1e-3 * model.block_size / (RAMP as f64 * state.time_step);
    let fall = model.fall_speed();
    let fastest = if fall > 0.0 { SUPPORT_SPEED * fall } else { without_weight } / model.farthest_movement();
    let faster = fastest / (RAMP as f64 * state.time_step);
    for _ in 0..most {
        let left = state.factor - state.support_factor;
        let before = support_rate(model, state);
        let towards = before * left.signum() + faster * state.time_step;
        let rate = towards.min(fastest).min((2.0 * faster * left.abs()).sqrt()) * left.signum();
        let arrives = !(rate.abs() * state.time_step < left.abs());
        set_supports_moving(model, state, if arrives { left / state.time_step } else { rate });
        let report = step(model, state, work, settings);
        let rate = support_rate(model, state);
        // The time step may have shrunk in this step.
        state.support_factor += rate * state.time_step;
        state.support_work += support_power(model, state) * state.time_step;
        if !(report.moved <= 0.1 * model.least_reach) {
            return Settled::Broken(culprit(model, state));
        }
        if arrives {
            state.support_factor = state.factor;
            set_supports_moving(model, state, 0.0);
            break;
        }
    }
    Settled::Going
}

/// Rate of the load factor at which the supports move now [1/s].
fn support_rate(model: &Model, state: &State) -> f64 {
    let motions = state.velocities.iter().flatten().zip(model.movement.iter().flatten());
    motions.filter(|(_, m)| **m != 0.0).map(|(v, m)| v / m).next().unwrap_or(0.0)
}

/// Gives the supports the velocity of a load factor that changes at `rate` [1/s].
fn set_supports_moving(model: &Model, state: &mut State, rate: f64) {
    for ((v, m), inverse) in state.velocities.iter_mut().zip(&model.movement).zip(&model.inverse_mass) {
        for c in 0..3 {
            if inverse[c] == 0.0 {
                v[c] = m[c] * rate;
            }
        }
    }
}

/// Power of what holds the moved supports [W/m]: it balances the contacts and, on a block that is free in another
/// direction and whose weight and loads are therefore in the account, those too.
fn support_power(model: &Model, state: &State) -> f64 {
    let mut power = 0.0;
    for i in 0..model.len() {
        if model.movement[i] == [0.0; 3] {
            continue;
        }
        let mut force = state.contact_forces[i];
        if model.inverse_mass[i] != [0.0; 3] {
            let (acting, turn) = (model.acting(i, state.factor), &state.poses[i].rotation);
            force[0] += acting.force.x;
            force[1] += acting.force.y;
            force[2] += turn.cos * acting.cross - turn.sin * acting.dot;
        }
        for c in 0..3 {
            if model.inverse_mass[i][c] == 0.0 {
                power -= force[c] * state.velocities[i][c];
            }
        }
    }
    power
}

/// Books the end of a stage.
fn record(model: &Model, run: &mut Run, settled: Settled, program: &Program) {
    let (block, point) = program.watched;
    let now = model.point_on(block, point, &run.state.poses);
    run.path.push(PathPoint {
        factor: run.state.factor,
        displacement: now - point,
        iterations: run.state.steps - run.stage.first_step,
        unbalanced_ratio: run.stage.ratio,
        at_rest: settled == Settled::AtRest,
    });
    if settled == Settled::AtRest {
        let stress = contacts(&run.state).iter().map(|c| c.compression / c.length).fold(0.0, f64::max);
        run.max_stress = run.max_stress.max(stress);
        // Pictures of a motion that came to rest after all are not those of a collapse; those of the collapse at a
        // higher factor stay, behind this frame.
        let factor = run.state.factor;
        let at = run.last_stable_frame.map_or(0, |i| i as usize + 1);
        let stable = frame(model, &run.state);
        let collapse: Vec<Frame> = run.frames.drain(at..).filter(|f| f.factor > factor).collect();
        run.last_stable_frame = Some(at as u64);
        run.frames.push(stable);
        run.frames.extend(collapse);
    } else {
        // The collapse at the lowest factor is the one to be drawn.
        let factor = run.state.factor;
        run.frames.retain(|f| f.factor <= factor);
    }
}

/// What comes after a stage that has ended: the next factor, or the end.
pub(super) fn decide(model: &Model, run: &mut Run, settled: Settled, program: &Program) -> Option<Status> {
    if settled != Settled::Going {
        record(model, run, settled, program);
    }
    match settled {
        Settled::AtRest => {
            run.low = Some(run.state.factor);
            run.stable = Some(run.state.clone());
        }
        Settled::Collapsed | Settled::Stalled => {
            if run.low.is_none() {
                let stalled = settled == Settled::Stalled;
                return Some(if stalled { Status::Stalled } else { Status::UnstableUnderSelfWeight });
            }
            run.high = Some(run.state.factor);
            run.stalled = settled == Settled::Stalled;
        }
        Settled::StepLimit => return Some(Status::StepLimit),
        Settled::Broken(body) => return Some(Status::Broken { body, step: run.state.steps }),
        Settled::Going => return None,
    }
    let low = run.low.unwrap_or(0.0);
    let next = match run.high {
        None if !((run.increments as f64 * program.increment) < program.limit * (1.0 - 1e-12)) => {
            return Some(Status::StableToLastLoad);
        }
        None => {
            run.increments += 1;
            let next = (run.increments as f64 * program.increment).min(program.limit);
            // An increment of nothing gets nowhere.
            if !(next > low) {
                return Some(Status::StableToLastLoad);
            }
            next
        }
        Some(high) => match program.resolution {
            // Halving ends at the resolution, or where two numbers have none between them.
            Some(resolution)
                if high - low > resolution * (1.0 + 1e-9) && low < 0.5 * (low + high) && 0.5 * (low + high) < high =>
            {
                if settled != Settled::AtRest {
                    let stable = run.stable.clone().expect("a stage came to rest before");
                    run.given_up += run.state.steps - stable.steps;
                    run.state = stable;
                }
                0.5 * (low + high)
            }
            _ => return Some(if run.stalled { Status::Stalled } else { Status::Collapsed }),
        },
    };
    set_factor(model, &mut run.state, next);
    run.stage = Stage::new(model, &run.state);
    None
}

fn progress(run: &Run, program: &Program) -> Progress {
    let share = run.state.factor / program.limit;
    Progress {
        stage: if run.low.is_none() { "self-weight".into() } else { format!("load factor {:.4}", run.state.factor) },
        fraction: share.is_finite().then_some(share.clamp(0.0, 1.0)),
        steps: run.state.steps + run.given_up,
    }
}

pub(super) fn finish(model: &Model, run: Run, status: Status) -> Outcome {
    Outcome {
        status,
        last_stable_factor: run.low,
        collapse_factor: run.high,
        iterations_total: run.state.steps + run.given_up,
        time_step: run.state.time_step,
        critical_time_step: run.critical_time_step,
        single_mass_time_step: run.single_mass_time_step,
        energy: energy(model, &run.state),
        path: run.path,
        frames: run.frames,
        last_stable_frame: run.last_stable_frame.map(|i| i as usize),
        max_compressive_stress: run.max_stress,
    }
}
