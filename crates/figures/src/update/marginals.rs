//! What the data leave open of each parameter: its posterior over its range, beside what was believed before.

use super::{UPDATED, axis, fitting, second_line, value_words};
use crate::chart::{Axes, Axis, Entry, Mark, Words, key};
use crate::elevation::INK;
use crate::sheet::{Area, GREY_TEXT, HAIR, MARGIN, Pen, SMALL, Sheet, Spot, Style, WIDTH, font, font::Weight};
use crate::ticks::Ticks;
use crate::words::{four_digits, three_digits};
use outcome::calibrate::Parameter;
use outcome::calibrate::posterior::{Marginal, Posterior, Prior, Status};
use outcome::update::Update;

const HEIGHT: f64 = 96.0;
const BETWEEN: f64 = 86.0;
const GAP: f64 = 34.0;
/// Bars over a range.
pub const BARS: usize = 40;
const BAR: &str = "#9dc3e6";
const WITHIN: &str = "#dcdcdc";
const PRIOR: &str = "#777777";

/// Two panels in a row. None without samples.
pub fn marginals(update: &Update) -> Option<String> {
    let report = update.posterior.as_ref()?;
    let posterior = &report.posterior;
    if posterior.samples.is_empty() || posterior.parameters.is_empty() {
        return None;
    }
    let mut sheet = Sheet::new("posterior");
    let what = "What the records leave open: the posterior of each parameter over its range";
    let top = sheet.title(&update.bridge, &second_line(update, what));
    let wide = 0.5 * (WIDTH - 2.0 * MARGIN - 8.0 - GAP);
    let found = update.found().map(|found| found.point());
    for (k, marginal) in posterior.parameters.iter().enumerate() {
        let left = MARGIN + 4.0 + (k % 2) as f64 * (wide + GAP);
        let upper = top + 34.0 + (k / 2) as f64 * (HEIGHT + BETWEEN);
        let frame = Area { left, right: left + wide, top: upper, bottom: upper + HEIGHT };
        let parameter = update.problem.parameters().get(k)?;
        let answer = found.as_ref().and_then(|point| point.get(k)).copied();
        panel(&mut sheet, parameter, marginal, &bars(posterior, parameter, k), answer, frame);
    }
    let rows = posterior.parameters.len().div_ceil(2) as f64;
    let below = top + 34.0 + rows * (HEIGHT + BETWEEN) - BETWEEN + 50.0;
    let entries = [
        Entry { line: Some((BAR, "")), mark: None, text: "posterior" },
        Entry { line: Some((PRIOR, "5 3")), mark: None, text: "prior" },
        Entry { line: Some((WITHIN, "")), mark: None, text: "95 % interval" },
        Entry { line: None, mark: Some((Mark::Hollow, INK)), text: "mean" },
        Entry { line: Some((UPDATED, "")), mark: None, text: "where the search ended" },
    ];
    let bottom = key(&mut sheet, below, &entries[..if found.is_some() { 5 } else { 4 }]);
    Some(sheet_end(sheet, bottom, posterior, &report.surrogate))
}

fn sheet_end(mut sheet: Sheet, bottom: f64, posterior: &Posterior, surrogate: &str) -> String {
    let mut words = format!(
        "{} effective samples, R-hat {}.",
        four_digits(posterior.effective_samples.round()),
        four_digits((1e3 * posterior.r_hat).round() / 1e3)
    );
    if posterior.status != Status::Completed {
        words += " The sampling was not brought to its end: these shapes are rough.";
    }
    if let Some(error) = &posterior.model_error {
        let [low, high] = error.interval_95.map(|share| three_digits(100.0 * share));
        words += &format!(" Error of the model itself: {low} to {high} % of the peaks (95 %).");
    }
    if !surrogate.is_empty() {
        let mut letters = surrogate.chars();
        let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
        words += &format!(" {first}{}.", letters.as_str().trim_end_matches('.'));
    }
    let bottom = sheet.caption(bottom, &words);
    sheet.finish(bottom)
}

/// Shares of the samples by even parts of the range.
pub fn bars(posterior: &Posterior, parameter: &Parameter, k: usize) -> Vec<f64> {
    let mut bars = vec![0.0; BARS];
    let values = posterior.samples.iter().filter_map(|sample| sample.get(k)).filter(|value| value.is_finite());
    for value in values {
        bars[((parameter.share(*value) * BARS as f64) as usize).min(BARS - 1)] += 1.0;
    }
    let all: f64 = bars.iter().sum();
    bars.iter().map(|count| count / all.max(1.0)).collect()
}

fn panel(
    sheet: &mut Sheet,
    parameter: &Parameter,
    marginal: &Marginal,
    bars: &[f64],
    answer: Option<f64>,
    frame: Area,
) {
    let bold = Style { weight: Weight::Bold, ..Style::default() };
    let alarm = if marginal.identifiable { "" } else { "hardly determined by the records" };
    let room = frame.right - frame.left - 14.0 - font::width(alarm, SMALL, Weight::Regular);
    let lines = font::wrap(&marginal.name, bold.size, bold.weight, room);
    let name = match &lines[..] {
        [] => String::new(),
        [one] => one.clone(),
        [first, ..] => format!("{first} …"),
    };
    sheet.text([frame.left, frame.top - 21.0], &name, bold);
    let at = frame.left + font::width(&name, bold.size, bold.weight) + 12.0;
    if !alarm.is_empty() {
        let red = Style { size: SMALL, colour: "#a02020", ..Style::default() };
        sheet.text([at, frame.top - 21.0], alarm, red);
    }
    let summary = &marginal.summary;
    let [from, to] = summary.interval_95;
    let text = format!(
        "{} ± {}, 95 % between {} and {}",
        three_digits(summary.mean),
        value_words(summary.standard_deviation, &parameter.unit),
        three_digits(from),
        value_words(to, &parameter.unit)
    );
    sheet.text([frame.left, frame.top - 6.0], &text, Style { size: SMALL, colour: GREY_TEXT, ..Style::default() });
    let name = fitting(&parameter.name, &parameter.unit, frame.right - frame.left);
    let x = axis(parameter, &name, [parameter.lower, parameter.upper], 7);
    let prior = prior(parameter, bars.len());
    let most = bars.iter().chain(&prior).copied().fold(1e-9, f64::max);
    let up = Axis {
        name: "",
        range: [0.0, 1.15 * most],
        ticks: Ticks { values: Vec::new(), decimals: 0 },
        logarithmic: false,
    };
    let axes = Axes::within(sheet, frame, &x, &up, Words { x: true, y: false, y_name: None });
    let across = |value: f64| axes.spot(value, 0.0)[0];
    let within = Area { left: across(from), right: across(to), ..frame };
    sheet.rectangle(within, Pen::shape(WITHIN, "none", 0.0).class("interval"));
    for (bar, height) in bars.iter().enumerate().filter(|(_, height)| **height > 0.0) {
        let edge = |k: usize| across(parameter.at(k as f64 / bars.len() as f64));
        let top = axes.spot(parameter.lower, *height)[1];
        let area = Area { left: edge(bar), right: edge(bar + 1), top, bottom: frame.bottom };
        sheet.rectangle(area, Pen::shape(BAR, "#5f8fbf", HAIR).class("bar"));
    }
    let middle = |k: usize| parameter.at((k as f64 + 0.5) / prior.len() as f64);
    let mut spots: Vec<Spot> = prior.iter().enumerate().map(|(k, height)| axes.spot(middle(k), *height)).collect();
    if let [first, .., last] = &mut spots[..] {
        (first[0], last[0]) = (frame.left, frame.right);
    }
    sheet.polyline(&spots, Pen::line(PRIOR, 1.2).dashed("5 3").class("prior"));
    sheet.rectangle(frame, Pen::line(INK, 0.9));
    if let Some(answer) = answer {
        sheet.line(
            [across(answer), frame.top],
            [across(answer), frame.bottom],
            Pen::line(UPDATED, 2.6).class("answer"),
        );
    }
    Mark::Hollow.draw(sheet, [across(summary.mean), frame.bottom], INK);
}

/// What was believed before, as bars like those of the samples.
fn prior(parameter: &Parameter, bars: usize) -> Vec<f64> {
    let density = |k: usize| {
        let share = (k as f64 + 0.5) / bars as f64;
        let value = parameter.at(share);
        let normal = |x: f64, mean: f64, deviation: f64| (-0.5 * ((x - mean) / deviation).powi(2)).exp();
        match parameter.prior {
            Prior::Uniform => 1.0,
            Prior::Normal { mean, standard_deviation } => {
                normal(value, mean, standard_deviation) * parameter.slope(share)
            }
            Prior::LogNormal { mean, standard_deviation } => {
                normal(value.ln(), mean, standard_deviation) / value * parameter.slope(share)
            }
        }
    };
    let densities: Vec<f64> = (0..bars).map(density).map(|d| if d.is_finite() { d } else { 0.0 }).collect();
    let all: f64 = densities.iter().sum();
    densities.iter().map(|density| density / all.max(f64::MIN_POSITIVE)).collect()
}
