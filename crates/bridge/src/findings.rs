//! Collects what is wrong, all of it.

use crate::diagnostic::{Diagnostic, Severity, TextRange};

/// The findings so far.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    list: Vec<Diagnostic>,
}

impl Findings {
    /// Records an error: what is wrong, where, the words under the caret, and what to write instead.
    pub(crate) fn error(
        &mut self,
        code: &'static str,
        range: TextRange,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> &mut Diagnostic {
        self.add(code, Severity::Error, range, message.into(), label.into(), help.into())
    }

    /// Records a warning: what is odd, where, the words under the caret, and what to write if it is a slip.
    pub(crate) fn warning(
        &mut self,
        code: &'static str,
        range: TextRange,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> &mut Diagnostic {
        self.add(code, Severity::Warning, range, message.into(), label.into(), help.into())
    }

    fn add(
        &mut self,
        code: &'static str,
        severity: Severity,
        range: TextRange,
        message: String,
        label: String,
        help: String,
    ) -> &mut Diagnostic {
        let index = self.list.len();
        self.list.push(Diagnostic { code, severity, message, range, label, note: None, help: Some(help) });
        &mut self.list[index]
    }

    /// Whether any finding is an error.
    pub(crate) fn any_error(&self) -> bool {
        self.list.iter().any(|finding| finding.severity == Severity::Error)
    }

    /// Drops findings that only follow from text that could not be read.
    pub(crate) fn retain(&mut self, keep: impl FnMut(&Diagnostic) -> bool) {
        self.list.retain(keep);
    }

    /// All findings in the order of the file, cut to its length, each once.
    pub(crate) fn in_order(mut self, length: usize) -> Vec<Diagnostic> {
        for finding in &mut self.list {
            finding.range = finding.range.within(length);
        }
        self.list.sort_by_key(|finding| (finding.range.start, finding.range.end, finding.code));
        self.list.dedup();
        self.list
    }
}

impl Diagnostic {
    /// Adds why it matters.
    pub(crate) fn because(&mut self, note: impl Into<String>) {
        self.note = Some(note.into());
    }
}
