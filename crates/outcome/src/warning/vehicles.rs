//! Vehicles that move: their sources, their factors, and what is left out.

use super::cards::warnings;
use crate::note::Sideways;
use crate::sentences::{listed, notes};
use findings::words::in_rows;
use rules::{Acting, Source, Ways};
use serde::{Deserialize, Serialize};

warnings! {
    /// Of vehicles.
    Vehicles {
        RECALLED_FACTOR: Recalled { rule: String, factors: Vec<RecalledFactor> } =>
            "factors of rule \"{rule}\" that must be confirmed in their source: {}", listed(factors);
        RULE_FOR_OTHER_WAYS: OtherWays { rule: String, vehicle: String } => "rule \"{rule}\" is not made for vehicle \"{vehicle}\"";
        POSITIONS_NOT_CONVERGED: PositionsOpen { vehicles: Vec<OpenPositions> } =>
            "positions were not answered, and adequacy factors are not known: of {}", listed(vehicles);
        PATHS_BROKEN_OFF: PathsBrokenOff { vehicles: Vec<(String, BrokenPath)> } =>
            "on deformable joints: {}. The last state in balance counts where a path broke off, and more may be carried",
            vehicles.iter().map(|(code, path)| format!("{code}: {path}")).collect::<Vec<_>>().join("; ");
        /// Vehicles that would not be met, with their adequacy factors, if discrete elements took as large a share off them.
        NEAR_THE_LIMIT: NearTheLimit { governing: String, share: f64, vehicles: Vec<(String, f64)> } =>
            "discrete elements carry {share:.2} of the limit load of {governing}; with that share these would not be met: {}",
            listed(vehicles.iter().map(|(code, adequacy)| format!("{code} ({adequacy:.2}, then {:.2})", adequacy * share)));
        /// Vehicles whose standard was not read, by their sources.
        VEHICLE_NOT_READ: NotRead { sources: Vec<(Vec<String>, Source)> } =>
            "axles and distances that were not read in their standard: {}",
            sources.iter().map(|(codes, source)| format!("{} {}", in_rows(codes), doubtful(source))).collect::<Vec<_>>().join(". ");
        DOUBTFUL_FILE: DoubtfulFile { values: Vec<String> } =>
            "doubtful values in files of vehicles or of the rule: {}", listed(values);
        /// Load models that are not made for spans as long, each with the reason.
        SPAN_TOO_LONG: SpanTooLong { models: Vec<TooLong> } =>
            "spans of this bridge are too long for load models of the rule: {}", models.iter().map(TooLong::to_string).collect::<Vec<_>>().join("; ");
        ACROSS_ASSUMED: AcrossAssumed { ways: Vec<Lanes> } =>
            "the file does not say where vehicles may stand across the bridge: {}",
            ways.iter().map(Lanes::to_string).collect::<Vec<_>>().join("; ");
        NO_LONGITUDINAL: NoLongitudinal { braking: Braking, sideways: Sideways } => "loads stand vertically: {braking}; {sideways}";
    }
}

/// How a source that was not read is named: "(recalled): standard; note".
pub(super) fn doubtful(source: &Source) -> String {
    let note = if source.note.is_empty() { String::new() } else { format!("; {}", source.note) };
    format!("({}): {}{note}", source.confidence.word(), source.text)
}

notes! {
    /// A factor that is recalled, and the load models on which it acts.
    RecalledFactor {
        /// One of the rule, by its name.
        Named(name: String, factor: f64) => "{name} {factor}";
        LiveLoad(factor: f64, models: String) => "live load {factor} ({models})";
        /// On what motion adds to loads of models.
        Impact(acting: Box<Acting>, models: String) => "impact {} ({models})", acting.told();
        /// On these vehicles in the lanes beside models.
        Beside(share: f64, vehicles: Vec<String>, models: String) =>
            "{share} of {} in the lanes beside ({models})", listed(vehicles);
    }
}

/// A load model that is not made for spans as long.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TooLong {
    /// Its code.
    pub model: String,
    /// Longest span [m].
    pub longest: f64,
    /// Why no longer.
    pub reason: String,
}

impl std::fmt::Display for TooLong {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(to, "{} (spans up to {} m: {})", self.model, self.longest, self.reason)
    }
}

/// Positions of a vehicle that were not answered.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OpenPositions {
    /// The vehicle.
    pub code: String,
    /// How many.
    pub open: usize,
    /// Of how many.
    pub of: usize,
    /// Its adequacy factor at most.
    pub at_most: Option<f64>,
}

impl std::fmt::Display for OpenPositions {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let bound = self.at_most.map_or(String::new(), |most| format!(", its factor at most {most:.3}"));
        write!(to, "{} ({} of {}{bound})", self.code, self.open, self.of)
    }
}

notes! {
    /// What is left open of a vehicle on deformable joints.
    BrokenPath {
        Falls => "the blocks fall under their own weight";
        NotFound => "no state under self-weight was found";
        Positions { open: usize, of: usize } => "at {open} of {of} positions the path broke off";
    }
}

/// What is assumed of vehicles across the bridge; nothing is told of what the file gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Lanes {
    /// On what they drive.
    pub ways: Ways,
    /// How many abreast, and how far apart [m], where the file does not say so.
    pub abreast: Option<(usize, f64)>,
    /// Whether the file gives no distance from the edge.
    pub open_edge: bool,
}

impl std::fmt::Display for Lanes {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (what, abreast) = match self.ways {
            Ways::Road => ("vehicles on a road", "abreast"),
            Ways::Rail => ("trains", "on tracks"),
        };
        let lanes = self.abreast.map(|(count, apart)| match count {
            1 => format!("{what}: one at a time"),
            _ => format!("{what}: up to {count} {abreast}, {apart} m apart"),
        });
        let edge = self.open_edge.then(|| "none nearer to the edge than its load spreads".to_owned());
        to.write_str(&listed(lanes.into_iter().chain(edge)))
    }
}

notes! {
    /// Why no horizontal forces act.
    Braking {
        /// The file says so, with its reason where it gives one.
        Written(reason: Option<String>) => "the file writes braking = 0{}",
            reason.as_ref().map_or(String::new(), |reason| format!(" ({reason})"));
        /// Trains without a word of it.
        OfTrains => "braking and traction of trains are left out";
        /// Vehicles on roads without a word of it.
        OfRoad => "braking is left out";
    }
}
