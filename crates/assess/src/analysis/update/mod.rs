//! Model updating: the moduli of a bridge from the records of a train's passage.

mod forward;
mod measured;
mod searches;

pub use forward::{Model, Threads};
pub use measured::RecordFile;

use super::AnalysisError;
use super::passage::Setup;
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
        format!("extrados {} {:016x}", env!("CARGO_PKG_VERSION"), checkpoint::fingerprint(&(self.bridge, paths)))
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
    let model = Model::new(task.bridge, task.document, &task.asked.parameters)?;
    let setup = &model.setup;
    measured::worth_a_passage(task.asked, setup, task.files).map_err(UpdateError::NoProblem)?;
    let blind = blind(task, setup)?;

    let mut evaluator = Evaluator::new(&blind, &model, means.map, &mut *means.watch, log);
    let first = started(&mut evaluator)?;
    let (log, already) = (evaluator.log, evaluator.computed);
    let Some(first) = first else { return Ok(cancelled(task, setup, blind)) };

    let (channels, used) = measured::measured(task, setup, &first.values);
    let of_records = || used.findings.iter().map(records::Finding::words);
    let problem = Problem::new(blind.parameters().to_vec(), channels, misfit(task.asked))
        .map_err(|flaws| UpdateError::NoProblem(flaws.iter().map(of_flaw).chain(of_records()).collect()))?;
    let mut evaluator = Evaluator::new(&problem, &model, means.map, means.watch, log);
    let basis = match Basis::at(&mut evaluator, &blind.start()) {
        Ok(basis) => basis,
        Err(Halt::Stopped) => return Ok(Update { records: used, ..cancelled(task, setup, problem.clone()) }),
        Err(Halt::Failed(failure)) => return Err(UpdateError::StartModel(words(&failure))),
    };

    let mut found = Update { records: used, ..cancelled(task, setup, problem.clone()) };
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
    found.channels = histories(setup, &problem, &first.values, updated.as_ref().map(|response| &response.values[..]));
    (found.evaluations, found.computed) = (evaluator.log.len(), evaluator.computed + already);
    found.assumptions = assumptions(&model, &problem, &task.asked.plan);
    found.basis = Some(basis);
    warn(&mut found);
    Ok(found)
}

/// The records alone, judged beside one passage of the start model: nothing is sought.
///
/// # Errors
/// A passage that cannot be set up, a start model without an answer, parameters that make no problem, or no record that can be used.
pub fn judge(task: &Task<'_>, means: Means<'_>) -> Result<Update, UpdateError> {
    let model = Model::new(task.bridge, task.document, &task.asked.parameters)?;
    let setup = &model.setup;
    let blind = blind(task, setup)?;
    let mut evaluator = Evaluator::new(&blind, &model, means.map, &mut *means.watch, Log::new(&task.identity()));
    let first = started(&mut evaluator)?;
    let log = evaluator.log;
    let Some(first) = first else { return Ok(cancelled(task, setup, blind)) };
    let (channels, used) = measured::measured(task, setup, &first.values);
    if used.runs.is_empty() {
        return Err(UpdateError::NoProblem(used.findings.iter().map(records::Finding::words).collect()));
    }
    // Where no channel can be compared, the verdict on the records is the answer all the same.
    let (posed, start) = (Problem::new(blind.parameters().to_vec(), channels, misfit(task.asked)), blind.start());
    let mut found = Update { records: used, ..cancelled(task, setup, blind) };
    found.status = UpdateStatus::Completed;
    match posed {
        Ok(problem) => {
            let mut evaluator = Evaluator::new(&problem, &model, means.map, means.watch, log);
            match Basis::at(&mut evaluator, &start) {
                Ok(basis) => found.basis = Some(basis),
                Err(Halt::Stopped) => found.status = UpdateStatus::Cancelled,
                Err(Halt::Failed(failure)) => found.warnings.push(untold(warning::Asked::StartFit, words(&failure))),
            }
            found.channels = histories(setup, &problem, &first.values, None);
            found.problem = problem;
        }
        Err(findings) => {
            let said: Vec<String> = findings.iter().map(|f| format!("{}: {}", f.place, f.message)).collect();
            found.warnings.push(untold(warning::Asked::StartFit, said.join("; ")));
        }
    }
    (found.evaluations, found.computed) = (1, 1);
    warn(&mut found);
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

fn misfit(asked: &Asked) -> Misfit {
    let plan = &asked.plan;
    Misfit {
        compare: match plan.compare {
            Compared::Peaks => Compare::Peaks,
            Compared::Histories => Compare::Histories,
        },
        scaling: if plan.by_uncertainty { Scaling::Uncertainty } else { Scaling::MeasuredPeak },
        weights: match plan.weights {
            update::Weights::Shapes => Weights::ShapeCorrelation,
            update::Weights::Equal => Weights::Equal,
            update::Weights::Given => Weights::Given,
        },
        slices: plan.slices,
        ..Misfit::default()
    }
}

/// The problem before records are looked at: it has the shape of the answers and nothing else.
fn blind(task: &Task<'_>, setup: &Setup) -> Result<Problem, UpdateError> {
    let parameters = task.asked.parameters.iter().map(parameter).collect();
    let channels = setup.sensors.iter().map(|sensor| Channel::peak(&sensor.name, sensor.quantity.unit(), 1.0));
    let misfit = Misfit { weights: Weights::Equal, ..Misfit::default() };
    Problem::new(parameters, channels.collect(), misfit)
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
fn cancelled(task: &Task<'_>, setup: &Setup, problem: Problem) -> Update {
    Update {
        bridge: task.bridge.name.clone(),
        train: setup.train.clone(),
        status: UpdateStatus::Cancelled,
        reason: None,
        answer: None,
        paths: task.asked.parameters.iter().map(|asked| asked.path.to_string()).collect(),
        problem,
        basis: None,
        times: setup.times.clone(),
        positions: setup.positions.clone(),
        channels: Vec::new(),
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

fn histories(setup: &Setup, problem: &Problem, start: &[Vec<f64>], updated: Option<&[Vec<f64>]>) -> Vec<Histories> {
    let one = |(k, channel): (usize, &Channel)| Histories {
        name: channel.name.clone(),
        quantity: setup.sensors[k].quantity,
        measured: channel.history.clone().unwrap_or_default(),
        start: start[k].clone(),
        updated: updated.map_or_else(Vec::new, |updated| updated[k].clone()),
        left_out: channel.left_out.clone(),
    };
    problem.channels().iter().enumerate().map(one).collect()
}

fn assumptions(model: &Model<'_>, problem: &Problem, plan: &update::Plan) -> Vec<Note> {
    let setup = &model.setup;
    let compared = match (problem.misfit().compare, problem.misfit().slices) {
        (Compare::Histories, _) => InUpdate::Histories,
        (Compare::Peaks, true) => InUpdate::PeaksBySlices,
        (Compare::Peaks, false) => InUpdate::Peaks,
    };
    let gain = match plan.common_gain_deviation {
        0.0 => InUpdate::NoCommonGain,
        deviation => InUpdate::CommonGain { deviation },
    };
    let said = [compared, InUpdate::Weights, InUpdate::Width { width: setup.effective_width }, gain];
    let anew = model.moves.then_some(InUpdate::MadeAnew);
    said.into_iter().chain(anew).map(Note::from).chain(setup.assumptions.iter().cloned()).collect()
}

/// What a reader should look at before using the numbers.
fn warn(found: &mut Update) {
    let mut said = Vec::new();
    let synthetic = found.records.runs.iter().filter(|run| run.synthetic.is_some());
    let records: Vec<String> = synthetic.map(|run| run.name.clone()).collect();
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
