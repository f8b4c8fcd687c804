//! An answer of another run is kept: its files are moved into a folder of their own before the new answer takes their place.

use super::list::List;
use super::{SEAL, remove, with_room};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Name of the folder for earlier answers.
pub(super) const NAME: &str = "earlier";

/// Moves the answer that a list describes into `earlier/KIND` and takes its files off the list. Gives the new place.
pub(super) fn keep(folder: &Path, list: &mut List) -> io::Result<Option<PathBuf>> {
    let there: Vec<String> = list.last.iter().filter(|name| folder.join(name).is_file()).cloned().collect();
    if there.is_empty() {
        list.last.clear();
        return Ok(None);
    }
    let kind = if list.kind.is_empty() { "run" } else { &list.kind };
    let place = free(&folder.join(NAME), kind, list)?;
    if !half_moved(&place, list) {
        fs::create_dir_all(&place)?;
        list.only(&there).write(&place)?;
    }
    // The seal goes last: what is half moved is taken up by the next run.
    for name in there.iter().filter(|name| *name != SEAL).chain(there.iter().filter(|name| *name == SEAL)) {
        fs::rename(folder.join(name), with_room(&place.join(name))?)?;
        list.forget(name);
    }
    list.last.clear();
    Ok(Some(place))
}

/// Whether a run was killed while it moved the answer of this list here: the seal comes last. What is there is part of that answer, and
/// the rest follows.
fn half_moved(place: &Path, list: &List) -> bool {
    let moved = List::read(place);
    moved.last.iter().any(|name| name == SEAL) && !place.join(SEAL).exists() && list.only(&moved.last) == moved
}

/// The place for an answer of this kind: the one that holds an older answer of the same run, emptied, or a new one. What
/// somebody changed or added there is left alone.
fn free(earlier: &Path, kind: &str, whole: &List) -> io::Result<PathBuf> {
    for number in 1.. {
        let name = if number == 1 { kind.to_owned() } else { format!("{kind}-{number}") };
        let place = earlier.join(name);
        if fs::symlink_metadata(&place).is_err() || half_moved(&place, whole) {
            return Ok(place);
        }
        let list = List::read(&place);
        if list.of == whole.of && list.kind == kind && empty(&place, &list)? {
            return Ok(place);
        }
    }
    unreachable!("numbers do not end")
}

/// Takes files away that are as the command made them; whether nothing else is left.
fn empty(place: &Path, list: &List) -> io::Result<bool> {
    let names = super::files_in(place)?;
    let own = |name: &String| name == super::list::NAME || list.holds(place, name);
    if !names.iter().all(own) {
        return Ok(false);
    }
    names.iter().try_for_each(|name| remove(&place.join(name)))?;
    Ok(true)
}
