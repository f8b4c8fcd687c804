//! Reports as PDF: the strings of a report (`report::Assessed::data`) are set by Typst in this process. Nothing is read but what is
//! handed over, no file and no network; the same bytes for the same strings.

#[cfg(test)]
mod tests;
mod world;

use serde_json::Value;
use std::fmt;
use typst::diag::SourceDiagnostic;
use typst::foundations::Smart;
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandards};
use world::Memory;

/// Why a report could not be set: what the typesetter said, one line each.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unset {
    /// What it said.
    pub words: Vec<String>,
}

impl fmt::Display for Unset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.words.join("; "))
    }
}

impl std::error::Error for Unset {}

/// Stack for nested layouts [bytes]; those of a report stay far below, also without optimisation.
const STACK: usize = 64 << 20;

/// The report as PDF. Every text of `data` is set as it stands: none is read as markup.
///
/// # Errors
/// What the typesetter said, or that it broke off.
pub fn pdf(data: &Value) -> Result<Vec<u8>, Unset> {
    let unset = |words: String| Unset { words: vec![words] };
    let json = data.to_string();
    let set = std::thread::Builder::new()
        .name("typesetter".to_owned())
        .stack_size(STACK)
        .spawn(move || {
            let result = set(json);
            // The typesetter remembers what it set; a long run must not grow by each report.
            typst::comemo::evict(0);
            result
        })
        .map_err(|error| unset(format!("no thread for the typesetter: {error}")))?;
    set.join().unwrap_or_else(|_| Err(unset("the typesetter broke off".to_owned())))
}

fn set(json: String) -> Result<Vec<u8>, Unset> {
    let world = Memory::new(json).map_err(|error| Unset { words: vec![error] })?;
    let said = |list: &[SourceDiagnostic]| Unset { words: list.iter().map(|one| one.message.to_string()).collect() };
    let document = typst::compile::<PagedDocument>(&world).output.map_err(|list| said(&list))?;
    let options = PdfOptions {
        creator: Smart::Custom(Some(format!("Extrados {}", env!("CARGO_PKG_VERSION")))),
        standards: PdfStandards::default(),
        ..PdfOptions::default()
    };
    typst_pdf::pdf(&document, &options).map_err(|list| said(&list))
}
