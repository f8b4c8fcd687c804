//! Files that a bridge file names: packings, trains, vehicles and rules, records, readings of a load test. Their paths are relative to the bridge file.

use crate::files::{Files, LONGEST, LONGEST_PHOTOGRAPH, LONGEST_TEXT};
use crate::refusal::{Refusal, reason};
use assess::analysis::update::RecordFile;
use bridge::{Particles, Read, Severity, SweepPlan, train};
use report::Photograph;
use std::path::{Path, PathBuf};
use structure::packing_file;

/// Reads what the bridge of a file takes from other files.
pub(crate) fn take(read: &mut Read, path: &Path, files: &dyn Files) -> Result<(), Refusal> {
    let Some(bridge) = read.bridge.as_mut() else { return Ok(()) };
    if let Some(particles) = &mut bridge.particles {
        packing(particles, path, files)?;
    }
    if let Some(sweep) = &mut bridge.sweep {
        vehicles(sweep, path, files)?;
    }
    if let Some(passage) = &mut bridge.passage {
        take_train(&mut passage.train, path, files)?;
    }
    if let Some(train) = bridge.load_test.as_mut().and_then(|test| test.train.as_mut()) {
        take_train(train, path, files)?;
    }
    Ok(())
}

/// Reads the table of readings that a load test names. A bridge can be loaded before anybody has read anything: without its table the file is used, and
/// only updating needs it.
pub(crate) fn readings(read: &mut Read, path: &Path, files: &dyn Files) -> Result<(), Refusal> {
    let Some(test) = read.bridge.as_mut().and_then(|bridge| bridge.load_test.as_mut()) else { return Ok(()) };
    let Some(name) = &test.readings.file else { return Ok(()) };
    let path = beside(path, name);
    let text = text("readings", name, &path, files)?;
    test.take_table(&String::from_utf8_lossy(&text)).map_err(|wrong| {
        const SHOWN: usize = 10;
        let more = wrong.len().saturating_sub(SHOWN);
        let mut said = wrong.into_iter().take(SHOWN).collect::<Vec<_>>().join("; ");
        if more > 0 {
            said += &format!("; and {more} more");
        }
        let message = format!("cannot use the readings {}: {said}", path.display());
        let help = "write a row for each position and a column for each sensor with its unit: position,crown displacement [mm]";
        Refusal::new("F130", message, help)
    })
}

/// Every file that is read beside a bridge file, and every record that is going to be.
pub(crate) fn inputs(read: &Read, path: &Path, files: &dyn Files) -> Vec<PathBuf> {
    let Some(bridge) = &read.bridge else { return Vec::new() };
    let mut names: Vec<&str> = Vec::new();
    names.extend(bridge.particles.as_ref().and_then(|particles| particles.file.as_deref()));
    names.extend(bridge.passage.as_ref().and_then(|passage| passage.train.file.as_deref()));
    let test = bridge.load_test.as_ref();
    names.extend(test.and_then(|test| test.train.as_ref()).and_then(|train| train.file.as_deref()));
    names.extend(test.and_then(|test| test.readings.file.as_deref()));
    names.extend(
        bridge.sweep.iter().flat_map(|sweep| sweep.rule_file.iter().chain(&sweep.vehicle_files)).map(String::as_str),
    );
    let mut all: Vec<PathBuf> = names.into_iter().map(|name| beside(path, name)).collect();
    // A folder of records is every file in it.
    let records = read.update.as_ref().and_then(|update| update.records.as_ref());
    if let Some(place) = records.map(|records| beside(path, &records.place)) {
        all.extend(files.list(&place).ok().flatten().unwrap_or_default());
        all.push(place);
    }
    all
}

/// Photographs of a report together [bytes].
const ALL_PHOTOGRAPHS: u64 = 64 << 20;

/// Photographs of inspections. One that is missing, too large, or outside the folder of the bridge file does not keep a bridge from being
/// assessed: the report says why it is not there. A report is passed on, and must not carry files that its reader has no right to.
pub(crate) fn photographs(read: &Read, path: &Path, files: &dyn Files) -> Vec<Photograph> {
    let inspections = read.document.iter().flat_map(|document| &document.inspections);
    let named =
        inspections.filter_map(|one| Some((one.photograph.as_ref()?, format!("{}: {}", one.part, one.finding))));
    let mut room = ALL_PHOTOGRAPHS;
    let photograph = |(name, caption): (&String, String)| match picture(path, name, files, &mut room) {
        Ok(bytes) => Photograph::new(name, &caption, &bytes),
        Err(why) => Photograph { file: name.clone(), caption, source: Err(why) },
    };
    named.map(photograph).collect()
}

fn picture(bridge: &Path, name: &str, files: &dyn Files, room: &mut u64) -> Result<Vec<u8>, String> {
    let place = beside(bridge, name);
    let why = |error: std::io::Error| reason(&error);
    if !files.pictures_from_outside() {
        let folder = Some(beside(bridge, "")).filter(|folder| !folder.as_os_str().is_empty());
        let folder = files.real(&folder.unwrap_or_else(|| PathBuf::from("."))).map_err(why)?;
        if !files.real(&place).map_err(why)?.starts_with(&folder) {
            return Err("it lies outside the folder of the bridge file; --allow-outside takes it".to_owned());
        }
    }
    let bytes = files.read_at_most(&place, LONGEST_PHOTOGRAPH).map_err(why)?;
    *room = room.checked_sub(bytes.len() as u64).ok_or("all photographs together are larger than 64 MiB")?;
    Ok(bytes)
}

/// Tables of records that one update reads.
const MOST_RECORDS: usize = 1000;

/// The tables of measurements that the file names: one, or all of a folder in the order of their names.
pub(crate) fn records(path: &Path, name: &str, files: &dyn Files) -> Result<Vec<RecordFile>, Refusal> {
    let place = beside(path, name);
    let listed = files.list(&place).map_err(|error| Refusal::companion("place", name, &place, &error))?;
    let paths = match listed {
        Some(mut paths) => {
            paths.retain(|path| is_table(path));
            paths
        }
        None => vec![place.clone()],
    };
    if paths.is_empty() {
        let message = format!("the folder {} holds no table", place.display());
        return Err(Refusal::new("F130", message, "put one table (.csv) for each run into it"));
    }
    if paths.len() > MOST_RECORDS {
        let message = format!("the folder {} holds {} tables, more than {MOST_RECORDS}", place.display(), paths.len());
        return Err(Refusal::new("F130", message, "put the tables of one test into a folder of their own"));
    }
    let mut room = LONGEST;
    let own = name;
    let mut file = |path: &PathBuf| {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let bytes = files.read_at_most(path, room).map_err(|error| Refusal::companion("place", own, path, &error))?;
        room -= bytes.len() as u64;
        Ok(RecordFile { name, bytes })
    };
    paths.iter().map(&mut file).collect()
}

fn is_table(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    ending.is_some_and(|ending| ["csv", "txt", "tsv", "parquet"].contains(&ending.as_str()))
}

/// The bytes of a file that somebody wrote by hand, in UTF-8 where it was UTF-16.
fn text(key: &str, name: &str, path: &Path, files: &dyn Files) -> Result<Vec<u8>, Refusal> {
    let bytes = files.read_at_most(path, LONGEST_TEXT).map_err(|error| Refusal::companion(key, name, path, &error))?;
    Ok(bridge::as_utf8(bytes))
}

/// The same of the file that a command is given. What is longer is cut: its first bytes tell what it is in the place of a bridge file.
pub(crate) fn main_text(path: &Path, files: &dyn Files) -> Result<Vec<u8>, Refusal> {
    let bytes = files.head(path, LONGEST_TEXT + 2).map_err(|error| Refusal::unreadable(path, &error))?;
    Ok(bridge::as_utf8(bytes))
}

fn beside(path: &Path, name: &str) -> PathBuf {
    path.parent().unwrap_or(Path::new("")).join(name)
}

fn packing(particles: &mut Particles, path: &Path, files: &dyn Files) -> Result<(), Refusal> {
    let Some(name) = &particles.file else { return Ok(()) };
    let path = beside(path, name);
    let bytes = files.read(&path).map_err(|error| Refusal::companion("file", name, &path, &error))?;
    particles.grains = packing_file::read(&bytes).map_err(|error| {
        let message = format!("cannot use the packing {}: {error}", path.display());
        Refusal::new("F120", message, "take packing.csv of an earlier run, or remove `file` from [particles]")
    })?;
    Ok(())
}

fn take_train(train: &mut train::Train, path: &Path, files: &dyn Files) -> Result<(), Refusal> {
    let Some(name) = &train.file else { return Ok(()) };
    let path = beside(path, name);
    let text = text("file", name, &path, files)?;
    let unusable = |why: String| {
        let message = format!("cannot use the train {}: {why}", path.display());
        Refusal::new("F121", message, "write [[vehicle]] tables (.toml), or axle_load_t,distance_m (.csv)")
    };
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv")) {
        let vehicles = train::read_csv(&String::from_utf8_lossy(&text));
        train.vehicles = vehicles.map_err(|wrong| unusable(wrong.join("; ")))?;
        return Ok(());
    }
    let read = train::read_toml(&text);
    let errors = read.diagnostics.iter().filter(|finding| finding.severity == Severity::Error);
    let said: Vec<String> = errors
        .map(|finding| {
            let line = bridge::text::position(&text, finding.range.start).line;
            let help = finding.help.as_ref().map_or(String::new(), |help| format!(": {help}"));
            format!("line {line}: {} ({}){help}", finding.message, finding.code)
        })
        .collect();
    train.vehicles = read.vehicles.ok_or_else(|| unusable(said.join("; ")))?;
    Ok(())
}

fn vehicles(sweep: &mut SweepPlan, path: &Path, files: &dyn Files) -> Result<(), Refusal> {
    let rule = sweep.rule_file.iter().map(|name| ("rule_file", name));
    for (key, name) in rule.chain(sweep.vehicle_files.iter().map(|name| ("vehicle_files", name))) {
        let path = beside(path, name);
        let text = String::from_utf8_lossy(&text(key, name, &path, files)?).into_owned();
        sweep.texts.push((path.display().to_string(), text));
    }
    Ok(())
}
