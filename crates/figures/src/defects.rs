//! Defects of the rings: numbered lines on the drawing, and what they are.

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
        let ([x, y], lowest) = (view.spot(middle), view.spot([middle[0], under(picture, middle)])[1]);
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

/// The lowest level of blocks over or under a place [m].
fn under(picture: &Picture, place: [f64; 2]) -> f64 {
    let free = picture.shapes.iter().filter(|shape| !shape.held);
    let here = free.filter(|shape| {
        let xs = || shape.outline.iter().map(|p| p[0]);
        xs().fold(f64::INFINITY, f64::min) <= place[0] && place[0] <= xs().fold(f64::NEG_INFINITY, f64::max)
    });
    // Of piers below the ring nothing counts.
    let near = here.filter(|shape| shape.role == "voussoir");
    near.flat_map(|shape| shape.outline.iter().map(|p| p[1])).fold(place[1], f64::min)
}

fn number(sheet: &mut Sheet, at: Spot, index: usize) {
    sheet.circle(at, RADIUS, Pen::shape("white", COLOUR, 1.2));
    let style = Style { size: SMALL - 1.0, colour: COLOUR, ..Style::default() };
    sheet.text([at[0], at[1] + 4.0], &(index + 1).to_string(), style.anchored(Anchor::Middle));
}
