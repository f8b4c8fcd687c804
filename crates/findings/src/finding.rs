//! A finding: code, severity, place and words.

use crate::Card;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt::Display;

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Severity {
    /// Worth knowing; nothing has to be done.
    Note,
    /// Something is doubtful, or was repaired or left out: a reader should look.
    Warning,
    /// What it is about cannot be used.
    Error,
}

impl Severity {
    /// The word that people and scripts read.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// Where in a file something was found; in words by [`Display`], which are empty where it is about the whole file.
pub trait Place: Display {
    /// The cards of the codes that are found in such files.
    const CARDS: &'static [Card];
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding<Place> {
    /// Stable code; its card is in [`Place::CARDS`].
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
struct Written<Place> {
    code: String,
    severity: Severity,
    place: Place,
    message: String,
    help: String,
}

impl<'de, P: Place + Deserialize<'de>> Deserialize<'de> for Finding<P> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Finding<P>, D::Error> {
        let Written { code, severity, place, message, help } = Written::<P>::deserialize(from)?;
        let card = P::CARDS.iter().find(|card| card.code == code);
        let code = card.ok_or_else(|| D::Error::custom(format!("there is no finding {code}")))?.code;
        Ok(Finding { code, severity, place, message, help })
    }
}

impl<P: Place> Finding<P> {
    /// A finding with its words.
    pub fn new(
        severity: Severity,
        code: &'static str,
        place: P,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Finding<P> {
        Finding { code, severity, place, message: message.into(), help: help.into() }
    }

    /// In one line of text: "error R041: run slow, crown: drifts …".
    pub fn words(&self) -> String {
        let place = self.place.to_string();
        let colon = if place.is_empty() { "" } else { ": " };
        let help = if self.help.is_empty() { String::new() } else { format!(" ({})", self.help) };
        format!("{} {}: {place}{colon}{}{help}", self.severity.word(), self.code, self.message)
    }
}
