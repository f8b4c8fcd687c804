//! Newton's method on the forces of the hot rows.

use super::rows::dot;
use super::{Condensed, Position, TOLERANCE};

/// Iterations without a smaller change after which a position is given up.
const IDLE: u32 = 15;

/// Change left in a row over the largest value of a row above which all active parts are looked at in every iteration.
const FAR: f64 = 1e-3;

/// Farthest that a row moves in an iteration, over the most that the loads move one of the linear system.
const FARTHEST: f64 = 2.0;

/// Share of the change that a step may leave before the tangent is factorised anew with all slopes: those that have changed little are not put right, and
/// count where it is nearly singular.
const SLOW: f64 = 0.3;

/// A position that is sought.
#[derive(Debug, Clone, Default)]
pub(super) struct Trial {
    /// Amplitudes of the load patterns.
    pub to: Vec<f64>,
    /// Iterations of the position at which it is given up.
    pub limit: u32,
    /// How far the loads alone move each active row beyond the last position.
    pub led: Vec<f64>,
    /// Forces on the hot rows, what they were in the last position, and the excess that was found last.
    pub forces: Vec<f64>,
    before: Vec<f64>,
    excess: Vec<f64>,
    /// Values of the hot rows.
    values: Vec<f64>,
}

impl Condensed<'_> {
    /// A position that loads move by `led` from the last one; the forces follow as the last tangent has it.
    pub(super) fn guess(&mut self, led: Vec<f64>) -> Trial {
        let most = self.hot.rows.iter().map(|&row| led[row].abs());
        self.most_moved = most.fold(self.most_moved, f64::max);
        let (step, way) = self.hot.predict(&self.hot.rows.iter().map(|&row| led[row]).collect::<Vec<f64>>());
        let before: Vec<f64> = self.hot.rows.iter().map(|&row| self.at.forces[row]).collect();
        let forces = before.iter().zip(step).map(|(force, step)| force + step).collect();
        let values = self.hot.rows.iter().zip(way).map(|(&row, way)| self.at.values[row] + led[row] + way).collect();
        Trial { led, forces, before, values, ..Trial::default() }
    }

    /// More parts are hot from now on; values of the active rows.
    pub(super) fn heat(&mut self, more: &[usize], trial: &mut Trial, values: &[f64]) {
        self.hot.add(more.iter().copied(), &self.parts, &self.rows);
        for &row in &self.hot.rows[trial.forces.len()..] {
            trial.forces.push(self.at.forces[row]);
            trial.before.push(self.at.forces[row]);
            trial.values.push(values[row]);
        }
    }

    /// Newton's method on the forces of the hot rows (equation 5); `false` where it finds no end.
    pub(super) fn iterate(&mut self, trial: &mut Trial, position: &mut Position) -> bool {
        let Some(mut right) = self.right(trial) else { return false };
        let (mut best, mut idle, mut before) = (f64::INFINITY, 0, f64::INFINITY);
        while position.iterations < trial.limit {
            let size = trial.values.iter().fold(1e-9_f64, |most, value| most.max(value.abs()));
            let most = |moves: &mut dyn Iterator<Item = f64>| moves.fold(0.0_f64, |most, m| most.max(m.abs())) / size;
            position.left = most(&mut self.hot.moves_alone(&right));
            if position.left <= TOLERANCE {
                let moves = self.hot.moves(&right);
                position.left = most(&mut moves.iter().copied());
                if position.left <= TOLERANCE {
                    trial.forces.copy_from_slice(&trial.excess);
                    trial.values.iter_mut().zip(moves).for_each(|(value, moves)| *value += moves);
                    return true;
                }
            }
            idle = if position.left < 0.9 * best { 0 } else { idle + 1 };
            best = best.min(position.left);
            if !position.left.is_finite() || idle > IDLE {
                return false;
            }
            position.iterations += 1;
            let slow = position.left > SLOW * before;
            before = position.left;
            self.hot.find_tangent(&self.parts, slow);
            let (direction, way) = self.hot.solve(&right);
            let Some(next) = self.step(trial, &direction, &way, &right) else { return false };
            right = next;
            // Far from balance, parts that join late would lead the others astray.
            if position.left > FAR {
                let values = self.values_of_all(trial);
                let Some(moving) = self.moving_among_the_cool(&values, None) else { return false };
                if !moving.is_empty() {
                    self.heat(&moving, trial, &values);
                    before = f64::INFINITY;
                    let Some(next) = self.right(trial) else { return false };
                    right = next;
                }
            }
        }
        false
    }

    /// Values of the active rows.
    pub(super) fn values_of_all(&self, trial: &Trial) -> Vec<f64> {
        let mut values: Vec<f64> = self.at.values.iter().zip(&trial.led).map(|(value, led)| value + led).collect();
        let since = self.hot.rows.iter().zip(trial.forces.iter().zip(&trial.before));
        self.rows.add_row_changes(&mut values, since.map(|(row, (now, before))| (*row, now - before)));
        values
    }

    /// Active parts that are not hot and do not answer linearly. Those that will not do so where the rows go next are foreseen.
    pub(super) fn moving_among_the_cool(&mut self, values: &[f64], ahead: Option<&[f64]>) -> Option<Vec<usize>> {
        let mut moving = Vec::new();
        self.foreseen.clear();
        for &index in self.active.iter().filter(|&&index| !self.hot.is_hot(index)) {
            let part = &mut self.parts[index];
            if part.proves_linear_at(self.model, |row| [values[row], ahead.map_or(values[row], |ahead| ahead[row])]) {
                continue;
            }
            let goes_on = ahead.is_none_or(|ahead| part.is_linear_at(self.model, |row| ahead[row]));
            part.evaluate(self.model, |row| values[row])?;
            if !part.linear {
                moving.push(index);
            } else if !goes_on {
                self.foreseen.push(index);
            }
        }
        Some(moving)
    }

    /// The excess of the hot parts at the values at hand, less the forces that stand for it.
    fn right(&mut self, trial: &mut Trial) -> Option<Vec<f64>> {
        self.find_excess(trial)?;
        Some(trial.excess.iter().zip(&trial.forces).map(|(excess, force)| excess - force).collect())
    }

    /// Goes along the direction of Newton's method, which moves the hot rows by `way`: all of it, or the part at which the unbalanced forces do no more work
    /// along it.
    fn step(&mut self, trial: &mut Trial, direction: &[f64], way: &[f64], right: &[f64]) -> Option<Vec<f64>> {
        const LEFT: f64 = 0.8;
        const TRIES: usize = 6;
        let start = dot(right, way);
        let from = (trial.forces.clone(), trial.values.clone());
        let along = |from: &[f64], way: &[f64], share: f64| from.iter().zip(way).map(|(f, d)| f + share * d).collect();
        let reach = FARTHEST * self.most_moved;
        // Where a law or an element has no answer the step was too long.
        let mut at = |share: f64| {
            trial.forces = along(&from.0, direction, share);
            trial.values = along(&from.1, way, share);
            let found = self.right(trial);
            (found.as_ref().map_or(f64::INFINITY, |right| dot(right, way)), found)
        };
        // Where the tangent is all but singular, no step goes farther than a multiple of what the loads do to the linear system.
        let longest = way.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        let whole = if longest > reach && reach > 0.0 { reach / longest } else { 1.0 };
        let (mut work, mut found) = at(whole);
        let (mut low, mut high) = ((0.0, start), (whole, work));
        let (mut share, mut best) = (whole, (whole, work.abs()));
        for _ in 0..TRIES {
            if work.abs() <= LEFT * start.abs() || (whole < 1.0 && share == whole && work * start > 0.0) {
                return found;
            }
            let crosses = high.1.is_finite() && low.1 * high.1 < 0.0;
            let part = if crosses { (low.1.abs() / (low.1.abs() + high.1.abs())).clamp(0.1, 0.9) } else { 0.5 };
            share = low.0 + part * (high.0 - low.0);
            (work, found) = at(share);
            if work.abs() < best.1 {
                best = (share, work.abs());
            }
            if work.is_finite() && work * start > 0.0 && work.abs() < start.abs() {
                low = (share, work);
            } else {
                high = (share, work);
            }
        }
        if best.0 == share { found } else { at(best.0).1 }
    }

    /// Excess on the hot rows: what it was in the last position and how that of the hot parts has changed, which is nothing where all of them
    /// are linear.
    fn find_excess(&mut self, trial: &mut Trial) -> Option<()> {
        trial.excess.clone_from(&trial.before);
        for &index in &self.hot.parts {
            let (part, hot, values) = (&mut self.parts[index], &self.hot, &trial.values);
            let value = |row: usize| hot.place(row).map_or(0.0, |place| values[place]);
            if part.proves_linear_at(self.model, |row| [value(row); 2]) {
                continue;
            }
            part.evaluate(self.model, value)?;
            if part.linear {
                continue;
            }
            for (row, change) in part.rows.iter().zip(part.excess_change()) {
                if let Some(place) = row.and_then(|row| hot.place(row)) {
                    trial.excess[place] += change;
                }
            }
        }
        Some(())
    }
}
