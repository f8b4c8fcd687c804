//! `extrados merge`: the shards of a command put together, as if it had run alone.

use super::answer::refused;
use super::obey;
use crate::args::{Arguments, Command};
use crate::desk::Desk;
use crate::program;
use crate::report::Report;
use crate::shards::{Merged, Portion, Sharing};
use crate::status::Status;
use clap::Parser;
use extrados::Refusal;
use extrados::shard::Shard;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Checks that the shards are all there and belong together, then lets their command find every piece finished.
pub(super) fn run(desk: &mut Desk, dirs: &[PathBuf], whole: &Path) -> Result<Report, Refusal> {
    let shards = match gathered(dirs) {
        Ok(shards) => shards,
        Err(refusals) => return Ok(refused(desk, Report::new(Status::UnusableInput), refusals)),
    };
    let first = &shards[0].1;
    let (identity, words) = (first.identity.clone(), first.words.clone());
    let own = Arguments::try_parse_from(&words).map_err(|_| not_a_shard(&shards[0].0))?;
    desk.schema = format!("extrados.{}/1", first.command());
    let mut command = own.command;
    let (sharing, out) = part_of(&mut command).ok_or_else(|| not_a_shard(&shards[0].0))?;
    *sharing = Sharing { shard: None, merged: Some(Merged { identity, shards }) };
    *out = Some(whole.to_owned());
    desk.words = words;
    obey(desk, &command)
}

/// Where a command that can be shared says how, and where its results go.
fn part_of(command: &mut Command) -> Option<(&mut Sharing, &mut Option<PathBuf>)> {
    match command {
        Command::Vary(own) => Some((&mut own.sharing, &mut own.out)),
        Command::Validate(own) => Some((&mut own.sharing, &mut own.out)),
        Command::Assess(own) => Some((&mut own.sharing, &mut own.out)),
        _ => None,
    }
}

/// Every shard, or everything that is wrong with them.
fn gathered(dirs: &[PathBuf]) -> Result<Vec<(PathBuf, Portion)>, Vec<Refusal>> {
    let mut refusals = Vec::new();
    let mut shards = Vec::new();
    for dir in dirs {
        match Portion::read(dir).and_then(|portion| Some((portion.shard.parse().ok()?, portion))) {
            Some((part, portion)) => shards.push((dir, part, portion)),
            None => refusals.push(not_a_shard(dir)),
        }
    }
    for (dir, part, portion) in &shards {
        refusals.extend(damaged(dir, portion));
        refusals.extend(stranger(dir, *part, portion, &shards[0]));
    }
    refusals.extend(counted(&shards));
    if refusals.is_empty() {
        Ok(shards.into_iter().map(|(dir, _, portion)| (dir.clone(), portion)).collect())
    } else {
        Err(refusals)
    }
}

/// A folder without a finished shard.
fn not_a_shard(dir: &Path) -> Refusal {
    let message = format!("{} holds no finished shard", dir.display());
    Refusal::new("F142", message, "run its command with --shard I/N again: it goes on where it was")
}

/// A shard of which something is missing.
fn damaged(dir: &Path, portion: &Portion) -> Option<Refusal> {
    let names = portion.damaged(dir);
    let first = names.first()?;
    let message = format!(
        "{}: {} of {} pieces are missing or damaged, such as {first}",
        dir.display(),
        names.len(),
        portion.pieces.len()
    );
    Some(Refusal::new("F142", message, "run its command with --shard I/N again: it makes what is missing"))
}

/// A shard of another work than the first.
fn stranger(dir: &Path, part: Shard, own: &Portion, first: &(&PathBuf, Shard, Portion)) -> Option<Refusal> {
    let (first_dir, first_part, of_first) = first;
    let (words, first_words) = (own.words.join(" "), of_first.words.join(" "));
    let what = if own.program != program::hash() {
        "was made by another build of the program, which may compute other bits".to_owned()
    } else if own.command() != of_first.command() {
        format!("is of `{}`, and {} of `{}`", own.command(), first_dir.display(), of_first.command())
    } else if part.of() != first_part.of() {
        format!("is one of {} shards, and {} one of {}", part.of(), first_dir.display(), first_part.of())
    } else if own.identity != of_first.identity {
        format!("is of another bridge or of other settings than {}: `{words}` and `{first_words}`", first_dir.display())
    } else {
        return None;
    };
    let message = format!("{} {what}", dir.display());
    Some(Refusal::new("F143", message, "merge the shards of one command, made by one build, from unchanged files"))
}

/// Shards that are missing, and shards that are there twice.
fn counted(shards: &[(&PathBuf, Shard, Portion)]) -> Vec<Refusal> {
    let Some((_, first, _)) = shards.first() else { return Vec::new() };
    let mut folders: BTreeMap<usize, Vec<String>> = (1..=first.of()).map(|number| (number, Vec::new())).collect();
    for (dir, part, _) in shards.iter().filter(|(_, part, _)| part.of() == first.of()) {
        folders.entry(part.number()).or_default().push(dir.display().to_string());
    }
    let named = |number: &usize| format!("{number}/{}", first.of());
    let missing: Vec<String> =
        folders.iter().filter(|(_, dirs)| dirs.is_empty()).map(|(number, _)| named(number)).collect();
    let mut refusals = Vec::new();
    if !missing.is_empty() {
        let message = format!("shards are missing: {}", missing.join(", "));
        refusals.push(Refusal::new("F144", message, "run the command with each of them, and name their folders too"));
    }
    for (number, dirs) in folders.iter().filter(|(_, dirs)| dirs.len() > 1) {
        let message = format!("shard {} is there more than once: {}", named(number), dirs.join(", "));
        refusals.push(Refusal::new("F144", message, "name one folder for each shard"));
    }
    refusals
}
