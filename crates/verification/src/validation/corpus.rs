//! A folder of tests, read and checked before anything is computed.

use super::document::{Level, bridge_of, dimensions, document};
use super::field_test::FieldTest;
use super::priors::Priors;
use outcome::validation::Predictor;
use serde::de::DeserializeOwned;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A bridge that was loaded to collapse.
#[derive(Debug, Clone, PartialEq)]
pub struct Test {
    /// Name of its folder.
    pub name: String,
    /// What was measured.
    pub field: FieldTest,
    /// Its geometry and its load, as a bridge file without materials.
    pub bridge: toml::Table,
}

/// All tests of a folder, with the prior values that every one of them is predicted from.
#[derive(Debug, Clone, PartialEq)]
pub struct Corpus {
    /// What is known of materials beforehand.
    pub priors: Priors,
    /// In the order of their names.
    pub tests: Vec<Test>,
}

/// What is wrong with a folder of tests.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum CorpusError {
    /// There is none.
    #[error("{0}")]
    Absent(String),
    /// A file of it cannot be used.
    #[error("{path}: {reason}")]
    Wrong {
        /// The file.
        path: String,
        /// The key and what is wrong with it.
        reason: String,
        /// What to do.
        help: String,
    },
}

/// Sections that come from the priors.
const FROM_PRIORS: [&str; 9] =
    ["masonry", "joint", "ring_joint", "backing", "fill_pressure", "continuum", "particles", "dispersal", "analysis"];

/// The file of a folder of tests that states what is known beforehand.
const PRIORS: &str = "priors.toml";

impl Corpus {
    /// Reads a folder of tests; with `only`, the tests of these names.
    ///
    /// # Errors
    /// A folder or a test that is not there, or a file that cannot be used.
    pub fn read(root: &Path, only: &[String]) -> Result<Corpus, CorpusError> {
        let priors = root.join(PRIORS);
        if !priors.is_file() {
            let what = if root.exists() { "holds no priors.toml" } else { "is not here" };
            return Err(CorpusError::Absent(format!("the folder of tests {} {what}", root.display())));
        }
        let values: Priors = read(&priors, "validation/README.md lists the keys of priors.toml")?;
        if let Some(reason) = values.wrong() {
            return Err(wrong(&priors, reason, "mend the value"));
        }
        let folders = folders(root).map_err(|error| wrong(root, error.to_string(), "make the folder readable"))?;
        let names: Vec<String> = folders.iter().map(|folder| name_of(folder)).collect();
        if let Some(unknown) = only.iter().find(|one| !names.contains(one)) {
            let known = if names.is_empty() { "no test".to_owned() } else { names.join(", ") };
            return Err(CorpusError::Absent(format!("{} has no test {unknown}: it has {known}", root.display())));
        }
        if names.is_empty() {
            return Err(CorpusError::Absent(format!("{} holds no folder with a test", root.display())));
        }
        let wanted = folders.iter().filter(|folder| only.is_empty() || only.contains(&name_of(folder)));
        let tests = wanted.map(|folder| test(folder, &values)).collect::<Result<_, _>>()?;
        Ok(Corpus { priors: values, tests })
    }
}

fn name_of(folder: &Path) -> String {
    folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Folders in a folder, in the order of their names; hidden ones are left out.
fn folders(root: &Path) -> io::Result<Vec<PathBuf>> {
    let paths = fs::read_dir(root)?.map(|entry| entry.map(|entry| entry.path()));
    let mut found: Vec<PathBuf> = paths.collect::<io::Result<_>>()?;
    found.retain(|path| path.is_dir() && !name_of(path).starts_with('.'));
    found.sort();
    Ok(found)
}

fn wrong(path: &Path, reason: impl Into<String>, help: impl Into<String>) -> CorpusError {
    CorpusError::Wrong { path: path.display().to_string(), reason: reason.into(), help: help.into() }
}

fn read<T: DeserializeOwned>(path: &Path, help: &str) -> Result<T, CorpusError> {
    let text = crate::read_text(path).map_err(|error| wrong(path, error.to_string(), "make the file readable"))?;
    toml::from_str(&text).map_err(|error| wrong(path, error.to_string().trim().to_owned(), help))
}

fn test(folder: &Path, priors: &Priors) -> Result<Test, CorpusError> {
    let (description, geometry) = (folder.join("test.toml"), folder.join("bridge.toml"));
    let beside =
        "a test has test.toml (what was measured) and bridge.toml (geometry and load); remove the folder if it is none";
    for path in [&description, &geometry] {
        if !path.is_file() {
            return Err(wrong(path, "it is missing", beside));
        }
    }
    let field: FieldTest = read(&description, "validation/README.md lists the keys of test.toml")?;
    if let Some(reason) = field.wrong() {
        return Err(wrong(&description, reason, "mend the key; validation/README.md says what it means"));
    }
    let kinds = [
        ("masonry", &field.masonry, priors.masonry.keys().cloned().collect::<Vec<_>>()),
        ("fill", &field.fill, priors.fill.keys().cloned().collect()),
        ("backing", &field.backing, priors.backing.keys().cloned().collect()),
    ];
    for (key, kind, known) in kinds {
        if !known.contains(kind) {
            let reason = format!("{key}: the priors have no {key} \"{kind}\"");
            return Err(wrong(&description, reason, format!("write one of {}", known.join(", "))));
        }
    }
    let bridge: toml::Table = read(&geometry, "docs/input/reference.md lists the keys of a bridge file")?;
    if let Some(section) = FROM_PRIORS.into_iter().find(|section| bridge.contains_key(*section)) {
        let reason = format!("[{section}]: materials and methods come from priors.toml, the same for every test");
        return Err(wrong(&geometry, reason, format!("remove [{section}]")));
    }
    let test = Test { name: name_of(folder), field, bridge };
    let mend = "mend the key, or the value at the end of an interval";
    dimensions(&test, None).map_err(|reason| wrong(&description, reason, mend))?;
    for run in super::predict::ends(&test) {
        let document = document(&test, priors, Predictor::Weight, run);
        let (path, help) = match run {
            (Level::Expected, None) => (&geometry, "mend the bridge file; docs/input/reference.md lists its keys"),
            _ => (&description, mend),
        };
        let document = document.map_err(|reason| wrong(path, reason, help))?;
        bridge_of(&document).map_err(|reason| wrong(path, reason, help))?;
    }
    Ok(test)
}
