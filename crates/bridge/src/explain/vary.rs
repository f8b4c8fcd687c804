//! Cards of errors in [[vary]].

use super::file_card::FileCard;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[FileCard] = &[
    FileCard {
        code: "B501",
        title: "no such quantity",
        meaning: "A path names a quantity of this file: its sections and its key with dots between, and [1] for the \
                  first of several. The message gives the nearest path and what the file has.",
        why: "A wrong path would vary nothing, and the result would look as if the quantity did not matter.",
        wrong: r#"quantity = "joint.friction_angel""#,
        right: r#"quantity = "joint.friction_angle""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B502",
        title: "no such entry",
        meaning: "Where a file has several spans, layers or loads, a path says which, counted from 1 in the order of the file.",
        why: "With a number beyond the last, or with none where there are several, the quantity is not defined.",
        wrong: r#"quantity = "span[9].ring[2].crown_thickness""#,
        right: r#"quantity = "span[1].ring[2].crown_thickness""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B503",
        title: "values that cannot be worked out",
        meaning: "Both ends of a range are numbers of the same dimension. Relative values, \"-5 %\" or \"x0.5\", need a quantity that has a number in the file or by default.",
        why: "A range needs two numbers of the same kind.",
        wrong: r#"to = "5 kN""#,
        right: r#"to = "+5 %""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B504",
        title: "a quantity is varied twice",
        meaning: "Every quantity has one table of values.",
        why: "With one quantity at a time, the second table would repeat the first; in a grid it would overwrite it.",
        wrong: r#"quantity = "joint.friction_angle""#,
        right: r#"quantity = "span[1].ring[2].crown_thickness""#,
        source: "the format of bridge files",
    },
];
