//! The way up: steps along the path to where the load grows no more, a state does not stand or no next state is found.

use super::correct::Constraint;
use super::outcome::Status;
use super::system::scale;
use super::trace::{Heading, Next, Path, Stage};
use serde::{Deserialize, Serialize};

/// The path followed up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Rise {
    pub heading: Heading,
    /// Length of the next step, and of the longest first one.
    pub share: f64,
    pub first: f64,
    /// Length of the last step that led to no state, where there was one not long ago.
    pub lost: Option<f64>,
    pub past: Option<Past>,
    pub step: u32,
    /// Load factor where it began.
    pub before: f64,
}

/// A state past the largest load, seen from the last one before it: its distance along the path, and how the factor changes there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Past {
    pub distance: f64,
    pub rate: f64,
}

impl Past {
    /// The share of the distance to a place a little before the largest load, if the rate changes evenly between the two.
    pub(super) fn short_of_peak(&self, heading: &Heading) -> f64 {
        const SHORT: f64 = 0.95;
        (SHORT * heading.factor / (heading.factor - self.rate)).clamp(0.05, 0.9)
    }
}

/// Iterations that a step of the right length takes.
const WANTED_ITERATIONS: f64 = 5.0;

/// The same where joints slide and the step is short: these take some iterations to show how they go on, and no fewer of them
/// where the step is shorter. What slides in a step does so in one direction, so that steps longer than these are not sought.
const WANTED_WHERE_SLIDING: f64 = 10.0;

/// Share by which what acts may grow in a step in which joints slide: what slides does so in one direction within a step, whatever the
/// way to its end.
const SLIDING_GAIN: f64 = 0.05;

/// Share of the first increment below which steps are not cut for that.
const LEAST_GAIN: f64 = 1e-3;

/// A step is short that gains less than this share of the load.
const SHORT: f64 = 2e-3;

/// A step after one that led to no state is at most this share of its length, and the next ones this much longer each.
const SHY: f64 = 0.75;
const DARING: f64 = 1.5;

impl Path<'_> {
    /// Begins to follow the path up from the last balanced state.
    pub(super) fn begin_rise(&mut self) -> Next {
        // A path of very many states is left to loads that are pushed on alone: these come to an end.
        let before = self.state.factor;
        if self.is_long() {
            return self.risen(Status::NotConverged, before);
        }
        match self.rising() {
            Some(rise) => Next::Continue(Stage::Rise(rise)),
            None => self.risen(Status::NotConverged, before),
        }
    }

    /// The path up from the last balanced state; none where the tangent is singular.
    pub(super) fn rising(&mut self) -> Option<Rise> {
        let state = self.state.clone();
        let heading = self.heading(&state, None)?;
        self.goes_on(&heading);
        let first = self.program.increment.min(self.program.limit) / heading.factor;
        let share = self.length.unwrap_or(first).min(first);
        let step = self.points.len() as u32;
        Some(Rise { heading, share, first, lost: None, past: None, step, before: state.factor })
    }

    /// One step up.
    pub(super) fn rise(&mut self, mut rise: Rise) -> Next {
        let before = rise.before;
        match self.climb(&mut rise) {
            None => Next::Continue(Stage::Rise(rise)),
            Some(end) => self.risen(end, before),
        }
    }

    /// Follows the path by a step up to where the load grows no more, a state does not stand or no next state is found; that is
    /// found to the resolution, and the state is left just before it.
    pub(super) fn climb(&mut self, rise: &mut Rise) -> Option<Status> {
        if rise.step >= self.settings.most_steps {
            return Some(Status::NotConverged);
        }
        rise.step += 1;
        let target = self.program.limit;
        let factor = self.state.factor;
        let mut reaches = factor + rise.heading.factor * rise.share >= target;
        if reaches {
            rise.share = (target - factor) / rise.heading.factor;
        }
        let unseen = self.unseen();
        // The load grows ever slower towards its largest value.
        if rise.past.as_ref().is_some_and(|past| rise.heading.factor * past.distance <= unseen) {
            self.mechanism.clone_from(&rise.heading.direction);
            return Some(Status::LimitPoint);
        }
        let most = self.most_where_sliding(&rise.heading);
        if rise.share > most && self.points.last().is_some_and(|p| p.sliding > 0) {
            rise.share = most;
            reaches = false;
        }
        let close = rise.heading.factor * rise.share <= unseen;
        let constraint = if reaches { Constraint::Load } else { Constraint::Plane(&rise.heading.direction) };
        let Some((next, balanced)) = self.step(constraint, (&rise.heading, rise.share)) else {
            if close {
                return Some(Status::NotConverged);
            }
            rise.lost = Some(rise.share);
            rise.share *= 0.5;
            return None;
        };
        if self.work.slides && rise.share > most {
            rise.share = most;
            return None;
        }
        let on = self.heading(&next, Some(&rise.heading));
        let falls = next.factor <= factor || on.as_ref().is_some_and(|on| on.factor <= 0.0);
        let turns = on.as_ref().is_none_or(|on| !on.stable);
        let on = match on {
            Some(on) if !falls && !turns => on,
            on => {
                if close {
                    self.mechanism.clone_from(&rise.heading.direction);
                    if falls {
                        return Some(Status::LimitPoint);
                    }
                    // Where a joint opens or closes the path has a corner; where it forks it has none.
                    if !on.is_some_and(|on| self.goes_on_to(&next, [&rise.heading, &on])) {
                        return Some(Status::NotConverged);
                    }
                    if let Some(sideways) = self.easiest() {
                        self.mechanism = sideways;
                    }
                    return Some(Status::Bifurcation);
                }
                rise.past = on.filter(|on| on.factor < 0.0).map(|on| Past { distance: rise.share, rate: on.factor });
                rise.share *= rise.past.as_ref().map_or(0.5, |past| past.short_of_peak(&rise.heading));
                return None;
            }
        };
        self.accept(next, balanced);
        self.goes_on(&on);
        if reaches {
            return Some(Status::StableToLastLoad);
        }
        self.length = Some(rise.share);
        rise.heading = on;
        let short = rise.share < rise.first || rise.heading.factor * rise.share < SHORT * self.state.factor;
        let grown = rise.share * (self.wanted(short) / f64::from(balanced.iterations.max(1))).clamp(0.5, 2.0);
        let grown = rise.lost.map_or(grown, |lost| grown.min(SHY * lost));
        rise.lost = rise.lost.map(|lost| lost * DARING).filter(|lost| SHY * lost < 2.0 * grown);
        let nearer = |past: Past| Past { distance: past.distance - rise.share, ..past };
        rise.past = rise.past.map(nearer).filter(|past| past.distance > 0.0);
        let most = |past: &Past| grown.min(past.distance * past.short_of_peak(&rise.heading));
        rise.share = rise.past.as_ref().map_or(grown, most);
        None
    }

    /// Length of the longest step in which joints slide.
    fn most_where_sliding(&self, heading: &Heading) -> f64 {
        let acting = |factor: f64| scale(self.model, factor);
        let grown = acting(1.0) - acting(0.0);
        // Blocks that weigh nothing begin somewhere.
        let gain = (SLIDING_GAIN * acting(self.state.factor) / grown).max(LEAST_GAIN * self.program.increment);
        if grown > 0.0 { gain / heading.factor } else { f64::INFINITY }
    }

    /// Iterations that the next step should take.
    pub(super) fn wanted(&self, short: bool) -> f64 {
        let slides = self.points.last().is_some_and(|p| p.sliding > 0);
        if slides && short { WANTED_WHERE_SLIDING } else { WANTED_ITERATIONS }
    }
}
