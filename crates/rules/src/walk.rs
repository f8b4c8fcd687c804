//! A file held against its shape: every mistake at once, each with its key and line.

use crate::Problem;
use crate::shape::{Key, Kind, Shape};
use findings::visible::is_hidden;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Most mistakes that are reported of one file.
const MOST: usize = 100;
/// Longest text [characters], and longest list.
const LONGEST: usize = 2000;
const MOST_ENTRIES: usize = 1000;

/// Everything in which a text differs from a shape, in the order of its lines; what is missing comes where its table begins.
pub(crate) fn differences(file: &str, text: &str, shape: &'static Shape) -> Vec<Problem> {
    let (tree, broken) = DeTable::parse_recoverable(text);
    let mut walk = Walk { file, text, problems: Vec::new() };
    for error in &broken {
        let at = error.span().unwrap_or(0..0);
        walk.say(&at, "", error.message().to_owned());
    }
    if broken.is_empty() {
        walk.table(shape, tree.get_ref(), &(0..0), "");
    }
    let mut problems = walk.problems;
    // What the file as a whole lacks has no line and comes last.
    problems.sort_by_key(|problem| if problem.line == 0 { usize::MAX } else { problem.line });
    problems.truncate(MOST);
    problems
}

/// The line of a key, as "vehicle[0].spacings_m", from 1; 0 where it is not found.
pub(crate) fn line_of(text: &str, path: &str) -> usize {
    let (tree, _) = DeTable::parse_recoverable(text);
    let mut table = tree.get_ref();
    let mut found = 0;
    for part in path.split('.') {
        let (name, index) = match part.split_once('[') {
            Some((name, rest)) => (name, rest.trim_end_matches(']').parse::<usize>().ok()),
            None => (part, None),
        };
        let Some((key, value)) = table.iter().find(|(key, _)| **key.get_ref() == *name) else { return found };
        found = line_at(text, key.span().start);
        let inner = match (value.get_ref(), index) {
            (DeValue::Array(items), Some(index)) => match items.get(index) {
                Some(item) => {
                    found = line_at(text, item.span().start);
                    item.get_ref()
                }
                None => return found,
            },
            (other, _) => other,
        };
        match inner {
            DeValue::Table(next) => table = next,
            _ => return found,
        }
    }
    found
}

fn line_at(text: &str, at: usize) -> usize {
    1 + text.as_bytes()[..at.min(text.len())].iter().filter(|byte| **byte == b'\n').count()
}

struct Walk<'a> {
    file: &'a str,
    text: &'a str,
    problems: Vec<Problem>,
}

impl Walk<'_> {
    fn say(&mut self, at: &Range<usize>, key: &str, message: String) {
        let line = line_at(self.text, at.start);
        self.problems.push(Problem { file: self.file.to_owned(), key: key.to_owned(), line, message });
    }

    fn table(&mut self, shape: &'static Shape, entries: &DeTable<'_>, at: &Range<usize>, path: &str) {
        let below = |name: &str| if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
        for (key, value) in entries.iter() {
            let name: &str = key.get_ref();
            match shape.key(name) {
                Some(card) => self.value(card, value, &below(name)),
                None => {
                    let known: Vec<&str> = shape.keys.iter().map(|card| card.name).collect();
                    let message = format!("there is no key `{name}` here: write one of {}", known.join(", "));
                    self.say(&key.span(), &below(name), message);
                }
            }
        }
        for card in shape.keys.iter().filter(|card| card.required) {
            if !entries.iter().any(|(key, _)| **key.get_ref() == *card.name) {
                self.say(at, &below(card.name), format!("`{}` is missing: {}", card.name, card.doc));
                if let Some(problem) = self.problems.last_mut().filter(|_| path.is_empty()) {
                    problem.line = 0;
                }
            }
        }
    }

    /// A text that can be read as it stands, of a length that tables and drawings have room for.
    fn words(&mut self, text: &str, at: &Range<usize>, path: &str) {
        let count = text.chars().count();
        if count > LONGEST {
            self.say(at, path, format!("it has {count} characters: write {LONGEST} at most"));
        }
        if let Some(hidden) = text.chars().find(|one| is_hidden(*one) && *one != '\n') {
            let message =
                format!("it holds the character U+{:04X}, which cannot be seen: type it again", u32::from(hidden));
            self.say(at, path, message);
        }
    }

    fn value(&mut self, card: &Key, value: &Spanned<DeValue<'_>>, path: &str) {
        let at = value.span();
        let entries = match value.get_ref() {
            DeValue::Array(items) => items.len(),
            _ => 0,
        };
        if entries > MOST_ENTRIES {
            return self.say(&at, path, format!("the list has {entries} entries: write {MOST_ENTRIES} at most"));
        }
        match value.get_ref() {
            DeValue::String(text) => self.words(text, &at, path),
            DeValue::Array(items) => {
                for item in items.iter() {
                    if let DeValue::String(text) = item.get_ref() {
                        self.words(text, &item.span(), path);
                    }
                }
            }
            _ => {}
        }
        match (card.kind, value.get_ref()) {
            (Kind::Table(shape), DeValue::Table(entries)) => self.table(shape, entries, &at, path),
            (Kind::Tables(shape), DeValue::Array(items)) => {
                for (k, item) in items.iter().enumerate() {
                    let path = format!("{path}[{k}]");
                    match item.get_ref() {
                        DeValue::Table(entries) => self.table(shape, entries, &item.span(), &path),
                        _ => self.say(&item.span(), &path, format!("write a table: {}", card.doc)),
                    }
                }
            }
            (Kind::Tagged(forms), DeValue::Table(entries)) => {
                let kind = entries.iter().find(|(key, _)| **key.get_ref() == *"kind").map(|(_, value)| value);
                let words: Vec<&str> = forms.iter().map(|form| form.0).collect();
                let word = match kind.map(|kind| kind.get_ref()) {
                    Some(DeValue::String(word)) => Some(&**word),
                    _ => None,
                };
                match forms.iter().find(|form| Some(form.0) == word) {
                    Some((_, shape)) => self.table(shape, entries, &at, path),
                    None => {
                        let at = kind.map_or(at, Spanned::span);
                        self.say(&at, &format!("{path}.kind"), format!("write kind as one of {}", quoted(&words)));
                    }
                }
            }
            (Kind::Text, DeValue::String(_))
            | (Kind::Number, DeValue::Integer(_) | DeValue::Float(_))
            | (Kind::Flag, DeValue::Boolean(_)) => {}
            (Kind::Word(words), DeValue::String(word)) if words.contains(&&**word) => {}
            (Kind::Word(words), _) => self.say(&at, path, format!("write one of {}: {}", quoted(words), card.doc)),
            (Kind::Words(words), DeValue::Array(items)) => {
                let known = |item: &Spanned<DeValue<'_>>| matches!(item.get_ref(), DeValue::String(word) if words.contains(&&**word));
                if !items.iter().all(known) {
                    self.say(&at, path, format!("write a list of {}: {}", quoted(words), card.doc));
                }
            }
            (Kind::Texts, DeValue::Array(items))
                if items.iter().all(|item| matches!(item.get_ref(), DeValue::String(_))) => {}
            (Kind::Numbers, DeValue::Array(items)) if items.iter().all(is_number) => {}
            (Kind::Rows, DeValue::Array(items)) if items.iter().all(is_row) => {}
            (Kind::Spacings, DeValue::Array(items)) if items.iter().all(|item| is_number(item) || is_range(item)) => {}
            _ => self.say(&at, path, format!("write {}: {}", wanted(card.kind), card.doc)),
        }
    }
}

fn is_number(value: &Spanned<DeValue<'_>>) -> bool {
    matches!(value.get_ref(), DeValue::Integer(_) | DeValue::Float(_))
}

fn is_row(value: &Spanned<DeValue<'_>>) -> bool {
    matches!(value.get_ref(), DeValue::Array(items) if items.iter().all(is_number))
}

/// Whether a value is `{ from, to, step }`.
fn is_range(value: &Spanned<DeValue<'_>>) -> bool {
    let DeValue::Table(entries) = value.get_ref() else { return false };
    let names = ["from", "to", "step"];
    entries.iter().count() == names.len()
        && entries.iter().all(|(key, value)| names.contains(&&**key.get_ref()) && is_number(value))
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}

/// A kind of value in words.
fn wanted(kind: Kind) -> &'static str {
    match kind {
        Kind::Text | Kind::Word(_) => "text in quotes",
        Kind::Number => "a bare number, whose unit the key names",
        Kind::Flag => "true or false",
        Kind::Texts | Kind::Words(_) => "a list of text in quotes",
        Kind::Numbers => "a list of bare numbers",
        Kind::Rows => "a list of lists of numbers, as [[1.5, 0.5]]",
        Kind::Spacings => "a list of numbers or ranges, as [1.8, { from = 6.0, to = 26.0, step = 5.0 }]",
        Kind::Table(_) | Kind::Tagged(_) => "a table",
        Kind::Tables(_) => "a list of tables in double brackets",
    }
}
