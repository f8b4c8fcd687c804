//! Newton's method on the forces of the active rows.

use super::loads::Load;
use super::rows::dot;
use super::{Condensed, ITERATIONS, Position, TOLERANCE};

/// Iterations without a smaller change after which a position is given up.
const IDLE: u32 = 15;

/// Change left in a row over the largest value of a row above which all parts are looked at in every iteration.
const FAR: f64 = 1e-3;

/// Farthest that a row moves in an iteration, over the most that the loads move one of the linear system.
const FARTHEST: f64 = 2.0;

impl Condensed<'_> {
    /// The forces follow the change of the loads as the last tangent has it.
    pub(super) fn guess(&mut self, before: &Load) {
        self.load.complete(&self.rows);
        let change = |&row: &usize| self.load.moved(row) - before.moved(row);
        let step = self.system.predict(&self.system.rows().iter().map(change).collect::<Vec<f64>>());
        self.forces.iter_mut().zip(step).for_each(|(force, step)| *force += step);
    }

    /// Newton's method on the forces of the active rows (equation 5); `false` where it finds no end.
    pub(super) fn iterate(&mut self, position: &mut Position) -> bool {
        let Some(mut right) = self.unbalanced() else { return false };
        let (mut best, mut idle) = (f64::INFINITY, 0);
        while position.iterations < ITERATIONS {
            let change = self.system.moves(&right);
            let size = self.values.iter().fold(1e-9_f64, |most, value| most.max(value.abs()));
            position.left = change.iter().fold(0.0_f64, |most, l| most.max(l.abs())) / size;
            if position.left <= TOLERANCE {
                self.forces.copy_from_slice(&self.excess);
                return true;
            }
            idle = if position.left < 0.9 * best { 0 } else { idle + 1 };
            best = best.min(position.left);
            if !position.left.is_finite() || idle > IDLE {
                return false;
            }
            position.iterations += 1;
            let moving = self.active.iter().map(|&part| &self.parts[part]).filter(|part| !part.still);
            let slopes = moving.map(|part| (&part.rows, &part.slope));
            let direction = self.system.solve(slopes, &right);
            let Some(next) = self.step(&direction, &right) else { return false };
            right = next;
            // Far from balance, parts that join late would lead the others astray.
            if position.left > FAR {
                let Some(changed) = self.changed() else { return false };
                if !changed.is_empty() {
                    self.activate(&changed);
                    if self.watch_around(&changed).is_err() {
                        return false;
                    }
                    let Some(next) = self.unbalanced() else { return false };
                    right = next;
                }
            }
        }
        false
    }

    /// Values of the active rows under loads and forces, and the excess of their parts less those forces.
    fn unbalanced(&mut self) -> Option<Vec<f64>> {
        // Rows of inactive parts wait until the position is balanced.
        let since: Vec<f64> = self.forces.iter().zip(self.rows.brought()).map(|(now, then)| now - then).collect();
        let more = self.system.moves(&since);
        self.values = self.system.rows().iter().zip(more).map(|(&row, more)| self.value(row) + more).collect();
        let moved = self.system.rows().iter().map(|&row| self.load.moved(row).abs());
        self.most_moved = moved.fold(self.most_moved, f64::max);
        self.right()
    }

    /// The excess of the active parts at the values at hand, less the forces that stand for it.
    fn right(&mut self) -> Option<Vec<f64>> {
        self.find_excess()?;
        Some(self.excess.iter().zip(&self.forces).map(|(excess, force)| excess - force).collect())
    }

    /// Goes along the direction of Newton's method: all of it, or the part at which the unbalanced forces do no more work along it.
    fn step(&mut self, direction: &[f64], right: &[f64]) -> Option<Vec<f64>> {
        const LEFT: f64 = 0.8;
        const TRIES: usize = 6;
        let way = self.system.moves(direction);
        let start = dot(right, &way);
        let from = (self.forces.clone(), self.values.clone());
        let along = |from: &[f64], way: &[f64], share: f64| from.iter().zip(way).map(|(f, d)| f + share * d).collect();
        // Where a law or an element has no answer the step was too long.
        let at = |this: &mut Self, share: f64| {
            this.forces = along(&from.0, direction, share);
            this.values = along(&from.1, &way, share);
            let found = this.right();
            (found.as_ref().map_or(f64::INFINITY, |right| dot(right, &way)), found)
        };
        // Where the tangent is all but singular, no step goes farther than a multiple of what the loads do to the linear system.
        let reach = FARTHEST * self.most_moved;
        let longest = way.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        let whole = if longest > reach && reach > 0.0 { reach / longest } else { 1.0 };
        let (mut work, mut found) = at(self, whole);
        let (mut low, mut high) = ((0.0, start), (whole, work));
        let (mut share, mut best) = (whole, (whole, work.abs()));
        for _ in 0..TRIES {
            if work.abs() <= LEFT * start.abs() || (whole < 1.0 && share == whole && work * start > 0.0) {
                return found;
            }
            let crosses = high.1.is_finite() && low.1 * high.1 < 0.0;
            let part = if crosses { (low.1.abs() / (low.1.abs() + high.1.abs())).clamp(0.1, 0.9) } else { 0.5 };
            share = low.0 + part * (high.0 - low.0);
            (work, found) = at(self, share);
            if work.abs() < best.1 {
                best = (share, work.abs());
            }
            if work.is_finite() && work * start > 0.0 && work.abs() < start.abs() {
                low = (share, work);
            } else {
                high = (share, work);
            }
        }
        if best.0 == share { found } else { at(self, best.0).1 }
    }

    /// Excess of the active parts, summed on the columns.
    fn find_excess(&mut self) -> Option<()> {
        self.excess.clear();
        self.excess.resize(self.forces.len(), 0.0);
        for &index in &self.active {
            let (part, values, rows) = (&mut self.parts[index], &self.values, &self.rows);
            part.answer(self.model, |row| rows[row].column.map_or(0.0, |column| values[column]))?;
            for (row, excess) in part.rows.iter().zip(part.excess) {
                if let Some(column) = row.and_then(|row| self.rows[row].column) {
                    self.excess[column] += excess;
                }
            }
        }
        Some(())
    }
}
