//! How parameters go together in the posterior: samples of each pair below the diagonal, correlation above it.

use super::marginals::bars;
use super::{pretty, second_line};
use crate::colour::either_way;
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, SMALL, Sheet, Spot, Style, WIDTH, font};
use crate::words::four_digits;
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
pub fn correlation(update: &Update) -> Option<String> {
    let posterior = &update.posterior.as_ref()?.posterior;
    let parameters = update.problem.parameters();
    let n = parameters.len();
    if n < 2 || posterior.samples.is_empty() || posterior.correlation.len() != n {
        return None;
    }
    let mut sheet = Sheet::new("correlation");
    let what = "How the parameters go together in the posterior";
    let top = sheet.title(&update.bridge, &second_line(update, what));
    let clouds = n <= MOST_CLOUDS;
    let left = MARGIN + names_width(parameters) + 8.0;
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
        name(&mut sheet, &parameters[row], cell(row, 0), left);
    }
    let below = values(&mut sheet, parameters, |column| cell(n - 1, column));
    let mut words = "On the diagonal each parameter over its range; above it the correlation coefficient, red where two rise together, blue \
                     where one rises as the other falls."
        .to_owned();
    if clouds {
        let drawn = posterior.samples.len().div_ceil(every(posterior));
        words += &format!(" Below it {drawn} samples of each pair, both over their ranges.");
    }
    let bottom = sheet.caption(below, &words);
    Some(sheet.finish(bottom))
}

const WIDEST_NAME: f64 = 118.0;

fn names_width(parameters: &[Parameter]) -> f64 {
    let wide =
        |p: &Parameter| lines(p).iter().map(|line| font::width(line, SMALL, font::Weight::Regular)).fold(0.0, f64::max);
    parameters.iter().map(wide).fold(40.0, f64::max)
}

fn lines(parameter: &Parameter) -> Vec<String> {
    let mut lines = font::wrap(&parameter.name, SMALL, font::Weight::Regular, WIDEST_NAME);
    lines.truncate(3);
    if !parameter.unit.is_empty() {
        lines.push(format!("[{}]", pretty(&parameter.unit)));
    }
    lines
}

fn name(sheet: &mut Sheet, parameter: &Parameter, row: Area, left: f64) {
    let lines = lines(parameter);
    let middle = 0.5 * (row.top + row.bottom) + 0.5 * font::CAPITAL * SMALL;
    let style = Style { size: SMALL, ..Style::default() }.anchored(Anchor::End);
    for (k, line) in lines.iter().enumerate() {
        let drop = 1.3 * SMALL * (k as f64 - 0.5 * (lines.len() - 1) as f64);
        sheet.text([left - 8.0, middle + drop], line, style);
    }
}

/// Names and ends of the ranges below the last row; returns the y below.
fn values(sheet: &mut Sheet, parameters: &[Parameter], cell: impl Fn(usize) -> Area) -> f64 {
    let small = Style { size: SMALL, ..Style::default() };
    let mut below: f64 = 0.0;
    for (column, parameter) in parameters.iter().enumerate() {
        let area = cell(column);
        let ends = [parameter.lower, parameter.upper].map(four_digits);
        sheet.text([area.left + 3.0, area.bottom + 15.0], &ends[0], small);
        sheet.text([area.right - 3.0, area.bottom + 15.0], &ends[1], small.anchored(Anchor::End));
        let mut y = area.bottom + 20.0;
        for line in font::wrap(&parameter.name, SMALL, small.weight, area.right - area.left - 6.0) {
            y += 1.3 * SMALL;
            sheet.text([0.5 * (area.left + area.right), y], &line, small.anchored(Anchor::Middle));
        }
        if !parameter.unit.is_empty() {
            y += 1.3 * SMALL;
            let unit = format!("[{}]", pretty(&parameter.unit));
            sheet.text([0.5 * (area.left + area.right), y], &unit, small.anchored(Anchor::Middle));
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
    let middle = [0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom) + 0.5 * font::CAPITAL * style.size];
    sheet.text(middle, &text, style);
}
