//! `extrados validate`: every field test predicted by every method from one set of prior values.

use crate::args::Validate;
use crate::desk::Desk;
use crate::failure;
use crate::folder::{Folder, Purpose};
use crate::program;
use crate::report::Report;
use crate::results::{self, Written};
use crate::shards;
use crate::shelf::{self, FolderShelf, Resume};
use crate::status::Status;
use crate::summary;
use crate::watcher::{self, silent};
use extrados::shard::Shard;
use extrados::{Looking, Means, Refusal};
use outcome::published;
use outcome::validation::{Predictor, Validation};
use rayon::prelude::*;
use serde_json::json;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use verification::validation::{Answer, Corpus, CorpusError, Job, gather, jobs, predict};

/// Methods where none is named: particles take hours.
const METHODS: [Predictor; 5] =
    [Predictor::Weight, Predictor::Pressure, Predictor::Continuum, Predictor::Path, Predictor::Movement];

/// Reads all tests, predicts them, writes table, figure and statistics.
pub(super) fn run(desk: &mut Desk, arguments: &Validate) -> Result<Report, Refusal> {
    let methods: Vec<Predictor> = match arguments.methods.as_slice() {
        [] => METHODS.to_vec(),
        named => Predictor::ALL.iter().copied().filter(|one| named.contains(one)).collect(),
    };
    let corpus = Corpus::read(&arguments.folder, &arguments.only).map_err(unusable)?;
    let shard = arguments.sharing.shard;
    let whole = || shards::folder_of(PathBuf::from("out").join("validate"), shard);
    let out = arguments.out.clone().unwrap_or_else(whole);
    let folder = Folder::prepare(&out, purpose(&arguments.folder, &corpus, shard))?;
    let shelf = FolderShelf::new(&folder, Resume::No);
    let means = Means { shelf: &shelf, program: &program::hash(), ..Means::default() };
    let jobs = jobs(&corpus, &methods);
    let keys: Vec<String> = jobs.iter().map(|job| key(&means, &corpus, job)).collect();
    let identity = means.key("validation", &(&keys, &corpus));
    if let Some(merged) = &arguments.sharing.merged {
        merged.bring(&identity, &folder)?;
    }
    let all: Vec<(&Job, &String)> = jobs.iter().zip(&keys).collect();
    let own: Vec<&(&Job, &String)> = shards::own(&all, shard).collect();
    let bar = watcher::bar(desk.screen.quiet, own.iter().map(|(job, _)| job.effort()).sum());
    let made: Vec<Result<Option<(Job, Answer)>, Refusal>> = own
        .par_iter()
        .map(|(job, key)| {
            let answer = answered(&means, &corpus, job, key)
                .map_err(|error| failure::not_written(&shelf.runs(), &error))
                .map(|answer| Some((**job, answer?)));
            watcher::counted_by(&bar, job.effort(), &corpus.tests[job.test].name);
            answer
        })
        .collect();
    bar.finish_and_clear();
    let made: Vec<Option<(Job, Answer)>> = made.into_iter().collect::<Result<_, Refusal>>()?;
    let Some(answers) = made.into_iter().collect::<Option<Vec<(Job, Answer)>>>() else {
        return Ok(Report::new(Status::Cancelled).saying(shards::INTERRUPTED));
    };
    if let Some(shard) = shard {
        let files = own.iter().map(|(_, key)| shelf::file(key)).collect();
        let report = Report::new(Status::Completed);
        return shards::publish(desk, report, &folder, shard, identity, (BTreeMap::new(), files));
    }
    write(desk, &gather(&corpus, &methods, &answers), &folder, &arguments.folder)
}

/// The name of a prediction on the shelf, after everything that its numbers follow from.
fn key(means: &Means<'_>, corpus: &Corpus, job: &Job) -> String {
    let test = &corpus.tests[job.test];
    format!("runs/{}", means.key("prediction", &(test, &corpus.priors, job.by, job.at, job.seed)))
}

/// A prediction from the shelf, or made and kept; nothing where somebody asked to stop.
fn answered(means: &Means<'_>, corpus: &Corpus, job: &Job, key: &str) -> io::Result<Option<Answer>> {
    if let Some(kept) = means.shelf.find(key).and_then(|bytes| serde_json::from_slice(&bytes).ok()) {
        return Ok(Some(kept));
    }
    if watcher::asked_to_stop() {
        return Ok(None);
    }
    let answer = predict(corpus, job, &mut Looking(&mut silent));
    // One that was stopped on its way is no answer.
    if watcher::asked_to_stop() {
        return Ok(None);
    }
    means.shelf.put(key, &serde_json::to_vec(&answer)?)?;
    Ok(Some(answer))
}

/// What it reads, so that no result replaces it.
fn purpose(root: &Path, corpus: &Corpus, shard: Option<Shard>) -> Purpose {
    let tests =
        corpus.tests.iter().flat_map(|test| ["bridge.toml", "test.toml"].map(|file| root.join(&test.name).join(file)));
    let inputs: Vec<PathBuf> = tests.chain([root.join("priors.toml")]).collect();
    Purpose::new(&shards::kind("validate", shard), root, &inputs)
}

fn unusable(error: CorpusError) -> Refusal {
    let message = error.to_string();
    match error {
        CorpusError::Absent(_) => {
            let help =
                "the tests stand in validation/ of the source: run the command in a clone of it, or name their folder";
            Refusal::new("F131", message, help)
        }
        CorpusError::Wrong { help, .. } => Refusal::new("F132", message, help),
    }
}

fn write(desk: &mut Desk, found: &Validation, folder: &Folder, root: &Path) -> Result<Report, Refusal> {
    let any = found.statistics.iter().any(|one| one.tests > 0);
    let mut report = Report::new(if any { Status::Completed } else { Status::Undetermined });
    report.fields = found.object();
    report.fields.insert("folder".to_owned(), json!(root.display().to_string()));
    report.summary = summary::validation(found, &folder.path().display().to_string());
    let drawings = figures::validation(found).map(|svg| ("validation".to_owned(), svg)).into_iter().collect();
    let table = ("validation.csv", published::validation_table(found));
    let record = published::record(found).map(|record| ("record.json", record));
    let files = [table].into_iter().chain(record);
    let files = files.map(|(name, text)| figures::File { name: name.to_owned(), bytes: text.into_bytes() }).collect();
    results::publish(desk, report, folder, Written { drawings, files })
}
