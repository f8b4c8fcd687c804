//! Many load positions on one bridge: the linear system is solved once, and only the forces of the nonlinear parts iterate.
//!
//! Let `K` be the stiffness of the untouched model, with joints closed and solids elastic. A *part* is a spring of an interface
//! or a quadrilateral that may yield. The force by which it carries less than `K` assumes is its *excess force*, which depends on
//! the values of a few *rows* `n_r`: openings of a spring, displacement components of the corners of a quadrilateral. Equilibrium
//! is then (docs/theory/condensed.md, equation 2)
//!
//! ```text
//! u = K^-1 (f + sum_r n_r g_r(u)),   so that on the rows   v_r = v_r0 + sum_l H_rl a_l + sum_s G_rs g_s(v),   G_rs = n_r K^-1 n_s
//! ```
//!
//! with load patterns `l` of amplitude `a_l` and the flexibility `G`. The equations are those of the whole mesh, without
//! approximation.
//!
//! A part is in one of three states. *Eliminated* parts have been linear so far and are condensed into `K`; they are rechecked in
//! all positions. *Retained* parts have their rows in `G`, at the cost of one solution of the linear system for each row. Of
//! these, *active* parts iterate, and *dormant* parts have been linear for some positions and are rechecked when a position is
//! balanced.

mod active_set;
mod dense;
mod hourglass;
mod increment;
mod low_rank;
mod newton;
mod parts;
mod passage;
mod quad_check;
mod recheck;
mod rows;
mod screening;
mod sensitivity;
mod spring_check;
mod tangent;

use super::dofs::HELD;
use super::element::{self, Kept};
use super::factor::{Block, FactorError};
use super::joint::PairState;
use super::model::{Model, count};
use super::settings::Kinematics;
use super::state::{Bond, Point, State};
use super::workspace::Workspace;
use crate::ids::{Id, QuadId};
use crate::watch::{Asking, Watch};
use active_set::ActiveSet;
use parts::{Committed, Kind, Part};
use rows::{Row, Rows, on_equations};
use screening::Screening;
use std::sync::Arc;

pub use passage::{Passage, Run, Visited};
pub use rows::{Functional, LoadPattern, load_pattern};
pub use sensitivity::{Derivatives, PerturbedModel};

/// How one position ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reached {
    /// The position is in equilibrium to the tolerance.
    Balanced,
    /// No equilibrium was found.
    NotConverged,
    /// The onlooker stopped the run on the way.
    Cancelled,
}

/// How the solution of one position ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// How it ended.
    pub reached: Reached,
    /// Iterations of Newton's method.
    pub iterations: u32,
    /// Largest change of a row value that is left, over the largest row value.
    pub residual: f64,
}

/// Numbers of nonlinear parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Springs that are open.
    pub open: usize,
    /// Interfaces that are open somewhere.
    pub open_interfaces: usize,
    /// Springs that slide.
    pub sliding: usize,
    /// Points that yield.
    pub yielding: usize,
    /// Plain quadrilaterals all of whose points yield: those that may lock ([`crate::fem::Step::locking`]).
    pub locking: usize,
    /// Retained rows: those on which excess forces act.
    pub retained_rows: usize,
}

/// Largest change left in a row value, over the largest row value, at which a position counts as balanced. Over the 2,717
/// positions of a passage the records are then within 1.2e-9 of a channel's largest value of those with 1e-12, and take seven
/// iterations where those take ten.
pub const TOLERANCE: f64 = 1e-9;

/// Default limit of iterations in one position.
const ITERATIONS: u32 = 60;

/// A model condensed around one state, ready for many load positions.
pub struct Condensed {
    model: Arc<Model>,
    work: Workspace,
    /// Solutions of the linear system that were found last.
    block: Block,
    /// The state in which the run began.
    start: State,
    /// Forces of the patterns by equations.
    patterns: Vec<Vec<(u32, f64)>>,
    /// Functionals whose values are wanted in every position.
    observed: Vec<Row>,
    /// All parts that may be nonlinear.
    parts: Vec<Part>,
    /// The batched test of all parts, with the memory that they had when the run began.
    screening: Screening,
    /// Retained parts, in the order in which they were retained.
    retained: Vec<usize>,
    is_retained: Vec<bool>,
    /// Position at which the part was last nonlinear, by parts, and the number of positions so far.
    last_nonlinear: Vec<u64>,
    position_count: u64,
    /// The retained rows.
    rows: Rows,
    /// Retained row of a displacement component, if it has one.
    row_of: Vec<Option<usize>>,
    /// The parts that iterate.
    active_set: ActiveSet,
    /// The last equilibrium.
    current: Equilibrium,
    /// Dormant parts that would become nonlinear if the rows went on as they did: they are activated at the beginning of the next
    /// position. If a part is found nonlinear only when a position is balanced, the position has to be balanced twice.
    predicted_active: Vec<usize>,
    /// Largest change of a row value by the loads from one position to the next [m].
    largest_load_change: f64,
    /// Limit of iterations in one position.
    pub iterations: u32,
    /// Whether the equilibria of all solved positions are kept, for [`Condensed::derivatives`].
    pub keeps_equilibria: bool,
}

/// A position in equilibrium.
#[derive(Debug, Clone, Default, PartialEq)]
struct Equilibrium {
    /// Amplitudes of the load patterns.
    amplitudes: Vec<f64>,
    /// Forces on the retained rows [N/m], and values of these [m].
    forces: Vec<f64>,
    values: Vec<f64>,
    /// Values of the observed functionals.
    observed: Vec<f64>,
    /// Parts that broke on the way here, in that order.
    broken: Vec<usize>,
}

impl Condensed {
    /// Factorises the linear system of a model at small displacements. Loads are added by amplitudes of `patterns` to those that
    /// `start` carries, which must be in equilibrium.
    ///
    /// # Errors
    /// Large displacements, a stiffness without an inverse or too large for the memory, or a part that has no answer to `start`.
    pub fn new(
        model: impl Into<Arc<Model>>,
        start: State,
        patterns: &[LoadPattern],
        observed: &[Functional],
    ) -> Result<Condensed, CondensedError> {
        let shared: Arc<Model> = model.into();
        let model = &*shared;
        if model.kinematics != Kinematics::Small {
            return Err(CondensedError::LargeDisplacements);
        }
        let mut work = Workspace::new(model)?;
        work.stiffness(model, &State::new(model))?;
        work.factorise()?;
        let springs = (0..model.springs.len()).map(|index| Some(Part::spring(model, &start, index)));
        let solids = model.mesh.quads.pairs().map(|(id, _)| id);
        let solids = solids.filter(|id| !model.section(*id).solid.material.linear());
        let parts = springs.chain(solids.map(|id| Part::quad(model, &start, id)));
        let mut parts: Vec<Part> = parts.collect::<Option<_>>().ok_or(CondensedError::Broken)?;
        parts.iter_mut().try_for_each(|part| part.set_initial_excess(model)).ok_or(CondensedError::Broken)?;
        let observed: Vec<Row> = observed.iter().map(|f| Row::new(model, f, &start.displacements)).collect();
        Ok(Condensed {
            work,
            block: Block::default(),
            patterns: patterns.iter().map(|pattern| on_equations(model, pattern)).collect(),
            retained: Vec::new(),
            is_retained: vec![false; parts.len()],
            last_nonlinear: vec![0; parts.len()],
            position_count: passage::DEACTIVATION_DELAY + 1,
            screening: Screening::new(model, &parts),
            parts,
            rows: Rows::new(patterns.len()),
            row_of: vec![None; model.dofs.equation.len()],
            active_set: ActiveSet::default(),
            current: Equilibrium {
                amplitudes: vec![0.0; patterns.len()],
                observed: observed.iter().map(|row| row.start).collect(),
                ..Equilibrium::default()
            },
            observed,
            predicted_active: Vec::new(),
            largest_load_change: 0.0,
            iterations: ITERATIONS,
            keeps_equilibria: false,
            model: Arc::clone(&shared),
            start,
        })
    }

    /// Extends the current equilibrium to rows that were retained since, which carry no force in it.
    fn extend_to_new_rows(&mut self) {
        let known = self.current.forces.len();
        self.current.forces.resize(self.rows.len(), 0.0);
        if known < self.rows.len() {
            let new_rows = self.rows.list[known..].iter().enumerate();
            let change = |row| self.rows.row_change(row, &self.current.amplitudes, &self.current.forces);
            self.current.values.extend(new_rows.map(|(k, row)| row.start + change(known + k)));
        }
    }

    /// Gives the retained parts, by number in ascending order: a good guess for [`Condensed::retain_parts`] of a model with other
    /// moduli.
    #[must_use]
    pub fn retained_parts(&self) -> Vec<usize> {
        let mut parts = self.retained.clone();
        parts.sort_unstable();
        parts
    }

    /// Retains parts that are likely to become nonlinear: the solutions for their rows are found together. A part retained in
    /// vain costs its solutions and changes no result. `false` where the onlooker stopped it: nothing can be solved then.
    pub fn retain_parts(&mut self, parts: &[usize], watch: &mut dyn Watch) -> bool {
        let known: Vec<usize> = parts.iter().copied().filter(|&index| index < self.parts.len()).collect();
        let mut asking = Asking::new(watch);
        self.retain(&known, &mut asking);
        !asking.stopped
    }

    /// Retains parts that were found nonlinear in the current position, so that they are active in the next.
    fn retain_nonlinear(&mut self, indices: &[usize], asking: &mut Asking<'_>) {
        self.retain(indices, asking);
        for &index in indices {
            self.last_nonlinear[index] = self.position_count;
        }
    }

    /// Retains parts, with one solution of the linear system for each of their rows; not with all of them where `asking` stops.
    fn retain(&mut self, indices: &[usize], asking: &mut Asking<'_>) {
        let mut fresh = Vec::new();
        for &index in indices.iter().filter(|&&index| !self.is_retained[index]) {
            self.retained.push(index);
            let first = self.rows.len();
            let mut push = |functional: Functional| {
                fresh.push(Row::new(&self.model, &functional, &self.start.displacements));
                first + fresh.len() - 1
            };
            let part = &mut self.parts[index];
            match part.kind {
                Kind::Spring(spring) => {
                    for (row, opening) in part.rows.iter_mut().zip(self.model.springs[spring].openings()) {
                        *row = Some(push(opening));
                    }
                }
                Kind::Quad(id) => {
                    for (row, component) in part.rows.iter_mut().zip(self.model.components(id)) {
                        if self.model.dofs.equation[component] != HELD {
                            let known = &mut self.row_of[component];
                            *row = Some(*known.get_or_insert_with(|| push(vec![(component, 1.0)])));
                        }
                    }
                }
            }
        }
        for &index in indices {
            self.is_retained[index] = true;
        }
        self.rows.append(fresh, &self.patterns, &mut self.work, &mut self.block, asking);
        self.extend_to_new_rows();
    }

    /// Solves the whole linear system under the loads and forces of some equilibria; the solutions are written to `self.block`.
    fn solve_full_system(&mut self, equilibria: &[&Equilibrium]) {
        let Condensed { work, block, patterns, rows, .. } = self;
        work.solver.solve_loaded(equilibria.len(), block, |block| {
            let mut multiples = vec![0.0; equilibria.len()];
            let mut add = |terms: &[(u32, f64)], of: &dyn Fn(&Equilibrium) -> f64| {
                multiples.iter_mut().zip(equilibria).for_each(|(multiple, equilibrium)| *multiple = of(equilibrium));
                if multiples.iter().any(|multiple| *multiple != 0.0) {
                    terms.iter().for_each(|&(equation, force)| block.add(equation, force, &multiples));
                }
            };
            for (k, pattern) in patterns.iter().enumerate() {
                add(pattern, &|equilibrium| equilibrium.amplitudes[k]);
            }
            for (k, row) in rows.list.iter().enumerate() {
                add(&row.terms, &|equilibrium| equilibrium.forces.get(k).copied().unwrap_or(0.0));
            }
        });
    }

    /// Gives the values of the observed functionals in one of the solutions found last.
    fn observed_values(&self, lane: usize) -> Vec<f64> {
        self.observed.iter().map(|row| row.start + row.change_in(&self.block, lane)).collect()
    }

    /// Gives the values of the observed functionals in the last position, in their order.
    pub fn observed(&self) -> Vec<f64> {
        self.current.observed.clone()
    }

    /// Counts the nonlinear parts of the last position.
    pub fn counts(&self) -> Counts {
        let untouched = Bond::default();
        let mut bonds = vec![&untouched; self.model.springs.len()];
        let mut counts = Counts { retained_rows: self.rows.len(), ..Counts::default() };
        for part in self.retained.iter().map(|&index| &self.parts[index]) {
            if let Kind::Spring(index) = part.kind {
                bonds[index] = &part.committed.history.bond;
            }
            counts.yielding += part.committed.history.points.iter().filter(|point| point.yields).count();
            counts.locking += usize::from(part.locks(&self.model));
        }
        (counts.open, counts.sliding) = count(bonds.iter().map(|bond| bond.state));
        counts.open_interfaces = open_interfaces(&self.model, bonds.into_iter());
        counts
    }

    /// Finds the whole state in the last position.
    ///
    /// # Errors
    /// A part that has no answer to its displacements.
    pub fn state(&mut self) -> Result<State, CondensedError> {
        let mut state = self.linear_state()?;
        for part in &mut self.parts {
            part.evaluate_in(&self.model, &self.block, 0).ok_or(CondensedError::Broken)?;
            part.write_to(&mut state);
        }
        Ok(state)
    }

    /// Finds the whole state at a position of the last batch of `run`, the last one or one before it, and leaves no trace.
    ///
    /// # Errors
    /// A part that has no answer to its displacements.
    pub fn state_at(&mut self, run: &Run, position: usize) -> Result<State, CondensedError> {
        let (equilibrium, earlier) = run.at(position, &self.current);
        let last = std::mem::replace(&mut self.current, equilibrium);
        let state = self.linear_state();
        self.current = last;
        let mut state = state?;
        for (index, part) in self.parts.iter().enumerate() {
            let mut part = part.clone();
            earlier.get(&index).iter().for_each(|&committed| part.committed = *committed);
            part.evaluate_in(&self.model, &self.block, 0).ok_or(CondensedError::Broken)?;
            part.write_to(&mut state);
        }
        Ok(state)
    }

    /// Finds the displacements in the last position, and the stresses of the quadrilaterals that cannot yield.
    fn linear_state(&mut self) -> Result<State, CondensedError> {
        let here = std::mem::take(&mut self.current);
        self.solve_full_system(&[&here]);
        self.current = here;
        let mut state = self.start.clone();
        for (component, change) in self.model.dofs.free.iter().zip(self.block.solution(0)) {
            state.displacements[*component as usize] += change;
        }
        let linear = |id: &QuadId| self.model.section(*id).solid.material.linear();
        for id in self.model.mesh.quads.ids().filter(linear) {
            let u = self.model.components(id).map(|component| state.displacements[component]);
            let first = 4 * id.index();
            let old: [Point; 4] = std::array::from_fn(|k| self.start.points[first + k]);
            let from = state.modes[id.index()];
            let modes = &mut state.modes[id.index()];
            let kept = Kept { points: &mut state.points[first..first + 4], modes, from, misses: &mut 0 };
            let (solid, modes) = (&self.model.section(id).solid, self.model.incompatible(id));
            let samples = element::sample(&self.model.corners(id));
            element::respond(solid, modes, &samples, &u, &old, kept).ok_or(CondensedError::Broken)?;
        }
        Ok(state)
    }

    /// Takes a snapshot of the last position, for [`Condensed::restore`].
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        let parts = self.retained.iter().map(|&index| (index, self.parts[index].committed)).collect();
        Snapshot { current: self.current.clone(), parts }
    }

    /// Makes an earlier equilibrium the current one. Rows that were retained since carried no force there.
    fn go_back_to(&mut self, equilibrium: Equilibrium) {
        self.current = equilibrium;
        self.predicted_active.clear();
        self.extend_to_new_rows();
        self.active_set.discard_tangent();
    }

    /// Restores a snapshot. Parts and rows that were retained later stay; they carried no excess force then.
    pub fn restore(&mut self, snapshot: &Snapshot) {
        self.go_back_to(snapshot.current.clone());
        for &index in &self.retained {
            self.parts[index].revert_to_start(&self.start);
        }
        for (index, committed) in &snapshot.parts {
            self.parts[*index].committed = *committed;
        }
    }
}

/// Counts the interfaces with an open spring; `bonds` are in the order of [`Model::springs`].
pub fn open_interfaces<'b>(model: &Model, bonds: impl Iterator<Item = &'b Bond>) -> usize {
    let mut open = vec![false; model.mesh.interfaces.len()];
    for (spring, bond) in model.springs.iter().zip(bonds) {
        open[spring.interface.index()] |= bond.state == PairState::Open;
    }
    open.into_iter().filter(|open| *open).count()
}

/// An equilibrium with the states of the retained parts.
#[derive(Debug, Clone)]
pub struct Snapshot {
    current: Equilibrium,
    /// Retained parts with their states.
    parts: Vec<(usize, Committed)>,
}

/// Why a model cannot be condensed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CondensedError {
    /// The model is computed at large displacements.
    #[error("large displacements cannot be condensed: the linear parts turn with them")]
    LargeDisplacements,
    /// The linear system has no inverse.
    #[error(transparent)]
    Factor(#[from] FactorError),
    /// A law or an element has no answer.
    #[error("an element or a spring has no answer to its displacements")]
    Broken,
    /// Derivatives were asked of a run that did not keep its equilibria, or that did not begin at rest and without loads.
    #[error("derivatives need a run from the untouched model on, whose equilibria were kept")]
    NoEquilibria,
}
