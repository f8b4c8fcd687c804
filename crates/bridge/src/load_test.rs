//! A load test: positions in which loads stand still on the bridge, and what sensors read in each.

mod table;

use crate::cards::*;
use crate::choice::choice;
use crate::passage::{Heading, PassagePlan, Way};
use crate::quantity::Dimension;
use crate::sensor::{Sensor, SensorKind};
use crate::train::Train;
use crate::values::of_keys;

/// Loads at rest on the bridge, one position after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadTest {
    /// The vehicle or the train of the file, which stands where a position names no other.
    pub train: Option<Train>,
    /// What vehicles stand on, where the file says it.
    pub way: Option<Way>,
    /// How equilibrium is found: as for a passage, at rest.
    pub plan: PassagePlan,
    /// What is measured; never empty.
    pub sensors: Vec<Sensor>,
    /// The positions, in the order of the test.
    pub positions: Vec<Position>,
    /// From which state each position is reached.
    pub sequence: Sequence,
    /// What was read.
    pub readings: Readings,
}

/// A position of the load test: all that stands on the bridge at the same time.
#[derive(Debug, Clone, PartialEq)]
pub struct Position {
    /// What it is called.
    pub name: String,
    /// Vehicles.
    pub vehicles: Vec<Standing>,
    /// Forces of jacks, beams or weights.
    pub forces: Vec<Patch>,
}

of_keys! {
    /// A vehicle that stands on the bridge.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Standing {
        pub vehicle ("name"): Option<String> =
            text("a vehicle of the library, as `extrados vehicles` lists them", "cs454-rfv").optional("that of [vehicle] or [train]"),
        pub front_axle: f64 = length("where its first axle stands, from the left springing of the first span", "3.2 m"),
        pub direction: Heading = word::<Heading>("the way in which it faces", "left").default(Heading::Right.word()),
    }
}

/// An even pressure on a part of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Its middle, from the left springing of the first span [m].
    pub x: f64,
    /// What it presses with.
    pub force: PatchForce,
    /// Its length along the bridge [m].
    pub length: f64,
    /// Its width across the bridge [m]; the barrel's where there is none.
    pub width: Option<f64>,
}

/// The force of a patch, downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PatchForce {
    /// Of the whole patch [N].
    Whole(f64),
    /// Per metre of the width that carries it [N/m].
    PerWidth(f64),
}

choice! {
    /// From which state a position is reached.
    pub enum Sequence {
        /// each from the unloaded bridge, as if it were the only one
        Independent = "independent",
        /// in the order of the file, the bridge unloaded after each: what yields or slides stays so in all readings that follow
        InOrder = "in-order",
    }
}

/// What sensors read in the positions, as changes from the reading of the unloaded bridge before the first position.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Readings {
    /// A table of readings, relative to the bridge file; `values` are empty until somebody reads it.
    pub file: Option<String>,
    /// What the table says of itself where it was computed and not measured.
    pub synthetic: Option<String>,
    /// By sensor and position [SI]; none where nothing was read. No row, or as many as sensors.
    pub values: Vec<Vec<Option<f64>>>,
    /// Standard deviation of one reading by sensor [SI], where it is stated.
    pub uncertainty: Vec<Option<f64>>,
}

impl Readings {
    /// Whether there is any.
    pub fn any(&self) -> bool {
        self.values.iter().flatten().any(Option::is_some)
    }

    /// Places and values of what a sensor read [SI].
    pub fn of(&self, sensor: usize) -> impl Iterator<Item = (usize, f64)> {
        self.values.get(sensor).into_iter().flatten().enumerate().filter_map(|(k, value)| Some((k, (*value)?)))
    }
}

/// What a reading of a sensor measures.
pub(crate) fn measured(sensor: &Sensor) -> Dimension {
    match sensor.kind {
        SensorKind::Displacement(_) | SensorKind::JointOpening | SensorKind::JointSliding => Dimension::Length,
        SensorKind::Strain { .. } => Dimension::Strain,
        SensorKind::Stress => Dimension::Stress,
    }
}
