//! Cards of named cases: combinations of the file's loads, with factors and with other values.

use crate::card::{Field, Kind, Section};

pub(super) static CASE: Section = Section {
    path: "case",
    doc: "A named case of `extrados cases`: loads of this file that act together, with factors on them and on weights, and values that are \
          otherwise in this case.",
    fields: &[
        Field::new("name", Kind::Text, "name of the case, for tables and drawings", "axle at the quarter point"),
        Field::new("load", Kind::Tables(&CASE_LOAD), "Loads that act, with their factors.", "")
            .at_most(200.0)
            .optional("all loads of the file, each once"),
        Field::new("masonry_weight", Kind::Number, "factor on the weight of rings, piers and walls", "1.15")
            .positive()
            .at_most(10.0)
            .default("1"),
        Field::new("fill_weight", Kind::Number, "factor on the weight of fill and backing", "1.2")
            .positive()
            .at_most(10.0)
            .default("1"),
        Field::new("surfacing_weight", Kind::Number, "factor on the weight of surfacing and ballast", "1.75")
            .positive()
            .at_most(10.0)
            .default("1"),
        Field::new(
            "change",
            Kind::Tables(&CASE_CHANGE),
            "Quantities of this file that are otherwise in this case.",
            "",
        )
        .at_most(200.0)
        .optional("everything is as the file says"),
    ],
};

static CASE_LOAD: Section = Section {
    path: "case.load",
    doc: "A load that acts in a case.",
    fields: &[
        Field::new("name", Kind::Text, "name of a [[load]]", "tandem"),
        Field::new("factor", Kind::Number, "factor on it", "1.35").positive().at_most(1000.0).default("1"),
    ],
};

static CASE_CHANGE: Section = Section {
    path: "case.change",
    doc: "A quantity that is otherwise in a case. Its value is written as the quantity itself is, or relative to its own: \"-5 %\", \"x0.5\".",
    fields: &[
        Field::new(
            "quantity",
            Kind::Text,
            "path of the quantity: sections and key with dots, [1] for the first of several",
            "joint.friction_angle",
        ),
        Field::new("value", Kind::Value, "its value in this case", "30 deg"),
    ],
};
