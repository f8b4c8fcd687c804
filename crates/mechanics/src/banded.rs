//! A square matrix with a band about its diagonal, factorised with row exchanges. The band is as wide as it has to be at each row: a
//! pier between two spans makes it wider there alone.
//!
//! Rings of voussoirs have some tens to a thousand equations and a band of a few: the general sparse factorisation spends
//! most of its time there on its own bookkeeping.

/// Share of the largest possible pivot from which on a row is not exchanged: a tenth of the time of five rings.
const STAYS: f64 = 0.1;

/// The band, row by row: entry `(row, column)` stands at `row * width + column + below - row`. Row exchanges need room for
/// `below` more entries above the diagonal.
#[derive(Debug, Clone)]
pub(crate) struct Banded {
    /// Number of equations.
    pub size: usize,
    /// Most diagonals on either side of the main one.
    pub below: usize,
    width: usize,
    /// The last equation that this one or one before it acts with.
    pub last: Vec<u32>,
    entries: Vec<f64>,
    /// Multiples of row `k` that were taken off the `below` rows after it, from `k * below` on.
    taken: Vec<f64>,
    exchanged: Vec<u32>,
    /// Last column of each row that the factorisation has filled.
    reach: Vec<u32>,
    /// One over each pivot.
    inverse: Vec<f64>,
    /// Sign of the determinant; 0 where a pivot vanished.
    pub sign: i8,
}

impl Banded {
    /// A matrix of zeros. `last` tells of each equation the last one that it acts with.
    pub(crate) fn new(mut last: Vec<u32>) -> Banded {
        let size = last.len();
        for k in 0..size {
            last[k] = last[k].max(k as u32).max(k.checked_sub(1).map_or(0, |before| last[before]));
        }
        let below = last.iter().enumerate().map(|(k, &last)| last as usize - k).max().unwrap_or(0);
        let width = 3 * below + 1;
        Banded {
            size,
            below,
            width,
            last,
            entries: vec![0.0; size * width],
            taken: vec![0.0; size * below],
            exchanged: vec![0; size],
            reach: vec![0; size],
            inverse: vec![0.0; size],
            sign: 0,
        }
    }

    /// A row of a matrix that is not factorised, over all diagonals.
    pub(crate) fn about_diagonal(&self, row: usize) -> &[f64] {
        &self.entries[row * self.width..][..=2 * self.below]
    }

    /// Back to zeros.
    pub(crate) fn clear(&mut self) {
        self.entries.fill(0.0);
    }

    #[inline(always)]
    fn at(&self, row: usize, column: usize) -> usize {
        row * self.width + column + self.below - row
    }

    /// Adds a multiple of another matrix of the same shape, neither of them factorised.
    pub(crate) fn add_times(&mut self, other: &Banded, factor: f64) {
        for (to, from) in self.entries.iter_mut().zip(&other.entries) {
            *to += factor * from;
        }
    }

    /// The product with a vector, of a matrix that is not factorised.
    pub(crate) fn times(&self, vector: &[f64]) -> Vec<f64> {
        let row = |row: usize| {
            let columns = row.saturating_sub(self.below)..=(row + self.below).min(self.size - 1);
            columns.map(|column| self.entries[self.at(row, column)] * vector[column]).sum()
        };
        (0..self.size).map(row).collect()
    }

    /// Adds to an entry within the band.
    #[inline(always)]
    pub(crate) fn add(&mut self, row: usize, column: usize, value: f64) {
        let at = self.at(row, column);
        self.entries[at] += value;
    }

    /// Adds to neighbours in a row within the band.
    #[inline(always)]
    pub(crate) fn add_all<const N: usize>(&mut self, row: usize, column: usize, values: [f64; N]) {
        let at = self.at(row, column);
        for (entry, value) in self.entries[at..at + N].iter_mut().zip(values) {
            *entry += value;
        }
    }

    /// Factorises in place; `false` where a pivot vanishes.
    pub(crate) fn factorise(&mut self) -> bool {
        let (size, below) = (self.size, self.below);
        self.sign = 1;
        let mut right = 0;
        for k in 0..size {
            let last = self.last[k] as usize;
            let mut pivot = k;
            for row in k + 1..=last {
                if self.entries[self.at(row, k)].abs() > self.entries[self.at(pivot, k)].abs() {
                    pivot = row;
                }
            }
            // A row that serves well enough stays: exchanged rows reach further.
            if self.entries[self.at(k, k)].abs() >= STAYS * self.entries[self.at(pivot, k)].abs() {
                pivot = k;
            }
            self.exchanged[k] = pivot as u32;
            // Rows that were exchanged reach further; all others have nothing there.
            right = right.max(self.last[pivot] as usize);
            self.reach[k] = right as u32;
            if pivot != k {
                self.sign = -self.sign;
                for column in k..=right {
                    let (a, b) = (self.at(k, column), self.at(pivot, column));
                    self.entries.swap(a, b);
                }
            }
            let start = self.at(k, k);
            let diagonal = self.entries[start];
            if diagonal == 0.0 || !diagonal.is_finite() {
                self.sign = 0;
                return false;
            }
            if diagonal < 0.0 {
                self.sign = -self.sign;
            }
            let inverse = 1.0 / diagonal;
            self.inverse[k] = inverse;
            let count = right - k;
            for row in k + 1..=last {
                let at = self.at(row, k);
                let share = self.entries[at] * inverse;
                self.taken[k * below + row - k - 1] = share;
                if share == 0.0 {
                    continue;
                }
                let (upper, lower) = self.entries.split_at_mut(at);
                // One by one: eight at once, what is written is read across its borders by the next row, and waited for (620 -> 860 samples).
                let from = &upper[start + 1..=start + count];
                for (to, from) in lower[1..=count].iter_mut().zip(from) {
                    *to -= share * from;
                }
            }
        }
        true
    }

    /// Solves in place with what [`factorise`](Self::factorise) left.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        self.solve_together([right]);
    }

    /// The same for several right-hand sides at once, each to the bits that it has alone.
    pub(crate) fn solve_together<const N: usize>(&self, mut right: [&mut [f64]; N]) {
        for k in 0..self.size {
            let count = self.last[k] as usize - k;
            let taken = &self.taken[k * self.below..k * self.below + count];
            for side in &mut right {
                side.swap(k, self.exchanged[k] as usize);
                let value = side[k];
                // Forces on one joint alone leave all rows before it as they are.
                if value == 0.0 {
                    continue;
                }
                for (other, share) in side[k + 1..=k + count].iter_mut().zip(taken) {
                    *other -= share * value;
                }
            }
        }
        for k in (0..self.size).rev() {
            let count = self.reach[k] as usize - k;
            let start = self.at(k, k);
            let row = &self.entries[start + 1..=start + count];
            let mut sums = [0.0; N];
            let known = right.each_ref().map(|side| &side[k + 1..=k + count]);
            // The nearest last: it was the last to be known, and the others need not wait for it.
            for (i, entry) in row.iter().enumerate().rev() {
                for (sum, known) in sums.iter_mut().zip(&known) {
                    *sum += entry * known[i];
                }
            }
            for (side, sum) in right.iter_mut().zip(sums) {
                side[k] = (side[k] - sum) * self.inverse[k];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Banded;

    #[test]
    fn a_system_with_exchanges_is_solved_and_its_determinant_has_its_sign() {
        // Wider in the middle.
        let size = 12;
        let last: Vec<u32> = vec![2, 3, 4, 8, 8, 9, 10, 9, 10, 11, 11, 11];
        let joined = |row: usize, column: usize| last[row.min(column)] as usize >= row.max(column);
        let entry = |row: usize, column: usize| ((row * row * 7 + column * 5 + row * column * 3) % 11) as f64 - 5.0;
        let mut matrix = Banded::new(last.clone());
        let exact: Vec<f64> = (0..size).map(|k| k as f64 - 3.5).collect();
        let mut right = vec![0.0; size];
        let mut whole = faer::Mat::<f64>::zeros(size, size);
        for row in 0..size {
            for column in (0..size).filter(|&column| joined(row, column)) {
                matrix.add(row, column, entry(row, column));
                whole[(row, column)] = entry(row, column);
                right[row] += entry(row, column) * exact[column];
            }
        }
        assert!(matrix.factorise());
        let (mut one, mut other) = (right.clone(), right.iter().map(|r| -2.0 * r).collect::<Vec<f64>>());
        matrix.solve_together([&mut one, &mut other]);
        matrix.solve(&mut right);
        assert_eq!(one, right);
        assert!(other.iter().zip(&right).all(|(other, right)| *other == -2.0 * right));
        for (found, exact) in right.iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-10, "{right:?}");
        }
        assert_eq!(f64::from(matrix.sign), whole.determinant().signum());
    }
}
