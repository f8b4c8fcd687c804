//! Many load positions on one bridge: everything linear is solved once, and only what is not linear iterates.
//!
//! Write the stiffness of the untouched model, joints closed and solids elastic, as `K`. Whatever springs and solids carry less than
//! `K` lets them carry is an *excess*, a force that depends on few displacements, the *rows* `n_r`: openings of springs, corners of
//! quadrilaterals. Balance is then (docs/theory/condensed.md, equation 2)
//!
//! ```text
//! u = K^-1 (f + sum_r n_r g_r(u)),   so that on the rows   v_r = v_r0 + sum_l H_rl a_l + sum_s G_rs g_s(v),   G_rs = n_r K^-1 n_s
//! ```
//!
//! with load patterns `l` of amplitude `a_l`. `H` costs one solution a pattern and `G` one a row whose excess ever changes; each is
//! found when it is first needed and serves all positions. The equations are those of the whole mesh: nothing is approximated.

mod foresight;
mod loads;
mod newton;
mod parts;
mod passage;
mod rows;
mod system;

use super::dofs::{HELD, dof};
use super::element::Kept;
use super::factor::FactorError;
use super::joint::PairState;
use super::model::{Model, count};
use super::settings::Kinematics;
use super::state::{Bond, Point, State};
use super::workspace::Workspace;
use super::{assemble, element};
use crate::ids::{Id, QuadId};
use loads::Load;
use parts::{Kind, Part, ROWS, Remembered};
use rows::Rows;
use system::System;

pub use passage::{Passage, Visited};
pub use rows::Functional;

/// How one position ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reached {
    /// Balanced.
    Balanced,
    /// No balance was found.
    NotConverged,
}

/// What one position took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// How it ended.
    pub reached: Reached,
    /// Iterations of Newton's method.
    pub iterations: u32,
    /// Largest change that is left in a row over the largest value of a row.
    pub left: f64,
}

/// Counts of what is not linear now.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Springs that are open.
    pub open: usize,
    /// Interfaces that are open somewhere.
    pub open_interfaces: usize,
    /// Springs that slide.
    pub sliding: usize,
    /// Points that flow.
    pub yielding: usize,
    /// Rows on which forces act that the linear system does not know.
    pub active_rows: usize,
    /// Quadrilaterals that are looked at in each position.
    pub watched_quads: usize,
}

/// Largest change left in a row, over the largest value of a row, at which a position counts as balanced.
pub const TOLERANCE: f64 = 1e-10;

/// Iterations allowed in one position.
const ITERATIONS: u32 = 60;

/// A model around one state, ready for many load positions.
#[derive(Debug)]
pub struct Condensed<'a> {
    model: &'a Model,
    work: Workspace,
    /// The state in which the run began.
    start: State,
    rows: Rows,
    /// Forces of the patterns on the equations.
    patterns: Vec<Vec<f64>>,
    /// Row of a component, where it has one.
    row_of: Vec<Option<usize>>,
    parts: Vec<Part>,
    /// Part of a quadrilateral, where it is watched.
    part_of: Vec<Option<usize>>,
    /// Quadrilaterals at each node that might flow.
    around: Vec<Vec<QuadId>>,
    /// Parts whose excess differs or differed from that of the start.
    active: Vec<usize>,
    is_active: Vec<bool>,
    observed: Vec<usize>,
    system: System,
    /// Loads of the last position.
    load: Load,
    /// Forces on the columns' rows, and the excess that was found last.
    forces: Vec<f64>,
    excess: Vec<f64>,
    /// Most that loads have moved a row of the linear system so far [m].
    most_moved: f64,
    /// Values of the active rows while they are sought, in their order.
    values: Vec<f64>,
    /// Multiple of what the loads do to it at which a quadrilateral that would flow is watched.
    foresight: f64,
}

impl<'a> Condensed<'a> {
    /// Factorises the linear system of a model at small displacements and solves it for the patterns (forces on all components
    /// [N/m]). `start` must be balanced; loads come on top of those it carries.
    pub fn new(
        model: &'a Model,
        start: State,
        patterns: &[Vec<f64>],
        observed: &[Functional],
    ) -> Result<Condensed<'a>, CondensedError> {
        if model.kinematics != Kinematics::Small {
            return Err(CondensedError::LargeDisplacements);
        }
        let mut work = Workspace::new(model)?;
        work.stiffness(model, &State::new(model))?;
        work.factorise()?;
        let free = model.dofs().free();
        let right: Vec<Vec<f64>> = patterns.iter().map(|p| free.iter().map(|c| p[*c as usize]).collect()).collect();
        let loads = work.solve_many(right.clone());
        let mut condensed = Condensed {
            rows: Rows::new(loads),
            patterns: right,
            row_of: vec![None; model.dofs().count()],
            parts: Vec::new(),
            part_of: vec![None; model.mesh.quads.len()],
            around: foresight::around(model),
            active: Vec::new(),
            is_active: Vec::new(),
            observed: Vec::new(),
            system: System::default(),
            load: Load::none(patterns.len(), 0),
            forces: Vec::new(),
            excess: Vec::new(),
            most_moved: 0.0,
            values: Vec::new(),
            foresight: foresight::FORESIGHT,
            model,
            work,
            start,
        };
        for functional in observed {
            let row = condensed.row(functional);
            condensed.observed.push(row);
        }
        for index in 0..model.springs().len() {
            let rows = model.springs()[index].openings().map(|terms| condensed.row(&Functional(terms)));
            let part = Part::spring(model, &condensed.start, index, rows);
            condensed.watch(part)?;
        }
        for (id, _) in model.mesh.quads.pairs() {
            let first = 4 * id.index();
            if condensed.start.points[first..first + 4].iter().any(|point| point.yields) {
                condensed.watch_quad(id)?;
            }
        }
        Ok(condensed)
    }

    /// Watches quadrilaterals that would flow at another multiple of what the loads do to them than two. The results are the same:
    /// one that was missed is found by the next look, and the way is gone again.
    #[must_use]
    pub fn with_foresight(mut self, multiple: f64) -> Condensed<'a> {
        self.foresight = multiple;
        self
    }

    fn row(&mut self, functional: &Functional) -> usize {
        let row = self.rows.push(self.model, functional, &self.start.displacements);
        self.load.complete(&self.rows);
        row
    }

    fn row_of(&mut self, component: usize) -> Option<usize> {
        if self.model.dofs().equation(component) == HELD {
            return None;
        }
        if self.row_of[component].is_none() {
            self.row_of[component] = Some(self.row(&Functional(vec![(component, 1.0)])));
        }
        self.row_of[component]
    }

    /// Watches a part from now on; what it remembers is what it remembered at the start.
    fn watch(&mut self, mut part: Part) -> Result<(), CondensedError> {
        let rows = &self.rows;
        part.begin(self.model, |row| rows[row].start).ok_or(CondensedError::Broken)?;
        self.parts.push(part);
        self.is_active.push(false);
        Ok(())
    }

    fn watch_quad(&mut self, id: QuadId) -> Result<(), CondensedError> {
        if self.part_of[id.index()].is_some() {
            return Ok(());
        }
        let nodes = self.model.mesh.quads[id].nodes;
        let rows: [Option<usize>; ROWS] = std::array::from_fn(|i| self.row_of(dof(nodes[i / 2], i % 2)));
        self.part_of[id.index()] = Some(self.parts.len());
        let part = Part::quad(self.model, &self.start, id, rows).ok_or(CondensedError::Broken)?;
        self.watch(part)
    }

    /// Balances loads on top of what was there at the start, from the last position.
    fn go(&mut self, load: Load) -> Result<Position, CondensedError> {
        let before = (std::mem::replace(&mut self.load, load), self.forces.clone());
        let mut position = Position { reached: Reached::NotConverged, iterations: 0, left: f64::INFINITY };
        self.guess(&before.0);
        while position.iterations < ITERATIONS {
            if !self.iterate(&mut position) {
                break;
            }
            let Some(changed) = self.changed() else { break };
            if changed.is_empty() {
                position.reached = Reached::Balanced;
                for part in &mut self.parts {
                    part.keep();
                }
                return Ok(position);
            }
            self.activate(&changed);
            if self.watch_around(&changed).is_err() {
                break;
            }
        }
        self.load = before.0;
        self.take_forces(&before.1);
        Ok(position)
    }

    /// Takes forces of an earlier position; rows that became active meanwhile carried nothing there.
    fn take_forces(&mut self, forces: &[f64]) {
        self.forces[..forces.len()].copy_from_slice(forces);
        self.forces[forces.len()..].fill(0.0);
        self.load.complete(&self.rows);
        self.rows.bring(&self.forces);
    }

    /// Value of a row under the loads and the forces to which rows were brought last.
    fn value(&self, row: usize) -> f64 {
        self.rows.carried(row) + self.load.moved(row)
    }

    /// Parts that were linear so far and are no longer.
    fn changed(&mut self) -> Option<Vec<usize>> {
        self.rows.bring(&self.forces);
        let (rows, load) = (&self.rows, &self.load);
        let mut changed = Vec::new();
        for (index, part) in self.parts.iter_mut().enumerate().filter(|(i, _)| !self.is_active[*i]) {
            part.answer(self.model, |row| rows.carried(row) + load.moved(row))?;
            if part.differs() {
                changed.push(index);
            }
        }
        Some(changed)
    }

    /// Solves for the rows of these parts and lets them take part.
    fn activate(&mut self, changed: &[usize]) {
        let mut fresh = Vec::new();
        for &index in changed {
            self.is_active[index] = true;
            self.active.push(index);
            let rows = self.parts[index].rows.into_iter().flatten();
            fresh.extend(rows.filter(|row| self.rows[*row].column.is_none()));
        }
        self.active.sort_unstable();
        fresh.sort_unstable();
        fresh.dedup();
        let equations = self.model.equations();
        let columns = self.work.solve_many(fresh.iter().map(|&row| self.rows[row].unit(equations)).collect());
        self.rows.add_columns(&fresh, columns);
        self.forces.resize(self.rows.columns(), 0.0);
        self.system.extend(&fresh, |column, row| self.rows.answer(column, row));
    }

    /// What the observed functionals are in the last position.
    pub fn observed(&self) -> Vec<f64> {
        self.observed.iter().map(|&row| self.value(row)).collect()
    }

    /// Counts of the last position.
    pub fn counts(&self) -> Counts {
        let bonds = self.parts.iter().filter_map(Part::bond);
        let (open, sliding) = count(bonds.map(|bond| bond.state));
        Counts {
            open,
            open_interfaces: open_interfaces(self.model, self.parts.iter().filter_map(Part::bond)),
            sliding,
            yielding: self.parts.iter().map(Part::yielding).sum(),
            active_rows: self.system.rows().len(),
            watched_quads: self.parts.iter().filter(|part| matches!(part.kind, Kind::Quad(_))).count(),
        }
    }

    /// The whole state in the last position.
    pub fn state(&mut self) -> Result<State, CondensedError> {
        let mut state = self.start.clone();
        state.displacements = self.displacements();
        for (id, quad) in self.model.mesh.quads.pairs().filter(|(id, _)| self.part_of[id.index()].is_none()) {
            let u = assemble::moved(&state.displacements, &quad.nodes);
            let first = 4 * id.index();
            let old: [Point; 4] = std::array::from_fn(|k| self.start.points[first + k]);
            let kept = Kept { points: &mut state.points[first..first + 4], modes: &mut state.modes[id.index()] };
            let (solid, modes) = (&self.model.section(id).solid, self.model.incompatible(id));
            let samples = element::sample(&self.model.corners(id));
            element::respond(solid, modes, &samples, &u, &old, kept).ok_or(CondensedError::Broken)?;
        }
        self.parts.iter().for_each(|part| part.write(&mut state));
        Ok(state)
    }

    /// What has to be kept to come back to the last position.
    #[must_use]
    pub fn mark(&self) -> Mark {
        let parts = self.parts.iter().map(Part::remembered).collect();
        Mark { load: self.load.clone(), forces: self.forces.clone(), parts }
    }

    /// Goes back to a mark. Parts and rows that came later stay; they carried nothing there.
    pub fn back_to(&mut self, mark: &Mark) {
        self.load.clone_from(&mark.load);
        self.take_forces(&mark.forces);
        for (part, remembered) in self.parts.iter_mut().zip(&mark.parts) {
            part.recall(remembered);
        }
        for part in &mut self.parts[mark.parts.len()..] {
            part.restart(&self.start);
        }
    }

    /// Goes back to the state in which the run began; what was found of the system stays.
    pub fn restart(&mut self) {
        self.load = Load::none(self.patterns.len(), self.rows.len());
        self.forces.fill(0.0);
        self.rows.restart();
        for part in &mut self.parts {
            part.restart(&self.start);
        }
    }

    /// Displacements of all components [m] in the last position: one solution of the whole system.
    pub fn displacements(&mut self) -> Vec<f64> {
        let mut right = vec![0.0; self.model.equations()];
        for (pattern, a) in self.patterns.iter().zip(&self.load.amplitudes).filter(|(_, a)| **a != 0.0) {
            right.iter_mut().zip(pattern).for_each(|(right, force)| *right += a * force);
        }
        for (&row, force) in self.system.rows().iter().zip(&self.forces) {
            self.rows[row].push(&mut right, *force);
        }
        let more = self.work.solve_many(vec![right]).pop().unwrap_or_default();
        let mut all = self.start.displacements.clone();
        for (component, more) in self.model.dofs().free().iter().zip(&more) {
            all[*component as usize] += more;
        }
        all
    }
}

/// Interfaces with an open spring; bonds in the order of [`Model::springs`].
pub fn open_interfaces<'b>(model: &Model, bonds: impl Iterator<Item = &'b Bond>) -> usize {
    let mut open = vec![false; model.mesh.interfaces.len()];
    for (spring, bond) in model.springs().iter().zip(bonds) {
        open[spring.interface.index()] |= bond.state == PairState::Open;
    }
    open.into_iter().filter(|open| *open).count()
}

/// Where a run stood.
#[derive(Debug, Clone)]
pub struct Mark {
    load: Load,
    forces: Vec<f64>,
    parts: Vec<Remembered>,
}

/// Why there is no condensed system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CondensedError {
    /// The model turns and moves by itself.
    #[error("large displacements cannot be condensed: the linear parts turn with them")]
    LargeDisplacements,
    /// The linear system has no inverse.
    #[error(transparent)]
    Factor(#[from] FactorError),
    /// A law or an element had no answer.
    #[error("an element or a spring has no answer to its displacements")]
    Broken,
}
