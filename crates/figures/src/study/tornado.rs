//! The tornado chart: one bar a quantity, the one that moves the answer most on top.

use super::{axis_name, honest, name_and_unit, with_unit};
use crate::chart::{Axes, Axis, Key, Mark};
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, MARGIN, MEDIUM, Pen, SMALL, Sheet, Style, THIN, WIDTH, font};
use crate::ticks::Ticks;
use crate::words::raised;
use outcome::study::{Extreme, Row, Sensitivity, Study, Trend, sensitivity};

/// Where the quantity is below its own value, above it, and where it has no order: told apart in grey print too.
const BELOW: &str = "#9dc3e6";
const ABOVE: &str = "#1f5fa8";
const WORDS: &str = "#b8b8b8";
const ALARM: &str = "#a02020";
const BAR: f64 = 20.0;
const WIDEST_NAME: f64 = 250.0;

/// The bars, with the answer of the file's own bridge as a line through all of them. None without an answer.
pub fn tornado(study: &Study) -> Option<String> {
    let mut bars: Vec<Sensitivity> = sensitivity(study).into_iter().filter(|one| one.low.is_some()).collect();
    bars.sort_by(|a, b| b.swing.unwrap_or(0.0).total_cmp(&a.swing.unwrap_or(0.0)));
    let ends = |one: &Sensitivity| [&one.low, &one.high].map(|end| end.as_ref().map_or(f64::NAN, |end| end.outcome));
    let own = study.baseline().and_then(|row| study.number(row));
    let numbers = || bars.iter().flat_map(ends).chain(own).filter(|number| number.is_finite());
    let (low, high) = (numbers().reduce(f64::min)?, numbers().reduce(f64::max)?);

    let (name, _) = name_and_unit(&study.outcome);
    let (mut sheet, top) = Sheet::titled(
        "tornado",
        &study.bridge,
        &format!("What moves the {name}, one quantity at a time, by {}", study.method.name()),
    );
    let name = axis_name(&study.outcome);
    let plane = Plane::new(study, &bars, top, &name, honest(low, high));
    Axes::across(&mut sheet, plane.area, &plane.axis, 38.0);
    for (place, one) in bars.iter().enumerate() {
        plane.bar(&mut sheet, study, one, place, own);
    }
    if let Some(own) = own {
        let x = plane.x(own);
        sheet.line([x, plane.area.top - 4.0], [x, plane.area.bottom], Pen::line(INK, MEDIUM).class("baseline"));
        let text = format!("as the file has it: {}", with_unit(own, &study.outcome));
        let half = 0.5 * Style::small().width(&text);
        let middle = x.clamp(MARGIN + half, WIDTH - MARGIN - half);
        sheet.text([middle, plane.area.top - 8.0], &text, Style::small().anchored(Anchor::Middle));
    }
    for (place, one) in bars.iter().enumerate() {
        plane.notes(&mut sheet, study, one, place);
    }
    let bottom = key(&mut sheet, plane.area.bottom + 50.0, study, &bars);
    Some(sheet.finish(bottom))
}

/// Where bars are drawn.
struct Plane<'a> {
    area: Area,
    axis: Axis<'a>,
    heights: Vec<f64>,
}

impl<'a> Plane<'a> {
    /// Bars of a range; their labels need the rest of the area.
    fn new(study: &Study, bars: &[Sensitivity], top: f64, name: &'a str, range: [f64; 2]) -> Plane<'a> {
        let wide = |text: &str| Style::small().width(text);
        let label = |one: &Sensitivity| Style::default().width(&label(study, one));
        let names = bars.iter().map(label).fold(90.0, f64::max).min(WIDEST_NAME);
        let reserve = |end: usize| {
            let apart = bars.iter().filter(|one| one.trend != Trend::Flat);
            apart.map(|one| wide(&end_texts(study, one)[end])).fold(0.0, f64::max) + 12.0
        };
        let (left, mut right) = (reserve(0), reserve(1));
        // What stays has its words beside the line through all bars, where there is room on the way to the last bar's end.
        let own = study.baseline().and_then(|row| study.number(row));
        let share = own.map_or(0.5, |own| (own - range[0]) / (range[1] - range[0])).clamp(0.05, 1.0);
        let room = WIDTH - 2.0 * MARGIN - names - 12.0 - left;
        for one in bars.iter().filter(|one| one.trend == Trend::Flat) {
            right = right.max((wide(&end_texts(study, one)[1]) + 14.0 - room * (1.0 - share)) / share);
        }
        let heights: Vec<f64> = bars.iter().map(|one| 44.0 + 15.0 * notes(study, one).len() as f64).collect();
        let area = Area {
            left: MARGIN + names + 12.0,
            right: WIDTH - MARGIN,
            top: top + 24.0,
            bottom: top + 24.0 + heights.iter().sum::<f64>() + 6.0,
        };
        // The axis goes as far as the frame does on both sides of the bars.
        let per_unit = (range[1] - range[0]) / (area.right - right - area.left - left);
        let (low, high) = (range[0] - per_unit * left, range[1] + per_unit * right);
        let mut ticks = Ticks::over(low, high, 6);
        ticks.values.retain(|value| (low..=high).contains(value));
        Plane { area, axis: Axis { name, ticks, ..Axis::blank(low, high) }, heights }
    }

    fn x(&self, number: f64) -> f64 {
        self.area.left + self.axis.share(number) * (self.area.right - self.area.left)
    }

    /// The middle of a bar.
    fn y(&self, place: usize) -> f64 {
        self.area.top + 6.0 + self.heights[..place].iter().sum::<f64>() + 17.0
    }

    fn bar(&self, sheet: &mut Sheet, study: &Study, one: &Sensitivity, place: usize, own: Option<f64>) {
        let (Some(low), Some(high)) = (&one.low, &one.high) else { return };
        let y = self.y(place);
        let start = own.unwrap_or(low.outcome);
        let sides = [(low, low.outcome < start), (high, high.outcome > start)];
        for (end, _) in sides.into_iter().filter(|(_, apart)| *apart) {
            let (a, b) = (self.x(start.min(end.outcome)), self.x(start.max(end.outcome)));
            let area = Area { left: a, right: b, top: y - 0.5 * BAR, bottom: y + 0.5 * BAR };
            sheet.rectangle(area, Pen::shape(side(study, one, end), INK, THIN).class("swing"));
        }
        for row in study.rows_of(one.quantity) {
            let Some(number) = study.number(row) else { continue };
            let mark = if ends_otherwise(study, row) { Mark::Hollow } else { Mark::Full };
            mark.draw(sheet, [self.x(number), y], INK);
        }
        let drop = 0.5 * font::CAPITAL * SMALL;
        let left = self.x(low.outcome.min(start)) - 8.0;
        let right = self.x(high.outcome.max(start)) + 8.0;
        let [first, last] = end_texts(study, one);
        sheet.text([left, y + drop], &first, Style::small().anchored(Anchor::End));
        sheet.text([right, y + drop], &last, Style::small());
        let name = Style::default().anchored(Anchor::End);
        let edge = self.area.left - 10.0;
        sheet.text([edge, y - 1.0], &name.first_line(&label(study, one), WIDEST_NAME), name);
        sheet.text([edge, y + 14.0], &own_text(study, one), Style::grey().anchored(Anchor::End));
    }

    /// How runs of a quantity ended that ended otherwise, over everything else that is drawn.
    fn notes(&self, sheet: &mut Sheet, study: &Study, one: &Sensitivity, place: usize) {
        for (line, note) in notes(study, one).iter().enumerate() {
            let at = [self.area.left + 8.0, self.y(place) + 27.0 + 15.0 * line as f64];
            sheet.text(at, note, Style { colour: ALARM, ..Style::on_drawing() });
        }
    }
}

/// The quantity's path.
fn label(study: &Study, one: &Sensitivity) -> String {
    study.quantities[one.quantity].path.to_string()
}

fn own_text(study: &Study, one: &Sensitivity) -> String {
    study.quantities[one.quantity].own.as_ref().map_or("not in the file".to_owned(), |own| raised(&own.text))
}

/// What stands at both ends of a bar: the value, and what it does to the answer. The file's own value is the line through
/// all bars and needs no words.
fn end_texts(study: &Study, one: &Sensitivity) -> [String; 2] {
    let varied = &study.quantities[one.quantity];
    if one.trend == Trend::Flat {
        let ends = [varied.values.first(), varied.values.last()].map(|end| end.map_or("", |end| end.text.as_str()));
        return [String::new(), raised(&format!("no change from {} to {}", ends[0], ends[1]))];
    }
    let own = varied.own.as_ref().map(|own| own.text.as_str());
    let start = study.baseline().and_then(|row| study.number(row));
    let text = |end: &Option<Extreme>, sign: f64| match end {
        Some(end) if Some(end.value.as_str()) == own => String::new(),
        // Both ends on one side of the file's own answer: the farther one says it.
        Some(end) if start.is_some_and(|start| sign * (end.outcome - start) < 0.0) => String::new(),
        Some(end) => {
            let change = end.change_percent.map_or(String::new(), |change| format!(": {change:+.1} %"));
            raised(&format!("{}{}", end.value, change.replace('-', "−")))
        }
        None => String::new(),
    };
    [text(&one.low, -1.0), text(&one.high, 1.0)]
}

/// Colour of the side on which a value lies.
fn side(study: &Study, one: &Sensitivity, end: &Extreme) -> &'static str {
    let varied = &study.quantities[one.quantity];
    let number = |text: &str| varied.values.iter().find(|value| value.text == text).and_then(|value| value.number);
    match (number(&end.value), varied.own.as_ref().and_then(|own| own.number)) {
        (Some(value), Some(own)) if value < own => BELOW,
        (Some(value), Some(own)) if value > own => ABOVE,
        _ => WORDS,
    }
}

fn ends_otherwise(study: &Study, row: &Row) -> bool {
    study.baseline().is_none_or(|own| own.outcome.status != row.outcome.status)
}

/// Runs that ended otherwise than the file's own bridge, by how they ended.
fn notes(study: &Study, one: &Sensitivity) -> Vec<String> {
    let mut notes: Vec<(String, Vec<String>)> = Vec::new();
    for row in study.rows_of(one.quantity).filter(|row| ends_otherwise(study, row)) {
        let value = study.setting(row, one.quantity).map_or(String::new(), |setting| raised(&setting.text));
        match notes.iter_mut().find(|(status, _)| *status == row.outcome.status) {
            Some((_, values)) => values.push(value),
            None => notes.push((row.outcome.status.clone(), vec![value])),
        }
    }
    notes.into_iter().map(|(status, values)| format!("{}: {status}", values.join(", "))).collect()
}

/// What colours and marks mean, those that are there; returns the y below.
fn key(sheet: &mut Sheet, top: f64, study: &Study, bars: &[Sensitivity]) -> f64 {
    let own = study.baseline().and_then(|row| study.number(row));
    let used = |colour: &str| {
        let ends = bars.iter().flat_map(|one| [&one.low, &one.high].into_iter().flatten().map(move |end| (one, end)));
        ends.filter(|(_, end)| Some(end.outcome) != own).any(|(one, end)| side(study, one, end) == colour)
    };
    let answered = || study.rows.iter().skip(1).filter(|row| study.number(row).is_some());
    let texts = ["value below the file's own", "value above the file's own", "another word, or not in the file"];
    let bars = [BELOW, ABOVE, WORDS].into_iter().zip(texts).filter(|(colour, _)| used(colour));
    let mut entries: Vec<((&str, Option<Mark>), &str)> = bars.map(|(colour, text)| ((colour, None), text)).collect();
    if answered().any(|row| !ends_otherwise(study, row)) {
        entries.push(((INK, Some(Mark::Full)), "one run"));
    }
    if answered().any(|row| ends_otherwise(study, row)) {
        entries.push(((INK, Some(Mark::Hollow)), "ended otherwise"));
    }
    let key = Key { words: 32.0, wide: 32.0, gap: 16.0, ..Key::CHART };
    key.draw(sheet, top, entries, |sheet, [x, y], (colour, mark)| match mark {
        Some(mark) => mark.draw(sheet, [x + 14.0, y - 4.5], colour),
        None => {
            let area = Area { left: x + 2.0, right: x + 26.0, top: y - 10.0, bottom: y + 1.0 };
            sheet.rectangle(area, Pen::shape(colour, INK, THIN));
        }
    })
}
