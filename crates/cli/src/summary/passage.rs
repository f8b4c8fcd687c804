//! The answer of a passage in an engineer's words.

use findings::words::counted;
use outcome::passage::{Passage, PassageStatus, SensorRecord};
use std::fmt::Write;

/// Peaks of the channels, what they took, what they rest on.
pub(crate) fn passage(found: &Passage, out: &str) -> String {
    let crossed = !found.times.is_empty() || found.positions_at_rest.is_empty();
    let how = match crossed {
        true => format!("{} at {:.1} km/h, {}", found.train, 3.6 * found.speed, found.analysis),
        false => format!("{}, {} at rest", found.train, counted(found.positions_at_rest.len(), "position")),
    };
    let mut page = format!("{}: {how}, {} displacements\n\n", found.bridge, found.kinematics);
    if found.status == PassageStatus::NotConverged {
        let reason = found.reason.as_deref().unwrap_or("a step did not converge");
        let _ = writeln!(page, "  NOT CONVERGED: {reason}\n  records end there\n");
    }
    if crossed {
        peaks(&mut page, found);
    }
    at_rest(&mut page, found);
    let solved = found.times.len() + found.positions_at_rest.len();
    let _ = write!(page, "  {}, {} degrees of freedom", counted(solved, "position"), found.degrees_of_freedom);
    if let Some(condensed) = found.condensed_degrees_of_freedom {
        let _ = write!(page, " ({condensed} iterate)");
    }
    let _ = writeln!(
        page,
        ", {}\n  at most {} open and {} yielding",
        counted(found.iterations_total as usize, "iteration"),
        counted(found.open_joints, "joint"),
        counted(found.plastic_points, "point")
    );
    page += "\nSigns:\n";
    for channel in &found.channels {
        let _ = writeln!(page, "  - {}: {}", channel.name, channel.about);
    }
    page += "\nThis assumes:\n";
    for line in &found.assumptions {
        let _ = writeln!(page, "  - {line}");
    }
    let _ = writeln!(page, "\nResults are in {out}");
    page
}

/// Peaks of the channels as the train passes.
fn peaks(page: &mut String, found: &Passage) {
    let wide = found.channels.iter().map(|channel| channel.name.chars().count()).max().unwrap_or(0).max(7);
    let _ = writeln!(page, "  {:<wide$}        peak     minimum     maximum   at [s]   self-weight", "channel");
    for channel in &found.channels {
        let scale = channel.quantity.scale();
        let [low, high] = channel.range().map(|value| scale * value);
        let time = channel.peak().and_then(|k| found.times.get(k)).copied().unwrap_or(0.0);
        let _ = writeln!(
            page,
            "  {:<wide$}  {:>10.4}  {low:>10.4}  {high:>10.4}  {time:>7.3}    {:>10.4}  {}",
            channel.name,
            scale * channel.peak_value(),
            scale * channel.self_weight,
            channel.quantity.unit()
        );
    }
    *page += "  (self-weight taken off; a peak is the value of largest size)\n\n";
}

/// Most positions that are shown; positions.csv has all.
const SHOWN: usize = 40;

/// A row for each position of the load test, a column for each channel, and what was read below.
fn at_rest(page: &mut String, found: &Passage) {
    let all = &found.positions_at_rest;
    if all.is_empty() {
        return;
    }
    let shown = &all[..all.len().min(SHOWN)];
    let wide = shown.iter().map(|position| position.name.chars().count()).max().unwrap_or(0).max(8);
    let heads: String = (1..=found.channels.len()).map(|k| format!("{:>12}", format!("({k})"))).collect();
    let _ = writeln!(page, "  {:<wide$}{heads}", "position");
    for position in shown {
        let cells = found.channels.iter().zip(&position.values);
        let cells: String =
            cells.map(|(channel, value)| format!("{:>12.4}", channel.quantity.scale() * value)).collect();
        let _ = writeln!(page, "  {:<wide$}{cells}", position.name);
        if position.readings.iter().any(Option::is_some) {
            let cells = found.channels.iter().zip(&position.readings);
            let cell = |(channel, value): (&SensorRecord, &Option<f64>)| match value {
                Some(value) => format!("{:>12.4}", channel.quantity.scale() * value),
                None => format!("{:>12}", "-"),
            };
            let _ = writeln!(page, "  {:<wide$}{}", "  read", cells.map(cell).collect::<String>());
        }
    }
    if all.len() > SHOWN {
        let _ = writeln!(page, "  and {} more in positions.csv", all.len() - SHOWN);
    }
    for (k, channel) in found.channels.iter().enumerate() {
        let _ = writeln!(page, "  ({}) {} [{}]", k + 1, channel.name, channel.quantity.unit());
    }
    *page += "  (changes from the unloaded bridge)\n\n";
}
