//! Block model files: blocks that are listed, or drawn in a DXF file.

use super::{Desk, read_text};
use crate::args::{Check, Collapse};
use crate::checkpoint::Checkpoint;
use crate::failure::Failure;
use crate::folder::{self, Folder, Purpose};
use crate::render::{self, Paint};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::Watcher;
use assess::analysis;
use bridge::blocks::{DrawingPart, Role};
use bridge::{Diagnostic, Method, Severity};
use extrados::Looking;
use mechanics::blocks::ModelError;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use structure::blocks::{Scene, assemble};

/// A block model file that was read, with its drawing.
pub struct Model {
    /// As the command line names it.
    name: String,
    text: Vec<u8>,
    diagnostics: Vec<Diagnostic>,
    /// Path of its drawing, where it names one.
    pub drawing: Option<PathBuf>,
    findings: Vec<drawing::Finding>,
    /// The model, unless something is wrong with it.
    pub scene: Option<Scene>,
}

impl Model {
    /// Reads a file and its drawing, and shows what was found in them.
    pub fn open(desk: &mut Desk, path: &Path) -> Result<Model, Failure> {
        let text = read_text(path)?;
        let bridge::ReadBlocks { file, mut diagnostics } = bridge::read_blocks(&text);
        let name = path.display().to_string();
        let (mut findings, mut scene, mut place) = (Vec::new(), None, None);
        if let Some(file) = file {
            let part = file.drawing.as_ref();
            place = part.map(|part| beside(path, &part.file));
            match place.as_deref().map(bytes).transpose() {
                Ok(bytes) => {
                    let assembled = assemble(&file, bytes.as_deref());
                    (findings, scene) = (assembled.findings, assembled.scene);
                    diagnostics.extend(assembled.diagnostics);
                }
                Err(error) => diagnostics.extend(part.map(|part| unreadable(part, place.as_deref(), &error))),
            }
        }
        let model = Model { name, text, diagnostics, drawing: place, findings, scene };
        if model.scene.is_none() || !desk.screen.quiet {
            let paint = Paint::for_stderr();
            if let Some(place) = &model.drawing {
                desk.screen.remark(&render::drawing(&place.display().to_string(), &model.findings, &paint));
            }
            desk.screen.remark(&render::findings(&model.name, &model.text, &model.diagnostics, &paint));
        }
        Ok(model)
    }

    /// The folder for the results of a run of this kind.
    fn folder(&self, path: &Path, kind: &str) -> Result<Folder, Failure> {
        let inputs: Vec<PathBuf> = self.drawing.iter().cloned().collect();
        Folder::prepare(path, Purpose::new(kind, Path::new(&self.name), &inputs))
    }

    /// An answer with what was found.
    pub fn report(&self, status: Status) -> Report {
        let mut report = Report::new(status);
        if let Some(place) = &self.drawing {
            report.add_drawing(&place.display().to_string(), &self.findings);
        }
        report.add_findings(&self.name, &self.text, &self.diagnostics);
        report
    }
}

/// A path inside a file is relative to it.
fn beside(file: &Path, name: &str) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).join(name)
}

/// No drawing is longer [bytes]; reading stops there, whatever the path leads to.
const LONGEST: u64 = 65 << 20;

/// The bytes of a drawing.
pub fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    if path.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(LONGEST).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn unreadable(part: &DrawingPart, path: Option<&Path>, error: &io::Error) -> Diagnostic {
    let reason = Failure::unreadable(path.unwrap_or(Path::new(&part.file)), error);
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

/// Reads the model and draws it.
pub fn check(desk: &mut Desk, arguments: &Check) -> Result<Report, Failure> {
    let model = Model::open(desk, &arguments.file)?;
    let Some(scene) = &model.scene else { return Ok(model.report(Status::UnusableInput)) };
    let picture = analysis::blocks_as_built(scene);
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = model.folder(&out, "check")?;
    let drawing = figures::both("bridge", &figures::bridge_as_drawn(&picture));
    let files = drawing.map_err(|error| results::not_drawn(folder.path(), &error))?;
    let pairs: Vec<(&str, &[u8])> = files.iter().map(|file| (file.name.as_str(), file.bytes.as_slice())).collect();
    folder.put(&pairs)?;
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
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
        let role = word(if body.held { Role::Support } else { Role::Block });
        *counts.entry((body.layer.clone(), material(body.material), role)).or_insert(0) += 1;
    }
    for particle in &scene.particles {
        let key = (particle.layer.clone(), material(particle.material), word(Role::Particles));
        *counts.entry(key).or_insert(0) += 1;
    }
    counts
}

fn word(role: Role) -> &'static str {
    match role {
        Role::Block => "block",
        Role::Support => "support",
        Role::Particles => "particles",
        Role::Ignore => "ignore",
    }
}

fn layers(scene: &Scene) -> Vec<Value> {
    let row = |((layer, material, role), count): ((String, String, &str), usize)| json!({ "layer": layer, "material": material, "role": role, "count": count });
    counts(scene).into_iter().map(row).collect()
}

fn summary(scene: &Scene, out: &str) -> String {
    let mut page = format!("{}, {} blocks, {} particles\n\n", scene.name, scene.bodies.len(), scene.particles.len());
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
pub fn collapse(desk: &mut Desk, arguments: &Collapse) -> Result<Report, Failure> {
    let mut model = Model::open(desk, &arguments.file)?;
    let Some(mut scene) = model.scene.take() else { return Ok(model.report(Status::UnusableInput)) };
    let arch = "this analysis needs an arch: a block model has no ring";
    let remedy = "leave the option out, or describe the arch in a bridge file";
    if arguments.sweep || arguments.choice.analysis.is_some_and(|analysis| analysis != crate::args::Analysis::Load) {
        return Err(Failure::input("F108", arch, remedy));
    }
    super::collapse::choice(scene.width, arguments)?.apply(&mut scene.plan);
    if !scene.particles.is_empty() && scene.plan.method == Method::Limit {
        let message = ModelError::ParticlesInLimitAnalysis(scene.particles.len()).to_string();
        let help = "say --method dem, or give their layers role = \"ignore\" to analyse the blocks alone";
        return Err(Failure::input("D406", message, help));
    }
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = model.folder(&out, &super::collapse::kind(&scene.plan, None))?;
    let run = |resume: Option<Vec<u64>>, watcher: &mut Watcher| {
        analysis::collapse_of_blocks(&scene, resume.as_deref(), &mut Looking(watcher))
            .map_err(|error| results::not_set_up(&error))
    };
    let checkpoint = Checkpoint::of(&scene, &folder);
    super::collapse::analyse(desk, arguments, model.report(Status::Completed), checkpoint, &folder, run)
}
