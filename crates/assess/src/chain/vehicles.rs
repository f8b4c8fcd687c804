//! Vehicles of the file's [sweep], as facts.

use crate::analysis::vehicles::by_acting;
use crate::plan_facts::of_plan;
use bridge::Bridge;
use outcome::collapse::Status;
use outcome::facts::{SafetyFacts, SweptFacts, ThrustFacts, VehicleFacts};
use outcome::help::Help;
use outcome::statics::pressure;
use outcome::vehicles::{ByDiscreteElements, Extreme, Of, SectionEnvelope, Swept, VehicleSweep};
use outcome::warning::{self, Warning};
use rules::{Confidence, Rule};

/// The facts of a sweep of vehicles.
pub fn vehicle_facts(bridge: &Bridge, found: &VehicleSweep) -> VehicleFacts {
    let plan = bridge.sweep.as_ref();
    let own = plan.map_or_else(VehicleFacts::default, |plan| of_plan(bridge, plan, &found.vehicles));
    let source = |source: &rules::Source| format!("{} ({}, {})", source.text, source.date, source.confidence.word());
    VehicleFacts {
        grades: found.grades().iter().map(|one| [one.of.clone(), one.told(), one.all_told()]).collect(),
        graded: found.grades(),
        rule: rule_line(&found.rule),
        factors: found
            .rule
            .listed()
            .into_iter()
            .map(|(name, factor)| [name.to_owned(), factor.value.to_string(), source(&factor.source)])
            .chain(by_acting(&found.vehicles).into_iter().flat_map(|(models, acting)| {
                let sources: Vec<String> = acting.sources().into_iter().map(source).collect();
                [
                    [
                        format!("live load of {models}"),
                        acting.live_load.value.to_string(),
                        source(&acting.live_load.source),
                    ],
                    [format!("impact on {models}"), acting.told(), sources.join("; ")],
                ]
            }))
            .collect(),
        safety: safety(&found.rule, own.safety),
        vehicles: found.vehicles.iter().map(swept).collect(),
        step_m: found.step,
        governing: found.governing.and_then(|k| found.vehicles.get(k)).map(|one| one.code.clone()),
        discrete_elements: found.discrete_elements.as_ref().map(carried),
        adequacy_by_discrete_elements: found.discrete_elements.as_ref().and_then(|second| second.adequacy),
        headline: found.headline().map(|headline| headline.0),
        positions_not_converged: found.positions_not_converged(),
        braking: plan.filter(|plan| plan.braking_given).map(|plan| plan.braking),
        braking_reason: plan.and_then(|plan| plan.braking_reason.clone()).unwrap_or_default(),
        assumptions: found.assumptions.clone(),
        warnings: warnings(found),
        ..own
    }
}

/// Warnings of the sweep, of the governing case as a collapse analysis, and of the two methods apart; each once.
fn warnings(found: &VehicleSweep) -> Vec<Warning> {
    let governing = found.collapse.iter().flat_map(|collapse| collapse.warnings.iter().cloned());
    let mut all = found.warnings.clone();
    for warning in governing.chain(apart(found)) {
        if !all.contains(&warning) {
            all.push(warning);
        }
    }
    all
}

/// A rule, where it is from, and how sure its factors are: its title may be read while its factors are recalled.
fn rule_line(rule: &Rule) -> String {
    let listed = rule.listed();
    let counted =
        [Confidence::Read, Confidence::Calculated, Confidence::Recalled, Confidence::Assumed].map(|confidence| {
            let count = listed.iter().filter(|(_, factor)| factor.source.confidence == confidence).count();
            (count > 0).then(|| format!("{count} {}", confidence.word()))
        });
    let counted: Vec<String> = counted.into_iter().flatten().collect();
    let (source, total) = (&rule.source, listed.len());
    format!("{}: {} ({}); of its {total} factors {}", rule.title, source.text, source.date, counted.join(", "))
}

/// What safety a rule holds, beside what is known of it by its plan: its factor on live loads, and how sure each factor is.
fn safety(rule: &Rule, own: SafetyFacts) -> SafetyFacts {
    let live = &rule.factors.live_load;
    let named = rule.listed().into_iter();
    SafetyFacts {
        rule: rule.code.clone(),
        live_load: live.value,
        live_load_confidence: live.source.confidence,
        model: rule.factors.model.value,
        model_confidence: rule.factors.model.source.confidence,
        factors: named.map(|(name, factor)| (format!("{name} {}", factor.value), factor.source.confidence)).collect(),
        ..own
    }
}

/// Discrete elements above limit analysis by more than their load step: the reason must be found.
fn apart(found: &VehicleSweep) -> Option<Warning> {
    let second = found.discrete_elements.as_ref()?;
    let (carried, limit) = (second.adequacy?, second.limit?);
    (carried > limit + second.step).then(|| warning::Loads::VehicleAboveLimit { carried, limit }.into())
}

/// What discrete elements say of the governing case.
fn carried(found: &ByDiscreteElements) -> String {
    let limit = found.limit.map_or(String::new(), |limit| format!("; limit analysis {limit:.3}"));
    match (found.adequacy, &found.reason) {
        (Some(_), _) if found.status == Some(Status::UnstableUnderSelfWeight) => {
            format!("the bridge does not stand under its own weight{limit}")
        }
        (Some(adequacy), _) => format!(
            "the last load step carried has an adequacy factor of {adequacy:.3}, in steps of {:.3}{limit}",
            found.step
        ),
        (None, Some(reason)) => format!("could not be made: {reason}"),
        (None, None) => format!("ended with {}{limit}", found.status.map_or("nothing", |status| status.word())),
    }
}

fn swept(one: &Swept) -> SweptFacts {
    let case = one.case.as_ref().map_or(String::new(), |case| {
        let axles = match case.axles {
            Some([first, last]) if first == last => format!("axle {}", first + 1),
            Some([first, last]) => format!("axles {} to {}", first + 1, last + 1),
            None => "uniform loads alone".to_owned(),
        };
        let arrangement = if case.arrangement.is_empty() {
            String::new()
        } else {
            format!(", {}", case.arrangement.replace(" m", "\u{a0}m"))
        };
        // The axle with more than the others, where the rule has such a thing.
        let critical = match (case.critical_axle, one.load_factors[1]) {
            (Some(axle), factor) if factor != 1.0 => {
                format!(", axle {} with {} times as much", axle + 1, (1e3 * factor).round() / 1e3)
            }
            _ => String::new(),
        };
        let uniform = case.uniform.filter(|_| case.axles.is_some());
        let beside = uniform.map_or(String::new(), |[from, to]| {
            format!(", uniform load from {from:.2} to {to:.2}\u{a0}m").replace('-', "\u{2212}")
        });
        let along = match case.horizontal {
            0.0 => String::new(),
            share => format!(
                ", {:.0}\u{a0}% of the loads along the bridge to the {}",
                100.0 * share.abs(),
                if share > 0.0 { "right" } else { "left" }
            ),
        };
        let which = format!("travelling to the {}{arrangement}{critical}{beside}{along}", case.direction.word());
        format!("{axles}, {which}; {}", case.weights.told())
    });
    let fallen =
        || one.weights.map_or(String::new(), |weights| format!("the bridge does not stand with {}", weights.told()));
    let case = if case.is_empty() { fallen() } else { case };
    SweptFacts {
        code: one.code.clone(),
        title: one.title.clone(),
        status: one.status,
        adequacy: one.adequacy,
        adequacy_with_fill_pressure: one.not_counted.with(Help::FillPressure).and_then(|with| with.factor),
        not_counted: one.not_counted.clone(),
        adequacy_at_most: one.adequacy_at_most,
        positions: one.envelope.len(),
        positions_not_converged: one.positions_not_converged,
        position_m: one.case.as_ref().map(|case| case.position),
        case,
        effective_width_m: one.effective_width,
        effective_width_derivation: one.across.derivation.clone(),
        stands: one.across.told(),
        thrusts: one.sections.iter().filter_map(thrust).collect(),
        load_factor: one.load_factors[0],
        live_load: one.acting.live_load.value,
        live_load_confidence: one.acting.live_load.source.confidence,
        impact: one.acting.told(),
        factors_of_vehicle_file: one.acting.of_vehicle_file,
        slow_cases: one.by_interior_point,
        loads_confidence: one.source.confidence,
        rigid: one.rigid,
        deformable: one.deformable.as_ref().and_then(|own| own.adequacy),
        permissible: one.deformable.as_ref().map_or_else(Vec::new, |own| own.permissible.clone()),
    }
}

/// The largest thrust at a springing or a foot of a pier.
fn thrust(section: &SectionEnvelope) -> Option<ThrustFacts> {
    let watched = ["springing", "foot"].iter().any(|word| section.name.contains(word));
    let pressed = |one: &Extreme| pressure(one.thrust, section.depth, one.eccentricity);
    let largest = section.extremes.iter().find(|one| one.of == Of::LargestThrust).filter(|_| watched)?;
    Some(ThrustFacts {
        place: section.name.clone(),
        thrust_kn_per_m: 1e-3 * largest.thrust,
        shear_kn_per_m: 1e-3 * largest.shear,
        eccentricity_m: largest.eccentricity,
        depth_m: section.depth,
        outside: largest.outside,
        pressure_kpa: 1e-3 * section.extremes.iter().map(pressed).fold(0.0, f64::max),
    })
}
