//! From an analysis to its folder of results.

use crate::failure::Failure;
use crate::status::Status;
use assess::analysis::AnalysisError;
use figures::RasterError;
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
pub fn write(folder: &Path, files: &[figures::File]) -> io::Result<()> {
    for file in files {
        let path = folder.join(&file.name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(path, &file.bytes)?;
    }
    Ok(())
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
