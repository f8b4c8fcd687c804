//! The peak of every channel of every run.

use crate::signal::least_count;
use crate::{Series, Unit};
use serde::{Deserialize, Serialize};

/// The peak of a channel in a run: its value of largest size, with its sign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// Run.
    pub run: String,
    /// Speed of the train [m/s], where it is known.
    pub speed: Option<f64>,
    /// Channel.
    pub name: String,
    /// Its line across the barrel; empty where none is named.
    pub line: String,
    /// Unit in which it is shown.
    pub unit: Unit,
    /// Value [SI].
    pub value: f64,
    /// When [s].
    pub time: f64,
    /// Line of the file; 0 of a sample that was made by resampling.
    pub file_line: usize,
    /// Least count of the channel [SI], 0 where it is not known: peaks nearer than that cannot be told apart.
    pub least_count: f64,
    /// Whether the run was computed and not measured.
    pub synthetic: bool,
}

/// Peaks of several runs.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PeakTable {
    /// In the order of the runs, then of their channels.
    pub peaks: Vec<Peak>,
}

/// Picks the peak of every used channel. Records should be prepared before: what is off zero is in the peak.
pub fn peaks(series: &Series) -> PeakTable {
    let mut peaks = Vec::new();
    for run in &series.runs {
        for channel in run.used() {
            let Some(at) = channel.peak() else { continue };
            let printed = channel.decimals.map(|digits| channel.unit.to_si(0.1_f64.powi(digits.min(15) as i32)).abs());
            peaks.push(Peak {
                run: run.name.clone(),
                speed: run.speed,
                name: channel.name.clone(),
                line: channel.line.clone(),
                unit: channel.unit,
                value: channel.values[at],
                time: run.times[at],
                file_line: run.lines.get(at).map_or(0, |line| *line as usize),
                // Of printed records the smallest step between neighbours, of others unknown.
                least_count: printed.map_or(0.0, |printed| least_count(&channel.values).max(printed)),
                synthetic: run.synthetic.is_some(),
            });
        }
    }
    PeakTable { peaks }
}

impl PeakTable {
    /// Names of the channels, in order of appearance.
    pub(crate) fn names(&self) -> Vec<&str> {
        distinct(self.peaks.iter().map(|peak| peak.name.as_str()))
    }

    /// Peaks of one channel in each run, lines averaged: lines of one run are no repeats of it. All but the value is that of the first line.
    pub(crate) fn by_run(&self, name: &str) -> Vec<Peak> {
        let mut runs: Vec<(Peak, usize)> = Vec::new();
        for peak in self.peaks.iter().filter(|peak| peak.name == name && peak.value.is_finite()) {
            match runs.iter_mut().find(|(run, _)| run.run == peak.run) {
                Some((run, count)) => {
                    run.value += peak.value;
                    *count += 1;
                }
                None => runs.push((peak.clone(), 1)),
            }
        }
        runs.iter_mut().for_each(|(run, count)| run.value /= *count as f64);
        runs.into_iter().map(|(run, _)| run).collect()
    }

    /// Least and greatest speed of each class [m/s], ascending: a class holds speeds up to `ratio` times its least.
    pub(crate) fn speed_classes(&self, ratio: f64) -> Vec<[f64; 2]> {
        let mut speeds: Vec<f64> = self.peaks.iter().filter_map(|peak| peak.speed).filter(|v| v.is_finite()).collect();
        speeds.sort_unstable_by(f64::total_cmp);
        let mut classes: Vec<[f64; 2]> = Vec::new();
        for speed in speeds {
            match classes.last_mut() {
                Some(class) if speed <= ratio * class[0] => class[1] = speed,
                _ => classes.push([speed, speed]),
            }
        }
        classes
    }
}

/// Each name once, in order of appearance.
pub(crate) fn distinct<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = Vec::new();
    for name in names {
        if !seen.contains(&name) {
            seen.push(name);
        }
    }
    seen
}
