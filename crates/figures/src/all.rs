//! Everything that is written beside the result of a collapse analysis: figures, and files for ParaView.

use crate::file::File;
use crate::stiffness::over_stiffness;
use crate::stress::last_stress;
use crate::{
    bridge_as_drawn, collapse_frames, displacement, fill_stress, force_chains, load_displacement, mechanism, packing,
    soil_mechanism, soil_pressure, soil_stress, thrust_line, vtk,
};
use outcome::picture::Picture;

/// A kind of figure of a collapse.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Its name, which its files have.
    pub name: &'static str,
    /// What is said under it.
    pub caption: &'static str,
    /// Draws it as SVG; none where the picture has no material for it.
    pub draw: fn(&Picture) -> Option<String>,
}

const fn figure(name: &'static str, caption: &'static str, draw: fn(&Picture) -> Option<String>) -> Figure {
    Figure { name, caption, draw }
}

/// Every figure of a collapse, in the order of its files.
pub const FIGURES: &[Figure] = &[
    figure("bridge", "The bridge as its file describes it.", |picture| Some(bridge_as_drawn(picture))),
    figure("mechanism", "Mechanism at collapse.", mechanism),
    figure("thrust-line", "Thrust line at collapse.", thrust_line),
    figure("stress", "Largest compression in every block, at the last stable load.", last_stress),
    figure("load-displacement", "Load over displacement of the watched point.", load_displacement),
    figure("stiffness", "Load over the stiffness of the joints; rigid blocks are its asymptote.", over_stiffness),
    figure("collapse", "The bridge on its way to collapse.", collapse_frames),
    figure("packing", "Particles as packed.", packing),
    figure("force-chains", "Forces between particles.", force_chains),
    figure("displacement", "Displacement of particles and blocks.", displacement),
    figure("fill-stress", "Mean stress in the fill.", fill_stress),
    figure("soil-mechanism", "Mechanism of blocks and fill, with the power that the fill dissipates.", soil_mechanism),
    figure("soil-stress", "Principal stresses in the fill, and the thrust line.", soil_stress),
    figure("soil-pressure", "Pressure of the fill on the ring.", soil_pressure),
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
