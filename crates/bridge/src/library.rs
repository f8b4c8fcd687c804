//! Materials of the library taken by name: `material = "sandstone"` in a table stands for every line of the library that the table does not
//! write itself. None of them is measured: whoever lists what a file says lists them with their source.

use crate::card::{Field, Kind, Need, Section};
use crate::cards::text;
use crate::findings::Findings;
use crate::material::{Material, MaterialValue, materials};
use crate::tree::{nearest, shorten, wrong_type};
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use toml_edit::{Item, TableLike};

/// The key by which a table names a material of the library.
pub(crate) const KEY: &str = "material";

/// Its card.
pub(crate) const fn material(example: &'static str) -> Field {
    let doc =
        "material of the library (`extrados materials`): its usual values stand for the keys that are not written here";
    text(KEY, doc, example).optional("every value is written")
}

/// Whether the materials of a table are those of the library: in a block model file they are its own.
pub(crate) fn named_in(section: &Section) -> bool {
    section.field(KEY).is_some_and(|field| field.doc == material("").doc)
}

/// Puts the values of named materials into the tables of a bridge file, each at the place of the name; reports names that there are none of.
pub(crate) fn fill(file: &Section, tree: &mut DeTable<'_>, findings: &mut Findings) {
    for field in file.fields {
        let (Kind::Table(section) | Kind::Tables(section)) = field.kind else { continue };
        let Some(value) = tree.get_mut(field.key).filter(|_| named_in(section)) else { continue };
        match value.get_mut() {
            DeValue::Table(one) => fill_one(section, one, findings),
            DeValue::Array(list) => {
                let tables = list.iter_mut().filter_map(|one| match one.get_mut() {
                    DeValue::Table(one) => Some(one),
                    _ => None,
                });
                tables.for_each(|one| fill_one(section, one, findings));
            }
            _ => {}
        }
    }
}

fn fill_one(section: &Section, table: &mut DeTable<'_>, findings: &mut Findings) {
    let (Some(field), Some(named)) = (section.field(KEY), table.get(KEY)) else { return };
    let range = named.span();
    let DeValue::String(name) = named.get_ref() else {
        wrong_type::<()>(field, named, findings);
        return;
    };
    let listed = materials();
    let Some(material) = find(&listed, section, name) else {
        let message = format!("the library has no material \"{}\" for [{}]", shorten(name), section.path);
        findings.error("B013", range.into(), message, field.doc, known(&listed, section, name));
        return;
    };
    let written = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str()).map(str::to_owned);
    let wanted =
        |value: &&MaterialValue| means(section, &value.key, written) && !table.contains_key(value.key.as_str());
    let values: Vec<&MaterialValue> = material.values.iter().filter(wanted).collect();
    for value in values {
        let usual = DeValue::String(value.usual.clone().into());
        table.insert(Spanned::new(range.clone(), value.key.clone().into()), Spanned::new(range.clone(), usual));
    }
}

/// Every value that a table takes from the library, with the remark that would stand beside it.
pub(crate) fn taken(section: &Section, table: &dyn TableLike) -> Vec<(String, String, String)> {
    let Some(name) = table.get(KEY).and_then(Item::as_str).filter(|_| named_in(section)) else { return Vec::new() };
    let listed = materials();
    let Some(material) = find(&listed, section, name) else { return Vec::new() };
    let written = |key: &str| table.get(key).and_then(Item::as_str).map(str::to_owned);
    let wanted = |value: &&MaterialValue| means(section, &value.key, written) && table.get(&value.key).is_none();
    let of = |value: &MaterialValue| (value.key.clone(), value.usual.clone(), value.remark(material));
    material.values.iter().filter(wanted).map(of).collect()
}

/// What a file of some kind takes from the library, each as "masonry.density 2250 kg/m^3 (sandstone)".
pub(crate) fn from_library(kind: &Section, file: &DeTable<'_>) -> Vec<String> {
    let mut found = Vec::new();
    for (key, value) in file.iter().filter(|(key, _)| kind.field(key.get_ref()).is_some()) {
        let tables: Vec<&DeTable<'_>> = match value.get_ref() {
            DeValue::Table(one) => vec![one],
            DeValue::Array(list) => list.iter().filter_map(|one| one.get_ref().as_table()).collect(),
            _ => Vec::new(),
        };
        for (k, table) in tables.iter().enumerate() {
            let Some((name, place)) = table.get(KEY).map(|named| (named.get_ref(), named.span())) else { continue };
            let number = if tables.len() > 1 { format!("[{}]", k + 1) } else { String::new() };
            // What was taken stands where its name stands.
            for (inner, value) in table.iter().filter(|(inner, value)| value.span() == place && inner.get_ref() != KEY)
            {
                if let (DeValue::String(value), DeValue::String(name)) = (value.get_ref(), name) {
                    found.push(format!(
                        "{}{number}.{} {value} ({})",
                        key.get_ref(),
                        inner.get_ref(),
                        name.to_lowercase()
                    ));
                }
            }
        }
    }
    found
}

/// Whether a table names a material that the library does not have, which is reported where the table is filled.
pub(crate) fn unknown(section: &Section, table: &DeTable<'_>) -> bool {
    match table.get(KEY).map(Spanned::get_ref) {
        Some(DeValue::String(name)) => named_in(section) && find(&materials(), section, name).is_none(),
        _ => false,
    }
}

/// Whether a material of the library gives a key of a table.
pub(crate) fn may_give(section: &Section, key: &str) -> bool {
    named_in(section)
        && materials().iter().any(|one| one.fills(section.path) && one.values.iter().any(|value| value.key == key))
}

fn find<'m>(listed: &'m [Material], section: &Section, name: &str) -> Option<&'m Material> {
    listed.iter().find(|one| one.fills(section.path) && one.code.eq_ignore_ascii_case(name.trim()))
}

/// Whether a key means something in a table, going by the word that decides about it.
fn means(section: &Section, key: &str, written: impl Fn(&str) -> Option<String>) -> bool {
    let Some(field) = section.field(key) else { return false };
    let Some((selector, words)) = field.only else { return true };
    let default = section.field(selector).and_then(|field| match field.need {
        Need::Default(word) => Some(word.to_owned()),
        _ => None,
    });
    written(selector).or(default).is_some_and(|word| words.contains(&word.as_str()))
}

/// What may be written in place of a name that there is none of.
fn known(listed: &[Material], section: &Section, name: &str) -> String {
    let codes = || listed.iter().filter(|one| one.fills(section.path)).map(|one| one.code.as_str());
    let all = codes().map(|code| format!("\"{code}\"")).collect::<Vec<_>>().join(", ");
    match nearest(name, codes()) {
        Some(near) => format!("did you mean \"{near}\"? Possible are {all}"),
        None => format!("write one of {all}; `extrados materials {}` lists their values", section.path),
    }
}
