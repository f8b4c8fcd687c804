//! What was found in records and what was done with them, as plain data.

use serde::{Deserialize, Serialize};
use std::fmt;

/// Where in a record.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Place {
    /// Run; empty where the finding is about all of them.
    pub run: String,
    /// First and last line of the file, counted from 1.
    pub lines: Option<[usize; 2]>,
    /// Column of the table, counted from 1.
    pub column: Option<usize>,
    /// Channel with its sensor line; empty where the finding is about the run.
    pub channel: String,
    /// Time of the first sample concerned [s].
    pub time: Option<f64>,
}

impl findings::Place for Place {
    const CARDS: &'static [findings::Card] = crate::CARDS;
}

/// In words: "run slow, line 12, column 3, crown, at 0.0550 s".
impl fmt::Display for Place {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        if !self.run.is_empty() {
            parts.push(format!("run {}", self.run));
        }
        match self.lines {
            Some([first, last]) if first == last => parts.push(format!("line {first}")),
            Some([first, last]) => parts.push(format!("lines {first} to {last}")),
            None => {}
        }
        if let Some(column) = self.column {
            parts.push(format!("column {column}"));
        }
        if !self.channel.is_empty() {
            parts.push(self.channel.clone());
        }
        if let Some(time) = self.time {
            parts.push(format!("at {time:.4} s"));
        }
        to.write_str(&parts.join(", "))
    }
}

/// One finding about records.
pub type Finding = findings::Finding<Place>;

/// One thing that was done to a record.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Done {
    /// Run it was done to.
    pub run: String,
    /// Channel with its sensor line; empty where it was done to all channels of the run.
    pub channel: String,
    /// What was done, in words with numbers.
    pub what: String,
}

impl Done {
    pub(crate) fn new(run: &str, channel: impl Into<String>, what: impl Into<String>) -> Done {
        Done { run: run.to_owned(), channel: channel.into(), what: what.into() }
    }
}
