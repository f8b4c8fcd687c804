//! Lists of `extrados.update/1`, and its tables.

use super::objects::{Object, list, object, said};
use super::rows::row;
use crate::update::{RecordsUsed, RunUsed, UncertaintyFrom, Update};

fn name(update: &Update, parameter: usize) -> &str {
    update.problem.parameters().get(parameter).map_or("", |parameter| &parameter.name)
}

pub(crate) fn parameters(update: &Update) -> Vec<Object> {
    let best = update.found();
    list(update.problem.parameters().iter().enumerate(), |(k, parameter)| {
        let found = best.map(|found| &found.parameters[k]);
        let summary = update.summary(k);
        object! {
            name: parameter.name,
            path: update.paths[k],
            value: found.map(|found| found.value),
            start: parameter.start,
            unit: parameter.unit,
            lower: parameter.lower,
            upper: parameter.upper,
            at_bound: found.map(|found| found.at_bound),
            converged: found.map(|found| found.converged),
            standard_deviation: summary.map(|summary| summary.standard_deviation),
            interval_95: summary.map(|summary| summary.interval_95),
            identifiable: update.identifiable(k),
            // Share of its variance that is that of the common gain, and not that of the records.
            gain_share: update.common_gain().and_then(|gain| gain.shares.get(k)),
        }
    })
}

/// What the records tell at the answer, in words: of the derivatives, and of the straight line where no posterior stands in its place.
pub fn told(update: &Update) -> Vec<String> {
    let local = update.identifiability.iter().flat_map(|told| told.words.iter().cloned());
    let line = update.linearised.iter().filter(|_| update.uncertainty_from() == Some(UncertaintyFrom::Linearised));
    local.chain(line.flat_map(|line| line.left.words.iter().cloned())).collect()
}

pub(crate) fn channels(update: &Update) -> Vec<Object> {
    let (Some(basis), best) = (&update.basis, update.found()) else { return Vec::new() };
    list(update.problem.channels().iter().enumerate(), |(k, channel)| {
        let found = best.map(|found| &found.channels[k]);
        object! {
            name: channel.name,
            unit: channel.unit,
            measured_peak: channel.measured_peak(),
            model_peak: found.map(|found| found.model_peak),
            shape_correlation: found.and_then(|found| found.shape_correlation),
            weight: basis.held.weights[k],
            error: found.map(|found| found.error),
            initial_error: basis.start.channels[k].error,
            left_out?: channel.left_out,
        }
    })
}

/// Positions of the load test in which something was read, in the order in which they come.
pub(crate) fn positions(update: &Update) -> Vec<Object> {
    list(names_of_positions(update), |name| {
        let mut channels = Object::new();
        for read in &update.read_at_rest {
            let Some(k) = read.positions.iter().position(|position| position == name) else { continue };
            let one = object! { measured: read.measured[k], start: read.start.get(k), updated: read.updated.get(k), };
            channels.insert(read.sensor.clone(), one.into());
        }
        object! { name: name, channels: channels, }
    })
}

fn names_of_positions(update: &Update) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for name in update.read_at_rest.iter().flat_map(|read| &read.positions) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    names
}

/// Readings and model in the positions of a load test: position, then three columns a sensor.
pub fn readings_table(update: &Update) -> String {
    let head = update.read_at_rest.iter().flat_map(|read| {
        let (name, unit) = (read.sensor.replace(' ', "_").to_lowercase(), read.quantity.unit().to_lowercase());
        ["measured", "start", "updated"].map(|kind| format!("{name}_{kind}_{unit}"))
    });
    let mut csv = String::new();
    row!(&mut csv, "position", head.collect::<Vec<_>>());
    for name in names_of_positions(update) {
        let cells = update.read_at_rest.iter().map(|read| {
            let place = read.positions.iter().position(|position| position == name);
            [&read.measured, &read.start, &read.updated].map(|values| values.get(place?).copied())
        });
        row!(&mut csv, name, cells.collect::<Vec<_>>());
    }
    csv
}

/// Sweeps of the model about the start, or of its straight line about the answer.
pub(crate) fn sensitivity(update: &Update) -> Vec<Object> {
    let (from, sweeps, ranking) = match (update.first_pass(), &update.linearised) {
        (Some(pass), _) => ("sweeps", &pass.sweeps, &pass.ranking),
        (None, Some(line)) => ("linearised", &line.sweeps, &line.ranking),
        (None, None) => return Vec::new(),
    };
    let channels = update.problem.channels().len();
    list(sweeps, |sweep| {
        object! {
            parameter: name(update, sweep.parameter),
            from: from,
            minimum: sweep.least(),
            maximum: sweep.most(),
            range: sweep.range(),
            value_at_minimum: sweep.best(),
            rank: ranking.iter().position(|k| *k == sweep.parameter).map_or(0, |place| place + 1),
            channel_ranges: (0..channels).map(|k| sweep.error_range(k)).collect::<Vec<_>>(),
        }
    })
}

pub(crate) fn stages(update: &Update) -> Vec<Object> {
    let passes =
        update.paper.iter().flat_map(|paper| paper.outcome.passes.iter().zip(1..).map(move |one| (paper, one)));
    let stages = passes.flat_map(|(paper, (pass, number))| pass.stages.iter().map(move |stage| (paper, number, stage)));
    list(stages, |(paper, number, stage): (_, u64, _)| {
        object! {
            variant: paper.variant.word(),
            start: paper.start.word(),
            pass: number,
            parameters: stage.surface.parameters.map(|k| name(update, k)),
            case: stage.surface.case.name(),
            error_norm: stage.surface.norm(),
            frozen: stage.frozen.iter().map(|k| name(update, *k)).collect::<Vec<_>>(),
            carried: stage.carried.map(|k| name(update, k)),
        }
    })
}

pub(crate) fn records(used: &RecordsUsed) -> Object {
    let kilometres = |speed: f64| 3.6 * speed;
    object! {
        runs: list(&used.runs, RunUsed::object),
        done: used.done_words().collect::<Vec<_>>(),
        findings: list(used.findings.iter().zip(&used.places), |(finding, file)| object! {
            code: finding.code,
            severity: finding.severity.word(),
            place: finding.place.to_string(),
            message: finding.message,
            help: finding.help,
            file: said(file),
            line: finding.place.lines.map(|lines| lines[0]),
            last_line: finding.place.lines.map(|lines| lines[1]),
            column: finding.place.column,
            time_s: finding.place.time,
            channel: said(&finding.place.channel),
        }),
        // A channel's peak in a run, on a line across the barrel.
        peaks: list(used.verdict.iter().flat_map(|verdict| &verdict.peaks.peaks), |peak| object! {
            channel: peak.name,
            line: peak.line,
            run: peak.run,
            speed_km_per_h: peak.speed.map(kilometres),
            value: peak.unit.of_si(peak.value),
            unit: peak.unit.symbol,
            time_s: peak.time,
        }),
        dynamics?: used.verdict.as_ref().map(|verdict| &verdict.dynamics).map(|told| object! {
            answer: told.answer.word(),
            words: told.words,
            speeds_km_per_h: told.speeds.iter().copied().map(kilometres).collect::<Vec<_>>(),
            // Factor on all peaks against the slowest speed, and the half-width of its 90 % interval.
            factors: told.factors,
            channels: told.channels.iter().map(|channel| &channel.words).collect::<Vec<_>>(),
        }),
        plane_strain?: used.verdict.as_ref().map(|verdict| &verdict.plane_strain).map(|told| object! {
            answer: told.answer.word(),
            words: told.words,
            channels: told.channels.iter().map(|channel| &channel.words).collect::<Vec<_>>(),
        }),
    }
}

/// Measured and computed histories: time, then three columns a channel.
pub fn histories_table(update: &Update) -> String {
    let head = update.channels.iter().flat_map(|channel| {
        let (name, unit) = (channel.name.replace(' ', "_").to_lowercase(), channel.quantity.unit().to_lowercase());
        ["measured", "start", "updated"].map(|kind| format!("{name}_{kind}_{unit}"))
    });
    let mut csv = String::new();
    row!(&mut csv, "time_s", "position_m", head.collect::<Vec<_>>());
    for k in 0..update.times.len() {
        let values = update
            .channels
            .iter()
            .map(|channel| [&channel.measured, &channel.start, &channel.updated].map(|values| values.get(k).copied()));
        row!(&mut csv, update.times[k], update.positions[k], values.collect::<Vec<_>>());
    }
    csv
}

/// Every point of every single sweep of the paper's search: the norm and the error of each channel.
pub fn sweeps_table(update: &Update) -> String {
    let channels = update.problem.channels();
    let errors = channels.iter().map(|channel| format!("error_{}", channel.name.replace(' ', "_")));
    let mut csv = String::new();
    let head = ["variant", "start", "pass", "parameter", "value", "unit", "error_norm"];
    row!(&mut csv, head, errors.collect::<Vec<_>>());
    for paper in &update.paper {
        let search = [paper.variant.word(), paper.start.word()];
        for (number, pass) in paper.outcome.passes.iter().enumerate() {
            for sweep in pass.sweeps.iter().chain(&pass.last) {
                let parameter = &update.problem.parameters()[sweep.parameter];
                for (k, value) in sweep.values.iter().enumerate() {
                    let errors: Vec<_> = (0..channels.len()).map(|channel| sweep.errors[k].get(channel)).collect();
                    row!(&mut csv, search, number + 1, parameter.name, value, parameter.unit, sweep.norms[k], errors);
                }
            }
        }
    }
    csv
}

/// Samples of the posterior, one column a parameter.
pub fn samples_table(update: &Update) -> String {
    let head = update.problem.parameters().iter().map(|p| format!("{} [{}]", p.name, p.unit));
    let mut csv = String::new();
    row!(&mut csv, head.collect::<Vec<_>>());
    for sample in update.posterior.iter().flat_map(|report| &report.posterior.samples) {
        row!(&mut csv, sample);
    }
    csv
}
