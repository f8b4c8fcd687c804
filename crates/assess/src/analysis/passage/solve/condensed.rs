//! The passage by the condensed path.

use super::{AtRest, Scope, Solution, functional, of_self_weight, pictures};
use crate::analysis::AnalysisError;
use crate::analysis::parallel::Retold;
use crate::analysis::passage::{PassageError, Setup};
use mechanics::fem::State;
use mechanics::fem::condensed::{
    Condensed, CondensedError, Functional, LoadPattern, Reached, Run, Snapshot, Visited, load_pattern,
};
use mechanics::ids::Id;
use mechanics::watch::{Progress, Watch};
use outcome::passage::{Influence, Part, PassageStatus, StepLog};
use std::sync::Arc;

/// All patterns: the weight, then those of sleepers or wheels.
pub(super) fn loads(setup: &Setup, weight: &[f64]) -> Vec<LoadPattern> {
    let surface = &setup.meshed.sets.surface;
    let down = |&(node, share): &(usize, f64)| (2 * surface[node].index() + 1, -share);
    let moving = setup.loads.patterns.iter().map(|pattern| pattern.iter().map(down).collect());
    std::iter::once(load_pattern(weight)).chain(moving).collect()
}

/// What the path keeps from one position to the next. The weight is the first pattern, brought on in the load steps of the file and
/// then held.
pub(super) struct Way {
    condensed: Condensed,
    at_rest: Snapshot,
    /// The positions; it may have come further than the passage, for they are solved in batches.
    run: Run,
}

fn failed(error: CondensedError) -> AnalysisError {
    PassageError::Condensed(error).into()
}

impl Way {
    /// Brings the self-weight on.
    pub(super) fn new(
        rest: &AtRest<'_>,
        solution: &mut Solution,
        expected: &[usize],
        watch: &mut dyn Watch,
    ) -> Result<Way, AnalysisError> {
        let setup = &*rest.setup;
        let observed: Vec<Functional> = setup.sensors.iter().filter_map(|sensor| functional(&sensor.reading)).collect();
        let loads = loads(setup, &rest.weight);
        let model = Arc::clone(&rest.model);
        let mut condensed = Condensed::new(model, State::new(&rest.model), &loads, &observed).map_err(failed)?;
        condensed.iterations = setup.plan.iterations as u32;
        if !condensed.retain_parts(expected, watch) {
            solution.status = PassageStatus::Cancelled;
        } else if stand(&mut condensed, setup, &mut solution.log, watch).map_err(failed)?.is_none() {
            end_of_weight(solution);
        } else {
            solution.self_weight = condensed.observed();
        }
        let (at_rest, run) = (condensed.snapshot(), condensed.begin(setup.positions.len()));
        Ok(Way { condensed, at_rest, run })
    }

    /// The position `k` of the last batch, or the bridge under its own weight.
    pub(super) fn state(&mut self, k: Option<usize>) -> Result<State, AnalysisError> {
        match k {
            Some(k) => self.condensed.state_at(&self.run, k),
            None => self.condensed.state(),
        }
        .map_err(failed)
    }

    /// Solves position `k`, the next one, with those of its batch where it is the first of one.
    pub(super) fn visit(
        &mut self,
        rest: &AtRest<'_>,
        k: usize,
        solution: &mut Solution,
        watch: &mut dyn Watch,
    ) -> Result<(), AnalysisError> {
        let Way { condensed, run, .. } = self;
        let setup = &*rest.setup;
        let under = |k: usize| with_weight(setup.loads.amplitudes(setup.positions[k]));
        while run.goes_on() && run.passage.visited.len() <= k {
            condensed.solve_batch(run, &under, watch).map_err(failed)?;
        }
        let Some(visited) = run.passage.visited.get(k) else {
            solution.status = PassageStatus::Cancelled;
            if !run.passage.cancelled {
                solution.status = PassageStatus::NotConverged;
                let place = setup.loads.place_words(setup.positions[k]);
                solution.reason = Some(format!(
                    "{place} no balance was found, however small the step: the bridge may be at its limit"
                ));
            }
            return Ok(());
        };
        for ((values, value), own) in solution.values.iter_mut().zip(&visited.observed).zip(&solution.self_weight) {
            values.push(value - own);
        }
        solution.log.push(StepLog {
            stage: Part::Passage,
            time: setup.times[k],
            position: setup.positions[k],
            ..of_visited(visited)
        });
        Ok(())
    }

    /// Makes the pictures and the influence lines.
    pub(super) fn finish(
        mut self,
        rest: &AtRest<'_>,
        solution: &mut Solution,
        wanted: Scope,
        watch: &mut dyn Watch,
    ) -> Result<(), AnalysisError> {
        if solution.self_weight.is_empty() {
            return Ok(());
        }
        solution.condensed_degrees_of_freedom = Some(self.condensed.counts().retained_rows);
        solution.taking_part = self.condensed.retained_parts();
        if wanted == Scope::Sensors || solution.status == PassageStatus::Cancelled {
            return Ok(());
        }
        self.moments(rest, solution, watch).map_err(failed)?;
        if solution.status != PassageStatus::Cancelled {
            self.influence(&rest.setup, solution, watch).map_err(failed)?;
        }
        Ok(())
    }

    /// Goes through the positions once more and keeps the bridge at those that are to be shown.
    fn moments(
        &mut self,
        rest: &AtRest<'_>,
        solution: &mut Solution,
        watch: &mut dyn Watch,
    ) -> Result<(), CondensedError> {
        let (setup, condensed) = (&*rest.setup, &mut self.condensed);
        let wanted = pictures(setup, solution);
        let Some(&(last, _)) = wanted.last() else { return Ok(()) };
        condensed.restore(&self.at_rest);
        for k in 0..=last {
            let mut watch = again(watch, "pictures", k, last);
            if !balanced(condensed, setup.loads.amplitudes(setup.positions[k]), solution, &mut watch)? {
                break;
            }
            for (_, name) in wanted.iter().filter(|(at, _)| *at == k) {
                let state = condensed.state()?;
                solution.moments.push(rest.moment(&state, name, Some(k)));
            }
        }
        Ok(())
    }

    /// What the heaviest axle of the train does when it crosses alone; nothing where a position finds no balance.
    fn influence(
        &mut self,
        setup: &Setup,
        solution: &mut Solution,
        watch: &mut dyn Watch,
    ) -> Result<(), CondensedError> {
        let condensed = &mut self.condensed;
        let [first, last] = setup.loads.reach;
        let Some((loads, force)) = setup.loads.heaviest_alone() else { return Ok(()) };
        let count = ((last - first) / INFLUENCE_STEP) as usize;
        let own = solution.self_weight.clone();
        let mut influence = Influence { force, positions: Vec::new(), values: vec![Vec::new(); own.len()] };
        condensed.restore(&self.at_rest);
        for k in 0..=count {
            let x = first + INFLUENCE_STEP * k as f64;
            let mut watch = again(watch, "influence lines", k, count);
            if !balanced(condensed, loads.amplitudes(x), solution, &mut watch)? {
                solution.no_influence_at = Some(x);
                return Ok(());
            }
            influence.positions.push(x);
            for ((values, value), own) in influence.values.iter_mut().zip(condensed.observed()).zip(&own) {
                values.push(value - own);
            }
        }
        solution.influence = Some(influence);
        Ok(())
    }
}

/// Balances the weight and what stands on the bridge; whether a balance was found.
fn balanced(
    condensed: &mut Condensed,
    amplitudes: Vec<f64>,
    solution: &mut Solution,
    watch: &mut dyn Watch,
) -> Result<bool, CondensedError> {
    let reached = condensed.solve_position(&with_weight(amplitudes), watch)?.reached;
    if reached == Reached::Cancelled {
        solution.status = PassageStatus::Cancelled;
    }
    Ok(reached == Reached::Balanced)
}

/// Distance between the places of an influence line [m].
const INFLUENCE_STEP: f64 = 0.25;

/// Amplitudes of all patterns: the whole weight and what stands on the bridge.
pub(super) fn with_weight(amplitudes: Vec<f64>) -> Vec<f64> {
    std::iter::once(1.0).chain(amplitudes).collect()
}

/// Brings the self-weight on, step by step; `None` where it finds no balance or the onlooker stops it.
pub(super) fn stand(
    condensed: &mut Condensed,
    setup: &Setup,
    log: &mut Vec<StepLog>,
    watch: &mut dyn Watch,
) -> Result<Option<Vec<Visited>>, CondensedError> {
    let steps = setup.plan.load_steps.max(1);
    let share = |step: usize| (step + 1) as f64 / steps as f64;
    let patterns = 1 + setup.loads.patterns.len();
    let under = |step: usize| {
        let mut amplitudes = vec![0.0; patterns];
        amplitudes[0] = share(step);
        amplitudes
    };
    let stood = condensed.solve_positions(steps, &under, &mut of_self_weight(watch))?;
    for (step, visited) in stood.visited.iter().enumerate() {
        log.push(StepLog {
            stage: Part::SelfWeight,
            time: share(step),
            iterations: visited.position.iterations as usize,
            unbalanced: visited.position.residual,
            plastic_points: visited.counts.yielding,
            locking_elements: visited.counts.locking,
            open_joints: visited.counts.open_interfaces,
            sliding_pairs: visited.counts.sliding,
            ..StepLog::default()
        });
        log.push(StepLog { stage: Part::SelfWeight, time: share(step), ..of_visited(visited) });
    }
    if let Some(step) = stood.stopped_at {
        log.push(StepLog { stage: Part::SelfWeight, time: share(step), cuts: 1, ..StepLog::default() });
    }
    Ok((!stood.cancelled && stood.stopped_at.is_none()).then_some(stood.visited))
}

fn end_of_weight(solution: &mut Solution) {
    match solution.log.last().filter(|step| step.cuts > 0) {
        None => solution.status = PassageStatus::Cancelled,
        Some(step) => {
            solution.status = PassageStatus::NotConverged;
            solution.reason = Some(format!(
                "under self-weight, with {:.0} % of it on: no balance was found, however small the step",
                100.0 * step.time
            ));
        }
    }
}

pub(super) fn of_visited(visited: &Visited) -> StepLog {
    StepLog {
        iterations: visited.position.iterations as usize,
        unbalanced: visited.position.residual,
        plastic_points: visited.counts.yielding,
        locking_elements: visited.counts.locking,
        open_joints: visited.counts.open_interfaces,
        sliding_pairs: visited.counts.sliding,
        ..StepLog::default()
    }
}

/// An onlooker who is told how far a repetition is.
fn again(watch: &mut dyn Watch, what: &str, k: usize, last: usize) -> impl Watch {
    let told = move |_: &Progress| {
        let fraction = Some(k as f64 / (last + 1) as f64);
        Progress { stage: what.to_owned(), fraction, steps: k as u64 }
    };
    Retold { watch, kept: None, told }
}
