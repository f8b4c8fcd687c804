//! A block model file with its drawing: blocks that are listed, or drawn.

use crate::collapse::CollapseOptions;
use crate::companions;
use crate::files::{Files, LONGEST_DRAWING};
use crate::refusal::Refusal;
use crate::watch::{Looking, Watch};
use ::drawing::Finding;
use assess::analysis;
use bridge::blocks::DrawingPart;
use bridge::{Diagnostic, Method, ReadBlocks, Severity};
use mechanics::blocks::ModelError;
use outcome::collapse::Collapse;
use outcome::picture::Picture;
use std::path::{Path, PathBuf};
use structure::blocks::{Scene, assemble};

/// A block model file that was read, with the drawing that it names.
#[derive(Debug, Clone)]
pub struct Blocks {
    name: String,
    text: Vec<u8>,
    diagnostics: Vec<Diagnostic>,
    drawing: Option<(PathBuf, Vec<Finding>)>,
    scene: Option<Scene>,
}

impl Blocks {
    /// Reads a file and its drawing. One with mistakes is read as well: they are among its findings, and it has no
    /// [`scene`](Self::scene).
    ///
    /// # Errors
    /// A file that cannot be read (F101).
    pub fn read(path: impl AsRef<Path>, files: &dyn Files) -> Result<Blocks, Refusal> {
        let path = path.as_ref();
        let text = companions::main_text(path, files)?;
        let ReadBlocks { file, mut diagnostics } = bridge::read_blocks(&text);
        let (mut drawing, mut scene) = (None, None);
        if let Some(file) = file {
            let drawn = file.drawing.as_ref().map(|part| {
                let place = path.parent().unwrap_or(Path::new("")).join(&part.file);
                let bytes = files
                    .read_at_most(&place, LONGEST_DRAWING)
                    .map_err(|error| unreadable(part, Refusal::unreadable(&place, &error)));
                (place, bytes)
            });
            let (place, bytes) = drawn.unzip();
            let mut found = Vec::new();
            match bytes.transpose() {
                Ok(bytes) => {
                    let assembled = assemble(&file, bytes.as_deref());
                    (found, scene) = (assembled.findings, assembled.scene);
                    diagnostics.extend(assembled.diagnostics);
                }
                Err(diagnostic) => diagnostics.push(diagnostic),
            }
            drawing = place.map(|place| (place, found));
        }
        Ok(Blocks { name: path.display().to_string(), text, diagnostics, drawing, scene })
    }

    /// The path of the file, as it was given.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text of the file, in UTF-8.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// What was found in the file, in its order.
    pub fn findings(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The path of its drawing and what was found there; none where it names none.
    pub fn drawing(&self) -> Option<(&Path, &[Finding])> {
        self.drawing.as_ref().map(|(place, found)| (place.as_path(), found.as_slice()))
    }

    /// The model; none where something is wrong with it.
    pub fn scene(&self) -> Option<&Scene> {
        self.scene.as_ref()
    }

    /// The model as it is described, for drawing; none where something is wrong with it.
    pub fn as_built(&self) -> Option<Picture> {
        self.scene.as_ref().map(analysis::blocks_as_built)
    }

    /// The model with what was chosen in place of its plan.
    ///
    /// # Errors
    /// A model that cannot be used (F108), or particles in limit analysis (D406).
    pub fn planned(&self, options: &CollapseOptions) -> Result<Scene, Refusal> {
        let unusable = || {
            let help = "extrados check FILE shows every error with its place";
            Refusal::new("F108", format!("{} cannot be used", self.name), help)
        };
        let mut scene = self.scene.clone().ok_or_else(unusable)?;
        options.choice.apply(&mut scene.plan);
        if !scene.particles.is_empty() && scene.plan.method == Method::Limit {
            let message = ModelError::ParticlesInLimitAnalysis(scene.particles.len()).to_string();
            let help = "say --method dem, or give their layers role = \"ignore\" to analyse the blocks alone";
            return Err(Refusal::new("D406", message, help));
        }
        Ok(scene)
    }
}

/// The load that makes a mechanism of a model. An interrupted run ends with the status `cancelled`.
///
/// # Errors
/// Those of [`Blocks::planned`], or an analysis that cannot be set up (F108).
pub fn collapse_of_blocks(
    blocks: &Blocks,
    options: &CollapseOptions,
    watch: &mut dyn Watch,
) -> Result<Collapse, Refusal> {
    let scene = blocks.planned(options)?;
    Ok(analysis::collapse_of_blocks(&scene, options.resume.as_deref(), &mut Looking(watch))?)
}

fn unreadable(part: &DrawingPart, reason: Refusal) -> Diagnostic {
    Diagnostic {
        code: "D101",
        severity: Severity::Error,
        message: reason.message,
        range: part.range,
        label: "path of the drawing, relative to this file".to_owned(),
        note: None,
        help: Some("check the path".to_owned()),
    }
}
