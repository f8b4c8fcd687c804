//! `extrados.update/1`, and its tables.

use crate::update::{SearchLine, UncertaintyFrom, Update};
use calibrate::Found;
use calibrate::search::sweep::Sweep;
use serde::Serialize;

/// The result of model updating. Status, warnings and times are those of the command.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UpdateObject {
    bridge: String,
    train: String,
    /// The search whose end is the answer; none where none came to an end.
    search: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    parameters: Vec<ParameterObject>,
    /// Where standard deviations, intervals and correlations come from: the linearised problem or the sampled posterior.
    uncertainty_from: Option<&'static str>,
    correlation: Vec<Vec<f64>>,
    error_norm: Option<f64>,
    error_norm_in_search: Option<f64>,
    initial_error_norm: Option<f64>,
    evaluations: usize,
    evaluations_computed: usize,
    channels: Vec<ChannelObject>,
    searches: Vec<SearchObject>,
    sensitivity: Vec<SensitivityObject>,
    stages: Vec<StageObject>,
    naive_error_norm: Option<f64>,
    rank: Option<usize>,
    condition: Option<f64>,
    told: Vec<String>,
    /// The model's error as a share of the response, by the linearised problem.
    model_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    posterior: Option<PosteriorObject>,
    records: RecordsObject,
    load_positions: usize,
    assumptions: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ParameterObject {
    name: String,
    path: String,
    value: Option<f64>,
    start: f64,
    unit: String,
    lower: f64,
    upper: f64,
    at_bound: Option<bool>,
    converged: Option<bool>,
    standard_deviation: Option<f64>,
    interval_95: Option<[f64; 2]>,
    identifiable: Option<bool>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ChannelObject {
    name: String,
    unit: String,
    measured_peak: Option<f64>,
    model_peak: Option<f64>,
    shape_correlation: Option<f64>,
    weight: Option<f64>,
    error: Option<f64>,
    initial_error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    left_out: Option<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct SearchObject {
    search: &'static str,
    variant: String,
    ended: String,
    error_norm: Option<f64>,
    error_norm_in_search: Option<f64>,
    evaluations: Option<usize>,
    evaluations_computed: usize,
    seconds: f64,
    values: Vec<f64>,
    unconverged: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct SensitivityObject {
    parameter: String,
    /// Sweeps of the model about the start, or of its straight line about the answer.
    from: &'static str,
    minimum: f64,
    maximum: f64,
    range: f64,
    value_at_minimum: f64,
    rank: usize,
    channel_ranges: Vec<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct StageObject {
    variant: &'static str,
    start: &'static str,
    pass: usize,
    parameters: [String; 2],
    case: &'static str,
    error_norm: f64,
    frozen: Vec<String>,
    carried: Option<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct PosteriorObject {
    model_error: Option<[f64; 3]>,
    log_evidence: Option<f64>,
    effective_samples: f64,
    r_hat: f64,
    surrogate: String,
    seconds: f64,
    told: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct RecordsObject {
    runs: Vec<RunObject>,
    done: Vec<String>,
    findings: Vec<FindingObject>,
    peaks: Vec<PeakObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dynamics: Option<DynamicsObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    plane_strain: Option<VerdictObject>,
}

/// A channel's peak in a run, on a line across the barrel.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct PeakObject {
    channel: String,
    line: String,
    run: String,
    speed_km_per_h: Option<f64>,
    value: f64,
    unit: &'static str,
    time_s: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct DynamicsObject {
    answer: &'static str,
    words: String,
    speeds_km_per_h: Vec<f64>,
    /// Factor on all peaks against the slowest speed, and the half-width of its 90 % interval.
    factors: Vec<[f64; 2]>,
    channels: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct VerdictObject {
    answer: &'static str,
    words: String,
    channels: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct RunObject {
    name: String,
    file: String,
    speed_km_per_h: Option<f64>,
    channels: usize,
    synthetic: Option<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct FindingObject {
    code: &'static str,
    severity: &'static str,
    place: String,
    message: String,
    help: String,
    file: Option<String>,
    line: Option<usize>,
    last_line: Option<usize>,
    column: Option<usize>,
    time_s: Option<f64>,
    channel: Option<String>,
}

impl UpdateObject {
    /// The object for a report.
    pub fn new(update: &Update) -> UpdateObject {
        let best = update.found();
        let paper = update.paper.first();
        let pass = paper.and_then(|paper| paper.outcome.passes.first());
        UpdateObject {
            bridge: update.bridge.clone(),
            train: update.train.clone(),
            search: update.answer.map(|k| update.searches[k].search.word()),
            reason: update.reason.clone(),
            parameters: parameters(update, best),
            uncertainty_from: update.uncertainty_from().map(UncertaintyFrom::word),
            correlation: update.correlation(),
            error_norm: best.map(|found| found.norm),
            error_norm_in_search: best.map(|found| found.norm_in_search),
            initial_error_norm: update.basis.as_ref().map(|basis| basis.start.norm),
            evaluations: update.evaluations,
            evaluations_computed: update.computed,
            channels: update.basis.as_ref().map_or_else(Vec::new, |_| channels(update, best)),
            searches: update.searches.iter().map(search).collect(),
            sensitivity: match (pass, &update.linearised) {
                (Some(pass), _) => sensitivity(update, "sweeps", &pass.sweeps, &pass.ranking),
                (None, Some(line)) => sensitivity(update, "linearised", &line.sweeps, &line.ranking),
                (None, None) => Vec::new(),
            },
            stages: stages(update),
            naive_error_norm: pass.and_then(|pass| pass.naive.as_ref()?.norm),
            rank: update.identifiability.as_ref().map(|told| told.rank),
            condition: update.identifiability.as_ref().map(|told| told.condition).filter(|c| c.is_finite()),
            told: told(update),
            model_error: update.linearised.as_ref().map(|line| line.left.model_error),
            posterior: posterior(update),
            records: records(update),
            load_positions: update.times.len(),
            assumptions: update.assumptions.clone(),
        }
    }
}

fn name(update: &Update, parameter: usize) -> String {
    update.problem.parameters().get(parameter).map_or_else(String::new, |parameter| parameter.name.clone())
}

fn parameters(update: &Update, best: Option<&Found>) -> Vec<ParameterObject> {
    let one = |(k, parameter): (usize, &calibrate::Parameter)| {
        let found = best.map(|found| &found.parameters[k]);
        let summary = update.summary(k);
        ParameterObject {
            name: parameter.name.clone(),
            path: update.places[k].path.clone(),
            value: found.map(|found| found.value),
            start: parameter.start,
            unit: parameter.unit.clone(),
            lower: parameter.lower,
            upper: parameter.upper,
            at_bound: found.map(|found| found.at_bound),
            converged: found.map(|found| found.converged),
            standard_deviation: summary.map(|summary| summary.standard_deviation),
            interval_95: summary.map(|summary| summary.interval_95),
            identifiable: update.identifiable(k),
        }
    };
    update.problem.parameters().iter().enumerate().map(one).collect()
}

/// What the records tell at the answer, in words: of the derivatives, and of the straight line where no posterior stands in its place.
pub fn told(update: &Update) -> Vec<String> {
    let local = update.identifiability.iter().flat_map(|told| told.words.iter().cloned());
    let line = update.linearised.iter().filter(|_| update.uncertainty_from() == Some(UncertaintyFrom::Linearised));
    local.chain(line.flat_map(|line| line.left.words.iter().cloned())).collect()
}

fn channels(update: &Update, best: Option<&Found>) -> Vec<ChannelObject> {
    let one = |(k, channel): (usize, &calibrate::Channel)| {
        let found = best.map(|found| &found.channels[k]);
        let start = update.basis.as_ref();
        ChannelObject {
            name: channel.name.clone(),
            unit: channel.unit.clone(),
            measured_peak: channel.measured_peak(),
            model_peak: found.map(|found| found.model_peak),
            shape_correlation: found.and_then(|found| found.shape_correlation),
            weight: start.map(|basis| basis.held.weights[k]),
            error: found.map(|found| found.error).filter(|error| error.is_finite()),
            initial_error: start.map(|basis| basis.start.channels[k].error).filter(|error| error.is_finite()),
            left_out: channel.left_out.clone(),
        }
    };
    update.problem.channels().iter().enumerate().map(one).collect()
}

fn search(line: &SearchLine) -> SearchObject {
    let found = line.found.as_ref();
    let open = |found: &Found| {
        found.parameters.iter().filter(|parameter| !parameter.converged).map(|p| p.name.clone()).collect()
    };
    SearchObject {
        search: line.search.word(),
        variant: line.variant.clone(),
        ended: line.status.clone(),
        error_norm: found.map(|found| found.norm),
        error_norm_in_search: found.map(|found| found.norm_in_search),
        evaluations: found.map(|found| found.evaluations),
        evaluations_computed: line.computed,
        seconds: line.seconds,
        values: found.map_or_else(Vec::new, Found::point),
        unconverged: found.map_or_else(Vec::new, open),
    }
}

fn sensitivity(update: &Update, from: &'static str, sweeps: &[Sweep], ranking: &[usize]) -> Vec<SensitivityObject> {
    let channels = update.problem.channels().len();
    let one = |sweep: &Sweep| SensitivityObject {
        parameter: name(update, sweep.parameter),
        from,
        minimum: sweep.least(),
        maximum: sweep.most(),
        range: sweep.range(),
        value_at_minimum: sweep.best(),
        rank: ranking.iter().position(|k| *k == sweep.parameter).map_or(0, |place| place + 1),
        channel_ranges: (0..channels).map(|k| sweep.error_range(k)).collect(),
    };
    sweeps.iter().map(one).collect()
}

fn stages(update: &Update) -> Vec<StageObject> {
    let mut all = Vec::new();
    for paper in &update.paper {
        for (number, pass) in paper.outcome.passes.iter().enumerate() {
            all.extend(pass.stages.iter().map(|stage| StageObject {
                variant: paper.variant.word(),
                start: paper.start.word(),
                pass: number + 1,
                parameters: stage.surface.parameters.map(|k| name(update, k)),
                case: stage.surface.case.name(),
                error_norm: stage.surface.norm(),
                frozen: stage.frozen.iter().map(|k| name(update, *k)).collect(),
                carried: stage.carried.map(|k| name(update, k)),
            }));
        }
    }
    all
}

fn posterior(update: &Update) -> Option<PosteriorObject> {
    let report = update.posterior.as_ref()?;
    let posterior = &report.posterior;
    Some(PosteriorObject {
        model_error: posterior.model_error.as_ref().map(|s| [s.mean, s.interval_95[0], s.interval_95[1]]),
        log_evidence: posterior.log_evidence.map(|(log, _)| log),
        effective_samples: posterior.effective_samples,
        r_hat: posterior.r_hat,
        surrogate: report.surrogate.clone(),
        seconds: report.seconds,
        told: posterior.words.clone(),
    })
}

fn records(update: &Update) -> RecordsObject {
    let run = |run: &crate::update::RunUsed| RunObject {
        name: run.name.clone(),
        file: run.file.clone(),
        speed_km_per_h: run.speed.map(|speed| 3.6 * speed),
        channels: run.channels,
        synthetic: run.synthetic.clone(),
    };
    let done = |done: &records::Done| {
        let place = [done.run.as_str(), done.channel.as_str()].join(" ");
        format!("{}: {}", place.trim(), done.what)
    };
    let said = |text: &String| (!text.is_empty()).then(|| text.clone());
    let finding = |(finding, file): (&records::Finding, &String)| FindingObject {
        code: finding.code,
        severity: finding.severity.word(),
        place: finding.place.words(),
        message: finding.message.clone(),
        help: finding.help.clone(),
        file: said(file),
        line: finding.place.lines.map(|lines| lines[0]),
        last_line: finding.place.lines.map(|lines| lines[1]),
        column: finding.place.column,
        time_s: finding.place.time,
        channel: said(&finding.place.channel),
    };
    let verdict = update.records.verdict.as_ref();
    RecordsObject {
        runs: update.records.runs.iter().map(run).collect(),
        done: update.records.done.iter().map(done).collect(),
        findings: update.records.findings.iter().zip(&update.records.places).map(finding).collect(),
        peaks: verdict.iter().flat_map(|verdict| verdict.peaks.peaks.iter().map(peak)).collect(),
        dynamics: verdict.map(|verdict| dynamics(&verdict.dynamics)),
        plane_strain: verdict.map(|verdict| plane_strain(&verdict.plane_strain)),
    }
}

fn peak(peak: &records::Peak) -> PeakObject {
    PeakObject {
        channel: peak.name.clone(),
        line: peak.line.clone(),
        run: peak.run.clone(),
        speed_km_per_h: peak.speed.map(|speed| 3.6 * speed),
        value: peak.unit.of_si(peak.value),
        unit: peak.unit.symbol,
        time_s: peak.time,
    }
}

fn dynamics(told: &records::Dynamics) -> DynamicsObject {
    DynamicsObject {
        answer: told.answer.word(),
        words: told.words.clone(),
        speeds_km_per_h: told.speeds.iter().map(|speed| 3.6 * speed).collect(),
        factors: told.factors.clone(),
        channels: told.channels.iter().map(|channel| channel.words.clone()).collect(),
    }
}

fn plane_strain(told: &records::PlaneStrain) -> VerdictObject {
    VerdictObject {
        answer: told.answer.word(),
        words: told.words.clone(),
        channels: told.channels.iter().map(|channel| channel.words.clone()).collect(),
    }
}

/// Measured and computed histories: time, then three columns a channel.
pub fn histories_table(update: &Update) -> String {
    let mut head = vec!["time_s".to_owned(), "position_m".to_owned()];
    for channel in &update.channels {
        for kind in ["measured", "start", "updated"] {
            head.push(format!(
                "{}_{kind}_{}",
                channel.name.replace(' ', "_").to_lowercase(),
                channel.quantity.unit().to_lowercase()
            ));
        }
    }
    let mut text = row(&head);
    for k in 0..update.times.len() {
        let mut cells = vec![update.times[k].to_string(), update.positions[k].to_string()];
        for channel in &update.channels {
            for values in [&channel.measured, &channel.start, &channel.updated] {
                cells.push(values.get(k).map_or_else(String::new, f64::to_string));
            }
        }
        text += &row(&cells);
    }
    text
}

/// Every point of every single sweep of the paper's search: the norm and the error of each channel.
pub fn sweeps_table(update: &Update) -> String {
    let mut head: Vec<String> =
        ["variant", "start", "pass", "parameter", "value", "unit", "error_norm"].map(str::to_owned).to_vec();
    head.extend(update.problem.channels().iter().map(|channel| format!("error_{}", channel.name.replace(' ', "_"))));
    let mut text = row(&head);
    for paper in &update.paper {
        for (number, pass) in paper.outcome.passes.iter().enumerate() {
            for sweep in pass.sweeps.iter().chain(&pass.last) {
                let unit = update.problem.parameters()[sweep.parameter].unit.clone();
                for (k, value) in sweep.values.iter().enumerate() {
                    let norm = sweep.norms[k].map_or_else(String::new, |norm| norm.to_string());
                    let mut cells =
                        vec![paper.variant.word().to_owned(), paper.start.word().to_owned(), (number + 1).to_string()];
                    cells.extend([name(update, sweep.parameter), value.to_string(), unit.clone(), norm]);
                    cells.extend(sweep.errors[k].iter().map(f64::to_string));
                    cells.resize(head.len(), String::new());
                    text += &row(&cells);
                }
            }
        }
    }
    text
}

/// Samples of the posterior, one column a parameter.
pub fn samples_table(update: &Update) -> String {
    let head: Vec<String> = update.problem.parameters().iter().map(|p| format!("{} [{}]", p.name, p.unit)).collect();
    let mut text = row(&head);
    for sample in update.posterior.iter().flat_map(|report| &report.posterior.samples) {
        text += &row(&sample.iter().map(f64::to_string).collect::<Vec<_>>());
    }
    text
}

/// A line of a table; cells with a comma or a quotation mark are put in quotes.
fn row(cells: &[String]) -> String {
    let quoted = |cell: &String| match cell.contains([',', '"']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.clone(),
    };
    cells.iter().map(quoted).collect::<Vec<_>>().join(",") + "\n"
}
