//! The part of a record that is kept.

use crate::signal::range;
use crate::{Recording, Series};
use findings::words::counted;

/// Which part of a record is kept.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Cut {
    /// All of it.
    #[default]
    Whole,
    /// From the first to the last time at which any channel is farther from zero than a share of its range, and a margin on
    /// either side: the time that the train is on the span.
    Answering {
        /// Share of the range [-].
        share: f64,
        /// Margin [s].
        margin: f64,
    },
    /// Between two times [s], after alignment.
    Between([f64; 2]),
}

pub(super) fn cut(run: &mut Recording, cut: Cut, log: &mut Series) {
    let between = match cut {
        Cut::Whole => return,
        Cut::Between(between) => Some(between),
        Cut::Answering { share, margin } => answering(run, share).map(|[a, b]| [a - margin, b + margin]),
    };
    let kept = between.map(|[from, to]| {
        let first = run.times.partition_point(|time| *time < from);
        first..run.times.partition_point(|time| *time <= to).max(first)
    });
    let Some(kept) = kept.filter(|kept| kept.len() >= 2) else {
        let message = "the part to be kept holds no two samples; nothing was cut off".to_owned();
        log.could_not(run, "R064", message, "name times within the run");
        return;
    };
    let n = run.times.len();
    let (start, end) = (kept.start, n - kept.end);
    run.times = run.times[kept.clone()].to_vec();
    run.lines = run.lines[kept.clone()].to_vec();
    for channel in &mut run.channels {
        channel.values = channel.values[kept.clone()].to_vec();
    }
    let (Some(from), Some(to)) = (run.times.first().copied(), run.times.last().copied()) else { return };
    let why = match cut {
        Cut::Answering { share, margin } => {
            format!(
                "where any channel answers with more than {:.1} % of its range, and {margin} s around",
                100.0 * share
            )
        }
        _ => "as asked".to_owned(),
    };
    let what = format!(
        "cut to {from:.4} s to {to:.4} s, {why}: {} taken off the start, {end} off the end",
        counted(start, "sample")
    );
    log.did(&run.name, "", what);
}

fn answering(run: &Recording, share: f64) -> Option<[f64; 2]> {
    let ends = run.used().filter_map(|channel| {
        let threshold = share * range(&channel.values);
        let answers = |value: &f64| value.abs() > threshold;
        let first = channel.values.iter().position(answers)?;
        let last = channel.values.iter().rposition(answers)?;
        Some([run.times[first], run.times[last]])
    });
    ends.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
}
