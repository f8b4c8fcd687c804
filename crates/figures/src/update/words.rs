//! Words of figures of an update: second lines of titles, values with their units, errors with their signs.

use crate::sheet::Style;
use crate::words::{named, raised, three_digits, with_unit};
use outcome::calibrate::Start;
use outcome::calibrate::misfit::Scaling;
use outcome::calibrate::search::hierarchical::Variant;
use outcome::update::{PaperSearch, Update};

/// The second line of a title, which says where records were computed and not measured.
pub(super) fn second_line(update: &Update, what: &str) -> String {
    let runs = &update.records.runs;
    let synthetic = runs.iter().filter(|run| run.synthetic.is_some()).count();
    match synthetic {
        0 => what.to_owned(),
        all if all == runs.len() => format!("{what}; the records are synthetic: computed, not measured"),
        some => format!("{what}; {some} of {} records are synthetic: computed, not measured", runs.len()),
    }
}

/// The paper's search in words: which reading of its rules, from where.
pub(super) fn search_words(update: &Update, paper: &PaperSearch) -> String {
    let start = match paper.start {
        Start::Stated => "the file's values",
        Start::Means => "the middle of all ranges",
        Start::LowerBounds => "all lower bounds",
        Start::UpperBounds => "all upper bounds",
    };
    let more = match update.paper.len() {
        0 | 1 => String::new(),
        all => format!("; of {all} such searches the one that ended best"),
    };
    let rules = match paper.variant {
        Variant::Printed => "as printed",
        Variant::AsPractised => "as practised",
    };
    format!("rules {rules}, started from {start}{more}")
}

/// A name with its unit in brackets, no wider than a limit; a long name is cut, the unit stays.
pub(super) fn fitting(name: &str, unit: &str, limit: f64) -> String {
    Style::default().shortened(name, limit, |name| named(name, unit)).unwrap_or_else(|| raised(unit))
}

/// A value with its unit, three digits.
pub(super) fn value_words(value: f64, unit: &str) -> String {
    with_unit(three_digits(value), unit)
}

/// What errors are multiplied by for print, and their unit there.
pub(super) fn errors_in(update: &Update) -> (f64, &'static str) {
    match update.problem.misfit().scaling {
        Scaling::MeasuredPeak => (100.0, "%"),
        Scaling::Uncertainty => (1.0, "standard deviations"),
    }
}

/// A number with its sign; what rounds to zero has none.
pub(super) fn signed(value: f64, digits: usize) -> String {
    let text = format!("{value:+.digits$}");
    match text.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) || !value.is_finite() {
        true => text.replace('-', "−"),
        false => text[1..].to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::signed;

    #[test]
    fn what_rounds_to_zero_has_no_sign() {
        assert_eq!([-0.04, 0.0, -0.0, 0.04].map(|value| signed(value, 1)), ["0.0"; 4].map(str::to_owned));
        assert_eq!([signed(-0.06, 1), signed(12.34, 1), signed(-3.0, 0)], ["−0.1", "+12.3", "−3"].map(str::to_owned));
    }
}
