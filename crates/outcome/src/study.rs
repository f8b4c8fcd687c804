//! An analysis repeated over ranges of a bridge's quantities: what each run gave.

mod design;
mod sensitivity;

pub use design::{Design, Variation, count, runs};
pub use sensitivity::{Extreme, Sensitivity, Trend, sensitivity};

use crate::published::list;
use crate::published::vary::{numbers, quantities, values};
use crate::wire::published;
use crate::words::words;
use bridge::vary::{Setting, Varied};
use serde::{Deserialize, Serialize};

/// The load that is carried: the headline of `extrados collapse`.
pub const CARRIED: &str = "headline_kn_per_m";

/// What one run gave. That it did not converge, or did not stand, is an outcome too.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Outcome {
    /// How it ended.
    pub status: String,
    /// Numbers by name, with the unit at the end of the name; those that the run did not find are left out.
    pub numbers: Vec<(String, f64)>,
    /// Codes of what a reader should look at.
    pub warnings: Vec<String>,
    /// Why there is no more to tell, where the analysis could not be set up.
    pub message: Option<String>,
}

impl Outcome {
    /// A number of this name.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().find(|(known, _)| known == name).map(|(_, number)| *number)
    }
}

words! {
    /// A command that can be repeated.
    pub enum Command {
        /// `extrados collapse`.
        Collapse = "collapse",
        /// `extrados collapse --sweep`.
        Sweep = "sweep",
    }
}

published! {
    /// A run and what it gave.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Row |row, study: &Study, number: usize| {
        = run: usize = number,
        = varied: Option<String> = row.run.varied.map(|quantity| study.path(quantity)),
        = values: Object = values(study, row),
        /// Which values it had.
        pub run: Variation [kept],
        = status: String = &row.outcome.status,
        = outcomes: Object = numbers(&row.outcome),
        = warnings: Vec<String> = &row.outcome.warnings,
        = message?: Option<String> = row.outcome.message.as_ref(),
        /// What it gave.
        pub outcome: Outcome [kept],
        /// How long it took when it was computed [s].
        pub seconds: f64,
        /// Whether it was taken from an earlier command.
        pub cached: bool,
    }

    /// All runs of one command.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Study |study| {
        /// Name of the bridge.
        pub bridge: String,
        /// The command that was repeated.
        pub command: Command,
        /// By which method the file's own plan has it analyse.
        pub method: bridge::Method,
        /// Which analysis the file's own plan has it make.
        pub analysis: bridge::Analysis,
        /// One at a time, or all against all.
        pub design: Design,
        /// Name of the number that figures and sensitivities are about.
        pub outcome: String,
        /// Changes of that number up to this are the search's and not the bridge's.
        pub resolution: f64 as outcome_resolution,
        /// What was varied: `quantity`, `unit`, `own`, `values`.
        pub quantities: Vec<Varied> = quantities(study),
        /// The bridge as its file has it, as one of the rows.
        = baseline: Option<Object> = study.baseline().map(|row| row.object(study, 0)),
        /// Every run in the order of the design: `values`, `status`, `outcomes` and so on.
        = rows: Vec<Object> =
            list(study.rows.iter().enumerate().skip(1), |(number, row)| row.object(study, number)),
        /// What each quantity does to the number: `low`, `high`, `elasticity`, `trend` and so on.
        = sensitivity: Vec<Object> = list(&sensitivity(study), |one| one.object(study)),
        /// How many runs there are, the bridge as its file has it among them.
        = runs: usize = study.rows.len(),
        /// How many of them were taken from an earlier command.
        = runs_from_cache: usize = study.rows.iter().filter(|row| row.cached).count(),
        /// The bridge as its file has it, then every run in the order of the design.
        pub rows: Vec<Row> [kept],
    }
}

impl Study {
    /// The bridge as its file has it.
    pub fn baseline(&self) -> Option<&Row> {
        self.rows.first()
    }

    /// The path of a quantity.
    pub(crate) fn path(&self, quantity: usize) -> String {
        self.quantities[quantity].path.to_string()
    }

    /// The leading number of a row.
    pub fn number(&self, row: &Row) -> Option<f64> {
        row.outcome.number(&self.outcome)
    }

    /// The value of a quantity in a row; none where it is the file's own and the file gives none.
    pub fn setting(&self, row: &Row, quantity: usize) -> Option<&Setting> {
        let varied = self.quantities.get(quantity)?;
        match row.run.choice.get(quantity)? {
            Some(value) => varied.values.get(*value),
            None => varied.own.as_ref(),
        }
    }

    /// Rows in which this quantity alone was varied, in the order of its values.
    pub fn rows_of(&self, quantity: usize) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.run.varied == Some(quantity))
    }

    /// Names of all numbers, in the order in which runs gave them.
    pub fn numbers(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for (name, _) in self.rows.iter().flat_map(|row| &row.outcome.numbers) {
            if !names.contains(&name.as_str()) {
                names.push(name);
            }
        }
        names
    }
}

#[cfg(test)]
mod tests;
