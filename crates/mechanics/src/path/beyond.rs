//! Past a limit point: a small overload is applied and the damped motion followed to rest or to collapse; then the descending branch is traced.

use super::correct::Constraint;
use super::outcome::Status;
use super::relax::{BRIEF, Fall, Falling, PATIENT, dashpots};
use super::system::advance;
use super::trace::{Heading, Next, Path, Stage};
use serde::{Deserialize, Serialize};

/// Blocks let fall under more load than the path was followed to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Push {
    /// How the path ended.
    pub end: Status,
    /// Unit of the load that is added.
    pub unit: f64,
    /// Whether no end was found closer by.
    pub coarse: bool,
    pub falling: Falling,
}

/// The path followed past its peak.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Descend {
    /// How the path ended.
    pub end: Status,
    /// Largest load factor.
    pub peak: f64,
    pub heading: Heading,
    /// Length of the next step.
    pub length: f64,
    pub step: u32,
}

/// A load that is pushed to is at most so many times the resolution further on; one that gains so many times as much on the path
/// afterwards is not enlarged.
const LARGEST_PUSH: f64 = 1024.0;
const FAR: f64 = 10.0;

/// The same where no end is found closer by: that tells the largest load to a thousandth, from below.
const COARSE_PUSH: f64 = 100.0;

/// Most loads that are pushed on where the path has as many states as it may.
const MOST_PUSHES: u32 = 500;

/// First step past the peak, as a share of the size of the blocks, in the norm of all motions.
const PAST_PEAK: f64 = 1e-3;

impl Path<'_> {
    /// What follows the end of a way up. Where balance is lost and found again close by, as when a hinge moves to the next joint, the
    /// path goes on from there.
    pub(super) fn risen(&mut self, end: Status, before: f64) -> Next {
        if matches!(end, Status::StableToLastLoad | Status::Bifurcation) {
            return Next::Break(end);
        }
        let unit = self.unseen();
        // Where the path is lost again and again, a load further on is tried.
        let gained = self.state.factor - before;
        self.push = if gained > FAR * self.push * unit { 1.0 } else { (2.0 * self.push).min(LARGEST_PUSH) };
        Next::Continue(Stage::Push(Push { end, unit, coarse: false, falling: self.let_fall(unit) }))
    }

    /// Blocks under a load a little further on.
    fn let_fall(&self, unit: f64) -> Falling {
        let mut pushed = self.state.clone();
        advance(self.model, &mut pushed, &[], (self.push * unit).min(self.program.limit - self.state.factor));
        Falling::new(pushed, if self.push > 1.0 { BRIEF } else { PATIENT })
    }

    /// One step of the way to where the blocks come to rest under a load a little further on; or how the path ends, if they do not.
    /// The load is lowered until they come to rest.
    pub(super) fn pushed(&mut self, mut push: Push) -> Next {
        let Some(fall) = self.fall(&mut push.falling) else { return Next::Continue(Stage::Push(push)) };
        match fall {
            Fall::Rests(found, balanced) => {
                self.snaps += 1;
                self.accept(found, balanced);
                if self.state.factor >= self.program.limit {
                    return Next::Break(Status::StableToLastLoad);
                }
                if self.points.len() as u32 > self.settings.most_steps + MOST_PUSHES {
                    return Next::Break(Status::NotConverged);
                }
                return self.begin_rise();
            }
            Fall::Falls(_) | Fall::Lost if self.push > 1.0 && !push.coarse => self.push = (0.25 * self.push).max(1.0),
            // That they fall for good proves that the load was the largest.
            Fall::Falls(fallen) if push.end == Status::NotConverged => {
                self.mechanism = self.way(&self.state, &fallen);
                return self.peaked(Status::LimitPoint);
            }
            // Under a little more load they fall faster, and that shows the largest load less closely.
            Fall::Lost if push.end == Status::NotConverged && !push.coarse => {
                (push.coarse, self.push) = (true, COARSE_PUSH)
            }
            Fall::Falls(_) | Fall::Lost => return self.peaked(push.end),
        }
        push.falling = self.let_fall(push.unit);
        Next::Continue(Stage::Push(push))
    }

    /// One step of a fall; how it ends, where it does.
    pub(super) fn fall(&mut self, falling: &mut Falling) -> Option<Fall> {
        let (model, settings) = (self.model, self.settings);
        let dashpots = self.dashpots.get_or_insert_with(|| dashpots(model, settings));
        let end = falling.go_on(model, settings, dashpots, &mut self.work)?;
        self.iterations += falling.corrections;
        Some(end)
    }

    /// What follows the largest load: the path past it, but for a very long one.
    pub(super) fn peaked(&mut self, end: Status) -> Next {
        if self.is_long() {
            return Next::Break(end);
        }
        let state = self.state.clone();
        let Some(heading) = self.heading(&state, None) else { return Next::Break(end) };
        let length = PAST_PEAK * self.model.size;
        Next::Continue(Stage::Descend(Descend { end, peak: state.factor, heading, length, step: 0 }))
    }

    /// Follows the path by a step past its peak, as far as that goes, until it has lost a share of its load. No state is kept above the peak: none of those
    /// past it is shown to stand.
    pub(super) fn descend(&mut self, mut descend: Descend) -> Next {
        let end = Next::Break(descend.end);
        if descend.step >= self.settings.most_steps {
            return end;
        }
        descend.step += 1;
        let constraint = Constraint::Plane(&descend.heading.direction);
        let Some((next, balanced)) = self.step(constraint, (&descend.heading, descend.length)) else {
            descend.length *= 0.5;
            return if descend.length < PAST_PEAK * self.model.size * 1e-6 {
                end
            } else {
                Next::Continue(Stage::Descend(descend))
            };
        };
        let Some(on) = self.heading(&next, Some(&descend.heading)) else { return end };
        let rises = next.factor > descend.peak;
        // Past a fork there is a branch on which the load goes on to grow, in states that do not stand.
        if rises && on.factor >= 0.0 {
            return end;
        }
        // A largest load is known to the resolution: the first state past it may lie a hair above.
        if rises {
            self.state = next;
        } else {
            self.accept(next, balanced);
        }
        let moved = self.points.last().map_or(0.0, |p| p.displacement.norm());
        if self.state.factor < descend.peak * (1.0 - self.settings.past) || moved > self.settings.farthest {
            return end;
        }
        descend.heading = on;
        descend.length *= (self.wanted(true) / f64::from(balanced.iterations.max(1))).clamp(0.5, 1.5);
        Next::Continue(Stage::Descend(descend))
    }
}
