//! What was found in records and what was done with them, as plain data.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Severity {
    /// Worth knowing; nothing was altered.
    Note,
    /// Something was repaired, removed or is doubtful: a reader should look.
    Warning,
    /// A channel, a run or the file is not used.
    Error,
}

impl Severity {
    /// The word that scripts read.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

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

impl Place {
    /// In words: "run slow, line 12, column 3, crown, at 0.0550 s".
    pub fn words(&self) -> String {
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
        parts.join(", ")
    }
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// Stable code, `R…`; its card is in [`CARDS`](crate::CARDS).
    pub code: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// Where.
    pub place: Place,
    /// What was found and what was done about it, in one line.
    pub message: String,
    /// What to do; empty where nothing has to be done.
    pub help: String,
}

/// A finding as it is read back.
#[derive(Deserialize)]
struct Written {
    code: String,
    severity: Severity,
    place: Place,
    message: String,
    help: String,
}

impl<'de> Deserialize<'de> for Finding {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Finding, D::Error> {
        let Written { code, severity, place, message, help } = Written::deserialize(from)?;
        let card = crate::CARDS.iter().find(|card| card.code == code);
        let code = card.ok_or_else(|| D::Error::custom(format!("there is no finding {code}")))?.code;
        Ok(Finding { code, severity, place, message, help })
    }
}

impl Finding {
    pub(crate) fn new(
        severity: Severity,
        code: &'static str,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Finding {
        Finding { code, severity, place, message: message.into(), help: help.into() }
    }

    /// In one line of text: "error R041: run slow, crown: drifts …".
    pub fn words(&self) -> String {
        let place = self.place.words();
        let colon = if place.is_empty() { "" } else { ": " };
        let help = if self.help.is_empty() { String::new() } else { format!(" ({})", self.help) };
        format!("{} {}: {place}{colon}{}{help}", self.severity.word(), self.code, self.message)
    }
}

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
