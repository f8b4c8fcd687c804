//! `extrados new`: a working example to edit.

use crate::args::New;
use crate::failure::Failure;
use crate::folder;
use crate::report::Report;
use crate::status::Status;
use extrados::examples::{self, Example};
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::Path;

/// Writes the example's files into a new or empty folder.
pub fn run(arguments: &New) -> Result<Report, Failure> {
    let example = examples::named(&arguments.from).ok_or_else(|| unknown(&arguments.from))?;
    write(example, &arguments.dir)?;
    let names: Vec<&str> = example.files.iter().map(|file| file.name).collect();
    let first = arguments.dir.join(example.main);
    let mut summary = format!("{}: {}\n", arguments.dir.display(), example.about);
    for file in example.files {
        let _ = writeln!(summary, "  {:<16} {}", file.name, file.about());
    }
    let _ = writeln!(summary, "next: extrados {} {}", example.command(), first.display());
    Ok(Report::new(Status::Completed)
        .with("example", example.name)
        .with("folder", arguments.dir.display().to_string())
        .with("files", names)
        .saying(summary))
}

fn write(example: &Example, dir: &Path) -> Result<(), Failure> {
    let unwritable = |error: io::Error| Failure::unwritable(dir, &error);
    match fs::read_dir(dir) {
        Ok(mut entries) => {
            if entries.next().is_some() {
                let message = format!("{} exists and is not empty", dir.display());
                return Err(Failure::input("F103", message, "name a folder that does not exist yet"));
            }
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => fs::create_dir_all(dir).map_err(unwritable)?,
        Err(error) => return Err(unwritable(error)),
    }
    for file in example.files {
        let path = dir.join(file.name);
        path.parent().map_or(Ok(()), fs::create_dir_all).map_err(unwritable)?;
        folder::write_whole(&path, file.text.as_bytes()).map_err(unwritable)?;
    }
    Ok(())
}

fn unknown(name: &str) -> Failure {
    let names: Vec<&str> = examples::ALL.iter().map(|example| example.name).collect();
    Failure::input(
        "F104",
        format!("there is no example called {name}"),
        format!("the examples are {}", names.join(", ")),
    )
}
