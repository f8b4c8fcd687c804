//! A bridge file's text, edited in one place with everything else kept as it is written: comments, order, spelling.

use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use crate::path::Path;

/// The text of a bridge file as a tree that can be edited.
#[derive(Debug, Clone)]
pub struct Document {
    tree: DocumentMut,
}

/// Why a value could not be put into its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unfit {
    /// There is no such place.
    NoPlace,
    /// The text is no TOML value.
    NoValue,
}

impl Document {
    /// Reads a text; none where it is not TOML.
    pub fn parse(text: &str) -> Option<Document> {
        text.parse::<DocumentMut>().ok().map(|tree| Document { tree })
    }

    /// The text as edited.
    pub fn text(&self) -> String {
        self.tree.to_string()
    }

    /// Takes a section of the file away.
    pub fn remove(&mut self, section: &str) {
        self.tree.remove(section);
    }

    /// The file's own table.
    pub(crate) fn root(&self) -> &dyn TableLike {
        self.tree.as_table()
    }

    /// The value at a path as TOML has it; none where nothing is written there.
    pub fn get(&self, path: &Path) -> Option<String> {
        let value = self.value(path)?;
        match path.steps.last()?.index {
            None => Some(literal(value)),
            Some(index) => value.as_array()?.get(index - 1).map(literal),
        }
    }

    /// The value of a key with the remark behind it; a text without its quotation marks. None where nothing is written there.
    pub fn said(&self, path: &Path) -> Option<(String, String)> {
        let value = self.value(path)?;
        Some((value.as_str().map_or_else(|| literal(value), str::to_owned), comment(value)))
    }

    /// The texts of a list; none where there is no list.
    pub(crate) fn list(&self, path: &Path) -> Vec<String> {
        let listed = self.value(path).and_then(Value::as_array);
        listed.into_iter().flatten().filter_map(|one| one.as_str().map(str::to_owned)).collect()
    }

    fn value(&self, path: &Path) -> Option<&Value> {
        let (last, before) = path.steps.split_last()?;
        let mut table = self.root();
        for step in before {
            table = entry(table.get(&step.key)?, step.index)?;
        }
        table.get(&last.key)?.as_value()
    }

    /// Writes a TOML value at a path, in the place of the one that is there or as a new key, with its section where
    /// that is missing too. An entry of a list must be there.
    ///
    /// # Errors
    /// A text that is no TOML value, or a path that leads to no place.
    pub fn set(&mut self, path: &Path, literal: &str) -> Result<(), Unfit> {
        let value: Value = literal.trim().parse().map_err(|_| Unfit::NoValue)?;
        let (last, before) = path.steps.split_last().ok_or(Unfit::NoPlace)?;
        let mut table: &mut dyn TableLike = self.tree.as_table_mut();
        let mut inline = false;
        for step in before {
            if !table.contains_key(&step.key) {
                let fresh = if inline { Item::Value(InlineTable::new().into()) } else { Item::Table(Table::new()) };
                table.insert(&step.key, fresh);
            }
            let item = table.get_mut(&step.key).ok_or(Unfit::NoPlace)?;
            inline = item.is_value();
            table = entry_mut(item, step.index).ok_or(Unfit::NoPlace)?;
        }
        match (table.get_mut(&last.key), last.index) {
            (Some(Item::Value(old)), None) => replace(old, value),
            (Some(Item::Value(Value::Array(list))), Some(index)) => {
                replace(list.get_mut(index - 1).ok_or(Unfit::NoPlace)?, value);
            }
            (None, None) => drop(table.insert(&last.key, Item::Value(value))),
            _ => return Err(Unfit::NoPlace),
        }
        Ok(())
    }

    /// Writes a remark behind the value of a key, in the place of the one that is there; behind the whole table with the key before it where
    /// the table stands in one line. Line ends and marks of comments in the words become blanks.
    ///
    /// # Errors
    /// A place where the file writes nothing.
    pub fn remark(&mut self, path: &Path, words: &str) -> Result<(), Unfit> {
        let words: String = words.chars().map(|c| if c.is_control() || c == '#' { ' ' } else { c }).collect();
        let (last, before) = path.steps.split_last().ok_or(Unfit::NoPlace)?;
        let mut table: &mut dyn TableLike = self.tree.as_table_mut();
        for step in before {
            let item = table.get_mut(&step.key).ok_or(Unfit::NoPlace)?;
            if let Item::Value(whole) = item {
                let (said, own) = (comment(whole), format!("{}: ", last.key));
                let others = said.split("; ").filter(|one| !one.is_empty() && !one.starts_with(&own));
                let all: Vec<String> = others.map(str::to_owned).chain([format!("{own}{words}")]).collect();
                whole.decor_mut().set_suffix(format!("  # {}", all.join("; ")));
                return Ok(());
            }
            table = entry_mut(item, step.index).ok_or(Unfit::NoPlace)?;
        }
        let value = table.get_mut(&last.key).and_then(Item::as_value_mut).ok_or(Unfit::NoPlace)?;
        value.decor_mut().set_suffix(format!("  # {words}"));
        Ok(())
    }
}

/// What is said behind a value.
pub(crate) fn comment(value: &Value) -> String {
    let behind = value.decor().suffix().and_then(|suffix| suffix.as_str()).unwrap_or_default();
    behind.split_once('#').map_or_else(String::new, |(_, words)| words.trim().to_owned())
}

/// A value without the blanks and comments around it.
pub(crate) fn literal(value: &Value) -> String {
    let mut plain = value.clone();
    plain.decor_mut().clear();
    plain.to_string()
}

/// Puts a value in another's place, between the same blanks and before the same comment.
fn replace(old: &mut Value, mut new: Value) {
    *new.decor_mut() = old.decor().clone();
    *old = new;
}

/// How many tables a section has: a single one counts as a list of one, as the reader counts.
pub(crate) fn count(item: &Item) -> usize {
    match item {
        Item::ArrayOfTables(list) => list.len(),
        Item::Value(Value::Array(list)) if list.iter().all(Value::is_inline_table) => list.len(),
        other => usize::from(other.is_table_like()),
    }
}

/// One table of a section, counted from 1; the only one where no number is given.
pub(crate) fn entry(item: &Item, index: Option<usize>) -> Option<&dyn TableLike> {
    let place = place(item, index)?;
    match item {
        Item::ArrayOfTables(list) => list.get(place).map(|table| table as &dyn TableLike),
        Item::Value(Value::Array(list)) => list.get(place)?.as_inline_table().map(|table| table as &dyn TableLike),
        other => other.as_table_like(),
    }
}

fn entry_mut(item: &mut Item, index: Option<usize>) -> Option<&mut dyn TableLike> {
    let place = place(item, index)?;
    match item {
        Item::ArrayOfTables(list) => list.get_mut(place).map(|table| table as &mut dyn TableLike),
        Item::Value(Value::Array(list)) => {
            list.get_mut(place)?.as_inline_table_mut().map(|table| table as &mut dyn TableLike)
        }
        other => other.as_table_like_mut(),
    }
}

fn place(item: &Item, index: Option<usize>) -> Option<usize> {
    let count = count(item);
    match index {
        None => (count == 1).then_some(0),
        Some(index) => (1..=count).contains(&index).then(|| index - 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edited(text: &str, path: &str, value: &str) -> String {
        let mut document = Document::parse(text).unwrap();
        document.set(&Path::parse(path).unwrap(), value).unwrap();
        document.text()
    }

    #[test]
    fn a_value_changes_and_nothing_else() {
        let text = "# head\n[joint]   # dry\nfriction_angle = \"35.6 deg\"  # measured\ncohesion = '0 kPa'\n";
        let want = text.replace("\"35.6 deg\"", "\"30 deg\"");
        assert_eq!(edited(text, "joint.friction_angle", "\"30 deg\""), want);
    }

    #[test]
    fn tables_are_found_however_they_are_written() {
        let cases = [
            ("[[span]]\nrise = 1\n[[span]]\nrise = 2\n", "span[2].rise", "[[span]]\nrise = 1\n[[span]]\nrise = 9\n"),
            ("span = [{ rise = 1 }, { rise = 2 }]\n", "span[2].rise", "span = [{ rise = 1 }, { rise = 9 }]\n"),
            ("span = { rise = 1 }\n", "span.rise", "span = { rise = 9 }\n"),
            ("span.rise = 1\n", "span[1].rise", "span.rise = 9\n"),
            ("span = { rise = 1 }\n", "span.ring.size", "span = { rise = 1 , ring = { size = 9 } }\n"),
            ("[load]\nforces = [1, 2] # two\n", "load.forces[2]", "[load]\nforces = [1, 9] # two\n"),
            ("[a]\nb = 1\n", "c.d", "[a]\nb = 1\n\n[c]\nd = 9\n"),
            ("[a] # here\nb = 1\n", "a.c", "[a] # here\nb = 1\nc = 9\n"),
        ];
        for (text, path, want) in cases {
            assert_eq!(edited(text, path, "9"), want, "{path}");
            assert_eq!(Document::parse(want).unwrap().get(&Path::parse(path).unwrap()).as_deref(), Some("9"), "{path}");
        }
    }

    #[test]
    fn a_remark_stands_behind_its_value() {
        let cases = [
            ("[a]\nb = 1 # old\nc = 2\n", "a.b", "[a]\nb = 1  # new\nc = 2\n"),
            ("[[a]]\nb = 1\n[[a]]\nb = 2\n", "a[2].b", "[[a]]\nb = 1\n[[a]]\nb = 2  # new\n"),
            ("a = { b = 1, c = 2 } # whole\n", "a.b", "a = { b = 1, c = 2 }  # whole; b: new\n"),
            ("a = { b = 1, c = 2 } # b: old; c: kept\n", "a.b", "a = { b = 1, c = 2 }  # c: kept; b: new\n"),
        ];
        for (text, path, want) in cases {
            let mut document = Document::parse(text).unwrap();
            document.remark(&Path::parse(path).unwrap(), "new").unwrap();
            assert_eq!(document.text(), want, "{path}");
            document.remark(&Path::parse(path).unwrap(), "two\nlines # more").unwrap();
            assert!(Document::parse(&document.text()).is_some(), "{}", document.text());
        }
        let mut document = Document::parse("[a]\nb = 1\n").unwrap();
        assert_eq!(document.remark(&Path::parse("a.c").unwrap(), "new"), Err(Unfit::NoPlace));
    }

    #[test]
    fn places_that_are_not_there_are_refused() {
        let mut document = Document::parse("[[span]]\nrise = 1\n[[span]]\nrise = 2\n[a]\nb = [1]\n").unwrap();
        for path in ["span.rise", "span[3].rise", "a.b[2]", "a.b.c", "span[1].rise[1]", "span"] {
            assert_eq!(document.set(&Path::parse(path).unwrap(), "9"), Err(Unfit::NoPlace), "{path}");
        }
        assert_eq!(document.set(&Path::parse("a.b").unwrap(), "9 m"), Err(Unfit::NoValue));
    }
}
