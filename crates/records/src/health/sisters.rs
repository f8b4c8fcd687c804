//! Units that slipped by a thousand and signs that are swapped: seen against expected peaks, or against the same channel on
//! other lines and in other runs.

use super::judge::Judge;
use super::smooth;
use crate::Recording;
use crate::signal::{loaded, median};

/// Ratios of peaks that are taken for a slip by 1000: no speed and no line across the barrel changes a peak two-hundredfold.
const SLIP: [f64; 2] = [200.0, 5000.0];
/// How much the larger side must exceed the other for a history to have a sign.
const SIDED: f64 = 1.3;

/// What is compared of a channel.
struct Sister {
    run: usize,
    channel: usize,
    at: usize,
    /// Signed value of largest size, from the level before the train [SI].
    peak: f64,
    /// Whether one side is clearly the larger.
    sided: bool,
}

pub(super) fn examine(runs: &mut [Recording], judge: &mut Judge) {
    let all = sisters(runs);
    let mut names: Vec<String> = all.iter().map(|one| runs[one.run].channels[one.channel].name.clone()).collect();
    names.sort();
    names.dedup();
    for name in names {
        let group: Vec<&Sister> = all.iter().filter(|one| runs[one.run].channels[one.channel].name == name).collect();
        slips(runs, &group, judge);
        let whole: Vec<&Sister> = group.into_iter().filter(|one| runs[one.run].channels[one.channel].used()).collect();
        signs(runs, &whole, judge);
    }
}

fn sisters(runs: &[Recording]) -> Vec<Sister> {
    let mut all = Vec::new();
    for (r, run) in runs.iter().enumerate() {
        let smooth = smooth(run);
        let loaded = loaded(run, &smooth);
        for (c, values) in smooth.iter().enumerate().filter(|(c, _)| run.channels[*c].used()) {
            let Some(values) = values.as_ref().filter(|values| !values.is_empty()) else { continue };
            let level = loaded.level(values);
            let side = |sign: f64| values.iter().map(|value| sign * (value - level)).fold(0.0, f64::max);
            let (up, down) = (side(1.0), side(-1.0));
            let peak = if up > down { up } else { -down };
            let at = values.iter().position(|value| value - level == peak).unwrap_or(0);
            all.push(Sister { run: r, channel: c, at, peak, sided: up.max(down) > SIDED * up.min(down) });
        }
    }
    all
}

fn slips(runs: &mut [Recording], group: &[&Sister], judge: &mut Judge) {
    let sizes: Vec<f64> = group.iter().map(|one| one.peak.abs()).collect();
    for (k, one) in group.iter().enumerate() {
        let unit = runs[one.run].channels[one.channel].unit;
        let expected = judge.expected(&runs[one.run].channels[one.channel]).map(f64::abs);
        let mut others: Vec<f64> = sizes.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, size)| *size).collect();
        let (reference, whose) = match expected {
            Some(peak) => (peak, "expected"),
            None if others.is_empty() => continue,
            None => (median(&mut others), "the peak of the same channel on other lines or in other runs"),
        };
        let ratio = one.peak.abs() / reference;
        let slipped = |ratio: f64| (SLIP[0]..SLIP[1]).contains(&ratio);
        if !(slipped(ratio) || slipped(1.0 / ratio)) {
            continue;
        }
        let (by, than) = if ratio > 1.0 { (ratio, "times") } else { (1.0 / ratio, "times less than") };
        let message = format!(
            "its peak of {} is {by:.0} {than} the {} that is {whose}: the unit seems to have slipped by 1000",
            unit.words(one.peak),
            unit.words(reference),
        );
        let help = "correct the unit in the heading or the scale in the mapping";
        judge.fault(&mut runs[one.run], Some(one.channel), "R044", Some([one.at; 2]), [&message, help]);
    }
}

fn signs(runs: &mut [Recording], group: &[&Sister], judge: &mut Judge) {
    let positive = group.iter().filter(|one| one.sided && one.peak > 0.0).count();
    let negative = group.iter().filter(|one| one.sided && one.peak < 0.0).count();
    for one in group.iter().filter(|one| one.sided) {
        let unit = runs[one.run].channels[one.channel].unit;
        let against = match judge.expected(&runs[one.run].channels[one.channel]) {
            Some(expected) if expected * one.peak < 0.0 => format!("where {} is expected", unit.words(expected)),
            Some(_) => continue,
            None => {
                let (same, other) = if one.peak > 0.0 { (positive, negative) } else { (negative, positive) };
                if other == 0 || same > other {
                    continue;
                }
                format!("while {other} of its {} sisters have the other sign", same + other - 1)
            }
        };
        let message = format!("its peak is {} {against}: the sign seems to be swapped", unit.words(one.peak));
        let help = "see to the sensor's direction, then give the column a sign of -1 in the mapping";
        judge.fault(&mut runs[one.run], Some(one.channel), "R045", Some([one.at; 2]), [&message, help]);
    }
}
