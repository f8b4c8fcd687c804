//! A uniform grid over the particles: which of them lie in which cell.

use super::disc::Disc;
use crate::plane::{Vec2, bounds};

/// Particles sorted by cell; within a cell by their place in memory.
#[derive(Debug, Clone, Default)]
pub(in crate::dem) struct Cells {
    low: Vec2,
    inverse_side: f64,
    columns: usize,
    rows: usize,
    /// Where the particles of each cell begin.
    starts: Vec<u32>,
    members: Vec<u32>,
    /// Cell of each particle, scratch.
    homes: Vec<u32>,
}

/// Most cells per particle. A few particles far from the rest must not ask for the machine's memory.
const MOST_CELLS: usize = 4;

impl Cells {
    /// Sorts `discs` into cells of at least `side` [m].
    pub(crate) fn fill(&mut self, discs: &[Disc], side: f64) {
        let (low, high) = bounds(discs.iter().map(Disc::centre));
        let (width, height) = (high.x - low.x, high.y - low.y);
        let most = (MOST_CELLS * discs.len() + 16) as f64;
        let mut side = side;
        while (width / side + 1.0) * (height / side + 1.0) > most {
            side *= 1.5;
        }
        self.low = low;
        self.inverse_side = 1.0 / side;
        self.columns = (width / side) as usize + 1;
        self.rows = (height / side) as usize + 1;
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        self.homes.clear();
        for d in discs {
            let home = self.row(d.y) * self.columns + self.column(d.x);
            self.homes.push(home as u32);
            self.starts[home + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.members.resize(discs.len(), 0);
        // Filling moves each start to its cell's end; shifted back afterwards.
        for (i, &home) in self.homes.iter().enumerate() {
            let at = &mut self.starts[home as usize];
            self.members[*at as usize] = i as u32;
            *at += 1;
        }
        for cell in (1..self.starts.len()).rev() {
            self.starts[cell] = self.starts[cell - 1];
        }
        self.starts[0] = 0;
    }
    fn column(&self, x: f64) -> usize {
        (((x - self.low.x) * self.inverse_side) as usize).min(self.columns - 1)
    }
    fn row(&self, y: f64) -> usize {
        (((y - self.low.y) * self.inverse_side) as usize).min(self.rows - 1)
    }
    /// Calls `each` with the particles in the cells that the box from `low` to `high` touches, row by row.
    #[inline]
    pub(crate) fn within(&self, low: Vec2, high: Vec2, mut each: impl FnMut(u32)) {
        if self.members.is_empty() {
            return;
        }
        let (left, right) = (self.column(low.x), self.column(high.x));
        for row in self.row(low.y)..=self.row(high.y) {
            // Cells of one row lie side by side.
            let (from, to) = (self.starts[row * self.columns + left], self.starts[row * self.columns + right + 1]);
            for &i in &self.members[from as usize..to as usize] {
                each(i);
            }
        }
    }
    /// Bytes held.
    pub(crate) fn bytes(&self) -> usize {
        4 * (self.starts.capacity() + self.members.capacity() + self.homes.capacity())
    }
}
