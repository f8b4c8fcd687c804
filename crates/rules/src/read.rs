//! Files of load models and rules, read with complaints that name file and key.

use crate::plausible::{self, Range};
use crate::shape::Shape;
use crate::walk::{differences, line_of};
use crate::{Confidence, EffectiveWidth, Extent, Factor, Impact, LoadModel, Published, Rule, Source, Spacing, Vehicle};
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
///
/// # Errors
/// All that is wrong with the file.
pub fn read_load_model(file: &str, text: &str) -> Result<LoadModel, Vec<Problem>> {
    let model: LoadModel = parse(file, text, LoadModel::SHAPE)?;
    let mut found = Complaints { file, text, problems: Vec::new() };
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
        let told = vehicle.grade.is_empty() || !model.grades.is_empty();
        found.need(
            told,
            &format!("vehicle[{k}].grade"),
            "write at the head of the file what it is a grade of: grades = \"…\"",
        );
    }
    if let Some(limit) = &model.span_limit {
        found.source("span_limit.source", &limit.source);
        let longest = limit.longest_m > 0.0 && limit.longest_m.is_finite();
        found.need(longest, "span_limit.longest_m", "the longest span is a positive number");
    }
    found.need(
        shares(&model.abreast),
        "abreast",
        "shares of lanes are numbers of 0 or more, the first of them positive",
    );
    for (k, under) in model.under.iter().enumerate() {
        found.acting(&format!("under[{k}]"), Some(&under.live_load), &under.impact, &under.presence);
    }
    for (name, tables) in [("published", &model.published), ("checked", &model.checked)] {
        for (k, table) in tables.iter().enumerate() {
            found.table(&format!("{name}[{k}]"), table, &model);
        }
    }
    for (k, table) in model.published.iter().enumerate() {
        let by_somebody = table.source.confidence != Confidence::Calculated;
        found.need(
            by_somebody,
            &format!("published[{k}].source"),
            "numbers that were worked out by hand stand in [[checked]]; [[published]] is what somebody else printed",
        );
    }
    found.done(model)
}

/// Reads a file of a rule.
///
/// # Errors
/// All that is wrong with the file.
pub fn read_rule(file: &str, text: &str) -> Result<Rule, Vec<Problem>> {
    let rule: Rule = parse(file, text, Rule::SHAPE)?;
    let mut found = Complaints { file, text, problems: Vec::new() };
    found.source("source", &rule.source);
    found.need(!rule.code.is_empty(), "code", "give the rule a name, as \"my-rule\"");
    found.need(!rule.ways.is_empty(), "ways", "say what the rule is made for: [\"road\"], [\"rail\"] or both");
    for ((name, factor), range) in rule.listed().into_iter().zip(plausible::LISTED) {
        found.factor(&format!("factors ({name})"), factor, range);
    }
    for (k, requirement) in rule.requires.iter().enumerate() {
        found.source(&format!("requires[{k}].source"), &requirement.source);
    }
    if let Some(most) = rule.dispersal.strip_at_most_m {
        found.need(most > 0.0 && most.is_finite(), "dispersal.strip_at_most_m", "the width of a strip is positive");
    }
    let d = &rule.dispersal;
    found.source("dispersal.source", &d.source);
    let sizes = [d.length_base_m, d.length_per_depth, d.width_base_m, d.width_per_depth];
    found.need(
        sizes.iter().all(|v| v.is_finite() && *v >= 0.0) && d.length_base_m > 0.0,
        "dispersal",
        "lengths and widths are numbers of 0 or more, and length_base_m is positive",
    );
    found.within("dispersal.length_per_depth", plausible::GROWTH, d.length_per_depth);
    found.within("dispersal.width_per_depth", plausible::GROWTH, d.width_per_depth);
    found.within("dispersal.length_base_m", plausible::BASE, d.length_base_m);
    found.within("dispersal.width_base_m", plausible::ACROSS, d.width_base_m);
    let least = (0.0..100.0).contains(&d.least_depth_m);
    found.need(least, "dispersal.least_depth_m", "the depth from which on loads spread is 0 or more, in metres");
    if let Some(impact) = &rule.impact {
        found.impact("impact", impact);
    }
    for (k, loads) in rule.loads.iter().enumerate() {
        let at = format!("loads[{k}]");
        found.need(!loads.models.is_empty(), &format!("{at}.models"), "name the load models, as [\"cs-454\"]");
        found.acting(&at, loads.live_load.as_ref(), &loads.impact, &loads.presence);
        if let Some(overload) = &loads.overload {
            found.source(&format!("{at}.overload.source"), &overload.source);
            let ordered = overload.others >= 1.0 && overload.critical >= overload.others && overload.critical <= 3.0;
            found.need(
                ordered,
                &format!("{at}.overload"),
                "1 <= others <= critical <= 3, as { critical = 1.2, others = 1.1 }",
            );
        }
        if let Some(beside) = &loads.beside {
            found.source(&format!("{at}.beside.source"), &beside.source);
            let possible = !beside.vehicles.is_empty() && beside.share > 0.0 && beside.share <= 1.0;
            found.need(
                possible,
                &format!("{at}.beside"),
                "name what stands beside, and a share of it from above 0 to 1",
            );
        }
    }
    found.need(
        rule.impact.is_some() || !rule.loads.is_empty(),
        "loads",
        "say what the rule is made for: [[loads]] with models and impact, or a general [impact]",
    );
    let (EffectiveWidth::Dispersed { source }
    | EffectiveWidth::Barrel { source }
    | EffectiveWidth::Fixed { source, .. }) = &rule.effective_width;
    found.source("effective_width.source", source);
    if let EffectiveWidth::Fixed { width_m, .. } = &rule.effective_width {
        found.need(*width_m > 0.0 && width_m.is_finite(), "effective_width.width_m", "the width is positive");
    }
    found.done(rule)
}

fn parse<T: DeserializeOwned>(file: &str, text: &str, shape: &'static Shape) -> Result<T, Vec<Problem>> {
    let wrong = differences(file, text, shape);
    if !wrong.is_empty() {
        return Err(wrong);
    }
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
    text: &'a str,
    problems: Vec<Problem>,
}

impl Complaints<'_> {
    /// One complaint a key says it.
    fn need(&mut self, holds: bool, key: &str, message: &str) {
        if !holds && !self.problems.iter().any(|problem| problem.key == key) {
            let line = line_of(self.text, key);
            let (file, key, message) = (self.file.to_owned(), key.to_owned(), message.to_owned());
            self.problems.push(Problem { file, key, line, message });
        }
    }

    fn source(&mut self, key: &str, source: &Source) {
        let said = !source.text.trim().is_empty() && !source.date.trim().is_empty();
        self.need(said, key, "say where the number is from: text and date must not be empty");
    }

    fn factor(&mut self, key: &str, factor: &Factor, range: Range) {
        self.source(key, &factor.source);
        self.within(key, range, factor.value);
    }

    /// A value that is impossible is refused; what is doubtful is told elsewhere.
    fn within(&mut self, key: &str, range: Range, value: f64) {
        let [least, most] = range.possible;
        let message = format!("{value} is impossible: {}; write a number from {least} to {most}", range.says);
        self.need((least..=most).contains(&value), key, &message);
    }

    /// What a rule does with the loads of models.
    fn acting(&mut self, at: &str, live_load: Option<&Factor>, impact: &Impact, presence: &[f64]) {
        if let Some(factor) = live_load {
            self.factor(&format!("{at}.live_load"), factor, plausible::LIVE);
        }
        self.impact(&format!("{at}.impact"), impact);
        for factor in presence {
            self.within(&format!("{at}.presence"), plausible::PRESENCE, *factor);
        }
    }

    fn impact(&mut self, at: &str, impact: &Impact) {
        for source in impact.sources() {
            self.source(&format!("{at}.source"), source);
        }
        for factor in plausible::greatest(impact) {
            self.within(at, plausible::MOTION, factor);
        }
        let fill_possible = |fill: &crate::FillReduction| {
            fill.depth_m > 0.0 && fill.vanishing_m > 0.0 && (0.0..=1.0).contains(&fill.share)
        };
        let numbers = |list: &[f64]| list.iter().all(|v| v.is_finite() && *v >= 0.0);
        let (possible, said, fill) = match impact {
            Impact::Augment { base, numerator_m, addend_m, most, fill, .. } => (
                numbers(&[*base, *numerator_m, *addend_m, *most]) && *addend_m > 0.0,
                "base, numerator_m, addend_m and most are numbers of 0 or more, and addend_m is positive",
                fill.as_ref(),
            ),
            Impact::AllAxles { fill, .. } => (true, "", fill.as_ref()),
            Impact::Root { numerator, subtrahend, constant, share, least, most, cover, .. } => (
                numbers(&[*numerator, *subtrahend, *constant, *share, *least, *most])
                    && *share > 0.0
                    && least <= most
                    && cover.as_ref().is_none_or(|cover| numbers(&[cover.from_m, cover.per_m])),
                "numbers are 0 or more, share is positive, and least is not above most",
                None,
            ),
            Impact::CriticalAxle { .. } | Impact::Included { .. } => (true, "", None),
        };
        self.need(possible, at, said);
        self.need(
            fill.is_none_or(fill_possible),
            &format!("{at}.fill"),
            "depth_m and vanishing_m are positive, and share lies between 0 and 1",
        );
    }

    /// A table of numbers over spans.
    fn table(&mut self, at: &str, table: &Published, model: &LoadModel) {
        self.source(&format!("{at}.source"), &table.source);
        let known = model.vehicle(&table.vehicle).is_some();
        let paired = table.spans_m.len() == table.values.len() && !table.spans_m.is_empty();
        let positive = table.spans_m.iter().chain(&table.values).all(|v| v.is_finite() && *v > 0.0);
        let close = table.tolerance > 0.0 && table.tolerance < 1.0;
        let inside = table.section.is_none_or(|x| x > 0.0 && x < 1.0) && (0.0..1.0).contains(&table.above);
        for (holds, key, message) in [
            (known, "vehicle", "no vehicle of this file has this code"),
            (paired, "values", "give as many values as spans, one at least"),
            (positive, "spans_m", "spans and values are positive numbers"),
            (close, "tolerance", "the tolerance is a share between 0 and 1, as 2e-4"),
            (inside, "section", "a section is a share of the span between 0 and 1, and so is above"),
        ] {
            self.need(holds, &format!("{at}.{key}"), message);
        }
    }

    fn vehicle(&mut self, at: &str, vehicle: &Vehicle) {
        let n = vehicle.axle_loads_kn.len();
        let key = |name: &str| format!("{at}.{name}");
        self.need(!vehicle.code.is_empty(), &key("code"), "give the vehicle a name, as \"hb-45\"");
        self.need(
            (1..=MOST_AXLES).contains(&n) && vehicle.axle_loads_kn.iter().all(|p| *p > 0.0 && p.is_finite())
                || n == 0 && !vehicle.uniform.is_empty(),
            &key("axle_loads_kn"),
            "give one axle load at least, each positive, as [245.25, 245.25], or [] with uniform loads",
        );
        for load in &vehicle.axle_loads_kn {
            self.within(&key("axle_loads_kn"), plausible::AXLE, *load);
        }
        for distance in vehicle.spacings_m.iter().flat_map(|spacing| spacing.range()) {
            self.within(&key("spacings_m"), plausible::DISTANCE, distance);
        }
        self.need(
            vehicle.spacings_m.len() == n.saturating_sub(1),
            &key("spacings_m"),
            &format!("{n} axles have {} distances, this vehicle has {}", n.max(1) - 1, vehicle.spacings_m.len()),
        );
        let possible = |s: &Spacing| match *s {
            Spacing::Fixed(_) => true,
            Spacing::Range { from, to, step } => to >= from && step > 0.0,
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
        for factor in vehicle.lift_off.iter().flatten() {
            self.within(&key("lift_off"), plausible::LIFT_OFF, *factor);
        }
        self.within(&key("wheel_track_m"), plausible::TRACK, vehicle.wheel_track_m);
        self.within(&key("contact_length_m"), plausible::CONTACT, vehicle.contact_length_m);
        for (k, u) in vehicle.uniform.iter().enumerate() {
            self.within(&format!("{at}.uniform[{k}].load_kn_per_m"), plausible::UNIFORM, u.load_kn_per_m);
            if let Some(width) = u.width_m {
                self.within(&format!("{at}.uniform[{k}].width_m"), plausible::WIDTH, width);
            }
            self.need(
                u.load_kn_per_m > 0.0
                    && u.load_kn_per_m.is_finite()
                    && u.gap_m >= 0.0
                    && u.gap_m.is_finite()
                    && u.width_m.is_none_or(|w| w > 0.0 && w.is_finite()),
                &format!("{at}.uniform[{k}]"),
                "load_kn_per_m and width_m are positive and gap_m is 0 or more",
            );
            self.need(
                match u.length_m {
                    Some(length) => u.place == Extent::Part && length > 0.0 && length.is_finite(),
                    None => u.place != Extent::Part,
                },
                &format!("{at}.uniform[{k}].length_m"),
                "give a positive length_m with place = \"part\", and with no other place",
            );
        }
        self.need((1..=10).contains(&vehicle.lanes), &key("lanes"), "a vehicle occupies 1 lane or a few");
        if let Some(source) = &vehicle.source {
            self.source(&key("source"), source);
        }
    }

    fn done<T>(self, value: T) -> Result<T, Vec<Problem>> {
        if self.problems.is_empty() { Ok(value) } else { Err(self.problems) }
    }
}

/// Whether these may be the shares of lanes.
fn shares(list: &[f64]) -> bool {
    list.iter().all(|share| *share >= 0.0 && share.is_finite()) && list.first().is_none_or(|first| *first > 0.0)
}

/// How many distances of a spacing are tried, before they are listed.
fn tried(spacing: &Spacing) -> f64 {
    match *spacing {
        Spacing::Fixed(_) => 1.0,
        Spacing::Range { from, to, step } => ((to - from) / step).ceil() + 1.0,
    }
}
