//! How the answer follows one quantity.

use super::{axis_name, honest, name_and_unit, pretty, with_unit};
use crate::chart::{Axes, Axis, Entry, Mark, key};
use crate::sheet::place::Room;
use crate::sheet::{Area, Pen, SMALL, Sheet, Spot, Style};
use crate::ticks::Ticks;
use outcome::study::{Row, Study};

const CURVE: &str = "#0b5394";
const ALARM: &str = "#a02020";
const HEIGHT: f64 = 320.0;

/// The answer over the values of a quantity, its own value ringed, runs that ended otherwise hollow, and those without
/// an answer crossed at the foot. None with fewer than three numbers, where a bar says as much.
pub fn response(study: &Study, quantity: usize) -> Option<String> {
    let varied = study.quantities.get(quantity)?;
    let rows: Vec<&Row> = study.baseline().into_iter().chain(study.rows_of(quantity)).collect();
    let value = |row: &Row| study.setting(row, quantity).and_then(|setting| setting.number);
    let mut points: Vec<(f64, Option<f64>, &Row)> =
        rows.iter().filter_map(|row| Some((value(row)?, study.number(row), *row))).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by(|a, b| a.0 == b.0);
    let answers = || points.iter().filter_map(|point| point.1).filter(|number| number.is_finite());
    if answers().count() < 3 {
        return None;
    }
    let (low, high) = (answers().reduce(f64::min)?, answers().reduce(f64::max)?);
    let [low, high] = honest(low, high);

    let mut sheet = Sheet::new("curve");
    let (name, _) = name_and_unit(&study.outcome);
    let top = sheet.title(&study.bridge, &format!("The {name} over {}, by {}", varied.path, study.method_in_words()));
    let x_name = match varied.unit.as_str() {
        "" => varied.path.to_string(),
        unit => format!("{} [{}]", varied.path, pretty(unit)),
    };
    let y_name = axis_name(&study.outcome);
    let (first, last) = (points.first()?.0, points.last()?.0);
    let x = Axis::exact(&x_name, first - 0.03 * (last - first), last + 0.03 * (last - first), 8);
    let y = Axis::round(&y_name, Ticks::over(low, high, 6));
    let (axes, below) = Axes::draw(&mut sheet, top, HEIGHT, &x, &y);

    let mut run: Vec<Spot> = Vec::new();
    sheet.open("curve");
    for answer in points.iter().map(|point| point.1.map(|number| axes.spot(point.0, number))).chain([None]) {
        match answer {
            Some(spot) => run.push(spot),
            None => {
                sheet.polyline(&run, Pen::line(CURVE, 1.8).class("response"));
                sheet.avoid_line(&run);
                run.clear();
            }
        }
    }
    sheet.close();
    let own_status = study.baseline().map(|row| row.outcome.status.as_str()).unwrap_or_default();
    let own_value = varied.own.as_ref().and_then(|own| own.number);
    let (mut otherwise, mut without) = (false, false);
    for (value, answer, row) in &points {
        let as_own = row.outcome.status == own_status;
        let Some(number) = answer else {
            without = true;
            let foot = [axes.spot(*value, low)[0], axes.area.bottom - 12.0];
            cross(&mut sheet, foot, &row.outcome.status, axes.area);
            continue;
        };
        otherwise |= !as_own;
        let at = axes.spot(*value, *number);
        if own_value == Some(*value) {
            Mark::Ring.draw(&mut sheet, at, CURVE);
        }
        (if as_own { Mark::Full } else { Mark::Hollow }).draw(&mut sheet, at, CURVE);
    }
    if let Some((value, Some(number), _)) = points.iter().find(|point| own_value == Some(point.0)) {
        // Beside the curve: below it where it rises to the right of the point, above it where it rises to the left.
        let rising = points.iter().rev().find_map(|point| point.1) > points.iter().find_map(|point| point.1);
        let right = if *value - first <= 0.5 * (last - first) { 1.0 } else { -1.0 };
        let down = if rising { right } else { -right };
        let room = Room { area: axes.area.grown(-5.0), towards: [0.6 * right, 0.8 * down], clear: 12.0 };
        let text = format!("as the file has it: {}", with_unit(*number, &study.outcome));
        sheet.label(axes.spot(*value, *number), &text, Style::on_drawing(), room);
    }
    let mut entries = vec![Entry { line: Some((CURVE, "")), mark: Some((Mark::Full, CURVE)), text: own_status }];
    if otherwise {
        entries.push(Entry { line: None, mark: Some((Mark::Hollow, CURVE)), text: "ended otherwise" });
    }
    let mut bottom = key(&mut sheet, below, &entries);
    if without {
        bottom = sheet.caption(bottom, "Crosses at the foot: runs without this number, with how they ended.");
    }
    Some(sheet.finish(bottom))
}

/// A run without an answer.
fn cross(sheet: &mut Sheet, at: Spot, status: &str, area: Area) {
    let arm = 4.5;
    for side in [-1.0, 1.0] {
        let (a, b) = ([at[0] - arm, at[1] - side * arm], [at[0] + arm, at[1] + side * arm]);
        sheet.line(a, b, Pen::line(ALARM, 1.6).class("without"));
    }
    let style = Style { size: SMALL, colour: ALARM, halo: true, ..Style::default() };
    let room = Room { area: area.grown(-5.0), towards: [0.0, -1.0], clear: 10.0 };
    sheet.label(at, status, style, room);
}
