//! A card of a message, and what it shows of what to write instead.

use serde::Deserialize;

/// The card of a code about files, with lines that raise it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub struct FileCard {
    /// The code: `B…` for errors in the file, `P…` for plausibility.
    pub code: &'static str,
    /// What is found, in a line.
    pub title: &'static str,
    /// What is checked.
    pub meaning: &'static str,
    /// Why it matters.
    pub why: &'static str,
    /// Lines that raise it.
    pub wrong: &'static str,
    /// What to write instead.
    pub right: &'static str,
    /// Where the rule comes from.
    pub source: &'static str,
}

impl FileCard {
    /// What to write instead, as it is shown. A value that the file must get from its own bridge is an ellipsis before its unit: the
    /// value of another bridge is no remedy. Numbers of the wrong lines stay, for there it is the writing that is wrong.
    pub fn instead(&self) -> String {
        let doubt = self.code.starts_with('P');
        let leave_out = |number: &str| doubt || !self.wrong.replace(',', ".").contains(number);
        let line = |line: &str| match line.split_once(" = ") {
            // A constant of nature.
            Some(("gravity", _)) => line.to_owned(),
            Some((key, count)) if doubt && count.parse::<u32>().is_ok() => format!("{key} = …"),
            Some(_) => masked(line, leave_out),
            // A row of a list shows how lists are written.
            None => line.to_owned(),
        };
        self.right.trim().lines().map(line).collect::<Vec<_>>().join("\n")
    }

    /// The words above these lines.
    pub fn instead_is(&self) -> &'static str {
        if self.instead().contains('…') { "Instead, with this bridge's own value:" } else { "Instead:" }
    }
}

/// A line with an ellipsis for the number of every quantity in quotes that is one to leave out.
fn masked(line: &str, leave_out: impl Fn(&str) -> bool) -> String {
    let piece = |(at, piece): (usize, &str)| match piece.split_once(' ') {
        Some((number, unit)) if at % 2 == 1 && crate::quantity::parse(piece).is_ok() && leave_out(number) => {
            format!("… {unit}")
        }
        _ => piece.to_owned(),
    };
    line.split('"').enumerate().map(piece).collect::<Vec<_>>().join("\"")
}
