//! A dense simplex method for few unknowns and many rows: greatest last unknown with `a z <= b` for every row.
//!
//! It works on the dual side. A basis of as many rows as unknowns, with multipliers that are not negative, is a mechanism
//! and gives an upper bound; rows that its corner violates enter until there are none, and the corner is then admissible:
//! both bounds meet. The mechanism's multipliers depend on the load only through one number, the work of the load. So a
//! basis that was best for one load is a start for every other load that does work on it.

use super::inverse::{Inverse, dot};
use super::rows::Rows;
use crate::watch::CancelToken;

/// The best corner.
#[derive(Debug, Clone)]
pub(super) struct Corner {
    /// Unknowns; the last one is what was to be made greatest.
    pub z: Vec<f64>,
    /// Rows of the basis and their multipliers.
    pub basis: Vec<(usize, f64)>,
    /// The whole basis, to start from again.
    pub start: Start,
    /// What the multipliers give: the upper bound.
    pub upper: f64,
    /// Exchanges of rows.
    pub pivots: usize,
}

/// A whole basis, to start from. It holds more than rows where the load leaves some unknowns alone.
#[derive(Debug, Clone)]
pub(super) struct Start {
    pub members: Vec<Member>,
    /// The inverse of their rows with the last column of the load that the basis was best for.
    inverse: Option<Inverse>,
}

impl Start {
    /// Of members whose inverse is not known.
    pub(super) fn of(members: Vec<Member>) -> Start {
        Start { members, inverse: None }
    }

    /// With rows in the place of members, each named by its number in the basis; none where that is no basis with multipliers.
    pub(super) fn with(&self, swaps: &[(usize, usize)], rows: &Rows, last: &[f64]) -> Option<Start> {
        let (mut members, mut inverse) = (self.members.clone(), self.inverse.clone()?);
        let mut row = vec![0.0; rows.width + 1];
        for &(leaving, entering) in swaps {
            members[leaving] = Member::Row(entering);
            coefficients(rows, last, members[leaving], &mut row);
            let weights = inverse.transposed_times(&row);
            if !(weights[leaving].abs() > TURNS) {
                return None;
            }
            inverse.exchange(leaving, &weights);
        }
        may_begin(&members, &inverse).then_some(Start { members, inverse: Some(inverse) })
    }
}

/// Whether multipliers bound the load: what is fixed has none, and a basis that bounds nothing is none.
fn may_begin(members: &[Member], inverse: &Inverse) -> bool {
    let may = |(member, y): (&Member, &f64)| match member {
        Member::Row(_) => *y >= -NOTHING,
        Member::Fixed(_) => y.abs() <= 1e-12,
        Member::Far => false,
    };
    members.iter().zip(inverse.multipliers()).all(may)
}

/// How a search ended.
#[derive(Debug, Clone)]
pub(super) enum Ended {
    /// At the best corner.
    Best(Corner),
    /// No row bounds the last unknown.
    Unbounded,
    /// Round-off, too many exchanges, or the end of the work.
    Lost,
}

/// A row of a basis: one of the rows, or a bound that only starts the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Member {
    /// One of the rows.
    Row(usize),
    /// `z_j = 0`, in force until a row takes its place.
    Fixed(usize),
    /// Last unknown at most [`FAR`].
    Far,
}

/// Beyond any factor that counts: scaled loads sum to one at a factor of one.
const FAR: f64 = 1e7;
/// Slack below which a row counts as violated; scaled forces are of the order of one.
const SLACK: f64 = 1e-11;
/// Coefficients below this do not turn a basis.
const PIVOT: f64 = 1e-9;
/// Multipliers between this and nothing are round-off: those of tangents that lie close together are known no better.
const NOTHING: f64 = 1e-9;
/// A row takes the place of a member that it is a sum of others without, where its share is larger than this.
const TURNS: f64 = 1e-3;
/// The inverse is made anew after so many changes, before round-off gathers in it.
const REFRESH: usize = 40;

/// Finds the best corner. `last` is the last column; `start` a basis to begin with, where there is one.
pub(super) fn greatest(rows: &Rows, last: &[f64], start: Option<&Start>, token: &CancelToken) -> Ended {
    if let Some(start) = start
        && let Some(search) = Search::new(rows, last, start.clone(), token)
        && may_begin(&search.members, &search.inverse)
    {
        match search.run() {
            Ended::Lost => {}
            ended => return ended,
        }
    }
    let fixed = (0..rows.width).map(Member::Fixed).chain([Member::Far]).collect();
    Search::new(rows, last, Start::of(fixed), token).map_or(Ended::Lost, Search::run)
}

struct Search<'a> {
    rows: &'a Rows,
    last: &'a [f64],
    size: usize,
    members: Vec<Member>,
    /// Their rows, one after the other, and their right sides: `matrix z = right` at the corner.
    matrix: Vec<f64>,
    right: Vec<f64>,
    inverse: Inverse,
    /// The corner of the basis.
    z: Vec<f64>,
    pivots: usize,
    token: &'a CancelToken,
}

impl<'a> Search<'a> {
    fn new(rows: &'a Rows, last: &'a [f64], start: Start, token: &'a CancelToken) -> Option<Self> {
        let size = rows.width + 1;
        let Start { members, inverse } = start;
        let known = inverse.is_some();
        let mut this = Search {
            rows,
            last,
            size,
            matrix: vec![0.0; size * size],
            right: vec![0.0; size],
            inverse: inverse.unwrap_or_default(),
            z: vec![0.0; size],
            members,
            pivots: 0,
            token,
        };
        for (k, to) in this.matrix.chunks_exact_mut(size).enumerate() {
            this.right[k] = coefficients(rows, last, this.members[k], to);
        }
        if !known || !this.inverse.with_last(this.matrix.iter().skip(size - 1).step_by(size)) {
            this.refresh()?;
        }
        Some(this)
    }

    fn refresh(&mut self) -> Option<()> {
        self.inverse = Inverse::of(&self.matrix, self.size)?;
        Some(())
    }

    fn run(mut self) -> Ended {
        let most = 60 * self.size + 400;
        loop {
            self.inverse.times(&self.right, &mut self.z);
            let careful = self.pivots > 30 * self.size + 200;
            let Some(entering) = self.violated(careful) else {
                // Nothing is violated, but for the round-off that gathered.
                if self.refined() {
                    return self.done();
                }
                if self.refresh().is_none() {
                    return Ended::Lost;
                }
                continue;
            };
            self.pivots += 1;
            if self.pivots > most || !self.token.iterate() || !self.exchange(entering) {
                return Ended::Lost;
            }
            if self.inverse.changes >= REFRESH && self.refresh().is_none() {
                return Ended::Lost;
            }
        }
    }

    /// The row that the corner violates most; with `careful`, the first, so that no circle can close.
    fn violated(&self, careful: bool) -> Option<usize> {
        let (x, factor) = (&self.z[..self.size - 1], self.z[self.size - 1]);
        let may = |k| !self.members.contains(&Member::Row(k));
        self.rows.violated(self.last, (x, factor), -SLACK * (1.0 + factor.abs()), careful, may)
    }

    /// Takes what the inverse missed out of the corner and the multipliers; false where that is more than the inverse may miss.
    fn refined(&mut self) -> bool {
        let n = self.size;
        let missing: Vec<f64> =
            self.matrix.chunks_exact(n).zip(&self.right).map(|(row, b)| b - dot(row, &self.z)).collect();
        let mut change = vec![0.0; n];
        self.inverse.times(&missing, &mut change);
        self.z.iter_mut().zip(&change).for_each(|(z, d)| *z += d);
        // What no row can be violated by through it, next to what counts as violated.
        let moved: f64 = change.iter().map(|d| d.abs()).sum();
        let largest = self.rows.largest.max(self.last.iter().fold(0.0, |most, a| a.abs().max(most)));
        let fresh = self.inverse.changes == 0;
        (fresh || moved * largest <= 0.1 * SLACK * (1.0 + self.z[n - 1].abs()))
            && self.inverse.refine_multipliers(&self.matrix)
    }

    /// Lets a row into the basis; false where no member can leave.
    fn exchange(&mut self, entering: usize) -> bool {
        let n = self.size;
        let mut row = vec![0.0; n];
        let right = coefficients(self.rows, self.last, Member::Row(entering), &mut row);
        // The entering row as a sum of the members' rows.
        let weights = self.inverse.transposed_times(&row);
        let y = self.inverse.multipliers();
        let mut leaving = None;
        // A bound that only starts the search leaves at once; its multiplier is zero.
        let mut largest = 1e-7;
        for (k, member) in self.members.iter().enumerate() {
            if matches!(member, Member::Fixed(_)) && weights[k].abs() > largest {
                (largest, leaving) = (weights[k].abs(), Some(k));
            }
        }
        if leaving.is_none() {
            let mut least = f64::INFINITY;
            for k in 0..n {
                if weights[k] > PIVOT && !matches!(self.members[k], Member::Fixed(_)) {
                    let ratio = y[k].max(0.0) / weights[k];
                    let tie = ratio <= least * (1.0 + 1e-12) + 1e-300;
                    let better = leaving.is_none_or(|l: usize| weights[k] > weights[l]);
                    if ratio < least * (1.0 - 1e-12) || (tie && better) {
                        least = least.min(ratio);
                        leaving = Some(k);
                    }
                }
            }
        }
        let Some(leaving) = leaving else { return false };
        self.inverse.exchange(leaving, &weights);
        self.members[leaving] = Member::Row(entering);
        self.matrix[leaving * n..][..n].copy_from_slice(&row);
        self.right[leaving] = right;
        self.inverse.multipliers().iter().all(|y| y.is_finite())
    }

    fn done(self) -> Ended {
        let mut basis = Vec::with_capacity(self.size);
        let mut upper = 0.0;
        for (&member, &y) in self.members.iter().zip(self.inverse.multipliers()) {
            match member {
                Member::Row(k) => {
                    if y < -NOTHING {
                        return Ended::Lost;
                    }
                    basis.push((k, y.max(0.0)));
                    upper += y.max(0.0) * self.rows.b[k];
                }
                Member::Far if y > 1e-9 => return Ended::Unbounded,
                Member::Far => {}
                Member::Fixed(_) if y.abs() > 1e-9 => return Ended::Lost,
                Member::Fixed(_) => {}
            }
        }
        let start = Start { members: self.members, inverse: Some(self.inverse) };
        Ended::Best(Corner { z: self.z, basis, upper, start, pivots: self.pivots })
    }
}

/// Writes the row of a member; its right side.
fn coefficients(rows: &Rows, last: &[f64], member: Member, row: &mut [f64]) -> f64 {
    let (own, of_last) = row.split_at_mut(rows.width);
    own.fill(0.0);
    of_last[0] = match member {
        Member::Row(k) => {
            own.iter_mut().zip(rows.row(k)).for_each(|(to, a)| *to = a);
            last[k]
        }
        Member::Fixed(j) => {
            own[j] = 1.0;
            0.0
        }
        Member::Far => 1.0,
    };
    match member {
        Member::Row(k) => rows.b[k],
        Member::Fixed(_) => 0.0,
        Member::Far => FAR,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(list: &[([f64; 2], f64)]) -> (Rows, Vec<f64>) {
        let mut rows = Rows::new(1);
        list.iter().for_each(|(a, b)| rows.push([a[0]], *b));
        (rows, list.iter().map(|r| r.0[1]).collect())
    }

    #[test]
    fn a_triangle_has_its_top() {
        // y <= 2 - x, y <= 1 + x, y <= 10: the top is at x = 0.5, y = 1.5.
        let (rows, last) = rows(&[([1.0, 1.0], 2.0), ([-1.0, 1.0], 1.0), ([0.0, 1.0], 10.0)]);
        let [a, b, c] = [0, 1, 2].map(Member::Row);
        for start in [None, Some(Start::of(vec![a, b])), Some(Start::of(vec![a, c]))] {
            let Ended::Best(corner) = greatest(&rows, &last, start.as_ref(), &CancelToken::default()) else {
                panic!("{start:?}")
            };
            assert!((corner.z[0] - 0.5).abs() < 1e-14 && (corner.z[1] - 1.5).abs() < 1e-14);
            assert!((corner.upper - 1.5).abs() < 1e-14);
        }
    }

    #[test]
    fn what_nothing_bounds_is_unbounded() {
        let (rows, last) = rows(&[([1.0, 0.0], 2.0), ([-1.0, 0.0], 1.0)]);
        assert!(matches!(greatest(&rows, &last, None, &CancelToken::default()), Ended::Unbounded));
    }
}
