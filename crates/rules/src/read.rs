//! Files of load models and rules, read with complaints that name file and key.

use crate::{Factor, LoadModel, Rule, Source, Spacing, Vehicle};
use serde::de::DeserializeOwned;
use std::fmt;

/// What is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The file.
    pub file: String,
    /// The key, as a path; empty where the text cannot be read at all.
    pub key: String,
    /// Line, from 1; 0 where it is not known.
    pub line: usize,
    /// What is wrong, and what to write instead.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        if self.line > 0 {
            write!(f, ", line {}", self.line)?;
        }
        if !self.key.is_empty() {
            write!(f, ", {}", self.key)?;
        }
        write!(f, ": {}", self.message)
    }
}

/// Most axles of one vehicle, and most arrangements: more are a slip of the pen.
const MOST_AXLES: usize = 1000;
const MOST_PATTERNS: usize = 1000;

/// Reads a file of vehicles.
pub fn read_load_model(file: &str, text: &str) -> Result<LoadModel, Vec<Problem>> {
    let model: LoadModel = parse(file, text)?;
    let mut found = Complaints { file, problems: Vec::new() };
    found.source("source", &model.source);
    found.need(!model.code.is_empty(), "code", "give the load model a name, as \"my-vehicle\"");
    found.need(
        !model.vehicles.is_empty(),
        "vehicle",
        "there is no vehicle: write [[vehicle]] with code, title, axle_loads_kn, spacings_m and the rest",
    );
    for (k, vehicle) in model.vehicles.iter().enumerate() {
        let twice = model.vehicles[..k].iter().any(|other| other.code == vehicle.code);
        found.need(!twice, &format!("vehicle[{k}].code"), "another vehicle of this file has the same code");
        found.vehicle(&format!("vehicle[{k}]"), vehicle);
    }
    for (k, table) in model.published.iter().enumerate() {
        let at = format!("published[{k}]");
        found.source(&format!("{at}.source"), &table.source);
        found.need(
            model.vehicle(&table.vehicle).is_some(),
            &format!("{at}.vehicle"),
            "no vehicle of this file has this code",
        );
        let paired = table.spans_m.len() == table.values.len() && !table.spans_m.is_empty();
        found.need(paired, &format!("{at}.values"), "give as many values as spans, one at least");
        found.need(
            table.spans_m.iter().chain(&table.values).all(|v| v.is_finite() && *v > 0.0),
            &format!("{at}.spans_m"),
            "spans and values are positive numbers",
        );
        found.need(
            table.tolerance > 0.0 && table.tolerance < 1.0,
            &format!("{at}.tolerance"),
            "the tolerance is a share between 0 and 1, as 2e-4",
        );
    }
    found.done(model)
}

/// Reads a file of a rule.
pub fn read_rule(file: &str, text: &str) -> Result<Rule, Vec<Problem>> {
    let rule: Rule = parse(file, text)?;
    let mut found = Complaints { file, problems: Vec::new() };
    found.source("source", &rule.source);
    found.need(!rule.code.is_empty(), "code", "give the rule a name, as \"my-rule\"");
    found.need(!rule.ways.is_empty(), "ways", "say what the rule is made for: [\"road\"], [\"rail\"] or both");
    for (name, factor) in rule.listed() {
        found.factor(&format!("factors ({name})"), factor);
    }
    let d = &rule.dispersal;
    found.source("dispersal.source", &d.source);
    let sizes = [d.length_base_m, d.length_per_depth, d.width_base_m, d.width_per_depth];
    found.need(
        sizes.iter().all(|v| v.is_finite() && *v >= 0.0) && d.length_base_m > 0.0,
        "dispersal",
        "lengths and widths are numbers of 0 or more, and length_base_m is positive",
    );
    match &rule.impact {
        crate::Impact::Augment { base, numerator_m, addend_m, most, fill, source } => {
            found.source("impact.source", source);
            found.need(
                [*base, *numerator_m, *addend_m, *most].iter().all(|v| v.is_finite() && *v >= 0.0) && *addend_m > 0.0,
                "impact",
                "base, numerator_m, addend_m and most are numbers of 0 or more, and addend_m is positive",
            );
            if let Some(fill) = fill {
                found.source("impact.fill.source", &fill.source);
                found.need(
                    fill.depth_m > 0.0 && fill.vanishing_m > 0.0 && (0.0..=1.0).contains(&fill.share),
                    "impact.fill",
                    "depth_m and vanishing_m are positive, and share lies between 0 and 1",
                );
            }
        }
        crate::Impact::AllAxles { .. } | crate::Impact::CriticalAxle { .. } => {}
    }
    match &rule.effective_width {
        crate::EffectiveWidth::Fixed { width_m, source } => {
            found.source("effective_width.source", source);
            found.need(*width_m > 0.0 && width_m.is_finite(), "effective_width.width_m", "the width is positive");
        }
        crate::EffectiveWidth::Dispersed { source } | crate::EffectiveWidth::Barrel { source } => {
            found.source("effective_width.source", source);
        }
    }
    found.done(rule)
}

fn parse<T: DeserializeOwned>(file: &str, text: &str) -> Result<T, Vec<Problem>> {
    toml::from_str(text).map_err(|error| {
        let line = error.span().map_or(0, |span| 1 + text[..span.start.min(text.len())].matches('\n').count());
        let key = error.span().and_then(|span| key_at(text, span.start)).unwrap_or_default();
        vec![Problem { file: file.to_owned(), key, line, message: error.message().to_owned() }]
    })
}

/// The key of the line that a place of the text is in.
fn key_at(text: &str, at: usize) -> Option<String> {
    let from = text.get(..at)?.rfind('\n').map_or(0, |k| k + 1);
    let line = text.get(from..)?.lines().next()?;
    Some(line.split('=').next()?.trim().to_owned())
}

struct Complaints<'a> {
    file: &'a str,
    problems: Vec<Problem>,
}

impl Complaints<'_> {
    fn need(&mut self, holds: bool, key: &str, message: &str) {
        if !holds {
            let (file, key, message) = (self.file.to_owned(), key.to_owned(), message.to_owned());
            self.problems.push(Problem { file, key, line: 0, message });
        }
    }

    fn source(&mut self, key: &str, source: &Source) {
        let said = !source.text.trim().is_empty() && !source.date.trim().is_empty();
        self.need(said, key, "say where the number is from: text and date must not be empty");
    }

    fn factor(&mut self, key: &str, factor: &Factor) {
        self.source(key, &factor.source);
        let possible = factor.value > 0.0 && factor.value.is_finite();
        self.need(possible, key, "a factor is a positive number");
    }

    fn vehicle(&mut self, at: &str, vehicle: &Vehicle) {
        let n = vehicle.axle_loads_kn.len();
        let key = |name: &str| format!("{at}.{name}");
        self.need(!vehicle.code.is_empty(), &key("code"), "give the vehicle a name, as \"hb-45\"");
        self.need(
            (1..=MOST_AXLES).contains(&n) && vehicle.axle_loads_kn.iter().all(|p| *p > 0.0 && p.is_finite()),
            &key("axle_loads_kn"),
            "give one axle load at least, each positive, as [245.25, 245.25]",
        );
        self.need(
            vehicle.spacings_m.len() + 1 == n,
            &key("spacings_m"),
            &format!("{n} axles have {} distances, this vehicle has {}", n.max(1) - 1, vehicle.spacings_m.len()),
        );
        let possible = |s: &Spacing| match *s {
            Spacing::Fixed(d) => d > 0.0 && d.is_finite(),
            Spacing::Range { from, to, step } => from > 0.0 && to >= from && to.is_finite() && step > 0.0,
        };
        let all = vehicle.spacings_m.iter().all(possible);
        self.need(all, &key("spacings_m"), "a distance is a positive number, or { from = 6.0, to = 26.0, step = 5.0 }");
        if all {
            let cases: f64 = vehicle.spacings_m.iter().map(tried).product::<f64>();
            self.need(
                cases * (1 + vehicle.lift_off.len()) as f64 <= MOST_PATTERNS as f64,
                &key("spacings_m"),
                &format!("{cases:.0} combinations of distances are too many: write larger steps, {MOST_PATTERNS} are the most"),
            );
        }
        self.need(
            vehicle.lift_off.iter().all(|f| f.len() == n && f.iter().all(|v| *v >= 0.0 && v.is_finite())),
            &key("lift_off"),
            "each case of lift-off has a factor for every axle, as [[1.5, 0.5]]",
        );
        for (k, u) in vehicle.uniform.iter().enumerate() {
            self.need(
                u.load_kn_per_m > 0.0 && u.load_kn_per_m.is_finite() && u.gap_m >= 0.0 && u.gap_m.is_finite(),
                &format!("{at}.uniform[{k}]"),
                "load_kn_per_m is positive and gap_m is 0 or more",
            );
        }
        self.need(
            vehicle.wheel_track_m >= 0.0 && vehicle.wheel_track_m.is_finite(),
            &key("wheel_track_m"),
            "the distance between the wheels of an axle is 0 or more",
        );
        self.need(
            vehicle.contact_length_m > 0.0 && vehicle.contact_length_m.is_finite(),
            &key("contact_length_m"),
            "the length of a footprint is positive, as 0.30",
        );
        if let Some(source) = &vehicle.source {
            self.source(&key("source"), source);
        }
    }

    fn done<T>(self, value: T) -> Result<T, Vec<Problem>> {
        if self.problems.is_empty() { Ok(value) } else { Err(self.problems) }
    }
}

/// How many distances of a spacing are tried, before they are listed.
fn tried(spacing: &Spacing) -> f64 {
    match *spacing {
        Spacing::Fixed(_) => 1.0,
        Spacing::Range { from, to, step } => ((to - from) / step).ceil() + 1.0,
    }
}
