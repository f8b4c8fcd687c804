//! Block model files: blocks that are listed, or drawn in a DXF file.

use crate::args::{Check, Collapse};
use crate::checkpoint::Checkpoint;
use crate::desk::Desk;
use crate::folder::{self, Folder, Purpose};
use crate::render::{self, Paint};
use crate::report::Report;
use crate::results::{self, Written};
use crate::status::Status;
use crate::watcher::Watcher;
use bridge::blocks::Role;
use extrados::{Blocks, CollapseOptions, Disk, Refusal, collapse_of_blocks};
use findings::words::counted;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use structure::blocks::Scene;

/// A block model file that was read, and shown what was found in it.
pub(super) struct Model(pub Blocks);

impl Model {
    /// Reads a file and its drawing, and shows what was found in them.
    pub(super) fn open(desk: &mut Desk, path: &Path) -> Result<Model, Refusal> {
        let blocks = Blocks::read(path, &Disk)?;
        if blocks.scene().is_none() || !desk.screen.quiet {
            let paint = Paint::for_stderr();
            if let Some((place, findings)) = blocks.drawing() {
                desk.screen.remark(&render::drawing(&place.display().to_string(), findings, &paint));
            }
            desk.screen.remark(&render::findings(blocks.name(), blocks.text(), blocks.findings(), &paint));
        }
        Ok(Model(blocks))
    }

    /// The folder for the results of a run of this kind.
    fn folder(&self, path: &Path, kind: &str) -> Result<Folder, Refusal> {
        let inputs: Vec<PathBuf> = self.0.drawing().map(|(place, _)| place.to_owned()).into_iter().collect();
        Folder::prepare(path, Purpose::new(kind, Path::new(self.0.name()), &inputs))
    }

    /// An answer with what was found.
    pub(super) fn report(&self, status: Status) -> Report {
        let mut report = Report::new(status);
        if let Some((place, findings)) = self.0.drawing() {
            report.add_drawing(&place.display().to_string(), findings);
        }
        report.add_findings(self.0.name(), self.0.text(), self.0.findings());
        report
    }
}

/// Reads the model and draws it.
pub(super) fn check(desk: &mut Desk, arguments: &Check) -> Result<Report, Refusal> {
    let model = Model::open(desk, &arguments.file)?;
    let (Some(scene), Some(picture)) = (model.0.scene(), model.0.as_built()) else {
        return Ok(model.report(Status::UnusableInput));
    };
    let folder = model.folder(&folder::named(&arguments.out, &arguments.file), "check")?;
    let drawings = vec![("bridge".to_owned(), figures::bridge_as_drawn(&picture))];
    let names = results::put(&folder, Written { drawings, ..Written::default() })?;
    let shown = folder.path().display().to_string();
    let report = model
        .report(Status::Completed)
        .with("bridge", scene.name.as_str())
        .with("width_m", scene.width)
        .with("blocks", scene.bodies.len())
        .with("particles", scene.particles.len())
        .with("layers", layers(scene))
        .with("loads", scene.forces.len())
        .with("out", shown.as_str())
        .with("files", names)
        .saying(summary(scene, &shown));
    Ok(report)
}

/// Bodies by layer: material, role, how many.
fn counts(scene: &Scene) -> BTreeMap<(String, String, &'static str), usize> {
    let mut counts = BTreeMap::new();
    let material = |k: usize| scene.materials[k].name.clone();
    for body in &scene.bodies {
        let role = if body.held { Role::Support } else { Role::Block };
        *counts.entry((body.layer.clone(), material(body.material), role.word())).or_insert(0) += 1;
    }
    for particle in &scene.particles {
        let key = (particle.layer.clone(), material(particle.material), Role::Particles.word());
        *counts.entry(key).or_insert(0) += 1;
    }
    counts
}

fn layers(scene: &Scene) -> Vec<Value> {
    let row = |((layer, material, role), count): ((String, String, &str), usize)| json!({ "layer": layer, "material": material, "role": role, "count": count });
    counts(scene).into_iter().map(row).collect()
}

fn summary(scene: &Scene, out: &str) -> String {
    let mut page = format!(
        "{}, {}, {}\n\n",
        scene.name,
        counted(scene.bodies.len(), "block"),
        counted(scene.particles.len(), "particle")
    );
    let _ = writeln!(page, "  {:<20}  {:<20}  {:<9}  {:>6}", "layer", "material", "role", "count");
    for ((layer, material, role), count) in counts(scene) {
        let _ = writeln!(page, "  {layer:<20}  {material:<20}  {role:<9}  {count:>6}");
    }
    for force in &scene.forces {
        let [x, y] = force.force.map(|component| component / 1e3 + 0.0);
        let name = &scene.bodies[force.body].name;
        let _ = writeln!(page, "  load: {} on {name}, ({x:.3}, {y:.3}) kN/m to the right and up", force.name);
    }
    let _ = writeln!(page, "\nThe file can be used. The model is drawn in {out}");
    page
}

/// Reads the model, makes the analysis, writes its results.
pub(super) fn collapse(desk: &mut Desk, arguments: &Collapse) -> Result<Report, Refusal> {
    let model = Model::open(desk, &arguments.file)?;
    let Some(scene) = model.0.scene() else { return Ok(model.report(Status::UnusableInput)) };
    let arch = "this analysis needs an arch: a block model has no ring";
    let remedy = "leave the option out, or describe the arch in a bridge file";
    if arguments.sweep || arguments.choice.analysis.is_some_and(|analysis| analysis != bridge::Analysis::Load) {
        return Err(Refusal::new("F108", arch, remedy));
    }
    let choice = super::collapse::choice(scene.width, arguments)?;
    let scene = model.0.planned(&CollapseOptions { choice, resume: None })?;
    let out = folder::named(&arguments.out, &arguments.file);
    let folder = model.folder(&out, &super::collapse::kind(&scene.plan, None))?;
    let run = |resume: Option<Vec<u8>>, watcher: &mut Watcher<'_>| {
        collapse_of_blocks(&model.0, &CollapseOptions { choice, resume }, watcher)
    };
    let checkpoint = Checkpoint::of(&scene, &folder);
    super::collapse::analyse(desk, arguments, model.report(Status::Completed), checkpoint, &folder, run)
}
