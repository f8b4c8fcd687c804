//! What keeps the rule of `[sweep]` from being met, where all that was compared is: load cases that were left out, factors without
//! safety, and what the rule asks of the file.

use super::by_file;
use super::verdict::Open;
use crate::coverage;
use crate::evidence::Evidence;
use crate::record;
use findings::words::in_rows;
use outcome::checked::Checked;
use rules::Confidence;

/// The check of vehicles under a rule.
pub(super) const CODE: &str = "C204";

/// Everything that is open.
pub(super) fn open(a: &Evidence, checked: &[Checked]) -> Vec<Open> {
    let key = "a model factor that was read in its source, in rule_file of [sweep]";
    let of_check = by_file::of_check(checked, CODE, "vehicles not compared", key);
    let mut list: Vec<Open> = of_check.into_iter().chain(assumed_loads(a)).collect();
    let Some(found) = coverage::of(a) else { return list };
    if !found.left_out.is_empty() {
        list.push(Open::new(
            format!("load cases of {} left out", found.name),
            format!("add {} to vehicles of [sweep]", found.left_out.join(", ")),
        ));
    }
    if !found.without_safety.is_empty() {
        let told: Vec<String> = found.without_safety.iter().map(|(code, factor)| format!("{code} {factor}")).collect();
        list.push(Open::new(
            format!("live loads without safety: {}", told.join(", ")),
            "write the live load factor of the rule, with its source, or leave [[under]] of the vehicle file away",
        ));
    }
    list.extend(found.lacks.into_iter().map(|[what, write]| Open::new(what, write)));
    list
}

/// Vehicles whose loads or distances nobody read, carried or not.
fn assumed_loads(a: &Evidence) -> Option<Open> {
    let facts = a.facts.vehicles.made()?;
    let assumed = facts.vehicles.iter().filter(|one| one.loads_confidence == Confidence::Assumed);
    let assumed: Vec<&str> = assumed.map(|one| one.code.as_str()).collect();
    (!assumed.is_empty()).then(|| {
        Open::new(
            format!("axle loads or distances of {} assumed", in_rows(&assumed)),
            "write those of the loading diagram into a file of vehicle_files in [sweep]",
        )
    })
}

/// The adequacy factor that a verdict needs: 1 under a standard, whose factors cover its own method; what tests ask for under an engineer's own
/// rule whose model factor nobody read, beyond the one that the adequacy factors hold; and the same where the file asks for it.
pub(super) fn needed(a: &Evidence) -> f64 {
    let of_tests = |model: f64| (record::model_factor() / model.max(f64::MIN_POSITIVE)).max(1.0);
    match coverage::of(a) {
        Some(rule) if a.asked.limits.model_factor_of_tests => of_tests(rule.model),
        Some(rule) if !rule.library && !rule.model_is_sourced => of_tests(rule.model),
        _ => 1.0,
    }
}
