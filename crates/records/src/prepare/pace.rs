//! Does the timing of axles agree with the speed that a record states?

use super::align::{Reference, best_shift, golden};
use crate::{Recording, Series};

/// Speeds are noted to the nearest km/h, which is 5 % at 20 km/h: nearer than that nothing is contradicted.
const NEAR: f64 = 0.05;
/// Speeds are looked for between the stated one over this and times this.
const WIDEST: f64 = 2.5;
/// Step of the search, as a ratio of speeds. Over a train thirty spans long, 2 % shift its last axle by half a span.
const STEP: f64 = 1.02;
/// Samples that this search compares.
const COARSE: usize = 800;
/// What another speed must leave unexplained, as a share of what the stated one does: a model's shape alone is never that wrong.
const BETTER: f64 = 0.5;
/// Reference that is this many times as long as its longest answer tells a speed; a shorter one tells the width of a bump.
const AXLES_APART: f64 = 4.0;

/// Names a speed that axle timing contradicts. `reference` holds for the speed that the record states, and fits it with
/// `correlation` at its best shift.
pub(super) fn judge(run: &Recording, measured: &[f64], reference: &Reference, correlation: f64, log: &mut Series) {
    if !long_enough(reference) {
        return;
    }
    let fit = |ratio: f64| best_shift(&run.times, measured, &reference.faster(ratio), COARSE).1;
    let steps = (WIDEST.ln() / STEP.ln()).ceil() as i32;
    let ratios = (-steps..=steps).map(|k| STEP.powi(k));
    let best = ratios.map(|ratio| (ratio, fit(ratio))).reduce(|a, b| if b.1 > a.1 { b } else { a });
    let Some((near, _)) = best else { return };
    let ratio = golden(near / STEP, near * STEP, fit);
    let found = fit(ratio);
    let unexplained = |correlation: f64| 1.0 - correlation.max(0.0).powi(2);
    if (ratio - 1.0).abs() <= NEAR || unexplained(found) > BETTER * unexplained(correlation) {
        return;
    }
    let kmh = |speed: f64| format!("{:.1} km/h", 3.6 * speed);
    let told = match (run.speed, reference.speed) {
        (Some(speed), _) => format!("a speed of {}, where the record states {}", kmh(ratio * speed), kmh(speed)),
        (None, Some(speed)) => format!("a speed of {}, where {} was assumed", kmh(ratio * speed), kmh(speed)),
        (None, None) => format!("{ratio:.2} times the speed that was assumed"),
    };
    let message = format!(
        "axle timing tells of {told} (correlation {found:.3} in place of {correlation:.3}); the run is used as it is"
    );
    log.could_not(run, "R066", message, "correct the speed, or leave the run out");
}

/// Whether the reference lasts long beside the longest time for which it keeps its sign above a tenth of its peak.
fn long_enough(reference: &Reference) -> bool {
    let peak = reference.values.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let answers = |k: usize| reference.values[k].abs() > 0.1 * peak;
    let Some(first) = (0..reference.values.len()).find(|k| answers(*k)) else { return false };
    let last = (first..reference.values.len()).rfind(|k| answers(*k)).unwrap_or(first);
    let (mut longest, mut since) = (0.0_f64, None);
    for k in first..=last {
        match (answers(k), since) {
            (true, None) => since = Some(reference.times[k]),
            (true, Some(begin)) => longest = longest.max(reference.times[k] - begin),
            (false, _) => since = None,
        }
    }
    reference.times[last] - reference.times[first] >= AXLES_APART * longest.max(f64::MIN_POSITIVE)
}
