//! From the bridge to what is solved: mesh, positions, loads as patterns, sensors as functionals.

use super::PassageError;
use super::loads::{Crossing, MovingLoads};
use super::sensors::{Placed, RingNodes, place};
use crate::analysis::AnalysisError;
use crate::analysis::geometry::point;
use bridge::Bridge;
use bridge::passage::{Heading, MOST_POSITIONS, Passage, PassagePlan, Sensor, Way, default_sensors};
use mechanics::fem::Mesh;
use outcome::note::{InPassage, Note};
use structure::discretise::mesh::{Meshed, SpanSets, mesh};

/// A passage that is ready to be solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    /// The bridge as a mesh.
    pub meshed: Meshed,
    /// Name of the train or vehicle.
    pub train: String,
    /// How it crosses.
    pub plan: PassagePlan,
    /// Its loads: `sum r_s q_s` on the surface, whose nodes the patterns count from 0 on the left.
    pub loads: MovingLoads,
    /// Weight of rails, sleepers and ballast on the surface, vertical nodal forces, downwards positive [N/m]: a part of the
    /// self-weight.
    pub dead_load: Vec<f64>,
    /// The sensors on the mesh.
    pub sensors: Vec<Placed>,
    /// Times [s].
    pub times: Vec<f64>,
    /// Position of the first axle at these times [m].
    pub positions: Vec<f64>,
    /// Width of the bridge that carries an axle [m].
    pub effective_width: f64,
    /// What was assumed.
    pub assumptions: Vec<Note>,
}

/// Mesh, loads, sensors and positions of the passage that the file describes.
///
/// # Errors
/// No train or one that was not read, no mesh, a sensor without a place, or positions that are none or too many.
pub fn setup(bridge: &Bridge) -> Result<Setup, AnalysisError> {
    let asked = bridge.passage.as_ref().ok_or(PassageError::NoTrain)?;
    if let (Some(file), true) = (&asked.train.file, asked.train.vehicles.is_empty()) {
        return Err(PassageError::UnreadTrain(file.clone()).into());
    }
    let meshed = mesh(bridge).map_err(PassageError::from)?;
    let surface: Vec<[f64; 2]> = meshed.sets.surface.iter().map(|node| point(meshed.mesh.nodes[*node])).collect();
    let effective_width = asked.way.effective_width().unwrap_or_else(|| carrying(bridge, &asked.way));
    let axles = asked.train.axles(bridge.gravity);
    let crossing = Crossing { axles: &axles, heading: asked.plan.direction, width: effective_width };
    let loads = match &asked.way {
        Way::Rails(track) => {
            MovingLoads::on_track(track, crossing, &surface, 0.5 * structure::discretise::bridge_length(bridge))
        }
        Way::Road(wheels) => MovingLoads::on_road(wheels, crossing, &surface),
    };
    let pressure = asked.way.dead_load() + meshed.ballast_pressure;
    let dead_load = even(&surface, pressure);
    let wanted = if asked.sensors.is_empty() { default_sensors(bridge.spans.len()) } else { asked.sensors.clone() };
    let sensors = sensors(&meshed, &wanted)?;
    let (times, positions) = positions(&asked.plan, &surface, loads.wheelbase())?;
    let assumptions = assumptions(bridge, asked, &loads, effective_width, pressure);
    let (train, plan) = (asked.train.name.clone(), asked.plan.clone());
    Ok(Setup { meshed, train, plan, loads, dead_load, sensors, times, positions, effective_width, assumptions })
}

/// Sensors on a mesh.
pub(super) fn sensors(meshed: &Meshed, wanted: &[Sensor]) -> Result<Vec<Placed>, PassageError> {
    let rings: Vec<RingNodes> = meshed.sets.spans.iter().map(|span| ring_nodes(&meshed.mesh, span)).collect();
    wanted.iter().map(|sensor| place(sensor, &meshed.mesh, &rings)).collect()
}

/// Distance of the wheels of an axle on a road [m].
const WHEELS_APART: f64 = 1.8;

/// Width that carries an axle where the file does not say it [m]: the widest part of the barrel that carries as a whole; on a road no more than two
/// wheels spread over, 1:2 to either side through the cover over the crown.
pub(super) fn carrying(bridge: &Bridge, way: &Way) -> f64 {
    match way {
        Way::Rails(_) => whole(bridge),
        Way::Road(_) => spread(bridge, WHEELS_APART),
    }
}

/// The widest part of the barrel that carries as a whole [m].
pub(super) fn whole(bridge: &Bridge) -> f64 {
    let cracks = bridge.carriageway.as_ref().map_or(&[][..], |asked| &asked.cracks);
    bridge::widest_strip(bridge.width, cracks)
}

/// What carries a load of this width [m]: spread 1:2 to either side through the cover over the crown, not wider than the barrel [m].
pub(super) fn spread(bridge: &Bridge, across: f64) -> f64 {
    whole(bridge).min(across + bridge.cover.depth)
}

/// Nodal forces of an even pressure [Pa] on a surface.
pub(super) fn even(surface: &[[f64; 2]], pressure: f64) -> Vec<f64> {
    let mut forces = vec![0.0; surface.len()];
    for (k, pair) in surface.windows(2).enumerate() {
        let half = 0.5 * pressure * (pair[1][0] - pair[0][0]);
        forces[k] += half;
        forces[k + 1] += half;
    }
    forces
}

/// The nodes of a ring as sensors look for them.
fn ring_nodes(mesh: &Mesh, span: &SpanSets) -> RingNodes {
    let joint = |id: &mechanics::ids::InterfaceId| {
        // Walking from intrados to extrados, side one lies on the right.
        let interface = &mesh.interfaces[*id];
        [interface.two.clone(), interface.one.clone()]
    };
    RingNodes {
        intrados: span.voussoirs.first().into_iter().flatten().map(|stone| stone.intrados().collect()).collect(),
        extrados: span.voussoirs.last().into_iter().flatten().map(|stone| stone.extrados().collect()).collect(),
        joints: span.joints.first().into_iter().flatten().map(joint).collect(),
    }
}

/// Times and places of the first axle, from where the mesh begins on the way to where the last axle has left it, unless the file says so.
fn positions(plan: &PassagePlan, surface: &[[f64; 2]], wheelbase: f64) -> Result<(Vec<f64>, Vec<f64>), PassageError> {
    let end = |point: Option<&[f64; 2]>| point.map_or(0.0, |point| point[0]);
    let sign = plan.direction.sign();
    let [first, last] = match plan.direction {
        Heading::Right => [surface.first(), surface.last()],
        Heading::Left => [surface.last(), surface.first()],
    };
    let from = plan.from.unwrap_or(end(first));
    let to = plan.to.unwrap_or(end(last) + sign * wheelbase);
    let way = sign * (to - from);
    if way <= 0.0 {
        return Err(PassageError::NoWay { from, to });
    }
    let steps = (way / (plan.speed * plan.time_step)).ceil();
    if steps >= MOST_POSITIONS as f64 {
        return Err(PassageError::TooManyPositions { count: steps as usize + 1, most: MOST_POSITIONS });
    }
    let times: Vec<f64> = (0..=steps as usize).map(|k| plan.time_step * k as f64).collect();
    let positions = times.iter().map(|time| from + sign * plan.speed * time).collect();
    Ok((times, positions))
}

fn assumptions(bridge: &Bridge, asked: &Passage, loads: &MovingLoads, width: f64, pressure: f64) -> Vec<Note> {
    let axles = asked.train.axles(bridge.gravity);
    let heaviest = axles.iter().map(|axle| axle.force).fold(0.0, f64::max) / width;
    let (of_file, pressed) = (asked.way.effective_width().is_some(), loads.pressed);
    let said = match &asked.way {
        Way::Rails(track) => {
            let spread = track.sleeper_length + 2.0 * track.ballast_depth / track.ballast_slope;
            let width = InPassage::Width { width, of_file, heaviest, spread };
            vec![width, InPassage::Sleeper { pressed }, InPassage::Rails, InPassage::TrackWeight { pressure }]
        }
        Way::Road(_) => vec![InPassage::WheelWidth { width, of_file, heaviest }, InPassage::Wheels { pressed }],
    };
    let sensors = asked.sensors.is_empty().then_some(InPassage::Sensors);
    said.into_iter().chain(sensors).map(Note::from).collect()
}
