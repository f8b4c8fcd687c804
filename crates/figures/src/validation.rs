//! Predictions over tests: one row a bridge, one line a method, on a logarithmic axis with the test at 1.

mod marks;

use crate::chart::{Axis, Key};
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Style, WIDTH, font};
use marks::{colour, mark};
use outcome::validation::{Bias, Prediction, Predictor, Tested, Validation};

/// Height of one method's line.
const LINE: f64 = 17.0;
/// Gap between two bridges.
const GAP: f64 = 9.0;
/// Room for words to the right of the plane.
const WORDS: f64 = 176.0;
/// Side on which a method predicts more than the test carried.
const TOO_HIGH: &str = "#fbeee6";
const ALARM: &str = "#a02020";
/// The axis never shows less than this, nor more than that: what goes beyond ends in an arrow.
const FARTHEST: [f64; 2] = [0.02, 20.0];

/// The figure of a validation as SVG. None without a prediction.
pub fn validation(found: &Validation) -> Option<String> {
    let methods: Vec<Predictor> = found.statistics.iter().map(|one| one.by).collect();
    let range = range(found)?;
    let (mut sheet, top) = Sheet::titled(
        "validation",
        "Prediction over test",
        "Bridges loaded to collapse, all predicted from one set of prior values; nothing is fitted to a test",
    );
    let plane = Plane::new(found, methods.len(), top, range);
    plane.draw(&mut sheet);
    for (row, test) in found.tests.iter().enumerate() {
        plane.test(&mut sheet, row, test);
    }
    plane.all(&mut sheet, found);
    let one = plane.x(1.0);
    sheet.line([one, plane.area.top], [one, plane.area.bottom], Pen::line(INK, 1.6).class("test"));
    let bottom = key(&mut sheet, plane.area.bottom + 48.0, found, &methods);
    let caption = "Thick: priors at their least and their largest values. Thin: dimensions that were not read at the ends of their intervals \
                   too; of particles, the packings. An arrow goes on beyond the axis. Right: prediction over test.";
    let bottom = sheet.caption(bottom + 2.0, caption);
    Some(sheet.end(bottom, &doubts(found)))
}

/// What a reader should know of tests, after their marks.
fn doubts(found: &Validation) -> String {
    let mut words = String::new();
    if found.tests.iter().any(|test| !test.recalled.is_empty()) {
        words += "† Some dimensions were not read: remembered or assumed.";
    }
    if found.tests.iter().any(|test| test.doubt.is_some()) {
        words += " ‡ The test may not be a fair one.";
    }
    words.trim().to_owned()
}

/// First and last value of the axis: everything that is shown, and 1.
fn range(found: &Validation) -> Option<[f64; 2]> {
    let of = |test: &Tested, one: &Prediction| {
        let ends = [one.by_priors, one.by_dimensions, one.by_packings].into_iter().flatten().flatten();
        let loads = ends.chain(one.load).chain(one.half_strength).chain(one.dilating);
        loads.filter(|load| *load > 0.0).map(|load| test.over(load)).collect::<Vec<_>>()
    };
    let every = || found.tests.iter().flat_map(|test| test.predictions.iter().flat_map(move |one| of(test, one)));
    let (low, high) = (every().reduce(f64::min)?, every().reduce(f64::max)?);
    Some([(0.85 * low.min(0.7)).max(FARTHEST[0]), (1.18 * high.max(1.5)).min(FARTHEST[1])])
}

/// Where everything is drawn.
struct Plane {
    area: Area,
    axis: Axis<'static>,
    methods: usize,
    /// The top of each row: tests, and all of them together.
    rows: Vec<f64>,
}

impl Plane {
    fn new(found: &Validation, methods: usize, top: f64, [low, high]: [f64; 2]) -> Plane {
        let bold = Style::bold();
        let names = found.tests.iter().map(|test| bold.width(&name(test))).fold(96.0, f64::max);
        let pitch = LINE * methods as f64 + GAP;
        let rows: Vec<f64> = (0..=found.tests.len()).map(|row| top + 26.0 + pitch * row as f64).collect();
        let area = Area {
            left: MARGIN + names + 14.0,
            right: WIDTH - MARGIN - WORDS,
            top: top + 22.0,
            bottom: top + 26.0 + pitch * rows.len() as f64,
        };
        Plane { area, axis: Axis::logarithmic("prediction over test", low, high), methods, rows }
    }

    fn x(&self, over: f64) -> f64 {
        let [low, high] = self.axis.range;
        self.area.left + self.axis.share(over.clamp(low, high)) * (self.area.right - self.area.left)
    }

    /// The middle of a method's line in a row.
    fn y(&self, row: usize, method: usize) -> f64 {
        self.rows[row] + 0.5 * GAP - 3.0 + LINE * (method as f64 + 0.5)
    }

    fn draw(&self, sheet: &mut Sheet) {
        let Area { left, right, top, bottom } = self.area;
        sheet.open("axes");
        sheet.rectangle(Area { left: self.x(1.0), right, top, bottom }, Pen::shape(TOO_HIGH, "none", 0.0));
        for &value in &self.axis.ticks.values {
            let x = self.x(value);
            sheet.line([x, top], [x, bottom], Pen::line("#d0d0d0", HAIR));
            sheet.line([x, bottom], [x, bottom + 5.0], Pen::line(INK, 0.9));
            sheet.text([x, bottom + 19.0], &self.axis.words(value), Style::small().anchored(Anchor::Middle));
        }
        for &row in &self.rows[1..] {
            sheet.line([MARGIN, row], [WIDTH - MARGIN, row], Pen::line("#b0b0b0", HAIR));
        }
        sheet.rectangle(self.area, Pen::line(INK, 0.9));
        sheet.text([0.5 * (left + right), bottom + 38.0], self.axis.name, Style::default().anchored(Anchor::Middle));
        sheet.text([self.x(1.0) - 8.0, top - 6.0], "careful", Style::grey().anchored(Anchor::End));
        sheet.text([self.x(1.0) + 8.0, top - 6.0], "more than the test carried", Style::grey());
        sheet.close();
    }

    /// A row's name to the left of it, and words below the name.
    fn name(&self, sheet: &mut Sheet, row: usize, name: &str, words: &str) {
        let middle = self.rows[row] + 0.5 * (GAP + LINE * self.methods as f64);
        let edge = self.area.left - 12.0;
        sheet.text([edge, middle - 3.0], name, Style::bold().anchored(Anchor::End));
        sheet.text([edge, middle + 13.0], words, Style::grey().anchored(Anchor::End));
    }

    fn test(&self, sheet: &mut Sheet, row: usize, test: &Tested) {
        self.name(sheet, row, &name(test), &format!("{:.0} kN", test.carried / 1e3));
        for (line, one) in test.predictions.iter().enumerate() {
            let y = self.y(row, line);
            let over = |load: f64| test.over(load);
            for (ends, width) in [(one.by_dimensions, 1.0), (one.by_packings, 1.0), (one.by_priors, 4.0)] {
                self.interval(sheet, y, ends.map(|ends| ends.map(over)), width, colour(one.by));
            }
            for other in [one.half_strength, one.dilating].into_iter().flatten() {
                self.tick(sheet, over(other), y, colour(one.by));
            }
            if let Some(load) = one.load {
                mark(sheet, [self.x(over(load)), y], one.by);
            } else {
                let words = Style { colour: ALARM, ..Style::on_drawing() };
                let ended = words.first_line(&one.ended.replace('-', " "), self.area.right - self.area.left - 16.0);
                sheet.text([self.area.left + 8.0, y + 0.5 * font::CAPITAL * SMALL], &ended, words);
            }
            self.words(sheet, y, one.by, &one.load.map_or("no load".to_owned(), |load| number(over(load))));
        }
    }

    /// A line from end to end, with an arrow where it goes on beyond the axis.
    fn interval(&self, sheet: &mut Sheet, y: f64, ends: Option<[f64; 2]>, width: f64, colour: &str) {
        let Some([low, high]) = ends else { return };
        let pen = Pen::line(colour, width).class("interval");
        let (a, b) = (self.x(low), self.x(high));
        sheet.line([a, y], [b, y], pen);
        let [first, last] = self.axis.range;
        for (x, side, beyond) in [(a, -1.0, low < first), (b, 1.0, high > last)] {
            if beyond {
                let wing = |up: f64| [x - 7.0 * side, y + 4.0 * up];
                sheet.polygon(&[[x, y], wing(1.0), wing(-1.0)], Pen::shape(colour, colour, HAIR));
            } else if width < 2.0 {
                sheet.line([x, y - 3.5], [x, y + 3.5], Pen::line(colour, width));
            }
        }
    }

    /// Another answer of the same method: with half of the strength, or with dilation.
    fn tick(&self, sheet: &mut Sheet, over: f64, y: f64, colour: &str) {
        if self.axis.holds(over) {
            sheet.circle([self.x(over), y], 3.0, Pen::shape("white", colour, MEDIUM).class("other"));
        }
    }

    fn words(&self, sheet: &mut Sheet, y: f64, by: Predictor, words: &str) {
        let drop = y + 0.5 * font::CAPITAL * SMALL;
        let left = self.area.right + 12.0;
        sheet.text([left, drop], by.word(), Style::grey());
        sheet.text([left + 76.0, drop], words, Style::small());
    }

    /// Medians of all tests with one standard deviation of the logarithm to both sides.
    fn all(&self, sheet: &mut Sheet, found: &Validation) {
        let row = self.rows.len() - 1;
        self.name(sheet, row, "all tests", "median, scatter");
        for (line, one) in found.statistics.iter().enumerate() {
            let y = self.y(row, line);
            let Bias { by, median: Some(median), scatter, .. } = one else {
                self.words(sheet, y, one.by, "no number");
                continue;
            };
            if let Some(scatter) = scatter {
                let ends = [median * (-scatter).exp(), median * scatter.exp()];
                self.interval(sheet, y, Some(ends), 1.6, colour(*by));
            }
            mark(sheet, [self.x(*median), y], *by);
            let spread = scatter.map_or(String::new(), |scatter| format!(", {}", number(scatter)));
            self.words(sheet, y, *by, &format!("{}{spread}", number(*median)));
        }
    }
}

/// Name of a bridge with the marks of what is doubtful.
fn name(test: &Tested) -> String {
    let memory = if test.recalled.is_empty() { "" } else { "†" };
    let doubt = if test.doubt.is_some() { "‡" } else { "" };
    format!("{}{memory}{doubt}", test.name)
}

fn number(over: f64) -> String {
    format!("{over:.2}")
}

/// What marks mean; returns the y below.
fn key(sheet: &mut Sheet, top: f64, found: &Validation, methods: &[Predictor]) -> f64 {
    let mut entries: Vec<(Option<Predictor>, String)> =
        methods.iter().map(|by| (Some(*by), format!("{}: {}", by.word(), by.about()))).collect();
    let others = |one: &Prediction| one.half_strength.is_some() || one.dilating.is_some();
    if found.tests.iter().any(|test| test.predictions.iter().any(others)) {
        entries.push((None, "continuum with half of its strength (left) and with dilation (right)".to_owned()));
    }
    let key = Key { words: 22.0, wide: 24.0, below: 6.0, ..Key::CHART };
    key.draw(sheet, top, entries, |sheet, [x, y], by| match by {
        Some(by) => mark(sheet, [x + 9.0, y - 4.0], by),
        None => {
            let pen = Pen::shape("white", colour(Predictor::Continuum), MEDIUM);
            sheet.circle([x + 9.0, y - 4.0], 3.0, pen);
        }
    })
}

#[cfg(test)]
mod tests;
