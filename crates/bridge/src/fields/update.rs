//! Model updating: records, channels, parameters, searches.

use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::choice::choice;
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
        text("place", "a table (.csv), or a folder in which every table is a run; beside this file", "table-6.csv"),
        flag("zero", "whether the level before the train is subtracted", "true").default("true"),
        flag("drift", "whether the line between the levels before and after is subtracted", "false").default("false"),
        Field::new(
            "low_pass",
            Kind::Quantity(Frequency),
            "frequency above which records are filtered, forward and backward so that nothing shifts in time; noise \
             raises a peak, which is the largest of many samples",
            "10 Hz",
        )
        .positive()
        .optional("as recorded"),
        text("align", "the channel by which clocks are aligned", "crown displacement")
            .optional("the records' clock is that of [passage]: zero where the first axle starts"),
        word::<AlignedBy>("align_by", "what that channel is aligned with", "model").default(AlignedBy::Model.word()),
    ],
};

pub(super) static CHANNEL: Section = Section {
    path: "channel",
    doc: "Information on a channel of the records; sensors without a [[channel]] are compared as they are.",
    fields: &[
        text("sensor", "name of the sensor", "crown strain"),
        text("column", "name of the column in the records", "SG 4").optional("the sensor's name"),
        flag("reversed", "whether the sign of the records is reversed", "false").default("false"),
        number("uncertainty", "standard deviation of one value, in mm, microstrain or MPa", "0.01")
            .positive()
            .optional("not known; needed by the posterior and by `by_uncertainty`"),
        number("weight", "its weight, where weights are given", "1.0")
            .positive()
            .optional("needed only where `weights` = \"given\""),
        text("leave_out", "reason for which it is left out; it is still shown", "a gauge on a stone sees no opening")
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
        text("quantity", "path of the quantity, as in [[vary]]", "fill.elastic_modulus"),
        text("name", "name in results", "fill").optional("its path"),
        value("lower", "lower end of the acceptable range", "20 MPa"),
        value("upper", "upper end of the acceptable range", "200 MPa"),
        word::<Spacing>("spacing", "how the range is divided", "linear").default(Spacing::Linear.word()),
    ],
};

pub(super) static UPDATE: Section = Section {
    path: "update",
    doc: "How `extrados update` searches for the parameters.",
    fields: &[
        word::<Search>("search", "which search", "modern").default(Search::Modern.word()),
        word::<Variant>("variant", "reading of the hierarchical search", "printed").default(Variant::Printed.word()),
        word::<Start>("start", "where the hierarchical search begins", "means").default(Start::Means.word()),
        count("starts", "starts of the modern search", "4").between(1.0, 1000.0).default("4"),
        count("passes", "most passes of the hierarchical search", "2").between(1.0, 100.0).default("2"),
        count("points", "points of a sweep, and of a surface along each parameter", "11")
            .between(3.0, 201.0)
            .default("11"),
        word::<Compared>("compare", "what is compared", "peaks").default(Compared::Peaks.word()),
        flag("slices", "whether peaks are compared in static slices instead of full passages", "true").default("true"),
        word::<Weights>("weights", "where weights come from", "shapes").default(Weights::Shapes.word()),
        flag("by_uncertainty", "whether errors are expressed in multiples of `uncertainty`", "false").default("false"),
        flag("posterior", "whether the posterior of the parameters is sampled", "false").default("false"),
        number("model_error", "scale of the model's own error, a share of the peaks; 0 for none", "0.1")
            .between(0.0, 1.0)
            .default("0.1"),
        number(
            "common_gain_deviation",
            "standard deviation of a gain that all channels share, a share of the response: axle loads as they are against those of \
             [train], the width that carries them, the share of a track; 0 where all of these are known exactly",
            "0.1",
        )
        .between(0.0, 0.5)
        .default("0.1"),
        count("samples", "effective samples of the posterior", "10000").between(100.0, 1_000_000.0).default("10000"),
        count("seed", "seed of starts, surrogate and posterior", "1").between(0.0, 9e15).default("1"),
    ],
};

/// Sections that say how to update a bridge, and are no part of it.
pub const UPDATE_SECTIONS: [&str; 4] = ["records", "channel", "parameter", "update"];
