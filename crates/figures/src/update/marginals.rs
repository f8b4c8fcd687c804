//! What the data leave open of each parameter: its posterior over its range, beside what was believed before.

use super::style::{UPDATED, axis};
use super::words::{fitting, second_line, value_words};
use crate::chart::{Axis, Entry, Mark, NAME, Panel, PanelPoint, key};
use crate::elevation::INK;
use crate::sheet::{Area, HAIR, MARGIN, Pen, Sheet, Style, WIDTH};
use crate::words::{four_digits, three_digits};
use outcome::calibrate::Parameter;
use outcome::calibrate::posterior::{Marginal, Posterior, Prior, Status};
use outcome::update::Update;

const HEIGHT: f64 = 96.0;
const BETWEEN: f64 = 86.0;
const GAP: f64 = 34.0;
/// Bars over a range.
pub(super) const BARS: usize = 40;
const BAR: &str = "#9dc3e6";
const WITHIN: &str = "#dcdcdc";
const PRIOR: &str = "#777777";

/// Two panels in a row. None without samples.
pub(super) fn marginals(update: &Update) -> Option<String> {
    let report = update.posterior.as_ref()?;
    let posterior = &report.posterior;
    if posterior.samples.is_empty() || posterior.parameters.is_empty() {
        return None;
    }
    let what = "What the records leave open: the posterior of each parameter over its range";
    let (mut sheet, top) = Sheet::titled("posterior", &update.bridge, &second_line(update, what));
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
        Entry::line((BAR, ""), "posterior"),
        Entry::line((PRIOR, "5 3"), "prior"),
        Entry::line((WITHIN, ""), "95 % interval"),
        Entry::mark(Mark::Hollow, INK, "mean"),
        Entry::line((UPDATED, ""), "where the search ended").when(found.is_some()),
    ];
    let bottom = key(&mut sheet, below, &entries);
    Some(sheet.end(bottom, &told(posterior, &report.surrogate)))
}

/// What stands below the panels.
fn told(posterior: &Posterior, surrogate: &str) -> String {
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
    words
}

/// Shares of the samples by even parts of the range.
pub(super) fn bars(posterior: &Posterior, parameter: &Parameter, k: usize) -> Vec<f64> {
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
    let bold = Style::bold();
    let alarm = if marginal.identifiable { "" } else { "hardly determined by the records" };
    let room = frame.right - frame.left - 14.0 - Style::small().width(alarm);
    let lines = bold.wrap(&marginal.name, room);
    let name = match &lines[..] {
        [] => String::new(),
        [one] => one.clone(),
        [first, ..] => format!("{first} …"),
    };
    sheet.text([frame.left, frame.top - 21.0], &name, bold);
    let at = frame.left + bold.width(&name) + 12.0;
    if !alarm.is_empty() {
        sheet.text([at, frame.top - 21.0], alarm, Style { colour: "#a02020", ..Style::small() });
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
    sheet.text([frame.left, frame.top - 6.0], &text, Style::grey());
    let name = fitting(&parameter.name, &parameter.unit, frame.right - frame.left);
    let x = axis(parameter, &name, [parameter.lower, parameter.upper], 7);
    let prior = prior(parameter, bars.len());
    let most = bars.iter().chain(&prior).copied().fold(1e-9, f64::max);
    let mut panel = Panel::new(x, Axis::blank(0.0, 1.15 * most));
    panel.bar([from, 0.0], [to, panel.y.range[1]], Pen::shape(WITHIN, "none", 0.0).class("interval"));
    let edge = |bar: usize| parameter.at(bar as f64 / bars.len() as f64);
    for (bar, height) in bars.iter().enumerate().filter(|(_, height)| **height > 0.0) {
        panel.bar([edge(bar), 0.0], [edge(bar + 1), *height], Pen::shape(BAR, "#5f8fbf", HAIR).class("bar"));
    }
    let middle = |k: usize| parameter.at((k as f64 + 0.5) / prior.len() as f64);
    let mut places: Vec<PanelPoint> = prior.iter().enumerate().map(|(k, height)| [middle(k), *height]).collect();
    if let [first, .., last] = &mut places[..] {
        [first[0], last[0]] = panel.x.range;
    }
    panel.line(places, Pen::line(PRIOR, 1.2).dashed("5 3").class("prior"));
    panel.add(|sheet, axes| sheet.rectangle(axes.area, Pen::line(INK, 0.9)));
    if let Some(answer) = answer {
        panel.upright(answer, Pen::line(UPDATED, 2.6).class("answer"));
    }
    panel.mark([summary.mean, 0.0], Mark::Hollow, INK);
    panel.within(sheet, frame, Some(NAME), None);
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
