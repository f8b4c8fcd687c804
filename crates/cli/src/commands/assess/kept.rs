//! Finished stages, one file each in the folder of results, by the hash of what they were computed from.

use crate::folder::{Folder, write_whole};
use ::report::Figure;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::fs;
use std::path::PathBuf;

/// Name of the folder inside the folder of results.
const NAME: &str = "stages";

/// The running program: another build may compute other bits.
pub struct Program {
    hash: String,
}

impl Program {
    /// Version and bytes of the program that runs.
    pub fn running() -> Program {
        Program { hash: crate::cache::program().to_hex().to_string() }
    }

    /// In hexadecimal digits.
    pub fn hash(&self) -> &str {
        &self.hash
    }
}

/// The stages of one bridge.
pub struct Kept<'a> {
    folder: PathBuf,
    program: &'a Program,
}

/// A finished stage.
pub struct Finished<T> {
    /// Its facts.
    pub facts: T,
    /// Its drawings.
    pub figures: Vec<Figure>,
    /// How long it took [s].
    pub seconds: f64,
}

impl<'a> Kept<'a> {
    /// Those in a folder of results.
    pub fn in_folder(folder: &Folder, program: &'a Program) -> Kept<'a> {
        Kept { folder: folder.file(NAME), program }
    }

    /// The key of a stage: everything that its numbers follow from. The debug form names every field and prints every number
    /// so that it can be read back exactly.
    pub fn key(&self, stage: &str, input: &impl std::fmt::Debug) -> String {
        let mut hasher = blake3::Hasher::new();
        hasher.update(self.program.hash.as_bytes());
        hasher.update(format!("{stage}\n{input:?}").as_bytes());
        hasher.finalize().to_hex().to_string()
    }

    /// A stage that was finished from the same input. A file that is damaged or of another input is none.
    pub fn get<T: DeserializeOwned>(&self, stage: &str, key: &str) -> Option<Finished<T>> {
        let bytes = fs::read(self.file(stage)).ok()?;
        let value: Value = serde_json::from_slice(&bytes).ok()?;
        if value["key"].as_str() != Some(key) {
            return None;
        }
        let figures = value["figures"].as_array()?.iter().map(|one| {
            let text = |name: &str| one[name].as_str().map(str::to_owned);
            Some(Figure { stage: stage.to_owned(), name: text("name")?, caption: text("caption")?, svg: text("svg")? })
        });
        Some(Finished {
            figures: figures.collect::<Option<_>>()?,
            seconds: value["seconds"].as_f64()?,
            facts: serde_json::from_value(value["facts"].clone()).ok()?,
        })
    }

    /// Keeps a finished stage, whole or not at all. One that cannot be kept is computed again: that is no failure.
    pub fn put<T: Serialize>(&self, stage: &str, key: &str, finished: &Finished<T>) {
        let figures: Vec<Value> = finished
            .figures
            .iter()
            .map(|figure| json!({ "name": figure.name, "caption": figure.caption, "svg": figure.svg }))
            .collect();
        let Ok(facts) = serde_json::to_value(&finished.facts) else { return };
        let value = json!({ "key": key, "seconds": finished.seconds, "facts": facts, "figures": figures });
        let _ = fs::create_dir_all(&self.folder)
            .and_then(|()| write_whole(&self.file(stage), value.to_string().as_bytes()));
    }

    fn file(&self, stage: &str) -> PathBuf {
        self.folder.join(format!("{stage}.json"))
    }
}
