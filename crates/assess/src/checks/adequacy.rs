//! Adequacy factor at ultimate.

use super::by_file;
use super::check::{Check, Probe, limit, of};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C201",
    keys: ["load", "assess.adequacy_factor"],
    title: "adequacy factor",
    clause: "factor on loads at collapse",
    text: "The least factor on the loads of the file at which the bridge becomes a mechanism, by limit \
           analysis, over all positions and every group of neighbouring axles: an axle on the far side is \
           favourable for an arch. It is compared with adequacy_factor of [assess]. Loads are those of the \
           file: no partial factor and no impact is added here. The check assesses strength only if \
           adequacy_source names the document of the factor, the factor times load_factor_included of the \
           loads is above 1, and the value reaches model_factor times the limit (A191); otherwise the \
           comparison is made, but no verdict of adequacy rests on it. If it is not met, use the discrete \
           element method for a second opinion (extrados collapse --method dem), and check what fill and \
           backing could add.",
    source: "plastic theory of masonry arches: Heyman, The Safety of Masonry Arches (1969)",
    probe: Probe::Collapse,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let limit = limit(a.asked.limits.adequacy_factor, "adequacy_factor = …", "from the rule that you assess by")?;
    let facts = of(&a.facts.ultimate)?;
    let made = (facts.load_factor, facts.status);
    let found = by_file::compared(a, limit, &facts.load, made, "limit analysis")?;
    let none = || NotMade::because("no load turns the bridge into a mechanism: the factor is unbounded");
    let found = found.ok_or_else(none)?;
    Ok(vec![Comparison {
        basis: match (found.value > 0.0, facts.position_m) {
            (false, _) => "the bridge does not stand under its own weight as rigid blocks".to_owned(),
            (true, Some(x)) => format!("{}; worst of {} positions at {x:.2} m", facts.method, facts.positions),
            (true, None) => facts.method.clone(),
        },
        position: facts.position_m,
        ..found
    }])
}
