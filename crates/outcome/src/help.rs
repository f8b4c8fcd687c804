//! What may help a bridge and may come and go: no result counts it, and what it would add stands beside the result.

use crate::collapse::Status;
use crate::published::Object;
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

words! {
    /// What a file describes, may help the bridge, and may be gone tomorrow.
    pub enum Help {
        /// Water in the pores of the fill: its weight, and its pressure on both haunches.
        Water = "water in the fill",
        /// A support that moved before the loads came.
        Movement = "past movement of a support",
        /// Fill that presses on backs that move against it.
        FillPressure = "fill pressure",
        /// Walls higher than the road.
        Parapets = "parapets",
        /// Stone that has come off, fallen out or slid down: weight that is gone where it did harm, a shape that bears more.
        LostStone = "stone that is lost or has slid",
        /// Tensile strength of joints, and of soil and backing that are a continuum.
        Tension = "tension of joints",
        /// Cohesion of joints.
        Cohesion = "cohesion of joints",
    }
}

impl Help {
    /// Whether it is strength: more of it never lowers a load.
    pub fn is_strength(self) -> bool {
        matches!(self, Help::Tension | Help::Cohesion)
    }

    /// "tension of joints and water in the fill".
    pub fn all_told(helps: &[Help]) -> String {
        match helps {
            [] => String::new(),
            [one] => one.word().to_owned(),
            [first @ .., last] => {
                let first: Vec<&str> = first.iter().map(|help| help.word()).collect();
                format!("{} and {last}", first.join(", "))
            }
        }
    }
}

published! {
    /// What the same bridge comes to with more help than the result counts; what was not sought is none.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct WithHelp |with| {
        /// What helps, in words.
        = what: String = Help::all_told(&with.helps),
        /// What helps.
        pub helps: Vec<Help>,
        /// How its analysis ended.
        pub status: Status,
        /// Largest load carried [N/m].
        pub last_stable_load?: Option<f64> [kN/m],
        /// Its headline: the smaller of the methods [N/m].
        pub headline?: Option<f64> [kN/m],
        /// Factor on the loads of the file, or adequacy factor of a vehicle.
        pub factor?: Option<f64>,
        /// Least thickness that stands, as a share of the given one.
        pub thickness_factor?: Option<f64> as minimum_thickness_factor,
        /// Last support movement at which the bridge came to rest [m].
        pub movement?: Option<f64> [m] as last_stable_movement,
    }

    /// What a result does not count. Both lists are empty where all that the file describes changes nothing, or lowers the result.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct NotCounted {
        /// What may help the bridge and may come and go: it is not counted.
        pub left_out: Vec<Help> as help_left_out,
        /// What it would add.
        pub with_help: Vec<WithHelp>,
    }
}

impl NotCounted {
    /// As others read it; none where nothing is left out.
    pub fn told(&self) -> Option<Object> {
        (!self.left_out.is_empty() || !self.with_help.is_empty()).then(|| self.object())
    }

    /// What the bridge comes to with all that is left out, where that is more.
    pub fn with_all(&self) -> Option<&WithHelp> {
        self.with_help.iter().max_by_key(|with| with.helps.len())
    }

    /// What the bridge comes to with everything that the file describes of these, where that is more.
    pub fn with(&self, help: Help) -> Option<&WithHelp> {
        self.with_help.iter().filter(|with| with.helps.contains(&help)).max_by_key(|with| with.helps.len())
    }
}
