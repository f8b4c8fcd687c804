//! What a load test would tell, beside what it tells.

use super::plan;
use super::readings_tests::{SOUGHT, TRUTH, read_of, text_of, truth, uncertainty, updated, with};
use outcome::plan::LoadTestPlan;

/// Places in which the lorry might stand, by its first axle [m].
fn places() -> Vec<f64> {
    (0..13).map(|k| 0.8 + 0.8 * f64::from(k)).collect()
}

fn planned(text: &str) -> LoadTestPlan {
    with(text, &[], |task, means| plan(task, means).unwrap().unwrap())
}

/// Of these places, those of names as "P3".
fn named(names: impl Iterator<Item = String>) -> Vec<f64> {
    let mut chosen: Vec<usize> = names.map(|name| name[1..].parse().unwrap()).collect();
    chosen.sort_unstable();
    chosen.into_iter().map(|k| places()[k]).collect()
}

/// Readings as the start model has them leave intervals of the width that was foretold, by draws and not by a formula; readings say nothing of
/// what they tell.
#[test]
fn intervals_are_as_wide_as_was_foretold() {
    let fronts = [1.6, 4.0, 7.2];
    let file = |readings: &[String], gain: &str| {
        text_of(&uncertainty(), &fronts, readings) + &SOUGHT.replace("deviation = 0.0", &format!("deviation = {gain}"))
    };
    for gain in ["0.0", "0.03"] {
        let before = planned(&file(&[], gain));
        let readings = read_of(&file(&[], gain), 0.0, 1);
        let found = updated(&file(&readings, gain), &[]);
        assert_eq!(planned(&file(&readings, gain)), before);
        for (k, [low, high]) in before.intervals.iter().enumerate() {
            let [after_low, after_high] = found.summary(k).unwrap().interval_95;
            // Twenty thousand draws, one of four independent: a deviation is known to 1 %, the ends of an interval to less than 3 %.
            let ratio = (after_high / after_low).ln() / (high / low).ln();
            assert!((ratio - 1.0).abs() < 0.03, "{gain} {k}: {after_low} {after_high}, foretold {low} {high}");
        }
    }
}

/// Three places by what they tell, and three at even distances.
fn both() -> [Vec<f64>; 2] {
    let plan = planned(&(text_of(&uncertainty(), &places(), &[]) + SOUGHT));
    let told: f64 = plan.positions.iter().map(|one| one.information).sum();
    // Thirteen that add less than a thousandth each are not listed.
    assert!((told - plan.information).abs() < 0.02 && plan.not_listed[0] + plan.positions.len() == 13, "{plan:?}");
    assert!(plan.positions.windows(2).all(|pair| pair[1].information <= pair[0].information + 1e-9), "{plan:?}");
    let chosen = named(plan.positions.iter().take(3).map(|one| one.name.clone()));
    [chosen, vec![places()[3], places()[6], places()[9]]]
}

#[test]
fn places_that_tell_most_tell_more_than_places_at_even_distances() {
    let [chosen, even] = both().map(|fronts| planned(&(text_of(&uncertainty(), &fronts, &[]) + SOUGHT)).information);
    assert!(chosen > even, "{chosen} {even}");
}

/// The same by what fifty twins are found to be.
#[test]
#[ignore = "a hundred updates, minutes"]
fn places_that_tell_most_lead_nearer_to_the_truth() {
    let error = |fronts: &[f64]| {
        let mut squares = [0.0; 2];
        for seed in 200..250 {
            let twin = truth(&text_of("", fronts, &[]));
            let found = updated(&(text_of(&uncertainty(), fronts, &read_of(&twin, 1.0, seed)) + SOUGHT), &[]);
            let point = found.found().unwrap().point();
            for (square, (found, truth)) in squares.iter_mut().zip(point.iter().zip(TRUTH)) {
                *square += (found / truth).ln().powi(2) / 50.0;
            }
        }
        squares.map(f64::sqrt)
    };
    let [chosen, even] = both().map(|fronts| error(&fronts));
    // A root mean square of fifty is known to a tenth.
    assert!(chosen[0] < even[0] && chosen[1] < 1.1 * even[1], "{chosen:?} {even:?}");
}
