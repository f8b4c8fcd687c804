//! The folder of results: written whole beside its place, then moved there, so that nobody ever reads half of it.

use crate::failure::Failure;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The seal: a folder with this file is complete. It goes first when results are replaced, and comes last.
pub const SEAL: &str = "result.json";

/// A folder that results will be written to.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
}

/// The default folder for a file: out/NAME beside the current folder.
pub fn default_for(file: &Path) -> PathBuf {
    Path::new("out").join(file.file_stem().unwrap_or(file.as_os_str()))
}

impl Folder {
    /// Makes sure that results can be written here, before anything is computed.
    pub fn prepare(path: &Path) -> Result<Folder, Failure> {
        let unwritable = |error: io::Error| Failure::unwritable(path, &error);
        fs::create_dir_all(path).map_err(unwritable)?;
        let probe = path.join(format!(".extrados-probe-{}", std::process::id()));
        fs::write(&probe, b"").and_then(|()| fs::remove_file(&probe)).map_err(unwritable)?;
        Ok(Folder { path: path.to_owned() })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// A file in it.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Lets `write` fill an empty folder beside the results, then moves its files into their place; what `seal` makes of
    /// their names becomes [`SEAL`]. Files of an earlier answer that are not part of this one are taken away.
    pub fn fill(
        &self,
        write: impl FnOnce(&Path) -> io::Result<()>,
        seal: impl FnOnce(&[String]) -> String,
    ) -> Result<(), Failure> {
        let staging = Staging::new(self.path.join(format!(".extrados-partial-{}", std::process::id())));
        let not_written = |error: io::Error| Failure::not_written(&self.path, &error);
        fs::create_dir_all(&staging.path).map_err(not_written)?;
        write(&staging.path).map_err(not_written)?;
        let files = files_in(&staging.path).map_err(not_written)?;
        fs::write(staging.path.join(SEAL), seal(&files)).map_err(not_written)?;
        self.replace(&staging.path, &files).map_err(not_written)
    }

    /// Writes one file, whole or not at all, beside whatever else is there.
    pub fn put(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        write_whole(&self.file(name), bytes).map_err(|error| Failure::not_written(&self.file(name), &error))
    }

    fn replace(&self, staging: &Path, files: &[String]) -> io::Result<()> {
        let earlier = earlier_files(&self.file(SEAL));
        remove(&self.file(SEAL))?;
        for stale in earlier.iter().filter(|name| !files.contains(name)) {
            remove(&self.file(stale))?;
        }
        for name in files {
            let place = self.file(name);
            if let Some(parent) = place.parent() {
                fs::create_dir_all(parent)?;
            }
            fs::rename(staging.join(name), place)?;
        }
        fs::File::open(staging.join(SEAL))?.sync_all()?;
        fs::rename(staging.join(SEAL), self.file(SEAL))
    }
}

impl Drop for Folder {
    /// Takes the folder away again where nothing was written to it.
    fn drop(&mut self) {
        let _ = fs::remove_dir(&self.path);
    }
}

/// Writes a file whole or not at all.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let partial = path.with_extension("partial");
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

/// Removes a file that may not be there.
pub fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Files of the answer that is there already, as its seal lists them: plain names inside the folder only.
fn earlier_files(seal: &Path) -> Vec<String> {
    let Ok(bytes) = fs::read(seal) else { return Vec::new() };
    let Ok(value) = serde_json::from_slice::<serde_json::Value>(&bytes) else { return Vec::new() };
    let names = value["files"].as_array().cloned().unwrap_or_default();
    let inside = |name: &String| Path::new(name).components().all(|c| matches!(c, std::path::Component::Normal(_)));
    names.iter().filter_map(|name| name.as_str().map(str::to_owned)).filter(inside).collect()
}

/// Every file below a folder, relative to it, with forward slashes, in order.
pub fn files_in(folder: &Path) -> io::Result<Vec<String>> {
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
struct Staging {
    path: PathBuf,
}

impl Staging {
    fn new(path: PathBuf) -> Staging {
        Staging { path }
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.path);
    }
}
