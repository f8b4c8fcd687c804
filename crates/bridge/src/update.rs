//! What a bridge file says of model updating: records, what ties their columns to sensors, parameters, searches.

use crate::choice::choice;
use crate::path::Path;
use crate::values::of_keys;

/// Model updating as a file asks for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Update {
    /// Where records are.
    pub records: Records,
    /// What is said of single channels.
    pub channels: Vec<Channel>,
    /// What is sought.
    pub parameters: Vec<Parameter>,
    /// How it is sought.
    pub plan: Plan,
}

/// Where records are and how they are made ready.
#[derive(Debug, Clone, PartialEq)]
pub struct Records {
    /// A file, or a folder all of whose tables are runs, beside the bridge file.
    pub place: String,
    /// Whether the level before the train is taken off.
    pub zero: bool,
    /// Whether the line between the levels before and after the train is taken off.
    pub drift: bool,
    /// Frequency above which records are cut off [Hz]; none where they stay as recorded.
    pub low_pass: Option<f64>,
    /// Channel by which clocks are aligned; none where clocks are the model's.
    pub align: Option<String>,
    /// What that channel is laid on: the times at which axles pass its sensor, or its history in the start model.
    pub by_axles: bool,
}

of_keys! {
    /// What is said of one channel.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Channel {
        /// Name of its sensor.
        pub sensor: String,
        /// Name of its column in the records; the sensor's where not given.
        pub column: Option<String>,
        /// Whether the records count the other way.
        pub reversed: bool,
        /// Standard deviation of one measured value [mm, microstrain or MPa].
        pub uncertainty: Option<f64>,
        /// Weight, where weights are given.
        pub weight: Option<f64>,
        /// Why it takes no part.
        pub left_out: Option<String> = "leave_out",
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
        /// Which search.
        pub search: Search,
        /// Which reading of the published search.
        pub variant: Variant,
        /// Where the published search begins.
        pub start: Start,
        /// Starts of the modern search.
        pub starts: u64,
        /// Passes of the published search.
        pub passes: u64,
        /// Points of a single sweep, and of a surface along each parameter.
        pub points: u64,
        /// What is compared.
        pub compare: Compared,
        /// Whether peaks are looked for in static slices instead of full passages.
        pub slices: bool,
        /// Where weights come from.
        pub weights: Weights,
        /// Whether errors are counted in standard deviations of the measurement.
        pub by_uncertainty: bool,
        /// Whether the posterior is sampled.
        pub posterior: bool,
        /// Scale of the model's error as a share of the peaks, sought beside the parameters; zero for an exact model.
        pub model_error: f64,
        /// Standard deviation of the gain that all channels share; zero where loads and width are known exactly.
        pub common_gain_deviation: f64,
        /// Effective samples of the posterior.
        pub samples: u64,
        /// Seed of everything that is drawn.
        pub seed: u64,
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
