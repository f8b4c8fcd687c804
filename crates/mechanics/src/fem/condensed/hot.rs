//! The parts that move now and those that moved lately: all that takes part in the iterations of a position, and the tangent on the
//! forces of their rows.

use super::low_rank::LowRankUpdate;
use super::parts::{Kind, Part, ROWS};
use super::rows::{Rows, add_multiples};
use super::tangent::{StiffnessEntry, Tangent};

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
    /// Slopes of parts with which the tangent was factorised, and where those of a part are among them, [`NOWHERE`] if it has none.
    slopes: Vec<Sloped>,
    slope_of: Vec<u32>,
    /// The tangent that is factorised, and how the last one differs from it.
    tangent: Tangent<f32>,
    changed: Vec<Sloped>,
    low_rank: LowRankUpdate,
    /// Whether there is a tangent, and whether it foretells where forces go.
    has_tangent: bool,
    foretells: bool,
}

/// A part and the slopes of its excess by its rows, or how they have changed.
#[derive(Clone, Copy)]
struct Sloped {
    part: usize,
    rows: [Option<usize>; ROWS],
    by: [[f64; ROWS]; ROWS],
}

/// Change of a part's slopes, over the largest entry of its stiffness in the linear system, for which the tangent is put right.
const CHANGED: f64 = 1e-2;

/// Rows whose slopes have changed, over those that are steep, beyond which the tangent is factorised anew. Of a passage some 290 rows are steep, 26 to 40
/// of them change from one position to the next and one to eight within a position: 3.1 s for all tangents in place of 8.5 s when each was factorised.
const MOST_CHANGED: f64 = 0.2;

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
            // Those that move side by side: the tangent reads `G` between them.
            let (nonlinear, linear): (Vec<usize>, Vec<usize>) = hot.partition(|&part| !parts[part].linear);
            self.add(nonlinear.into_iter().chain(linear), parts, rows);
            self.settle_tangent();
            return;
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
        let sliding = fresh.clone().flat_map(|part| &part.rows[flat(part)..]);
        let rest = fresh.flat_map(|part| &part.rows[..flat(part)]);
        for row in sliding.chain(rest).flatten() {
            if self.place[*row] == NOWHERE {
                self.place[*row] = self.rows.len() as u32;
                self.rows.push(*row);
            }
        }
        if self.answers.len() < self.rows.len() {
            self.answers.resize_with(self.rows.len(), Vec::new);
        }
        for (place, row) in self.rows.iter().enumerate().filter(|_| self.rows.len() > before) {
            let (answers, own) = (rows.flexibility_row(*row), &mut self.answers[place]);
            let from = if place < before { before } else { 0 };
            own.truncate(from);
            own.reserve_exact(self.rows.len() - from);
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
        (self.has_tangent, self.foretells) = (false, false);
    }

    /// Change of the forces that the last tangent makes of a change of the rows' values without them, and what it does to these.
    pub fn predict(&mut self, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut right = vec![0.0; self.rows.len()];
        if !(self.has_tangent && self.foretells) {
            return (right.clone(), right);
        }
        for (p, q, s) in self.placed(&self.slopes).into_iter().chain(self.placed(&self.changed)) {
            right[p] += s * values[q];
        }
        self.solve(&right)
    }

    /// Finds the tangent with the slopes that the hot parts answered last.
    pub fn find_tangent(&mut self, parts: &[Part], anew: bool) {
        self.foretells = true;
        if anew || !self.has_tangent || !self.put_right(parts) {
            self.slopes.clear();
            let sloped = self.parts.iter().filter(|part| !parts[**part].linear);
            self.slopes.extend(sloped.map(|&part| Sloped {
                part,
                rows: parts[part].rows,
                by: parts[part].excess_stiffness,
            }));
            self.changed.clear();
            self.factorise();
        }
    }

    /// Puts the tangent right where slopes have changed; not where too many have.
    fn put_right(&mut self, parts: &[Part]) -> bool {
        const FLAT: [[f64; ROWS]; ROWS] = [[0.0; ROWS]; ROWS];
        self.slope_of.resize(parts.len(), NOWHERE);
        self.changed.clear();
        for &index in &self.parts {
            let part = &parts[index];
            let known = self.slopes.get(self.slope_of[index] as usize);
            if part.linear && known.is_none() {
                continue;
            }
            let (now, then) =
                (if part.linear { &FLAT } else { &part.excess_stiffness }, known.map_or(&FLAT, |known| &known.by));
            let by: [[f64; ROWS]; ROWS] = std::array::from_fn(|i| std::array::from_fn(|j| now[i][j] - then[i][j]));
            let least = CHANGED * part.largest_stiffness;
            let changed = by.iter().flatten().fold(0, |changed, change| changed | u32::from(change.abs() > least));
            if changed != 0 {
                self.changed.push(Sloped { part: index, rows: part.rows, by });
            }
        }
        let changes = self.placed(&self.changed);
        let most = MOST_CHANGED * self.tangent.nonlinear_rows.len() as f64;
        let answers = &self.answers[..self.rows.len()];
        self.low_rank.build(&changes, most as usize, &mut self.tangent, answers)
    }

    /// Takes the last tangent for the rows that are hot now.
    fn settle_tangent(&mut self) {
        if !self.has_tangent {
            return;
        }
        for changed in std::mem::take(&mut self.changed) {
            match self.slopes.get_mut(self.slope_of[changed.part] as usize) {
                Some(known) => {
                    let entries = known.by.iter_mut().flatten().zip(changed.by.iter().flatten());
                    entries.for_each(|(known, change)| *known += change);
                }
                None => self.slopes.push(changed),
            }
        }
        self.factorise();
    }

    fn factorise(&mut self) {
        self.slope_of.fill(NOWHERE);
        let last = self.slopes.iter().map(|sloped| sloped.part + 1).max().unwrap_or(0);
        self.slope_of.resize(last.max(self.slope_of.len()), NOWHERE);
        self.slopes.iter().enumerate().for_each(|(k, sloped)| self.slope_of[sloped.part] = k as u32);
        let slopes = self.placed(&self.slopes);
        self.tangent.factorise_for(&slopes, &self.answers[..self.rows.len()]);
        self.low_rank.reset();
        self.has_tangent = true;
    }

    /// Slopes by places of rows.
    fn placed(&self, sloped: &[Sloped]) -> Vec<StiffnessEntry> {
        let mut slopes = Vec::new();
        for Sloped { rows, by, .. } in sloped {
            let places = rows.map(|row| row.and_then(|row| self.place(row)));
            for (p, by) in places.iter().zip(by) {
                for (q, s) in places.iter().zip(by).filter(|(_, s)| **s != 0.0) {
                    slopes.extend(p.zip(*q).map(|(p, q)| (p, q, *s)));
                }
            }
        }
        slopes
    }

    /// Solves `(1 - S G) step = right` with the tangent that was found last; the step, and how it moves the rows.
    pub fn solve(&mut self, right: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut given = right.to_vec();
        self.tangent.nonlinear_rows.iter().for_each(|&p| given[p] = 0.0);
        let mut way = self.moves(&given);
        let mut step = self.tangent.solve(right, &way);
        self.low_rank.correct_step(&mut step, &self.answers[..self.rows.len()]);
        let more = step.iter().zip(given).map(|(step, given)| step - given);
        add_multiples(&mut way, self.answers.iter().map(Vec::as_slice).zip(more));
        (step, way)
    }
}
