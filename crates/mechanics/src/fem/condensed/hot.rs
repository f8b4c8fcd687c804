//! The parts that move now and those that moved lately: all that takes part in the iterations of a position, and the tangent on the
//! forces of their rows.

use super::parts::{Kind, Part};
use super::rows::{Rows, add_multiples};
use super::tangent::{Slope, Tangent};

/// No place.
const NOWHERE: u32 = u32::MAX;

/// Parts that iterate, and the last tangent.
#[derive(Default)]
pub(super) struct Hot {
    /// In the order in which they came.
    pub parts: Vec<usize>,
    is_hot: Vec<bool>,
    /// Their rows.
    pub rows: Vec<usize>,
    /// Place of an active row among them, [`NOWHERE`] if it has none.
    place: Vec<u32>,
    /// `G` between them; what was allocated for more rows stays.
    answers: Vec<Vec<f64>>,
    /// Entries of the last `S`, by active rows.
    slopes: Vec<(u32, u32, f64)>,
    /// The last tangent, and the active rows that were steep then.
    tangent: Tangent,
    steep: Vec<u32>,
}

impl std::fmt::Debug for Hot {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.debug_struct("Hot").field("parts", &self.parts.len()).field("rows", &self.rows.len()).finish_non_exhaustive()
    }
}

impl Hot {
    /// These parts are hot, and those that are hot already stay so unless more than a quarter of them have cooled: to gather `G` anew costs more than
    /// a few rows that do not move.
    pub fn set(&mut self, hot: impl Iterator<Item = usize> + Clone, parts: &[Part], rows: &Rows) {
        let stay = hot.clone().filter(|&part| self.is_hot(part)).count();
        if 4 * stay < 3 * self.parts.len() {
            self.parts.clear();
            self.rows.clear();
            self.is_hot.clear();
            self.place.fill(NOWHERE);
        }
        self.add(hot, parts, rows);
    }

    /// More parts are hot.
    pub fn add(&mut self, more: impl Iterator<Item = usize>, parts: &[Part], rows: &Rows) {
        self.is_hot.resize(parts.len(), false);
        self.place.resize(rows.len(), NOWHERE);
        let (known, before) = (self.parts.len(), self.rows.len());
        for index in more {
            if std::mem::replace(&mut self.is_hot[index], true) {
                continue;
            }
            self.parts.push(index);
        }
        // Rows that may be steep side by side: of a spring that slides, only the second is.
        let fresh = self.parts[known..].iter().map(|&index| &parts[index]);
        let flat = |part: &Part| usize::from(matches!(part.kind, Kind::Spring(_)));
        let steep = fresh.clone().flat_map(|part| &part.rows[flat(part)..]);
        let rest = fresh.flat_map(|part| &part.rows[..flat(part)]);
        for row in steep.chain(rest).flatten() {
            if self.place[*row] == NOWHERE {
                self.place[*row] = self.rows.len() as u32;
                self.rows.push(*row);
            }
        }
        if self.answers.len() < self.rows.len() {
            self.answers.resize_with(self.rows.len(), Vec::new);
        }
        for (place, row) in self.rows.iter().enumerate().filter(|_| self.rows.len() > before) {
            let (answers, own) = (rows.answers(*row), &mut self.answers[place]);
            let from = if place < before { before } else { 0 };
            own.truncate(from);
            own.reserve(rows.len());
            own.extend(self.rows[from..].iter().map(|&other| answers[other]));
        }
    }

    pub fn is_hot(&self, part: usize) -> bool {
        self.is_hot.get(part).copied().unwrap_or(false)
    }

    /// Place of an active row, if it has one.
    #[inline]
    pub fn place(&self, row: usize) -> Option<usize> {
        self.place.get(row).filter(|place| **place != NOWHERE).map(|place| *place as usize)
    }

    /// Changes of the hot rows' values by forces on them.
    pub fn moves(&self, forces: &[f64]) -> Vec<f64> {
        let mut moves = vec![0.0; self.rows.len()];
        add_multiples(&mut moves, self.answers.iter().map(Vec::as_slice).zip(forces.iter().copied()));
        moves
    }

    /// How far forces on the hot rows move each of them, those of the others left out: of the size of what all of them do, and not as dear.
    pub fn moves_alone(&self, forces: &[f64]) -> impl Iterator<Item = f64> {
        self.answers.iter().zip(forces).enumerate().map(|(place, (answers, force))| answers[place] * force)
    }

    /// The last tangent is that of another place: nothing is predicted from it.
    pub fn forget(&mut self) {
        self.slopes.clear();
    }

    /// Change of the forces that the last tangent makes of a change of the rows' values without them.
    pub fn predict(&mut self, values: &[f64]) -> Vec<f64> {
        let mut step = vec![0.0; self.rows.len()];
        if self.slopes.is_empty() {
            return step;
        }
        for &(p, q, s) in &self.slopes {
            if let (Some(p), Some(q)) = (self.place(p as usize), self.place(q as usize)) {
                step[p] += s * values[q];
            }
        }
        let at = |row: u32| self.place(row as usize);
        let mut x: Vec<f64> = self.steep.iter().map(|&row| at(row).map_or(0.0, |place| step[place])).collect();
        self.tangent.solve_steep(&mut x);
        for (row, x) in self.steep.iter().zip(x) {
            if let Some(place) = self.place.get(*row as usize).filter(|place| **place != NOWHERE) {
                step[*place as usize] = x;
            }
        }
        step
    }

    /// Finds the tangent with the slopes that the hot parts answered last.
    pub fn find_tangent(&mut self, parts: &[Part]) {
        self.slopes.clear();
        for part in self.parts.iter().map(|&part| &parts[part]).filter(|part| !part.still) {
            part.slopes(|p, q, s| self.slopes.push((p as u32, q as u32, s)));
        }
        let slopes = self.placed_slopes();
        self.tangent.find(&slopes, &self.answers[..self.rows.len()]);
        self.steep = self.tangent.steep.iter().map(|&p| self.rows[p] as u32).collect();
    }

    fn placed_slopes(&self) -> Vec<Slope> {
        let placed =
            |&(p, q, s): &(u32, u32, f64)| (self.place[p as usize] as usize, self.place[q as usize] as usize, s);
        self.slopes.iter().map(placed).collect()
    }

    /// Solves `(1 - S G) step = right` with the tangent that was found last.
    pub fn solve(&mut self, right: &[f64]) -> Vec<f64> {
        let slopes = self.placed_slopes();
        let mut given = right.to_vec();
        self.tangent.steep.iter().for_each(|&p| given[p] = 0.0);
        let given = self.moves(&given);
        self.tangent.solve(&slopes, right, &given)
    }
}
