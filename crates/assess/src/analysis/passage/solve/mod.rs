//! Solves the positions: self-weight first, then the train, by the condensed path or by the whole system.

mod condensed;
mod moment;
mod plain;
mod slices;

pub use slices::{Slices, Wanted as WantedSlices, slices};

use super::model::{assumptions, model};
use super::sensors::Reading;
use super::{PassageError, Setup};
use crate::analysis::AnalysisError;
use bridge::Bridge;
use bridge::passage::{PassageAnalysis, PassageKinematics, PassagePath};
use mechanics::fem::condensed::{Functional, open_interfaces};
use mechanics::fem::{Kinematics, Model, Outcome, Settings, State, Status, Step, Target, Workspace, advance};
use mechanics::ids::{Id, QuadId};
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::passage::Part;
use outcome::passage::{Influence, Moment, PassageStatus, StepLog};
use outcome::warning::Warning;

/// What solving gives. Records end at the last position that was solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// How it ended.
    pub status: PassageStatus,
    /// Why, where it did not complete.
    pub reason: Option<String>,
    /// Value of each sensor under self-weight alone [SI].
    pub self_weight: Vec<f64>,
    /// Value of each sensor at every position, self-weight taken off [SI]: all of the same length.
    pub values: Vec<Vec<f64>>,
    /// Unknowns of the model.
    pub degrees_of_freedom: usize,
    /// Unknowns that iterate, where linear parts are condensed.
    pub condensed_degrees_of_freedom: Option<usize>,
    /// Parts of the model that did not answer linearly, where linear parts are condensed.
    pub taking_part: Vec<usize>,
    /// Every step: of the self-weight, then of the passage.
    pub log: Vec<StepLog>,
    /// The bridge at chosen moments, self-weight first.
    pub moments: Vec<Moment>,
    /// Influence lines, where they were computed.
    pub influence: Option<Influence>,
    /// What the solver assumed, in words.
    pub assumptions: Vec<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

/// Out-of-balance force over applied force of the self-weight, from which everything else starts.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// Self-weight first, then position after position, then what is to be shown of it.
pub fn solve(bridge: &Bridge, setup: &Setup, watch: &mut dyn Watch) -> Result<Solution, AnalysisError> {
    solve_for(bridge, setup, Wanted::Everything, &[], watch)
}

/// Self-weight and positions alone: the values of the sensors, without pictures and influence lines. `expected` are the parts of the
/// model that took part with other moduli, or none.
pub fn records(
    bridge: &Bridge,
    setup: &Setup,
    expected: &[usize],
    watch: &mut dyn Watch,
) -> Result<Solution, AnalysisError> {
    solve_for(bridge, setup, Wanted::Records, expected, watch)
}

/// What is wanted of a passage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    Records,
    Everything,
}

fn solve_for(
    bridge: &Bridge,
    setup: &Setup,
    wanted: Wanted,
    expected: &[usize],
    watch: &mut dyn Watch,
) -> Result<Solution, AnalysisError> {
    let large = setup.plan.kinematics == PassageKinematics::Large;
    let kinematics = if large { Kinematics::Large } else { Kinematics::Small };
    let model = model(bridge, &setup.meshed, kinematics)?;
    let weight = self_weight(bridge, setup, &model);
    let mut solution = Solution {
        status: PassageStatus::Completed,
        reason: None,
        self_weight: Vec::new(),
        values: vec![Vec::new(); setup.sensors.len()],
        degrees_of_freedom: model.equations(),
        condensed_degrees_of_freedom: None,
        taking_part: Vec::new(),
        log: Vec::new(),
        moments: Vec::new(),
        influence: None,
        assumptions: assumptions(bridge, &setup.meshed),
        warnings: Vec::new(),
    };
    let bridge_at_rest = AtRest { setup, model: &model, weight: &weight };
    if condenses(setup) {
        condensed::pass(&bridge_at_rest, &mut solution, wanted, expected, watch)?;
        return Ok(solution);
    }
    let mut work = Workspace::new(&model).map_err(PassageError::from)?;
    let mut state = State::new(&model);
    let settings = Settings {
        tolerance: setup.plan.tolerance.min(WEIGHT_TOLERANCE),
        load_steps: setup.plan.load_steps as u32,
        iteration_limit: setup.plan.iterations as u32,
        ..Settings::default()
    };
    let target = Target { forces: weight.clone(), imposed: Vec::new() };
    let mut named = Named { watch, stage: "self-weight" };
    let outcome = advance(&model, &mut state, &mut work, &target, &settings, &mut named);
    solution.log.extend(outcome.steps.iter().map(of_weight));
    if let Some(last) = solution.log.last_mut() {
        last.open_joints = open_interfaces(&model, state.bonds.iter());
    }
    if outcome.status != Status::Completed {
        end(&mut solution, &outcome, "under self-weight");
        return Ok(solution);
    }
    solution.self_weight = setup.sensors.iter().map(|sensor| read(&sensor.reading, &state)).collect();
    solution.moments.push(moment::moment(setup, &model, &state, "self-weight", None));
    plain::pass(&bridge_at_rest, state, work, &mut solution, watch)?;
    Ok(solution)
}

/// Whether the condensed path is taken: it is asked for, nothing moves fast or far, and every sensor is a sum of displacements.
pub(super) fn condenses(setup: &Setup) -> bool {
    let plan = &setup.plan;
    let still = plan.analysis == PassageAnalysis::Static && plan.kinematics != PassageKinematics::Large;
    let linear_sensors = setup.sensors.iter().all(|sensor| functional(&sensor.reading).is_some());
    still && plan.path == PassagePath::Condensed && linear_sensors
}

/// A bridge and its own weight.
struct AtRest<'a> {
    setup: &'a Setup,
    model: &'a Model,
    /// Nodal forces of its weight [N/m].
    weight: &'a [f64],
}

/// Nodal forces of masses and of what lies on the surface [N/m].
fn self_weight(bridge: &Bridge, setup: &Setup, model: &Model) -> Vec<f64> {
    let mut forces = model.weight(vec2(0.0, -bridge.gravity));
    for (node, force) in setup.meshed.sets.surface.iter().zip(&setup.dead_load) {
        forces[2 * node.index() + 1] -= force;
    }
    forces
}

/// Nodal forces of the train at a position, on top of the weight [N/m].
fn with_train(rest: &AtRest<'_>, position: f64) -> Vec<f64> {
    let mut forces = rest.weight.to_vec();
    let train = rest.setup.forces(position);
    for (node, force) in rest.setup.meshed.sets.surface.iter().zip(train) {
        forces[2 * node.index() + 1] -= force;
    }
    forces
}

/// Value of a sensor in a state.
fn read(reading: &Reading, state: &State) -> f64 {
    let moved = |node: mechanics::ids::NodeId| {
        let first = 2 * node.index();
        [state.displacements[first], state.displacements[first + 1]]
    };
    reading.value(moved, |quad| {
        let [xx, yy, _, xy] = mean_stress(state, quad);
        [xx, yy, xy]
    })
}

/// Mean stress of an element's points: xx, yy, zz, xy [Pa].
fn mean_stress(state: &State, quad: QuadId) -> [f64; 4] {
    let points = &state.points[4 * quad.index()..4 * quad.index() + 4];
    std::array::from_fn(|i| 0.25 * points.iter().map(|point| point.stress[i]).sum::<f64>())
}

/// A sensor as a functional of displacements, where it is one.
fn functional(reading: &Reading) -> Option<Functional> {
    match reading {
        Reading::Displacements(terms) => {
            let of = |(node, [x, y]): &(mechanics::ids::NodeId, [f64; 2])| {
                [(2 * node.index(), *x), (2 * node.index() + 1, *y)]
            };
            Some(Functional(terms.iter().flat_map(of).filter(|(_, factor)| *factor != 0.0).collect()))
        }
        Reading::Stress { .. } => None,
    }
}

fn of_weight(step: &Step) -> StepLog {
    StepLog { stage: Part::SelfWeight, time: step.reached, ..of_step(step) }
}

fn of_step(step: &Step) -> StepLog {
    StepLog {
        iterations: step.iterations as usize,
        unbalanced: step.unbalanced,
        cuts: usize::from(!step.kept),
        plastic_points: step.yielding,
        locking_elements: step.locking,
        sliding_pairs: step.sliding,
        ..StepLog::default()
    }
}

/// Books an end that is none of a whole passage.
fn end(solution: &mut Solution, outcome: &Outcome, place: &str) {
    let (status, why) = match outcome.status {
        Status::Cancelled => (PassageStatus::Cancelled, None),
        Status::Singular => {
            (PassageStatus::NotConverged, Some("the stiffness has no inverse: a part moves without resistance"))
        }
        _ => (PassageStatus::NotConverged, Some("no balance was found, however small the step")),
    };
    solution.status = status;
    solution.reason = why.map(|why| format!("{place}, at {:.0} % of the step: {why}", 100.0 * outcome.reached));
}

/// An onlooker who is told which stage is at work.
struct Named<'a> {
    watch: &'a mut dyn Watch,
    stage: &'static str,
}

impl Watch for Named<'_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        self.watch.look(&Progress { stage: format!("{}: {}", self.stage, progress.stage), ..progress.clone() })
    }
}
