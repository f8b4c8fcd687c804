//! Cards by the kind of their value: key, what it is, an example.
//!
//! A function for each kind, so that the cards of a section read like a table.
use crate::card::{Field, Kind, Section};
use crate::choice::Choice;
use crate::quantity::Dimension;

/// A function for each kind of value.
macro_rules! cards {
    ($($name:ident: $kind:expr,)+) => {
        $(pub(crate) const fn $name(key: &'static str, doc: &'static str, example: &'static str) -> Field {
            Field::new(key, $kind, doc, example)
        })+
    };
}

cards! {
    text: Kind::Text,
    number: Kind::Number,
    count: Kind::Count,
    flag: Kind::Flag,
    value: Kind::Value,
    values: Kind::Values,
    slope: Kind::Slope,
    points: Kind::Points,
    line_load: Kind::LineLoad,
    length: Kind::Quantity(Dimension::Length),
    lengths: Kind::Quantities(Dimension::Length),
    stress: Kind::Quantity(Dimension::Stress),
    stresses: Kind::Quantities(Dimension::Stress),
    angle: Kind::Quantity(Dimension::Angle),
    density: Kind::Quantity(Dimension::Density),
    joint_stiffness: Kind::Quantity(Dimension::JointStiffness),
    force: Kind::Quantity(Dimension::Force),
    forces: Kind::Quantities(Dimension::Force),
    mass: Kind::Quantity(Dimension::Mass),
    masses: Kind::Quantities(Dimension::Mass),
    speed: Kind::Quantity(Dimension::Speed),
    frequencies: Kind::Quantities(Dimension::Frequency),
}

/// One of the words of a choice.
pub(crate) const fn word<C: Choice>(key: &'static str, doc: &'static str, example: &'static str) -> Field {
    Field::new(key, Kind::Word(C::WORDS), doc, example)
}

/// A table.
pub(crate) const fn table(key: &'static str, section: &'static Section, doc: &'static str) -> Field {
    Field::new(key, Kind::Table(section), doc, "")
}

/// A list of tables.
pub(crate) const fn tables(key: &'static str, section: &'static Section, doc: &'static str) -> Field {
    Field::new(key, Kind::Tables(section), doc, "")
}
