//! What a command answers: one object for scripts, a few lines for people.

use crate::page::Page;
use crate::render::{self, Paint};
use crate::screen::Screen;
use crate::status::Status;
use bridge::{Diagnostic, Severity};
use serde_json::{Map, Value, json};
use std::time::Instant;

/// The answer of a command.
#[derive(Debug, Clone)]
pub(crate) struct Report {
    /// How it ended.
    pub status: Status,
    /// Fields of the object besides the common ones.
    pub fields: Map<String, Value>,
    /// Warnings as objects with `code` and `message`, and a place where they come from a file.
    pub warnings: Vec<Value>,
    /// Errors, likewise.
    pub errors: Vec<Value>,
    /// The answer in words.
    pub summary: String,
    /// Whether every analysis came to its end: an answer that is undetermined for lack of something else says so by its code.
    pub finished: bool,
    /// Whether its words are the answer for scripts too: the JSON Schema.
    pub is_text: bool,
}

impl Report {
    /// An answer without fields yet.
    pub(crate) fn new(status: Status) -> Report {
        Report {
            status,
            fields: Map::new(),
            warnings: Vec::new(),
            errors: Vec::new(),
            summary: String::new(),
            finished: false,
            is_text: false,
        }
    }

    /// The exit code of the command: an assessment that finished without a verdict is 1, one that could not finish 3.
    pub(crate) fn exit_code(&self) -> u8 {
        match self.status {
            Status::Undetermined if self.finished => Status::Inadequate.exit_code(),
            status => status.exit_code(),
        }
    }

    /// Adds a field.
    pub(crate) fn with(mut self, key: &str, value: impl Into<Value>) -> Report {
        self.fields.insert(key.to_owned(), value.into());
        self
    }

    /// Sets the words.
    pub(crate) fn saying(mut self, summary: impl Into<String>) -> Report {
        self.summary = summary.into();
        self
    }

    /// Adds to what is said.
    pub(crate) fn adding(mut self, words: &str) -> Report {
        self.summary += words;
        self
    }

    /// Sets the words of a page: whole, or as a first screen with the warnings that matter most.
    pub(crate) fn show(&mut self, screen: &Screen, page: &Page) {
        self.summary = if screen.details { page.whole() } else { page.first(&self.warnings) };
    }

    /// Adds what was found in a file.
    pub(crate) fn add_findings(&mut self, name: &str, text: &[u8], list: &[Diagnostic]) {
        for finding in list {
            let value = extrados::written::finding(name, text, finding);
            match finding.severity {
                Severity::Error => self.errors.push(value),
                Severity::Warning | Severity::Note => self.warnings.push(value),
            }
        }
    }

    /// Adds what was found in a drawing: notes stand in a list of their own.
    pub(crate) fn add_drawing(&mut self, name: &str, list: &[drawing::Finding]) {
        let mut notes = Vec::new();
        for finding in list {
            let value = extrados::written::finding_in_drawing(name, finding);
            match finding.severity {
                Severity::Error => self.errors.push(value),
                Severity::Warning => self.warnings.push(value),
                Severity::Note => notes.push(value),
            }
        }
        if !notes.is_empty() {
            self.fields.insert("notes".to_owned(), json!(notes));
        }
    }

    /// Adds a warning of the analysis and shows it.
    pub(crate) fn warn(&mut self, screen: &mut Screen, code: &str, message: &str) {
        self.warn_with(screen, json!({ "code": code, "message": message }));
    }

    /// Adds a warning that may have a place and shows it.
    pub(crate) fn warn_with(&mut self, screen: &mut Screen, warning: Value) {
        let [code, message] = ["code", "message"].map(|key| warning[key].as_str().unwrap_or_default());
        // What concerns files and folders is told as it happens.
        if screen.tells_each() || !screen.quiet && code.starts_with('F') {
            screen.remark(&render::warning(code, message, &Paint::for_stderr()));
        }
        self.warnings.push(warning);
    }

    /// Adds the warnings of an analysis and shows them.
    pub(crate) fn warn_of(&mut self, screen: &mut Screen, warnings: &[outcome::warning::Warning]) {
        warnings.iter().for_each(|warning| self.warn(screen, warning.code(), &warning.message()));
    }

    /// The object: `schema` and `status`, the answer's fields, then `warnings`, `errors` where there are some,
    /// `wall_seconds`, `threads` and `version`.
    pub(crate) fn object(&self, schema: &str, clock: Instant) -> Value {
        let (fields, warnings) = (self.fields.clone(), self.warnings.clone());
        let mut object = extrados::written::headed(schema, self.status.name(), fields, warnings);
        if !self.errors.is_empty() {
            object.insert("errors".to_owned(), json!(self.errors));
        }
        object.insert("wall_seconds".to_owned(), json!(clock.elapsed().as_secs_f64()));
        object.insert("threads".to_owned(), json!(rayon::current_num_threads()));
        object.insert("version".to_owned(), json!(extrados::VERSION));
        Value::Object(object)
    }
}
