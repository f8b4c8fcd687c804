//! What a bridge weighs, and what its springings and piers hand to the ground under its own weight.

use crate::note::Note;
use serde::{Deserialize, Serialize};

/// Weights and reactions, per metre of the strip between the walls.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Statics {
    /// Width of the barrel [m], for totals.
    pub width: f64,
    /// Weight of every part, in the order of the bridge.
    pub weights: Vec<Weight>,
    /// What stands on the bridge, or may, and is not among these weights.
    pub apart: Vec<Apart>,
    /// What springings and feet of piers carry at rest; empty where the blocks have no elastic state.
    pub reactions: Vec<Reaction>,
    /// What was assumed, in words.
    pub assumptions: Vec<Note>,
}

/// Weight of a part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Weight {
    /// What it is: "span 1, masonry of the rings".
    pub part: String,
    /// Per metre of width [N/m].
    pub force: f64,
}

/// Something that stands on the bridge and loads no strip of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Apart {
    /// What it is: "parapets".
    pub part: String,
    /// Its weight on the whole bridge [N]; none where the file does not say enough.
    pub weight: Option<f64>,
    /// Why it is not in the loads, or what the loads have in its place.
    pub why: String,
}

/// What a joint that hands weight down is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Seat {
    /// A springing on an abutment that is ground itself.
    Springing,
    /// A springing on a pier, or on an abutment of blocks, which has a foot of its own.
    Carried,
    /// The foot of a pier, or of an abutment of blocks.
    Foot,
}

/// What a joint on the ground or on a pier carries.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Reaction {
    /// Where: "span 1 left springing", "foot of pier 1".
    pub place: String,
    /// What joint that is.
    pub seat: Seat,
    /// Upward force on what stands there, per metre of width [N/m].
    pub vertical: f64,
    /// Thrust on what carries it, outwards from the span at springings, to the right at feet of piers [N/m].
    pub horizontal: f64,
    /// Distance of the resultant from the middle of the joint [m], towards the extrados at springings and to the left at feet; none where
    /// several rings spring there.
    pub eccentricity: Option<f64>,
    /// Length of the joint [m]; none where several rings spring there.
    pub depth: Option<f64>,
    /// Pressure over the part of the joint that is centred on the resultant [Pa]: force over depth less twice the eccentricity
    /// (Meyerhof 1953); none where several rings spring there, or the resultant lies outside.
    pub pressure: Option<f64>,
    /// Width across of what bears there over that of the barrel; the pressure is over that width.
    pub spread: f64,
}

/// Narrowest strip that a resultant near the edge of its joint, or beyond it, is taken to bear on [m].
const NARROWEST: f64 = 1e-3;

/// Pressure [Pa] of a force [N/m] over the part of a joint that is centred on the resultant: its depth less twice the eccentricity (G. G.
/// Meyerhof, "The bearing capacity of foundations under eccentric and inclined loads", 3rd Int. Conf. Soil Mech., Zurich 1953). A resultant
/// beyond the edge presses on a millimetre: more than any ground carries.
pub fn pressure(force: f64, depth: f64, eccentricity: f64) -> f64 {
    force / (depth - 2.0 * eccentricity.abs()).max(NARROWEST)
}

impl Statics {
    /// Weight of all parts per metre of width [N/m].
    pub fn total(&self) -> f64 {
        self.weights.iter().map(|weight| weight.force).sum()
    }
}
