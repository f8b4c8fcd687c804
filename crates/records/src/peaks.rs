//! The peak of every channel of every run, and their means and spread.

use crate::series::title;
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

/// Mean and spread of the peaks of one channel, over runs of one speed or over the runs of one line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpeedGroup {
    /// Channel.
    pub name: String,
    /// Line; None where lines were averaged first.
    pub line: Option<String>,
    /// Mean speed of the runs [m/s]; None where speeds were put together.
    pub speed: Option<f64>,
    /// Runs.
    pub count: usize,
    /// Mean [SI].
    pub mean: f64,
    /// Standard deviation between runs [SI]; None of a single run.
    pub deviation: Option<f64>,
    /// Least and greatest [SI].
    pub range: [f64; 2],
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
                least_count: least_count_of(&channel.values, printed),
                synthetic: run.synthetic.is_some(),
            });
        }
    }
    PeakTable { peaks }
}

/// The step that a record was rounded to: of printed records the smallest step between neighbours, of others unknown.
fn least_count_of(values: &[f64], printed: Option<f64>) -> f64 {
    printed.map_or(0.0, |printed| least_count(values).max(printed))
}

/// Peaks of one channel in one run, lines averaged: lines of one run are no repeats of it.
#[derive(Debug, Clone)]
pub(crate) struct RunPeak {
    pub run: String,
    pub speed: Option<f64>,
    pub value: f64,
    pub least_count: f64,
}

impl PeakTable {
    /// Names of the channels, in order of appearance.
    pub(crate) fn names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        for peak in &self.peaks {
            if !names.contains(&peak.name.as_str()) {
                names.push(peak.name.as_str());
            }
        }
        names
    }

    pub(crate) fn by_run(&self, name: &str) -> Vec<RunPeak> {
        let mut runs: Vec<(RunPeak, usize)> = Vec::new();
        for peak in self.peaks.iter().filter(|peak| peak.name == name && peak.value.is_finite()) {
            let found = runs.iter_mut().find(|(run, _)| run.run == peak.run);
            match found {
                Some((run, count)) => {
                    run.value += peak.value;
                    *count += 1;
                }
                None => {
                    let Peak { run, speed, value, least_count, .. } = peak.clone();
                    runs.push((RunPeak { run, speed, value, least_count }, 1));
                }
            }
        }
        runs.iter_mut().for_each(|(run, count)| run.value /= *count as f64);
        runs.into_iter().map(|(run, _)| run).collect()
    }

    /// Mean and spread of each channel at each speed, lines averaged within a run. Speeds nearer than `ratio` are one class.
    pub fn by_speed(&self, ratio: f64) -> Vec<SpeedGroup> {
        let classes = self.speed_classes(ratio);
        let mut groups = Vec::new();
        for name in self.names() {
            let runs = self.by_run(name);
            for class in &classes {
                let inside = |run: &&RunPeak| run.speed.is_some_and(|speed| class[0] <= speed && speed <= class[1]);
                let of: Vec<&RunPeak> = runs.iter().filter(inside).collect();
                let speeds: Vec<f64> = of.iter().filter_map(|run| run.speed).collect();
                let values: Vec<f64> = of.iter().map(|run| run.value).collect();
                let speed = (!speeds.is_empty()).then(|| speeds.iter().sum::<f64>() / speeds.len() as f64);
                groups.extend(group(name, None, speed, &values));
            }
        }
        groups
    }

    /// Mean and spread of each channel on each line, over all runs.
    pub fn by_line(&self) -> Vec<SpeedGroup> {
        let mut groups = Vec::new();
        for name in self.names() {
            let own: Vec<&Peak> = self.peaks.iter().filter(|peak| peak.name == name).collect();
            let mut lines: Vec<&str> = own.iter().map(|peak| peak.line.as_str()).collect();
            lines.dedup();
            let mut seen: Vec<&str> = Vec::new();
            for line in lines {
                if !seen.contains(&line) {
                    seen.push(line);
                    let values: Vec<f64> = own.iter().filter(|peak| peak.line == line).map(|peak| peak.value).collect();
                    groups.extend(group(name, Some(line.to_owned()), None, &values));
                }
            }
        }
        groups
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

    /// A table in text: run, speed, channel, peak, time, place in the file.
    pub fn words(&self) -> String {
        let mut text = String::from("run, speed [km/h], channel, peak, unit, time [s], line of the file, made by\n");
        for peak in &self.peaks {
            let speed = peak.speed.map_or(String::new(), |speed| format!("{:.1}", 3.6 * speed));
            text += &format!(
                "{}, {speed}, {}, {}, {}, {:.4}, {}, {}\n",
                peak.run,
                title(&peak.name, &peak.line),
                peak.unit.of_si(peak.value),
                peak.unit.symbol,
                peak.time,
                peak.file_line,
                if peak.synthetic { "computation (synthetic)" } else { "measurement" },
            );
        }
        text
    }
}

fn group(name: &str, line: Option<String>, speed: Option<f64>, values: &[f64]) -> Option<SpeedGroup> {
    let count = values.len();
    if count == 0 {
        return None;
    }
    let mean = values.iter().sum::<f64>() / count as f64;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let deviation = (count > 1).then(|| (squares / (count - 1) as f64).sqrt());
    let range = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| [l.min(*v), h.max(*v)]);
    Some(SpeedGroup { name: name.to_owned(), line, speed, count, mean, deviation, range })
}
