//! The rows of a linear program, so laid out that the slack of eight of them is computed at once.

use crate::wide;

/// Rows that stand side by side.
const SIDE: usize = 8;

/// Rows `a z <= b`, `a` without its last column: what does not depend on the load.
#[derive(Debug, Clone, Default)]
pub(super) struct Rows {
    /// Unknowns but the last.
    width: usize,
    /// Eight rows after the other; of each eight, unknown after unknown. Rows that only fill up the last eight are zeros.
    a: Vec<f64>,
    /// Right sides.
    b: Vec<f64>,
}

impl Rows {
    /// No rows of `width` unknowns yet.
    pub fn new(width: usize) -> Rows {
        Rows { width, ..Rows::default() }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn count(&self) -> usize {
        self.b.len()
    }

    /// Right side of a row.
    pub fn b(&self, k: usize) -> f64 {
        self.b[k]
    }

    pub fn push(&mut self, a: impl IntoIterator<Item = f64>, b: f64) {
        let k = self.b.len();
        if k.is_multiple_of(SIDE) {
            self.a.resize(self.a.len() + SIDE * self.width, 0.0);
        }
        let from = self.at(k);
        self.a[from..].iter_mut().step_by(SIDE).zip(a).for_each(|(to, value)| *to = value);
        self.b.push(b);
    }

    /// Where the first entry of a row stands.
    fn at(&self, k: usize) -> usize {
        k / SIDE * SIDE * self.width + k % SIDE
    }

    pub fn entry(&self, k: usize, unknown: usize) -> f64 {
        self.a[self.at(k) + SIDE * unknown]
    }

    pub fn row(&self, k: usize) -> impl Iterator<Item = f64> + '_ {
        (0..self.width).map(move |unknown| self.entry(k, unknown))
    }

    /// The first row that a corner violates most among those that `may` enter, with less slack than `most`: its slack is `b - a x - last factor`. With
    /// `careful`, the first that it violates at all.
    pub fn violated(
        &self,
        last: &[f64],
        (x, factor): (&[f64], f64),
        most: f64,
        careful: bool,
        may: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        wide::widest(Violated { rows: self, last, x, factor, most, careful, may })
    }
}

struct Violated<'a, M> {
    rows: &'a Rows,
    last: &'a [f64],
    x: &'a [f64],
    factor: f64,
    most: f64,
    careful: bool,
    may: M,
}

impl<M: Fn(usize) -> bool> pulp::NullaryFnOnce for Violated<'_, M> {
    type Output = Option<usize>;

    #[inline(always)]
    fn call(self) -> Option<usize> {
        let Violated { rows, last, x, factor, most, careful, may } = self;
        let (mut worst, mut found) = (most, None);
        for (eight, (b, last)) in rows.b.chunks(SIDE).zip(last.chunks(SIDE)).enumerate() {
            let mut slack = [f64::INFINITY; SIDE];
            for (slack, (b, last)) in slack.iter_mut().zip(b.iter().zip(last)) {
                *slack = b - last * factor;
            }
            let from = eight * SIDE * rows.width;
            let (columns, _) = rows.a[from..from + SIDE * rows.width].as_chunks::<SIDE>();
            for (column, x) in columns.iter().zip(x) {
                for (slack, a) in slack.iter_mut().zip(column) {
                    *slack -= a * x;
                }
            }
            if slack.iter().all(|slack| *slack >= worst) {
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
    }
}
