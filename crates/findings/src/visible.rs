//! Text that somebody else wrote, on its way out: to a terminal, into a table. Names and notes come from files, and a file may come
//! from anybody.

use std::borrow::Cow;

/// What stands for a character that cannot be shown.
const UNSHOWN: char = '\u{fffd}';

/// Whether a character acts instead of being seen: controls (a terminal obeys them), those that turn the direction of what follows (Unicode standard
/// annex 9), so that words are not read as they stand, and those of no width and tags, by which two names that look alike are not. Joiners stay: letters of
/// several scripts need them.
pub fn is_hidden(character: char) -> bool {
    let acts = matches!(character, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}'
        | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}');
    character.is_control() || acts
}

/// The text without characters that act: lines stay lines, tabs become spaces.
pub fn visible(text: &str) -> Cow<'_, str> {
    replaced(text, |character| match character {
        '\n' => '\n',
        '\t' => ' ',
        _ => UNSHOWN,
    })
}

/// The same in one line.
pub fn one_line(text: &str) -> Cow<'_, str> {
    replaced(text, |character| if matches!(character, '\n' | '\r' | '\t') { ' ' } else { UNSHOWN })
}

fn replaced(text: &str, by: impl Fn(char) -> char) -> Cow<'_, str> {
    match text.chars().any(|character| is_hidden(character) && by(character) != character) {
        true => text.chars().map(|character| if is_hidden(character) { by(character) } else { character }).collect(),
        false => Cow::Borrowed(text),
    }
}

/// Characters with which a spreadsheet begins a formula.
const FORMULA: [char; 8] = ['=', '+', '-', '@', '＝', '＋', '－', '＠'];

/// Text of a cell that no spreadsheet takes for a formula: an apostrophe stands before what would begin one, also behind a semicolon,
/// which divides cells where the comma is the decimal sign. Numbers stay numbers.
pub fn harmless(text: &str) -> String {
    guarded(&one_line(text), &[';'])
}

/// The same for a line of a table that is no row, in which commas divide too.
pub fn harmless_line(text: &str) -> String {
    guarded(&one_line(text), &[',', ';'])
}

/// Text of a cell of a CSV table (RFC 4180): [`harmless`], in quotation marks where it has what divides cells.
pub fn cell(text: &str) -> String {
    let text = harmless(text);
    if text.contains(['"', ',', ';']) { in_quotes(&text) } else { text }
}

/// The same, in quotation marks whatever it is.
pub fn quoted_cell(text: &str) -> String {
    in_quotes(&harmless(text))
}

/// A cell as it was before [`harmless`] put its apostrophe there.
pub fn unguarded(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|rest| rest.starts_with(FORMULA)).unwrap_or(cell)
}

fn in_quotes(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

fn guarded(text: &str, dividers: &[char]) -> String {
    let is_number = |piece: &str| piece.parse::<f64>().is_ok_and(f64::is_finite);
    let mut out = String::with_capacity(text.len() + 1);
    for piece in text.split_inclusive(dividers) {
        let start =
            piece.trim_start_matches(|character: char| character.is_whitespace() || matches!(character, '"' | '\''));
        // What stands before it already keeps it text.
        let kept = piece[..piece.len() - start.len()].starts_with('\'');
        if start.starts_with(FORMULA) && !kept && !is_number(piece.trim_end_matches(dividers).trim()) {
            out.push('\'');
        }
        out.push_str(piece);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_acts_is_not_shown_and_everything_else_is() {
        assert_eq!(visible("a\u{1b}[2Jb\u{9b}c\u{7f}\r\nd\te"), "a\u{fffd}[2Jb\u{fffd}c\u{fffd}\u{fffd}\nd e");
        assert_eq!(one_line("bridge\nAdequate\u{202e}x\u{2067}"), "bridge Adequate\u{fffd}x\u{fffd}");
        assert_eq!(
            one_line("a\u{200f}\u{ad}b\u{61c}c\u{200b}d\u{e0041}e"),
            "a\u{fffd}\u{fffd}b\u{fffd}c\u{fffd}d\u{fffd}e"
        );
        for plain in ["Pont de Palé", "橋", "جسر", "גשר", "a–b · 1/4 ≤ 2", "می\u{200c}روم"] {
            assert!(matches!(visible(plain), Cow::Borrowed(same) if same == plain));
        }
    }

    #[test]
    fn no_text_begins_a_formula_and_numbers_stay() {
        let cured = [
            ("=1+1", "'=1+1"),
            ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
            ("@SUM(1)", "'@SUM(1)"),
            ("-2+3+cmd", "'-2+3+cmd"),
            ("\t=1", "' =1"),
            ("\r=1", "' =1"),
            (" =1", "' =1"),
            ("\"=1", "'\"=1"),
            ("＝1", "'＝1"),
            ("-", "'-"),
            ("name;=1", "name;'=1"),
            ("-infinity", "'-infinity"),
        ];
        for (text, expected) in cured {
            assert_eq!(harmless(text), expected, "{text:?}");
            assert!(!cell(text).trim_matches('"').starts_with(FORMULA));
        }
        for same in ["-1.5", "+3", "-1e-9", "1 + 1", "a = b", "'=1", "", "load, -3 mm"] {
            assert_eq!(harmless(same), same);
        }
        assert_eq!(harmless_line("run: a,=1+1"), "run: a,'=1+1");
    }

    #[test]
    fn cells_are_divided_as_they_were() {
        assert_eq!(cell("a, \"b\""), "\"a, \"\"b\"\"\"");
        assert_eq!((cell("plain").as_str(), quoted_cell("plain").as_str()), ("plain", "\"plain\""));
        assert_eq!(unguarded(&cell("=1+1")), "=1+1");
        assert_eq!(unguarded("'tis"), "'tis");
    }
}
