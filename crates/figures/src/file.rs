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

/// A drawing as the two files it is written to.
///
/// # Errors
/// Those of [`png()`].
pub fn both(name: &str, svg: &str) -> Result<[File; 2], RasterError> {
    let picture = png(svg, PNG_WIDTH)?;
    Ok([
        File { name: format!("{name}.svg"), bytes: svg.as_bytes().to_vec() },
        File { name: format!("{name}.png"), bytes: picture },
    ])
}

/// Drawings as the files they are written to.
pub(crate) fn written(drawings: Vec<(String, String)>) -> Result<Vec<File>, RasterError> {
    let files: Result<Vec<[File; 2]>, _> = drawings.iter().map(|(name, svg)| both(name, svg)).collect();
    Ok(files?.into_iter().flatten().collect())
}
