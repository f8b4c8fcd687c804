//! Places in a text: from byte ranges to lines and columns as an editor counts them.

use crate::diagnostic::TextRange;

/// A place as an editor shows it, both counted from 1; columns count characters, not bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Position {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

/// Line and column of a byte offset. Offsets beyond the end give the end; bytes that are no UTF-8 count as one
/// character each.
pub fn position(text: &[u8], offset: usize) -> Position {
    let before = &text[..offset.min(text.len())];
    let line_start = before.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
    Position {
        line: 1 + before.iter().filter(|byte| **byte == b'\n').count(),
        column: 1 + characters(&before[line_start..]),
    }
}

impl TextRange {
    /// A range from its two ends.
    pub fn new(start: usize, end: usize) -> TextRange {
        TextRange { start, end: end.max(start) }
    }

    /// Line and column of the first character.
    pub fn position(&self, text: &[u8]) -> Position {
        position(text, self.start)
    }

    /// The same range cut to a text of this length.
    pub(crate) fn within(self, length: usize) -> TextRange {
        TextRange::new(self.start.min(length), self.end.min(length))
    }
}

impl From<std::ops::Range<usize>> for TextRange {
    fn from(range: std::ops::Range<usize>) -> TextRange {
        TextRange::new(range.start, range.end)
    }
}

fn characters(bytes: &[u8]) -> usize {
    bytes.utf8_chunks().map(|chunk| chunk.valid().chars().count() + chunk.invalid().len()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let text = "a = 1\nname = \"Ångström\" # x\n".as_bytes();
        assert_eq!(position(text, 0), Position { line: 1, column: 1 });
        assert_eq!(position(text, 6), Position { line: 2, column: 1 });
        let hash = text.iter().position(|byte| *byte == b'#').unwrap();
        assert_eq!(position(text, hash), Position { line: 2, column: 19 });
    }

    #[test]
    fn any_offset_and_any_bytes_have_a_place() {
        let text = b"ab\xff\xfec\n";
        assert_eq!(position(text, 4), Position { line: 1, column: 5 });
        assert_eq!(position(text, 1000), Position { line: 2, column: 1 });
        assert_eq!(position(b"", 7), Position { line: 1, column: 1 });
    }
}
