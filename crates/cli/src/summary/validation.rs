//! Predictions over tests, in words.

use ::outcome::validation::{Bias, Prediction, Tested, Validation};
use findings::words::counted;
use std::fmt::Write;

/// The table of all predictions, what each method comes to, and which tests it predicts too high.
pub(crate) fn validation(found: &Validation, out: &str) -> String {
    let mut page =
        format!("{} loaded to collapse; loads in kN on the whole width\n\n", counted(found.tests.len(), "bridge"));
    let name = found.tests.iter().map(|test| test.name.len()).chain([6]).max().unwrap_or(6);
    let _ = writeln!(
        page,
        "  {:name$}  {:>6}  {:10} {:>9}  {:>9}  {:16}  {:16}  {:>7}",
        "bridge", "test", "method", "predicted", "over test", "priors vary", "and dimensions", "time"
    );
    for test in &found.tests {
        for (line, one) in test.predictions.iter().enumerate() {
            let (bridge, load) = match line {
                0 => (test.name.as_str(), format!("{:.0}", test.carried / 1e3)),
                _ => ("", String::new()),
            };
            let row = format!("  {bridge:name$}  {load:>6}  {:10} {}", one.by.word(), predicted(test, one));
            let _ = writeln!(page, "{}", row.trim_end());
        }
    }
    beside(&mut page, found);
    statistics(&mut page, found);
    page += "\nThe careful side:\n";
    for one in &found.statistics {
        let _ = writeln!(page, "  {}", careful(one));
    }
    let _ = writeln!(page, "\nResults are in {out}");
    page
}

/// A prediction, its place beside the test, its intervals over the test, its time.
fn predicted(test: &Tested, one: &Prediction) -> String {
    let (load, over) = match one.load {
        Some(load) => (format!("{:.0}", load / 1e3), format!("{:.2}", test.over(load))),
        None => ("none".to_owned(), "-".to_owned()),
    };
    let interval = |ends: Option<[f64; 2]>| {
        ends.map_or("-".to_owned(), |ends| {
            let [low, high] = ends.map(|load| test.over(load));
            format!("{low:.2} to {high:.2}")
        })
    };
    let end = if one.load.is_none() { format!("  {}", one.ended) } else { String::new() };
    let (priors, dimensions) = (interval(one.by_priors), interval(one.by_dimensions));
    format!("{load:>9}  {over:>9}  {priors:16}  {dimensions:16}  {:>5.1} s{end}", one.seconds)
}

/// What else runs gave: other strengths of a continuum, ends without a number, doubts about tests.
fn beside(page: &mut String, found: &Validation) {
    let mut lines = Vec::new();
    for test in &found.tests {
        for one in &test.predictions {
            if let (Some(half), Some(dilating), Some(upper)) = (one.half_strength, one.dilating, one.upper_bound) {
                let [half, dilating, upper] = [half, dilating, upper].map(|load| test.over(load));
                lines.push(format!(
                    "{}, {}: upper bound {upper:.2}; {half:.2} with half of the strength, {dilating:.2} with dilation",
                    test.name, one.by
                ));
            }
            if let Some([least, most]) = one.by_packings.map(|ends| ends.map(|load| test.over(load))) {
                lines.push(format!("{}, {}: {least:.2} to {most:.2} by the packing", test.name, one.by));
            }
            for end in &one.without {
                lines.push(format!("{}, {}, no number with {end}", test.name, one.by));
            }
        }
    }
    for test in &found.tests {
        if !test.recalled.is_empty() {
            lines.push(format!("{}: not read, remembered or assumed: {}", test.name, test.recalled.join(", ")));
        }
        if test.carried_mark == "memory" {
            lines.push(format!("{}: the load of the test is from memory too", test.name));
        }
        if let Some(doubt) = &test.doubt {
            lines.push(format!("{}: {doubt}", test.name));
        }
    }
    if !lines.is_empty() {
        *page += "\nBeside these:\n";
        for line in lines {
            let _ = writeln!(page, "  {line}");
        }
    }
}

fn statistics(page: &mut String, found: &Validation) {
    *page += "\nPrediction over test, and each test corrected by the median of the others (leave one out):\n";
    let _ = writeln!(
        page,
        "  {:10} {:>5}  {:>6}  {:>7}  {:>19}  {:>19}  {:>13}",
        "method", "tests", "median", "scatter", "median of others", "corrected", "their scatter"
    );
    for one in &found.statistics {
        let number = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.2}"));
        let span = |values: Vec<f64>| {
            let (low, high) = (values.iter().copied().reduce(f64::min), values.iter().copied().reduce(f64::max));
            low.zip(high).map_or("-".to_owned(), |(low, high)| format!("{low:.2} to {high:.2}"))
        };
        let biases = span(one.left_out.iter().map(|left| left.bias).collect());
        let corrected = span(one.left_out.iter().map(|left| left.corrected).collect());
        let _ = writeln!(
            page,
            "  {:10} {:>5}  {:>6}  {:>7}  {biases:>19}  {corrected:>19}  {:>13}",
            one.by.word(),
            one.tests,
            number(one.median),
            number(one.scatter),
            number(one.left_out_scatter)
        );
    }
}

/// Which tests a method predicts too high.
fn careful(of: &Bias) -> String {
    let (by, tests) = (of.by, of.tests);
    match of.too_high.as_slice() {
        _ if tests == 0 => format!("{by} gives no number"),
        [] => format!("{by} predicts no more than the test carried, for any of {tests}"),
        high => {
            let named: Vec<String> = high.iter().map(|(name, over)| format!("{name} ({over:.2})")).collect();
            format!("{by} predicts more than the test carried for {} of {tests}: {}", high.len(), named.join(", "))
        }
    }
}
