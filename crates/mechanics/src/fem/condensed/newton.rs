//! Newton's method on the forces of the active rows.

use super::rows::dot;
use super::{Condensed, Position, Reached, TOLERANCE};
use crate::watch::Asking;

/// Iterations without a smaller residual after which a position is given up.
const MOST_STALLED: u32 = 15;

/// Relative residual above which dormant parts are rechecked after every iteration.
const ACTIVATE_ABOVE: f64 = 1e-3;

/// Largest change of a row value in an iteration, over the largest by the loads.
const FARTHEST_STEP: f64 = 2.0;

/// Ratio of two successive residuals above which the tangent is factorised anew: small changes of the excess stiffness are left
/// out of updates, and count where the tangent is nearly singular.
const SLOW_RATIO: f64 = 0.3;

/// An equilibrium that is sought.
#[derive(Debug, Clone, Default)]
pub(super) struct Trial {
    /// Amplitudes of the load patterns.
    pub amplitudes: Vec<f64>,
    /// Number of iterations at which it is given up.
    pub iteration_limit: u32,
    /// Changes of all retained row values by the loads alone, from the last equilibrium [m].
    pub load_changes: Vec<f64>,
    /// Forces on the active rows now and in the last equilibrium, and the excess forces evaluated last [N/m].
    pub forces: Vec<f64>,
    start_forces: Vec<f64>,
    excess: Vec<f64>,
    /// Values of the active rows [m].
    values: Vec<f64>,
}

impl Condensed {
    /// Predicts the next equilibrium with the last tangent, for given changes of the row values by the loads alone [m].
    pub(super) fn predict_trial(&mut self, load_changes: Vec<f64>) -> Trial {
        let loads: Vec<f64> = self.active_set.rows.iter().map(|&row| load_changes[row]).collect();
        self.largest_load_change = loads.iter().fold(self.largest_load_change, |most, load| most.max(load.abs()));
        let (step, row_step) = self.active_set.predict(&loads);
        let rows = self.active_set.rows.iter();
        let start_forces: Vec<f64> = rows.clone().map(|&row| self.current.forces[row]).collect();
        let forces = start_forces.iter().zip(step).map(|(force, step)| force + step).collect();
        let changes = loads.iter().zip(row_step);
        let values = rows.zip(changes).map(|(&row, (load, step))| self.current.values[row] + load + step).collect();
        Trial { load_changes, forces, start_forces, values, ..Trial::default() }
    }

    /// Activates parts during a position; `values` are those of all retained rows [m].
    pub(super) fn activate(&mut self, more: &[usize], trial: &mut Trial, values: &[f64]) {
        self.active_set.add(more.iter().copied(), &self.parts, &self.rows);
        for &row in &self.active_set.rows[trial.forces.len()..] {
            trial.forces.push(self.current.forces[row]);
            trial.start_forces.push(self.current.forces[row]);
            trial.values.push(values[row]);
        }
    }

    /// Iterates the forces of the active rows (equation 5) until the row values change by less than the tolerance; `false` where
    /// the iterations do not converge or `asking` stops them.
    pub(super) fn iterate(&mut self, trial: &mut Trial, position: &mut Position, asking: &mut Asking<'_>) -> bool {
        let Some(mut residual) = self.residual(trial) else { return false };
        let (mut best, mut stalled, mut before) = (f64::INFINITY, 0, f64::INFINITY);
        while position.iterations < trial.iteration_limit {
            let size = trial.values.iter().fold(1e-9_f64, |most, value| most.max(value.abs()));
            let most =
                |changes: &mut dyn Iterator<Item = f64>| changes.fold(0.0_f64, |most, m| most.max(m.abs())) / size;
            position.residual = most(&mut self.active_set.diagonal_row_changes(&residual));
            if position.residual <= TOLERANCE {
                let row_changes = self.active_set.row_changes(&residual);
                position.residual = most(&mut row_changes.iter().copied());
                if position.residual <= TOLERANCE {
                    trial.forces.copy_from_slice(&trial.excess);
                    trial.values.iter_mut().zip(row_changes).for_each(|(value, change)| *value += change);
                    return true;
                }
            }
            stalled = if position.residual < 0.9 * best { 0 } else { stalled + 1 };
            best = best.min(position.residual);
            if !position.residual.is_finite() || stalled > MOST_STALLED {
                return false;
            }
            if asking.stops() {
                position.reached = Reached::Cancelled;
                return false;
            }
            position.iterations += 1;
            let slow = position.residual > SLOW_RATIO * before;
            before = position.residual;
            self.active_set.update_tangent(&self.parts, slow);
            let (direction, row_step) = self.active_set.solve(&residual);
            let Some(next) = self.line_search(trial, &direction, &row_step, &residual) else { return false };
            residual = next;
            // Far from equilibrium, parts that are activated late lead the others astray.
            if position.residual > ACTIVATE_ABOVE {
                let values = self.retained_values(trial);
                let Some(nonlinear) = self.recheck_dormant(&values, None) else { return false };
                if !nonlinear.is_empty() {
                    self.activate(&nonlinear, trial, &values);
                    before = f64::INFINITY;
                    let Some(next) = self.residual(trial) else { return false };
                    residual = next;
                }
            }
        }
        false
    }

    /// Gives the values of all retained rows [m].
    pub(super) fn retained_values(&self, trial: &Trial) -> Vec<f64> {
        let mut values: Vec<f64> =
            self.current.values.iter().zip(&trial.load_changes).map(|(value, change)| value + change).collect();
        let since = self.active_set.rows.iter().zip(trial.forces.iter().zip(&trial.start_forces));
        self.rows.add_row_changes(&mut values, since.map(|(row, (now, before))| (*row, now - before)));
        values
    }

    /// Evaluates the dormant parts at the `values` of all retained rows [m] and gives those that are nonlinear. Those that are
    /// nonlinear at the `extrapolated` values alone are noted for the next position. `None` where a law has no answer.
    pub(super) fn recheck_dormant(&mut self, values: &[f64], extrapolated: Option<&[f64]>) -> Option<Vec<usize>> {
        let mut nonlinear = Vec::new();
        self.predicted_active.clear();
        for &index in self.retained.iter().filter(|&&index| !self.active_set.contains(index)) {
            let part = &mut self.parts[index];
            if part.proves_linear_at(&self.model, |row| {
                [values[row], extrapolated.map_or(values[row], |ahead| ahead[row])]
            }) {
                continue;
            }
            let stays_linear = extrapolated.is_none_or(|ahead| part.is_linear_at(&self.model, |row| ahead[row]));
            part.evaluate(&self.model, |row| values[row])?;
            if !part.linear {
                nonlinear.push(index);
            } else if !stays_linear {
                self.predicted_active.push(index);
            }
        }
        Some(nonlinear)
    }

    /// Gives the residual: excess forces at the trial values, less the forces that stand for them [N/m]. `None` where a law has
    /// no answer.
    fn residual(&mut self, trial: &mut Trial) -> Option<Vec<f64>> {
        self.update_excess(trial)?;
        Some(trial.excess.iter().zip(&trial.forces).map(|(excess, force)| excess - force).collect())
    }

    /// Moves the trial along a Newton step: `direction` of the forces [N/m], `row_step` of the row values [m]. Takes the full
    /// step, or the factor at which the work of the residual along it vanishes (equation 6). Gives the new residual.
    fn line_search(
        &mut self,
        trial: &mut Trial,
        direction: &[f64],
        row_step: &[f64],
        residual: &[f64],
    ) -> Option<Vec<f64>> {
        const SUFFICIENT: f64 = 0.8;
        const TRIALS: usize = 6;
        let start = dot(residual, row_step);
        let from = (trial.forces.clone(), trial.values.clone());
        let along =
            |from: &[f64], step: &[f64], factor: f64| from.iter().zip(step).map(|(f, d)| f + factor * d).collect();
        let longest_allowed = FARTHEST_STEP * self.largest_load_change;
        // Where a law has no answer the step was too long.
        let mut at = |factor: f64| {
            trial.forces = along(&from.0, direction, factor);
            trial.values = along(&from.1, row_step, factor);
            let found = self.residual(trial);
            (found.as_ref().map_or(f64::INFINITY, |residual| dot(residual, row_step)), found)
        };
        // Where the tangent is nearly singular the step is bounded by a multiple of the change by the loads.
        let longest = row_step.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        let full = if longest > longest_allowed && longest_allowed > 0.0 { longest_allowed / longest } else { 1.0 };
        let (mut work, mut found) = at(full);
        let (mut low, mut high) = ((0.0, start), (full, work));
        let (mut factor, mut best) = (full, (full, work.abs()));
        for _ in 0..TRIALS {
            if work.abs() <= SUFFICIENT * start.abs() || (full < 1.0 && factor == full && work * start > 0.0) {
                return found;
            }
            let crosses = high.1.is_finite() && low.1 * high.1 < 0.0;
            let part = if crosses { (low.1.abs() / (low.1.abs() + high.1.abs())).clamp(0.1, 0.9) } else { 0.5 };
            factor = low.0 + part * (high.0 - low.0);
            (work, found) = at(factor);
            if work.abs() < best.1 {
                best = (factor, work.abs());
            }
            if work.is_finite() && work * start > 0.0 && work.abs() < start.abs() {
                low = (factor, work);
            } else {
                high = (factor, work);
            }
        }
        if best.0 == factor { found } else { at(best.0).1 }
    }

    /// Evaluates the active parts: excess forces on the active rows are those of the last equilibrium and the changes since,
    /// which are zero for linear parts.
    fn update_excess(&mut self, trial: &mut Trial) -> Option<()> {
        trial.excess.clone_from(&trial.start_forces);
        for &index in &self.active_set.parts {
            let (part, active_set, values) = (&mut self.parts[index], &self.active_set, &trial.values);
            let value = |row: usize| active_set.local_index(row).map_or(0.0, |index| values[index]);
            if part.proves_linear_at(&self.model, |row| [value(row); 2]) {
                continue;
            }
            part.evaluate(&self.model, value)?;
            if part.linear {
                continue;
            }
            for (row, change) in part.rows.iter().zip(part.excess_change()) {
                if let Some(index) = row.and_then(|row| active_set.local_index(row)) {
                    trial.excess[index] += change;
                }
            }
        }
        Some(())
    }
}
