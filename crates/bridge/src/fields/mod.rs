//! Field cards: one table of everything a bridge file may say. Accessors, error messages, the JSON Schema and the
//! input reference are all made from it, so that they cannot disagree.

pub(crate) mod assess;
pub mod blocks;
pub(crate) mod calibration;
pub(crate) mod case;
pub(crate) mod continuum;
pub(crate) mod cover;
pub(crate) mod defect;
pub(crate) mod document;
pub(crate) mod loading;
pub(crate) mod material;
pub(crate) mod particles;
pub(crate) mod passage;
pub(crate) mod plan;
pub(crate) mod road;
pub(crate) mod service;
pub(crate) mod spandrel;
pub(crate) mod structure;
pub(crate) mod support;
pub(crate) mod sweep;
pub(crate) mod train;
pub(crate) mod update;
pub(crate) mod vary;
pub(crate) mod wall;

pub use crate::choice::Word;
use crate::quantity::Dimension;

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
    /// A table.
    Table(&'static Section),
    /// A list of tables.
    Tables(&'static Section),
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

    /// The example as it is written in the file, in quotes where it is text.
    pub fn example_literal(&self) -> String {
        self.literal(self.example)
    }

    /// A text of the card as the file would have it, in quotes where it is text.
    pub(crate) fn literal(&self, text: &str) -> String {
        match self.kind {
            Kind::Number
            | Kind::NumberOr(_)
            | Kind::Numbers
            | Kind::Count
            | Kind::Flag
            | Kind::Quantities(_)
            | Kind::Points
            | Kind::Rows(_)
            | Kind::Values => text.to_owned(),
            Kind::Table(_) | Kind::Tables(_) => String::new(),
            _ => format!("\"{text}\""),
        }
    }

    /// How a line of the file looks, with the unit and without a value: what a message may say, for a value of another bridge is no remedy.
    pub fn form(&self) -> String {
        let unit = || {
            let of_example = self.example.split('"').find_map(|piece| crate::quantity::parse(piece).ok());
            of_example.map_or("", |quantity| quantity.unit.symbol)
        };
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
const fn total(lists: &[&[Field]]) -> usize {
    let (mut count, mut k) = (0, 0);
    while k < lists.len() {
        count += lists[k].len();
        k += 1;
    }
    count
}

/// Some lists of cards as one, of as many as there are.
const fn joined<const N: usize>(lists: &[&[Field]]) -> [Field; N] {
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

/// The whole file.
pub static FILE: Section = Section {
    path: "",
    doc: "A masonry arch bridge and what to analyse. Quantities are text with a unit: \"18.30 m\", \"15 GPa\".",
    fields: &[
        Field::new("bridge", Kind::Table(&structure::BRIDGE), "The bridge as a whole.", ""),
        Field::new("span", Kind::Tables(&structure::SPAN), "The spans, from left to right.", "").at_most(200.0),
        Field::new(
            "pier",
            Kind::Tables(&support::PIER),
            "The piers between the spans, from left to right; a single one describes all.",
            "",
        )
        .at_most(200.0)
        .optional("a bridge of one span has none"),
        Field::new("abutment", Kind::Table(&support::ABUTMENT), "What holds the outer springings.", "")
            .optional("fixed, and drawn with its defaults"),
        Field::new("masonry", Kind::Table(&material::MASONRY), "Masonry of rings and piers.", ""),
        Field::new(
            "joint",
            Kind::Table(&material::JOINT),
            "Joints between voussoirs, at springings and between the courses of piers.",
            "",
        ),
        Field::new("ring_joint", Kind::Table(&material::RING_JOINT), "Joints between the rings of a span.", "")
            .optional("rings are joined as voussoirs are"),
        Field::new("spandrel_wall", Kind::Table(&wall::SPANDREL_WALL), "Spandrel walls that stand on the rings.", "")
            .optional("no walls"),
        Field::new("wall_joint", Kind::Table(&material::WALL_JOINT), "Joints of the spandrel walls.", "")
            .optional("bricks are joined as voussoirs are; each contact point represents half its own joint"),
        Field::new("particles", Kind::Table(&particles::PARTICLES), "Fill as particles.", "")
            .optional("no layer is modelled as particles"),
        Field::new("particle_joint", Kind::Table(&material::PARTICLE_JOINT), "Contacts between particles.", "")
            .optional("no layer is modelled as particles"),
        Field::new(
            "particle_block_joint",
            Kind::Table(&material::PARTICLE_BLOCK_JOINT),
            "Contacts of particles with blocks.",
            "",
        )
        .optional("as contacts between particles"),
        Field::new(
            "calibration",
            Kind::Table(&calibration::CALIBRATION),
            "How the contact stiffness of particles is found.",
            "",
        )
        .optional("the defaults"),
        Field::new("cover", Kind::Tables(&cover::COVER), "Layers above the rings, from the extrados up.", "")
            .at_most(50.0)
            .optional("nothing lies on the extrados"),
        Field::new("road", Kind::Table(&road::ROAD), "Levels of the surface, where it is not level.", "")
            .optional("the surface is level"),
        Field::new("water", Kind::Table(&cover::WATER), "Water in the pores of the fill.", "")
            .optional("the fill is drained"),
        Field::new("backing", Kind::Table(&cover::BACKING), "Solid backing above the haunches.", "")
            .optional("no backing"),
        Field::new(
            "internal_walls",
            Kind::Table(&spandrel::INTERNAL_WALLS),
            "Walls between the outer spandrel walls.",
            "",
        )
        .optional("none"),
        Field::new("void", Kind::Tables(&spandrel::VOID), "Voids in the spandrels, and what carries their roofs.", "")
            .at_most(200.0)
            .optional("the spandrels are filled"),
        Field::new("defect", Kind::Tables(&defect::DEFECT), "What is wrong with the rings, and where.", "")
            .at_most(200.0)
            .optional("the rings are sound"),
        Field::new(
            "continuum",
            Kind::Table(&continuum::CONTINUUM),
            "How layers and backing that are a continuum are modelled.",
            "",
        )
        .optional("the defaults"),
        Field::new("dispersal", Kind::Table(&loading::DISPERSAL), "How loads spread through the cover.", "")
            .optional("possible only where there is no cover or no load"),
        Field::new(
            "fill_pressure",
            Kind::Table(&sweep::FILL_PRESSURE),
            "Horizontal pressure of the fill against movement, in limit analysis.",
            "",
        )
        .optional("fill has weight and spreads loads, but does not press sideways"),
        Field::new(
            "carriageway",
            Kind::Table(&sweep::CARRIAGEWAY),
            "Possible positions of vehicles of [sweep] across the bridge.",
            "",
        )
        .optional("one vehicle in the middle; on roads two abreast where they fit"),
        Field::new(
            "sweep",
            Kind::Table(&sweep::SWEEP),
            "Vehicles that `extrados collapse --sweep` moves over the bridge.",
            "",
        )
        .optional("`--sweep` moves the loads of the file"),
        Field::new(
            "load",
            Kind::Tables(&loading::LOAD),
            "Loads on the surface; together they form the pattern that grows to collapse.",
            "",
        )
        .at_most(200.0)
        .optional("possible only for analyses without a load"),
        Field::new("case", Kind::Tables(&case::CASE), "Named cases that `extrados cases` compares.", "")
            .optional("the loads of the file act together, once"),
        Field::new("support_movement", Kind::Table(&plan::SUPPORT_MOVEMENT), "A movement of one support.", "")
            .optional("supports do not move"),
        Field::new("analysis", Kind::Table(&plan::ANALYSIS), "What to analyse, and how exactly.", "")
            .optional("limit analysis of the load, with the defaults"),
        Field::new("mesh", Kind::Table(&service::MESH), "The finite element mesh.", "").optional("the defaults"),
        Field::new("fill", Kind::Table(&service::FILL), "Fill above the rings, in the finite element model.", "")
            .optional("not needed for collapse"),
        Field::new("haunch_fill", Kind::Table(&service::HAUNCH_FILL), "Fill of the haunches.", "")
            .optional("the haunches have the same fill as the rest"),
        Field::new("abutment_fill", Kind::Table(&service::ABUTMENT_FILL), "Fill behind the abutments.", "")
            .optional("as the rest of the fill"),
        Field::new("mortar", Kind::Table(&service::MORTAR), "Mortar of the joints, in the finite element model.", "")
            .optional("not needed for collapse"),
        Field::new("fill_contact", Kind::Table(&service::FILL_CONTACT), "Contact of fill with masonry.", "")
            .optional("not needed for collapse"),
        Field::new("train", Kind::Table(&train::TRAIN), "The train that crosses in `extrados respond`.", "")
            .optional("no train crosses"),
        Field::new("track", Kind::Table(&train::TRACK), "How axles reach the fill: rails, sleepers, ballast.", "")
            .optional("possible only where no train crosses"),
        Field::new("passage", Kind::Table(&passage::PASSAGE), "How the train crosses, and how that is analysed.", "")
            .optional("possible only where no train crosses"),
        Field::new("sensor", Kind::Tables(&crate::sensor::SENSOR), "What is measured while the train crosses.", "")
            .optional(
                "crown, pier springing and abutment springing of the first span: displacement and strain of each",
            ),
        Field::new("vary", Kind::Tables(&vary::VARY), "What `extrados vary` changes, and over which values.", "")
            .optional("nothing is varied"),
        Field::new("records", Kind::Table(&update::RECORDS), "Records that `extrados update` compares with.", "")
            .optional("possible only without parameters"),
        Field::new("channel", Kind::Tables(&update::CHANNEL), "What is known of the records' channels.", "")
            .optional("all sensors are compared, by their names"),
        Field::new("parameter", Kind::Tables(&update::PARAMETER), "What `extrados update` searches for.", "")
            .optional("there is no search"),
        Field::new("update", Kind::Table(&update::UPDATE), "How `extrados update` searches for it.", "")
            .optional("the defaults"),
        Field::new("assess", Kind::Table(&assess::ASSESS), "Limits that `extrados assess` compares with.", "")
            .optional("checks that need a limit are not made"),
        Field::new("service_load", Kind::Tables(&assess::SERVICE_LOAD), "Loads in service.", "")
            .optional("the train as it is"),
        Field::new("mexe", Kind::Table(&assess::MEXE), "Factors of the modified MEXE method.", "")
            .optional("the MEXE check is not made"),
        Field::new("expected", Kind::Tables(&assess::EXPECTED), "Where identified parameters are expected.", "")
            .optional("identified parameters are listed without a verdict"),
        Field::new(
            "document",
            Kind::Table(&document::DOCUMENT),
            "Identification, revisions and signatures of the report.",
            "",
        )
        .optional("the report has blank fields to fill in"),
    ],
};

/// A file of ranges alone.
pub(crate) static RANGES: Section = Section {
    path: "",
    doc: "Quantities of a bridge file and their values.",
    fields: &[Field::new(
        "vary",
        Kind::Tables(&vary::VARY),
        "What `extrados vary` changes, and over which values.",
        "",
    )],
};

/// Every section of the bridge file with the key that opens it, in the order of the reference.
pub fn sections() -> Vec<&'static Section> {
    sections_of(&FILE)
}

/// Every section of the kind of file that this section belongs to; those of both kinds are found in bridge files.
pub fn neighbours(section: &'static Section) -> Vec<&'static Section> {
    let bridge = sections();
    match bridge.iter().any(|known| std::ptr::eq(*known, section)) {
        true => bridge,
        false => sections_of(&blocks::FILE),
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::findings::Findings;
    use crate::tree::Table;

    /// A card cannot name a word that its selector does not have, nor a default that cannot be read.
    #[test]
    fn words_and_defaults_of_cards_can_be_read() {
        for section in [&FILE, &blocks::FILE].into_iter().flat_map(sections_of) {
            let absent = Table::absent(section, crate::TextRange::new(0, 0));
            for field in section.fields {
                let words = |field: &Field| match field.kind {
                    Kind::Word(words) => words.iter().map(|word| word.word).collect::<Vec<_>>(),
                    _ => Vec::new(),
                };
                if let Some((key, wanted)) = field.only {
                    let known = section.field(key).map(words).unwrap_or_default();
                    assert!(wanted.iter().all(|word| known.contains(word)), "{}.{}", section.path, field.key);
                }
                let Need::Default(value) = field.need else { continue };
                let mut findings = Findings::default();
                let read = match field.kind {
                    Kind::Word(_) => words(field).contains(&value),
                    Kind::Flag => absent.read::<bool>(field.key, &mut findings).is_some(),
                    Kind::Count => absent.read::<u64>(field.key, &mut findings).is_some(),
                    Kind::Text => absent.read::<String>(field.key, &mut findings).is_some(),
                    Kind::Numbers | Kind::Quantities(_) => absent.read::<Vec<f64>>(field.key, &mut findings).is_some(),
                    _ => absent.read::<f64>(field.key, &mut findings).is_some(),
                };
                assert!(read, "{}.{} = {value}", section.path, field.key);
            }
        }
    }

    #[test]
    fn a_gauge_is_as_long_by_its_card_as_by_the_default_sensors() {
        let absent = Table::absent(&crate::sensor::SENSOR, crate::TextRange::new(0, 0));
        let length: Option<f64> = absent.read("gauge_length", &mut Findings::default());
        assert_eq!(length, Some(crate::passage::GAUGE_LENGTH));
    }
}
