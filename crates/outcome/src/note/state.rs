//! What helps a bridge and may come and go.

use crate::collapse::Status;
use crate::help::Help;
use crate::sentences::{kilo, notes};
use serde::{Deserialize, Serialize};

notes! {
    /// What is counted of helps.
    State {
        /// Help that hurts, and is counted: what the bridge comes to without it and with it.
        Counted { helps: Vec<Help>, without: Size, with: Size } => "Without {} the bridge would carry {without} in place of {with}.", Help::all_told(helps);
        NotCounted { helps: Vec<Help> } => "What may come and go is not counted where it helps: {}.", Help::all_told(helps);
    }
}

/// What a state of a bridge comes to, by which states are compared.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Size {
    /// A load [N/m].
    Load(f64),
    /// A share of the given thickness.
    Thickness(f64),
    /// The movement of a support [m].
    Movement(f64),
    /// No load, and how that ended.
    NoLoad(Status),
    /// A factor on the loads of the file, and the load where it is known [N/m].
    LoadFactor(f64, Option<f64>),
    /// No such factor, and how that ended.
    NoLoadFactor(Status),
    /// The adequacy factor of a vehicle.
    Adequacy(Option<f64>),
}

impl std::fmt::Display for Size {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ended = |status: &Status| status.word().replace('-', " ");
        match self {
            Size::Load(load) => write!(to, "{} kN/m", kilo(*load)),
            Size::Thickness(share) => write!(to, "{share:.4} of the given thickness"),
            Size::Movement(movement) => write!(to, "{:.1} mm", 1e3 * movement),
            Size::NoLoad(status) => write!(to, "no load that was found ({})", ended(status)),
            Size::LoadFactor(factor, Some(load)) => write!(to, "a load factor of {factor:.4} ({} kN/m)", kilo(*load)),
            Size::LoadFactor(factor, None) => write!(to, "a load factor of at most {factor:.4}"),
            Size::NoLoadFactor(status) => write!(to, "no load factor that was found ({})", ended(status)),
            Size::Adequacy(Some(factor)) => write!(to, "an adequacy factor of {factor:.3}"),
            Size::Adequacy(None) => write!(to, "no adequacy factor"),
        }
    }
}
