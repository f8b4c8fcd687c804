//! Finished runs, kept by what they were computed from: a run whose key is there is never computed again.

use crate::folder::write_whole;
use assess::vary::Outcome;
use assess::wire;
use bridge::Bridge;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Name of the folder inside the folder of results.
const NAME: &str = "cache";

/// A folder of finished runs.
#[derive(Debug)]
pub struct Cache {
    folder: PathBuf,
    program: blake3::Hash,
}

/// What a run is computed from, as a hash in hexadecimal digits.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key(String);

impl Cache {
    /// The cache in a folder of results; its own folder comes with the first run that is kept.
    pub fn in_folder(folder: &Path) -> Cache {
        Cache { folder: folder.join(NAME), program: program() }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.folder
    }

    /// The key of an analysis of a bridge with its plan. Comments, order and units of the file do not enter; every number
    /// does to its last bit, and so does the program.
    pub fn key(&self, analysis: &str, bridge: &Bridge) -> Key {
        let mut hasher = blake3::Hasher::new();
        hasher.update(self.program.as_bytes());
        // The debug form names every field and prints every number so that it can be read back exactly.
        hasher.update(format!("{analysis}\n{bridge:?}").as_bytes());
        Key(hasher.finalize().to_hex().to_string())
    }

    /// A finished run and the seconds it took. A file that is damaged is none: the run is computed again.
    pub fn get(&self, key: &Key) -> Option<(Outcome, f64)> {
        wire::run_from_record(&fs::read(self.file(key)).ok()?)
    }

    /// Keeps a finished run, whole or not at all.
    pub fn put(&self, key: &Key, outcome: &Outcome, seconds: f64) -> io::Result<()> {
        fs::create_dir_all(&self.folder)?;
        write_whole(&self.file(key), wire::run_record(outcome, seconds).as_bytes())
    }

    fn file(&self, key: &Key) -> PathBuf {
        self.folder.join(format!("{}.json", key.0))
    }
}

/// Version and bytes of the running program: another build may compute other bits.
pub fn program() -> blake3::Hash {
    let mut hasher = blake3::Hasher::new();
    hasher.update(env!("CARGO_PKG_VERSION").as_bytes());
    if let Ok(bytes) = std::env::current_exe().and_then(fs::read) {
        hasher.update(&bytes);
    }
    hasher.finalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_key_follows_the_meaning_of_the_file() {
        let cache = Cache { folder: PathBuf::new(), program: program() };
        let text = crate::examples::named("tiny").map(|example| example.files[0].text).unwrap();
        let key = |text: &str| {
            let read = bridge::read(text.as_bytes());
            cache.key("collapse", &read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics)))
        };
        assert_eq!(key(text), key(&format!("# a comment\n{text}")));
        let line = text.lines().find(|line| line.contains("density")).unwrap();
        let number: String = line.chars().filter(char::is_ascii_digit).take(4).collect();
        assert_ne!(key(text), key(&text.replacen(&number, "2345", 1)));
        let read = bridge::read(text.as_bytes()).bridge.unwrap();
        assert_ne!(cache.key("collapse", &read), cache.key("another", &read));
    }
}
