//! What helps a bridge and may come and go.

use crate::collapse::Status;
use crate::help::Help;
use crate::sentences::{kilo, notes};

notes! {
    /// What is counted of helps.
    State {
        /// Help that hurts, and is counted: what the bridge comes to without it and with it.
        Counted { helps: Vec<Help>, without: Size, with: Size } => "Without {} the bridge would carry {without} in place of {with}.", Help::all_told(helps);
        NotCounted { helps: Vec<Help> } => "What may come and go is not counted where it helps: {}.", Help::all_told(helps);
    }
}

notes! {
    /// What a state of a bridge comes to, by which states are compared.
    #[derive(Copy)]
    Size {
        /// A load [N/m].
        Load(load: f64) => "{} kN/m", kilo(*load);
        Thickness(share: f64) => "{share:.4} of the given thickness";
        /// The movement of a support [m].
        Movement(movement: f64) => "{:.1} mm", 1e3 * movement;
        NoLoad(status: Status) => "no load that was found ({})", ended(*status);
        /// A factor on the loads of the file, and the load where it is known [N/m].
        LoadFactor(factor: f64, load: Option<f64>) => "a load factor of {}", match load {
            Some(load) => format!("{factor:.4} ({} kN/m)", kilo(*load)),
            None => format!("at most {factor:.4}"),
        };
        NoLoadFactor(status: Status) => "no load factor that was found ({})", ended(*status);
        /// The adequacy factor of a vehicle.
        Adequacy(factor: Option<f64>) => "{}",
            factor.map_or("no adequacy factor".to_owned(), |factor| format!("an adequacy factor of {factor:.3}"));
    }
}

fn ended(status: Status) -> String {
    status.word().replace('-', " ")
}
