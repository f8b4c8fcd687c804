//! What critical joints carry under a vehicle.

use super::case::Case;
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

words! {
    /// What is extreme.
    pub enum Of {
        /// Largest compression.
        LargestThrust = "largest thrust",
        /// Smallest compression.
        SmallestThrust = "smallest thrust",
        /// Thrust farthest outwards.
        OutermostThrust = "outermost thrust",
        /// Thrust farthest inwards.
        InnermostThrust = "innermost thrust",
        /// Largest shear.
        LargestShear = "largest shear",
    }
}

published! {
    /// An extreme and what goes with it.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Extreme {
        /// Of what.
        pub of: Of,
        /// Compression [N/m].
        pub thrust: f64 [kN/m],
        /// Distance of the thrust from the middle of the joint [m], outwards positive; on piers to the left.
        pub eccentricity: f64 [m],
        /// Whether that lies outside the joint: no ring without tension carries it so; joints open and hinges form.
        pub outside: bool as outside_section,
        /// Shear [N/m].
        pub shear: f64 [kN/m],
        /// The case.
        pub case: Case,
    }

    /// A critical joint.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct SectionEnvelope |section| {
        /// Where: "span 1 left springing".
        pub name: String,
        = x: f64 [m] = section.at[0],
        = y: f64 [m] = section.at[1],
        /// Middle of the joint [m].
        pub at: [f64; 2] [kept],
        /// Length of the joint between its contact points [m].
        pub depth: f64 [m],
        /// Extremes over all cases.
        pub extremes: Vec<Extreme>,
    }
}
