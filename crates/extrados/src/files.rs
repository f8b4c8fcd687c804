//! Where files come from: a disk, or bytes that a caller holds. Nothing else in this crate reads a file.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

/// Gives the bytes of files by their paths.
pub trait Files {
    /// The bytes of a file. A folder is refused with [`io::ErrorKind::IsADirectory`].
    ///
    /// # Errors
    /// A path that leads to no file, or a file that cannot be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// The files in a folder, in the order of their names; none where the path leads to no folder.
    ///
    /// # Errors
    /// A folder that cannot be read.
    fn list(&self, folder: &Path) -> io::Result<Option<Vec<PathBuf>>>;

    /// The first `most` bytes of a file.
    ///
    /// # Errors
    /// Those of [`read`](Self::read).
    fn head(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
        let mut bytes = self.read(path)?;
        bytes.truncate(usize::try_from(most).unwrap_or(usize::MAX));
        Ok(bytes)
    }

    /// The bytes of a file that has no more than `most`; one that is longer is refused before it is read.
    ///
    /// # Errors
    /// Those of [`head`](Self::head), and a longer file as [`io::ErrorKind::InvalidData`].
    fn read_at_most(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
        let bytes = self.head(path, most + 1)?;
        if bytes.len() as u64 > most { Err(too_long(most)) } else { Ok(bytes) }
    }

    /// Where a path leads, links followed.
    ///
    /// # Errors
    /// A path that leads nowhere, where there are links to follow.
    fn real(&self, path: &Path) -> io::Result<PathBuf> {
        Ok(plain(path))
    }

    /// Whether a report may hold pictures from outside the folder of its bridge file.
    fn pictures_from_outside(&self) -> bool {
        false
    }
}

/// No file of a bridge is longer [bytes], whatever its kind.
pub const LONGEST: u64 = 256 << 20;
/// Files that are written by hand: bridges, block models, ranges, vehicles, rules, trains [bytes]; in UTF-16 twice as long as in UTF-8.
pub const LONGEST_TEXT: u64 = 2 << 20;
/// Drawings [bytes].
pub const LONGEST_DRAWING: u64 = 64 << 20;
/// Photographs [bytes].
pub const LONGEST_PHOTOGRAPH: u64 = 8 << 20;

fn too_long(most: u64) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("it is longer than {} MiB", most >> 20))
}

/// The first `most` bytes of a file of this machine. What is no plain file (a device, a pipe, a socket) may never end, and is refused
/// before it is opened.
///
/// # Errors
/// Where the path leads to no plain file, or the system does not give it.
pub fn head(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let data = std::fs::metadata(path)?;
    if data.is_dir() {
        return Err(folder());
    }
    if !data.is_file() {
        return Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            "it is no plain file, but a device, a pipe or a socket",
        ));
    }
    let mut bytes = Vec::with_capacity(usize::try_from(data.len().min(most)).unwrap_or(0));
    std::fs::File::open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The bytes of a plain file of this machine that has no more than `most`.
///
/// # Errors
/// As [`head`], and a file that is longer: nothing of it is read.
pub fn read_at_most(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let data = std::fs::metadata(path)?;
    if data.is_file() && data.len() > most {
        return Err(too_long(most));
    }
    // It may grow while it is read.
    let bytes = head(path, most + 1)?;
    if bytes.len() as u64 > most { Err(too_long(most)) } else { Ok(bytes) }
}

/// The files of this machine.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

/// The files of this machine, where reports may hold pictures from anywhere.
#[derive(Debug, Clone, Copy, Default)]
pub struct WholeDisk;

/// The disk, and whether reports may hold pictures from anywhere.
macro_rules! disk {
    ($Disk:ident, $outside:literal) => {
        impl Files for $Disk {
            fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
                read_at_most(path, LONGEST)
            }

            fn head(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
                head(path, most)
            }

            fn read_at_most(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
                read_at_most(path, most)
            }

            fn real(&self, path: &Path) -> io::Result<PathBuf> {
                path.canonicalize()
            }

            fn list(&self, folder: &Path) -> io::Result<Option<Vec<PathBuf>>> {
                if !folder.is_dir() {
                    return Ok(None);
                }
                let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)?.flatten().map(|entry| entry.path()).collect();
                paths.sort();
                Ok(Some(paths))
            }

            fn pictures_from_outside(&self) -> bool {
                $outside
            }
        }
    };
}

disk!(Disk, false);
disk!(WholeDisk, true);

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

/// A path without steps up and down, as far as its words tell.
fn plain(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(out.components().next_back(), Some(Component::Normal(_))) => {
                out.pop();
            }
            part => out.push(part),
        }
    }
    out
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

    #[test]
    fn a_long_file_is_refused_by_its_limit() {
        let files = Memory::default().with("a", vec![b'x'; (2 << 20) + 1]);
        assert_eq!(files.read_at_most(Path::new("a"), 2 << 20).unwrap_err().to_string(), "it is longer than 2 MiB");
        assert_eq!(files.head(Path::new("a"), 3).unwrap(), b"xxx");
        assert_eq!(plain(Path::new("a/./b/../../../c")), Path::new("../c"));
    }

    #[cfg(unix)]
    #[test]
    fn what_may_never_end_is_not_opened() {
        for path in ["/dev/zero", "/dev/null"] {
            assert!(Disk.read(Path::new(path)).unwrap_err().to_string().contains("no plain file"), "{path}");
        }
        assert_eq!(Disk.read(Path::new("/")).unwrap_err().kind(), io::ErrorKind::IsADirectory);
    }
}
