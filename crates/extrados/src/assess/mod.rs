//! The whole chain of a bridge against the limits of its file, and what its report is made of.

mod kept;
mod pictures;
mod stages;

use crate::means::Means;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Remembering, Watch};
use bridge::document::ReportDocument;
use bridge::inputs::Input;
use findings::visible::one_line;
use outcome::assessment::Assessment;
use outcome::published;
use outcome::warning::{self, Warning};
use report::{Appendix, Figure, Material, Photograph, StageLine, StageState};
use serde_json::{Value, json};
use stages::Stages;

bridge::choice! {
    /// A stage that can be left out.
    pub enum StageName {
        /// Moduli from records; the file's own values count
        Update = "update",
        /// The train that crosses
        Service = "service",
        /// The loads of the file at collapse
        Collapse = "collapse",
        /// The vehicles of [sweep]
        Vehicles = "vehicles",
        /// The named cases of the file
        Cases = "cases",
        /// The support that moves
        SupportMovement = "support-movement",
        /// What would change the verdict
        Sensitivity = "sensitivity",
    }
}

/// What an assessment leaves out, and what its report says of how it was made.
#[derive(Debug, Clone, Default)]
pub struct AssessOptions {
    /// Stages to leave out.
    pub skip: Vec<StageName>,
    /// The command or program that made it.
    pub command: String,
    /// The day, as year-month-day.
    pub day: String,
}

/// A bridge that was judged.
#[derive(Debug)]
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

/// Makes every stage that the file asks for and judges the bridge. Stages are kept on the shelf as they are finished; none is given
/// where somebody asked to stop.
///
/// # Errors
/// A file that cannot be used (F108, F114).
pub fn assess(
    project: &Project,
    options: &AssessOptions,
    means: &Means<'_>,
    watch: &mut dyn Watch,
) -> Result<Option<Assessed>, Refusal> {
    let watch = Remembering { watch, stopped: false };
    let mut stages = Stages { project, skip: &options.skip, means, watch, figures: Vec::new(), lines: Vec::new() };
    let assessment = match stages.run() {
        Ok(made) => made,
        Err(halt) => return halt.map_or(Ok(None), Err),
    };
    let Stages { figures, lines, .. } = stages;
    let appendix = Appendix {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        program: means.program.to_owned(),
        file: one_line(project.name()).into_owned(),
        input: blake3::hash(project.text()).to_hex().to_string(),
        command: one_line(&options.command).into_owned(),
        day: options.day.clone(),
        stages: lines,
    };
    let findings = project.findings().iter().map(|finding| {
        let place = bridge::text::position(project.text(), finding.range.start);
        [finding.code.to_owned(), finding.message.clone(), format!("line {}", place.line)]
    });
    let inputs = bridge::inputs::inputs(&String::from_utf8_lossy(project.text()));
    let findings = findings.collect();
    let document = project.meaning().document.clone().unwrap_or_default();
    let photographs = project.photographs().to_vec();
    Ok(Some(Assessed { assessment, figures, inputs, findings, appendix, document, photographs }))
}

impl Assessed {
    /// What its report is made of.
    pub fn material(&self) -> Material<'_> {
        Material {
            assessment: &self.assessment,
            figures: &self.figures,
            inputs: &self.inputs,
            findings: &self.findings,
            appendix: &self.appendix,
            document: &self.document,
            photographs: &self.photographs,
        }
    }

    /// The report as one self-contained page.
    pub fn html(&self) -> String {
        report::html(&self.material())
    }

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
