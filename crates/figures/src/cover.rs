//! Layers of the cover and backing, pale behind the blocks, and what they are.

use crate::chart::Key;
use crate::elevation::INK;
use crate::geometry::View;
use crate::sheet::{Area, HAIR, Pen, Sheet};
use outcome::picture::Picture;

/// Fill of a layer by its name.
fn colour(name: &str) -> &'static str {
    match name {
        "backing" => "#d3cfc4",
        "internal walls" => "#e6dccb",
        name if name.starts_with("void") => "#ffffff",
        "surfacing" => "#cfd2d6",
        "sub-base" => "#e3e1da",
        "ballast" => "#dcdcdc",
        _ => "#f3efe4",
    }
}

/// The layers, without outlines that could be taken for joints.
pub(crate) fn bands(sheet: &mut Sheet, view: &View, picture: &Picture) {
    if picture.bands.is_empty() {
        return;
    }
    sheet.open("cover");
    for band in &picture.bands {
        for outline in &band.outlines {
            sheet.polygon(&view.spots(outline), Pen::shape(colour(&band.name), "none", 0.0).class("layer"));
        }
    }
    sheet.close();
}

/// A row of layers with their colours and depths; returns the y below it.
pub(crate) fn key(sheet: &mut Sheet, top: f64, picture: &Picture) -> f64 {
    if picture.bands.is_empty() {
        return top;
    }
    let bands = picture.bands.iter().map(|band| (colour(&band.name), format!("{}, {}", band.name, band.size)));
    Key { class: "cover-key", ..Key::ELEVATION }.draw(sheet, top, bands, |sheet, [x, y], colour| {
        let swatch = Area { left: x + 1.0, right: x + 21.0, top: y - 9.0, bottom: y + 1.0 };
        sheet.rectangle(swatch, Pen::shape(colour, INK, HAIR));
    })
}
