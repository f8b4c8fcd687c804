//! The formats others rely on: JSON objects and CSV tables. The only serialisable types; keys carry their unit, a meaning
//! that stands never changes.

mod assess;
mod calibration;
mod collapse;
mod particles;
mod passage;
mod shapes;
mod sweep;
mod tables;
mod update;
mod vary;
mod vehicles;

pub use assess::{AssessObject, checks_table};
pub use calibration::{CalibrationObject, calibration_curves, calibration_moduli};
pub use collapse::{CollapseObject, strip};
pub use particles::{particle_contacts, particles};
pub use passage::{PassageObject, channels_table, influence_table, joint_states, passage_log, thrust_lines};
pub use shapes::{schema_of_rules, schema_of_vehicles};
pub use sweep::SweepObject;
pub use tables::{blocks, contacts, hinges, path, sweep_table, thrust_line};
pub use update::{UpdateObject, histories_table, samples_table, sweeps_table, told};
pub use vary::{VaryObject, collapse_numbers, run_from_record, run_record, vary_table};
pub use vehicles::{VehicleSweepObject, vehicle_envelope_table, vehicle_sections_table, vehicles_table};

use serde::Serialize;

/// A warning as results show it; `file`, `line` and `column` where it comes from a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WarningObject {
    /// Stable code.
    pub code: String,
    /// What was found.
    pub message: String,
    /// File.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Column, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
}

impl From<&crate::warning::Warning> for WarningObject {
    fn from(w: &crate::warning::Warning) -> WarningObject {
        WarningObject { code: w.code.to_string(), message: w.message.clone(), file: None, line: None, column: None }
    }
}

/// What only the face that started an analysis knows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Run {
    /// Wall clock [s].
    pub wall_seconds: f64,
    /// Threads used.
    pub threads: usize,
    /// Warnings about the file, which come before those of the analysis.
    pub file_warnings: Vec<WarningObject>,
}

/// Any object as JSON text, with a newline at its end.
pub fn json<T: Serialize>(object: &T) -> String {
    let mut text = serde_json::to_string_pretty(object).expect("numbers and strings always have a JSON form");
    text.push('\n');
    text
}

/// N/m in kN/m, or N in kN.
fn kilo(value: f64) -> f64 {
    value / 1e3
}
