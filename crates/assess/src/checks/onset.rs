//! States that a bridge should not come to in service, and how far from them it is.

use super::check::{Check, Probe, limit, of, unless_empty};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::collapse::Criterion;

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C205",
    keys: ["load", "assess.onset_factor"],
    title: "states in service",
    clause: "factor on loads at which a joint is half open, at half its strength, or the bridge at half its stiffness",
    text: "The least factor on nominal loads (of a vehicle with impact, without the rule's factor on live loads; of \
           the file as they are) at which a joint is open over half of its depth, is stressed to half of its \
           strength, or the stone that moves most does so twice as far as at first for a little more load. It is found along \
           the equilibrium path on deformable joints, at every position, and is compared with onset_factor of \
           [assess]. It says from which load damage begins, and nothing about collapse. The thrust leaves the middle third \
           of a joint earlier: that factor stands in the result and is not compared.",
    source: "the permissible limit state of masonry arches: Melbourne, Wang and Tomor, Proc. ICE Bridge Engineering 160 (2007) \
             [recalled]; the three states and their shares are the program's own",
    probe: Probe::Whole,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let wanted = limit(a.asked.limits.onset_factor, "onset_factor = …", "from the owner of the bridge")?;
    let mut states = of_vehicles(a, wanted);
    states.extend(of_the_file(a, wanted));
    unless_empty(states, "no such state was met, or joints were taken as rigid: write method = \"path\" in [analysis]")
}

/// The first state that a load brings about, and the factor on the load at which it does, beside the wanted one.
fn compared(load: &str, state: Criterion, [factor, wanted]: [f64; 2], position: Option<f64>, what: &str) -> Comparison {
    Comparison {
        load_model: load.to_owned(),
        value: factor,
        limit: wanted,
        unit: Unit::Ratio,
        utilisation: if factor > 0.0 { wanted / factor } else { f64::MAX },
        basis: format!("{} at this multiple of {what}", state.word()),
        position,
        ..Comparison::default()
    }
}

/// Whether a state counts: thrusts leave the middle third of some joint in many sound bridges.
fn counts(criterion: Criterion) -> bool {
    criterion != Criterion::MiddleThird
}

fn of_vehicles(a: &Evidence, wanted: f64) -> Vec<Comparison> {
    let Ok(facts) = of(&a.facts.vehicles) else { return Vec::new() };
    let live = facts.safety.live_load;
    let first = |one: &outcome::facts::SweptFacts| {
        let counting = one.permissible.iter().filter(|p| counts(p.criterion));
        let least = counting.min_by(|a, b| a.adequacy.total_cmp(&b.adequacy))?;
        let what = format!("{} with impact, without the factor {live} on live loads", one.title);
        Some(compared(&one.code, least.criterion, [least.adequacy * live, wanted], Some(least.position), &what))
    };
    facts.vehicles.iter().filter_map(first).collect()
}

fn of_the_file(a: &Evidence, wanted: f64) -> Option<Comparison> {
    let facts = of(&a.facts.ultimate).ok()?;
    let counting = facts.permissible.iter().filter(|p| counts(p.criterion));
    let least = counting.min_by(|a, b| a.load.total_cmp(&b.load))?;
    let factor = least.load / 1e3 / facts.reference_load_kn_per_m;
    let what = "the loads of the file, where they govern";
    Some(compared(&facts.load, least.criterion, [factor, wanted], facts.position_m, what))
}
