//! What of a rule the vehicles of a file cover: load cases that apply to the spans, and how they were sought.

use crate::evidence::Evidence;
use crate::vehicles::{Chosen, LoadModel, Read, Rule, applicable, chosen, read};
use bridge::{Bridge, Directions, SweepPlan};
use outcome::given::Taken;
use rules::{Acting, Confidence, Factor, Required, Ways, based_on};

/// The rule of a file and what its vehicles cover.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    /// Code of the rule.
    pub code: String,
    /// As it is said: "CS 454"; an engineer's own by its code and file.
    pub name: String,
    /// Whether it is one of the library's, as published there.
    pub library: bool,
    /// Whether its model factor was read in its source.
    pub model_is_sourced: bool,
    /// Its model factor, which the adequacy factors hold already.
    pub model: f64,
    /// The grades that are asked for, where every vehicle stands for one.
    pub level: Option<String>,
    /// Codes of load cases that apply and were left out.
    pub left_out: Vec<String>,
    /// Factors that act on this bridge and that nobody read in their source, each with its value.
    pub to_confirm: Vec<String>,
    /// Vehicles whose live loads act without safety, and the factor.
    pub without_safety: Vec<(String, f64)>,
    /// What the rule asks of the file and does not find there, each as what and what to write.
    pub lacks: Vec<[String; 2]>,
}

/// The coverage of a file with a `[sweep]` that can be read.
pub fn of(a: &Evidence) -> Option<Coverage> {
    let plan = a.bridge.sweep.as_ref()?;
    let (rule, vehicles) = chosen(&a.bridge, plan).ok()?;
    Some(Coverage {
        code: rule.code.clone(),
        name: name(plan, &rule),
        library: plan.rule_file.is_none(),
        model_is_sourced: matches!(rule.factors.model.source.confidence, Confidence::Read | Confidence::Calculated),
        model: rule.factors.model.value,
        level: level(&vehicles),
        left_out: left_out(&a.bridge, plan, &rule, &vehicles),
        to_confirm: to_confirm(&a.bridge, &rule, &vehicles),
        without_safety: without_safety(&vehicles),
        lacks: lacks(a, plan),
    })
}

/// "CS 454" of "CS 454, masonry arches at ultimate limit state"; an engineer's own rule is named as that.
fn name(plan: &SweepPlan, rule: &Rule) -> String {
    match &plan.rule_file {
        Some(file) => format!("rule \"{}\" of {file}", rule.code),
        None => rule.title.split(',').next().unwrap_or(&rule.title).trim().to_owned(),
    }
}

/// The grades of vehicles that all stand for one.
fn level(vehicles: &[Chosen]) -> Option<String> {
    let grades: Vec<&str> = vehicles.iter().filter_map(|one| Some(one.grade.as_ref()?.name.as_str())).collect();
    let heaviest = vehicles.iter().filter_map(|one| one.grade.as_ref()).max_by_key(|grade| grade.rank)?;
    (grades.len() == vehicles.len()).then(|| heaviest.name.clone())
}

/// Load cases of the loadings that are asked for; and where none of normal traffic is, those of the rule. An engineer's own rule that names a
/// standard has to carry what the standard has carried, and an own vehicle is no normal traffic of a standard by what its file calls it.
fn left_out(bridge: &Bridge, plan: &SweepPlan, rule: &Rule, vehicles: &[Chosen]) -> Vec<String> {
    let Ok(Read { library, own, .. }) = read(bridge, plan) else { return Vec::new() };
    let models = &library.models;
    let standard = match plan.rule_file {
        None => Some(rule),
        Some(_) => based_on(rule, &library).filter(|base| base.named).map(|base| base.rule),
    };
    let made_for = |model: &LoadModel| [Some(rule), standard].iter().flatten().any(|one| one.acting(model).is_some());
    let published = |model: &LoadModel| models[..own].iter().any(|one| one.code == model.code);
    let counts = |model: &LoadModel| {
        let joins = |other: &LoadModel| published(other) && other.loading == model.loading;
        standard.is_none() || published(model) || !model.loading.is_empty() && models.iter().any(joins)
    };
    let asked = |model: &LoadModel| vehicles.iter().any(|one| one.model == model.code);
    let normal = models.iter().filter(|model| asked(model)).any(|model| is_normal(model) && counts(model));
    let ways: Vec<Ways> = vehicles.iter().map(|one| one.ways).collect();
    let loadings: Vec<&str> = match normal {
        true => models.iter().filter(|model| asked(model)).map(|model| model.loading.as_str()).collect(),
        false => {
            let own = models.iter().filter(|model| !model.only_by_name && made_for(model));
            own.filter(|model| ways.contains(&model.ways)).map(|model| model.loading.as_str()).collect()
        }
    };
    let mut codes = Vec::new();
    for model in models.iter().filter(|model| !model.loading.is_empty() && loadings.contains(&model.loading.as_str())) {
        if !made_for(model) {
            continue;
        }
        if !applicable(bridge, model) {
            let reason = model.span_limit.as_ref().map_or("", |limit| limit.reason.as_str());
            codes.push(format!("{} ({reason})", model.code));
            continue;
        }
        // An own vehicle may bear the same code.
        let moved = |code: &str| vehicles.iter().any(|one| one.model == model.code && one.vehicle.code == code);
        let missing = model.vehicles.iter().filter(|vehicle| !moved(&vehicle.code));
        codes.extend(missing.map(|vehicle| vehicle.code.clone()));
    }
    codes
}

/// Whether a model is normal traffic: a loading all of whose cases count, or grades of restrictions.
fn is_normal(model: &LoadModel) -> bool {
    !model.loading.is_empty() || !model.grades.is_empty()
}

/// Of the rule's factors and those on the loads of its vehicles those that act and that nobody read in their source.
fn to_confirm(bridge: &Bridge, rule: &Rule, vehicles: &[Chosen]) -> Vec<String> {
    let masonry = [&bridge.joint, &bridge.ring_joint];
    let acts = |name: &str| match name {
        "live load" => false,
        "cohesion and tension of joints" => {
            masonry.iter().any(|joint| joint.cohesion > 0.0 || joint.tensile_strength > 0.0)
        }
        "fill pressure" => bridge.fill_pressure.is_some_and(|fill| fill.applies),
        "strength of masonry" => bridge.masonry.compressive_strength.is_some(),
        _ => true,
    };
    let listed = rule.listed().into_iter().filter(|(name, _)| acts(name));
    let of_rule = |(name, factor): (&str, &Factor)| (format!("{name} {}", factor.value), factor.source.confidence);
    let mut list: Vec<(String, Confidence)> = listed.map(of_rule).collect();
    for one in vehicles {
        let Acting { live_load, impact, .. } = &one.acting;
        let live = format!("live load of {} {}", one.model, live_load.value);
        let surest = impact.sources().iter().map(|source| source.confidence).max().unwrap_or(Confidence::Assumed);
        let impact = format!("impact on {} {}", one.model, impact.told());
        for factor in [(live, live_load.source.confidence), (impact, surest)] {
            if !list.contains(&factor) {
                list.push(factor);
            }
        }
    }
    let open = |confidence| matches!(confidence, Confidence::Recalled | Confidence::Assumed);
    list.into_iter().filter(|(_, confidence)| open(*confidence)).map(|(told, _)| told).collect()
}

/// Vehicles on which no factor above 1 with a source acts.
fn without_safety(vehicles: &[Chosen]) -> Vec<(String, f64)> {
    let live = vehicles.iter().map(|one| (&one.vehicle.code, &one.acting.live_load));
    live.filter(|(_, factor)| !factor.is_safety()).map(|(code, factor)| (code.clone(), factor.value)).collect()
}

/// Least positions over the shortest span with which the worst one is met.
const LEAST_POSITIONS: f64 = 15.0;

/// Least braking and traction, as a share of the loads, that railways ask for: 0.15 (AREMA, longitudinal force), 0.25 (EN 1991-2, 6.5.3: 20 of
/// 80 kN/m). Less than that asks for a reason.
const LEAST_BRAKING: f64 = 0.15;

/// What the rule asks of the file and does not find there.
fn lacks(a: &Evidence, plan: &SweepPlan) -> Vec<[String; 2]> {
    let bridge = &a.bridge;
    let mut list: Vec<[String; 2]> = Vec::new();
    let mut ask = |what: &str, write: &str| list.push([what.to_owned(), write.to_owned()]);
    if bridge.masonry.compressive_strength.is_none() {
        ask(
            "no compressive strength of the masonry",
            "write compressive_strength in [masonry], from tests or the values of the standard: joints that never crush carry more",
        );
    }
    if plan.own_dispersal {
        ask("loads spread by the file and not by the rule", "leave dispersal = \"file\" of [sweep] away");
    }
    let facts = a.facts.vehicles.made();
    let asks = |what| facts.is_some_and(|facts| facts.requires.iter().any(|one| one.what == what));
    if asks(Required::Braking) && !plan.braking_given {
        ask(
            "braking not written",
            "write braking = … in [sweep], as a share of the loads, or braking = 0 with braking_reason = \"…\"",
        );
    } else if asks(Required::Braking) && plan.braking < LEAST_BRAKING && plan.braking_reason.is_none() {
        ask(&format!("no reason for braking = {}", plan.braking), "write braking_reason = \"…\" in [sweep]");
    }
    if plan.directions != Directions::Both {
        ask("vehicles drive one way only", "leave directions of [sweep] away");
    }
    if !plan.subsets {
        ask("axles that relieve the arch are not taken away", "leave subsets = false of [sweep] away");
    }
    let shortest = bridge.spans.iter().map(|span| span.span).fold(f64::INFINITY, f64::min);
    if plan.step.is_some_and(|step| step > shortest / LEAST_POSITIONS) {
        ask("positions too far apart", "leave step of [sweep] away, or write a fifteenth of the shortest span at most");
    }
    list
}

/// Less braking than railways ask for under a rule that asks for it, with the reason that the file gives.
pub fn less_braking(a: &Evidence) -> Option<Taken> {
    let plan = a.bridge.sweep.as_ref().filter(|plan| plan.braking_given && plan.braking < LEAST_BRAKING)?;
    let asked = a.facts.vehicles.made()?.requires.iter().any(|one| one.what == Required::Braking);
    let how = plan.braking_reason.clone().filter(|_| asked)?;
    Some(Taken { what: format!("braking {}", plan.braking), how, ..Taken::default() })
}

/// Widest lane of a road, and the farthest that the nearest wheel usually stands from the edge of a barrel [m]: beyond them vehicles that
/// share a width are kept apart.
const WIDEST_LANE: f64 = 3.65;
const FARTHEST_WHEEL: f64 = 2.0;
/// Between the wheels of an axle on a road [m] (CS 454, 7.3).
const NARROWEST_TRACK: f64 = 1.8;

/// How a road's carriageway keeps vehicles from where they weigh most on the barrel, each in a sentence.
pub fn lanes_apart(bridge: &Bridge) -> Vec<Taken> {
    let Some(asked) = bridge.carriageway.as_ref() else { return Vec::new() };
    let road = bridge.sweep.as_ref().and_then(|plan| chosen(bridge, plan).ok());
    if !road.is_some_and(|(_, vehicles)| vehicles.iter().any(|one| one.ways == Ways::Road)) {
        return Vec::new();
    }
    let told = |what, how: &str| Taken { what, how: how.to_owned(), ..Taken::default() };
    let room = (bridge.width / crate::analysis::vehicles::ROAD_LANE).floor().min(2.0) as usize;
    let fewer = asked.lanes.filter(|lanes| *lanes < room).map(|lanes| {
        let width = bridge.width;
        told(
            format!("{lanes} lane where {width:.2} m have room for {room}"),
            "vehicles beside one another are left out",
        )
    });
    let wide = asked.lane_width.filter(|width| *width > WIDEST_LANE);
    let wide =
        wide.map(|width| told(format!("lanes {width:.2} m apart"), "vehicles beside one another are that far apart"));
    let far = asked.edge_distance.filter(|distance| *distance > FARTHEST_WHEEL);
    let far =
        far.map(|distance| told(format!("wheels {distance:.2} m from the edge"), "no wheel comes nearer to the edge"));
    let left = |edge: f64| bridge.width - 2.0 * edge;
    let none = asked.edge_distance.filter(|edge| left(*edge) < NARROWEST_TRACK);
    let none = none.map(|edge| {
        let left = left(edge).max(0.0);
        told(
            format!("wheels {edge:.2} m from both edges of {:.2} m", bridge.width),
            &format!("{left:.2} m are left between, where no vehicle has room; wheels are taken in the middle"),
        )
    });
    fewer.into_iter().chain(wide).chain(far).chain(none).collect()
}
