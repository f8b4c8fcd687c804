//! Whole analyses, as the command makes them.

use crate::document::{Document, Read};
use crate::one;
use crate::result::Outcome;
use extrados::bridge::choice::Choice as Words;
use extrados::bridge::vary::known;
use extrados::{
    AssessOptions, Choice, CollapseOptions, Means, Refusal, RespondOptions, SweepOptions, UpdateOptions, VaryOptions,
    Watch,
};
use serde_json::Value;

/// What takes the place of a file's plan: an object of words.
///
/// # Errors
/// Words that are none of their key (F107).
pub fn choice(text: &str) -> Result<Choice, Refusal> {
    let said: Value = match text.trim() {
        "" => Value::Null,
        text => serde_json::from_str(text).map_err(|error| {
            Refusal::new("F107", error.to_string(), "give an object such as {\"method\": \"limit\"}")
        })?,
    };
    Ok(Choice {
        analysis: word(&said, "analysis")?,
        method: word(&said, "method")?,
        contact: word(&said, "contact")?,
        friction: word(&said, "friction")?,
        contact_points: word(&said, "contact_points")?,
        step_limit: said.get("step_limit").and_then(Value::as_u64),
        resolution: said.get("resolution").and_then(Value::as_f64),
        ..Choice::default()
    })
}

fn word<T: Words>(said: &Value, key: &str) -> Result<Option<T>, Refusal> {
    let Some(text) = said.get(key).and_then(Value::as_str) else { return Ok(None) };
    T::named(text).map(Some).ok_or_else(|| {
        let known: Vec<&str> = T::WORDS.iter().map(|word| word.word).collect();
        Refusal::new("F107", format!("{key}: there is no \"{text}\""), format!("write one of {}", known.join(", ")))
    })
}

/// The load, the thickness or the support movement that makes a mechanism, of a bridge or of blocks.
///
/// # Errors
/// Those of [`extrados::collapse()`].
pub fn collapse(document: &Document, choice_of: &str, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let options = CollapseOptions { choice: choice(choice_of)?, resume: None };
    if let Read::Blocks(blocks) = &document.read {
        let found = extrados::collapse_of_blocks(blocks, &options, watch)?;
        return Ok(Outcome::collapse_of_blocks(blocks, &found));
    }
    let project = document.project()?;
    Ok(Outcome::collapse(project, &extrados::collapse(project, &options, watch)?))
}

/// Loads or vehicles at every position; `step` [m], or the file's where it is no number.
///
/// # Errors
/// Those of [`extrados::sweep`].
pub fn sweep(document: &Document, choice_of: &str, step: f64, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let options = SweepOptions { choice: choice(choice_of)?, step: (step > 0.0 && step.is_finite()).then_some(step) };
    let project = document.project()?;
    Outcome::sweep(project, &extrados::sweep(project, &options, watch)?)
}

/// Every named case.
///
/// # Errors
/// Those of [`extrados::cases`].
pub fn cases(document: &Document, choice_of: &str, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let project = document.project()?;
    Ok(Outcome::cases(project, &extrados::cases(project, choice(choice_of)?, watch)?))
}

/// Another bridge, and this one beside it.
///
/// # Errors
/// Those of [`extrados::compare`].
pub fn compare(
    document: &Document,
    before: &Document,
    choice_of: &str,
    watch: &mut dyn Watch,
) -> Result<Outcome, Refusal> {
    let (before, after) = (before.project()?, document.project()?);
    let found = extrados::compare(before, after, choice(choice_of)?, watch)?;
    Ok(Outcome::compared(before, after, &found))
}

/// The passage of the file's train.
///
/// # Errors
/// Those of [`extrados::respond`].
pub fn respond(document: &Document, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let project = document.project()?;
    Ok(Outcome::passage(project, extrados::respond(project, &RespondOptions::default(), watch)?))
}

/// Parameters from records.
///
/// # Errors
/// Those of [`extrados::update`].
pub fn update(document: &Document, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let project = document.project()?;
    let found = extrados::update(project, &UpdateOptions::default(), &Means::default(), watch)?;
    Ok(Outcome::update(project, &found, false))
}

/// The records alone.
///
/// # Errors
/// Those of [`extrados::judge`].
pub fn judge(document: &Document, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let project = document.project()?;
    Ok(Outcome::update(project, &extrados::judge(project, &Means::default(), watch)?, true))
}

/// The collapse over ranges of quantities, each by itself; those of the file where none are given.
///
/// # Errors
/// Those of [`extrados::vary`]; a stop on the way (F108).
pub fn vary(document: &Document, settings: &str, choice_of: &str, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let project = document.project()?;
    let texts: Vec<String> = serde_json::from_str(settings).map_err(|error| {
        Refusal::new("F107", error.to_string(), "give a list such as [\"joint.friction_angle=30deg..40deg:5\"]")
    })?;
    let requests = if texts.is_empty() { Vec::new() } else { extrados::settings(project, &texts).map_err(one)? };
    let options = VaryOptions { choice: choice(choice_of)?, ..VaryOptions::default() };
    let found = extrados::vary(project, &requests, &options, &Means::default(), watch).map_err(one)?;
    let stopped = || Refusal::new("F108", "the study was stopped on the way", "start it again");
    Ok(Outcome::study(project, &found.study.ok_or_else(stopped)?))
}

/// By how much a quantity is moved down and up where nobody says.
const SHARE: f64 = 0.1;

/// The same for a list of paths, each moved a tenth down and up; where none are given, what an engineer doubts first.
///
/// # Errors
/// Those of [`vary`].
pub fn tornado(document: &Document, paths: &str, choice_of: &str, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let asked: Vec<String> = serde_json::from_str(paths)
        .map_err(|error| Refusal::new("F107", error.to_string(), "give a list such as [\"joint.friction_angle\"]"))?;
    let there = extrados::bridge::edit::Document::parse(&document.text());
    let there: Vec<String> =
        there.map_or_else(Vec::new, |document| known(&document).into_iter().map(|one| one.path).collect());
    let paths = match asked.is_empty() {
        false => asked,
        true => there.into_iter().filter(|path| DOUBTED.iter().any(|ending| path.ends_with(ending))).collect(),
    };
    let settings: Vec<String> =
        paths.iter().map(|path| format!("{path}=x{}..x{}:3", 1.0 - SHARE, 1.0 + SHARE)).collect();
    vary(document, &serde_json::json!(settings).to_string(), choice_of, watch)
}

/// What a survey leaves most in doubt.
const DOUBTED: [&str; 6] =
    [".thickness", "masonry.density", "masonry.compressive_strength", "joint.friction_angle", "].density", ".rise"];

/// The whole chain, with its report.
///
/// # Errors
/// Those of [`extrados::assess`]; a stop on the way (F108).
pub fn assess(document: &Document, day: &str, watch: &mut dyn Watch) -> Result<Outcome, Refusal> {
    let project = document.project()?;
    let options = AssessOptions {
        skip: Vec::new(),
        command: format!("extrados assess {}", project.name()),
        day: day.chars().filter(|c| c.is_ascii_digit() || *c == '-').take(10).collect(),
    };
    let found = extrados::assess(project, &options, &Means::default(), watch)?;
    let stopped = || Refusal::new("F108", "the assessment was stopped on the way", "start it again");
    Ok(Outcome::assessed(project, &found.ok_or_else(stopped)?))
}
