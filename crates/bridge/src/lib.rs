//! What an engineer wrote about a bridge: read, checked, named.
//!
//! Reading never fails and never computes: it returns what it understood together with everything that is wrong.

mod asked;
pub mod assess;
pub mod blocks;
mod calibration;
mod card;
mod cards;
pub mod case;
pub mod choice;
mod companions;
pub mod defect;
pub mod diagnostic;
pub mod document;
pub mod edit;
pub mod explain;
pub mod fields;
mod findings;
pub mod inputs;
mod library;
pub mod load_test;
pub mod material;
pub mod mixed_units;
mod model;
pub mod passage;
pub mod path;
mod plain;
mod plausible;
pub mod quantity;
mod resolve;
pub mod ring;
pub mod road;
pub mod schema;
mod sensor;
pub mod service;
pub mod survey;
pub mod text;
mod trade;
pub mod train;
mod tree;
pub mod update;
mod usual;
mod values;
pub mod vary;
pub mod whereabouts;

pub use ::findings::Severity;
pub use diagnostic::{Diagnostic, TextRange};
pub use fields::sweep::DOUBTFUL_SKEW;
pub use model::*;
pub use service::*;
pub use text::Position;
pub use update::UPDATE_SECTIONS;

use findings::Findings;
use plain::{LONGEST, not_toml, read_sound, read_text, readable};
use toml::de::DeTable;

/// What reading gives: the bridge if it can be used, and all findings.
#[derive(Debug, Clone, Default)]
pub struct Read {
    /// The bridge, unless a finding is an error.
    pub bridge: Option<Bridge>,
    /// What the file asks to vary, as far as that can be read.
    pub vary: Vec<vary::Request>,
    /// Its named cases.
    pub cases: Vec<case::Case>,
    /// What identifies the assessment and who signs for it; none where the file does not say.
    pub document: Option<document::ReportDocument>,
    /// What the file says of model updating; none where it says nothing, or nothing that can be used.
    pub update: Option<update::Update>,
    /// The assessment that the file asks for; none where something is wrong with the file.
    pub assess: Option<assess::Assess>,
    /// Every finding, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// The bytes of a text file as UTF-8: UTF-16, which some editors call Unicode, is converted; anything else stays as it is.
pub fn as_utf8(bytes: Vec<u8>) -> Vec<u8> {
    let (first, little) = match bytes.get(..2) {
        Some([0xff, 0xfe]) => (2, true),
        Some([0xfe, 0xff]) => (2, false),
        // Without a mark: every other byte of plain text is zero.
        Some([a, 0]) if *a != 0 && bytes.len() > 3 && bytes[3] == 0 => (0, true),
        Some([0, b]) if *b != 0 && bytes.len() > 3 && bytes[2] == 0 => (0, false),
        _ => return bytes,
    };
    let unit = |pair: &[u8]| {
        let pair = [pair[0], pair[1]];
        if little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) }
    };
    let units: Vec<u16> = bytes[first..].chunks_exact(2).map(unit).collect();
    String::from_utf16(&units).map_or(bytes, String::into_bytes)
}

/// Reads a bridge file from its bytes (TOML, UTF-8).
pub fn read(text: &[u8]) -> Read {
    let mut findings = Findings::of(text);
    let mut found = match is_block_file(text) {
        false => read_text(text, &fields::FILE, resolve_bridge, &mut findings).unwrap_or_default(),
        true => {
            findings.error(
                "B243",
                TextRange::new(0, 0),
                "the file lists blocks, or a drawing of them, and describes no bridge",
                "vehicles, trains, records and verdicts need spans, rings and cover",
                "`check`, `collapse` and `convert` read block model files; for the rest describe the bridge with [bridge] and [[span]] (`extrados new`)",
            );
            Read::default()
        }
    };
    if found.bridge.is_none() || findings.any_error() {
        found = Read { vary: found.vary, document: found.document, ..Read::default() };
    }
    Read { diagnostics: findings.in_order(text.len()), ..found }
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
    let (file, diagnostics) = read_sound(text, &fields::blocks::FILE, fields::blocks::resolve);
    ReadBlocks { file, diagnostics }
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

/// Reads a file of [[vary]] tables about the quantities of a bridge file.
pub fn read_ranges(text: &[u8], bridge: &edit::Document) -> (Vec<vary::Request>, Vec<Diagnostic>) {
    let mut findings = Findings::of(text);
    let requests = readable(text, &mut findings).map(|words| {
        let (tree, broken) = DeTable::parse_recoverable(words);
        not_toml(words, &broken, &mut findings);
        let file = tree::Table::file(&fields::RANGES, tree.get_ref(), &mut findings);
        let requests = asked::vary::vary(&file, &mut findings);
        asked::vary::check(bridge, &requests, &mut findings);
        requests
    });
    (requests.unwrap_or_default(), findings.in_order(text.len()))
}

/// The errors of a bridge file, in a line each.
fn errors(text: &str) -> Vec<String> {
    let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
    let all = read(text.as_bytes()).diagnostics.into_iter().filter(is_error);
    all.map(|finding| format!("{} ({})", finding.message, finding.code)).collect()
}

/// The bridge, what is varied, and what is sought.
fn resolve_bridge(text: &str, file: &tree::Table<'_>, findings: &mut Findings) -> Read {
    let bridge = resolve::resolve(file, findings);
    let vary = asked::vary::vary(file, findings);
    if !vary.is_empty()
        && let Some(document) = edit::Document::parse(text)
    {
        asked::vary::check(&document, &vary, findings);
    }
    let update = asked::update::update(text, file, bridge.as_ref(), findings);
    let assess = assess::assess(file, bridge.as_ref().map(|bridge| bridge.spans.len()), findings);
    let cases = asked::case::cases(text, file, bridge.as_ref().map(|bridge| &bridge.loads[..]), errors, findings);
    let document = document::document(file, findings);
    Read { bridge, vary, cases, document, update, assess, diagnostics: Vec::new() }
}
