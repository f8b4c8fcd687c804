//! Where finished pieces of work are kept, so that an interrupted command goes on where it was: runs of a study, stages of an
//! assessment, evaluations of an update.

use crate::refusal::Refusal;
use calibrate::Log;
use std::collections::BTreeMap;
use std::io;
use std::sync::{Mutex, PoisonError};

/// Keeps finished pieces under their names. Pieces of several threads arrive at once.
pub trait Shelf: Sync {
    /// A piece that was kept.
    fn find(&self, name: &str) -> Option<Vec<u8>>;

    /// Keeps a piece, whole or not at all.
    ///
    /// # Errors
    /// A piece that cannot be kept.
    fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()>;

    /// The evaluations that were kept of this model; [`append`](Self::append) adds to them.
    ///
    /// # Errors
    /// Where there is a log that cannot be used.
    fn evaluations(&self, identity: &str) -> Result<Log, Refusal> {
        Ok(Log::new(identity))
    }

    /// Keeps one evaluation more, a line of the log.
    fn append(&self, _line: &str) {}

    /// Whether lines are wanted.
    fn appends(&self) -> bool {
        false
    }
}

/// Nothing is kept.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unkept;

impl Shelf for Unkept {
    fn find(&self, _: &str) -> Option<Vec<u8>> {
        None
    }

    fn put(&self, _: &str, _: &[u8]) -> io::Result<()> {
        Ok(())
    }
}

/// Pieces are kept as long as this lives.
#[derive(Debug, Default)]
pub struct Remembered(Mutex<BTreeMap<String, Vec<u8>>>);

impl Shelf for Remembered {
    fn find(&self, name: &str) -> Option<Vec<u8>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned()
    }

    fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(name.to_owned(), bytes.to_vec());
        Ok(())
    }
}
