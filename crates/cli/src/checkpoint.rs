//! The checkpoint of a run, in its folder of results. It is written to a file beside it, synchronised and renamed, so that it is
//! whole or absent.

use crate::failure;
use crate::folder::{self, Folder};
use assess::checkpoint::{self, CheckpointError};
use extrados::Refusal;
use extrados::files::read_at_most;
use std::fmt::{self, Debug, Display};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// Name of the file.
const NAME: &str = "run.checkpoint";

/// Where a run keeps its state, and which run it is.
#[derive(Debug, Clone)]
pub(crate) struct Checkpoint {
    path: PathBuf,
    fingerprint: u64,
}

impl Checkpoint {
    /// The checkpoint of this bridge or block model with its plan.
    pub(crate) fn of<T: Debug>(input: &T, folder: &Folder) -> Checkpoint {
        Checkpoint { path: folder.file(NAME), fingerprint: checkpoint::fingerprint(input) }
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// What to tell of it when the run is interrupted.
    pub(crate) fn words(&self) -> String {
        format!("the run is kept in {}\ngo on with the same command and --resume", self.path.display())
    }

    /// Keeps a state, whole or not at all.
    pub(crate) fn keep(&self, state: &[u8]) -> Result<(), Refusal> {
        write(&self.path, &checkpoint::bytes(self.fingerprint, state))
            .map_err(|error| failure::not_written(&self.path, &error))
    }

    /// The state that was kept, where there is one.
    pub(crate) fn take_up(&self) -> Result<Option<Vec<u8>>, Refusal> {
        let aside = self.set_aside(self.fingerprint);
        match read(&self.path, self.fingerprint) {
            Err(Unusable::Unread(error)) if error.kind() == io::ErrorKind::NotFound => {
                Ok(read(&aside, self.fingerprint).ok())
            }
            Err(Unusable::Wrong(CheckpointError::OtherInput { .. })) if aside.exists() => {
                read(&aside, self.fingerprint).map(Some).map_err(|error| self.unusable(&error))
            }
            Err(Unusable::Wrong(CheckpointError::OtherInput { .. })) => {
                let message = format!("{} belongs to another bridge or another plan", self.path.display());
                Err(Refusal::new("F106", message, "repeat the command that was interrupted, or run without --resume"))
            }
            found => found.map(Some).map_err(|error| self.unusable(&error)),
        }
    }

    /// Makes way for a run that starts anew: the state of another run, or of another version of this program, is kept under a name of
    /// its own, a file that is no checkpoint is refused. Says what a reader should know.
    pub(crate) fn make_way(&self) -> Result<Option<String>, Refusal> {
        let shown = self.path.display();
        match read(&self.path, self.fingerprint) {
            Ok(_) => {
                Ok(Some(format!("{shown} holds this run as it was interrupted: it starts anew; --resume would go on")))
            }
            Err(Unusable::Wrong(error @ CheckpointError::OtherInput { found })) => {
                self.put_aside(&error, &self.set_aside(found), "where --resume of that run finds it")
            }
            // What this program takes away when the run is finished has another name.
            Err(Unusable::Wrong(error @ CheckpointError::Version { found, format })) => {
                let aside = self.path.with_file_name(format!("run-{found:016x}-format-{format}.checkpoint"));
                self.put_aside(&error, &aside, "for that version")
            }
            Err(Unusable::Wrong(CheckpointError::Foreign)) => {
                let folder = self.path.parent().unwrap_or(Path::new(""));
                Err(failure::replaces_foreign(folder, &[(false, NAME.to_owned())]))
            }
            Err(_) => Ok(None),
        }
    }

    /// Gives the file another name; says which, and what for.
    fn put_aside(&self, error: &CheckpointError, aside: &Path, what_for: &str) -> Result<Option<String>, Refusal> {
        fs::rename(&self.path, aside).map_err(|error| failure::not_written(aside, &error))?;
        let shown = self.path.display();
        Ok(Some(format!("{shown}: {error}; it is kept as {}, {what_for}", aside.display())))
    }

    /// Where the state of another run is kept.
    fn set_aside(&self, fingerprint: u64) -> PathBuf {
        self.path.with_file_name(format!("run-{fingerprint:016x}.checkpoint"))
    }

    /// Takes it away when the run is finished. One that stays would only be refused or taken up to the same end.
    pub(crate) fn remove(&self) {
        let _ = folder::remove(&self.path);
        let _ = folder::remove(&self.set_aside(self.fingerprint));
    }

    fn unusable(&self, error: &Unusable) -> Refusal {
        let message = format!("cannot use {}: {error}", self.path.display());
        Refusal::new("F110", message, "run without --resume to start anew")
    }
}

/// Why a file cannot be taken up.
enum Unusable {
    Unread(io::Error),
    Wrong(CheckpointError),
}

impl Display for Unusable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unusable::Unread(error) => write!(f, "the checkpoint cannot be read: {error}"),
            Unusable::Wrong(error) => Display::fmt(error, f),
        }
    }
}

fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    folder::write_whole(path, bytes)?;
    // The new name must survive a power cut too; where a folder cannot be synchronised, the system does it in time.
    if let Some(folder) = path.parent()
        && let Ok(folder) = File::open(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })
    {
        let _ = folder.sync_all();
    }
    Ok(())
}

fn read(path: &Path, fingerprint: u64) -> Result<Vec<u8>, Unusable> {
    let bytes = read_at_most(path, checkpoint::LONGEST).map_err(Unusable::Unread)?;
    checkpoint::state(&bytes, fingerprint).map(<[u8]>::to_vec).map_err(Unusable::Wrong)
}
