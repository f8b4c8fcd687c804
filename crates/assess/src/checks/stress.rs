//! Stresses along the ring in service: crown, abutments, piers.

use super::check::{Check, Probe, limit, of, unless_empty, used};
use crate::evidence::Evidence;
use outcome::checked::{Columns, Comparison, NotMade, Unit};
use outcome::facts::{Reading, RingSection, SectionFacts, ServiceFacts, Watched};

/// At crowns.
pub(super) const CROWN: Check = Check {
    code: "C102",
    keys: ["service_load", "assess"],
    title: "crown stress",
    clause: "longitudinal stress at the crown",
    text: "The stress along the ring on the faces of the voussoirs at this position, tension positive: the \
           strain of a voussoir times E / (1 - nu^2), under self-weight and under the train, whose effect is increased by \
           the design and by the total coefficient of dynamic augment. The largest compression and the largest tension over \
           all spans and both faces are compared with compression_limit and tension_limit of [assess]. A voussoir between \
           joints without tensile strength has little tension whatever the load; if this check shows more tension than the \
           mortar can carry, the voussoir bends between its joints. If the compression limit is not met, look at the thrust \
           line: it is close to a face.",
    source: "Table 7 of the railway paper: 26.4 kg/cm2 in compression, 2.64 in tension",
    probe: Probe::Sensors,
    run: |a| run(a, RingSection::Crown),
};

/// At springings on abutments.
pub(super) const ABUTMENT: Check = Check {
    code: "C103",
    title: "abutment stress",
    clause: "longitudinal stress at the abutments",
    run: |a| run(a, RingSection::Abutment),
    ..CROWN
};

/// At springings on piers.
pub(super) const PIER: Check = Check {
    code: "C104",
    title: "pier stress",
    clause: "longitudinal stress at the piers",
    run: |a| match a.bridge.spans.len() {
        0 | 1 => Err(NotMade::because("the bridge has no pier")),
        _ => run(a, RingSection::Pier),
    },
    ..CROWN
};

/// The side of a limit on which places are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// What is least: compression, or a deflection downwards.
    Below,
    /// What is most.
    Above,
}

/// The place that comes nearest to its limit on a side, or passes it farthest, under a load whose effect is increased by a reading of the augment;
/// beside it the columns of Table 7. None where no place is watched.
pub(super) fn worst<'f>(
    facts: &ServiceFacts,
    (load, reading): (&str, Reading),
    places: impl Iterator<Item = &'f SectionFacts>,
    side: Side,
    limit: f64,
) -> Option<Comparison> {
    let sign = if side == Side::Below { -1.0 } else { 1.0 };
    let extreme = |at: &SectionFacts| match side {
        Side::Below => (at.minimum, at.minimum_at_m, at.minimum_span),
        Side::Above => (at.maximum, at.maximum_at_m, at.maximum_span),
    };
    let size = |at: &SectionFacts| {
        let (live, _, span) = extreme(at);
        sign * (at.self_weight + (1.0 + facts.augment.on(span)[reading as usize]) * live)
    };
    let at = places.max_by(|x, y| size(x).total_cmp(&size(y)))?;
    let (own, (live, position, span)) = (at.self_weight, extreme(at));
    let both = facts.augment.on(span);
    let [design, total] = both.map(|augment| (1.0 + augment) * live);
    let values = [own, design, own + design, total, own + total];
    Some(Comparison {
        load_model: format!("{load}, {reading} CDA {:.3}", both[reading as usize]),
        value: sign * size(at),
        limit: sign * limit,
        utilisation: used(size(at), limit),
        basis: format!("{}; first axle at {position:.2} m", at.about),
        position: Some(position),
        columns: Some(Columns { load: load.to_owned(), reading, values }),
        ..Comparison::default()
    })
}

fn run(a: &Evidence, place: RingSection) -> Result<Vec<Comparison>, NotMade> {
    let limits = &a.asked.limits;
    if limits.compression.is_none() && limits.tension.is_none() {
        limit(None, "compression_limit and tension_limit", "from the rule that you assess by")?;
    }
    let facts = of(&a.facts.service)?;
    let sides = [(limits.compression, Side::Below, "compression"), (limits.tension, Side::Above, "tension")];
    let mut list = Vec::new();
    for load in &facts.loads {
        for &reading in Reading::ALL {
            for (limit, side, word) in sides {
                let here = load.places.iter().filter(|at| at.quantity == Watched::Stress && at.place == place);
                let found = limit.and_then(|limit| worst(facts, (&load.name, reading), here, side, limit / 1e6));
                list.extend(found.map(|found| Comparison {
                    unit: Unit::Megapascal,
                    basis: format!("{word}; {}", found.basis),
                    ..found
                }));
            }
        }
    }
    unless_empty(list, format!("no {place} of the bridge was watched"))
}
