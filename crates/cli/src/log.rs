//! The log of an update: every finished evaluation as a line of a file in the folder of results.

use crate::failure;
use crate::folder::Folder;
use crate::signs;
use calibrate::Log;
use calibrate::log::Unreadable;
use extrados::Refusal;
use extrados::files::{LONGEST, read_at_most};
use std::fs::{File, OpenOptions};
use std::io::{self, Write as _};
use std::path::PathBuf;

pub(crate) const NAME: &str = "evaluations.log";

/// A log that is written to.
pub(crate) struct LogFile {
    path: PathBuf,
    file: File,
    trouble: Option<io::Error>,
}

impl LogFile {
    /// What an earlier run of the same model did, if it is to be taken up, and the file for what comes.
    pub(crate) fn open(folder: &Folder, identity: &str, resume: bool) -> Result<(Log, LogFile), Refusal> {
        let path = folder.file(NAME);
        let log = match read(&path)? {
            Some(text) if resume => take_up(folder, identity, &text)?,
            Some(text) => {
                make_way(folder, &text)?;
                Log::new(identity)
            }
            None if resume => {
                let kept = read(&aside(folder, identity))?;
                kept.and_then(|text| Log::read(identity, &text).ok()).map_or_else(|| Log::new(identity), |(log, _)| log)
            }
            None => Log::new(identity),
        };
        // Written anew, so that a torn last line of a killed run does not spoil the next one.
        let unwritable = |error: io::Error| failure::not_written(&path, &error);
        crate::folder::write_whole(&path, log.text().as_bytes()).map_err(unwritable)?;
        let file = OpenOptions::new().append(true).open(&path).map_err(unwritable)?;
        let words = format!("evaluations are kept in {}\nthe same command with --resume goes on", path.display());
        signs::keeps("log", &path, words);
        Ok((log, LogFile { path, file, trouble: None }))
    }

    /// Adds a line.
    pub(crate) fn append(&mut self, line: &str) {
        if let Err(error) = self.file.write_all(format!("{line}\n").as_bytes()) {
            self.trouble.get_or_insert(error);
        }
    }

    /// What kept a line from being kept.
    pub(crate) fn trouble(&self) -> Option<Refusal> {
        self.trouble.as_ref().map(|error| failure::not_written(&self.path, error))
    }
}

fn read(path: &std::path::Path) -> Result<Option<String>, Refusal> {
    match read_at_most(path, LONGEST) {
        Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Refusal::unreadable(path, &error)),
    }
}

/// Keeps the log of an earlier run under a name of its own; a file that is no log is refused.
fn make_way(folder: &Folder, text: &str) -> Result<(), Refusal> {
    // No model has an empty identity: the answer tells whose log it is.
    let Err(Unreadable::Other { identity }) = Log::read("", text) else {
        return Err(failure::replaces_foreign(folder.path(), &[(false, NAME.to_owned())]));
    };
    let aside = aside(folder, &identity);
    std::fs::rename(folder.file(NAME), &aside).map_err(|error| failure::not_written(&aside, &error))
}

/// Where the evaluations of a model are kept while another one's stand in the log.
fn aside(folder: &Folder, identity: &str) -> PathBuf {
    let hash = blake3::hash(identity.as_bytes()).to_hex();
    folder.file(&format!("evaluations-{}.log", &hash.as_str()[..16]))
}

fn take_up(folder: &Folder, identity: &str, text: &str) -> Result<Log, Refusal> {
    let path = folder.file(NAME);
    match Log::read(identity, text) {
        Ok((log, _)) => Ok(log),
        Err(Unreadable::Other { .. }) => {
            let kept = read(&aside(folder, identity))?;
            if let Some((log, _)) = kept.and_then(|text| Log::read(identity, &text).ok()) {
                make_way(folder, text)?;
                return Ok(log);
            }
            let message = format!("{} belongs to another bridge or other parameters", path.display());
            Err(Refusal::new("F106", message, "repeat the command that was interrupted, or run without --resume"))
        }
        Err(Unreadable::NoLog) => {
            let message = format!("cannot use {}: it is no log of evaluations", path.display());
            Err(Refusal::new("F110", message, "run without --resume to start anew"))
        }
    }
}
