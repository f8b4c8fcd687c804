//! How the answer follows one quantity.

use super::{axis_name, honest, name_and_unit, with_unit};
use crate::chart::{Axis, Chart, Entry, Mark, Panel, PanelPoint, runs};
use crate::sheet::place::Room;
use crate::sheet::{Pen, Style};
use crate::ticks::Ticks;
use crate::words::named;
use outcome::study::{Row, Study};

const CURVE: &str = "#0b5394";
const ALARM: &str = "#a02020";

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

    let x_name = named(&varied.path.to_string(), &varied.unit);
    let y_name = axis_name(&study.outcome);
    let (first, last) = (points.first()?.0, points.last()?.0);
    let x = Axis::exact(&x_name, first - 0.03 * (last - first), last + 0.03 * (last - first), 8);
    let mut panel = Panel::new(x, Axis::round(&y_name, Ticks::over(low, high, 6)));
    let places: Vec<PanelPoint> = points.iter().map(|point| [point.0, point.1.unwrap_or(f64::NAN)]).collect();
    panel.open("curve");
    for run in runs(&places) {
        panel.curve(run, Pen::line(CURVE, 1.8).class("response"));
    }
    panel.close();
    let own_status = study.baseline().map(|row| row.outcome.status.as_str()).unwrap_or_default();
    let own_value = varied.own.as_ref().and_then(|own| own.number);
    let (mut otherwise, mut without) = (false, false);
    for (&place, (value, answer, row)) in places.iter().zip(&points) {
        let as_own = row.outcome.status == own_status;
        if answer.is_none() {
            without = true;
            cross(&mut panel, *value, &row.outcome.status);
            continue;
        }
        otherwise |= !as_own;
        if own_value == Some(*value) {
            panel.mark(place, Mark::Ring, CURVE);
        }
        panel.mark(place, if as_own { Mark::Full } else { Mark::Hollow }, CURVE);
    }
    if let Some((value, Some(number), _)) = points.iter().find(|point| own_value == Some(point.0)) {
        // Beside the curve: below it where it rises to the right of the point, above it where it rises to the left.
        let rising = points.iter().rev().find_map(|point| point.1) > points.iter().find_map(|point| point.1);
        let right = if *value - first <= 0.5 * (last - first) { 1.0 } else { -1.0 };
        let down = if rising { right } else { -right };
        let text = format!("as the file has it: {}", with_unit(*number, &study.outcome));
        panel.label([*value, *number], text, [0.6 * right, 0.8 * down], 12.0);
    }
    let mut chart = Chart::of(panel, 320.0);
    chart.key.push(Entry::line((CURVE, ""), own_status).marked(Mark::Full, CURVE));
    chart.key.push(Entry::mark(Mark::Hollow, CURVE, "ended otherwise").when(otherwise));
    if without {
        chart.words.push("Crosses at the foot: runs without this number, with how they ended.".to_owned());
    }
    let (name, _) = name_and_unit(&study.outcome);
    let second = format!("The {name} over {}, by {}", varied.path, study.method.name());
    Some(chart.draw("curve", &study.bridge, &second))
}

/// A run without an answer, at the foot of the panel.
fn cross<'a>(panel: &mut Panel<'a>, value: f64, status: &'a str) {
    let (arm, foot) = (4.5, panel.y.range[0]);
    panel.add(move |sheet, axes| {
        let [x, y] = axes.spot([value, foot]);
        let at = [x, y - 12.0];
        for side in [-1.0, 1.0] {
            let (a, b) = ([at[0] - arm, at[1] - side * arm], [at[0] + arm, at[1] + side * arm]);
            sheet.line(a, b, Pen::line(ALARM, 1.6).class("without"));
        }
        let room = Room { area: axes.area.grown(-5.0), towards: [0.0, -1.0], clear: 10.0 };
        sheet.label(at, status, Style { colour: ALARM, ..Style::on_drawing() }, room);
    });
}
