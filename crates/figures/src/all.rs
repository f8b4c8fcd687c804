//! Everything that is written beside the result of a collapse analysis.

use crate::raster::RasterError;
use crate::{FIGURES, animation, figure::Figure, png, vtk};
use outcome::picture::Picture;

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

/// All figures that the picture has material for, as SVG: name without extension, and drawing.
pub fn drawings(picture: &Picture) -> Vec<(String, String)> {
    let draw = |figure: &Figure| Some((figure.name.to_owned(), (figure.draw)(picture)?));
    FIGURES.iter().filter_map(draw).collect()
}

/// A drawing as the two files it is written to.
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

/// The ParaView files: one VTU a snapshot for blocks, contacts, particles and their forces, the series, the mechanism, and soil
/// that yields.
pub fn paraview(picture: &Picture) -> Vec<File> {
    let alone = [("mechanism.vtu", vtk::mechanism(picture)), ("soil.vtu", vtk::soil(picture))];
    let mut files: Vec<File> =
        alone.into_iter().filter_map(|(name, text)| text.map(|text| vtk::file(name, text))).collect();
    let moments = vtk::moments(picture);
    type Writer = fn(&Picture, usize) -> Option<String>;
    let kinds: [(&str, Writer); 4] = [
        ("blocks", vtk::blocks),
        ("contacts", vtk::contacts),
        ("particles", vtk::particles),
        ("particle-forces", vtk::particle_forces),
    ];
    for (kind, write) in kinds {
        let texts = moments.iter().enumerate().filter_map(|(k, time)| Some((k, *time, write(picture, k)?)));
        files.extend(vtk::over_time(kind, texts));
    }
    files
}

/// Every file of a collapse analysis, in a fixed order.
pub fn all(picture: &Picture) -> Result<Vec<File>, RasterError> {
    let mut files = written(drawings(picture))?;
    if let Some(bytes) = animation(picture)? {
        files.push(File { name: "animation.png".into(), bytes });
    }
    files.extend(paraview(picture));
    Ok(files)
}
