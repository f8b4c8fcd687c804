//! Newton's method in load steps that are cut back where they fail and grow again where they go well.

use super::assemble::assemble;
use super::dofs::dof;
use super::element::held;
use super::factor::FactorError;
use super::gmres::{dot, norm};
use super::interface::Spring;
use super::joint::weakest;
use super::model::{Model, count};
use super::newmark::Inertia;
use super::outcome::{Outcome, Status, Step};
use super::settings::Settings;
use super::state::{Bond, State};
use super::workspace::Workspace;
use crate::ids::{Id, NodeId};
use crate::watch::{Asking, Progress, Watch};

/// What is to be carried in the end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Target {
    /// Nodal forces on all components [N/m].
    pub forces: Vec<f64>,
    /// Displacements of held components: node, axis (0 or 1), value [m]. Those that are not named stay as they are.
    pub imposed: Vec<(NodeId, usize, f64)>,
}

/// Takes a state to a target in load steps between what it carries and what it is to carry.
///
/// Where that ends early, the state stands at the last step that was balanced. The first guess of a step goes along the tangent with
/// which the last step ended, if `work` still has it: another workspace gives the same state to within the tolerance, not to the bit.
pub fn advance(
    model: &Model,
    state: &mut State,
    work: &mut Workspace,
    target: &Target,
    settings: &Settings,
    watch: &mut dyn Watch,
) -> Outcome {
    let mut outcome = Outcome { status: Status::Completed, reached: 0.0, iterations: 0, steps: Vec::new() };
    let from = Aim { forces: state.forces.clone(), displacements: state.displacements.clone() };
    let to = Aim::new(model, &from, target);
    let (mut path, mut asking) = (Path::new(settings), Asking::new(watch));
    work.fresh &= work.trial.displacements == state.displacements;
    while path.reached < 1.0 {
        let progress = Progress {
            stage: format!("load step {}", outcome.steps.len() + 1),
            fraction: Some(path.reached),
            steps: outcome.iterations,
        };
        if asking.tell(progress) {
            outcome.status = Status::Cancelled;
            return outcome;
        }
        let aim = from.towards(&to, path.next());
        let attempt = balance(model, state, work, (&aim, None), settings, &mut asking);
        outcome.iterations += u64::from(attempt.took.iterations);
        outcome.steps.push(attempt.step(model, work, path.next()));
        if attempt.end == Status::Completed {
            work.keep(state, &aim.forces);
            path.accept(attempt.took.iterations);
            outcome.reached = path.reached;
        } else if !path.cut(work) || attempt.end == Status::Cancelled {
            outcome.status = attempt.end;
            return outcome;
        }
    }
    outcome
}

/// What is carried at some point of the path.
#[derive(Debug, Clone)]
pub(super) struct Aim {
    /// On all components [N/m].
    pub forces: Vec<f64>,
    /// Of all components [m]; only those of held ones are read.
    pub displacements: Vec<f64>,
}

impl Aim {
    fn new(model: &Model, from: &Aim, target: &Target) -> Aim {
        let mut to = from.clone();
        to.forces.iter_mut().zip(&target.forces).for_each(|(to, force)| *to = *force);
        for &(node, axis, value) in &target.imposed {
            if axis < 2 && model.held(node, axis) {
                to.displacements[dof(node, axis)] = value;
            }
        }
        to
    }

    fn towards(&self, to: &Aim, share: f64) -> Aim {
        let mix = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + share * (b - a)).collect();
        Aim { forces: mix(&self.forces, &to.forces), displacements: mix(&self.displacements, &to.displacements) }
    }
}

/// How far along the load the run is, and how far the next step goes.
#[derive(Debug)]
struct Path {
    reached: f64,
    step: f64,
    largest: f64,
    smallest: f64,
}

/// Iterations within which a step counts as easy, so that the next may be longer.
const EASY: u32 = 8;

impl Path {
    fn new(settings: &Settings) -> Path {
        let largest = 1.0 / f64::from(settings.load_steps.max(1));
        let smallest = largest * 0.5_f64.powi(settings.cut_limit.min(1000) as i32);
        Path { reached: 0.0, step: largest, largest, smallest }
    }

    /// Share of the load at the end of the next step; the rest, where little more is left.
    fn next(&self) -> f64 {
        let next = self.reached + self.step;
        if next > 1.0 - 1e-9 { 1.0 } else { next }
    }

    fn accept(&mut self, iterations: u32) {
        self.reached = self.next();
        if iterations <= EASY {
            self.step = (2.0 * self.step).min(self.largest);
        }
    }

    /// Halves the step; tells whether it may still be tried. The tangent starts anew.
    fn cut(&mut self, work: &mut Workspace) -> bool {
        self.step *= 0.5;
        work.fresh = false;
        self.step >= self.smallest
    }
}

/// One attempt at balance.
#[derive(Debug, Clone, Copy)]
pub(super) struct Attempt {
    /// How it ended: completed where there is balance.
    pub end: Status,
    /// What it took; what was tried stands in the workspace.
    pub took: Step,
}

impl Attempt {
    pub(super) fn step(&self, model: &Model, work: &Workspace, reached: f64) -> Step {
        let (open, sliding) = count(work.trial.bonds.iter().map(|bond| bond.state));
        Step {
            reached,
            yielding: work.trial.points.iter().filter(|point| point.yields).count(),
            locking: model.locking(&work.trial.points, |quad| held(work.misses[quad.index()])),
            open,
            sliding,
            kept: self.end == Status::Completed,
            ..self.took
        }
    }
}

/// Iterations without a new least residual after which what is left may be rounding.
const PATIENCE: u32 = 3;

/// Residual over applied force above which nothing passes for rounding.
const ROUNDED: f64 = 1e-4;

/// Those after which an attempt is given up.
const STALL: u32 = 20;

/// Residual over applied force beyond which an attempt is given up.
const RUNAWAY: f64 = 1e12;

/// Residual to which unsymmetric tangents are solved: Newton's method makes up for the rest.
const ACCURACY: f64 = 1e-4;

/// Finds displacements at which internal forces balance what is aimed at and no pair of `state` that is whole is beyond its strength; `work` then holds them,
/// and pairs that broke are marked in `state`, unless there is no balance.
pub(super) fn balance(
    model: &Model,
    state: &mut State,
    work: &mut Workspace,
    (aim, inertia): (&Aim, Option<&Inertia>),
    settings: &Settings,
    asking: &mut Asking<'_>,
) -> Attempt {
    let mut broken = Vec::new();
    let mut attempt = seek(&Equations { model, state, aim, inertia }, work, settings, Begin::State, asking);
    while attempt.end == Status::Completed {
        let breaking = weakest(overstressed(model, &work.trial.bonds));
        if breaking.is_empty() {
            return attempt;
        }
        breaking.iter().for_each(|&pair| state.bonds[pair].memory.broken = true);
        broken.extend(breaking);
        let before = attempt.took.iterations;
        attempt = seek(&Equations { model, state, aim, inertia }, work, settings, Begin::Trial, asking);
        attempt.took.iterations += before;
    }
    broken.iter().for_each(|&pair| state.bonds[pair].memory.broken = false);
    attempt
}

/// Tension over strength of all pairs.
fn overstressed<'a>(model: &'a Model, bonds: &'a [Bond]) -> impl Iterator<Item = (usize, f64)> + 'a {
    let overstress = |(spring, bond): (&Spring, &Bond)| {
        model.joints[spring.kind].overstress(bond.traction[0], spring.area, &bond.memory)
    };
    model.springs.iter().zip(bonds).map(overstress).enumerate()
}

/// Where an attempt begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begin {
    /// At the state, along its tangent.
    State,
    /// At the displacements that were tried last.
    Trial,
}

/// Finds displacements at which internal forces balance what is aimed at; `work` then holds them (equation 15).
fn seek(
    equations: &Equations<'_>,
    work: &mut Workspace,
    settings: &Settings,
    begin: Begin,
    asking: &mut Asking<'_>,
) -> Attempt {
    let model = equations.model;
    let took = Step { unbalanced: f64::INFINITY, ..Step::default() };
    let mut attempt = Attempt { end: Status::NotConverged, took };
    let begins = match begin {
        Begin::State => equations.predict(work),
        Begin::Trial => equations.evaluate(work).map(|()| (equations.unbalanced(work), false)),
    };
    let Some((mut right, imposes)) = begins else { return attempt };
    let mut best = (f64::INFINITY, 0);
    let mut damping = 0.0;
    while attempt.took.iterations < settings.iteration_limit.max(1) {
        if asking.stops() {
            attempt.end = Status::Cancelled;
            return attempt;
        }
        attempt.took.iterations += 1;
        let first = attempt.took.iterations == 1 && begin == Begin::State;
        let direction = match direction(work, &right, &mut damping) {
            Ok(direction) => direction,
            Err(FactorError::IllConditioned) => return attempt,
            Err(_) => {
                attempt.end = Status::Singular;
                return attempt;
            }
        };
        let start = dot(&right, &direction);
        let (skewed, before) = (work.skewed, norm(&right).hypot(work.loose));
        if first {
            equations.impose(work);
        }
        let whole = equations.go(work, &direction, 1.0);
        let found = if first && imposes {
            whole
        } else if skewed {
            equations.shorten(work, &direction, before, whole)
        } else if damping > 0.0 {
            equations.descend(work, &direction, start, whole)
        } else if whole.as_ref().is_none_or(|now| poor(start, dot(now, &direction))) {
            equations.search(work, &direction, start, whole)
        } else {
            whole
        };
        let Some(now) = found else { return attempt };
        right = now;
        let left = norm(&right).hypot(work.loose);
        attempt.took.unbalanced = left / equations.size(work).max(f64::MIN_POSITIVE);
        // Balanced, or as near to it as numbers can come.
        let stalled = attempt.took.iterations > best.1 + PATIENCE;
        let rounded = stalled && attempt.took.unbalanced <= ROUNDED && left <= work.rounding(model);
        if attempt.took.unbalanced <= settings.tolerance || rounded {
            attempt.end = Status::Completed;
            return attempt;
        }
        if attempt.took.unbalanced < 0.9 * best.0 {
            best = (attempt.took.unbalanced, attempt.took.iterations);
        }
        if !(attempt.took.unbalanced < RUNAWAY) || attempt.took.iterations > best.1 + STALL {
            return attempt;
        }
    }
    attempt
}

/// Share of its diagonal that is added to a tangent that is not positive definite, at first.
const LEAST_DAMPING: f64 = 1e-6;

/// The step of Newton's method.
///
/// Where a symmetric tangent has an inverse but is not positive definite, Newton's step leads away from balance that is stable: a stone
/// between two open joints that swings out. A share of its diagonal is then added, as much as makes it definite, so that the step goes
/// down in energy; the share fades over the next iterations (Levenberg and Marquardt).
fn direction(work: &mut Workspace, right: &[f64], damping: &mut f64) -> Result<Vec<f64>, FactorError> {
    let definite = work.factorise()?;
    let plain = work.solve(right, ACCURACY)?;
    if work.skewed || (definite && *damping < LEAST_DAMPING) {
        *damping = 0.0;
        return Ok(plain);
    }
    *damping = if definite { 0.1 * *damping } else { LEAST_DAMPING.max(*damping) };
    while *damping < 1.0 {
        if let Some(damped) = work.solve_damped(right, *damping) {
            return Ok(damped);
        }
        *damping *= 10.0;
    }
    Ok(plain)
}

/// Whether a part of the step may serve better than the whole: the force along it has turned round and is large, or has grown.
fn poor(start: f64, end: f64) -> bool {
    const LEFT: f64 = 0.8;
    let turned = end * start < 0.0;
    !(end.abs() <= if turned { LEFT } else { 1.0 } * start.abs())
}

/// The equations of balance of one step.
struct Equations<'a> {
    model: &'a Model,
    state: &'a State,
    aim: &'a Aim,
    inertia: Option<&'a Inertia>,
}

impl Equations<'_> {
    /// Right-hand side of the first iteration, and whether displacements are imposed in this step. The tangent of the last step is
    /// used where it is at hand.
    fn predict(&self, work: &mut Workspace) -> Option<(Vec<f64>, bool)> {
        let fresh = work.fresh;
        work.take(self.state);
        if !fresh {
            self.evaluate(work)?;
        }
        work.fresh = false;
        let mut right = self.unbalanced(work);
        let mut imposes = false;
        let entries = work.pattern.entries();
        for (&(equation, component), value) in work.pattern.coupling.iter().zip(&work.values[entries..]) {
            let more = self.more(component as usize);
            imposes |= more != 0.0;
            right[equation as usize] -= value * more;
        }
        Some((right, imposes))
    }

    /// How much further a held component is to move.
    fn more(&self, component: usize) -> f64 {
        self.aim.displacements[component] - self.state.displacements[component]
    }

    fn impose(&self, work: &mut Workspace) {
        let dofs = &self.model.dofs;
        for component in (0..dofs.equation.len()).filter(|component| dofs.held(*component)) {
            work.trial.displacements[component] = self.aim.displacements[component];
        }
    }

    /// Moves the free components and computes what is then out of balance.
    fn go(&self, work: &mut Workspace, direction: &[f64], share: f64) -> Option<Vec<f64>> {
        for (component, step) in self.model.dofs.free.iter().zip(direction) {
            work.trial.displacements[*component as usize] += share * step;
        }
        self.evaluate(work)?;
        Some(self.unbalanced(work))
    }

    fn evaluate(&self, work: &mut Workspace) -> Option<()> {
        assemble(self.model, work, self.state)?;
        if let Some(inertia) = self.inertia {
            inertia.stiffen(work);
        }
        Some(())
    }

    fn unbalanced(&self, work: &Workspace) -> Vec<f64> {
        match self.inertia {
            None => work.unbalanced(self.model, &self.aim.forces),
            Some(inertia) => inertia.unbalanced(self.model, work, &self.aim.forces),
        }
    }

    /// Size of the forces that are to balance [N/m].
    fn size(&self, work: &Workspace) -> f64 {
        let applied = work.applied(self.model, &self.aim.forces);
        match self.inertia {
            None => applied,
            Some(_) => applied.max(norm(&self.model.dofs.of_free(&work.internal))),
        }
    }

    /// Halves the step until the out-of-balance force falls: where tangents are not symmetric there is no energy to go by. If it
    /// never does, the shortest step is taken, so that the next direction is another.
    fn shorten(
        &self,
        work: &mut Workspace,
        direction: &[f64],
        start: f64,
        whole: Option<Vec<f64>>,
    ) -> Option<Vec<f64>> {
        const TRIES: usize = 4;
        let falls =
            |found: &Option<Vec<f64>>, loose: f64| found.as_ref().is_some_and(|found| norm(found).hypot(loose) < start);
        let (mut found, mut share) = (whole, 1.0);
        for _ in 0..TRIES {
            if falls(&found, work.loose) {
                break;
            }
            found = self.go(work, direction, -0.5 * share);
            share *= 0.5;
        }
        found
    }

    /// Goes on doubling a damped step as long as the force along it has not turned round: out of the saddle that made the damping
    /// necessary. The last step before it turns is taken; where it turns at once, the part of it at which the force vanishes.
    fn descend(
        &self,
        work: &mut Workspace,
        direction: &[f64],
        start: f64,
        whole: Option<Vec<f64>>,
    ) -> Option<Vec<f64>> {
        const DOUBLINGS: usize = 20;
        let (mut found, mut share) = (whole, 1.0);
        if found.as_ref().is_none_or(|now| !(dot(now, direction) * start > 0.0)) {
            return self.search(work, direction, start, found);
        }
        for _ in 0..DOUBLINGS {
            let farther = self.go(work, direction, share);
            if farther.as_ref().is_none_or(|now| !(dot(now, direction) * start > 0.0)) {
                return self.go(work, direction, -share);
            }
            (found, share) = (farther, 2.0 * share);
        }
        found
    }

    /// Searches the part of the step at which the force along it vanishes, by false position within [0.05, 1]; `whole` was found at 1.
    fn search(&self, work: &mut Workspace, direction: &[f64], start: f64, whole: Option<Vec<f64>>) -> Option<Vec<f64>> {
        const TRIES: usize = 6;
        const LEAST: f64 = 0.05;
        let along = |right: &Option<Vec<f64>>| right.as_ref().map_or(f64::INFINITY, |right| dot(right, direction));
        let (mut low, mut high) = ((0.0, start), (1.0, along(&whole)));
        let (mut share, mut found) = (1.0, whole);
        let mut best = (share, high.1.abs());
        for _ in 0..TRIES {
            let crosses = high.1.is_finite() && low.1 * high.1 < 0.0;
            let (a, b) = (low.1.abs(), high.1.abs());
            let part = if crosses { (a / (a + b)).clamp(0.1, 0.9) } else { 0.5 };
            let next = low.0 + part * (high.0 - low.0);
            if next < LEAST {
                break;
            }
            found = self.go(work, direction, next - share);
            share = next;
            let force = along(&found);
            if force.abs() < best.1 {
                best = (share, force.abs());
            }
            if !poor(start, force) {
                return found;
            }
            if force.is_finite() && force * start > 0.0 && force.abs() < start.abs() {
                low = (share, force);
            } else {
                high = (share, force);
            }
        }
        if best.0 == share { found } else { self.go(work, direction, best.0 - share) }
    }
}
