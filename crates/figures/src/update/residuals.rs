//! What is left between record and model, channel by channel, before and after the update.

use super::style::{START, UPDATED};
use super::words::{errors_in, second_line, signed};
use crate::chart::{Axes, Axis, Key, NAME};
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, MARGIN, MEDIUM, Pen, SMALL, Sheet, Style, THIN, WIDTH, font};
use crate::words::three_digits;
use outcome::calibrate::misfit::{Compare, Scaling};
use outcome::counted;
use outcome::update::Update;

const ROW: f64 = 48.0;
const BAR: f64 = 15.0;
const WIDEST_NAME: f64 = 230.0;

/// Errors of all channels, those of the start model above those of the updated one. None without an error.
pub(super) fn residuals(update: &Update) -> Option<String> {
    let rows = rows(update);
    let numbers = || rows.iter().flat_map(|row| row.errors).flatten();
    let (low, high) = (numbers().fold(0.0, f64::min), numbers().fold(0.0, f64::max));
    numbers().next()?;

    let (mut sheet, top) =
        Sheet::titled("residuals", &update.bridge, &second_line(update, "What is left between records and model"));
    let name = axis_name(update);
    let room = 0.12 * (high - low).max(1e-6);
    let (low, high) = (if low < 0.0 { low - room } else { low }, if high > 0.0 { high + room } else { high });
    let axis = Axis::exact(&name, low, high.max(low + 1e-6), 7);
    let wide = |row: &Row| Style::default().width(&row.name);
    let left = MARGIN + rows.iter().map(wide).fold(90.0, f64::max).min(WIDEST_NAME) + 12.0;
    let area = Area { left, right: WIDTH - MARGIN, top: top + 4.0, bottom: top + 4.0 + ROW * rows.len() as f64 };
    let axes = Axes::across(&mut sheet, area, &axis, NAME);
    for (place, row) in rows.iter().enumerate() {
        let y = area.top + ROW * (place as f64 + 0.5);
        for (side, error) in row.errors.iter().enumerate() {
            let at = y + (side as f64 - 0.5) * (BAR + 2.0);
            let Some(error) = error else { continue };
            bar(&mut sheet, &axes, at, pen(side, row.left_out.is_some()), *error);
        }
        let end = Style::default().anchored(Anchor::End);
        sheet.text([area.left - 10.0, y - 2.0], &end.first_line(&row.name, WIDEST_NAME), end);
        sheet.text([area.left - 10.0, y + 14.0], &row.about, Style::grey().anchored(Anchor::End));
    }
    let zero = axes.x(0.0);
    sheet.line([zero, area.top], [zero, area.bottom], Pen::line(INK, MEDIUM));
    let bottom = key(&mut sheet, area.bottom + 48.0, update);
    let out: Vec<String> =
        rows.iter().filter_map(|row| Some(format!("{}: {}", row.name, row.left_out.as_ref()?))).collect();
    let bottom = match out.is_empty() {
        true => bottom,
        false => sheet.caption(bottom, &format!("Hollow bars: channels that take no part. {}.", out.join("; "))),
    };
    Some(sheet.finish(bottom))
}

/// A channel with its errors before and after [as the axis has them].
struct Row {
    name: String,
    about: String,
    errors: [Option<f64>; 2],
    left_out: Option<String>,
}

fn rows(update: &Update) -> Vec<Row> {
    let (factor, _) = errors_in(update);
    let start = update.basis.as_ref().map(|basis| &basis.start.channels);
    let found = update.found().map(|found| &found.channels);
    let row = |k: usize| {
        let channel = &update.problem.channels()[k];
        let before = start.and_then(|all| all.get(k)).map(|one| factor * one.error);
        let after = found.and_then(|all| all.get(k)).map(|one| factor * one.error);
        let weight = update.basis.as_ref().and_then(|basis| basis.held.weights.get(k));
        let about = match (&channel.left_out, weight) {
            (Some(_), _) => "left out".to_owned(),
            (None, _) if channel.readings => counted(channel.history.as_ref().map_or(0, Vec::len), "reading"),
            (None, Some(weight)) => format!("weight {}", three_digits(*weight)),
            (None, None) => String::new(),
        };
        let errors = [before, after].map(|error| error.filter(|error| error.is_finite()));
        Row { name: channel.name.clone(), about, errors, left_out: channel.left_out.clone() }
    };
    (0..update.problem.channels().len()).map(row).collect()
}

fn axis_name(update: &Update) -> String {
    let readings = update.problem.channels().iter().filter(|channel| channel.readings).count();
    let what = match update.problem.misfit().compare {
        _ if readings == update.problem.channels().len() => "root mean square of model less reading",
        Compare::Peaks if readings > 0 => "model peak less record's, root mean square of readings",
        Compare::Peaks => "model peak less record's",
        Compare::Histories => "root mean square of model less record",
    };
    let over = match update.problem.misfit().scaling {
        Scaling::MeasuredPeak => ", over the record's peak",
        Scaling::Uncertainty => "",
    };
    format!("{what}{over} [{}]", errors_in(update).1)
}

fn pen(side: usize, hollow: bool) -> Pen<'static> {
    let colour = [START, UPDATED][side];
    let class = ["before", "after"][side];
    if hollow { Pen::shape("white", colour, MEDIUM).class(class) } else { Pen::shape(colour, INK, THIN).class(class) }
}

fn bar(sheet: &mut Sheet, axes: &Axes, y: f64, pen: Pen, error: f64) {
    let (from, to) = (axes.x(0.0), axes.x(error));
    let bar = Area { left: from.min(to), right: from.max(to), top: y - 0.5 * BAR, bottom: y + 0.5 * BAR };
    sheet.rectangle(bar, pen);
    let text = signed(error, axes.x.ticks.decimals.max(1));
    let style = Style::on_drawing();
    let wide = style.width(&text) + 6.0;
    // Beside the bar's end; on its other side where the frame is in the way.
    let beyond = if to >= from { to + wide < axes.area.right } else { to - wide > axes.area.left };
    let right = (to >= from) == beyond;
    let (anchor, at) = if right { (Anchor::Start, to + 6.0) } else { (Anchor::End, to - 6.0) };
    sheet.text([at, y + 0.5 * font::CAPITAL * SMALL], &text, style.anchored(anchor));
}

/// What the colours mean, with the norms; returns the y below.
fn key(sheet: &mut Sheet, top: f64, update: &Update) -> f64 {
    let norms = [update.basis.as_ref().map(|basis| basis.start.norm), update.found().map(|found| found.norm)];
    let sides = ["start model", "updated model"].into_iter().zip(norms).enumerate();
    let entries =
        sides.filter_map(|(side, (name, norm))| Some((side, format!("{name}: norm {}", three_digits(norm?)))));
    Key { wide: 38.0, gap: 24.0, ..Key::CHART }.draw(sheet, top, entries, |sheet, [x, y], side| {
        let swatch = Area { left: x + 4.0, right: x + 30.0, top: y - 10.0, bottom: y };
        sheet.rectangle(swatch, Pen { class: "", ..pen(side, false) });
    })
}
