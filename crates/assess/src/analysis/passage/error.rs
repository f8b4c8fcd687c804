//! Why a passage cannot be set up.

use outcome::picture::Point;
use thiserror::Error;

/// A passage that cannot be set up.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PassageError {
    /// The file has no train.
    #[error(
        "nothing crosses the bridge of this file: describe a train with [train], [track] and [passage], or a road vehicle with [vehicle] and [passage]"
    )]
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
    /// The file has no load test.
    #[error(
        "no load stands still on the bridge of this file: describe positions with [load_test] and [[load_test.position]]"
    )]
    NoLoadTest,
    /// Nothing of a position stands on what is modelled.
    #[error(
        "position \"{position}\" of [load_test]: nothing of it stands on the bridge, whose surface reaches from {from:.2} m to {to:.2} m of the left springing: \
         correct `front_axle` or `x`"
    )]
    BesideBridge {
        /// The position.
        position: String,
        /// Where the surface begins [m].
        from: f64,
        /// Where it ends [m].
        to: f64,
    },
    /// A vehicle that the library does not have, or that cannot stand here.
    #[error("position \"{position}\" of [load_test]: {why}")]
    NoSuchVehicle {
        /// The position.
        position: String,
        /// Why not, and what to write.
        why: String,
    },
    /// Nothing is where a sensor is to sit.
    #[error("sensor \"{name}\" lies at x = {:.3} m, y = {:.3} m, outside of the bridge and its fill", at[0], at[1])]
    Outside {
        /// The sensor.
        name: String,
        /// Where [m].
        at: Point,
    },
    /// A sensor needs the ring.
    #[error("sensor \"{name}\" sits on a stone or a joint: place it by `span` and `place`, or by `at`")]
    NeedsRing {
        /// The sensor.
        name: String,
    },
    /// A gauge is longer than its stone.
    #[error(
        "sensor \"{name}\": a gauge of {:.0} mm does not fit on a stone of {:.0} mm, and must not cross a joint", 1e3 * gauge, 1e3 * stone
    )]
    LongGauge {
        /// The sensor.
        name: String,
        /// Gauge length [m].
        gauge: f64,
        /// Length of the stone's face [m].
        stone: f64,
    },
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
