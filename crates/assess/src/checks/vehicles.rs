//! Vehicles under the factors of a rule.

use super::by_rule;
use super::check::{Check, Probe, of};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::collapse::Status;
use outcome::facts::{SafetyFacts, SweptFacts, VehicleFacts};
use rules::Confidence;

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C204",
    keys: ["sweep.vehicles", "sweep.rule"],
    title: "adequacy of vehicles",
    clause: "adequacy factor of every vehicle under the factors of its rule",
    text: "The factor by which all loads of a vehicle may be multiplied before a mechanism forms, by limit \
           analysis over every position, both directions and every group of neighbouring axles. Partial \
           factors, impact, dispersal, effective width and condition are those of the rule of [sweep], each \
           with its source in the report; the limit is therefore 1. A rule without a factor above 1 on live \
           loads, or without a source of it (\"characteristic\", rules of working stresses), is compared only \
           to find vehicles that fail even so: a bridge that carries nominal loads has no verdict of adequacy. \
           The factors of a standard cover its own method. Under a rule_file whose model factor was not read in \
           its source, a verdict needs the model factor of tests (A191), and so does every rule with \
           model_factor = \"tests\" in [assess]. If the check is not met, study the governing case: its \
           position, its axles, and which factors are recalled and not read. With discrete_elements = true in \
           [sweep] the governing case is also analysed by discrete elements, and the smaller number counts.",
    source: "the rule of [sweep]; plastic theory of masonry arches (Heyman 1969)",
    probe: Probe::Vehicle,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let facts = of(&a.facts.vehicles)?;
    let strength = has_safety(&facts.safety);
    let needed = by_rule::needed(a);
    // What a verdict needs is the limit itself where the file makes it so.
    let limit = if a.asked.limits.model_factor_of_tests { needed } else { 1.0 };
    let bounded = facts.vehicles.iter().filter(|one| one.adequacy.is_some() || one.status != Status::Locks);
    let all: Vec<Comparison> = bounded
        .clone()
        .filter(|one| one.adequacy.is_some() || one.status != OPEN || fails_all_the_same(one))
        .map(|one| finding(facts, one, strength, [limit, needed]))
        .collect();
    let (met, broken): (Vec<&Comparison>, Vec<&Comparison>) = all.iter().partition(|finding| finding.met());
    // What fails at some position fails; what passes at the others passes only where no position is left open.
    let open: Vec<&str> = bounded.filter(|one| one.status == OPEN).map(|one| one.code.as_str()).collect();
    if !open.is_empty() && broken.is_empty() {
        let why = format!("limit analysis of {} has no result at some positions", open.join(", "));
        return Err(NotMade::failed(why));
    }
    match (strength, met.first(), broken.is_empty()) {
        (_, None, true) => {
            Err(NotMade::because("no vehicle turns the bridge into a mechanism: the factors are unbounded"))
        }
        (false, Some(_), true) => Err(NotMade::because(without_safety(&facts.safety, &met))),
        // Without safety only what fails even so is a comparison.
        (false, _, false) => Ok(broken.into_iter().cloned().collect()),
        (true, ..) => Ok(all),
    }
}

/// The status of a vehicle without an answer.
const OPEN: Status = Status::NotConverged;

/// Whether what was answered of a vehicle turns the bridge down, whatever the positions left open would say.
fn fails_all_the_same(one: &SweptFacts) -> bool {
    one.adequacy_at_most.is_some_and(|most| most < 1.0)
}

/// Whether a rule has a factor on live loads that has a source: without one, loads at their nominal values are compared with
/// what they collapse at.
fn has_safety(safety: &SafetyFacts) -> bool {
    safety.live_load > 1.0 && safety.live_load_confidence != Confidence::Assumed
}

/// What is said where a rule without safety is carried.
fn without_safety(safety: &SafetyFacts, met: &[&Comparison]) -> String {
    let least = met.iter().map(|finding| finding.value).fold(f64::INFINITY, f64::min);
    let lacks = match safety.live_load > 1.0 {
        true => format!("the live load factor {} of rule \"{}\" has no source", safety.live_load, safety.rule),
        false => format!("rule \"{}\" has no factor on live loads", safety.rule),
    };
    format!(
        "{lacks}: carrying loads without safety factors {least:.2} times gives no verdict; write rule = \"cs-454\" \
         (roads), rule = \"nr-civ-025\" (railways), or rule_file with the factors of yours, in [sweep]"
    )
}

/// The method of deformable joints, in words.
const GIVES: &str = "equilibrium path on deformable joints";

fn finding(facts: &VehicleFacts, one: &SweptFacts, safe: bool, [limit, needed]: [f64; 2]) -> Comparison {
    // Joints that deform carry less; the smaller number counts where both were found.
    let governs = facts.governing.as_ref() == Some(&one.code);
    let second = facts.adequacy_by_discrete_elements.filter(|_| governs);
    let by_limit = one.adequacy.or(one.adequacy_at_most).unwrap_or(0.0);
    let value = by_limit.min(second.unwrap_or(f64::INFINITY));
    let (rigid, gives) = (one.rigid.unwrap_or(f64::INFINITY), one.deformable.unwrap_or(f64::INFINITY));
    let method = match value < by_limit {
        _ if one.adequacy.is_none() && one.adequacy_at_most.is_some() => {
            format!(
                "{}, at most: {} of {} positions have no answer",
                if gives < rigid { GIVES } else { "limit analysis" },
                one.positions_not_converged,
                one.positions
            )
        }
        true => format!("discrete elements (limit analysis {by_limit:.3})"),
        false if gives < rigid => format!("{GIVES} (rigid blocks {rigid:.3})"),
        false if gives.is_finite() => format!("limit analysis ({GIVES} {gives:.3})"),
        false => "limit analysis".to_owned(),
    };
    Comparison {
        load_model: one.code.clone(),
        value,
        limit,
        unit: Unit::Ratio,
        utilisation: if value > 0.0 { limit / value } else { f64::MAX },
        basis: match one.position_m {
            Some(x) => format!(
                "{method}; {}; {}, first axle at {x:.2} m; factor {:.3} on axles",
                one.title, one.case, one.load_factor
            ),
            None => format!("{}; {}", one.title, one.status),
        },
        position: one.position_m,
        columns: None,
        // What fails is settled; what passes must pass with what a verdict needs, under loads that have a source.
        strength: safe && (value < limit || value >= needed && one.loads_confidence != Confidence::Assumed),
        needed: (needed > limit).then_some(needed),
    }
}
