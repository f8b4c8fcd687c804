//! The path from self-weight to the largest load and past it.

use super::banded::Banded;
use super::correct::{Balanced, Constraint, balance, dot, norm};
use super::frame::{frame, point};
use super::model::Model;
use super::outcome::{Frame, Outcome, PathPoint, Status};
use super::relax::{BRIEF, Fall, PATIENT, dashpots, fall};
use super::settings::{Program, Settings};
use super::stand::Standing;
use super::system::{State, Workspace, advance, assemble, commit};
use crate::blocks::{BlockModel, Loading, ModelError};
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
        Standing::Lost => Status::NotConverged,
        Standing::Stopped => Status::Cancelled,
    };
    Ok(path.outcome(blocks, status))
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
pub(super) struct Heading {
    direction: Vec<f64>,
    factor: f64,
    /// Sign of the determinant of the tangent.
    pub sign: i8,
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
    pub model: &'m Model,
    pub settings: &'m Settings,
    program: &'m Program,
    pub work: Workspace,
    /// Whether the tangent of the state that the last step led to stands in the workspace.
    assembled: bool,
    /// What falls are resisted by, once there was one.
    dashpots: Option<Banded>,
    pub points: Vec<PathPoint>,
    /// Whether states are kept to be drawn.
    drawn: bool,
    frames: Vec<Frame>,
    last: Balanced,
    pub iterations: u32,
    pub mechanism: Vec<f64>,
    /// How often balance was lost and found again.
    snaps: u32,
}

/// Iterations that a step of the right length takes.
const WANTED_ITERATIONS: f64 = 5.0;

/// The same where joints slide and the step is short: these take some iterations to show how they go on, and no fewer of them
/// where the step is shorter. What slides in a step does so in one direction, so that steps longer than these are not sought.
const WANTED_WHERE_SLIDING: f64 = 10.0;

/// A step is short that gains less than this share of the load.
const SHORT: f64 = 2e-3;

/// A load that is pushed to is at most so many times the resolution further on; one that gains so many times as much on the path
/// afterwards is not enlarged.
const LARGEST_PUSH: f64 = 1024.0;
const FAR: f64 = 10.0;

/// The same where no end is found closer by: that tells the largest load to a thousandth, from below.
const COARSE_PUSH: f64 = 100.0;

/// Most loads that are pushed on where the path has as many states as it may.
const MOST_PUSHES: u32 = 500;

/// First step past the peak, as a share of the size of the blocks, in the norm of all motions.
const PAST_PEAK: f64 = 1e-3;

impl<'m> Path<'m> {
    pub fn new(model: &'m Model, settings: &'m Settings, program: &'m Program) -> Path<'m> {
        Path {
            model,
            settings,
            program,
            work: Workspace::new(model),
            assembled: false,
            dashpots: None,
            points: Vec::new(),
            drawn: false,
            frames: Vec::new(),
            last: Balanced { iterations: 0, residual: 0.0 },
            iterations: 0,
            mechanism: Vec::new(),
            snaps: 0,
        }
    }

    /// Follows the path until the factor is at its target or can grow no more. Where balance is lost and found again close by,
    /// as when a hinge moves to the next joint, the path goes on from there.
    pub fn follow(&mut self, increment: f64, target: f64, state: &mut State, watch: &mut dyn Watch) -> End {
        let (mut length, mut push) = (None, 1.0);
        loop {
            let before = state.factor;
            // A path of very many states is left to loads that are pushed on alone: these come to an end.
            let long = self.points.len() as u32 >= self.settings.most_steps;
            let end = if long { End::Lost } else { self.rise((increment, target), &mut length, state, watch) };
            if matches!(end, End::Target | End::Bifurcation | End::Stopped) {
                return end;
            }
            let unit = self.settings.resolution * state.factor.abs().max(self.settings.resolution * increment);
            // Where the path is lost again and again, a load further on is tried.
            let gained = state.factor - before;
            push = if gained > FAR * push * unit { 1.0 } else { (2.0 * push).min(LARGEST_PUSH) };
            let (next, balanced) = match self.pushed(end, (&mut push, unit), target, state, watch) {
                Ok(found) => found,
                Err(end) => {
                    if end != End::Stopped && !long {
                        self.descend(state, watch);
                    }
                    return end;
                }
            };
            self.snaps += 1;
            self.accept(next, balanced, state);
            if state.factor >= target {
                return End::Target;
            }
            if self.points.len() as u32 > self.settings.most_steps + MOST_PUSHES {
                return End::Lost;
            }
        }
    }

    /// Where the blocks come to rest under a load a little further on; or how the path ends, if they do not. `push` is that load
    /// beyond the present one in units of the resolution, and is lowered until they come to rest.
    fn pushed(
        &mut self,
        end: End,
        (push, unit): (&mut f64, f64),
        target: f64,
        state: &State,
        watch: &mut dyn Watch,
    ) -> Result<(State, Balanced), End> {
        let mut coarse = false;
        loop {
            let mut pushed = state.clone();
            advance(self.model, &mut pushed, &[], (*push * unit).min(target - state.factor));
            match self.fall(&pushed, if *push > 1.0 { BRIEF } else { PATIENT }, watch) {
                Fall::Rests(found, balanced) => return Ok((found, balanced)),
                Fall::Stopped => return Err(End::Stopped),
                Fall::Falls(_) | Fall::Lost if *push > 1.0 && !coarse => *push = (0.25 * *push).max(1.0),
                // That they fall for good proves that the load was the largest.
                Fall::Falls(fallen) if end == End::Lost => {
                    self.mechanism = self.way(state, &fallen);
                    return Err(End::Limit);
                }
                // Under a little more load they fall faster, and that shows the largest load less closely.
                Fall::Lost if end == End::Lost && !coarse => (coarse, *push) = (true, COARSE_PUSH),
                Fall::Falls(_) | Fall::Lost => return Err(end),
            }
        }
    }

    pub fn fall(&mut self, from: &State, granted: u32, watch: &mut dyn Watch) -> Fall {
        let (model, settings) = (self.model, self.settings);
        let dashpots = self.dashpots.get_or_insert_with(|| dashpots(model, settings));
        let (end, corrections) = fall(model, settings, dashpots, (from, granted), (&mut self.work, watch));
        self.iterations += corrections;
        end
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
        for step in self.points.len() as u32..self.settings.most_steps {
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
            let short = share < first || heading.factor * share < SHORT * state.factor;
            let grown = share * (self.wanted(short) / f64::from(balanced.iterations.max(1))).clamp(0.5, 2.0);
            past = past.map(|past| Past { distance: past.distance - share, ..past }).filter(|past| past.distance > 0.0);
            share = past.as_ref().map_or(grown, |past| grown.min(past.distance * past.short_of_peak(&heading)));
        }
        End::Lost
    }

    /// Iterations that the next step should take.
    fn wanted(&self, short: bool) -> f64 {
        let slides = self.points.last().is_some_and(|p| p.sliding > 0);
        if slides && short { WANTED_WHERE_SLIDING } else { WANTED_ITERATIONS }
    }

    /// A balanced state a step along the heading.
    fn step(
        &mut self,
        constraint: Constraint,
        from: &State,
        (heading, length): (&Heading, f64),
    ) -> Option<(State, Balanced)> {
        self.assembled = false;
        let mut next = from.clone();
        let change: Vec<f64> = heading.direction.iter().map(|d| d * length).collect();
        advance(self.model, &mut next, &change, heading.factor * length);
        let balanced = balance(self.model, self.settings, constraint, &mut next, &mut self.work)?;
        self.iterations += balanced.iterations;
        commit(self.model, self.settings, &mut next);
        // Joints that hold have the same tangent before and after they remember the state.
        self.assembled = !self.work.slides;
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
            length *= (self.wanted(true) / f64::from(balanced.iterations.max(1))).clamp(0.5, 1.5);
        }
    }

    /// Where the path goes at a balanced state, on from where it came; none where the tangent is singular.
    pub fn heading(&mut self, state: &State, before: Option<&Heading>) -> Option<Heading> {
        if !std::mem::take(&mut self.assembled) {
            assemble(self.model, self.settings, state, &mut self.work);
        }
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
        let cause = collapse_factor.and(peak).map(|k| self.cause(&self.points[self.frames[k].step]));
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
}
