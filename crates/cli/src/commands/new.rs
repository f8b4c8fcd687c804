//! `extrados new`: the file of a bridge from what a survey measured, or a working example to edit.

use super::source::Source;
use crate::args::{New, Survey};
use crate::desk::Desk;
use crate::failure;
use crate::folder;
use crate::render::{self, Paint};
use crate::report::Report;
use crate::status::Status;
use assess::vehicles;
use bridge::survey::{self, Unusable};
use extrados::examples;
use extrados::{Disk, Refusal};
use findings::words::counted;
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::Path;

/// The example that is written where nothing else is asked for.
const FIRST: &str = "bridgemill";
/// The file of a surveyed bridge.
const BRIDGE: &str = "bridge.toml";

/// Writes the files into a new or empty folder.
pub(super) fn run(desk: &mut Desk, arguments: &New) -> Result<Report, Refusal> {
    match arguments.survey.span {
        Some(_) => surveyed(desk, &arguments.dir, &arguments.survey),
        None => example(&arguments.dir, arguments.from.as_deref().unwrap_or(FIRST)),
    }
}

/// The examples, a line each, for the end of the help.
pub(crate) fn examples_of_new() -> String {
    let mut page = String::from("Examples for --from:\n");
    for example in examples::ALL {
        let _ = writeln!(page, "  {:<14} {}", example.name, example.about);
    }
    page + "\nYour own bridge:\n  extrados new mill-lane --span 6 --rise 1.5 --ring 0.45 --width 5 --cover 0.5 --rule cs-454"
}

fn example(dir: &Path, from: &str) -> Result<Report, Refusal> {
    let example = examples::named(from).ok_or_else(|| unknown(from))?;
    let files: Vec<(&str, &[u8])> = example.files.iter().map(|file| (file.name, file.text.as_bytes())).collect();
    write(&files, dir)?;
    let first = dir.join(example.main);
    let mut summary = format!("{}: {}\n", dir.display(), example.about);
    let longest = example.files.iter().map(|file| file.name.len()).max().unwrap_or(0);
    for file in example.files {
        let _ = writeln!(summary, "  {:<longest$}  {}", file.name, file.about());
    }
    let _ = writeln!(summary, "next: extrados {} {}", example.command(), first.display());
    let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
    Ok(Report::new(Status::Completed)
        .with("example", example.name)
        .with("folder", dir.display().to_string())
        .with("files", names)
        .saying(summary))
}

/// The bridge file of these answers, with what is doubtful of it.
fn surveyed(desk: &mut Desk, dir: &Path, said: &Survey) -> Result<Report, Refusal> {
    let name = said.name.clone().or_else(|| dir.file_name().map(|name| name.to_string_lossy().into_owned()));
    let text = survey::file(name.as_deref().unwrap_or("Bridge"), &|key| said.answer(key)).map_err(slips)?;
    known(&text)?;
    write(&[(BRIDGE, text.as_bytes())], dir)?;
    let assumed: Vec<&str> = text.lines().filter(|line| line.contains("# assumed")).map(str::trim).collect();
    let first = dir.join(BRIDGE);
    let mut summary = format!(
        "{}: what was measured; assumed, to be replaced by what is known: {}\n",
        first.display(),
        counted(assumed.len(), "value")
    );
    assumed.iter().for_each(|line| summary.push_str(&format!("  {line}\n")));
    let next = if said.rule.is_some() { "assess" } else { "collapse" };
    let _ = writeln!(summary, "next: extrados {next} {}", first.display());
    let source = Source::read(&first, &Disk)?;
    let project = &source.project;
    desk.screen.remark(&render::findings(project.name(), project.text(), project.findings(), &Paint::for_stderr()));
    Ok(source
        .report(Status::Completed)
        .with("folder", dir.display().to_string())
        .with("files", vec![BRIDGE])
        .with("assumed", assumed)
        .saying(summary))
}

/// What the flags are called that answer the questions of a survey otherwise named.
const FLAGS: [(&str, &str); 7] = [
    ("thickness", "--ring"),
    ("unit", "--stone"),
    ("pier_width", "--pier-width"),
    ("pier_height", "--pier-height"),
    ("vehicles", "--vehicle"),
    ("fill_density", "--fill-density"),
    ("lost_mortar", "--lost-mortar"),
];

impl Survey {
    /// The answer to a question.
    fn answer(&self, key: &str) -> Option<String> {
        match key {
            "span" => self.span.clone(),
            "rise" => self.rise.clone(),
            "thickness" => self.ring.clone(),
            "width" => self.width.clone(),
            "cover" => self.cover.clone(),
            "unit" => self.stone.clone(),
            "backing" => self.backing.clone(),
            "density" => self.density.clone(),
            "strength" => self.strength.clone(),
            "axle" => self.axle.clone(),
            "spans" => self.spans.clone(),
            "pier_width" => self.pier_width.clone(),
            "pier_height" => self.pier_height.clone(),
            "reference" => self.reference.clone(),
            "rings" => self.rings.clone(),
            "bond" => self.bond.clone(),
            "skew" => self.skew.clone(),
            "fill" => self.fill.clone(),
            "fill_density" => self.fill_density.clone(),
            "lost_mortar" => self.lost_mortar.clone(),
            "condition" => self.condition.clone(),
            "rule" => self.rule.clone(),
            "vehicles" => Some(self.vehicle.join(",")),
            _ => None,
        }
    }
}

/// All answers that are none, by their flags.
fn slips(wrong: Vec<Unusable>) -> Refusal {
    let said = |text: &str, key: &str| {
        let flag = FLAGS.iter().find(|(one, _)| *one == key).map_or(format!("--{key}"), |(_, flag)| (*flag).to_owned());
        text.replacen(key, &flag, 1)
    };
    let message: Vec<String> = wrong.iter().map(|one| said(&one.message, &one.key)).collect();
    let help: Vec<String> = wrong.iter().map(|one| said(&one.help, &one.key)).collect();
    Refusal::new("F108", message.join("; "), help.join("; "))
}

/// Refuses a rule or vehicles that the library has not, or that do not go together.
fn known(text: &str) -> Result<(), Refusal> {
    let Some(bridge) = bridge::read(text.as_bytes()).bridge else { return Ok(()) };
    match bridge.sweep.as_ref().map(|plan| vehicles::chosen(&bridge, plan)) {
        Some(Err(refused)) => {
            Err(Refusal::new("F126", refused.to_string(), "extrados vehicles lists rules and vehicles"))
        }
        _ => Ok(()),
    }
}

/// Writes the files into a folder beside the place, which then takes its name: it is there whole or not at all.
pub(super) fn write(files: &[(&str, &[u8])], dir: &Path) -> Result<(), Refusal> {
    let unwritable = |error: io::Error| failure::unwritable(dir, &error);
    match fs::read_dir(dir) {
        Ok(mut entries) => {
            if entries.next().is_some() {
                let message = format!("{} exists and is not empty", dir.display());
                return Err(Refusal::new("F103", message, "name a folder that does not exist yet"));
            }
            // The folder may be the current one, which nothing can take the place of.
            return fill(files, dir).map_err(unwritable);
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => return Err(unwritable(error)),
    }
    if let Some(parent) = dir.parent() {
        fs::create_dir_all(parent).map_err(unwritable)?;
    }
    let beside = folder::partial(dir);
    let written = fill(files, &beside).and_then(|()| fs::rename(&beside, dir));
    if written.is_err() {
        let _ = fs::remove_dir_all(&beside);
    }
    written.map_err(unwritable)
}

fn fill(files: &[(&str, &[u8])], dir: &Path) -> io::Result<()> {
    let write = |(name, bytes): &(&str, &[u8])| folder::write_whole(folder::with_room(&dir.join(name))?, bytes);
    files.iter().try_for_each(write)
}

fn unknown(name: &str) -> Refusal {
    let names: Vec<&str> = examples::ALL.iter().map(|example| example.name).collect();
    Refusal::new("F104", format!("there is no example called {name}"), format!("the examples are {}", names.join(", ")))
}
