//! Deflection of crowns in service.

use super::check::{Check, Probe, limit, of, unless_empty, used};
use super::stress::{columns, told};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::facts::{Reading, SectionFacts, Watched};

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
            let on = |place: &SectionFacts| facts.augment.on(place.minimum_span)[reading as usize];
            let places = load.places.iter().filter(|place| place.quantity == Watched::Deflection);
            let down = |place: &&SectionFacts| -(place.self_weight + (1.0 + on(place)) * place.minimum);
            let Some(at) = places.max_by(|x, y| down(x).total_cmp(&down(y))) else { continue };
            let value = down(&at);
            list.push(Comparison {
                load_model: format!("{}, {}", load.name, told(reading, on(at))),
                value: -value,
                limit: -limit,
                unit: Unit::Millimetre,
                utilisation: used(value, limit),
                basis: format!("{}; first axle at {:.2} m", at.about, at.minimum_at_m),
                position: Some(at.minimum_at_m),
                columns: Some(columns(facts, (&load.name, reading), at.minimum_span, at.self_weight, at.minimum)),
                ..Comparison::default()
            });
        }
    }
    unless_empty(list, "no crown was watched while the train crossed")
}
