//! What came of a train's passage, in SI units; tables, figures and the wire format are made from this alone.

use crate::mesh::MeshPicture;
use crate::note::Note;
use crate::picture::{Point, ThrustPoint};
use crate::published::{Object, list, object};
use crate::warning::Warning;
use crate::wire::published;
use crate::words::words;
use bridge::passage::{PassageAnalysis, PassageKinematics, PassagePath};
use serde::{Deserialize, Serialize};

words! {
    /// How a passage ended.
    #[derive(Default)]
    pub enum PassageStatus {
        /// The train has crossed.
        Completed = "completed",
        /// A step found no equilibrium; what came before it stands.
        #[default]
        NotConverged = "not-converged",
        /// Somebody asked to stop.
        Cancelled = "cancelled",
    }

    /// What a channel records.
    pub enum Measurand {
        /// Displacement [m], in mm.
        Displacement = "displacement",
        /// Strain [-], in microstrain.
        Strain = "strain",
        /// Opening of a joint [m], in mm.
        JointOpening = "joint-opening",
        /// Sliding of a joint [m], in mm.
        JointSliding = "joint-sliding",
        /// Stress [Pa], in MPa.
        Stress = "stress",
    }
}

impl Measurand {
    /// The unit in tables and figures with how many of it an SI unit is, and what records call it.
    fn row(self) -> (&'static str, f64, records::Dimension) {
        match self {
            Measurand::Displacement => ("mm", 1e3, records::Dimension::Length),
            Measurand::Strain => ("microstrain", 1e6, records::Dimension::Strain),
            Measurand::JointOpening => ("mm", 1e3, records::Dimension::Length),
            Measurand::JointSliding => ("mm", 1e3, records::Dimension::Length),
            Measurand::Stress => ("MPa", 1e-6, records::Dimension::Stress),
        }
    }

    /// The unit in tables and figures.
    pub fn unit(self) -> &'static str {
        self.row().0
    }

    /// How many of that unit an SI unit is.
    pub fn scale(self) -> f64 {
        self.row().1
    }

    /// What records of it hold.
    pub fn recorded(self) -> records::Dimension {
        self.row().2
    }
}

published! {
    /// The record of one sensor; published in its unit, self-weight taken off all but `self_weight`.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct SensorRecord |record, of: &Passage| {
        /// Its name.
        pub name: String,
        /// What it records.
        pub quantity: Measurand,
        /// Unit of its values.
        = unit: String = record.quantity.unit(),
        /// Least value.
        = minimum: f64 = record.quantity.scale() * record.range()[0],
        /// Greatest value.
        = maximum: f64 = record.quantity.scale() * record.range()[1],
        /// Value of largest size; its sign is kept.
        = peak: f64 = record.quantity.scale() * record.peak_value(),
        /// When that is.
        = time_of_peak: Option<f64> [s] = record.peak().and_then(|k| of.times.get(k)),
        /// Where the first axle is then.
        = position_of_peak: Option<f64> [m] = record.peak().and_then(|k| of.positions.get(k)),
        /// Value under self-weight alone [SI].
        pub self_weight: f64 = record.quantity.scale() * record.self_weight,
        /// Where it sits and what its sign means, in words.
        pub about: String,
        /// Value at every time, self-weight taken off [SI].
        pub values: Vec<f64> [kept],
    }
}

impl SensorRecord {
    /// Least and greatest value [SI]; zeros of an empty record.
    pub fn range(&self) -> [f64; 2] {
        let first = self.values.first().copied().unwrap_or(0.0);
        self.values.iter().fold([first; 2], |[low, high], value| [low.min(*value), high.max(*value)])
    }

    /// Index of the value of largest size, the first of equals; its sign is kept.
    pub fn peak(&self) -> Option<usize> {
        (0..self.values.len()).reduce(|best, k| if self.values[k].abs() > self.values[best].abs() { k } else { best })
    }

    /// That value [SI].
    pub fn peak_value(&self) -> f64 {
        self.peak().map_or(0.0, |k| self.values[k])
    }
}

published! {
    /// A position of a load test, and what sensors read in it.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PositionAtRest |position, of: &Passage| {
        /// Its name.
        pub name: String,
        /// Value of every sensor by its name, in its unit, self-weight taken off.
        = channels: Object = of.by_sensor(|k| position.values.get(k).copied()),
        /// Value of each sensor in the order of `channels`, self-weight taken off [SI]; empty where no equilibrium was found.
        pub values: Vec<f64> [kept],
        /// What was read, by the names of the sensors; none where nothing was.
        = readings?: Option<Object> =
            Some(of.by_sensor(|k| position.readings.get(k).copied().flatten())).filter(|readings| !readings.is_empty()),
        /// Reading of each sensor in the order of `channels` [SI], where there is one.
        pub readings: Vec<Option<f64>> [kept],
    }
}

/// One step of the run: of the self-weight, then one position after the other.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct StepLog {
    /// Which part of the run it belongs to.
    pub stage: Part,
    /// Time since the train started [s]; the share of the load in the self-weight's steps.
    pub time: f64,
    /// Position of the first axle [m].
    pub position: f64,
    /// Iterations.
    pub iterations: usize,
    /// Out-of-balance force over applied force; by the condensed path what is left of the largest displacement.
    pub unbalanced: f64,
    /// How often the step was cut back.
    pub cuts: usize,
    /// Points that yield.
    pub plastic_points: usize,
    /// Elements of soil all of whose points yield: they carry too much.
    pub locking_elements: usize,
    /// Joints that are open somewhere.
    pub open_joints: usize,
    /// Pairs that slide.
    pub sliding_pairs: usize,
}

words! {
    /// State of a pair of facing points.
    pub enum PairState {
        /// In contact.
        Closed = "closed",
        /// Apart.
        Open = "open",
        /// In contact, and sliding.
        Sliding = "sliding",
    }
}

/// A pair of facing points of a joint or a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Where, as built [m].
    pub at: Point,
    /// Area that it stands for, per metre of width [m].
    pub area: f64,
    /// Normal traction [Pa], tension positive.
    pub normal: f64,
    /// Shear traction [Pa].
    pub shear: f64,
    /// Opening [m], apart is positive.
    pub opening: f64,
    /// Sliding [m].
    pub sliding: f64,
    /// Its state.
    pub state: PairState,
}

/// What a row of pairs belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RowKind {
    /// A joint of the ring of a span (both from 0): joint 0 is the left springing.
    Joint {
        /// The span.
        span: usize,
        /// The joint.
        joint: usize,
    },
    /// Contact of masonry with fill.
    Contact,
}

/// A joint or a contact: its pairs in order, joints from the intrados to the extrados.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// What it belongs to.
    pub kind: RowKind,
    /// Its pairs.
    pub pairs: Vec<Pair>,
}

published! {
    /// The bridge at one moment.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Moment |moment| {
        /// Why it is kept: "self-weight", "peak of crown displacement", "first axle at 3.00 m".
        pub name: String,
        /// Time [s].
        pub time: f64 [s],
        /// Position of the first axle [m].
        pub position: f64 [m],
        /// How many axles stand above the mesh.
        = axles_above: usize = moment.axles.len(),
        /// Places [m] and forces [N] of the axles above the mesh.
        pub axles: Vec<(f64, f64)> [kept],
        /// Displacement of every node since the bridge was built, self-weight included [m].
        pub displacements: Vec<Point> [kept],
        /// Stress of every quadrilateral [Pa], tension positive: xx, yy, xy, zz.
        pub stresses: Vec<[f64; 4]> [kept],
        /// How many quadrilaterals have a point that yields.
        = yielding_elements: usize = moment.yielding.iter().filter(|yields| **yields).count(),
        /// Whether a point of it yields.
        pub yielding: Vec<bool> [kept],
        /// Joints and contacts.
        pub rows: Vec<Row> [kept],
    }
}

/// What one axle does that is moved over the bridge.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Influence {
    /// Its force [N], on the effective width.
    pub force: f64,
    /// Its places [m].
    pub positions: Vec<f64>,
    /// Value of each channel at each place, self-weight taken off [SI].
    pub values: Vec<Vec<f64>>,
}

words! {
    /// Which part of a run a step belongs to.
    #[derive(Default)]
    pub enum Part {
        /// The weight of the bridge is put on.
        #[default]
        SelfWeight = "self-weight",
        /// The train crosses.
        Passage = "passage",
    }
}

published! {
    /// The passage of a train over a bridge; its status is published as that of the command.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Passage |passage| {
        /// Name of the bridge.
        pub bridge: String,
        /// Name of the train.
        pub train: String,
        /// Its speed [m/s].
        pub speed: f64 [km/h],
        /// At rest at every position, or with inertia.
        pub analysis: PassageAnalysis,
        /// On the bridge as built, or deformed.
        pub kinematics: PassageKinematics,
        /// How positions were solved.
        pub path: PassagePath,
        /// How it ended.
        pub status: PassageStatus [kept],
        /// Why it ended early, where it did not complete.
        pub reason?: Option<String>,
        /// Times [s].
        pub times: Vec<f64> [kept],
        /// Position of the first axle at these times [m].
        pub positions: Vec<f64> [kept],
        /// Records of the sensors; where nothing crosses, their values in the positions of the load test.
        pub channels: Vec<SensorRecord> = list(&passage.channels, |one| one.object(passage)),
        /// Positions of the load test: `name`, `channels`, in its order.
        pub positions_at_rest: Vec<PositionAtRest> as positions = list(&passage.positions_at_rest, |one| one.object(passage)),
        /// Unknowns of the model, before anything is condensed.
        pub degrees_of_freedom: usize,
        /// Unknowns that iterate, where linear parts are condensed.
        pub condensed_degrees_of_freedom: Option<usize>,
        /// Positions at which equilibrium was sought.
        = load_positions: usize = passage.times.len() + passage.positions_at_rest.len(),
        /// Iterations of all steps.
        pub iterations_total: u64,
        /// Most joints that were open somewhere at the same time.
        pub open_joints: usize,
        /// Most points that yielded at the same time.
        pub plastic_points: usize,
        /// Most elements all of whose points yielded at the same time.
        pub locking_elements: usize,
        /// Width of the bridge that carries an axle [m].
        pub effective_width: f64 [m],
        /// Asked out-of-balance force over applied force.
        pub tolerance: f64,
        /// Time between two positions.
        = time_step: Option<f64> [s] = passage.times.get(1).map(|time| time - passage.times[0]),
        /// First position of the first axle.
        = first_position: Option<f64> [m] = passage.positions.first(),
        /// Last position of the first axle.
        = last_position: Option<f64> [m] = passage.positions.last(),
        /// Nodes of the mesh.
        = nodes: usize = passage.mesh.nodes.len(),
        /// Elements of the mesh.
        = elements: usize = passage.mesh.quads.len(),
        /// Parts of the mesh: `name`, `elements`.
        = zones: Vec<Object> = list(&passage.mesh.zones, |zone| object! { name: zone.name, elements: zone.quads, }),
        /// The mesh.
        pub mesh: MeshPicture [kept],
        /// The bridge at chosen moments; the first is under self-weight alone.
        pub moments: Vec<Moment>,
        /// What was assumed, in words.
        pub assumptions: Vec<Note>,
        /// Warnings.
        pub warnings: Vec<Warning> [kept],
        /// Every step.
        pub log: Vec<StepLog> [kept],
        /// Influence lines, where they were computed.
        pub influence: Option<Influence> [kept],
    }
}

impl Passage {
    /// Values of the sensors [SI] by their names, in their units; those that have none are left out.
    fn by_sensor(&self, value: impl Fn(usize) -> Option<f64>) -> Object {
        let channels = self.channels.iter().enumerate();
        let named = channels
            .filter_map(|(k, channel)| Some((channel.name.clone(), (channel.quantity.scale() * value(k)?).into())));
        named.collect()
    }
}

impl Moment {
    /// Lines of thrust, one for each span: where the resultant crosses each joint of the ring, from the tractions of its pairs.
    /// Joints that carry no compression are passed over.
    pub fn thrust_lines(&self) -> Vec<Vec<ThrustPoint>> {
        let mut lines: Vec<Vec<(usize, ThrustPoint)>> = Vec::new();
        for row in &self.rows {
            let RowKind::Joint { span, joint } = row.kind else { continue };
            if lines.len() <= span {
                lines.resize(span + 1, Vec::new());
            }
            if let Some(point) = resultant(&row.pairs) {
                lines[span].push((joint, point));
            }
        }
        for line in &mut lines {
            line.sort_by_key(|(joint, _)| *joint);
        }
        lines.into_iter().map(|line| line.into_iter().map(|(_, point)| point).collect()).collect()
    }
}

/// Where the resultant of a joint's tractions crosses it, and its size [N/m].
fn resultant(pairs: &[Pair]) -> Option<ThrustPoint> {
    let compression = |pair: &Pair| -pair.normal * pair.area;
    let normal: f64 = pairs.iter().map(compression).sum();
    let shear: f64 = pairs.iter().map(|pair| pair.shear * pair.area).sum();
    if normal.is_nan() || normal <= 0.0 {
        return None;
    }
    let centre = |c: usize| pairs.iter().map(|pair| compression(pair) * pair.at[c]).sum::<f64>() / normal;
    Some(ThrustPoint { point: [centre(0), centre(1)], thrust: normal.hypot(shear) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peak_keeps_its_sign_and_its_time() {
        let channel = SensorRecord {
            name: "crown".into(),
            quantity: Measurand::Displacement,
            about: String::new(),
            self_weight: -1e-3,
            values: vec![0.0, 1e-4, -3e-4, 2e-4, -3e-4],
        };
        assert_eq!((channel.peak(), channel.peak_value(), channel.range()), (Some(2), -3e-4, [-3e-4, 2e-4]));
    }

    /// Springs at the edges of a section: the resultant stands where levers put it.
    #[test]
    fn the_line_of_thrust_passes_through_the_resultants() {
        let pair = |y: f64, normal: f64| Pair {
            at: [1.0, y],
            area: 0.5,
            normal,
            shear: 0.3 * normal,
            opening: 0.0,
            sliding: 0.0,
            state: PairState::Closed,
        };
        let row =
            |joint, a, b| Row { kind: RowKind::Joint { span: 1, joint }, pairs: vec![pair(0.0, a), pair(1.0, b)] };
        let rows = vec![row(1, -1e5, -3e5), row(0, -2e5, 0.0), row(2, 0.0, 0.0)];
        let lines = Moment { rows, ..Moment::default() }.thrust_lines();
        assert!(lines[0].is_empty());
        assert_eq!(lines[1].iter().map(|p| p.point[1]).collect::<Vec<_>>(), [0.0, 0.75]);
        // Half a square metre each, friction of 0.3.
        assert!((lines[1][1].thrust - 2e5 * 1.09_f64.sqrt()).abs() < 1e-6);
    }
}
