//! A train's passage in the hands of its caller: position by position, with a look at the bridge in between.

use crate::project::Project;
use crate::refusal::Refusal;
use crate::respond::{RespondOptions, crossed};
use crate::watch::{Looking, Watch};
use assess::analysis::passage;
use assess::analysis::passage::sensors::{Placed, Reading};
use assess::analysis::passage::{Setup, report, setup};
use bridge::Bridge;
use mechanics::ids::NodeId;
use outcome::passage::{Moment, Passage, PassageStatus};
use outcome::picture::Point;
use std::borrow::Cow;

/// A passage that goes on when it is told to. Its numbers are those of [`respond`](crate::respond()), by either path.
pub struct Passing {
    bridge: Bridge,
    run: passage::Passing<'static>,
}

impl Passing {
    /// The bridge of a project under its own weight, before the train.
    ///
    /// # Errors
    /// A file that cannot be used or has no train, or a passage that cannot be set up (F108).
    pub fn new(project: &Project, options: &RespondOptions, watch: &mut dyn Watch) -> Result<Passing, Refusal> {
        let bridge = crossed(project, options)?;
        let setup = setup(&bridge)?;
        let run = passage::Passing::new(&bridge, Cow::Owned(setup), &mut Looking(watch))?;
        Ok(Passing { bridge, run })
    }

    /// Moves the train on by so many positions, or to the last one. Tells how the passage ended, once it has.
    ///
    /// # Errors
    /// A part of the bridge whose law has no answer (F108).
    pub fn advance(&mut self, positions: usize, watch: &mut dyn Watch) -> Result<Option<PassageStatus>, Refusal> {
        Ok(self.run.advance(positions, &mut Looking(watch))?)
    }

    /// Time since the train started [s] and place of its first axle [m] at the position that was reached last.
    pub fn place(&self) -> Option<(f64, f64)> {
        let last = self.run.done.checked_sub(1)?;
        Some((self.setup().times[last], self.setup().positions[last]))
    }

    /// Values of the sensors there, self-weight taken off [SI], in the order of [`setup`](Self::setup).
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.run.values()
    }

    /// Displacements, stresses and joints there; under self-weight alone before the first position.
    ///
    /// # Errors
    /// Those of [`advance`](Self::advance).
    pub fn moment(&mut self) -> Result<Moment, Refusal> {
        Ok(self.run.moment()?)
    }

    /// Mesh, positions and sensors.
    pub fn setup(&self) -> &Setup {
        self.run.setup()
    }

    /// How many positions are done.
    pub fn done(&self) -> usize {
        self.run.done
    }

    /// Where each sensor reads, as built [m]: the middle of the nodes or of the element that it reads; none where it reads nothing.
    pub fn sensor_places(&self) -> Vec<Option<Point>> {
        let setup = self.setup();
        let mesh = &setup.meshed.mesh;
        let middle = |points: Vec<Point>| {
            let count = points.len() as f64;
            let sum = points.iter().fold([0.0; 2], |sum, point| [sum[0] + point[0], sum[1] + point[1]]);
            (!points.is_empty()).then(|| sum.map(|value| value / count))
        };
        let node = |node: &NodeId| [mesh.nodes[*node].x, mesh.nodes[*node].y];
        let place = |sensor: &Placed| match &sensor.reading {
            Reading::Displacements(parts) => middle(parts.iter().map(|(of, _)| node(of)).collect()),
            Reading::Stress { quad, .. } => middle(mesh.quads[*quad].nodes.iter().map(node).collect()),
        };
        setup.sensors.iter().map(place).collect()
    }

    /// Makes the pictures and influence lines of the passage so far; one that is left before its end was cancelled.
    ///
    /// # Errors
    /// Those of [`advance`](Self::advance).
    pub fn finish(self, watch: &mut dyn Watch) -> Result<Passage, Refusal> {
        let setup = self.setup().clone();
        let solution = self.run.finish(&mut Looking(watch))?;
        Ok(report(&self.bridge, &setup, solution))
    }
}
