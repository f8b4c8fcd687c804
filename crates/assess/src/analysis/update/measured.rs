//! From tables of loggers to the channels that the model is compared with: read, judged, made ready, brought to its times.

use super::Task;
use crate::analysis::passage::Setup;
use bridge::Bridge;
use bridge::passage::{SensorPosition, default_sensors};
use bridge::update::{Channel as Said, Records, Update as Asked};
use calibrate::Channel;
use findings::Severity;
use outcome::update::{RecordsUsed, RunUsed, Verdict};
use records::{
    Align, Column, Detrend, Expected, Finding, LeaveOut, Mapping, Place, Preparation, ReadOptions, Recording,
    Reference, Scrutiny, Series, Source, Zero, dynamics, examine, peaks, plane_strain, prepare, read,
};

/// A table beside the bridge file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordFile {
    /// Its name, as messages show it.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// Tables as they were read.
#[derive(Debug, Default)]
struct Tables {
    runs: Vec<Recording>,
    /// File of each run.
    named: Vec<String>,
    /// Findings, each with its file.
    findings: Vec<(String, Finding)>,
}

fn tables(asked: &Asked, setup: &Setup, files: &[RecordFile]) -> Tables {
    let mut tables = Tables::default();
    for file in files {
        let found = read(&file.bytes, &options(asked, &file.name));
        tables.findings.extend(found.findings.into_iter().map(|finding| (file.name.clone(), finding)));
        if let Some(mut run) = found.run {
            name_by_sensors(&mut run, setup);
            tables.findings.extend(unnamed(&run, setup).into_iter().map(|finding| (file.name.clone(), finding)));
            tables.named.push(file.name.clone());
            tables.runs.push(run);
        }
    }
    tables
}

/// Whether any channel of a sensor can be used as far as the tables alone tell; if none can, what was found in them.
pub(super) fn worth_a_passage(asked: &Asked, setup: &Setup, files: &[RecordFile]) -> Result<(), Vec<String>> {
    let Tables { runs, named, findings } = tables(asked, setup, files);
    let series = examine(runs, &Scrutiny::default());
    if series.runs.iter().any(|run| run.used().any(|channel| is_sensor(setup, &channel.name))) {
        return Ok(());
    }
    let mut words: Vec<String> =
        findings.iter().map(|(file, finding)| format!("{file}: {}", finding.words())).collect();
    words.extend(series.findings.iter().map(|finding| {
        let run = series.runs.iter().position(|run| run.name == finding.place.run);
        run.map_or_else(|| finding.words(), |run| format!("{}: {}", named[run], finding.words()))
    }));
    if series.runs.iter().any(|run| run.used().next().is_some()) {
        let sensors: Vec<&str> = setup.sensors.iter().map(|sensor| sensor.name.as_str()).collect();
        words.push(format!("no column is named after a sensor; the sensors are {}", sensors.join(", ")));
    }
    Err(words)
}

/// Channels in the order of the sensors, in the units in which they are shown, and how they came about.
pub(super) fn measured(
    task: &Task<'_>,
    (setup, records): (&Setup, &Records),
    start: &[Vec<f64>],
) -> (Vec<Channel>, RecordsUsed) {
    let asked = task.asked;
    let Tables { runs, named, mut findings } = tables(asked, setup, task.files);
    let series =
        prepare(examine(runs, &scrutiny(asked, setup, start)), &preparation(task.bridge, (setup, records), start));
    // Runs keep their order; those of one name were given numbers.
    let file_of = |finding: &Finding| {
        let run = series.runs.iter().position(|run| run.name == finding.place.run);
        run.map_or_else(String::new, |run| named[run].clone())
    };
    findings.extend(series.findings.iter().map(|finding| (file_of(finding), finding.clone())));
    let used = |(run, file): (&Recording, &String)| RunUsed {
        name: run.name.clone(),
        file: file.clone(),
        speed: run.speed,
        synthetic: run.synthetic.clone(),
        channels: run.used().filter(|channel| is_sensor(setup, &channel.name)).count(),
    };
    let runs = series.runs.iter().zip(&named).map(used).collect();
    let channels = (0..setup.sensors.len()).map(|k| channel(asked, (setup, records), &series, k)).collect();
    let verdict = verdict(&series);
    let (places, findings) = findings.into_iter().unzip();
    (channels, RecordsUsed { runs, done: series.done, findings, places, verdict })
}

/// What the peaks of all runs and lines tell; nothing where there is none.
fn verdict(series: &Series) -> Option<Verdict> {
    let peaks = peaks(series);
    let told = |peaks| Verdict { dynamics: dynamics(&peaks), plane_strain: plane_strain(&peaks, Some(series)), peaks };
    (!peaks.peaks.is_empty()).then(|| told(peaks))
}

/// What the file says of the channel of a sensor.
pub(super) fn said<'a>(asked: &'a Asked, name: &str) -> Option<&'a Said> {
    asked.channels.iter().find(|channel| channel.sensor == name)
}

fn options(asked: &Asked, file: &str) -> ReadOptions {
    let column = |channel: &Said| {
        let heading = channel.column.clone().unwrap_or_else(|| channel.sensor.clone());
        let sign = if channel.reversed { -1.0 } else { 1.0 };
        Column { sign, ..Column::new(Source::Heading(heading), &channel.sensor) }
    };
    let tied = asked.channels.iter().filter(|channel| channel.column.is_some() || channel.reversed);
    let mapping = Mapping { channels: tied.map(column).collect(), ..Mapping::default() };
    let name = std::path::Path::new(file).file_stem().map_or(file.into(), |stem| stem.to_string_lossy().into_owned());
    ReadOptions { name, mapping, ..ReadOptions::default() }
}

/// Headings as programs write them lose blanks and capitals: they are the sensor whose name is left.
fn name_by_sensors(run: &mut Recording, setup: &Setup) {
    let plain = |name: &str| name.to_lowercase().replace(['_', '-'], " ");
    for channel in &mut run.channels {
        if let Some(sensor) = setup.sensors.iter().find(|sensor| plain(&sensor.name) == plain(&channel.name)) {
            channel.name.clone_from(&sensor.name);
        }
    }
}

fn is_sensor(setup: &Setup, name: &str) -> bool {
    setup.sensors.iter().any(|sensor| sensor.name == name)
}

/// Columns that are named after no sensor: a doubt where a sensor has none, for one of them may be misspelt.
fn unnamed(run: &Recording, setup: &Setup) -> Vec<Finding> {
    let filled = |name: &str| run.channels.iter().any(|channel| channel.name == name);
    let empty: Vec<&str> =
        setup.sensors.iter().map(|sensor| sensor.name.as_str()).filter(|name| !filled(name)).collect();
    let told = |channel: &records::Channel| {
        let place = Place {
            run: run.name.clone(),
            column: Some(channel.column),
            channel: channel.name.clone(),
            ..Place::default()
        };
        let message = format!("`{}` is named after no sensor and is passed over", channel.name);
        let help = match empty.len() {
            0 => String::new(),
            _ => format!(
                "if it is one of the sensors without a column ({}), name it so, or write column = \"{}\" into that sensor's [[channel]]",
                empty.join(", "),
                channel.name
            ),
        };
        let severity = if empty.is_empty() { Severity::Note } else { Severity::Warning };
        Finding::new(severity, "R016", place, message, &help)
    };
    run.channels.iter().filter(|channel| !is_sensor(setup, &channel.name)).map(told).collect()
}

/// Units and signs are judged against the start model, which need be right to a factor of five only.
fn scrutiny(asked: &Asked, setup: &Setup, start: &[Vec<f64>]) -> Scrutiny {
    let expected = setup.sensors.iter().zip(start).filter_map(|(sensor, values)| {
        let peak = calibrate::channel::largest(values)? / sensor.quantity.scale();
        Some(Expected { name: sensor.name.clone(), line: None, peak })
    });
    let out = |channel: &Said| {
        let reason = channel.left_out.clone()?;
        Some(LeaveOut { run: None, name: channel.sensor.clone(), line: None, reason })
    };
    let leave_out = asked.channels.iter().filter_map(out).collect();
    Scrutiny { expected: expected.collect(), leave_out, ..Scrutiny::default() }
}

fn preparation(bridge: &Bridge, (setup, records): (&Setup, &Records), start: &[Vec<f64>]) -> Preparation {
    let align = records.align.as_ref().and_then(|name| match records.by_axles {
        true => by_axles(bridge, setup, name),
        false => by_model(setup, start, name),
    });
    Preparation {
        zero: if records.zero { Zero::QuietStart } else { Zero::AsRecorded },
        detrend: if records.drift { Detrend::QuietEnds } else { Detrend::None },
        low_pass: records.low_pass,
        align: align.unwrap_or_default(),
        ..Preparation::default()
    }
}

/// The channel's history in the start model.
fn by_model(setup: &Setup, start: &[Vec<f64>], name: &str) -> Option<Align> {
    let k = setup.sensors.iter().position(|sensor| sensor.name == name)?;
    let scale = setup.sensors[k].quantity.scale();
    Some(Align::Reference(Reference {
        name: name.to_owned(),
        line: String::new(),
        times: setup.times.clone(),
        values: start[k].iter().map(|value| value / scale).collect(),
        speed: Some(setup.plan.speed),
    }))
}

/// The times at which axles stand above the channel's sensor, on the clock of the passage; each is felt for half a span
/// before and after.
fn by_axles(bridge: &Bridge, setup: &Setup, name: &str) -> Option<Align> {
    let passage = bridge.passage.as_ref()?;
    let defaults = default_sensors(bridge.spans.len());
    let sensors = if passage.sensors.is_empty() { &defaults } else { &passage.sensors };
    let ends = |span: usize| setup.meshed.sets.spans.get(span).map(|span| span.springings_at.map(|point| point.x));
    let middle = |[left, right]: [f64; 2]| 0.5 * (left + right);
    let (x, [left, right]) = match sensors.iter().find(|sensor| sensor.name == name)?.place {
        SensorPosition::Span { span, share } => {
            ends(span).map(|[left, right]| (left + share * (right - left), [left, right]))?
        }
        SensorPosition::Point([x, _]) => {
            let spans = (0..bridge.spans.len()).filter_map(ends);
            (x, spans.min_by(|a, b| (middle(*a) - x).abs().total_cmp(&(middle(*b) - x).abs()))?)
        }
    };
    let (speed, from) = (setup.plan.speed, *setup.positions.first()?);
    let along = setup.plan.direction.sign() * (x - from);
    let times = passage.train.axles(bridge.gravity).iter().map(|axle| (along + axle.offset) / speed).collect();
    let (name, line) = (name.to_owned(), String::new());
    Some(Align::Axles { name, line, times, felt: 0.5 * (right - left).abs() / speed, speed: Some(speed) })
}

/// The mean over runs and lines of one sensor's records.
fn channel(asked: &Asked, (setup, records): (&Setup, &Records), series: &Series, k: usize) -> Channel {
    let sensor = &setup.sensors[k];
    let said = said(asked, &sensor.name);
    let wanted = sensor.quantity.recorded();
    let scale = sensor.quantity.scale();
    let (mut peaks, mut histories) = (Vec::new(), Vec::new());
    let mut reason = None;
    for run in &series.runs {
        for channel in run.channels.iter().filter(|channel| channel.name == sensor.name) {
            if channel.unit.quantity != wanted {
                reason = Some(format!("its records are in {}", channel.unit.symbol));
                continue;
            }
            if let Some(why) = &channel.left_out {
                reason = Some(why.clone());
            }
            let by_hand = said.is_some_and(|said| said.left_out.is_some());
            let Some(peak) = channel.peak().filter(|_| channel.used() || by_hand) else { continue };
            // A train at another speed stands at the same places at other times.
            let pace = run.speed.map_or(1.0, |speed| speed / setup.plan.speed);
            peaks.push(scale * channel.values[peak]);
            histories.push(at_times(&run.times, &channel.values, pace, &setup.times, scale));
        }
    }
    let count = peaks.len() as f64;
    let missing = if peaks.is_empty() { Some(reason.unwrap_or_else(|| "no record of it".to_owned())) } else { None };
    let mean = |sample: usize| histories.iter().map(|history: &Vec<f64>| history[sample]).sum::<f64>() / count;
    Channel {
        name: sensor.name.clone(),
        unit: sensor.quantity.unit().to_owned(),
        peak: (!peaks.is_empty()).then(|| peaks.iter().sum::<f64>() / count),
        history: (!peaks.is_empty()).then(|| (0..setup.times.len()).map(mean).collect()),
        uncertainty: said.and_then(|said| said.uncertainty),
        correlated_over: records.low_pass.map(|cutoff| {
            // Noise of that bandwidth, seen at the times of the model on the clock of the fastest run.
            let pace =
                series.runs.iter().filter_map(|run| run.speed).fold(setup.plan.speed, f64::max) / setup.plan.speed;
            pace / (2.0 * ::records::noise_bandwidth(cutoff) * setup.plan.time_step)
        }),
        readings: false,
        weight: said.and_then(|said| said.weight),
        left_out: said.and_then(|said| said.left_out.clone()).or(missing),
    }
}

/// Values at the model's times on straight lines between samples; zero where nothing was recorded, before and after the train.
fn at_times(times: &[f64], values: &[f64], pace: f64, wanted: &[f64], scale: f64) -> Vec<f64> {
    let at = |time: &f64| {
        let time = time / pace;
        let next = times.partition_point(|known| *known < time);
        match (next.checked_sub(1), times.get(next)) {
            (_, Some(known)) if *known == time => values[next],
            (Some(last), Some(known)) => {
                let share = (time - times[last]) / (known - times[last]);
                values[last] + share * (values[next] - values[last])
            }
            _ => 0.0,
        }
    };
    wanted.iter().map(at).map(|value| if value.is_finite() { scale * value } else { 0.0 }).collect()
}
