//! Loads at rest: the positions of a load test, set up and solved as a passage is.
//!
//! Every position is in static balance with the weight of the bridge, by the condensed path where that can be taken. By default each is reached from the
//! bridge under its own weight alone, so that none depends on another; `sequence = "in-order"` goes through them as the file has them, the loads taken off after
//! each, and keeps what has yielded or slid. Readings are changes from the bridge under its own weight, before the first position.

use super::loads::{Crossing, MovingLoads, Pattern, strip};
use super::setup::{carrying, even, sensors, spread, whole};
use super::{PassageError, Scope, Setup, Solution, WantedSlices, condenses, slices, solve};
use crate::analysis::AnalysisError;
use crate::analysis::geometry::point;
use crate::vehicles::{LoadModel, Spacing, Vehicle, Ways, library};
use bridge::Bridge;
use bridge::load_test::{LoadTest, Patch, PatchForce, Position, Sequence, Standing};
use bridge::passage::{PassageAnalysis, PassagePlan, Track, Way, Wheels};
use bridge::train::Axle;
use mechanics::watch::Watch;
use outcome::note::{AtRest as Said, InPassage, Note};
use outcome::passage::PassageStatus;
use outcome::picture::Point;
use structure::discretise::mesh::mesh;

/// A load test that is ready to be solved.
#[derive(Debug, Clone, PartialEq)]
pub struct AtRest {
    /// Mesh, loads and sensors; its positions are numbers of [`MovingLoads::at_rest`].
    pub setup: Setup,
    /// Names of the positions.
    pub names: Vec<String>,
    /// From which state each is reached.
    pub sequence: Sequence,
}

/// Mesh, loads and sensors of the load test that the file describes.
///
/// # Errors
/// No load test, vehicles that were not read, no mesh, a vehicle that the library lacks, a position beside the bridge, a sensor without a place.
pub fn setup(bridge: &Bridge) -> Result<AtRest, AnalysisError> {
    let test = bridge.load_test.as_ref().ok_or(PassageError::NoLoadTest)?;
    if let Some(file) =
        test.train.as_ref().filter(|train| train.vehicles.is_empty()).and_then(|train| train.file.clone())
    {
        return Err(PassageError::UnreadTrain(file).into());
    }
    let meshed = mesh(bridge).map_err(PassageError::from)?;
    let surface: Vec<Point> = meshed.sets.surface.iter().map(|node| point(meshed.mesh.nodes[*node])).collect();
    let on = Surface { bridge, test, nodes: &surface };
    let patterns: Vec<(String, Pattern)> = test
        .positions
        .iter()
        .map(|position| Ok((position.name.clone(), on.pattern(position)?)))
        .collect::<Result<_, PassageError>>()?;
    let pressure = test.way.as_ref().map_or(0.0, Way::dead_load) + meshed.ballast_pressure;
    let count = patterns.len();
    let positions: Vec<f64> = match test.sequence {
        Sequence::Independent => (1..=count).map(|k| k as f64).collect(),
        Sequence::InOrder => (1..=count).flat_map(in_order).collect(),
    };
    Ok(AtRest {
        names: test.positions.iter().map(|position| position.name.clone()).collect(),
        sequence: test.sequence,
        setup: Setup {
            train: test.train.as_ref().map_or_else(|| "loads at rest".to_owned(), |train| train.name.clone()),
            plan: PassagePlan { analysis: PassageAnalysis::Static, ..test.plan.clone() },
            loads: MovingLoads::at_rest(patterns),
            dead_load: even(&surface, pressure),
            sensors: sensors(&meshed, &test.sensors)?,
            times: vec![0.0; positions.len()],
            positions,
            effective_width: on.vehicle_width().unwrap_or_else(|| whole(bridge)),
            assumptions: on.assumptions(pressure),
            meshed,
        },
    })
}

/// Steps in which loads are taken off.
const UNLOADING: usize = 4;

/// A position, and the way back to the unloaded bridge.
fn in_order(position: usize) -> impl Iterator<Item = f64> {
    let below = (position - 1) as f64;
    let share = move |step: usize| match UNLOADING - step {
        0 => 0.0,
        left => below + left as f64 / UNLOADING as f64,
    };
    (0..=UNLOADING).map(share)
}

/// The surface that loads stand on.
struct Surface<'a> {
    bridge: &'a Bridge,
    test: &'a LoadTest,
    /// Its nodes from left to right [m].
    nodes: &'a [Point],
}

impl Surface<'_> {
    /// Nodal forces of all that stands in a position [N per metre of width].
    fn pattern(&self, position: &Position) -> Result<Pattern, PassageError> {
        let mut forces = vec![0.0; self.nodes.len()];
        let mut add = |more: &[f64]| forces.iter_mut().zip(more).for_each(|(force, more)| *force += more);
        for vehicle in &position.vehicles {
            let loads = self
                .vehicle(vehicle)
                .map_err(|why| PassageError::NoSuchVehicle { position: position.name.clone(), why })?;
            add(&loads.forces(vehicle.front_axle, self.nodes.len()));
        }
        for patch in &position.forces {
            for (node, share) in strip(self.nodes, patch.x - 0.5 * patch.length, patch.x + 0.5 * patch.length) {
                forces[node] += share * self.per_width(patch);
            }
        }
        let pattern: Pattern = forces.into_iter().enumerate().filter(|(_, force)| *force != 0.0).collect();
        if pattern.is_empty() {
            let end = |node: Option<&Point>| node.map_or(0.0, |node| node[0]);
            let (from, to) = (end(self.nodes.first()), end(self.nodes.last()));
            return Err(PassageError::BesideBridge { position: position.name.clone(), from, to });
        }
        Ok(pattern)
    }

    /// A force per metre of the width that carries it [N/m].
    fn per_width(&self, patch: &Patch) -> f64 {
        match patch.force {
            PatchForce::PerWidth(force) => force,
            PatchForce::Whole(force) => {
                force / patch.width.map_or_else(|| whole(self.bridge), |width| spread(self.bridge, width))
            }
        }
    }

    /// The loads of a vehicle that stands; why there are none.
    fn vehicle(&self, standing: &Standing) -> Result<MovingLoads, String> {
        let Some(name) = &standing.vehicle else {
            let (Some(train), Some(way)) = (&self.test.train, &self.test.way) else {
                return Err("the file describes no vehicle; describe it with [vehicle], or write the name of one of the library".into());
            };
            let width = way.effective_width().unwrap_or_else(|| carrying(self.bridge, way));
            return Ok(self.stood(&train.axles(self.bridge.gravity), way, (standing, width)));
        };
        let library = library(self.bridge.gravity).map_err(|refused| refused.to_string())?;
        let Some((model, vehicle)) = library.vehicle(name) else {
            return Err(format!("the library has no vehicle \"{name}\"; `extrados vehicles` lists them"));
        };
        let axles = axles(vehicle).ok_or_else(|| {
            format!("\"{name}\" is no vehicle of axles at fixed distances that could be weighed; describe the one that stood there with [vehicle]")
        })?;
        if on_rails(model) {
            let Some(Way::Rails(track)) = &self.test.way else {
                return Err(format!("\"{name}\" stands on rails, and the file has no [track]"));
            };
            let way = Way::Rails(track.clone());
            let width = way.effective_width().unwrap_or_else(|| carrying(self.bridge, &way));
            return Ok(self.stood(&axles, &way, (standing, width)));
        }
        let way = Way::Road(Wheels { contact_length: vehicle.contact_length_m, effective_width: None });
        Ok(self.stood(&axles, &way, (standing, spread(self.bridge, vehicle.wheel_track_m))))
    }

    /// Axles on a way, carried by a width [m].
    fn stood(&self, axles: &[Axle], way: &Way, (standing, width): (&Standing, f64)) -> MovingLoads {
        let crossing = Crossing { axles, heading: standing.direction, width };
        match way {
            Way::Rails(track) => {
                let middle = 0.5 * structure::discretise::bridge_length(self.bridge);
                MovingLoads::on_track(track, crossing, self.nodes, middle)
            }
            Way::Road(wheels) => MovingLoads::on_road(wheels, crossing, self.nodes),
        }
    }

    /// Width that carries the vehicle of the file, where one of it stands [m].
    fn vehicle_width(&self) -> Option<f64> {
        let of_file = self.standing().any(|one| one.vehicle.is_none());
        let way = self.test.way.as_ref().filter(|_| of_file)?;
        Some(way.effective_width().unwrap_or_else(|| carrying(self.bridge, way)))
    }

    fn standing(&self) -> impl Iterator<Item = &Standing> {
        self.test.positions.iter().flat_map(|position| &position.vehicles)
    }

    fn assumptions(&self, pressure: f64) -> Vec<Note> {
        let mut said: Vec<Note> = vec![match self.test.sequence {
            Sequence::Independent => Said::Independent.into(),
            Sequence::InOrder => Said::InOrder.into(),
        }];
        if let Some(width) = self.vehicle_width() {
            let of_file = self.test.way.as_ref().and_then(Way::effective_width).is_some();
            said.push(Said::Vehicle { width, of_file }.into());
        }
        if self.standing().any(|one| one.vehicle.is_some()) {
            said.push(Said::Library.into());
        }
        let patches = self.test.positions.iter().flat_map(|position| &position.forces);
        if patches.clone().any(|patch| matches!(patch.force, PatchForce::Whole(_))) {
            said.push(Said::Forces.into());
        }
        if let Some(Way::Rails(Track { .. })) = self.test.way {
            said.push(InPassage::TrackWeight { pressure }.into());
        }
        said
    }
}

/// Axles of a vehicle of the library; none where it has none, uniform loads, or distances that vary.
fn axles(vehicle: &Vehicle) -> Option<Vec<Axle>> {
    if vehicle.axle_loads_kn.is_empty() || !vehicle.uniform.is_empty() {
        return None;
    }
    let mut offset = 0.0;
    let mut axles = Vec::new();
    for (k, load) in vehicle.axle_loads_kn.iter().enumerate() {
        axles.push(Axle { force: 1e3 * load, offset });
        match vehicle.spacings_m.get(k) {
            Some(Spacing::Fixed(spacing)) => offset += spacing,
            Some(Spacing::Range { .. }) => return None,
            None => {}
        }
    }
    Some(axles)
}

fn on_rails(model: &LoadModel) -> bool {
    matches!(model.ways, Ways::Rail)
}

impl AtRest {
    /// Values of the sensors in every position, fewer than asked for where one found no balance, with the moduli of `bridge` on this mesh. `wanted` says what took
    /// part where nearly the same was asked, and which derivatives are wanted ([`AtRest::has_derivatives`]); its positions are not looked at.
    ///
    /// # Errors
    /// Those of [`solve`] and [`slices`].
    pub fn solve(
        &self,
        bridge: &Bridge,
        wanted: WantedSlices<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Solution, AnalysisError> {
        let setup = &self.setup;
        match self.sequence {
            Sequence::Independent if condenses(setup) => {
                slices(bridge, setup, WantedSlices { positions: &setup.positions, ..wanted }, watch)
            }
            Sequence::Independent => self.one_by_one(bridge, watch),
            Sequence::InOrder => {
                let mut found = solve(bridge, setup, Scope::Sensors, wanted.expected, watch)?;
                for values in &mut found.values {
                    *values = values.iter().step_by(UNLOADING + 1).copied().collect();
                }
                Ok(found)
            }
        }
    }

    /// Whether derivatives come with the values.
    pub fn has_derivatives(&self) -> bool {
        self.sequence == Sequence::Independent && condenses(&self.setup)
    }

    /// Each position by the whole system, from the bridge under its own weight.
    fn one_by_one(&self, bridge: &Bridge, watch: &mut dyn Watch) -> Result<Solution, AnalysisError> {
        let mut all = Solution {
            status: PassageStatus::Completed,
            values: vec![Vec::new(); self.setup.sensors.len()],
            ..Solution::default()
        };
        for &position in &self.setup.positions {
            let one = Setup { positions: vec![position], times: vec![0.0], ..self.setup.clone() };
            let found = solve(bridge, &one, Scope::Sensors, &[], watch)?;
            all.values.iter_mut().zip(found.values).for_each(|(all, one)| all.extend(one));
            let values = std::mem::take(&mut all.values);
            let mut log = std::mem::take(&mut all.log);
            log.extend(found.log);
            all = Solution { values, log, ..found };
            if all.status != PassageStatus::Completed {
                break;
            }
        }
        Ok(all)
    }
}
