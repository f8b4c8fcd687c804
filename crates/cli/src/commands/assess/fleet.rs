//! A folder of bridge files: each is assessed into a folder of its own, side by side over the cores, and one table lists them,
//! worst first. A file that cannot be used is a row and stops nothing. What is finished is taken up by the next run.

use super::{answer, assessed, command, pdf, pictures, pictures_left_out};
use crate::args::Assess as Arguments;
use crate::commands::source::{Source, read_text};
use crate::desk::Desk;
use crate::failure;
use crate::folder::{self, Folder, Purpose};
use crate::program;
use crate::report::Report;
use crate::results::{self, Written};
use crate::shards::{self, Merged};
use crate::signs;
use crate::status::Status;
use crate::watcher;
use ::report::FleetRow;
use extrados::shard::Shard;
use extrados::{Disk, Means, Refusal};
use findings::visible::{is_hidden, one_line};
use findings::words::counted;
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Every bridge file of the folder, in the order of their names.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    let paths = bridge_files(&arguments.file)?;
    let shard = arguments.sharing.shard;
    let out = arguments.out.clone().unwrap_or_else(|| shards::folder_of(default_for(&arguments.file), shard));
    let folder = Folder::prepare(&out, Purpose::new(&shards::kind("fleet", shard), &arguments.file, &paths))?;
    let program = program::hash();
    let means = Means { program: &program, ..Means::default() };
    let names: Vec<String> = paths.iter().map(|path| name_of(path)).collect();
    let identity = means.key("fleet", &(names, &arguments.skip));
    if let Some(merged) = &arguments.sharing.merged {
        unchanged(&arguments.file, merged)?;
        merged.bring(&identity, &folder)?;
    }
    let own: Vec<&PathBuf> = shards::own(&paths, shard).collect();
    signs::keeps("out", folder.path(), KEPT);
    let bar = watcher::bar(desk.screen.quiet, own.len() as u64);
    let rows: Vec<Option<FleetRow>> = own
        .par_iter()
        .map(|file| {
            if watcher::asked_to_stop() {
                return None;
            }
            let row = one(file, &folder_of(file, &paths), arguments, &folder, &program);
            watcher::counted(&bar, "bridges");
            row
        })
        .collect();
    bar.finish_and_clear();
    desk.schema = "extrados.fleet/1".to_owned();
    if rows.iter().any(Option::is_none) {
        return Ok(Report::new(Status::Cancelled).saying(format!("interrupted; {KEPT}\n")));
    }
    let rows: Vec<FleetRow> = rows.into_iter().flatten().collect();
    if let Some(shard) = shard {
        return share(desk, shard, identity, &arguments.file, (&own, &paths), &folder);
    }
    let count = |status: Status| rows.iter().filter(|row| row.status == status.name()).count();
    let (broken, open, met) = (count(Status::Inadequate), count(Status::Undetermined), count(Status::Adequate));
    let unusable: Vec<&FleetRow> =
        rows.iter().filter(|row| !["inadequate", "undetermined", "adequate"].contains(&row.status.as_str())).collect();
    let mut report = Report::new(match (broken, open, unusable.len()) {
        (1.., _, _) => Status::Inadequate,
        (0, 0, 0) => Status::Adequate,
        _ => Status::Undetermined,
    });
    report.finished = rows.iter().all(|row| row.finished);
    let listed = |row: &&FleetRow| json!({ "file": row.file, "status": row.status, "message": row.words });
    report = report
        .with("bridges", rows.len())
        .with("inadequate", broken)
        .with("undetermined", open)
        .with("adequate", met)
        .with("unusable", unusable.iter().map(listed).collect::<Vec<Value>>());
    report.summary = format!(
        "{}: {broken} not adequate, {open} undetermined, {met} adequate, {} that could not be assessed\n\n",
        counted(rows.len(), "bridge"),
        unusable.len()
    );
    for row in unusable.iter().take(MOST_LISTED) {
        report.summary += &format!("  {}: {}\n", row.file, row.words);
    }
    if unusable.len() > MOST_LISTED {
        report.summary += &format!("  and {} more, in the table\n", unusable.len() - MOST_LISTED);
    }
    let map = ::report::fleet_geojson(&rows);
    let named = if map.is_some() { "fleet.html, fleet.csv and fleet.geojson" } else { "fleet.html and fleet.csv" };
    report.summary += &format!("\n{named} are in {}\n", folder.path().display());
    if map.is_none() {
        report.summary += "no map: write latitude and longitude into [document] of the bridge files\n";
    }
    let made = format!(
        "Made by extrados {}: {}",
        extrados::VERSION,
        command(arguments, &arguments.file.display().to_string())
    );
    let title = arguments.file.display().to_string();
    let mut files = vec![
        figures::File { name: "fleet.csv".into(), bytes: ::report::fleet_csv(&rows).into_bytes() },
        figures::File { name: "fleet.html".into(), bytes: ::report::fleet_html(&title, &rows, &made).into_bytes() },
    ];
    files.extend(map.map(|map| figures::File { name: "fleet.geojson".into(), bytes: map.into_bytes() }));
    results::publish(desk, report, &folder, Written { files, ..Written::default() })
}

/// The least factor on a vehicle of the rule, or else on the loads of the file, and what it is on.
fn least(facts: &::outcome::assessment::Facts) -> (Option<f64>, String) {
    let swept = facts.vehicles.made().into_iter().flat_map(|facts| &facts.vehicles);
    let factors = swept.filter_map(|one| Some((one.adequacy?, one.title.clone())));
    let own = facts.ultimate.made().and_then(|own| Some((own.load_factor?, own.load.clone())));
    let found = factors.min_by(|a, b| a.0.total_cmp(&b.0)).or(own);
    found.map_or((None, String::new()), |(factor, on)| (Some(factor), on))
}

/// A shard of a fleet: the finished stages of its bridges are its pieces, the bridge files its inputs.
fn share(
    desk: &mut Desk,
    shard: Shard,
    identity: String,
    root: &Path,
    (own, all): (&[&PathBuf], &[PathBuf]),
    folder: &Folder,
) -> Result<Report, Refusal> {
    let mut inputs = BTreeMap::new();
    let mut files = Vec::new();
    for path in own {
        // A file that cannot be used has no others beside it.
        let beside = Source::read(path, &Disk).map_or(Vec::new(), |source| source.project.inputs().to_vec());
        for input in beside.iter().filter(|input| input.is_file()).chain([*path]) {
            let hash = folder::hash(input).map_err(|error| Refusal::unreadable(input, &error))?;
            inputs.insert(input.strip_prefix(root).unwrap_or(input).display().to_string(), hash);
        }
        let stages = format!("{}/stages", folder_of(path, all));
        let Ok(entries) = fs::read_dir(folder.file(&stages)) else { continue };
        let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
        files.extend(names.filter(|name| !name.starts_with('.')).map(|name| format!("{stages}/{name}")));
    }
    files.sort();
    shards::publish(desk, Report::new(Status::Completed), folder, shard, identity, (inputs, files))
}

/// Refuses bridge files that are not those of which the shards were made.
fn unchanged(root: &Path, merged: &Merged) -> Result<(), Refusal> {
    let changed = merged.inputs().filter(|(name, hash)| folder::hash(&root.join(name)).ok().as_ref() != Some(hash));
    let names: Vec<&str> = changed.map(|(name, _)| name.as_str()).collect();
    if names.is_empty() {
        return Ok(());
    }
    let message = format!("files have changed since the shards were made: {}", names.join(", "));
    Err(Refusal::new("F145", message, "run the commands of the shards again: only what changed is computed"))
}

/// The name of a file, without its folder.
fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// What stays of a fleet that is interrupted.
const KEPT: &str = "finished bridges are kept, and the same command takes them up";

/// Files named one by one on the screen; the table has all.
const MOST_LISTED: usize = 40;

/// out/NAME-fleet beside the current folder.
fn default_for(folder: &Path) -> PathBuf {
    let name =
        folder.canonicalize().ok().and_then(|path| path.file_name().map(|name| name.to_string_lossy().into_owned()));
    Path::new("out").join(format!("{}-fleet", name.unwrap_or_else(|| "bridges".to_owned())))
}

/// Bridge files of a folder: every .toml that is no block model and no file of vehicles or rule, not looked for in folders below.
fn bridge_files(folder: &Path) -> Result<Vec<PathBuf>, Refusal> {
    let entries = fs::read_dir(folder).map_err(|error| Refusal::unreadable(folder, &error))?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.is_file() && path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")));
    files.retain(|path| {
        read_text(path)
            .map_or(true, |text| !bridge::is_block_file(&text) && !is_beside_a_bridge(&String::from_utf8_lossy(&text)))
    });
    files.sort();
    if files.is_empty() {
        let message = format!("the folder {} holds no bridge file (.toml)", folder.display());
        return Err(Refusal::new("F101", message, "put one file for each bridge into it"));
    }
    Ok(files)
}

/// Whether a text is a file of vehicles or a rule, which stands beside the bridge file that names it.
fn is_beside_a_bridge(text: &str) -> bool {
    let begins = |what: &str| text.lines().any(|line| line.trim_start().starts_with(what));
    !begins("[bridge]") && (begins("[[vehicle]]") || begins("[factors."))
}

/// The folder of a bridge below that of the fleet: its file's name without the ending, and with it where two differ by that or by
/// capital letters alone.
fn folder_of(path: &Path, files: &[PathBuf]) -> String {
    let stem = |path: &Path| folder::shown_stem(path).to_string_lossy().into_owned();
    let same = files.iter().filter(|other| stem(other).to_lowercase() == stem(path).to_lowercase());
    match same.count() {
        0 | 1 => stem(path),
        _ => name_of(path).replace(is_hidden, "_"),
    }
}

/// One bridge, into a folder of this name; none where somebody asked to stop.
fn one(path: &Path, stem: &str, arguments: &Arguments, fleet: &Folder, program: &str) -> Option<FleetRow> {
    let row = judged(path, stem, arguments, fleet, program).unwrap_or_else(|failure| {
        Some(blank(failure::status(&failure), format!("{} ({})", failure.message, failure.code)))
    });
    row.map(|row| FleetRow { file: one_line(&name_of(path)).into_owned(), ..row })
}

/// A row with nothing but how the assessment ended, and words about it.
fn blank(status: Status, words: String) -> FleetRow {
    FleetRow { status: status.name().to_owned(), words, ..FleetRow::default() }
}

/// The row of a bridge, but for its file.
fn judged(
    path: &Path,
    stem: &str,
    arguments: &Arguments,
    fleet: &Folder,
    program: &str,
) -> Result<Option<FleetRow>, Refusal> {
    let source = Source::read(path, pictures(arguments))?;
    if source.bridge().is_none() {
        let words: Vec<String> = source.project.errors().take(5).collect();
        return Ok(Some(blank(Status::UnusableInput, words.join("; "))));
    }
    let folder = source.folder(&fleet.file(stem), "assess")?;
    let Some(done) = assessed(&source, &folder, program, arguments, true)? else { return Ok(None) };
    let mut report = answer(&done, &source);
    let mut files = extrados::written::assessed(&done).files;
    let printed = arguments.pdf.then(|| pdf::pdf(&done, &folder)).map(|pdf| pdf.map(|file| files.push(file)));
    let left_out = pictures_left_out(&done).into_iter().chain(printed.and_then(Result::err));
    report.warnings.extend(left_out.map(|[code, message]| json!({ "code": code, "message": message })));
    folder.fill(
        |staging| results::write(staging, &files),
        |names, place, _| {
            report.fields.insert("out".to_owned(), json!(place.display().to_string()));
            report.fields.insert("files".to_owned(), json!(names));
            ::outcome::published::json(&report.object("extrados.assess/1", std::time::Instant::now()))
        },
    )?;
    let assessment = &done.assessment;
    let verdict = &assessment.verdict;
    let worst = ::outcome::checked::worst(&assessment.checked);
    let all = assessment.checked.iter().flat_map(|check| check.outcome.iter().flatten());
    let (factor, factor_on) = least(&assessment.facts);
    let document = source.project.meaning().document.as_ref();
    Ok(Some(FleetRow {
        factor,
        factor_on,
        place: document.and_then(|document| Some([document.latitude?, document.longitude?])),
        name: assessment.bridge.clone(),
        utilisation: worst.map(|(_, finding)| finding.utilisation),
        governing: worst.map_or(String::new(), |(check, _)| format!("{} {}", check.code, check.title)),
        load_model: worst.map_or(String::new(), |(_, finding)| finding.load_model.clone()),
        finished: verdict.finished,
        broken: all.filter(|finding| !finding.met()).count(),
        report: format!("{}/report.html", web(stem)),
        head: verdict.head(),
        beside: verdict.beside(),
        skipped: verdict.given.skipped.clone(),
        left_out: verdict.given.load_cases_left_out.clone(),
        doubtful: verdict.given.doubtful.iter().map(|one| one.code.clone()).collect(),
        ..blank(report.status, verdict.words.clone())
    }))
}

/// A name as a link has it.
fn web(name: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.~".contains(&byte);
    name.bytes().map(|byte| if plain(byte) { (byte as char).to_string() } else { format!("%{byte:02X}") }).collect()
}
