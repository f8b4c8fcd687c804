//! `extrados verify`: runs the verification cases, prints the manual's table kind by kind, and compares the load models of the
//! library with the tables that were published for them.

use crate::args::Verify;
use crate::desk::Desk;
use crate::failure;
use crate::folder;
use crate::report::Report;
use crate::status::Status;
use crate::watcher;
use extrados::Refusal;
use extrados::files::head;
use findings::words::counted;
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use verification::{Case, Class, Judged, Kind, TableRow, Verdict};

/// Runs the cases below a folder.
pub(super) fn run(desk: &mut Desk, arguments: &Verify) -> Result<Report, Refusal> {
    if let Some(path) = &arguments.manual {
        free(path)?;
    }
    let cases = read(&arguments.folder)?;
    let (chosen, left): (Vec<Case>, Vec<Case>) =
        cases.into_iter().partition(|case| arguments.slow || case.class == Class::Quick);
    let bar = watcher::bar(desk.screen.quiet, chosen.len() as u64);
    let judged: Vec<Option<Judged>> = chosen
        .par_iter()
        .map(|case| {
            let judged = (!watcher::asked_to_stop()).then(|| verification::run(case));
            watcher::counted(&bar, "cases");
            judged
        })
        .collect();
    bar.finish_and_clear();
    let complete = judged.iter().all(Option::is_some);
    let judged: Vec<Judged> = judged.into_iter().flatten().collect();
    let tables = verification::tables()
        .map_err(|wrong| Refusal::new("F112", wrong, "this program was built with a library that cannot be used"))?;
    let well = judged.iter().all(|one| one.verdict.is_well()) && tables.iter().all(TableRow::agrees);
    let status = match (complete, well) {
        (false, _) => Status::Cancelled,
        (true, true) => Status::Completed,
        (true, false) => Status::Inadequate,
    };
    if let Some(path) = arguments.manual.as_ref().filter(|_| complete) {
        let written = folder::write_whole(path, verification::manual(&judged).as_bytes());
        written.map_err(|error| failure::not_written(path, &error))?;
    }
    Ok(Report::new(status)
        .with("kinds", counts(&judged))
        .with("cases", judged.iter().map(case).collect::<Vec<Value>>())
        .with("tables", tables.iter().map(table).collect::<Vec<Value>>())
        .with("left_out", left.iter().map(|case| case.name.as_str()).collect::<Vec<&str>>())
        .saying(summary(&judged, &tables, &left, status)))
}

/// How the manual begins.
const MANUAL: &str = "# Verification manual";

/// The manual replaces an earlier manual and no other file.
fn free(path: &Path) -> Result<(), Refusal> {
    match head(path, MANUAL.len() as u64) {
        Ok(bytes) if !bytes.starts_with(MANUAL.as_bytes()) => {
            let message = format!("{} exists and is no verification manual", path.display());
            Err(Refusal::new("F119", message, "name another file with --manual FILE"))
        }
        _ => Ok(()),
    }
}

fn read(folder: &Path) -> Result<Vec<Case>, Refusal> {
    if !folder.exists() {
        let message = format!("there is no folder {} here", folder.display());
        let help =
            "the cases stand in verification/ of the source: run the command in a clone of it, or name the folder";
        return Err(Refusal::new("F111", message, help));
    }
    let found = verification::discover(folder).map_err(|error| Refusal::unreadable(folder, &error))?;
    if found.is_empty() {
        let message = format!("{} holds no folder with a case.toml", folder.display());
        return Err(Refusal::new("F111", message, "name the folder of the verification cases"));
    }
    let read = found.iter().map(|folder| Case::read(folder));
    read.collect::<Result<_, _>>().map_err(|error| {
        Refusal::new(
            "F112",
            error.to_string(),
            "repair the case, or name another folder; verification/README.md tells what a case holds",
        )
    })
}

fn counts(judged: &[Judged]) -> Map<String, Value> {
    let mut kinds = Map::new();
    for kind in Kind::ALL {
        let of_kind = || judged.iter().filter(|one| one.case.kind == *kind);
        let count = |test: fn(&Verdict) -> bool| of_kind().filter(|one| test(&one.verdict)).count();
        if of_kind().next().is_some() {
            let row = json!({
                "holds": count(|verdict| *verdict == Verdict::Holds),
                "open": count(|verdict| matches!(verdict, Verdict::Open(_))),
                "fails": count(|verdict| !verdict.is_well()),
            });
            kinds.insert(kind.word().to_owned(), row);
        }
    }
    kinds
}

fn case(judged: &Judged) -> Value {
    let findings = judged.findings.iter().map(|finding| {
        json!({
            "quantity": finding.expect.quantity,
            "found": finding.found,
            "met": finding.met,
            "why_this_tolerance": finding.expect.why,
        })
    });
    let mut value = json!({
        "name": judged.case.name,
        "title": judged.case.title,
        "kind": judged.case.kind.word(),
        "verdict": judged.verdict.word(),
        "seconds": judged.seconds,
        "findings": findings.collect::<Vec<Value>>(),
    });
    if let Verdict::Open(reason) | Verdict::Broken(reason) = &judged.verdict {
        value["reason"] = json!(reason);
    }
    value
}

fn table(row: &TableRow) -> Value {
    json!({
        "load_model": row.model,
        "vehicle": row.table.vehicle,
        "quantity": row.quantity,
        "source": row.source,
        "published": row.published,
        "numbers": row.numbers,
        "largest_difference": row.difference,
        "at_span_m": row.span,
        "tolerance": row.table.tolerance,
        "why_this_tolerance": row.table.reason,
        "agrees": (row.numbers > 0).then(|| row.agrees()),
        "why_not_compared": row.left_out,
    })
}

/// The tables of load models, one a line.
fn tables_in_words(tables: &[TableRow]) -> String {
    let compared: Vec<&TableRow> = tables.iter().filter(|row| row.numbers > 0).collect();
    let agree = compared.iter().filter(|row| row.agrees()).count();
    let numbers: usize = compared.iter().map(|row| row.numbers).sum();
    let published = compared.iter().filter(|row| row.published).count();
    let mut page = format!(
        "load models against tables: {agree} of {} agree, {numbers} numbers; {published} were published, the others worked out by hand\n",
        counted(compared.len(), "table")
    );
    for row in compared {
        let word = if row.agrees() { "agrees" } else { "differs" };
        let _ = writeln!(
            page,
            "  {:18}  {word:7}  {:2} numbers, at most {:+.1e} at {} m, {:.0e} allowed: {}, {}",
            row.table.vehicle, row.numbers, row.difference, row.span, row.table.tolerance, row.quantity, row.source
        );
    }
    let read = tables.iter().filter(|row| row.numbers == 0).count();
    if read > 0 {
        let _ = writeln!(page, "  {read} tables are read and not compared: the vehicle alone does not give them");
    }
    page
}

fn summary(judged: &[Judged], tables: &[TableRow], left: &[Case], status: Status) -> String {
    let mut page = String::new();
    for kind in Kind::ALL {
        let of_kind: Vec<Judged> = judged.iter().filter(|one| one.case.kind == *kind).cloned().collect();
        if of_kind.is_empty() {
            continue;
        }
        let holds = of_kind.iter().filter(|one| one.verdict == Verdict::Holds).count();
        let _ = writeln!(page, "against {}: {holds} of {} hold", kind.words(), of_kind.len());
        for line in verification::table(&of_kind).lines() {
            let _ = writeln!(page, "  {line}");
        }
        page.push('\n');
    }
    page += &tables_in_words(tables);
    page.push('\n');
    if !left.is_empty() {
        let _ = writeln!(page, "left out: {} slow cases; --slow runs them too", left.len());
    }
    page += match status {
        Status::Completed => "every case holds that should, and every table agrees\n",
        Status::Cancelled => "interrupted: not every case was run\n",
        _ => "a case does not hold, or a table differs\n",
    };
    page
}
