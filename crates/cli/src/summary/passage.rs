//! The answer of a passage in an engineer's words.

use findings::words::counted;
use outcome::passage::{Passage, PassageStatus};
use std::fmt::Write;

/// Peaks of the channels, what they took, what they rest on.
pub(crate) fn passage(found: &Passage, out: &str) -> String {
    let mut page = format!(
        "{}: {} at {:.1} km/h, {}, {} displacements\n\n",
        found.bridge,
        found.train,
        3.6 * found.speed,
        found.analysis,
        found.kinematics
    );
    if found.status == PassageStatus::NotConverged {
        let reason = found.reason.as_deref().unwrap_or("a step did not converge");
        let _ = writeln!(page, "  NOT CONVERGED: {reason}\n  records end there\n");
    }
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
    page += "  (self-weight taken off; a peak is the value of largest size)\n\n";
    let _ =
        write!(page, "  {}, {} degrees of freedom", counted(found.times.len(), "position"), found.degrees_of_freedom);
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
