//! What analyses found, as data that is written and read back: in metres, newtons and pascals, on the bridge as drawn. Figures,
//! reports and the published formats are made from these values alone, and no solver is needed to read them.

pub mod assessment;
pub mod calibration;
pub mod checked;
pub mod collapse;
pub mod condition;
pub mod facts;
pub mod given;
pub mod ground;
pub mod help;
pub mod mesh;
pub mod note;
pub mod passage;
pub mod picture;
pub mod plan;
pub mod published;
pub mod section;
mod sentences;
pub mod soil;
pub mod statics;
pub mod study;
pub mod sweep;
pub mod update;
pub mod validation;
pub mod vehicles;
pub mod warning;
pub mod wire;
mod words;

/// Parameters from channels: the plain data of searches and posteriors, which updates hold.
pub use calibrate;
pub use findings::words::{counted, verb};
/// Records: findings and what was done, which updates hold.
pub use records;
/// Load models and rules: the plain data that sweeps of vehicles hold.
pub use rules;
