//! What each quantity does to the answer.

use super::{Row, Setting, Study};
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

/// Changes below this share of the answer are the solver's and nobody's finding: its duality gap is closed to 1e-8.
const NOTHING: f64 = 1e-6;
/// Steps of a search are equal but for rounding.
const ROUNDING: f64 = 1.0 + 1e-6;

words! {
    /// Which way the answer goes as a quantity grows.
    pub enum Trend {
        /// It never falls.
        Rising = "rising",
        /// It never rises.
        Falling = "falling",
        /// It stays.
        Flat = "flat",
        /// It does both.
        NotMonotone = "not-monotone",
        /// The quantity has no order, fewer than two answers, or answers that stay beside runs that have none.
        Unknown = "unknown",
    }
}

published! {
    /// An answer and the value that gave it.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Extreme {
        /// The value as people write it.
        pub value: String,
        /// The answer.
        pub outcome: f64,
        /// Change against the file's own bridge [%].
        pub change_percent: Option<f64>,
    }

    /// What a quantity does to the answer.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Sensitivity |one, study: &Study| {
        = quantity: String = study.path(one.quantity),
        /// Which quantity.
        pub quantity: usize [kept],
        /// The smallest answer; the first of equals.
        pub low: Option<Extreme>,
        /// The largest answer; the first of equals.
        pub high: Option<Extreme>,
        /// Largest less smallest, the answer of the file's own bridge counted among them.
        pub swing: Option<f64> [kept],
        /// The same over the answer of the file's own bridge [%].
        pub swing_percent: Option<f64>,
        /// d ln(answer) / d ln(value): over the nearest values on both sides of the file's own, or on the one side there is.
        pub elasticity: Option<f64>,
        /// Which way the answer goes.
        pub trend: Trend,
        /// Runs without the answer.
        pub without_answer: usize as runs_without_outcome,
    }
}

/// What each quantity of a one-at-a-time study does to the answer, in the order of the quantities; nothing for a grid,
/// where no quantity varies alone.
pub fn sensitivity(study: &Study) -> Vec<Sensitivity> {
    if study.design == super::Design::Grid {
        return Vec::new();
    }
    (0..study.quantities.len()).map(|quantity| one(study, quantity)).collect()
}

fn one(study: &Study, quantity: usize) -> Sensitivity {
    let own = study.baseline().and_then(|row| study.number(row));
    let answered: Vec<(&Setting, f64)> = rows(study, quantity)
        .filter_map(|row| Some((study.setting(row, quantity)?, study.number(row)?)))
        .filter(|(_, outcome)| outcome.is_finite())
        .collect();
    let size = answered.iter().map(|(_, outcome)| outcome.abs()).fold(0.0, f64::max);
    // The file's own bridge comes first and stays where others are no better than the solver's noise.
    let extreme = |sign: f64| {
        let better = |best: Option<usize>, (at, (_, outcome)): (usize, &(&Setting, f64))| match best {
            Some(known) if sign * (outcome - answered[known].1) <= NOTHING * size => Some(known),
            _ => Some(at),
        };
        let (setting, outcome) = answered[answered.iter().enumerate().fold(None, better)?];
        Some(Extreme { value: setting.text.clone(), outcome, change_percent: change(outcome, own) })
    };
    let (low, high) = (extreme(-1.0), extreme(1.0));
    let ends = low.as_ref().zip(high.as_ref()).map(|(low, high)| [low.outcome, high.outcome]);
    let with_own = |[low, high]: [f64; 2]| own.map_or(high - low, |own| high.max(own) - low.min(own));
    let swing = ends.map(with_own);
    let curve = curve(&answered);
    let without_answer = study.rows_of(quantity).filter(|row| study.number(row).is_none()).count();
    Sensitivity {
        quantity,
        swing,
        swing_percent: swing.zip(own.filter(|own| *own != 0.0)).map(|(swing, own)| 100.0 * swing / own.abs()),
        elasticity: study.quantities[quantity].own.as_ref().and_then(|own| elasticity(&curve, own.number?)),
        // What has no answer at some value did not stay.
        trend: match trend(&curve, study.resolution) {
            Trend::Flat if without_answer > 0 => Trend::Unknown,
            found => found,
        },
        without_answer,
        low,
        high,
    }
}

/// The file's own bridge and the rows of a quantity.
fn rows(study: &Study, quantity: usize) -> impl Iterator<Item = &Row> {
    study.baseline().into_iter().chain(study.rows_of(quantity))
}

fn change(outcome: f64, own: Option<f64>) -> Option<f64> {
    // Adding zero takes the sign off a negative zero.
    own.filter(|own| *own != 0.0).map(|own| 100.0 * (outcome - own) / own.abs() + 0.0)
}

/// Values with their answers in the order of the values, each value once; nothing where one has no number.
fn curve(answered: &[(&Setting, f64)]) -> Vec<(f64, f64)> {
    let points: Option<Vec<(f64, f64)>> =
        answered.iter().map(|(setting, outcome)| Some((setting.number?, *outcome))).collect();
    let mut points = points.unwrap_or_default();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by(|a, b| a.0 == b.0);
    points
}

/// The answer rises where it is anywhere higher than at some smaller value, by more than the search could err; likewise
/// it falls.
fn trend(curve: &[(f64, f64)], resolution: f64) -> Trend {
    let size = curve.iter().map(|(_, outcome)| outcome.abs()).fold(0.0, f64::max);
    let noise = (NOTHING * size).max(ROUNDING * resolution);
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut rises, mut falls) = (false, false);
    for (_, outcome) in curve {
        rises |= outcome - lowest > noise;
        falls |= highest - outcome > noise;
        lowest = lowest.min(*outcome);
        highest = highest.max(*outcome);
    }
    match (curve.len() < 2, rises, falls) {
        (true, ..) => Trend::Unknown,
        (_, true, true) => Trend::NotMonotone,
        (_, true, false) => Trend::Rising,
        (_, false, true) => Trend::Falling,
        (_, false, false) => Trend::Flat,
    }
}

/// The slope in a log-log plot between the neighbours of the file's own value; where it is the first or the last, from
/// it to its one neighbour.
fn elasticity(curve: &[(f64, f64)], own: f64) -> Option<f64> {
    let at = curve.iter().position(|(value, _)| *value == own)?;
    let (below, above) = (curve[at.saturating_sub(1)], curve[(at + 1).min(curve.len() - 1)]);
    let positive = [below.0, below.1, above.0, above.1].iter().all(|number| *number > 0.0);
    (positive && above.0 > below.0).then(|| (above.1 / below.1).ln() / (above.0 / below.0).ln())
}
