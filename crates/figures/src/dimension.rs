//! Dimension lines: spans and piers below, rises in the openings, thickness across the ring, depth above the crown.

use crate::elevation::INK;
use crate::geometry::{Extent, View};
use crate::sheet::place::Room;
use crate::sheet::{Anchor, Area, HAIR, Pen, Sheet, Spot, Style};
use crate::words;
use outcome::picture::{DimensionLine, Measure};

const LINE: Pen = Pen::line(INK, HAIR).class("dimension");
const EXTENSION: Pen = Pen::line("#777777", HAIR);

/// Draws all dimensions; `lowest` is the extent of the drawing. Returns the y below the span dimensions.
pub(crate) fn draw(sheet: &mut Sheet, view: &View, dimensions: &[DimensionLine], extent: Extent, room: Room) -> f64 {
    let foot = view.spot(extent.low)[1];
    // Spans and piers form one chain of dimensions below the drawing.
    let spans = || dimensions.iter().filter(|d| matches!(d.measure, Measure::Span | Measure::Width));
    let below = if spans().next().is_some() { foot + 22.0 } else { foot };
    sheet.open("dimensions");
    for d in spans() {
        span(sheet, view, d, below);
    }
    for d in dimensions {
        match d.measure {
            Measure::Span | Measure::Width => {}
            Measure::Rise => upright(sheet, view, d, d.to[0], room),
            Measure::Height | Measure::Depth => upright(sheet, view, d, d.from[0], room),
            Measure::Thickness => {
                let near = |r: &DimensionLine| (view.spot(r.to)[0] - view.spot(d.from)[0]).abs() < 40.0;
                let taken = dimensions.iter().any(|r| r.measure == Measure::Rise && near(r));
                thickness(sheet, view, d, taken, room);
            }
        }
    }
    sheet.close();
    below + if below > foot { 6.0 } else { 0.0 }
}

/// A slanted stroke where a dimension ends, as on drawings of buildings.
pub(crate) fn tick(sheet: &mut Sheet, at: Spot) {
    sheet.line([at[0] - 3.0, at[1] + 3.0], [at[0] + 3.0, at[1] - 3.0], Pen::line(INK, 1.4));
}

fn span(sheet: &mut Sheet, view: &View, d: &DimensionLine, y: f64) {
    let (a, b) = (view.spot(d.from), view.spot(d.to));
    for p in [a, b] {
        sheet.line([p[0], p[1] + 4.0], [p[0], y + 5.0], EXTENSION);
        tick(sheet, [p[0], y]);
    }
    sheet.line([a[0] - 5.0, y], [b[0] + 5.0, y], LINE);
    let text = words::metres((d.to[0] - d.from[0]).abs());
    let style = Style::small();
    sheet.text([0.5 * (a[0] + b[0]), y - 4.0], &text, style.anchored(Anchor::Middle));
}

/// A vertical dimension at a given place along the bridge.
fn upright(sheet: &mut Sheet, view: &View, d: &DimensionLine, x: f64, room: Room) {
    let (low, high) = (d.from[1].min(d.to[1]), d.from[1].max(d.to[1]));
    let (a, b) = (view.spot([x, low]), view.spot([x, high]));
    let from = view.spot(d.from);
    if (from[0] - a[0]).abs() > 1.0 {
        // The springing line, drawn only as far as the dimension needs it.
        let over = 8.0 * (a[0] - from[0]).signum();
        sheet.line(from, [a[0] + over, from[1]], EXTENSION.dashed("7 2.5 1.5 2.5"));
    }
    sheet.line(a, b, LINE);
    tick(sheet, a);
    tick(sheet, b);
    let text = words::metres(high - low);
    // The line itself keeps texts away.
    sheet.avoid(Area { left: a[0] - 2.0, right: a[0] + 2.0, top: b[1], bottom: a[1] });
    let room = Room { clear: 6.0, ..room }.towards([1.0, 0.0]);
    sheet.label([a[0], 0.5 * (a[1] + b[1])], &text, Style::on_drawing(), room);
}

/// Two arrows that press on the ring from both sides, with the value on the intrados' side. Where a rise takes that
/// place: a line across the ring, with the value where there is room.
fn thickness(sheet: &mut Sheet, view: &View, d: &DimensionLine, taken: bool, room: Room) {
    let (a, b) = (view.spot(d.from), view.spot(d.to));
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    if !length.is_finite() || length <= 0.0 {
        return;
    }
    let text = words::metres((d.to[0] - d.from[0]).hypot(d.to[1] - d.from[1]));
    let unit = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    let off = |p: Spot, by: f64| [p[0] + by * unit[0], p[1] + by * unit[1]];
    sheet.line(a, b, Pen::line(INK, 1.2));
    if taken {
        tick(sheet, a);
        tick(sheet, b);
        let room = Room { clear: 5.0, ..room }.towards([0.9 + 0.3 * unit[0], 0.3 * unit[1]]);
        sheet.label(b, &text, Style::on_drawing(), room);
        return;
    }
    let arrow = Pen::line(INK, 0.9);
    sheet.arrow(off(b, 20.0), b, arrow);
    sheet.arrow(off(a, -24.0), a, arrow);
    let room = Room { clear: 4.0, ..room }.towards([-unit[0], -unit[1]]);
    sheet.label(off(a, -24.0), &text, Style::on_drawing(), room);
}
