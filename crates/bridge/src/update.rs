//! What a bridge file says of model updating: records, what ties their columns to sensors, parameters, searches.

use crate::card::{Section, joined};
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::path::Path;
use crate::tree::Table;
use crate::values::of_keys;

/// Model updating as a file asks for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Update {
    /// Where records are; none where readings of a load test are compared alone.
    pub records: Option<Records>,
    /// What is said of single channels.
    pub channels: Vec<Channel>,
    /// What is sought.
    pub parameters: Vec<Parameter>,
    /// How it is sought.
    pub plan: Plan,
}

of_keys! {
    /// Where records are and how they are made ready.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Records {
        pub place: String =
            text("a table (.csv), or a folder in which every table is a run; beside this file", "table-6.csv"),
        pub zero: bool = flag("whether the level before the train is subtracted", "true").default("true"),
        pub drift: bool =
            flag("whether the line between the levels before and after is subtracted", "false").default("false"),
        pub low_pass: Option<f64> = frequency(
            "frequency above which records are filtered, forward and backward so that nothing shifts in time; noise \
             raises a peak, which is the largest of many samples",
            "10 Hz",
        )
        .positive()
        .optional("as recorded"),
        pub align: Option<String> = text("the channel by which clocks are aligned", "crown displacement")
            .optional("the records' clock is that of [passage]: zero where the first axle starts"),
    } and {
        /// What that channel is laid on: the times at which axles pass its sensor, or its history in the start model.
        pub by_axles: bool => by_axles,
    }
}

of_keys! {
    /// What is said of one channel.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Channel {
        pub sensor: String = text("name of the sensor", "crown strain"),
        pub column: Option<String> = text("name of the column in the records", "SG 4").optional("the sensor's name"),
        pub reversed: bool = flag("whether the sign of the records is reversed", "false").default("false"),
        pub uncertainty: Option<f64> = number("standard deviation of one value, in mm, microstrain or MPa", "0.01")
            .positive()
            .optional("not known; needed by the posterior and by `by_uncertainty`"),
        pub weight: Option<f64> = number("its weight, where weights are given", "1.0")
            .positive()
            .optional("needed only where `weights` = \"given\""),
        pub left_out ("leave_out"): Option<String> =
            text("reason for which it is left out; it is still shown", "a gauge on a stone sees no opening")
                .optional("it is compared"),
    }
}

/// A quantity of the file that is sought between bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Its name in results.
    pub name: String,
    /// Its place in the file.
    pub path: Path,
    /// Unit of the numbers; empty for bare ones.
    pub unit: String,
    /// The file's own value.
    pub start: f64,
    /// Lower end of the range.
    pub lower: f64,
    /// Upper end of the range.
    pub upper: f64,
    /// Whether the range is divided evenly in the logarithm.
    pub logarithmic: bool,
}

impl Parameter {
    /// A value as the file would have it, with every digit.
    pub fn literal(&self, value: f64) -> String {
        if self.unit.is_empty() { format!("{value:?}") } else { format!("\"{value} {}\"", self.unit) }
    }
}

of_keys! {
    /// How parameters are sought.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Plan {
        pub search: Search = word::<Search>("which search", "modern").default(Search::Modern.word()),
        pub variant: Variant =
            word::<Variant>("reading of the hierarchical search", "printed").default(Variant::Printed.word()),
        pub start: Start = word::<Start>("where the hierarchical search begins", "means").default(Start::Means.word()),
        pub starts: u64 = count("starts of the modern search", "4").between(1.0, 1000.0).default("4"),
        pub passes: u64 = count("most passes of the hierarchical search", "2").between(1.0, 100.0).default("2"),
        pub points: u64 =
            count("points of a sweep, and of a surface along each parameter", "11").between(3.0, 201.0).default("11"),
        pub compare: Compared = word::<Compared>("what is compared", "peaks").default(Compared::Peaks.word()),
        pub slices: bool =
            flag("whether peaks are compared in static slices instead of full passages", "true").default("true"),
        pub weights: Weights = word::<Weights>("where weights come from", "shapes").default(Weights::Shapes.word()),
        pub by_uncertainty: bool =
            flag("whether errors are expressed in multiples of `uncertainty`", "false").default("false"),
        pub posterior: bool = flag("whether the posterior of the parameters is sampled", "false").default("false"),
        pub model_error: f64 = number("scale of the model's own error, a share of the peaks; 0 for none", "0.1")
            .between(0.0, 1.0)
            .default("0.1"),
        pub common_gain_deviation: f64 = number(
            "standard deviation of a gain that all channels share, a share of the response: axle loads as they are against those of \
             [train], the width that carries them, the share of a track; 0 where all of these are known exactly",
            "0.1",
        )
        .between(0.0, 0.5)
        .default("0.1"),
        pub samples: u64 =
            count("effective samples of the posterior", "10000").between(100.0, 1_000_000.0).default("10000"),
        pub seed: u64 = count("seed of starts, surrogate and posterior", "1").between(0.0, 9e15).default("1"),
    }
}

choice! {
    /// Searches for parameters.
    pub enum Search {
        /// the railway paper's search, by sweeps of one parameter and surfaces of two
        Hierarchical = "hierarchical",
        /// trust-region least squares from many starts
        Modern = "modern",
        /// evolutionary search (CMA-ES) over the whole ranges
        Referee = "referee",
        /// a plain gradient search from one start
        Gradient = "gradient",
        /// one after the other, with a table
        All = "all",
    }
}

choice! {
    /// Readings of the hierarchical search.
    pub enum Variant {
        /// the three cases as printed
        Printed = "printed",
        /// a decided descent to a bound freezes a parameter there
        AsPractised = "as-practised",
        /// one after the other, with a table
        Both = "both",
    }
}

choice! {
    /// Where the hierarchical search begins.
    pub enum Start {
        /// the values of this file
        Stated = "stated",
        /// the middle of every range
        Means = "means",
        /// all lower bounds, then all upper bounds
        Bounds = "bounds",
        /// means, then bounds
        All = "all",
    }
}

choice! {
    /// What is compared.
    pub enum Compared {
        /// signed peaks (eq. 3 of the paper), from static slices
        Peaks = "peaks",
        /// every value, by root mean square
        Histories = "histories",
    }
}

choice! {
    /// Where weights come from.
    pub enum Weights {
        /// squares of the shape correlation factors (eq. 4) at the start model
        Shapes = "shapes",
        /// all alike
        Equal = "equal",
        /// those of [[channel]]
        Given = "given",
    }
}

choice! {
    /// What the channel is laid on by which clocks are aligned.
    enum AlignedBy {
        /// its history in the start model
        Model = "model",
        /// the times at which axles pass its sensor
        Axles = "axles",
    }
}

pub(crate) static RECORDS: Section = Section {
    path: "records",
    doc: "Records of a train's passage that `extrados update` compares with. Their columns are named after the sensors.",
    fields: &joined::<6>(&[
        Records::CARDS,
        &[word::<AlignedBy>("align_by", "what that channel is aligned with", "model").default(AlignedBy::Model.word())],
    ]),
};

/// Whether clocks are aligned by the times at which axles pass.
fn by_axles(table: &Table<'_>, findings: &mut Findings) -> Option<bool> {
    Some(match table.read("align_by", findings)? {
        AlignedBy::Model => false,
        AlignedBy::Axles => true,
    })
}

pub(crate) static CHANNEL: Section = Section {
    path: "channel",
    doc: "Information on a channel of the records; sensors without a [[channel]] are compared as they are.",
    fields: Channel::CARDS,
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

pub(crate) static PARAMETER: Section = Section {
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

pub(crate) static UPDATE: Section =
    Section { path: "update", doc: "How `extrados update` searches for the parameters.", fields: Plan::CARDS };

/// Sections that say how to update a bridge, and are no part of it.
pub const UPDATE_SECTIONS: [&str; 4] = ["records", "channel", "parameter", "update"];
