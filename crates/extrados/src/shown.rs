//! Findings of a bridge file in words, with the line and a caret under the place; colours are the command's.

use bridge::{Diagnostic, TextRange};
use findings::visible::is_hidden;
use std::fmt::Write;
use unicode_width::UnicodeWidthChar;

/// Widest stretch of a source line that is shown [columns].
const WIDEST: usize = 110;
/// A tab is drawn this wide [columns].
const TAB: usize = 4;

/// A finding about the text of a file: code and message, place, line with carets, remedy.
pub fn finding_in_words(name: &str, text: &[u8], finding: &Diagnostic) -> String {
    let place = bridge::text::position(text, finding.range.start);
    let excerpt = Excerpt::of(text, finding.range);
    let gutter = place.line.to_string().len().max(3);
    let mut page = String::new();
    let _ = writeln!(page, "{}[{}]: {}", finding.severity.word(), finding.code, finding.message);
    let _ = writeln!(page, "  {name}:{}:{}", place.line, place.column);
    let _ = writeln!(page, "{:>gutter$} | {}", place.line, excerpt.shown);
    let carets = "^".repeat(excerpt.carets);
    let _ = writeln!(page, "{:gutter$} | {:indent$}{carets} {}", "", "", finding.label, indent = excerpt.indent);
    for (word, words) in [("note", &finding.note), ("help", &finding.help)] {
        if let Some(words) = words {
            let _ = writeln!(page, "  {word}: {words}");
        }
    }
    page
}

/// What is shown of a line, and where the carets stand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt {
    /// The line, or the stretch of it about the place; free of control characters.
    pub shown: String,
    /// Columns before the carets.
    pub indent: usize,
    /// How many carets stand under the marked text.
    pub carets: usize,
}

impl Excerpt {
    /// The line of a text in which a range begins; the range may pass the end of the line, and of the text.
    pub fn of(text: &[u8], range: TextRange) -> Excerpt {
        let place = range.start.min(text.len());
        let start = text[..place].iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
        let end = text[place..].iter().position(|byte| *byte == b'\n').map_or(text.len(), |length| place + length);
        let words = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim_end_matches('\r').to_owned();
        let (before, after) = (words(&text[start..place]), words(&text[place..end]));
        let mut marked_end = range.end.saturating_sub(range.start).min(after.len());
        while !after.is_char_boundary(marked_end) {
            marked_end += 1;
        }
        let mut before = drawn(&before);
        let (mut marked, mut rest) = (drawn(&after[..marked_end]), drawn(&after[marked_end..]));
        if width(&before) > WIDEST / 2 {
            before = format!("…{}", last_columns(&before, WIDEST / 3));
        }
        let room = WIDEST - width(&before);
        if width(&marked) > room {
            marked = format!("{}…", first_columns(&marked, room));
            rest.clear();
        }
        let room = room.saturating_sub(width(&marked));
        if width(&rest) > room {
            rest = format!("{}…", first_columns(&rest, room));
        }
        Excerpt { indent: width(&before), carets: width(&marked).max(1), shown: format!("{before}{marked}{rest}") }
    }
}

/// Text without tabs and control characters.
fn drawn(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\t' => shown += &" ".repeat(TAB),
            c if is_hidden(c) => shown.push('\u{fffd}'),
            c => shown.push(c),
        }
    }
    shown
}

fn width(text: &str) -> usize {
    text.chars().map(|c| c.width().unwrap_or(0)).sum()
}

fn first_columns(text: &str, columns: usize) -> String {
    let mut used = 0;
    text.chars()
        .take_while(|c| {
            used += c.width().unwrap_or(0);
            used <= columns
        })
        .collect()
}

fn last_columns(text: &str, columns: usize) -> String {
    let reversed: String = text.chars().rev().collect();
    first_columns(&reversed, columns).chars().rev().collect()
}
