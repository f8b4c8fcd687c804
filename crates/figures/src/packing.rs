//! The packing of particles, before and after.

use crate::dimension;
use crate::discs;
use crate::elevation::{self as draw, INK, Sign};
use crate::geometry::{Extent, View};
use crate::panels::{fits, outline};
use crate::sheet::place::Room;
use crate::sheet::{Anchor, HAIR, Pen, Sheet, Style};
use crate::words;
use outcome::picture::{DimensionLine, Measure, Picture, Shape};

/// Thickness of the lid in the drawing [m].
const LID: f64 = 0.25;
/// Tallest of the two elevations.
const TALLEST: f64 = 330.0;

/// The particles as packed, under the lid and on the fixed ring, and at rest after the lid was taken away and the ring
/// let go, coloured by layer. None without particles.
pub fn packing(picture: &Picture) -> Option<String> {
    let extent = draw::extent(picture).filter(|_| discs::drawable(picture))?;
    let sizes = picture.particles.iter().map(|d| 2.0 * d.radius);
    let (least, most) = (sizes.clone().fold(f64::INFINITY, f64::min), sizes.fold(0.0, f64::max));
    let second = format!(
        "Packing of {} particles, {} to {} across",
        picture.particles.len(),
        words::metres(least),
        words::metres(most)
    );
    let (mut sheet, top) = Sheet::titled("packing", &picture.title, &second);

    // (a) the blocks that bring loads come after the packing.
    let shapes: Vec<Shape> = picture.shapes.iter().filter(|s| s.role != "block").cloned().collect();
    let first = Picture { shapes, snapshots: Vec::new(), ..picture.clone() };
    let (frame, view) = draw::fit(extent, top + 20.0, TALLEST);
    discs::by_layer(&mut sheet, &view, &first, None);
    draw::blocks(&mut sheet, &view, &first.shapes, |k| first.shapes[k].outline.clone());
    lid(&mut sheet, &view, picture);
    draw::avoid_blocks(&mut sheet, &view, &first.shapes, |k| first.shapes[k].outline.clone());
    let room = Room::between(top, frame.bottom);
    // The ring's thickness has its place in the drawing of the bridge.
    let mut sizes: Vec<DimensionLine> =
        picture.dimensions.iter().filter(|d| d.measure != Measure::Thickness).copied().collect();
    sizes.extend(depths(picture));
    let y = dimension::draw(&mut sheet, &view, &sizes, extent, room) + 4.0;
    let style = Style::small();
    let limit = crate::sheet::WIDTH - 2.0 * crate::sheet::MARGIN;
    let text = "(a) as packed: pressed together under the lid, the ring held";
    let mut y = sheet.paragraph(crate::sheet::MARGIN, y, limit, text, style) + 10.0;

    // (b)
    if fits(picture, 0) {
        let state = &picture.snapshots[0];
        let (frame, view) = draw::fit(extent, y, TALLEST);
        discs::by_layer(&mut sheet, &view, picture, Some(state));
        draw::blocks(&mut sheet, &view, &picture.shapes, |k| outline(picture, Some(state), k, 1.0));
        draw::surface(&mut sheet, &view, picture, draw::SURFACE);
        let sunk = picture.particles.iter().zip(&state.particles).map(|(d, now)| d.centre[1] - now.centre[1]);
        let mean = sunk.sum::<f64>() / picture.particles.len() as f64;
        let sense = if mean < 0.0 { "rose" } else { "sank" };
        let with = if picture.shapes.iter().any(|s| s.role == "block") { ", the loading block in place" } else { "" };
        let text = format!(
            "(b) at rest under {}: the lid taken away, the ring let go{with}; the particles {sense} by {} in the mean. The line is the road as planned.",
            words::force(state.load),
            words::metres(mean.abs())
        );
        y = sheet.paragraph(crate::sheet::MARGIN, frame.bottom + 4.0, limit, &text, style) + 8.0;
    }
    y = draw::scale_bar(&mut sheet, &view, y);
    y = discs::key(&mut sheet, y + 4.0, picture, false);
    y = draw::key(&mut sheet, y, &[(Sign::Support, "support, fixed wall, lid", true)]);
    Some(sheet.finish(y))
}

/// Level of the fill's upper face, and its ends.
fn upper_face(picture: &Picture) -> Option<(Extent, f64)> {
    let extent = Extent::of(picture.fill.iter().copied())?;
    Some((extent, extent.high[1]))
}

/// The lid that held the particles while they grew, and the width of the fill above it.
fn lid(sheet: &mut Sheet, view: &View, picture: &Picture) {
    let Some((extent, level)) = upper_face(picture) else { return };
    let (a, b) = (view.spot([extent.low[0], level + LID]), view.spot([extent.high[0], level]));
    let corners = [[a[0], a[1]], [b[0], a[1]], [b[0], b[1]], [a[0], b[1]]];
    sheet.hatched(&corners, Pen::line(INK, HAIR).class("lid"));
    let y = a[1] - 10.0;
    sheet.line([a[0], y], [b[0], y], Pen::line(INK, HAIR).class("dimension"));
    for x in [a[0], b[0]] {
        dimension::tick(sheet, [x, y]);
    }
    let style = Style::on_drawing().anchored(Anchor::Middle);
    sheet.text([0.5 * (a[0] + b[0]), y - 4.0], &words::metres(extent.size()[0]), style);
}

/// Depth of the fill over the crown and at its left end.
fn depths(picture: &Picture) -> Vec<DimensionLine> {
    let Some((extent, level)) = upper_face(picture) else { return Vec::new() };
    let below = |p: &&[f64; 2]| p[1] < level - 1e-9;
    let Some(crown) = picture.fill.iter().filter(below).max_by(|a, b| a[1].total_cmp(&b[1])) else { return Vec::new() };
    let x = extent.low[0] + 0.04 * extent.size()[0];
    let foot = picture.fill.iter().filter(below).min_by(|a, b| a[0].total_cmp(&b[0])).map_or(extent.low[1], |p| p[1]);
    // Beside the dimension of the rise, so that their words do not meet.
    let beside = crown[0] + 0.05 * extent.size()[0];
    vec![
        DimensionLine { measure: Measure::Height, from: [beside, crown[1]], to: [beside, level] },
        DimensionLine { measure: Measure::Height, from: [x, foot], to: [x, level] },
    ]
}
