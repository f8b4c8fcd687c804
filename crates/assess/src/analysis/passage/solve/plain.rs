//! The passage by the whole system: every unknown at every position, at rest or in motion.

use super::{AtRest, Scope, Solution, end, nearest, of_self_weight, of_step, pictures, read, with_train};
use crate::analysis::AnalysisError;
use crate::analysis::parallel::Retold;
use crate::analysis::passage::{PassageError, Setup};
use bridge::passage::PassageAnalysis;
use mechanics::fem::condensed::open_interfaces;
use mechanics::fem::{Damping, Motion, Outcome, Settings, State, Status, Step, Target, Workspace, advance, transient};
use mechanics::watch::{Progress, Watch};
use outcome::passage::{Part, PassageStatus, StepLog};
use std::collections::BTreeMap;

/// Out-of-balance force over applied force of the self-weight, from which everything else starts.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// What the path keeps from one position to the next.
pub(super) struct Way {
    state: State,
    work: Workspace,
    settings: Settings,
    motion: Option<Motion>,
    /// States of which pictures may be made, by positions.
    kept: BTreeMap<usize, State>,
    /// Position and size of each channel's largest value so far.
    peaks: Vec<(usize, f64)>,
}

impl Way {
    /// Brings the self-weight on.
    pub(super) fn new(rest: &AtRest<'_>, solution: &mut Solution, watch: &mut dyn Watch) -> Result<Way, AnalysisError> {
        let (setup, model) = (&*rest.setup, &*rest.model);
        let plan = &setup.plan;
        let mut work = Workspace::new(model).map_err(PassageError::from)?;
        let mut state = State::new(model);
        let settings = Settings {
            tolerance: plan.tolerance,
            load_steps: 1,
            iteration_limit: plan.iterations as u32,
            ..Settings::default()
        };
        let of_weight = Settings {
            tolerance: plan.tolerance.min(WEIGHT_TOLERANCE),
            load_steps: plan.load_steps as u32,
            ..settings
        };
        let target = Target { forces: rest.weight.clone(), imposed: Vec::new() };
        let outcome = advance(model, &mut state, &mut work, &target, &of_weight, &mut of_self_weight(watch));
        let log = |step: &Step| StepLog { stage: Part::SelfWeight, time: step.reached, ..of_step(step) };
        solution.log.extend(outcome.steps.iter().map(log));
        if let Some(last) = solution.log.last_mut() {
            last.open_joints = open_interfaces(model, state.bonds.iter());
        }
        let mut motion = None;
        if outcome.status == Status::Completed {
            solution.self_weight = setup.sensors.iter().map(|sensor| read(&sensor.reading, &state)).collect();
            if plan.analysis == PassageAnalysis::Transient {
                motion = Some(self::motion(rest, &mut work)?);
            }
        } else {
            end(solution, &outcome, "under self-weight");
        }
        let peaks = vec![(0, -1.0); setup.sensors.len()];
        Ok(Way { state, work, settings, motion, kept: BTreeMap::new(), peaks })
    }

    /// The position that was reached last.
    pub(super) fn state(&self) -> &State {
        &self.state
    }

    /// Solves position `k`, the next one.
    pub(super) fn visit(
        &mut self,
        rest: &AtRest<'_>,
        k: usize,
        solution: &mut Solution,
        watch: &mut dyn Watch,
    ) -> Result<(), AnalysisError> {
        let (setup, model) = (&*rest.setup, &*rest.model);
        let Way { state, work, settings, motion, .. } = self;
        let (position, time, count) = (setup.positions[k], setup.times[k], setup.positions.len());
        let told = |_: &Progress| {
            let stage = format!("position {} of {count}", k + 1);
            Progress { stage, fraction: Some(k as f64 / count as f64), steps: k as u64 }
        };
        let mut placed = Retold { watch, kept: None, told };
        let forces = with_train(rest, position);
        let outcome: Outcome = match motion {
            None => {
                let target = Target { forces, imposed: Vec::new() };
                advance(model, state, work, &target, settings, &mut placed)
            }
            Some(motion) => {
                let (mut given, mut unseen) = (|_| forces.clone(), |_: u64, _: &State, _: &Workspace| {});
                transient((model, settings), (state, work), (motion, 1), &mut given, &mut unseen, &mut placed)
            }
        };
        if outcome.status == Status::Cancelled {
            solution.status = PassageStatus::Cancelled;
            return Ok(());
        }
        if let Some(step) = outcome.steps.last() {
            let cuts = outcome.steps.iter().filter(|step| !step.kept).count();
            let iterations = outcome.iterations as usize;
            let open_joints = open_interfaces(model, state.bonds.iter());
            solution.log.push(StepLog {
                stage: Part::Passage,
                time,
                position,
                cuts,
                iterations,
                open_joints,
                ..of_step(step)
            });
        }
        if outcome.status != Status::Completed {
            end(solution, &outcome, &setup.loads.place_words(position));
            return Ok(());
        }
        for (s, sensor) in setup.sensors.iter().enumerate() {
            solution.values[s].push(read(&sensor.reading, &self.state) - solution.self_weight[s]);
        }
        self.keep(setup, k, solution);
        Ok(())
    }

    /// Keeps the state where a picture of it may be wanted: at a place of the file, or at the largest values so far.
    fn keep(&mut self, setup: &Setup, k: usize, solution: &Solution) {
        let mut wanted = nearest(setup).any(|(at, _)| at == k);
        if setup.plan.pictures.is_empty() {
            for (peak, values) in self.peaks.iter_mut().zip(&solution.values) {
                if values[k].abs() > peak.1 {
                    *peak = (k, values[k].abs());
                    wanted = true;
                }
            }
            let peaks = &self.peaks;
            self.kept.retain(|at, _| peaks.iter().any(|peak| peak.0 == *at));
        }
        if wanted {
            self.kept.insert(k, self.state.clone());
        }
    }

    /// Makes the pictures.
    pub(super) fn finish(self, rest: &AtRest<'_>, solution: &mut Solution, wanted: Scope) {
        if wanted == Scope::Sensors || solution.status == PassageStatus::Cancelled {
            return;
        }
        let places = pictures(&rest.setup, solution);
        let moments = places.iter().filter_map(|(k, name)| Some(rest.moment(self.kept.get(k)?, name, Some(*k))));
        solution.moments.extend(moments);
    }
}

/// Masses, damping and scheme.
fn motion(rest: &AtRest<'_>, work: &mut Workspace) -> Result<Motion, AnalysisError> {
    let plan = &rest.setup.plan;
    let damping = plan.damping.map_or(Damping::default(), |rayleigh| {
        Damping::of(rayleigh.ratio, rayleigh.frequencies.map(|f| 2.0 * std::f64::consts::PI * f))
    });
    Ok(Motion::new(&rest.model, work, -plan.numerical_damping, damping, plan.time_step).map_err(PassageError::from)?)
}
