//! What is found in files and analyses: how bad it is, where, and the card that explains its code; and how text that stood in files goes
//! out again. A leaf: it knows neither files nor analyses.

mod card;
mod finding;
pub mod visible;
pub mod words;

pub use card::Card;
pub use finding::{Finding, Place, Severity};
