//! Where files come from: a disk, or bytes that a caller holds. Nothing else in this crate reads a file.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Gives the bytes of files by their paths.
pub trait Files {
    /// The bytes of a file. A folder is refused with [`io::ErrorKind::IsADirectory`].
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// The files in a folder, in the order of their names; none where the path leads to no folder.
    fn list(&self, folder: &Path) -> io::Result<Option<Vec<PathBuf>>>;
}

/// No file of a bridge is longer [bytes]; reading ends there, whatever a path leads to.
const LONGEST: u64 = 1 << 30;

/// The files of this machine.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path.is_dir() {
            return Err(folder());
        }
        let mut bytes = Vec::new();
        std::fs::File::open(path)?.take(LONGEST + 1).read_to_end(&mut bytes)?;
        match bytes.len() as u64 > LONGEST {
            true => Err(io::Error::other("it is longer than 1 GiB")),
            false => Ok(bytes),
        }
    }

    fn list(&self, folder: &Path) -> io::Result<Option<Vec<PathBuf>>> {
        if !folder.is_dir() {
            return Ok(None);
        }
        let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)?.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        Ok(Some(paths))
    }
}

/// Files that a caller holds: from a browser, an archive, a test.
#[derive(Debug, Clone, Default)]
pub struct Memory(BTreeMap<PathBuf, Vec<u8>>);

impl Memory {
    /// With one file more.
    pub fn with(mut self, path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) -> Memory {
        self.0.insert(path.into(), bytes.into());
        self
    }

    /// Without a file.
    pub fn without(mut self, path: &Path) -> Memory {
        self.0.remove(path);
        self
    }
}

impl Files for Memory {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.0.get(path) {
            Some(bytes) => Ok(bytes.clone()),
            None if self.list(path)?.is_some() => Err(folder()),
            None => Err(io::Error::new(io::ErrorKind::NotFound, "no such file or directory")),
        }
    }

    fn list(&self, folder: &Path) -> io::Result<Option<Vec<PathBuf>>> {
        let inside: Vec<PathBuf> = self.0.keys().filter(|path| path.parent() == Some(folder)).cloned().collect();
        Ok((!inside.is_empty()).then_some(inside))
    }
}

fn folder() -> io::Error {
    io::Error::new(io::ErrorKind::IsADirectory, "it is a folder")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_in_memory_have_folders() {
        let files = Memory::default().with("a.toml", "x").with("runs/2.csv", "2").with("runs/1.csv", "1");
        assert_eq!(files.read(Path::new("runs/1.csv")).unwrap(), b"1");
        assert_eq!(files.read(Path::new("runs")).unwrap_err().kind(), io::ErrorKind::IsADirectory);
        assert_eq!(files.read(Path::new("b.toml")).unwrap_err().kind(), io::ErrorKind::NotFound);
        let listed = files.list(Path::new("runs")).unwrap().unwrap();
        assert_eq!(listed, [PathBuf::from("runs/1.csv"), PathBuf::from("runs/2.csv")]);
        assert_eq!(files.list(Path::new("a.toml")).unwrap(), None);
    }
}
