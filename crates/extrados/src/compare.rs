//! Two bridges side by side: what their files say differently, and what that changes.

use crate::choice::Choice;
use crate::collapse::{CollapseOptions, collapse};
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::Watch;
use bridge::inputs::{Input, inputs};
use bridge::quantity;
use findings::visible::cell;
use outcome::collapse::{Collapse, Status};
use outcome::{note, published};
use serde_json::{Value, json};
use std::fmt::Write;

/// A value that stands in one file alone, or differs.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Difference {
    /// Section, with its number where it stands several times, and key: `cover[2].thickness`; the section alone where all of it stands in
    /// one file only.
    pub path: String,
    /// As the first file writes it; none where it does not.
    pub before: Option<String>,
    /// As the second file writes it.
    pub after: Option<String>,
}

/// A number of both answers.
#[derive(Debug, Clone, PartialEq)]
pub struct Answered {
    /// What it is, with its unit at the end.
    pub name: &'static str,
    /// Of the first file.
    pub before: Option<f64>,
    /// Of the second file.
    pub after: Option<f64>,
}

impl Answered {
    /// By which share of the first the second is larger; none where either is missing or the first is nothing.
    pub fn change(&self) -> Option<f64> {
        let (before, after) = (self.before?, self.after?);
        (before != 0.0).then(|| after / before - 1.0)
    }
}

/// Two files with their answers.
#[derive(Debug, Clone)]
pub struct Compared {
    /// What differs, in the order of the first file, then what the second alone says.
    pub differences: Vec<Difference>,
    /// The answers of both analyses.
    pub answers: [Collapse; 2],
    /// The same number of both, each in its line.
    pub numbers: Vec<Answered>,
    /// Why the two answers may differ for other reasons than the bridges.
    pub cautions: Vec<String>,
    /// Assumptions that the first result alone makes, and the second alone.
    pub assumptions: [Vec<String>; 2],
}

impl Compared {
    /// The answer for scripts.
    pub fn object(&self) -> published::Object {
        let number = |one: &Answered| json!({ "name": one.name, "before": one.before, "after": one.after, "change_percent": one.change().map(|c| 100.0 * c) });
        let mut fields = published::Object::new();
        fields.insert("verdict".into(), json!(self.verdict()));
        fields.insert("cautions".into(), json!(self.cautions));
        fields.insert("differences".into(), json!(self.differences));
        fields.insert("numbers".into(), self.numbers.iter().map(number).collect());
        fields.insert("assumptions_before_only".into(), json!(self.assumptions[0]));
        fields.insert("assumptions_after_only".into(), json!(self.assumptions[1]));
        fields.insert("before".into(), Value::Object(self.answers[0].object()));
        fields.insert("after".into(), Value::Object(self.answers[1].object()));
        fields
    }

    /// The tables: what differs, and both answers number by number.
    pub(crate) fn tables(&self) -> [String; 2] {
        [differences_table(self), answers_table(self)]
    }

    /// Drawings (SVG) of both, those of each in a folder of its own: `before/mechanism`.
    pub fn drawings(&self) -> impl Iterator<Item = (String, String)> {
        ["before", "after"].into_iter().zip(&self.answers).flat_map(|(which, one)| {
            let own = figures::drawings(&one.picture).into_iter();
            own.map(move |(name, svg)| (format!("{which}/{name}"), svg))
        })
    }

    /// Which of the two carries more, in a sentence.
    pub fn verdict(&self) -> String {
        let Some(headline) = self.numbers.iter().find(|number| number.name == "headline_kn_per_m") else {
            return "no load is known to be carried by either".to_owned();
        };
        match (headline.before, headline.after, headline.change()) {
            (Some(before), Some(after), Some(change)) if change.abs() < 5e-4 => {
                format!("both carry the same: {before:.2} and {after:.2} kN/m")
            }
            (Some(before), Some(after), Some(change)) => {
                let word = if change > 0.0 { "more" } else { "less" };
                format!("the second carries {:.1} % {word}: {after:.2} against {before:.2} kN/m", 100.0 * change.abs())
            }
            (Some(before), None, _) => {
                format!("the first carries {before:.2} kN/m; no load is known to be carried by the second")
            }
            (_, Some(after), _) => {
                format!("the second carries {after:.2} kN/m; no load is known to be carried by the first")
            }
            _ => "no load is known to be carried by either".to_owned(),
        }
    }
}

fn differences_table(found: &Compared) -> String {
    let mut table = "path,before,after\n".to_owned();
    for one in &found.differences {
        let said = |value: &Option<String>| cell(value.as_deref().unwrap_or_default());
        let _ = writeln!(table, "{},{},{}", cell(&one.path), said(&one.before), said(&one.after));
    }
    table
}

fn answers_table(found: &Compared) -> String {
    let mut table = "name,before,after,change_percent\n".to_owned();
    let shown = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    for one in &found.numbers {
        let change = one.change().map(|change| 100.0 * change);
        let _ = writeln!(table, "{},{},{},{}", one.name, shown(one.before), shown(one.after), shown(change));
    }
    table
}

/// Makes the analysis that each file plans, with the same choice in place of either plan, and puts input and answers side by side.
///
/// # Errors
/// A file that cannot be used, or an analysis that cannot be set up for its bridge (F108).
pub fn compare(before: &Project, after: &Project, choice: Choice, watch: &mut dyn Watch) -> Result<Compared, Refusal> {
    // Both are refused before either is computed.
    before.bridge().and(after.bridge())?;
    let mut answer = |project: &Project| {
        watch.begin(project.name());
        collapse(project, &CollapseOptions { choice, resume: None }, watch)
    };
    let answers = [answer(before)?, answer(after)?];
    let said = [0, 1].map(|k: usize| note::words(&answers[k].assumptions));
    let only = |k: usize| said[k].iter().filter(|words| !said[1 - k].contains(words)).cloned().collect::<Vec<_>>();
    Ok(Compared {
        differences: differences(before, after),
        numbers: numbers(&answers),
        cautions: cautions(&answers),
        assumptions: [only(0), only(1)],
        answers,
    })
}

/// A table of a file with its values.
#[derive(Debug, Clone, Copy)]
struct Part<'a> {
    section: &'a str,
    inputs: &'a [Input],
}

impl<'a> Part<'a> {
    fn all(inputs: &'a [Input]) -> Vec<Part<'a>> {
        let parts = inputs.chunk_by(|a, b| a.section == b.section);
        parts.map(|inputs| Part { section: &inputs[0].section, inputs }).collect()
    }
    /// Its section without its own number: tables of one list share it.
    fn list(&self) -> &'a str {
        match self.section.rfind('[') {
            Some(at) if self.section.ends_with(']') => &self.section[..at],
            _ => self.section,
        }
    }
    fn find(&self, key: &str) -> Option<&'a Input> {
        self.inputs.iter().find(|input| input.key == key)
    }
    /// How many values of another are the same here.
    fn alike(&self, other: &Part<'_>) -> usize {
        let same = |one: &&Input| self.find(&one.key).is_some_and(|own| same_value(&own.value, &one.value));
        other.inputs.iter().filter(same).count()
    }
    fn equals(&self, other: &Part<'_>) -> bool {
        self.inputs.len() == other.inputs.len() && self.alike(other) == other.inputs.len()
    }
    /// All of it, where the other file has nothing like it.
    fn words(&self) -> String {
        let all: Vec<String> = self.inputs.iter().map(|one| format!("{} = {}", one.key, one.value)).collect();
        all.join(", ")
    }
}

/// Tables that are equal belong together, wherever they stand in their list; then those that are most alike.
fn differences(before: &Project, after: &Project) -> Vec<Difference> {
    let read = |project: &Project| inputs(std::str::from_utf8(project.text()).unwrap_or_default());
    let [first, second] = [read(before), read(after)];
    let [own, others] = [Part::all(&first), Part::all(&second)];
    let mut partner: Vec<Option<usize>> = vec![None; own.len()];
    let mut is_taken = vec![false; others.len()];
    let mut pair = |fits: &dyn Fn(&Part<'_>, &Part<'_>) -> usize| {
        for (k, part) in own.iter().enumerate().filter(|(_, part)| !part.inputs.is_empty()) {
            if partner[k].is_some() {
                continue;
            }
            let free = (0..others.len()).filter(|&j| !is_taken[j] && others[j].list() == part.list());
            let scored = free.map(|j| (fits(part, &others[j]), j)).filter(|(score, _)| *score > 0);
            // The first of the best.
            if let Some((_, j)) = scored.min_by_key(|(score, j)| (std::cmp::Reverse(*score), *j)) {
                (partner[k], is_taken[j]) = (Some(j), true);
            }
        }
    };
    pair(&|a, b| usize::from(a.equals(b)));
    // Half of the values are the same, or the table stands once in its file.
    pair(&|a, b| if 2 * a.alike(b) >= a.inputs.len().min(b.inputs.len()) { a.alike(b) } else { 0 });
    pair(&|a, b| usize::from(!a.section.ends_with(']') && !b.section.ends_with(']')));
    let mut found = Vec::new();
    for (part, other) in own.iter().zip(&partner) {
        match other {
            Some(other) => within(part, &others[*other], &mut found),
            None => found.push(whole(part, true)),
        }
    }
    let new = others.iter().zip(&is_taken).filter(|(_, taken)| !**taken);
    found.extend(new.map(|(part, _)| whole(part, false)));
    found
}

/// What differs between two tables.
fn within(own: &Part<'_>, other: &Part<'_>, found: &mut Vec<Difference>) {
    let path = |part: &Part<'_>, key: &str| {
        if part.section.is_empty() { key.to_owned() } else { format!("{}.{key}", part.section) }
    };
    for one in own.inputs {
        let after = other.find(&one.key).map(|input| input.value.clone());
        if !after.as_ref().is_some_and(|after| same_value(&one.value, after)) {
            found.push(Difference { path: path(own, &one.key), before: Some(one.value.clone()), after });
        }
    }
    for one in other.inputs.iter().filter(|one| own.find(&one.key).is_none()) {
        found.push(Difference { path: path(other, &one.key), before: None, after: Some(one.value.clone()) });
    }
}

fn whole(part: &Part<'_>, is_before: bool) -> Difference {
    let (before, after) = if is_before { (Some(part.words()), None) } else { (None, Some(part.words())) };
    Difference { path: part.section.to_owned(), before, after }
}

/// Whether two values mean the same: "0.5 m" is "500 mm".
fn same_value(a: &str, b: &str) -> bool {
    if a == b {
        return true;
    }
    let [Ok(a), Ok(b)] = [a, b].map(quantity::parse) else { return false };
    let (one, other) = (a.si(), b.si());
    a.unit.dimension == b.unit.dimension && (one - other).abs() <= 1e-12 * one.abs().max(other.abs())
}

/// Numbers of both answers that are compared.
const NUMBERS: &str = "headline_kn_per_m headline_kn last_stable_load_kn_per_m collapse_load_kn_per_m limit_load_kn_per_m \
                       max_compressive_stress_mpa hinges sliding_joints width_m";

fn numbers(both: &[Collapse; 2]) -> Vec<Answered> {
    let both = both.each_ref().map(Collapse::object);
    let all = NUMBERS.split(' ').map(|name| {
        let [before, after] = both.each_ref().map(|object| published::number(object, name));
        Answered { name, before, after }
    });
    all.filter(|one| one.before.is_some() || one.after.is_some()).collect()
}

fn cautions([before, after]: &[Collapse; 2]) -> Vec<String> {
    let mut cautions = Vec::new();
    if before.analysis() != after.analysis() {
        cautions.push("the two files seek different things: their numbers cannot be compared".to_owned());
    }
    if before.method() != after.method() {
        cautions.push(format!(
            "the answers are by different methods ({} and {}): part of the difference is the method's; give --method",
            before.method().word(),
            after.method().word()
        ));
    }
    for (one, which) in [(before, "first"), (after, "second")] {
        if one.status != Status::Collapsed {
            cautions.push(format!("the {which} analysis ended as {}", one.status.word()));
        }
    }
    let codes = |c: &Collapse| c.warnings.iter().map(|warning| warning.code()).collect::<Vec<_>>();
    for (one, other, which) in [(before, after, "first"), (after, before, "second")] {
        let theirs = codes(other);
        let mut own: Vec<&str> = codes(one).into_iter().filter(|code| !theirs.contains(code)).collect();
        own.dedup();
        if !own.is_empty() {
            cautions.push(format!("the {which} result alone warns of {}", own.join(", ")));
        }
    }
    cautions
}
