//! What the stages of an assessment leave behind: plain numbers with their units in their names. Checks and reports read
//! nothing else, and a finished stage is kept in this form.

use crate::collapse::{Collapse, Permissible, Status};
use crate::help::NotCounted;
use crate::note::Note;
use crate::passage::PassageStatus;
use crate::vehicles::{Graded, PermissibleFactor};
use crate::warning::Warning;
use crate::words::words;
use bridge::passage::Face;
use rules::{ChangedFactor, Confidence, Requirement};
use serde::{Deserialize, Serialize};

words! {
    /// Places of a ring that checks look at.
    #[derive(Default)]
    pub enum RingSection {
        /// A crown.
        #[default]
        Crown = "crown",
        /// A springing on an abutment.
        Abutment = "abutment",
        /// A springing on a pier.
        Pier = "pier",
    }

    /// What is watched at a place.
    #[derive(Default)]
    pub enum Watched {
        /// Displacement upwards [mm].
        #[default]
        Deflection = "deflection",
        /// Stress along the ring [MPa], tension positive.
        Stress = "stress",
    }

    /// Coefficients of dynamic augment by which a live load is increased.
    #[derive(Default)]
    pub enum Reading {
        /// As the cushion of fill lessens it.
        #[default]
        Design = "design",
        /// In full.
        Total = "total",
    }
}

/// The train in service: what the bridge answers to each load.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ServiceFacts {
    /// Name of the train.
    pub train: String,
    /// Dynamic augment.
    pub augment: AugmentFacts,
    /// One entry a load.
    pub loads: Vec<ServiceLoadFacts>,
    /// What the analysis assumes.
    pub assumptions: Vec<Note>,
    /// What a reader should look at.
    pub warnings: Vec<Warning>,
}

/// Coefficients of dynamic augment and where they are from.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct AugmentFacts {
    /// Length that it is taken for [m].
    pub loaded_length_m: f64,
    /// Depth of cushion that lessens it [m].
    pub cushion_m: f64,
    /// Without the cushion's effect.
    pub total: f64,
    /// With it.
    pub design: f64,
    /// Where the formula is from.
    pub source: String,
    /// The same span by span: motion adds by the length of the span that is loaded. The numbers above are those of the
    /// longest.
    pub spans: Vec<SpanAugmentFacts>,
}

/// Coefficients of dynamic augment for loads on one span.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SpanAugmentFacts {
    /// Span, from 1.
    pub span: usize,
    /// Length that they are taken for [m].
    pub loaded_length_m: f64,
    /// Without the cushion's effect.
    pub total: f64,
    /// With it.
    pub design: f64,
}

impl AugmentFacts {
    /// The design and the total coefficient for loads on a span, from 1.
    pub fn on(&self, span: usize) -> [f64; 2] {
        let of_span = self.spans.iter().find(|one| one.span == span);
        of_span.map_or([self.design, self.total], |one| [one.design, one.total])
    }
}

/// What the bridge answers to one load.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ServiceLoadFacts {
    /// Name of the load.
    pub name: String,
    /// Heaviest axle [t].
    pub heaviest_axle_t: f64,
    /// Where the load is from.
    pub source: Option<String>,
    /// How its passage ended.
    pub status: PassageStatus,
    /// The file's own sensors.
    pub channels: Vec<ChannelFacts>,
    /// Deflections and stresses at the places that are checked.
    pub places: Vec<SectionFacts>,
    /// Joints, by reading of the dynamic augment.
    pub joints: Vec<JointFacts>,
}

/// A sensor of the file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ChannelFacts {
    /// Name.
    pub name: String,
    /// Unit of the numbers.
    pub unit: String,
    /// Least value of the passage, self-weight taken off.
    pub minimum: f64,
    /// Greatest.
    pub maximum: f64,
    /// Value of largest size.
    pub peak: f64,
    /// Value under self-weight alone.
    pub self_weight: f64,
}

/// A quantity at a place of the ring: displacement upwards [mm] or stress along the ring [MPa], tension positive.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SectionFacts {
    /// Which place.
    pub place: RingSection,
    /// What is watched there.
    pub quantity: Watched,
    /// The place in words, with span and face.
    pub about: String,
    /// Span, from 1.
    pub span: usize,
    /// On which face.
    pub face: Face,
    /// Under self-weight.
    pub self_weight: f64,
    /// Least value of the passage, self-weight taken off.
    pub minimum: f64,
    /// Position of the first axle then [m].
    pub minimum_at_m: f64,
    /// The span, from 1, whose loaded length decides what motion adds to it.
    pub minimum_span: usize,
    /// Greatest.
    pub maximum: f64,
    /// Position of the first axle then [m].
    pub maximum_at_m: f64,
    /// The span, from 1, whose loaded length decides what motion adds to it.
    pub maximum_span: usize,
}

/// The worst joints of a passage, live load increased by an augment.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct JointFacts {
    /// Which coefficient of dynamic augment.
    pub reading: Reading,
    /// Its coefficient on the longest span.
    pub augment: f64,
    /// Its coefficient where the shear is largest.
    pub shear_augment: f64,
    /// Its coefficient where the thrust goes farthest.
    pub eccentricity_augment: f64,
    /// Largest shear stress of a point of a joint [MPa].
    pub shear_mpa: f64,
    /// Which joint and when.
    pub shear_at: String,
    /// Position of the first axle then [m].
    pub shear_position_m: f64,
    /// Largest distance of the thrust from the middle of a joint over its depth.
    pub eccentricity: f64,
    /// Which joint and when.
    pub eccentricity_at: String,
    /// Position of the first axle then [m].
    pub eccentricity_position_m: f64,
}

/// The file's own loads at collapse, where they stand and moved over the bridge.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct UltimateFacts {
    /// What the loads are called.
    pub load: String,
    /// How the analysis ended.
    pub status: Status,
    /// Method in words.
    pub method: String,
    /// Least factor on the loads of the file; none where a position found no answer.
    pub load_factor: Option<f64>,
    /// What may help the bridge and is not counted.
    pub not_counted: NotCounted,
    /// Where positions found no answer: the least factor of the others, which the true one does not exceed.
    pub load_factor_at_most: Option<f64>,
    /// Position of the first load or axle then [m].
    pub position_m: Option<f64>,
    /// Loads of the file [kN/m].
    pub reference_load_kn_per_m: f64,
    /// Loads at which states are first reached there that a bridge should not come to in service, where deformable joints were
    /// followed.
    pub permissible: Vec<Permissible>,
    /// Uniform loads of which a part does more harm than the whole: the loads above are those of the parts.
    pub shortened: Vec<ShortenedFacts>,
    /// Positions that were tried.
    pub positions: usize,
    /// Positions at which a case found no answer: with one of them, nothing is settled.
    pub positions_not_converged: usize,
    /// Assumptions.
    pub assumptions: Vec<Note>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// The collapse at the governing position.
    pub collapse: Option<Box<Collapse>>,
}

/// A uniform load of the file of which a part does more harm than the whole.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ShortenedFacts {
    /// Which load, counted from 0.
    pub load: usize,
    /// Its name.
    pub name: String,
    /// Its length in the file [m].
    pub of_m: f64,
    /// Length of the part that acts [m].
    pub length_m: f64,
    /// How far the middle of the part lies to the right of that of the whole [m].
    pub shift_m: f64,
}

/// Vehicles moved over the bridge under the factors of a rule.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct VehicleFacts {
    /// The rule: its name and where it is from.
    pub rule: String,
    /// Every factor of the rule: name, value, source.
    pub factors: Vec<[String; 3]>,
    /// What safety the rule holds.
    pub safety: SafetyFacts,
    /// One entry a vehicle.
    pub vehicles: Vec<SweptFacts>,
    /// What the bridge is worth in the grades of the vehicles' load models: what they are of, the highest grade, and the others in words.
    pub grades: Vec<[String; 3]>,
    /// The same as data.
    pub graded: Vec<Graded>,
    /// Distance between positions [m].
    pub step_m: f64,
    /// The vehicle with the least adequacy factor.
    pub governing: Option<String>,
    /// Its governing case by discrete elements, in words, where the file asks for it.
    pub discrete_elements: Option<String>,
    /// The adequacy factor that these carried.
    pub adequacy_by_discrete_elements: Option<f64>,
    /// The governing vehicle's adequacy factor by the method that gives less.
    pub headline: Option<f64>,
    /// Positions at which a case found no answer, over all vehicles.
    pub positions_not_converged: usize,
    /// What must be given before the bridge is adequate by the rule: what the rule asks for, and what the library's rule that it builds on
    /// asks for.
    pub requires: Vec<Requirement>,
    /// The share of loads along the bridge, where the file writes it, be it 0.
    pub braking: Option<f64>,
    /// Why that share, as the file says; empty where it does not.
    pub braking_reason: String,
    /// What the rule or the load model has and the program leaves out of these vehicles' loads, in words.
    pub left_out: Vec<String>,
    /// Vehicles of the same loading that were not moved: their codes.
    pub load_cases_missing: Vec<String>,
    /// Doubtful values of the file's own vehicles and rule.
    pub doubtful: Vec<DoubtFacts>,
    /// Assumptions.
    pub assumptions: Vec<Note>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl VehicleFacts {
    /// The vehicle that governs.
    pub fn worst(&self) -> Option<&SweptFacts> {
        self.vehicles.iter().find(|one| self.governing.as_ref() == Some(&one.code))
    }
}

/// What safety a rule holds.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SafetyFacts {
    /// Code of the rule.
    pub rule: String,
    /// Factor on live loads, without impact.
    pub live_load: f64,
    /// How sure it is.
    pub live_load_confidence: Confidence,
    /// Model factor that the adequacy factors already hold.
    pub model: f64,
    /// How sure it is.
    pub model_confidence: Confidence,
    /// Every factor as "name value", and how sure it is.
    pub factors: Vec<(String, Confidence)>,
    /// The file of the rule; empty where the rule is the library's.
    pub rule_file: String,
    /// The library's rule that a rule of a file builds on; empty where the rule is the library's.
    pub based_on: String,
    /// Whether the file names that rule, or it is only the nearest one.
    pub based_on_named: bool,
    /// Factors that differ from those of the library's rule: of a rule file, and of the vehicles' own files.
    pub changed_factors: Vec<ChangedFactor>,
}

/// A doubtful value of a file of vehicles or of a rule.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct DoubtFacts {
    /// Code of its card, `P…`.
    pub code: String,
    /// The file.
    pub file: String,
    /// Where it stands there.
    pub at: String,
    /// What is doubtful, and what is usual.
    pub told: String,
}

impl std::fmt::Display for DoubtFacts {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(to, "{}, {}: {} ({})", self.file, self.at, self.told, self.code)
    }
}

/// A vehicle that was moved over the bridge.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SweptFacts {
    /// Its code.
    pub code: String,
    /// Its name.
    pub title: String,
    /// How the governing case ended.
    pub status: Status,
    /// What all its factored loads may be multiplied by; 1 is just enough. None where a position found no answer.
    pub adequacy: Option<f64>,
    /// The same with fill that presses, where the file has it; `adequacy` is the lower end.
    pub adequacy_with_fill_pressure: Option<f64>,
    /// What may help the bridge and is not counted.
    pub not_counted: NotCounted,
    /// Where positions found no answer: the least factor of the others, which the true one does not exceed.
    pub adequacy_at_most: Option<f64>,
    /// Positions that were tried.
    pub positions: usize,
    /// Positions at which a case found no answer: with one of them, nothing is settled.
    pub positions_not_converged: usize,
    /// Position of its first axle in the governing case [m].
    pub position_m: Option<f64>,
    /// The governing case in words: direction, axles, arrangement.
    pub case: String,
    /// Width of the barrel that carries an axle [m].
    pub effective_width_m: f64,
    /// How that width was found, in words.
    pub effective_width_derivation: String,
    /// How it stands across the bridge, in words.
    pub stands: String,
    /// Largest thrusts at springings and feet of piers, over all its cases.
    pub thrusts: Vec<ThrustFacts>,
    /// Factor on every axle.
    pub load_factor: f64,
    /// Factor on its loads that acted, without what motion adds.
    pub live_load: f64,
    /// How sure that factor is.
    pub live_load_confidence: Confidence,
    /// What motion added, in words.
    pub impact: String,
    /// Whether both are from the vehicle's own file and not from the rule.
    pub factors_of_vehicle_file: bool,
    /// Cases that the interior-point method answered one by one.
    pub slow_cases: usize,
    /// How sure its loads and distances are.
    pub loads_confidence: Confidence,
    /// The factor of rigid blocks, where deformable joints were followed too: `adequacy` is the smaller one then.
    pub rigid: Option<f64>,
    /// The factor in balance on deformable joints.
    pub deformable: Option<f64>,
    /// Factors at which states are first reached that a bridge should not come to in service.
    pub permissible: Vec<PermissibleFactor>,
}

/// The largest thrust at a joint, with what goes with it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ThrustFacts {
    /// Which joint.
    pub place: String,
    /// Compression [kN/m].
    pub thrust_kn_per_m: f64,
    /// Shear [kN/m].
    pub shear_kn_per_m: f64,
    /// Distance of the resultant from the middle of the joint [m].
    pub eccentricity_m: f64,
    /// Length of the joint [m].
    pub depth_m: f64,
    /// Whether the resultant lies outside it.
    pub outside: bool,
    /// Largest pressure over the barrel's width, [`crate::statics::pressure`], of these values and of those with the outermost, the innermost
    /// and the smallest thrust and the largest shear [kPa].
    pub pressure_kpa: f64,
}

/// What the file's named cases carry.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CasesFacts {
    /// In the order of the file.
    pub cases: Vec<CaseFacts>,
    /// Assumptions, each once.
    pub assumptions: Vec<Note>,
    /// Warnings, each once.
    pub warnings: Vec<Warning>,
}

/// What a named case carries.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CaseFacts {
    /// Its name.
    pub name: String,
    /// What acts, in words.
    pub acts: String,
    /// How its analysis ended.
    pub status: Status,
    /// The method that its factor is from.
    pub method: String,
    /// What all its loads may be multiplied by; 1 is just enough. None where it is not known, or unbounded.
    pub load_factor: Option<f64>,
}

/// The movement of a support that makes a mechanism.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MovementFacts {
    /// How the analysis ended.
    pub status: Status,
    /// Last movement at which the bridge stood [mm].
    pub last_stable_mm: Option<f64>,
    /// Which support, in words.
    pub support: String,
    /// The whole analysis.
    pub collapse: Option<Box<Collapse>>,
}

/// What changes the governing utilisation.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SensitivityFacts {
    /// Code of the check.
    pub code: String,
    /// Its utilisation as this stage computes it for the file's own values.
    pub utilisation: f64,
    /// How the stage differs from the full one, in words.
    pub how: String,
    /// Share by which every quantity was changed, both ways.
    pub share: f64,
    /// One entry a quantity, the most telling first.
    pub quantities: Vec<ChangeFacts>,
}

/// A quantity that was changed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ChangeFacts {
    /// Its path.
    pub path: String,
    /// Its value as the file has it.
    pub value: String,
    /// Utilisation with less of it.
    pub less: Option<f64>,
    /// Utilisation with more of it.
    pub more: Option<f64>,
}
