//! Interrupted runs end in the numbers of undisturbed ones, and threads change none.

use crate::stage::{Stage, numbers, object};
use serde_json::Value;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A run of some seconds: case 2 at a tolerance far below what its answer needs.
const LONG: [&str; 8] =
    ["collapse", "bridge/case-2.toml", "--tolerance", "1e-8", "--keep-every", "0.05", "--json", "--quiet"];
/// A machine that needs longer than this for a second's work is not going to finish.
const PATIENCE: Duration = Duration::from_secs(120);

fn start(stage: &Stage, more: &[&str]) -> Child {
    let words: Vec<&str> = LONG.iter().chain(more).copied().collect();
    stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// Waits until the checkpoint has been written `times` times, so that the run is well under way.
fn wait_for_checkpoints(stage: &Stage, out: &str, times: usize, child: &mut Child) {
    let path = stage.folder.join(out).join("run.checkpoint");
    let begin = Instant::now();
    let mut seen = Vec::new();
    while seen.len() < times {
        if let Ok(time) = path.metadata().and_then(|data| data.modified())
            && !seen.contains(&time)
        {
            seen.push(time);
        }
        assert!(begin.elapsed() < PATIENCE, "no checkpoint after {PATIENCE:?}");
        assert!(child.try_wait().expect("the child can be asked").is_none(), "the run ended before it was interrupted");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn answer(stage: &Stage, more: &[&str]) -> (Value, Option<i32>) {
    let output = start(stage, more).wait_with_output().expect("it ends");
    (object(&String::from_utf8_lossy(&output.stdout)), output.status.code())
}

#[test]
fn a_killed_run_resumes_to_the_same_numbers() {
    let stage = Stage::with_example("interruption-kill", "bridgemill");
    let (whole, code) = answer(&stage, &["--out", "whole"]);
    assert_eq!(code, Some(0));
    let mut child = start(&stage, &["--out", "torn"]);
    wait_for_checkpoints(&stage, "torn", 5, &mut child);
    child.kill().expect("it is running");
    child.wait().expect("it ends");
    assert_eq!(stage.names("torn"), ["run.checkpoint"], "no half-written results");
    let (resumed, code) = answer(&stage, &["--out", "torn", "--resume"]);
    assert_eq!(code, Some(0));
    assert_eq!(resumed["warnings"], whole["warnings"], "the checkpoint was taken up");
    assert!(resumed["wall_seconds"].as_f64() < whole["wall_seconds"].as_f64().map(|seconds| 3.0 * seconds));
    assert_eq!(numbers(resumed), numbers(whole));
    assert!(!stage.names("torn").contains(&"run.checkpoint".to_owned()), "a finished run needs no checkpoint");
    assert_eq!(stage.read("torn/path.csv"), stage.read("whole/path.csv"));
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_says_so_and_resumes() {
    let stage = Stage::with_example("interruption-signal", "bridgemill");
    let mut child = start(&stage, &["--out", "o"]);
    wait_for_checkpoints(&stage, "o", 3, &mut child);
    let told = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(told.success());
    let output = child.wait_with_output().expect("it ends");
    let cancelled = object(&String::from_utf8_lossy(&output.stdout));
    assert_eq!((output.status.code(), cancelled["status"].as_str()), (Some(130), Some("cancelled")));
    assert_eq!(cancelled["checkpoint"], "o/run.checkpoint");
    assert_eq!(stage.names("o"), ["run.checkpoint"]);
    let (resumed, code) = answer(&stage, &["--out", "o", "--resume"]);
    assert_eq!((code, resumed["status"].as_str()), (Some(0), Some("collapsed")));
    assert_eq!(resumed["last_stable_load_kn"].as_f64().map(f64::round), Some(2700.0));
}

#[test]
fn a_checkpoint_of_another_run_is_refused() {
    let stage = Stage::with_example("interruption-other", "bridgemill");
    let mut child = start(&stage, &["--out", "o"]);
    wait_for_checkpoints(&stage, "o", 1, &mut child);
    child.kill().expect("it is running");
    child.wait().expect("it ends");
    let refused = |words: &[&str], code: &str| {
        let (answer, ending) = stage.object(words);
        assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some(code)), "{}", ending.stderr);
    };
    refused(&["collapse", "bridge/case-2.toml", "--out", "o", "--resume"], "F106");
    stage.write("o/run.checkpoint", "no checkpoint at all");
    refused(&["collapse", "bridge/case-2.toml", "--out", "o", "--resume"], "F110");
}

#[test]
fn nothing_to_resume_is_a_warning() {
    let stage = Stage::with_example("interruption-nothing", "bridgemill");
    let (answer, ending) = stage.object(&["collapse", "bridge/case-1.toml", "--resume"]);
    assert_eq!(ending.code, Some(0));
    assert!(answer["warnings"].as_array().is_some_and(|list| list.iter().any(|one| one["code"] == "F110")), "{answer}");
}

#[test]
fn threads_change_no_bit() {
    let stage = Stage::with_example("interruption-threads", "bridgemill");
    stage.run(&["new", "two", "--from", "two-span"]);
    let runs: [&[&str]; 4] = [
        &["collapse", "bridge/case-1.toml"],
        &["collapse", "bridge/case-1.toml", "--method", "limit"],
        &["collapse", "two/bridge.toml"],
        &["collapse", "two/bridge.toml", "--sweep", "--sweep-step", "0.5 m"],
    ];
    for run in runs {
        let with = |threads: &str| {
            let words: Vec<&str> = run.iter().copied().chain(["--threads", threads, "--out", threads]).collect();
            let (answer, ending) = stage.object(&words);
            assert_eq!(ending.code, Some(0), "{run:?}: {}", ending.stderr);
            assert_eq!(answer["threads"].as_u64().map(|count| count.to_string()).as_deref(), Some(threads));
            numbers(answer)
        };
        assert_eq!(with("1"), with("2"), "{run:?}");
        for name in stage.names("1").iter().filter(|name| name.ends_with(".csv") || name.ends_with(".svg")) {
            assert_eq!(stage.read(&format!("1/{name}")), stage.read(&format!("2/{name}")), "{run:?}: {name}");
        }
    }
}
