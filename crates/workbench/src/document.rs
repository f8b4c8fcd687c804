//! One bridge with the files beside it, as somebody edits it.

use crate::border::Thrown;
use crate::reading;
use extrados::bridge::vary::{Spread, find, settle};
use extrados::bridge::{edit, is_block_file};
use extrados::figures::bridge_as_drawn;
use extrados::results::picture::Picture;
use extrados::{Blocks, Memory, Project, Refusal};
use std::path::{Path, PathBuf};
use wasm_bindgen::prelude::*;

/// A bridge file or a block model file.
#[wasm_bindgen]
pub struct Document {
    path: PathBuf,
    text: String,
    files: Memory,
    /// What the text means.
    pub(crate) read: Read,
}

/// What the text means.
pub(crate) enum Read {
    Bridge(Box<Project>),
    Blocks(Box<Blocks>),
    /// It cannot be read, or a file beside it cannot.
    Refused(Refusal),
}

#[wasm_bindgen]
impl Document {
    /// Of a text at a path; companions are named relative to it.
    #[wasm_bindgen(constructor)]
    pub fn new(path: &str, text: &str) -> Document {
        let mut this = Document {
            path: PathBuf::from(path),
            text: text.to_owned(),
            files: Memory::default(),
            read: Read::Refused(Refusal::new("F101", "", "")),
        };
        this.read();
        this
    }

    /// A file beside it.
    pub fn put(&mut self, path: &str, bytes: Vec<u8>) {
        self.files = std::mem::take(&mut self.files).with(path, bytes);
        self.read();
    }

    /// Takes a file beside it away.
    #[wasm_bindgen(js_name = drop)]
    pub fn take_away(&mut self, path: &str) {
        self.files = std::mem::take(&mut self.files).without(Path::new(path));
        self.read();
    }

    /// Another text, whatever it says.
    pub fn set_text(&mut self, text: &str) {
        text.clone_into(&mut self.text);
        self.read();
    }

    fn read(&mut self) {
        let files = self.files.clone().with(&self.path, self.text.as_bytes());
        self.read = match is_block_file(self.text.as_bytes()) {
            true => {
                Blocks::read(&self.path, &files).map_or_else(Read::Refused, |blocks| Read::Blocks(Box::new(blocks)))
            }
            false => {
                Project::read(&self.path, &files).map_or_else(Read::Refused, |project| Read::Bridge(Box::new(project)))
            }
        };
    }

    /// The text.
    pub fn text(&self) -> String {
        self.text.clone()
    }

    /// The bridge file that analyses take.
    ///
    /// # Errors
    /// Why there is none: a file beside it, or a block model file, which only collapses.
    pub(crate) fn project(&self) -> Result<&Project, Refusal> {
        match &self.read {
            Read::Bridge(project) => Ok(project),
            Read::Refused(refusal) => Err(refusal.clone()),
            Read::Blocks(blocks) => {
                let message = format!("{} is a block model file: its blocks collapse, and nothing else", blocks.name());
                Err(Refusal::new("F108", message, "write a bridge file, which has spans and rings"))
            }
        }
    }

    /// Findings, what there is to analyse.
    pub fn reading(&self) -> String {
        reading::reading(self).to_string()
    }

    /// Values with their units, ranges and places.
    pub fn quantities(&self) -> String {
        reading::quantities(&self.text).to_string()
    }

    /// The bridge as its file describes it; null where it has errors.
    pub fn picture(&self) -> String {
        serde_json::to_string(&self.built()).unwrap_or_else(|_| "null".to_owned())
    }

    fn built(&self) -> Option<Picture> {
        match &self.read {
            Read::Bridge(project) => extrados::as_built(project).ok(),
            Read::Blocks(blocks) => blocks.as_built(),
            Read::Refused(_) => None,
        }
    }

    /// The same as a drawing (SVG).
    pub fn drawing(&self) -> String {
        self.built().as_ref().map(bridge_as_drawn).unwrap_or_default()
    }

    /// Writes one value at its path, in the place of the one that is there; every other byte stays.
    ///
    /// # Errors
    /// A path that leads to no quantity, a value that does not fit (B501 to B503, F114).
    pub fn set(&mut self, path: &str, literal: &str) -> Result<(), Thrown> {
        let unfit = || {
            let message = format!("{path}: the file has no place for it");
            Refusal::new("F114", message, "mend the text first, or write the line by hand")
        };
        let mut document = edit::Document::parse(&self.text).ok_or_else(unfit)?;
        let settled = settle(&find(&document, path)?, &Spread::List(vec![reading::literal(literal)]))?;
        // What somebody set is no assumption any more.
        if document.said(&settled.path).is_some_and(|(_, remark)| remark.starts_with("assumed")) {
            document.remark(&settled.path, "set by hand").map_err(|_| unfit())?;
        }
        for value in &settled.values {
            document.set(&settled.path, &value.literal).map_err(|_| unfit())?;
        }
        self.set_text(&document.text());
        Ok(())
    }
}
