//! What has happened to a model: all that a run needs to go on.

use super::joint::{PairMemory, PairState};
use super::law::{Four, Memory};
use super::model::Model;

/// A point of integration of a solid.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// What its law remembers.
    pub memory: Memory,
    /// Stress [Pa]; in the frame of the element where displacements are large.
    pub stress: Four,
    /// Whether it flowed or cracked in the last step.
    pub yields: bool,
}

/// A point of integration of an interface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bond {
    /// What its law remembers.
    pub memory: PairMemory,
    /// Normal (positive in tension) and shear traction [Pa].
    pub traction: [f64; 2],
    /// Normal (positive when apart) and tangential opening [m].
    pub opening: [f64; 2],
    /// Closed, open or sliding.
    pub state: PairState,
}

/// Displacements and memories.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Displacement components [m]: x and y of each node in turn.
    pub displacements: Vec<f64>,
    /// Four points a quadrilateral.
    pub points: Vec<Point>,
    /// Amplitudes of the incompatible modes of each quadrilateral [m].
    pub modes: Vec<[f64; 4]>,
    /// Points of the interfaces, in the order of [`Model::springs`].
    pub bonds: Vec<Bond>,
    /// The nodal forces [N/m] that the state carries.
    pub forces: Vec<f64>,
    /// Velocity components [m/s]; zero unless time passes.
    pub velocities: Vec<f64>,
    /// Acceleration components [m/s^2]; zero unless time passes.
    pub accelerations: Vec<f64>,
}

impl State {
    /// Nothing has moved, nothing is loaded.
    pub fn new(model: &Model) -> State {
        let components = 2 * model.mesh.nodes.len();
        let quads = model.mesh.quads.len();
        State {
            displacements: vec![0.0; components],
            points: vec![Point::default(); 4 * quads],
            modes: vec![[0.0; 4]; quads],
            bonds: vec![Bond::default(); model.springs.len()],
            forces: vec![0.0; components],
            velocities: vec![0.0; components],
            accelerations: vec![0.0; components],
        }
    }

    /// Points of solids that flow or crack.
    pub fn yielding(&self) -> usize {
        self.points.iter().filter(|point| point.yields).count()
    }
}
