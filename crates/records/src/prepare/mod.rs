//! Records made ready for comparison, each step in a file of its own and listed in words.

mod align;
mod cut;
mod filter;
mod level;
mod log;
mod pace;
mod resample;

pub use align::{Align, Reference};
pub use cut::Cut;
pub use filter::noise_bandwidth;
pub use level::{Detrend, Zero};

use crate::Series;

/// What is done to every run, in the order of the fields.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Preparation {
    /// What is taken as zero.
    pub zero: Zero,
    /// Which drift is taken off.
    pub detrend: Detrend,
    /// Frequency above which a record is cut off [Hz]: Butterworth of second order, forward and backward, so that no peak is
    /// moved; its amplitude there is 0.707 of what it was.
    pub low_pass: Option<f64>,
    /// Rate of the clock that all runs get [Hz].
    pub rate: Option<f64>,
    /// What the clock's zero is.
    pub align: Align,
    /// Which part is kept.
    pub cut: Cut,
}

/// Prepares the channels that are used. What could not be done is a finding.
pub fn prepare(series: Series, preparation: &Preparation) -> Series {
    let mut log = series;
    let mut runs = std::mem::take(&mut log.runs);
    for run in runs.iter_mut().filter(|run| run.used().next().is_some()) {
        // Levels are seen in the quiet start and end, which stand in the run as it was recorded.
        level::zero(run, preparation.zero, &mut log);
        level::detrend(run, preparation.detrend, &mut log);
        let own_rate = 1.0 / run.interval().max(f64::MIN_POSITIVE);
        let folds = preparation.rate.filter(|rate| *rate < 0.999 * own_rate);
        if preparation.low_pass.is_some() || folds.is_some() {
            resample::regular(run, &mut log);
        }
        if let Some(cutoff) = preparation.low_pass {
            filter::low_pass(run, cutoff, "", &mut log);
        }
        if let Some(rate) = folds.filter(|rate| preparation.low_pass.is_none_or(|cutoff| cutoff > 0.5 * rate)) {
            filter::low_pass(run, 0.4 * rate, ", so that nothing above half the new rate folds back", &mut log);
        }
        if let Some(rate) = preparation.rate {
            resample::to_rate(run, rate, &mut log);
        }
        align::align(run, &preparation.align, &mut log);
        cut::cut(run, preparation.cut, &mut log);
    }
    Series { runs, ..log }
}
