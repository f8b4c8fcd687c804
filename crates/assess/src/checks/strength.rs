//! Whether strength was assessed: what an ultimate check under factors with a source still needs, and what qualifies one that
//! was made.

use super::{model_factor, vehicles};
use crate::evidence::Evidence;
use outcome::checked::Strength;
use outcome::checked::{Checked, Comparison};
use outcome::warning::{self, Warning};
use rules::Confidence;

/// Codes of the checks at ultimate that can assess strength.
const ULTIMATE: [&str; 2] = ["C201", "C204"];
/// Warnings that do not qualify a verdict: numbers chosen for the reader, and factors that are listed by name anyway.
const BESIDE: [&str; 2] = [warning::CHOSEN, warning::RECALLED_FACTOR];
/// What assesses strength, in words.
const WANTED: &str = "strength was not assessed: no ultimate check was made under factors with a source";

/// Reads it off the checks.
pub fn strength(a: &Evidence, checked: &[Checked]) -> Strength {
    let ultimate: Vec<&Checked> = checked.iter().filter(|one| ULTIMATE.contains(&one.code.as_str())).collect();
    let failed = ultimate.iter().any(|one| one.outcome.as_ref().is_err_and(|why| why.failed));
    let made = ultimate.iter().flat_map(|one| one.outcome.iter().flatten());
    let assessed = ultimate.iter().any(|one| whole(one)) && !failed && skew(a).is_none();
    let missing = if assessed { Vec::new() } else { missing(a, &ultimate) };
    let qualifications = if made.count() > 0 { qualifications(a) } else { Vec::new() };
    Strength { assessed, missing, qualifications }
}

/// Whether a check assesses strength for every load that it compares.
fn whole(check: &Checked) -> bool {
    check.outcome.as_ref().is_ok_and(|list| !list.is_empty() && list.iter().all(|finding| finding.strength))
}

fn missing(a: &Evidence, ultimate: &[&Checked]) -> Vec<String> {
    let mut list = vec![WANTED.to_owned()];
    list.extend(skew(a));
    for check in ultimate {
        let card = check;
        match &check.outcome {
            Err(why) => list.push(format!("{} ({}): {}", card.title, card.code, why.why)),
            Ok(found) if card.code == "C201" => {
                let why = of_the_file(a).or_else(|| within(found, model_of_the_file(a), "model_factor in [assess]"));
                list.extend(why.map(|why| format!("{} (C201): {why}", card.title)));
            }
            Ok(found) => {
                let wanted = a.facts.vehicles.made().map_or(1.0, |facts| vehicles::wanted(&facts.safety));
                let why = within(found, wanted, "a model factor that was read in its source, in rule_file of [sweep],");
                list.extend(why.map(|why| format!("{} ({}): {why}", card.title, card.code)));
                list.extend(of_assumed_loads(a).map(|why| format!("{} ({}): {why}", card.title, card.code)));
            }
        }
    }
    list
}

/// Why a skew bridge has no verdict of adequacy; none where it is square, hardly skew, or where the file names what confirms it.
fn skew(a: &Evidence) -> Option<String> {
    let skew = a.bridge.spans.iter().map(|span| span.skew).fold(0.0, f64::max);
    let doubtful = skew > bridge::DOUBTFUL_SKEW && a.asked.limits.skew_source.is_none();
    doubtful.then(|| {
        format!(
            "the bridge is skew by {:.0} degrees, and the square model is not a bound for it: name the \
             three-dimensional model or the test that confirms it as skew_source in [assess]",
            skew.to_degrees()
        )
    })
}

/// Which vehicles are carried but have assumed loads.
fn of_assumed_loads(a: &Evidence) -> Option<String> {
    let facts = a.facts.vehicles.made()?;
    let carried = facts.vehicles.iter().filter(|one| one.adequacy.is_some_and(|adequacy| adequacy >= 1.0));
    let assumed: Vec<&str> =
        carried.filter(|one| one.loads_confidence == Confidence::Assumed).map(|one| one.code.as_str()).collect();
    (!assumed.is_empty()).then(|| {
        format!(
            "axle loads or distances of {} are assumed: write those of the loading diagram into a file of \
             vehicle_files in [sweep]",
            assumed.join(", ")
        )
    })
}

/// Why the factor of the file is none that assesses strength; none where it is one.
pub(super) fn of_the_file(a: &Evidence) -> Option<String> {
    let limits = &a.asked.limits;
    let asked = limits.adequacy_factor?;
    if asked * limits.load_factor_included <= 1.0 {
        return Some(format!(
            "a factor of {asked} on loads that carry a factor of {} gives no safety: write the factor of a rule as \
             adequacy_factor, or load_factor_included where the forces of the file carry it, in [assess]",
            limits.load_factor_included
        ));
    }
    match limits.adequacy_source {
        Some(_) => None,
        None => Some(
            "the file names no source of its adequacy_factor: write adequacy_source = \"document, clause\" in [assess]"
                .to_owned(),
        ),
    }
}

/// The model factor under the file's own factor on its loads.
pub(super) fn model_of_the_file(a: &Evidence) -> f64 {
    a.asked.limits.model_factor.unwrap_or_else(model_factor::model_factor)
}

/// What is said where limits are met by less than the model factor asks for; `key` is what to write.
fn within(found: &[Comparison], wanted: f64, key: &str) -> Option<String> {
    let near = found.iter().filter(|finding| finding.met() && finding.value < wanted * finding.limit);
    let list: Vec<String> = near
        .map(|finding| format!("{} {:.2} of {:.2}", finding.load_model, finding.value, wanted * finding.limit))
        .collect();
    (!list.is_empty()).then(|| {
        format!(
            "met, but with less margin than the uncertainty of the model requires: {}; {}; write {key} if a source has \
             another",
            list.join(", "),
            model_factor::words()
        )
    })
}

/// Factors that were not read in their source, and warnings of the analyses behind the ultimate checks, each in a line.
fn qualifications(a: &Evidence) -> Vec<String> {
    let mut list = Vec::new();
    let limits = &a.asked.limits;
    let by_file =
        a.facts.ultimate.made().is_some() && limits.adequacy_factor.is_some() && limits.model_factor.is_none();
    if by_file || a.facts.vehicles.made().is_some_and(|facts| vehicles::wanted(&facts.safety) > 1.0) {
        list.push(format!("{} (A191)", model_factor::words()));
    }
    if let Some(facts) = a.facts.vehicles.made() {
        let told = |sure: Confidence| {
            let some = facts.safety.factors.iter().filter(|(_, confidence)| *confidence == sure);
            some.map(|(named, _)| named.as_str()).collect::<Vec<_>>().join(", ")
        };
        for (sure, what) in [
            (Confidence::Recalled, "recalled and not read in their source, confirm them"),
            (Confidence::Assumed, "assumed, since no source gives them"),
        ] {
            let named = told(sure);
            if !named.is_empty() {
                list.push(format!("factors of rule \"{}\" that are {what}: {named}", facts.safety.rule));
            }
        }
    }
    let stages =
        [a.facts.vehicles.made().map(|facts| &facts.warnings), a.facts.ultimate.made().map(|facts| &facts.warnings)];
    for Warning { code, message } in stages.into_iter().flatten().flatten() {
        let title = findings::Card::of(code, warning::CARDS).map_or(message.as_str(), |card| card.title);
        let line = format!("{title} ({code})");
        if !BESIDE.contains(code) && !list.contains(&line) {
            list.push(line);
        }
    }
    list
}
