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

pub(super) fn told(word: Reading, augment: f64) -> String {
    format!("{word} CDA {augment:.3}")
}

/// The columns of Table 7: self-weight, live load with design augment, sum, live load with total augment, sum; loads stand on
/// a span, from 1.
pub(super) fn columns(
    facts: &ServiceFacts,
    (load, reading): (&str, Reading),
    span: usize,
    own: f64,
    live: f64,
) -> Columns {
    let [design, total] = facts.augment.on(span).map(|augment| (1.0 + augment) * live);
    Columns { load: load.to_owned(), reading, values: [own, design, own + design, total, own + total] }
}

fn run(a: &Evidence, place: RingSection) -> Result<Vec<Comparison>, NotMade> {
    let limits = &a.asked.limits;
    if limits.compression.is_none() && limits.tension.is_none() {
        limit(None, "compression_limit and tension_limit", "from the rule that you assess by")?;
    }
    let facts = of(&a.facts.service)?;
    let mut list = Vec::new();
    for load in &facts.loads {
        for &reading in Reading::ALL {
            let here = || load.places.iter().filter(|at| at.quantity == Watched::Stress && at.place == place);
            let on = |span: usize| facts.augment.on(span)[reading as usize];
            let pressed = |at: &&SectionFacts| -(at.self_weight + (1.0 + on(at.minimum_span)) * at.minimum);
            let pulled = |at: &&SectionFacts| at.self_weight + (1.0 + on(at.maximum_span)) * at.maximum;
            let sides = [
                (limits.compression, -1.0, here().max_by(|x, y| pressed(x).total_cmp(&pressed(y)))),
                (limits.tension, 1.0, here().max_by(|x, y| pulled(x).total_cmp(&pulled(y)))),
            ];
            for (limit, sign, worst) in sides {
                let (Some(limit), Some(at)) = (limit.map(|pascals| pascals / 1e6), worst) else { continue };
                let compression = sign < 0.0;
                let (size, live, position, span) = match compression {
                    true => (pressed(&at), at.minimum, at.minimum_at_m, at.minimum_span),
                    false => (pulled(&at), at.maximum, at.maximum_at_m, at.maximum_span),
                };
                let word = if compression { "compression" } else { "tension" };
                list.push(Comparison {
                    load_model: format!("{}, {}", load.name, told(reading, on(span))),
                    value: sign * size,
                    limit: sign * limit,
                    unit: Unit::Megapascal,
                    utilisation: used(size, limit),
                    basis: format!("{word}; {}; first axle at {position:.2} m", at.about),
                    position: Some(position),
                    columns: Some(columns(facts, (&load.name, reading), span, at.self_weight, live)),
                    ..Comparison::default()
                });
            }
        }
    }
    unless_empty(list, format!("no {place} of the bridge was watched"))
}
