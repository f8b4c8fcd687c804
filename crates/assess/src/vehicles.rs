//! Vehicles and rules that a bridge file can name: those of the library, the trains of passages, and an engineer's own.

use bridge::{Bridge, SweepPlan};
use rules::{Confidence, Library, LoadModel, Rule, Source, Vehicle, Ways};

/// Code of the load model that holds the trains of passages.
const TRAINS: &str = "trains";
/// Broad gauge, between the middles of the rail heads, and the breadth of a sleeper [m]: of the railway paper's trains.
const GAUGE: f64 = 1.75;
const SLEEPER: f64 = 0.25;

/// Why vehicles or a rule cannot be had.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unknown {
    /// No vehicle has this code.
    #[error(
        "there is no vehicle, load model or train \"{code}\": write one of {known}, or name its file in `vehicle_files`"
    )]
    Vehicle {
        /// As written.
        code: String,
        /// Codes that there are.
        known: String,
    },
    /// No rule has this code.
    #[error("there is no rule \"{code}\": write one of {known}, or name its file in `rule_file`")]
    Rule {
        /// As written.
        code: String,
        /// Codes that there are.
        known: String,
    },
    /// A file cannot be used.
    #[error("{0}")]
    File(String),
}

/// The library with the trains of passages, whose axles weigh by `gravity` [m/s^2].
pub fn library(gravity: f64) -> Result<Library, Unknown> {
    let mut library = rules::library().map_err(|problems| said(&problems))?;
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
        published: Vec::new(),
    });
    Ok(library)
}

/// A vehicle that a sweep moves, and the load model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// Code of its load model.
    pub model: String,
    /// On what it drives.
    pub ways: Ways,
    /// The vehicle.
    pub vehicle: Vehicle,
}

/// The rule and the vehicles that a plan asks for. Without names these are all of the library that the rule is made for
/// (of the trains the short one, which holds all that the long one repeats), and all of the plan's own files.
pub fn chosen(bridge: &Bridge, plan: &SweepPlan) -> Result<(Rule, Vec<Chosen>), Unknown> {
    let mut library = library(bridge.gravity)?;
    let mut texts = plan.texts.iter();
    let rule = match &plan.rule_file {
        Some(_) => {
            let (name, text) = texts.next().ok_or_else(|| Unknown::File("the file of the rule was not read".into()))?;
            rules::read_rule(name, text).map_err(|problems| said(&problems))?
        }
        None => library.rule(&plan.rule).cloned().ok_or_else(|| Unknown::Rule {
            code: plan.rule.clone(),
            known: library.rules.iter().map(|rule| rule.code.as_str()).collect::<Vec<_>>().join(", "),
        })?,
    };
    let own = library.models.len();
    for (name, text) in texts {
        library.models.push(rules::read_load_model(name, text).map_err(|problems| said(&problems))?);
    }
    let of = |model: &LoadModel, vehicle: &Vehicle| Chosen {
        model: model.code.clone(),
        ways: model.ways,
        vehicle: vehicle.clone(),
    };
    if plan.vehicles.is_empty() {
        let usual = library.models.iter().enumerate().flat_map(|(k, model)| {
            let fits = k >= own || rule.ways.contains(&model.ways);
            let vehicles =
                model.vehicles.iter().filter(move |v| fits && (model.code != TRAINS || v.code == "paper-short"));
            vehicles.map(move |vehicle| of(model, vehicle))
        });
        let usual: Vec<Chosen> = usual.collect();
        return Ok((rule, usual));
    }
    let mut vehicles: Vec<Chosen> = Vec::new();
    for code in &plan.vehicles {
        let found: Vec<Chosen> = match library.vehicle(code) {
            Some((model, vehicle)) => vec![of(model, vehicle)],
            None => library.model(code).map_or(Vec::new(), |m| m.vehicles.iter().map(|v| of(m, v)).collect()),
        };
        if found.is_empty() {
            let known: Vec<&str> = library.vehicles().map(|(_, v)| v.code.as_str()).collect();
            return Err(Unknown::Vehicle { code: code.clone(), known: known.join(", ") });
        }
        vehicles.extend(found.into_iter().filter(|new| !vehicles.contains(new)).collect::<Vec<_>>());
    }
    Ok((rule, vehicles))
}

fn said(problems: &[rules::Problem]) -> Unknown {
    Unknown::File(problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
}
