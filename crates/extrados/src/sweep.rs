//! Loads or vehicles at every position on the bridge.

use crate::choice::Choice;
use crate::collapse::planned;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Looking, Watch};
use assess::analysis::engine::can;
use assess::analysis::{self, Places};
use bridge::{LEAST_STEP, Method};
use outcome::note::{self, Note};
use outcome::sweep::Sweep;
use outcome::vehicles::VehicleSweep;
use structure::discretise::bridge_length;

/// How a sweep is made.
#[derive(Debug, Clone, Default)]
pub struct SweepOptions {
    /// What takes the place of the file's plan.
    pub choice: Choice,
    /// Distance between positions [m]; none for the file's, or a hundredth of the bridge.
    pub step: Option<f64>,
}

/// What was moved over the bridge.
#[derive(Debug, Clone)]
pub enum Swept {
    /// The loads of the file.
    Loads(Sweep),
    /// The vehicles of its `[sweep]`.
    Vehicles(Box<VehicleSweep>),
}

/// Moves the vehicles of the file's `[sweep]` over the bridge, or its loads where it has none. An interrupted sweep keeps what is
/// done and says so.
///
/// # Errors
/// A file that cannot be used, or a sweep that cannot be set up for its bridge (F108).
pub fn sweep(project: &Project, options: &SweepOptions, watch: &mut dyn Watch) -> Result<Swept, Refusal> {
    if options.step.is_some_and(|step| !(step >= LEAST_STEP)) {
        let least = format!("write {LEAST_STEP} m or more, or leave the distance between places away");
        return Err(Refusal::new("F107", "places are too close to one another", least));
    }
    let mut bridge = planned(project, &options.choice)?;
    let watch = &mut Looking(watch);
    let other = Some(bridge.plan.method)
        .filter(|method| !sweeps(*method))
        .map(|method| Note::from(note::Moving::InsteadOf { method }));
    let found = match &mut bridge.sweep {
        Some(plan) => {
            plan.step = options.step.or(plan.step);
            analysis::vehicle_sweep_with_restrictions(&bridge, watch).map(|mut found| {
                found.assumptions.extend(other);
                Swept::Vehicles(Box::new(found))
            })
        }
        None => {
            let step = options.step.unwrap_or_else(|| bridge_length(&bridge) / 100.0);
            analysis::sweep(&bridge, Places::Every(step), true, watch).map(|mut found| {
                found.assumptions.extend(other);
                Swept::Loads(found)
            })
        }
    };
    Ok(found?)
}

/// Whether a method moves loads over a bridge: limit analysis does, and the equilibrium path beside it.
#[must_use]
pub fn sweeps(method: Method) -> bool {
    can::knows(method, can::Feature::LoadSweep) == can::Knows::Yes
}
