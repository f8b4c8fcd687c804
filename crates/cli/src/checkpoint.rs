//! The checkpoint of a run, in its folder of results.

use crate::failure::Failure;
use crate::folder::{self, Folder};
use assess::checkpoint::{self, CheckpointError};
use std::fmt::Debug;
use std::io;
use std::path::{Path, PathBuf};

/// Name of the file.
const NAME: &str = "run.checkpoint";

/// Where a run keeps its state, and which run it is.
#[derive(Debug, Clone)]
pub struct Checkpoint {
    path: PathBuf,
    fingerprint: u64,
}

impl Checkpoint {
    /// The checkpoint of this bridge or block model with its plan.
    pub fn of<T: Debug>(input: &T, folder: &Folder) -> Checkpoint {
        Checkpoint { path: folder.file(NAME), fingerprint: checkpoint::fingerprint(input) }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Keeps a state, whole or not at all.
    pub fn keep(&self, words: &[u64]) -> Result<(), Failure> {
        checkpoint::write(&self.path, self.fingerprint, words).map_err(|error| match error {
            CheckpointError::Io(error) => Failure::not_written(&self.path, &error),
            other => self.unusable(&other),
        })
    }

    /// The state that was kept, where there is one.
    pub fn take_up(&self) -> Result<Option<Vec<u64>>, Failure> {
        match checkpoint::read(&self.path, self.fingerprint) {
            Ok(words) => Ok(Some(words)),
            Err(CheckpointError::Io(error)) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(CheckpointError::OtherInput) => {
                let message = format!("{} belongs to another bridge or another plan", self.path.display());
                Err(Failure::input("F106", message, "repeat the command that was interrupted, or run without --resume"))
            }
            Err(error) => Err(self.unusable(&error)),
        }
    }

    /// Takes it away when the run is finished. One that stays would only be refused or taken up to the same end.
    pub fn remove(&self) {
        let _ = folder::remove(&self.path);
    }

    fn unusable(&self, error: &CheckpointError) -> Failure {
        let message = format!("cannot use {}: {error}", self.path.display());
        Failure::input("F110", message, "run without --resume to start anew")
    }
}
