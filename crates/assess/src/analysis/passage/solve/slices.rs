//! Slices of a passage: the train at rest at a few positions, each reached from the bridge under its own weight alone.
//!
//! What model updating asks for again and again (the railway paper, section 3.4): the mesh stays, the moduli change. All of it goes by the condensed
//! path, the self-weight too, so that an evaluation costs one factorisation and the rows that are not linear.

use super::condensed::{loads, of_visited, stand, with_weight};
use super::{Solution, functional, self_weight};
use crate::analysis::AnalysisError;
use crate::analysis::passage::model::{assumptions, model};
use crate::analysis::passage::{PassageError, Setup};
use bridge::Bridge;
use mechanics::fem::condensed::{Condensed, Functional, PerturbedModel, Reached, Visited};
use mechanics::fem::{Kinematics, State};
use mechanics::watch::Watch;
use outcome::passage::PassageStatus;
use std::sync::Arc;

/// What is asked of slices.
#[derive(Debug, Clone, Copy, Default)]
pub struct WantedSlices<'w> {
    /// Places of the first axle [m].
    pub positions: &'w [f64],
    /// Parts that took part where nearly the same was asked, or none.
    pub expected: &'w [usize],
    /// The same bridge with one quantity a little different, and by how much: derivatives by each quantity are given.
    pub neighbours: &'w [(Bridge, f64)],
}

/// Values of the sensors while the first axle stands at some positions, fewer than asked for where one found no balance, with the moduli of `bridge` on the mesh of
/// `setup`, which may have been made for others. Small displacements; stresses cannot be asked for.
///
/// # Errors
/// A sensor of stress, and those of [`solve`](super::solve).
pub fn slices(
    bridge: &Bridge,
    setup: &Setup,
    wanted: WantedSlices<'_>,
    watch: &mut dyn Watch,
) -> Result<Solution, AnalysisError> {
    let observed: Option<Vec<Functional>> = setup.sensors.iter().map(|sensor| functional(&sensor.reading)).collect();
    let observed = observed.ok_or(PassageError::StressInSlices)?;
    let model = model(bridge, &setup.meshed, Kinematics::Small)?;
    let weight = self_weight(bridge, setup, &model);
    let loads = loads(setup, &weight);
    let mut found = Solution {
        status: PassageStatus::Completed,
        values: vec![Vec::new(); observed.len()],
        degrees_of_freedom: model.equations(),
        assumptions: assumptions(bridge, &setup.meshed),
        ..Solution::default()
    };
    let model = Arc::new(model);
    let failed = |error| AnalysisError::from(PassageError::Condensed(error));
    let mut condensed = Condensed::new(Arc::clone(&model), State::new(&model), &loads, &observed).map_err(failed)?;
    condensed.iterations = setup.plan.iterations as u32;
    condensed.keeps_equilibria = !wanted.neighbours.is_empty();
    if !condensed.retain_parts(wanted.expected, watch) {
        return Ok(cancelled(found));
    }
    let stood = stand(&mut condensed, setup, &mut found.log, watch).map_err(failed)?;
    let Some(path) = stood else {
        let stuck = found.log.last().is_some_and(|step| step.cuts > 0);
        let reason = "under self-weight no balance was found".to_owned();
        return Ok(if stuck { unbalanced(found, reason) } else { cancelled(found) });
    };
    found.self_weight = condensed.observed();
    let at_rest = condensed.snapshot();
    let under = wanted.positions.iter().map(|&position| with_weight(setup.loads.amplitudes(position)));
    let visited = condensed.solve_branches(&at_rest, &under.collect::<Vec<_>>(), watch).map_err(failed)?;
    let Some(visited) = visited else { return Ok(cancelled(found)) };
    found.taking_part = condensed.retained_parts();
    found.condensed_degrees_of_freedom = Some(condensed.counts().retained_rows);
    for (visited, place) in visited.iter().zip(wanted.positions) {
        found.log.push(of_visited(visited));
        if visited.position.reached != Reached::Balanced {
            return Ok(unbalanced(found, format!("{} no balance was found", setup.loads.place_words(*place))));
        }
        for ((values, now), own) in found.values.iter_mut().zip(&visited.observed).zip(&found.self_weight) {
            values.push(now - own);
        }
    }
    if !wanted.neighbours.is_empty() {
        match derivatives(&mut condensed, setup, wanted.neighbours, [&path, &visited], watch)? {
            Some(derivatives) => found.derivatives = derivatives,
            None => return Ok(cancelled(found)),
        }
    }
    Ok(found)
}

/// Derivatives of every sensor at every position, self-weight taken off: by neighbour, sensor and position. `None` where the onlooker
/// stops it.
fn derivatives(
    condensed: &mut Condensed,
    setup: &Setup,
    neighbours: &[(Bridge, f64)],
    [path, branches]: [&[Visited]; 2],
    watch: &mut dyn Watch,
) -> Result<Option<Vec<Vec<Vec<f64>>>>, AnalysisError> {
    let mut models = Vec::with_capacity(neighbours.len());
    for (bridge, by) in neighbours {
        let model = model(bridge, &setup.meshed, Kinematics::Small)?;
        let weight = self_weight(bridge, setup, &model);
        let loads = loads(setup, &weight);
        models.push((model, loads, *by));
    }
    let neighbours: Vec<PerturbedModel<'_>> =
        models.iter().map(|(model, patterns, by)| PerturbedModel { model, patterns, by: *by }).collect();
    let found = condensed.derivatives(&neighbours, path, branches, watch).map_err(PassageError::Condensed)?;
    let Some(found) = found else { return Ok(None) };
    let by_neighbour = |(k, at_rest): (usize, &Vec<f64>)| {
        let of = |(sensor, own): (usize, &f64)| found.branches.iter().map(|branch| branch[k][sensor] - own).collect();
        at_rest.iter().enumerate().map(of).collect()
    };
    Ok(Some(found.at_end.iter().enumerate().map(by_neighbour).collect()))
}

/// A stop leaves nothing that could pass for an answer.
fn cancelled(found: Solution) -> Solution {
    Solution { status: PassageStatus::Cancelled, values: Vec::new(), ..found }
}

fn unbalanced(found: Solution, reason: String) -> Solution {
    Solution { status: PassageStatus::NotConverged, reason: Some(reason), ..found }
}
