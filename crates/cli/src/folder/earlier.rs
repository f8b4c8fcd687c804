//! An answer of another run is kept: its files are moved into a folder of their own before the new answer takes their place.

use super::list::List;
use super::{SEAL, remove};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Name of the folder for earlier answers.
pub const NAME: &str = "earlier";

/// Moves the answer that a list describes into `earlier/KIND` and takes its files off the list. Gives the new place.
pub fn keep(folder: &Path, list: &mut List) -> io::Result<Option<PathBuf>> {
    let there: Vec<String> = list.last.iter().filter(|name| folder.join(name).is_file()).cloned().collect();
    if there.is_empty() {
        list.last.clear();
        return Ok(None);
    }
    let place = free(&folder.join(NAME), if list.kind.is_empty() { "run" } else { &list.kind }, &list.of)?;
    fs::create_dir_all(&place)?;
    list.only(&there).write(&place)?;
    // The seal goes last: what is half moved is taken up by the next run.
    for name in there.iter().filter(|name| *name != SEAL).chain(there.iter().filter(|name| *name == SEAL)) {
        let target = place.join(name);
        if let Some(parent) = target.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::rename(folder.join(name), target)?;
        list.forget(name);
    }
    list.last.clear();
    Ok(Some(place))
}

/// The place for an answer of this kind: the one that holds an older answer of the same run, emptied, or a new one. What
/// somebody changed or added there is left alone.
fn free(earlier: &Path, kind: &str, of: &str) -> io::Result<PathBuf> {
    for number in 1.. {
        let name = if number == 1 { kind.to_owned() } else { format!("{kind}-{number}") };
        let place = earlier.join(name);
        if fs::symlink_metadata(&place).is_err() {
            return Ok(place);
        }
        let list = List::read(&place);
        if list.of == of && list.kind == kind && empty(&place, &list)? {
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
