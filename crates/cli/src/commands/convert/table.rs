//! A table of a bridge's numbers, from a spreadsheet or another program, becomes a bridge file.

use super::{Report, folder, guard};
use crate::args::Convert;
use crate::commands::source::read_file;
use crate::desk::Desk;
use crate::failure;
use crate::status::Status;
use bridge::Severity;
use bridge::survey::{self, Rows, Taken, Unusable};
use extrados::Refusal;
use extrados::files::LONGEST;
use findings::words::counted;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;

/// The text of a file that is a table of named numbers; none of one that is something else.
pub(super) fn read(path: &Path) -> Result<Option<String>, Refusal> {
    let text = String::from_utf8_lossy(&bridge::as_utf8(read_file(path, LONGEST)?)).into_owned();
    Ok(survey::is_table(&text).then_some(text))
}

/// Writes the bridge file of the table, and says of every line what became of it.
pub(super) fn run(desk: &mut Desk, arguments: &Convert, text: &str, to: &str) -> Result<Report, Refusal> {
    let from = arguments.from.display().to_string();
    if to != "toml" {
        let message = format!("{from} is a table of a bridge's numbers, and not a section that can be drawn");
        return Err(Refusal::new("F118", message, "write a bridge file, such as bridge.toml"));
    }
    let rows = survey::rows(text);
    let stem = arguments.from.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let name = rows.answer("name").unwrap_or(stem);
    let said = |key: &str| rows.answer(key);
    let file = survey::file(&name, &said).map_err(|wrong| refused(&from, &rows, &wrong))?;
    guard(arguments, &[&arguments.from])?;
    folder::write_whole(&arguments.to, file.as_bytes()).map_err(|error| failure::unwritable(&arguments.to, &error))?;
    let mut report = Report::new(Status::Completed);
    for left in &rows.left {
        let message = format!("{from}, line {} (\"{}\"): {}; {}", left.line, left.text, left.why, left.help);
        report.warn(&mut desk.screen, "F135", &message);
    }
    for taken in rows.taken.iter().filter(|taken| !taken.assumed.is_empty()) {
        let message = format!("{from}, line {} ({}): {}", taken.line, taken.name, taken.assumed);
        report.warn(&mut desk.screen, "F136", &message);
    }
    for doubt in survey::findings(&name, &said).iter().filter(|one| one.severity == Severity::Warning) {
        let message = [place(&from, &rows, doubt), doubt.message.clone(), doubt.help.clone()];
        report.warn(&mut desk.screen, "F136", &message.join("; "));
    }
    let assumed: Vec<&str> = file.lines().filter(|line| line.contains("# assumed")).map(str::trim).collect();
    let shown = arguments.to.display().to_string();
    let is_judged = rows.of("rule").is_some();
    let summary = summary(&from, &rows, &assumed, &shown, is_judged);
    let taken =
        |taken: &Taken| json!({ "line": taken.line, "name": taken.name, "key": taken.key, "value": taken.text });
    let left =
        |left: &survey::Left| json!({ "line": left.line, "text": left.text, "why": left.why, "help": left.help });
    Ok(report
        .with("understood", rows.taken.iter().map(taken).collect::<Vec<Value>>())
        .with("not_understood", rows.left.iter().map(left).collect::<Vec<Value>>())
        .with("assumed", assumed)
        .with("written", shown)
        .saying(summary))
}

/// Where an answer stands.
fn place(from: &str, rows: &Rows, one: &Unusable) -> String {
    match rows.of(&one.key) {
        Some(taken) => format!("{from}, line {} ({})", taken.line, taken.name),
        None => from.to_owned(),
    }
}

/// All that keeps a bridge file from being made: at its lines, and what no line says.
fn refused(from: &str, rows: &Rows, wrong: &[Unusable]) -> Refusal {
    let mut message: Vec<String> =
        wrong.iter().map(|one| format!("{}: {}", place(from, rows, one), one.message)).collect();
    let mut help: Vec<String> = wrong.iter().map(|one| one.help.clone()).collect();
    for left in &rows.left {
        message.push(format!("{from}, line {} (\"{}\"): {}", left.line, left.text, left.why));
        help.push(format!("line {}: {}", left.line, left.help));
    }
    Refusal::new("F108", message.join("; "), help.join("; "))
}

fn summary(from: &str, rows: &Rows, assumed: &[&str], shown: &str, is_judged: bool) -> String {
    let mut page = format!("{from}: {} understood\n\n", counted(rows.taken.len(), "line"));
    for taken in &rows.taken {
        let _ = writeln!(page, "  line {:<4} {:<18} {:<16} from \"{}\"", taken.line, taken.key, taken.text, taken.name);
    }
    if !rows.left.is_empty() {
        let _ = writeln!(page, "\nnot understood, and not in the file: {}", counted(rows.left.len(), "line"));
        for left in &rows.left {
            let _ = writeln!(page, "  line {:<4} {}\n            {}; {}", left.line, left.text, left.why, left.help);
        }
    }
    let _ = writeln!(page, "\nassumed, to be replaced by what is known: {}", counted(assumed.len(), "value"));
    assumed.iter().for_each(|line| page.push_str(&format!("  {line}\n")));
    let next = if is_judged { "assess" } else { "collapse" };
    let _ = writeln!(page, "\nwritten to {shown}\nnext: extrados {next} {shown}");
    page
}
