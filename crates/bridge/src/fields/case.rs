//! Cards of named cases: combinations of the file's loads, with factors and with other values.

use crate::card::Section;
use crate::cards::*;

pub(super) static CASE: Section = Section {
    path: "case",
    doc: "A named case of `extrados cases`: loads of this file that act together, with factors on them and on weights, and values that are \
          otherwise in this case.",
    fields: &[
        text("name", "name of the case, for tables and drawings", "axle at the quarter point"),
        tables("load", &CASE_LOAD, "Loads that act, with their factors.")
            .at_most(200.0)
            .optional("all loads of the file, each once"),
        number("masonry_weight", "factor on the weight of rings, piers and walls", "1.15")
            .positive_up_to(10.0)
            .default("1"),
        number("fill_weight", "factor on the weight of fill and backing", "1.2").positive_up_to(10.0).default("1"),
        number("surfacing_weight", "factor on the weight of surfacing and ballast", "1.75")
            .positive_up_to(10.0)
            .default("1"),
        tables("change", &CASE_CHANGE, "Quantities of this file that are otherwise in this case.")
            .at_most(200.0)
            .optional("everything is as the file says"),
    ],
};

static CASE_LOAD: Section = Section {
    path: "case.load",
    doc: "A load that acts in a case.",
    fields: &[
        text("name", "name of a [[load]]", "tandem"),
        number("factor", "factor on it", "1.35").positive_up_to(1000.0).default("1"),
    ],
};

static CASE_CHANGE: Section = Section {
    path: "case.change",
    doc: "A quantity that is otherwise in a case. Its value is written as the quantity itself is, or relative to its own: \"-5 %\", \"x0.5\".",
    fields: &[
        text(
            "quantity",
            "path of the quantity: sections and key with dots, [1] for the first of several",
            "joint.friction_angle",
        ),
        value("value", "its value in this case", "30 deg"),
    ],
};
