//! The parts of a DXF file that describe geometry, checked pair by pair before anything is made of them.
//!
//! What is not understood and what cannot be read must both be said, so the file is taken apart here into its pairs of a
//! group code and a value. Only the header's unit, the blocks and the entities that become outlines go on, with only those
//! of their groups that are needed; the rest is counted. Group codes after Autodesk, DXF Reference (2018).

use crate::entity::Record;
use crate::finding::{Findings, Place};
use crate::shown::{Hidden, HiddenLayers};
use crate::units::Header;
use ::findings::visible::is_hidden;
use std::collections::{BTreeMap, BTreeSet};

/// No drawing of a bridge is longer [bytes].
const LONGEST: usize = 64 << 20;
/// Entities read in one go; more is no drawing of a bridge, but something else.
const MOST_ENTITIES: usize = 200_000;

/// Layers that entities lie on, likewise.
const MOST_LAYERS: usize = 5_000;

/// What describes geometry, and what the file says of itself.
#[derive(Debug, Default)]
pub(crate) struct Sieved {
    /// Blocks and entities, in the order of the file.
    pub(crate) records: Vec<Record>,
    /// What the header says of units.
    pub(crate) header: Header,
    /// Layers that are off or frozen.
    pub(crate) hidden_layers: HiddenLayers,
    /// Entities that do not become outlines: layer, kind, how many.
    pub(crate) left_out: BTreeMap<(String, String), usize>,
}

/// A group: code, value, number of the line that holds the value.
struct Group<'a> {
    code: i32,
    value: &'a str,
    line: usize,
}

/// The kinds of entities that are kept, each with its groups besides handle, layer and paper space.
const KEPT: [(&str, &[i32]); 13] = [
    ("POINT", &[10, 20, 30]),
    ("LINE", &[10, 20, 30, 11, 21, 31]),
    ("LWPOLYLINE", &[10, 20, 42, 38, 70, 210, 220, 230]),
    ("POLYLINE", &[10, 20, 30, 70, 210, 220, 230]),
    ("VERTEX", &[10, 20, 30, 42, 70]),
    ("SEQEND", &[]),
    ("ARC", &[10, 20, 30, 40, 50, 51, 210, 220, 230]),
    ("CIRCLE", &[10, 20, 30, 40, 210, 220, 230]),
    ("ELLIPSE", &[10, 20, 30, 11, 21, 31, 40, 41, 42, 210, 220, 230]),
    ("SPLINE", &[10, 20, 30, 40, 41, 70, 71, 11, 21, 31, 12, 22, 32, 13, 23, 33]),
    ("INSERT", &[2, 10, 20, 30, 41, 42, 43, 44, 45, 50, 70, 71, 210, 220, 230]),
    ("BLOCK", &[2, 10, 20, 30, 70]),
    ("ENDBLK", &[]),
];

/// Takes a file apart.
pub(crate) fn sieve(bytes: &[u8], findings: &mut Findings) -> Option<Sieved> {
    const SAVE: &str = "save the drawing as DXF with text (ASCII), version R2000 or later";
    let mut refuse = |code: &'static str, message: &str, help: &str| {
        findings.error(code, Place::default(), message, help);
        None
    };
    if bytes.len() > LONGEST {
        let message = format!("the file is {:.0} MB long", bytes.len() as f64 / 1e6);
        return refuse("D106", &message, "export only the outlines of the blocks");
    }
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return refuse("D101", "the file is empty", "export the drawing again");
    }
    if bytes.starts_with(b"AutoCAD Binary DXF") || bytes.starts_with(b"AutoCAD DXB") || bytes.starts_with(b"AC10") {
        return refuse("D101", "the file is binary: a binary DXF, a DXB or a DWG file", SAVE);
    }
    let text = decode(bytes);
    let groups = match groups(&text) {
        Ok(groups) => groups,
        Err(line) => {
            let message = format!("line {line} is not a group code: a DXF file is pairs of a number and a value");
            return refuse("D101", &message, SAVE);
        }
    };
    let sieved = sections(&groups, findings);
    if !groups.last().is_some_and(|g| g.code == 0 && g.value == "EOF") {
        let line = groups.last().map_or(0, |g| g.line);
        findings.error(
            "D101",
            Place::default(),
            format!("the file breaks off after line {line}"),
            "export the drawing again",
        );
    }
    Some(sieved)
}

/// Text of any encoding: UTF-8 where it is, else byte by byte, which keeps the names of layers apart.
fn decode(bytes: &[u8]) -> String {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    }
}

/// All pairs; the number of the first line that should be a group code and is none. What follows EOF is not read.
fn groups(text: &str) -> Result<Vec<Group<'_>>, usize> {
    let mut lines = text.lines().enumerate();
    let mut groups = Vec::new();
    while let Some((number, line)) = lines.next() {
        let word = line.trim();
        let Ok(code) = word.parse::<i32>() else {
            // Blank lines at the end are no harm.
            let rest_blank = word.is_empty() && lines.all(|(_, line)| line.trim().is_empty());
            return if rest_blank { Ok(groups) } else { Err(number + 1) };
        };
        let Some((below, value)) = lines.next() else { return Ok(groups) };
        let value = value.trim();
        groups.push(Group { code, value, line: below + 1 });
        if code == 0 && value == "EOF" {
            break;
        }
    }
    Ok(groups)
}

fn sections(groups: &[Group<'_>], findings: &mut Findings) -> Sieved {
    let mut out = Sieved::default();
    let (mut section, mut entities, mut in_polyline) = ("", 0, false);
    let mut layers: BTreeSet<&str> = BTreeSet::new();
    let mut at = 0;
    while at < groups.len() {
        let group = &groups[at];
        let end = groups[at + 1..].iter().position(|g| g.code == 0).map_or(groups.len(), |n| at + 1 + n);
        let body = &groups[at + 1..end];
        at = end;
        if group.code != 0 {
            continue;
        }
        match group.value {
            "SECTION" => {
                section = body.iter().find(|g| g.code == 2).map_or("", |g| g.value);
                if section == "HEADER" {
                    out.header = header(body);
                }
                continue;
            }
            "ENDSEC" => {
                section = "";
                continue;
            }
            "EOF" => break,
            "LAYER" if section == "TABLES" => {
                let number = |code| body.iter().find(|g| g.code == code).and_then(|g| g.value.parse().ok());
                let name = body.iter().find(|g| g.code == 2).map(|g| unescape(g.value)).unwrap_or_default();
                out.hidden_layers.add(&name, number(70).unwrap_or(0), number(62).unwrap_or(7));
                continue;
            }
            _ if section != "BLOCKS" && section != "ENTITIES" => continue,
            _ => {}
        }
        entities += 1;
        layers.extend(body.iter().find(|g| g.code == 8).map(|g| g.value));
        if entities > MOST_ENTITIES || layers.len() > MOST_LAYERS {
            let message = format!("there are more than {MOST_ENTITIES} entities or {MOST_LAYERS} layers");
            findings.error("D106", Place::default(), message, "export only the outlines of the blocks");
            break;
        }
        let kind = group.value;
        // Vertices are shown with their polyline; layer 0 of a block is that of its reference.
        let hidden = match kind {
            "VERTEX" | "SEQEND" | "BLOCK" | "ENDBLK" => None,
            _ => hidden(body, kind, section == "BLOCKS", &out.hidden_layers),
        };
        match kind {
            "POLYLINE" => in_polyline = true,
            "VERTEX" => {}
            // A sequence of attributes ends like a sequence of vertices.
            "SEQEND" if !in_polyline => continue,
            _ => in_polyline = false,
        }
        match KEPT.iter().find(|(known, _)| *known == kind) {
            Some(&(kind, codes)) => {
                // What is not shown need not be whole.
                let record = match hidden {
                    Some(_) => Some(Record { kind, layer: layer(body), ..Record::default() }),
                    None => entity(kind, codes, group.line, body, findings),
                };
                let in_blocks = section == "BLOCKS";
                out.records.extend(record.map(|record| Record { in_blocks, hidden, ..record }));
            }
            None if kind == "ATTRIB" || kind == "ATTDEF" || hidden.is_some() => {}
            None => *out.left_out.entry((layer(body), shorten(kind))).or_insert(0) += 1,
        }
    }
    out
}

/// What the header says of units.
fn header(header: &[Group<'_>]) -> Header {
    let number = |name: &str| {
        let at = header.iter().position(|g| g.code == 9 && g.value == name)?;
        header.get(at + 1).filter(|g| g.code == 70).and_then(|g| g.value.parse().ok())
    };
    Header { unit: number("$INSUNITS"), measurement: number("$MEASUREMENT"), format: number("$LUNITS") }
}

/// Why an entity is not shown, as far as it and its own layer tell.
fn hidden(body: &[Group<'_>], kind: &str, in_blocks: bool, layers: &HiddenLayers) -> Option<Hidden> {
    let is_set = |code| body.iter().any(|g| g.code == code && whole(g.value).is_some_and(|number| number != 0.0));
    let layer = layer(body);
    if is_set(67) {
        Some(Hidden::PaperSpace)
    } else if is_set(60) {
        Some(Hidden::Invisible)
    } else if in_blocks && layer == "0" {
        None
    } else {
        layers.hide(&layer, kind)
    }
}

fn layer(body: &[Group<'_>]) -> String {
    body.iter().find(|g| g.code == 8).map_or_else(|| "0".to_owned(), |g| unescape(g.value))
}

/// An entity's groups, or a finding that says which of its values cannot be read.
fn entity(
    kind: &'static str,
    codes: &[i32],
    line: usize,
    body: &[Group<'_>],
    findings: &mut Findings,
) -> Option<Record> {
    let handle = body.iter().find(|g| g.code == 5).map_or("", |g| g.value);
    let place = || Place { layer: layer(body), entity: format!("{kind} {}", shorten(handle)).trim().into(), at: None };
    let mut record = Record { kind, layer: "0".to_owned(), ..Record::default() };
    for group in body {
        let known = matches!(group.code, 5 | 8) || codes.contains(&group.code);
        if !known {
            continue;
        }
        match group.code {
            5 => match u64::from_str_radix(group.value, 16) {
                Ok(0) | Err(_) => {}
                Ok(handle) => record.handle = format!("{handle:X}"),
            },
            2 => record.name = unescape(group.value),
            8 => record.layer = Some(unescape(group.value)).filter(|name| !name.is_empty()).unwrap_or("0".to_owned()),
            60..=79 => match whole(group.value) {
                Some(number) => record.numbers.push((group.code, number)),
                None => return unreadable(place(), group, findings),
            },
            _ => match group.value.parse::<f64>() {
                Ok(number) if number.is_finite() => record.numbers.push((group.code, number)),
                _ => return unreadable(place(), group, findings),
            },
        }
    }
    let count = |code: i32| record.all(code).count();
    let (coordinates, fit) = ([10, 20].map(count), [11, 21].map(count));
    let needed = !matches!(kind, "SEQEND" | "ENDBLK" | "BLOCK" | "POLYLINE");
    let is_fitted = kind == "SPLINE" && fit[0] > 1 && fit[0] == fit[1];
    if coordinates[0] != coordinates[1] || (needed && coordinates[0] == 0 && !is_fitted) {
        let which = if kind == "SPLINE" && fit != [0, 0] { ", a spline by fit points," } else { "" };
        let message = format!("the entity that starts in line {line}{which} lacks coordinates");
        findings.error("D103", place(), message, "draw it again, or take it out");
        return None;
    }
    if kind == "SPLINE" && count(30) > coordinates[0] {
        findings.error("D103", place(), "a spline has more heights than points", "draw it again, or take it out");
        return None;
    }
    Some(record)
}

/// A whole number as DXF keeps it, in 16 bits; some programs write it with decimals.
fn whole(value: &str) -> Option<f64> {
    value.parse::<f64>().ok().filter(|number| number.is_finite()).map(|number| f64::from(number as i16))
}

fn unreadable(place: Place, group: &Group<'_>, findings: &mut Findings) -> Option<Record> {
    let message = format!("line {}: \"{}\" is no number (group code {})", group.line, shorten(group.value), group.code);
    findings.error("D103", place, message, "draw the entity again, or take it out");
    None
}

/// Characters that old versions write as \U+00C5.
fn unescape(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find("\\U+") {
        let code = rest.get(at + 3..at + 7).and_then(|hex| u32::from_str_radix(hex, 16).ok()).and_then(char::from_u32);
        let Some(character) = code else { break };
        out.push_str(&rest[..at]);
        out.push(character);
        rest = &rest[at + 7..];
    }
    out.push_str(rest);
    // A name stands on one line, and is written back on one.
    out.retain(|c| !is_hidden(c));
    out
}

/// A word of the file as it may be quoted.
fn shorten(text: &str) -> String {
    text.chars().filter(|c| !is_hidden(*c)).take(40).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_of_old_versions_become_letters() {
        assert_eq!(unescape("\\U+00C5NGSTR\\U+00D6M"), "ÅNGSTRÖM");
        assert_eq!(unescape("\\U+ZZ"), "\\U+ZZ");
        assert_eq!(unescape("\\U+"), "\\U+");
    }
}
