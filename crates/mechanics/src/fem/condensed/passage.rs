//! A run of positions, found a stretch at a time and then looked over at all of them at once.

use super::balance::Track;
use super::{Condensed, CondensedError, Counts, Mark, Place, Position, Reached};
use crate::fem::many::{WIDEST, WIDTHS};
use crate::watch::{Progress, Watch, Wish};

/// How often the way from one position to the next is halved before the run gives up.
const HALVINGS: u32 = 6;

/// Positions that are looked over together: twice as many are undone too often, and half as many cost as much to look over.
const LONGEST: usize = WIDTHS[1] - 1;

/// Positions beyond a stretch at which parts are looked at too, going on as in the last of them: those that would answer otherwise there join early. With ten
/// a fifth more rows join than with five.
const AHEAD: usize = 6;

/// Positions after which a part that has not moved any more is hot no longer.
pub(super) const COOLS: u64 = 4;

/// One position of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Visited {
    /// Values of the observed functionals.
    pub observed: Vec<f64>,
    /// How it went.
    pub position: Position,
    /// What was not linear.
    pub counts: Counts,
    /// Where it is, if that was to be kept.
    pub(super) place: Option<Place>,
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
    /// Stretches of which a part was gone through again.
    pub repeated: usize,
}

/// A position that was reached, and how to undo it.
#[derive(Debug)]
pub(super) struct Step {
    position: Position,
    counts: Counts,
    from: Place,
    to: Place,
    track: Track,
}

/// Where steps end, and where something broke on the way to which of them.
fn places(steps: &[Step]) -> (Vec<&Place>, Vec<(usize, &Place)>) {
    let breaks = steps.iter().enumerate().flat_map(|(k, step)| step.track.breaks.iter().map(move |place| (k, place)));
    (steps.iter().map(|step| &step.to).collect(), breaks.collect())
}

impl Condensed<'_> {
    /// Goes through `count` positions with the amplitudes of each.
    ///
    /// A stretch of positions is found with the parts that are active. One solution of the whole linear system for each then shows all other parts,
    /// and the stretch counts up to the first position at which one of them would have answered otherwise; those join, and the run
    /// goes on from there.
    pub fn pass(
        &mut self,
        count: usize,
        amplitudes: &dyn Fn(usize) -> Vec<f64>,
        watch: &mut dyn Watch,
    ) -> Result<Passage, CondensedError> {
        let mut passage = Passage::default();
        let mut stretch = if self.active.is_empty() { 1 } else { WIDTHS[0] - 1 };
        while passage.visited.len() < count {
            let at = passage.visited.len();
            let progress = Progress {
                stage: format!("position {} of {count}", at + 1),
                fraction: Some(at as f64 / count as f64),
                steps: at as u64,
            };
            if watch.look(&progress) == Wish::Stop {
                passage.cancelled = true;
                return Ok(passage);
            }
            self.cool_down();
            let mut steps = Vec::with_capacity(stretch);
            for k in at..(at + stretch).min(count) {
                steps.push(self.reach(&amplitudes(k))?);
                if steps.last().is_some_and(|step| step.position.reached != Reached::Balanced) {
                    break;
                }
            }
            let failed = steps.pop_if(|step| step.position.reached != Reached::Balanced);
            let ahead = (count - at - steps.len()).min(AHEAD);
            let (observed, good) = self.look_over(&mut steps, ahead)?;
            let observed_any = !steps.is_empty();
            for (step, observed) in steps.into_iter().zip(observed) {
                let place = self.keeps_places.then_some(step.to);
                passage.visited.push(Visited { observed, position: step.position, counts: step.counts, place });
            }
            if !good {
                passage.repeated += 1;
                stretch = if observed_any { WIDTHS[0] - 1 } else { 1 };
            } else if failed.is_some() {
                passage.stopped_at = Some(passage.visited.len());
                return Ok(passage);
            } else {
                stretch = (stretch + 1 + stretch / 2).min(LONGEST);
            }
        }
        Ok(passage)
    }

    /// Goes to a position from the last one, in parts of the way where the whole is too far.
    pub fn settle(&mut self, to: &[f64]) -> Result<Position, CondensedError> {
        loop {
            self.cool_down();
            let step = self.reach(to)?;
            let position = step.position;
            if position.reached != Reached::Balanced || self.look_over(&mut vec![step], 0)?.1 {
                return Ok(position);
            }
        }
    }

    /// Goes from a mark to some positions, each from there: the train at rest at one place or another. All are looked over side by side, and
    /// those in which another part takes part are gone to again. A position without balance tells nothing of what is observed.
    pub fn branch(&mut self, from: &Mark, to: &[Vec<f64>]) -> Result<Vec<Visited>, CondensedError> {
        let mut found: Vec<Option<Visited>> = vec![None; to.len()];
        loop {
            let open = (0..to.len()).filter(|k| found[*k].is_none());
            let open: Vec<usize> = open.take(WIDEST).collect();
            if open.is_empty() {
                return Ok(found.into_iter().flatten().collect());
            }
            let mut steps: Vec<Step> = Vec::with_capacity(open.len());
            for &k in &open {
                self.back_to(from);
                self.cool_down();
                steps.push(self.reach(&to[k])?);
            }
            let (ends, breaks) = places(&steps);
            let (joining, stands) = self.joining(&ends, &breaks, 0)?;
            for (lane, (k, step)) in open.into_iter().zip(steps).enumerate().filter(|(lane, _)| stands[*lane]) {
                let balanced = step.position.reached == Reached::Balanced;
                let observed = if balanced { self.observed_in(lane) } else { Vec::new() };
                let place = self.keeps_places.then_some(step.to);
                found[k] = Some(Visited { observed, position: step.position, counts: step.counts, place });
            }
            self.activate(&joining);
        }
    }

    /// Looks at all parts in the positions that were reached. Those from which on others than the active ones take part are undone and taken off `steps`;
    /// tells what is observed in those that are left, and whether these are all.
    fn look_over(&mut self, steps: &mut Vec<Step>, ahead: usize) -> Result<(Vec<Vec<f64>>, bool), CondensedError> {
        let (ends, breaks) = places(steps);
        let (joining, stands) = self.joining(&ends, &breaks, ahead)?;
        let first = stands.iter().position(|stands| !stands).unwrap_or(stands.len());
        for step in steps.drain(first..).rev() {
            self.undo(step);
        }
        let observed: Vec<Vec<f64>> = (0..first).map(|lane| self.observed_in(lane)).collect();
        if let Some(last) = observed.last() {
            self.at.observed.clone_from(last);
        }
        let good = first == stands.len();
        self.activate(&joining);
        Ok((observed, good))
    }

    fn undo(&mut self, step: Step) {
        self.at = step.from;
        self.foreseen.clear();
        // Rows that have joined since carried nothing there.
        self.complete();
        self.hot.forget();
        for (part, before) in step.track.before.iter().rev() {
            self.parts[*part].restore(before);
        }
    }

    /// What did not move for some positions iterates no longer.
    fn cool_down(&mut self) {
        let hot = self.active.iter().filter(|&&part| self.moved_at[part] + COOLS >= self.clock);
        self.hot.set(hot.copied(), &self.parts, &self.rows);
    }

    /// Goes to a position with the parts that are active, in parts of the way where the whole is too far; where no balance is found the last one
    /// is as it was.
    fn reach(&mut self, to: &[f64]) -> Result<Step, CondensedError> {
        let from = self.at.clone();
        let (mut reached, mut step, mut iterations) = (0.0, 1.0, 0);
        let mut track = Track::default();
        loop {
            let next = if reached + step > 1.0 - 1e-9 { 1.0 } else { reached + step };
            let mix = |(a, b): (&f64, &f64)| if next == 1.0 { *b } else { a + next * (b - a) };
            let amplitudes = from.amplitudes.iter().zip(to).map(mix).collect();
            let mut position = self.go(amplitudes, &mut track);
            iterations += position.iterations;
            position.iterations = iterations;
            if position.reached == Reached::Balanced {
                reached = next;
                if reached == 1.0 {
                    return Ok(Step { position, counts: self.counts(), from, to: self.at.clone(), track });
                }
                continue;
            }
            step *= 0.5;
            if step < 0.5_f64.powi(HALVINGS as i32) {
                // It may be for want of parts that flow or slide where it got to.
                let here = self.at.clone();
                let (joining, _) = self.joining(&[&here], &[], 0)?;
                let counts = Counts::default();
                self.undo(Step { position, counts, from: from.clone(), to: Place::default(), track });
                if joining.is_empty() {
                    return Ok(Step { position, counts, from: from.clone(), to: from, track: Track::default() });
                }
                self.activate(&joining);
                (reached, step, track) = (0.0, 1.0, Track::default());
            }
        }
    }
}
