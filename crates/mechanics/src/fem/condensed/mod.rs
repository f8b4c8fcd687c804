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

mod parts;
mod passage;
mod rows;
mod system;

use super::dofs::{HELD, dof};
use super::element::Kept;
use super::factor::FactorError;
use super::joint::PairState;
use super::law::{Four, Law};
use super::model::{Model, count};
use super::settings::Kinematics;
use super::state::{Bond, Point, State};
use super::workspace::Workspace;
use super::{assemble, element};
use crate::ids::{Id, QuadId};
use parts::{Kind, Part, ROWS};
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

/// Iterations without a smaller change after which a position is given up.
const IDLE: u32 = 15;

/// Change left in a row over the largest value of a row above which all parts are looked at in every iteration.
const FAR: f64 = 1e-3;

/// Farthest that a row moves in an iteration, over the most that the loads move one of the linear system.
const FARTHEST: f64 = 2.0;

/// A quadrilateral is watched if it would flow at this multiple of what the loads do to it.
const FORESIGHT: f64 = 2.0;

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
    amplitudes: Vec<f64>,
    /// Forces on the columns' rows.
    forces: Vec<f64>,
    /// Most that loads have moved a row of the linear system so far [m].
    most_moved: f64,
    /// Values of the active rows while they are sought, in their order.
    values: Vec<f64>,
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
            around: around(model),
            active: Vec::new(),
            is_active: Vec::new(),
            observed: Vec::new(),
            system: System::default(),
            amplitudes: vec![0.0; patterns.len()],
            forces: Vec::new(),
            most_moved: 0.0,
            values: Vec::new(),
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

    fn row(&mut self, functional: &Functional) -> usize {
        self.rows.push(self.model, functional, &self.start.displacements)
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

    /// Yielding spreads to what is next to it.
    fn watch_around(&mut self, changed: &[usize]) -> Result<(), CondensedError> {
        for &index in changed {
            let Kind::Quad(id) = self.parts[index].kind else { continue };
            for node in self.model.mesh.quads[id].nodes {
                for k in 0..self.around[node.index()].len() {
                    self.watch_quad(self.around[node.index()][k])?;
                }
            }
        }
        Ok(())
    }

    /// Balances loads of these amplitudes on top of what was there at the start, from the last position.
    pub fn go(&mut self, amplitudes: &[f64]) -> Result<Position, CondensedError> {
        let before = (self.amplitudes.clone(), self.forces.clone());
        self.amplitudes.copy_from_slice(amplitudes);
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
        self.amplitudes = before.0;
        // Rows that became active meanwhile carry nothing in the last position.
        self.forces[..before.1.len()].copy_from_slice(&before.1);
        self.forces[before.1.len()..].fill(0.0);
        self.rows.bring(&self.amplitudes, &self.forces);
        Ok(position)
    }

    /// The forces follow the change of the loads as the last tangent has it.
    fn guess(&mut self, before: &[f64]) {
        let more: Vec<f64> = self.amplitudes.iter().zip(before).map(|(now, then)| now - then).collect();
        let step: Vec<f64> = self.system.rows().iter().map(|&row| self.rows.moved(row, &more)).collect();
        let step = self.system.predict(&step);
        self.forces.iter_mut().zip(step).for_each(|(force, step)| *force += step);
    }

    /// Newton's method on the forces of the active rows (equation 5); `false` where it finds no end.
    fn iterate(&mut self, position: &mut Position) -> bool {
        let Some(mut right) = self.unbalanced() else { return false };
        let (mut best, mut idle) = (f64::INFINITY, 0);
        while position.iterations < ITERATIONS {
            let change = self.system.moves(&right);
            let size = self.values.iter().fold(1e-9_f64, |most, value| most.max(value.abs()));
            position.left = change.iter().fold(0.0_f64, |most, l| most.max(l.abs())) / size;
            if position.left <= TOLERANCE {
                self.forces.iter_mut().zip(&right).for_each(|(force, right)| *force += right);
                return true;
            }
            idle = if position.left < 0.9 * best { 0 } else { idle + 1 };
            best = best.min(position.left);
            if !position.left.is_finite() || idle > IDLE {
                return false;
            }
            position.iterations += 1;
            let slopes = self.active.iter().map(|&part| (&self.parts[part].rows, &self.parts[part].slope));
            let direction = self.system.solve(slopes, &right);
            let Some(next) = self.step(&direction, &right) else { return false };
            right = next;
            // Far from balance, parts that join late would lead the others astray.
            if position.left > FAR {
                let Some(changed) = self.changed() else { return false };
                if !changed.is_empty() {
                    self.activate(&changed);
                    if self.watch_around(&changed).is_err() {
                        return false;
                    }
                    let Some(next) = self.unbalanced() else { return false };
                    right = next;
                }
            }
        }
        false
    }

    /// Values of the active rows under loads and forces, and the excess of their parts less those forces.
    fn unbalanced(&mut self) -> Option<Vec<f64>> {
        let more = self.system.moves(&self.forces);
        let rows = self.system.rows().iter().zip(more);
        self.values = rows.map(|(&row, more)| self.rows.linear(row, &self.amplitudes) + more).collect();
        let moved = self.system.rows().iter().map(|&row| self.rows.moved(row, &self.amplitudes).abs());
        self.most_moved = moved.fold(self.most_moved, f64::max);
        self.right()
    }

    /// The excess of the active parts at the values at hand, less the forces that stand for it.
    fn right(&mut self) -> Option<Vec<f64>> {
        let excess = self.excess()?;
        Some(excess.iter().zip(&self.forces).map(|(excess, force)| excess - force).collect())
    }

    /// Goes along the direction of Newton's method: all of it, or the part at which the unbalanced forces do no more work along it.
    fn step(&mut self, direction: &[f64], right: &[f64]) -> Option<Vec<f64>> {
        const LEFT: f64 = 0.8;
        const TRIES: usize = 6;
        let way = self.system.moves(direction);
        let start = rows::dot(right, &way);
        let from = (self.forces.clone(), self.values.clone());
        let along = |from: &[f64], way: &[f64], share: f64| from.iter().zip(way).map(|(f, d)| f + share * d).collect();
        // Where a law or an element has no answer the step was too long.
        let at = |this: &mut Self, share: f64| {
            this.forces = along(&from.0, direction, share);
            this.values = along(&from.1, &way, share);
            let found = this.right();
            (found.as_ref().map_or(f64::INFINITY, |right| rows::dot(right, &way)), found)
        };
        // Where the tangent is all but singular, no step goes farther than a multiple of what the loads do to the linear system.
        let reach = FARTHEST * self.most_moved;
        let longest = way.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        let whole = if longest > reach && reach > 0.0 { reach / longest } else { 1.0 };
        let (mut work, mut found) = at(self, whole);
        let (mut low, mut high) = ((0.0, start), (whole, work));
        let (mut share, mut best) = (whole, (whole, work.abs()));
        for _ in 0..TRIES {
            if work.abs() <= LEFT * start.abs() || (whole < 1.0 && share == whole && work * start > 0.0) {
                return found;
            }
            let crosses = high.1.is_finite() && low.1 * high.1 < 0.0;
            let part = if crosses { (low.1.abs() / (low.1.abs() + high.1.abs())).clamp(0.1, 0.9) } else { 0.5 };
            share = low.0 + part * (high.0 - low.0);
            (work, found) = at(self, share);
            if work.abs() < best.1 {
                best = (share, work.abs());
            }
            if work.is_finite() && work * start > 0.0 && work.abs() < start.abs() {
                low = (share, work);
            } else {
                high = (share, work);
            }
        }
        if best.0 == share { found } else { at(self, best.0).1 }
    }

    /// Excess of the active parts, summed on the columns.
    fn excess(&mut self) -> Option<Vec<f64>> {
        let mut sum = vec![0.0; self.forces.len()];
        for &index in &self.active {
            let (part, values, rows) = (&mut self.parts[index], &self.values, &self.rows);
            part.answer(self.model, |row| rows[row].column.map_or(0.0, |column| values[column]))?;
            for (row, excess) in part.rows.iter().zip(part.excess) {
                if let Some(column) = row.and_then(|row| self.rows[row].column) {
                    sum[column] += excess;
                }
            }
        }
        Some(sum)
    }

    /// Parts that were linear so far and are no longer.
    fn changed(&mut self) -> Option<Vec<usize>> {
        self.rows.bring(&self.amplitudes, &self.forces);
        let rows = &self.rows;
        let mut changed = Vec::new();
        for (index, part) in self.parts.iter_mut().enumerate().filter(|(i, _)| !self.is_active[*i]) {
            part.answer(self.model, |row| rows.value(row))?;
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
        self.observed.iter().map(|&row| self.rows.value(row)).collect()
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

    /// State of each spring in the last position, in the order of [`Model::springs`].
    pub fn pairs(&self) -> Vec<PairState> {
        self.parts.iter().filter_map(Part::bond).map(|bond| bond.state).collect()
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
    fn mark(&self) -> Mark {
        Mark { amplitudes: self.amplitudes.clone(), forces: self.forces.clone(), parts: self.parts.clone() }
    }

    /// Goes back to a mark. Parts and rows that came later stay; they carried nothing there.
    fn back_to(&mut self, mark: &Mark) {
        self.amplitudes.clone_from(&mark.amplitudes);
        self.forces[..mark.forces.len()].copy_from_slice(&mark.forces);
        self.forces[mark.forces.len()..].fill(0.0);
        self.rows.bring(&self.amplitudes, &self.forces);
        for (part, marked) in self.parts.iter_mut().zip(&mark.parts) {
            part.clone_from(marked);
        }
    }

    /// Goes back to the state in which the run began; what was found of the system stays.
    pub fn restart(&mut self) {
        self.amplitudes.fill(0.0);
        self.forces.fill(0.0);
        self.rows.restart();
        for part in &mut self.parts {
            part.restart(&self.start);
        }
    }

    /// Displacements of all components [m] in the last position: one solution of the whole system.
    pub fn displacements(&mut self) -> Vec<f64> {
        let mut right = vec![0.0; self.model.equations()];
        for (pattern, a) in self.patterns.iter().zip(&self.amplitudes).filter(|(_, a)| **a != 0.0) {
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

    /// Finds quadrilaterals that would flow soon and watches them from now on; `true` where one of them flows already, unwatched:
    /// the positions since the last look have to be gone through again.
    pub fn look_ahead(&mut self) -> Result<bool, CondensedError> {
        let now = self.displacements();
        let mut missed = false;
        let ids: Vec<QuadId> = self.model.mesh.quads.pairs().map(|(id, _)| id).collect();
        for id in ids {
            let solid = &self.model.section(id).solid;
            if self.part_of[id.index()].is_some() || solid.material.linear() {
                continue;
            }
            let (then, at) = (self.strains(id, &self.start.displacements), self.strains(id, &now));
            let flows = |share: f64| {
                let points = self.start.points[4 * id.index()..4 * id.index() + 4].iter();
                points.zip(then.iter().zip(&at)).any(|(point, (then, at))| {
                    let strain: Four = std::array::from_fn(|i| then[i] + share * (at[i] - then[i]));
                    solid.respond(&strain, &point.memory).yields
                })
            };
            if flows(FORESIGHT) {
                missed |= flows(1.0);
                self.watch_quad(id)?;
            }
        }
        Ok(missed)
    }

    /// Strains at the points of a quadrilateral, incompatible modes left out.
    fn strains(&self, id: QuadId, displacements: &[f64]) -> [Four; 4] {
        let u = assemble::moved(displacements, &self.model.mesh.quads[id].nodes);
        element::sample(&self.model.corners(id)).map(|at| {
            let mut strain = [0.0; 4];
            for a in 0..4 {
                strain[0] += at.dx[a] * u[2 * a];
                strain[1] += at.dy[a] * u[2 * a + 1];
                strain[3] += at.dy[a] * u[2 * a] + at.dx[a] * u[2 * a + 1];
            }
            strain
        })
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

/// Quadrilaterals at each node whose law is not linear.
fn around(model: &Model) -> Vec<Vec<QuadId>> {
    let mut around = vec![Vec::new(); model.mesh.nodes.len()];
    for (id, quad) in model.mesh.quads.pairs().filter(|(id, _)| !model.section(*id).solid.material.linear()) {
        quad.nodes.iter().for_each(|node| around[node.index()].push(id));
    }
    around
}

/// Where a run stood.
#[derive(Debug, Clone)]
struct Mark {
    amplitudes: Vec<f64>,
    forces: Vec<f64>,
    parts: Vec<Part>,
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
