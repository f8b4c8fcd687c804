//! `--shard` and `merge`: parts of a command, made apart, give the results of the whole, and parts that do not belong together are named.

use crate::stage::Stage;
use serde_json::Value;
use std::fs;
use std::path::Path;

const FILE: &str = "bridge/vary.toml";
const VARY: [&str; 5] = ["vary", FILE, "--method", "limit", "--quiet"];

fn stage(name: &str) -> Stage {
    Stage::with_example(&format!("shards-{name}"), "bridgemill")
}

/// Runs a command that must come to its end.
fn done(stage: &Stage, words: &[&str]) -> Value {
    let (answer, ending) = stage.object(words);
    assert_eq!(ending.code, Some(0), "{words:?}: {}", ending.stderr);
    answer
}

/// The shards of a command, each into a folder of its own; their folders.
fn shards(stage: &Stage, words: &[&str], of: usize) -> Vec<String> {
    (1..=of)
        .map(|number| {
            let (shard, out) = (format!("{number}/{of}"), format!("part-{number}"));
            let answer = done(stage, &[words, &["--shard", &shard, "--out", &out]].concat());
            assert_eq!(answer["schema"], "extrados.shard/1");
            assert_eq!(answer["shard"], shard.as_str());
            out
        })
        .collect()
}

/// Puts them together.
fn merged(stage: &Stage, dirs: &[String], out: &str) -> Value {
    let dirs: Vec<&str> = dirs.iter().map(String::as_str).collect();
    done(stage, &[&["merge"], &dirs[..], &["--out", out]].concat())
}

/// Errors of shards that cannot be put together: code and message.
fn refused(stage: &Stage, dirs: &[&str]) -> Vec<(String, String)> {
    let (answer, ending) = stage.object(&[&["merge"], dirs, &["--out", "never"]].concat());
    assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")), "{}", ending.stderr);
    assert!(stage.names("never").is_empty(), "nothing is written");
    let word = |error: &Value, key: &str| error[key].as_str().unwrap_or_default().to_owned();
    answer["errors"].as_array().expect("errors").iter().map(|one| (word(one, "code"), word(one, "message"))).collect()
}

/// Everything but times, places, and where answers came from.
fn timeless(value: &Value) -> Value {
    match value {
        Value::Object(fields) => {
            let left_out = ["wall_seconds", "threads", "out", "seconds", "cached", "runs_from_cache", "state"];
            let kept = fields.iter().filter(|(key, _)| !left_out.contains(&key.as_str()));
            Value::Object(kept.map(|(key, value)| (key.clone(), timeless(value))).collect())
        }
        Value::Array(all) => Value::Array(all.iter().map(timeless).collect()),
        other => other.clone(),
    }
}

/// Bytes of every file of results but those that tell times.
fn bytes(stage: &Stage, folder: &str) -> Vec<(String, Vec<u8>)> {
    let names = stage.names(folder).into_iter();
    let names = names.filter(|name| [".csv", ".svg", ".png"].iter().any(|ending| name.ends_with(ending)));
    names.map(|name| (name.clone(), fs::read(stage.folder.join(folder).join(name)).expect("a file"))).collect()
}

#[test]
fn shards_of_a_study_give_the_bytes_of_the_whole() {
    let stage = stage("whole");
    let whole = done(&stage, &[&VARY[..], &["--out", "whole"]].concat());
    let dirs = shards(&stage, &VARY, 3);
    let made: Vec<usize> = dirs.iter().map(|dir| stage.names(&format!("{dir}/cache")).len()).collect();
    assert_eq!(
        made.iter().sum::<usize>(),
        stage.names("whole/cache").len(),
        "{made:?}: nothing twice, nothing left out"
    );
    assert!(made.iter().all(|count| (5..=6).contains(count)), "{made:?}");
    // In any order.
    let backwards: Vec<String> = dirs.iter().rev().cloned().collect();
    let found = merged(&stage, &backwards, "merged");
    assert_eq!(found["schema"], "extrados.vary/1");
    assert_eq!(found["runs_from_cache"], found["runs"], "nothing is computed again");
    assert_eq!(timeless(&found), timeless(&whole));
    let (whole, found) = (bytes(&stage, "whole"), bytes(&stage, "merged"));
    assert!(whole.iter().any(|(name, _)| name == "vary.csv") && whole.iter().any(|(name, _)| name == "tornado.svg"));
    assert_eq!(found, whole);
    // Once more into the same folder.
    assert_eq!(timeless(&merged(&stage, &dirs, "merged")), timeless(&merged(&stage, &dirs, "merged-again")));
}

#[test]
fn a_shard_that_was_killed_goes_on_and_one_that_is_finished_computes_nothing() {
    let stage = stage("killed");
    let long = ["vary", FILE, "--set", "joint.normal_stiffness=x0.5..x2:5", "--threads", "1", "--quiet"];
    let first = [&long[..], &["--shard", "1/2", "--out", "part-1"]].concat();
    let runs = || stage.names("part-1/cache").iter().filter(|name| name.ends_with(".json")).count();
    let mut running = stage.start(&first);
    running.wait_for("a finished run", || runs() >= 1);
    running.kill();
    assert_eq!(stage.names("part-1"), ["cache"], "no half-written results");
    let kept = runs() as u64;
    assert!(kept < 3, "it was killed before its end");
    done(&stage, &[&long[..], &["--shard", "2/2", "--out", "part-2"]].concat());
    let told = refused(&stage, &["part-1", "part-2"]);
    let [(unfinished, of_first), (missing, list)] = &told[..] else { panic!("{told:?}") };
    assert_eq!((unfinished.as_str(), of_first.as_str()), ("F142", "part-1 holds no finished shard"));
    assert_eq!((missing.as_str(), list.as_str()), ("F144", "shards are missing: 1/2"));
    assert!(done(&stage, &first)["runs_from_cache"].as_u64().is_some_and(|count| count >= kept));
    assert_eq!(done(&stage, &first)["runs_from_cache"], 3);
    let found = merged(&stage, &["part-1".to_owned(), "part-2".to_owned()], "merged");
    let whole = done(&stage, &[&long[..], &["--out", "whole"]].concat());
    assert_eq!(timeless(&found), timeless(&whole));
    assert_eq!(bytes(&stage, "merged"), bytes(&stage, "whole"));
}

#[test]
fn shards_that_do_not_belong_together_are_named_all_at_once() {
    let stage = stage("strangers");
    let part = |words: &[&str], shard: &str, out: &str| {
        done(&stage, &[&VARY[..], words, &["--shard", shard, "--out", out]].concat());
    };
    part(&[], "1/3", "one");
    part(&[], "1/3", "again");
    part(&[], "2/4", "of-four");
    part(&["--tolerance", "1e-7"], "2/3", "other-settings");
    let text = stage.read(FILE);
    stage.write(FILE, text.replace("\"2.85 m\"", "\"2.86 m\""));
    part(&[], "3/3", "other-bridge");
    stage.write(FILE, &text);
    fs::create_dir(stage.folder.join("empty")).expect("a folder");
    let name = stage.names("again/cache").remove(0);
    stage.write(&format!("again/cache/{name}"), "half");
    let told = refused(&stage, &["one", "again", "of-four", "other-settings", "other-bridge", "empty", "nowhere"]);
    let expected = [
        ("F142", "empty holds no finished shard".to_owned()),
        ("F142", "nowhere holds no finished shard".to_owned()),
        ("F142", format!("again: 1 of 6 pieces are missing or damaged, such as cache/{name}")),
        ("F143", "of-four is one of 4 shards, and one one of 3".to_owned()),
        ("F143", "other-settings is of another bridge or of other settings than one".to_owned()),
        ("F143", "other-bridge is of another bridge or of other settings than one".to_owned()),
        ("F144", "shard 1/3 is there more than once: one, again".to_owned()),
    ];
    assert_eq!(told.len(), expected.len(), "{told:#?}");
    for ((code, message), (wanted, words)) in told.iter().zip(&expected) {
        assert!(code == wanted && message.starts_with(words.as_str()), "{code} {message}, not {wanted} {words}");
    }
    // A file that changed after its shards were made.
    part(&[], "1/1", "alone");
    stage.write(FILE, text.replace("\"2.85 m\"", "\"2.86 m\""));
    let told = refused(&stage, &["alone"]);
    assert_eq!(told[0].0, "F145", "{told:?}");
    // What is no shard number, and what cannot be cut.
    for wrong in ["0/3", "4/3", "1", "a/b"] {
        let (answer, ending) = stage.object(&[&VARY[..], &["--shard", wrong]].concat());
        assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F107")), "{wrong}");
    }
    let (answer, _) = stage.object(&["assess", FILE, "--shard", "1/2"]);
    assert_eq!(answer["errors"][0]["code"], "F146");
}

#[test]
fn shards_of_field_tests_give_the_table_of_the_whole() {
    let stage = Stage::new("shards-validate");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation").display().to_string();
    let words = ["validate", &root, "--only", "prestwood,bridgemill", "--methods", "weight,pressure", "--quiet"];
    let whole = done(&stage, &[&words[..], &["--out", "whole"]].concat());
    let dirs = shards(&stage, &words, 2);
    let found = merged(&stage, &dirs, "merged");
    assert_eq!(timeless(&found["statistics"]), timeless(&whole["statistics"]));
    assert_eq!(timeless(&found["tests"]), timeless(&whole["tests"]));
    // The last column tells times.
    let table = |folder: &str| -> Vec<String> {
        let text = stage.read(&format!("{folder}/validation.csv"));
        text.lines().map(|line| line.rsplit_once(',').map_or(line, |(row, _)| row).to_owned()).collect()
    };
    assert_eq!(table("merged"), table("whole"));
    assert_eq!(stage.read("merged/validation.svg"), stage.read("whole/validation.svg"));
}

#[test]
fn shards_of_a_folder_of_bridges_give_its_table() {
    let stage = Stage::with_example("shards-fleet", "prestwood");
    let text = stage.read("bridge/limit.toml");
    fs::create_dir(stage.folder.join("fleet")).expect("a folder");
    for k in 1..=3 {
        let own = text.replacen("friction_angle = \"35 deg\"", &format!("friction_angle = \"3{k} deg\""), 1);
        stage.write(&format!("fleet/bridge-{k}.toml"), own);
    }
    stage.write("fleet/poisoned.toml", text.replacen(" m\"", " GPa\"", 1));
    let skip = ["service", "vehicles", "cases", "support-movement", "sensitivity"];
    let words: Vec<&str> =
        ["assess", "fleet", "--quiet"].into_iter().chain(skip.iter().flat_map(|one| ["--skip", one])).collect();
    let run = |words: &[&str]| {
        let (answer, ending) = stage.object(words);
        assert!(ending.code.is_some_and(|code| code == 0 || code == 1 || code == 3), "{}", ending.stderr);
        answer
    };
    let whole = run(&[&words[..], &["--out", "whole"]].concat());
    let dirs = shards(&stage, &words, 2);
    let found = run(&["merge", &dirs[0], &dirs[1], "--out", "merged"]);
    assert_eq!(found["schema"], "extrados.fleet/1");
    assert_eq!(found["bridges"], 4);
    assert_eq!(timeless(&found), timeless(&whole));
    assert_eq!(stage.read("merged/fleet.csv"), stage.read("whole/fleet.csv"));
    for k in 1..=3 {
        let result = |folder: &str| -> Value {
            let text = stage.read(&format!("{folder}/bridge-{k}/result.json"));
            serde_json::from_str(&text).expect("an object")
        };
        assert_eq!(timeless(&result("merged")), timeless(&result("whole")));
        let stages = result("merged")["stages"].as_array().expect("stages").clone();
        let states: Vec<&str> = stages.iter().filter_map(|one| one["state"].as_str()).collect();
        assert!(states.contains(&"taken from an earlier run") && !states.contains(&"made"), "{states:?}");
    }
    stage.write("fleet/bridge-2.toml", text);
    let told = refused(&stage, &[&dirs[0], &dirs[1]]);
    assert!(told[0].0 == "F145" && told[0].1.ends_with(": bridge-2.toml"), "{told:?}");
}
