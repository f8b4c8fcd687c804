//! Finished pieces of work in the folder of results: runs in `cache`, stages in `stages`, evaluations in their log. A piece that
//! is there is never computed again.

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
    /// The log, once it is asked for, and how many evaluations were in it.
    log: Mutex<Option<(LogFile, usize)>>,
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
        self.log().as_ref().map_or(0, |(_, taken_up)| *taken_up)
    }

    /// What kept an evaluation from being kept.
    pub(crate) fn trouble(&self) -> Option<Refusal> {
        self.log().as_ref().and_then(|(file, _)| file.trouble())
    }

    fn log(&self) -> MutexGuard<'_, Option<(LogFile, usize)>> {
        self.log.lock().unwrap_or_else(PoisonError::into_inner)
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
        read_at_most(&self.folder.file(&file(name)), LONGEST).ok()
    }

    fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        write_whole(with_room(&self.folder.file(&file(name)))?, bytes)
    }

    fn evaluations(&self, identity: &str) -> Result<calibrate::Log, Refusal> {
        let open = |resume| LogFile::open(self.folder, identity, resume);
        let (known, file) = match self.resume {
            Resume::Asked => open(true),
            Resume::WherePossible => open(true).or_else(|_| open(false)),
            Resume::No => open(false),
        }?;
        *self.log() = Some((file, known.len()));
        Ok(known)
    }

    fn append(&self, line: &str) {
        if let Some((file, _)) = &mut *self.log() {
            file.append(line);
        }
    }

    fn appends(&self) -> bool {
        true
    }
}
