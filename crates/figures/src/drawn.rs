//! The bridge as its file draws it.

use crate::cover;
use crate::defects;
use crate::dimension;
use crate::discs;
use crate::edges;
use crate::elevation::{self as draw, Sign};
use crate::sheet::{Sheet, place::Room};
use outcome::picture::Picture;

/// Elevation of the bridge as built: blocks, supports, road surface, loads, dimensions. An empty sheet with its
/// title where there are no blocks.
pub fn bridge_as_drawn(picture: &Picture) -> String {
    let (mut sheet, top) = Sheet::titled("bridge", &picture.title, "The bridge as drawn");
    let Some(extent) = draw::extent(picture) else { return sheet.finish(top) };
    let extent = edges::extent(picture, extent);
    let (frame, view) = draw::fit(extent, top + draw::ARROW, draw::TALLEST);
    edges::behind(&mut sheet, &view, picture);
    cover::bands(&mut sheet, &view, picture);
    discs::by_layer(&mut sheet, &view, picture, None);
    draw::blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    defects::lines(&mut sheet, &view, picture);
    draw::surface(&mut sheet, &view, picture, draw::SURFACE);
    edges::over(&mut sheet, &view, picture);
    let on_surface = !picture.surface_loads.is_empty();
    if on_surface {
        draw::surface_loads(&mut sheet, &view, picture);
    } else {
        draw::load_arrows(&mut sheet, &view, picture, None);
    }
    let room = Room::between(top, frame.bottom);
    let mut y = dimension::draw(&mut sheet, &view, &picture.dimensions, extent, room) + 8.0;
    y = draw::scale_bar(&mut sheet, &view, y);
    y = discs::key(&mut sheet, y + 4.0, picture, false);
    y = cover::key(&mut sheet, y, picture);
    y = edges::key(&mut sheet, y, picture);
    y = defects::key(&mut sheet, y, picture);
    let load = if on_surface { "variable load on the surface" } else { "variable load" };
    let entries = [
        (Sign::Support, "support", picture.shapes.iter().any(|s| s.held)),
        (Sign::Load, load, on_surface || !picture.loads.is_empty()),
    ];
    y = draw::key(&mut sheet, y, &entries);
    if let Some(words) = discs::left_out(picture) {
        y = sheet.caption(y, &format!("{words}."));
    }
    sheet.finish(y)
}
