//! Lengths in feet beside lengths in metres: one of them may be a slip of the unit, which no range of usual values can see.

use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::quantity::{self, Dimension};
use crate::tree::Table;
use toml::de::{DeTable, DeValue};

/// A length as it is written: the key, whether its unit is a foot, an inch or a yard, whether it may be a slip, and where it stands.
struct Written {
    key: String,
    imperial: bool,
    slips: bool,
    range: TextRange,
}

/// Units of which one is written for another without a look: a bridge in metres may have been measured in feet. An inch is 25 mm, and a ring of 18 of
/// them would be seen as one of 18 mm or 18 m.
const SLIPS: [&str; 3] = ["m", "ft", "yd"];

/// Doubts the lengths of whichever system has fewer.
pub(crate) fn check(file: &Table<'_>, findings: &mut Findings) {
    let mut lengths = Vec::new();
    file.written().into_iter().for_each(|table| gather(table, &mut lengths));
    let imperial = lengths.iter().filter(|one| one.imperial).count();
    if imperial == 0 || imperial == lengths.len() {
        return;
    }
    let fewer = 2 * imperial <= lengths.len();
    // Feet beside millimetres alone are no slip of metres.
    if fewer && lengths.iter().all(|one| one.imperial || !one.slips) {
        return;
    }
    let (own, other) = if fewer { ("feet", "metres") } else { ("metres", "feet or inches") };
    for one in lengths.iter().filter(|one| one.imperial == fewer && one.slips) {
        findings.warning(
            "P033",
            one.range,
            format!("`{}` is in {own}, where other lengths are in {other}", one.key),
            "a foot written for a metre is another bridge",
            format!("write it in {other} if the number is meant so; otherwise convert it, so that one system is left"),
        );
    }
}

fn gather(table: &DeTable<'_>, lengths: &mut Vec<Written>) {
    for (key, raw) in table.iter() {
        value(key.get_ref(), raw.get_ref(), raw.span().into(), lengths);
    }
}

fn value(key: &str, found: &DeValue<'_>, range: TextRange, lengths: &mut Vec<Written>) {
    match found {
        DeValue::String(text) => {
            let length = quantity::parse(text).ok().filter(|one| one.unit.dimension == Dimension::Length);
            lengths.extend(length.map(|one| Written {
                key: key.to_owned(),
                imperial: one.unit.imperial(),
                slips: SLIPS.contains(&one.unit.symbol),
                range,
            }));
        }
        DeValue::Array(items) => {
            items.iter().for_each(|item| value(key, item.get_ref(), item.span().into(), lengths));
        }
        DeValue::Table(inner) => gather(inner, lengths),
        _ => {}
    }
}
