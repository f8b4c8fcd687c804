//! The answer of a study in an engineer's words.

use findings::words::counted;
use outcome::study::{Design, Sensitivity, Study, Trend, sensitivity};
use std::fmt::Write;

/// Runs that ended otherwise, shown at most.
const MOST_SHOWN: usize = 8;

/// What was found, what matters most, where the rest is.
pub(crate) fn vary(study: &Study, out: &str) -> String {
    let (name, unit) = figures::name_and_unit(&study.outcome);
    let mut page = format!("{}: {name} by {}, {}\n\n", study.bridge, study.method.name(), design(study));
    let own = study.baseline().map(|row| (row, study.number(row)));
    if let Some((row, number)) = own {
        let shown =
            number.map_or("none".to_owned(), |number| format!("{}{}", figures::four_digits(number), behind(unit)));
        let _ = writeln!(page, "  {name} as the file has it: {shown} ({})", row.outcome.status);
    }
    match study.design {
        Design::OneAtATime => sensitivities(&mut page, study, unit),
        Design::Grid => grid(&mut page, study, unit),
    }
    others(&mut page, study);
    let own = study.baseline().and_then(|row| study.number(row));
    if study.resolution > 1e-6 * own.unwrap_or(0.0).abs() {
        let sharp = figures::four_digits(study.resolution);
        let _ = writeln!(page, "\n  changes up to {sharp}{} are steps of the search", behind(unit));
    }
    let _ = writeln!(page, "\nThe table and finished runs are in {out}");
    page
}

fn design(study: &Study) -> String {
    let (runs, cached) = (study.rows.len(), study.rows.iter().filter(|row| row.cached).count());
    let quantities = study.quantities.len();
    let how = match study.design {
        Design::OneAtATime if quantities == 1 => "one quantity".to_owned(),
        Design::OneAtATime => format!("{quantities} quantities one at a time"),
        Design::Grid => format!("a grid of {}", counted(quantities, "quantity")),
    };
    let kept = if cached > 0 { format!(", {cached} of them computed earlier") } else { String::new() };
    format!("{how}, {}{kept}", counted(runs, "run"))
}

/// The quantities, the one that moves the answer most first.
fn sensitivities(page: &mut String, study: &Study, unit: &str) {
    let mut all = sensitivity(study);
    all.sort_by(|a, b| b.swing_percent.unwrap_or(-1.0).total_cmp(&a.swing_percent.unwrap_or(-1.0)));
    let digits = figures::four_digits;
    let cells: Vec<[String; 5]> = all
        .iter()
        .map(|one| {
            let (low, high) = (one.low.as_ref(), one.high.as_ref());
            let at = |end: Option<&outcome::study::Extreme>| match end {
                Some(end) if one.trend == Trend::Flat => digits(end.outcome),
                Some(end) => format!("{} at {}", digits(end.outcome), end.value),
                None => "–".to_owned(),
            };
            let percent = |end: Option<&outcome::study::Extreme>| {
                end.and_then(|end| end.change_percent).map_or("–".to_owned(), |change| format!("{change:+.1} %"))
            };
            [
                study.quantities[one.quantity].path.to_string(),
                at(low),
                at(high),
                match one.trend {
                    Trend::Flat => "none".to_owned(),
                    Trend::Unknown if one.without_answer > 0 => {
                        format!("{} without answer", counted(one.without_answer, "run"))
                    }
                    _ => format!("{} … {}", percent(low), percent(high)),
                },
                words(one),
            ]
        })
        .collect();
    // A result such as a factor has no unit.
    let of_unit = |word: &str| if unit.is_empty() { word.to_owned() } else { format!("{word} [{unit}]") };
    let heads = ["quantity".into(), of_unit("smallest"), of_unit("largest"), "change".into(), "elasticity".into()];
    let width = |at: usize| cells.iter().chain([&heads]).map(|row| row[at].chars().count()).max().unwrap_or(0);
    let widths = [width(0), width(1), width(2), width(3)];
    page.push('\n');
    for row in [&heads].into_iter().chain(&cells) {
        let padded: Vec<String> = row
            .iter()
            .zip(widths)
            .map(|(cell, width)| format!("{cell}{}", " ".repeat(width - cell.chars().count())))
            .collect();
        let _ = writeln!(page, "  {}  {}", padded.join("  "), row[4]);
    }
}

fn words(one: &Sensitivity) -> String {
    // Half of the last digit shown takes the sign off what rounds to zero.
    let elasticity = one.elasticity.map(|number| if number.abs() < 0.005 { 0.0 } else { number });
    let elasticity = elasticity.map_or("–".to_owned(), |number| format!("{number:+.2}"));
    format!("{elasticity}, {}", one.trend.word().replace('-', " "))
}

/// A unit behind a number; a factor has none.
fn behind(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

/// Where a grid is lowest and highest.
fn grid(page: &mut String, study: &Study, unit: &str) {
    let answered = || study.rows.iter().skip(1).filter_map(|row| Some((row, study.number(row)?)));
    // The first of those that differ by no more than the solver's noise.
    let first = |sign: f64| {
        let best = answered().map(|(_, number)| sign * number).reduce(f64::max)?;
        answered().find(|(_, number)| sign * number >= best - 1e-6 * best.abs())
    };
    let (low, high) = (first(-1.0), first(1.0));
    for (word, end) in [("smallest", low), ("largest", high)] {
        let Some((row, number)) = end else { continue };
        let _ =
            writeln!(page, "  {word:<9} {}{} at {}", figures::four_digits(number), behind(unit), values(study, row));
    }
}

fn values(study: &Study, row: &outcome::study::Row) -> String {
    let value = |at: usize| {
        let text = study.setting(row, at).map_or("not given", |setting| setting.text.as_str());
        format!("{} = {text}", study.quantities[at].path)
    };
    let own = row.run.varied.is_none() && row.run.choice.iter().all(Option::is_none);
    match (row.run.varied, own) {
        (Some(quantity), _) => value(quantity),
        (None, true) => "the file's own values".to_owned(),
        (None, false) => (0..study.quantities.len()).map(value).collect::<Vec<_>>().join(", "),
    }
}

/// Runs that ended in another way than the file's own.
fn others(page: &mut String, study: &Study) {
    let Some(own) = study.baseline().map(|row| row.outcome.status.clone()) else { return };
    let differ: Vec<_> = study.rows.iter().filter(|row| row.outcome.status != own).collect();
    if differ.is_empty() {
        return;
    }
    let _ = writeln!(page, "\n  {} of {} ended otherwise than {own}:", differ.len(), counted(study.rows.len(), "run"));
    for row in differ.iter().take(MOST_SHOWN) {
        let why = row.outcome.message.as_ref().map_or(String::new(), |message| format!(" ({message})"));
        let _ = writeln!(page, "    {} at {}{why}", row.outcome.status, values(study, row));
    }
    if differ.len() > MOST_SHOWN {
        let _ = writeln!(page, "    … and {} more, see vary.csv", differ.len() - MOST_SHOWN);
    }
}
