//! Cards by the kind of their value: key, what it is, an example.
//!
//! A function for each kind, so that the cards of a section read like a table.
use crate::card::{Field, Kind, Section};
use crate::choice::Choice;
use crate::quantity::Dimension;

/// A function for each kind of value.
macro_rules! cards {
    ($($name:ident: $kind:expr $(, $unit:literal)?;)+) => {
        $(pub(crate) const fn $name(key: &'static str, doc: &'static str, example: &'static str) -> Field {
            Field::new(key, $kind, doc, example)
        })+

        /// The unit in which values of a kind are read, for documentation.
        macro_rules! unit {
            $($(($name) => { concat!(" [", $unit, "]") };)?)+
            ($other:ident) => { "" };
        }
    };
}

cards! {
    text: Kind::Text;
    number: Kind::Number;
    number_or_tests: Kind::NumberOr("tests");
    numbers: Kind::Numbers;
    count: Kind::Count;
    flag: Kind::Flag;
    value: Kind::Value;
    values: Kind::Values;
    slope: Kind::Slope;
    points: Kind::Points;
    line_load: Kind::LineLoad;
    load_per_metre: Kind::Quantity(Dimension::LineLoad), "N/m";
    length: Kind::Quantity(Dimension::Length), "m";
    lengths: Kind::Quantities(Dimension::Length), "m";
    stress: Kind::Quantity(Dimension::Stress), "Pa";
    stress_or_unlimited: Kind::QuantityOr(Dimension::Stress, "unlimited"), "Pa";
    stresses: Kind::Quantities(Dimension::Stress), "Pa";
    angle: Kind::Quantity(Dimension::Angle), "rad";
    density: Kind::Quantity(Dimension::Density), "kg/m^3";
    joint_stiffness: Kind::Quantity(Dimension::JointStiffness), "Pa/m";
    bending_stiffness: Kind::Quantity(Dimension::BendingStiffness), "N m^2";
    force: Kind::Quantity(Dimension::Force), "N";
    forces: Kind::Quantities(Dimension::Force), "N";
    mass: Kind::Quantity(Dimension::Mass), "kg";
    masses: Kind::Quantities(Dimension::Mass), "kg";
    speed: Kind::Quantity(Dimension::Speed), "m/s";
    acceleration: Kind::Quantity(Dimension::Acceleration), "m/s^2";
    time: Kind::Quantity(Dimension::Time), "s";
    frequency: Kind::Quantity(Dimension::Frequency), "Hz";
    frequencies: Kind::Quantities(Dimension::Frequency), "Hz";
}
pub(crate) use unit as unit_of;

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
