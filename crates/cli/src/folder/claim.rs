//! A folder in the hands of one run: no other run may write there meanwhile, and what a run that was killed left half done is ended or
//! taken away first.

use super::list::List;
use super::{SEAL, files_in, list, remove, with_room};
use serde_json::Value;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::Path;

/// Complete results on their way into their place.
pub(super) const READY: &str = ".extrados-ready";
/// How names begin, or go on, of what is not complete.
pub(super) const PARTIAL: &str = ".extrados-partial-";

/// Holds the folder as long as it lives.
#[derive(Debug)]
pub(super) struct Claim(Option<File>);

impl Claim {
    /// Claims a folder for this run; none where another run holds it. Systems that cannot lock folders let everybody in.
    pub(super) fn of(folder: &Path) -> Option<Claim> {
        let Ok(file) = File::open(folder) else { return Some(Claim(None)) };
        match file.try_lock() {
            Ok(()) => Some(Claim(Some(file))),
            Err(TryLockError::WouldBlock) => None,
            Err(TryLockError::Error(_)) => Some(Claim(None)),
        }
    }

    /// Ends what a killed run left here: complete results go to their place, incomplete ones are taken away.
    pub(super) fn tidy(&self, folder: &Path) -> io::Result<()> {
        // Without a lock what looks left over may be another run's.
        if self.0.is_none() {
            return Ok(());
        }
        finish(folder)?;
        for below in ["", "cache", "stages"] {
            let Ok(entries) = fs::read_dir(folder.join(below)) else { continue };
            for entry in entries {
                let entry = entry?;
                let name = entry.file_name().to_string_lossy().into_owned();
                let left_over = name.starts_with('.') && (name.contains(PARTIAL) || name.contains(super::PROBE));
                match entry.file_type()? {
                    kind if left_over && kind.is_dir() => fs::remove_dir_all(entry.path())?,
                    kind if left_over && kind.is_file() => remove(&entry.path())?,
                    _ => {}
                }
            }
        }
        list::places(folder).iter().try_for_each(|list| remove_partial(list))
    }
}

/// Takes away what a killed run had written of a file.
fn remove_partial(file: &Path) -> io::Result<()> {
    let (Some(parent), Some(name)) = (file.parent(), file.file_name()) else { return Ok(()) };
    let start = format!(".{}{PARTIAL}", name.to_string_lossy());
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(&start) {
            remove(&entry.path())?;
        }
    }
    Ok(())
}

/// Moves complete results into their place, from wherever a kill cut that off: the list of the folder tells what was there before.
fn finish(folder: &Path) -> io::Result<()> {
    let ready = folder.join(READY);
    let Ok(names) = files_in(&ready) else { return Ok(()) };
    if names.iter().any(|name| name == SEAL) {
        let seal: Option<Value> = serde_json::from_slice(&fs::read(ready.join(SEAL))?).ok();
        let files = seal.map(|seal| list::strings(&seal["files"])).unwrap_or_default();
        if files.iter().all(|name| list::is_inside(name)) {
            into_place(&ready, folder, &files)?;
        }
    }
    fs::remove_dir_all(&ready)
}

/// Moves the files of complete results, those that are still there, from a folder of their own into their place, the seal last. Files of
/// the answer before them that are no part of this one are taken away. The list tells both; it is settled at the end.
pub(super) fn into_place(from: &Path, target: &Path, files: &[String]) -> io::Result<()> {
    let mut list = List::read(target);
    let all: Vec<String> = files.iter().cloned().chain([SEAL.to_owned()]).collect();
    remove(&target.join(SEAL))?;
    for name in list.stale(target, &all) {
        remove(&target.join(&name))?;
        list.forget(&name);
    }
    for name in files.iter().filter(|name| from.join(name).is_file()) {
        fs::rename(from.join(name), with_room(&target.join(name))?)?;
    }
    File::open(from.join(SEAL))?.sync_all()?;
    fs::rename(from.join(SEAL), target.join(SEAL))?;
    for name in &all {
        list.settle(name, list::hash(&target.join(name))?);
    }
    list.last = all;
    list.write(target)
}
