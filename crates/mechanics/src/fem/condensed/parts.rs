//! The parts that are not linear: springs of interfaces and quadrilaterals that may yield. Each answers what it carries less than the
//! linear system lets it carry.

use crate::fem::assemble::moved;
use crate::fem::element::{self, Kept, Sample, sample};
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
    /// Rows by number, `None` where a component is held.
    pub rows: [Option<usize>; ROWS],
    /// Stiffness with which it stands in the linear system.
    stiffness: [[f64; ROWS]; ROWS],
    /// Values of held components: they do not change.
    held: [f64; ROWS],
    samples: Option<[Sample; 4]>,
    old: Kept4,
    new: Kept4,
    /// What the linear system carried too much when the run began, when the part was last kept, and what it does now [N/m].
    start: [f64; ROWS],
    kept: [f64; ROWS],
    pub excess: [f64; ROWS],
    /// Derivatives of `excess` by the rows, while the part is not still.
    pub slope: [[f64; ROWS]; ROWS],
    /// Whether it answers linearly from what it remembers: its excess is then the one that was kept, to the bit.
    pub still: bool,
}

/// What a part was when it was last kept.
#[derive(Debug, Clone, Copy)]
pub(super) struct Remembered {
    old: Kept4,
    kept: [f64; ROWS],
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
    pub fn spring(model: &Model, state: &State, index: usize, rows: [usize; 2]) -> Part {
        let spring = &model.springs()[index];
        let virgin = model.joints[spring.kind].respond([0.0; 2], spring.area, &PairMemory::default());
        let mut part = Part::blank(Kind::Spring(index));
        for i in 0..2 {
            part.rows[i] = Some(rows[i]);
            for j in 0..2 {
                part.stiffness[i][j] = spring.area * virgin.tangent[i][j];
            }
        }
        part.old.bond = state.bonds[index];
        part
    }

    /// A quadrilateral as it stands in `state`; `None` where it has no linear stiffness.
    pub fn quad(model: &Model, state: &State, id: QuadId, rows: [Option<usize>; ROWS]) -> Option<Part> {
        let mut part = Part::blank(Kind::Quad(id));
        part.rows = rows;
        let samples = sample(&model.corners(id));
        let mut scratch = Kept4::default();
        let kept = Kept { points: &mut scratch.points, modes: &mut scratch.modes };
        let virgin = [Point::default(); 4];
        let (solid, modes) = (&model.section(id).solid, model.incompatible(id));
        part.stiffness = element::respond(solid, modes, &samples, &[0.0; 8], &virgin, kept)?.tangent;
        part.held = moved(&state.displacements, &model.mesh.quads[id].nodes);
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
            stiffness: [[0.0; ROWS]; ROWS],
            held: [0.0; ROWS],
            samples: None,
            old: Kept4::default(),
            new: Kept4::default(),
            start: [0.0; ROWS],
            kept: [0.0; ROWS],
            excess: [0.0; ROWS],
            slope: [[0.0; ROWS]; ROWS],
            still: true,
        }
    }

    /// Takes what it answers at these values of the rows as what was there when the run began.
    pub fn begin(&mut self, model: &Model, value: impl Fn(usize) -> f64) -> Option<()> {
        let at = self.at(value);
        self.start = [0.0; ROWS];
        self.answer_in_full(model, &at)?;
        self.start = self.excess;
        self.excess = [0.0; ROWS];
        Some(())
    }

    /// What the linear system carries too much at these values of the rows, beyond what it did when the run began.
    pub fn answer(&mut self, model: &Model, value: impl Fn(usize) -> f64) -> Option<()> {
        let at = self.at(value);
        self.still = self.is_still(model, &at);
        if self.still {
            self.excess = self.kept;
            return Some(());
        }
        self.answer_in_full(model, &at)
    }

    fn at(&self, value: impl Fn(usize) -> f64) -> [f64; ROWS] {
        std::array::from_fn(|i| self.rows[i].map_or(self.held[i], &value))
    }

    /// Looks whether the part remembers nothing new and resists as the linear system does; keeps stress and traction if so.
    fn is_still(&mut self, model: &Model, at: &[f64; ROWS]) -> bool {
        match (self.kind, &self.samples) {
            (Kind::Quad(id), Some(samples)) => {
                let solid = &model.section(id).solid;
                !model.incompatible(id) && element::still(solid, samples, at, &self.old.points, &mut self.new.points)
            }
            (Kind::Spring(index), _) => {
                let tangent = self.pull(model, index, [at[0], at[1]]);
                let linear = (0..2).all(|i| (0..2).all(|j| tangent[i][j] == self.stiffness[i][j]));
                linear && self.new.bond.memory == self.old.bond.memory
            }
            (Kind::Quad(_), None) => false,
        }
    }

    fn answer_in_full(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<()> {
        let (force, tangent) = self.carries(model, at)?;
        for i in 0..ROWS {
            let mut linear = 0.0;
            for j in 0..ROWS {
                linear += self.stiffness[i][j] * at[j];
                self.slope[i][j] = self.stiffness[i][j] - tangent[i][j];
            }
            self.excess[i] = linear - force[i] - self.start[i];
        }
        self.still = false;
        Some(())
    }

    /// Opens a spring; gives its tangent.
    fn pull(&mut self, model: &Model, index: usize, opening: [f64; 2]) -> [[f64; 2]; 2] {
        let spring = &model.springs()[index];
        let answer = model.joints[spring.kind].respond(opening, spring.area, &self.old.bond.memory);
        self.new.bond = Bond { memory: answer.memory, traction: answer.traction, opening, state: answer.state };
        answer.tangent.map(|row| row.map(|entry| spring.area * entry))
    }

    fn carries(&mut self, model: &Model, at: &[f64; ROWS]) -> Option<([f64; ROWS], [[f64; ROWS]; ROWS])> {
        match (self.kind, &self.samples) {
            (Kind::Quad(id), Some(samples)) => {
                self.new.modes = self.old.modes;
                let kept = Kept { points: &mut self.new.points, modes: &mut self.new.modes };
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

    /// Whether it carries anything else than the linear system lets it carry.
    pub fn differs(&self) -> bool {
        // What rounding leaves of a difference of two equal forces.
        const ROUNDING: f64 = 1e-13;
        let size = |i: usize| self.stiffness[i][i].abs();
        let scale = (0..ROWS).map(size).fold(0.0, f64::max);
        let most = self.excess.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        let displaced = self.held.iter().fold(1e-3_f64, |most, h| most.max(h.abs()));
        most > ROUNDING * scale * displaced
    }

    /// Remembers what the state remembers in which the run began.
    pub fn restart(&mut self, state: &State) {
        self.kept = [0.0; ROWS];
        match self.kind {
            Kind::Spring(index) => self.old.bond = state.bonds[index],
            Kind::Quad(id) => {
                let first = 4 * id.index();
                self.old.points.copy_from_slice(&state.points[first..first + 4]);
                self.old.modes = state.modes[id.index()];
            }
        }
    }

    /// Keeps what it answered last.
    pub fn keep(&mut self) {
        self.old = self.new;
        self.kept = self.excess;
    }

    /// What it would take to come back.
    pub fn remembered(&self) -> Remembered {
        Remembered { old: self.old, kept: self.kept }
    }

    /// Comes back.
    pub fn recall(&mut self, remembered: &Remembered) {
        (self.old, self.kept) = (remembered.old, remembered.kept);
    }

    /// Writes what it remembers into a state.
    pub fn write(&self, state: &mut State) {
        match self.kind {
            Kind::Spring(index) => state.bonds[index] = self.old.bond,
            Kind::Quad(id) => {
                state.points[4 * id.index()..4 * id.index() + 4].copy_from_slice(&self.old.points);
                state.modes[id.index()] = self.old.modes;
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
}
