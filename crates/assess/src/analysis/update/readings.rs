//! Readings of a load test as channels: each is compared for itself, over its uncertainty.

use super::Task;
use super::forward::Model;
use super::measured::said;
use crate::analysis::AnalysisError;
use crate::analysis::passage::{AtRest, at_rest};
use bridge::Bridge;
use calibrate::{Channel, Problem};
use outcome::update::ReadAtRest;
use std::sync::OnceLock;

/// A load test with readings.
#[derive(Debug)]
pub struct Standing {
    /// The positions, set up at the start model.
    pub test: AtRest,
    /// Sensors that were read, and in which positions; none is empty.
    pub read: Vec<(usize, Vec<usize>)>,
    /// Parts of the model that take part in the answers of the start model, found when they are first asked for.
    pub(super) expected: OnceLock<Vec<usize>>,
}

impl Standing {
    /// The load test of a bridge; none where nothing was read in one.
    ///
    /// # Errors
    /// A load test that cannot be set up.
    pub(super) fn of(bridge: &Bridge) -> Result<Option<Standing>, AnalysisError> {
        let Some(test) = bridge.load_test.as_ref().filter(|test| test.readings.any()) else { return Ok(None) };
        let places = |sensor: usize| -> Vec<usize> { test.readings.of(sensor).map(|(position, _)| position).collect() };
        let read = (0..test.sensors.len()).map(|sensor| (sensor, places(sensor)));
        let read = read.filter(|(_, positions)| !positions.is_empty()).collect();
        Ok(Some(Standing { test: at_rest::setup(bridge)?, read, expected: OnceLock::new() }))
    }

    /// A channel for each sensor that was read.
    pub(super) fn channels(&self, task: &Task<'_>) -> Vec<Channel> {
        let readings = task.bridge.load_test.as_ref().map(|test| &test.readings);
        let one = |&(sensor, _): &(usize, Vec<usize>)| {
            let (placed, readings) = (&self.test.setup.sensors[sensor], readings?);
            let (scale, unit) = (placed.quantity.scale(), placed.quantity.unit());
            let said = said(task.asked, &placed.name);
            let sign = if said.is_some_and(|said| said.reversed) { -1.0 } else { 1.0 };
            let values = readings.of(sensor).map(|(_, value)| sign * scale * value).collect();
            let stated = readings.uncertainty.get(sensor).copied().flatten().map(|deviation| scale * deviation);
            Some(Channel {
                uncertainty: stated.or_else(|| said.and_then(|said| said.uncertainty)),
                weight: said.and_then(|said| said.weight),
                left_out: said.and_then(|said| said.left_out.clone()),
                ..Channel::readings(&format!("{} (load test)", placed.name), unit, values)
            })
        };
        self.read.iter().filter_map(one).collect()
    }
}

/// What was read and what the model gives there, by sensor; answers are those of all channels.
pub(super) fn compared(
    model: &Model<'_>,
    problem: &Problem,
    start: &[Vec<f64>],
    updated: Option<&[Vec<f64>]>,
) -> Vec<ReadAtRest> {
    let Some(standing) = &model.standing else { return Vec::new() };
    let first = problem.channels().len() - standing.read.len();
    let one = |(k, (sensor, positions)): (usize, &(usize, Vec<usize>))| {
        let placed = &standing.test.setup.sensors[*sensor];
        let row = |table: &[Vec<f64>]| table.get(first + k).cloned().unwrap_or_default();
        ReadAtRest {
            sensor: placed.name.clone(),
            quantity: placed.quantity,
            positions: positions.iter().map(|position| standing.test.names[*position].clone()).collect(),
            measured: problem.channels()[first + k].history.clone().unwrap_or_default(),
            start: row(start),
            updated: updated.map_or_else(Vec::new, row),
        }
    };
    standing.read.iter().enumerate().map(one).collect()
}
