//! Active rows: sums of displacement components on which forces stand for excess, and what loads and forces on the others do to each.

use crate::fem::dofs::HELD;
use crate::fem::factor::{Asked, Block};
use crate::fem::many::WIDEST;
use crate::fem::model::Model;
use crate::fem::workspace::Workspace;

/// A sum of displacement components.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Functional(
    /// Component (`2 node` for x, `2 node + 1` for y) and its weight.
    pub Vec<(usize, f64)>,
);

/// Forces of a load pattern on displacement components, numbered as those of a [`Functional`] [N/m]; no component more than once.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LoadPattern(
    /// Component and force.
    pub Vec<(usize, f64)>,
);

impl LoadPattern {
    /// Of forces on all components.
    #[must_use]
    pub fn of_all(forces: &[f64]) -> LoadPattern {
        LoadPattern(forces.iter().copied().enumerate().filter(|(_, force)| *force != 0.0).collect())
    }

    /// Its forces on the equations, in ascending order.
    pub(super) fn on_equations(&self, model: &Model) -> Vec<(u32, f64)> {
        let equation = |&(component, force): &(usize, f64)| (model.dofs().equation(component), force);
        let mut forces: Vec<(u32, f64)> = self.0.iter().map(equation).collect();
        forces.retain(|(equation, force)| *equation != HELD && *force != 0.0);
        forces.sort_unstable_by_key(|(equation, _)| *equation);
        forces
    }
}

/// A functional on the free components.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Equations and weights.
    terms: Vec<(u32, f64)>,
    /// Value when the run began, held components included.
    pub start: f64,
}

impl Row {
    pub fn new(model: &Model, functional: &Functional, displacements: &[f64]) -> Row {
        let equation = |&(component, weight): &(usize, f64)| (model.dofs().equation(component), weight);
        Row {
            terms: functional.0.iter().map(equation).filter(|(equation, _)| *equation != HELD).collect(),
            start: functional.0.iter().map(|&(component, weight)| weight * displacements[component]).sum(),
        }
    }

    /// Equations and weights.
    pub fn terms(&self) -> &[(u32, f64)] {
        &self.terms
    }

    /// Its change in a solution.
    #[inline]
    pub fn of(&self, block: &Block, lane: usize) -> f64 {
        self.terms.iter().map(|&(equation, weight)| weight * block.of(equation)[lane]).sum()
    }

    /// Its changes in the first solutions.
    fn read(&self, block: &Block, changes: &mut [f64]) {
        changes.fill(0.0);
        for &(equation, weight) in &self.terms {
            changes.iter_mut().zip(block.of(equation)).for_each(|(change, value)| *change += weight * value);
        }
    }

    /// Its change in one solution.
    fn among(&self, solution: &[f64]) -> f64 {
        self.terms.iter().map(|&(equation, weight)| weight * solution[equation as usize]).sum()
    }

    /// Adds a force on it to a right-hand side.
    pub fn push(&self, right: &mut Vec<(u32, f64)>, force: f64) {
        right.extend(self.terms.iter().map(|&(equation, weight)| (equation, weight * force)));
    }
}

/// The active rows.
#[derive(Debug, Default)]
pub(super) struct Rows {
    list: Vec<Row>,
    /// `G`: for each row what a unit force on it does to all of them.
    answers: Vec<Vec<f64>>,
    /// `H`: for each pattern what it does to all of them.
    moved: Vec<Vec<f64>>,
    /// Solutions for the patterns that load more than [`FEW`] equations.
    broad: Vec<Option<Vec<f64>>>,
    /// Equations that rows read, and those that other patterns load.
    asked: Asked,
}

/// Equations that a pattern may load for its `H` to be read from the solutions of the rows, which then have to be found there.
const FEW: usize = 100;

impl Rows {
    pub fn new(patterns: usize) -> Rows {
        Rows { moved: vec![Vec::new(); patterns], ..Rows::default() }
    }

    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn list(&self) -> &[Row] {
        &self.list
    }

    /// What a unit force on a row does to all of them.
    #[inline]
    pub fn answers(&self, row: usize) -> &[f64] {
        &self.answers[row]
    }

    /// `G` by rows.
    pub fn all(&self) -> &[Vec<f64>] {
        &self.answers
    }

    /// More rows take part: one solution for each. What patterns do to them, and what forces on the others do, needs no other, for the linear system
    /// is symmetric.
    pub fn join(&mut self, fresh: Vec<Row>, patterns: &[Vec<(u32, f64)>], work: &mut Workspace, block: &mut Block) {
        let first = self.list.len();
        self.list.extend(fresh);
        let all = self.list.len();
        self.answers.resize_with(all, || vec![0.0; all]);
        self.answers[..first].iter_mut().for_each(|answers| answers.resize(all, 0.0));
        self.moved.iter_mut().for_each(|moved| moved.resize(all, 0.0));
        if first == all {
            return;
        }
        self.solve_broad(patterns, work, block);
        let read = self.list[first..].iter().flat_map(|row| &row.terms);
        let loaded = patterns.iter().filter(|pattern| first == 0 && pattern.len() <= FEW).flatten();
        work.ask(&mut self.asked, read.chain(loaded).map(|(equation, _)| *equation));
        for start in (first..all).step_by(WIDEST) {
            let lanes = start..(start + WIDEST).min(all);
            let unit = |row: usize| {
                let mut right = Vec::new();
                self.list[row].push(&mut right, 1.0);
                right
            };
            work.solve_block_at(&lanes.clone().map(unit).collect::<Vec<_>>(), &self.asked, block);
            for (row, answers) in self.list.iter().zip(&mut self.answers) {
                row.read(block, &mut answers[lanes.clone()]);
            }
            for ((moved, pattern), broad) in self.moved.iter_mut().zip(patterns).zip(&self.broad) {
                let moved = &mut moved[lanes.clone()];
                if let Some(solution) = broad {
                    let rows = moved.iter_mut().zip(&self.list[lanes.clone()]);
                    rows.for_each(|(moved, row)| *moved = row.among(solution));
                    continue;
                }
                for &(equation, force) in pattern {
                    moved.iter_mut().zip(block.of(equation)).for_each(|(moved, value)| *moved += force * value);
                }
            }
        }
        let (known, fresh) = self.answers.split_at_mut(first);
        for (other, known) in known.iter().enumerate() {
            fresh.iter_mut().zip(&known[first..]).for_each(|(answers, answer)| answers[other] = *answer);
        }
    }

    /// Solves for the patterns that load many equations, once.
    fn solve_broad(&mut self, patterns: &[Vec<(u32, f64)>], work: &mut Workspace, block: &mut Block) {
        if !self.broad.is_empty() {
            return;
        }
        self.broad = patterns.iter().map(|_| None).collect();
        let broad: Vec<usize> = (0..patterns.len()).filter(|&k| patterns[k].len() > FEW).collect();
        for some in broad.chunks(WIDEST) {
            work.solve_block(&some.iter().map(|&k| patterns[k].clone()).collect::<Vec<_>>(), block);
            for (lane, &k) in some.iter().enumerate() {
                self.broad[k] = Some((0..block.equations()).map(|equation| block.of(equation)[lane]).collect());
            }
        }
    }

    /// How far loads and forces on all rows move one.
    pub fn value(&self, row: usize, amplitudes: &[f64], forces: &[f64]) -> f64 {
        let loads = self.moved.iter().zip(amplitudes).map(|(moved, amplitude)| amplitude * moved[row]);
        loads.sum::<f64>() + dot(&self.answers[row], forces)
    }

    /// How far loads alone move each row.
    pub fn moved(&self, amplitudes: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.list.len()];
        add_multiples(&mut sums, self.moved.iter().map(Vec::as_slice).zip(amplitudes.iter().copied()));
        sums
    }

    /// Adds to `values` what forces on rows do to all of them.
    pub fn add_moves(&self, values: &mut [f64], forces: impl Iterator<Item = (usize, f64)>) {
        add_multiples(values, forces.map(|(row, force)| (self.answers[row].as_slice(), force)));
    }
}

/// Adds multiples of columns, eight at a time: what they are added to is read and written once for eight. Columns of which nothing is added are not
/// read. As wide as the processor's registers are, with the same bits for any of them.
pub(super) fn add_multiples<'c>(sums: &mut [f64], columns: impl Iterator<Item = (&'c [f64], f64)>) {
    widest(Multiples { sums, columns });
}

/// Does work with the widest registers of the processor.
pub(super) fn widest<W: pulp::NullaryFnOnce>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(v4) = pulp::x86::V4::try_new() {
            return v4.vectorize(work);
        }
        if let Some(v3) = pulp::x86::V3::try_new() {
            return v3.vectorize(work);
        }
    }
    work.call()
}

struct Multiples<'s, I> {
    sums: &'s mut [f64],
    columns: I,
}

impl<'c, I: Iterator<Item = (&'c [f64], f64)>> pulp::NullaryFnOnce for Multiples<'_, I> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Multiples { sums, columns } = self;
        let mut some = columns.filter(|(_, factor)| *factor != 0.0).fuse();
        loop {
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
        }
    }
}

/// Products of a vector with others, each as far as it goes, on top of what `found` has already. As wide as the processor's registers are, with the same
/// bits for any of them.
pub(super) fn dots<'c>(with: &[f64], others: impl Iterator<Item = &'c [f64]>, found: &mut Vec<f64>) {
    widest(Dots { with, others, found });
}

struct Dots<'d, I> {
    with: &'d [f64],
    others: I,
    found: &'d mut Vec<f64>,
}

impl<'c, I: Iterator<Item = &'c [f64]>> pulp::NullaryFnOnce for Dots<'_, I> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        const LANES: usize = 32;
        let Dots { with, others, found } = self;
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
    }
}

/// Eight running sums, in a fixed order: as fast as memory gives the numbers.
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
