//! Solves the positions: self-weight first, then the train, by the condensed path or by the whole system.

mod condensed;
mod moment;
mod plain;
mod slices;

pub use slices::{WantedSlices, slices};

use super::Setup;
use super::model::{assumptions, model};
use super::sensors::Reading;
use crate::analysis::AnalysisError;
use crate::analysis::parallel::Retold;
use bridge::Bridge;
use bridge::passage::{PassageAnalysis, PassageKinematics, PassagePath};
use mechanics::fem::condensed::Functional;
use mechanics::fem::{Kinematics, Model, Outcome, State, Status, Step};
use mechanics::ids::{Id, QuadId};
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Watch};
use outcome::note::Note;
use outcome::passage::{Influence, Moment, PassageStatus, StepLog};
use std::borrow::Cow;
use std::sync::Arc;

/// What solving gives. Records end at the last position that was solved.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solution {
    /// How it ended.
    pub status: PassageStatus,
    /// Why, where it did not complete.
    pub reason: Option<String>,
    /// Value of each sensor under self-weight alone [SI].
    pub self_weight: Vec<f64>,
    /// Value of each sensor at every position, self-weight taken off [SI]: all of the same length.
    pub values: Vec<Vec<f64>>,
    /// Of slices: derivatives of the values by each quantity that was asked for, in the same shape.
    pub derivatives: Vec<Vec<Vec<f64>>>,
    /// Unknowns of the model.
    pub degrees_of_freedom: usize,
    /// Unknowns that iterate, where linear parts are condensed.
    pub condensed_degrees_of_freedom: Option<usize>,
    /// Parts of the model that did not answer linearly, where linear parts are condensed: what to expect of the same bridge with other moduli.
    pub taking_part: Vec<usize>,
    /// Every step: of the self-weight, then of the passage.
    pub log: Vec<StepLog>,
    /// The bridge at chosen moments, self-weight first.
    pub moments: Vec<Moment>,
    /// Influence lines, where they were computed.
    pub influence: Option<Influence>,
    /// Where the axle of influence lines found no balance [m].
    pub no_influence_at: Option<f64>,
    /// What the solver assumed, in words.
    pub assumptions: Vec<Note>,
}

/// Self-weight first, then position after position, then what is to be shown of it. `expected` are the parts of the model that took part with
/// other moduli, or none.
///
/// # Errors
/// Values that the model needs and the file lacks, no model or no inverse of its stiffness, or a part whose law has no answer.
pub fn solve(
    bridge: &Bridge,
    setup: &Setup,
    wanted: Scope,
    expected: &[usize],
    watch: &mut dyn Watch,
) -> Result<Solution, AnalysisError> {
    let mut passing = Passing::with(bridge, Cow::Borrowed(setup), wanted, expected, watch)?;
    passing.advance(usize::MAX, watch)?;
    passing.finish(watch)
}

/// How much of a passage is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Sensors, joints at their peaks, influence lines.
    Everything,
    /// Sensors alone.
    Sensors,
}

/// A passage that goes on when it is told to. However it is moved on, it finds the same numbers.
pub struct Passing<'s> {
    rest: AtRest<'s>,
    way: Way,
    wanted: Scope,
    /// Positions that were reached.
    pub done: usize,
    /// What was found so far.
    solution: Solution,
}

/// By which path.
enum Way {
    /// Small models have little to keep, large ones much.
    Plain(Box<plain::Way>),
    Condensed(Box<condensed::Way>),
}

impl<'s> Passing<'s> {
    /// The bridge under its own weight, before the train.
    ///
    /// # Errors
    /// Those of [`solve`].
    pub fn new(bridge: &Bridge, setup: Cow<'s, Setup>, watch: &mut dyn Watch) -> Result<Passing<'s>, AnalysisError> {
        Passing::with(bridge, setup, Scope::Everything, &[], watch)
    }

    fn with(
        bridge: &Bridge,
        setup: Cow<'s, Setup>,
        wanted: Scope,
        expected: &[usize],
        watch: &mut dyn Watch,
    ) -> Result<Passing<'s>, AnalysisError> {
        let large = setup.plan.kinematics == PassageKinematics::Large;
        let kinematics = if large { Kinematics::Large } else { Kinematics::Small };
        let model = model(bridge, &setup.meshed, kinematics)?;
        let weight = self_weight(bridge, &setup, &model);
        let mut solution = Solution {
            status: PassageStatus::Completed,
            values: vec![Vec::new(); setup.sensors.len()],
            degrees_of_freedom: model.equations(),
            assumptions: assumptions(bridge, &setup.meshed),
            ..Solution::default()
        };
        let condenses = condenses(&setup);
        let rest = AtRest { setup, model: Arc::new(model), weight };
        let way = match condenses {
            true => Way::Condensed(Box::new(condensed::Way::new(&rest, &mut solution, expected, watch)?)),
            false => Way::Plain(Box::new(plain::Way::new(&rest, &mut solution, watch)?)),
        };
        let mut passing = Passing { rest, way, wanted, done: 0, solution };
        if wanted == Scope::Everything && passing.solution.status == PassageStatus::Completed {
            let moment = passing.moment()?;
            passing.solution.moments.push(moment);
        }
        Ok(passing)
    }

    /// Mesh, positions and sensors.
    pub fn setup(&self) -> &Setup {
        &self.rest.setup
    }

    /// Moves the train on by so many positions, or to the last one. Tells how the passage ended, once it has.
    ///
    /// # Errors
    /// A part of the model whose law has no answer.
    pub fn advance(&mut self, count: usize, watch: &mut dyn Watch) -> Result<Option<PassageStatus>, AnalysisError> {
        let to = self.done.saturating_add(count);
        while self.done < to && self.status().is_none() {
            let Passing { rest, way, done, solution, .. } = self;
            match way {
                Way::Plain(way) => way.visit(rest, *done, solution, watch)?,
                Way::Condensed(way) => way.visit(rest, *done, solution, watch)?,
            }
            *done += usize::from(solution.status == PassageStatus::Completed);
        }
        Ok(self.status())
    }

    /// How the passage ended; none while it goes on.
    pub fn status(&self) -> Option<PassageStatus> {
        let status = self.solution.status;
        (status != PassageStatus::Completed || self.done == self.setup().positions.len()).then_some(status)
    }

    /// Values of the sensors at the position that was reached last, self-weight taken off [SI]; empty before the first one.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.solution.values.iter().filter_map(|values| values.last().copied())
    }

    /// The bridge at the position that was reached last; under its own weight before the first one.
    ///
    /// # Errors
    /// A part of the model whose law has no answer.
    pub fn moment(&mut self) -> Result<Moment, AnalysisError> {
        let Passing { rest, way, done, .. } = self;
        let last = done.checked_sub(1);
        let name = last.map_or("self-weight".to_owned(), |k| axle_at(rest.setup.positions[k]));
        let state = match way {
            Way::Plain(way) => Cow::Borrowed(way.state()),
            Way::Condensed(way) => Cow::Owned(way.state(last)?),
        };
        Ok(rest.moment(&state, &name, last))
    }

    /// What was found; a passage that is left before its end was cancelled.
    ///
    /// # Errors
    /// A part of the model whose law has no answer.
    pub fn finish(self, watch: &mut dyn Watch) -> Result<Solution, AnalysisError> {
        let status = self.status().unwrap_or(PassageStatus::Cancelled);
        let Passing { rest, way, wanted, mut solution, .. } = self;
        solution.status = status;
        match way {
            Way::Plain(way) => way.finish(&rest, &mut solution, wanted),
            Way::Condensed(way) => way.finish(&rest, &mut solution, wanted, watch)?,
        }
        Ok(solution)
    }
}

fn axle_at(x: f64) -> String {
    format!("first axle at {x:.2} m")
}

/// Positions of which pictures are made, in their order, and why: those of the file that were reached, or the peaks of the channels.
fn pictures(setup: &Setup, solution: &Solution) -> Vec<(usize, String)> {
    let solved = solution.values.first().map_or(0, Vec::len);
    let mut wanted: Vec<(usize, String)> = Vec::new();
    if setup.plan.pictures.is_empty() && solved > 0 {
        for (sensor, values) in setup.sensors.iter().zip(&solution.values) {
            let peak = (0..solved).fold(0, |best, k| if values[k].abs() > values[best].abs() { k } else { best });
            match wanted.iter_mut().find(|(k, _)| *k == peak) {
                Some((_, name)) => *name = format!("{name}, {}", sensor.name),
                None => wanted.push((peak, format!("peak of {}", sensor.name))),
            }
        }
    }
    wanted.extend(nearest(setup).filter(|(k, _)| *k < solved).map(|(k, x)| (k, axle_at(x))));
    wanted.sort_by_key(|(k, _)| *k);
    wanted
}

/// Positions that lie nearest to the places of which the file wants pictures [m].
fn nearest(setup: &Setup) -> impl Iterator<Item = (usize, f64)> {
    setup.plan.pictures.iter().filter_map(|&x| {
        let near = |k: &usize| (setup.positions[*k] - x).abs();
        let k = (0..setup.positions.len()).min_by(|a, b| near(a).total_cmp(&near(b)))?;
        Some((k, x))
    })
}

/// Whether the condensed path is taken: it is asked for, nothing moves fast or far, and every sensor is a sum of displacements.
pub(super) fn condenses(setup: &Setup) -> bool {
    let plan = &setup.plan;
    let still = plan.analysis == PassageAnalysis::Static && plan.kinematics != PassageKinematics::Large;
    let linear_sensors = setup.sensors.iter().all(|sensor| functional(&sensor.reading).is_some());
    still && plan.path == PassagePath::Condensed && linear_sensors
}

/// A bridge and its own weight.
struct AtRest<'s> {
    setup: Cow<'s, Setup>,
    model: Arc<Model>,
    /// Nodal forces of its weight [N/m].
    weight: Vec<f64>,
}

impl AtRest<'_> {
    /// The bridge in a state, at a position or before the first one.
    fn moment(&self, state: &State, name: &str, position: Option<usize>) -> Moment {
        let at = position.map(|k| (self.setup.times[k], self.setup.positions[k]));
        moment::moment(&self.setup, &self.model, state, name, at)
    }
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
    let mut forces = rest.weight.clone();
    let train = rest.setup.loads.forces(position, rest.setup.meshed.sets.surface.len());
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
            Some(terms.iter().flat_map(of).filter(|(_, factor)| *factor != 0.0).collect())
        }
        Reading::Stress { .. } => None,
    }
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

/// Records why the passage stopped early.
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

/// An onlooker who is told that the self-weight is brought on.
fn of_self_weight(watch: &mut dyn Watch) -> impl Watch {
    let told = |progress: &Progress| Progress { stage: format!("self-weight: {}", progress.stage), ..progress.clone() };
    Retold { watch, kept: None, told }
}
