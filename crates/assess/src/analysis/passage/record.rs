//! A passage as a logger would have written it: a synthetic record with stated noise, labelled as such.

use outcome::passage::{Measurand, Passage};
use records::{Exact, Noise, Recording, Unit, synthesise};

/// What a logger does to one kind of channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Step to which values are rounded [SI]; 0 leaves every digit.
    pub least_count: f64,
    /// Standard deviation of normal noise, added before rounding [SI].
    pub deviation: f64,
}

impl Scatter {
    /// Neither noise nor rounding.
    pub const NONE: Scatter = Scatter { least_count: 0.0, deviation: 0.0 };

    /// Noise of one least count: an amplifier with much less noise would be given a finer one.
    pub const fn of_least_count(least_count: f64) -> Scatter {
        Scatter { least_count, deviation: least_count }
    }
}

/// How a record is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Logger {
    /// Sampling rate [Hz]; None keeps the times that were computed.
    pub rate: Option<f64>,
    /// Displacements, openings and sliding [m].
    pub displacement: Scatter,
    /// Strains [-].
    pub strain: Scatter,
    /// Seed: the same one gives the same record.
    pub seed: u64,
}

impl Logger {
    /// The histories as they were computed.
    pub const NONE: Logger = Logger { rate: None, displacement: Scatter::NONE, strain: Scatter::NONE, seed: 1 };

    fn scatter(&self, quantity: Measurand) -> Scatter {
        match quantity.recorded() {
            records::Dimension::Length => self.displacement,
            records::Dimension::Strain => self.strain,
            // Noise of nothing else is known; no amplifier measures stresses.
            _ => Scatter::NONE,
        }
    }
}

impl Default for Logger {
    /// The amplifier of the railway paper: 200 Hz, 0.01 mm and 0.05 microstrain.
    fn default() -> Logger {
        Logger {
            rate: Some(200.0),
            displacement: Scatter::of_least_count(1e-5),
            strain: Scatter::of_least_count(0.05e-6),
            seed: 1,
        }
    }
}

/// The record of a passage. `name` is the run's, `made_by` what computed it, for the label.
pub fn record(passage: &Passage, name: &str, made_by: &str, logger: &Logger) -> Recording {
    let exact = passage.channels.iter().map(|channel| {
        let scatter = logger.scatter(channel.quantity);
        Exact {
            name: channel.name.clone(),
            line: String::new(),
            unit: Unit::named(channel.quantity.unit()).unwrap_or_else(|| Unit::usual(channel.quantity.recorded())),
            values: channel.values.clone(),
            least_count: scatter.least_count,
            deviation: scatter.deviation,
        }
    });
    let exact: Vec<Exact> = exact.collect();
    let Passage { bridge, train, analysis, .. } = passage;
    let origin = format!("{made_by} ({bridge}, train {train}, {analysis} analysis, self-weight taken off)");
    let noise = Noise { rate: logger.rate, seed: logger.seed, origin };
    synthesise(name, Some(passage.speed), &passage.times, &exact, &noise)
}

#[cfg(test)]
mod tests;
