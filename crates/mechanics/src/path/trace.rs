//! The path from self-weight to the largest load and past it.

use super::correct::{Balanced, Constraint, balance, dot, norm};
use super::frame::{frame, point};
use super::jump::fall;
use super::model::{HELD, Model};
use super::outcome::{Cause, Frame, Outcome, PathPoint, Status};
use super::settings::{Program, Settings};
use super::system::{State, Workspace, advance, assemble, commit, respond};
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::ids::{BlockId, Id, Table};
use crate::plane::Vec2;
use crate::watch::{Progress, Watch, Wish};

/// The load at which equilibrium ends, with joints that give: the path of balanced states from the blocks' own weight through
/// the largest load.
///
/// # Errors
/// A model that cannot be analysed.
pub fn collapse(
    blocks: &BlockModel,
    loading: &Loading,
    (settings, program): (&Settings, &Program),
    watch: &mut dyn Watch,
) -> Result<Outcome, ModelError> {
    let model = Model::new(blocks, loading, settings)?;
    let mut path = Path::new(&model, settings, program);
    path.drawn = true;
    let mut state = State::as_built(&model);
    let status = match path.stand(&mut state, watch) {
        Standing::Balanced(balanced) => {
            path.keep(&state, balanced);
            path.follow(program.increment, program.limit, &mut state, watch).status()
        }
        Standing::Falls => Status::UnstableUnderSelfWeight,
        Standing::Stopped => Status::Cancelled,
    };
    Ok(path.outcome(blocks, status))
}

/// Whether the blocks stand under their own weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Standing {
    Balanced(Balanced),
    Falls,
    Stopped,
}

/// How the loads ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Target,
    Limit,
    Bifurcation,
    Lost,
    Stopped,
}

impl End {
    pub fn status(self) -> Status {
        match self {
            End::Target => Status::StableToLastLoad,
            End::Limit => Status::LimitPoint,
            End::Bifurcation => Status::Bifurcation,
            End::Lost => Status::NotConverged,
            End::Stopped => Status::Cancelled,
        }
    }
}

/// Where the path goes at a balanced state, per unit of its length.
struct Heading {
    direction: Vec<f64>,
    factor: f64,
    /// Sign of the determinant of the tangent.
    sign: i8,
}

impl Heading {
    /// Whether another one, close by, has the same direction.
    fn goes_on_as(&self, other: &Heading) -> bool {
        const ALIKE: f64 = 1e-2;
        let turned = 1.0 - dot(&self.direction, &other.direction);
        turned < ALIKE && (other.factor / self.factor - 1.0).abs() < ALIKE
    }
}

/// A state past the largest load, seen from the last one before it: its distance along the path, and how the factor changes there.
struct Past {
    distance: f64,
    rate: f64,
}

impl Past {
    /// The share of the distance to a place a little before the largest load, if the rate changes evenly between the two.
    fn short_of_peak(&self, heading: &Heading) -> f64 {
        const SHORT: f64 = 0.95;
        (SHORT * heading.factor / (heading.factor - self.rate)).clamp(0.05, 0.9)
    }
}

pub(super) struct Path<'m> {
    model: &'m Model,
    settings: &'m Settings,
    program: &'m Program,
    work: Workspace,
    pub points: Vec<PathPoint>,
    /// Whether states are kept to be drawn.
    drawn: bool,
    frames: Vec<Frame>,
    last: Balanced,
    pub iterations: u32,
    mechanism: Vec<f64>,
    /// How often balance was lost and found again.
    snaps: u32,
}

/// Overlap by which joints are as good as glued, and overlap that is as good as none, as shares of the largest one of glued
/// joints.
const GLUED: f64 = 10.0;
const LET_GO: f64 = 1e-3;

/// Iterations that a step of the right length takes.
const WANTED_ITERATIONS: f64 = 5.0;

/// First step past the peak, as a share of the size of the blocks, in the norm of all motions.
const PAST_PEAK: f64 = 1e-3;

impl<'m> Path<'m> {
    pub fn new(model: &'m Model, settings: &'m Settings, program: &'m Program) -> Path<'m> {
        Path {
            model,
            settings,
            program,
            work: Workspace::new(model),
            points: Vec::new(),
            drawn: false,
            frames: Vec::new(),
            last: Balanced { iterations: 0, residual: 0.0 },
            iterations: 0,
            mechanism: Vec::new(),
            snaps: 0,
        }
    }

    /// The first state under self-weight. Joints without tension are alike at every load, so no small load would make it
    /// easier to find: instead they are pressed together until they are as good as glued, and are let go by degrees.
    pub fn stand(&mut self, state: &mut State, watch: &mut dyn Watch) -> Standing {
        let mut glued = state.clone();
        // As built, sides neither overlap nor gape but for rounding: any overlap makes them closed.
        state.pressed = self.model.size;
        assemble(self.model, self.settings, state, &mut self.work);
        if !self.work.tangent.factorise() {
            return Standing::Falls;
        }
        let mut change = self.work.unbalanced.clone();
        self.work.tangent.solve(&mut change);
        advance(self.model, &mut glued, &change, 0.0);
        let overlap = |k| respond(self.model, self.settings, &glued.memory[k], k, &glued).overlap;
        let widest = (0..self.model.joints.len()).flat_map(overlap).fold(0.0, |most: f64, o| most.max(o.abs()));
        let (mut pressed, mut share) = (GLUED * widest, 0.5);
        *state = glued;
        while pressed > 0.0 {
            if watch.look(&Progress { stage: "self-weight".to_owned(), fraction: None, steps: 0 }) == Wish::Stop {
                return Standing::Stopped;
            }
            let next = if pressed < widest * LET_GO { 0.0 } else { pressed * share };
            let mut guess = State { pressed: next, ..state.clone() };
            match balance(self.model, self.settings, Constraint::Load, &mut guess, &mut self.work) {
                Some(balanced) => {
                    self.iterations += balanced.iterations;
                    (*state, pressed) = (guess, next);
                    share = (share * share).max(0.1);
                    if next == 0.0 {
                        commit(self.model, self.settings, state);
                        return Standing::Balanced(balanced);
                    }
                }
                None if share > 0.98 => return Standing::Falls,
                None => share = share.sqrt(),
            }
        }
        Standing::Falls
    }

    /// Follows the path until the factor is at its target or can grow no more. Where balance is lost and found again close by,
    /// as when a hinge moves to the next joint, the path goes on from there.
    pub fn follow(&mut self, increment: f64, target: f64, state: &mut State, watch: &mut dyn Watch) -> End {
        let mut length = None;
        loop {
            let end = self.rise((increment, target), &mut length, state, watch);
            if !matches!(end, End::Limit | End::Lost) {
                return end;
            }
            // Where no next state was found, the one of a load a little further on may be.
            let pushes: &[f64] = if end == End::Lost { &[1.0, 10.0, 100.0] } else { &[1.0] };
            let fallen = pushes.iter().find_map(|times| {
                let mut pushed = state.clone();
                let push = times * self.settings.resolution * state.factor.abs().max(increment);
                advance(self.model, &mut pushed, &[], push);
                fall(self.model, self.settings, &pushed, &mut self.work)
            });
            let Some((next, steps)) = fallen else {
                self.descend(state, watch);
                return end;
            };
            self.iterations += steps;
            self.snaps += 1;
            self.accept(next, Balanced { iterations: steps, residual: self.last.residual }, state);
            if self.points.len() as u32 > self.settings.most_steps {
                return End::Lost;
            }
        }
    }

    /// Follows the path up to where the load grows no more, a stiffness turns negative or no next state is found; that is found
    /// to the resolution, and the state is left just before it.
    pub fn rise(
        &mut self,
        (increment, target): (f64, f64),
        length: &mut Option<f64>,
        state: &mut State,
        watch: &mut dyn Watch,
    ) -> End {
        let Some(mut heading) = self.heading(state, None) else { return End::Lost };
        let first = increment.min(target) / heading.factor;
        let mut share = length.unwrap_or(first).min(first);
        let mut past: Option<Past> = None;
        for step in 0..self.settings.most_steps {
            let progress = Progress {
                stage: format!("load factor {:.4}", state.factor),
                fraction: target.is_finite().then(|| (state.factor / target).clamp(0.0, 1.0)),
                steps: u64::from(step),
            };
            if watch.look(&progress) == Wish::Stop {
                return End::Stopped;
            }
            let reaches = state.factor + heading.factor * share >= target;
            if reaches {
                share = (target - state.factor) / heading.factor;
            }
            let unseen = self.settings.resolution * state.factor.abs().max(self.settings.resolution * increment);
            // The load grows ever slower towards its largest value.
            if past.as_ref().is_some_and(|past| heading.factor * past.distance <= unseen) {
                self.mechanism.clone_from(&heading.direction);
                return End::Limit;
            }
            let close = heading.factor * share <= unseen;
            let constraint = if reaches { Constraint::Load } else { Constraint::Plane(&heading.direction) };
            let Some((next, balanced)) = self.step(constraint, state, (&heading, share)) else {
                if close {
                    return End::Lost;
                }
                share *= 0.5;
                continue;
            };
            let on = self.heading(&next, Some(&heading));
            let falls = next.factor <= state.factor || on.as_ref().is_some_and(|on| on.factor <= 0.0);
            let turns = on.as_ref().is_none_or(|on| on.sign <= 0);
            // Where a joint opens or closes the path has a corner; where it forks it has none.
            let smooth = on.as_ref().is_some_and(|on| heading.goes_on_as(on));
            let on = match on {
                Some(on) if !falls && !turns => on,
                on => {
                    if close {
                        self.mechanism.clone_from(&heading.direction);
                        return match (falls, smooth) {
                            (true, _) => End::Limit,
                            (false, true) => End::Bifurcation,
                            (false, false) => End::Lost,
                        };
                    }
                    past = on.filter(|on| on.factor < 0.0).map(|on| Past { distance: share, rate: on.factor });
                    share *= past.as_ref().map_or(0.5, |past| past.short_of_peak(&heading));
                    continue;
                }
            };
            self.accept(next, balanced, state);
            if reaches {
                return End::Target;
            }
            *length = Some(share);
            heading = on;
            let grown = share * (WANTED_ITERATIONS / f64::from(balanced.iterations.max(1))).clamp(0.5, 2.0);
            past = past.map(|past| Past { distance: past.distance - share, ..past }).filter(|past| past.distance > 0.0);
            share = past.as_ref().map_or(grown, |past| grown.min(past.distance * past.short_of_peak(&heading)));
        }
        End::Lost
    }

    /// A balanced state a step along the heading.
    fn step(
        &mut self,
        constraint: Constraint,
        from: &State,
        (heading, length): (&Heading, f64),
    ) -> Option<(State, Balanced)> {
        let mut next = from.clone();
        let change: Vec<f64> = heading.direction.iter().map(|d| d * length).collect();
        advance(self.model, &mut next, &change, heading.factor * length);
        let balanced = balance(self.model, self.settings, constraint, &mut next, &mut self.work)?;
        self.iterations += balanced.iterations;
        commit(self.model, self.settings, &mut next);
        Some((next, balanced))
    }

    /// Follows the path past its peak, as far as that goes, until it has lost a share of its load.
    fn descend(&mut self, state: &mut State, watch: &mut dyn Watch) {
        let peak = state.factor;
        let Some(mut heading) = self.heading(state, None) else { return };
        let mut length = PAST_PEAK * self.model.size;
        let least = length * 1e-6;
        for _ in 0..self.settings.most_steps {
            if watch.look(&Progress { stage: "past the peak".to_owned(), fraction: None, steps: 0 }) == Wish::Stop {
                return;
            }
            let Some((next, balanced)) = self.step(Constraint::Plane(&heading.direction), state, (&heading, length))
            else {
                length *= 0.5;
                if length < least {
                    return;
                }
                continue;
            };
            let Some(on) = self.heading(&next, Some(&heading)) else { return };
            self.accept(next, balanced, state);
            let moved = self.points.last().map_or(0.0, |p| p.displacement.norm());
            if state.factor < peak * (1.0 - self.settings.past) || moved > self.settings.farthest {
                return;
            }
            heading = on;
            length *= (WANTED_ITERATIONS / f64::from(balanced.iterations.max(1))).clamp(0.5, 1.5);
        }
    }

    /// Where the path goes at a balanced state, on from where it came; none where the tangent is singular.
    fn heading(&mut self, state: &State, before: Option<&Heading>) -> Option<Heading> {
        assemble(self.model, self.settings, state, &mut self.work);
        if !self.work.tangent.factorise() {
            return None;
        }
        let mut direction = self.work.growing.clone();
        self.work.tangent.solve(&mut direction);
        let length = norm(&direction);
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let on = before.is_none_or(|before| dot(&before.direction, &direction) >= 0.0);
        let factor = if on { 1.0 } else { -1.0 } / length;
        direction.iter_mut().for_each(|d| *d *= factor);
        Some(Heading { direction, factor, sign: self.work.tangent.sign })
    }

    fn accept(&mut self, next: State, balanced: Balanced, state: &mut State) {
        *state = next;
        self.last = balanced;
        self.keep(state, balanced);
    }

    pub fn keep(&mut self, state: &State, balanced: Balanced) {
        let numbers = (balanced.iterations, balanced.residual);
        self.points.push(point(self.model, (self.settings, self.program), state, numbers));
        if self.drawn {
            self.frames.push(frame(self.model, self.settings, state, self.points.len() - 1));
        }
    }

    fn outcome(self, blocks: &BlockModel, status: Status) -> Outcome {
        let stands = !matches!(status, Status::UnstableUnderSelfWeight);
        let most = self.points.iter().map(|p| p.factor).fold(f64::NEG_INFINITY, f64::max);
        let collapse_factor = matches!(status, Status::LimitPoint | Status::Bifurcation).then_some(most);
        let peak = (0..self.frames.len()).rev().find(|&k| self.frames[k].factor == most);
        let cause = collapse_factor.and(peak).map(|k| cause(&self.points[self.frames[k].step]));
        Outcome {
            status,
            cause,
            collapse_factor,
            last_stable_factor: (stands && most.is_finite()).then_some(most),
            peak,
            mechanism: self.motions(blocks),
            path: self.points,
            frames: self.frames,
            interfaces: self.model.interfaces.clone(),
            iterations: self.iterations,
            snaps: self.snaps,
        }
    }

    /// The mechanism with its fastest point moved by 1 m.
    fn motions(&self, blocks: &BlockModel) -> Table<BlockId, (Vec2, f64)> {
        if self.mechanism.is_empty() {
            return Table::default();
        }
        let of = |block: usize| {
            let part = |c: usize| match self.model.equation[block][c] {
                HELD => 0.0,
                equation => self.mechanism[equation as usize],
            };
            (Vec2 { x: part(0), y: part(1) }, part(2) / self.model.size)
        };
        let fastest = |block: usize| {
            let (velocity, spin) = of(block);
            let corners = blocks.blocks[BlockId::new(block)].outline.vertices();
            let speed = |corner: &Vec2| (velocity + (*corner - self.model.built[block]).left() * spin).norm();
            corners.iter().map(speed).fold(0.0, f64::max)
        };
        let count = self.model.built.len();
        let scale = (0..count).map(fastest).fold(f64::MIN_POSITIVE, f64::max);
        (0..count).map(of).map(|(velocity, spin)| (velocity * (1.0 / scale), spin / scale)).collect()
    }
}

/// What gives way in a state at the largest load.
pub(super) fn cause(point: &PathPoint) -> Cause {
    if point.hinges >= 3 {
        Cause::Hinging
    } else if point.sliding > 0 {
        Cause::Sliding
    } else if point.crushed > 0.0 {
        Cause::Crushing
    } else {
        Cause::Hinging
    }
}
