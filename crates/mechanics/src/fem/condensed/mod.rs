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
//! with load patterns `l` of amplitude `a_l`. A row whose excess ever changes costs one solution, found when it is first needed. All parts are
//! looked at in every position. The equations are those of the whole mesh: nothing is approximated.

mod balance;
mod dense;
mod hot;
mod hourglass;
mod look;
mod low_rank;
mod newton;
mod parts;
mod passage;
mod quad_check;
mod rows;
mod screening;
mod slopes;
mod spring_check;
mod tangent;

use super::dofs::HELD;
use super::element::Kept;
use super::factor::{Block, FactorError};
use super::joint::PairState;
use super::model::{Model, count};
use super::settings::Kinematics;
use super::state::{Bond, Point, State};
use super::workspace::Workspace;
use super::{assemble, element};
use crate::ids::{Id, QuadId};
use hot::Hot;
use parts::{Committed, Kind, Part, quad_components};
use rows::{Row, Rows};
use screening::Screening;

pub use passage::{Passage, Visited};
pub use rows::{Functional, LoadPattern};
pub use slopes::{Derivatives, Neighbour};

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
    /// Plain quadrilaterals all of whose points flow: those that may lock ([`crate::fem::Step::locking`]).
    pub locking: usize,
    /// Rows on which forces act that the linear system does not know.
    pub active_rows: usize,
    /// Quadrilaterals that flow or have flowed in some position.
    pub active_quads: usize,
}

/// Largest change left in a row, over the largest value of a row, at which a position counts as balanced. Over the 2,717 positions of a passage records are then
/// within 1.2e-9 of a channel's largest value of those found with 1e-12, and take seven iterations where these take ten.
pub const TOLERANCE: f64 = 1e-9;

/// Iterations allowed in one position where nobody says how many.
const ITERATIONS: u32 = 60;

/// A model around one state, ready for many load positions.
#[derive(Debug)]
pub struct Condensed<'a> {
    model: &'a Model,
    work: Workspace,
    /// Solutions of the linear system that were found last.
    block: Block,
    /// The state in which the run began.
    start: State,
    /// Forces of the patterns on the equations.
    patterns: Vec<Vec<(u32, f64)>>,
    observed: Vec<Row>,
    /// All that may answer otherwise than linearly.
    parts: Vec<Part>,
    /// The batched test of all parts, with the memory that they had when the run began.
    screening: Screening,
    /// Parts whose excess differs or differed from that of the start, in the order in which they joined.
    active: Vec<usize>,
    is_active: Vec<bool>,
    /// When a part has last not answered linearly, by the clock, which counts positions.
    moved_at: Vec<u64>,
    clock: u64,
    rows: Rows,
    /// Row of a component, where it is active.
    row_of: Vec<Option<usize>>,
    hot: Hot,
    /// The last position.
    at: Place,
    /// Active parts that do not move yet, but would if the rows went on as they did: they iterate from the beginning of the next position. A position whose
    /// parts get hot when it has already been balanced without them is balanced twice.
    foreseen: Vec<usize>,
    /// Most that loads have moved a row of the linear system from one position to the next [m].
    most_moved: f64,
    /// Iterations allowed in one position.
    iterations: u32,
    /// Whether places that were visited are kept.
    keeps_places: bool,
}

/// A position in balance.
#[derive(Debug, Clone, Default, PartialEq)]
struct Place {
    amplitudes: Vec<f64>,
    /// Forces on the active rows, and their values.
    forces: Vec<f64>,
    values: Vec<f64>,
    /// Values of the observed functionals.
    observed: Vec<f64>,
    /// Parts that broke on the way here, in that order.
    broken: Vec<usize>,
}

impl<'a> Condensed<'a> {
    /// Factorises the linear system of a model at small displacements. Loads, amplitudes of the patterns, come on
    /// top of those that `start` carries, which must be balanced.
    pub fn new(
        model: &'a Model,
        start: State,
        patterns: &[LoadPattern],
        observed: &[Functional],
    ) -> Result<Condensed<'a>, CondensedError> {
        if model.kinematics != Kinematics::Small {
            return Err(CondensedError::LargeDisplacements);
        }
        let mut work = Workspace::new(model)?;
        work.stiffness(model, &State::new(model))?;
        work.factorise()?;
        let springs = (0..model.springs().len()).map(|index| Some(Part::spring(model, &start, index)));
        let solids = model.mesh.quads.pairs().map(|(id, _)| id);
        let solids = solids.filter(|id| !model.section(*id).solid.material.linear());
        let parts = springs.chain(solids.map(|id| Part::quad(model, &start, id)));
        let mut parts: Vec<Part> = parts.collect::<Option<_>>().ok_or(CondensedError::Broken)?;
        parts.iter_mut().try_for_each(|part| part.set_initial_excess(model)).ok_or(CondensedError::Broken)?;
        let observed: Vec<Row> = observed.iter().map(|f| Row::new(model, f, &start.displacements)).collect();
        Ok(Condensed {
            work,
            block: Block::default(),
            patterns: patterns.iter().map(|pattern| pattern.on_equations(model)).collect(),
            active: Vec::new(),
            is_active: vec![false; parts.len()],
            moved_at: vec![0; parts.len()],
            clock: passage::COOLS + 1,
            screening: Screening::new(model, &parts),
            parts,
            rows: Rows::new(patterns.len()),
            row_of: vec![None; model.dofs().count()],
            hot: Hot::default(),
            at: Place {
                amplitudes: vec![0.0; patterns.len()],
                observed: observed.iter().map(|row| row.start).collect(),
                ..Place::default()
            },
            observed,
            foreseen: Vec::new(),
            most_moved: 0.0,
            iterations: ITERATIONS,
            keeps_places: false,
            model,
            start,
        })
    }

    /// Allows so many iterations in one position.
    #[must_use]
    pub fn with_iterations(mut self, iterations: u32) -> Condensed<'a> {
        self.iterations = iterations;
        self
    }

    /// Keeps the forces in every position that is visited: [`Condensed::derivatives`] goes along them.
    #[must_use]
    pub fn with_places(mut self) -> Condensed<'a> {
        self.keeps_places = true;
        self
    }

    /// Rows that joined since carry nothing here.
    fn complete(&mut self) {
        let known = self.at.forces.len();
        self.at.forces.resize(self.rows.len(), 0.0);
        if known < self.rows.len() {
            let fresh = self.rows.list()[known..].iter().enumerate();
            let moved = |row| self.rows.row_change(row, &self.at.amplitudes, &self.at.forces);
            self.at.values.extend(fresh.map(|(k, row)| row.start + moved(known + k)));
        }
    }

    /// Parts that take part, by number in ascending order: what [`Condensed::expect`] of a model with other moduli wants to hear.
    #[must_use]
    pub fn taking_part(&self) -> Vec<usize> {
        let mut parts = self.active.clone();
        parts.sort_unstable();
        parts
    }

    /// These parts will take part sooner or later: the solutions for their rows are found side by side, before any is asked for. What
    /// is expected in vain costs its solutions and changes nothing.
    pub fn expect(&mut self, parts: &[usize]) {
        let known: Vec<usize> = parts.iter().copied().filter(|&index| index < self.parts.len()).collect();
        self.join(&known);
    }

    /// These parts take part from now on, and iterate at once.
    fn activate(&mut self, joining: &[usize]) {
        self.join(joining);
        for &index in joining {
            self.moved_at[index] = self.clock;
        }
    }

    /// These parts take part from now on: one solution for each of their rows.
    fn join(&mut self, joining: &[usize]) {
        let mut fresh = Vec::new();
        for &index in joining.iter().filter(|&&index| !self.is_active[index]) {
            self.active.push(index);
            let first = self.rows.len();
            let mut push = |functional: Functional| {
                fresh.push(Row::new(self.model, &functional, &self.start.displacements));
                first + fresh.len() - 1
            };
            let part = &mut self.parts[index];
            match part.kind {
                Kind::Spring(spring) => {
                    for (row, opening) in part.rows.iter_mut().zip(self.model.springs()[spring].openings()) {
                        *row = Some(push(Functional(opening)));
                    }
                }
                Kind::Quad(id) => {
                    for (row, component) in part.rows.iter_mut().zip(quad_components(self.model, id)) {
                        if self.model.dofs().equation(component) != HELD {
                            let known = &mut self.row_of[component];
                            *row = Some(*known.get_or_insert_with(|| push(Functional(vec![(component, 1.0)]))));
                        }
                    }
                }
            }
        }
        for &index in joining {
            self.is_active[index] = true;
        }
        self.rows.append(fresh, &self.patterns, &mut self.work, &mut self.block);
        self.complete();
    }

    /// Solves the whole linear system under the loads and forces of some positions, [`Condensed::block`].
    fn displace(&mut self, places: &[&Place]) {
        let Condensed { work, block, patterns, rows, .. } = self;
        work.solve_loaded(places.len(), block, |block| {
            let mut multiples = vec![0.0; places.len()];
            let mut add = |terms: &[(u32, f64)], of: &dyn Fn(&Place) -> f64| {
                multiples.iter_mut().zip(places).for_each(|(multiple, place)| *multiple = of(place));
                if multiples.iter().any(|multiple| *multiple != 0.0) {
                    terms.iter().for_each(|&(equation, force)| block.add(equation, force, &multiples));
                }
            };
            for (k, pattern) in patterns.iter().enumerate() {
                add(pattern, &|place| place.amplitudes[k]);
            }
            for (k, row) in rows.list().iter().enumerate() {
                add(row.terms(), &|place| place.forces.get(k).copied().unwrap_or(0.0));
            }
        });
    }

    /// Values of the observed functionals in one of the solutions found last.
    fn observed_in(&self, lane: usize) -> Vec<f64> {
        self.observed.iter().map(|row| row.start + row.change_in(&self.block, lane)).collect()
    }

    /// Load patterns.
    #[must_use]
    pub fn patterns(&self) -> usize {
        self.patterns.len()
    }

    /// What the observed functionals are in the last position.
    pub fn observed(&self) -> Vec<f64> {
        self.at.observed.clone()
    }

    /// Counts of the last position.
    pub fn counts(&self) -> Counts {
        let mut bonds = vec![None; self.model.springs().len()];
        let mut counts = Counts { active_rows: self.rows.len(), ..Counts::default() };
        for part in self.active.iter().map(|&index| &self.parts[index]) {
            match part.kind {
                Kind::Spring(index) => bonds[index] = part.committed_bond(),
                Kind::Quad(_) => counts.active_quads += 1,
            }
            counts.yielding += part.yielding_points();
            counts.locking += usize::from(part.locks(self.model));
        }
        (counts.open, counts.sliding) = count(bonds.iter().flatten().map(|bond| bond.state));
        counts.open_interfaces = open_among(self.model, bonds.into_iter());
        counts
    }

    /// The whole state in the last position.
    pub fn state(&mut self) -> Result<State, CondensedError> {
        let mut state = self.start.clone();
        state.displacements = self.displacements();
        let linear = |id: &QuadId| self.model.section(*id).solid.material.linear();
        for (id, quad) in self.model.mesh.quads.pairs().filter(|(id, _)| linear(id)) {
            let u = assemble::moved(&state.displacements, &quad.nodes);
            let first = 4 * id.index();
            let old: [Point; 4] = std::array::from_fn(|k| self.start.points[first + k]);
            let from = state.modes[id.index()];
            let modes = &mut state.modes[id.index()];
            let kept = Kept { points: &mut state.points[first..first + 4], modes, from, misses: &mut 0 };
            let (solid, modes) = (&self.model.section(id).solid, self.model.incompatible(id));
            let samples = element::sample(&self.model.corners(id));
            element::respond(solid, modes, &samples, &u, &old, kept).ok_or(CondensedError::Broken)?;
        }
        for part in &mut self.parts {
            part.evaluate_in(self.model, &self.block, 0).ok_or(CondensedError::Broken)?;
            part.write_to(&mut state);
        }
        Ok(state)
    }

    /// What has to be kept to come back to the last position.
    #[must_use]
    pub fn mark(&self) -> Mark {
        let parts = self.active.iter().map(|&index| (index, self.parts[index].committed())).collect();
        Mark { at: self.at.clone(), parts }
    }

    /// Goes back to a mark. Parts and rows that came later stay; they carried nothing there.
    pub fn back_to(&mut self, mark: &Mark) {
        self.at = mark.at.clone();
        self.foreseen.clear();
        self.complete();
        self.hot.forget();
        for &index in &self.active {
            self.parts[index].revert_to_start(&self.start);
        }
        for (index, remembered) in &mark.parts {
            self.parts[*index].restore(remembered);
        }
    }

    /// Goes back to the state in which the run began; what was found of the system stays.
    pub fn restart(&mut self) {
        self.at = Place {
            amplitudes: vec![0.0; self.patterns.len()],
            observed: self.observed.iter().map(|row| row.start).collect(),
            ..Place::default()
        };
        self.foreseen.clear();
        self.complete();
        self.hot.forget();
        for &index in &self.active {
            self.parts[index].revert_to_start(&self.start);
        }
    }

    /// Displacements of all components [m] in the last position: one solution of the whole system.
    pub fn displacements(&mut self) -> Vec<f64> {
        let here = std::mem::take(&mut self.at);
        self.displace(&[&here]);
        self.at = here;
        let mut all = self.start.displacements.clone();
        for (equation, component) in self.model.dofs().free().iter().enumerate() {
            all[*component as usize] += self.block.of(equation as u32)[0];
        }
        all
    }
}

/// Interfaces with an open spring; bonds in the order of [`Model::springs`].
pub fn open_interfaces<'b>(model: &Model, bonds: impl Iterator<Item = &'b Bond>) -> usize {
    open_among(model, bonds.map(Some))
}

fn open_among<'b>(model: &Model, bonds: impl Iterator<Item = Option<&'b Bond>>) -> usize {
    let mut open = vec![false; model.mesh.interfaces.len()];
    for (spring, bond) in model.springs().iter().zip(bonds) {
        open[spring.interface.index()] |= bond.is_some_and(|bond| bond.state == PairState::Open);
    }
    open.into_iter().filter(|open| *open).count()
}

/// Where a run stood.
#[derive(Debug, Clone)]
pub struct Mark {
    at: Place,
    /// Active parts.
    parts: Vec<(usize, Committed)>,
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
    /// Derivatives of a run whose places were not kept, or that did not begin at rest and without loads.
    #[error("derivatives need a run from the untouched model on, whose places were kept")]
    NoPlaces,
}
