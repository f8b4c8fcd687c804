//! A dense simplex method for few unknowns and many rows: greatest last unknown with `a z <= b` for every row.
//!
//! It works on the dual side. A basis of as many rows as unknowns, with multipliers that are not negative, is a mechanism
//! and gives an upper bound; rows that its corner violates enter until there are none, and the corner is then admissible:
//! both bounds meet. The mechanism's multipliers depend on the load only through one number, the work of the load. So a
//! basis that was best for one load is a start for every other load that does work on it.

use super::rows::Rows;
use crate::watch::Pace;

/// The best corner.
#[derive(Debug, Clone)]
pub(super) struct Corner {
    /// Unknowns; the last one is what was to be made greatest.
    pub z: Vec<f64>,
    /// Rows of the basis and their multipliers.
    pub basis: Vec<(usize, f64)>,
    /// The whole basis, to start from again. It holds more than rows where the load leaves some unknowns alone.
    pub members: Vec<Member>,
    /// What the multipliers give: the upper bound.
    pub upper: f64,
    /// Exchanges of rows.
    pub pivots: usize,
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
/// The inverse is made anew after so many exchanges, before round-off gathers in it.
const REFRESH: usize = 40;

/// Finds the best corner. `last` is the last column; `start` the rows of a basis to begin with, where there is one.
pub(super) fn greatest(rows: &Rows, last: &[f64], start: Option<&[Member]>, pace: &Pace) -> Ended {
    if let Some(start) = start {
        // What is fixed has no multiplier; a basis that bounds nothing is none.
        let may = |(member, y): (&Member, &f64)| match member {
            Member::Row(_) => *y >= -1e-12,
            Member::Fixed(_) => y.abs() <= 1e-12,
            Member::Far => false,
        };
        if let Some(search) = Search::new(rows, last, start.to_vec(), pace)
            && search.members.iter().zip(&search.y).all(may)
        {
            match search.run() {
                Ended::Lost => {}
                ended => return ended,
            }
        }
    }
    let mut members: Vec<Member> = (0..rows.width()).map(Member::Fixed).collect();
    members.push(Member::Far);
    Search::new(rows, last, members, pace).map_or(Ended::Lost, Search::run)
}

struct Search<'a> {
    rows: &'a Rows,
    last: &'a [f64],
    size: usize,
    members: Vec<Member>,
    /// Inverse of the matrix whose rows are the members' rows, stored by rows: `z = inverse b`.
    inverse: Vec<f64>,
    /// Multipliers.
    y: Vec<f64>,
    pivots: usize,
    pace: &'a Pace,
}

impl<'a> Search<'a> {
    fn new(rows: &'a Rows, last: &'a [f64], members: Vec<Member>, pace: &'a Pace) -> Option<Self> {
        let size = rows.width() + 1;
        let mut this = Search { rows, last, size, members, inverse: Vec::new(), y: Vec::new(), pivots: 0, pace };
        this.refresh()?;
        Some(this)
    }

    fn coefficients(&self, member: Member) -> Vec<f64> {
        let mut row = vec![0.0; self.size];
        match member {
            Member::Row(k) => {
                row.iter_mut().zip(self.rows.row(k)).for_each(|(to, a)| *to = a);
                row[self.size - 1] = self.last[k];
            }
            Member::Fixed(j) => row[j] = 1.0,
            Member::Far => row[self.size - 1] = 1.0,
        }
        row
    }

    fn right_side(&self, member: Member) -> f64 {
        match member {
            Member::Row(k) => self.rows.b(k),
            Member::Fixed(_) => 0.0,
            Member::Far => FAR,
        }
    }

    /// Inverts the basis by Gauss and Jordan with the largest pivot of each column; none where it is singular.
    fn refresh(&mut self) -> Option<()> {
        let n = self.size;
        let mut m: Vec<Vec<f64>> = self.members.iter().map(|&member| self.coefficients(member)).collect();
        let mut inverse: Vec<Vec<f64>> =
            (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
        for column in 0..n {
            let mut pivot = column;
            for row in column + 1..n {
                if m[row][column].abs() > m[pivot][column].abs() {
                    pivot = row;
                }
            }
            let value = m[pivot][column];
            if !(value.abs() > 1e-13) {
                return None;
            }
            m.swap(column, pivot);
            inverse.swap(column, pivot);
            for v in m[column].iter_mut().chain(inverse[column].iter_mut()) {
                *v /= value;
            }
            let (pivot_row, pivot_inverse) = (m[column].clone(), inverse[column].clone());
            for row in (0..n).filter(|&row| row != column) {
                let factor = m[row][column];
                if factor != 0.0 {
                    m[row].iter_mut().zip(&pivot_row).for_each(|(v, p)| *v -= factor * p);
                    inverse[row].iter_mut().zip(&pivot_inverse).for_each(|(v, p)| *v -= factor * p);
                }
            }
        }
        self.inverse = inverse.concat();
        // y A = e_last: the last row of the inverse.
        self.y = self.inverse[(n - 1) * n..].to_vec();
        self.y.iter().all(|v| v.is_finite()).then_some(())
    }

    fn corner(&self) -> Vec<f64> {
        let b: Vec<f64> = self.members.iter().map(|&member| self.right_side(member)).collect();
        self.inverse.chunks_exact(self.size).map(|row| row.iter().zip(&b).map(|(a, b)| a * b).sum()).collect()
    }

    fn run(mut self) -> Ended {
        let most = 60 * self.size + 400;
        let mut since_refresh = 0;
        loop {
            let z = self.corner();
            let careful = self.pivots > 30 * self.size + 200;
            let Some(entering) = self.violated(&z, careful) else {
                // Nothing is violated: once more without the round-off of all exchanges.
                if since_refresh > 0 {
                    if self.refresh().is_none() {
                        return Ended::Lost;
                    }
                    since_refresh = 0;
                    continue;
                }
                return self.done(z);
            };
            self.pivots += 1;
            since_refresh += 1;
            if self.pivots > most || !self.pace.beat() || !self.exchange(entering) {
                return Ended::Lost;
            }
            if since_refresh >= REFRESH {
                if self.refresh().is_none() {
                    return Ended::Lost;
                }
                since_refresh = 0;
            }
        }
    }

    /// The row that the corner violates most; with `careful`, the first, so that no circle can close.
    fn violated(&self, z: &[f64], careful: bool) -> Option<usize> {
        let (x, factor) = (&z[..self.size - 1], z[self.size - 1]);
        let may = |k| !self.members.contains(&Member::Row(k));
        self.rows.violated(self.last, (x, factor), -SLACK * (1.0 + factor.abs()), careful, may)
    }

    /// Lets a row into the basis; false where no member can leave.
    fn exchange(&mut self, entering: usize) -> bool {
        let n = self.size;
        let row = self.coefficients(Member::Row(entering));
        // The entering row as a sum of the members' rows.
        let mut weights = vec![0.0; n];
        for (value, inverse) in row.iter().zip(self.inverse.chunks_exact(n)) {
            for (w, i) in weights.iter_mut().zip(inverse) {
                *w += value * i;
            }
        }
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
                    let ratio = self.y[k].max(0.0) / weights[k];
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
        let pivot = weights[leaving];
        for row in self.inverse.chunks_exact_mut(n) {
            let value = row[leaving] / pivot;
            for (v, w) in row.iter_mut().zip(&weights) {
                *v -= value * w;
            }
            row[leaving] = value;
        }
        self.members[leaving] = Member::Row(entering);
        self.y.copy_from_slice(&self.inverse[(n - 1) * n..]);
        self.y.iter().all(|y| y.is_finite())
    }

    fn done(self, z: Vec<f64>) -> Ended {
        let mut basis = Vec::with_capacity(self.size);
        let mut upper = 0.0;
        for (&member, &y) in self.members.iter().zip(&self.y) {
            match member {
                Member::Row(k) => {
                    if y < -1e-9 {
                        return Ended::Lost;
                    }
                    basis.push((k, y.max(0.0)));
                    upper += y.max(0.0) * self.rows.b(k);
                }
                Member::Far if y > 1e-9 => return Ended::Unbounded,
                Member::Far => {}
                Member::Fixed(_) if y.abs() > 1e-9 => return Ended::Lost,
                Member::Fixed(_) => {}
            }
        }
        Ended::Best(Corner { z, basis, upper, members: self.members, pivots: self.pivots })
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
        for start in [None, Some(&[a, b][..]), Some(&[a, c][..])] {
            let Ended::Best(corner) = greatest(&rows, &last, start, &Pace::default()) else { panic!("{start:?}") };
            assert!((corner.z[0] - 0.5).abs() < 1e-14 && (corner.z[1] - 1.5).abs() < 1e-14);
            assert!((corner.upper - 1.5).abs() < 1e-14);
        }
    }

    #[test]
    fn what_nothing_bounds_is_unbounded() {
        let (rows, last) = rows(&[([1.0, 0.0], 2.0), ([-1.0, 0.0], 1.0)]);
        assert!(matches!(greatest(&rows, &last, None, &Pace::default()), Ended::Unbounded));
    }
}
