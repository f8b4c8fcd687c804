//! Cards of errors in [records], [[channel]] and [[parameter]].

use super::file_card::FileCard;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[FileCard] = &[
    FileCard {
        code: "B670",
        title: "no range to search in",
        meaning: "A parameter has a number in the file, the start model, and its range contains that number.",
        why: "A search that starts outside its range starts from a model that is considered impossible.",
        wrong: r#"lower = "300 MPa""#,
        right: r#"lower = "20 MPa""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B671",
        title: "no such channel",
        meaning: "A [[channel]] names one sensor, and only one [[channel]] names it; clocks are aligned by an existing \
                  sensor.",
        why: "A reason or an uncertainty without a channel would have no effect, unnoticed.",
        wrong: r#"sensor = "quarter strain""#,
        right: r#"sensor = "crown strain""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B672",
        title: "a parameter is there twice, or there are too many",
        meaning: "Every quantity is a parameter only once, with its own name, and there are twenty parameters at most.",
        why: "One quantity cannot have two values; twenty parameters are more than any record can determine.",
        wrong: r##"quantity = "track.track_modulus" # the other one"##,
        right: r##"quantity = "track.dead_load" # the other one"##,
        source: "the format of bridge files",
    },
];
