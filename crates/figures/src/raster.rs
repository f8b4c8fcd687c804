//! SVG to PNG, with the embedded font and nothing from the machine: the same bytes everywhere.

use crate::sheet::font;
use resvg::{tiny_skia, usvg};
use std::sync::Arc;
use thiserror::Error;

/// Why there is no PNG.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RasterError {
    /// The SVG is broken.
    #[error("the drawing cannot be read: {0}")]
    Svg(String),
    /// No picture can be that large or that small.
    #[error("a picture of {0} by {1} pixels cannot be made")]
    Size(u32, u32),
    /// The pixels could not be packed.
    #[error("the picture cannot be packed: {0}")]
    Pack(String),
}

/// Longest side of a picture [pixels].
const LARGEST: u32 = 20_000;

/// With the embedded font.
pub(crate) fn options() -> usvg::Options<'static> {
    let mut fonts = usvg::fontdb::Database::new();
    for file in font::files() {
        fonts.load_font_source(usvg::fontdb::Source::Binary(Arc::new(file)));
    }
    // Every other family falls back to the embedded one.
    fonts.set_sans_serif_family("DejaVu Sans");
    usvg::Options { fontdb: Arc::new(fonts), font_family: "DejaVu Sans".into(), ..Default::default() }
}

/// A picture `width_px` pixels wide on white ground.
pub(crate) fn pixels(svg: &str, width_px: u32, options: &usvg::Options) -> Result<tiny_skia::Pixmap, RasterError> {
    let tree = usvg::Tree::from_str(svg, options).map_err(|e| RasterError::Svg(e.to_string()))?;
    let size = tree.size();
    if width_px == 0 || width_px > LARGEST {
        return Err(RasterError::Size(width_px, width_px));
    }
    // What is much taller than wide is drawn smaller: larger pictures would ask for gigabytes.
    let scale = (width_px as f32 / size.width()).min(LARGEST as f32 / size.height());
    let [width_px, height_px] =
        [size.width(), size.height()].map(|side| ((side * scale).round() as u32).clamp(1, LARGEST));
    let mut pixels = tiny_skia::Pixmap::new(width_px, height_px).ok_or(RasterError::Size(width_px, height_px))?;
    pixels.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    Ok(pixels)
}

/// A PNG picture `width_px` pixels wide on white ground.
///
/// # Errors
/// A text that is no SVG, or a width of 0 or of more than 20 000 pixels.
pub fn png(svg: &str, width_px: u32) -> Result<Vec<u8>, RasterError> {
    let pixels = pixels(svg, width_px, &options())?;
    pixels.encode_png().map_err(|e| RasterError::Pack(e.to_string()))
}
