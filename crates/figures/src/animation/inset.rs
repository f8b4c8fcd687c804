//! How far the load path has come: a small chart beside the load.

use crate::elevation::{FAINT, INK, LOAD, THRUST};
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Spot, Style, WIDTH};
use crate::ticks::Ticks;
use outcome::picture::{Picture, Step};

/// Height that it takes.
pub const HEIGHT: f64 = 152.0;

/// Load over the vertical displacement of the watched point: the whole path pale, what is behind it dark, and where
/// this snapshot stands. Nothing without two steps at rest.
pub fn draw(sheet: &mut Sheet, picture: &Picture, snapshot: usize, corner: Spot) {
    let finite = |s: &&Step| s.at_rest && s.load.is_finite() && s.displacement[1].is_finite();
    let steps: Vec<&Step> = picture.path.iter().filter(finite).collect();
    if steps.len() < 2 {
        return;
    }
    let unit = if picture.moves_supports { 1e3 } else { 1e-3 };
    let sink = |s: &Step| -1e3 * s.displacement[1];
    let over = |values: Vec<f64>, count| {
        let (low, high) = values.iter().fold((0.0_f64, 0.0_f64), |(a, b), v| (a.min(*v), b.max(*v)));
        Ticks::over(low, high, count)
    };
    let x = over(steps.iter().map(|s| sink(s)).collect(), 4);
    let load = picture.snapshots[snapshot].load;
    let y = over(steps.iter().map(|s| s.load * unit).chain([picture.collapse_load.unwrap_or(0.0) * unit]).collect(), 3);
    let area =
        Area { left: corner[0] + 52.0, right: WIDTH - MARGIN - 12.0, top: corner[1] + 18.0, bottom: corner[1] + 108.0 };
    let share = |v: f64, r: [f64; 2]| (v - r[0]) / (r[1] - r[0]);
    let spot = |sunk: f64, load: f64| -> Spot {
        [
            area.left + share(sunk, x.range()) * (area.right - area.left),
            area.bottom - share(load * unit, y.range()) * (area.bottom - area.top),
        ]
    };
    axes(sheet, &x, &y, area, if picture.moves_supports { "support movement [mm]" } else { "load [kN/m]" });
    let spots: Vec<Spot> = steps.iter().map(|s| spot(sink(s), s.load)).collect();
    sheet.polyline(&spots, Pen::line(FAINT, MEDIUM));
    // Loads of steps and snapshots are the same numbers; the allowance is for round-off.
    let behind = steps.iter().filter(|s| s.load <= load + 1e-9 * load.abs()).count();
    sheet.polyline(&spots[..behind], Pen::line(THRUST, 1.8));
    let falling = picture.last_stable.is_none_or(|stable| snapshot > stable);
    match spots.get(behind.saturating_sub(1)) {
        Some(&from) if falling => sheet.arrow(from, [area.right, spot(0.0, load)[1]], Pen::line(LOAD, MEDIUM)),
        Some(&at) => sheet.circle(at, 4.0, Pen::shape(THRUST, "white", 1.0)),
        None => {}
    }
}

fn axes(sheet: &mut Sheet, x: &Ticks, y: &Ticks, area: Area, name: &str) {
    let style = Style { size: SMALL, ..Style::default() };
    let at = |v: f64, t: &Ticks| (v - t.range()[0]) / (t.range()[1] - t.range()[0]);
    for &v in &x.values {
        let left = area.left + at(v, x) * (area.right - area.left);
        sheet.line([left, area.bottom], [left, area.bottom + 4.0], Pen::line(INK, 0.9));
        sheet.text([left, area.bottom + 17.0], &x.words(v), style.anchored(Anchor::Middle));
    }
    for &v in &y.values {
        let level = area.bottom - at(v, y) * (area.bottom - area.top);
        sheet.line([area.left, level], [area.right, level], Pen::line("#d8d8d8", HAIR));
        sheet.text([area.left - 6.0, level + 4.4], &y.words(v), style.anchored(Anchor::End));
    }
    sheet.rectangle(area, Pen::line(INK, 0.9));
    sheet.text([area.left, area.top - 7.0], name, style);
    let middle = 0.5 * (area.left + area.right);
    let below = "displacement of the watched point, down [mm]";
    sheet.text([middle, area.bottom + 35.0], below, style.anchored(Anchor::Middle));
}
