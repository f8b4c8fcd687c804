//! How far the load path has come: a small chart beside the load.

use crate::chart::{Axes, Axis, PanelPoint};
use crate::elevation::{FAINT, INK, LOAD, THRUST};
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, Sheet, Spot, Style, WIDTH};
use crate::ticks::Ticks;
use outcome::picture::{Picture, Step};

/// Height that it takes.
pub(super) const HEIGHT: f64 = 152.0;

/// Load over the vertical displacement of the watched point: the whole path pale, what is behind it dark, and where
/// this snapshot stands. Nothing without two steps at rest.
pub(super) fn draw(sheet: &mut Sheet, picture: &Picture, snapshot: usize, corner: Spot) {
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
    let name = if picture.moves_supports { "support movement [mm]" } else { "load [kN/m]" };
    let (x, y) = (Axis::round("displacement of the watched point, down [mm]", x), Axis::round(name, y));
    let area =
        Area { left: corner[0] + 52.0, right: WIDTH - MARGIN - 12.0, top: corner[1] + 18.0, bottom: corner[1] + 108.0 };
    let axes = Axes { area, x: &x, y: &y };
    frame(sheet, &axes);
    let places: Vec<PanelPoint> = steps.iter().map(|s| [sink(s), s.load * unit]).collect();
    let spots = axes.spots(&places);
    sheet.polyline(&spots, Pen::line(FAINT, MEDIUM));
    // Loads of steps and snapshots are the same numbers; the allowance is for round-off.
    let behind = steps.iter().filter(|s| s.load <= load + 1e-9 * load.abs()).count();
    sheet.polyline(&spots[..behind], Pen::line(THRUST, 1.8));
    let falling = picture.last_stable.is_none_or(|stable| snapshot > stable);
    match spots.get(behind.saturating_sub(1)) {
        Some(&from) if falling => {
            sheet.arrow(from, [area.right, axes.spot([0.0, load * unit])[1]], Pen::line(LOAD, MEDIUM));
        }
        Some(&at) => sheet.circle(at, 4.0, Pen::shape(THRUST, "white", 1.0)),
        None => {}
    }
}

/// Smaller than that of other charts.
fn frame(sheet: &mut Sheet, axes: &Axes) {
    let (area, style) = (axes.area, Style::small());
    for &v in &axes.x.ticks.values {
        let left = axes.x(v);
        sheet.line([left, area.bottom], [left, area.bottom + 4.0], Pen::line(INK, 0.9));
        sheet.text([left, area.bottom + 17.0], &axes.x.words(v), style.anchored(Anchor::Middle));
    }
    for &v in &axes.y.ticks.values {
        let [_, level] = axes.spot([0.0, v]);
        sheet.line([area.left, level], [area.right, level], Pen::line("#d8d8d8", HAIR));
        sheet.text([area.left - 6.0, level + 4.4], &axes.y.words(v), style.anchored(Anchor::End));
    }
    sheet.rectangle(area, Pen::line(INK, 0.9));
    sheet.text([area.left, area.top - 7.0], axes.y.name, style);
    let middle = 0.5 * (area.left + area.right);
    sheet.text([middle, area.bottom + 35.0], axes.x.name, style.anchored(Anchor::Middle));
}
