//! Stepping until the blocks rest, or until it is plain that they will not.

use super::account::{energy, unbalanced_ratio};
use super::model::Model;
use super::outcome::Body;
use super::particles::Disc;
use super::settings::Settings;
use super::state::State;
use super::step::{Workspace, step};
use crate::ids::{BlockId, Id, ParticleId};
use crate::plane::Vec2;
use serde::{Deserialize, Serialize};

/// How one stage ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Settled {
    /// Out-of-balance force and motion below tolerance.
    AtRest,
    /// A block moved farther than a structure at rest could.
    Collapsed,
    /// The out-of-balance force oscillates without falling.
    Stalled,
    /// The stage used up its iterations.
    StepLimit,
    /// A number is not finite, a block runs away within one step, or energy comes out of nothing.
    Broken(Body),
    /// Still going.
    Going,
}

/// Displacement within one stage that counts as collapse, as a share of the mean block size. A quarter of a block is
/// far beyond what a stage at rest shows (about a hundredth in the arch tests) and close enough to save iterations.
const COLLAPSE: f64 = 0.25;

/// A block that is guided, as one that brings a load onto particles, may sink so many times farther within a stage: fill
/// that gives way under it may carry again deeper down, and what lies below goes on carrying (Rouxinol, Providência and
/// Lemos, section 3.4). A whole block size in all.
const GUIDED: f64 = 4.0;

/// Iterations between looks at the out-of-balance force.
const LOOK: u64 = 20;

/// A stall is looked for in windows of so many iterations at least.
const LEAST_WINDOW: u64 = 20_000;

/// Windows of blocks alone are so many times as long as one of them takes to fall half its size. How long blocks take to come to
/// rest is a matter of their weight, and steps are the shorter the stiffer the joints: Bridgemill's ring with joints a hundred times
/// as stiff stalled at 205.8 kN/m in windows of 20,000 iterations, and carries 208 in these (its path: 208.9). Runs with particles, which are long
/// and of short steps, keep the least window.
const FALLS: f64 = 12.0;

/// Windows without progress that make a stall.
const STALLED_WINDOWS: u32 = 4;

/// Blocks whose forces balance are at rest if, going on as they move, they would come at most this share of the way
/// to collapse within a window.
const DRIFT: f64 = 0.1;

/// What a stage remembers while it settles.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Stage {
    /// Iterations of a window.
    pub window: u64,
    /// Where the blocks were when the stage began.
    pub start: Vec<Vec2>,
    pub first_step: u64,
    /// Least out-of-balance ratio of this window, and of the last window that made progress.
    pub window_least: f64,
    pub best: f64,
    pub idle_windows: u32,
    /// Largest displacement at the end of the last window.
    pub window_displacement: f64,
    pub ratio: f64,
    /// Displacement beyond which the next picture of a collapse is taken, as a share of the limit.
    pub next_picture: f64,
}

impl Stage {
    pub(super) fn new(model: &Model, state: &State) -> Stage {
        Stage {
            window: window(model, state),
            start: state.poses.iter().map(|p| p.position).collect(),
            first_step: state.steps,
            window_least: f64::INFINITY,
            best: f64::INFINITY,
            ratio: f64::INFINITY,
            next_picture: 0.125,
            ..Stage::default()
        }
    }
}

fn window(model: &Model, state: &State) -> u64 {
    let speed = model.fall_speed();
    if state.particles.discs.is_empty() && speed > 0.0 && state.time_step > 0.0 {
        let falls = FALLS * model.block_size / speed / state.time_step;
        LEAST_WINDOW.max((falls / LOOK as f64).ceil() as u64 * LOOK)
    } else {
        LEAST_WINDOW
    }
}

/// Largest displacement of a free block's centre since the stage began, as a share of the collapse limit.
fn displacement(model: &Model, state: &State, stage: &Stage) -> f64 {
    let mut largest: f64 = 0.0;
    for i in model.free() {
        let d = state.poses[i].position - stage.start[i];
        let guided = model.inverse_mass[i].contains(&0.0);
        let share = if guided && !state.particles.discs.is_empty() { 1.0 / GUIDED } else { 1.0 };
        largest = largest.max(d.dot(d) * share * share);
    }
    largest.sqrt() / (COLLAPSE * model.block_size)
}

/// Runs at most `most` steps of a stage. `picture` is shown the state at an eighth, a quarter and half of the way to
/// collapse and at the collapse itself.
pub(super) fn settle(
    model: &Model,
    state: &mut State,
    stage: &mut Stage,
    work: &mut Workspace,
    (settings, most): (&Settings, u64),
    picture: &mut dyn FnMut(&State),
) -> Settled {
    for _ in 0..most {
        let report = step(model, state, work, settings);
        // A block that crosses a tenth of its size in one step has left every contact law behind.
        let limit = 0.1 * model.least_reach;
        if !(report.moved <= limit && report.particles_moved <= limit) {
            return Settled::Broken(culprit(model, state));
        }
        let count = state.steps - stage.first_step;
        if !count.is_multiple_of(LOOK) {
            continue;
        }
        stage.ratio = unbalanced_ratio(model, state);
        stage.window_least = stage.window_least.min(stage.ratio);
        // Forces can balance in motion: steady sliding, or a swing through its middle.
        if stage.ratio <= settings.tolerance
            && report.moved * stage.window as f64 <= DRIFT * COLLAPSE * model.block_size
        {
            return Settled::AtRest;
        }
        let moved = displacement(model, state, stage);
        if moved >= stage.next_picture {
            picture(state);
            stage.next_picture *= 2.0;
        }
        if moved >= 1.0 {
            return if gains_energy(model, state) {
                Settled::Broken(culprit(model, state))
            } else {
                Settled::Collapsed
            };
        }
        if count.is_multiple_of(stage.window) {
            if gains_energy(model, state) {
                return Settled::Broken(culprit(model, state));
            }
            // Progress is a lower residual, or blocks that are still on their way.
            let lower = stage.window_least < 0.9 * stage.best;
            let on_the_way = (moved - stage.window_displacement).abs() > 1e-3;
            stage.idle_windows = if lower || on_the_way { 0 } else { stage.idle_windows + 1 };
            // Compared with the last progress, not the last window: a residual that falls slowly is no stall.
            if lower {
                stage.best = stage.window_least;
            }
            stage.window_least = f64::INFINITY;
            stage.window_displacement = moved;
            if stage.idle_windows >= STALLED_WINDOWS {
                return Settled::Stalled;
            }
        }
        if count >= settings.step_limit {
            return Settled::StepLimit;
        }
    }
    Settled::Going
}

/// Whether more energy has come out of nothing than half the work done: the sign of a time step too large, which can
/// shake blocks apart without ever making a number infinite. An arch run to collapse accounts for all but a millionth;
/// contact lengths that are updated swallow a few hundredths.
fn gains_energy(model: &Model, state: &State) -> bool {
    let energy = energy(model, state);
    energy.drift() < -0.5 * (energy.gravity.abs() + energy.loads.abs() + energy.supports.abs())
}

/// The body that broke: the first whose numbers are not finite, otherwise the fastest; blocks before particles.
pub(super) fn culprit(model: &Model, state: &State) -> Body {
    let of_block = |i: usize| {
        let v = &state.velocities[i];
        (v[0].abs() + v[1].abs() + v[2].abs() * model.cores.as_slice()[i].reach, state.poses[i].position.is_finite())
    };
    let of_particle = |d: &Disc| (d.vx.hypot(d.vy), d.centre().is_finite());
    let blocks = (0..model.len()).map(|i| (Body::Block(BlockId::new(i)), of_block(i)));
    let ids = model.particles.ids.iter().map(|&id| Body::Particle(ParticleId(id)));
    let bodies: Vec<(Body, (f64, bool))> =
        blocks.chain(ids.zip(state.particles.discs.iter().map(of_particle))).collect();
    let broken = bodies.iter().find(|(_, (speed, placed))| !(speed.is_finite() && *placed));
    let fastest = || bodies.iter().max_by(|a, b| a.1.0.total_cmp(&b.1.0));
    broken.or_else(fastest).map_or(Body::Block(BlockId::new(0)), |(body, _)| *body)
}
