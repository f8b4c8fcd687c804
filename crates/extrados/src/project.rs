//! A bridge file with everything that it takes from other files: what every analysis starts from.

use crate::files::Files;
use crate::refusal::Refusal;
use crate::{companions, names};
use assess::analysis::update::RecordFile;
use bridge::case::Case;
use bridge::edit::Document;
use bridge::path::Path as QuantityPath;
use bridge::vary::{Setting, find, parse_setting, settle};
use bridge::{Bridge, Diagnostic, Read, Severity};
use report::Photograph;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A bridge file that was read, with its companions: packings, trains, vehicles, rules and records. It does not change; varied
/// projects are made by [`Project::with`].
#[derive(Debug, Clone)]
pub struct Project {
    name: String,
    text: Vec<u8>,
    read: Read,
    inputs: Arc<[PathBuf]>,
    records: Arc<Result<Vec<RecordFile>, Refusal>>,
    photographs: Arc<[Photograph]>,
}

impl Project {
    /// Reads a bridge file and the files that it names, relative to it. A file with mistakes is read as well: they are among
    /// its [`findings`](Self::findings), and it has no [`bridge`](Self::bridge).
    ///
    /// # Errors
    /// A file that cannot be read (F101), or a companion that cannot be used (F120, F121). Records that cannot be read are told by
    /// [`records`](Self::records).
    pub fn read(path: impl AsRef<Path>, files: &dyn Files) -> Result<Project, Refusal> {
        let path = path.as_ref();
        let text = companions::main_text(path, files)?;
        let mut read = bridge::read(&text);
        companions::take(&mut read, path, files)?;
        names::look_up(&mut read, &text);
        let inputs = companions::inputs(&read, path, files).into();
        let readings = companions::readings(&mut read, path, files);
        let records = match read.update.as_ref().and_then(|asked| asked.records.as_ref()) {
            Some(records) => companions::records(path, &records.place, files),
            None => Ok(Vec::new()),
        };
        let records = readings.and(records);
        let photographs = companions::photographs(&read, path, files).into();
        Ok(Project { name: path.display().to_string(), text, read, inputs, records: Arc::new(records), photographs })
    }

    /// The path of the file, as it was given.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text of the file, in UTF-8.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// Everything that the file says: the bridge, what is varied, what is sought, what is asked of it.
    pub fn meaning(&self) -> &Read {
        &self.read
    }

    /// Errors, doubts and notes, in the order of the file.
    pub fn findings(&self) -> &[Diagnostic] {
        &self.read.diagnostics
    }

    /// Its errors in words, each with its line.
    pub fn errors(&self) -> impl Iterator<Item = String> {
        self.findings().iter().filter(|finding| finding.severity == Severity::Error).map(|finding| {
            let line = bridge::text::position(&self.text, finding.range.start).line;
            format!("line {line}: {} ({})", finding.message, finding.code)
        })
    }

    /// The paths of the files that were read beside it, records among them.
    pub fn inputs(&self) -> &[PathBuf] {
        &self.inputs
    }

    /// The bridge.
    ///
    /// # Errors
    /// The file's own errors, each with its line, where it cannot be used (F108).
    pub fn bridge(&self) -> Result<&Bridge, Refusal> {
        self.read.bridge.as_ref().ok_or_else(|| {
            let told: Vec<String> = self.errors().collect();
            let message = format!("{} cannot be used: {}", self.name, told.join("; "));
            Refusal::new("F108", message, "extrados check FILE shows every error with its place")
        })
    }

    /// The records that the file names; empty where it names none.
    ///
    /// # Errors
    /// Records or readings of a load test that are missing or cannot be read (F101, F130).
    pub fn records(&self) -> Result<&[RecordFile], Refusal> {
        self.records.as_ref().as_ref().map(Vec::as_slice).map_err(Clone::clone)
    }

    /// Photographs that its document names, those that cannot be read among them.
    pub fn photographs(&self) -> &[Photograph] {
        &self.photographs
    }

    /// The file's text as a tree that can be edited, without the named sections.
    pub(crate) fn document(&self, without: &[&str]) -> Result<Document, Refusal> {
        let mut document = Document::parse(std::str::from_utf8(&self.text).unwrap_or_default()).ok_or_else(|| {
            Refusal::new("F114", format!("{} cannot be edited", self.name), "check it with extrados check")
        })?;
        without.iter().for_each(|section| document.remove(section));
        Ok(document)
    }

    /// The file's text as a tree that can be edited, without its ranges.
    ///
    /// # Errors
    /// A text that cannot be edited (F114).
    pub fn document_without_ranges(&self) -> Result<Document, Refusal> {
        self.document(&["vary"])
    }

    /// What an edited text of the same file means. Companions are those of this project: a text that names others cannot be used.
    pub fn read_again(&self, text: &[u8]) -> Read {
        let mut read = bridge::read(text);
        if let (Some(bridge), Some(known)) = (&mut read.bridge, &self.read.bridge)
            && !bridge.take_over(known)
        {
            read.bridge = None;
            read.diagnostics.push(Diagnostic {
                code: "B013",
                severity: Severity::Error,
                message: "an edited file names another file beside it".to_owned(),
                range: bridge::TextRange::new(0, 0),
                label: "it was not read with the bridge".to_owned(),
                note: None,
                help: Some("change the bridge file itself and read it anew".to_owned()),
            });
        }
        names::look_up(&mut read, text);
        read
    }

    /// The same project with an edited text.
    pub(crate) fn reworded(&self, text: Vec<u8>) -> Project {
        let read = self.read_again(&text);
        Project { text, read, ..self.clone() }
    }

    /// The bridge as one of the file's cases has it: its loads with their factors, its weights, its changed values.
    ///
    /// # Errors
    /// Changed values with which the file cannot be used (B501 to B503, F108).
    pub fn in_case(&self, case: &Case) -> Result<Project, Refusal> {
        let mut document = self.document(&["case"])?;
        for change in &case.changes {
            let settled = settle(&find(&document, &change.quantity)?, &change.spread)?;
            for value in &settled.values {
                document.set(&settled.path, &value.literal).map_err(|_| {
                    Refusal::new(
                        "F114",
                        format!("{}: the file has no place for it", settled.path),
                        "extrados vary FILE --list",
                    )
                })?;
            }
        }
        let text = document.text().into_bytes();
        let mut read = self.read_again(&text);
        read.bridge = read.bridge.map(|bridge| case.put(&bridge));
        let own = Project { text, read, ..self.clone() };
        own.bridge()?;
        Ok(own)
    }

    /// The same file with other values, each as on the command line: `joint.friction_angle=30deg`, `masonry.density=2300 kg/m^3`.
    /// Values go through the file's text and its one reader, so that units, limits and doubts are those of the file.
    ///
    /// # Errors
    /// Every edit that names no quantity or gives no value that fits (B501 to B503), or what the reader says of the edited text.
    pub fn with<E: AsRef<str>>(&self, edits: &[E]) -> Result<Project, Vec<Refusal>> {
        let varied = self.edited(edits)?;
        varied.bridge()?;
        Ok(varied)
    }

    /// The same, where the edited text may be one that the reader has something against: that is among its findings then.
    ///
    /// # Errors
    /// Every edit that names no quantity or gives no value that fits (B501 to B503).
    pub fn edited<E: AsRef<str>>(&self, edits: &[E]) -> Result<Project, Vec<Refusal>> {
        let mut document = self.document(&[])?;
        let mut refusals = Vec::new();
        for edit in edits {
            match setting(&document, edit.as_ref()) {
                Ok((path, literal)) if document.set(&path, &literal).is_ok() => {}
                Ok((path, _)) => {
                    let help = "extrados vary FILE --list shows what the file has";
                    refusals.push(Refusal::new("F114", format!("{path}: the file has no place for it"), help));
                }
                Err(refusal) => refusals.push(refusal),
            }
        }
        if !refusals.is_empty() {
            return Err(refusals);
        }
        let text = document.text().into_bytes();
        Ok(self.reworded(text))
    }
}

/// The path and the one value of `PATH=VALUE`.
fn setting(document: &Document, edit: &str) -> Result<(QuantityPath, String), Refusal> {
    let settled = parse_setting(document, edit)
        .and_then(|request| settle(&find(document, &request.quantity)?, &request.spread))?;
    match <[Setting; 1]>::try_from(settled.values) {
        Ok([value]) => Ok((settled.path, value.literal)),
        Err(values) => {
            let message = format!("`{edit}` gives {} values", values.len());
            Err(Refusal::new("B503", message, "give one value; extrados::vary makes runs over several"))
        }
    }
}
