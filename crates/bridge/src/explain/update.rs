//! Cards of errors in [records], [[channel]] and [[parameter]].

use super::Card;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[Card] = &[
    Card {
        code: "B670",
        title: "no range to seek in",
        meaning: "A parameter has a number in the file, and its range holds that number: it is the start model.",
        why: "A search that starts outside its range compares with a model that nobody holds possible.",
        wrong: r#"lower = "300 MPa""#,
        right: r#"lower = "20 MPa""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B671",
        title: "no such channel",
        meaning: "A [[channel]] speaks of one sensor, by its name, and no other does; clocks are aligned by a sensor that there is.",
        why: "A reason or an uncertainty that reaches no channel would look as if it had.",
        wrong: r#"sensor = "quarter strain""#,
        right: r#"sensor = "crown strain""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B672",
        title: "a parameter is there twice, or too many are",
        meaning: "Every quantity is sought once, under a name of its own, and twenty are the most.",
        why: "Two values for one quantity are no model; twenty are more than any record tells.",
        wrong: r##"quantity = "track.track_modulus" # the other one"##,
        right: r##"quantity = "track.dead_load" # the other one"##,
        source: "the format of bridge files",
    },
];
