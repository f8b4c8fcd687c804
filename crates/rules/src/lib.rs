//! Load models and rules of assessment as data: every number stands in a file of `crates/rules/data/` with its source, its
//! date and how sure it is. Nothing here knows a bridge.
//!
//! A [`LoadModel`] holds [`Vehicle`]s and the tables that were published for them; [`check`] compares the two. A [`Rule`]
//! holds every factor between a vehicle's axle and the number that is compared with a limit. [`library`] reads all of them;
//! [`read_load_model`] and [`read_rule`] read an engineer's own.

mod changed;
mod check;
mod dispersal;
mod factor;
mod impact;
mod library;
mod model;
mod pattern;
mod plausible;
mod read;
mod rule;
pub mod shape;
mod simple_span;
mod source;
mod units;
mod vehicle;
mod walk;

pub use changed::{Base, ChangedFactor, based_on, changed_by_vehicles, changed_for};
pub use check::{Checked, check, compared};
pub use dispersal::{Dispersal, Pressure};
pub use factor::Factor;
pub use impact::{CoverReduction, FillReduction, Impact};
pub use library::{FILES, Library, library};
pub use model::{LoadModel, Published, PublishedQuantity, SpanLimit, Under, Ways};
pub use pattern::{Axle, Pattern, Stretch};
pub use plausible::{Doubt, doubts_of_rule, doubts_of_vehicles};
pub use read::{Problem, read_load_model, read_rule};
pub use rule::{Acting, Beside, EffectiveWidth, Factors, Loads, Overload, Required, Requirement, Rule};
pub use simple_span::{equivalent_uniform_load, greatest_bending, greatest_bending_at, greatest_shear};
pub use source::{Confidence, Source};
pub use units::{RouteAvailability, Units, equivalent_units, greatest_of};
pub use vehicle::{Extent, Spacing, Uniform, Vehicle};
