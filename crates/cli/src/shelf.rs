//! Finished pieces of work in the folder of results: runs in `cache`, stages in `stages`, evaluations in their log. A piece that
//! is there is never computed again.

use crate::failure::Failure;
use crate::folder::{Folder, with_room, write_whole};
use crate::log::LogFile;
use extrados::Refusal;
use extrados::files::{LONGEST, read_at_most};
use extrados::shelf::Shelf;
use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Whether evaluations of an earlier command are taken up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Resume {
    /// They must be those of the same model.
    Asked,
    /// Where they are those of the same model.
    WherePossible,
    /// They make way.
    No,
}

/// A folder of results as a shelf.
pub(crate) struct FolderShelf<'a> {
    folder: &'a Folder,
    resume: Resume,
    log: Mutex<Opened>,
}

/// The log, once it is asked for.
#[derive(Default)]
struct Opened {
    file: Option<LogFile>,
    taken_up: usize,
    failure: Option<Failure>,
}

impl<'a> FolderShelf<'a> {
    pub(crate) fn new(folder: &'a Folder, resume: Resume) -> FolderShelf<'a> {
        FolderShelf { folder, resume, log: Mutex::default() }
    }

    /// Where runs of a study are.
    pub(crate) fn runs(&self) -> PathBuf {
        self.folder.file("cache")
    }

    /// How many evaluations were taken up.
    pub(crate) fn taken_up(&self) -> usize {
        self.log().taken_up
    }

    /// What kept the log from being opened or an evaluation from being kept.
    pub(crate) fn trouble(&self) -> Option<Failure> {
        let log = self.log();
        log.failure.clone().or(log.file.as_ref().and_then(LogFile::trouble))
    }

    fn log(&self) -> MutexGuard<'_, Opened> {
        self.log.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.folder.file(&file(name))
    }
}

/// The file of a piece of this name, below the folder of results.
pub(crate) fn file(name: &str) -> String {
    match name.strip_prefix("runs/") {
        Some(key) => format!("cache/{key}.json"),
        None => format!("{name}.json"),
    }
}

impl Shelf for FolderShelf<'_> {
    fn find(&self, name: &str) -> Option<Vec<u8>> {
        read_at_most(&self.file(name), LONGEST).ok()
    }

    fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        write_whole(with_room(&self.file(name))?, bytes)
    }

    fn evaluations(&self, identity: &str) -> Result<calibrate::Log, Refusal> {
        let open = |resume| LogFile::open(self.folder, identity, resume);
        let opened = match self.resume {
            Resume::Asked => open(true),
            Resume::WherePossible => open(true).or_else(|_| open(false)),
            Resume::No => open(false),
        };
        let mut log = self.log();
        match opened {
            Ok((known, file)) => {
                (log.file, log.taken_up) = (Some(file), known.len());
                Ok(known)
            }
            Err(failure) => {
                let refusal = Refusal::new(failure.code, failure.message.clone(), failure.help.clone());
                log.failure = Some(failure);
                Err(refusal)
            }
        }
    }

    fn append(&self, line: &str) {
        if let Some(file) = &mut self.log().file {
            file.append(line);
        }
    }

    fn appends(&self) -> bool {
        true
    }
}
