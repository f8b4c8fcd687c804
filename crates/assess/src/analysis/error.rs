//! Why an analysis cannot be set up.

use super::engine::can::Cannot;
use super::passage::PassageError;
use mechanics::blocks::ModelError;
use mechanics::dem::PackingError;
use structure::discretise::DiscretiseError;
use thiserror::Error;

/// An analysis that cannot be set up. What the file must change is in the words.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum AnalysisError {
    /// The bridge cannot be cut into blocks.
    #[error(transparent)]
    Discretise(#[from] DiscretiseError),
    /// The blocks cannot be analysed.
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error(
        "discrete elements need the normal and the shear stiffness of the {joint}, and so do equilibrium paths where [masonry] has no elastic_modulus: give them in the file"
    )]
    NoStiffness { joint: &'static str },
    #[error("loads that stand on loading blocks cannot be moved over the bridge: write through = \"cover\"")]
    MovedBlock,
    /// The fill cannot be packed.
    #[error(transparent)]
    Packing(#[from] PackingError),
    /// The continuum has no mesh.
    #[error(transparent)]
    Continuum(#[from] mechanics::limit::continuum::MeshError),
    #[error("no layer of the file is modelled as a continuum: write as = \"continuum\" in a [[cover]]")]
    NoContinuum,
    #[error("no layer of the file is modelled as particles: write as = \"particles\" in a [[cover]]")]
    NoParticles,
    #[error("calibration packs the fill anew for every seed: remove `file` from [particles]")]
    SavedPacking,
    #[error("the fill packed with seed {seed} does not come to rest on its ring: look at it with extrados collapse")]
    FillNotAtRest {
        /// Seed of the packing.
        seed: u64,
    },
    #[error(
        "no square of {size} m fits into the fill between rings, end walls and road: write a smaller sample_size in [calibration]"
    )]
    NoSample {
        /// Side of the square [m].
        size: f64,
    },
    #[error(
        "a square of {size} m holds too few particles of {diameter:.3} m: write a sample_size of {:.2} m or more in [calibration]",
        LEAST_SAMPLE * .diameter
    )]
    SmallSample {
        /// Side of the square [m].
        size: f64,
        /// Mean diameter of the particles [m].
        diameter: f64,
    },
    #[error(
        "{astray} of the {count} particles of the saved packing lie outside the region of the fill, the first at \
         x = {:.3} m, y = {:.3} m: the packing is of another bridge", first[0], first[1]
    )]
    ForeignPacking {
        /// Particles outside.
        astray: usize,
        /// All particles.
        count: usize,
        /// Centre of the first one outside [m].
        first: [f64; 2],
    },
    /// A train's passage cannot be set up.
    #[error(transparent)]
    Passage(#[from] PassageError),
    /// What the method or the question does not know.
    #[error(transparent)]
    Cannot(#[from] Cannot),
    #[error("the mesh of the ring cannot be analysed: {0}")]
    Elements(mechanics::fem::ModelError),
    #[error("the equations of the ring cannot be set up: {0}")]
    Equations(mechanics::fem::FactorError),
    /// A vehicle or a rule of a sweep is not known.
    #[error(transparent)]
    Vehicles(#[from] crate::vehicles::Refused),
    #[error(
        "no load of the file reaches the rings: there is nothing to increase; describe one with [[load]], or move the vehicles of a [sweep] over the bridge (--sweep)"
    )]
    NoLoad,
    #[error("the plan gives no {what}: {why}")]
    Missing {
        /// Which entry.
        what: &'static str,
        /// Why it cannot be chosen.
        why: &'static str,
    },
}

/// Least side of a sample of fill in mean diameters of its particles: with fewer side by side each touches a wall.
pub(crate) const LEAST_SAMPLE: f64 = 3.0;
