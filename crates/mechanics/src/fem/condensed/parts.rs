//! The parts that are not linear: springs of interfaces and quadrilaterals that may yield. Each answers what it carries less than the
//! linear system lets it carry.

use super::quad_check::QuadCheck;
use super::rows::widest;
use super::spring_check::SpringCheck;
use crate::fem::assemble::moved;
use crate::fem::dofs::{HELD, dof};
use crate::fem::element::{self, Kept, Sample, sample};
use crate::fem::factor::Block;
use crate::fem::joint::{PairLaw, PairMemory};
use crate::fem::model::Model;
use crate::fem::state::{Bond, Point, State};
use crate::ids::{Id, QuadId};

/// Most rows of a part: the components of a quadrilateral.
pub(super) const ROWS: usize = 8;

/// Which part of the model it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A spring of [`Model::springs`]: its rows are normal and tangential opening.
    Spring(usize),
    /// A quadrilateral: its rows are the components of its corners.
    Quad(QuadId),
}

/// A part, what it remembers, and what it answers now.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub kind: Kind,
    /// Rows by number, `None` where a component is held and while the part is not active.
    pub rows: [Option<usize>; ROWS],
    /// Equations that the openings of a spring read, with their weights.
    openings: [Vec<(u32, f64)>; 2],
    /// Equations of a quadrilateral's components.
    equations: [u32; ROWS],
    /// Stiffness with which it stands in the linear system.
    stiffness: [[f64; ROWS]; ROWS],
    /// Largest entry of that.
    pub stiffest: f64,
    /// Values of its rows when the run began: those of held components do not change.
    base: [f64; ROWS],
    samples: Option<[Sample; 4]>,
    old: Kept4,
    new: Kept4,
    /// What the linear system carried too much when the run began, when the part was last kept, and what it does now [N/m].
    start: [f64; ROWS],
    kept: [f64; ROWS],
    pub excess: [f64; ROWS],
    /// Derivatives of `excess` by the rows, while the part is not still.
    pub slope: [[f64; ROWS]; ROWS],
    /// Whether the part is linear at the values given last: its excess force is then the committed one, to the bit.
    pub linear: bool,
    /// Whether it was linear when it was last committed.
    committed_linear: bool,
}

/// Components of a quadrilateral's corners.
pub(super) fn components(model: &Model, id: QuadId) -> [usize; ROWS] {
    let nodes = model.mesh.quads[id].nodes;
    std::array::from_fn(|i| dof(nodes[i / 2], i % 2))
}

/// A sum of components on the equations: those that are held have none.
fn free(model: &Model, terms: &[(usize, f64)]) -> Vec<(u32, f64)> {
    let equation = |&(component, weight): &(usize, f64)| (model.dofs().equation(component), weight);
    terms.iter().map(equation).filter(|(equation, _)| *equation != HELD).collect()
}

/// What a part was when it was last kept.
#[derive(Debug, Clone, Copy)]
pub(super) struct Remembered {
    old: Kept4,
    kept: [f64; ROWS],
    committed_linear: bool,
}

/// What a part remembers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Kept4 {
    points: [Point; 4],
    modes: [f64; 4],
    bond: Bond,
}

impl Part {
    /// A spring as it stands in `state`.
    pub fn spring(model: &Model, state: &State, index: usize) -> Part {
        let spring = &model.springs()[index];
        let virgin = model.joints[spring.kind].respond([0.0; 2], spring.area, &PairMemory::default());
        let mut part = Part::blank(Kind::Spring(index));
        for (i, opening) in spring.openings().into_iter().enumerate() {
            part.base[i] = opening.iter().map(|&(component, weight)| weight * state.displacements[component]).sum();
            part.openings[i] = free(model, &opening);
            for j in 0..2 {
                part.stiffness[i][j] = spring.area * virgin.tangent[i][j];
            }
        }
        part.old.bond = state.bonds[index];
        part
    }

    /// A quadrilateral as it stands in `state`; `None` where it has no linear stiffness.
    pub fn quad(model: &Model, state: &State, id: QuadId) -> Option<Part> {
        let mut part = Part::blank(Kind::Quad(id));
        part.equations = components(model, id).map(|component| model.dofs().equation(component));
        let samples = sample(&model.corners(id));
        let mut scratch = Kept4::default();
        let from = scratch.modes;
        let kept = Kept { points: &mut scratch.points, modes: &mut scratch.modes, from, misses: &mut 0 };
        let virgin = [Point::default(); 4];
        let (solid, modes) = (&model.section(id).solid, model.incompatible(id));
        part.stiffness = element::respond(solid, modes, &samples, &[0.0; 8], &virgin, kept)?.tangent;
        part.base = moved(&state.displacements, &model.mesh.quads[id].nodes);
        let first = 4 * id.index();
        part.old.points.copy_from_slice(&state.points[first..first + 4]);
        part.old.modes = state.modes[id.index()];
        part.samples = Some(samples);
        Some(part)
    }

    fn blank(kind: Kind) -> Part {
        Part {
            kind,
            rows: [None; ROWS],
            openings: Default::default(),
            equations: [HELD; ROWS],
            stiffness: [[0.0; ROWS]; ROWS],
            stiffest: 0.0,
            base: [0.0; ROWS],
            samples: None,
            old: Kept4::default(),
            new: Kept4::default(),
            start: [0.0; ROWS],
            kept: [0.0; ROWS],
            excess: [0.0; ROWS],
            slope: [[0.0; ROWS]; ROWS],
            linear: true,
            committed_linear: true,
        }
    }

    /// Takes what it answers in the state in which the run begins as what was there then.
    pub fn begin(&mut self, model: &Model) -> Option<()> {
        let at = self.base;
        self.start = [0.0; ROWS];
        self.answer_in_full(model, &at)?;
        self.start = self.excess;
        self.stiffest = self.stiffness.iter().flatten().fold(0.0, |most, entry| most.max(entry.abs()));
        self.excess = [0.0; ROWS];
        Some(())
    }

    /// What the linear system carries too much at these values of the rows, beyond what it did when the run began.
    #[inline]
    pub fn answer(&mut self, model: &Model, value: impl Fn(usize) -> f64) -> Option<()> {
        let at = std::array::from_fn(|i| self.rows[i].map_or(self.base[i], &value));
        self.answer_at(model, &at)
    }

    /// Whether it would answer linearly at these values of the rows. What it answered last is no longer at hand.
    pub fn is_linear_at(&mut self, model: &Model, value: impl Fn(usize) -> f64) -> bool {
        let at = std::array::from_fn(|i| self.rows[i].map_or(self.base[i], &value));
        self.is_linear_from(model, &at)
    }

    fn answer_at(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<()> {
        self.linear = self.is_linear_from(model, at);
        if self.linear {
            self.excess = self.kept;
            return Some(());
        }
        self.answer_in_full(model, at)
    }

    /// The same for one of many solutions of the linear system, whether the part is active or not.
    pub fn answer_in(&mut self, model: &Model, block: &Block, lane: usize) -> Option<()> {
        let mut at = self.base;
        for (at, opening) in at.iter_mut().zip(&self.openings) {
            *at += opening.iter().map(|&(equation, weight)| weight * block.of(equation)[lane]).sum::<f64>();
        }
        for (at, &equation) in at.iter_mut().zip(&self.equations).filter(|(_, equation)| **equation != HELD) {
            *at += block.of(equation)[lane];
        }
        self.answer_at(model, &at)
    }

    /// Looks whether the part remembers nothing new and resists as the linear system does; keeps stress and traction if so.
    fn is_linear_from(&mut self, model: &Model, at: &[f64; ROWS]) -> bool {
        match (self.kind, &self.samples) {
            (Kind::Quad(id), Some(samples)) => {
                let solid = &model.section(id).solid;
                !model.incompatible(id)
                    && element::is_linear(solid, samples, at, &self.old.points, &mut self.new.points)
            }
            (Kind::Spring(index), _) => {
                let tangent = self.pull(model, index, [at[0], at[1]]);
                let linear = (0..2).all(|i| (0..2).all(|j| tangent[i][j] == self.stiffness[i][j]));
                linear && self.new.bond.memory == self.old.bond.memory && self.overstress(model) <= 1.0
            }
            (Kind::Quad(_), None) => false,
        }
    }

    fn answer_in_full(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<()> {
        let (force, tangent) = self.carries(model, at)?;
        for i in 0..ROWS {
            let mut linear_force = 0.0;
            for j in 0..ROWS {
                linear_force += self.stiffness[i][j] * at[j];
                self.slope[i][j] = self.stiffness[i][j] - tangent[i][j];
            }
            self.excess[i] = linear_force - force[i] - self.start[i];
        }
        self.linear = false;
        Some(())
    }

    /// Opens a spring; gives its tangent.
    fn pull(&mut self, model: &Model, index: usize, opening: [f64; 2]) -> [[f64; 2]; 2] {
        let spring = &model.springs()[index];
        let answer = model.joints[spring.kind].respond(opening, spring.area, &self.old.bond.memory);
        self.new.bond = Bond { memory: answer.memory, traction: answer.traction, opening, state: answer.state };
        answer.tangent.map(|row| row.map(|entry| spring.area * entry))
    }

    /// Tension of a spring that is whole over its strength, as it answered last.
    pub fn overstress(&self, model: &Model) -> f64 {
        let Kind::Spring(index) = self.kind else { return 0.0 };
        let spring = &model.springs()[index];
        model.joints[spring.kind].overstress(self.new.bond.traction[0], spring.area, &self.old.bond.memory)
    }

    /// The spring is whole no longer.
    pub fn let_go(&mut self) {
        self.old.bond.memory.broken = true;
    }

    fn carries(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<([f64; ROWS], [[f64; ROWS]; ROWS])> {
        match (self.kind, &self.samples) {
            (Kind::Quad(id), Some(samples)) => {
                self.new.modes = self.old.modes;
                let from = self.old.modes;
                let kept = Kept { points: &mut self.new.points, modes: &mut self.new.modes, from, misses: &mut 0 };
                let (solid, modes) = (&model.section(id).solid, model.incompatible(id));
                let answer = element::respond(solid, modes, samples, at, &self.old.points, kept)?;
                Some((answer.force, answer.tangent))
            }
            (Kind::Spring(index), _) => {
                let pulled = self.pull(model, index, [at[0], at[1]]);
                let (mut force, mut tangent) = ([0.0; ROWS], [[0.0; ROWS]; ROWS]);
                for i in 0..2 {
                    force[i] = model.springs()[index].area * self.new.bond.traction[i];
                    tangent[i][..2].copy_from_slice(&pulled[i]);
                }
                Some((force, tangent))
            }
            (Kind::Quad(_), None) => None,
        }
    }

    /// Entries of its slope between active rows: row, column, derivative.
    pub fn slopes(&self, mut push: impl FnMut(usize, usize, f64)) {
        for i in 0..ROWS {
            for j in 0..ROWS {
                if let (Some(p), Some(q), true) = (self.rows[i], self.rows[j], self.slope[i][j] != 0.0) {
                    push(p, q, self.slope[i][j]);
                }
            }
        }
    }

    /// Whether it carries anything else than the linear system lets it carry.
    pub fn differs(&self) -> bool {
        // What rounding leaves of a difference of two equal forces.
        const ROUNDING: f64 = 1e-13;
        let size = |i: usize| self.stiffness[i][i].abs();
        let scale = (0..ROWS).map(size).fold(0.0, f64::max);
        let most = self.excess.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        let displaced = self.base.iter().fold(1e-3_f64, |most, h| most.max(h.abs()));
        most > ROUNDING * scale * displaced
    }

    /// Whether it answers otherwise than it did when the run began, would remember something new, or is beyond its strength.
    pub fn changes(&self, model: &Model) -> bool {
        let points = self.new.points.iter().zip(&self.old.points);
        !self.linear
            && (self.differs()
                || self.overstress(model) > 1.0
                || self.new.bond.memory != self.old.bond.memory
                || points.into_iter().any(|(new, old)| new.memory != old.memory))
    }

    /// Remembers what the state remembers in which the run began.
    pub fn restart(&mut self, state: &State) {
        self.kept = [0.0; ROWS];
        self.committed_linear = true;
        match self.kind {
            Kind::Spring(index) => self.old.bond = state.bonds[index],
            Kind::Quad(id) => {
                let first = 4 * id.index();
                self.old.points.copy_from_slice(&state.points[first..first + 4]);
                self.old.modes = state.modes[id.index()];
            }
        }
    }

    /// Keeps what it answered last; gives what it was, where that is something else.
    pub fn keep(&mut self) -> Option<Remembered> {
        if self.linear && self.committed_linear {
            return None;
        }
        let before = self.remembered();
        self.old = self.new;
        self.kept = self.excess;
        self.committed_linear = self.linear;
        Some(before)
    }

    /// How its excess has changed since it was last kept.
    pub fn change(&self) -> [f64; ROWS] {
        std::array::from_fn(|i| self.excess[i] - self.kept[i])
    }

    /// Gives the pointwise test of a quadrilateral without incompatible modes.
    pub fn quad_check<'a>(&'a self, model: &'a Model) -> Option<QuadCheck<'a>> {
        let (Kind::Quad(id), Some(samples)) = (self.kind, &self.samples) else { return None };
        let (solid, points) = (&model.section(id).solid, &self.old.points);
        let quad = QuadCheck { solid, samples, points, base: &self.base, equations: &self.equations };
        (!model.incompatible(id)).then_some(quad)
    }

    /// Gives the test of a spring whose stiffness in the linear system is that of its law while closed, and the number of that
    /// law.
    pub fn spring_check<'a>(&'a self, model: &'a Model) -> Option<(usize, SpringCheck<'a>)> {
        let Kind::Spring(index) = self.kind else { return None };
        let (kind, area) = (model.springs()[index].kind, model.springs()[index].area);
        let law = &model.joints[kind];
        let [normal, tangential] = law.stiffness().map(|stiffness| area * stiffness);
        let closed = [[normal, 0.0], [0.0, tangential]];
        let linear = (0..2).all(|i| (0..2).all(|j| self.stiffness[i][j] == closed[i][j]));
        let openings = [self.openings[0].as_slice(), self.openings[1].as_slice()];
        let spring =
            SpringCheck { law, area, memory: &self.old.bond.memory, base: [self.base[0], self.base[1]], openings };
        linear.then_some((kind, spring))
    }

    /// Whether the part is provably linear in all of the first solutions of `block`, with the memory it has now. `false` proves
    /// nothing: the law has to be evaluated.
    pub fn proves_linear(&self, model: &Model, block: &Block, lanes: usize) -> bool {
        struct Wide<'a>(&'a Part, &'a Model, &'a Block, usize);
        impl pulp::NullaryFnOnce for Wide<'_> {
            type Output = bool;
            #[inline(always)]
            fn call(self) -> bool {
                let Wide(part, model, block, lanes) = self;
                if let Some(quad) = part.quad_check(model) {
                    return quad.proves_linear(block, lanes);
                }
                part.spring_check(model).is_some_and(|(_, spring)| spring.proves_linear(block, lanes))
            }
        }
        widest(Wide(self, model, block, lanes))
    }

    /// Whether the part is provably linear at both row values that `value` gives for a row, and was linear when last committed.
    /// Its excess force is then the committed one. `false` proves nothing: the law has to be evaluated.
    #[inline]
    pub fn proves_linear_at(&mut self, model: &Model, value: impl Fn(usize) -> [f64; 2]) -> bool {
        let at = std::array::from_fn(|i| self.rows[i].map_or([self.base[i]; 2], &value));
        let linear = self.committed_linear
            && match self.quad_check(model) {
                Some(quad) => quad.proves_linear_at(&at),
                None => self
                    .spring_check(model)
                    .is_some_and(|(_, spring)| spring.law.provably_linear(&[at[0], at[1]], spring.area, spring.memory)),
            };
        if linear {
            (self.linear, self.excess) = (true, self.kept);
        }
        linear
    }

    /// What it would take to come back.
    pub fn remembered(&self) -> Remembered {
        Remembered { old: self.old, kept: self.kept, committed_linear: self.committed_linear }
    }

    /// Comes back.
    pub fn recall(&mut self, remembered: &Remembered) {
        (self.old, self.kept, self.committed_linear) = (remembered.old, remembered.kept, remembered.committed_linear);
    }

    /// Writes into a state what it answered last, or what was kept of it where it does not answer linearly.
    pub fn write(&self, state: &mut State) {
        let now = if self.linear { &self.new } else { &self.old };
        match self.kind {
            Kind::Spring(index) => state.bonds[index] = now.bond,
            Kind::Quad(id) => {
                state.points[4 * id.index()..4 * id.index() + 4].copy_from_slice(&now.points);
                state.modes[id.index()] = now.modes;
            }
        }
    }

    /// The pair of a spring, as it was kept.
    pub fn bond(&self) -> Option<&Bond> {
        matches!(self.kind, Kind::Spring(_)).then_some(&self.old.bond)
    }

    /// Points that flow, as they were kept.
    pub fn yielding(&self) -> usize {
        match self.kind {
            Kind::Quad(_) => self.old.points.iter().filter(|point| point.yields).count(),
            Kind::Spring(_) => 0,
        }
    }

    /// Whether it is a plain quadrilateral all of whose points flow.
    pub fn locks(&self, model: &Model) -> bool {
        matches!(self.kind, Kind::Quad(id) if model.may_lock(id)) && self.old.points.iter().all(|point| point.yields)
    }
}
