//! What a bridge file says of its assessment: loads in service, limits, MEXE's factors, expected ranges. No part of the
//! bridge: nothing of it changes what is computed, only what is asked and how it is judged.

use crate::choice::choice;
use crate::values::of_keys;

/// An assessment as a file asks for it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Assess {
    /// Loads in service: the file's train, with these axles; none where only the train itself counts.
    pub service_loads: Vec<ServiceLoad>,
    /// Limits of the checks; a check without its limit cannot be made.
    pub limits: Limits,
    /// MEXE's factors, where the file gives them.
    pub mexe: Option<Mexe>,
    /// Ranges in which identified parameters are expected.
    pub expected: Vec<Expected>,
}

/// A load in service.
#[derive(Debug, Clone, PartialEq)]
pub struct ServiceLoad {
    /// What it is called.
    pub name: String,
    /// Mass of every axle of the train [kg]; the train's own where none is given.
    pub axle_load: Option<f64>,
    /// Where it comes from.
    pub source: Option<String>,
}

/// Limits and what they need.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Limits {
    /// Where the limits come from.
    pub source: Option<String>,
    /// Code of the rule whose dynamic augment counts; none where nothing is added.
    pub rule: Option<String>,
    /// Length that the dynamic augment is taken for [m]; the longest span where none is given.
    pub loaded_length: Option<f64>,
    /// Depth of cushion that lessens the dynamic augment [m]; the cover's depth where none is given.
    pub cushion: Option<f64>,
    /// Largest deflection of the crown [m].
    pub deflection: Option<f64>,
    /// Largest compressive stress along the ring [Pa].
    pub compression: Option<f64>,
    /// Largest tensile stress along the ring [Pa].
    pub tension: Option<f64>,
    /// Shear strength of joints [Pa].
    pub joint_shear: Option<f64>,
    /// Part of the ring's thickness in which the line of thrust must stay: 1/3 or 1/2.
    pub thrust_zone: Option<f64>,
    /// Least adequacy factor at ultimate.
    pub adequacy_factor: Option<f64>,
    /// Document and clause that it is from; without one it assesses no strength.
    pub adequacy_source: Option<String>,
    /// By what a square model stands for a skew bridge; without it no strength of one is assessed.
    pub skew_source: Option<String>,
    /// Factor that the forces of the file's loads already carry; 1 where they are nominal.
    pub load_factor_included: f64,
    /// Factor for the method of analysis; the program's own where none is given.
    pub model_factor: Option<f64>,
    /// Whether the model factor is to be that of tests to collapse, in every check of strength.
    pub model_factor_of_tests: bool,
    /// Largest share of the ultimate load in service.
    pub permissible_share: Option<f64>,
    /// Least factor on loads at which states are first reached that a bridge should not come to in service.
    pub onset_factor: Option<f64>,
    /// Largest pressure on the ground below piers and abutments [Pa].
    pub bearing: Option<f64>,
    /// Largest distance of the resultant at rest from the middle of a foot, over the foot's depth.
    pub foot_eccentricity: Option<f64>,
    /// Cycles of load in the life that is asked for.
    pub load_cycles: Option<f64>,
    /// Support movement that is expected or was measured [m].
    pub expected_movement: Option<f64>,
    /// Safety on it.
    pub movement_factor: f64,
}

of_keys! {
    /// Inputs of MEXE that the rest of the file does not hold.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Mexe {
        /// The span it is made for, from 0.
        pub span: usize,
        /// Barrel factor F_b.
        pub barrel_factor: f64,
        /// Fill factor F_f.
        pub fill_factor: f64,
        /// Joint width factor F_w.
        pub width_factor: f64,
        /// Joint depth factor F_d.
        pub depth_factor: f64,
        /// Mortar factor F_mo.
        pub mortar_factor: f64,
        /// Condition factor F_cM.
        pub condition_factor: f64,
        /// Span/rise factor F_sr, where it was read off the method's figure.
        pub span_rise_factor: Option<f64>,
        /// Rise at the quarter points [m]; the profile's where none is given.
        pub quarter_rise: Option<f64>,
        /// Thickness of the ring [m]; that of the crown where none is given.
        pub ring_thickness: Option<f64>,
        /// Depth of fill at the crown [m]; the cover's where none is given.
        pub fill_depth: Option<f64>,
        /// Mass on an axle that must be allowed [kg].
        pub axle_load: Option<f64>,
        /// What stands on the bridge with that axle.
        pub axles: MexeAxles,
        /// Whether an axle of a bogie may lift off and leave its load to the others.
        pub lift_off: bool,
        /// Axle factor A_f, where it was read off the method's figure.
        pub axle_factor: Option<f64>,
    }
}

choice! {
    /// Axles that MEXE's load is compared with.
    pub enum MexeAxles {
        /// one axle by itself
        Single = "single",
        /// two axles of a bogie
        Bogie = "bogie",
        /// three axles of a bogie
        Triple = "triple",
    }
}

/// A range in which an identified parameter is expected.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// Name of the [[parameter]].
    pub parameter: String,
    /// Lower end, in SI or as a bare number.
    pub lower: f64,
    /// Upper end, likewise.
    pub upper: f64,
    /// Where the range comes from.
    pub source: Option<String>,
    /// What a value below it says of the bridge, for its owner.
    pub below: Option<String>,
    /// What a value above it says.
    pub above: Option<String>,
}
