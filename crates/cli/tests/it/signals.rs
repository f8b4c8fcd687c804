//! A command ends soon after it is asked to, whatever it is at; where no bar can be drawn it says how far it is.

#![cfg(unix)]

use crate::stage::{Stage, object};
use serde_json::Value;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a command may take to end: a second, and what a busy machine adds.
const SOON: Duration = Duration::from_millis(2500);

/// Starts a command, lets it work for a while, sends a signal; what it printed, its exit code, and how long it took to end.
fn stopped(stage: &Stage, words: &[&str], signal: &str, after: Duration) -> (Value, Option<i32>, Duration) {
    let words: Vec<&str> = words.iter().copied().chain(["--json", "--quiet"]).collect();
    let mut child = stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("it starts");
    std::thread::sleep(after);
    assert!(child.try_wait().expect("it can be asked").is_none(), "{words:?} ended before the signal");
    let asked = Instant::now();
    let told = Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill is there");
    assert!(told.success());
    let output = child.wait_with_output().expect("it ends");
    let spent = asked.elapsed();
    (object(&String::from_utf8_lossy(&output.stdout)), output.status.code(), spent)
}

fn ends_soon(stage: &Stage, words: &[&str], signal: &str) -> Value {
    let (answer, code, spent) = stopped(stage, words, signal, Duration::from_millis(1500));
    assert_eq!((code, answer["status"].as_str()), (Some(130), Some("cancelled")), "{words:?}: {answer}");
    assert!(spent < SOON, "{words:?} took {spent:?} after {signal}");
    answer
}

/// A bridge of many voussoirs, so that a sweep over it takes long.
fn long_sweep(name: &str) -> Stage {
    let stage = Stage::with_example(name, "two-span");
    let text = stage.read("bridge/bridge.toml");
    let line = text.lines().find(|line| line.starts_with("voussoirs")).expect("rings have voussoirs");
    stage.write("bridge/bridge.toml", text.replace(line, "voussoirs = 400"));
    stage
}

#[test]
fn a_sweep_ends_within_a_second_of_ctrl_c() {
    let stage = long_sweep("signals-sweep");
    ends_soon(&stage, &["collapse", "bridge/bridge.toml", "--sweep", "--sweep-step", "0.001 m"], "-INT");
}

#[test]
fn limit_analysis_ends_within_a_second_of_termination() {
    let stage = long_sweep("signals-limit");
    let text = stage.read("bridge/bridge.toml").replace("voussoirs = 400", "voussoirs = 4000");
    stage.write("bridge/bridge.toml", text);
    ends_soon(&stage, &["collapse", "bridge/bridge.toml", "--method", "limit"], "-TERM");
}

#[test]
fn an_assessment_ends_when_its_terminal_closes() {
    let stage = Stage::with_example("signals-assess", "railway-arch");
    let answer = ends_soon(&stage, &["assess", "bridge/assess.toml", "--skip", "update"], "-HUP");
    assert!(answer["out"].is_string() || answer["errors"].is_null(), "{answer}");
    assert!(!stage.names("out/assess").iter().any(|name| name.contains("partial")), "nothing half-written");
}

#[test]
fn lines_of_progress_come_where_there_is_no_terminal() {
    let stage = long_sweep("signals-lines");
    let run = ["collapse", "bridge/bridge.toml", "--sweep", "--sweep-step", "0.001 m", "--progress-every", "0.2"];
    let said = |more: &[&str]| {
        let words: Vec<&str> = run.iter().chain(more).copied().collect();
        let child = stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        std::thread::sleep(Duration::from_millis(1500));
        let told = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
        assert!(told.success(), "it ended before the signal");
        let output = child.wait_with_output().expect("it ends");
        String::from_utf8_lossy(&output.stderr).lines().filter(|line| line.contains(" so far")).count()
    };
    assert!(said(&[]) >= 3, "a line every fifth of a second");
    assert_eq!(said(&["--quiet"]), 0);
}
