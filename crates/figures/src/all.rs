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

/// The ParaView files: one VTU a snapshot for blocks, contacts, particles and their forces, the series, the mechanism, and soil
/// that yields.
pub fn paraview(picture: &Picture) -> Vec<File> {
    let mut files = Vec::new();
    let mut put = |name: String, text: String| {
        files.push(File { name: format!("paraview/{name}"), bytes: text.into_bytes() });
    };
    if let Some(text) = vtk::mechanism(picture) {
        put("mechanism.vtu".into(), text);
    }
    if let Some(text) = vtk::soil(picture) {
        put("soil.vtu".into(), text);
    }
    let moments = vtk::moments(picture);
    type Writer = fn(&Picture, usize) -> Option<String>;
    let kinds: [(&str, Writer); 4] = [
        ("blocks", vtk::blocks),
        ("contacts", vtk::contacts),
        ("particles", vtk::particles),
        ("particle-forces", vtk::particle_forces),
    ];
    for (kind, write) in kinds {
        let mut listed = Vec::new();
        for (k, &moment) in moments.iter().enumerate() {
            let Some(text) = write(picture, k) else { continue };
            let name = format!("{kind}-{k:04}.vtu");
            listed.push((moment, name.clone()));
            put(name, text);
        }
        if !listed.is_empty() {
            put(format!("{kind}.pvd"), vtk::series(&listed));
        }
    }
    files
}

/// Every file of a collapse analysis, in a fixed order.
pub fn all(picture: &Picture) -> Result<Vec<File>, RasterError> {
    let mut files = Vec::new();
    for (name, svg) in drawings(picture) {
        files.extend(both(&name, &svg)?);
    }
    if let Some(bytes) = animation(picture)? {
        files.push(File { name: "animation.png".into(), bytes });
    }
    files.extend(paraview(picture));
    Ok(files)
}
