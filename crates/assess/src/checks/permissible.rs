//! Permissible limit: share of the ultimate load in service.

use super::check::{Check, Probe, limit, of, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::collapse::Status;

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C202",
    keys: ["load", "assess.permissible_share"],
    title: "share of the ultimate load",
    clause: "permissible limit: load in service over load at collapse",
    text: "The reciprocal of the adequacy factor of the file's loads: the load in service as a share of the \
           collapse load. It is compared with permissible_share of [assess]. Above about half of the ultimate \
           load repeated loading damages masonry arches: joints open and close, mortar falls out, rings \
           separate.",
    source: "Melbourne, Wang and Tomor, A new masonry arch bridge assessment strategy (SMART), Proc. ICE Bridge Engineering 160 (2007): \
             about 50 % of the ultimate load [recalled]",
    probe: Probe::Collapse,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let limit = limit(a.asked.limits.permissible_share, "permissible_share = …", "from the rule that you assess by")?;
    let facts = of(&a.facts.ultimate)?;
    let factor = facts.load_factor.filter(|factor| *factor > 0.0).ok_or_else(|| NotMade {
        why: format!("limit analysis ended with {}", facts.status),
        // No bound on the load is an answer; a bridge that does not stand, or no answer, settles nothing.
        failed: facts.status != Status::Locks,
        left_out: None,
    })?;
    Ok(vec![Comparison {
        load_model: facts.load.clone(),
        value: 1.0 / factor,
        limit,
        unit: Unit::OfTheUltimateLoad,
        utilisation: used(1.0 / factor, limit),
        basis: format!("adequacy factor {factor:.3}"),
        position: facts.position_m,
        ..Comparison::default()
    }])
}
