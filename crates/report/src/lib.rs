//! Assessments as pages: one self-contained HTML file a bridge, and a table of many bridges. Plain data goes in, text comes
//! out; the same text for the same data.

mod figure;
mod fleet;
mod numbers;
mod page;
mod rows;

pub use figure::Figure;
pub use fleet::{FleetRow, fleet_csv, fleet_html};
pub use page::{Appendix, Material, StageLine, html};
