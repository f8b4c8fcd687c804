//! What a verdict must know of the rule and the vehicles that a plan names: what the rule asks for, what an engineer's own files change of
//! the library, what is doubtful in them, and which load cases were not moved.

use crate::vehicles::{Library, Read, applicable, read};
use bridge::{Bridge, SweepPlan};
use outcome::facts::{DoubtFacts, SafetyFacts, VehicleFacts};
use outcome::vehicles::Swept;
use rules::{
    Confidence, Doubt, LoadModel, Required, Requirement, Rule, Source, Ways, based_on, changed_by_vehicles,
    changed_for, doubts_of_rule, doubts_of_vehicles,
};

/// What is to be said of a plan whose vehicles were moved: of their facts no more than that.
pub(crate) fn of_plan(bridge: &Bridge, plan: &SweepPlan, swept: &[Swept]) -> VehicleFacts {
    let Ok(Read { rule: Some(rule), library, own, .. }) = read(bridge, plan) else { return VehicleFacts::default() };
    let base = based_on(&rule, &library).filter(|_| plan.rule_file.is_some());
    let moved: Vec<&str> = swept.iter().map(|one| one.model.as_str()).collect();
    let mut changed_factors = base.map_or_else(Vec::new, |base| changed_for(&rule, base.rule, &moved));
    let mut left_out: Vec<String> = Vec::new();
    let mut models: Vec<&str> = Vec::new();
    for one in swept {
        let more: Vec<String> = one.acting.left_out.iter().filter(|words| !left_out.contains(words)).cloned().collect();
        left_out.extend(more);
        if !models.contains(&one.model.as_str()) {
            models.push(&one.model);
            changed_factors.extend(changed_by_vehicles(&rule, &one.model, &one.acting));
        }
    }
    let rule_file = plan.rule_file.clone().unwrap_or_default();
    let doubtful = doubtful(plan, &rule, &library, own);
    let (based_on, based_on_named) = base.map_or_else(Default::default, |base| (base.rule.code.clone(), base.named));
    VehicleFacts {
        requires: requires(&rule, base.map(|base| base.rule)),
        load_cases_missing: missing(bridge, &rule, &library.models, swept),
        safety: SafetyFacts { rule_file, based_on, based_on_named, changed_factors, ..SafetyFacts::default() },
        doubtful,
        left_out,
        ..VehicleFacts::default()
    }
}

/// Doubtful values of the files of vehicles and of the rule that the bridge file's sweep names.
pub fn doubtful_files(bridge: &Bridge) -> Vec<DoubtFacts> {
    let Some(plan) = &bridge.sweep else { return Vec::new() };
    match read(bridge, plan) {
        Ok(Read { rule: Some(rule), library, own, .. }) => doubtful(plan, &rule, &library, own),
        _ => Vec::new(),
    }
}

/// The same of what was read, where the plan's own load models begin at `own`.
fn doubtful(plan: &SweepPlan, rule: &Rule, library: &Library, own: usize) -> Vec<DoubtFacts> {
    let of_file = |file: &str, doubts: Vec<Doubt>| {
        let facts = |doubt: Doubt| DoubtFacts {
            code: doubt.code.to_owned(),
            file: file.to_owned(),
            at: doubt.at,
            told: doubt.message,
        };
        doubts.into_iter().map(facts).collect::<Vec<_>>()
    };
    let of_rule = plan.rule_file.iter().flat_map(|file| of_file(file, doubts_of_rule(rule)));
    let models = plan.vehicle_files.iter().zip(&library.models[own..]);
    of_rule.chain(models.flat_map(|(file, model)| of_file(file, doubts_of_vehicles(model)))).collect()
}

/// What a rule asks for: its own requirements and those of the rule that it builds on; braking of every rule for railways.
fn requires(rule: &Rule, base: Option<&Rule>) -> Vec<Requirement> {
    let mut list = rule.requires.clone();
    for more in base.iter().flat_map(|base| &base.requires) {
        if list.iter().all(|own| own.what != more.what) {
            list.push(more.clone());
        }
    }
    let rail_alone = rule.ways == [Ways::Rail];
    if rail_alone && list.iter().all(|own| own.what != Required::Braking) {
        let source = Source {
            text: "rules for railway bridges ask for braking and traction".to_owned(),
            date: "2026".to_owned(),
            confidence: Confidence::Assumed,
            note: "the rule's file does not say whether it asks for them".to_owned(),
        };
        list.push(Requirement { what: Required::Braking, source });
    }
    list
}

/// Vehicles that belong to the same loadings as those that were moved, go with the rule on these spans, and were not moved.
fn missing(bridge: &Bridge, rule: &Rule, models: &[LoadModel], swept: &[Swept]) -> Vec<String> {
    let loading = |code: &str| models.iter().find(|model| model.code == code).map(|model| model.loading.as_str());
    let moved: Vec<&str> = swept.iter().filter_map(|one| loading(&one.model)).filter(|name| !name.is_empty()).collect();
    let applies = |model: &&LoadModel| {
        moved.contains(&model.loading.as_str()) && applicable(bridge, model) && rule.acting(model).is_some()
    };
    let all = models.iter().filter(applies).flat_map(|model| &model.vehicles);
    let not_moved = |code: &&String| swept.iter().all(|one| one.code != **code);
    all.map(|vehicle| &vehicle.code).filter(not_moved).cloned().collect()
}
