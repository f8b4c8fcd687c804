//! The list of files that the command made in a folder, each with the hash of what it wrote: what is not on it, or was changed
//! since, belongs to somebody else and is never replaced. It stands beside the folder, hidden, so that the folder holds results alone;
//! inside where nothing can be written beside it.

use super::{SEAL, write_whole};
use extrados::files::{LONGEST, head, read_at_most};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

/// What the name of the list ends in; the name of the folder stands before it.
pub(super) const NAME: &str = ".extrados-files.json";
const SCHEMA: &str = "extrados.files/1";

/// What the command made in a folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct List {
    /// Which run made the result that stands there, such as "collapse-load-dem"; empty where none does.
    pub kind: String,
    /// The file that it was made from.
    pub of: String,
    /// Files of that result.
    pub last: Vec<String>,
    /// Every file that was made there, with the hashes it may have; none where nobody kept them.
    made: BTreeMap<String, Vec<String>>,
}

impl List {
    /// The list of a folder. Where there is none, files that a result names count as made: results of earlier versions have no
    /// list.
    pub(super) fn read(folder: &Path) -> List {
        let value = |path: PathBuf| serde_json::from_slice::<Value>(&read_at_most(&path, LONGEST).ok()?).ok();
        let listed = places(folder).into_iter().filter_map(value).find(|value| value["schema"] == SCHEMA);
        if let Some(value) = listed {
            return List::from_value(&value);
        }
        let Some(seal) = value(folder.join(SEAL)) else { return List::default() };
        if !seal["schema"].as_str().is_some_and(|schema| schema.starts_with("extrados.")) {
            return List::default();
        }
        let mut last: Vec<String> = strings(&seal["files"]).into_iter().filter(|name| is_inside(name)).collect();
        last.push(SEAL.to_owned());
        let made = last.iter().map(|name| (name.clone(), Vec::new())).collect();
        List { kind: String::new(), of: String::new(), last, made }
    }

    fn from_value(value: &Value) -> List {
        let made = value["made"].as_object().into_iter().flatten();
        let made = made.filter(|(name, _)| is_inside(name)).map(|(name, hashes)| (name.clone(), strings(hashes)));
        let word = |key: &str| value[key].as_str().unwrap_or_default().to_owned();
        let last = strings(&value["last"]).into_iter().filter(|name| is_inside(name)).collect();
        List { kind: word("kind"), of: word("of"), last, made: made.collect() }
    }

    /// Writes it, whole or not at all.
    pub(super) fn write(&self, folder: &Path) -> io::Result<()> {
        let about = "Files that extrados made here, and may replace as long as they are as it made them.";
        let value = json!({
            "schema": SCHEMA, "about": about, "kind": self.kind, "of": self.of, "last": self.last, "made": self.made,
        });
        let bytes = format!("{value:#}\n").into_bytes();
        let mut written = Ok(());
        for place in places(folder) {
            written = write_whole(&place, &bytes);
            if written.is_ok() {
                break;
            }
        }
        written
    }

    /// Whether the file of this name is as the command made it.
    pub(super) fn holds(&self, folder: &Path, name: &str) -> bool {
        let Some(hashes) = self.made.get(name) else { return false };
        let path = folder.join(name);
        let plain = fs::symlink_metadata(&path).is_ok_and(|data| data.is_file());
        plain && (hashes.is_empty() || hash(&path).is_ok_and(|hash| hashes.contains(&hash)))
    }

    /// Files of the last result that are as the command made them and no part of a new one.
    pub(super) fn stale(&self, folder: &Path, all: &[String]) -> Vec<String> {
        self.last.iter().filter(|name| !all.contains(name) && self.holds(folder, name)).cloned().collect()
    }

    /// Whether a file of this name was made, whatever became of it.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.made.contains_key(name)
    }

    /// A file may have this content too.
    pub(super) fn expect(&mut self, name: &str, hash: String) {
        let known = self.made.entry(name.to_owned()).or_default();
        if !known.contains(&hash) {
            known.push(hash);
        }
    }

    /// A file has this content and no other.
    pub(super) fn settle(&mut self, name: &str, hash: String) {
        self.made.insert(name.to_owned(), vec![hash]);
    }

    /// A file is gone.
    pub(super) fn forget(&mut self, name: &str) {
        self.made.remove(name);
    }

    /// The list of these files alone.
    pub(super) fn only(&self, names: &[String]) -> List {
        let made = self.made.iter().filter(|(name, _)| names.contains(name));
        let made = made.map(|(name, hashes)| (name.clone(), hashes.clone())).collect();
        List { last: names.to_vec(), made, ..self.clone() }
    }
}

/// Where the list of a folder may stand: beside it, and inside.
pub(super) fn places(folder: &Path) -> Vec<PathBuf> {
    let whole = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let beside = whole.parent().zip(whole.file_name());
    let beside = beside.map(|(parent, name)| parent.join(format!(".{}{NAME}", name.to_string_lossy())));
    beside.into_iter().chain([folder.join(NAME)]).collect()
}

/// The hash of a file's content, in hexadecimal digits.
pub(crate) fn hash(path: &Path) -> io::Result<String> {
    // What is no plain file is refused before it is opened.
    head(path, 0)?;
    let mut hasher = blake3::Hasher::new();
    io::copy(&mut fs::File::open(path)?, &mut hasher)?;
    Ok(hasher.finalize().to_hex().to_string())
}

/// A plain name below the folder.
pub(crate) fn is_inside(name: &str) -> bool {
    !name.is_empty() && Path::new(name).components().all(|part| matches!(part, Component::Normal(_)))
}

/// Texts of a list.
pub(super) fn strings(value: &Value) -> Vec<String> {
    value.as_array().into_iter().flatten().filter_map(|one| one.as_str().map(str::to_owned)).collect()
}
