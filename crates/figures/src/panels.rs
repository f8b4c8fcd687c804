//! Elevations one below the other, each with its words.

use crate::elevation::{self as draw, INK};
use crate::geometry::{Extent, Turn, View, moved};
use crate::sheet::{Area, HAIR, MARGIN, Pen, Sheet, Style, WIDTH};
use crate::words;
use outcome::picture::{Picture, Point, Snapshot};

/// Tallest of two elevations on a sheet.
const TALLEST: f64 = 330.0;

/// Draws one panel of the whole width below `top`, framed; its words stand below it. Returns the y below them.
pub(crate) fn panel(
    sheet: &mut Sheet,
    extent: Extent,
    top: f64,
    name: &str,
    text: &str,
    content: impl FnOnce(&mut Sheet, &View),
) -> f64 {
    let (area, view) = draw::fit(extent, top, TALLEST);
    // The frame hugs a bridge that is narrower than the sheet.
    let half = 0.5 * view.scale * extent.size()[0];
    let middle = 0.5 * (area.left + area.right);
    let area = Area { left: middle - half, right: middle + half, ..area };
    sheet.open_clipped("panel", name, area);
    content(sheet, &view);
    sheet.close();
    sheet.rectangle(area, Pen::line("#9a9a9a", HAIR));
    let style = Style::small();
    sheet.paragraph(MARGIN, area.bottom + 3.0, WIDTH - 2.0 * MARGIN, text, style) + 6.0
}

/// The blocks where they are in a state, each free one of its colour, asked for in their order.
pub(crate) fn coloured(
    sheet: &mut Sheet,
    view: &View,
    picture: &Picture,
    state: &Snapshot,
    support: f64,
    mut colour: impl FnMut(usize) -> String,
) {
    let width = draw::outline_width(&picture.shapes, view);
    for (k, shape) in picture.shapes.iter().enumerate() {
        let spots = view.spots(&outline(picture, Some(state), k, 1.0));
        match shape.held {
            true => sheet.hatched(&spots, Pen::line(INK, support).class("support")),
            false => sheet.polygon(&spots, Pen::shape(&colour(k), INK, width).class("block")),
        }
    }
}

/// Outline of a block where it is in a state, its displacement drawn `scale` times as large, or as built [m].
pub(crate) fn outline(picture: &Picture, state: Option<&Snapshot>, block: usize, scale: f64) -> Vec<Point> {
    let shape = &picture.shapes[block];
    state.and_then(|s| s.motions.get(block)).map_or(shape.outline.clone(), |&m| moved(shape, m, scale, Turn::Finite))
}

/// A state's load in words, and whether it is the last stable one.
pub(crate) fn load(picture: &Picture, snapshot: usize) -> String {
    let load = picture.snapshots[snapshot].load;
    let size = if picture.moves_supports { words::metres(load) } else { words::force(load) };
    match picture.last_stable {
        Some(stable) if stable == snapshot => format!("{size}, last stable"),
        Some(stable) if snapshot > stable => {
            format!("{size}, on the way down, {} of {}", snapshot - stable, picture.snapshots.len() - stable - 1)
        }
        _ => size,
    }
}

/// The state that figures of particles show: the last stable one, or the last of all; none where it does not fit.
pub(crate) fn shown(picture: &Picture) -> Option<usize> {
    picture.last_stable.or(picture.snapshots.len().checked_sub(1)).filter(|&k| fits(picture, k))
}

/// Whether a state has every block and every particle.
pub(crate) fn fits(picture: &Picture, snapshot: usize) -> bool {
    picture
        .snapshots
        .get(snapshot)
        .is_some_and(|s| s.motions.len() == picture.shapes.len() && s.particles.len() == picture.particles.len())
}
