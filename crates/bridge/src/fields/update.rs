//! Model updating: records, channels, parameters, searches.

use crate::card::{Field, Kind, Section};
use crate::choice::{Choice, choice};
use crate::quantity::Dimension::Frequency;
use crate::update::{Compared, Search, Start, Variant, Weights};

choice! {
    /// What the channel is laid on by which clocks are aligned.
    pub(crate) enum AlignedBy {
        /// its history in the start model
        Model = "model",
        /// the times at which axles pass its sensor
        Axles = "axles",
    }
}

pub(super) static RECORDS: Section = Section {
    path: "records",
    doc: "Records of a train's passage that `extrados update` compares with. Their columns are named after the sensors.",
    fields: &[
        Field::new(
            "place",
            Kind::Text,
            "a table (.csv), or a folder in which every table is a run; beside this file",
            "table-6.csv",
        ),
        Field::new("zero", Kind::Flag, "whether the level before the train is subtracted", "true").default("true"),
        Field::new("drift", Kind::Flag, "whether the line between the levels before and after is subtracted", "false")
            .default("false"),
        Field::new(
            "low_pass",
            Kind::Quantity(Frequency),
            "frequency above which records are filtered, forward and backward so that nothing shifts in time; noise \
             raises a peak, which is the largest of many samples",
            "10 Hz",
        )
        .positive()
        .optional("as recorded"),
        Field::new("align", Kind::Text, "the channel by which clocks are aligned", "crown displacement")
            .optional("the records' clock is that of [passage]: zero where the first axle starts"),
        Field::new("align_by", Kind::Word(AlignedBy::WORDS), "what that channel is aligned with", "model")
            .default(AlignedBy::Model.word()),
    ],
};

pub(super) static CHANNEL: Section = Section {
    path: "channel",
    doc: "Information on a channel of the records; sensors without a [[channel]] are compared as they are.",
    fields: &[
        Field::new("sensor", Kind::Text, "name of the sensor", "crown strain"),
        Field::new("column", Kind::Text, "name of the column in the records", "SG 4").optional("the sensor's name"),
        Field::new("reversed", Kind::Flag, "whether the sign of the records is reversed", "false").default("false"),
        Field::new("uncertainty", Kind::Number, "standard deviation of one value, in mm, microstrain or MPa", "0.01")
            .positive()
            .optional("not known; needed by the posterior and by `by_uncertainty`"),
        Field::new("weight", Kind::Number, "its weight, where weights are given", "1.0")
            .positive()
            .optional("needed only where `weights` = \"given\""),
        Field::new(
            "leave_out",
            Kind::Text,
            "reason for which it is left out; it is still shown",
            "a gauge on a stone sees no opening",
        )
        .optional("it is compared"),
    ],
};

choice! {
    /// How a range is divided.
    pub(crate) enum Spacing {
        /// evenly in the value
        Linear = "linear",
        /// evenly in its logarithm, for ranges over orders of magnitude
        Logarithmic = "logarithmic",
    }
}

pub(super) static PARAMETER: Section = Section {
    path: "parameter",
    doc: "A quantity of this file that `extrados update` searches for between bounds. The search starts at its own \
          value.",
    fields: &[
        Field::new("quantity", Kind::Text, "path of the quantity, as in [[vary]]", "fill.elastic_modulus"),
        Field::new("name", Kind::Text, "name in results", "fill").optional("its path"),
        Field::new("lower", Kind::Value, "lower end of the acceptable range", "20 MPa"),
        Field::new("upper", Kind::Value, "upper end of the acceptable range", "200 MPa"),
        Field::new("spacing", Kind::Word(Spacing::WORDS), "how the range is divided", "linear")
            .default(Spacing::Linear.word()),
    ],
};

pub(super) static UPDATE: Section = Section {
    path: "update",
    doc: "How `extrados update` searches for the parameters.",
    fields: &[
        Field::new("search", Kind::Word(Search::WORDS), "which search", "modern").default(Search::Modern.word()),
        Field::new("variant", Kind::Word(Variant::WORDS), "reading of the hierarchical search", "printed")
            .default(Variant::Printed.word()),
        Field::new("start", Kind::Word(Start::WORDS), "where the hierarchical search begins", "means")
            .default(Start::Means.word()),
        Field::new("starts", Kind::Count, "starts of the modern search", "4")
            .at_least(1.0)
            .at_most(1000.0)
            .default("4"),
        Field::new("passes", Kind::Count, "most passes of the hierarchical search", "2")
            .at_least(1.0)
            .at_most(100.0)
            .default("2"),
        Field::new("points", Kind::Count, "points of a sweep, and of a surface along each parameter", "11")
            .at_least(3.0)
            .at_most(201.0)
            .default("11"),
        Field::new("compare", Kind::Word(Compared::WORDS), "what is compared", "peaks").default(Compared::Peaks.word()),
        Field::new(
            "slices",
            Kind::Flag,
            "whether peaks are compared in static slices instead of full passages",
            "true",
        )
        .default("true"),
        Field::new("weights", Kind::Word(Weights::WORDS), "where weights come from", "shapes")
            .default(Weights::Shapes.word()),
        Field::new("by_uncertainty", Kind::Flag, "whether errors are expressed in multiples of `uncertainty`", "false")
            .default("false"),
        Field::new(
            "posterior",
            Kind::Flag,
            "whether the posterior of the parameters is \
                                             sampled",
            "false",
        )
        .default("false"),
        Field::new(
            "model_error",
            Kind::Number,
            "scale of the model's own error, a share of the peaks; 0 for none",
            "0.1",
        )
        .at_least(0.0)
        .at_most(1.0)
        .default("0.1"),
        Field::new(
            "common_gain_deviation",
            Kind::Number,
            "standard deviation of a gain that all channels share, a share of the response: axle loads as they are against those of \
             [train], the width that carries them, the share of a track; 0 where all of these are known exactly",
            "0.1",
        )
        .at_least(0.0)
        .at_most(0.5)
        .default("0.1"),
        Field::new("samples", Kind::Count, "effective samples of the posterior", "10000")
            .at_least(100.0)
            .at_most(1_000_000.0)
            .default("10000"),
        Field::new("seed", Kind::Count, "seed of starts, surrogate and posterior", "1")
            .at_least(0.0)
            .at_most(9e15)
            .default("1"),
    ],
};

/// Sections of updating, which are no part of the bridge.
pub(crate) const SECTIONS: [&str; 4] = ["records", "channel", "parameter", "update"];
