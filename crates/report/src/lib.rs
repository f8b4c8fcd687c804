//! Assessments as pages: one self-contained HTML file a bridge, and a table of many bridges. Plain data goes in, text comes
//! out; the same text for the same data. The strings of a report are also given as data, for another typesetter.

mod assessed;
mod figure;
mod fleet;
mod left_out;
mod map;
mod numbers;
mod page;
mod parts;
mod rows;
mod springings;
mod standing;
mod summary;

pub use assessed::Assessed;
pub use figure::Figure;
pub use fleet::{FleetRow, fleet_csv, fleet_html};
pub use map::fleet_geojson;
pub use page::{Appendix, Photograph, StageLine, StageState};
