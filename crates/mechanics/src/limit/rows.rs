//! The rows of a linear program, so laid out that the slack of eight of them is computed at once.

use crate::wide::wide;

/// Rows that stand side by side.
const SIDE: usize = 8;

/// Rows `a z <= b`, `a` without its last column: what does not depend on the load.
#[derive(Debug, Clone, Default)]
pub(super) struct Rows {
    /// Unknowns but the last.
    pub width: usize,
    /// Eight rows after the other; of each eight, unknown after unknown. Rows that only fill up the last eight say nothing.
    a: Vec<f64>,
    /// Right sides.
    pub b: Vec<f64>,
    /// The largest size of any entry.
    pub largest: f64,
}

impl Rows {
    /// No rows of `width` unknowns yet.
    pub(super) fn new(width: usize) -> Rows {
        Rows { width, ..Rows::default() }
    }

    pub(super) fn push(&mut self, a: impl IntoIterator<Item = f64>, b: f64) {
        let k = self.b.len();
        if k.is_multiple_of(SIDE) {
            self.a.resize(self.a.len() + SIDE * self.width, 0.0);
        }
        let from = self.at(k);
        for (to, value) in self.a[from..].iter_mut().step_by(SIDE).zip(a) {
            *to = value;
            self.largest = self.largest.max(value.abs());
        }
        self.b.push(b);
    }

    /// Puts a row in the place of an earlier one.
    pub(super) fn put(&mut self, k: usize, place: usize) {
        let (from, to) = (self.at(k), self.at(place));
        (0..self.width).for_each(|unknown| self.a[to + SIDE * unknown] = self.a[from + SIDE * unknown]);
        self.b[place] = self.b[k];
    }

    /// Drops all rows from this one on.
    pub(super) fn truncate(&mut self, count: usize) {
        self.b.truncate(count);
        self.a.truncate(count.div_ceil(SIDE) * SIDE * self.width);
    }

    /// Where the first entry of a row stands.
    fn at(&self, k: usize) -> usize {
        k / SIDE * SIDE * self.width + k % SIDE
    }

    pub(super) fn entry(&self, k: usize, unknown: usize) -> f64 {
        self.a[self.at(k) + SIDE * unknown]
    }

    pub(super) fn row(&self, k: usize) -> impl Iterator<Item = f64> + '_ {
        (0..self.width).map(move |unknown| self.entry(k, unknown))
    }

    /// The first row that a corner violates most among those that `may` enter, with less slack than `most`: its slack is `b - a x - last factor`. With
    /// `careful`, the first that it violates at all.
    pub(super) fn violated(
        &self,
        last: &[f64],
        (x, factor): (&[f64], f64),
        most: f64,
        careful: bool,
        may: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        wide(
            #[inline(always)]
            move || {
                let (mut worst, mut found) = (most, None);
                let (b, b_left) = self.b.as_chunks::<SIDE>();
                let (last, last_left) = last[..self.b.len()].as_chunks::<SIDE>();
                // Rows that only fill up the last eight are never violated.
                let (mut b_end, mut last_end) = ([f64::INFINITY; SIDE], [0.0; SIDE]);
                b_end[..b_left.len()].copy_from_slice(b_left);
                last_end[..last_left.len()].copy_from_slice(last_left);
                let sides = b.iter().chain([&b_end]).zip(last.iter().chain([&last_end]));
                for (eight, (b, last)) in sides.take(self.b.len().div_ceil(SIDE)).enumerate() {
                    let mut slack = [0.0; SIDE];
                    for k in 0..SIDE {
                        slack[k] = b[k] - last[k] * factor;
                    }
                    let (columns, _) = self.a[eight * SIDE * self.width..][..SIDE * self.width].as_chunks::<SIDE>();
                    for (column, x) in columns.iter().zip(x) {
                        for k in 0..SIDE {
                            slack[k] -= column[k] * x;
                        }
                    }
                    if !slack.iter().fold(false, |any, slack| any | (*slack < worst)) {
                        continue;
                    }
                    for (side, slack) in slack.into_iter().enumerate() {
                        let k = eight * SIDE + side;
                        if slack < worst && may(k) {
                            (worst, found) = (slack, Some(k));
                            if careful {
                                return found;
                            }
                        }
                    }
                }
                found
            },
        )
    }
}
