//! Permissible limit: range of stress in service.

use super::check::{Check, Probe, limit, of, unless_empty, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::facts::SectionFacts;
use outcome::facts::Watched;

/// The lower bound of tests on brickwork in compression: root of range times maximum over the strength, after N cycles.
pub(super) fn bound(cycles: f64) -> f64 {
    0.7 - 0.05 * cycles.log10()
}

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C203",
    keys: ["service_load", "assess.load_cycles"],
    title: "range of stress",
    clause: "permissible limit: fatigue of masonry in compression",
    text: "The root of the range of compressive stress times its maximum, over the compressive strength of the \
           masonry, at every watched point of the ring, with the design coefficient of dynamic augment. It is \
           compared with 0.7 - 0.05 log10 N, the lower bound of tests on brickwork; N is load_cycles of \
           [assess]: a passing train is one cycle of its largest range or more. The strength is that of \
           [masonry]; without one the check cannot be made.",
    source: "Roberts, Hughes, Dandamudi and Bell, Quasi-static and high cycle fatigue strength of brick masonry, Construction and Building \
             Materials 20 (2006) [recalled]",
    probe: Probe::Sensors,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let cycles = limit(a.asked.limits.load_cycles, "load_cycles = …", "from the traffic in the required life")?;
    let facts = of(&a.facts.service)?;
    let strength = a.bridge.masonry.compressive_strength.ok_or_else(|| {
        NotMade::because("the masonry has no compressive strength: write compressive_strength in [masonry]")
    })? / 1e6;
    let limit = bound(cycles);
    let mut list = Vec::new();
    for load in &facts.loads {
        let level = |at: &SectionFacts| {
            // Compression of the two ends; tension counts as none.
            let increase = |span: usize| 1.0 + facts.augment.on(span)[0];
            let most = -(at.self_weight + increase(at.minimum_span) * at.minimum).min(0.0);
            let least = -(at.self_weight + increase(at.maximum_span) * at.maximum).min(0.0);
            ((most - least) * most).sqrt() / strength
        };
        let stresses = load.places.iter().filter(|at| at.quantity == Watched::Stress);
        let Some(at) = stresses.max_by(|x, y| level(x).total_cmp(&level(y))) else { continue };
        let value = level(at);
        list.push(Comparison {
            load_model: format!("{}, design CDA {:.3}", load.name, facts.augment.on(at.minimum_span)[0]),
            value,
            limit,
            unit: Unit::OfTheStrength,
            utilisation: used(value, limit),
            basis: format!("{}; {cycles:.0e} cycles, strength {strength:.2} MPa", at.about),
            position: Some(at.minimum_at_m),
            ..Comparison::default()
        });
    }
    unless_empty(list, "no stress was watched while the train crossed")
}
