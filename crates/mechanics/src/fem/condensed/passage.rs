//! A run of positions, solved by batches: the eliminated parts are rechecked in all positions of a batch at once.

use super::increment::UndoLog;
use super::parts::Committed;
use super::recheck::Recheck;
use super::{Condensed, CondensedError, Counts, Equilibrium, Position, Reached, Snapshot};
use crate::fem::many::{WIDEST, WIDTHS};
use crate::watch::{Asking, Progress, Watch};
use std::collections::BTreeMap;

/// Number of times that the way from one position to the next is halved before the run stops.
const HALVINGS: u32 = 6;

/// Positions of the longest batch: of batches twice as long, too many are rolled back; half as many cost as much to recheck.
const LONGEST_BATCH: usize = WIDTHS[1] - 1;

/// Positions beyond a batch at which parts are rechecked too, by extrapolation: those that are nonlinear there are retained
/// early. With ten a fifth more rows are retained than with five.
const LOOKAHEAD: usize = 6;

/// Positions in a row in which a part has to be linear before it is deactivated.
pub(super) const DEACTIVATION_DELAY: u64 = 4;

/// One solved position of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Visited {
    /// Values of the observed functionals.
    pub observed: Vec<f64>,
    /// How the solution ended.
    pub position: Position,
    /// Numbers of nonlinear parts.
    pub counts: Counts,
    /// The equilibrium, if equilibria are kept.
    pub(super) equilibrium: Option<Equilibrium>,
}

/// A run of positions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Passage {
    /// Positions that were solved, in order; fewer than asked for where one was not.
    pub visited: Vec<Visited>,
    /// The position for which no equilibrium was found.
    pub stopped_at: Option<usize>,
    /// Whether the watcher stopped the run.
    pub cancelled: bool,
    /// Number of batches of which positions were rolled back and solved again.
    pub repeated: usize,
}

/// A solved position, and how to roll it back.
#[derive(Debug)]
pub(super) struct Step {
    position: Position,
    counts: Counts,
    from: Equilibrium,
    to: Equilibrium,
    undo_log: UndoLog,
}

/// Positions that are solved in turn, batch by batch.
#[derive(Debug)]
pub struct Run {
    count: usize,
    /// Length of the next batch.
    batch: usize,
    /// What was found so far.
    pub passage: Passage,
    /// The steps of the last batch that is valid.
    last: Vec<Step>,
}

impl Run {
    /// Whether there is more to solve.
    pub fn goes_on(&self) -> bool {
        let Passage { visited, stopped_at, cancelled, .. } = &self.passage;
        visited.len() < self.count && stopped_at.is_none() && !cancelled
    }

    /// The equilibrium at a position of the last batch, where the last one is `current`, and earlier states of parts that
    /// changed since.
    pub(super) fn at(&self, position: usize, current: &Equilibrium) -> (Equilibrium, BTreeMap<usize, Committed>) {
        let later = (self.passage.visited.len().saturating_sub(position + 1)).min(self.last.len());
        let (before, after) = self.last.split_at(self.last.len() - later);
        let equilibrium = match (before.last(), after.first()) {
            (_, None) => current,
            (Some(step), _) => &step.to,
            (None, Some(step)) => &step.from,
        };
        let changes = after.iter().rev().flat_map(|step| step.undo_log.states.iter().rev());
        (equilibrium.clone(), changes.copied().collect())
    }
}

/// Gives the equilibria at the ends of some steps, and those in which springs broke with the number of their step.
fn equilibria(steps: &[Step]) -> (Vec<&Equilibrium>, Vec<(usize, &Equilibrium)>) {
    let breaks = steps
        .iter()
        .enumerate()
        .flat_map(|(k, step)| step.undo_log.breaks.iter().map(move |equilibrium| (k, equilibrium)));
    (steps.iter().map(|step| &step.to).collect(), breaks.collect())
}

impl Condensed {
    /// Solves `count` positions in turn, with the amplitudes that `amplitudes` gives for each: one for each pattern, in their order.
    ///
    /// A batch of positions is solved with the parts that are retained. Then the linear system is solved for all positions of the
    /// batch at once, and the eliminated parts are rechecked. The batch is valid up to the first position in which one of them is
    /// nonlinear; the positions from there on are rolled back, those parts are retained, and the run goes on.
    ///
    /// # Errors
    /// A part that has no answer to its displacements; a position without equilibrium is told in the passage.
    pub fn solve_positions(
        &mut self,
        count: usize,
        amplitudes: &dyn Fn(usize) -> Vec<f64>,
        watch: &mut dyn Watch,
    ) -> Result<Passage, CondensedError> {
        let mut run = self.begin(count);
        while run.goes_on() {
            self.solve_batch(&mut run, amplitudes, watch)?;
        }
        Ok(run.passage)
    }

    /// Begins a run of `count` positions from the current one.
    pub fn begin(&self, count: usize) -> Run {
        let batch = if self.retained.is_empty() { 1 } else { WIDTHS[0] - 1 };
        Run { count, batch, passage: Passage::default(), last: Vec::new() }
    }

    /// Solves the next batch of a run, or the part of it that is valid.
    ///
    /// # Errors
    /// A part that has no answer to its displacements.
    pub fn solve_batch(
        &mut self,
        run: &mut Run,
        amplitudes: &dyn Fn(usize) -> Vec<f64>,
        watch: &mut dyn Watch,
    ) -> Result<(), CondensedError> {
        let (mut asking, count, at) = (Asking::new(watch), run.count, run.passage.visited.len());
        self.update_active_set();
        let mut steps = Vec::with_capacity(run.batch);
        for k in at..(at + run.batch).min(count) {
            let progress = Progress {
                stage: format!("position {} of {count}", k + 1),
                fraction: Some(k as f64 / count as f64),
                steps: k as u64,
            };
            if asking.tell(progress) {
                break;
            }
            steps.push(self.solve_in_substeps(&amplitudes(k), &mut asking)?);
            if steps.last().is_some_and(|step| step.position.reached != Reached::Balanced) {
                break;
            }
        }
        let failed = steps.pop_if(|step| step.position.reached != Reached::Balanced);
        if asking.stopped {
            steps.drain(..).rev().for_each(|step| self.roll_back(step.from, &step.undo_log));
            run.passage.cancelled = true;
            return Ok(());
        }
        let lookahead = (count - at - steps.len()).min(LOOKAHEAD);
        let (observed, complete) = self.recheck_and_roll_back(&mut steps, lookahead, &mut asking)?;
        let any_valid = !steps.is_empty();
        for (step, observed) in steps.iter().zip(observed) {
            let equilibrium = self.keeps_equilibria.then(|| step.to.clone());
            run.passage.visited.push(Visited { observed, position: step.position, counts: step.counts, equilibrium });
        }
        if any_valid {
            run.last = steps;
        }
        if !complete {
            run.passage.repeated += 1;
            run.batch = if any_valid { WIDTHS[0] - 1 } else { 1 };
        } else if failed.is_some() {
            run.passage.stopped_at = Some(run.passage.visited.len());
        } else {
            run.batch = (run.batch + 1 + run.batch / 2).min(LONGEST_BATCH);
        }
        run.passage.cancelled = asking.stopped;
        Ok(())
    }

    /// Solves one position from the current one, in substeps where the whole step does not converge. `to` are the amplitudes there.
    ///
    /// # Errors
    /// A part that has no answer to its displacements.
    pub fn solve_position(&mut self, to: &[f64], watch: &mut dyn Watch) -> Result<Position, CondensedError> {
        let mut asking = Asking::new(watch);
        loop {
            self.update_active_set();
            let step = self.solve_in_substeps(to, &mut asking)?;
            let position = step.position;
            let valid =
                position.reached != Reached::Balanced || self.recheck_and_roll_back(&mut vec![step], 0, &mut asking)?.1;
            if asking.stopped {
                return Ok(Position { reached: Reached::Cancelled, ..position });
            }
            if valid {
                return Ok(position);
            }
        }
    }

    /// Solves several positions, each from the same snapshot: the train at rest at one place or another. All are rechecked
    /// together; those in which an eliminated part is nonlinear are solved again. A position without equilibrium has no observed
    /// values. `None` where the onlooker stops it.
    ///
    /// # Errors
    /// A part that has no answer to its displacements.
    pub fn solve_branches(
        &mut self,
        from: &Snapshot,
        to: &[Vec<f64>],
        watch: &mut dyn Watch,
    ) -> Result<Option<Vec<Visited>>, CondensedError> {
        let mut asking = Asking::new(watch);
        let mut found: Vec<Option<Visited>> = vec![None; to.len()];
        loop {
            let unsolved = (0..to.len()).filter(|k| found[*k].is_none());
            let unsolved: Vec<usize> = unsolved.take(WIDEST).collect();
            if unsolved.is_empty() {
                return Ok(Some(found.into_iter().flatten().collect()));
            }
            let mut steps: Vec<Step> = Vec::with_capacity(unsolved.len());
            for &k in &unsolved {
                self.restore(from);
                self.update_active_set();
                steps.push(self.solve_in_substeps(&to[k], &mut asking)?);
                if asking.stopped {
                    return Ok(None);
                }
            }
            let (ends, breaks) = equilibria(&steps);
            let Recheck { to_retain, valid } = self.recheck_eliminated(&ends, &breaks, 0)?;
            for (lane, (k, step)) in unsolved.into_iter().zip(steps).enumerate().filter(|(lane, _)| valid[*lane]) {
                let balanced = step.position.reached == Reached::Balanced;
                let observed = if balanced { self.observed_values(lane) } else { Vec::new() };
                let equilibrium = self.keeps_equilibria.then_some(step.to);
                found[k] = Some(Visited { observed, position: step.position, counts: step.counts, equilibrium });
            }
            self.retain_nonlinear(&to_retain, &mut asking);
            if asking.stopped {
                return Ok(None);
            }
        }
    }

    /// Rechecks the eliminated parts in all `steps`; rolls back to the first position that is no longer valid and takes the
    /// others off `steps`. Gives the observed values of those that are left, and whether these are all.
    fn recheck_and_roll_back(
        &mut self,
        steps: &mut Vec<Step>,
        lookahead: usize,
        asking: &mut Asking<'_>,
    ) -> Result<(Vec<Vec<f64>>, bool), CondensedError> {
        let (ends, breaks) = equilibria(steps);
        let Recheck { to_retain, valid } = self.recheck_eliminated(&ends, &breaks, lookahead)?;
        let first = valid.iter().position(|valid| !valid).unwrap_or(valid.len());
        steps.drain(first..).rev().for_each(|step| self.roll_back(step.from, &step.undo_log));
        let observed: Vec<Vec<f64>> = (0..first).map(|lane| self.observed_values(lane)).collect();
        if let Some(last) = observed.last() {
            self.current.observed.clone_from(last);
        }
        let complete = first == valid.len();
        self.retain_nonlinear(&to_retain, asking);
        Ok((observed, complete))
    }

    /// Rolls back what was done since the equilibrium `from`.
    fn roll_back(&mut self, from: Equilibrium, undo_log: &UndoLog) {
        self.go_back_to(from);
        undo_log.states.iter().rev().for_each(|&(part, state)| self.parts[part].committed = state);
    }

    /// Deactivates parts that have been linear for some positions.
    fn update_active_set(&mut self) {
        let recent =
            self.retained.iter().filter(|&&part| self.last_nonlinear[part] + DEACTIVATION_DELAY >= self.position_count);
        self.active_set.update(recent.copied(), &self.parts, &self.rows);
    }

    /// Solves one position with the retained parts, in substeps where the whole step does not converge; where no equilibrium is
    /// found, the current one stays as it is.
    fn solve_in_substeps(&mut self, to: &[f64], asking: &mut Asking<'_>) -> Result<Step, CondensedError> {
        let from = self.current.clone();
        let (mut share, mut step, mut iterations) = (0.0, 1.0, 0);
        let mut undo_log = UndoLog::default();
        loop {
            let next = if share + step > 1.0 - 1e-9 { 1.0 } else { share + step };
            let mix = |(a, b): (&f64, &f64)| if next == 1.0 { *b } else { a + next * (b - a) };
            let amplitudes = from.amplitudes.iter().zip(to).map(mix).collect();
            let mut position = self.solve_increment(amplitudes, &mut undo_log, asking);
            iterations += position.iterations;
            position.iterations = iterations;
            if position.reached == Reached::Balanced {
                share = next;
                if share == 1.0 {
                    return Ok(Step { position, counts: self.counts(), from, to: self.current.clone(), undo_log });
                }
                continue;
            }
            step *= 0.5;
            let cancelled = position.reached == Reached::Cancelled;
            if !cancelled && step >= 0.5_f64.powi(HALVINGS as i32) {
                continue;
            }
            // An eliminated part may be nonlinear here, so that no equilibrium is found without it.
            let here = self.current.clone();
            let to_retain = if cancelled { Vec::new() } else { self.recheck_eliminated(&[&here], &[], 0)?.to_retain };
            self.roll_back(from.clone(), &undo_log);
            (share, step, undo_log) = (0.0, 1.0, UndoLog::default());
            if to_retain.is_empty() {
                return Ok(Step { position, counts: Counts::default(), from: from.clone(), to: from, undo_log });
            }
            self.retain_nonlinear(&to_retain, asking);
        }
    }
}
