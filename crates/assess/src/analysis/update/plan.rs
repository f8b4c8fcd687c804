//! What the readings of a load test would tell, before anyone goes out: which positions and which sensors narrow the parameters most.

use super::readings::Standing;
use super::{Means, Model, Task, UpdateError, blind, misfit, of_flaw, searches, started, words};
use bridge::Bridge;
use bridge::update::Update as Asked;
use calibrate::linearised::design::{self, Reading};
use calibrate::{Basis, Channel, Design, Evaluator, Expected, Halt, Linearised, Log, Parameter, Problem};
use outcome::note::{InUpdate, Note};
use outcome::plan::{LoadTestPlan, Sought, Telling};

/// Models beside that of the file by which information is averaged.
const MODELS: usize = 8;
/// Most positions and sensors that are put in order: each of the others adds less than the last of them.
const MOST: usize = 20;
/// Standard deviations on either side of the middle that hold 95 %.
const NINETY_FIVE: f64 = 1.959_964;

/// What the load test of a file would tell of its parameters, whether it was read or not; none where somebody wished to stop.
///
/// # Errors
/// A load test that cannot be set up, a start model without an answer, or parameters that make no problem.
pub fn plan(task: &Task<'_>, means: Means<'_>) -> Result<Option<LoadTestPlan>, UpdateError> {
    let (bridge, asked) = (unread(task.bridge), Asked { records: None, ..task.asked.clone() });
    let task = &Task { bridge: &bridge, asked: &asked, files: &[], ..*task };
    let model = Model::new(&bridge, task.document, &asked)?;
    let Some(standing) = &model.standing else { return Ok(None) };
    let blind = blind(task, &model)?;
    let mut evaluator = Evaluator::new(&blind, &model, means.map, &mut *means.watch, Log::new(&task.identity()));
    let Some(first) = started(&mut evaluator)? else { return Ok(None) };
    let log = evaluator.log;
    // What readings tell does not hang on what they are: here they are those of the start model.
    let expected = standing.channels(task).into_iter().zip(first.values);
    let channels = expected.map(|(channel, values)| Channel { history: Some(values), ..channel }).collect();
    let problem = Problem::new(blind.parameters().to_vec(), channels, misfit(&asked, &model))
        .map_err(|flaws| UpdateError::NoProblem(flaws.iter().map(of_flaw).collect()))?;
    let mut evaluator = Evaluator::new(&problem, &model, means.map, means.watch, log);
    match designs(task, &mut evaluator) {
        Ok(designs) => Ok(Some(told(task, standing, &problem, &designs))),
        Err(Halt::Stopped) => Ok(None),
        Err(Halt::Failed(failure)) => Err(UpdateError::StartModel(words(&failure))),
    }
}

/// The readings as the start model has them, and as models from all over the ranges have them; those without an answer are passed over.
fn designs(task: &Task<'_>, evaluator: &mut Evaluator) -> Result<Vec<Design>, Halt> {
    let (problem, plan) = (evaluator.problem, &task.asked.plan);
    let start = problem.start();
    let basis = Basis::at(evaluator, &start)?;
    let mut designs = Vec::new();
    for point in std::iter::once(start).chain(design::models(problem.parameters(), MODELS, plan.seed)) {
        match Linearised::at(evaluator, &basis, &point, searches::STEP) {
            Ok(line) => designs.push(line.design(problem, &searches::likelihood(plan))),
            Err(Halt::Failed(_)) if !designs.is_empty() => {}
            Err(halt) => return Err(halt),
        }
    }
    Ok(designs)
}

/// The bridge with a reading of every sensor in every position; any will do, but for zero, which has no hundredth.
fn unread(bridge: &Bridge) -> Bridge {
    let mut bridge = bridge.clone();
    if let Some(test) = &mut bridge.load_test {
        test.readings.values = vec![vec![Some(1.0); test.positions.len()]; test.sensors.len()];
    }
    bridge
}

fn told(task: &Task<'_>, standing: &Standing, problem: &Problem, designs: &[Design]) -> LoadTestPlan {
    let sensors: Vec<usize> = standing.read.iter().map(|(sensor, _)| *sensor).collect();
    let positions = &standing.test.names;
    let in_position = |place: usize| (0..sensors.len()).map(|channel| (channel, place)).collect();
    let of_sensor = |channel: usize| (0..positions.len()).map(|place| (channel, place)).collect();
    let groups = |count: usize, of: &dyn Fn(usize) -> Vec<Reading>| (0..count).map(of).collect::<Vec<_>>();
    let by_position = groups(positions.len(), &in_position);
    let by_sensor = groups(sensors.len(), &of_sensor);
    let all = design::of(designs, &by_sensor.concat());
    let parameters = problem.parameters();
    let sensor = |k: usize| standing.test.setup.sensors[sensors[k]].name.clone();
    let positions = in_order(designs, parameters, &by_position, |k| positions[k].clone());
    let sensors = in_order(designs, parameters, &by_sensor, sensor);
    LoadTestPlan {
        sought: parameters.iter().map(sought).collect(),
        information: all.information,
        intervals: intervals(parameters, &all),
        not_listed: [by_position.len() - positions.len(), by_sensor.len() - sensors.len()],
        positions,
        sensors,
        assumptions: assumptions(task, standing, problem, designs.len() - 1),
    }
}

/// Groups of readings in the order in which each adds most.
fn in_order(
    designs: &[Design],
    parameters: &[Parameter],
    groups: &[Vec<Reading>],
    name: impl Fn(usize) -> String,
) -> Vec<Telling> {
    let mut before = 0.0;
    let mut one = |(k, expected): (usize, Expected)| {
        let information = expected.information - before;
        before = expected.information;
        Telling { name: name(k), information, intervals: intervals(parameters, &expected) }
    };
    design::in_order(designs, groups, MOST).into_iter().map(&mut one).collect()
}

fn sought(parameter: &Parameter) -> Sought {
    Sought {
        name: parameter.name.clone(),
        unit: parameter.unit.clone(),
        start: parameter.start,
        range: [parameter.lower, parameter.upper],
    }
}

/// Intervals about the start that would hold each parameter with 95 %, within the ranges.
fn intervals(parameters: &[Parameter], expected: &Expected) -> Vec<[f64; 2]> {
    let one = |(parameter, deviation): (&Parameter, &f64)| {
        let start = parameter.share(parameter.start);
        [-1.0, 1.0].map(|side| parameter.at(start + side * NINETY_FIVE * deviation))
    };
    parameters.iter().zip(&expected.deviations).map(one).collect()
}

fn assumptions(task: &Task<'_>, standing: &Standing, problem: &Problem, models: usize) -> Vec<Note> {
    let plan = &task.asked.plan;
    let silent = problem.channels().iter().filter(|one| one.counts() && one.uncertainty.is_none());
    let sensors: Vec<String> = silent.map(|channel| channel.name.trim_end_matches(" (load test)").to_owned()).collect();
    let planned = InUpdate::Planned { models, common_gain: plan.common_gain_deviation, model_error: plan.model_error };
    let silent = (!sensors.is_empty()).then(|| InUpdate::PlannedUnstated { sensors }.into());
    let setup = standing.test.setup.assumptions.iter().cloned();
    std::iter::once(planned.into()).chain(silent).chain(setup).collect()
}
