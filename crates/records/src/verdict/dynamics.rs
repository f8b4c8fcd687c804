//! Do peaks depend on the speed of the train?

use super::anova::{Test, blocks, columns, half_width, mean, one_way};
use super::{Answer, LEVEL, MATTERS, SAME_SPEED};
use crate::peaks::{Peak, PeakTable};
use crate::signal::range;
use serde::{Deserialize, Serialize};

/// What the peaks of one channel say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ChannelTest {
    /// Channel.
    pub name: String,
    /// Greatest less least of the means at each speed, as a share of their mean [-].
    pub spread: f64,
    /// One-way F test over speeds; None without repeats at any speed.
    pub test: Option<Test>,
    /// Its p times the number of channels tested, at most 1: with many channels one is odd by chance.
    pub p_adjusted: Option<f64>,
    /// Answer of this channel alone.
    pub answer: Answer,
    /// In words.
    pub words: String,
}

/// Whether peaks depend on the speed of the train.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Dynamics {
    /// Answer over all channels.
    pub answer: Answer,
    /// Speeds [m/s], ascending.
    pub speeds: Vec<f64>,
    /// Factor on the peaks of all channels at each speed against the slowest, and the half-width of its 90 % interval [-]; empty
    /// where too few channels have a peak at every speed.
    pub factors: Vec<[f64; 2]>,
    /// F test of that common factor: logarithms of peaks, speeds in blocks of channels.
    pub common: Option<Test>,
    /// Each channel by itself.
    pub channels: Vec<ChannelTest>,
    /// In words.
    pub words: String,
}

/// Peaks of one channel, grouped by speed.
struct Grouped {
    name: String,
    groups: Vec<Vec<f64>>,
    /// Deviation that rounding alone makes [SI].
    rounding: f64,
}

/// Judges whether peaks depend on speed. Lines across the barrel are averaged first, for lines of one run are no repeats of it.
pub fn dynamics(table: &PeakTable) -> Dynamics {
    let classes = table.speed_classes(SAME_SPEED);
    let speeds: Vec<f64> = classes.iter().map(|[low, high]| 0.5 * (low + high)).collect();
    let grouped: Vec<Grouped> = table.names().iter().map(|name| group(name, &table.by_run(name), &classes)).collect();
    let tested = grouped.iter().filter(|one| one_way(&one.groups, one.rounding).is_some()).count();
    let channels: Vec<ChannelTest> = grouped.iter().map(|one| channel(one, tested)).collect();
    let (common, factors) = common(&grouped, speeds.len()).map_or((None, Vec::new()), |(t, f)| (Some(t), f));
    let (answer, words) = overall(&speeds, common, &factors, &channels);
    let mut unknown: Vec<&str> =
        table.peaks.iter().filter(|peak| peak.speed.is_none()).map(|p| p.run.as_str()).collect();
    unknown.sort_unstable();
    unknown.dedup();
    let words = match unknown.len() {
        0 => words,
        count => format!("{words}; runs without a speed are not counted ({count}): {}", unknown.join(", ")),
    };
    Dynamics { answer, speeds, factors, common, channels, words }
}

fn group(name: &str, runs: &[Peak], classes: &[[f64; 2]]) -> Grouped {
    let of = |class: &[f64; 2]| -> Vec<f64> {
        let inside = runs.iter().filter(|run| run.speed.is_some_and(|v| class[0] <= v && v <= class[1]));
        inside.map(|run| run.value).collect()
    };
    let least = runs.iter().map(|run| run.least_count).fold(0.0, f64::max);
    // A value rounded to a step is uniform within it: its variance is the step's square over twelve.
    Grouped { name: name.to_owned(), groups: classes.iter().map(of).collect(), rounding: least / 12.0_f64.sqrt() }
}

fn channel(one: &Grouped, tested: usize) -> ChannelTest {
    let groups: Vec<&Vec<f64>> = one.groups.iter().filter(|group| !group.is_empty()).collect();
    let means: Vec<f64> = groups.iter().map(|group| mean(group)).collect();
    let size = mean(&means).abs();
    let spread = if size > 0.0 { range(&means) / size } else { 0.0 };
    let test = one_way(&one.groups, one.rounding);
    let p_adjusted = test.map(|test| (test.p * tested as f64).min(1.0));
    let (answer, why) = match test {
        None if groups.len() < 2 => (Answer::CannotTell, "peaks at one speed only".to_owned()),
        None => (Answer::CannotTell, "no speed was run twice, so that its scatter is not known".to_owned()),
        Some(test) => {
            let seen = p_adjusted.is_some_and(|p| p < LEVEL);
            let excluded = excluded(&groups, &means, size, test);
            let words = if tested > 1 { format!("{} (times {tested} channels)", test.words()) } else { test.words() };
            (Answer::of(seen, excluded), words)
        }
    };
    let words = format!("{}: means at {} speeds spread by {:.1} %; {why}", one.name, means.len(), 100.0 * spread);
    ChannelTest { name: one.name.clone(), spread, test, p_adjusted, answer, words }
}

/// Whether an effect that matters is excluded between the slowest and every other speed.
fn excluded(groups: &[&Vec<f64>], means: &[f64], size: f64, test: Test) -> bool {
    (1..means.len()).all(|k| {
        let error = test.scatter * (1.0 / groups[0].len() as f64 + 1.0 / groups[k].len() as f64).sqrt();
        let half = half_width(error, test.freedom[1], LEVEL);
        (means[k] - means[0]).abs() + half < MATTERS * size
    })
}

/// The factor that speed puts on all peaks alike: channels with a peak of one sign at every speed are blocks.
fn common(grouped: &[Grouped], speeds: usize) -> Option<(Test, Vec<[f64; 2]>)> {
    let rows: Vec<Vec<f64>> = grouped.iter().filter_map(|one| logarithms(one, speeds)).collect();
    let test = blocks(&rows, 0.0)?;
    let error = test.scatter * (2.0 / rows.len() as f64).sqrt();
    let half = half_width(error, test.freedom[1], LEVEL);
    let means = columns(&rows);
    let factors = (0..speeds).map(|k| [(means[k] - means[0]).exp(), if k == 0 { 0.0 } else { half.exp() - 1.0 }]);
    Some((test, factors.collect()))
}

fn logarithms(one: &Grouped, speeds: usize) -> Option<Vec<f64>> {
    let means: Vec<f64> = one.groups.iter().filter(|group| !group.is_empty()).map(|group| mean(group)).collect();
    let sided = means.iter().all(|mean| *mean > 0.0) || means.iter().all(|mean| *mean < 0.0);
    (means.len() == speeds && sided).then(|| means.iter().map(|mean| mean.abs().ln()).collect())
}

fn overall(speeds: &[f64], common: Option<Test>, factors: &[[f64; 2]], channels: &[ChannelTest]) -> (Answer, String) {
    if speeds.len() < 2 {
        let words = "runs of two speeds at least are needed to judge dynamics".to_owned();
        return (Answer::CannotTell, words);
    }
    let margin = (1.0 + MATTERS).ln();
    let within = |[factor, half]: &[f64; 2]| factor.ln().abs() + (1.0 + half).ln() < margin;
    let of_all = common.map(|test| Answer::of(test.p < LEVEL, factors.iter().skip(1).all(within)));
    let any = |answer: Answer| channels.iter().any(|channel| channel.answer == answer);
    let judged = channels.iter().any(|channel| channel.test.is_some());
    let every = judged && channels.iter().filter(|c| c.test.is_some()).all(|c| c.answer == Answer::NotSeen);
    let answer = match of_all {
        _ if any(Answer::Seen) => Answer::Seen,
        Some(Answer::Seen) => Answer::Seen,
        Some(Answer::SeenButSmall) => Answer::SeenButSmall,
        _ if any(Answer::SeenButSmall) => Answer::SeenButSmall,
        Some(Answer::NotSeen) => Answer::NotSeen,
        _ if every => Answer::NotSeen,
        _ => Answer::CannotTell,
    };
    let matters = 100.0 * MATTERS;
    let verdict = match answer {
        Answer::NotSeen => {
            format!("no dynamic effect is seen, and one of {matters:.0} % on all channels would have been")
        }
        Answer::SeenButSmall => format!("peaks depend on speed, by less than {matters:.0} %"),
        Answer::Seen => "peaks depend on speed beyond their scatter".to_owned(),
        Answer::CannotTell => "these peaks cannot tell whether there is a dynamic effect".to_owned(),
    };
    let factors: Vec<String> = factors
        .iter()
        .zip(speeds)
        .skip(1)
        .map(|([factor, half], speed)| format!("{factor:.3} ± {half:.3} at {:.0} km/h", 3.6 * speed))
        .collect();
    let test = common.map_or(String::new(), |test| {
        format!("; factor on all peaks against {:.0} km/h: {}; {}", 3.6 * speeds[0], factors.join(", "), test.words())
    });
    let odd: Vec<&str> = channels
        .iter()
        .filter(|channel| matches!(channel.answer, Answer::Seen | Answer::SeenButSmall))
        .map(|channel| channel.words.as_str())
        .collect();
    let odd = if odd.is_empty() { String::new() } else { format!("; {}", odd.join("; ")) };
    (answer, format!("{verdict}{test}{odd}"))
}
