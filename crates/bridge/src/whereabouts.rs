//! Where the value of a quantity stands in the text of its file.

use crate::diagnostic::TextRange;
use crate::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The values of a text with their places; made once for many questions.
#[derive(Debug)]
pub struct Whereabouts<'t>(Spanned<DeTable<'t>>);

impl<'t> Whereabouts<'t> {
    /// Of a text, as far as it can be read.
    pub fn of(text: &'t str) -> Whereabouts<'t> {
        Whereabouts(DeTable::parse_recoverable(text).0)
    }

    /// Where the value at a path stands; none where the file does not write it.
    pub fn value(&self, path: &Path) -> Option<TextRange> {
        let mut table = self.0.get_ref();
        let mut found: Option<&Spanned<DeValue<'t>>> = None;
        for (depth, step) in path.steps.iter().enumerate() {
            if depth > 0 {
                table = match found?.get_ref() {
                    DeValue::Table(table) => table,
                    DeValue::Array(list) if list.len() == 1 => list.first()?.get_ref().as_table()?,
                    _ => return None,
                };
            }
            let (_, value) = table.iter().find(|(key, _)| key.get_ref().as_ref() == step.key)?;
            found = match (value.get_ref(), step.index) {
                (DeValue::Array(list), Some(index)) => Some(list.get(index.checked_sub(1)?)?),
                // A single table counts as a list of one.
                (_, None | Some(1)) => Some(value),
                _ => None,
            };
        }
        found.map(|value| value.span().into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_found_however_tables_are_written() {
        let texts = [
            ("[[span]]\nrise = 1\n[[span]]\nrise = \"2 m\" # two\n", "span[2].rise", Some("\"2 m\"")),
            ("span = { rise = 7 }\n", "span[1].rise", Some("7")),
            ("span = [{ rise = 7 }]\n", "span.rise", Some("7")),
            ("[load]\nforces = [1, 29]\n", "load.forces[2]", Some("29")),
            ("span.rise = 3\n", "span.rise", Some("3")),
            ("[a]\nb = 1\n", "a.c", None),
            ("[[span]]\nrise = 1\n[[span]]\nrise = 2\n", "span.rise", None),
        ];
        for (text, path, want) in texts {
            let range = Whereabouts::of(text).value(&Path::parse(path).unwrap());
            assert_eq!(range.map(|range| &text[range.start..range.end]), want, "{path} in {text}");
        }
    }
}
