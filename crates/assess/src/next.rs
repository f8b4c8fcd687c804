//! What to do next, by rule: each step follows from a fact of the assessment, names it, and names where the rule is from. Nothing here is an
//! opinion of the program, and nothing changes the verdict. docs/theory/next-steps.md lists the rules.

use crate::evidence::Evidence;
use bridge::defect::DefectKind;
use outcome::assessment::{Action, Step};
use outcome::checked::{Checked, Comparison, Judgement, Verdict};
use outcome::warning;

/// Where the rules are from.
const SHORTFALL: &str = "management of sub-standard structures: interim measures stand from an assessed shortfall until it is removed or disproved \
                         (CS 470 on highways; a railway's owner has its own procedure; recalled)";
const SURVEY: &str = "inspection for assessment: what an assessment rests on is measured on site (BD 21, chapter 2; its contents were read)";
const GROWTH: &str = "condition appraisal: movements and cracks are measured until they are known to rest (CIRIA C656, UIC 778-3; recalled)";
const LEVELS: &str = "levels of assessment: a finer method follows where a simpler one does not settle the question (UIC 778-3, CS 454; recalled)";
const OWN: &str = "the limits of this program's own methods (docs/theory/limits.md)";

/// Share of a limit from which on little is left of it.
const NEAR: f64 = 0.9;

/// Every step whose fact is there, restrictions first.
pub fn steps(evidence: &Evidence, checked: &[Checked], verdict: &Verdict) -> Vec<Step> {
    let mut list = Vec::new();
    restrict(evidence, checked, verdict, &mut list);
    inspect(evidence, &mut list);
    rings(evidence, verdict, &mut list);
    monitor(evidence, checked, &mut list);
    refine(evidence, checked, verdict, &mut list);
    list
}

fn step(action: Action, what: impl Into<String>, because: impl Into<String>, rule: &str) -> Step {
    Step { action, what: what.into(), because: because.into(), rule: rule.to_owned() }
}

/// Comparisons with their checks.
fn compared(checked: &[Checked]) -> impl Iterator<Item = (&Checked, &Comparison)> {
    checked.iter().flat_map(|check| check.outcome.iter().flatten().map(move |one| (check, one)))
}

fn used((check, one): (&Checked, &Comparison)) -> String {
    format!("{} {}, {}: {:.0} % of the limit is used", check.code, check.title, one.load_model, 100.0 * one.utilisation)
}

fn worst<'a>(list: impl Iterator<Item = (&'a Checked, &'a Comparison)>) -> Option<(&'a Checked, &'a Comparison)> {
    list.max_by(|a, b| a.1.utilisation.total_cmp(&b.1.utilisation))
}

/// A load that strength does not carry leaves the bridge, or stays off it, until the shortfall is gone.
fn restrict(evidence: &Evidence, checked: &[Checked], verdict: &Verdict, list: &mut Vec<Step>) {
    let Some(found) = worst(compared(checked).filter(|(_, one)| one.strength && !one.met())) else { return };
    let grades = evidence.facts.vehicles.made().map_or(&[][..], |facts| &facts.graded);
    for graded in grades {
        let (of, highest) = (&graded.of, graded.told());
        let what = if graded.highest.is_none() && !graded.not_carried.is_empty() {
            format!(
                "{of}: no grade that was asked for is carried ({highest}); keep all of these loads off until the shortfall is removed or disproved"
            )
        } else {
            let settled = if verdict.strength.missing.is_empty() {
                ""
            } else {
                ", and that is not settled either while strength is missing"
            };
            format!("{of}: no more than {highest}{settled}, until the shortfall is removed or disproved")
        };
        list.push(step(Action::Restrict, what, used(found), SHORTFALL));
    }
    if grades.is_empty() {
        let what = "keep the loads that are not carried off the bridge until the shortfall is removed or disproved";
        list.push(step(Action::Restrict, what, used(found), SHORTFALL));
    }
}

/// What the answer hangs on, and what was not measured.
fn inspect(evidence: &Evidence, list: &mut Vec<Step>) {
    if let Some(facts) = evidence.facts.sensitivity.made() {
        let met = facts.utilisation <= 1.0;
        let turns = |value: Option<f64>| value.is_some_and(|value| (value <= 1.0) != met);
        let turning = facts.quantities.iter().filter(|one| turns(one.less) || turns(one.more));
        for one in turning {
            let differs = if met { "a change" } else { "a measurement that differs" };
            let because = format!("{differs} of {:.0} % turns check {}", 100.0 * facts.share, facts.code);
            let what = format!("measure {} (the file has {})", one.path, one.value);
            list.push(step(Action::Inspect, what, because, SURVEY));
        }
        if list.iter().all(|one| one.action != Action::Inspect)
            && let Some(first) = facts.quantities.first()
        {
            let because = format!(
                "of all quantities it changes check {} most; none turns it within {:.0} %",
                facts.code,
                100.0 * facts.share
            );
            let what = format!("measure {} first (the file has {})", first.path, first.value);
            list.push(step(Action::Inspect, what, because, SURVEY));
        }
    }
    let across = evidence.facts.warnings().find(|(_, one)| one.code() == warning::ACROSS_ASSUMED);
    if let Some((_, found)) = across {
        let what = "measure lanes or tracks, and the distance of the nearest wheel or rail from the edge of the barrel";
        list.push(step(Action::Inspect, what, format!("{}: {}", found.code(), found.message()), SURVEY));
    }
}

/// Bonded rings may carry several times what separated ones do: worth a cheap look where separated ones are not enough.
fn rings(evidence: &Evidence, verdict: &Verdict, list: &mut Vec<Step>) {
    let collapse = evidence.facts.ultimate.made().and_then(|facts| facts.collapse.as_deref());
    let known = collapse.and_then(|found| found.carried().zip(found.bonded_rings_load));
    if let Some((apart, bonded)) = known.filter(|(apart, bonded)| bonded > apart)
        && verdict.status != Judgement::Adequate
    {
        let what = "sound the barrel and core it: rings that still hold together may be described as one";
        let because =
            format!("apart they carry {:.1} kN/m, as one {:.1} kN/m by limit analysis", apart / 1e3, bonded / 1e3);
        list.push(step(Action::Inspect, what, because, SURVEY));
    }
}

/// Whether a defect is one of a kind.
type Is = fn(&DefectKind) -> bool;

/// Defects that can grow: what is measured of them, what they are, and which they are.
const GROWING: [(&str, &str, Is); 4] = [
    ("opening of the joints that stand open, at several temperatures", "open joints", |kind| {
        matches!(kind, DefectKind::OpenJoint { .. })
    }),
    ("extent of ring separation, by tapping", "stretches of separated rings", |kind| {
        matches!(kind, DefectKind::RingSeparation { .. })
    }),
    ("stones beside those that dropped or fell out", "stretches of dropped or missing stones", |kind| {
        matches!(kind, DefectKind::MissingStones | DefectKind::DroppedStones { .. })
    }),
    ("depth of mortar and stone that is lost, at the same places", "stretches of lost mortar or stone", |kind| {
        matches!(kind, DefectKind::LostMortar { .. } | DefectKind::ThinRing { .. })
    }),
];

/// What can grow.
fn monitor(evidence: &Evidence, checked: &[Checked], list: &mut Vec<Step>) {
    let bridge = &evidence.bridge;
    let mut add = |what: &str, because: String| list.push(step(Action::Monitor, what, because, GROWTH));
    if let Some(before) = bridge.plan.support_movement.and_then(|movement| movement.before) {
        add("levels and distances of the springings", format!("a support has moved by {:.1} mm", 1e3 * before));
    }
    let cracks = bridge.carriageway.as_ref().map_or(0, |asked| asked.cracks.len());
    if cracks > 0 {
        add("width and length of longitudinal cracks", format!("through the barrel: {cracks}"));
    }
    for (what, defects, is_one) in GROWING {
        let count = bridge.spans.iter().flat_map(|span| &span.defects).filter(|one| is_one(&one.kind)).count();
        if count > 0 {
            add(what, format!("{defects} in the file: {count}"));
        }
    }
    if let Some(water) = bridge.cover.water {
        add(
            "level of the water in the fill, and its drains",
            format!("the fill is taken as saturated to {:.2} m", water.level),
        );
    }
    let near = worst(compared(checked).filter(|(_, one)| one.met() && one.utilisation >= NEAR));
    if let Some(found) = near {
        add("the quantities of this check at every inspection", used(found));
    }
}

/// What a finer analysis can settle, up or down.
fn refine(evidence: &Evidence, checked: &[Checked], verdict: &Verdict, list: &mut Vec<Step>) {
    let mut add = |what: &str, because: String, rule: &str| list.push(step(Action::Refine, what, because, rule));
    for check in checked {
        if let Err(why) = &check.outcome
            && why.failed
        {
            add(
                "repeat the analysis that came to no end, with other steps or another method",
                format!("{} {}: {}", check.code, check.title, why.why),
                LEVELS,
            );
        }
    }
    let settled = verdict.status == Judgement::Adequate;
    let mut told: Vec<&str> = Vec::new();
    for (_, found) in evidence.facts.warnings() {
        if told.contains(&found.code()) {
            continue;
        }
        told.push(found.code());
        let because = format!("{}: {}", found.code(), found.message());
        match found.code() {
            warning::SKEW => add(
                "confirm the load of the skew barrel by a model in three dimensions or by a load test",
                because,
                LEVELS,
            ),
            warning::RINGS_SHARE => {
                add(
                    "analyse the governing case by discrete elements or the equilibrium path; it may carry less",
                    because,
                    OWN,
                );
            }
            warning::FILL_AS_WEIGHT if !settled => {
                add(
                    "model the fill: [fill_pressure], or a continuum; it may carry more, and soil may fail before the arch",
                    because,
                    LEVELS,
                );
            }
            warning::RECALLED_FACTOR | warning::VEHICLE_NOT_READ => {
                let what = format!("confirm in its text what warning {} lists", found.code());
                add(&what, because, OWN);
            }
            _ => {}
        }
    }
    if let Some(first) = verdict.strength.missing.first() {
        let count = verdict.strength.missing.len();
        let others = if count > 1 { format!(", and {} more under Missing", count - 1) } else { String::new() };
        add("settle what the verdict on strength is missing", format!("{first}{others}"), LEVELS);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;
    use bridge::PoreWater;
    use bridge::assess::Assess;
    use bridge::defect::{Defect, Face};
    use outcome::assessment::{Facts, Stage};
    use outcome::checked::{NotMade, Rung, Strength, Unit};
    use outcome::facts::{ChangeFacts, SensitivityFacts, UltimateFacts, VehicleFacts};
    use outcome::vehicles::Graded;

    fn evidence() -> Evidence {
        let (asked, facts) = (Assess::default(), Facts::default());
        Evidence { bridge: samples::bridgemill(), asked, facts, statics: None, doubts: Vec::new(), assumed: Vec::new() }
    }

    fn verdict(status: Judgement) -> Verdict {
        Verdict {
            status,
            headline: Rung::Adequate,
            words: String::new(),
            finished: true,
            strength: Strength::default(),
            given: Default::default(),
            broken_by_rule: false,
            open: Vec::new(),
        }
    }

    fn check(utilisation: f64) -> Checked {
        let one = Comparison {
            load_model: "gb-3t".into(),
            value: 1.0,
            limit: 1.0,
            unit: Unit::Ratio,
            utilisation,
            basis: String::new(),
            position: None,
            columns: None,
            strength: true,
            needed: None,
        };
        Checked {
            code: "C204".into(),
            title: "adequacy".into(),
            clause: String::new(),
            keys: Default::default(),
            outcome: Ok(vec![one]),
        }
    }

    fn actions(list: &[Step]) -> Vec<Action> {
        list.iter().map(|one| one.action).collect()
    }

    #[test]
    fn rings_are_sounded_where_they_do_not_carry_enough_apart() {
        let mut own = evidence();
        let ring = own.bridge.spans[0].rings[0].clone();
        let half = bridge::Ring {
            crown_thickness: 0.5 * ring.crown_thickness,
            springing_thickness: 0.5 * ring.springing_thickness,
            ..ring
        };
        own.bridge.spans[0].rings = vec![half.clone(), half];
        own.bridge.plan.method = bridge::Method::Limit;
        let found = crate::analysis::collapse(&own.bridge, None, &mut mechanics::watch::Unwatched).unwrap();
        own.facts.ultimate = Stage::Made(UltimateFacts { collapse: Some(Box::new(found)), ..UltimateFacts::default() });
        let open = steps(&own, &[check(0.5)], &verdict(Judgement::Undetermined));
        assert!(open.iter().any(|one| one.action == Action::Inspect && one.because.starts_with("apart they carry")));
        assert!(
            steps(&own, &[check(0.5)], &verdict(Judgement::Adequate)).iter().all(|one| one.action != Action::Inspect)
        );
    }

    /// Without a fact there is no step; every step names its fact and its rule.
    #[test]
    fn a_sound_bridge_that_carries_all_has_no_next_step() {
        assert!(steps(&evidence(), &[check(0.5)], &verdict(Judgement::Adequate)).is_empty());
        let near = steps(&evidence(), &[check(0.95)], &verdict(Judgement::Adequate));
        assert_eq!(actions(&near), [Action::Monitor]);
        assert!(near[0].because.contains("95 %") && near[0].rule.contains("CIRIA"), "{near:?}");
    }

    #[test]
    fn a_shortfall_restricts_to_the_grade_that_is_carried() {
        let mut e = evidence();
        let short = |e: &Evidence| steps(e, &[check(1.6)], &verdict(Judgement::Inadequate));
        assert!(short(&e)[0].what.contains("off the bridge"), "{:?}", short(&e));
        let grade = |highest: Option<&str>, not_carried: &str| VehicleFacts {
            graded: vec![Graded {
                of: "weight restriction".into(),
                highest: highest.map(str::to_owned),
                not_carried: vec![not_carried.into()],
                ..Graded::default()
            }],
            warnings: vec![
                warning::Cover::AsWeight { backing: false, record: None }.into(),
                warning::Vehicles::AcrossAssumed { ways: Vec::new() }.into(),
            ],
            ..VehicleFacts::default()
        };
        e.facts.vehicles = Stage::Made(grade(Some("7.5 t"), "10 t"));
        let list = short(&e);
        assert!(list[0].what.contains("no more than 7.5 t") && list[0].because.contains("160 %"), "{list:?}");
        assert_eq!(actions(&list), [Action::Restrict, Action::Inspect, Action::Refine]);
        e.facts.vehicles = Stage::Made(grade(None, "3 t"));
        assert!(short(&e)[0].what.contains("keep all of these loads off"));
        // Where all is carried, neither a restriction nor a better model of the fill follows.
        assert_eq!(actions(&steps(&e, &[check(0.5)], &verdict(Judgement::Adequate))), [Action::Inspect]);
    }

    #[test]
    fn what_can_grow_is_measured_again() {
        let mut e = evidence();
        let span = e.bridge.spans[0].span;
        let kinds = [
            DefectKind::OpenJoint { face: Face::Intrados, depth: 0.1 },
            DefectKind::LostMortar { face: Face::Intrados, depth: 0.1 },
            DefectKind::DroppedStones { depth: 0.05 },
        ];
        let all = kinds.map(|kind| Defect { kind, from_to: [1.0, 2.0], shares: [1.0 / span, 2.0 / span] });
        e.bridge.spans[0].defects.extend(all);
        e.bridge.cover.water = Some(PoreWater { level: 1.0, saturated_density: 2100.0 });
        e.bridge.carriageway = Some(bridge::Carriageway { cracks: vec![0.5], ..Default::default() });
        let list = steps(&e, &[], &verdict(Judgement::Adequate));
        assert_eq!(actions(&list), [Action::Monitor; 5]);
    }

    /// What turns the check is measured first; an analysis without an end is made again.
    #[test]
    fn what_turns_a_check_is_measured_and_what_failed_is_repeated() {
        let mut e = evidence();
        let change = |path: &str, less: f64| ChangeFacts {
            path: path.into(),
            value: "x".into(),
            less: Some(less),
            more: Some(0.7),
        };
        let facts = |less| SensitivityFacts {
            code: "C204".into(),
            utilisation: 0.8,
            how: String::new(),
            share: 0.1,
            quantities: vec![change("span[1].thickness", less), change("cover[1].density", 0.81)],
        };
        e.facts.sensitivity = Stage::Made(facts(1.2));
        let list = steps(&e, &[], &verdict(Judgement::Adequate));
        assert!(
            list.len() == 1 && list[0].what.contains("span[1].thickness") && list[0].because.contains("turns"),
            "{list:?}"
        );
        e.facts.sensitivity = Stage::Made(facts(0.9));
        let list = steps(&e, &[], &verdict(Judgement::Adequate));
        assert!(list.len() == 1 && list[0].because.contains("none turns it"), "{list:?}");
        e.facts.sensitivity = Facts::default().sensitivity;
        let why = NotMade::failed("positions without a result");
        let open = Checked {
            code: "C201".into(),
            title: "adequacy".into(),
            clause: String::new(),
            keys: Default::default(),
            outcome: Err(why),
        };
        let list = steps(&e, &[open], &verdict(Judgement::Undetermined));
        assert_eq!(actions(&list), [Action::Refine]);
    }
}
