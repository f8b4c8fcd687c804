//! Which quantities a file has: those that are written, and those that have a default.

use toml_edit::{Item, TableLike};

use super::Slip;
use crate::card::{Field, Kind, Need, Section};
use crate::edit::{Document, count, entry, literal};
use crate::fields::FILE;
use crate::library;
use crate::path::{Path, Step};
use crate::tree::{nearest, shorten};

/// A quantity that a request leads to.
#[derive(Debug, Clone)]
pub struct Variable {
    /// Its path, with a number wherever there is a list.
    pub path: Path,
    /// Its card.
    pub field: &'static Field,
    /// Its own value as TOML has it: as written, or its default; none where the file says nothing.
    pub own: Option<String>,
}

/// A quantity that a file has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Known {
    /// Its path.
    pub path: String,
    /// Its value as TOML has it.
    pub value: String,
    /// Whether the value is a default, or that of a material that is named, and the file does not write it.
    pub by_default: bool,
    /// What it is, in a line.
    pub doc: &'static str,
}

/// Sections that say how to vary, seek, sweep or judge, and are not varied themselves.
const NOT_VARIED: [&str; 12] = [
    "vary",
    "case",
    "document",
    "records",
    "channel",
    "parameter",
    "update",
    "sweep",
    "assess",
    "service_load",
    "mexe",
    "expected",
];

/// Paths shown at most in a message.
const MOST_SHOWN: usize = 12;

/// Every quantity of a file that has a value, in the order of the reference.
pub fn known(document: &Document) -> Vec<Known> {
    let mut found = Vec::new();
    visit(&FILE, Some(document.root()), "", &mut found);
    found
}

fn visit(section: &'static Section, table: Option<&dyn TableLike>, prefix: &str, found: &mut Vec<Known>) {
    for field in section.fields.iter().filter(|field| !NOT_VARIED.contains(&field.key) || !section.path.is_empty()) {
        let path = format!("{prefix}{}", field.key);
        let item = table.and_then(|table| table.get(field.key));
        match field.kind {
            // A default in a table that is not there would open it, and it may need more than defaults.
            Kind::Table(inner) if item.is_none() && inner.fields.iter().any(|f| f.need == Need::Required) => {}
            Kind::Table(inner) => visit(inner, item.and_then(|item| entry(item, None)), &format!("{path}."), found),
            Kind::Tables(inner) => {
                for number in 1..=item.map_or(0, count) {
                    let one = item.and_then(|item| entry(item, Some(number)));
                    visit(inner, one, &format!("{path}[{number}]."), found);
                }
            }
            Kind::Text | Kind::Readings => {}
            _ => match (item.and_then(Item::as_value), field.need) {
                (Some(value), _) => {
                    found.push(Known { path, value: literal(value), by_default: false, doc: field.doc });
                }
                (None, _) if let Some(value) = by_name(section, field, table) => {
                    found.push(Known { path, value, by_default: true, doc: field.doc });
                }
                (None, Need::Default(value)) if applies(section, field, table) => {
                    let value = field.literal(value);
                    found.push(Known { path, value, by_default: true, doc: field.doc });
                }
                _ => {}
            },
        }
    }
}

/// The value of a key that is not written, as TOML has it, by the name of a material of the library in its table.
fn by_name(section: &Section, field: &Field, table: Option<&dyn TableLike>) -> Option<String> {
    let (_, value, _) = library::taken(section, table?).into_iter().find(|(key, ..)| key == field.key)?;
    Some(field.literal(&value))
}

/// Whether a key that is not written means something here, going by the word that decides about it.
fn applies(section: &Section, field: &Field, table: Option<&dyn TableLike>) -> bool {
    let Some((key, words)) = field.only else { return true };
    let written = table.and_then(|table| table.get(key)).and_then(Item::as_str);
    let default = section.field(key).and_then(|selector| match selector.need {
        Need::Default(word) => Some(word),
        _ => None,
    });
    written.or(default).is_some_and(|word| words.contains(&word))
}

/// The quantity at a path of a file, which need not be written there if it has a card.
///
/// # Errors
/// A path that leads to nothing (B501), or to something that is no quantity (B502).
pub fn find(document: &Document, text: &str) -> Result<Variable, Slip> {
    let path = Path::parse(text).ok_or_else(|| unknown(document, text, &FILE))?;
    let mut section: &'static Section = &FILE;
    let mut table = Some(document.root());
    let mut whole = Path { steps: Vec::new() };
    for (depth, step) in path.steps.iter().enumerate() {
        let field = section.field(&step.key).filter(|field| depth > 0 || !NOT_VARIED.contains(&field.key));
        let field = field.ok_or_else(|| unknown(document, text, section))?;
        let last = depth + 1 == path.steps.len();
        let item = table.and_then(|table| table.get(&step.key));
        let inner = match field.kind {
            Kind::Table(inner) | Kind::Tables(inner) => inner,
            Kind::Text | Kind::Readings if last => return Err(no_quantity(document, text)),
            _ if last => {
                let default = by_name(section, field, table);
                return quantity(document, whole, step, (field, default), item, text);
            }
            _ => return Err(unknown(document, text, section)),
        };
        if last {
            return Err(no_quantity(document, text));
        }
        let several = matches!(field.kind, Kind::Tables(_));
        table = match item {
            None if several => return Err(no_such(text, step, 0)),
            None => None,
            Some(item) => Some(entry(item, step.index).ok_or_else(|| no_such(text, step, count(item)))?),
        };
        let index = if several { step.index.or(Some(1)) } else { None };
        whole.steps.push(Step { key: step.key.clone(), index });
        section = inner;
    }
    Err(unknown(document, text, &FILE))
}

/// The quantity of the last step, or the entry of a list of quantities.
fn quantity(
    document: &Document,
    mut path: Path,
    step: &Step,
    (field, by_name): (&'static Field, Option<String>),
    item: Option<&Item>,
    text: &str,
) -> Result<Variable, Slip> {
    if let Some(index) = step.index {
        let entries = item.and_then(Item::as_array).map_or(0, toml_edit::Array::len);
        let listed = matches!(field.kind, Kind::Quantities(_));
        if !listed || index > entries {
            return Err(no_such(text, step, entries));
        }
    }
    path.steps.push(step.clone());
    let default = match field.need {
        Need::Default(value) => Some(field.literal(value)),
        _ => None,
    };
    Ok(Variable { own: document.get(&path).or(by_name).or(default), path, field })
}

fn no_such(text: &str, step: &Step, there: usize) -> Slip {
    let (message, label, help) = match (step.index, there) {
        (_, 0) => (
            format!("`{}` leads to a {} that the file does not have", shorten(text), step.key),
            format!("the file has no {} with a number", step.key),
            format!("add it to the file, or leave the number of `{}` away if there is only one", step.key),
        ),
        (Some(index), 1) => (
            format!("`{}` leads to number {index} of one", shorten(text)),
            format!("the file has one of `{}`", step.key),
            format!("write {}[1], or leave the number away", step.key),
        ),
        (Some(index), _) => (
            format!("`{}` leads to number {index} of {there}", shorten(text)),
            format!("the file has {there} of `{}`, counted from 1", step.key),
            format!("write a number from 1 to {there}: {}[{there}]", step.key),
        ),
        (None, _) => (
            format!("`{}` does not say which `{}` is meant", shorten(text), step.key),
            format!("the file has {there} of them"),
            format!("write a number from 1 to {there}: {}[1]", step.key),
        ),
    };
    Slip::of_path("B502", message, label, help)
}

fn no_quantity(document: &Document, text: &str) -> Slip {
    let message = format!("`{}` is no quantity", shorten(text));
    Slip::of_path("B501", message, "a section or a name; only its quantities can be varied", held(document, text))
}

/// A path that leads nowhere: what was probably meant, and what the file holds thereabouts.
fn unknown(document: &Document, text: &str, section: &'static Section) -> Slip {
    let all = known(document);
    let near = nearest(text, all.iter().map(|known| known.path.as_str())).map(str::to_owned);
    // The same key in another section is a likelier slip than any spelling; then the nearest one.
    let key = |path: &'_ str| path.rsplit('.').next().unwrap_or_default().to_owned();
    let elsewhere = || {
        let keys: Vec<String> = all.iter().map(|known| key(&known.path)).collect();
        let place = nearest(&key(text), keys.iter().map(String::as_str))?;
        all.iter().find(|known| key(&known.path) == place).map(|known| known.path.clone())
    };
    let label = match near.or_else(elsewhere) {
        Some(near) => format!("did you mean `{near}`?"),
        None if section.path.is_empty() => "the file has nothing of this name".to_owned(),
        None => format!("[{}] has no such key", section.path),
    };
    Slip::of_path("B501", format!("there is no quantity `{}`", shorten(text)), label, held(document, text))
}

/// What the file holds in the section that a path begins with; its sections where it begins with none.
fn held(document: &Document, text: &str) -> String {
    let all = known(document);
    let head = |path: &str| path.split(['.', '[']).next().unwrap_or_default().to_owned();
    let first = head(text);
    let mut heads: Vec<String> = all.iter().map(|known| head(&known.path)).collect();
    heads.dedup();
    let here: Vec<&Known> = all.iter().filter(|known| head(&known.path) == first).collect();
    if here.is_empty() {
        return format!(
            "the file holds quantities in {}; `extrados vary FILE --list` shows them all",
            heads.join(", ")
        );
    }
    let mut shown: Vec<String> =
        here.iter().take(MOST_SHOWN).map(|known| format!("{} = {}", known.path, shorten(&known.value))).collect();
    if here.len() > MOST_SHOWN {
        shown.push("…".to_owned());
    }
    format!("the file has {}", shown.join(", "))
}
