//! `extrados.respond/1`, and its tables.

use super::tables::row;
use crate::mesh::MeshPicture;
use crate::passage::{Channel, Passage, RowKind, StepLog};
use serde::Serialize;

/// The result of a train's passage. Status, warnings and times are those of the command.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PassageObject {
    bridge: String,
    train: String,
    speed_km_per_h: f64,
    analysis: &'static str,
    kinematics: &'static str,
    path: &'static str,
    /// Why the run ended early, where it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    channels: Vec<ChannelObject>,
    degrees_of_freedom: usize,
    condensed_degrees_of_freedom: Option<usize>,
    load_positions: usize,
    iterations_total: u64,
    open_joints: usize,
    plastic_points: usize,
    locking_elements: usize,
    effective_width_m: f64,
    tolerance: f64,
    time_step_s: Option<f64>,
    first_position_m: Option<f64>,
    last_position_m: Option<f64>,
    nodes: usize,
    elements: usize,
    zones: Vec<ZoneObject>,
    moments: Vec<MomentObject>,
    assumptions: Vec<String>,
}

/// A channel: numbers in its unit, self-weight taken off all but `self_weight`.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct ChannelObject {
    name: String,
    quantity: &'static str,
    unit: &'static str,
    minimum: f64,
    maximum: f64,
    peak: f64,
    time_of_peak_s: Option<f64>,
    position_of_peak_m: Option<f64>,
    self_weight: f64,
    about: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ZoneObject {
    name: String,
    elements: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct MomentObject {
    name: String,
    time_s: f64,
    position_m: f64,
    axles_above: usize,
    yielding_elements: usize,
}

impl PassageObject {
    /// The object for a report.
    pub fn new(passage: &Passage) -> PassageObject {
        PassageObject {
            bridge: passage.bridge.clone(),
            train: passage.train.clone(),
            speed_km_per_h: 3.6 * passage.speed,
            analysis: passage.analysis.word(),
            kinematics: passage.kinematics.word(),
            path: passage.path.word(),
            reason: passage.reason.clone(),
            channels: channels(passage),
            degrees_of_freedom: passage.degrees_of_freedom,
            condensed_degrees_of_freedom: passage.condensed_degrees_of_freedom,
            load_positions: passage.times.len(),
            iterations_total: passage.iterations_total,
            open_joints: passage.open_joints,
            plastic_points: passage.plastic_points,
            locking_elements: passage.locking_elements,
            effective_width_m: passage.effective_width,
            tolerance: passage.tolerance,
            time_step_s: passage.times.get(1).map(|time| time - passage.times[0]),
            first_position_m: passage.positions.first().copied(),
            last_position_m: passage.positions.last().copied(),
            nodes: passage.mesh.nodes.len(),
            elements: passage.mesh.quads.len(),
            zones: zones(&passage.mesh),
            moments: moments(passage),
            assumptions: passage.assumptions.clone(),
        }
    }
}

fn channels(passage: &Passage) -> Vec<ChannelObject> {
    let one = |channel: &Channel| {
        let scale = channel.quantity.scale();
        let [minimum, maximum] = channel.range().map(|value| scale * value);
        let at = channel.peak();
        ChannelObject {
            name: channel.name.clone(),
            quantity: channel.quantity.word(),
            unit: channel.quantity.unit(),
            minimum,
            maximum,
            peak: scale * channel.peak_value(),
            time_of_peak_s: at.and_then(|k| passage.times.get(k)).copied(),
            position_of_peak_m: at.and_then(|k| passage.positions.get(k)).copied(),
            self_weight: scale * channel.self_weight,
            about: channel.about.clone(),
        }
    };
    passage.channels.iter().map(one).collect()
}

fn zones(mesh: &MeshPicture) -> Vec<ZoneObject> {
    mesh.zones.iter().map(|zone| ZoneObject { name: zone.name.clone(), elements: zone.quads }).collect()
}

fn moments(passage: &Passage) -> Vec<MomentObject> {
    let one = |moment: &crate::passage::Moment| MomentObject {
        name: moment.name.clone(),
        time_s: moment.time,
        position_m: moment.position,
        axles_above: moment.axles.len(),
        yielding_elements: moment.yielding.iter().filter(|yields| **yields).count(),
    };
    passage.moments.iter().map(one).collect()
}

/// `channels.csv`: a time, and a column for each channel, headed by its name and unit; self-weight taken off.
pub fn channels_table(passage: &Passage) -> String {
    let mut csv = String::from("time_s");
    for channel in &passage.channels {
        csv += &format!(",{}", column(channel));
    }
    csv.push('\n');
    for (k, time) in passage.times.iter().enumerate() {
        let mut line = time.to_string();
        for channel in &passage.channels {
            let value = channel.values.get(k).map(|value| channel.quantity.scale() * value);
            line += &value.map_or(",".to_owned(), |value| format!(",{value}"));
        }
        row(&mut csv, format_args!("{line}"));
    }
    csv
}

/// Every step of the run: what it was, where, and what it took.
pub fn passage_log(passage: &Passage) -> String {
    let mut csv = String::from(
        "stage,time_s,position_m,iterations,unbalanced_ratio,cuts,plastic_points,open_joints,sliding_pairs\n",
    );
    for step in &passage.log {
        let StepLog { stage, time, position, iterations, unbalanced, cuts, .. } = step;
        row(
            &mut csv,
            format_args!(
                "{stage},{time},{position},{iterations},{unbalanced},{cuts},{},{},{}",
                step.plastic_points, step.open_joints, step.sliding_pairs
            ),
        );
    }
    csv
}

/// Joints of the ring at every moment that is kept: tractions, openings, states.
pub fn joint_states(passage: &Passage) -> String {
    let mut csv = String::from(
        "moment,span,joint,x_m,y_m,area_m,normal_stress_mpa,shear_stress_mpa,opening_mm,sliding_mm,state\n",
    );
    for (k, moment) in passage.moments.iter().enumerate() {
        for joint in &moment.rows {
            let RowKind::Joint { span, joint: number } = joint.kind else { continue };
            for pair in &joint.pairs {
                row(
                    &mut csv,
                    format_args!(
                        "{k},{},{number},{},{},{},{},{},{},{},{}",
                        span + 1,
                        pair.at[0],
                        pair.at[1],
                        pair.area,
                        pair.normal / 1e6,
                        pair.shear / 1e6,
                        pair.opening * 1e3,
                        pair.sliding * 1e3,
                        pair.state.word()
                    ),
                );
            }
        }
    }
    csv
}

/// Lines of thrust at every moment that is kept.
pub fn thrust_lines(passage: &Passage) -> String {
    let mut csv = String::from("moment,span,x_m,y_m,thrust_kn_per_m\n");
    for (k, moment) in passage.moments.iter().enumerate() {
        for (span, line) in moment.thrust_lines().iter().enumerate() {
            for point in line {
                let [x, y] = point.point;
                row(&mut csv, format_args!("{k},{},{x},{y},{}", span + 1, point.thrust / 1e3));
            }
        }
    }
    csv
}

/// Influence lines: the place of the axle, and a column for each channel.
pub fn influence_table(passage: &Passage) -> String {
    let mut csv = String::from("position_m");
    for channel in &passage.channels {
        csv += &format!(",{}", column(channel));
    }
    csv.push('\n');
    let Some(influence) = &passage.influence else { return csv };
    for (k, position) in influence.positions.iter().enumerate() {
        let mut line = position.to_string();
        for (channel, values) in passage.channels.iter().zip(&influence.values) {
            let value = values.get(k).map(|value| channel.quantity.scale() * value);
            line += &value.map_or(",".to_owned(), |value| format!(",{value}"));
        }
        row(&mut csv, format_args!("{line}"));
    }
    csv
}

/// Heading of a channel's column: its name and unit.
fn column(channel: &Channel) -> String {
    let name: String = channel.name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    format!("{name}_{}", channel.quantity.unit().to_lowercase())
}
