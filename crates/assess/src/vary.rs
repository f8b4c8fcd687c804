//! An analysis repeated over ranges of a bridge's quantities: which runs there are, what they gave, what matters most.

use crate::analysis::{self, AnalysisError, Places};
use bridge::Bridge;
use mechanics::watch::Watch;
use outcome::published;
use outcome::study::{CARRIED, Command, Outcome, Study};
use outcome::warning::Warning;
use structure::discretise::bridge_length;

/// An analysis that can be repeated: from a bridge with its plan to numbers with names.
#[derive(Clone, Copy)]
pub struct Analysis {
    /// The command that it is.
    pub command: Command,
    /// Numbers that a reader asks for first, most wanted first.
    pub leading: &'static [&'static str],
    /// Numbers that the analysis finds as the two ends of a bracket: the answer is no sharper than their distance.
    pub brackets: &'static [[&'static str; 2]],
    /// Makes it.
    pub run: fn(&Bridge, &mut dyn Watch) -> Result<Outcome, AnalysisError>,
}

/// The load, the thickness or the support movement that makes a mechanism, as the plan says; what is carried leads.
pub const COLLAPSE: Analysis = Analysis {
    command: Command::Collapse,
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
        Ok(outcome(found.status.word(), published::collapse_numbers(&found), &found.warnings))
    },
};

/// What came of an analysis.
fn outcome(status: &str, numbers: Vec<(String, f64)>, warnings: &[Warning]) -> Outcome {
    let warnings = warnings.iter().map(|warning| warning.code().to_owned()).collect();
    Outcome { status: status.to_owned(), numbers, warnings, message: None }
}

/// Vehicles of the file's `[sweep]` moved over the bridge, or else its loads.
pub const SWEEP: Analysis = Analysis {
    command: Command::Sweep,
    leading: &["adequacy_factor", "load_factor"],
    brackets: &[["adequacy_upper_bound", "adequacy_lower_bound"]],
    run: sweep,
};

/// A sweep: vehicles where the file has [sweep], its loads otherwise.
fn sweep(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Outcome, AnalysisError> {
    let Some(plan) = &bridge.sweep else { return loads(bridge, watch) };
    // A second opinion on one position is for one bridge.
    let plan = bridge::SweepPlan { discrete_elements: false, ..plan.clone() };
    let bridge = Bridge { sweep: Some(plan), ..bridge.clone() };
    let found = analysis::vehicle_sweep(&bridge, watch)?;
    let governing = found.governing.and_then(|k| found.vehicles.get(k));
    let bound = |k: usize| governing.and_then(|v| v.bounds).map(|bounds| bounds[k]);
    let numbers = [
        ("adequacy_factor", governing.and_then(|v| v.adequacy)),
        ("adequacy_lower_bound", bound(0)),
        ("adequacy_upper_bound", bound(1)),
        ("governing_position_m", governing.and_then(|v| v.case.as_ref()).map(|case| case.position)),
    ];
    let each = found.vehicles.iter().map(|v| (format!("adequacy_factor_of_{}", v.code), v.adequacy));
    let numbers = numbers.into_iter().map(|(name, number)| (name.to_owned(), number)).chain(each);
    Ok(outcome(found.status().word(), finite(numbers), &found.warnings))
}

/// Steps over the bridge of a sweep of the file's loads, as `collapse --sweep` has them.
const STEPS: f64 = 100.0;

fn loads(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Outcome, AnalysisError> {
    let found = analysis::sweep(bridge, Places::Every(bridge_length(bridge) / STEPS), true, watch)?;
    let governing = found.governing.and_then(|k| found.points.get(k));
    let load = governing.and_then(|point| point.collapse_load).map(|load| load / 1e3);
    let numbers = [
        ("load_factor", governing.and_then(|point| point.load_factor)),
        ("last_stable_load_kn_per_m", load),
        ("collapse_load_kn_per_m", load),
        ("governing_position_m", governing.map(|point| point.position)),
    ];
    let numbers = numbers.into_iter().map(|(name, number)| (name.to_owned(), number));
    Ok(outcome(found.ended().word(), finite(numbers), &found.warnings))
}

/// Numbers that there are.
fn finite(numbers: impl Iterator<Item = (String, Option<f64>)>) -> Vec<(String, f64)> {
    numbers.filter_map(|(name, number)| Some((name, number.filter(|number| number.is_finite())?))).collect()
}

/// Numbers that only a sweep finds.
pub const OF_SWEEPS: [&str; 3] = ["adequacy_factor", "load_factor", "governing_position_m"];

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
mod tests {
    use super::*;

    #[test]
    fn the_leading_number_is_one_that_there_is() {
        let with = |names: &[&str]| Outcome {
            numbers: names.iter().map(|name| ((*name).to_owned(), 1.0)).collect(),
            ..Outcome::default()
        };
        let (load, stable) = (with(&["collapse_load_kn_per_m"]), with(&["last_stable_load_kn_per_m"]));
        let all = with(&["collapse_load_kn_per_m", "last_stable_load_kn_per_m", CARRIED]);
        assert_eq!(leading(&COLLAPSE, &[&all]), Some(CARRIED), "what is carried stands before what is not");
        let moved = with(&["collapse_movement_m", "last_stable_movement_m"]);
        assert_eq!(leading(&COLLAPSE, &[&moved]), Some("last_stable_movement_m"));
        assert_eq!(leading(&COLLAPSE, &[&load, &stable]), Some("collapse_load_kn_per_m"));
        assert_eq!(leading(&COLLAPSE, &[&stable, &load]), Some("last_stable_load_kn_per_m"));
        assert_eq!(leading(&COLLAPSE, &[&with(&[]), &load]), Some("collapse_load_kn_per_m"));
        assert_eq!(leading(&COLLAPSE, &[]), None);
    }
}
