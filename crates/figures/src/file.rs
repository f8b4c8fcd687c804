//! Files to be written, and drawings as such.

use crate::raster::{RasterError, png};

/// Width of PNG pictures [pixels]: 160 mm at 380 dots per inch.
pub const PNG_WIDTH: u32 = 2400;

/// A file to be written.
#[derive(Debug, Clone, PartialEq)]
pub struct File {
    /// Its name, with a folder before it where there is one (`paraview/blocks.pvd`); `/` divides.
    pub name: String,
    /// What it contains.
    pub bytes: Vec<u8>,
}

/// Drawings, each a name without extension and SVG, as the files they are written to: SVG and PNG.
///
/// # Errors
/// Those of [`png()`].
pub fn written(drawings: &[(String, String)]) -> Result<Vec<File>, RasterError> {
    let mut files = Vec::new();
    for (name, svg) in drawings {
        files.push(File { name: format!("{name}.svg"), bytes: svg.as_bytes().to_vec() });
        files.push(File { name: format!("{name}.png"), bytes: png(svg, PNG_WIDTH)? });
    }
    Ok(files)
}
