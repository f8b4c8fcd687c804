//! The path from self-weight to the largest load and past it, a step at a time: between two steps a run can be kept.

use super::banded::Banded;
use super::correct::{Balanced, Constraint, balance, dot, norm};
use super::frame::{frame, point};
use super::model::Model;
use super::outcome::{Outcome, PathPoint, Status};
use super::relax::{BRIEF, Fall, Falling, PATIENT, dashpots};
use super::settings::{Program, Settings};
use super::stand::{LetGo, Settle};
use super::system::{State, Workspace, advance, assemble, commit};
use super::words;
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::watch::{Progress, Watch, Wish};

/// The load at which equilibrium ends, with joints that give: the path of balanced states from the blocks' own weight through
/// the largest load. `resume` takes up a run that [`Watch::keep`] was offered, for the same blocks, loads, settings and program;
/// the numbers are those of an undisturbed run.
///
/// # Errors
/// A model that cannot be analysed, and words that were kept for another one.
pub fn collapse(
    blocks: &BlockModel,
    loading: &Loading,
    (settings, program): (&Settings, &Program),
    resume: Option<&[u64]>,
    watch: &mut dyn Watch,
) -> Result<Outcome, ModelError> {
    let model = Model::new(blocks, loading, settings)?;
    let mut path = Path::new(&model, settings, program);
    path.keeps = true;
    let belongs = words::fingerprint(&path);
    if let Some(kept) = resume {
        words::decode(&mut path, kept, belongs).ok_or(ModelError::ForeignState)?;
    }
    let status = path.run(Some(belongs), watch).status();
    Ok(path.outcome(blocks, status))
}

/// How the loads ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Target,
    Limit,
    Bifurcation,
    Lost,
    /// The blocks fall under their own weight.
    Falls,
    Stopped,
}

impl End {
    pub fn status(self) -> Status {
        match self {
            End::Target => Status::StableToLastLoad,
            End::Limit => Status::LimitPoint,
            End::Bifurcation => Status::Bifurcation,
            End::Lost => Status::NotConverged,
            End::Falls => Status::UnstableUnderSelfWeight,
            End::Stopped => Status::Cancelled,
        }
    }
}

/// What a run does next.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Stage {
    /// Begins.
    Built,
    /// Lets joints go that are pressed together.
    LetGo(LetGo),
    /// Lets the blocks fall under their own weight.
    Settle(Settle),
    /// The blocks stand under their own weight.
    Stood(Balanced),
    /// Follows the path up.
    Rise(Rise),
    /// Lets the blocks fall under a little more load.
    Push(Push),
    /// Follows the path past its peak.
    Descend(Descend),
}

/// What follows a step.
pub(super) enum Next {
    On(Stage),
    End(End),
}

/// The path followed up.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rise {
    pub heading: Heading,
    /// Length of the next step, and of the longest first one.
    pub share: f64,
    pub first: f64,
    /// Length of the last step that led to no state, where there was one not long ago.
    pub lost: Option<f64>,
    pub past: Option<Past>,
    pub step: u32,
    /// Load factor where it began.
    pub before: f64,
}

/// Blocks let fall under more load than the path was followed to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Push {
    /// How the path ended.
    pub end: End,
    /// Unit of the load that is added.
    pub unit: f64,
    /// Whether no end was found closer by.
    pub coarse: bool,
    pub falling: Falling,
}

/// The path followed past its peak.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Descend {
    /// How the path ended.
    pub end: End,
    /// Largest load factor.
    pub peak: f64,
    pub heading: Heading,
    /// Length of the next step.
    pub length: f64,
    pub step: u32,
}

/// Where the path goes at a balanced state, per unit of its length.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Heading {
    pub direction: Vec<f64>,
    pub factor: f64,
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Past {
    pub distance: f64,
    pub rate: f64,
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
    pub program: &'m Program,
    pub work: Workspace,
    /// Whether the tangent of the state that the last step led to stands in the workspace.
    assembled: bool,
    /// What falls are resisted by, once there was one.
    dashpots: Option<Banded>,
    /// Whether all states are kept.
    pub keeps: bool,
    /// The last balanced state, and what comes next.
    pub state: State,
    pub stage: Stage,
    /// Length of the last step on the way up.
    pub length: Option<f64>,
    /// The load that is added where balance is lost, in units of the resolution.
    pub push: f64,
    /// The balanced states in their order: their numbers, and all of them where they are kept.
    pub points: Vec<PathPoint>,
    pub states: Vec<State>,
    pub iterations: u32,
    pub mechanism: Vec<f64>,
    /// How often balance was lost and found again.
    pub snaps: u32,
}

/// Iterations that a step of the right length takes.
const WANTED_ITERATIONS: f64 = 5.0;

/// The same where joints slide and the step is short: these take some iterations to show how they go on, and no fewer of them
/// where the step is shorter. What slides in a step does so in one direction, so that steps longer than these are not sought.
const WANTED_WHERE_SLIDING: f64 = 10.0;

/// A step is short that gains less than this share of the load.
const SHORT: f64 = 2e-3;

/// A step after one that led to no state is at most this share of its length, and the next ones this much longer each.
const SHY: f64 = 0.75;
const DARING: f64 = 1.5;

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
            keeps: false,
            state: State::as_built(model),
            stage: Stage::Built,
            length: None,
            push: 1.0,
            points: Vec::new(),
            states: Vec::new(),
            iterations: 0,
            mechanism: Vec::new(),
            snaps: 0,
        }
    }

    /// Brings the blocks to stand under their own weight; or how that ends.
    pub fn stand(&mut self, watch: &mut dyn Watch) -> Result<Balanced, End> {
        loop {
            if let Stage::Stood(balanced) = self.stage {
                return Ok(balanced);
            }
            if let Some(end) = self.go_on(None, watch) {
                return Err(end);
            }
        }
    }

    /// Follows the path from the last balanced state to its end.
    pub fn follow(&mut self, watch: &mut dyn Watch) -> End {
        (self.length, self.push) = (None, 1.0);
        match self.begin_rise() {
            Next::End(end) => end,
            Next::On(stage) => {
                self.stage = stage;
                self.run(None, watch)
            }
        }
    }

    /// Follows the path from the last balanced state to where it no longer rises.
    pub fn follow_up(&mut self, watch: &mut dyn Watch) -> End {
        let Some(mut rise) = self.rising() else { return End::Lost };
        loop {
            if watch.look(&self.progress()) == Wish::Stop {
                return End::Stopped;
            }
            if let Some(end) = self.climb(&mut rise) {
                return end;
            }
        }
    }

    /// Goes on to the end. Where the words of a run may be kept, they begin with what they belong to.
    fn run(&mut self, belongs: Option<u64>, watch: &mut dyn Watch) -> End {
        loop {
            if let Some(end) = self.go_on(belongs, watch) {
                return end;
            }
        }
    }

    /// One step; how the path ends, where it does.
    fn go_on(&mut self, belongs: Option<u64>, watch: &mut dyn Watch) -> Option<End> {
        let keep = |path: &Path, watch: &mut dyn Watch| {
            if let Some(belongs) = belongs {
                watch.keep(&|| words::encode(path, belongs));
            }
        };
        keep(self, watch);
        if watch.look(&self.progress()) == Wish::Stop {
            keep(self, watch);
            return Some(End::Stopped);
        }
        let next = match std::mem::replace(&mut self.stage, Stage::Built) {
            Stage::Built => Next::On(self.glue()),
            Stage::LetGo(joints) => self.let_go(joints),
            Stage::Settle(settle) => self.fall_at_first(settle),
            Stage::Stood(balanced) => {
                self.keep(balanced);
                self.begin_rise()
            }
            Stage::Rise(rise) => self.rise(rise),
            Stage::Push(push) => self.pushed(push),
            Stage::Descend(descend) => self.descend(descend),
        };
        match next {
            Next::On(stage) => {
                self.stage = stage;
                None
            }
            Next::End(end) => Some(end),
        }
    }

    fn progress(&self) -> Progress {
        let (limit, factor) = (self.program.limit, self.state.factor);
        let share = (limit.is_finite() && limit > 0.0).then(|| (factor / limit).clamp(0.0, 1.0));
        let (stage, fraction, steps) = match &self.stage {
            Stage::Rise(rise) => (format!("load factor {factor:.4}"), share, rise.step),
            Stage::Push(push) => {
                let stage = format!("balance lost at load factor {:.4}", push.falling.state.factor);
                (stage, None, push.falling.corrections)
            }
            Stage::Descend(descend) => ("past the peak".to_owned(), None, descend.step),
            Stage::Settle(settle) => ("self-weight, let fall".to_owned(), None, settle.falling.corrections),
            Stage::Built | Stage::LetGo(_) | Stage::Stood(_) => ("self-weight".to_owned(), None, 0),
        };
        Progress { stage, fraction, steps: u64::from(steps) }
    }

    /// Begins to follow the path up from the last balanced state.
    fn begin_rise(&mut self) -> Next {
        // A path of very many states is left to loads that are pushed on alone: these come to an end.
        let before = self.state.factor;
        if self.is_long() {
            return self.risen(End::Lost, before);
        }
        match self.rising() {
            Some(rise) => Next::On(Stage::Rise(rise)),
            None => self.risen(End::Lost, before),
        }
    }

    /// The path up from the last balanced state; none where the tangent is singular.
    fn rising(&mut self) -> Option<Rise> {
        let state = self.state.clone();
        let heading = self.heading(&state, None)?;
        let first = self.program.increment.min(self.program.limit) / heading.factor;
        let share = self.length.unwrap_or(first).min(first);
        let step = self.points.len() as u32;
        Some(Rise { heading, share, first, lost: None, past: None, step, before: state.factor })
    }

    fn is_long(&self) -> bool {
        self.points.len() as u32 >= self.settings.most_steps
    }

    /// The load factor that counts as nothing here.
    fn unseen(&self) -> f64 {
        let increment = self.program.increment;
        self.settings.resolution * self.state.factor.abs().max(self.settings.resolution * increment)
    }

    /// One step up.
    fn rise(&mut self, mut rise: Rise) -> Next {
        let before = rise.before;
        match self.climb(&mut rise) {
            None => Next::On(Stage::Rise(rise)),
            Some(end) => self.risen(end, before),
        }
    }

    /// What follows the end of a way up. Where balance is lost and found again close by, as when a hinge moves to the next joint, the
    /// path goes on from there.
    fn risen(&mut self, end: End, before: f64) -> Next {
        if matches!(end, End::Target | End::Bifurcation) {
            return Next::End(end);
        }
        let unit = self.unseen();
        // Where the path is lost again and again, a load further on is tried.
        let gained = self.state.factor - before;
        self.push = if gained > FAR * self.push * unit { 1.0 } else { (2.0 * self.push).min(LARGEST_PUSH) };
        Next::On(Stage::Push(Push { end, unit, coarse: false, falling: self.let_fall(unit) }))
    }

    /// Blocks under a load a little further on.
    fn let_fall(&self, unit: f64) -> Falling {
        let mut pushed = self.state.clone();
        advance(self.model, &mut pushed, &[], (self.push * unit).min(self.program.limit - self.state.factor));
        Falling::new(pushed, if self.push > 1.0 { BRIEF } else { PATIENT })
    }

    /// One step of the way to where the blocks come to rest under a load a little further on; or how the path ends, if they do not.
    /// The load is lowered until they come to rest.
    fn pushed(&mut self, mut push: Push) -> Next {
        let Some(fall) = self.fall(&mut push.falling) else { return Next::On(Stage::Push(push)) };
        match fall {
            Fall::Rests(found, balanced) => {
                self.snaps += 1;
                self.accept(found, balanced);
                if self.state.factor >= self.program.limit {
                    return Next::End(End::Target);
                }
                if self.points.len() as u32 > self.settings.most_steps + MOST_PUSHES {
                    return Next::End(End::Lost);
                }
                return self.begin_rise();
            }
            Fall::Falls(_) | Fall::Lost if self.push > 1.0 && !push.coarse => self.push = (0.25 * self.push).max(1.0),
            // That they fall for good proves that the load was the largest.
            Fall::Falls(fallen) if push.end == End::Lost => {
                self.mechanism = self.way(&self.state, &fallen);
                return self.peaked(End::Limit);
            }
            // Under a little more load they fall faster, and that shows the largest load less closely.
            Fall::Lost if push.end == End::Lost && !push.coarse => (push.coarse, self.push) = (true, COARSE_PUSH),
            Fall::Falls(_) | Fall::Lost => return self.peaked(push.end),
        }
        push.falling = self.let_fall(push.unit);
        Next::On(Stage::Push(push))
    }

    /// One step of a fall; how it ends, where it does.
    pub fn fall(&mut self, falling: &mut Falling) -> Option<Fall> {
        let (model, settings) = (self.model, self.settings);
        let dashpots = self.dashpots.get_or_insert_with(|| dashpots(model, settings));
        let end = falling.go_on(model, settings, dashpots, &mut self.work)?;
        self.iterations += falling.corrections;
        Some(end)
    }

    /// Follows the path by a step up to where the load grows no more, a stiffness turns negative or no next state is found; that is
    /// found to the resolution, and the state is left just before it.
    fn climb(&mut self, rise: &mut Rise) -> Option<End> {
        if rise.step >= self.settings.most_steps {
            return Some(End::Lost);
        }
        rise.step += 1;
        let target = self.program.limit;
        let factor = self.state.factor;
        let reaches = factor + rise.heading.factor * rise.share >= target;
        if reaches {
            rise.share = (target - factor) / rise.heading.factor;
        }
        let unseen = self.unseen();
        // The load grows ever slower towards its largest value.
        if rise.past.as_ref().is_some_and(|past| rise.heading.factor * past.distance <= unseen) {
            self.mechanism.clone_from(&rise.heading.direction);
            return Some(End::Limit);
        }
        let close = rise.heading.factor * rise.share <= unseen;
        let constraint = if reaches { Constraint::Load } else { Constraint::Plane(&rise.heading.direction) };
        let Some((next, balanced)) = self.step(constraint, (&rise.heading, rise.share)) else {
            if close {
                return Some(End::Lost);
            }
            rise.lost = Some(rise.share);
            rise.share *= 0.5;
            return None;
        };
        let on = self.heading(&next, Some(&rise.heading));
        let falls = next.factor <= factor || on.as_ref().is_some_and(|on| on.factor <= 0.0);
        let turns = on.as_ref().is_none_or(|on| on.sign <= 0);
        // Where a joint opens or closes the path has a corner; where it forks it has none. Whether a crack grows is not known beforehand.
        let smooth = !self.work.cracks && on.as_ref().is_some_and(|on| rise.heading.goes_on_as(on));
        let on = match on {
            Some(on) if !falls && !turns => on,
            on => {
                if close {
                    self.mechanism.clone_from(&rise.heading.direction);
                    return Some(match (falls, smooth) {
                        (true, _) => End::Limit,
                        (false, true) => End::Bifurcation,
                        (false, false) => End::Lost,
                    });
                }
                rise.past = on.filter(|on| on.factor < 0.0).map(|on| Past { distance: rise.share, rate: on.factor });
                rise.share *= rise.past.as_ref().map_or(0.5, |past| past.short_of_peak(&rise.heading));
                return None;
            }
        };
        self.accept(next, balanced);
        if reaches {
            return Some(End::Target);
        }
        self.length = Some(rise.share);
        rise.heading = on;
        let short = rise.share < rise.first || rise.heading.factor * rise.share < SHORT * self.state.factor;
        let grown = rise.share * (self.wanted(short) / f64::from(balanced.iterations.max(1))).clamp(0.5, 2.0);
        let grown = rise.lost.map_or(grown, |lost| grown.min(SHY * lost));
        rise.lost = rise.lost.map(|lost| lost * DARING).filter(|lost| SHY * lost < 2.0 * grown);
        let nearer = |past: Past| Past { distance: past.distance - rise.share, ..past };
        rise.past = rise.past.map(nearer).filter(|past| past.distance > 0.0);
        let most = |past: &Past| grown.min(past.distance * past.short_of_peak(&rise.heading));
        rise.share = rise.past.as_ref().map_or(grown, most);
        None
    }

    /// Iterations that the next step should take.
    fn wanted(&self, short: bool) -> f64 {
        let slides = self.points.last().is_some_and(|p| p.sliding > 0);
        if slides && short { WANTED_WHERE_SLIDING } else { WANTED_ITERATIONS }
    }

    /// A balanced state a step along the heading.
    fn step(&mut self, constraint: Constraint, (heading, length): (&Heading, f64)) -> Option<(State, Balanced)> {
        self.assembled = false;
        let mut next = self.state.clone();
        let change: Vec<f64> = heading.direction.iter().map(|d| d * length).collect();
        advance(self.model, &mut next, &change, heading.factor * length);
        let balanced = balance(self.model, self.settings, constraint, &mut next, &mut self.work)?;
        self.iterations += balanced.iterations;
        commit(self.model, self.settings, &mut next);
        // Joints that hold have the same tangent before and after they remember the state.
        self.assembled = !(self.work.slides || self.work.cracks);
        Some((next, balanced))
    }

    /// What follows the largest load: the path past it, but for a very long one.
    fn peaked(&mut self, end: End) -> Next {
        if self.is_long() {
            return Next::End(end);
        }
        let state = self.state.clone();
        let Some(heading) = self.heading(&state, None) else { return Next::End(end) };
        let length = PAST_PEAK * self.model.size;
        Next::On(Stage::Descend(Descend { end, peak: state.factor, heading, length, step: 0 }))
    }

    /// Follows the path by a step past its peak, as far as that goes, until it has lost a share of its load.
    fn descend(&mut self, mut descend: Descend) -> Next {
        let end = Next::End(descend.end);
        if descend.step >= self.settings.most_steps {
            return end;
        }
        descend.step += 1;
        let constraint = Constraint::Plane(&descend.heading.direction);
        let Some((next, balanced)) = self.step(constraint, (&descend.heading, descend.length)) else {
            descend.length *= 0.5;
            return if descend.length < PAST_PEAK * self.model.size * 1e-6 {
                end
            } else {
                Next::On(Stage::Descend(descend))
            };
        };
        let Some(on) = self.heading(&next, Some(&descend.heading)) else { return end };
        self.accept(next, balanced);
        let moved = self.points.last().map_or(0.0, |p| p.displacement.norm());
        if self.state.factor < descend.peak * (1.0 - self.settings.past) || moved > self.settings.farthest {
            return end;
        }
        descend.heading = on;
        descend.length *= (self.wanted(true) / f64::from(balanced.iterations.max(1))).clamp(0.5, 1.5);
        Next::On(Stage::Descend(descend))
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

    fn accept(&mut self, next: State, balanced: Balanced) {
        self.state = next;
        self.keep(balanced);
    }

    /// The last balanced state becomes part of the path.
    pub fn keep(&mut self, balanced: Balanced) {
        let numbers = (balanced.iterations, balanced.residual);
        self.points.push(point(self.model, (self.settings, self.program), &self.state, numbers));
        if self.keeps {
            self.states.push(self.state.clone());
        }
    }

    fn outcome(self, blocks: &BlockModel, status: Status) -> Outcome {
        let stands = !matches!(status, Status::UnstableUnderSelfWeight);
        let most = self.points.iter().map(|p| p.factor).fold(f64::NEG_INFINITY, f64::max);
        let collapse_factor = matches!(status, Status::LimitPoint | Status::Bifurcation).then_some(most);
        let peak = (0..self.states.len()).rev().find(|&k| self.states[k].factor == most);
        let cause = collapse_factor.and(peak).map(|k| self.cause(&self.points[k]));
        let drawn = |(k, state): (usize, &State)| frame(self.model, self.settings, state, k);
        Outcome {
            status,
            cause,
            collapse_factor,
            last_stable_factor: (stands && most.is_finite()).then_some(most),
            peak,
            mechanism: self.motions(blocks),
            frames: self.states.iter().enumerate().map(drawn).collect(),
            path: self.points,
            interfaces: self.model.interfaces.clone(),
            iterations: self.iterations,
            snaps: self.snaps,
        }
    }
}
