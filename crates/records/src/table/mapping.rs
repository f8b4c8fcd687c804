//! What the caller says of a file: which column is which channel, and how it is written.

use super::dialect::Dialect;

/// A column of the table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// By its heading: the whole of it, or the name in it.
    Heading(String),
    /// By its place, counted from 1.
    Number(usize),
}

/// What the caller says of a column; what it leaves open comes from the heading.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Which column.
    pub source: Source,
    /// Name of the channel; empty takes the heading's.
    pub name: String,
    /// Line across the barrel; None takes the heading's.
    pub line: Option<String>,
    /// Unit of the cells; None takes the heading's.
    pub unit: Option<String>,
    /// 1, or -1 where the sensor's positive side is the channel's negative one.
    pub sign: f64,
    /// Factor on the cells, a calibration [-].
    pub scale: f64,
}

impl Column {
    /// A column as it is.
    pub fn new(source: Source, name: &str) -> Column {
        Column { source, name: name.to_owned(), line: None, unit: None, sign: 1.0, scale: 1.0 }
    }
}

/// What becomes of columns that the mapping does not name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Others {
    /// They are read by their headings.
    #[default]
    Read,
    /// They are passed over, and a note says so.
    PassOver,
}

/// Which column is which channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Mapping {
    /// Whether a line of headings stands above the data. Without one, columns go by their numbers.
    pub headed: bool,
    /// The clock; None looks for a heading such as "time [s]".
    pub time: Option<Column>,
    /// Channels.
    pub channels: Vec<Column>,
    /// The other columns.
    pub others: Others,
}

impl Default for Mapping {
    fn default() -> Mapping {
        Mapping { headed: true, time: None, channels: Vec::new(), others: Others::Read }
    }
}

/// What the caller says of a file that is read.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Name of the run, commonly the file's; a comment line `# run: slow` in the file counts more.
    pub name: String,
    /// Speed of the train [m/s]; counts more than a comment line `# speed: 45 km/h`.
    pub speed: Option<f64>,
    /// Which column is which channel.
    pub mapping: Mapping,
    /// How the table is written.
    pub dialect: Dialect,
}
