//! What a bridge file says of a train that crosses: the train, the track under it, the analysis, and what is measured.

use crate::train::Train;
use serde::{Deserialize, Serialize};

/// A train that crosses.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The train.
    pub train: Train,
    /// How axles reach the fill.
    pub track: Track,
    /// How it crosses, and how that is analysed.
    pub plan: PassagePlan,
    /// What is measured; empty where the file leaves that to the defaults, see [`default_sensors`].
    pub sensors: Vec<Sensor>,
}

/// Rails on sleepers on ballast, on the fill.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// Bending stiffness of one rail about its horizontal axis [N m^2].
    pub rail_bending_stiffness: f64,
    /// Stiffness of what bears one rail, per metre of rail [N/m per m].
    pub track_modulus: f64,
    /// Distance between the middles of sleepers [m].
    pub sleeper_spacing: f64,
    /// Size of a sleeper along the bridge [m].
    pub sleeper_breadth: f64,
    /// Size of a sleeper across the bridge [m].
    pub sleeper_length: f64,
    /// Depth of ballast below the sleepers, down to the top of the fill [m].
    pub ballast_depth: f64,
    /// Slope at which pressure spreads through it, vertical to one horizontal.
    pub ballast_slope: f64,
    /// Weight of rails and sleepers on the fill [Pa]; that of ballast is part of it only where no layer of the cover is ballast.
    pub dead_load: f64,
    /// Width of the bridge that carries an axle [m]; the barrel's where the file gives none.
    pub effective_width: Option<f64>,
}

/// How a train crosses, and how that is analysed.
#[derive(Debug, Clone, PartialEq)]
pub struct PassagePlan {
    /// Speed [m/s].
    pub speed: f64,
    /// Time from one position to the next [s].
    pub time_step: f64,
    /// Where the first axle stands at the start [m], from the left springing of the first span; where the mesh begins if the
    /// file does not say.
    pub from: Option<f64>,
    /// Where it stands at the end [m]; where the last axle has left the mesh if the file does not say.
    pub to: Option<f64>,
    /// Whether masses take part.
    pub analysis: PassageAnalysis,
    /// Rayleigh damping, where there is some.
    pub damping: Option<Rayleigh>,
    /// Share of numerical damping in time integration: 0 is Newmark's average acceleration, up to 1/3 Hilber, Hughes and
    /// Taylor's method.
    pub numerical_damping: f64,
    /// Whether displacements and rotations are large.
    pub kinematics: PassageKinematics,
    /// Load steps of the self-weight.
    pub load_steps: usize,
    /// Most iterations of one load step.
    pub iterations: usize,
    /// Out-of-balance force at which a step has converged, relative to the applied forces.
    pub tolerance: f64,
    /// How positions are solved.
    pub path: PassagePath,
    /// Positions of the first axle [m] for which pictures are made; the peaks of the channels where the file gives none.
    pub pictures: Vec<f64>,
}

/// Whether masses take part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PassageAnalysis {
    /// Every position at rest.
    Static,
    /// With inertia and damping.
    Transient,
}

/// Rayleigh damping: one damping ratio at two frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rayleigh {
    /// Share of critical damping.
    pub ratio: f64,
    /// The two frequencies [Hz], the lower first.
    pub frequencies: [f64; 2],
}

/// Whether displacements and rotations are large.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PassageKinematics {
    /// Equilibrium on the bridge as built.
    Small,
    /// Equilibrium on the deformed bridge.
    Large,
}

/// How positions are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PassagePath {
    /// Linear zones condensed to what iterates.
    Condensed,
    /// All degrees of freedom at every position.
    Plain,
}

/// A sensor.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    /// Name of its channel.
    pub name: String,
    /// What it measures.
    pub kind: SensorKind,
    /// Where.
    pub place: Place,
    /// On which face of the ring.
    pub face: Face,
}

/// What a sensor measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SensorKind {
    /// Displacement [m].
    Displacement(Direction),
    /// Mean strain of one stone along the ring over a gauge length [m]; tension positive. Never across a joint.
    Strain {
        /// Gauge length [m].
        gauge_length: f64,
    },
    /// Opening of a joint at a face [m]; apart is positive.
    JointOpening,
    /// Sliding of a joint at a face [m]; positive where the stone on the right moves outwards, from intrados to extrados.
    JointSliding,
    /// Stress along the ring [Pa]; tension positive.
    Stress,
}

/// Direction of a displacement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Up is positive.
    Vertical,
    /// To the right is positive.
    Horizontal,
    /// Away from the middle of its span is positive.
    Lateral,
}

/// Where a sensor sits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// At a share of a span's length between its springings: 0 left, 0.5 crown, 1 right.
    Span {
        /// The span, counted from 0 on the left.
        span: usize,
        /// The share.
        share: f64,
    },
    /// At a point [m], from the left springing of the first span.
    Point([f64; 2]),
}

/// A face of the ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Face {
    /// The lower one.
    #[default]
    Intrados,
    /// The upper one.
    Extrados,
}

/// Most positions of one passage: an hour's record at the default time step.
pub const MOST_POSITIONS: usize = 720_000;

/// Gauge length of the railway paper's strain gauges [m], section 3.2.
pub const GAUGE_LENGTH: f64 = 0.120;

/// The channels of the railway paper's Table 1, on the first span: vertical displacement of the crown, lateral displacement of
/// the springings, strain on the stones at the same three places. The first span's left springing rests on the abutment,
/// its right springing on a pier where there is another span.
pub fn default_sensors(spans: usize) -> Vec<Sensor> {
    let right = if spans > 1 { "pier springing" } else { "right springing" };
    let left = if spans > 1 { "abutment springing" } else { "left springing" };
    let places = [("crown", 0.5), (right, 1.0), (left, 0.0)];
    let sensor =
        |name: String, kind, share| Sensor { name, kind, place: Place::Span { span: 0, share }, face: Face::Intrados };
    let displacements = places.into_iter().map(|(name, share)| {
        let direction = if share == 0.5 { Direction::Vertical } else { Direction::Lateral };
        sensor(format!("{name} displacement"), SensorKind::Displacement(direction), share)
    });
    let strains = places.into_iter().map(|(name, share)| {
        sensor(format!("{name} strain"), SensorKind::Strain { gauge_length: GAUGE_LENGTH }, share)
    });
    displacements.chain(strains).collect()
}
