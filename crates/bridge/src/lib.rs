//! What an engineer wrote about a bridge: read, checked, named.
//!
//! Reading never fails and never computes: it returns what it understood together with everything that is wrong.

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
    let bridge = read_text(text, &mut findings);
    let bridge = if findings.any_error() { None } else { bridge };
    Read { bridge, diagnostics: findings.in_order(text.len()) }
}

fn read_text(bytes: &[u8], findings: &mut Findings) -> Option<Bridge> {
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
        let unquoted = text.get(range.start..range.end).filter(|_| error.message().contains("must be quoted"));
        let help = match unquoted {
            Some(value) => format!("put it in quotes: \"{}\"", tree::shorten(value.trim())),
            None => {
                "write lines like key = \"value\" below [section] headers; text and quantities stand in quotes".into()
            }
        };
        findings.error("B002", range, error.message().to_owned(), "cannot be read as TOML", help);
    }
    let file = tree::Table::open(&fields::FILE, tree.get_ref(), TextRange::new(0, 0), findings);
    let bridge = resolve::resolve(&file, findings);
    if !broken.is_empty() {
        // What could not be read may be what seems to be missing.
        findings.retain(|finding| finding.code == "B002" || finding.code.starts_with("B1") || finding.code == "B010");
    }
    bridge
}
