//! What loads alone do to all rows, many positions at a time.

use super::rows::Rows;

/// Amplitudes of the load patterns, and how far they move each row by themselves.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Load {
    pub amplitudes: Vec<f64>,
    /// Of the rows that there were when it was made; [`Load::complete`] adds the others.
    moved: Vec<f64>,
}

impl Load {
    /// Nothing.
    pub fn none(patterns: usize, rows: usize) -> Load {
        Load { amplitudes: vec![0.0; patterns], moved: vec![0.0; rows] }
    }

    /// What these amplitudes do to rows that came later.
    pub fn complete(&mut self, rows: &Rows) {
        for row in self.moved.len()..rows.len() {
            self.moved.push(rows.moved(row, &self.amplitudes));
        }
    }

    /// How far the load moves a row.
    #[inline]
    pub fn moved(&self, row: usize) -> f64 {
        self.moved[row]
    }

    /// A load on the way from this to another; both know the same rows.
    pub fn mix(&self, other: &Load, share: f64) -> Load {
        let mix = |from: &[f64], to: &[f64]| from.iter().zip(to).map(|(a, b)| a + share * (b - a)).collect();
        Load { amplitudes: mix(&self.amplitudes, &other.amplitudes), moved: mix(&self.moved, &other.moved) }
    }
}

/// The loads of several positions.
pub(super) fn loads(rows: &Rows, amplitudes: Vec<Vec<f64>>) -> Vec<Load> {
    let moved = rows.all_moved(&amplitudes);
    let all = amplitudes.into_iter().zip(moved.col_iter());
    all.map(|(amplitudes, moved)| Load { amplitudes, moved: moved.iter().copied().collect() }).collect()
}
