//! An analysis repeated over ranges of a bridge's quantities: which runs there are, what they gave, what matters most.

mod design;
mod sensitivity;
mod sweep;

pub use design::{Design, Run, count, runs};
pub use sensitivity::{Extreme, Sensitivity, Trend, sensitivity};

use crate::analysis::{self, AnalysisError};
use crate::wire;
use bridge::Bridge;
use mechanics::watch::Watch;

pub use bridge::path::Path;
pub use bridge::vary::{Setting, Varied};
pub use bridge::{Analysis as AnalysisKind, Method as MethodKind};

/// An analysis that can be repeated: from a bridge with its plan to numbers with names.
#[derive(Clone, Copy)]
pub struct Analysis {
    /// What it is called.
    pub name: &'static str,
    /// Numbers that a reader asks for first, most wanted first.
    pub leading: &'static [&'static str],
    /// Numbers that the analysis finds as the two ends of a bracket: the answer is no sharper than their distance.
    pub brackets: &'static [[&'static str; 2]],
    /// Makes it.
    pub run: fn(&Bridge, &mut dyn Watch) -> Result<Outcome, AnalysisError>,
}

/// The load that is carried: the headline of `extrados collapse`.
pub const CARRIED: &str = "headline_kn_per_m";

/// The load, the thickness or the support movement that makes a mechanism, as the plan says; what is carried leads.
pub const COLLAPSE: Analysis = Analysis {
    name: "collapse",
    leading: &[
        "minimum_thickness_m",
        "last_stable_movement_m",
        "collapse_movement_m",
        CARRIED,
        "last_stable_load_kn_per_m",
        "collapse_load_kn_per_m",
    ],
    brackets: &[
        ["collapse_load_kn_per_m", "last_stable_load_kn_per_m"],
        ["collapse_movement_m", "last_stable_movement_m"],
        ["minimum_thickness_factor", "thickness_factor_that_falls"],
    ],
    run: |bridge, watch| {
        let found = analysis::collapse(bridge, None, watch)?;
        Ok(Outcome {
            status: found.status.word().to_owned(),
            numbers: wire::collapse_numbers(&found),
            warnings: found.warnings.iter().map(|warning| warning.code.to_owned()).collect(),
            message: None,
        })
    },
};

/// Vehicles of the file's `[sweep]` moved over the bridge, or else its loads.
pub const SWEEP: Analysis = Analysis {
    name: "sweep",
    leading: &["adequacy_factor", "load_factor"],
    brackets: &[["adequacy_upper_bound", "adequacy_lower_bound"]],
    run: sweep::run,
};

/// Numbers that only a sweep finds.
pub const OF_SWEEPS: [&str; 3] = ["adequacy_factor", "load_factor", "governing_position_m"];

/// What one run gave. That it did not converge, or did not stand, is an outcome too.
#[derive(Debug, Clone, PartialEq, Default)]
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

/// A run and what it gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Which values it had.
    pub run: Run,
    /// What it gave.
    pub outcome: Outcome,
    /// How long it took when it was computed [s].
    pub seconds: f64,
    /// Whether it was taken from an earlier command.
    pub cached: bool,
}

/// All runs of one command.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Name of the bridge.
    pub bridge: String,
    /// The command that was repeated.
    pub command: &'static str,
    /// Which analysis the file's own plan has it make.
    pub analysis: bridge::Analysis,
    /// By which method, likewise.
    pub method: bridge::Method,
    /// One at a time, or all against all.
    pub design: Design,
    /// Name of the number that figures and sensitivities are about.
    pub outcome: String,
    /// Changes of that number up to this are the search's and not the bridge's.
    pub resolution: f64,
    /// What was varied.
    pub quantities: Vec<Varied>,
    /// The bridge as its file has it, then every run in the order of the design.
    pub rows: Vec<Row>,
}

impl Study {
    /// The method in words.
    pub fn method_in_words(&self) -> &'static str {
        match self.method {
            bridge::Method::Dem => "discrete elements",
            bridge::Method::Limit => "limit analysis",
            bridge::Method::Fe => "finite elements",
        }
    }

    /// The bridge as its file has it.
    pub fn baseline(&self) -> Option<&Row> {
        self.rows.first()
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

/// How sharp a number of the file's own bridge is: the bracket that it is an end of, zero where it is none.
pub fn resolution(analysis: &Analysis, study: &Study) -> f64 {
    // What is carried is the last stable load, or a limit load below it, which is no coarser.
    let outcome = if study.outcome == CARRIED { "last_stable_load_kn_per_m" } else { study.outcome.as_str() };
    let pair = analysis.brackets.iter().find(|pair| pair.contains(&outcome));
    let ends = pair.zip(study.baseline()).map(|(pair, own)| pair.map(|name| own.outcome.number(name)));
    match ends {
        Some([Some(a), Some(b)]) => (a - b).abs(),
        _ => 0.0,
    }
}

/// The number that a study is about unless it is told: the first wanted one that the file's own bridge gives, or else any
/// run.
pub fn leading(analysis: &Analysis, outcomes: &[&Outcome]) -> Option<&'static str> {
    let has = |outcome: &Outcome, name: &str| outcome.number(name).is_some();
    let own = analysis.leading.iter().find(|name| outcomes.first().is_some_and(|outcome| has(outcome, name)));
    let any = || analysis.leading.iter().find(|name| outcomes.iter().any(|outcome| has(outcome, name)));
    own.or_else(any).copied()
}

#[cfg(test)]
mod tests;
