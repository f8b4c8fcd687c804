//! A run of positions, looked over every few of them.

use super::loads::{Load, loads};
use super::{Condensed, CondensedError, Counts, Position, Reached};
use crate::watch::{Progress, Watch, Wish};

/// Positions between two looks at quadrilaterals that might flow: fewest, after a look that has missed one, and most. Each look
/// solves the whole system once.
const LOOK: (usize, usize) = (5, 20);

/// How often the way from one position to the next is halved before the run gives up.
const HALVINGS: u32 = 6;

/// One position of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Visited {
    /// Values of the observed functionals.
    pub observed: Vec<f64>,
    /// How it went.
    pub position: Position,
    /// What was not linear.
    pub counts: Counts,
}

/// A run of positions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Passage {
    /// Those that were balanced, in order; fewer than asked for where one was not.
    pub visited: Vec<Visited>,
    /// The position that found no balance.
    pub stopped_at: Option<usize>,
    /// Whether the onlooker stopped it.
    pub cancelled: bool,
    /// Looks after which positions were gone through again.
    pub repeated: usize,
}

impl Condensed<'_> {
    /// Goes through `count` positions with the amplitudes of each.
    pub fn pass(
        &mut self,
        count: usize,
        amplitudes: &dyn Fn(usize) -> Vec<f64>,
        watch: &mut dyn Watch,
    ) -> Result<Passage, CondensedError> {
        let mut passage = Passage::default();
        self.scan(count, amplitudes)?;
        let (mut at, mut stretch) = (0, LOOK.0);
        while at < count {
            let progress = Progress {
                stage: format!("position {} of {count}", at + 1),
                fraction: Some(at as f64 / count as f64),
                steps: at as u64,
            };
            if watch.look(&progress) == Wish::Stop {
                passage.cancelled = true;
                return Ok(passage);
            }
            let mark = self.mark();
            // The first position brings the loads on: it is looked over by itself.
            let end = if at == 0 { 1.min(count) } else { (at + stretch).min(count) };
            let mut seen = Vec::with_capacity(end - at);
            for load in loads(&self.rows, (at..end).map(amplitudes).collect()) {
                let position = self.reach_load(load)?;
                if position.reached != Reached::Balanced {
                    break;
                }
                seen.push(Visited { observed: self.observed(), position, counts: self.counts() });
            }
            let failed = seen.len() < end - at;
            if self.look_ahead()? {
                passage.repeated += 1;
                self.back_to(&mark);
                stretch = LOOK.0;
                continue;
            }
            stretch = (2 * stretch).min(LOOK.1);
            passage.visited.extend(seen);
            if failed {
                passage.stopped_at = Some(passage.visited.len());
                return Ok(passage);
            }
            at = end;
        }
        Ok(passage)
    }

    /// Goes to a position from the last one and looks over it: what was missed is watched, and the way is gone again.
    pub fn settle(&mut self, to: &[f64]) -> Result<Position, CondensedError> {
        let mark = self.mark();
        loop {
            let position = self.reach(to)?;
            if !self.look_ahead()? {
                return Ok(position);
            }
            self.back_to(&mark);
        }
    }

    /// Goes to a position, in parts of the way where the whole is too far.
    pub fn reach(&mut self, to: &[f64]) -> Result<Position, CondensedError> {
        let load = loads(&self.rows, vec![to.to_vec()]).pop().unwrap_or_default();
        self.reach_load(load)
    }

    fn reach_load(&mut self, mut to: Load) -> Result<Position, CondensedError> {
        let mut from = self.load.clone();
        let (mut reached, mut step, mut total) = (0.0, 1.0, 0);
        loop {
            let next = if reached + step > 1.0 - 1e-9 { 1.0 } else { reached + step };
            // Rows may have joined on the way.
            from.complete(&self.rows);
            to.complete(&self.rows);
            let mut position = self.go(if next == 1.0 { to.clone() } else { from.mix(&to, next) })?;
            total += position.iterations;
            position.iterations = total;
            if position.reached == Reached::Balanced {
                reached = next;
                if reached == 1.0 {
                    return Ok(position);
                }
            } else {
                step *= 0.5;
                if step < 0.5_f64.powi(HALVINGS as i32) {
                    return Ok(position);
                }
            }
        }
    }
}
