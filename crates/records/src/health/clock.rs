//! Clocks: times that repeat, go back, or change their step; rows that are missing.

use super::judge::{Judge, LONGEST_GAP};
use crate::Recording;
use crate::signal::median;
use findings::words::{counted, verb};

/// More repeated times than this share of the rows, and the clock is too coarse or stands still.
const REPEATED: f64 = 0.05;
/// More times out of order or repeated than these are no accident.
const OUT_OF_ORDER: usize = 3;
/// Ratio of steps from which a clock is another one; loggers are set to 50, 100, 200, 250 Hz, of which no two are nearer.
const OTHER_CLOCK: f64 = 1.2;
/// A step longer than this multiple of its neighbours has a gap in it.
const GAP: f64 = 1.5;

const SUMMER_TIME: &str = "the clock was set by an hour, as summer time begins or ends: let the logger keep one time throughout, or write its zone behind each stamp";

/// Whether a step is an hour, but for what passes between two samples.
fn is_set_by_an_hour(step: f64) -> bool {
    (step.abs() - 3600.0).abs() < 2.0
}

/// Judges the clock of a run and takes out rows that repeat a time.
pub(super) fn examine(run: &mut Recording, judge: &mut Judge) {
    if !in_order(run, judge) {
        return;
    }
    let steps: Vec<f64> = run.times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    if steps.is_empty() {
        return;
    }
    let shown = run.time_step_shown;
    let changes = changes(&run.times, &steps, shown);
    let one_clock = changes.is_empty();
    for (at, before, after) in changes {
        let message = format!(
            "the clock changes its step from {before:.6} s to {after:.6} s: two clocks, of which one may be wrong"
        );
        let help = "split the file where the clock changes, or accept R032 and say why both steps are right";
        judge.fault(run, None, "R032", Some([at; 2]), [&message, help]);
    }
    gaps(run, &steps, one_clock, judge);
}

/// Takes out rows with repeated times and single times out of order. False where the clock goes back.
fn in_order(run: &mut Recording, judge: &mut Judge) -> bool {
    let times = &run.times;
    let n = times.len();
    let mut kept: Vec<usize> = Vec::with_capacity(n);
    let (mut repeated, mut strays) = (Vec::new(), Vec::new());
    let mut back = None;
    for k in 0..n {
        let Some(&last) = kept.last() else {
            kept.push(k);
            continue;
        };
        if times[k] > times[last] {
            kept.push(k);
        } else if times[k] == times[last] {
            repeated.push(k);
        } else if times.get(k + 1).is_some_and(|next| *next > times[last]) {
            strays.push(k);
        } else if kept.len() >= 2
            && times[k] > times[kept[kept.len() - 2]]
            && times.get(k + 1).is_none_or(|t| *t > times[k])
        {
            strays.push(last);
            kept.pop();
            kept.push(k);
        } else {
            back = Some((k, times[last]));
            break;
        }
    }
    if back.is_none() && strays.len() > OUT_OF_ORDER {
        back = Some((strays[0], times[strays[0].saturating_sub(1)]));
    }
    if let Some((at, last)) = back {
        let message = format!("the time goes back from {last:.4} s to {:.4} s: two clocks", times[at]);
        let help = if is_set_by_an_hour(times[at] - last) { SUMMER_TIME } else { "give each clock a file of its own" };
        judge.fault(run, None, "R031", Some([at; 2]), [&message, help]);
        return false;
    }
    if repeated.len() > OUT_OF_ORDER && repeated.len() as f64 > REPEATED * n as f64 {
        let share = times.chunk_by(|a, b| a == b).map(<[f64]>::len).max().unwrap_or(0);
        let shown = match run.time_step_shown {
            0.0 => "the clock stands still".to_owned(),
            1.0 => "times show whole seconds".to_owned(),
            step => format!("times show steps of {step} s"),
        };
        let message = format!(
            "{} of {n} rows {} the time above: {shown}, and up to {share} rows share one",
            repeated.len(),
            verb(repeated.len(), "repeats", "repeat")
        );
        let help = "let the logger write fractions of a second, or replace the column by \"time [s]\", the row number over the sampling rate";
        judge.fault(run, None, "R033", Some([repeated[0]; 2]), [&message, help]);
        return false;
    }
    for &at in &repeated {
        let same = run.channels.iter().all(|channel| {
            let pair = [channel.values[at - 1], channel.values[at]];
            pair[0] == pair[1] || (pair[0].is_nan() && pair[1].is_nan())
        });
        let values = if same { "the same values" } else { "other values" };
        let message = format!("the time {:.4} s is repeated with {values}; the row is left out", run.times[at]);
        judge.warn(run, None, "R033", Some([at; 2]), [&message, "see whether the logger wrote a row twice"]);
    }
    for &at in &strays {
        let message = format!("the time {:.4} s stands out of order; the row is left out", run.times[at]);
        judge.warn(run, None, "R034", Some([at; 2]), [&message, "correct the time of the row"]);
    }
    if kept.len() < n {
        run.times = kept.iter().map(|k| run.times[*k]).collect();
        run.lines = kept.iter().map(|k| run.lines[*k]).collect();
        for channel in &mut run.channels {
            channel.values = kept.iter().map(|k| channel.values[*k]).collect();
        }
    }
    true
}

/// Mean of the middle half: neither a few gaps nor the rounding of printed times moves it much.
fn middle_mean(steps: &[f64]) -> f64 {
    let mut sorted = steps.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let quarter = sorted.len() / 4;
    let middle = &sorted[quarter..sorted.len() - quarter];
    middle.iter().sum::<f64>() / middle.len() as f64
}

/// Samples at which the step of the clock changes, with the steps before and after.
fn changes(times: &[f64], steps: &[f64], shown: f64) -> Vec<(usize, f64, f64)> {
    let n = times.len();
    let width = (n / 6).clamp(8, 25);
    let mut found: Vec<(usize, f64, f64, f64)> = Vec::new();
    for k in width..n.saturating_sub(width) {
        let (a, b) = (times[k] - times[k - width], times[k + width] - times[k]);
        if a.max(b) < 1.1 * a.min(b) {
            continue;
        }
        let (before, after) = (middle_mean(&steps[k - width..k]), middle_mean(&steps[k..k + width]));
        let ratio = (after / before).max(before / after);
        // Of printed times, half the steps may be rounded up and half down.
        if ratio < OTHER_CLOCK || (after - before).abs() < 2.0 * shown / width as f64 {
            continue;
        }
        match found.last_mut() {
            Some(last) if k - last.0 <= width => {
                // The ratio is the same over some samples; the change lies where the plain means differ most.
                let sharpness = (b / a).max(a / b);
                if sharpness > last.3 {
                    *last = (k, before, after, sharpness);
                }
            }
            _ => found.push((k, before, after, (b / a).max(a / b))),
        }
    }
    found.into_iter().map(|(at, before, after, _)| (at, before, after)).collect()
}

/// Step of a clock: the middle one of the means of fifty steps, which rounding does not move and gaps hardly reach.
fn usual_step(times: &[f64]) -> f64 {
    let width = 50.min(times.len() - 1);
    let mean = |k: usize| (times[k + width] - times[k]) / width as f64;
    median(&mut (0..times.len() - width).step_by(width).map(mean).collect::<Vec<f64>>())
}

/// Rows that are missing between two times.
fn gaps(run: &mut Recording, steps: &[f64], one_clock: bool, judge: &mut Judge) {
    let usual = usual_step(&run.times);
    let shown = run.time_step_shown;
    // Printed times are rounded only where the step is no multiple of what they can show.
    let counts = usual / shown;
    let rounded = if shown > 0.0 && (counts - counts.round()).abs() > 1e-3 { shown } else { 0.0 };
    let width = 12;
    let mut long: Option<(Option<[usize; 2]>, String)> = None;
    for (k, &step) in steps.iter().enumerate() {
        let local = if one_clock {
            usual
        } else {
            middle_mean(&steps[k.saturating_sub(width)..(k + width + 1).min(steps.len())])
        };
        if step <= GAP * local + rounded {
            continue;
        }
        let missing = (step / local).round() as usize - 1;
        let spot = Some([k, k + 1]);
        let times = format!("{:.4} s to {:.4} s", run.times[k], run.times[k + 1]);
        let message = format!("{} {} missing from {times}", counted(missing, "sample"), verb(missing, "is", "are"));
        if missing <= LONGEST_GAP {
            judge.warn(run, None, "R035", spot, [&format!("{message}; bridged by straight lines"), ""]);
        } else if long.is_none() {
            long = Some((spot, message));
        } else {
            judge.warn(run, None, "R035", spot, [&message, "see the first gap of the run"]);
        }
    }
    if let Some((spot, message)) = long {
        let message = format!("{message}, more than {LONGEST_GAP}");
        let set = steps.iter().any(|step| is_set_by_an_hour(*step));
        let help = "cut the file so that the passage has no gap, or accept R035 and say why the gap does not matter";
        let help = if set { SUMMER_TIME } else { help };
        judge.fault(run, None, "R035", spot, [&message, help]);
    }
}
