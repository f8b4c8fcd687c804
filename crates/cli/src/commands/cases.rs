//! `extrados cases`: the named cases of a bridge file, side by side.

use super::source::Source;
use crate::args::Cases as Arguments;
use crate::desk::Desk;
use crate::folder;
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::watched;
use extrados::{Cases, Refusal};
use std::fmt::Write;
use std::path::Path;

/// Reads the file, makes every case, writes them side by side.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    let source = Source::open(desk, &arguments.file)?;
    let Some(bridge) = source.bridge() else { return Ok(source.report(Status::UnusableInput)) };
    let choice = arguments.choice.of(bridge.width)?;
    let folder = source.folder(&folder::named(&arguments.out, &arguments.file), "cases")?;
    let found = watched(desk.screen.quiet, |spectator| extrados::cases(&source.project, choice, spectator))?;
    let mut report = source.report(Status::worst_of(found.answers.iter().map(|one| one.collapse.status)));
    report.fields = found.object();
    report.warn_of(&mut desk.screen, &found.warnings());
    report.summary = summary(&bridge.name, &found, folder.path());
    results::publish(desk, report, &folder, extrados::written::cases(&bridge.name, &found))
}

fn summary(bridge: &str, found: &Cases, folder: &Path) -> String {
    let mut page = match (found.governing().map(|one| (&one.name, one.factor())), found.least()) {
        (Some((name, Some(factor))), _) => {
            let word = if factor < 1.0 { "is not carried" } else { "is carried" };
            format!("{bridge}: case \"{name}\" governs and {word}, load factor {factor:.3}\n")
        }
        (_, Some(least)) => {
            let factor = least.factor().unwrap_or(0.0);
            format!(
                "{bridge}: not every case has an answer; the least factor is at most {factor:.3}, case \"{}\"\n",
                least.name
            )
        }
        _ => format!("{bridge}: no case has a load factor\n"),
    };
    let wide = found.answers.iter().map(|one| one.name.chars().count()).max().unwrap_or(0).clamp(4, 48);
    let _ = writeln!(page, "\n  {:<wide$} {:>11} {:>12}  {:<22} acts", "case", "load factor", "load [kN/m]", "ended");
    for one in &found.answers {
        let factor = one.factor().map_or("-".to_owned(), |factor| format!("{factor:.3}"));
        let load = one.collapse.carried().map_or("-".to_owned(), |load| format!("{:.2}", 1e-3 * load));
        let ended = one.collapse.status.to_string();
        let _ = writeln!(page, "  {:<wide$} {factor:>11} {load:>12}  {ended:<22} {}", one.name, one.told);
    }
    let _ = writeln!(
        page,
        "\nResults are in {}: a table, and the drawings of each case in a folder of its own",
        folder.display()
    );
    page
}
