//! Figures and ParaView files of an analysis, made from its results alone.
//!
//! Every function is pure: a [`Picture`](outcome::picture::Picture) goes in, text or bytes come out, and the same
//! bytes every time; the caller writes files. Drawings are SVG 160 mm wide; [`png`] turns them into pictures with a
//! font of their own. What there is no material for is `None`.

// Units stand in brackets and are no links.
#![allow(rustdoc::broken_intra_doc_links)]

mod across;
mod all;
mod animation;
mod bar;
mod calibration;
mod chains;
mod chart;
mod colour;
mod cover;
mod defects;
mod dimension;
mod discs;
mod displaced;
mod drawn;
pub mod dxf;
mod edges;
mod elevation;
mod envelope;
mod factor_bars;
mod file;
mod fill_stress;
mod frames;
mod geometry;
mod ground;
mod load_path;
mod mechanism;
mod mesh;
mod near;
mod packing;
mod panels;
mod passage;
mod raster;
mod section;
mod sheet;
mod sketch;
mod sliding;
mod soil;
mod stiffness;
mod stress;
mod study;
mod thrust;
mod ticks;
mod update;
mod validation;
mod vehicles;
pub mod vtk;
mod words;

pub use across::cross_section;
pub use all::{FIGURES, Figure, drawings, paraview};
pub use animation::animation;
pub use calibration::calibration;
pub use chains::force_chains;
pub use discs::left_out;
pub use displaced::displacement;
pub use drawn::bridge_as_drawn;
pub use envelope::{Ordinate, Sweep, envelope, sweep_drawing};
pub use factor_bars::case_factors;
pub use file::{File, PNG_WIDTH, written};
pub use fill_stress::fill_stress;
pub use frames::collapse_frames;
pub use ground::plan;
pub use load_path::load_displacement;
pub use mechanism::mechanism;
pub use mesh::mesh;
pub use packing::packing;
pub use passage::{passage_drawings, passage_paraview, passage_records, passage_ring};
pub use raster::{RasterError, png};
pub use section::section_drawing;
pub use sketch::sketch;
pub use soil::mechanism::soil_mechanism;
pub use soil::pressure::soil_pressure;
pub use soil::stress::soil_stress;
pub use stress::{most_compressive, stress};
pub use study::{heat_map, name_and_unit, response, study_drawings, tornado};
pub use thrust::thrust_line;
pub use update::{UPDATE_FIGURES, update_drawings};
pub use validation::validation;
pub use vehicles::vehicles;
pub use words::four_digits;
