//! `extrados validate`: every field test predicted by every method from one set of prior values.

use super::Desk;
use crate::args::Validate;
use crate::failure::Failure;
use crate::folder::{Folder, Purpose};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::summary;
use crate::watcher;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::published;
use outcome::validation::{Predictor, Validation};
use rayon::prelude::*;
use serde_json::json;
use std::path::{Path, PathBuf};
use verification::validation::{Answer, Corpus, CorpusError, Job, gather, jobs, predict};

/// Methods where none is named: particles take hours.
const METHODS: [Predictor; 5] =
    [Predictor::Weight, Predictor::Pressure, Predictor::Continuum, Predictor::Path, Predictor::Movement];

/// Reads all tests, predicts them, writes table, figure and statistics.
pub fn run(desk: &mut Desk, arguments: &Validate) -> Result<Report, Failure> {
    let methods: Vec<Predictor> = match arguments.methods.as_slice() {
        [] => METHODS.to_vec(),
        named => Predictor::ALL.iter().copied().filter(|one| named.contains(one)).collect(),
    };
    let corpus = Corpus::read(&arguments.folder, &arguments.only).map_err(unusable)?;
    let out = arguments.out.clone().unwrap_or_else(|| PathBuf::from("out").join("validate"));
    let folder = Folder::prepare(&out, purpose(&arguments.folder, &corpus))?;
    let jobs = jobs(&corpus, &methods);
    let effort = jobs.iter().map(Job::effort).sum();
    let bar = watcher::count(desk.screen.quiet, effort);
    let answers: Vec<Option<(Job, Answer)>> = jobs
        .par_iter()
        .map(|job| {
            let answer = (!watcher::asked_to_stop()).then(|| (*job, predict(&corpus, job, &mut Stops)));
            watcher::counted_by(&bar, job.effort(), &corpus.tests[job.test].name);
            answer
        })
        .collect();
    bar.finish_and_clear();
    if watcher::asked_to_stop() || answers.iter().any(Option::is_none) {
        let words = "interrupted: not every prediction was made, and nothing is written\n";
        return Ok(Report::new(Status::Cancelled).saying(words.to_owned()));
    }
    let answers: Vec<(Job, Answer)> = answers.into_iter().flatten().collect();
    write(desk, &gather(&corpus, &methods, &answers), &folder, &arguments.folder)
}

/// What it reads, so that no result replaces it.
fn purpose(root: &Path, corpus: &Corpus) -> Purpose {
    let tests =
        corpus.tests.iter().flat_map(|test| ["bridge.toml", "test.toml"].map(|file| root.join(&test.name).join(file)));
    let inputs: Vec<PathBuf> = tests.chain([root.join("priors.toml")]).collect();
    Purpose::new("validate", root, &inputs)
}

fn unusable(error: CorpusError) -> Failure {
    let message = error.to_string();
    match error {
        CorpusError::Absent(_) => {
            let help =
                "the tests stand in validation/ of the source: run the command in a clone of it, or name their folder";
            Failure::input("F131", message, help)
        }
        CorpusError::Wrong { help, .. } => Failure::input("F132", message, help),
    }
}

/// Hears Ctrl-C in the middle of a run.
struct Stops;

impl Watch for Stops {
    fn look(&mut self, _: &Progress) -> Wish {
        if watcher::asked_to_stop() { Wish::Stop } else { Wish::GoOn }
    }
}

fn write(desk: &mut Desk, found: &Validation, folder: &Folder, root: &Path) -> Result<Report, Failure> {
    let any = found.statistics.iter().any(|one| one.tests > 0);
    let mut report = Report::new(if any { Status::Completed } else { Status::Undetermined });
    report.fields = published::validation(found);
    report.fields.insert("folder".to_owned(), json!(root.display().to_string()));
    report.summary = summary::validation(found, &folder.path().display().to_string());
    let mut files = figures::validation(found).map_err(|error| results::not_drawn(folder.path(), &error))?;
    let table = published::validation_table(found).into_bytes();
    files.push(figures::File { name: "validation.csv".to_owned(), bytes: table });
    results::publish(desk, report, folder, &files)
}
