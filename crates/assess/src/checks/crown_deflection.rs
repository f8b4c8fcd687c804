//! Deflection of crowns in service.

use super::check::{Check, Probe, limit, of, unless_empty};
use super::stress::{Side, worst};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::facts::{Reading, Watched};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C101",
    keys: ["service_load", "assess.deflection_limit"],
    title: "crown deflection",
    clause: "deflection of the crown, self-weight and live load",
    text: "The vertical displacement of every crown under self-weight and under the train, which is increased \
           by the coefficient of dynamic augment: once the design value, reduced by the cushion, and once the \
           total. The increase multiplies the static effect of the train; the analysis is not repeated with \
           heavier axles. The sum is compared with deflection_limit of [assess]. Self-weight is applied to the \
           stress-free bridge, which no record can show: read the columns of the report separately. If the \
           check is not met, check the moduli first: a record of a train (extrados update) is better evidence \
           than any table.",
    source: "Table 7 of the railway paper, row 1, for the bridge of that paper",
    probe: Probe::Sensors,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let limit =
        1e3 * limit(a.asked.limits.deflection, "deflection_limit = \"… mm\"", "from the rule that you assess by")?;
    let facts = of(&a.facts.service)?;
    let mut list = Vec::new();
    for load in &facts.loads {
        for &reading in Reading::ALL {
            let crowns = load.places.iter().filter(|place| place.quantity == Watched::Deflection);
            let found = worst(facts, (&load.name, reading), crowns, Side::Below, limit);
            list.extend(found.map(|found| Comparison { unit: Unit::Millimetre, ..found }));
        }
    }
    unless_empty(list, "no crown was watched while the train crossed")
}
