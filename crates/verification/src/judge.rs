//! Whether a case holds.

use super::against;
use super::case::{Case, Class, Expect, Value, change};
use super::measure::{find, measure};
use super::service;
use serde_json::Value as Json;
use std::time::Instant;

/// What became of a case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// Every expectation is met, and its bite bites.
    Holds,
    /// Marked open, and it does not hold.
    Open(String),
    /// Marked open, but it holds: the mark must go.
    HoldsUnexpectedly,
    /// An expectation is not met.
    Fails,
    /// Every expectation is met although the input was spoilt: the case cannot fail.
    Toothless,
    /// The input could not be analysed.
    Broken(String),
}

impl Verdict {
    /// Whether nothing has to be done.
    pub fn is_well(&self) -> bool {
        matches!(self, Verdict::Holds | Verdict::Open(_))
    }
    /// In a word.
    pub fn word(&self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Open(_) => "open",
            Verdict::HoldsUnexpectedly => "holds unexpectedly",
            Verdict::Fails => "fails",
            Verdict::Toothless => "cannot fail",
            Verdict::Broken(_) => "broken",
        }
    }
}

/// One expectation and what was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The expectation.
    pub expect: Expect,
    /// What was found, in words.
    pub found: String,
    /// Whether it is met.
    pub met: bool,
}

/// A case that has run.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The case.
    pub case: Case,
    /// Each expectation.
    pub findings: Vec<Judgement>,
    /// What became of it.
    pub verdict: Verdict,
    /// Time taken, bite included [s].
    pub seconds: f64,
}

/// Runs a case, and the bite of a quick one.
pub fn run(case: &Case) -> Judged {
    let start = Instant::now();
    let other = case.against.as_ref().map(|other| against::checked(measured(case, other))).transpose();
    let (findings, verdict) = match other.and_then(|other| Ok((measured(case, &case.document)?, other))) {
        Err(reason) => (Vec::new(), case.open.clone().map_or(Verdict::Broken(reason), Verdict::Open)),
        Ok((result, other)) => {
            let result = against::compared(result, other.as_ref());
            let findings = judge(&case.expect, &result);
            let met = findings.iter().all(|f| f.met);
            let verdict = match (&case.open, met) {
                (None, false) => Verdict::Fails,
                (Some(reason), false) => Verdict::Open(reason.clone()),
                (Some(_), true) => Verdict::HoldsUnexpectedly,
                (None, true) => bite(case, other.as_ref()),
            };
            (findings, verdict)
        }
    };
    Judged { case: case.clone(), findings, verdict, seconds: start.elapsed().as_secs_f64() }
}

/// The result of a document, by what the case puts it through.
fn measured(case: &Case, document: &toml::Table) -> Result<Json, String> {
    match case.run {
        None => measure(document),
        Some(run) => service::measure(document, run, case.twin.as_ref()),
    }
}

/// Spoils the input of a quick case: at least one expectation must fail, or the input must become unusable.
fn bite(case: &Case, other: Option<&Json>) -> Verdict {
    let (Class::Quick, Some(changes)) = (case.class, &case.bite) else { return Verdict::Holds };
    let mut spoilt = case.document.clone();
    if let Err(reason) = change(&mut spoilt, changes) {
        return Verdict::Broken(format!("bite: {reason}"));
    }
    let compared = measured(case, &spoilt).map(|result| against::compared(result, other));
    match compared {
        Err(reason) => Verdict::Broken(format!("bite: the spoilt input does not run: {reason}")),
        Ok(result) if judge(&case.expect, &result).iter().all(|f| f.met) => Verdict::Toothless,
        Ok(_) => Verdict::Holds,
    }
}

fn judge(expectations: &[Expect], result: &Json) -> Vec<Judgement> {
    expectations
        .iter()
        .map(|expect| {
            let found = find(result, &expect.quantity);
            let met = found.as_ref().is_some_and(|f| meets(expect, f));
            let found = match found.as_deref() {
                None => "missing".to_string(),
                Some(Json::String(word)) => word.clone(),
                Some(other) => other.to_string(),
            };
            Judgement { expect: expect.clone(), found, met }
        })
        .collect()
}

fn meets(expect: &Expect, found: &Json) -> bool {
    match (&expect.value, found) {
        (Some(Value::Word(word)), Json::String(found)) => word == found,
        (Some(Value::Word(word)), Json::Bool(found)) => *word == found.to_string(),
        (Some(Value::Number(value)), found) => found.as_f64().is_some_and(|f| {
            let room = expect.tolerance.unwrap_or(0.0).max(expect.relative.unwrap_or(0.0) * value.abs());
            (f - value).abs() <= room
        }),
        (None, found) => found.as_f64().is_some_and(|f| {
            expect.at_most.is_none_or(|bound| f <= bound) && expect.at_least.is_none_or(|bound| f >= bound)
        }),
        _ => false,
    }
}
