//! Named cases of a bridge file, side by side.

use crate::choice::Choice;
use crate::collapse::{CollapseOptions, collapse};
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::Watch;
use bridge::case::Case;
use findings::visible::cell;
use outcome::collapse::{Collapse, Status};
use outcome::facts::{CaseFacts, CasesFacts};
use outcome::published;
use outcome::warning::{Passed, Warning};
use serde_json::{Value, json};
use std::fmt::Write;

/// A case with its answer.
#[derive(Debug, Clone)]
pub struct CaseAnswer {
    /// Its name.
    pub name: String,
    /// What acts, with which factors: "1.35 tandem, 1 crowd; fill 0.9".
    pub told: String,
    /// The analysis.
    pub collapse: Collapse,
}

impl CaseAnswer {
    /// What all loads of the case may be multiplied by, their own factors included; zero where the bridge does not stand. None where it
    /// is not known, or no load makes a mechanism.
    pub fn factor(&self) -> Option<f64> {
        match self.collapse.status {
            Status::UnstableUnderSelfWeight => Some(0.0),
            _ => self.collapse.load_factor(),
        }
    }

    /// Whether the analysis came to an end that says what is carried.
    pub fn is_known(&self) -> bool {
        self.factor().is_some() || self.collapse.status == Status::Locks
    }
}

/// All cases of a file.
#[derive(Debug, Clone)]
pub struct Cases {
    /// In the order of the file.
    pub answers: Vec<CaseAnswer>,
}

impl Cases {
    /// The case with the least factor; none where a case has no answer, which may be the least.
    pub fn governing(&self) -> Option<&CaseAnswer> {
        if self.answers.iter().any(|one| !one.is_known()) {
            return None;
        }
        self.least()
    }

    /// For checks and reports.
    pub(crate) fn facts(&self) -> CasesFacts {
        let mut facts = CasesFacts::default();
        for one in &self.answers {
            facts.cases.push(CaseFacts {
                name: one.name.clone(),
                acts: one.told.clone(),
                status: one.collapse.status,
                method: one.collapse.method().word().to_owned(),
                load_factor: one.factor(),
            });
            let Collapse { warnings, assumptions, .. } = &one.collapse;
            let new: Vec<_> = warnings.iter().filter(|warning| !facts.warnings.contains(warning)).cloned().collect();
            facts.warnings.extend(new);
            let new: Vec<_> = assumptions.iter().filter(|note| !facts.assumptions.contains(note)).cloned().collect();
            facts.assumptions.extend(new);
        }
        facts
    }

    /// The answer for scripts.
    pub fn object(&self) -> published::Object {
        let case = |one: &CaseAnswer| {
            json!({
                "name": one.name,
                "acts": one.told,
                "load_factor": one.factor(),
                "result": Value::Object(one.collapse.object()),
            })
        };
        let mut fields = published::Object::new();
        fields.insert("governing_case".into(), json!(self.governing().map(|one| &one.name)));
        fields.insert("load_factor".into(), json!(self.governing().and_then(CaseAnswer::factor)));
        fields.insert("load_factor_at_most".into(), json!(self.least().and_then(CaseAnswer::factor)));
        fields.insert("cases".into(), self.answers.iter().map(case).collect());
        fields
    }

    /// The factors of the cases that have one, by their names.
    pub fn factors(&self) -> Vec<(String, f64)> {
        self.answers.iter().filter_map(|one| Some((one.name.clone(), one.factor()?))).collect()
    }

    /// The table: a row for each case, loads in kN/m.
    pub(crate) fn table(&self) -> String {
        let mut table = "case,acts,status,load_factor,load_kn_per_m,reference_load_kn_per_m\n".to_owned();
        let shown = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
        for one in &self.answers {
            let _ = writeln!(
                table,
                "{},{},{},{},{},{}",
                cell(&one.name),
                cell(&one.told),
                one.collapse.status,
                shown(one.factor()),
                shown(one.collapse.carried().map(|load| load / 1e3)),
                one.collapse.reference_load / 1e3
            );
        }
        table
    }

    /// Drawings (SVG) of every case, those of each in a folder of its own: `case-1/mechanism`.
    pub fn drawings(&self) -> impl Iterator<Item = (String, String)> {
        self.answers.iter().enumerate().flat_map(|(k, one)| {
            let own = figures::drawings(&one.collapse.picture).into_iter();
            own.map(move |(name, svg)| (format!("case-{}/{name}", k + 1), svg))
        })
    }

    /// Warnings of all cases, each once, with the cases that it concerns.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut all: Vec<(&Warning, Vec<String>)> = Vec::new();
        for one in &self.answers {
            for warning in &one.collapse.warnings {
                match all.iter_mut().find(|(known, _)| *known == warning) {
                    Some((_, cases)) => cases.push(one.name.clone()),
                    None => all.push((warning, vec![one.name.clone()])),
                }
            }
        }
        let of = |(warning, cases): (&Warning, Vec<String>)| match cases.len() == self.answers.len() {
            true => warning.clone(),
            false => Passed::OfCases { cases, warning: Box::new(warning.clone()) }.into(),
        };
        all.into_iter().map(of).collect()
    }

    /// The least factor of those that are known.
    pub fn least(&self) -> Option<&CaseAnswer> {
        let known = self.answers.iter().filter_map(|one| Some((one, one.factor()?)));
        known.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(one, _)| one)
    }
}

/// Makes the analysis that the file plans for each of its cases.
///
/// # Errors
/// A file that cannot be used or has no case (F108), or an analysis that cannot be set up, with the name of its case.
pub fn cases(project: &Project, choice: Choice, watch: &mut dyn Watch) -> Result<Cases, Refusal> {
    let all = &project.meaning().cases;
    project.bridge()?;
    if all.is_empty() {
        let message = format!("{} has no [[case]]", project.name());
        let help = "name the loads that act together with [[case]] and [[case.load]]: extrados schema, docs/input/reference.md";
        return Err(Refusal::new("F108", message, help));
    }
    let projects = all.iter().map(|case| project.in_case(case)).collect::<Result<Vec<Project>, Refusal>>()?;
    let mut answers = Vec::with_capacity(all.len());
    for (case, own) in all.iter().zip(&projects) {
        watch.begin(&format!("case {}", case.name));
        let found = collapse(own, &CollapseOptions { choice, resume: None }, watch)
            .map_err(|refusal| Refusal { message: format!("case {}: {}", case.name, refusal.message), ..refusal })?;
        let stopped = found.status == Status::Cancelled;
        answers.push(CaseAnswer { name: case.name.clone(), told: told(case, project), collapse: found });
        if stopped {
            break;
        }
    }
    Ok(Cases { answers })
}

/// What acts in a case, in words.
fn told(case: &Case, project: &Project) -> String {
    let loads = project.meaning().bridge.as_ref().map_or(&[][..], |bridge| &bridge.loads);
    let acting = case.loads.iter().filter_map(|(k, factor)| Some(format!("{factor} {}", loads.get(*k)?.name)));
    let weights = [("masonry", case.masonry_weight), ("fill", case.fill_weight), ("surfacing", case.surfacing_weight)];
    let weights =
        weights.iter().filter(|(_, factor)| *factor != 1.0).map(|(name, factor)| format!("weight of {name} {factor}"));
    let changes = case.changes.iter().map(|change| {
        let value = match &change.spread {
            bridge::vary::Spread::List(list) => list.join(", "),
            bridge::vary::Spread::Range { .. } => String::new(),
        };
        format!("{} {}", change.quantity, value.trim_matches('"'))
    });
    acting.chain(weights).chain(changes).collect::<Vec<_>>().join("; ")
}
