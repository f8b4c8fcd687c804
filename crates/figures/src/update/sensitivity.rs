//! How the norm and every channel's error follow each parameter alone (railway paper, Figs. 5, 6 and 10).

use super::{HEADING_LINE, axis, errors_in, fitting, heading, heading_lines, search_words, second_line, value_words};
use crate::chart::{Axes, Axis, Entry, Mark, Words, key};
use crate::elevation::INK;
use crate::sheet::{Area, HAIR, MARGIN, Pen, Sheet, Spot, WIDTH};
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
pub fn sensitivity(update: &Update, paper: &PaperSearch, number: usize) -> Option<String> {
    let pass = paper.outcome.passes.get(number)?;
    let ranked = pass.ranking.iter().filter_map(|k| pass.sweeps.iter().find(|sweep| sweep.parameter == *k));
    let rows: Vec<(&Sweep, bool)> =
        ranked.map(|sweep| (sweep, false)).chain(pass.last.iter().map(|s| (s, true))).collect();
    let norms = || rows.iter().flat_map(|(sweep, _)| &sweep.norms).flatten().copied().filter(|norm| norm.is_finite());
    let most = norms().reduce(f64::max)?;
    let pieces: Vec<(usize, Vec<(f64, f64)>)> = rows.iter().flat_map(|(sweep, _)| errors(update, sweep)).collect();
    let sizes = || pieces.iter().flat_map(|(_, points)| points).map(|point| point.1);
    let (low, high) = (sizes().fold(0.0, f64::min), sizes().fold(0.0, f64::max));

    let mut sheet = Sheet::new(&format!("sensitivity-{}", number + 1));
    let what = format!("Each parameter varied alone, pass {}; {}", number + 1, search_words(update, paper));
    let top = sheet.title(&update.bridge, &second_line(update, &what));
    let (factor, unit) = errors_in(update);
    let error_name = format!("error [{unit}]");
    let up = [
        Axis::round("norm", Ticks::over(0.0, most, 4)),
        Axis::round(&error_name, Ticks::over(factor * low, factor * high, 4)),
    ];
    let mut below = top + 2.0;
    for (place, (sweep, last)) in rows.iter().enumerate() {
        let [name, about] = told(update, sweep, place, *last);
        let (left, right) = (frames(&up, 0.0)[0].left, WIDTH - MARGIN);
        let frames = frames(&up, below + 8.0 + HEADING_LINE * heading_lines(left, right, &name, &about));
        heading(&mut sheet, [left, frames[0].top - 8.0], right, &name, &about);
        row(&mut sheet, update, sweep, frames, &up);
        below = frames[0].bottom + 50.0;
    }
    let mut entries = vec![Entry { line: Some((NORM, "")), mark: Some((Mark::Full, NORM)), text: "norm" }];
    entries.push(Entry { line: None, mark: Some((Mark::Hollow, INK)), text: "least norm" });
    let channels = update.problem.channels();
    let drawn = |k: &usize| pieces.iter().any(|(channel, _)| channel == k);
    for (k, channel) in channels.iter().enumerate().filter(|(k, _)| drawn(k)) {
        entries.push(Entry { line: Some(CHANNELS[k % CHANNELS.len()]), mark: None, text: &channel.name });
    }
    let bottom = key(&mut sheet, below, &entries);
    let bottom = sheet.caption(
        bottom,
        "Dashed upright: the model about which parameters were varied. All panels of a column have one scale. Where a \
         curve is broken, the model found no answer.",
    );
    Some(sheet.finish(bottom))
}

/// Both panels of a row below `top`.
fn frames(up: &[Axis; 2], top: f64) -> [Area; 2] {
    let [one, two] = [Axes::widest(&up[0]), Axes::widest(&up[1])];
    let left = MARGIN + 24.0 + one + 8.0;
    // Norm and errors share what is left of the sheet evenly.
    let wide = 0.5 * (WIDTH - MARGIN - 14.0 - left - (46.0 + two));
    let bottom = top + HEIGHT;
    let second = left + wide + 46.0 + two;
    [Area { left, right: left + wide, top, bottom }, Area { left: second, right: second + wide, top, bottom }]
}

fn row(sheet: &mut Sheet, update: &Update, sweep: &Sweep, frames: [Area; 2], up: &[Axis; 2]) {
    let parameter = &update.problem.parameters()[sweep.parameter];
    let (Some(first), Some(last)) = (sweep.values.first(), sweep.values.last()) else { return };
    let name = fitting(&parameter.name, &parameter.unit, frames[0].right - frames[0].left);
    let x = axis(parameter, &name, [*first, *last], 7);
    for (side, (frame, up)) in frames.into_iter().zip(up).enumerate() {
        let y_name = frame.left - 20.0 - Axes::widest(up);
        let axes = Axes::within(sheet, frame, &x, up, Words { x: true, y: true, y_name: Some(y_name) });
        if let Some(own) = sweep.model.get(sweep.parameter).filter(|own| (x.range[0]..=x.range[1]).contains(*own)) {
            let at = axes.spot(*own, up.range[0])[0];
            sheet.line([at, frame.top], [at, frame.bottom], Pen::line("#707070", HAIR + 0.3).dashed("4 3"));
        }
        if side == 0 {
            norms(sheet, sweep, &axes);
        } else {
            let ends = x.range.map(|x| axes.spot(x, 0.0));
            sheet.line(ends[0], ends[1], Pen::line("#8a8a8a", HAIR + 0.2));
            let (factor, _) = errors_in(update);
            for (k, points) in errors(update, sweep) {
                let (colour, dashes) = CHANNELS[k % CHANNELS.len()];
                let spots: Vec<Spot> = points.iter().map(|(x, error)| axes.spot(*x, factor * error)).collect();
                sheet.polyline(&spots, Pen::line(colour, 1.5).dashed(dashes).class("error"));
            }
        }
    }
}

fn norms(sheet: &mut Sheet, sweep: &Sweep, axes: &Axes) {
    let mut run: Vec<Spot> = Vec::new();
    for (value, norm) in sweep.values.iter().zip(&sweep.norms).map(|(v, n)| (*v, *n)).chain([(0.0, None)]) {
        match norm.filter(|norm| norm.is_finite()) {
            Some(norm) => run.push(axes.spot(value, norm)),
            None => {
                sheet.polyline(&run, Pen::line(NORM, 1.8).class("norm"));
                run.iter().for_each(|at| sheet.circle(*at, 2.4, Pen::shape(NORM, NORM, HAIR)));
                run.clear();
            }
        }
    }
    if let Some(minimum) = &sweep.minimum {
        Mark::Hollow.draw(sheet, axes.spot(sweep.values[minimum.place], minimum.norm), INK);
    }
}

/// Errors along a sweep by channel, those that count, in pieces without a gap: value and error.
fn errors(update: &Update, sweep: &Sweep) -> Vec<(usize, Vec<(f64, f64)>)> {
    let channels = update.problem.channels();
    let mut pieces = Vec::new();
    for k in (0..channels.len()).filter(|k| channels[*k].counts()) {
        let points = sweep.values.iter().zip(&sweep.errors);
        let points: Vec<(f64, f64)> =
            points.map(|(x, errors)| (*x, errors.get(k).copied().unwrap_or(f64::NAN))).collect();
        let split = points.split(|point| !point.1.is_finite()).filter(|piece| !piece.is_empty());
        pieces.extend(split.map(|piece| (k, piece.to_vec())));
    }
    pieces
}

/// Name with rank, and what the sweep showed.
fn told(update: &Update, sweep: &Sweep, place: usize, last: bool) -> [String; 2] {
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
    [name, words]
}
