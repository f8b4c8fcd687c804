//! Answers given to a survey whose file has other things in it as well: what an answer changes is changed, and all else stays as it is.

use super::answers::Unusable;
use super::page::NOT_THERE;
use super::{answers, checked};
use crate::Severity;
use crate::edit::comment;
use std::collections::BTreeMap;
use toml_edit::{DocumentMut, Item, Table, TableLike, Value};

/// What became of answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Changed {
    /// The file with them; none where one is refused.
    pub text: Option<String>,
    /// What is wrong with answers or doubtful; no key where it is none of them.
    pub findings: Vec<Unusable>,
}

/// The file of a survey with these answers in it; an empty one takes an answer away. Without any, what is doubtful of those that it has.
pub fn changed(text: &str, changes: &BTreeMap<String, String>) -> Changed {
    let Some(before) = answers(text) else {
        return refused("the text of the file has an error", "mend it first: “Findings” says where it is");
    };
    let mut after = before.clone();
    after.extend(changes.iter().map(|(key, value)| (key.clone(), value.clone())));
    let (mine, findings) = written(&after);
    let Some(mine) = mine.filter(|_| findings.iter().all(|one| one.severity != Severity::Error)) else {
        return Changed { text: None, findings };
    };
    if changes.is_empty() {
        return Changed { text: Some(text.to_owned()), findings };
    }
    let base = written(&before).0.unwrap_or_default();
    match merged(&base, &mine, text) {
        Some(text) => Changed { text: Some(text), findings },
        None => refused(
            "the file has been changed by hand where this answer stands",
            "change it in “Form” or “Text”, where it is as it was written",
        ),
    }
}

fn refused(message: &str, help: &str) -> Changed {
    let one = Unusable { key: String::new(), severity: Severity::Error, message: message.into(), help: help.into() };
    Changed { text: None, findings: vec![one] }
}

fn written(answers: &BTreeMap<String, String>) -> (Option<String>, Vec<Unusable>) {
    let name = answers.get("name").map_or("", |name| name.trim());
    checked(if name.is_empty() { super::kept::NO_NAME } else { name }, &|key| answers.get(key).cloned(), true)
}

/// What leads from one text to another, done to a third; none where that has no place for it.
fn merged(base: &str, mine: &str, theirs: &str) -> Option<String> {
    if base == theirs {
        return Some(mine.to_owned());
    }
    let [base_tree, mine_tree] = [base, mine].map(|text| text.parse::<DocumentMut>().ok());
    let mut tree = theirs.parse::<DocumentMut>().ok()?;
    merge(base_tree.unwrap_or_default().as_table(), mine_tree?.as_table(), tree.as_table_mut())?;
    let text = with_head(base, mine, tree.to_string());
    let errors = |text: &str| crate::read(text.as_bytes()).bridge.is_none();
    (text.parse::<DocumentMut>().is_ok() && (!errors(&text) || errors(theirs))).then_some(text)
}

/// The line of what is not there stands in no table.
fn with_head(base: &str, mine: &str, text: String) -> String {
    let not_there = |text: &str| text.lines().find(|line| line.starts_with(NOT_THERE)).map(str::to_owned);
    let (before, after) = (not_there(base), not_there(mine));
    if before == after {
        return text;
    }
    let mut lines: Vec<String> = text.lines().filter(|line| !line.starts_with(NOT_THERE)).map(str::to_owned).collect();
    lines.splice(1.min(lines.len())..1.min(lines.len()), after);
    lines.join("\n") + "\n"
}

fn merge(base: &Table, mine: &Table, theirs: &mut dyn TableLike) -> Option<()> {
    for (key, _) in base.iter().filter(|(key, _)| !mine.contains_key(key)) {
        theirs.remove(key);
    }
    for (key, item) in mine.iter() {
        let before = base.get(key);
        match item {
            Item::Value(value) => put(before.and_then(Item::as_value), key, value, theirs),
            Item::Table(table) => match theirs.get_mut(key) {
                None if before.is_some_and(|one| one.to_string() == item.to_string()) => {}
                None => drop(theirs.insert(key, item.clone())),
                Some(there) => {
                    let none = Table::new();
                    merge(before.and_then(Item::as_table).unwrap_or(&none), table, there.as_table_like_mut()?)?;
                }
            },
            Item::ArrayOfTables(list) => match theirs.get_mut(key) {
                None => drop(theirs.insert(key, item.clone())),
                Some(Item::ArrayOfTables(there)) => {
                    let none = Table::new();
                    let before = before.and_then(Item::as_array_of_tables);
                    let had = before.map_or(0, |list| list.len());
                    for (k, table) in list.iter().enumerate() {
                        match there.get_mut(k) {
                            Some(one) => merge(before.and_then(|list| list.get(k)).unwrap_or(&none), table, one)?,
                            None => there.push(table.clone()),
                        }
                    }
                    // Those that somebody wrote beside the survey's stay.
                    (list.len()..had.min(there.len())).rev().for_each(|k| drop(there.remove(k)));
                }
                Some(there) if list.len() == 1 => {
                    let none = Table::new();
                    let before = before.and_then(Item::as_array_of_tables).and_then(|list| list.get(0));
                    merge(before.unwrap_or(&none), list.get(0)?, there.as_table_like_mut()?)?;
                }
                Some(_) => return None,
            },
            Item::None => {}
        }
    }
    Some(())
}

/// Puts a value that is another one now. What is assumed gives way to what somebody wrote in its place.
fn put(before: Option<&Value>, key: &str, value: &Value, theirs: &mut dyn TableLike) {
    let plain = |value: &Value| crate::edit::literal(value);
    let same = before.is_some_and(|one| plain(one) == plain(value) && comment(one) == comment(value));
    let there = theirs.get(key).and_then(Item::as_value).map(plain);
    let own = there.is_some() && there != before.map(plain);
    if !same && !(own && comment(value).starts_with("assumed")) {
        theirs.insert(key, Item::Value(value.clone()));
    }
}
