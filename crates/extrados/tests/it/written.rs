//! Results are written and read back: every number to its last bit.

use extrados::bridge::Method;
use extrados::bridge::update::Search;
use extrados::results::study::Study;
use extrados::shelf::Unkept;
use extrados::{
    AssessOptions, Choice, CollapseOptions, Disk, Means, Project, RespondOptions, StageName, SweepOptions, Swept,
    Unwatched, UpdateOptions, VaryOptions, assess, collapse, respond, settings, sweep, update, vary,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

fn example(name: &str) -> Project {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
    Project::read(format!("{root}{name}"), &Disk).expect("an example")
}

/// Written as JSON and read back.
fn read_back<T: Serialize + DeserializeOwned + PartialEq + Debug>(result: &T) {
    let text = serde_json::to_string(result).expect("a result is written");
    let again: T = serde_json::from_str(&text).expect("a result is read");
    assert!(again == *result, "{}", &text[..text.len().min(2000)]);
}

#[test]
fn a_collapse_by_every_method_is_read_back() {
    for (file, method) in [
        ("bridgemill/case-1.toml", Method::Dem),
        ("bridgemill/case-1.toml", Method::Limit),
        ("bridgemill/case-1.toml", Method::Fe),
        ("semicircle/ring.toml", Method::Limit),
        ("settlement/bridge.toml", Method::Limit),
    ] {
        let choice = Choice { method: Some(method), ..Choice::default() };
        let found = collapse(&example(file), &CollapseOptions { choice, resume: None }, &mut Unwatched);
        read_back(&found.expect("an analysis"));
    }
}

#[test]
fn sweeps_and_studies_are_read_back() {
    let tiny = example("tiny/bridge.toml");
    match sweep(&tiny, &SweepOptions::default(), &mut Unwatched).expect("a sweep") {
        Swept::Loads(found) => read_back(&found),
        Swept::Vehicles(found) => read_back(&*found),
    }
    let ranges = settings(&tiny, &["joint.friction_angle=30deg..40deg:3"]).expect("a range");
    let study = vary(&tiny, &ranges, &VaryOptions::default(), &Means::default(), &mut Unwatched).expect("a study");
    read_back::<Option<Study>>(&study.study);
}

#[test]
fn a_passage_and_an_update_are_read_back() {
    let found = respond(&super::project("few.toml"), &RespondOptions::default(), &mut Unwatched);
    read_back(&found.expect("a passage"));
    let options = UpdateOptions { search: Some(Search::Gradient), ..UpdateOptions::default() };
    let means = Means { shelf: &Unkept, ..Means::default() };
    let found = update(&example("railway-arch/update.toml"), &options, &means, &mut Unwatched);
    read_back(&found.expect("an update"));
}

#[test]
fn an_assessment_is_read_back() {
    let options = AssessOptions { skip: vec![StageName::Vehicles, StageName::Sensitivity], ..AssessOptions::default() };
    let done = assess(&example("bridgemill/assess.toml"), &options, &Means::default(), &mut Unwatched);
    read_back(&done.expect("an assessment").expect("nobody stopped it").assessment);
}
