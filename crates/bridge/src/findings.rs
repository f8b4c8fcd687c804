//! Collects what is wrong, all of it.

use crate::diagnostic::{Diagnostic, TextRange};
use ::findings::Severity;

/// Findings reported in one go; whoever has more starts with the first ones.
const MOST: usize = 500;

/// The findings so far.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    list: Vec<Diagnostic>,
    /// One more than fits, which nobody reads.
    beyond: Option<Diagnostic>,
    line_ends: Vec<usize>,
}

impl Findings {
    /// None yet, about this text.
    pub(crate) fn of(text: &[u8]) -> Findings {
        let line_ends = text.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at).collect();
        Findings { line_ends, ..Findings::default() }
    }

    /// Records an error: what is wrong, where, the words under the caret, and what to write instead.
    pub(crate) fn error(
        &mut self,
        code: &'static str,
        range: TextRange,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> &mut Diagnostic {
        let (message, label, help) = (message.into(), label.into(), Some(help.into()));
        self.add(Diagnostic { code, severity: Severity::Error, message, range, label, note: None, help })
    }

    /// Records an error for which nothing can be read.
    pub(crate) fn refuse<T>(
        &mut self,
        code: &'static str,
        range: TextRange,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> Option<T> {
        self.error(code, range, message, label, help);
        None
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
        let (message, label, help) = (message.into(), label.into(), Some(help.into()));
        self.add(Diagnostic { code, severity: Severity::Warning, message, range, label, note: None, help })
    }

    fn add(&mut self, finding: Diagnostic) -> &mut Diagnostic {
        let severity = finding.severity;
        let mut index = self.list.len();
        if index < MOST {
            self.list.push(finding);
            return &mut self.list[index];
        }
        // An error is worth more than a warning.
        let warning = self.list.iter().rposition(|known| known.severity == Severity::Warning);
        match warning.filter(|_| severity == Severity::Error) {
            Some(place) => index = place,
            None => return self.beyond.insert(finding),
        }
        self.list[index] = finding;
        &mut self.list[index]
    }

    /// Line of a place, from 1, for notes that point elsewhere.
    pub(crate) fn line(&self, place: TextRange) -> usize {
        1 + self.line_ends.partition_point(|end| *end < place.start)
    }

    /// Whether any finding is an error.
    pub(crate) fn any_error(&self) -> bool {
        self.list.iter().any(|finding| finding.severity == Severity::Error)
    }

    /// Drops findings that only follow from text that could not be read.
    pub(crate) fn retain(&mut self, keep: impl Fn(&Diagnostic, usize) -> bool) {
        let ends = std::mem::take(&mut self.line_ends);
        let line = |place: TextRange| 1 + ends.partition_point(|end| *end < place.start);
        self.list.retain(|finding| keep(finding, line(finding.range)));
        self.line_ends = ends;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Hundreds of warnings do not hide an error.
    #[test]
    fn an_error_outranks_warnings() {
        let mut findings = Findings::of(b"");
        (0..900).for_each(|k| {
            findings.warning("P001", TextRange::new(k, k + 1), "odd", "", "");
        });
        findings.error("B405", TextRange::new(0, 1), "wrong", "", "");
        assert!(findings.any_error());
        let list = findings.in_order(1000);
        assert_eq!(list.len(), MOST);
        assert_eq!(list.iter().filter(|finding| finding.code == "B405").count(), 1);
    }
}
