//! Do lines across the barrel differ, or may one line stand for the whole width?

use super::anova::{Test, blocks, columns, half_width};
use super::{Answer, LEVEL, MATTERS};
use crate::peaks::{Peak, PeakTable, distinct};
use crate::signal::range;
use crate::{Recording, Series};
use serde::{Deserialize, Serialize};

/// What the lines of one channel say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LineTest {
    /// Channel.
    pub name: String,
    /// Lines, and the mean peak on each [SI].
    pub lines: Vec<(String, f64)>,
    /// Runs in which every line has a peak.
    pub runs: usize,
    /// Greatest less least of those means, as a share of their mean [-].
    pub difference: f64,
    /// F test of lines in blocks of runs; None of a single run.
    pub test: Option<Test>,
    /// Least likeness of a line's history to the mean of all lines [-]: 1 less the root mean square of the difference over the
    /// root mean square of the mean; None without histories.
    pub likeness: Option<f64>,
    /// Answer of this channel.
    pub answer: Answer,
    /// In words.
    pub words: String,
}

/// Whether lines across the barrel differ.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlaneStrain {
    /// Answer over all channels.
    pub answer: Answer,
    /// Each channel that was measured on two lines at least.
    pub channels: Vec<LineTest>,
    /// In words.
    pub words: String,
}

/// Judges whether lines across the barrel differ; with histories, also by their shapes.
pub fn plane_strain(table: &PeakTable, series: Option<&Series>) -> PlaneStrain {
    let tests: Vec<LineTest> = table.names().iter().filter_map(|name| lines(table, series, name)).collect();
    let any = |answer: Answer| tests.iter().any(|test| test.answer == answer);
    let answer = match () {
        () if tests.is_empty() => Answer::CannotTell,
        () if any(Answer::Seen) => Answer::Seen,
        () if any(Answer::CannotTell) => Answer::CannotTell,
        () if any(Answer::SeenButSmall) => Answer::SeenButSmall,
        () => Answer::NotSeen,
    };
    let matters = 100.0 * MATTERS;
    let verdict = match answer {
        Answer::NotSeen => {
            format!("lines across the barrel differ by less than {matters:.0} %: plane strain may be assumed")
        }
        Answer::SeenButSmall => {
            format!(
                "lines across the barrel differ beyond their scatter, by less than {matters:.0} %: plane strain may be assumed"
            )
        }
        Answer::Seen => "lines across the barrel differ: one line does not stand for the width".to_owned(),
        Answer::CannotTell if tests.is_empty() => {
            "no channel was measured on two lines: nothing is known of plane strain".to_owned()
        }
        Answer::CannotTell => "these records cannot tell whether lines across the barrel differ".to_owned(),
    };
    let details: Vec<&str> = tests.iter().map(|test| test.words.as_str()).collect();
    let colon = if details.is_empty() { "" } else { "; " };
    let words = format!("{verdict}{colon}{}", details.join("; "));
    PlaneStrain { answer, channels: tests, words }
}

fn lines(table: &PeakTable, series: Option<&Series>, name: &str) -> Option<LineTest> {
    let own: Vec<&Peak> = table.peaks.iter().filter(|peak| peak.name == name && peak.value.is_finite()).collect();
    let lines = distinct(own.iter().map(|peak| peak.line.as_str()));
    if lines.len() < 2 {
        return None;
    }
    let row = |run: &str| -> Option<Vec<f64>> {
        let of = |line: &&str| own.iter().find(|peak| peak.run == run && peak.line == **line).map(|peak| peak.value);
        lines.iter().map(of).collect()
    };
    let rows: Vec<Vec<f64>> = distinct(own.iter().map(|peak| peak.run.as_str())).into_iter().filter_map(row).collect();
    let runs = rows.len();
    let means: Vec<f64> =
        (0..lines.len()).map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / runs.max(1) as f64).collect();
    let size = (means.iter().sum::<f64>() / means.len() as f64).abs();
    let apart = range(&means);
    let difference = if size > 0.0 { apart / size } else { 0.0 };
    let least = own.iter().map(|peak| peak.least_count).fold(0.0, f64::max);
    let test = blocks(&rows, least / 12.0_f64.sqrt());
    let likeness = series.and_then(|series| likeness(&series.runs, name));
    let (answer, how) = match test {
        Some(test) => {
            let error = test.scatter * (2.0 / runs as f64).sqrt();
            let half = half_width(error, test.freedom[1], LEVEL);
            (Answer::of(test.p < LEVEL, apart + half < MATTERS * size), test.words())
        }
        None if runs == 0 => (Answer::CannotTell, "no run has a peak on every line".to_owned()),
        // One run has no scatter: two least counts are what rounding may make of equal peaks.
        None if difference < MATTERS => (Answer::NotSeen, "of a single run, without a test".to_owned()),
        None if apart <= 2.0 * least => (Answer::CannotTell, "no more than two least counts".to_owned()),
        None => (Answer::CannotTell, "of a single run, whose scatter is not known".to_owned()),
    };
    let alike = likeness.map_or(String::new(), |likeness| format!("; histories alike to {:.1} %", 100.0 * likeness));
    let words = format!("{name}: {} lines differ by {:.1} % ({how}){alike}", lines.len(), 100.0 * difference);
    let lines = lines.into_iter().map(str::to_owned).zip(means).collect();
    Some(LineTest { name: name.to_owned(), lines, runs, difference, test, likeness, answer, words })
}

/// Least likeness of a line's history to the mean of its run's lines, over all runs.
fn likeness(runs: &[Recording], name: &str) -> Option<f64> {
    let mut least: Option<f64> = None;
    for run in runs {
        let lines: Vec<&Vec<f64>> =
            run.used().filter(|channel| channel.name == name).map(|channel| &channel.values).collect();
        if lines.len() < 2 || run.times.is_empty() {
            continue;
        }
        let mean = columns(&lines);
        let whole: f64 = mean.iter().map(|value| value * value).sum();
        for line in lines {
            let rest: f64 = line.iter().zip(&mean).map(|(a, b)| (a - b).powi(2)).sum();
            let alike = if whole > 0.0 { 1.0 - (rest / whole).sqrt() } else { 0.0 };
            least = Some(least.map_or(alike, |least| least.min(alike)));
        }
    }
    least
}
