//! The folder of results: written whole beside its place, then moved there, so that nobody ever reads half of it.

mod claim;
mod earlier;
mod list;
mod purpose;

pub(crate) use list::{hash, is_inside};
pub(crate) use purpose::Purpose;

use crate::failure;
use claim::{Claim, PARTIAL, READY};
use extrados::Refusal;
use findings::visible::is_hidden;
use list::List;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The seal: a folder with this file is complete. It goes first when results are replaced, and comes last.
pub(crate) const SEAL: &str = "result.json";

/// A folder that results will be written to.
#[derive(Debug)]
pub(crate) struct Folder {
    path: PathBuf,
    purpose: Purpose,
    /// No other run writes here meanwhile.
    _claim: Claim,
}

/// How the name of a file begins by which it is tried whether a folder can be written.
const PROBE: &str = ".extrados-probe-";

/// Where an answer went.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Placed {
    /// Where the answer of another run was moved, which stood there before.
    pub earlier: Option<PathBuf>,
    /// Files of somebody else that came while the run went on: the answer stands beside them in a folder of its own.
    pub avoided: Vec<String>,
}

/// The folder that was named for the results of a file; by default out/NAME beside the current folder.
pub(crate) fn named(out: &Option<PathBuf>, file: &Path) -> PathBuf {
    out.clone().unwrap_or_else(|| Path::new("out").join(shown_stem(file)))
}

/// The name of a file without its ending, as a folder may be called: characters that act instead of being seen become "_".
pub(crate) fn shown_stem(file: &Path) -> OsString {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    match stem.to_str().filter(|name| name.chars().any(is_hidden)) {
        Some(name) => name.replace(is_hidden, "_").into(),
        None => stem.to_owned(),
    }
}

impl Folder {
    /// Makes sure, before anything is computed, that results can be written here, and that they replace nothing but what the
    /// command made here before.
    pub(crate) fn prepare(path: &Path, purpose: Purpose) -> Result<Folder, Refusal> {
        let unwritable = |error: io::Error| failure::unwritable(path, &error);
        fs::create_dir_all(path).map_err(unwritable)?;
        let claim = Claim::of(path).ok_or_else(|| failure::in_use(path))?;
        let probe = path.join(format!("{PROBE}{}", std::process::id()));
        fs::write(&probe, b"").and_then(|()| fs::remove_file(&probe)).map_err(unwritable)?;
        claim.tidy(path).map_err(unwritable)?;
        let folder = Folder { path: path.to_owned(), purpose, _claim: claim };
        folder.guard()?;
        Ok(folder)
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Room of its own for another program, until it has ended.
    pub(crate) fn room(&self) -> io::Result<Staging> {
        let room = self.path.join(format!("{PARTIAL}room-{}", std::process::id()));
        fs::create_dir_all(&room)?;
        Ok(Staging(room))
    }

    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Refuses, by name, to replace a file that the run reads or that the command did not make.
    fn guard(&self) -> Result<(), Refusal> {
        let list = List::read(&self.path);
        let (mut read, mut foreign) = (Vec::new(), Vec::new());
        for name in self.present().map_err(|error| failure::unwritable(&self.path, &error))? {
            if !self.purpose.may_write(&name) {
                continue;
            }
            if self.purpose.reads(&self.file(&name)) {
                read.push(name);
            } else if !list.holds(&self.path, &name) {
                foreign.push((list.knows(&name), name));
            }
        }
        match (read.is_empty(), foreign.is_empty()) {
            (false, _) => Err(failure::replaces_input(&self.path, &read)),
            (_, false) => Err(failure::replaces_foreign(&self.path, &foreign)),
            _ => Ok(()),
        }
    }

    /// Names of what stands where results go; folders below are looked into where results have them.
    fn present(&self) -> io::Result<Vec<String>> {
        let mut names = Vec::new();
        for below in std::iter::once("").chain(purpose::BELOW) {
            let Ok(entries) = fs::read_dir(self.path.join(below)) else { continue };
            for entry in entries {
                let name = entry?.file_name().to_string_lossy().into_owned();
                names.push(if below.is_empty() { name } else { format!("{below}/{name}") });
            }
        }
        names.sort();
        Ok(names)
    }

    /// Lets `write` fill an empty folder beside the results, then moves its files into their place; what `seal` makes of
    /// their names and of their place becomes [`SEAL`]. Files of an earlier answer of the same run that are not part of this one
    /// are taken away; an earlier answer of another run is moved into `earlier`.
    pub(crate) fn fill(
        &self,
        write: impl FnOnce(&Path) -> io::Result<()>,
        seal: impl FnOnce(&[String], &Path, &Placed) -> String,
    ) -> Result<Placed, Refusal> {
        let _busy = crate::signs::busy();
        let staging = Staging(self.path.join(format!("{PARTIAL}{}", std::process::id())));
        let not_written = |error: io::Error| failure::not_written(&self.path, &error);
        fs::create_dir_all(&staging.0).map_err(not_written)?;
        write(&staging.0).map_err(not_written)?;
        let files = files_in(&staging.0).map_err(not_written)?;
        let (mut placed, place) = self.clear(&files).map_err(not_written)?;
        let target = place.as_deref().unwrap_or(&self.path);
        if target == self.path {
            placed.earlier = self.keep_earlier().map_err(not_written)?;
        }
        fs::write(staging.0.join(SEAL), seal(&files, target, &placed)).map_err(not_written)?;
        self.replace(&staging.0, target, &files).map_err(not_written)?;
        Ok(placed)
    }

    /// Writes files, each whole or not at all, beside whatever else is there. An answer of another file is moved away first.
    pub(crate) fn put(&self, files: &[figures::File]) -> Result<(), Refusal> {
        let not_written = |error: io::Error| failure::not_written(&self.path, &error);
        let hash = |file: &figures::File| blake3::hash(&file.bytes).to_hex().to_string();
        self.guard()?;
        let mut list = List::read(&self.path);
        if list.of != self.purpose.of() {
            earlier::keep(&self.path, &mut list).map_err(not_written)?;
            (list.kind, list.of) = (String::new(), self.purpose.of());
        }
        files.iter().for_each(|file| list.expect(&file.name, hash(file)));
        list.write(&self.path).map_err(not_written)?;
        for file in files {
            let place = self.file(&file.name);
            write_whole(&place, &file.bytes).map_err(|error| failure::not_written(&place, &error))?;
            list.settle(&file.name, hash(file));
        }
        list.write(&self.path).map_err(not_written)
    }

    /// Files of somebody else in the way of an answer, which came since [`Folder::prepare`] looked, and the free place that the
    /// answer goes to in that case.
    fn clear(&self, files: &[String]) -> io::Result<(Placed, Option<PathBuf>)> {
        let list = List::read(&self.path);
        let names = files.iter().map(String::as_str).chain([SEAL]);
        let taken = |name: &&str| fs::symlink_metadata(self.file(name)).is_ok();
        let somebody = |name: &&str| self.purpose.reads(&self.file(name)) || !list.holds(&self.path, name);
        let avoided: Vec<String> = names.filter(taken).filter(somebody).map(str::to_owned).collect();
        if avoided.is_empty() {
            return Ok((Placed::default(), None));
        }
        let numbered = |number: usize| self.path.join(format!("results-{number}"));
        let place = (1..).map(numbered).find(|place| fs::symlink_metadata(place).is_err());
        let place = place.unwrap_or_else(|| numbered(0));
        fs::create_dir_all(&place)?;
        Ok((Placed { avoided, ..Placed::default() }, Some(place)))
    }

    /// Moves the answer of another run, or of another file, out of the way.
    fn keep_earlier(&self) -> io::Result<Option<PathBuf>> {
        let mut list = List::read(&self.path);
        if list.kind == self.purpose.kind && list.of == self.purpose.of() {
            return Ok(None);
        }
        let place = earlier::keep(&self.path, &mut list)?;
        list.write(&self.path)?;
        Ok(place)
    }

    fn replace(&self, staging: &Path, target: &Path, files: &[String]) -> io::Result<()> {
        let mut list = List::read(target);
        let all: Vec<String> = files.iter().cloned().chain([SEAL.to_owned()]).collect();
        let hashes: Vec<String> = all.iter().map(|name| list::hash(&staging.join(name))).collect::<io::Result<_>>()?;
        let stale = list.stale(target, &all);
        all.iter().zip(&hashes).for_each(|(name, hash)| list.expect(name, hash.clone()));
        (list.kind, list.of, list.last) = (self.purpose.kind.clone(), self.purpose.of(), all.clone());
        list.last.extend(stale);
        // Should the move be cut off, whatever then stands there is on the list, and the next run ends it.
        list.write(target)?;
        if target != self.path {
            return claim::into_place(staging, target, files);
        }
        let ready = target.join(READY);
        fs::rename(staging, &ready)?;
        claim::into_place(&ready, target, files)?;
        fs::remove_dir_all(ready)
    }
}

impl Drop for Folder {
    /// Takes the folder away again where nothing was written to it.
    fn drop(&mut self) {
        let _ = fs::remove_dir(&self.path);
    }
}

/// Writes a file whole or not at all.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let _busy = crate::signs::busy();
    let partial = partial(path);
    let written = fs::File::create(&partial).and_then(|mut file| {
        io::Write::write_all(&mut file, bytes)?;
        file.sync_all()
    });
    let moved = written.and_then(|()| fs::rename(&partial, path));
    if moved.is_err() {
        let _ = fs::remove_file(&partial);
    }
    moved
}

/// The place of a file, in a folder that is made where it is not there.
pub(crate) fn with_room(place: &Path) -> io::Result<&Path> {
    place.parent().map_or(Ok(()), fs::create_dir_all)?;
    Ok(place)
}

/// A name beside a file that nobody else uses.
pub(crate) fn partial(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}{PARTIAL}{}", std::process::id()))
}

/// Removes a file that may not be there.
pub(crate) fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Every file below a folder, relative to it, with forward slashes, in order.
pub(crate) fn files_in(folder: &Path) -> io::Result<Vec<String>> {
    fn visit(folder: &Path, prefix: &str, found: &mut Vec<String>) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                visit(&entry.path(), &format!("{name}/"), found)?;
            } else {
                found.push(name);
            }
        }
        Ok(())
    }
    let mut found = Vec::new();
    visit(folder, "", &mut found)?;
    found.sort();
    Ok(found)
}

/// A folder that is gone when the work is done, whichever way it ends.
pub(crate) struct Staging(PathBuf);

impl Staging {
    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
