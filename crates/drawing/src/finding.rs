//! What was found in a drawing, as plain data.

use crate::Point;
use findings::Severity;
use findings::words::{counted, verb};
use std::fmt;

/// Where in a drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Place {
    /// Layer; empty where the finding is about the file.
    pub layer: String,
    /// What stands there: "LWPOLYLINE 2F", "LINE 31 in INSERT 40"; empty where it is about the file.
    pub entity: String,
    /// Coordinates [m], where there is a point.
    pub at: Option<Point>,
}

impl Place {
    /// The same place at a point [m].
    pub fn at(&self, point: Point) -> Place {
        Place { at: Some(point), ..self.clone() }
    }
}

impl findings::Place for Place {
    const CARDS: &'static [findings::Card] = crate::cards::CARDS;
}

/// In words: "layer RING, LWPOLYLINE 2F, at (1.250, 3.000) m".
impl fmt::Display for Place {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let layer = (!self.layer.is_empty()).then(|| format!("layer {}", self.layer));
        let entity = (!self.entity.is_empty()).then(|| self.entity.clone());
        // Adding zero takes the sign off a negative zero.
        let at = self.at.map(|[x, y]| format!("at ({:.4}, {:.4}) m", x + 0.0, y + 0.0));
        to.write_str(&[layer, entity, at].into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

/// One finding about a drawing.
pub type Finding = findings::Finding<Place>;

/// No list of findings is longer; more say no more.
const MOST: usize = 2000;

/// Collects findings.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    pub(crate) list: Vec<Finding>,
    /// Errors that no longer fit.
    beyond: usize,
}

impl Findings {
    pub(crate) fn add(
        &mut self,
        severity: Severity,
        code: &'static str,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        if self.list.len() < MOST {
            self.list.push(Finding { code, severity, place, message: message.into(), help: help.into() });
        } else if severity == Severity::Error {
            self.beyond += 1;
        }
    }

    pub(crate) fn error(&mut self, code: &'static str, place: Place, message: impl Into<String>, help: &str) {
        self.add(Severity::Error, code, place, message, help);
    }

    pub(crate) fn warning(&mut self, code: &'static str, place: Place, message: impl Into<String>, help: &str) {
        self.add(Severity::Warning, code, place, message, help);
    }

    pub(crate) fn note(&mut self, code: &'static str, place: Place, message: impl Into<String>) {
        self.add(Severity::Note, code, place, message, "");
    }

    /// All of them; errors that did not fit are counted in one more.
    pub(crate) fn finish(mut self) -> Vec<Finding> {
        if self.beyond > 0 {
            let message =
                format!("{} {} not listed", counted(self.beyond, "more error"), verb(self.beyond, "is", "are"));
            let help = "mend those listed first".to_owned();
            self.list.push(Finding { code: "D106", severity: Severity::Error, place: Place::default(), message, help });
        }
        self.list
    }
}
