//! Everything that is written beside the result of a collapse analysis: figures, and files for ParaView.

use crate::animation::animation;
use crate::figure::Figure;
use crate::file::{File, written};
use crate::raster::RasterError;
use crate::{
    chains, displaced, drawn, fill_stress, frames, load_path, mechanism, packing, soil, stiffness, stress, thrust, vtk,
};
use outcome::picture::Picture;

/// Every figure of a collapse, in the order of its files.
pub const FIGURES: &[Figure] = &[
    drawn::FIGURE,
    mechanism::FIGURE,
    thrust::FIGURE,
    stress::FIGURE,
    load_path::FIGURE,
    stiffness::FIGURE,
    frames::FIGURE,
    packing::FIGURE,
    chains::FIGURE,
    displaced::FIGURE,
    fill_stress::FIGURE,
    soil::mechanism::FIGURE,
    soil::stress::FIGURE,
    soil::pressure::FIGURE,
];

/// All figures that the picture has material for, as SVG: name without extension, and drawing.
pub fn drawings(picture: &Picture) -> Vec<(String, String)> {
    let draw = |figure: &Figure| Some((figure.name.to_owned(), (figure.draw)(picture)?));
    FIGURES.iter().filter_map(draw).collect()
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
///
/// # Errors
/// A drawing of which no PNG can be made.
pub fn all(picture: &Picture) -> Result<Vec<File>, RasterError> {
    let mut files = written(drawings(picture))?;
    if let Some(bytes) = animation(picture)? {
        files.push(File { name: "animation.png".into(), bytes });
    }
    files.extend(paraview(picture));
    Ok(files)
}
