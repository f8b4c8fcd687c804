//! Slices of a passage: the train at rest at a few positions, each reached from the bridge under its own weight alone.
//!
//! What model updating asks for again and again (the railway paper, section 3.4): the mesh stays, the moduli change. All of it goes by the condensed
//! path, the self-weight too, so that an evaluation costs one factorisation and the rows that are not linear.

use super::condensed::stand;
use super::{AtRest, functional, self_weight, with_train};
use crate::analysis::AnalysisError;
use crate::analysis::passage::model::model;
use crate::analysis::passage::{PassageError, PassageStatus, Setup};
use bridge::Bridge;
use mechanics::fem::condensed::{Condensed, Functional, Reached};
use mechanics::fem::{Kinematics, State};
use mechanics::watch::{Progress, Watch, Wish};

/// Values of the sensors at a few positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Slices {
    /// How it ended.
    pub status: PassageStatus,
    /// Why, where it did not complete.
    pub reason: Option<String>,
    /// Value of each sensor under self-weight alone [SI].
    pub self_weight: Vec<f64>,
    /// Value of each sensor at each position, self-weight taken off [SI]; fewer positions than asked for where one found no
    /// balance.
    pub values: Vec<Vec<f64>>,
    /// Iterations in all.
    pub iterations: u32,
    /// Parts of the model that did not answer linearly: what to expect of the same bridge with other moduli.
    pub taking_part: Vec<usize>,
}

/// Values of the sensors while the first axle stands at each of `positions` [m], with the moduli of `bridge` on the mesh of
/// `setup`, which may have been made for others. Small displacements; stresses cannot be asked for. `expected` are the parts that took part where
/// nearly the same was asked, or none.
pub fn slices(
    bridge: &Bridge,
    setup: &Setup,
    positions: &[f64],
    expected: &[usize],
    watch: &mut dyn Watch,
) -> Result<Slices, AnalysisError> {
    let observed: Option<Vec<Functional>> = setup.sensors.iter().map(|sensor| functional(&sensor.reading)).collect();
    let observed = observed.ok_or(PassageError::StressInSlices)?;
    let model = model(bridge, &setup.meshed, Kinematics::Small)?;
    let weight = self_weight(bridge, setup, &model);
    let rest = AtRest { setup, model: &model, weight: &weight };
    let train = positions.iter().map(|&position| with_train(&rest, position));
    let loads: Vec<Vec<f64>> = std::iter::once(weight.clone()).chain(train).collect();
    let failed = |error| AnalysisError::from(PassageError::Condensed(error));
    let condensed = Condensed::new(&model, State::new(&model), &loads, &observed).map_err(failed)?;
    let mut condensed = condensed.with_iterations(setup.plan.iterations as u32);
    let mut found = Slices {
        status: PassageStatus::Completed,
        reason: None,
        self_weight: Vec::new(),
        values: vec![Vec::new(); observed.len()],
        iterations: 0,
        taking_part: Vec::new(),
    };
    condensed.expect(expected);
    let one = |pattern: usize| {
        let mut amplitudes = vec![0.0; loads.len()];
        amplitudes[pattern] = 1.0;
        amplitudes
    };
    let mut log = Vec::new();
    if !stand(&mut condensed, setup, &mut log, watch).map_err(failed)? {
        found.status = PassageStatus::Cancelled;
        let stuck = log.last().is_some_and(|step| step.cuts > 0);
        return Ok(if stuck { unbalanced(found, "under self-weight no balance was found".to_owned()) } else { found });
    }
    found.iterations = log.iter().map(|step| step.iterations as u32).sum();
    found.self_weight = condensed.observed();
    let at_rest = condensed.mark();
    let progress = Progress { stage: "slices".into(), fraction: None, steps: 0 };
    if watch.look(&progress) == Wish::Stop {
        found.status = PassageStatus::Cancelled;
        return Ok(found);
    }
    let under: Vec<Vec<f64>> = (1..loads.len()).map(one).collect();
    let visited = condensed.branch(&at_rest, &under).map_err(failed)?;
    found.taking_part = condensed.taking_part();
    for (visited, place) in visited.iter().zip(positions) {
        found.iterations += visited.position.iterations;
        if visited.position.reached != Reached::Balanced {
            return Ok(unbalanced(found, format!("with the first axle at {place:.3} m no balance was found")));
        }
        for ((values, now), own) in found.values.iter_mut().zip(&visited.observed).zip(&found.self_weight) {
            values.push(now - own);
        }
    }
    Ok(found)
}

fn unbalanced(found: Slices, reason: String) -> Slices {
    Slices { status: PassageStatus::NotConverged, reason: Some(reason), ..found }
}
