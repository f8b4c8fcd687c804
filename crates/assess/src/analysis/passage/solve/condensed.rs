//! The passage by the condensed path.

use super::moment::moment;
use super::{AtRest, Named, Solution, Wanted, functional};
use crate::analysis::AnalysisError;
use crate::analysis::passage::{PassageError, Setup};
use mechanics::fem::State;
use mechanics::fem::condensed::{Condensed, CondensedError, Functional, LoadPattern, Reached, Snapshot, Visited};
use mechanics::ids::Id;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::passage::Part;
use outcome::passage::{Influence, PassageStatus, StepLog};

/// All patterns: the weight, then those of the sleepers.
pub fn loads(rest: &AtRest<'_>) -> Vec<LoadPattern> {
    let surface = &rest.setup.meshed.sets.surface;
    let down = |&(node, share): &(usize, f64)| (2 * surface[node].index() + 1, -share);
    let sleepers = rest.setup.loads.patterns.iter().map(|pattern| LoadPattern(pattern.iter().map(down).collect()));
    std::iter::once(LoadPattern::from_forces(rest.weight)).chain(sleepers).collect()
}

/// Self-weight and passage. The weight is the first pattern, brought on in the load steps of the file and then held.
pub fn pass(
    rest: &AtRest<'_>,
    solution: &mut Solution,
    wanted: Wanted,
    expected: &[usize],
    watch: &mut dyn Watch,
) -> Result<(), AnalysisError> {
    let setup = rest.setup;
    let observed: Vec<Functional> = setup.sensors.iter().filter_map(|sensor| functional(&sensor.reading)).collect();
    let loads = loads(rest);
    let failed = |error| AnalysisError::from(PassageError::Condensed(error));
    let condensed = Condensed::new(rest.model, State::new(rest.model), &loads, &observed).map_err(failed)?;
    let mut condensed = condensed.with_iterations(setup.plan.iterations as u32);
    condensed.retain_parts(expected);
    if stand(&mut condensed, setup, &mut solution.log, watch).map_err(failed)?.is_none() {
        end_of_weight(solution);
        return Ok(());
    }
    solution.self_weight = condensed.observed();
    if wanted == Wanted::Everything {
        let state = condensed.state().map_err(failed)?;
        solution.moments.push(moment(setup, rest.model, &state, "self-weight", None));
    }
    let at_rest = condensed.snapshot();
    let under = |k: usize| with_weight(setup.loads.reactions(setup.positions[k]));
    let passage = condensed.solve_positions(setup.positions.len(), &under, watch).map_err(failed)?;
    for (k, visited) in passage.visited.iter().enumerate() {
        for ((values, value), own) in solution.values.iter_mut().zip(&visited.observed).zip(&solution.self_weight) {
            values.push(value - own);
        }
        solution.log.push(StepLog {
            stage: Part::Passage,
            time: setup.times[k],
            position: setup.positions[k],
            iterations: visited.position.iterations as usize,
            unbalanced: visited.position.residual,
            cuts: 0,
            plastic_points: visited.counts.yielding,
            locking_elements: visited.counts.locking,
            open_joints: visited.counts.open_interfaces,
            sliding_pairs: visited.counts.sliding,
        });
    }
    let counts = condensed.counts();
    solution.condensed_degrees_of_freedom = Some(counts.retained_rows);
    solution.taking_part = condensed.retained_parts();
    if passage.cancelled {
        solution.status = PassageStatus::Cancelled;
        return Ok(());
    }
    if let Some(k) = passage.stopped_at {
        solution.status = PassageStatus::NotConverged;
        solution.reason = Some(format!(
            "with the first axle at {:.3} m no balance was found, however small the step: the bridge may be at its limit",
            setup.positions[k]
        ));
    }
    if wanted == Wanted::Records {
        return Ok(());
    }
    moments(&mut condensed, &at_rest, rest, solution, watch).map_err(failed)?;
    if solution.status != PassageStatus::Cancelled {
        influence(&mut condensed, &at_rest, setup, solution, watch).map_err(failed)?;
    }
    Ok(())
}

/// Amplitudes of all patterns: the whole weight and what stands on the sleepers.
pub fn with_weight(reactions: Vec<f64>) -> Vec<f64> {
    std::iter::once(1.0).chain(reactions).collect()
}

/// Brings the self-weight on, step by step; `None` where it finds no balance or the onlooker stops it.
pub fn stand(
    condensed: &mut Condensed<'_>,
    setup: &Setup,
    log: &mut Vec<StepLog>,
    watch: &mut dyn Watch,
) -> Result<Option<Vec<Visited>>, CondensedError> {
    let steps = setup.plan.load_steps.max(1);
    let share = |step: usize| (step + 1) as f64 / steps as f64;
    let patterns = condensed.pattern_count();
    let under = |step: usize| {
        let mut amplitudes = vec![0.0; patterns];
        amplitudes[0] = share(step);
        amplitudes
    };
    let stood = condensed.solve_positions(steps, &under, &mut Named { watch, stage: "self-weight" })?;
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

/// Goes through the positions once more and keeps the bridge at those that are to be shown.
fn moments(
    condensed: &mut Condensed<'_>,
    at_rest: &Snapshot,
    rest: &AtRest<'_>,
    solution: &mut Solution,
    watch: &mut dyn Watch,
) -> Result<(), CondensedError> {
    let setup = rest.setup;
    let wanted = places(setup, solution);
    condensed.restore(at_rest);
    let last = wanted.iter().map(|(k, _)| *k).max().unwrap_or(0);
    for k in 0..=last {
        if asked_to_stop(watch, "pictures", k, last) {
            solution.status = PassageStatus::Cancelled;
            return Ok(());
        }
        if wanted.is_empty()
            || condensed.solve_position(&with_weight(setup.loads.reactions(setup.positions[k])))?.reached
                != Reached::Balanced
        {
            break;
        }
        for (_, name) in wanted.iter().filter(|(at, _)| *at == k) {
            let state = condensed.state()?;
            let at = Some((setup.times[k], setup.positions[k]));
            solution.moments.push(moment(setup, rest.model, &state, name, at));
        }
    }
    Ok(())
}

/// Positions of which pictures are made, and why: those of the file, or the peaks of the channels.
pub fn places(setup: &Setup, solution: &Solution) -> Vec<(usize, String)> {
    let solved = solution.values.first().map_or(0, Vec::len);
    let mut wanted: Vec<(usize, String)> = Vec::new();
    if solved == 0 {
        return wanted;
    }
    if setup.plan.pictures.is_empty() {
        for (sensor, values) in setup.sensors.iter().zip(&solution.values) {
            let peak = (0..solved).fold(0, |best, k| if values[k].abs() > values[best].abs() { k } else { best });
            match wanted.iter_mut().find(|(k, _)| *k == peak) {
                Some((_, name)) => *name = format!("{name}, {}", sensor.name),
                None => wanted.push((peak, format!("peak of {}", sensor.name))),
            }
        }
    }
    for x in &setup.plan.pictures {
        let near = |k: &usize| (setup.positions[*k] - x).abs();
        let k = (0..solved).min_by(|a, b| near(a).total_cmp(&near(b))).unwrap_or(0);
        wanted.push((k, format!("first axle at {x:.2} m")));
    }
    wanted.sort_by_key(|(k, _)| *k);
    wanted
}

/// Distance between the places of an influence line [m].
const INFLUENCE_STEP: f64 = 0.25;

/// What the heaviest axle of the train does when it crosses alone; nothing where a position finds no balance.
fn influence(
    condensed: &mut Condensed<'_>,
    at_rest: &Snapshot,
    setup: &Setup,
    solution: &mut Solution,
    watch: &mut dyn Watch,
) -> Result<(), CondensedError> {
    let sleepers = &setup.loads.sleepers;
    let (Some((loads, force)), Some(first), Some(last)) =
        (setup.loads.heaviest_alone(), sleepers.first(), sleepers.last())
    else {
        return Ok(());
    };
    let count = ((last - first) / INFLUENCE_STEP) as usize;
    let own = &solution.self_weight;
    let mut influence = Influence { force, positions: Vec::new(), values: vec![Vec::new(); own.len()] };
    condensed.restore(at_rest);
    for k in 0..=count {
        if asked_to_stop(watch, "influence lines", k, count) {
            solution.status = PassageStatus::Cancelled;
            return Ok(());
        }
        let x = first + INFLUENCE_STEP * k as f64;
        if condensed.solve_position(&with_weight(loads.reactions(x)))?.reached != Reached::Balanced {
            return Ok(());
        }
        influence.positions.push(x);
        for ((values, value), own) in influence.values.iter_mut().zip(condensed.observed()).zip(own) {
            values.push(value - own);
        }
    }
    solution.influence = Some(influence);
    Ok(())
}

/// Tells the onlooker how far a repetition is, every few positions.
fn asked_to_stop(watch: &mut dyn Watch, what: &str, k: usize, last: usize) -> bool {
    const LOOK: usize = 10;
    let share = k as f64 / (last + 1) as f64;
    let progress = Progress { stage: what.to_owned(), fraction: Some(share), steps: k as u64 };
    k.is_multiple_of(LOOK) && watch.look(&progress) == Wish::Stop
}
