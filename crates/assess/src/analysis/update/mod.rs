//! Model updating: the moduli of a bridge from the records of a train's passage, from readings of loads at rest, or from both.

mod forward;
mod measured;
mod plan;
#[cfg(test)]
mod plan_tests;
mod readings;
#[cfg(test)]
mod readings_tests;
mod searches;

pub use forward::{Model, Threads};
pub use measured::RecordFile;
pub use plan::plan;

use super::AnalysisError;
use super::passage::sensors::Placed;
use crate::checkpoint;
use bridge::Bridge;
use bridge::edit::Document;
use bridge::update::{self, Compared, Update as Asked};
use calibrate::misfit::{Compare, Misfit, Scaling, Weights};
use calibrate::{
    Basis, Channel, Evaluator, Failure, Flaw, Halt, Log, Map, Parameter, Problem, Request, Response, Scale, Watch,
};
use outcome::note::{InUpdate, Note};
use outcome::update::{Histories, RecordsUsed, Update, UpdateStatus};
use outcome::warning::{self, Warning};
use searches::Searches;
use std::borrow::Cow;
use thiserror::Error;

/// Why nothing can be updated.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum UpdateError {
    /// The bridge cannot be analysed.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
    /// The start model gives no answer.
    #[error("the start model gives no answer: {0}")]
    StartModel(String),
    /// Records and parameters make no problem.
    #[error("records and parameters make no problem: {}", .0.join("; "))]
    NoProblem(Vec<String>),
}

/// What is to be updated, and by which records.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// The bridge as its file has it.
    pub bridge: &'a Bridge,
    /// The file's text without the sections of updating.
    pub document: &'a Document,
    /// What it asks for.
    pub asked: &'a Asked,
    /// The records.
    pub files: &'a [RecordFile],
}

impl Task<'_> {
    /// What decides the answers of the model beside the point: the first line of a log.
    pub fn identity(&self) -> String {
        let paths: Vec<String> = self.asked.parameters.iter().map(|p| format!("{} [{}]", p.path, p.unit)).collect();
        // Which sensors were read where decides what the model is asked for, and what they read does not.
        let mut bridge = Cow::Borrowed(self.bridge);
        if self.bridge.load_test.is_some()
            && let Some(test) = &mut bridge.to_mut().load_test
        {
            test.readings.values.iter_mut().flatten().flatten().for_each(|value| *value = 0.0);
            test.readings.uncertainty.clear();
        }
        format!("extrados {} {:016x}", env!("CARGO_PKG_VERSION"), checkpoint::fingerprint(&(&*bridge, paths)))
    }
}

/// How an update is made: its threads, its onlooker, its clock [s].
pub struct Means<'a> {
    /// Evaluations side by side.
    pub map: &'a dyn Map,
    /// Who looks on and keeps the log.
    pub watch: &'a mut dyn Watch,
    /// Seconds since whenever.
    pub clock: &'a dyn Fn() -> f64,
}

/// Start model, records, searches, what the data can tell. `log` holds evaluations that were done before.
///
/// # Errors
/// A passage that cannot be set up, a start model without an answer, or records and parameters that make no problem.
pub fn update(task: &Task<'_>, log: Log, means: Means<'_>) -> Result<Update, UpdateError> {
    let model = Model::new(task.bridge, task.document, task.asked)?;
    if let Some(setup) = &model.crossing {
        measured::worth_a_passage(task.asked, setup, task.files).map_err(UpdateError::NoProblem)?;
    }
    let blind = blind(task, &model)?;

    let mut evaluator = Evaluator::new(&blind, &model, means.map, &mut *means.watch, log);
    let first = started(&mut evaluator)?;
    let (log, already) = (evaluator.log, evaluator.computed);
    let Some(first) = first else { return Ok(cancelled(task, &model, blind)) };

    let (channels, used) = compared(task, &model, &first.values);
    let of_records = || used.findings.iter().map(records::Finding::words);
    let problem = Problem::new(blind.parameters().to_vec(), channels, misfit(task.asked, &model))
        .map_err(|flaws| UpdateError::NoProblem(flaws.iter().map(of_flaw).chain(of_records()).collect()))?;
    let mut evaluator = Evaluator::new(&problem, &model, means.map, means.watch, log);
    let basis = match Basis::at(&mut evaluator, &blind.start()) {
        Ok(basis) => basis,
        Err(Halt::Stopped) => return Ok(Update { records: used, ..cancelled(task, &model, problem.clone()) }),
        Err(Halt::Failed(failure)) => return Err(UpdateError::StartModel(words(&failure))),
    };

    let mut found = Update { records: used, ..cancelled(task, &model, problem.clone()) };
    found.status = UpdateStatus::Completed;
    Searches { plan: &task.asked.plan, basis: &basis, clock: means.clock, found: &mut found }.make(&mut evaluator);
    let mut updated = None;
    if found.status != UpdateStatus::Cancelled
        && let Some(point) = found.found().map(calibrate::Found::point)
    {
        let told = tell(task, &mut evaluator, &basis, &point, means.clock, &mut found);
        if told.is_err() {
            found.status = UpdateStatus::Cancelled;
        }
        updated = evaluator.respond(&[point], &Request::all()).ok();
    }
    let updated = updated.and_then(|answers| answers[0].as_ref().as_ref().ok().cloned());
    let updated = updated.as_ref().map(|response| &response.values[..]);
    found.channels = histories(&model, &problem, &first.values, updated);
    found.read_at_rest = readings::compared(&model, &problem, &first.values, updated);
    (found.evaluations, found.computed) = (evaluator.log.len(), evaluator.computed + already);
    found.assumptions = assumptions(&model, &problem, &task.asked.plan);
    found.basis = Some(basis);
    warn(&mut found, task.bridge);
    Ok(found)
}

/// The records alone, judged beside one passage of the start model: nothing is sought.
///
/// # Errors
/// A passage that cannot be set up, a start model without an answer, parameters that make no problem, or no record that can be used.
pub fn judge(task: &Task<'_>, means: Means<'_>) -> Result<Update, UpdateError> {
    let model = Model::new(task.bridge, task.document, task.asked)?;
    let blind = blind(task, &model)?;
    let mut evaluator = Evaluator::new(&blind, &model, means.map, &mut *means.watch, Log::new(&task.identity()));
    let first = started(&mut evaluator)?;
    let log = evaluator.log;
    let Some(first) = first else { return Ok(cancelled(task, &model, blind)) };
    let (channels, used) = compared(task, &model, &first.values);
    if used.runs.is_empty() && model.crossing.is_some() {
        return Err(UpdateError::NoProblem(used.findings.iter().map(records::Finding::words).collect()));
    }
    // Where no channel can be compared, the verdict on the records is the answer all the same.
    let (posed, start) =
        (Problem::new(blind.parameters().to_vec(), channels, misfit(task.asked, &model)), blind.start());
    let mut found = Update { records: used, ..cancelled(task, &model, blind) };
    found.status = UpdateStatus::Completed;
    match posed {
        Ok(problem) => {
            let mut evaluator = Evaluator::new(&problem, &model, means.map, means.watch, log);
            match Basis::at(&mut evaluator, &start) {
                Ok(basis) => found.basis = Some(basis),
                Err(Halt::Stopped) => found.status = UpdateStatus::Cancelled,
                Err(Halt::Failed(failure)) => found.warnings.push(untold(warning::Asked::StartFit, words(&failure))),
            }
            found.channels = histories(&model, &problem, &first.values, None);
            found.read_at_rest = readings::compared(&model, &problem, &first.values, None);
            found.problem = problem;
        }
        Err(findings) => {
            let said: Vec<String> = findings.iter().map(|f| format!("{}: {}", f.place, f.message)).collect();
            found.warnings.push(untold(warning::Asked::StartFit, said.join("; ")));
        }
    }
    (found.evaluations, found.computed) = (1, 1);
    warn(&mut found, task.bridge);
    Ok(found)
}

/// Identifiability, intervals and posterior; an error is a wish to stop.
fn tell(
    task: &Task<'_>,
    evaluator: &mut Evaluator,
    basis: &Basis,
    point: &[f64],
    clock: &dyn Fn() -> f64,
    found: &mut Update,
) -> Result<(), ()> {
    // Slices count with what the full passage of the model that was found gives beyond them.
    let corrected = match basis.corrected(evaluator, point) {
        Ok(corrected) => corrected,
        Err(Halt::Stopped) => return Err(()),
        Err(Halt::Failed(_)) => basis.clone(),
    };
    let basis = &corrected;
    match calibrate::identify::identify(evaluator, basis, point, searches::STEP) {
        Ok(told) => found.identifiability = Some(told),
        Err(Halt::Stopped) => return Err(()),
        Err(Halt::Failed(failure)) => found.warnings.push(untold(warning::Asked::Identifiability, words(&failure))),
    }
    // A model that leaves more of a history than the stated noise is not as exact as the noise.
    let likelihood = searches::likelihood(&task.asked.plan);
    let problem = match evaluator.respond(&[point.to_vec()], &Request::all()) {
        Ok(answers) => match answers[0].as_ref() {
            Ok(response) => evaluator.problem.with_noise_of(response, &likelihood),
            Err(_) => evaluator.problem.clone(),
        },
        Err(_) => return Err(()),
    };
    if found.identifiability.is_some() {
        match searches::linearised(&task.asked.plan, evaluator, basis, point, &problem) {
            Ok(report) => found.linearised = Some(report),
            Err(Halt::Stopped) => return Err(()),
            Err(Halt::Failed(failure)) => found.warnings.push(untold(warning::Asked::Intervals, words(&failure))),
        }
    }
    if !task.asked.plan.posterior {
        return Ok(());
    }
    match searches::posterior(&task.asked.plan, evaluator, basis, &problem, clock) {
        Ok(Ok(report)) => found.posterior = Some(report),
        Ok(Err(message)) => found.warnings.push(untold(warning::Asked::Posterior, message)),
        Err(Halt::Stopped) => return Err(()),
        Err(Halt::Failed(failure)) => found.warnings.push(untold(warning::Asked::Posterior, words(&failure))),
    }
    Ok(())
}

fn untold(what: warning::Asked, why: String) -> Warning {
    warning::Service::Untold { what, why }.into()
}

fn words(failure: &Failure) -> String {
    format!("{} ({})", failure.message, failure.code)
}

fn parameter(asked: &bridge::update::Parameter) -> Parameter {
    let plain = Parameter::new(&asked.name, &asked.unit, asked.start, asked.lower, asked.upper);
    if asked.logarithmic { Parameter { scale: Scale::Logarithmic, ..plain } } else { plain }
}

/// How misfit is measured. Beside readings, records are compared in units of their uncertainty too: shares of a peak and multiples of an uncertainty make
/// no sum. Readings alone are compared as peaks are, in what a search asks for.
fn misfit(asked: &Asked, model: &Model<'_>) -> Misfit {
    let plan = &asked.plan;
    if model.crossing.is_none() {
        return Misfit { scaling: Scaling::Uncertainty, weights: weights(plan), slices: true, ..Misfit::default() };
    }
    let by_uncertainty = plan.by_uncertainty || model.standing.is_some();
    Misfit {
        compare: match plan.compare {
            Compared::Peaks => Compare::Peaks,
            Compared::Histories => Compare::Histories,
        },
        scaling: if by_uncertainty { Scaling::Uncertainty } else { Scaling::MeasuredPeak },
        weights: weights(plan),
        slices: plan.slices,
        ..Misfit::default()
    }
}

fn weights(plan: &update::Plan) -> Weights {
    match plan.weights {
        update::Weights::Shapes => Weights::ShapeCorrelation,
        update::Weights::Equal => Weights::Equal,
        update::Weights::Given => Weights::Given,
    }
}

/// Channels of the records, then those of the readings, and what was made of the records.
fn compared(task: &Task<'_>, model: &Model<'_>, start: &[Vec<f64>]) -> (Vec<Channel>, RecordsUsed) {
    let of_records = model.crossing.as_ref().zip(task.asked.records.as_ref());
    let found = of_records.map(|(setup, records)| measured::measured(task, (setup, records), start));
    let (mut channels, used) = found.unwrap_or_default();
    channels.extend(model.standing.iter().flat_map(|standing| standing.channels(task)));
    (channels, used)
}

/// The problem before records are looked at: it has the shape of the answers and nothing else.
fn blind(task: &Task<'_>, model: &Model<'_>) -> Result<Problem, UpdateError> {
    let parameters = task.asked.parameters.iter().map(parameter).collect();
    let sensors = model.crossing.iter().flat_map(|setup| &setup.sensors);
    let channels = sensors.map(|sensor| Channel::peak(&sensor.name, sensor.quantity.unit(), 1.0));
    let read = model.standing.iter().flat_map(|standing| standing.channels(task));
    // Whether anything is left out is looked at with the records.
    let read = read.map(|channel| Channel { left_out: None, ..channel });
    let misfit = Misfit { weights: Weights::Equal, ..Misfit::default() };
    Problem::new(parameters, channels.chain(read).collect(), misfit)
        .map_err(|flaws| UpdateError::NoProblem(flaws.iter().map(of_flaw).collect()))
}

fn of_flaw(flaw: &Flaw) -> String {
    format!("{}: {} ({})", flaw.place, flaw.message, flaw.help)
}

/// A passage of the start model; none where the onlooker wished to stop.
fn started(evaluator: &mut Evaluator) -> Result<Option<Response>, UpdateError> {
    let Ok(first) = evaluator.respond(&[evaluator.problem.start()], &Request::all()) else { return Ok(None) };
    let failed = |failure: Failure| UpdateError::StartModel(words(&failure));
    first[0].as_ref().clone().map(Some).map_err(failed)
}

/// An update of which nothing is known yet but what was asked.
fn cancelled(task: &Task<'_>, model: &Model<'_>, problem: Problem) -> Update {
    let crossing = model.crossing.as_ref();
    Update {
        bridge: task.bridge.name.clone(),
        train: model.base().map_or_else(String::new, |setup| setup.train.clone()),
        status: UpdateStatus::Cancelled,
        reason: None,
        answer: None,
        paths: task.asked.parameters.iter().map(|asked| asked.path.to_string()).collect(),
        problem,
        basis: None,
        times: crossing.map_or_else(Vec::new, |setup| setup.times.clone()),
        positions: crossing.map_or_else(Vec::new, |setup| setup.positions.clone()),
        channels: Vec::new(),
        read_at_rest: Vec::new(),
        searches: Vec::new(),
        paper: Vec::new(),
        identifiability: None,
        linearised: None,
        posterior: None,
        evaluations: 0,
        computed: 0,
        records: RecordsUsed::default(),
        assumptions: Vec::new(),
        warnings: Vec::new(),
    }
}

fn histories(model: &Model<'_>, problem: &Problem, start: &[Vec<f64>], updated: Option<&[Vec<f64>]>) -> Vec<Histories> {
    let sensors = model.crossing.iter().flat_map(|setup| &setup.sensors);
    let one = |(k, (channel, sensor)): (usize, (&Channel, &Placed))| Histories {
        name: channel.name.clone(),
        quantity: sensor.quantity,
        measured: channel.history.clone().unwrap_or_default(),
        start: start[k].clone(),
        updated: updated.map_or_else(Vec::new, |updated| updated[k].clone()),
        left_out: channel.left_out.clone(),
    };
    problem.channels().iter().zip(sensors).enumerate().map(one).collect()
}

fn assumptions(model: &Model<'_>, problem: &Problem, plan: &update::Plan) -> Vec<Note> {
    let Some(setup) = model.base() else { return Vec::new() };
    let compared = match (problem.misfit().compare, problem.misfit().slices) {
        (Compare::Histories, _) => InUpdate::Histories,
        (Compare::Peaks, true) => InUpdate::PeaksBySlices,
        (Compare::Peaks, false) => InUpdate::Peaks,
    };
    let gain = match plan.common_gain_deviation {
        0.0 => InUpdate::NoCommonGain,
        deviation => InUpdate::CommonGain { deviation },
    };
    let compared = model.crossing.as_ref().map(|_| compared);
    let readings = model.standing.as_ref().map(|_| InUpdate::Readings);
    let silent = problem.channels().iter().filter(|one| one.readings && one.counts() && one.uncertainty.is_none());
    let sensors: Vec<String> = silent.map(|channel| channel.name.clone()).collect();
    let silent = (!sensors.is_empty()).then_some(InUpdate::UnstatedReadings { sensors });
    let said = [InUpdate::Weights, InUpdate::Width { width: setup.effective_width }, gain];
    let anew = model.moves.then_some(InUpdate::MadeAnew);
    let own = compared.into_iter().chain(readings).chain(silent).chain(said).chain(anew).map(Note::from);
    let setups = model.crossing.iter().chain(model.standing.iter().map(|standing| &standing.test.setup));
    let mut all: Vec<Note> = own.collect();
    for note in setups.flat_map(|setup| &setup.assumptions) {
        if !all.contains(note) {
            all.push(note.clone());
        }
    }
    all
}

/// What a reader should look at before using the numbers.
fn warn(found: &mut Update, bridge: &Bridge) {
    let mut said = Vec::new();
    let synthetic = found.records.runs.iter().filter(|run| run.synthetic.is_some());
    let readings = bridge.load_test.as_ref().map(|test| &test.readings).filter(|one| one.synthetic.is_some());
    let readings = readings.and_then(|readings| readings.file.clone());
    let records: Vec<String> = synthetic.map(|run| run.name.clone()).chain(readings).collect();
    if !records.is_empty() {
        said.push(warning::Service::Synthetic { records });
    }
    if let Some(best) = found.found() {
        let at_bound = best.parameters.iter().filter(|parameter| parameter.at_bound);
        said.extend(at_bound.map(|one| warning::Service::AtBound { parameter: one.name.clone() }));
        if !best.wandered.is_empty() {
            said.push(warning::Service::Wandered { peaks: best.wandered.clone() });
        }
    }
    found.warnings.extend(said.into_iter().map(Warning::from));
}
