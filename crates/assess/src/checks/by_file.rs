//! What keeps the file's own factor on its loads (`adequacy_factor`) from showing strength, where all that was compared is met.

use super::verdict::Open;
use crate::evidence::Evidence;
use crate::record;
use outcome::checked::{Checked, Comparison, NotMade, Unit};
use outcome::collapse::Status;

/// The check of the loads of the file.
pub(super) const CODE: &str = "C201";

/// Everything that is open.
pub(super) fn open(a: &Evidence, checked: &[Checked]) -> Vec<Open> {
    let of_check = of_check(checked, CODE, "loads of the file not compared", "model_factor in [assess]");
    factor(a).into_iter().chain(of_check).collect()
}

/// What a check leaves open: that it was not made, or too little margin; `key` is where another model factor is written.
pub(super) fn of_check(checked: &[Checked], code: &str, not_made: &str, key: &str) -> Option<Open> {
    match &checked.iter().find(|one| one.code == code)?.outcome {
        Ok(found) => within(found, key),
        Err(why) => (why.left_out.is_none() && !why.failed).then(|| Open::new(not_made, why.why.clone())),
    }
}

/// Why the factor of the file shows no strength; none where it does.
pub(super) fn factor(a: &Evidence) -> Option<Open> {
    let limits = &a.asked.limits;
    let asked = limits.adequacy_factor?;
    if asked * limits.load_factor_included <= 1.0 {
        return Some(Open::new(
            format!(
                "a factor of {asked} on loads that carry a factor of {} gives no safety",
                limits.load_factor_included
            ),
            "write the factor of a rule as adequacy_factor, or load_factor_included where the forces of the file carry it, in [assess]",
        ));
    }
    limits
        .adequacy_source
        .is_none()
        .then(|| Open::new("no source of adequacy_factor", "write adequacy_source = \"document, clause\" in [assess]"))
}

/// What an analysis of loads of the file found, its factor and how it ended, beside the limit on it; none where no load makes a mechanism.
/// Strength is shown where the factor is not met, or met by as much as the model factor asks for.
pub(super) fn compared(
    a: &Evidence,
    limit: f64,
    load: &str,
    (found, status): (Option<f64>, Status),
    what: &str,
) -> Result<Option<Comparison>, NotMade> {
    let value = match (found, status) {
        (Some(factor), _) => factor,
        (None, Status::Locks) => return Ok(None),
        (None, Status::UnstableUnderSelfWeight) => 0.0,
        (None, status) => return Err(NotMade::failed(format!("{what} ended with {status}"))),
    };
    let needed = limit * a.asked.limits.model_factor.unwrap_or_else(record::model_factor);
    Ok(Some(Comparison {
        load_model: load.to_owned(),
        value,
        limit,
        unit: Unit::Ratio,
        utilisation: if value > 0.0 { limit / value } else { f64::MAX },
        strength: factor(a).is_none() && (value < limit || value >= needed),
        needed: (needed > limit).then_some(needed),
        ..Comparison::default()
    }))
}

/// What meets its limit by less than the uncertainty of the method asks for; `key` is where another model factor is written.
fn within(found: &[Comparison], key: &str) -> Option<Open> {
    let short =
        found.iter().filter_map(|one| Some((one, one.needed.filter(|needed| one.met() && one.value < *needed)?)));
    let list: Vec<String> =
        short.map(|(one, needed)| format!("{} {:.2} of {needed:.2}", one.load_model, one.value)).collect();
    (!list.is_empty()).then(|| {
        Open::new(
            format!("less margin than the uncertainty of the model requires: {}", list.join(", ")),
            format!(
                "model factor {}, {}; write {key} if a source has another",
                record::model_factor(),
                record::words()
            ),
        )
    })
}
