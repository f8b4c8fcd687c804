//! Load factors at which states are first met on the way up.

use super::correct::{Constraint, balance};
use super::frame::point;
use super::model::Model;
use super::onset::{Measure, Onset};
use super::outcome::PathPoint;
use super::system::{State, commit};
use super::trace::{Heading, Path};
use crate::numbering::HELD;

/// Factors at which states are met are sought to this, relative to them.
const EXACT: f64 = 1e-4;

/// States that are tried between two of the path. Where the measure leaps they do not do, and the lower factor counts.
const TRIED: usize = 12;

impl Path<'_> {
    /// Where the path first meets each of the states that the settings name; none where it does not, or not below a factor that is given
    /// for it. All states of the path were kept.
    pub(super) fn onsets(&mut self, below: &[f64]) -> Vec<Option<f64>> {
        let settings = self.settings;
        let least = |k: usize| below.get(k).copied().unwrap_or(f64::INFINITY);
        settings.onsets.iter().enumerate().map(|(k, onset)| self.first_met(onset, least(k))).collect()
    }

    fn first_met(&mut self, onset: &Onset, below: f64) -> Option<f64> {
        let points = &self.points;
        let falls = points.windows(2).position(|pair| pair[1].factor < pair[0].factor);
        let rising = falls.map_or(points.len(), |k| k + 1);
        let first = points.first()?.rate;
        let met = points[..rising].iter().position(|point| onset.excess(point, first) > 0.0)?;
        let Some(before) = met.checked_sub(1) else { return Some(points[0].factor).filter(|factor| *factor < below) };
        if points[before].factor >= below { None } else { self.between(onset, [before, met], below, first) }
    }

    /// The factor between two states of the path at which one is met that the second shows and the first does not, if that is below another.
    fn between(&mut self, onset: &Onset, [before, met]: [usize; 2], below: f64, first: Option<f64>) -> Option<f64> {
        let place = |k: usize| (self.points[k].factor, onset.excess(&self.points[k], first));
        let (mut low, mut high) = (place(before), place(met));
        if below < high.0 {
            match self.at(onset.measure, below, [before, met]).map(|found| onset.excess(&found, first)) {
                Some(excess) if excess <= 0.0 => return None,
                Some(excess) => high = (below, excess),
                None => {}
            }
        }
        let mut last_was_low = None;
        for _ in 0..TRIED {
            let share = (low.1 / (low.1 - high.1)).clamp(0.02, 0.98);
            let factor = low.0 + share * (high.0 - low.0);
            let Some(found) = self.at(onset.measure, factor, [before, met]) else { break };
            let excess = onset.excess(&found, first);
            if excess.abs() * (high.0 - low.0) <= EXACT * factor * (high.1 - low.1) {
                return (factor < below).then_some(factor);
            }
            let is_low = excess <= 0.0;
            // An end that stays is taken for half as far off, or it would stay for ever (the Illinois method).
            let stays = if last_was_low == Some(is_low) { 0.5 } else { 1.0 };
            (low, high) = if is_low {
                ((factor, excess), (high.0, stays * high.1))
            } else {
                ((low.0, stays * low.1), (factor, excess))
            };
            last_was_low = Some(is_low);
        }
        (low.0 < below).then_some(low.0)
    }

    /// The stable state at a factor between those of two states of the path, in numbers; none where none is found.
    fn at(&mut self, measure: Measure, factor: f64, [from, to]: [usize; 2]) -> Option<PathPoint> {
        let (one, other) = (&self.states[from], &self.states[to]);
        let share = (factor - one.factor) / (other.factor - one.factor);
        let mut state = State { factor, ..one.clone() };
        for (motion, other) in state.motions.iter_mut().zip(&other.motions) {
            for (value, other) in motion.iter_mut().zip(other) {
                *value += share * (other - *value);
            }
        }
        let found = balance(self.model, self.settings, Constraint::Load, &mut state, &mut self.work)?;
        let holds = !(self.work.slides || self.work.cracks);
        if !holds {
            commit(self.model, self.settings, &mut state);
        }
        self.assembled = holds;
        if !self.is_stable(&state) {
            return None;
        }
        let mut numbers = point(self.model, (self.settings, self.program), &state, (found.iterations, found.residual));
        if measure == Measure::Softening {
            self.assembled = true;
            numbers.rate = self.heading(&state, None).map(|heading| self.rate(&heading));
        }
        Some(numbers)
    }

    /// The last point of the path is known to go on like this, its equations being those in the workspace.
    pub(super) fn goes_on(&mut self, heading: &Heading) {
        let rate = self.rate(heading);
        if let Some(last) = self.points.last_mut() {
            last.rate = Some(rate);
        }
    }

    fn rate(&self, heading: &Heading) -> f64 {
        let grown: Vec<f64> = heading.direction.iter().map(|part| part / heading.factor).collect();
        fastest(self.model, &grown)
    }
}

/// How far the centre of the block that moves most does for a load factor of one more [m], where the unknowns grow by so much. No place has to be
/// chosen, so that it changes as continuously as the load.
pub(super) fn fastest(model: &Model, grown: &[f64]) -> f64 {
    let moves = |block: usize| {
        let [x, y] = [0, 1].map(|c| match model.equation[block][c] {
            HELD => model.movement[block][c],
            equation => grown[equation as usize],
        });
        x.hypot(y)
    };
    (0..model.built.len()).map(moves).fold(0.0, f64::max)
}
