//! Results replace nothing but what the command made: inputs, files of somebody else and answers of other runs are kept.

use crate::stage::Stage;
use serde_json::Value;
use std::fs;

/// Runs; the exit code, the code and the message of the first error.
fn refused(stage: &Stage, words: &[&str]) -> (Option<i32>, String, String) {
    let (answer, ending) = stage.object(words);
    let text = |key: &str| answer["errors"][0][key].as_str().unwrap_or_default().to_owned();
    (ending.code, text("code"), text("message"))
}

fn done(stage: &Stage, words: &[&str]) -> Value {
    let (answer, ending) = stage.object(words);
    assert_eq!(ending.code, Some(0), "{words:?}: {}", ending.stderr);
    answer
}

#[test]
fn a_file_that_the_command_did_not_make_is_refused_by_name_before_the_run() {
    let stage = Stage::with_example("keeping-foreign", "tiny");
    let run = ["collapse", "bridge/bridge.toml", "--method", "limit", "--out", "bridge"];
    stage.write("bridge/model.dxf", "the engineer's own survey");
    let (code, error, message) = refused(&stage, &run);
    assert_eq!((code, error.as_str()), (Some(2), "F123"), "{message}");
    assert!(message.contains("model.dxf") && !message.contains("bridge.toml"), "{message}");
    assert_eq!(stage.read("bridge/model.dxf"), "the engineer's own survey");
    assert_eq!(stage.names("bridge"), ["bridge.toml", "model.dxf"], "nothing was written");

    fs::rename(stage.folder.join("bridge/model.dxf"), stage.folder.join("bridge/survey.dxf")).expect("moved");
    done(&stage, &run);
    let made = stage.read("bridge/model.dxf");
    assert!(made.contains("SECTION") && stage.read("bridge/survey.dxf") == "the engineer's own survey");
    done(&stage, &run);
    assert_eq!(stage.read("bridge/model.dxf"), made, "its own files are made anew");

    stage.write("bridge/model.dxf", "drawn over by hand");
    let (code, error, message) = refused(&stage, &run);
    assert_eq!((code, error.as_str()), (Some(2), "F123"));
    assert!(message.contains("model.dxf (changed since it was made)"), "{message}");
    assert_eq!(stage.read("bridge/model.dxf"), "drawn over by hand");
}

#[test]
fn an_input_is_never_replaced() {
    let stage = Stage::with_example("keeping-input", "drawing");
    let text = stage.read("bridge/bridge.toml");
    fs::rename(stage.folder.join("bridge/arch.dxf"), stage.folder.join("bridge/model.dxf")).expect("renamed");
    stage.write("bridge/bridge.toml", text.replace("arch.dxf", "model.dxf"));
    let drawing = stage.read("bridge/model.dxf");
    let run = ["collapse", "bridge/bridge.toml", "--method", "limit", "--out", "bridge"];
    let (code, error, message) = refused(&stage, &run);
    assert_eq!((code, error.as_str()), (Some(2), "F122"), "{message}");
    assert_eq!(stage.read("bridge/model.dxf"), drawing);
    // A table of records among the results of the file that names it.
    let stage = Stage::with_example("keeping-record", "railway-arch");
    let text = stage.read("bridge/update.toml");
    let (head, records) = text.split_once("\n[records]\n").expect("the file has records");
    let line = records.lines().find(|line| line.starts_with("place")).expect("records have a place");
    stage.write(
        "bridge/update.toml",
        format!("{head}\n[records]\n{}", records.replacen(line, "place = \"histories.csv\"", 1)),
    );
    stage.write("bridge/histories.csv", "time_s,a_mm\n0,0\n");
    let (code, error, message) = refused(&stage, &["update", "bridge/update.toml", "--out", "bridge"]);
    assert_eq!((code, error.as_str()), (Some(2), "F122"), "{message}");
    assert!(message.contains("histories.csv"), "{message}");
    assert_eq!(stage.read("bridge/histories.csv"), "time_s,a_mm\n0,0\n");
}

/// Where an answer says that another one was moved.
fn kept_in(answer: &Value) -> Option<String> {
    let warnings = answer["warnings"].as_array().expect("a list");
    let message = warnings.iter().find(|one| one["code"] == "F125")?["message"].as_str()?;
    Some(message.rsplit_once("they are kept in ")?.1.to_owned())
}

#[test]
fn answers_of_other_runs_are_kept() {
    let stage = Stage::with_example("keeping-earlier", "tiny");
    let file = "bridge/bridge.toml";
    done(&stage, &["collapse", file, "--method", "limit"]);
    let mechanism = stage.read("out/bridge/mechanism.svg");
    let swept = done(&stage, &["collapse", file, "--sweep"]);
    let place = kept_in(&swept).expect("the place is told");
    assert_eq!(stage.read(&format!("{place}/mechanism.svg")), mechanism);
    let kept: Value = serde_json::from_str(&stage.read(&format!("{place}/result.json"))).expect("whole");
    assert_eq!(kept["schema"], "extrados.collapse/1");
    let again = done(&stage, &["collapse", file, "--sweep"]);
    assert!(kept_in(&again).is_none(), "the same run replaces its own answer: {again}");
    assert_eq!(stage.read(&format!("{place}/mechanism.svg")), mechanism);

    let vary = [
        "vary",
        file,
        "--method",
        "limit",
        "--set",
        "cover[1].thickness=0.2m,0.4m",
        "--set",
        "joint.friction_angle=30deg,40deg",
    ];
    done(&stage, &vary);
    let tornado = stage.read("out/bridge-vary/tornado.svg");
    let grid: Vec<&str> = vary.iter().copied().chain(["--grid"]).collect();
    let place = kept_in(&done(&stage, &grid)).expect("the place is told");
    assert_eq!(stage.read(&format!("{place}/tornado.svg")), tornado);
}

#[test]
fn files_of_one_name_do_not_take_one_anothers_results() {
    let stage = Stage::with_example("keeping-names", "tiny");
    fs::create_dir_all(stage.folder.join("other")).expect("a folder");
    let text = stage.read("bridge/bridge.toml");
    stage.write("other/bridge.toml", format!("{text}\n# another bridge\n"));
    done(&stage, &["collapse", "bridge/bridge.toml", "--method", "limit"]);
    let first = stage.read("out/bridge/result.json");
    let ending = stage.run(&["collapse", "other/bridge.toml", "--method", "limit"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!(ending.stderr.contains("they are kept in out/bridge/earlier"), "{}", ending.stderr);
    assert_eq!(stage.read("out/bridge/earlier/collapse-load-limit/result.json"), first);
}

#[test]
fn a_checkpoint_stays_until_the_results_stand() {
    let stage = Stage::with_example("keeping-checkpoint", "bridgemill");
    fs::create_dir_all(stage.folder.join("o")).expect("a folder");
    stage.write("o/paraview", "a file where a folder must come: results cannot be written");
    let run = ["collapse", "bridge/case-1.toml", "--out", "o", "--keep-every", "0", "--quiet"];
    let (code, error, message) = refused(&stage, &run);
    assert_eq!((code, error.as_str()), (Some(3), "F109"), "{message}");
    assert!(stage.names("o").contains(&"run.checkpoint".to_owned()), "{:?}", stage.names("o"));
    fs::remove_file(stage.folder.join("o/paraview")).expect("removed");
    let again: Vec<&str> = run.iter().copied().chain(["--resume"]).collect();
    done(&stage, &again);
    assert!(!stage.names("o").contains(&"run.checkpoint".to_owned()), "a finished run needs no checkpoint");
}

/// A checkpoint that another version of the program kept is not taken up, and a run that starts anew does not write over it.
#[test]
fn a_checkpoint_of_another_version_is_refused_and_stays() {
    let stage = Stage::with_example("keeping-version", "bridgemill");
    fs::create_dir_all(stage.folder.join("o")).expect("a folder");
    stage.write("o/paraview", "a file where a folder must come: results cannot be written");
    let run = ["collapse", "bridge/case-1.toml", "--out", "o", "--keep-every", "0", "--quiet"];
    assert_eq!(refused(&stage, &run).1, "F109");
    let path = stage.folder.join("o/run.checkpoint");
    let mut older = fs::read(&path).expect("a checkpoint");
    older[8] -= 1;
    fs::write(&path, &older).expect("written");
    fs::remove_file(stage.folder.join("o/paraview")).expect("removed");
    let (code, error, message) = refused(&stage, &[&run[..], &["--resume"]].concat());
    assert_eq!((code, error.as_str()), (Some(2), "F110"), "{message}");
    assert!(message.contains("another version of this program"), "{message}");
    assert_eq!(fs::read(&path).expect("it stays"), older);
    done(&stage, &run);
    let aside: Vec<String> = stage.names("o").into_iter().filter(|name| name.starts_with("run-")).collect();
    assert_eq!(aside.len(), 1, "{aside:?}");
    assert_eq!(fs::read(stage.folder.join("o").join(&aside[0])).expect("it is kept"), older);
}

#[test]
fn a_checkpoint_of_another_run_is_set_aside_and_found_again() {
    let stage = Stage::with_example("keeping-aside", "bridgemill");
    fs::create_dir_all(stage.folder.join("o")).expect("a folder");
    stage.write("o/paraview", "a file where a folder must come: results cannot be written");
    let run = |file, more: &[&str]| {
        let words = ["collapse", file, "--out", "o", "--keep-every", "0", "--quiet"];
        stage.object(&words.iter().copied().chain(more.iter().copied()).collect::<Vec<_>>())
    };
    assert_eq!(run("bridge/case-1.toml", &[]).1.code, Some(3));
    fs::remove_file(stage.folder.join("o/paraview")).expect("removed");
    let (second, ending) = run("bridge/case-2.toml", &[]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert!(second["warnings"].as_array().is_some_and(|all| all.iter().any(|one| one["code"] == "F110")), "{second}");
    let (first, ending) = run("bridge/case-1.toml", &["--resume"]);
    assert_eq!((ending.code, first["status"].as_str()), (Some(0), Some("collapsed")), "{}", ending.stderr);
    let found = |one: &Value| one["code"] == "F110";
    assert!(!first["warnings"].as_array().is_some_and(|all| all.iter().any(found)), "it was taken up: {first}");
    stage.write("o/run.checkpoint", "somebody's notes");
    let (answer, ending) = run("bridge/case-1.toml", &[]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F123")));
    assert_eq!(stage.read("o/run.checkpoint"), "somebody's notes");
}
