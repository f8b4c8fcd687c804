//! The formats others rely on: JSON objects and CSV tables. Keys carry their unit, a meaning that stands never changes.
//! `extrados.NAME/1` is the schema of the object of the command NAME, which adds what only it knows: its own warnings, the
//! wall clock and the threads.

pub(crate) mod assess;
mod calibration;
mod objects;
mod particles;
mod passage;
mod rows;
mod shapes;
mod tables;
pub(crate) mod update;
mod validation;
pub(crate) mod vary;
mod vehicles;

pub use assess::{checks_table, with_sentences};
pub use calibration::{calibration_curves, calibration_moduli};
pub use objects::{Object, json, number};
pub(crate) use objects::{kilo, list, object, said};
pub use particles::{particle_contacts, particles};
pub use passage::{channels_table, influence_table, joint_states, passage_log, positions_table, thrust_lines};
pub use shapes::{schema_of_rules, schema_of_vehicles};
pub use tables::{blocks, contacts, hinges, path, sweep_table, thrust_line};
pub use update::{histories_table, readings_table, samples_table, sweeps_table, told};
pub use validation::{record, validation_table};
pub use vary::{collapse_numbers, run_from_record, run_record, vary_table};
pub use vehicles::{vehicle_envelope_table, vehicle_sections_table, vehicles_table};
