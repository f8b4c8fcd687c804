//! Vehicles and rules that a bridge file can name: those of the library, the trains of passages, and an engineer's own.

use bridge::{Bridge, SweepPlan};
use outcome::vehicles::Grade;
use outcome::warning::TooLong;
use rules::{Acting, Confidence, Factor};
pub use rules::{Extent, Library, LoadModel, Published, Rule, Source, Spacing, Uniform, Vehicle, Ways};

/// Code of the load model that holds the trains of passages.
const TRAINS: &str = "trains";
/// Broad gauge, between the middles of the rail heads, and the breadth of a sleeper [m]: of the railway paper's trains.
const GAUGE: f64 = 1.75;
const SLEEPER: f64 = 0.25;

/// Why vehicles or a rule cannot be had.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum Unknown {
    #[error(
        "there is no vehicle, load model or train \"{code}\": write {near}a name that extrados vehicles lists, or name its file in \
         `vehicle_files`"
    )]
    Vehicle {
        /// As written.
        code: String,
        /// A few names that are close to it, nearest first, with a comma; empty where none is.
        near: String,
    },
    #[error("there is no rule \"{code}\": write {near}one of {known}, or name its file in `rule_file`")]
    Rule {
        /// As written.
        code: String,
        /// A name that is close to it, with a comma; empty where none is.
        near: String,
        /// Codes that there are.
        known: String,
    },
    #[error(
        "rule \"{rule}\" is not made for \"{vehicle}\" of load model \"{model}\": write a vehicle of {made_for}, or a rule that is \
         made for it ({others}), or give its factors under this rule in a file of your own ([[under]] of a vehicle file, \
         [[loads]] of a rule file)"
    )]
    Pairing {
        /// As written.
        vehicle: String,
        /// Its load model.
        model: String,
        rule: String,
        /// Load models that the rule is made for.
        made_for: String,
        /// Rules that are made for the load model.
        others: String,
    },
    #[error(
        "\"{vehicle}\" is not made for spans over {longest} m, and this bridge has one of {span} m: {reason}: write a vehicle that \
         is made for this span, or the loading's whole train in a file of your own"
    )]
    Span {
        /// As written.
        vehicle: String,
        /// Longest span of the model, in metres.
        longest: String,
        /// Longest span of the bridge, in metres.
        span: String,
        /// Why not longer ones.
        reason: String,
    },
    #[error("{0}")]
    File(String),
}

/// Everything that keeps vehicles or a rule from being had.
#[derive(Debug, Clone, PartialEq, Eq, Default, thiserror::Error)]
#[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))]
pub struct Refused(pub Vec<Unknown>);

impl From<Unknown> for Refused {
    fn from(unknown: Unknown) -> Refused {
        Refused(vec![unknown])
    }
}

/// The library with the trains of passages, whose axles weigh by `gravity` [m/s^2].
///
/// # Errors
/// What is wrong with the files of the library.
pub fn library(gravity: f64) -> Result<Library, Refused> {
    let mut library = own_library()?;
    let vehicles = bridge::train::LIBRARY.iter().filter_map(|train| {
        let vehicles = bridge::train::read_toml(train.text.as_bytes()).vehicles?;
        let whole = bridge::train::Train { name: train.name.to_owned(), file: None, vehicles };
        let axles: Vec<(f64, f64)> = whole.axles(gravity).iter().map(|axle| (axle.force, axle.offset)).collect();
        Some(Vehicle::of_axles(train.name, train.about, &axles, SLEEPER, GAUGE))
    });
    library.models.push(LoadModel {
        code: TRAINS.to_owned(),
        title: "Trains of passages".to_owned(),
        ways: Ways::Rail,
        source: Source {
            text: "the files of crates/bridge/data/trains/, each with its own sources and assumptions".to_owned(),
            date: "2026".to_owned(),
            confidence: Confidence::Assumed,
            note: "axle loads are the railway paper's, spacings are assumed".to_owned(),
        },
        vehicles: vehicles.collect(),
        grades: String::new(),
        published: Vec::new(),
        checked: Vec::new(),
        span_limit: None,
        abreast: Vec::new(),
        only_by_name: false,
        under: Vec::new(),
        left_out: Vec::new(),
        loading: String::new(),
    });
    Ok(library)
}

/// The library without them.
pub(crate) fn own_library() -> Result<Library, Refused> {
    rules::library().map_err(|problems| Refused(of_files(problems).collect()))
}

/// A vehicle that a sweep moves, the load model it belongs to, and what the rule does with its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// Code of its load model.
    pub model: String,
    /// On what it drives.
    pub ways: Ways,
    /// The vehicle.
    pub vehicle: Vehicle,
    /// The grade of a bridge that carries it, where its model has grades.
    pub grade: Option<Grade>,
    /// What the rule does with its loads.
    pub acting: Acting,
    /// Shares of its axle loads in the first lane, the second and so on; all whole where none are given.
    pub abreast: Vec<f64>,
    /// What stands in the lanes beside it, where that was asked for and found.
    pub beside: Option<BesideLane>,
    /// Where the vehicle is from.
    pub source: Source,
}

/// Normal traffic in the lanes beside an abnormal vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct BesideLane {
    /// The vehicle that is worst there.
    pub code: String,
    /// What it is worth in terms of the first vehicle, on the same width.
    pub share: f64,
    /// Distance between their middles [m].
    pub apart: f64,
    /// How much narrower the width is that carries it alone [m].
    pub narrower: f64,
}

/// Vehicles that a rule puts into the lanes beside; why they cannot be had.
pub(crate) fn named_beside(
    bridge: &Bridge,
    plan: &SweepPlan,
    rule: &Rule,
    codes: &[String],
) -> Result<Vec<Chosen>, Refused> {
    let Read { library, .. } = read(bridge, plan)?;
    let mut list = Vec::new();
    for code in codes {
        let found = of_name(&library, code);
        if found.is_empty() {
            let known: Vec<&str> = library.models.iter().map(|model| model.code.as_str()).collect();
            return Err(Unknown::Vehicle { code: code.clone(), near: near(code, &known) }.into());
        }
        for (model, vehicle) in found {
            list.push(taken(bridge, rule, &library, model, vehicle)?);
        }
    }
    Ok(list)
}

/// The vehicles of a load model, or the vehicle, that bears a name.
fn of_name<'l>(library: &'l Library, code: &str) -> Vec<(&'l LoadModel, &'l Vehicle)> {
    match library.model(code) {
        Some(model) => model.vehicles.iter().map(|vehicle| (model, vehicle)).collect(),
        None => library.vehicle(code).into_iter().collect(),
    }
}

/// The vehicles of a load model under the rule of a plan.
///
/// # Errors
/// No such model, or one that does not go with the rule or with spans as long as these.
pub(crate) fn of_model(bridge: &Bridge, plan: &SweepPlan, rule: &Rule, code: &str) -> Result<Vec<Chosen>, Refused> {
    let Read { library, .. } = read(bridge, plan)?;
    let unknown = || Unknown::Vehicle { code: code.to_owned(), near: String::new() };
    let model = library.model(code).ok_or_else(unknown)?;
    model.vehicles.iter().map(|vehicle| Ok(taken(bridge, rule, &library, model, vehicle)?)).collect()
}

/// What a plan has to choose from.
pub(crate) struct Read {
    /// The rule of the plan, where there is one.
    pub rule: Option<Rule>,
    /// The library, and after it the load models of the plan's own files.
    pub library: Library,
    /// How many load models are the library's.
    pub own: usize,
    /// Whether every file of vehicles could be used: a name that is missing otherwise may stand in one that could not.
    whole: bool,
    /// What is wrong.
    wrong: Vec<Unknown>,
}

pub(crate) fn read(bridge: &Bridge, plan: &SweepPlan) -> Result<Read, Refused> {
    let library = library(bridge.gravity)?;
    let (mut wrong, mut texts) = (Vec::new(), plan.texts.iter());
    let text = plan.rule_file.as_ref().and_then(|_| texts.next());
    let rule = rule_of(&library, plan, text).map_err(|found| wrong = found).ok();
    if let Some(base) = rule.as_ref().map(|rule| &rule.based_on).filter(|base| !base.is_empty())
        && library.rule(base).is_none()
    {
        wrong.push(no_rule(&library, base));
    }
    if let Some(code) = rule.as_ref().and_then(|rule| rule.restrictions.as_ref())
        && library.model(code).is_none()
    {
        let known: Vec<&str> = library.models.iter().map(|model| model.code.as_str()).collect();
        wrong.push(Unknown::Vehicle { code: code.clone(), near: near(code, &known) });
    }
    let mut read = Read { rule, own: library.models.len(), library, whole: true, wrong };
    for (name, text) in texts {
        match rules::read_load_model(name, text) {
            Ok(model) => {
                let levels = model.vehicles.iter().any(|vehicle| !vehicle.with.is_empty());
                read.library.models.push(model);
                if levels {
                    read.wrong.extend(of_files(read.library.join_levels()));
                }
            }
            Err(problems) => {
                read.whole = false;
                read.wrong.extend(of_files(problems));
            }
        }
    }
    Ok(read)
}

/// The rule of a plan: of its own file, where it names one, or of the library.
fn rule_of(library: &Library, plan: &SweepPlan, text: Option<&(String, String)>) -> Result<Rule, Vec<Unknown>> {
    let mut rule = written(library, plan, text)?;
    if let Some(value) = plan.condition_factor {
        let source = Source {
            text: "condition_factor of [sweep]: judged by the barrel's inspector".to_owned(),
            date: String::new(),
            confidence: Confidence::Read,
            note: String::new(),
        };
        rule.factors.condition = Factor { value, source };
    }
    Ok(rule)
}

/// The same as it is written.
fn written(library: &Library, plan: &SweepPlan, text: Option<&(String, String)>) -> Result<Rule, Vec<Unknown>> {
    if plan.rule_file.is_none() {
        return library.rule(&plan.rule).cloned().ok_or_else(|| vec![no_rule(library, &plan.rule)]);
    }
    let unread = || vec![Unknown::File("the file of the rule was not read".into())];
    let (name, text) = text.ok_or_else(unread)?;
    rules::read_rule(name, text).map_err(|problems| of_files(problems).collect())
}

/// Nothing in the library bears this rule's name.
pub fn no_rule(library: &Library, code: &str) -> Unknown {
    let known: Vec<&str> = library.rules.iter().map(|rule| rule.code.as_str()).collect();
    Unknown::Rule { code: code.to_owned(), near: near(code, &known), known: known.join(", ") }
}

/// The rule and the vehicles that a plan asks for. Without names these are all of the library that the rule is made for
/// and whose spans are not exceeded (of the trains the short one, which holds all that the long one repeats), and all of the
/// plan's own files. Everything that is wrong is told at once.
///
/// # Errors
/// All of it: files, a rule or vehicles that cannot be used, or that do not go together or with spans as long as these.
pub fn chosen(bridge: &Bridge, plan: &SweepPlan) -> Result<(Rule, Vec<Chosen>), Refused> {
    let Read { rule, library, own, whole, mut wrong } = read(bridge, plan)?;
    let mut vehicles: Vec<Chosen> = Vec::new();
    if plan.vehicles.is_empty() {
        for (k, model) in library.models.iter().enumerate() {
            let taken_up = !model.only_by_name || completes(rule.as_ref(), model, &library.models);
            let wanted =
                model.vehicles.iter().filter(|v| taken_up && (model.code != TRAINS || v.code == "paper-short"));
            for vehicle in wanted {
                match rule.as_ref().map(|rule| taken(bridge, rule, &library, model, vehicle)) {
                    Some(Ok(chosen)) => vehicles.push(chosen),
                    Some(Err(unknown)) if k >= own => wrong.push(unknown),
                    _ => {}
                }
            }
        }
    }
    for code in &plan.vehicles {
        let found = of_name(&library, code);
        if found.is_empty() && whole {
            let vehicles = library.vehicles().map(|(_, vehicle)| vehicle.code.as_str());
            let known: Vec<&str> = vehicles.chain(library.models.iter().map(|model| model.code.as_str())).collect();
            wrong.push(Unknown::Vehicle { code: code.clone(), near: near(code, &known) });
        }
        for (model, vehicle) in found {
            match rule.as_ref().map(|rule| taken(bridge, rule, &library, model, vehicle)) {
                Some(Ok(new)) if !vehicles.contains(&new) => vehicles.push(new),
                Some(Err(unknown)) => {
                    // One refusal a load model and name says it.
                    let unknown = named(unknown, code);
                    if !wrong.contains(&unknown) {
                        wrong.push(unknown);
                    }
                }
                _ => {}
            }
        }
    }
    match rule {
        Some(rule) if wrong.is_empty() && vehicles.is_empty() => {
            let reason = format!("no vehicle of the library goes with rule \"{}\" on spans like these", rule.code);
            Err(Unknown::File(reason).into())
        }
        Some(rule) if wrong.is_empty() => Ok((rule, vehicles)),
        _ => Err(Refused(wrong)),
    }
}

/// Whether a model that is taken by name alone belongs to a loading of which another model is taken anyway: a rule with safety asks for
/// all cases of a loading.
fn completes(rule: Option<&Rule>, model: &LoadModel, models: &[LoadModel]) -> bool {
    let safe = rule.is_some_and(|rule| rule.factors.live_load.is_safety());
    let begun = |other: &LoadModel| !other.only_by_name && other.loading == model.loading;
    safe && !model.loading.is_empty() && models.iter().any(begun)
}

/// Load models that a plan without names leaves out because a span is too long for them: why.
pub fn left_out(bridge: &Bridge, plan: &SweepPlan) -> Vec<TooLong> {
    let Ok(Read { rule: Some(rule), library, .. }) = read(bridge, plan) else { return Vec::new() };
    if !plan.vehicles.is_empty() {
        return Vec::new();
    }
    let made_for = library.models.iter().filter(|model| !model.only_by_name && rule.acting(model).is_some());
    made_for
        .filter_map(|model| {
            let limit = model.span_limit.as_ref().filter(|limit| longest(bridge) > limit.longest_m)?;
            Some(TooLong { model: model.code.clone(), longest: limit.longest_m, reason: limit.reason.clone() })
        })
        .collect()
}

/// Whether the spans are no longer than a model is made for.
pub fn applicable(bridge: &Bridge, model: &LoadModel) -> bool {
    model.span_limit.as_ref().is_none_or(|limit| longest(bridge) <= limit.longest_m + 1e-9)
}

fn longest(bridge: &Bridge) -> f64 {
    bridge.spans.iter().map(|span| span.span).fold(0.0, f64::max)
}

/// A vehicle as the rule takes it; why it does not.
fn taken(
    bridge: &Bridge,
    rule: &Rule,
    library: &Library,
    model: &LoadModel,
    vehicle: &Vehicle,
) -> Result<Chosen, Unknown> {
    let acting = rule.acting(model).ok_or_else(|| {
        let others = library.rules.iter().filter(|other| other.acting(model).is_some());
        let others: Vec<&str> = others.map(|other| other.code.as_str()).collect();
        let made_for = rule.models();
        Unknown::Pairing {
            vehicle: vehicle.code.clone(),
            model: model.code.clone(),
            rule: rule.code.clone(),
            made_for: if made_for.is_empty() { "its own ways".to_owned() } else { made_for.join(", ") },
            others: if others.is_empty() { "the library has none".to_owned() } else { others.join(", ") },
        }
    })?;
    if let Some(limit) = model.span_limit.as_ref().filter(|limit| longest(bridge) > limit.longest_m + 1e-9) {
        return Err(Unknown::Span {
            vehicle: vehicle.code.clone(),
            longest: limit.longest_m.to_string(),
            span: ((1e3 * longest(bridge)).round() / 1e3).to_string(),
            reason: limit.reason.clone(),
        });
    }
    Ok(Chosen {
        model: model.code.clone(),
        ways: model.ways,
        vehicle: vehicle.clone(),
        grade: grade(model, vehicle),
        acting,
        abreast: model.abreast.clone(),
        beside: None,
        source: model.source_of(vehicle).clone(),
    })
}

/// The grade of a bridge that carries a vehicle, and its rank among those of the model.
fn grade(model: &LoadModel, vehicle: &Vehicle) -> Option<Grade> {
    let rank = model.vehicles.iter().position(|other| other.code == vehicle.code)?;
    let has_one = !model.grades.is_empty() && !vehicle.grade.is_empty();
    has_one.then(|| Grade { of: model.grades.clone(), name: vehicle.grade.clone(), rank })
}

/// A refusal of the name that was written.
fn named(mut unknown: Unknown, code: &str) -> Unknown {
    if let Unknown::Pairing { vehicle, .. } | Unknown::Span { vehicle, .. } = &mut unknown {
        code.clone_into(vehicle);
    }
    unknown
}

/// How many names are suggested for one that nothing bears.
const SUGGESTED: usize = 4;

/// Names that are close, nearest first, with a comma: those that begin with what was written, and those that differ by two letters, in short
/// words by one.
fn near(written: &str, known: &[&str]) -> String {
    let written = written.to_ascii_lowercase();
    let allowed = if written.len() > 5 { 2 } else { 1 };
    let mut close: Vec<(usize, &str)> = known
        .iter()
        .map(|name| (strsim::levenshtein(&written, name), *name))
        .filter(|(apart, name)| *apart <= allowed || (!written.is_empty() && name.starts_with(&written)))
        .collect();
    close.sort_unstable();
    close.dedup();
    close.iter().take(SUGGESTED).map(|(_, name)| format!("\"{name}\", or ")).collect()
}

/// What is wrong with files.
fn of_files(problems: Vec<rules::Problem>) -> impl Iterator<Item = Unknown> {
    problems.into_iter().map(|problem| Unknown::File(problem.to_string()))
}
