//! Values of an engineer's own files that are possible but so unusual that they are worth a question, and what is impossible.
//!
//! Ranges are wide on purpose, and two-level: outside the usual range a value is doubtful and qualifies a verdict, outside the possible
//! one the file is refused. They are those of vehicles that have been built: tonnes written as kilonewtons, and millimetres as metres,
//! lie outside.

use crate::{Impact, LoadModel, Rule, Vehicle};

/// A doubtful value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Doubt {
    /// The code of its card: `P080`.
    pub code: &'static str,
    /// Where it stands: `vehicle "our-lorry", axle_loads_kn`.
    pub at: String,
    /// What is doubtful, with its number, and what is usual.
    pub message: String,
}

/// A usual range within a possible one, both with their ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Range {
    pub code: &'static str,
    pub usual: [f64; 2],
    pub possible: [f64; 2],
    /// What is usual, in words.
    pub says: &'static str,
}

const fn range(code: &'static str, usual: [f64; 2], possible: [f64; 2], says: &'static str) -> Range {
    Range { code, usual, possible, says }
}

impl Range {
    fn doubt(&self, at: &str, value: f64, list: &mut Vec<Doubt>) {
        if !(self.usual[0]..=self.usual[1]).contains(&value) {
            list.push(Doubt { code: self.code, at: at.to_owned(), message: format!("{value}: {}", self.says) });
        }
    }
}

/// Axles [kN]: a bicycle's to a transformer's; 1 t is 9.81 kN.
pub(crate) const AXLE: Range = range("P080", [10.0, 1000.0], [1.0, 5000.0], "axles usually have 10 to 1000 kN");
/// Between the wheels of an axle [m].
pub(crate) const TRACK: Range =
    range("P081", [1.0, 3.5], [0.0, 10.0], "the wheels of an axle are usually 1 to 3.5 m apart");
/// Between axles [m].
pub(crate) const DISTANCE: Range = range("P082", [0.5, 30.0], [0.1, 200.0], "axles usually stand 0.5 to 30 m apart");
/// A wheel's or sleeper's footprint along the bridge [m].
pub(crate) const CONTACT: Range =
    range("P083", [0.05, 1.0], [0.001, 5.0], "footprints are usually 0.05 to 1 m long along the bridge");
/// A uniform load [kN/m].
pub(crate) const UNIFORM: Range =
    range("P083", [1.0, 300.0], [0.01, 3000.0], "uniform loads are usually 1 to 300 kN per metre of lane or track");
/// Its width [m].
pub(crate) const WIDTH: Range = range("P083", [1.0, 6.0], [0.05, 50.0], "uniform loads are usually 1 to 6 m wide");
/// A factor of lift-off.
pub(crate) const LIFT_OFF: Range = range("P083", [0.0, 1.5], [0.0, 3.0], "lift-off usually has factors of 0 to 1.5");
/// How many axles.
const AXLES: Range = range("P083", [0.0, 200.0], [0.0, 1000.0], "vehicles usually have fewer than 200 axles");

/// Factors of a rule. All of them stand on the side of safety of 1, or the rule would make a bridge stronger than it is.
pub(crate) const LIVE: Range = range("P084", [1.0, 2.5], [1.0, 4.0], "factors on live loads are usually 1 to 2.5");
pub(crate) const ADVERSE: Range = range("P084", [1.0, 2.0], [1.0, 4.0], "factors on adverse weight are usually 1 to 2");
pub(crate) const HELPS: Range =
    range("P084", [0.8, 1.0], [0.0, 1.0], "factors on weight that helps are usually 0.8 to 1");
pub(crate) const STRENGTH: Range =
    range("P084", [1.0, 4.0], [1.0, 10.0], "factors that divide a strength are usually 1 to 4");
pub(crate) const MODEL: Range = range("P084", [1.0, 3.0], [1.0, 10.0], "model factors are usually 1 to 3");
pub(crate) const CONDITION: Range =
    range("P084", [0.3, 1.0], [0.01, 1.0], "condition factors are usually 0.3 to 1, and never more");
pub(crate) const MOTION: Range =
    range("P084", [1.0, 2.5], [1.0, 5.0], "what motion adds is usually a factor of 1 to 2.5");
pub(crate) const PRESENCE: Range =
    range("P084", [0.4, 1.3], [0.01, 2.0], "factors of multiple presence are usually 0.4 to 1.3");
pub(crate) const GROWTH: Range = range(
    "P084",
    [0.0, 2.0],
    [0.0, 4.0],
    "loads usually spread by at most 2 m of length or width for each metre of depth",
);
pub(crate) const BASE: Range =
    range("P084", [0.1, 1.0], [0.001, 5.0], "loads usually stand on 0.1 to 1 m along the bridge at the surface");
pub(crate) const ACROSS: Range =
    range("P084", [0.0, 2.0], [0.0, 10.0], "widths at the surface are usually up to 2 m more than the track");

/// The range of each factor of [`Rule::listed`], in its order.
pub(crate) const LISTED: [Range; 11] =
    [ADVERSE, ADVERSE, ADVERSE, HELPS, LIVE, STRENGTH, STRENGTH, STRENGTH, STRENGTH, MODEL, CONDITION];

/// What is doubtful about a file of vehicles.
pub fn doubts_of_vehicles(model: &LoadModel) -> Vec<Doubt> {
    let mut list = Vec::new();
    model.vehicles.iter().for_each(|vehicle| of_vehicle(vehicle, &mut list));
    for under in &model.under {
        let at = |what: &str| format!("under \"{}\", {what}", under.rule);
        LIVE.doubt(&at("live_load"), under.live_load.value, &mut list);
        of_motion(&at("impact"), &under.impact, &mut list);
        under.presence.iter().for_each(|factor| PRESENCE.doubt(&at("presence"), *factor, &mut list));
    }
    list
}

fn of_vehicle(vehicle: &Vehicle, list: &mut Vec<Doubt>) {
    let at = |key: &str| format!("vehicle \"{}\", {key}", vehicle.code);
    let mut each = |key: &str, range: Range, values: Vec<f64>| {
        // One doubt a key says it.
        if let Some(value) = values.into_iter().find(|value| !(range.usual[0]..=range.usual[1]).contains(value)) {
            range.doubt(&at(key), value, list);
        }
    };
    each("axle_loads_kn", AXLE, vehicle.axle_loads_kn.clone());
    each("spacings_m", DISTANCE, vehicle.spacings_m.iter().flat_map(|spacing| spacing.range()).collect());
    if !vehicle.axle_loads_kn.is_empty() {
        each("wheel_track_m", TRACK, vec![vehicle.wheel_track_m]);
        each("contact_length_m", CONTACT, vec![vehicle.contact_length_m]);
    }
    each("axle_loads_kn (how many)", AXLES, vec![vehicle.axle_loads_kn.len() as f64]);
    each("lift_off", LIFT_OFF, vehicle.lift_off.concat());
    each("uniform.load_kn_per_m", UNIFORM, vehicle.uniform.iter().map(|uniform| uniform.load_kn_per_m).collect());
    each("uniform.width_m", WIDTH, vehicle.uniform.iter().filter_map(|uniform| uniform.width_m).collect());
}

/// What is doubtful about a rule.
pub fn doubts_of_rule(rule: &Rule) -> Vec<Doubt> {
    let mut list = Vec::new();
    for ((name, factor), range) in rule.listed().into_iter().zip(LISTED) {
        range.doubt(&format!("factors ({name})"), factor.value, &mut list);
    }
    let d = &rule.dispersal;
    GROWTH.doubt("dispersal.length_per_depth", d.length_per_depth, &mut list);
    GROWTH.doubt("dispersal.width_per_depth", d.width_per_depth, &mut list);
    BASE.doubt("dispersal.length_base_m", d.length_base_m, &mut list);
    ACROSS.doubt("dispersal.width_base_m", d.width_base_m, &mut list);
    if let Some(impact) = &rule.impact {
        of_motion("impact", impact, &mut list);
    }
    for loads in &rule.loads {
        let at = |what: &str| format!("{what} on {}", loads.models.join(", "));
        if let Some(live) = &loads.live_load {
            LIVE.doubt(&at("live load"), live.value, &mut list);
        }
        of_motion(&at("impact"), &loads.impact, &mut list);
        loads.presence.iter().for_each(|factor| PRESENCE.doubt(&at("presence"), *factor, &mut list));
    }
    list
}

fn of_motion(at: &str, impact: &Impact, list: &mut Vec<Doubt>) {
    greatest(impact).into_iter().for_each(|factor| MOTION.doubt(at, factor, list));
}

/// The factors that what motion adds may come to.
pub(crate) fn greatest(impact: &Impact) -> Vec<f64> {
    match impact {
        Impact::AllAxles { factor, .. } | Impact::CriticalAxle { factor } => vec![factor.value],
        Impact::Augment { most, .. } => vec![1.0 + most],
        Impact::Root { least, most, .. } => vec![*least, *most],
        Impact::Included { .. } => Vec::new(),
    }
}
