//! The whole chain of a bridge against the limits of its file, and what its report is made of.

mod kept;
mod pictures;
mod stages;

use crate::means::Means;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Remembering, Watch};
use findings::visible::one_line;
use report::Appendix;
pub use report::Assessed;
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
        version: crate::VERSION.to_owned(),
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
