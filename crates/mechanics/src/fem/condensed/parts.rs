//! The parts that may be nonlinear: springs of interfaces and quadrilaterals that may yield. Each evaluates its excess force, by
//! which it carries less than the linear system assumes.

use super::quad_check::QuadCheck;
use super::rows::Row;
use super::spring_check::SpringCheck;
use crate::fem::dofs::HELD;
use crate::fem::element::{self, Kept, Sample, sample};
use crate::fem::factor::Block;
use crate::fem::joint::PairMemory;
use crate::fem::model::Model;
use crate::fem::state::{Bond, Point, State};
use crate::ids::{Id, QuadId};
use crate::wide::wide;

/// Largest number of rows of a part: the displacement components of a quadrilateral.
pub(super) const ROWS: usize = 8;

/// The element that a part stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A spring of [`Model::springs`]: its rows are normal and tangential opening.
    Spring(usize),
    /// A quadrilateral: its rows are the components of its corners.
    Quad(QuadId),
}

/// A part with its committed and its trial state.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// Its element.
    pub kind: Kind,
    /// Numbers of its retained rows, `None` where a component is held and while the part is eliminated.
    pub rows: [Option<usize>; ROWS],
    /// Equations and weights of a spring's normal and tangential opening.
    openings: [Vec<(u32, f64)>; 2],
    /// Equations of a quadrilateral's components.
    equations: [u32; ROWS],
    /// Stiffness in the linear system [N/m²].
    stiffness: [[f64; ROWS]; ROWS],
    /// Largest entry of `stiffness` by size [N/m²].
    pub largest_stiffness: f64,
    /// Row values when the run began [m]; those of held components do not change.
    base: [f64; ROWS],
    /// Integration points of a quadrilateral.
    samples: [Sample; 4],
    /// State at the end of the last balanced position.
    pub committed: Committed,
    /// History by the last evaluation.
    trial: History,
    /// Force that the linear system carried beyond the part when the run began [N/m].
    initial_excess: [f64; ROWS],
    /// Excess force by the last evaluation, counted from `initial_excess` [N/m].
    pub excess: [f64; ROWS],
    /// Derivatives of `excess` by the row values [N/m²], valid while the part is not linear.
    pub excess_stiffness: [[f64; ROWS]; ROWS],
    /// Whether the part is linear at the row values evaluated last: `excess` is then the committed one, to the bit.
    pub linear: bool,
}

/// State of a part at the end of a balanced position.
#[derive(Debug, Clone, Copy)]
pub(super) struct Committed {
    pub history: History,
    /// Excess force [N/m].
    excess: [f64; ROWS],
    /// Whether the part was linear.
    linear: bool,
}

impl Committed {
    /// Gives the state of an element in the `state` in which the run begins, from which excess forces are counted.
    fn at_start(kind: Kind, state: &State) -> Committed {
        let mut history = History::default();
        match kind {
            Kind::Spring(index) => history.bond = state.bonds[index],
            Kind::Quad(id) => {
                history.points.copy_from_slice(&state.points[4 * id.index()..][..4]);
                history.modes = state.modes[id.index()];
            }
        }
        Committed { history, excess: [0.0; ROWS], linear: true }
    }
}

/// History variables of a part, with stress or traction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct History {
    pub points: [Point; 4],
    pub modes: [f64; 4],
    pub bond: Bond,
}

impl Part {
    /// Makes the part of a spring as it stands in `state`.
    pub(super) fn spring(model: &Model, state: &State, index: usize) -> Part {
        let spring = &model.springs[index];
        let virgin = model.joints[spring.kind].respond([0.0; 2], spring.area, &PairMemory::default());
        let mut part = Part::from_rest(Kind::Spring(index), state);
        for (i, opening) in spring.openings().into_iter().enumerate() {
            let row = Row::new(model, &opening, &state.displacements);
            (part.base[i], part.openings[i]) = (row.start, row.terms);
            for j in 0..2 {
                part.stiffness[i][j] = spring.area * virgin.tangent[i][j];
            }
        }
        part
    }

    /// Makes the part of a quadrilateral as it stands in `state`; `None` where it has no linear stiffness.
    pub(super) fn quad(model: &Model, state: &State, id: QuadId) -> Option<Part> {
        let mut part = Part::from_rest(Kind::Quad(id), state);
        part.samples = sample(&model.corners(id));
        let components = model.components(id);
        part.equations = components.map(|component| model.dofs.equation[component]);
        let mut scratch = History::default();
        let from = scratch.modes;
        let kept = Kept { points: &mut scratch.points, modes: &mut scratch.modes, from, misses: &mut 0 };
        let virgin = [Point::default(); 4];
        let (solid, modes) = (&model.section(id).solid, model.incompatible(id));
        part.stiffness = element::respond(solid, modes, &part.samples, &[0.0; 8], &virgin, kept)?.tangent;
        part.base = components.map(|component| state.displacements[component]);
        Some(part)
    }

    /// Makes a part without stiffness or displacement, with the history of its element in `state`.
    fn from_rest(kind: Kind, state: &State) -> Part {
        Part {
            kind,
            rows: [None; ROWS],
            openings: Default::default(),
            equations: [HELD; ROWS],
            stiffness: [[0.0; ROWS]; ROWS],
            largest_stiffness: 0.0,
            base: [0.0; ROWS],
            samples: [Sample::default(); 4],
            committed: Committed::at_start(kind, state),
            trial: History::default(),
            initial_excess: [0.0; ROWS],
            excess: [0.0; ROWS],
            excess_stiffness: [[0.0; ROWS]; ROWS],
            linear: true,
        }
    }

    /// Evaluates the part in the state in which the run begins, from which its excess force is counted. `None` where the law has
    /// no answer.
    pub(super) fn set_initial_excess(&mut self, model: &Model) -> Option<()> {
        let at = self.base;
        self.initial_excess = [0.0; ROWS];
        self.evaluate_law(model, &at)?;
        self.initial_excess = self.excess;
        self.largest_stiffness = self.stiffness.iter().flatten().fold(0.0, |most, entry| most.max(entry.abs()));
        self.excess = [0.0; ROWS];
        Some(())
    }

    /// Evaluates excess force and excess stiffness at the values [m] that `value` gives for retained rows. `None` where the law
    /// has no answer.
    #[inline]
    pub(super) fn evaluate(&mut self, model: &Model, value: impl Fn(usize) -> f64) -> Option<()> {
        let at = std::array::from_fn(|i| self.rows[i].map_or(self.base[i], &value));
        self.evaluate_at(model, &at)
    }

    /// Whether the part would be linear at these values of its rows [m]. The trial history is overwritten.
    pub(super) fn is_linear_at(&mut self, model: &Model, value: impl Fn(usize) -> f64) -> bool {
        let at = std::array::from_fn(|i| self.rows[i].map_or(self.base[i], &value));
        self.check_linear(model, &at)
    }

    /// Evaluates the part at given row values [m]; the law itself only where the part is not linear.
    fn evaluate_at(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<()> {
        self.linear = self.check_linear(model, at);
        if self.linear {
            self.excess = self.committed.excess;
            return Some(());
        }
        self.evaluate_law(model, at)
    }

    /// Evaluates the part, retained or eliminated, in one solution of the linear system.
    pub(super) fn evaluate_in(&mut self, model: &Model, block: &Block, lane: usize) -> Option<()> {
        let mut at = self.base;
        for (at, opening) in at.iter_mut().zip(&self.openings) {
            *at += opening.iter().map(|&(equation, weight)| weight * block.of(equation)[lane]).sum::<f64>();
        }
        for (at, &equation) in at.iter_mut().zip(&self.equations).filter(|(_, equation)| **equation != HELD) {
            *at += block.of(equation)[lane];
        }
        self.evaluate_at(model, &at)
    }

    /// Whether the part is linear at given row values [m]: its history does not change and its stiffness is that of the linear
    /// system. Stress and traction are written to the trial history.
    fn check_linear(&mut self, model: &Model, at: &[f64; ROWS]) -> bool {
        match self.kind {
            Kind::Quad(id) => {
                let (solid, old) = (&model.section(id).solid, &self.committed.history.points);
                !model.incompatible(id) && element::is_linear(solid, &self.samples, at, old, &mut self.trial.points)
            }
            Kind::Spring(index) => {
                let tangent = self.evaluate_spring(model, index, [at[0], at[1]]);
                let linear = (0..2).all(|i| (0..2).all(|j| tangent[i][j] == self.stiffness[i][j]));
                linear && self.trial.bond.memory == self.committed.history.bond.memory && self.overstress(model) <= 1.0
            }
        }
    }

    /// Evaluates the law of the part: trial history, excess force and excess stiffness.
    fn evaluate_law(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<()> {
        let (force, tangent) = self.force_and_tangent(model, at)?;
        for i in 0..ROWS {
            let mut linear_force = 0.0;
            for j in 0..ROWS {
                linear_force += self.stiffness[i][j] * at[j];
                self.excess_stiffness[i][j] = self.stiffness[i][j] - tangent[i][j];
            }
            self.excess[i] = linear_force - force[i] - self.initial_excess[i];
        }
        self.linear = false;
        Some(())
    }

    /// Evaluates the law of a spring at an opening [m]; gives its tangent stiffness [N/m²].
    fn evaluate_spring(&mut self, model: &Model, index: usize, opening: [f64; 2]) -> [[f64; 2]; 2] {
        let spring = &model.springs[index];
        let answer = model.joints[spring.kind].respond(opening, spring.area, &self.committed.history.bond.memory);
        self.trial.bond = Bond { memory: answer.memory, traction: answer.traction, opening, state: answer.state };
        answer.tangent.map(|row| row.map(|entry| spring.area * entry))
    }

    /// Gives the tension of an unbroken spring by the last evaluation, over its strength; 0 for quadrilaterals.
    pub(super) fn overstress(&self, model: &Model) -> f64 {
        let Kind::Spring(index) = self.kind else { return 0.0 };
        let spring = &model.springs[index];
        model.joints[spring.kind].overstress(
            self.trial.bond.traction[0],
            spring.area,
            &self.committed.history.bond.memory,
        )
    }

    /// Marks the spring as broken in the committed history.
    pub(super) fn break_spring(&mut self) {
        self.committed.history.bond.memory.broken = true;
    }

    /// Gives the force of the part [N/m] and its tangent stiffness [N/m²] at given row values [m].
    fn force_and_tangent(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<([f64; ROWS], [[f64; ROWS]; ROWS])> {
        match self.kind {
            Kind::Quad(id) => {
                self.trial.modes = self.committed.history.modes;
                let from = self.committed.history.modes;
                let kept = Kept { points: &mut self.trial.points, modes: &mut self.trial.modes, from, misses: &mut 0 };
                let (solid, modes) = (&model.section(id).solid, model.incompatible(id));
                let answer = element::respond(solid, modes, &self.samples, at, &self.committed.history.points, kept)?;
                Some((answer.force, answer.tangent))
            }
            Kind::Spring(index) => {
                let stiffness = self.evaluate_spring(model, index, [at[0], at[1]]);
                let (mut force, mut tangent) = ([0.0; ROWS], [[0.0; ROWS]; ROWS]);
                for i in 0..2 {
                    force[i] = model.springs[index].area * self.trial.bond.traction[i];
                    tangent[i][..2].copy_from_slice(&stiffness[i]);
                }
                Some((force, tangent))
            }
        }
    }

    /// Calls `push` with each entry of the excess stiffness between retained rows: row, column, derivative [N/m²].
    pub(super) fn for_each_stiffness_entry(&self, mut push: impl FnMut(usize, usize, f64)) {
        for i in 0..ROWS {
            for j in 0..ROWS {
                if let (Some(p), Some(q), true) = (self.rows[i], self.rows[j], self.excess_stiffness[i][j] != 0.0) {
                    push(p, q, self.excess_stiffness[i][j]);
                }
            }
        }
    }

    /// Whether the excess force is larger than rounding.
    pub(super) fn has_excess(&self) -> bool {
        // Rounding of the difference of two equal forces.
        const ROUNDING: f64 = 1e-13;
        let size = |i: usize| self.stiffness[i][i].abs();
        let scale = (0..ROWS).map(size).fold(0.0, f64::max);
        let most = self.excess.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        let displaced = self.base.iter().fold(1e-3_f64, |most, h| most.max(h.abs()));
        most > ROUNDING * scale * displaced
    }

    /// Whether the linear system is wrong for this part by the last evaluation: it has an excess force, its history changes, or
    /// it is beyond its strength.
    pub(super) fn needs_retaining(&self, model: &Model) -> bool {
        let points = self.trial.points.iter().zip(&self.committed.history.points);
        !self.linear
            && (self.has_excess()
                || self.overstress(model) > 1.0
                || self.trial.bond.memory != self.committed.history.bond.memory
                || points.into_iter().any(|(new, old)| new.memory != old.memory))
    }

    /// Restores the state in which the run began.
    pub(super) fn revert_to_start(&mut self, state: &State) {
        self.committed = Committed::at_start(self.kind, state);
    }

    /// Commits the last evaluation; gives the state before, where it was another one.
    pub(super) fn commit(&mut self) -> Option<Committed> {
        if self.linear && self.committed.linear {
            return None;
        }
        let before = self.committed;
        self.committed = Committed { history: self.trial, excess: self.excess, linear: self.linear };
        Some(before)
    }

    /// Gives the change of the excess force since it was last committed [N/m].
    pub(super) fn excess_change(&self) -> [f64; ROWS] {
        std::array::from_fn(|i| self.excess[i] - self.committed.excess[i])
    }

    /// Gives the pointwise test of a quadrilateral without incompatible modes.
    pub(super) fn quad_check<'a>(&'a self, model: &'a Model) -> Option<QuadCheck<'a>> {
        let Kind::Quad(id) = self.kind else { return None };
        let (solid, points) = (&model.section(id).solid, &self.committed.history.points);
        let quad = QuadCheck { solid, samples: &self.samples, points, base: &self.base, equations: &self.equations };
        (!model.incompatible(id)).then_some(quad)
    }

    /// Gives equations and weights of a spring's two openings.
    pub(super) fn openings(&self) -> [&[(u32, f64)]; 2] {
        self.openings.each_ref().map(Vec::as_slice)
    }

    /// Gives the test of a spring whose stiffness in the linear system is that of its law while closed.
    pub(super) fn spring_check(&self, model: &Model) -> Option<SpringCheck> {
        let Kind::Spring(index) = self.kind else { return None };
        let (kind, area) = (model.springs[index].kind, model.springs[index].area);
        let [normal, tangential] = model.joints[kind].stiffness().map(|stiffness| area * stiffness);
        let closed = [[normal, 0.0], [0.0, tangential]];
        let linear = (0..2).all(|i| (0..2).all(|j| self.stiffness[i][j] == closed[i][j]));
        let (memory, base) = (self.committed.history.bond.memory, [self.base[0], self.base[1]]);
        linear.then_some(SpringCheck { kind: kind as u32, area, memory, base })
    }

    /// Whether the part is provably linear in all of the first solutions of `block`, with the memory it has now. `false` proves
    /// nothing: the law has to be evaluated.
    pub(super) fn proves_linear(&self, model: &Model, block: &Block, solutions: usize) -> bool {
        wide(
            #[inline(always)]
            || match self.quad_check(model) {
                Some(quad) => quad.proves_linear(block, solutions),
                None => self
                    .spring_check(model)
                    .is_some_and(|spring| spring.proves_linear(model, self.openings(), block, solutions)),
            },
        )
    }

    /// Whether the part is provably linear at both row values that `value` gives for a row, and was linear when last committed.
    /// Its excess force is then the committed one. `false` proves nothing: the law has to be evaluated.
    #[inline]
    pub(super) fn proves_linear_at(&mut self, model: &Model, value: impl Fn(usize) -> [f64; 2]) -> bool {
        let at = std::array::from_fn(|i| self.rows[i].map_or([self.base[i]; 2], &value));
        let linear = self.committed.linear
            && match self.quad_check(model) {
                Some(quad) => quad.proves_linear_at(&at),
                None => self.spring_check(model).is_some_and(|SpringCheck { kind, area, memory, .. }| {
                    model.joints[kind as usize].provably_linear(&[at[0], at[1]], area, &memory)
                }),
            };
        if linear {
            (self.linear, self.excess) = (true, self.committed.excess);
        }
        linear
    }

    /// Writes the part to a state: the trial history where the part is linear, the committed one where it is not.
    pub(super) fn write_to(&self, state: &mut State) {
        let now = if self.linear { &self.trial } else { &self.committed.history };
        match self.kind {
            Kind::Spring(index) => state.bonds[index] = now.bond,
            Kind::Quad(id) => {
                state.points[4 * id.index()..4 * id.index() + 4].copy_from_slice(&now.points);
                state.modes[id.index()] = now.modes;
            }
        }
    }

    /// Whether the part is a plain quadrilateral all of whose points yield.
    pub(super) fn locks(&self, model: &Model) -> bool {
        matches!(self.kind, Kind::Quad(id) if model.may_lock(id))
            && self.committed.history.points.iter().all(|point| point.yields)
    }
}
