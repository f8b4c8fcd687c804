//! The card of ranges over which `extrados vary` repeats an analysis.

use crate::card::Section;
use crate::cards::*;
use crate::choice::choice;

choice! {
    /// How the values of a range lie.
    pub(crate) enum Spacing {
        /// equal differences
        Linear = "linear",
        /// equal ratios; both ends of the same sign
        Geometric = "geometric",
    }
}

pub(crate) static VARY: Section = Section {
    path: "vary",
    doc: "A quantity of this file and the values that `extrados vary` gives it, one quantity at a time or in a grid. \
          Values are written as the quantity itself is, or relative to its own value: \"-5 %\", \"x0.5\".",
    fields: &[
        text(
            "quantity",
            "path of the quantity: sections and key with dots, [1] for the first of several",
            "joint.friction_angle",
        ),
        values("values", "the values, one after the other", "[\"30 deg\", \"35.6 deg\", \"40 deg\"]")
            .optional("given by `from`, `to` and `points`"),
        value("from", "first value of a range", "30 deg").optional("given by `values`"),
        value("to", "last value of a range", "40 deg").optional("given by `values`"),
        count("points", "number of values in a range, both ends included", "5")
            .between(2.0, 1000.0)
            .optional("given by `values`"),
        word::<Spacing>("spacing", "how the values of a range are spaced", "linear").default(Spacing::Linear.word()),
    ],
};
