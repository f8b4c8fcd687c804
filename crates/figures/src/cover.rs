//! Layers of the cover and backing, pale behind the blocks, and what they are.

use crate::elevation::INK;
use crate::geometry::View;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, SMALL, Sheet, Style, WIDTH, font};
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
pub fn bands(sheet: &mut Sheet, view: &View, picture: &Picture) {
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
pub fn key(sheet: &mut Sheet, top: f64, picture: &Picture) -> f64 {
    if picture.bands.is_empty() {
        return top;
    }
    let style = Style { size: SMALL, ..Style::default() };
    let (mut x, mut y) = (MARGIN, top + 12.0);
    sheet.open("cover-key");
    for band in &picture.bands {
        let text = format!("{}, {}", band.name, band.size);
        let wide = 30.0 + font::width(&text, style.size, style.weight);
        if x > MARGIN && x + wide > WIDTH - MARGIN {
            x = MARGIN;
            y += 18.0;
        }
        let swatch = Area { left: x + 1.0, right: x + 21.0, top: y - 9.0, bottom: y + 1.0 };
        sheet.rectangle(swatch, Pen::shape(colour(&band.name), INK, HAIR));
        sheet.text([x + 26.0, y], &text, style.anchored(Anchor::Start));
        x += wide + 18.0;
    }
    sheet.close();
    y + 6.0
}
