//! How the norm and every channel's error follow each parameter alone (railway paper, Figs. 5, 6 and 10).

use super::style::axis;
use super::words::{errors_in, fitting, search_words, second_line, value_words};
use crate::chart::{
    Axes, Axis, Entry, HEADING, Heading, Mark, NAME, Panel, PanelPoint, ZERO, heading, heading_lines, key, runs,
};
use crate::elevation::INK;
use crate::sheet::{Area, HAIR, MARGIN, Pen, Sheet, WIDTH};
use crate::ticks::Ticks;
use crate::words::three_digits;
use outcome::calibrate::search::sweep::Sweep;
use outcome::update::{PaperSearch, Update};

/// Height of a panel.
const HEIGHT: f64 = 108.0;
const NORM: &str = "#0b5394";
/// Colours after Okabe and Ito (2008), told apart by the colour-blind; dashes tell them apart in grey print.
const CHANNELS: [(&str, &str); 8] = [
    ("#0072b2", ""),
    ("#d55e00", "7 3"),
    ("#009e73", "2 2"),
    ("#cc79a7", "9 3 2 3"),
    ("#111111", "4 2"),
    ("#56b4e9", "12 3"),
    ("#a67c00", "1 3"),
    ("#7f7f7f", "6 2 1 2 1 2"),
];

/// A row for each parameter in the order of the ranking: the norm to the left, the channels' errors to the right. Last single
/// sweeps follow.
pub(super) fn sensitivity(update: &Update, paper: &PaperSearch, number: usize) -> Option<String> {
    let pass = paper.outcome.passes.get(number)?;
    let ranked = pass.ranking.iter().filter_map(|k| pass.sweeps.iter().find(|sweep| sweep.parameter == *k));
    let rows: Vec<(&Sweep, bool)> =
        ranked.map(|sweep| (sweep, false)).chain(pass.last.iter().map(|s| (s, true))).collect();
    let norms = || rows.iter().flat_map(|(sweep, _)| &sweep.norms).flatten().copied().filter(|norm| norm.is_finite());
    let most = norms().reduce(f64::max)?;
    let pieces: Vec<(usize, Vec<PanelPoint>)> = rows.iter().flat_map(|(sweep, _)| errors(update, sweep)).collect();
    let sizes = || pieces.iter().flat_map(|(_, run)| run).map(|place| place[1]);
    let (low, high) = (sizes().fold(0.0, f64::min), sizes().fold(0.0, f64::max));

    let what = format!("Each parameter varied alone, pass {}; {}", number + 1, search_words(update, paper));
    let (mut sheet, top) =
        Sheet::titled(&format!("sensitivity-{}", number + 1), &update.bridge, &second_line(update, &what));
    let error_name = format!("error [{}]", errors_in(update).1);
    let up = [Axis::round("norm", Ticks::over(0.0, most, 4)), Axis::round(&error_name, Ticks::over(low, high, 4))];
    let mut below = top + 2.0;
    for (place, (sweep, last)) in rows.iter().enumerate() {
        let told = told(update, sweep, place, *last);
        let (left, right) = (Axes::left(up[0].widest()), WIDTH - MARGIN);
        let frames = frames(&up, below + 8.0 + HEADING * heading_lines(left, right, &told));
        heading(&mut sheet, [left, frames[0].top - 8.0], right, &told);
        row(&mut sheet, update, sweep, frames, &up);
        below = frames[0].bottom + 50.0;
    }
    let mut entries =
        vec![Entry::line((NORM, ""), "norm").marked(Mark::Full, NORM), Entry::mark(Mark::Hollow, INK, "least norm")];
    for (k, channel) in update.problem.channels().iter().enumerate() {
        let drawn = pieces.iter().any(|(of, _)| *of == k);
        entries.push(Entry::line(CHANNELS[k % CHANNELS.len()], &channel.name).when(drawn));
    }
    let bottom = key(&mut sheet, below, &entries);
    let words = "Dashed upright: the model about which parameters were varied. All panels of a column have one scale. Where a \
                 curve is broken, the model found no answer.";
    Some(sheet.end(bottom, words))
}

/// Both panels of a row below `top`.
fn frames(up: &[Axis; 2], top: f64) -> [Area; 2] {
    let (left, bottom) = (Axes::left(up[0].widest()), top + HEIGHT);
    let between = 46.0 + up[1].widest();
    // Norm and errors share what is left of the sheet evenly.
    let wide = 0.5 * (WIDTH - MARGIN - 14.0 - left - between);
    let second = left + wide + between;
    [Area { left, right: left + wide, top, bottom }, Area { left: second, right: second + wide, top, bottom }]
}

fn row(sheet: &mut Sheet, update: &Update, sweep: &Sweep, frames: [Area; 2], up: &[Axis; 2]) {
    let parameter = &update.problem.parameters()[sweep.parameter];
    let (Some(first), Some(last)) = (sweep.values.first(), sweep.values.last()) else { return };
    let name = fitting(&parameter.name, &parameter.unit, frames[0].right - frames[0].left);
    let x = axis(parameter, &name, [*first, *last], 7);
    let fill: [fn(&mut Panel, &Update, &Sweep); 2] = [add_norms, add_errors];
    for ((frame, up), fill) in frames.into_iter().zip(up).zip(fill) {
        let mut panel = Panel::new(x.clone(), up.clone());
        if let Some(own) = sweep.model.get(sweep.parameter).filter(|own| x.holds(**own)) {
            panel.upright(*own, Pen::line("#707070", HAIR + 0.3).dashed("4 3"));
        }
        fill(&mut panel, update, sweep);
        panel.within(sheet, frame, Some(NAME), Some(up.widest()));
    }
}

fn add_norms(panel: &mut Panel, _: &Update, sweep: &Sweep) {
    let norms = sweep.values.iter().zip(&sweep.norms);
    let places: Vec<PanelPoint> = norms.map(|(value, norm)| [*value, norm.unwrap_or(f64::NAN)]).collect();
    for run in runs(&places) {
        panel.line(run, Pen::line(NORM, 1.8).class("norm"));
        panel.circles(run, 2.4, Pen::shape(NORM, NORM, HAIR));
    }
    if let Some(minimum) = &sweep.minimum {
        panel.mark([sweep.values[minimum.place], minimum.norm], Mark::Hollow, INK);
    }
}

fn add_errors(panel: &mut Panel, update: &Update, sweep: &Sweep) {
    panel.level(0.0, ZERO);
    for (k, run) in errors(update, sweep) {
        let (colour, dashes) = CHANNELS[k % CHANNELS.len()];
        panel.line(run, Pen::line(colour, 1.5).dashed(dashes).class("error"));
    }
}

/// Errors along a sweep by channel, those that count, in pieces without a gap [as the axis has them].
fn errors(update: &Update, sweep: &Sweep) -> Vec<(usize, Vec<PanelPoint>)> {
    let channels = update.problem.channels();
    let (factor, _) = errors_in(update);
    let mut pieces = Vec::new();
    for k in (0..channels.len()).filter(|k| channels[*k].counts()) {
        let points = sweep.values.iter().zip(&sweep.errors);
        let places = points.map(|(x, errors)| [*x, factor * errors.get(k).copied().unwrap_or(f64::NAN)]);
        pieces.extend(runs(&places.collect::<Vec<PanelPoint>>()).map(|run| (k, run.to_vec())));
    }
    pieces
}

/// Name with rank, and what the sweep showed.
fn told(update: &Update, sweep: &Sweep, place: usize, last: bool) -> Heading {
    let parameter = &update.problem.parameters()[sweep.parameter];
    let name =
        if last { format!("{}, last sweep", parameter.name) } else { format!("{}. {}", place + 1, parameter.name) };
    let weights = update.basis.as_ref().map_or(&[][..], |basis| &basis.held.weights);
    let mut words = format!("range of the norm {}", three_digits(sweep.range()));
    if let Some(minimum) = &sweep.minimum {
        let value = value_words(sweep.values[minimum.place], &parameter.unit);
        let bound = if minimum.at_bound { ", on its bound" } else { "" };
        let decided = if minimum.decided { "" } else { ", not decided" };
        words += &format!("; least {} at {value}{bound}{decided}", three_digits(minimum.norm));
    }
    if !weights.is_empty() && !last {
        let (factor, unit) = errors_in(update);
        words += &format!("; mean range of errors {} {unit}", three_digits(factor * sweep.mean_error_range(weights)));
    }
    (name, Some(words))
}
