//! What is wrong with a file, as plain data. Rendering is a face's business.

use ::findings::Severity;

/// A stretch of the source text, in bytes; line and column are counted from 1, columns in characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TextRange {
    /// First byte.
    pub start: usize,
    /// Byte after the last.
    pub end: usize,
}

/// One finding about a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// Stable code: `B…` for errors in the file, `P…` for plausibility. `extrados explain CODE` tells more.
    pub code: &'static str,
    /// Error or warning; a file has no notes.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// Where.
    pub range: TextRange,
    /// Words under the caret.
    pub label: String,
    /// Why it matters, where more can be said.
    pub note: Option<String>,
    /// What to write instead.
    pub help: Option<String>,
}
