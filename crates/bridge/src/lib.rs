//! What an engineer wrote about a bridge: read, checked, named.
//!
//! Reading never fails and never computes: it returns what it understood together with everything that is wrong.

pub mod blocks;
pub mod diagnostic;
pub mod explain;
pub mod fields;
mod findings;
pub mod model;
mod plausible;
pub mod quantity;
pub mod reference;
mod resolve;
pub mod ring;
pub mod schema;
pub mod text;
mod tree;
mod values;

pub use diagnostic::{Diagnostic, Severity, TextRange};
pub use model::*;
pub use text::Position;

use findings::Findings;
use toml::de::DeTable;

/// What reading gives: the bridge if it can be used, and all findings.
#[derive(Debug, Clone)]
pub struct Read {
    /// The bridge, unless a finding is an error.
    pub bridge: Option<Bridge>,
    /// Every finding, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// No bridge file is longer [bytes]; what is, is something else.
const LONGEST: usize = 1 << 20;

/// Broken lines reported in one go; a file with more is no bridge file.
const MOST_SYNTAX_ERRORS: usize = 20;

/// Reads a bridge file from its bytes (TOML, UTF-8).
pub fn read(text: &[u8]) -> Read {
    let mut findings = Findings::of(text);
    let bridge = read_text(text, &fields::FILE, resolve::resolve, &mut findings);
    let bridge = if findings.any_error() { None } else { bridge };
    Read { bridge, diagnostics: findings.in_order(text.len()) }
}

/// What reading a block model file gives.
#[derive(Debug, Clone)]
pub struct ReadBlocks {
    /// The model's description, unless a finding is an error.
    pub file: Option<blocks::BlockFile>,
    /// Every finding, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a block model file from its bytes (TOML, UTF-8). The drawing that it names is not looked at.
pub fn read_blocks(text: &[u8]) -> ReadBlocks {
    let mut findings = Findings::of(text);
    let file = read_text(text, &fields::blocks::FILE, resolve::blocks::resolve, &mut findings);
    let file = if findings.any_error() { None } else { file };
    ReadBlocks { file, diagnostics: findings.in_order(text.len()) }
}

/// Whether a text is a block model file rather than a bridge file, by the sections it opens.
pub fn is_block_file(text: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(text) else { return false };
    if text.len() > LONGEST {
        return false;
    }
    let (tree, _) = DeTable::parse_recoverable(text);
    let has = |key: &str| tree.get_ref().get(key).is_some();
    !has("bridge") && !has("span") && ["model", "drawing", "block", "material"].into_iter().any(has)
}

fn read_text<T>(
    bytes: &[u8],
    kind: &'static fields::Section,
    resolve: fn(&tree::Table<'_>, &mut Findings) -> Option<T>,
    findings: &mut Findings,
) -> Option<T> {
    if bytes.len() > LONGEST {
        findings.error(
            "B003",
            TextRange::new(0, 0),
            format!("the file is {:.1} MB long", bytes.len() as f64 / 1e6),
            "a bridge file has a few kilobytes",
            "check that this is the bridge file",
        );
        return None;
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => {
            let start = error.valid_up_to();
            let end = start + error.error_len().unwrap_or(bytes.len() - start);
            findings.error(
                "B001",
                TextRange::new(start, end),
                "the file is not UTF-8 text",
                "this byte belongs to another encoding",
                "save the file as UTF-8; every editor can",
            );
            return None;
        }
    };
    let (tree, broken) = DeTable::parse_recoverable(text);
    for error in broken.iter().take(MOST_SYNTAX_ERRORS) {
        let range = error.span().map_or(TextRange::new(0, 0), TextRange::from);
        let help = syntax_help(error.message(), text.get(range.start..range.end).unwrap_or_default());
        findings.error("B002", range, error.message().to_owned(), "cannot be read as TOML", help);
    }
    let file = tree::Table::open(kind, tree.get_ref(), TextRange::new(0, 0), findings);
    let value = resolve(&file, findings);
    if !broken.is_empty() {
        // What could not be read may be what seems to be missing, and what is left of its line means nothing.
        let lines: Vec<usize> = broken.iter().filter_map(|e| Some(findings.line(e.span()?.into()))).collect();
        findings.retain(|finding, line| {
            let of_a_value = finding.code.starts_with("B1") || finding.code == "B010";
            finding.code == "B002" || (of_a_value && !lines.contains(&line))
        });
    }
    value
}

/// What to write instead of a line that is not TOML.
fn syntax_help(message: &str, found: &str) -> String {
    let found = tree::shorten(found.trim());
    match message {
        _ if message.contains("must be quoted") => format!("put it in quotes: \"{found}\""),
        _ if message.contains("duplicate key") => {
            "keep one of the two; sections that repeat are written [[section]]".into()
        }
        _ if message.contains("string") => "close the quotes at the end of the same line: key = \"value\"".into(),
        _ => "write lines like key = \"value\" below [section] headers; text and quantities stand in quotes".into(),
    }
}
