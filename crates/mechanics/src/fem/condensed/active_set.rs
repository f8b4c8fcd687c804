//! The active set: the retained parts that iterate in a position, and the tangent on the forces of their rows. Retained parts
//! outside the set are dormant: they are rechecked when a position is balanced.

use super::low_rank::{LowRankUpdate, NO_INDEX};
use super::parts::{Kind, Part, ROWS};
use super::rows::{Rows, add_multiples};
use super::tangent::{StiffnessEntry, Tangent};

/// The active parts, and the last tangent on the forces of their rows.
#[derive(Default)]
pub(super) struct ActiveSet {
    /// Active parts in the order in which they were activated.
    pub parts: Vec<usize>,
    /// Whether a part is active, by parts.
    is_active: Vec<bool>,
    /// Retained rows of the active parts.
    pub rows: Vec<usize>,
    /// Index of a retained row among them; [`NO_INDEX`] if it has none.
    local_index: Vec<u32>,
    /// `G` between them [m²/N]. It may be longer than `rows`: memory is kept.
    flexibility: Vec<Vec<f64>>,
    /// Excess stiffness of the parts with which the tangent was factorised, and its index by parts; [`NO_INDEX`] if a part has
    /// none.
    factorised: Vec<PartStiffness>,
    factorised_index: Vec<u32>,
    /// The factorised tangent, the change of the excess stiffness since, and the update for that change.
    tangent: Tangent<f32>,
    changes: Vec<PartStiffness>,
    low_rank: LowRankUpdate,
    /// Whether there is a tangent.
    has_tangent: bool,
    /// Whether the tangent is that of the current position, so that steps can be predicted with it.
    can_predict: bool,
}

/// A part with its excess stiffness, or the change of that [N/m²].
#[derive(Clone, Copy)]
struct PartStiffness {
    part: usize,
    rows: [Option<usize>; ROWS],
    stiffness: [[f64; ROWS]; ROWS],
}

/// Change of a part's excess stiffness, over the largest entry of its stiffness, for which the tangent is updated.
const CHANGE_TOLERANCE: f64 = 1e-2;

/// Share of the nonlinear rows whose excess stiffness may change before the tangent is factorised anew. In a passage some 290
/// rows are nonlinear; 26 to 40 of them change from one position to the next, and one to eight within a position. All tangents
/// take 3.1 s, and took 8.5 s when each was factorised.
const MOST_CHANGED_ROWS: f64 = 0.2;

impl ActiveSet {
    /// Sets the active parts. Parts that are active already stay so unless more than a quarter of them would be deactivated: to
    /// gather `G` anew costs more than a few linear rows.
    pub(super) fn update(&mut self, active: impl Iterator<Item = usize> + Clone, parts: &[Part], rows: &Rows) {
        let unchanged = active.clone().filter(|&part| self.contains(part)).count();
        if 4 * unchanged < 3 * self.parts.len() {
            self.parts.clear();
            self.rows.clear();
            self.is_active.clear();
            self.local_index.fill(NO_INDEX);
            // Nonlinear parts first: the tangent reads `G` between them, and reads it faster side by side.
            let (nonlinear, linear): (Vec<usize>, Vec<usize>) = active.partition(|&part| !parts[part].linear);
            self.add(nonlinear.into_iter().chain(linear), parts, rows);
            self.refactorise();
            return;
        }
        self.add(active, parts, rows);
    }

    /// Activates more parts.
    pub(super) fn add(&mut self, more: impl Iterator<Item = usize>, parts: &[Part], rows: &Rows) {
        self.is_active.resize(parts.len(), false);
        self.local_index.resize(rows.len(), NO_INDEX);
        let (known, before) = (self.parts.len(), self.rows.len());
        for index in more {
            if std::mem::replace(&mut self.is_active[index], true) {
                continue;
            }
            self.parts.push(index);
        }
        // Rows that may be nonlinear first: of a spring that slides, only the second is.
        let new_parts = self.parts[known..].iter().map(|&index| &parts[index]);
        let first_nonlinear = |part: &Part| usize::from(matches!(part.kind, Kind::Spring(_)));
        let nonlinear = new_parts.clone().flat_map(|part| &part.rows[first_nonlinear(part)..]);
        let rest = new_parts.flat_map(|part| &part.rows[..first_nonlinear(part)]);
        for row in nonlinear.chain(rest).flatten() {
            if self.local_index[*row] == NO_INDEX {
                self.local_index[*row] = self.rows.len() as u32;
                self.rows.push(*row);
            }
        }
        if self.flexibility.len() < self.rows.len() {
            self.flexibility.resize_with(self.rows.len(), Vec::new);
        }
        for (local_index, row) in self.rows.iter().enumerate().filter(|_| self.rows.len() > before) {
            let (flexibility, own) = (&rows.flexibility[*row], &mut self.flexibility[local_index]);
            let from = if local_index < before { before } else { 0 };
            own.truncate(from);
            own.reserve_exact(self.rows.len() - from);
            own.extend(self.rows[from..].iter().map(|&other| flexibility[other]));
        }
    }

    /// Whether a part is active.
    pub(super) fn contains(&self, part: usize) -> bool {
        self.is_active.get(part).copied().unwrap_or(false)
    }

    /// Gives the index of a retained row among the active ones.
    #[inline]
    pub(super) fn local_index(&self, row: usize) -> Option<usize> {
        self.local_index.get(row).filter(|index| **index != NO_INDEX).map(|index| *index as usize)
    }

    /// Gives the changes of the active rows' values by `forces` on them, `G f` [m].
    pub(super) fn row_changes(&self, forces: &[f64]) -> Vec<f64> {
        let mut row_changes = vec![0.0; self.rows.len()];
        add_multiples(&mut row_changes, self.flexibility.iter().map(Vec::as_slice).zip(forces.iter().copied()));
        row_changes
    }

    /// Gives the change of each active row's value by the force on itself alone, `G_rr f_r` [m]: of the size of `G f`, and cheap.
    pub(super) fn diagonal_row_changes(&self, forces: &[f64]) -> impl Iterator<Item = f64> {
        self.flexibility
            .iter()
            .zip(forces)
            .enumerate()
            .map(|(local_index, (flexibility, force))| flexibility[local_index] * force)
    }

    /// Discards the tangent, which belongs to another state than the current one.
    pub(super) fn discard_tangent(&mut self) {
        (self.has_tangent, self.can_predict) = (false, false);
    }

    /// Predicts the change of the forces [N/m] for changes `values` of the active rows by the loads alone [m], with the last
    /// tangent; gives also the changes of the rows by these forces [m]. Zeros where there is no tangent.
    pub(super) fn predict(&mut self, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut right = vec![0.0; self.rows.len()];
        if !(self.has_tangent && self.can_predict) {
            return (right.clone(), right);
        }
        for (p, q, s) in self.local_entries(&self.factorised).into_iter().chain(self.local_entries(&self.changes)) {
            right[p] += s * values[q];
        }
        self.solve(&right)
    }

    /// Updates the tangent to the excess stiffness of the last evaluation: by a low-rank update where few rows have changed, by a
    /// new factorisation otherwise or if `refactorise`.
    pub(super) fn update_tangent(&mut self, parts: &[Part], refactorise: bool) {
        self.can_predict = true;
        if refactorise || !self.has_tangent || !self.update_low_rank(parts) {
            self.factorised.clear();
            let nonlinear = self.parts.iter().filter(|part| !parts[**part].linear);
            self.factorised.extend(nonlinear.map(|&part| PartStiffness {
                part,
                rows: parts[part].rows,
                stiffness: parts[part].excess_stiffness,
            }));
            self.changes.clear();
            self.factorise();
        }
    }

    /// Finds the parts whose excess stiffness has changed and updates the tangent for them; `false` if too many rows have
    /// changed.
    fn update_low_rank(&mut self, parts: &[Part]) -> bool {
        const NO_STIFFNESS: [[f64; ROWS]; ROWS] = [[0.0; ROWS]; ROWS];
        self.factorised_index.resize(parts.len(), NO_INDEX);
        self.changes.clear();
        for &index in &self.parts {
            let part = &parts[index];
            let known = self.factorised.get(self.factorised_index[index] as usize);
            if part.linear && known.is_none() {
                continue;
            }
            let (now, then) = (
                if part.linear { &NO_STIFFNESS } else { &part.excess_stiffness },
                known.map_or(&NO_STIFFNESS, |known| &known.stiffness),
            );
            let stiffness: [[f64; ROWS]; ROWS] =
                std::array::from_fn(|i| std::array::from_fn(|j| now[i][j] - then[i][j]));
            let tolerance = CHANGE_TOLERANCE * part.largest_stiffness;
            let differs = stiffness.iter().flatten().fold(0, |any, change| any | u32::from(change.abs() > tolerance));
            if differs != 0 {
                self.changes.push(PartStiffness { part: index, rows: part.rows, stiffness });
            }
        }
        let entries = self.local_entries(&self.changes);
        let most = MOST_CHANGED_ROWS * self.tangent.nonlinear_rows.len() as f64;
        let flexibility = &self.flexibility[..self.rows.len()];
        self.low_rank.build(&entries, most as usize, &mut self.tangent, flexibility)
    }

    /// Factorises the last tangent anew for the rows that are active now.
    fn refactorise(&mut self) {
        if !self.has_tangent {
            return;
        }
        for change in std::mem::take(&mut self.changes) {
            match self.factorised.get_mut(self.factorised_index[change.part] as usize) {
                Some(known) => {
                    let entries = known.stiffness.iter_mut().flatten().zip(change.stiffness.iter().flatten());
                    entries.for_each(|(known, change)| *known += change);
                }
                None => self.factorised.push(change),
            }
        }
        self.factorise();
    }

    /// Factorises the tangent with the excess stiffness in `factorised`.
    fn factorise(&mut self) {
        self.factorised_index.fill(NO_INDEX);
        let last = self.factorised.iter().map(|part| part.part + 1).max().unwrap_or(0);
        self.factorised_index.resize(last.max(self.factorised_index.len()), NO_INDEX);
        self.factorised.iter().enumerate().for_each(|(k, part)| self.factorised_index[part.part] = k as u32);
        let entries = self.local_entries(&self.factorised);
        self.tangent.factorise_for(&entries, &self.flexibility[..self.rows.len()]);
        self.low_rank.reset();
        self.has_tangent = true;
    }

    /// Gives excess stiffnesses by entries, with rows counted among the active ones.
    fn local_entries(&self, parts: &[PartStiffness]) -> Vec<StiffnessEntry> {
        let mut entries = Vec::new();
        for PartStiffness { rows, stiffness, .. } in parts {
            let indices = rows.map(|row| row.and_then(|row| self.local_index(row)));
            for (p, stiffness) in indices.iter().zip(stiffness) {
                for (q, s) in indices.iter().zip(stiffness).filter(|(_, s)| **s != 0.0) {
                    entries.extend(p.zip(*q).map(|(p, q)| (p, q, *s)));
                }
            }
        }
        entries
    }

    /// Solves `(1 - S G) step = right` with the last tangent. Gives the step of the forces [N/m] and the changes of the rows by
    /// it [m].
    pub(super) fn solve(&mut self, right: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut known_step = right.to_vec();
        self.tangent.nonlinear_rows.iter().for_each(|&p| known_step[p] = 0.0);
        let mut row_step = self.row_changes(&known_step);
        let mut step = self.tangent.solve(right, &row_step);
        self.low_rank.correct_step(&mut step, &self.flexibility[..self.rows.len()]);
        let more = step.iter().zip(known_step).map(|(step, known_step)| step - known_step);
        add_multiples(&mut row_step, self.flexibility.iter().map(Vec::as_slice).zip(more));
        (step, row_step)
    }
}
