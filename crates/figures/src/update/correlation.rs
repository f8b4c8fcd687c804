//! How parameters go together in the posterior: samples of each pair below the diagonal, correlation above it.

use super::marginals::bars;
use super::words::second_line;
use crate::colour::either_way;
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, SMALL, Sheet, Spot, Style, WIDTH};
use crate::words::{four_digits, raised};
use outcome::calibrate::Parameter;
use outcome::calibrate::posterior::Posterior;
use outcome::update::Update;

/// More parameters than these have correlations alone: clouds would be smaller than words.
const MOST_CLOUDS: usize = 7;
/// Samples that are drawn of each pair: more make a blot.
const DOTS: usize = 1200;
const DOT: &str = "#1f5fa8";
const BAR: &str = "#9dc3e6";

/// A square of cells, a row and a column for each parameter. None of fewer than two parameters or without samples.
pub(super) fn correlation(update: &Update) -> Option<String> {
    let posterior = &update.posterior.as_ref()?.posterior;
    let parameters = update.problem.parameters();
    let n = parameters.len();
    if n < 2 || posterior.samples.is_empty() || posterior.correlation.len() != n {
        return None;
    }
    let what = "How the parameters go together in the posterior";
    let (mut sheet, top) = Sheet::titled("correlation", &update.bridge, &second_line(update, what));
    let clouds = n <= MOST_CLOUDS;
    let names = parameters.iter().flat_map(|parameter| lines(parameter, WIDEST_NAME, 3));
    let left = MARGIN + names.map(|line| Style::small().width(&line)).fold(40.0, f64::max) + 8.0;
    let side = ((WIDTH - MARGIN - left) / n as f64).min(150.0);
    let cell = |row: usize, column: usize| {
        let (x, y) = (left + side * column as f64, top + 6.0 + side * row as f64);
        Area { left: x, right: x + side, top: y, bottom: y + side }
    };
    for row in 0..n {
        for column in 0..n {
            let area = cell(row, column);
            if row == column {
                marginal(&mut sheet, &bars(posterior, &parameters[row], row), area);
            } else if row > column && clouds {
                cloud(&mut sheet, posterior, [&parameters[column], &parameters[row]], [column, row], area);
            } else {
                number(&mut sheet, posterior.correlation[row][column], area);
            }
            sheet.rectangle(area, Pen::line(INK, 0.7));
        }
        let first = cell(row, 0);
        let lines = lines(&parameters[row], WIDEST_NAME, 3);
        let at = [left - 8.0, 0.5 * (first.top + first.bottom)];
        sheet.lines(at, &lines, 1.3 * SMALL, Style::small().anchored(Anchor::End));
    }
    let below = values(&mut sheet, parameters, |column| cell(n - 1, column));
    let mut words = "On the diagonal each parameter over its range; above it the correlation coefficient, red where two rise together, blue \
                     where one rises as the other falls."
        .to_owned();
    if clouds {
        let drawn = posterior.samples.len().div_ceil(every(posterior));
        words += &format!(" Below it {drawn} samples of each pair, both over their ranges.");
    }
    Some(sheet.end(below, &words))
}

const WIDEST_NAME: f64 = 118.0;

/// Name of a parameter, of so many lines at most, and its unit.
fn lines(parameter: &Parameter, limit: f64, most: usize) -> Vec<String> {
    let mut lines = Style::small().wrap(&parameter.name, limit);
    lines.truncate(most);
    if !parameter.unit.is_empty() {
        lines.push(format!("[{}]", raised(&parameter.unit)));
    }
    lines
}

/// Names and ends of the ranges below the last row; returns the y below.
fn values(sheet: &mut Sheet, parameters: &[Parameter], cell: impl Fn(usize) -> Area) -> f64 {
    let small = Style::small();
    let mut below: f64 = 0.0;
    for (column, parameter) in parameters.iter().enumerate() {
        let area = cell(column);
        let ends = [parameter.lower, parameter.upper].map(four_digits);
        sheet.text([area.left + 3.0, area.bottom + 15.0], &ends[0], small);
        sheet.text([area.right - 3.0, area.bottom + 15.0], &ends[1], small.anchored(Anchor::End));
        let mut y = area.bottom + 20.0;
        for line in lines(parameter, area.right - area.left - 6.0, usize::MAX) {
            y += 1.3 * SMALL;
            sheet.text([0.5 * (area.left + area.right), y], &line, small.anchored(Anchor::Middle));
        }
        below = below.max(y);
    }
    below + 8.0
}

fn marginal(sheet: &mut Sheet, bars: &[f64], area: Area) {
    let most = bars.iter().copied().fold(1e-9, f64::max);
    let wide = (area.right - area.left) / bars.len() as f64;
    for (k, height) in bars.iter().enumerate().filter(|(_, height)| **height > 0.0) {
        let left = area.left + wide * k as f64;
        let top = area.bottom - 0.9 * (area.bottom - area.top) * height / most;
        sheet.rectangle(Area { left, right: left + wide, top, bottom: area.bottom }, Pen::shape(BAR, BAR, HAIR));
    }
}

/// One sample of so many is drawn.
fn every(posterior: &Posterior) -> usize {
    posterior.samples.len().div_ceil(DOTS).max(1)
}

fn cloud(sheet: &mut Sheet, posterior: &Posterior, pair: [&Parameter; 2], places: [usize; 2], area: Area) {
    let spots: Vec<Spot> = posterior
        .samples
        .iter()
        .step_by(every(posterior))
        .filter_map(|sample| {
            let share = |side: usize| Some(pair[side].share(*sample.get(places[side])?));
            let (x, y) = (share(0)?, share(1)?);
            Some([area.left + x * (area.right - area.left), area.bottom - y * (area.bottom - area.top)])
        })
        .collect();
    sheet.open_clipped("cloud", &format!("cloud-{}-{}", places[0], places[1]), area);
    sheet.dots(&spots, 0.8, DOT);
    sheet.close();
}

fn number(sheet: &mut Sheet, correlation: f64, area: Area) {
    let colour = either_way(correlation);
    sheet.rectangle(area, Pen::shape(&colour, "none", 0.0).class("correlation"));
    let text = format!("{correlation:+.2}").replace('-', "−");
    let letters = if correlation.abs() > 0.75 { "#ffffff" } else { "#111111" };
    let style = Style { colour: letters, ..Style::default() }.anchored(Anchor::Middle);
    sheet.lines([0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom)], &[text], 0.0, style);
}
