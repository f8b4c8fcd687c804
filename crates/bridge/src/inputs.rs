//! What a bridge file says, line by line with the remarks beside it: where engineers write down where a value is from.

use crate::card::{Kind, Section};
use crate::fields::FILE;
use crate::library;
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// A value of a file.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Input {
    /// Section, with its number where it stands several times: `cover[2]`.
    pub section: String,
    /// Key.
    pub key: String,
    /// Value as written, without quotes.
    pub value: String,
    /// The comment behind it; empty where there is none.
    pub remark: String,
}

impl Input {
    /// Its path in the file: `cover[2].density`.
    pub fn path(&self) -> String {
        if self.section.is_empty() { self.key.clone() } else { format!("{}.{}", self.section, self.key) }
    }
}

/// The table of a section in which a key has a value, as `sensor[2]`; the section itself where none has.
pub fn table_with(inputs: &[Input], section: &str, key: &str, value: &str) -> String {
    let of = |one: &&Input| one.section.split('[').next() == Some(section) && one.key == key && one.value == value;
    inputs.iter().find(of).map_or_else(|| section.to_owned(), |one| one.section.clone())
}

/// Every value of a file in its order, those that it takes from the library by the name of a material behind that name; nothing where it
/// is not TOML.
pub fn inputs(text: &str) -> Vec<Input> {
    let mut found = Vec::new();
    if let Ok(document) = text.parse::<DocumentMut>() {
        table(document.as_table(), "", &mut found);
    }
    found
}

fn table(table: &dyn TableLike, section: &str, found: &mut Vec<Input>) {
    let inside = |key: &str| if section.is_empty() { key.to_owned() } else { format!("{section}.{key}") };
    for (key, item) in table.iter() {
        match item {
            // Written in one line, a table is a table.
            Item::Value(Value::InlineTable(inner)) => self::table(inner, &inside(key), found),
            Item::Value(Value::Array(list)) if !list.is_empty() && list.iter().all(Value::is_inline_table) => {
                tables(list.iter().filter_map(|one| one.as_inline_table()), list.len(), &inside(key), found);
            }
            Item::Value(value) => {
                let input = |key: &str, value, remark| Input {
                    section: section.to_owned(),
                    key: key.to_owned(),
                    value,
                    remark,
                };
                found.push(input(key, plain(value), remark(value)));
                if let Some(card) = card(section).filter(|_| key == library::KEY) {
                    found.extend(
                        library::taken(card, table).into_iter().map(|(key, value, remark)| input(&key, value, remark)),
                    );
                }
            }
            Item::Table(inner) => self::table(inner, &inside(key), found),
            Item::ArrayOfTables(list) => {
                tables(list.iter(), list.len(), &inside(key), found);
            }
            Item::None => {}
        }
    }
}

/// Tables of one list, with their numbers where there are several.
fn tables<'a, T: TableLike + 'a>(
    list: impl Iterator<Item = &'a T>,
    count: usize,
    section: &str,
    found: &mut Vec<Input>,
) {
    for (k, inner) in list.enumerate() {
        let number = if count > 1 { format!("[{}]", k + 1) } else { String::new() };
        table(inner, &format!("{section}{number}"), found);
    }
}

/// The card of a section, as `cover[2]`, of a bridge file.
fn card(section: &str) -> Option<&'static Section> {
    match FILE.field(section.split('[').next()?)?.kind {
        Kind::Table(card) | Kind::Tables(card) => Some(card),
        _ => None,
    }
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.value().clone(),
        other => crate::edit::literal(other),
    }
}

fn remark(value: &Value) -> String {
    let behind = value.decor().suffix().and_then(|suffix| suffix.as_str()).unwrap_or_default();
    behind.split('#').skip(1).map(str::trim).filter(|words| !words.is_empty()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_come_with_their_remarks() {
        let text =
            "[bridge]\nwidth = \"4 m\" # [paper] Table 1\n[[cover]]\nas = true\n[[cover]]\nlist = [1, 2] # two\n";
        let found = inputs(text);
        let shown: Vec<String> =
            found.iter().map(|one| format!("{}.{}={}|{}", one.section, one.key, one.value, one.remark)).collect();
        assert_eq!(shown, ["bridge.width=4 m|[paper] Table 1", "cover[1].as=true|", "cover[2].list=[1, 2]|two"]);
        let inline = "bridge = { width = \"4 m\" }\ncover = [{ as = true }, { list = [1, 2] }]\n";
        let paths = |text: &str| inputs(text).into_iter().map(|one| (one.path(), one.value)).collect::<Vec<_>>();
        assert_eq!(paths(inline), paths(text), "written in one line, a table is a table");
        assert!(inputs("no [toml").is_empty());
        let named = inputs("[masonry]\nmaterial = \"Sandstone\" # by eye\ndensity = \"2300 kg/m^3\" # cored\n");
        let shown: Vec<_> = named.iter().map(|one| format!("{} = {}", one.path(), one.value)).collect();
        assert_eq!(shown[..2], ["masonry.material = Sandstone", "masonry.compressive_strength = 10 MPa"]);
        assert!(
            named[1].remark.starts_with("not measured: library, sandstone, 5 MPa to 18 MPa; "),
            "{}",
            named[1].remark
        );
        let densities: Vec<_> = named.iter().filter(|one| one.key == "density").map(|one| &one.remark[..]).collect();
        assert_eq!(densities, ["cored"], "what the table writes itself is not taken");
        assert_eq!((found[0].path(), found[2].path()), ("bridge.width".to_owned(), "cover[2].list".to_owned()));
        let two = inputs("[[sensor]]\nname = \"a\"\n[[sensor]]\nname = \"b\"\n");
        assert_eq!(["b", "c"].map(|name| table_with(&two, "sensor", "name", name)), ["sensor[2]", "sensor"]);
    }
}
