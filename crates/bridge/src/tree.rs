//! A spanned TOML tree read through field cards: typed accessors that collect every mistake.

use ::findings::visible::is_hidden;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::card::{Field, Kind, Need, Section, sections_of, title};
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::library;
use crate::trade::{self, Meant};
use crate::usual::usual_of;

/// A value and where it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct At<T> {
    /// The value.
    pub(crate) value: T,
    /// Its place.
    pub(crate) range: TextRange,
}

/// A table of the file together with its card.
#[derive(Debug, Clone)]
pub(crate) struct Table<'t> {
    pub(crate) section: &'static Section,
    /// The card of the file that it stands in.
    file: &'static Section,
    /// Nothing where the file leaves the table out.
    entries: Option<&'t DeTable<'t>>,
    /// The header, or the braces of an inline table.
    pub(crate) range: TextRange,
    /// Keys that were probably meant by unknown ones.
    misspelt: Vec<&'static str>,
    /// The table that keys are taken from which are not written.
    pub(crate) under: Option<&'t Table<'t>>,
}

pub(crate) type Raw<'t> = &'t Spanned<DeValue<'t>>;

impl<'t> Table<'t> {
    /// A file of some kind.
    pub(crate) fn file(kind: &'static Section, entries: &'t DeTable<'t>, findings: &mut Findings) -> Table<'t> {
        Table::absent(kind).inner(kind, entries, TextRange::new(0, 0), findings)
    }

    /// Opens a table inside this one: reports keys that are unknown or do not belong here, and required ones that are missing.
    fn inner(
        &self,
        section: &'static Section,
        entries: &'t DeTable<'t>,
        range: TextRange,
        findings: &mut Findings,
    ) -> Table<'t> {
        let file = self.file;
        let mut table = Table { section, file, entries: Some(entries), range, misspelt: Vec::new(), under: None };
        for (key, _) in entries.iter() {
            match section.field(key.get_ref()) {
                None => {
                    let meant = unknown_key([file, section], key.get_ref(), key.span().into(), findings);
                    table.misspelt.extend(meant);
                }
                Some(field) if !table.applies(field) => table.out_of_place(field, key.span().into(), findings),
                Some(_) => {}
            }
        }
        for field in section.fields {
            if field.need == Need::Required && table.applies(field) && !table.has(field.key) {
                table.missing(field, findings);
            }
        }
        table
    }

    /// A file that says nothing: every key has the default of its card.
    pub(crate) fn absent(file: &'static Section) -> Table<'t> {
        Table { section: file, file, entries: None, range: TextRange::new(0, 0), misspelt: Vec::new(), under: None }
    }

    /// A table that is not inside this one.
    pub(crate) fn without(&self, section: &'static Section) -> Table<'t> {
        Table { section, range: self.range, ..Table::absent(self.file) }
    }

    /// What the file has of it; nothing where it is left out.
    pub(crate) fn written(&self) -> Option<&'t DeTable<'t>> {
        self.entries
    }

    /// Whether a key is written, rightly or wrongly.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.raw(key).is_some()
    }

    /// Where the value of a key stands; the table's head where it is not written.
    pub(crate) fn place(&self, key: &str) -> TextRange {
        self.raw(key).map_or(self.range, |value| value.span().into())
    }

    /// How a table is called in messages: `[[span]]`, `[joint]`.
    pub(crate) fn title(&self) -> String {
        title(self.file, self.section)
    }

    /// The card of a key and its value, if it is written and means something here.
    pub(crate) fn entry(&self, key: &str) -> Option<(&'static Field, Raw<'t>)> {
        let field = self.section.field(key);
        debug_assert!(field.is_some(), "no card for {}.{key}", self.section.path);
        let field = field?;
        if !self.applies(field) {
            return None;
        }
        Some((field, self.raw(key)?))
    }

    /// A table inside this one.
    pub(crate) fn table(&self, key: &str, findings: &mut Findings) -> Option<Table<'t>> {
        let (field, raw) = self.entry(key)?;
        let Kind::Table(section) = field.kind else { return None };
        let one = match raw.get_ref() {
            // One `[[joint]]` is as good as `[joint]`.
            DeValue::Array(items) if items.len() == 1 => items.iter().next()?,
            _ => raw,
        };
        match one.get_ref() {
            DeValue::Table(entries) => Some(self.inner(section, entries, one.span().into(), findings)),
            _ => wrong_type(field, raw, findings),
        }
    }

    /// A table inside this one whose mistakes are reported where it is read.
    pub(crate) fn known(&self, key: &str) -> Option<Table<'t>> {
        self.table(key, &mut Findings::default())
    }

    /// Where the value of a key stands in a table inside this one; this one's head where there is no such table.
    pub(crate) fn place_in(&self, table: &str, key: &str) -> TextRange {
        self.known(table).map_or(self.range, |table| table.place(key))
    }

    /// What a table inside this one says; the defaults of its cards where the file leaves it out.
    pub(crate) fn part<T>(
        &self,
        key: &str,
        findings: &mut Findings,
        read: impl FnOnce(&Table<'_>, &mut Findings) -> Option<T>,
    ) -> Option<T> {
        match self.section.field(key).map(|field| field.kind) {
            Some(Kind::Table(section)) if !self.has(key) => read(&self.without(section), findings),
            _ => read(&self.table(key, findings)?, findings),
        }
    }

    /// What a table inside this one says; none inside where the file leaves it out.
    pub(crate) fn optional<T>(
        &self,
        key: &str,
        findings: &mut Findings,
        read: impl FnOnce(&Table<'_>, &mut Findings) -> Option<T>,
    ) -> Option<Option<T>> {
        match self.has(key) {
            true => read(&self.table(key, findings)?, findings).map(Some),
            false => Some(None),
        }
    }

    /// What every table of a list says; none where one of them is wrong, or the list as such.
    pub(crate) fn all<T>(
        &self,
        key: &str,
        findings: &mut Findings,
        mut read: impl FnMut(&Table<'_>, &mut Findings) -> Option<T>,
    ) -> Option<Vec<T>> {
        let rows: Vec<Option<T>> = self.tables(key, findings).iter().map(|table| read(table, findings)).collect();
        let rows = rows.into_iter().collect::<Option<Vec<T>>>()?;
        (!self.has(key) || !rows.is_empty()).then_some(rows)
    }

    /// The same table, whose keys are as in another where they are not written.
    pub(crate) fn over<'s>(&self, under: &'s Table<'s>) -> Table<'s>
    where
        't: 's,
    {
        Table { under: Some(under), ..self.clone() }
    }

    /// A list of tables inside this one; a single table counts as a list of one.
    pub(crate) fn tables(&self, key: &str, findings: &mut Findings) -> Vec<Table<'t>> {
        let Some((field, raw)) = self.entry(key) else { return Vec::new() };
        let Kind::Tables(section) = field.kind else { return Vec::new() };
        match raw.get_ref() {
            DeValue::Table(entries) => vec![self.inner(section, entries, raw.span().into(), findings)],
            DeValue::Array(items) if items.len() > field.most_entries() => {
                let first_beyond = items.get(field.most_entries()).map_or(raw.span(), |item| item.span());
                too_many(field, items.len(), "tables", first_beyond.into(), findings);
                Vec::new()
            }
            DeValue::Array(items) if items.iter().next().is_some() => items
                .iter()
                .filter_map(|item| match item.get_ref() {
                    DeValue::Table(entries) => Some(self.inner(section, entries, item.span().into(), findings)),
                    _ => wrong_type(field, item, findings),
                })
                .collect(),
            _ => {
                wrong_type::<()>(field, raw, findings);
                Vec::new()
            }
        }
    }

    /// Reports a key that must be there, unless it is there in a wrong spelling.
    pub(crate) fn missing(&self, field: &Field, findings: &mut Findings) {
        let unnamed = |entries| library::may_give(self.section, field.key) && library::unknown(self.section, entries);
        if self.misspelt.contains(&field.key) || self.entries.is_some_and(unnamed) {
            return;
        }
        let opening = matches!(field.kind, Kind::Table(_) | Kind::Tables(_));
        let (message, help) = if opening && self.section.path.is_empty() {
            let line = field.example_line();
            (format!("the file has no {line}"), format!("add a {line} section; `extrados schema` lists its keys"))
        } else {
            let usual = usual_of(self.section.path, field.key);
            let usual = usual.map_or_else(String::new, |says| format!("; {says}: take it from a survey or a test"));
            let usual = match library::may_give(self.section, field.key) {
                true => format!("{usual}, or name a material: `extrados materials {}` lists them", self.section.path),
                false => usual,
            };
            (format!("`{}` is missing in {}", field.key, self.title()), format!("add a line {}{usual}", field.form()))
        };
        findings
            .error("B011", self.range, message, field.doc, help)
            .because("properties of the bridge are never assumed");
    }

    /// Reports a key that must be there in this case; gives nothing, for whoever cannot go on without it.
    pub(crate) fn need<T>(&self, key: &str, findings: &mut Findings) -> Option<T> {
        self.missing(self.section.field(key)?, findings);
        None
    }

    /// Reports two keys that say the same thing; gives nothing, for whoever cannot go on with both.
    pub(crate) fn exclude<T>(&self, key: &str, other: &str, findings: &mut Findings) -> Option<T> {
        findings.refuse(
            "B016",
            self.place(key),
            format!("`{key}` and {other} exclude one another"),
            format!("{other} is given as well"),
            format!("keep `{key}` or {other}, not both"),
        )
    }

    fn raw(&self, key: &str) -> Option<Raw<'t>> {
        self.entries?.get(key)
    }

    /// Whether a field means something here, going by the word that decides about it; unknown words decide nothing.
    fn applies(&self, field: &Field) -> bool {
        let Some((key, words)) = field.only else { return true };
        let Some(selector) = self.section.field(key) else { return true };
        let written = match (self.raw(key).map(Spanned::get_ref), selector.need) {
            (Some(DeValue::String(word)), _) => word.as_ref(),
            (None, Need::Default(word)) => word,
            // Nobody can say what belongs here: let what is written stand, and miss nothing.
            _ => return self.has(field.key),
        };
        let Kind::Word(choices) = selector.kind else { return true };
        if choices.iter().any(|choice| choice.word == written) { words.contains(&written) } else { self.has(field.key) }
    }

    fn out_of_place(&self, field: &Field, range: TextRange, findings: &mut Findings) {
        let Some((selector, words)) = field.only else { return };
        let list = words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" or ");
        findings.error(
            "B015",
            range,
            format!("`{}` has no effect in this {}", field.key, self.title()),
            format!("belongs to `{selector}` = {list}"),
            format!("remove this line, or set `{selector}` to {list}"),
        );
    }
}

/// Reports a value of the wrong type.
pub(crate) fn wrong_type<T>(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<T> {
    let wanted = match field.kind {
        Kind::Text => "text in quotes",
        Kind::Quantity(_) | Kind::LineLoad => "a number with its unit, in quotes",
        Kind::QuantityOr(..) => "a number with its unit or a word, in quotes",
        Kind::Quantities(_) => "a list of numbers with units",
        Kind::Number => "a bare number",
        Kind::NumberOr(_) => "a bare number or a word in quotes",
        Kind::Numbers => "a list of bare numbers",
        Kind::Count => "a whole number",
        Kind::Flag => "true or false",
        Kind::Word(_) => "a word in quotes",
        Kind::Slope => "a slope in quotes",
        Kind::Share => "a share of a span, in quotes",
        Kind::Points => "a list of points",
        Kind::Rows(2) => "a list of pairs of bare numbers",
        Kind::Rows(_) => "a list of rows of bare numbers",
        Kind::Value => "a value as the quantity has it",
        Kind::Values => "a list of values",
        Kind::Support => "the name of a support, in quotes",
        Kind::Readings => "a table of readings by the names of sensors",
        Kind::Table(_) => "a table",
        Kind::Tables(_) => "a list of tables",
    };
    let found = match raw.get_ref() {
        DeValue::String(_) => "text",
        DeValue::Integer(_) | DeValue::Float(_) => "a bare number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    };
    // A number in quotes is the number that is meant.
    let number = match (field.kind, raw.get_ref()) {
        (Kind::Number | Kind::NumberOr(_) | Kind::Count, DeValue::String(text)) => {
            text.trim().parse::<f64>().ok().map(|_| text.trim())
        }
        _ => None,
    };
    let help = match number {
        Some(number) => format!("write it without quotes: {} = {}", field.key, shorten(number)),
        None => format!("write {}", field.form()),
    };
    findings.refuse(
        "B012",
        raw.span().into(),
        format!("`{}` takes {wanted}, found {found}", field.key),
        field.doc,
        help,
    )
}

/// Reports a list that is longer than its card allows.
pub(crate) fn too_many(field: &Field, count: usize, what: &str, range: TextRange, findings: &mut Findings) {
    let most = field.most_entries();
    let message = format!("`{}` has {count} {what}, more than {most}", field.key);
    findings.error("B112", range, message, field.doc, format!("write {most} at most"));
}

/// Reports an unknown key; returns the known one that was probably meant.
fn unknown_key(
    [file, section]: [&'static Section; 2],
    key: &str,
    range: TextRange,
    findings: &mut Findings,
) -> Option<&'static str> {
    let known = section.fields.iter().map(|field| field.key);
    let title = |section| title(file, section);
    let elsewhere = sections_of(file)
        .into_iter()
        .filter(|other| !other.path.is_empty())
        .find_map(|other| Some((other, other.field(key)?)));
    let list = || known.clone().map(|key| format!("`{key}`")).collect::<Vec<_>>().join(", ");
    let meant = trade::meant(section.path, key, |key| section.field(key).is_some());
    let near = match meant {
        Some(Meant::Key(meant)) => known.clone().find(|key| *key == meant),
        Some(Meant::Elsewhere(_)) => None,
        None => nearest(key, known.clone()),
    };
    let (label, help) = if let Some(near) = near {
        let line = section.field(near).map_or_else(|| format!("`{near}`"), Field::form);
        (format!("did you mean `{near}`?"), format!("write {line}"))
    } else if let Some(Meant::Elsewhere(how)) = meant {
        (format!("not a key of {}", title(section)), how.to_owned())
    } else if let Some((other, field)) = elsewhere {
        // The same word may mean another thing there: what it means is said, and what this section knows.
        let help = format!("{} knows {}; in {} `{key}` means: {}", title(section), list(), title(other), field.doc);
        (format!("a key of {}, not of {}", title(other), title(section)), help)
    } else {
        (format!("not a key of {}", title(section)), format!("{} knows {}", title(section), list()))
    };
    findings.error("B010", range, format!("unknown key `{}` in {}", shorten(key), title(section)), label, help);
    near
}

/// The known word nearest to what was written, if it is near enough to be a slip.
pub(crate) fn nearest<'a>(written: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    if written.len() > 60 {
        return None;
    }
    let plain = |word: &str| word.to_lowercase().replace(['-', ' '], "_");
    let written = plain(written);
    known
        .map(|word| (strsim::osa_distance(&plain(word), &written), word))
        .filter(|(distance, word)| *distance <= 1.max(word.len().min(written.len()) / 3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
}

/// A piece of the file as it may be quoted in a message.
pub(crate) fn shorten(text: &str) -> String {
    let mut short: String = text.chars().take(40).map(|c| if is_hidden(c) { ' ' } else { c }).collect();
    if text.chars().count() > 40 {
        short.push('…');
    }
    short
}
