//! Quantities of a bridge file and the values that they are given, one run of an analysis for each.

mod command_line;
mod quantities;
mod scale;
mod spread;

pub use command_line::parse_setting;
pub use quantities::{Known, Variable, find, known};
pub use spread::{Setting, Spread, Varied, settle};

use crate::diagnostic::TextRange;

/// What was asked to vary, as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Path of the quantity.
    pub quantity: String,
    /// Its values.
    pub spread: Spread,
    /// Where path and values stand in the file; the command line has no places.
    pub places: Option<[TextRange; 2]>,
}

/// What is wrong with a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slip {
    /// Code of its card.
    pub code: &'static str,
    /// What is wrong, in one line.
    pub message: String,
    /// Words under the caret, where there is one.
    pub label: String,
    /// What to write instead.
    pub help: String,
    /// Whether the values are at fault, and not the path.
    pub of_values: bool,
}

impl Slip {
    /// What is wrong with a path.
    fn of_path(code: &'static str, message: String, label: impl Into<String>, help: impl Into<String>) -> Slip {
        Slip { code, message, label: label.into(), help: help.into(), of_values: false }
    }
}

/// Every quantity that is asked for twice: its second request.
pub fn twice(requests: &[(usize, String)]) -> Vec<(usize, Slip)> {
    let repeated = requests.iter().enumerate().filter(|(at, (_, path))| requests[..*at].iter().any(|(_, p)| p == path));
    let slip = |path: &str| {
        let help = "put all values of a quantity into one list";
        Slip::of_path("B504", format!("`{path}` is varied twice"), "it has its values already", help)
    };
    repeated.map(|(_, (request, path))| (*request, slip(path))).collect()
}
