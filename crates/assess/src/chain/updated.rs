//! Facts of an update, and the bridge with what it found.

use bridge::edit::Document;
use bridge::update::Parameter;
use calibrate::channel::largest;
use outcome::facts::{FitFacts, ParameterFacts, UpdateFacts};
use outcome::update::Update;

/// The facts of an update.
pub fn facts(update: Update) -> UpdateFacts {
    let found = update.found();
    let parameter = |(k, parameter): (usize, &calibrate::Parameter)| {
        let end = found.map(|found| &found.parameters[k]);
        ParameterFacts {
            name: parameter.name.clone(),
            path: update.places[k].path.clone(),
            unit: parameter.unit.clone(),
            start: parameter.start,
            value: end.map(|end| end.value),
            lower: parameter.lower,
            upper: parameter.upper,
            at_bound: end.is_some_and(|end| end.at_bound),
            identifiable: update.identifiable(k),
            limited_by_gain: update.limited_by_gain(k),
            interval_95: update.summary(k).map(|summary| summary.interval_95),
        }
    };
    let fit = |(k, histories): (usize, &outcome::update::Histories)| {
        let end = found.and_then(|found| found.channels.get(k));
        FitFacts {
            name: histories.name.clone(),
            unit: histories.quantity.unit().to_owned(),
            measured: end
                .and_then(|_| update.problem.channels()[k].measured_peak())
                .or_else(|| largest(&histories.measured)),
            start: largest(&histories.start),
            updated: end.map(|end| end.model_peak),
            shape: end.and_then(|end| end.shape_correlation),
            left_out: histories.left_out.clone(),
        }
    };
    let done = update.records.done.iter().map(|done| {
        let place = [done.run.as_str(), done.channel.as_str()].join(" ");
        format!("{}: {}", place.trim(), done.what)
    });
    let findings = update.records.findings.iter().map(records::Finding::words);
    let sampled = update.posterior.iter().flat_map(|report| report.posterior.words.iter().cloned());
    UpdateFacts {
        status: update.status,
        parameters: update.problem.parameters().iter().enumerate().map(parameter).collect(),
        initial_error_norm: update.basis.as_ref().map(|basis| basis.start.norm),
        error_norm: found.map(|found| found.norm),
        channels: update.channels.iter().enumerate().map(fit).collect(),
        runs: update.records.runs.iter().map(|run| (run.name.clone(), run.synthetic.clone())).collect(),
        records: done.chain(findings).collect(),
        told: outcome::published::told(&update).into_iter().chain(sampled).collect(),
        assumptions: update.assumptions.clone(),
        warnings: update.warnings.clone(),
        update: Some(Box::new(update)),
    }
}

/// The file's text with the values that were found in the place of its own; none where a value finds no place.
pub fn with_parameters(document: &Document, asked: &[Parameter], facts: &UpdateFacts) -> Option<Document> {
    let mut edited = document.clone();
    for (parameter, found) in asked.iter().zip(&facts.parameters) {
        edited.set(&parameter.path, &parameter.literal(found.value?)).ok()?;
    }
    Some(edited)
}
