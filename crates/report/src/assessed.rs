//! A bridge that was judged, and what scripts read of it.

use crate::{Appendix, Figure, Photograph, StageLine, StageState};
use bridge::document::ReportDocument;
use bridge::inputs::Input;
use outcome::assessment::Assessment;
use outcome::published;
use outcome::warning::{self, Warning};
use serde_json::{Value, json};

/// A bridge that was judged.
#[derive(Debug, Clone)]
pub struct Assessed {
    /// Its facts, its checks and the verdict.
    pub assessment: Assessment,
    /// Drawings of its stages.
    pub figures: Vec<Figure>,
    /// Its file, value by value.
    pub inputs: Vec<Input>,
    /// What was found in the file: code, message, place.
    pub findings: Vec<[String; 3]>,
    /// How it was made.
    pub appendix: Appendix,
    /// What identifies it, and who signs for it.
    pub document: ReportDocument,
    /// Photographs that the file names.
    pub photographs: Vec<Photograph>,
}

impl Assessed {
    /// The answer for scripts.
    pub fn object(&self) -> published::Object {
        self.assessment.object()
    }

    /// The stages in their order: name, state, key.
    pub fn stages(&self) -> Value {
        let one = |stage: &StageLine| json!({ "name": stage.name, "state": stage.state.to_string(), "key": stage.key });
        self.appendix.stages.iter().map(one).collect()
    }

    /// The checks as a table (CSV).
    pub fn table(&self) -> String {
        published::checks_table(&self.assessment.checked)
    }

    /// Warnings of its stages, each once; whether strength stayed open; and the stages that failed.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut all: Vec<Warning> = Vec::new();
        let stage = self.assessment.governing_stage();
        for (of, warning) in self.assessment.facts.warnings() {
            // Where a load goes is told of the position that governs.
            let elsewhere = stage.is_some_and(|stage| stage != of) && warning::OF_A_POSITION.contains(&warning.code());
            if !elsewhere && !all.contains(warning) {
                all.push(warning.clone());
            }
        }
        let missing = &self.assessment.verdict.strength.missing;
        if !missing.is_empty() {
            all.push(warning::Command::StrengthOpen { missing: missing.clone() }.into());
        }
        let failed = self.appendix.stages.iter().filter(|stage| matches!(stage.state, StageState::Failed(_)));
        all.extend(failed.map(|stage| -> Warning {
            warning::Command::StageFailed { stage: stage.name.to_string(), state: stage.state.to_string() }.into()
        }));
        all
    }
}
