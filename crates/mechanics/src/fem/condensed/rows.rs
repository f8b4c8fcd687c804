//! Retained rows: sums of displacement components on which excess forces act, with the flexibility `G` between them and the
//! influence `H` of the load patterns on them.

use crate::fem::dofs::HELD;
use crate::fem::factor::Block;
use crate::fem::many::WIDEST;
use crate::fem::model::Model;
use crate::fem::workspace::Workspace;
use crate::watch::Asking;
use crate::wide::wide;

/// A weighted sum of displacement components: component (`2 node` for x, `2 node + 1` for y) and its weight.
pub type Functional = Vec<(usize, f64)>;

/// Forces of a load pattern on displacement components, which are numbered as those of a [`Functional`]: component and force [N/m]. No component
/// occurs twice.
pub type LoadPattern = Vec<(usize, f64)>;

/// Makes a pattern of forces on all components [N/m], without the zeros.
#[must_use]
pub fn load_pattern(forces: &[f64]) -> LoadPattern {
    forces.iter().copied().enumerate().filter(|(_, force)| *force != 0.0).collect()
}

/// Gives a pattern's forces by equations, in ascending order.
pub(super) fn on_equations(model: &Model, pattern: &[(usize, f64)]) -> Vec<(u32, f64)> {
    let mut forces = free_terms(model, pattern);
    forces.retain(|(_, force)| *force != 0.0);
    forces.sort_unstable_by_key(|(equation, _)| *equation);
    forces
}

/// Gives a sum of components by equations, without those that are held.
fn free_terms(model: &Model, terms: &[(usize, f64)]) -> Vec<(u32, f64)> {
    let equation = |&(component, weight): &(usize, f64)| (model.dofs.equation[component], weight);
    terms.iter().map(equation).filter(|(equation, _)| *equation != HELD).collect()
}

/// A functional by the equations of its free components.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Equations and weights: also the right-hand side of a unit force on the row.
    pub terms: Vec<(u32, f64)>,
    /// Value when the run began, held components included [m].
    pub start: f64,
}

impl Row {
    /// Makes the row of a functional; `displacements` are those of all components when the run began [m].
    pub(super) fn new(model: &Model, functional: &[(usize, f64)], displacements: &[f64]) -> Row {
        Row {
            terms: free_terms(model, functional),
            start: functional.iter().map(|&(component, weight)| weight * displacements[component]).sum(),
        }
    }

    /// Gives the change of the row's value in one solution of a block [m].
    #[inline]
    pub(super) fn change_in(&self, block: &Block, lane: usize) -> f64 {
        self.terms.iter().map(|&(equation, weight)| weight * block.of(equation)[lane]).sum()
    }

    /// Gives the changes of the row's value in the first solutions of a block [m].
    fn changes_in(&self, block: &Block, changes: &mut [f64]) {
        changes.fill(0.0);
        for &(equation, weight) in &self.terms {
            changes.iter_mut().zip(block.of(equation)).for_each(|(change, value)| *change += weight * value);
        }
    }
}

/// The retained rows.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// In the order in which they were retained.
    pub list: Vec<Row>,
    /// `G`, by rows: row values for a unit force on another row [m²/N]. It is symmetric.
    pub flexibility: Vec<Vec<f64>>,
    /// `H`, by patterns: row values for a pattern of amplitude one [m].
    influence: Vec<Vec<f64>>,
    /// Solutions for the patterns that load more than [`WIDE_PATTERN`] equations; `None` for the others.
    wide_solutions: Vec<Option<Vec<f64>>>,
    /// Equations at which solutions are needed: those that rows read, and those that the other patterns load.
    needed: Vec<bool>,
}

/// A pattern that loads more equations than this is solved for by itself. The `H` of the others is read from the solutions of the
/// rows, which are found at the equations that they load, too.
const WIDE_PATTERN: usize = 100;

impl Rows {
    /// Makes an empty set of rows for a number of patterns.
    pub(super) fn new(patterns: usize) -> Rows {
        Rows { influence: vec![Vec::new(); patterns], ..Rows::default() }
    }

    /// Gives the number of rows.
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// Retains more rows, with one solution of the linear system for each. As the linear system is symmetric, the same solutions
    /// give the entries of `G` and `H` between new and old rows, and patterns. Where `asking` stops, entries are left out.
    pub(super) fn append(
        &mut self,
        fresh: Vec<Row>,
        patterns: &[Vec<(u32, f64)>],
        work: &mut Workspace,
        block: &mut Block,
        asking: &mut Asking<'_>,
    ) {
        let first = self.list.len();
        self.list.extend(fresh);
        let all = self.list.len();
        self.flexibility.resize_with(all, || vec![0.0; all]);
        self.flexibility[..first].iter_mut().for_each(|flexibility| flexibility.resize(all, 0.0));
        self.influence.iter_mut().for_each(|influence| influence.resize(all, 0.0));
        if first == all {
            return;
        }
        self.solve_wide_patterns(patterns, work, block);
        let read = self.list[first..].iter().flat_map(|row| &row.terms);
        let loaded = patterns.iter().filter(|pattern| first == 0 && pattern.len() <= WIDE_PATTERN).flatten();
        work.solver.ask(&mut self.needed, read.chain(loaded).map(|(equation, _)| *equation));
        for start in (first..all).step_by(WIDEST) {
            if asking.stops() {
                return;
            }
            let lanes = start..(start + WIDEST).min(all);
            let units: Vec<_> = self.list[lanes.clone()].iter().map(|row| row.terms.clone()).collect();
            work.solver.solve_block(&units, Some(&self.needed), block);
            for (row, flexibility) in self.list.iter().zip(&mut self.flexibility) {
                row.changes_in(block, &mut flexibility[lanes.clone()]);
            }
            for ((influence, pattern), wide) in self.influence.iter_mut().zip(patterns).zip(&self.wide_solutions) {
                let influence = &mut influence[lanes.clone()];
                if let Some(solution) = wide {
                    let term = |&(equation, weight): &(u32, f64)| weight * solution[equation as usize];
                    let rows = influence.iter_mut().zip(&self.list[lanes.clone()]);
                    rows.for_each(|(influence, row)| *influence = row.terms.iter().map(term).sum());
                    continue;
                }
                for &(equation, force) in pattern {
                    influence
                        .iter_mut()
                        .zip(block.of(equation))
                        .for_each(|(influence, value)| *influence += force * value);
                }
            }
        }
        let (known, fresh) = self.flexibility.split_at_mut(first);
        for (other, known) in known.iter().enumerate() {
            fresh.iter_mut().zip(&known[first..]).for_each(|(flexibility, entry)| flexibility[other] = *entry);
        }
    }

    /// Solves for the patterns that load many equations, once.
    fn solve_wide_patterns(&mut self, patterns: &[Vec<(u32, f64)>], work: &mut Workspace, block: &mut Block) {
        if !self.wide_solutions.is_empty() {
            return;
        }
        self.wide_solutions = patterns.iter().map(|_| None).collect();
        let wide: Vec<usize> = (0..patterns.len()).filter(|&k| patterns[k].len() > WIDE_PATTERN).collect();
        for some in wide.chunks(WIDEST) {
            work.solver.solve_block(&some.iter().map(|&k| patterns[k].clone()).collect::<Vec<_>>(), None, block);
            for (lane, &k) in some.iter().enumerate() {
                self.wide_solutions[k] = Some(block.solution(lane));
            }
        }
    }

    /// Gives the change of one row's value [m] under loads of given `amplitudes` and `forces` on all rows [N/m].
    pub(super) fn row_change(&self, row: usize, amplitudes: &[f64], forces: &[f64]) -> f64 {
        let loads = self.influence.iter().zip(amplitudes).map(|(influence, amplitude)| amplitude * influence[row]);
        loads.sum::<f64>() + dot(&self.flexibility[row], forces)
    }

    /// Gives the changes of all row values under loads alone, `H a` [m].
    pub(super) fn load_changes(&self, amplitudes: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.list.len()];
        add_multiples(&mut sums, self.influence.iter().map(Vec::as_slice).zip(amplitudes.iter().copied()));
        sums
    }

    /// Adds to `values` the changes of all row values under forces on some rows, `G f` [m].
    pub(super) fn add_row_changes(&self, values: &mut [f64], forces: impl Iterator<Item = (usize, f64)>) {
        add_multiples(values, forces.map(|(row, force)| (self.flexibility[row].as_slice(), force)));
    }
}

/// Adds multiples of columns to `sums`, eight columns at a time, so that `sums` is read and written once for eight. Columns with
/// a factor of zero are not read. The code is as wide as the processor's registers, with the same bits for any width.
pub(super) fn add_multiples<'c>(sums: &mut [f64], columns: impl Iterator<Item = (&'c [f64], f64)>) {
    let mut some = columns.filter(|(_, factor)| *factor != 0.0).fuse();
    wide(
        #[inline(always)]
        || loop {
            let eight: [_; 8] = std::array::from_fn(|_| some.next());
            match eight {
                [
                    Some((a, fa)),
                    Some((b, fb)),
                    Some((c, fc)),
                    Some((d, fd)),
                    Some((e, fe)),
                    Some((f, ff)),
                    Some((g, fg)),
                    Some((h, fh)),
                ] => {
                    let all = sums.iter_mut().zip(a).zip(b).zip(c).zip(d).zip(e).zip(f).zip(g).zip(h);
                    for ((((((((sum, a), b), c), d), e), f), g), h) in all {
                        *sum += ((fa * a + fb * b) + (fc * c + fd * d)) + ((fe * e + ff * f) + (fg * g + fh * h));
                    }
                }
                few => {
                    for (column, factor) in few.into_iter().flatten() {
                        sums.iter_mut().zip(column).for_each(|(sum, entry)| *sum += factor * entry);
                    }
                    return;
                }
            }
        },
    );
}

/// Appends to `found` the dot products of a vector with others, each over the shorter of the two lengths. The code is as wide as
/// the processor's registers, with the same bits for any width.
pub(super) fn dots<'c>(with: &[f64], others: impl Iterator<Item = &'c [f64]>, found: &mut Vec<f64>) {
    const LANES: usize = 32;
    wide(
        #[inline(always)]
        || {
            for other in others {
                let count = with.len().min(other.len());
                let whole = count - count % LANES;
                let mut sums = [0.0; LANES];
                for (a, b) in with[..whole].chunks_exact(LANES).zip(other[..whole].chunks_exact(LANES)) {
                    for k in 0..LANES {
                        sums[k] += a[k] * b[k];
                    }
                }
                let rest: f64 = with[whole..count].iter().zip(&other[whole..count]).map(|(a, b)| a * b).sum();
                found.push(sums.iter().sum::<f64>() + rest);
            }
        },
    );
}

/// Gives a dot product by eight running sums in a fixed order: as fast as memory gives the numbers.
#[inline]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}
