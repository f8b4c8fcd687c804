//! What can be trusted: clocks and channels judged, bad ones left out with their reason.

mod clock;
mod drift;
mod flat;
mod held;
mod judge;
mod missing;
mod sisters;
mod spike;

pub use judge::{Accept, Expected, LeaveOut, Scrutiny};

use crate::signal::{bridged, loaded, smoothed};
use crate::{Recording, Series};
use findings::words::counted;
use judge::Judge;

/// Fewer samples than these are no record of a passage.
const FEWEST: usize = 20;

/// Judges runs. Channels that cannot be trusted are left out and say why; short gaps are bridged and spikes taken out, and the
/// list of what was done says so. Runs as they come out can be used.
pub fn examine(runs: Vec<Recording>, scrutiny: &Scrutiny) -> Series {
    let mut judge = Judge { scrutiny, findings: Vec::new(), done: Vec::new() };
    let mut runs = runs;
    distinct_names(&mut runs, &mut judge);
    judge.sort_out_by_hand(&mut runs);
    for run in &mut runs {
        if run.times.len() < FEWEST {
            let message = format!("the run has {}, too few to judge", counted(run.times.len(), "sample"));
            judge.fault(run, None, "R030", None, [&message, "see why the file is so short"]);
        }
        equal_lengths(run);
        clock::examine(run, &mut judge);
        channels(run, &mut judge);
    }
    sisters::examine(&mut runs, &mut judge);
    for run in &mut runs {
        missing::bridge(run, &mut judge);
    }
    Series { runs, done: judge.done, findings: judge.findings }
}

/// Every channel by itself, and beside those of its run.
fn channels(run: &mut Recording, judge: &mut Judge) {
    for channel in 0..run.channels.len() {
        missing::examine(run, channel, judge);
    }
    let smooth = smooth(run);
    let loaded = loaded(run, &smooth);
    // One reason to leave a channel out is enough; dead ones go first, for others are compared with those that move.
    for look in [flat::examine, spike::examine, held::examine, drift::examine] {
        for channel in 0..smooth.len() {
            if run.channels[channel].used() {
                look(run, channel, &smooth, loaded, judge);
            }
        }
    }
}

/// The channels of a run, smoothed.
pub(crate) fn smooth(run: &Recording) -> Vec<Option<Vec<f64>>> {
    run.channels.iter().map(|channel| bridged(&channel.values).map(|values| smoothed(&values))).collect()
}

/// Runs of one name would be taken for lines of one run: the later ones get a number.
fn distinct_names(runs: &mut [Recording], judge: &mut Judge) {
    for k in 1..runs.len() {
        let name = runs[k].name.clone();
        let taken = |name: &str| runs[..k].iter().any(|run| run.name == name);
        if !taken(&name) {
            continue;
        }
        let fresh = (2..).map(|number| format!("{name} ({number})")).find(|name| !taken(name)).unwrap_or_default();
        let message = format!("another run has the same name; this one is called `{fresh}`");
        judge.warn(&runs[k], None, "R037", None, [&message, "give each run a name of its own: `# run: slow 2`"]);
        runs[k].name = fresh;
    }
}

/// A run that the caller made may have channels longer or shorter than its clock; what is missing is missing.
fn equal_lengths(run: &mut Recording) {
    let n = run.times.len();
    run.lines.resize(n, 0);
    run.channels.iter_mut().for_each(|channel| channel.values.resize(n, f64::NAN));
}
