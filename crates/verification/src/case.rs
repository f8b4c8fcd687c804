//! What a `case.toml` says.

use bridge::choice::Choice;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use thiserror::Error;

bridge::choice! {
    /// What a case is compared with: kinds of evidence, whose counts are never added up.
    #[derive(PartialOrd, Ord)]
    pub enum Kind {
        /// closed forms
        Exact = "exact",
        /// approximate theory
        Analytical = "analytical",
        /// other programs and published numerical results
        Benchmark = "benchmark",
        /// tests
        Experiment = "experiment",
        /// this program's own past
        Regression = "regression",
    }
}

impl Kind {
    /// What a case of this kind is compared with.
    pub fn words(self) -> &'static str {
        Kind::WORDS[self as usize].doc
    }
}

/// How long it takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Class {
    /// Seconds: run with every test.
    Quick,
    /// Longer: run when asked.
    Slow,
}

/// Whether it is expected to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Standing {
    /// It holds; anything else is a failure.
    Holds,
    /// It does not hold yet; the reason is in `reason`.
    Open,
}

/// What an input is put through, where it is not what its sections say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Analysis {
    /// The file's train crosses.
    Respond,
    /// Moduli are sought from records: those of the case's twin, or those that the file names.
    Update,
    /// The file is assessed.
    Assess,
}

/// A number or a word.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A word, compared letter by letter; "true" and "false" stand for what is or is not so.
    Word(String),
}

/// One expectation.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expect {
    /// Key of the result object; `hinges.1.edge` reaches inside, `hinges.length` counts.
    pub quantity: String,
    /// What it should be; with `at_most` or `at_least` a bound.
    pub value: Option<Value>,
    /// Unit, for the reader.
    #[serde(default)]
    pub unit: String,
    /// Largest deviation, in the unit.
    pub tolerance: Option<f64>,
    /// Largest deviation relative to the value.
    pub relative: Option<f64>,
    /// Upper bound instead of a value.
    pub at_most: Option<f64>,
    /// Lower bound instead of a value.
    pub at_least: Option<f64>,
    /// Reason for the tolerance.
    pub why: String,
}

/// Changes to an input: dotted keys with their new value.
pub(crate) type Changes = BTreeMap<String, toml::Value>;

/// A case, ready to run.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Family and case: the last two folder names.
    #[serde(skip)]
    pub name: String,
    /// What it shows.
    pub title: String,
    /// What it is compared with.
    pub kind: Kind,
    /// Citation, page, table, equation.
    pub source: String,
    /// How long it takes.
    pub class: Class,
    status: Standing,
    /// Why it does not hold yet; `None` where it holds.
    #[serde(rename = "reason")]
    pub open: Option<String>,
    /// Path of the input.
    #[serde(default)]
    pub input: PathBuf,
    /// What the input is put through, where it is not what its sections say.
    pub run: Option<Analysis>,
    #[serde(default)]
    set: Changes,
    #[serde(rename = "twin")]
    set_twin: Option<Changes>,
    /// The bridge whose passage is the record of an update.
    #[serde(skip)]
    pub twin: Option<toml::Table>,
    /// What is expected.
    pub expect: Vec<Expect>,
    /// What the source says that cannot be right, and what is used.
    #[serde(default)]
    pub errata: Vec<String>,
    /// A change that must break at least one expectation.
    pub bite: Option<Changes>,
    #[serde(rename = "against")]
    set_against: Option<Changes>,
    /// The input of another run with which the result is compared.
    #[serde(skip)]
    pub against: Option<toml::Table>,
    /// The input after the case's own changes.
    #[serde(skip)]
    pub document: toml::Table,
}

/// Why a case cannot be run: a defect of the case.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{path}: {reason}")]
pub struct CaseError {
    /// The file.
    pub path: String,
    /// What is wrong.
    pub reason: String,
}

impl Case {
    /// Reads the case in `folder`.
    ///
    /// # Errors
    /// A file that is missing or wrong, or changes that do not fit it.
    pub fn read(folder: &Path) -> Result<Case, CaseError> {
        let path = folder.join("case.toml");
        let wrong = |path: &Path, reason: String| CaseError { path: path.display().to_string(), reason };
        let load = |path: &Path| crate::read_text(path).map_err(|e| wrong(path, e.to_string()));
        let mut case: Case = toml::from_str(&load(&path)?).map_err(|e| wrong(&path, e.to_string()))?;
        if let Some(bad) = case.expect.iter().find(|e| !e.is_complete()) {
            let reason = format!("{}: give a number with a tolerance, a word, or a bound", bad.quantity);
            return Err(wrong(&path, reason));
        }
        match case.status {
            Standing::Open if case.open.is_none() => return Err(wrong(&path, "an open case gives its reason".into())),
            Standing::Open => {}
            Standing::Holds => case.open = None,
        }
        if case.class == Class::Quick && case.bite.is_none() {
            return Err(wrong(&path, "a quick case has a [bite]: a change that must make it fail".into()));
        }
        case.input = match case.input.as_os_str().is_empty() {
            false => folder.join(&case.input),
            true => ["bridge.toml", "blocks.toml"]
                .map(|n| folder.join(n))
                .into_iter()
                .find(|p| p.is_file())
                .ok_or_else(|| wrong(&path, "there is neither bridge.toml nor blocks.toml beside it".into()))?,
        };
        let mut document: toml::Table =
            load(&case.input)?.parse().map_err(|e: toml::de::Error| wrong(&case.input, e.to_string()))?;
        change(&mut document, &case.set).map_err(|reason| wrong(&path, reason))?;
        locate(&mut document, &case.input);
        let changed = |changes: &Option<Changes>, what: &str| {
            let apply = |changes: &Changes| {
                let mut other = document.clone();
                change(&mut other, changes).map(|()| other).map_err(|reason| wrong(&path, format!("{what}: {reason}")))
            };
            changes.as_ref().map(apply).transpose()
        };
        (case.against, case.twin) = (changed(&case.set_against, "against")?, changed(&case.set_twin, "twin")?);
        if case.twin.is_some() && case.run != Some(Analysis::Update) {
            return Err(wrong(&path, "a [twin] is the record of a case with run = \"update\"".into()));
        }
        let part = |p: Option<&Path>| p.and_then(Path::file_name).map(|n| n.to_string_lossy().into_owned());
        case.name = [part(folder.parent()), part(Some(folder))].into_iter().flatten().collect::<Vec<_>>().join("/");
        case.document = document;
        Ok(case)
    }
}

/// Drawings and records are named relative to the file that names them; from here on, relative to the current folder.
fn locate(document: &mut toml::Table, input: &Path) {
    for (section, key) in [("drawing", "file"), ("records", "place")] {
        let file = document.get_mut(section).and_then(toml::Value::as_table_mut).and_then(|part| part.get_mut(key));
        if let (Some(toml::Value::String(name)), Some(folder)) = (file, input.parent()) {
            *name = folder.join(&*name).to_string_lossy().into_owned();
        }
    }
}

impl Expect {
    fn is_complete(&self) -> bool {
        let bounded = self.at_most.is_some() || self.at_least.is_some();
        let close = self.tolerance.is_some() || self.relative.is_some();
        !self.why.is_empty()
            && match &self.value {
                Some(Value::Number(_)) => close && !bounded,
                Some(Value::Word(_)) => !close && !bounded,
                None => bounded && !close,
            }
    }
}

/// Applies changes to a document. A key that is missing at its last place is added; `"remove"` under the key `-name`
/// takes it away.
pub(crate) fn change(document: &mut toml::Table, changes: &Changes) -> Result<(), String> {
    for (key, value) in changes {
        let mut at = &mut *document;
        let parts: Vec<&str> = key.split('.').collect();
        let (last, inner) = parts.split_last().expect("splitting gives at least one part");
        let mut rest = inner.iter().peekable();
        while let Some(part) = rest.next() {
            let next = at.get_mut(*part).ok_or_else(|| format!("the input has no {part} of {key}"))?;
            at = match next {
                toml::Value::Table(table) => table,
                toml::Value::Array(rows) => {
                    let index = rest.next().and_then(|i| i.parse::<usize>().ok());
                    let row = index.and_then(|i| rows.get_mut(i)).and_then(toml::Value::as_table_mut);
                    row.ok_or_else(|| format!("{key}: after {part} comes the number of a row, from 0"))?
                }
                _ => return Err(format!("{part} of {key} is a value, not a table")),
            };
        }
        match last.strip_prefix('-') {
            Some(name) => {
                at.remove(name).ok_or_else(|| format!("the input has no {key} to remove"))?;
            }
            None => {
                at.insert((*last).to_string(), value.clone());
            }
        }
    }
    Ok(())
}
