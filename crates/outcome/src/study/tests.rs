//! Studies made up from formulas whose sensitivities are known.

use super::*;
use bridge::path::Path;

fn setting(number: f64) -> Setting {
    Setting { literal: format!("{number:?}"), text: format!("{number}"), number: Some(number) }
}

fn quantity(path: &str, own: f64, values: &[f64]) -> Varied {
    let values = values.iter().copied().map(setting).collect();
    Varied { path: Path::parse(path).unwrap(), unit: String::new(), own: Some(setting(own)), values }
}

/// A study whose answer is a formula of two quantities; it has none where the formula is not finite.
fn study(first: Varied, second: Varied, design: Design, answer: fn(f64, f64) -> f64) -> Study {
    let mut study = Study {
        bridge: "formula".into(),
        command: Command::Collapse,
        analysis: bridge::Analysis::Load,
        method: bridge::Method::Limit,
        design,
        outcome: "y".into(),
        resolution: 0.0,
        quantities: vec![first, second],
        rows: Vec::new(),
    };
    let counts: Vec<usize> = study.quantities.iter().map(|varied| varied.values.len()).collect();
    for run in runs(design, &counts) {
        let mut row = Row { run, outcome: Outcome::default(), seconds: 0.0, cached: false };
        let number = |at: usize| study.setting(&row, at).and_then(|setting| setting.number).unwrap();
        let found = answer(number(0), number(1));
        if found.is_finite() {
            row.outcome.numbers.push(("y".into(), found));
        }
        study.rows.push(row);
    }
    study
}

#[test]
fn a_power_law_has_its_exponent_as_elasticity() {
    let study =
        study(quantity("a.b", 2.0, &[1.0, 3.0, 4.0]), quantity("c.d", 5.0, &[6.0]), Design::OneAtATime, |a, c| {
            7.0 * a.powf(1.5) / (c * c)
        });
    let found = sensitivity(&study);
    // Secants of a straight line in the log-log plot; a few roundings.
    assert!((found[0].elasticity.unwrap() - 1.5).abs() < 1e-12);
    assert!((found[1].elasticity.unwrap() + 2.0).abs() < 1e-12);
    assert_eq!([found[0].trend, found[1].trend], [Trend::Rising, Trend::Falling]);
    let (low, high) = (found[0].low.clone().unwrap(), found[0].high.clone().unwrap());
    assert_eq!((low.value.as_str(), high.value.as_str()), ("1", "4"));
    assert!((high.change_percent.unwrap() - 100.0 * (2_f64.powf(1.5) - 1.0)).abs() < 1e-9);
    assert!((found[0].swing_percent.unwrap() - 100.0 * (2_f64.powf(1.5) - 0.5_f64.powf(1.5))).abs() < 1e-9);
}

#[test]
fn what_goes_up_and_down_is_not_monotone_and_what_stays_is_flat() {
    let study = study(
        quantity("a.b", 0.0, &[-1.0, 1.0, 2.0]),
        quantity("c.d", 5.0, &[4.0, 6.0]),
        Design::OneAtATime,
        |a, _| 3.0 - a * a,
    );
    let found = sensitivity(&study);
    assert_eq!([found[0].trend, found[1].trend], [Trend::NotMonotone, Trend::Flat]);
    assert_eq!(found[0].high.as_ref().map(|high| high.value.as_str()), Some("0"), "the file's own value counts");
    assert_eq!(found[0].elasticity, None, "zero has no logarithm");
    assert_eq!(found[1].elasticity, Some(0.0));
}

#[test]
fn what_the_search_cannot_tell_is_flat() {
    let stairs = |a: f64, _: f64| 10.0 + (a / 4.0).floor();
    let values = [0.5, 3.0, 5.0, 9.0];
    let mut study = study(quantity("a.b", 1.0, &values), quantity("c.d", 1.0, &[2.0]), Design::OneAtATime, stairs);
    assert_eq!(sensitivity(&study)[0].trend, Trend::Rising);
    study.resolution = 1.0;
    assert_eq!(sensitivity(&study)[0].trend, Trend::Rising, "two steps are more than one");
    study.rows.retain(|row| row.run.choice[0] != Some(3));
    assert_eq!(sensitivity(&study)[0].trend, Trend::Flat);
}

#[test]
fn runs_without_answer_are_counted_and_left_out() {
    let study =
        study(quantity("a.b", 2.0, &[1.0, -1.0, 3.0]), quantity("c.d", 5.0, &[5.0]), Design::OneAtATime, |a, _| a.ln());
    let found = sensitivity(&study);
    assert_eq!([found[0].without_answer, found[1].without_answer], [1, 0]);
    assert_eq!(found[1].trend, Trend::Unknown, "the file's own value once more is no range");
    let falls = |a: f64, _: f64| if a < 0.0 { f64::NAN } else { 7.0 };
    let study =
        self::study(quantity("a.b", 2.0, &[1.0, -1.0, 3.0]), quantity("c.d", 5.0, &[4.0]), Design::OneAtATime, falls);
    let found = sensitivity(&study);
    assert_eq!([found[0].trend, found[1].trend], [Trend::Unknown, Trend::Flat], "a run that falls did not stay");
}

#[test]
fn a_grid_has_no_quantity_that_varies_alone() {
    let grid =
        study(quantity("a.b", 1.0, &[1.0, 2.0]), quantity("c.d", 1.0, &[1.0, 2.0]), Design::Grid, |a, c| a + 10.0 * c);
    assert_eq!(sensitivity(&grid), []);
    let answers: Vec<f64> = grid.rows.iter().filter_map(|row| grid.number(row)).collect();
    assert_eq!(answers, [11.0, 11.0, 21.0, 12.0, 22.0]);
}
