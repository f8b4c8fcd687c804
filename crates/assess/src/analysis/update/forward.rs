//! The finite element model as a function of the parameters: the file is edited, read again, crossed by its train and loaded as in its load test. The
//! mesh and what stands on it is made once, where no parameter moves it.

use super::readings::Standing;
use crate::analysis::passage::{
    AtRest, PassageError, Scope, Setup, Solution, WantedSlices, at_rest, setup, slices, solve,
};
use crate::analysis::{AnalysisError, parallel};
use bridge::edit::Document;
use bridge::passage::{PassageAnalysis, PassagePlan};
use bridge::update::{Parameter, Update};
use bridge::{Bridge, Severity};
use calibrate::{Evaluation, Failure, Forward, Map, Request, Response, Samples};
use mechanics::watch::CancelToken;
use outcome::passage::{Measurand, PassageStatus};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::{Builder, ScopedJoinHandle};

/// A bridge whose quantities are sought.
#[derive(Debug)]
pub struct Model<'a> {
    own: &'a Bridge,
    document: &'a Document,
    parameters: &'a [Parameter],
    /// Mesh, positions and sensors of the passage at the start; none where no records of one are compared.
    pub crossing: Option<Setup>,
    /// The positions at rest whose readings are compared.
    pub standing: Option<Standing>,
    /// Whether a parameter moves the mesh, the loads or the sensors, so that they are made anew for every evaluation.
    pub moves: bool,
    /// What the answers of some models let expect of all others, by the positions that were asked for; `None` for all of them.
    usual: Mutex<BTreeMap<(Asked, Seen), Expected>>,
    /// Whether evaluations go on.
    token: CancelToken,
}

/// Positions of slices, or `None` for a whole passage.
type Asked = Option<Vec<usize>>;

/// Models whose answers let expect what takes part in others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Seen {
    /// The start model: for searches that go by derivatives, a few dozen evaluations.
    Start,
    /// Those, too, in which one parameter stands at either end of its range: for sweeps and surfaces, hundreds of evaluations. More than half of the slices are
    /// gone to twice without them, a tenth with them, and an evaluation takes three quarters of the time.
    Ends,
}

/// Parts that are expected, found when they are first asked for.
type Expected = Arc<OnceLock<Vec<usize>>>;

/// Share of a range by which the neighbours differ that derivatives are taken from: laws are nearly linear over it, and their rounding
/// leaves ten digits.
const APART: f64 = 1e-6;

impl<'a> Model<'a> {
    /// The model of a file: `document` is its text without the sections of updating.
    ///
    /// # Errors
    /// A passage or a load test that cannot be set up, as the file has it or with a parameter at its end.
    pub fn new(own: &'a Bridge, document: &'a Document, asked: &'a Update) -> Result<Self, AnalysisError> {
        let parameters = &asked.parameters;
        let crossing = asked.records.as_ref().map(|_| setup(own)).transpose()?;
        let standing = Standing::of(own)?;
        let mut model = Self {
            own,
            document,
            parameters,
            crossing,
            standing,
            moves: false,
            usual: Mutex::default(),
            token: CancelToken::default(),
        };
        for k in 0..parameters.len() {
            let mut point: Vec<f64> = parameters.iter().map(|parameter| parameter.start).collect();
            point[k] = if point[k] == parameters[k].lower { parameters[k].upper } else { parameters[k].lower };
            let there = model.bridge_at(&point).map_err(|failure| PassageError::Missing(failure.message))?;
            if let Some(own) = &model.crossing {
                model.moves |= setup(&there)? != *own;
            }
            if let Some(own) = &model.standing {
                model.moves |= at_rest::setup(&there)? != own.test;
            }
        }
        Ok(model)
    }

    /// The file with these values, read again.
    fn bridge_at(&self, point: &[f64]) -> Result<Bridge, Failure> {
        let mut document = self.document.clone();
        for (parameter, value) in self.parameters.iter().zip(point) {
            let set = document.set(&parameter.path, &parameter.literal(*value));
            set.map_err(|_| Failure::new("no-place", format!("the file has no place for `{}`", parameter.path)))?;
        }
        let read = bridge::read(document.text().as_bytes());
        let Some(mut bridge) = read.bridge else {
            let error = read.diagnostics.iter().find(|finding| finding.severity == Severity::Error);
            let message = error.map_or("the file cannot be read".into(), |e| format!("{} ({})", e.message, e.code));
            return Err(Failure::new("unusable-input", message));
        };
        // Vehicles and packings from files beside this one were read once.
        bridge.take_over(self.own);
        Ok(bridge)
    }

    /// Answers of a model, which expects what those of a few others let expect; those of the start model's own whole passage are found without, and
    /// once: answers do not depend on what was asked before.
    fn answer(
        &self,
        point: &[f64],
        bridge: &Bridge,
        setup: &Setup,
        asked: Asked,
        neighbours: &[(Bridge, f64)],
    ) -> Result<Solution, Failure> {
        if self.moves {
            return answers(bridge, setup, &asked, &[], &[], &self.token);
        }
        let seen = if asked.is_some() && neighbours.is_empty() { Seen::Ends } else { Seen::Start };
        let usual = {
            let mut usual = self.usual.lock().unwrap_or_else(PoisonError::into_inner);
            usual.entry((asked.clone(), seen)).or_default().clone()
        };
        let start: Vec<f64> = self.parameters.iter().map(|parameter| parameter.start).collect();
        if asked.is_none() && point == start {
            let found = whole(bridge, setup, &[], &self.token)?;
            usual.get_or_init(|| found.taking_part.clone());
            return Ok(found);
        }
        let usual = usual
            .get_or_init(|| if has_stress(setup) { Vec::new() } else { self.expected(&start, setup, &asked, seen) });
        answers(bridge, setup, &asked, usual, neighbours, &self.token)
    }

    /// Parts that take part in the answers of some models; one without answers tells nothing.
    fn expected(&self, start: &[f64], setup: &Setup, asked: &Asked, seen: Seen) -> Vec<usize> {
        let of = |point: &[f64], expected: &[usize]| -> Result<Vec<usize>, Failure> {
            Ok(answers(&self.bridge_at(point)?, setup, asked, expected, &[], &self.token)?.taking_part)
        };
        let first = of(start, &[]).unwrap_or_default();
        if seen == Seen::Start {
            return first;
        }
        let mut ends = Vec::new();
        for (k, parameter) in self.parameters.iter().enumerate() {
            for end in [parameter.lower, parameter.upper] {
                let mut point = start.to_vec();
                point[k] = end;
                ends.push(point);
            }
        }
        // Threads of their own: one of the pool's that waits here might be given an evaluation that waits for this list. Where
        // none can be started, as in WebAssembly, the work is done here.
        let share = ends.len().div_ceil(rayon::current_num_threads()).max(1);
        let of_some = &|points: &[Vec<f64>]| -> Vec<usize> {
            points.iter().flat_map(|point| of(point, &first).unwrap_or_default()).collect()
        };
        let mut all: Vec<usize> = std::thread::scope(|scope| {
            let start = |points| (points, Builder::new().spawn_scoped(scope, move || of_some(points)));
            let running: Vec<_> = ends.chunks(share).map(start).collect();
            let end = |(points, thread): (_, io::Result<ScopedJoinHandle<'_, Vec<usize>>>)| match thread {
                Ok(thread) => thread.join().unwrap_or_default(),
                Err(_) => of_some(points),
            };
            running.into_iter().flat_map(end).collect()
        });
        all.extend(first);
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The bridge with each parameter a little away from a point, inside its range.
    fn neighbours(&self, point: &[f64]) -> Result<Vec<(Bridge, f64)>, Failure> {
        let one = |(k, parameter): (usize, &Parameter)| {
            let apart = APART * (parameter.upper - parameter.lower);
            let mut other = point.to_vec();
            other[k] += if point[k] + apart > parameter.upper { -apart } else { apart };
            Ok((self.bridge_at(&other)?, other[k] - point[k]))
        };
        self.parameters.iter().enumerate().map(one).collect()
    }

    /// The passage on a bridge, at the times of the start model.
    fn setup_of<'s>(&self, known: &'s Setup, bridge: &Bridge) -> Result<Cow<'s, Setup>, Failure> {
        if !self.moves {
            return Ok(Cow::Borrowed(known));
        }
        let own = setup(bridge).map_err(not_set_up)?;
        let (times, positions) = (known.times.clone(), known.positions.clone());
        Ok(Cow::Owned(Setup { times, positions, ..own }))
    }

    /// Answers of the passage by channel, and their derivatives, at some places in its histories or at all.
    fn crossed(
        &self,
        point: &[f64],
        (bridge, known): (&Bridge, &Setup),
        places: Option<&[Vec<usize>]>,
        neighbours: &[(Bridge, f64)],
    ) -> Result<Response, Failure> {
        let setup = self.setup_of(known, bridge)?;
        let by_channel = |table| scaled(&setup, table);
        let Some(places) = places else {
            let found = self.answer(point, bridge, &setup, None, &[])?;
            return Ok(Response { values: by_channel(found.values), derivatives: Vec::new() });
        };
        let mut all: Vec<usize> = places.concat();
        all.sort_unstable();
        all.dedup();
        let found = self.answer(point, bridge, &setup, Some(all.clone()), neighbours)?;
        let at = |k: &usize| all.binary_search(k).unwrap_or_default();
        let of = |(wanted, values): (&Vec<usize>, Vec<f64>)| wanted.iter().map(|k| values[at(k)]).collect();
        let asked_for = |table: Vec<Vec<f64>>| by_channel(places.iter().zip(table).map(of).collect());
        Ok(Response {
            values: asked_for(found.values),
            derivatives: found.derivatives.into_iter().map(asked_for).collect(),
        })
    }

    /// Answers of the loads at rest where something was read, by channel, and their derivatives.
    fn stood(&self, bridge: &Bridge, standing: &Standing, neighbours: &[(Bridge, f64)]) -> Result<Response, Failure> {
        let expecting = |test: &AtRest, bridge: &Bridge, expected: &[usize], neighbours: &[(Bridge, f64)]| {
            let wanted = WantedSlices { expected, neighbours, ..WantedSlices::default() };
            completed(test.solve(bridge, wanted, &mut self.token.clone()).map_err(not_set_up)?)
        };
        let found = if self.moves {
            expecting(&at_rest::setup(bridge).map_err(not_set_up)?, bridge, &[], neighbours)?
        } else {
            let first = || {
                let start: Vec<f64> = self.parameters.iter().map(|parameter| parameter.start).collect();
                let found = self.bridge_at(&start).and_then(|bridge| expecting(&standing.test, &bridge, &[], &[]));
                found.map_or_else(|_| Vec::new(), |found| found.taking_part)
            };
            expecting(&standing.test, bridge, standing.expected.get_or_init(first), neighbours)?
        };
        let read = |table: Vec<Vec<f64>>| {
            let table = scaled(&standing.test.setup, table);
            let of = |(sensor, positions): &(usize, Vec<usize>)| positions.iter().map(|k| table[*sensor][*k]).collect();
            standing.read.iter().map(of).collect::<Vec<Vec<f64>>>()
        };
        Ok(Response { values: read(found.values), derivatives: found.derivatives.into_iter().map(read).collect() })
    }

    /// The passage, or the load test where there is none; none where nothing is compared.
    pub fn base(&self) -> Option<&Setup> {
        self.crossing.as_ref().or_else(|| self.standing.as_ref().map(|standing| &standing.test.setup))
    }

    /// How many channels are those of the passage.
    fn crossing_channels(&self) -> usize {
        self.crossing.as_ref().map_or(0, |setup| setup.sensors.len())
    }
}

/// A table by sensor in the units of the channels.
fn scaled(setup: &Setup, table: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let scales = setup.sensors.iter().map(|sensor| sensor.quantity.scale());
    let of = |(values, scale): (Vec<f64>, f64)| values.into_iter().map(|value| scale * value).collect();
    table.into_iter().zip(scales).map(of).collect()
}

fn not_set_up(error: AnalysisError) -> Failure {
    Failure::new("not-set-up", error.to_string())
}

fn has_stress(setup: &Setup) -> bool {
    setup.sensors.iter().any(|sensor| sensor.quantity == Measurand::Stress)
}

/// Answers at every position of the passage.
fn whole(bridge: &Bridge, setup: &Setup, expected: &[usize], token: &CancelToken) -> Result<Solution, Failure> {
    completed(solve(bridge, setup, Scope::Sensors, expected, &mut token.clone()).map_err(not_set_up)?)
}

/// Answers at every position of the passage, or static ones at some alone, in ascending order. Stresses are no functionals of
/// displacements: with them the train goes from one of these positions to the next.
fn answers(
    bridge: &Bridge,
    setup: &Setup,
    asked: &Asked,
    expected: &[usize],
    neighbours: &[(Bridge, f64)],
    token: &CancelToken,
) -> Result<Solution, Failure> {
    let Some(places) = asked else { return whole(bridge, setup, expected, token) };
    let positions: Vec<f64> = places.iter().map(|k| setup.positions[*k]).collect();
    if has_stress(setup) {
        let times = places.iter().map(|k| setup.times[*k]).collect();
        let plan = PassagePlan { analysis: PassageAnalysis::Static, ..setup.plan.clone() };
        let some = Setup { times, positions, plan, ..setup.clone() };
        return whole(bridge, &some, &[], token);
    }
    let wanted = WantedSlices { positions: &positions, expected, neighbours };
    completed(slices(bridge, setup, wanted, &mut token.clone()).map_err(not_set_up)?)
}

fn completed(answers: Solution) -> Result<Solution, Failure> {
    match answers.status {
        PassageStatus::Completed => Ok(answers),
        PassageStatus::Cancelled => Err(Failure::new(calibrate::STOPPED, String::new())),
        status => Err(Failure::new(status.word(), answers.reason.unwrap_or_default())),
    }
}

impl Forward for Model<'_> {
    fn evaluate(&self, point: &[f64], request: &Request) -> Evaluation {
        let bridge = self.bridge_at(point)?;
        let neighbours = if request.sensitivities { self.neighbours(point)? } else { Vec::new() };
        let mut all = Response::default();
        if let Some(setup) = &self.crossing {
            let places = match &request.samples {
                Samples::All => None,
                Samples::At(places) => Some(&places[..setup.sensors.len().min(places.len())]),
            };
            all = self.crossed(point, (&bridge, setup), places, &neighbours)?;
        }
        if let Some(standing) = &self.standing {
            let own = self.stood(&bridge, standing, &neighbours)?;
            all.values.extend(own.values);
            match all.derivatives.is_empty() {
                true => all.derivatives = own.derivatives,
                false => all.derivatives.iter_mut().zip(own.derivatives).for_each(|(all, own)| all.extend(own)),
            }
        }
        Ok(all)
    }

    /// Slices go with their derivatives, unless a parameter moves the mesh or a stress is among the sensors; loads at rest where none depends on another.
    fn has_sensitivities(&self, samples: &Samples) -> bool {
        let crossing = |setup: &Setup| *samples != Samples::All && !has_stress(setup);
        let standing = |standing: &Standing| standing.test.has_derivatives();
        !self.moves && self.crossing.as_ref().is_none_or(crossing) && self.standing.as_ref().is_none_or(standing)
    }

    fn stop(&self) {
        self.token.cancel();
    }

    fn length(&self, channel: usize) -> usize {
        match (channel.checked_sub(self.crossing_channels()), &self.standing, &self.crossing) {
            (Some(k), Some(standing), _) => standing.read.get(k).map_or(0, |(_, positions)| positions.len()),
            (_, _, crossing) => crossing.as_ref().map_or(0, |setup| setup.times.len()),
        }
    }
}

/// Evaluations side by side over the threads that there are; answers come in the order of the points.
#[derive(Debug, Clone, Copy, Default)]
pub struct Threads;

impl Map for Threads {
    fn map(
        &self,
        points: &[Vec<f64>],
        work: &(dyn Fn(&[f64]) -> Evaluation + Sync),
        look: &mut dyn FnMut(),
    ) -> Vec<Evaluation> {
        let lost = || Err(Failure::new("no-answer", "the thread of this point was lost"));
        let mut found: Vec<Evaluation> = points.iter().map(|_| lost()).collect();
        let mut hear = |said: Option<(usize, Evaluation)>| match said {
            Some((k, answer)) => found[k] = answer,
            None => look(),
        };
        parallel::told(points, &mut hear, |k, point, tell| {
            // Nobody listens only where this function itself is gone.
            let _ = tell.send((k, work(point)));
        });
        found
    }

    fn at_once(&self) -> usize {
        2 * rayon::current_num_threads()
    }
}
