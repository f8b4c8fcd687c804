//! Defects of the rings: numbered lines on the drawing, and what they are.

use crate::elevation::blocks_at;
use crate::geometry::View;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, SMALL, Sheet, Spot, Style};
use outcome::picture::Picture;

const COLOUR: &str = "#b3261e";
/// Radius of the circle with a number.
const RADIUS: f64 = 8.0;

/// A line along each defect, and its number beside the middle of it.
pub(crate) fn lines(sheet: &mut Sheet, view: &View, picture: &Picture) {
    if picture.defects.is_empty() {
        return;
    }
    sheet.open("defects");
    for mark in &picture.defects {
        sheet.polyline(&view.spots(&mark.line), Pen::line(COLOUR, 3.0).class("defect"));
    }
    for (index, mark) in picture.defects.iter().enumerate() {
        let Some(&middle) = mark.line.get(mark.line.len() / 2) else { continue };
        // Numbers of defects at one place stand beside one another, below the ring.
        let before = picture.defects[..index].iter().filter_map(|other| other.line.get(other.line.len() / 2));
        let near = before.filter(|at| (at[0] - middle[0]).abs() * view.scale < 2.0 * RADIUS).count();
        // Of piers below the ring nothing counts.
        let under = blocks_at(picture, "voussoir", middle[0]).map(|stone| stone.low[1]).fold(middle[1], f64::min);
        let ([x, y], lowest) = (view.spot(middle), view.spot([middle[0], under])[1]);
        let at = [x, lowest.max(y) + 20.0 + 2.4 * RADIUS * near as f64];
        sheet.line([x, y], [at[0], at[1] - RADIUS], Pen::line(COLOUR, HAIR));
        number(sheet, at, index);
        sheet.avoid(Area::about(at, RADIUS));
    }
    sheet.close();
}

/// Numbers and what they stand for, a line each; returns the y below.
pub(crate) fn key(sheet: &mut Sheet, top: f64, picture: &Picture) -> f64 {
    if picture.defects.is_empty() {
        return top;
    }
    let mut y = top + 14.0;
    sheet.open("defects-key");
    for (index, mark) in picture.defects.iter().enumerate() {
        number(sheet, [MARGIN + RADIUS + 2.0, y - 4.0], index);
        sheet.text([MARGIN + 26.0, y], &mark.words, Style::small());
        y += 20.0;
    }
    sheet.close();
    y - 8.0
}

fn number(sheet: &mut Sheet, at: Spot, index: usize) {
    sheet.circle(at, RADIUS, Pen::shape("white", COLOUR, 1.2));
    let style = Style { size: SMALL - 1.0, colour: COLOUR, ..Style::default() };
    sheet.text([at[0], at[1] + 4.0], &(index + 1).to_string(), style.anchored(Anchor::Middle));
}
