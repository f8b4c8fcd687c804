//! Why a passage cannot be set up.

use super::sensors::SensorError;
use thiserror::Error;

/// A passage that cannot be set up.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PassageError {
    /// The file has no train.
    #[error("the file has no train that crosses: describe it with [train], [track] and [passage]")]
    NoTrain,
    /// The vehicles of a file have not been read.
    #[error("the vehicles of {0} have not been read")]
    UnreadTrain(String),
    /// Too many positions.
    #[error(
        "the train stands at {count} positions, more than {most}: give a larger `time_step` in [passage], or `from` and `to`"
    )]
    TooManyPositions {
        /// How many.
        count: usize,
        /// Most.
        most: usize,
    },
    /// The positions leave nothing to do.
    #[error("the first axle starts at {from:.3} m and ends at {to:.3} m: give a larger `to` in [passage]")]
    NoWay {
        /// Start [m].
        from: f64,
        /// End [m].
        to: f64,
    },
    /// A sensor finds no place.
    #[error(transparent)]
    Sensor(#[from] SensorError),
    /// The bridge has no mesh.
    #[error(transparent)]
    Mesh(#[from] structure::discretise::mesh::MeshError),
    /// Values that the finite element model needs.
    #[error("the finite element model needs {0}")]
    Missing(String),
    /// The mesh and its materials make no model.
    #[error(transparent)]
    Model(mechanics::fem::ModelError),
    /// The stiffness of the untouched bridge has no inverse.
    #[error(transparent)]
    Factor(#[from] mechanics::fem::FactorError),
    /// A stress is no sum of displacements.
    #[error("slices know displacements, strains and openings, no stresses: leave sensors of stress out")]
    StressInSlices,
    /// The condensed path.
    #[error(transparent)]
    Condensed(mechanics::fem::condensed::CondensedError),
}
