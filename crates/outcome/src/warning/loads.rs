//! Loads that were found, or were not, and what is said of their size.

use super::cards::warnings;
use crate::help::Help;
use crate::note::Size;
use crate::sentences::{kilo, listed};

warnings! {
    /// Of loads.
    Loads {
        /// Largest load carried by discrete elements over the limit load.
        ABOVE_LIMIT: AboveLimit { stable [N/m]: f64, limit [N/m]: f64 } => "{}", over(*stable, *limit);
        /// Far below it.
        FAR_BELOW_LIMIT: FarBelowLimit { stable [N/m]: f64, limit [N/m]: f64 } => "{}", over(*stable, *limit);
        ABOVE_LIMIT: AboveLimitOfBlocks { stable [N/m]: f64, limit [N/m]: f64 } =>
            "last stable load {} kN/m, limit load of the same blocks {} kN/m", kilo(*stable), kilo(*limit);
        ABOVE_LIMIT: ElementsAboveLimit { stable [N/m]: f64, limit [N/m]: f64 } =>
            "last stable load {} kN/m, limit load of the same blocks {} kN/m: the smaller is the headline", kilo(*stable), kilo(*limit);
        ABOVE_LIMIT: AboveCrushing { stable [N/m]: f64, limit [N/m]: f64 } =>
            "last stable load {} kN/m, limit load of joints that crush at their edges {} kN/m: the smaller is the headline",
            kilo(*stable), kilo(*limit);
        /// The same of a vehicle, with adequacy factors.
        ABOVE_LIMIT: VehicleAboveLimit { carried: f64, limit: f64 } =>
            "the governing vehicle: discrete elements carry an adequacy factor of {carried:.3}, limit analysis {limit:.3}; the smaller one counts";
        METHODS_APART: MethodsApart =>
            "limit analysis finds no equilibrium of the same blocks under their own weight: no load counts as carried";
        BOUNDS_APART: BoundsApart { lower [N/m]: f64, upper [N/m]: f64 } =>
            "lower bound {:.4} kN/m, upper bound {:.4} kN/m", lower / 1e3, upper / 1e3;
        /// A load step, where it is known, that came to no end.
        STALLED: Stalled { step [N/m]: Option<f64> } => "{} neither came to rest nor collapsed: no collapse load was found",
            step.map_or("a step".to_owned(), |load| format!("the load step of {} kN/m", kilo(load)));
        BROKEN: Broken { block: String, iteration: u64 } => "the run broke off at {block}, iteration {iteration}";
        PUBLISHED_STEP: PublishedStep =>
            "Rouxinol, Providência and Lemos print the last stable step as collapse load of cases like this one";
        CHOSEN: LoadStep { step [N/m]: f64 } => "load_step = {:.3} kN/m, about a twentieth of the limit load", step / 1e3;
        CHOSEN: LoadLimit { limit [N/m]: f64 } => "load_limit = {:.1} kN/m, one and a half times the limit load", limit / 1e3;
        CHOSEN: Increment { increment [m]: f64 } =>
            "increment of the support movement = {increment} m, a share of the shortest span";
        CHOSEN: LargestMovement { limit [m]: f64 } => "limit of the support movement = {limit} m, a share of the shortest span";
        /// A path that broke off at a load that is carried, or found nothing.
        PATHS_BROKEN_OFF: PathBrokenOff { carried [N/m]: Option<f64> } => "{}; try --method dem", match carried {
            Some(load) => format!("the path broke off at {} kN/m, which is carried: more may be, and the load at collapse is not known", kilo(*load)),
            None => "no state under self-weight was found, and the blocks were not seen to fall: nothing is known".to_owned(),
        };
        PATHS_BROKEN_OFF: SelfWeightNotFound => "the state under self-weight was not found with deformable joints: what the bridge carries is at \
                                                 most what rigid blocks carry, and not known";
        PATHS_BROKEN_OFF: FallsOnDeformableJoints =>
            "the bridge does not stand under its own weight on deformable joints: rigid blocks alone carry loads";
        PATHS_BROKEN_OFF: PathsBrokenOff { positions: usize, of: usize } =>
            "at {positions} of {of} positions the path of deformable joints broke off: the last state in balance counts there, and more may be \
             carried";
        /// Positions that were not answered, and the bound of the load factor.
        POSITIONS_NOT_CONVERGED: PositionsOpen { positions: usize, of: usize, at_most: Option<f64> } =>
            "{positions} of {of} positions were not answered{}, and is not known",
            at_most.map_or(String::new(), |most| format!("; the load factor is at most {most:.4}"));
        /// What walls carry of the sum of two strips, and on which share of the width.
        STRIPS_ADDED: StripsAdded { share: f64, width_share: f64 } =>
            "the walls carry {:.0} % of the sum of both strips on {:.0} % of the width", 100.0 * share, 100.0 * width_share;
        /// Help that is left out of a bridge, or of a vehicle on it: what each set of helps would come to.
        HELP_NOT_COUNTED: HelpNotCounted { vehicle: Option<String>, own: Size, left_out: Vec<Help>, with: Vec<(Size, Vec<Help>)> } =>
            "{}{own} without {}, which leads; {}: what may come and go is not counted",
            vehicle.as_ref().map_or(String::new(), |code| format!("{code}: ")), Help::all_told(left_out),
            listed(with.iter().map(|(size, helps)| format!("{size} with {}", Help::all_told(helps))));
    }
}

fn over(stable: f64, limit: f64) -> String {
    let percent = 100.0 * (stable / limit);
    format!(
        "last stable load {} kN/m, limit load of the same blocks {} kN/m ({percent:.0} %)",
        kilo(stable),
        kilo(limit)
    )
}
