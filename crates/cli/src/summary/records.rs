//! The verdict on records in an engineer's words.

use super::update::list;
use findings::words::counted;
use outcome::update::Update;
use std::fmt::Write;

/// The verdict on the records alone.
pub(crate) fn records(found: &Update, out: &str) -> String {
    let used = &found.records;
    let mut page = format!("{}: records of the passage of {}\n\n", found.bridge, found.train);
    for run in &used.runs {
        let speed = run.speed.map_or("speed not stated".to_owned(), |speed| format!("{:.1} km/h", 3.6 * speed));
        let synthetic = if run.synthetic.is_some() { ", SYNTHETIC: computed and not measured" } else { "" };
        let channels = counted(run.channels, "channel");
        let _ = writeln!(page, "  run {} ({}): {speed}, {channels} used{synthetic}", run.name, run.file);
    }
    if let Some(verdict) = &used.verdict {
        peaks(&mut page, &verdict.peaks);
        let _ =
            writeln!(page, "\n  dynamics: {}\n  plane strain: {}", verdict.dynamics.words, verdict.plane_strain.words);
    }
    start_model(&mut page, found);
    let named = used.findings.iter().zip(&used.places).map(|(finding, file)| match file.as_str() {
        "" => finding.words(),
        file => format!("{file}: {}", finding.words()),
    });
    list(&mut page, "Found in the records", named);
    if used.findings.is_empty() {
        page += "\nNothing was found in the records.\n";
    }
    let done = used.done.iter().map(|done| format!("{} {}: {}", done.run, done.channel, done.what));
    list(&mut page, "Done to the records", done);
    let _ = writeln!(page, "\nNothing was sought. Results are in {out}");
    page
}

/// A line for each channel on each line across the barrel, a column for each run.
fn peaks(page: &mut String, table: &outcome::records::PeakTable) {
    let mut rows: Vec<(String, String)> = Vec::new();
    for peak in &table.peaks {
        let name = if peak.line.is_empty() { peak.name.clone() } else { format!("{} @ {}", peak.name, peak.line) };
        let value = format!("{:.4} ({})", peak.unit.of_si(peak.value), peak.run);
        match rows.iter_mut().find(|(known, _)| known.starts_with(&name) && known[name.len()..].starts_with(" [")) {
            Some((_, values)) => *values += &format!(", {value}"),
            None => rows.push((format!("{name} [{}]", peak.unit.symbol), value)),
        }
    }
    page.push_str("\n  peaks\n");
    for (name, values) in rows {
        let _ = writeln!(page, "  {name:<46} {values}");
    }
}

/// What the start model makes of them: Table 3 of the railway paper.
fn start_model(page: &mut String, found: &Update) {
    let Some(basis) = &found.basis else { return };
    let head = ["measured", "start model", "error", "shape"];
    let _ = writeln!(page, "\n  {:<34} {:>10} {:>12} {:>8} {:>7}", "channel", head[0], head[1], head[2], head[3]);
    let number = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.4}"));
    for (k, channel) in found.problem.channels().iter().enumerate() {
        let (measured, shape) = (number(channel.measured_peak()), number(basis.held.shape_correlations[k]));
        let start = basis.start.channels[k];
        let error = if start.error.is_finite() { format!("{:.4}", start.error) } else { "-".to_owned() };
        let why = channel.left_out.as_ref().map_or(String::new(), |why| format!(", left out: {why}"));
        let (name, peak, unit) = (&channel.name, start.peak, &channel.unit);
        let _ = writeln!(page, "  {name:<34} {measured:>10} {peak:>12.4} {error:>8} {shape:>7}  {unit}{why}");
    }
    let _ = writeln!(page, "  norm of the start model {:.4}", basis.start.norm);
}
