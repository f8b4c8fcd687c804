//! Factorisation of the tangent: found symbolically once, computed anew for each tangent.

use super::gmres;
use super::many::{self, WIDEST, WIDTHS};
use super::pattern::Pattern;
use super::unsymmetric::Whole;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
use thiserror::Error;

/// Residual of a solution over its right-hand side beyond which it counts as none.
const LARGEST_RESIDUAL: f64 = 1e-6;

/// Residual over the terms that it is the sum of, |A| |x|, below which it is rounding; and these terms over the right-hand side beyond which the
/// matrix has no inverse that numbers could show. Between a stiff joint's terms and the load on soft ground there may be ten orders of magnitude.
const ROUNDING: f64 = 1e-13;
const LARGEST_TERMS: f64 = 1e13;

/// Equations below which the library chooses how the factor is kept. Above, it is kept in dense blocks, which solutions for many right-hand sides go
/// through side by side: an evaluation of 13,614 equations for updating takes 0.42 s that way and 1.02 s where the library chooses.
const SMALL: usize = 500;

/// Entries of right-hand sides that are brought to their places one after the other.
const FEW: usize = 64;

/// Why there is no factorisation or no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum FactorError {
    /// The tangent has no inverse, or none that numbers could show.
    #[error("the stiffness has no inverse: a part can move without resistance")]
    Singular,
    /// There is an inverse, but not to the accuracy of numbers.
    #[error(
        "the stiffness is too ill-conditioned for double precision: some joint or element is too many times as stiff as what it stands on"
    )]
    IllConditioned,
    /// The factor does not fit into memory.
    #[error("the factor of {0} equations does not fit into memory")]
    Memory(usize),
}

/// What the values at hand are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Nothing,
    /// L L^T: the symmetric part is positive definite.
    Definite,
    /// L D L^T: it is not.
    Indefinite,
}

/// Factorises the symmetric part of the tangent, and solves with it.
///
/// A tangent that is not symmetric is solved for by GMRES with that factor as preconditioner (see `gmres.rs`), and where that does not
/// get there, or the symmetric part is not positive definite, by factorising the whole.
pub(super) struct Solver {
    symbolic: SymbolicCholesky<u32>,
    /// Entries of the factor.
    pub values: Vec<f64>,
    memory: MemBuffer,
    kind: Kind,
    /// Made when it is needed first.
    whole: Option<Box<Whole>>,
}

/// Solutions side by side.
#[derive(Debug, Clone, Default)]
pub(super) struct Block {
    /// Right-hand sides, those that were not asked for included: their solutions are zero.
    pub width: usize,
    pub lanes: Vec<f64>,
    /// Place of an equation among them; none where they stand in order.
    pub place: Vec<u32>,
}

impl Block {
    #[inline]
    fn start(&self, equation: u32) -> usize {
        self.width * self.place.get(equation as usize).copied().unwrap_or(equation) as usize
    }

    fn at(&mut self, equation: u32) -> &mut [f64] {
        let start = self.start(equation);
        &mut self.lanes[start..start + self.width]
    }

    /// Adds multiples of `force` on an equation to the first right-hand sides.
    #[inline]
    pub(super) fn add(&mut self, equation: u32, force: f64, multiples: &[f64]) {
        self.at(equation).iter_mut().zip(multiples).for_each(|(lane, multiple)| *lane += force * multiple);
    }

    /// One of the solutions, by equations.
    pub(super) fn solution(&self, lane: usize) -> Vec<f64> {
        let equations = self.lanes.len() / self.width.max(1);
        (0..equations as u32).map(|equation| self.of(equation)[lane]).collect()
    }

    /// Goes on beyond the last of `count` solutions, which are on a way, by so many steps like the last few. What is found takes the place of another solution.
    pub(super) fn extend_beyond(&mut self, count: usize, few: usize, steps: usize, into: usize) {
        let before = (count - 1).saturating_sub(few);
        let share = steps as f64 / (count - 1 - before) as f64;
        for lanes in self.lanes.chunks_exact_mut(self.width) {
            lanes[into] = lanes[count - 1] + share * (lanes[count - 1] - lanes[before]);
        }
    }

    /// Values of an equation, one for each right-hand side.
    #[inline]
    pub(super) fn of(&self, equation: u32) -> &[f64] {
        let start = self.start(equation);
        &self.lanes[start..start + self.width]
    }
}

impl Solver {
    /// Orders the equations (AMD) and finds the pattern of the factor.
    pub(super) fn new(pattern: &Pattern) -> Result<Solver, FactorError> {
        let count = pattern.columns.len() - 1;
        let matrix = structure(pattern);
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: if count < SMALL {
                SupernodalThreshold::AUTO
            } else {
                SupernodalThreshold::FORCE_SUPERNODAL
            },
            ..CholeskySymbolicParams::default()
        };
        let symbolic = factorize_symbolic_cholesky(matrix, Side::Lower, SymmetricOrdering::Amd, parameters)
            .map_err(|_| FactorError::Memory(count))?;
        let need = StackReq::any_of(&[
            symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default()),
            symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default()),
            symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
        ]);
        let memory = MemBuffer::try_new(need).map_err(|_| FactorError::Memory(count))?;
        let mut values = Vec::new();
        values.try_reserve_exact(symbolic.len_val()).map_err(|_| FactorError::Memory(count))?;
        values.resize(symbolic.len_val(), 0.0);
        Ok(Solver { symbolic, values, memory, kind: Kind::Nothing, whole: None })
    }

    /// Factorises; tells whether the symmetric part is positive definite.
    pub(super) fn factorise(&mut self, pattern: &Pattern, values: &[f64]) -> Result<bool, FactorError> {
        self.kind = Kind::Nothing;
        let values = &values[..pattern.entries()];
        if !values.iter().all(|value| value.is_finite()) {
            return Err(FactorError::Singular);
        }
        let kinds = [Kind::Definite, Kind::Indefinite];
        let done = kinds.into_iter().find(|kind| self.factorised_as(*kind, pattern, values));
        self.kind = done.ok_or(FactorError::Singular)?;
        Ok(self.kind == Kind::Definite)
    }

    /// Whether there is a factor of this kind, all of it finite.
    fn factorised_as(&mut self, kind: Kind, pattern: &Pattern, values: &[f64]) -> bool {
        let matrix = SparseColMatRef::new(structure(pattern), values);
        let (to, stack, side) = (&mut self.values, MemStack::new(&mut self.memory), Side::Lower);
        let plain = Default::default();
        let done = match kind {
            Kind::Nothing => false,
            Kind::Definite => {
                let rule = LltRegularization::default();
                self.symbolic.factorize_numeric_llt(to, matrix, side, rule, Par::Seq, stack, plain).is_ok()
            }
            Kind::Indefinite => {
                let (rule, plain) = (LdltRegularization::default(), Default::default());
                self.symbolic.factorize_numeric_ldlt(to, matrix, side, rule, Par::Seq, stack, plain).is_ok()
            }
        };
        done && self.values.iter().all(|value| value.is_finite())
    }

    /// `x` becomes the inverse of the factorised symmetric part times `x`.
    pub(super) fn apply(&mut self, x: &mut [f64]) {
        let (rows, stack) = (x.len(), MemStack::new(&mut self.memory));
        let right = MatMut::from_column_major_slice_mut(x, rows, 1);
        let (symbolic, values, par) = (&self.symbolic, &self.values[..], Par::Seq);
        match self.kind {
            Kind::Nothing => {}
            Kind::Definite => LltRef::new(symbolic, values).solve_in_place_with_conj(Conj::No, right, par, stack),
            Kind::Indefinite => LdltRef::new(symbolic, values).solve_in_place_with_conj(Conj::No, right, par, stack),
        }
    }

    /// Solves for sparse right-hand sides, each a list of equation and value, at most the largest of [`WIDTHS`] at once; overwrites `block`.
    ///
    /// Where only some equations are `asked` for, the block holds their solutions and nothing that could be read elsewhere.
    pub(super) fn solve_block(&mut self, right: &[Vec<(u32, f64)>], asked: Option<&[bool]>, block: &mut Block) {
        self.clear(right.len(), block);
        // A few entries of each at a time: they often stand in the same equations, which are at hand then.
        let longest = right.iter().map(Vec::len).max().unwrap_or(0);
        for first in (0..longest).step_by(FEW) {
            for (lane, entries) in right.iter().enumerate() {
                for &(equation, value) in entries.iter().skip(first).take(FEW) {
                    block.at(equation)[lane] += value;
                }
            }
        }
        self.solve_lanes(right.len(), asked, block);
    }

    /// Solutions for right-hand sides that `load` adds to an empty block.
    pub(super) fn solve_loaded(&mut self, count: usize, block: &mut Block, load: impl FnOnce(&mut Block)) {
        self.clear(count, block);
        load(block);
        self.solve_lanes(count, None, block);
    }

    fn clear(&self, count: usize, block: &mut Block) {
        block.width = WIDTHS.into_iter().find(|width| *width >= count).unwrap_or(WIDEST);
        block.lanes.clear();
        block.lanes.resize(block.width * self.symbolic.nrows(), 0.0);
        block.place = self.symbolic.perm().map(|perm| perm.arrays().1.to_vec()).unwrap_or_default();
    }

    fn solve_lanes(&mut self, count: usize, asked: Option<&[bool]>, block: &mut Block) {
        match (self.symbolic.raw(), self.kind) {
            (SymbolicCholeskyRaw::Supernodal(symbolic), Kind::Definite) => {
                let wanted = asked.filter(|wanted| !wanted.is_empty());
                many::solve(symbolic, &self.values, block.width, &mut block.lanes, wanted);
            }
            _ => {
                for lane in 0..count {
                    let mut x = block.solution(lane);
                    self.apply(&mut x);
                    x.iter().enumerate().for_each(|(equation, value)| block.at(equation as u32)[lane] = *value);
                }
            }
        }
    }

    /// Solutions at these equations are asked for, too: `asked` marks the parts of the factor that they need, none where all are gone through anyway.
    pub(super) fn ask(&self, asked: &mut Vec<bool>, equations: impl Iterator<Item = u32>) {
        let place = self.symbolic.perm().map(|perm| perm.arrays().1);
        let place = |equation: u32| place.map_or(equation, |place| place[equation as usize]);
        if let SymbolicCholeskyRaw::Supernodal(symbolic) = self.symbolic.raw() {
            many::reach(symbolic, asked, equations.map(place));
        }
    }

    /// Solves with the tangent that was factorised last, whose values these are. `accuracy` is the residual over the right-hand side
    /// that is enough where the answer has to be sought by iteration.
    pub(super) fn solve(
        &mut self,
        pattern: &Pattern,
        (values, skew): (&[f64], &[f64]),
        right: &[f64],
        accuracy: f64,
    ) -> Result<Vec<f64>, FactorError> {
        if self.kind == Kind::Definite && skew.is_empty() {
            return self.direct(pattern, values, right);
        }
        let sound = |x: &[f64]| x.iter().all(|x| x.is_finite());
        if self.kind == Kind::Definite || skew.is_empty() {
            let goal = if skew.is_empty() { 1e-10 } else { accuracy };
            let matrix = |x: &[f64], out: &mut [f64]| pattern.multiply(values, skew, x, out);
            let (x, residual) = gmres::solve(matrix, |x| self.apply(x), right, goal);
            if residual <= LARGEST_RESIDUAL.max(goal) && sound(&x) {
                return Ok(x);
            }
            if skew.is_empty() {
                return judged(pattern, (values, skew), right, x, residual);
            }
        }
        if self.whole.is_none() {
            self.whole = Whole::new(pattern).map(Box::new);
        }
        let whole = self.whole.as_mut().ok_or(FactorError::Memory(right.len()))?;
        match whole.solve(pattern, (values, skew), right) {
            Some((x, residual)) if residual <= LARGEST_RESIDUAL && sound(&x) => Ok(x),
            Some((x, residual)) => judged(pattern, (values, skew), right, x, residual),
            None => Err(FactorError::Singular),
        }
    }

    /// A pivot that is nothing but rounding passes for positive; it shows in the residual. What is left of the right-hand side where the
    /// matrix is nearly singular is solved for again; where it has no inverse that does not help.
    fn direct(&mut self, pattern: &Pattern, values: &[f64], right: &[f64]) -> Result<Vec<f64>, FactorError> {
        const TIMES: usize = 3;
        let mut x = right.to_vec();
        self.apply(&mut x);
        let mut residual = f64::INFINITY;
        for time in 0..=TIMES {
            let mut rest: Vec<f64> = right.iter().map(|r| -r).collect();
            pattern.multiply(values, &[], &x, &mut rest);
            residual = gmres::norm(&rest) / gmres::norm(right).max(f64::MIN_POSITIVE);
            if residual <= LARGEST_RESIDUAL && x.iter().all(|x| x.is_finite()) {
                return Ok(x);
            }
            if time < TIMES {
                self.apply(&mut rest);
                x.iter_mut().zip(&rest).for_each(|(x, more)| *x -= more);
            }
        }
        judged(pattern, (values, &[]), right, x, residual)
    }
}

/// A solution whose residual is large beside the right-hand side: it stands where that is the rounding of its own terms, and these do not say that
/// something moves without resistance.
fn judged(
    pattern: &Pattern,
    (values, skew): (&[f64], &[f64]),
    right: &[f64],
    x: Vec<f64>,
    residual: f64,
) -> Result<Vec<f64>, FactorError> {
    let mut sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
    sizes.iter_mut().zip(skew).for_each(|(size, skew)| *size += skew.abs());
    let moved: Vec<f64> = x.iter().map(|x| x.abs()).collect();
    let mut terms = vec![0.0; x.len()];
    pattern.multiply(&sizes, &[], &moved, &mut terms);
    let terms = gmres::norm(&terms) / gmres::norm(right).max(f64::MIN_POSITIVE);
    if !(terms < LARGEST_TERMS && residual.is_finite()) {
        return Err(FactorError::Singular);
    }
    if residual <= ROUNDING * terms { Ok(x) } else { Err(FactorError::IllConditioned) }
}

fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let count = pattern.columns.len() - 1;
    SymbolicSparseColMatRef::new_checked(count, count, &pattern.columns, None, &pattern.rows)
}
