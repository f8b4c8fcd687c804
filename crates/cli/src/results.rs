//! From an analysis to its folder of results.

use crate::commands::Desk;
use crate::failure::Failure;
use crate::folder::Folder;
use crate::report::{self, Report};
use crate::status::Status;
use assess::analysis::AnalysisError;
use figures::RasterError;
use serde_json::json;
use std::fs;
use std::io;
use std::path::Path;

/// An analysis that cannot be set up.
pub fn not_set_up(error: &AnalysisError) -> Failure {
    cannot_be_set_up(&error.to_string())
}

/// The same from its words.
pub fn cannot_be_set_up(message: &str) -> Failure {
    Failure::input("F108", message, "extrados explain F108 tells what each analysis needs")
}

/// A figure that cannot be drawn is a result that cannot be written.
pub fn not_drawn(folder: &Path, error: &RasterError) -> Failure {
    Failure::not_written(folder, &io::Error::other(error.to_string()))
}

/// Writes files into a folder, with folders of their own where their names have them.
fn write(folder: &Path, files: &[figures::File]) -> io::Result<()> {
    for file in files {
        let path = folder.join(&file.name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(path, &file.bytes)?;
    }
    Ok(())
}

/// Moves the files into the folder, sealed with the object that scripts read.
pub fn publish(desk: &Desk, mut report: Report, folder: &Folder, files: &[figures::File]) -> Result<Report, Failure> {
    report.fields.insert("out".to_owned(), json!(folder.path().display().to_string()));
    folder.fill(
        |staging| write(staging, files),
        |names| {
            report.fields.insert("files".to_owned(), json!(names));
            report::text_of(&report.object(&desk.schema, desk.clock))
        },
    )?;
    Ok(report)
}

/// Tables (name without extension, text) as files; those without a row are left out.
pub fn tables<'a>(all: impl IntoIterator<Item = (&'a str, String)>) -> impl Iterator<Item = figures::File> {
    let filled = all.into_iter().filter(|(_, text)| text.lines().nth(1).is_some());
    filled.map(|(name, text)| figures::File { name: format!("{name}.csv"), bytes: text.into_bytes() })
}

/// The status of an analysis as a status of the command.
pub fn status(status: assess::analysis::Status) -> Status {
    Status::named(status.word()).unwrap_or(Status::NotConverged)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_status_of_an_analysis_is_one_of_the_command() {
        for one in assess::analysis::Status::ALL {
            assert_eq!(status(one).name(), one.word());
            assert_eq!(status(one).exit_code(), one.exit_code());
        }
    }
}
