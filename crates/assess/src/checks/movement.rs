//! Tolerance of settlement.

use super::check::{Check, Probe, limit, of, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::collapse::Status;

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C401",
    keys: ["support_movement", "assess.expected_movement"],
    title: "settlement tolerance",
    clause: "support movement over the movement that makes a mechanism",
    text: "expected_movement of [assess], times movement_factor, over the last movement of [support_movement] \
           at which the bridge still stood. Masonry arches follow large movements of their supports by opening \
           joints: this check is about collapse, not cracks. If it is not met, measure again and find the \
           cause of the movement.",
    source: "McInerney and DeJong, Discrete element modeling of groin vault displacement capacity (2015), for the method [recalled]",
    probe: Probe::Whole,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let limits = &a.asked.limits;
    let expected = 1e3
        * limit(limits.expected_movement, "expected_movement = \"… mm\"", "as measured or expected at the support")?;
    let facts = of(&a.facts.movement)?;
    let stood = facts.last_stable_mm.ok_or_else(|| NotMade {
        why: format!("the analysis of the movement ended with {}", facts.status),
        failed: facts.status != Status::Locks,
        left_out: None,
    })?;
    let allowed = stood / limits.movement_factor;
    Ok(vec![Comparison {
        load_model: format!("{} moves", facts.support),
        value: expected,
        limit: allowed,
        unit: Unit::Millimetre,
        utilisation: used(expected, allowed),
        basis: format!("the bridge stood at {stood:.1} mm; safety on the movement {:.2}", limits.movement_factor),
        ..Comparison::default()
    }])
}
