//! From bytes to the tables of a file: what is no text, no TOML or no file of ours is said.

use crate::card::Section;
use crate::diagnostic::{Diagnostic, TextRange};
use crate::findings::Findings;
use crate::library;
use crate::tree::{Table, shorten};
use toml::de::DeTable;

/// No bridge file is longer [bytes]; what is, is something else.
pub(crate) const LONGEST: usize = 1 << 20;

/// Broken lines reported in one go; a file with more is no bridge file.
const MOST_SYNTAX_ERRORS: usize = 20;

/// What a file of this kind means; nothing where the text is none of ours.
pub(crate) fn read_text<T>(
    bytes: &[u8],
    kind: &'static Section,
    resolve: impl Fn(&str, &Table<'_>, &mut Findings) -> T,
    findings: &mut Findings,
) -> Option<T> {
    let text = readable(bytes, findings)?;
    let (mut tree, broken) = DeTable::parse_recoverable(text);
    not_toml(text, &broken, findings);
    library::fill(kind, tree.get_mut(), findings);
    let file = Table::file(kind, tree.get_ref(), findings);
    let value = resolve(text, &file, findings);
    if !broken.is_empty() {
        // What could not be read may be what seems to be missing, and what is left of its line means nothing.
        let lines: Vec<usize> = broken.iter().filter_map(|e| Some(findings.line(e.span()?.into()))).collect();
        findings.retain(|finding, line| {
            let of_a_value = finding.code.starts_with("B1") || finding.code == "B010";
            finding.code == "B002" || (of_a_value && !lines.contains(&line))
        });
    }
    Some(value)
}

/// What a file of this kind means, unless a finding is an error; every finding, in the order of the file.
pub(crate) fn read_sound<T>(
    bytes: &[u8],
    kind: &'static Section,
    resolve: impl Fn(&Table<'_>, &mut Findings) -> Option<T>,
) -> (Option<T>, Vec<Diagnostic>) {
    let mut findings = Findings::of(bytes);
    let found = read_text(bytes, kind, |_, table, findings| resolve(table, findings), &mut findings);
    (found.flatten().filter(|_| !findings.any_error()), findings.in_order(bytes.len()))
}

/// What a file is that is none of ours, with its code and what to do with it.
fn other_kind(bytes: &[u8]) -> Option<(&'static str, &'static str, &'static str)> {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(400)]).replace('\r', "");
    let mut lines = start.lines().map(str::trim).skip_while(|line| line.is_empty() || *line == "999");
    let dxf = start.starts_with("AutoCAD Binary DXF") || (lines.next() == Some("0") && lines.next() == Some("SECTION"));
    if dxf {
        let help = "name the drawing in a block model file, [drawing] file = \"….dxf\", and give that one to the command; `extrados new arch --from drawing` \
                    writes an example";
        return Some(("B217", "the file is a drawing (DXF) and no bridge file", help));
    }
    if start.starts_with("PK\u{3}\u{4}") || bytes.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]) {
        let help =
            "a bridge file is plain text; `extrados new` writes one to edit. Records and tables are read as .csv";
        return Some(("B218", "the file is a workbook or an archive (XLSX, XLS, ZIP) and no bridge file", help));
    }
    None
}

/// The bytes as text.
pub(crate) fn readable<'t>(bytes: &'t [u8], findings: &mut Findings) -> Option<&'t str> {
    if let Some((code, message, help)) = other_kind(bytes) {
        return findings.refuse(code, TextRange::new(0, 0), message, "a bridge file is text (TOML)", help);
    }
    if bytes.len() > LONGEST {
        return findings.refuse(
            "B003",
            TextRange::new(0, 0),
            format!("the file is longer than {} MiB", LONGEST >> 20),
            "a bridge file has a few kilobytes",
            "check that this is the bridge file",
        );
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Some(text),
        Err(error) => {
            let start = error.valid_up_to();
            let end = start + error.error_len().unwrap_or(bytes.len() - start);
            findings.refuse(
                "B001",
                TextRange::new(start, end),
                "the file is not UTF-8 text",
                "this byte belongs to another encoding",
                "save the file as UTF-8; every editor can",
            )
        }
    }
}

/// Reports lines that are not TOML.
pub(crate) fn not_toml(text: &str, broken: &[toml::de::Error], findings: &mut Findings) {
    for error in broken.iter().take(MOST_SYNTAX_ERRORS) {
        let range = error.span().map_or(TextRange::new(0, 0), TextRange::from);
        let found = text.get(range.start..range.end).unwrap_or_default();
        let line = text.get(..range.start).map_or("", |before| {
            let from = before.rfind('\n').map_or(0, |newline| newline + 1);
            text[from..].lines().next().unwrap_or_default()
        });
        let help = if line.contains(CURLY) {
            let straight = line.replace(['“', '”', '„', '″'], "\"").replace(['‘', '’'], "'");
            format!("a word processor wrote curly quotes; write straight ones: {}", shorten(straight.trim()))
        } else {
            syntax_help(error.message(), found)
        };
        findings.error("B002", range, error.message().to_owned(), "cannot be read as TOML", help);
    }
}

/// Quotes as word processors write them.
const CURLY: [char; 6] = ['“', '”', '„', '‘', '’', '″'];

/// What to write instead of a line that is not TOML.
fn syntax_help(message: &str, found: &str) -> String {
    let found = shorten(found.trim());
    match message {
        _ if message.contains("must be quoted") => format!("put it in quotes: \"{found}\""),
        _ if message.contains("duplicate key") => {
            "keep one of the two; sections that repeat are written [[section]]".into()
        }
        _ if message.contains("string") => "close the quotes at the end of the same line: key = \"value\"".into(),
        _ => "write lines like key = \"value\" below [section] headers; text and quantities stand in quotes".into(),
    }
}
