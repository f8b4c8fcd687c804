//! What a bridge file says of a train or a road vehicle that crosses: its axles, what they roll on, the analysis, and what is measured.

use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
pub use crate::sensor::*;
use crate::train::Train;
use crate::tree::{At, Table};
use crate::values::of_keys;

/// A train or a road vehicle that crosses.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The train; a road vehicle is one of a single vehicle.
    pub train: Train,
    /// How axles reach the fill.
    pub way: Way,
    /// How it crosses, and how that is analysed.
    pub plan: PassagePlan,
    /// What is measured; empty where the file leaves that to the defaults, see [`default_sensors`].
    pub sensors: Vec<Sensor>,
}

/// What axles roll on.
#[derive(Debug, Clone, PartialEq)]
pub enum Way {
    /// Rails, sleepers and ballast.
    Rails(Track),
    /// The surface of a road.
    Road(Wheels),
}

impl Way {
    /// Width of the bridge that carries an axle, where the file says it [m].
    pub fn effective_width(&self) -> Option<f64> {
        match self {
            Way::Rails(track) => track.effective_width,
            Way::Road(wheels) => wheels.effective_width,
        }
    }

    /// Weight on the fill that is there before anything crosses [Pa].
    pub fn dead_load(&self) -> f64 {
        match self {
            Way::Rails(track) => track.dead_load,
            Way::Road(_) => 0.0,
        }
    }
}

of_keys! {
    /// Wheels on the surface of a road.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Wheels {
        pub contact_length: f64 = length("length of the road on which a wheel presses, along the bridge", "0.25 m")
            .between(0.02, 5.0)
            .default("0.25 m"),
        pub effective_width: Option<f64> = length("width of the bridge that carries an axle", "3.1 m")
            .at_least(0.1)
            .optional("1.8 m between the wheels, spread 1:2 to either side through the cover over the crown, not wider than the barrel"),
    }
}

of_keys! {
    /// Rails on sleepers on ballast, on the fill.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Track {
        pub rail_bending_stiffness: f64 =
            bending_stiffness("bending stiffness E I of one rail about its horizontal axis", "4.47 MNm^2")
                .between(1e2, 1e9),
        pub track_modulus: f64 = stress(
            "stiffness of the support of one rail, per metre of rail (force per length and settlement)",
            "30 MPa",
        )
        .between(1e4, 1e12),
        pub sleeper_spacing: f64 = length("distance between the middles of two sleepers", "0.60 m").between(0.1, 5.0),
        pub sleeper_breadth: f64 = length("size of a sleeper along the bridge", "0.25 m").between(0.01, 5.0),
        pub sleeper_length: f64 = length("size of a sleeper across the bridge", "2.75 m").between(0.1, 10.0),
        pub ballast_depth: f64 =
            length("depth of ballast below the sleepers, down to the top of the fill", "0.25 m").between(0.0, 20.0),
        pub ballast_slope: f64 =
            slope("slope at which pressure spreads through the ballast, vertical to horizontal", "2:1")
                .between(0.1, 1000.0),
        pub dead_load: f64 = stress(
            "weight of rails and sleepers on the fill (and of ballast where no [[cover]] layer is ballast); a part of the self-weight",
            "3 kPa",
        )
        .between(0.0, 1e6),
        pub effective_width: Option<f64> = length("width of the bridge that carries an axle", "4.5 m")
            .at_least(0.1)
            .optional("the width of the barrel"),
    }
}

of_keys! {
    /// How a train crosses, and how that is analysed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PassagePlan {
        /// 0 where nothing crosses.
        pub speed: f64 = speed("speed of the train or vehicle", "45 km/h").at_least(0.01) => speed_or_rest,
        pub time_step: f64 = time("time from one position to the next", "0.005 s").at_least(1e-5).default("0.005 s"),
        pub from: Option<f64> =
            length("position of the first axle at the start, from the left springing of the first span", "-10 m")
                .optional("where the mesh begins, or where it ends for one that drives to the left"),
        pub to: Option<f64> =
            length("position of the first axle at the end", "60 m").optional("where the last axle leaves the mesh"),
        pub direction: Heading =
            word::<Heading>("the way in which it drives", "right").default(Heading::Right.word()),
        pub analysis: PassageAnalysis =
            word::<PassageAnalysis>("whether inertia is included", "static").default(PassageAnalysis::Static.word()),
        pub numerical_damping: f64 = number(
            "numerical damping of time integration: 0 is Newmark's average acceleration, larger values are the method \
             of Hilber, Hughes and Taylor",
            "0.05",
        )
        .between(0.0, 1.0 / 3.0)
        .default("0.0"),
        pub kinematics: PassageKinematics =
            word::<PassageKinematics>("whether displacements and rotations are large", "small")
                .default(PassageKinematics::Small.word()),
        pub load_steps: usize =
            count("load steps in which the self-weight is applied", "10").between(1.0, 10_000.0).default("10"),
        pub iterations: usize = count("most iterations of one step", "100").between(1.0, 100_000.0).default("100"),
        pub tolerance: f64 =
            number("out-of-balance force of a step that has converged, relative to the applied forces", "1e-6")
                .between(1e-12, 0.1)
                .default("1e-6"),
        pub path: PassagePath =
            word::<PassagePath>("how positions are solved", "condensed").default(PassagePath::Condensed.word()),
        pub pictures: Vec<f64> =
            lengths("positions of the first axle for which pictures are made", r#"["3.0 m", "9.5 m"]"#)
                .optional("the peak of every channel"),
    } and {
        /// Rayleigh damping, where there is some.
        pub damping: Option<Rayleigh> => damping,
    }
}

/// The speed, which a file must say where something crosses; none where it has no such table.
fn speed_or_rest(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<f64> {
    if table.written().is_some() { table.read(key, findings) } else { Some(0.0) }
}

choice! {
    /// The way in which a train or a vehicle drives.
    pub enum Heading {
        /// from the first span to the last
        Right = "right",
        /// from the last span to the first
        Left = "left",
    }
}

impl Heading {
    /// 1 to the right, -1 to the left.
    pub fn sign(self) -> f64 {
        match self {
            Heading::Right => 1.0,
            Heading::Left => -1.0,
        }
    }
}

choice! {
    /// Whether masses take part.
    pub enum PassageAnalysis {
        /// every position at rest
        Static = "static",
        /// with inertia and damping
        Transient = "transient",
    }
}

/// Rayleigh damping: one damping ratio at two frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rayleigh {
    /// Share of critical damping.
    pub ratio: f64,
    /// The two frequencies [Hz], the lower first.
    pub frequencies: [f64; 2],
}

/// Rayleigh damping: a ratio, and the two frequencies at which it holds.
fn damping(table: &Table<'_>, findings: &mut Findings) -> Option<Option<Rayleigh>> {
    let ratio: Option<Option<f64>> = table.read("damping_ratio", findings);
    let frequencies: Option<Option<At<Vec<f64>>>> = table.read("damping_frequencies", findings);
    if table.has("damping_ratio") != table.has("damping_frequencies") {
        return table.need(if table.has("damping_ratio") { "damping_frequencies" } else { "damping_ratio" }, findings);
    }
    let Some(ratio) = ratio? else { return Some(None) };
    let frequencies = frequencies??;
    match frequencies.value[..] {
        [low, high] if low < high => Some(Some(Rayleigh { ratio, frequencies: [low, high] })),
        _ => findings.refuse(
            "B654",
            frequencies.range,
            "Rayleigh damping takes two frequencies, the lower first",
            "the damping ratio holds at both, is less in between and more outside",
            r#"write damping_frequencies = ["8 Hz", "40 Hz"]: about the lowest, and the highest that matters"#,
        ),
    }
}

choice! {
    /// Whether displacements and rotations are large.
    pub enum PassageKinematics {
        /// equilibrium on the bridge as built
        Small = "small",
        /// equilibrium on the deformed bridge: large displacements and rotations
        Large = "large",
    }
}

choice! {
    /// How positions are solved.
    pub enum PassagePath {
        /// linear parts are condensed once, and only nonlinear parts iterate; the same numbers, much faster
        Condensed = "condensed",
        /// all degrees of freedom at every position
        Plain = "plain",
    }
}

/// Most positions of one passage: an hour's record at the default time step.
pub const MOST_POSITIONS: usize = 720_000;
