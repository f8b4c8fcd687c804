//! Many places of a load on one model.

use super::ground::Ground;
use super::outcome::Status;
use super::settings::{Friction, Settings};
use super::sweeper::Sweeper;
use crate::blocks::{BlockModel, Loading, ModelError, PointForce};

/// The answer for one place of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadPosition {
    /// How it ended.
    pub status: Status,
    /// Load factor at collapse; `None` unless solved.
    pub factor: Option<f64>,
    /// Upper bound from the associated mechanism by the work equation.
    pub upper_bound: Option<f64>,
    /// Load factor with associated friction.
    pub associated_factor: Option<f64>,
    /// The flow rule that `factor` belongs to.
    pub friction: Friction,
}

/// The answers for all places, in the order of the loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// One answer for each load.
    pub places: Vec<LoadPosition>,
    /// Index of the lowest load factor.
    pub governing: Option<usize>,
}

/// The load factor of each of `loads` in place of the variable loads. Joints and equations are set up once.
///
/// # Errors
/// Nothing that is free to move, particles, or a block whose rounding leaves nothing of an edge.
pub fn sweep(
    model: &BlockModel,
    loading: &Loading,
    loads: &[Vec<PointForce>],
    settings: &Settings,
) -> Result<Sweep, ModelError> {
    let ground = Ground::new(model, loading, settings)?;
    let mut sweeper = ground.sweeper();
    let places: Vec<LoadPosition> = loads.iter().map(|load| sweeper.place(load, settings.friction)).collect();
    let mut governing = None;
    let mut lowest = f64::INFINITY;
    for (i, place) in places.iter().enumerate() {
        if let Some(factor) = place.factor
            && factor < lowest
        {
            (governing, lowest) = (Some(i), factor);
        }
    }
    Ok(Sweep { places, governing })
}

impl Sweeper<'_> {
    /// The load factor of a load by itself.
    pub fn place(&mut self, load: &[PointForce], friction: Friction) -> LoadPosition {
        let effect = self.effect(load);
        let found = self.least(&effect, friction);
        LoadPosition {
            status: found.status,
            factor: found.factor,
            upper_bound: found.dilatant.upper,
            associated_factor: found.dilatant.lower,
            friction: found.friction,
        }
    }
}
