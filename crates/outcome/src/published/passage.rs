//! Tables of `extrados.respond/1`.

use super::rows::row;
use crate::passage::{Passage, RowKind, SensorRecord, StepLog};

/// `channels.csv`: a time, and a column for each channel, headed by its name and unit; self-weight taken off.
pub fn channels_table(passage: &Passage) -> String {
    columns(passage, "time_s", &passage.times, passage.channels.iter().map(|channel| &channel.values))
}

/// `positions.csv`: a row for each position of the load test, a column for each channel; self-weight taken off. A load test reads such a table.
pub fn positions_table(passage: &Passage) -> String {
    let mut csv = String::new();
    row!(&mut csv, "position", headings(passage));
    for position in &passage.positions_at_rest {
        let cells = passage.channels.iter().enumerate();
        let cells = cells.map(|(k, channel)| Some(channel.quantity.scale() * position.values.get(k)?));
        row!(&mut csv, position.name, cells.collect::<Vec<_>>());
    }
    csv
}

/// Influence lines: the place of the axle, and a column for each channel.
pub fn influence_table(passage: &Passage) -> String {
    let (positions, values) = passage.influence.as_ref().map_or((&[][..], &[][..]), |i| (&i.positions, &i.values));
    columns(passage, "position_m", positions, values)
}

/// A table with a column for each channel, in its unit.
fn columns<'a>(
    passage: &Passage,
    first: &str,
    at: &[f64],
    values: impl IntoIterator<Item = &'a Vec<f64>> + Clone,
) -> String {
    let mut csv = String::new();
    row!(&mut csv, first, headings(passage));
    for (k, at) in at.iter().enumerate() {
        let cells = passage.channels.iter().zip(values.clone());
        let cells = cells.map(|(channel, values)| Some(channel.quantity.scale() * values.get(k)?));
        row!(&mut csv, at, cells.collect::<Vec<_>>());
    }
    csv
}

/// Names of the channels with their units.
fn headings(passage: &Passage) -> Vec<String> {
    let heading = |channel: &SensorRecord| {
        let name: String = channel.name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
        format!("{name}_{}", channel.quantity.unit().to_lowercase())
    };
    passage.channels.iter().map(heading).collect()
}

/// Every step of the run: what it was, where, and what it took.
pub fn passage_log(passage: &Passage) -> String {
    let mut csv = String::from(
        "stage,time_s,position_m,iterations,unbalanced_ratio,cuts,plastic_points,open_joints,sliding_pairs\n",
    );
    for step in &passage.log {
        let StepLog { stage, time, position, iterations, unbalanced, cuts, .. } = step;
        let points = [step.plastic_points, step.open_joints, step.sliding_pairs];
        row!(&mut csv, stage.word(), time, position, iterations, unbalanced, cuts, points);
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
                let traction = [pair.normal / 1e6, pair.shear / 1e6];
                let movement = [pair.opening * 1e3, pair.sliding * 1e3];
                row!(&mut csv, k, span + 1, number, pair.at, pair.area, traction, movement, pair.state.word());
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
                row!(&mut csv, k, span + 1, point.point, point.thrust / 1e3);
            }
        }
    }
    csv
}
