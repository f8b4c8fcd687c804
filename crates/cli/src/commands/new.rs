//! `extrados new`: a working example to edit.

use crate::failure;
use crate::folder;
use crate::report::Report;
use crate::status::Status;
use extrados::Refusal;
use extrados::examples::{self, Example, File};
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::Path;

/// Writes the example's files into a new or empty folder.
pub(super) fn run(dir: &Path, from: &str) -> Result<Report, Refusal> {
    let example = examples::named(from).ok_or_else(|| unknown(from))?;
    write(example, dir)?;
    let names: Vec<&str> = example.files.iter().map(|file| file.name).collect();
    let first = dir.join(example.main);
    let mut summary = format!("{}: {}\n", dir.display(), example.about);
    for file in example.files {
        let _ = writeln!(summary, "  {:<16} {}", file.name, file.about());
    }
    let _ = writeln!(summary, "next: extrados {} {}", example.command(), first.display());
    Ok(Report::new(Status::Completed)
        .with("example", example.name)
        .with("folder", dir.display().to_string())
        .with("files", names)
        .saying(summary))
}

/// Writes the files into a folder beside the place, which then takes its name: it is there whole or not at all.
fn write(example: &Example, dir: &Path) -> Result<(), Refusal> {
    let unwritable = |error: io::Error| failure::unwritable(dir, &error);
    match fs::read_dir(dir) {
        Ok(mut entries) => {
            if entries.next().is_some() {
                let message = format!("{} exists and is not empty", dir.display());
                return Err(Refusal::new("F103", message, "name a folder that does not exist yet"));
            }
            // The folder may be the current one, which nothing can take the place of.
            return fill(example, dir).map_err(unwritable);
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => return Err(unwritable(error)),
    }
    if let Some(parent) = dir.parent() {
        fs::create_dir_all(parent).map_err(unwritable)?;
    }
    let beside = folder::partial(dir);
    let written = fill(example, &beside).and_then(|()| fs::rename(&beside, dir));
    if written.is_err() {
        let _ = fs::remove_dir_all(&beside);
    }
    written.map_err(unwritable)
}

fn fill(example: &Example, dir: &Path) -> io::Result<()> {
    let write = |file: &File| folder::write_whole(folder::with_room(&dir.join(file.name))?, file.text.as_bytes());
    example.files.iter().try_for_each(write)
}

fn unknown(name: &str) -> Refusal {
    let names: Vec<&str> = examples::ALL.iter().map(|example| example.name).collect();
    Refusal::new("F104", format!("there is no example called {name}"), format!("the examples are {}", names.join(", ")))
}
