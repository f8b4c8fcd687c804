//! Figures of model updating, from `Update` alone: histories over one another, sensitivity curves, surfaces of two
//! parameters, what the data leave open, and residuals by channel.

mod bands;
mod correlation;
mod histories;
mod marginals;
mod residuals;
mod sensitivity;
mod surface;

use crate::all::{File, written};
use crate::chart::Axis;
use crate::raster::RasterError;
use crate::sheet::Style;
use crate::words::{named, raised, three_digits, with_unit};
use outcome::calibrate::Start;
use outcome::calibrate::misfit::Scaling;
use outcome::calibrate::search::hierarchical::Variant;
use outcome::calibrate::{Parameter, Scale};
use outcome::update::{PaperSearch, Update};

const MEASURED: &str = "#222222";
/// Of the start model.
const START: &str = "#d07a00";
/// Of the updated model.
const UPDATED: &str = "#0b5394";

/// Kinds of figures of an update: how their names begin, and what stands under them.
pub const UPDATE_FIGURES: [(&str, &str); 6] = [
    ("histories", "Histories as measured, before and after the update."),
    ("residuals", "What is left between records and model, channel by channel."),
    ("sensitivity", "Misfit over each parameter alone."),
    ("surface", "Misfit over two parameters, with the path of the search."),
    ("posterior", "What the records leave open of each parameter."),
    ("correlation", "Correlation of the parameters."),
];

/// Every figure of an update that there is material for.
pub fn update(update: &Update) -> Result<Vec<File>, RasterError> {
    written(update_drawings(update))
}

/// The same as SVG: name without extension, and drawing.
pub fn update_drawings(update: &Update) -> Vec<(String, String)> {
    let mut drawings: Vec<(String, String)> = Vec::new();
    let mut put = |name: String, svg: Option<String>| drawings.extend(svg.map(|svg| (name, svg)));
    put("histories".into(), histories::histories(update));
    put("residuals".into(), residuals::residuals(update));
    if let Some(paper) = shown(update) {
        for (number, pass) in paper.outcome.passes.iter().enumerate() {
            put(format!("sensitivity-{}", number + 1), sensitivity::sensitivity(update, paper, number));
            for stage in 0..pass.stages.len() {
                put(format!("surface-{}-{}", number + 1, stage + 1), surface::surface(update, paper, number, stage));
            }
        }
    }
    put("posterior".into(), marginals::marginals(update));
    put("correlation".into(), correlation::correlation(update));
    drawings
}

/// Of several searches after the paper, by reading and start, the one that ended best; the first of equals.
fn shown(update: &Update) -> Option<&PaperSearch> {
    let norm = |paper: &PaperSearch| paper.outcome.found.as_ref().map_or(f64::INFINITY, |found| found.norm);
    update.paper.iter().reduce(|best, next| if norm(next) < norm(best) { next } else { best })
}

/// The second line of a title, which says where records were computed and not measured.
fn second_line(update: &Update, what: &str) -> String {
    let runs = &update.records.runs;
    let synthetic = runs.iter().filter(|run| run.synthetic.is_some()).count();
    match synthetic {
        0 => what.to_owned(),
        all if all == runs.len() => format!("{what}; the records are synthetic: computed, not measured"),
        some => format!("{what}; {some} of {} records are synthetic: computed, not measured", runs.len()),
    }
}

/// The paper's search in words: which reading of its rules, from where.
fn search_words(update: &Update, paper: &PaperSearch) -> String {
    let start = match &paper.start {
        Start::Stated => "the file's values",
        Start::Means => "the middle of all ranges",
        Start::LowerBounds => "all lower bounds",
        Start::UpperBounds => "all upper bounds",
        Start::Values(_) => "values of its own",
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
fn fitting(name: &str, unit: &str, limit: f64) -> String {
    let fits = |text: &String| Style::default().width(text) <= limit;
    let cut = |length: usize| format!("{}…", name.chars().take(length).collect::<String>().trim_end());
    let shorter = (1..=name.chars().count()).rev().map(|length| named(&cut(length), unit));
    std::iter::once(named(name, unit)).chain(shorter).find(fits).unwrap_or_else(|| raised(unit))
}

/// A value with its unit, three digits.
fn value_words(value: f64, unit: &str) -> String {
    with_unit(three_digits(value), unit)
}

/// The axis of a parameter from one value to another, divided as its range is.
fn axis<'a>(parameter: &Parameter, name: &'a str, [low, high]: [f64; 2], count: usize) -> Axis<'a> {
    match parameter.scale {
        Scale::Linear => Axis::exact(name, low, high, count),
        Scale::Logarithmic => Axis::logarithmic(name, low, high),
    }
}

/// What errors are multiplied by for print, and their unit there.
fn errors_in(update: &Update) -> (f64, &'static str) {
    match update.problem.misfit().scaling {
        Scaling::MeasuredPeak => (100.0, "%"),
        Scaling::Uncertainty => (1.0, "standard deviations"),
    }
}

/// An error in per cent with its sign.
fn percent(error: f64) -> String {
    format!("{} %", signed(100.0 * error, 1))
}

/// A number with its sign; what rounds to zero has none.
fn signed(value: f64, digits: usize) -> String {
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
