//! Runs and channels, in SI units.

use crate::{Done, Finding, Unit};

/// One sensor's record in one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// What it measures, "crown displacement"; sensors of one name on several lines across the barrel are sisters.
    pub name: String,
    /// The line across the barrel on which it sits: "upstream", "centre", "downstream"; empty where none is named.
    pub line: String,
    /// Unit of its cells.
    pub unit: Unit,
    /// Column of the table, counted from 1; 0 of a channel that was never in one.
    pub column: usize,
    /// Value at every time of the run [SI]; NaN where there is none.
    pub values: Vec<f64>,
    /// Decimals that its cells were printed with, the most of any; None where they had exponents or were never printed.
    pub decimals: Option<usize>,
    /// Why it is not used, if it is not.
    pub left_out: Option<String>,
}

impl Channel {
    /// Name and line: "crown displacement @ upstream".
    pub fn title(&self) -> String {
        title(&self.name, &self.line)
    }

    /// Whether it may be used.
    pub fn used(&self) -> bool {
        self.left_out.is_none()
    }

    /// Index of the value of largest size, the first of equals; None where there is no value.
    pub fn peak(&self) -> Option<usize> {
        let finite = (0..self.values.len()).filter(|k| self.values[*k].is_finite());
        finite.reduce(|best, k| if self.values[k].abs() > self.values[best].abs() { k } else { best })
    }
}

pub(crate) fn title(name: &str, line: &str) -> String {
    if line.is_empty() { name.to_owned() } else { format!("{name} @ {line}") }
}

/// One passage of a train: a clock and the channels that share it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recording {
    /// Its name; the file's where nothing else was said.
    pub name: String,
    /// Speed of the train [m/s], where it is known.
    pub speed: Option<f64>,
    /// What the file says where it was computed and not measured; stands wherever the record is shown.
    pub synthetic: Option<String>,
    /// Comment lines of the file, without their sign.
    pub notes: Vec<String>,
    /// Times [s].
    pub times: Vec<f64>,
    /// Line of the file at which each sample stands; 0 of a sample that was made by resampling.
    pub lines: Vec<u32>,
    /// Smallest step that the printed times can show [s]; 0 where it is not known.
    pub time_step_shown: f64,
    /// Channels, in the order of the columns.
    pub channels: Vec<Channel>,
}

impl Recording {
    /// Channels that may be used.
    pub fn used(&self) -> impl Iterator<Item = &Channel> {
        self.channels.iter().filter(|channel| channel.used())
    }

    /// The channel of that name and line.
    pub fn channel(&self, name: &str, line: &str) -> Option<&Channel> {
        self.channels.iter().find(|channel| channel.name == name && channel.line == line)
    }

    /// Mean step of the clock [s]; 0 of fewer than two samples.
    pub fn interval(&self) -> f64 {
        match self.times.as_slice() {
            [first, .., last] => (last - first) / (self.times.len() - 1) as f64,
            _ => 0.0,
        }
    }
}

/// Runs that were judged: what is used can be trusted as far as [`examine`](crate::examine) tells, what is not says why.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Series {
    /// The runs.
    pub runs: Vec<Recording>,
    /// Everything that was done to them, in order.
    pub done: Vec<Done>,
    /// Everything that was found in them.
    pub findings: Vec<Finding>,
}

impl Series {
    /// Channels that are not used: run, channel, reason.
    pub fn left_out(&self) -> Vec<(&str, String, &str)> {
        let all = self.runs.iter().flat_map(|run| run.channels.iter().map(move |channel| (run, channel)));
        let out = all.filter_map(|(run, channel)| {
            channel.left_out.as_deref().map(|reason| (run.name.as_str(), channel.title(), reason))
        });
        out.collect()
    }
}
