//! What a card is: a table of a file, and a key of it.

pub use crate::choice::Word;
use crate::quantity::{self, Dimension, Quantity};

/// A table of the file.
#[derive(Debug)]
pub struct Section {
    /// Name in the file, with dots: `span.ring`.
    pub path: &'static str,
    /// What it describes.
    pub doc: &'static str,
    /// Its keys.
    pub fields: &'static [Field],
}

/// A key of a table.
#[derive(Debug, Clone, Copy)]
pub struct Field {
    /// The key.
    pub key: &'static str,
    /// What kind of value it takes.
    pub kind: Kind,
    /// What it is, in a line; the words under a caret.
    pub doc: &'static str,
    /// An example value, without quotes.
    pub example: &'static str,
    /// Whether it must be there.
    pub need: Need,
    /// The key, and the words it may hold, for which this field means something; always where none.
    pub only: Option<(&'static str, &'static [&'static str])>,
    /// Which numbers are possible.
    pub limits: Limits,
}

/// Kinds of values.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Any text.
    Text,
    /// A number with a unit of this dimension.
    Quantity(Dimension),
    /// A number with a unit of this dimension, or this word for none.
    QuantityOr(Dimension, &'static str),
    /// A list of numbers with units.
    Quantities(Dimension),
    /// A force per metre of width, or a force over the whole width.
    LineLoad,
    /// A bare number.
    Number,
    /// A bare number, or this word in its place.
    NumberOr(&'static str),
    /// A list of bare numbers.
    Numbers,
    /// A whole number.
    Count,
    /// true or false.
    Flag,
    /// One of several words.
    Word(&'static [Word]),
    /// Two numbers of a slope, "2:1".
    Slope,
    /// A share of a span, "1/4 of span 1".
    Share,
    /// A list of points, each a pair of lengths.
    Points,
    /// A list of rows of as many bare numbers; the key carries their unit.
    Rows(usize),
    /// A value of whatever quantity: text, a number, true or false, a list.
    Value,
    /// A list of such values.
    Values,
    /// A support: "left abutment", "pier 1", "right abutment".
    Support,
    /// A table of numbers with units, each beside the name of a sensor.
    Readings,
    /// A table.
    Table(&'static Section),
    /// A list of tables.
    Tables(&'static Section),
}

impl Kind {
    /// Whether its values stand in a file without quotes around the whole.
    pub(crate) const fn is_bare(self) -> bool {
        matches!(
            self,
            Kind::Number
                | Kind::NumberOr(_)
                | Kind::Numbers
                | Kind::Count
                | Kind::Flag
                | Kind::Quantities(_)
                | Kind::Points
                | Kind::Rows(_)
                | Kind::Values
                | Kind::Readings
        )
    }
}

/// Whether a field must be there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Need {
    /// It must.
    Required,
    /// It may be missing; what that means.
    Optional(&'static str),
    /// A numerical setting with a default, as it would be written.
    Default(&'static str),
}

/// Which numbers are possible [SI].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Smallest.
    pub least: f64,
    /// Whether the smallest itself is possible.
    pub least_included: bool,
    /// Largest.
    pub most: f64,
}

impl Limits {
    /// Whether a number is possible.
    pub fn allow(&self, value: f64) -> bool {
        (value > self.least || (self.least_included && value == self.least)) && value <= self.most
    }
}

const ANY: Limits = Limits { least: f64::NEG_INFINITY, least_included: false, most: f64::INFINITY };

impl Field {
    pub(crate) const fn new(key: &'static str, kind: Kind, doc: &'static str, example: &'static str) -> Field {
        Field { key, kind, doc, example, need: Need::Required, only: None, limits: ANY }
    }

    pub(crate) const fn optional(mut self, meaning: &'static str) -> Field {
        self.need = Need::Optional(meaning);
        self
    }

    pub(crate) const fn default(mut self, value: &'static str) -> Field {
        self.need = Need::Default(value);
        self
    }

    pub(crate) const fn only(mut self, key: &'static str, words: &'static [&'static str]) -> Field {
        self.only = Some((key, words));
        self
    }

    pub(crate) const fn positive(self) -> Field {
        self.above(0.0)
    }

    pub(crate) const fn positive_up_to(self, most: f64) -> Field {
        self.positive().at_most(most)
    }

    pub(crate) const fn above(mut self, least: f64) -> Field {
        self.limits.least = least;
        self.limits.least_included = false;
        self
    }

    pub(crate) const fn at_least(mut self, least: f64) -> Field {
        self.limits.least = least;
        self.limits.least_included = true;
        self
    }

    pub(crate) const fn at_most(mut self, most: f64) -> Field {
        self.limits.most = most;
        self
    }

    pub(crate) const fn between(self, least: f64, most: f64) -> Field {
        self.at_least(least).at_most(most)
    }

    /// Most characters of a text: as the card says. Names stand in drawings, tables and titles; other texts are some sentences.
    pub fn most_characters(&self) -> usize {
        if self.limits.most.is_finite() {
            return self.limits.most as usize;
        }
        if self.key == "name" { 200 } else { 2000 }
    }

    /// Most tables or entries of a list: as the card says, or as many as are ever drawn beside one another.
    pub fn most_entries(&self) -> usize {
        match self.kind {
            Kind::Tables(_) if self.limits.most.is_finite() => self.limits.most as usize,
            Kind::Tables(_) => 1000,
            _ => 10_000,
        }
    }

    /// The first quantity of the example, whose unit engineers would use here.
    pub(crate) fn example_quantity(&self) -> Option<Quantity> {
        self.example.split('"').find_map(|piece| quantity::parse(piece).ok())
    }

    /// The example as it is written in the file, in quotes where it is text.
    pub fn example_literal(&self) -> String {
        self.literal(self.example)
    }

    /// A text of the card as the file would have it, in quotes where it is text.
    pub(crate) fn literal(&self, text: &str) -> String {
        match self.kind {
            kind if kind.is_bare() => text.to_owned(),
            Kind::Table(_) | Kind::Tables(_) => String::new(),
            _ => format!("\"{text}\""),
        }
    }

    /// How a line of the file looks, with the unit and without a value: what a message may say, for a value of another bridge is no remedy.
    pub fn form(&self) -> String {
        let unit = || self.example_quantity().map_or("", |quantity| quantity.unit.symbol);
        let value = match self.kind {
            Kind::Table(_) | Kind::Tables(_) => return self.example_line(),
            Kind::Word(choices) => {
                choices.iter().map(|choice| format!("\"{}\"", choice.word)).collect::<Vec<_>>().join(" or ")
            }
            Kind::Flag => "true or false".to_owned(),
            Kind::Slope => "\"vertical:horizontal\"".to_owned(),
            Kind::Text | Kind::Share | Kind::Support => self.example_literal(),
            Kind::Quantity(_) | Kind::LineLoad => format!("\"… {}\"", unit()),
            Kind::QuantityOr(_, word) => format!("\"… {}\" or \"{word}\"", unit()),
            Kind::Quantities(_) => format!("[\"… {}\", …]", unit()),
            Kind::Number | Kind::Count => "…".to_owned(),
            Kind::NumberOr(word) => format!("… or \"{word}\""),
            Kind::Numbers | Kind::Rows(_) | Kind::Points | Kind::Values => "[…]".to_owned(),
            Kind::Value => "\"…\"".to_owned(),
            Kind::Readings => format!("{{ \"sensor\" = \"… {}\" }}", unit()),
        };
        format!("{} = {value}", self.key)
    }

    /// A line of the file with the example.
    pub fn example_line(&self) -> String {
        match self.kind {
            Kind::Table(section) => format!("[{}]", section.path),
            Kind::Tables(section) => format!("[[{}]]", section.path),
            _ => format!("{} = {}", self.key, self.example_literal()),
        }
    }
}

impl Section {
    /// The card of a key.
    pub fn field(&self, key: &str) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.key == key)
    }
}

/// How many cards some lists have together.
pub(crate) const fn total(lists: &[&[Field]]) -> usize {
    let (mut count, mut k) = (0, 0);
    while k < lists.len() {
        count += lists[k].len();
        k += 1;
    }
    count
}

/// Some lists of cards as one, of as many as there are.
pub(crate) const fn joined<const N: usize>(lists: &[&[Field]]) -> [Field; N] {
    assert!(total(lists) == N);
    let mut fields = [Field::new("", Kind::Text, "", ""); N];
    let (mut count, mut list) = (0, 0);
    while list < lists.len() {
        let mut k = 0;
        while k < lists[list].len() {
            fields[count] = lists[list][k];
            (count, k) = (count + 1, k + 1);
        }
        list += 1;
    }
    fields
}

/// The same cards, none of which must be there.
pub(crate) const fn each_optional<const N: usize>(fields: &[Field], meaning: &'static str) -> [Field; N] {
    let mut fields = joined::<N>(&[fields]);
    let mut k = 0;
    while k < N {
        fields[k] = fields[k].optional(meaning);
        k += 1;
    }
    fields
}

/// Every section of a kind of file, in the order of the reference.
pub fn sections_of(file: &'static Section) -> Vec<&'static Section> {
    fn visit(section: &'static Section, found: &mut Vec<&'static Section>) {
        if found.iter().any(|known| std::ptr::eq(*known, section)) {
            return;
        }
        found.push(section);
        for field in section.fields {
            if let Kind::Table(inner) | Kind::Tables(inner) = field.kind {
                visit(inner, found);
            }
        }
    }
    let mut found = Vec::new();
    visit(file, &mut found);
    found
}

/// How a table of a file is called in messages.
pub fn title(file: &'static Section, section: &'static Section) -> String {
    let listed = sections_of(file).iter().any(|outer| {
        outer.fields.iter().any(|field| matches!(field.kind, Kind::Tables(inner) if std::ptr::eq(inner, section)))
    });
    match (section.path, listed) {
        ("", _) => "the file".to_owned(),
        (path, true) => format!("[[{path}]]"),
        (path, false) => format!("[{path}]"),
    }
}
