//! Model updating as its users meet it: an identical twin, a kill and what it leaves, records that cannot be used.

use crate::stage::{Stage, number, numbers, object};
use serde_json::Value;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// A bridge of a hundred elements under one wagon: an evaluation takes hundredths of a second.
pub const BRIDGE: &str = r#"bridge = { name = "Tiny", width = "4 m" }
span = { profile = "segmental", span = "4 m", rise = "1 m", thickness = "0.5 m", voussoirs = 9 }
abutment = { top_width = "1 m", height = "1 m" }
joint = { friction_angle = "35 deg", cohesion = "0 kPa" }
load = { kind = "knife-edge", force = "1 kN/m", length = "0.3 m", at = "1/4 of span 1" }

[masonry]
density = "2200 kg/m^3"
elastic_modulus = "10 GPa"
poisson_ratio = 0.2
compressive_strength = "unlimited"

[[cover]]
layer = "fill"
thickness = "0.4 m"
density = "1800 kg/m^3"

[dispersal]
rule = "uniform"
slope = "2:1"

[mesh]
size = "0.6 m"
ring_nodes = 3

[fill]
elastic_modulus = "100 MPa"
poisson_ratio = 0.2
density = "1800 kg/m^3"
friction_angle = "30 deg"
cohesion = "50 kPa"

[mortar]
elastic_modulus = "1 GPa"
thickness = "10 mm"
lift_off = "100 kN"

[fill_contact]
friction_coefficient = 0.6
separation = false

[train]
name = "one wagon"

[[train.vehicle]]
axle_loads = ["10 t"]
axle_spacings = ["2.0 m"]
front_overhang = "1 m"
rear_overhang = "1 m"

[track]
rail_bending_stiffness = "4 MNm^2"
track_modulus = "30 MPa"
sleeper_spacing = "0.60 m"
sleeper_breadth = "0.25 m"
sleeper_length = "2.75 m"
ballast_depth = "0.25 m"
ballast_slope = "2:1"
dead_load = "3 kPa"

[passage]
speed = "36 km/h"
time_step = "0.04 s"
from = "-3 m"
to = "9 m"

[[sensor]]
name = "crown"
kind = "displacement"
direction = "vertical"
place = "crown"

[[sensor]]
name = "quarter"
kind = "displacement"
direction = "vertical"
at = "1/4 of span 1"

[[sensor]]
name = "strain"
kind = "strain"
gauge_length = "100 mm"
place = "left-springing"
"#;

/// Two moduli sought, the file's own values being the start.
pub const SOUGHT: &str = r#"
[records]
place = "records.csv"
zero = false

[[parameter]]
quantity = "masonry.elastic_modulus"
name = "stone"
lower = "5 GPa"
upper = "20 GPa"

[[parameter]]
quantity = "fill.elastic_modulus"
name = "fill"
lower = "20 MPa"
upper = "300 MPa"

[update]
starts = 2
points = 5
"#;

/// A machine that needs longer than this for a second's work is not going to finish.
const PATIENCE: Duration = Duration::from_secs(120);

/// A stage with a bridge and the records of its twin, whose stone has 13 GPa and whose fill 170 MPa.
fn twin(name: &str) -> Stage {
    let stage = Stage::new(name);
    let truth = BRIDGE.replace("\"10 GPa\"", "\"13 GPa\"").replace("\"100 MPa\"", "\"170 MPa\"");
    stage.write("truth.toml", truth);
    let (answer, ending) = stage.object(&["respond", "truth.toml", "--out", "truth", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    stage.write("records.csv", format!("# synthetic: twin\n{}", stage.read("truth/channels.csv")));
    stage.write("bridge.toml", format!("{BRIDGE}{SOUGHT}"));
    stage
}

fn parameter(answer: &Value, name: &str) -> f64 {
    let list = answer["parameters"].as_array().expect("parameters");
    list.iter().find(|one| one["name"] == name).and_then(|one| one["value"].as_f64()).expect("a value")
}

fn codes(answer: &Value) -> Vec<&str> {
    answer["warnings"].as_array().into_iter().flatten().filter_map(|warning| warning["code"].as_str()).collect()
}

#[test]
fn a_twin_is_found_whatever_the_threads() {
    let stage = twin("update-twin");
    let (one, ending) = stage.object(&["update", "bridge.toml", "--out", "one", "--threads", "1", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{one}");
    // Half a per cent is what the search is made for; nothing in this bridge opens or flows.
    assert!((parameter(&one, "stone") / 13.0 - 1.0).abs() < 5e-3, "{one}");
    assert!((parameter(&one, "fill") / 170.0 - 1.0).abs() < 5e-3, "{one}");
    assert!(number(&one, "error_norm") < 1e-3 && number(&one, "initial_error_norm") > 0.05, "{one}");
    assert!(codes(&one).contains(&"A140"), "synthetic records are called so: {one}");
    assert!(stage.read("one/histories.csv").starts_with("time_s,position_m,crown_measured_mm,crown_start_mm,"));
    let (two, _) = stage.object(&["update", "bridge.toml", "--out", "one", "--threads", "2", "--quiet"]);
    assert_eq!(without_times(two), without_times(one));
}

/// Numbers that stand for an answer, not for a run of the program.
fn without_times(answer: Value) -> Value {
    let mut answer = numbers(answer);
    for search in answer["searches"].as_array_mut().into_iter().flatten() {
        search["seconds"] = Value::Null;
        search["evaluations_computed"] = Value::Null;
    }
    for key in ["evaluations_computed", "evaluations_taken_up", "out"] {
        answer[key] = Value::Null;
    }
    answer
}

#[test]
fn a_killed_update_goes_on_and_does_nothing_twice() {
    let stage = twin("update-kill");
    let words = ["update", "bridge.toml", "--search", "hierarchical", "--threads", "1", "--quiet", "--json"];
    let whole = stage.run(&[&words[..], &["--out", "whole"]].concat());
    let whole = object(&whole.stdout);
    let all = stage.read("whole/evaluations.log").lines().count();
    let mut child = stage
        .command(&[&words[..], &["--out", "torn"]].concat())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let begin = Instant::now();
    let kept =
        || std::fs::read_to_string(stage.folder.join("torn/evaluations.log")).unwrap_or_default().lines().count();
    while kept() < all / 2 {
        assert!(begin.elapsed() < PATIENCE, "no half of the evaluations after {PATIENCE:?}");
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().expect("it can be killed");
    child.wait().expect("it ends");
    let resumed = object(&stage.run(&[&words[..], &["--out", "torn", "--resume"]].concat()).stdout);
    let (taken, done) = (number(&resumed, "evaluations_taken_up"), number(&resumed, "evaluations_computed"));
    assert!(taken >= (all / 2 - 2) as f64, "{taken} of {all} were kept");
    assert_eq!(taken + done, number(&whole, "evaluations"), "no evaluation is done twice");
    assert_eq!(without_times(resumed), without_times(whole));
    assert_eq!(stage.read("torn/sweeps.csv"), stage.read("whole/sweeps.csv"));
    // Another model does not take it up.
    stage.write("bridge.toml", stage.read("bridge.toml").replace("\"0.4 m\"", "\"0.5 m\""));
    let (other, ending) = stage.object(&["update", "bridge.toml", "--out", "torn", "--resume", "--quiet"]);
    assert_eq!((ending.code, other["errors"][0]["code"].as_str()), (Some(2), Some("F106")), "{other}");
}

#[test]
fn records_that_are_doubted_are_named_and_not_used() {
    let stage = twin("update-doubted");
    // One channel a thousand times too large, one turned round.
    let table = stage.read("records.csv");
    let mut lines = Vec::new();
    for (k, line) in table.lines().enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        lines.push(match cells[..] {
            [time, crown, quarter, strain] if k > 1 => {
                let value = |cell: &str| cell.parse::<f64>().expect("a number");
                format!("{time},{},{},{strain}", 1000.0 * value(crown), -value(quarter))
            }
            _ => line.to_owned(),
        });
    }
    stage.write("records.csv", lines.join("\n") + "\n");
    let (answer, ending) = stage.object(&["update", "bridge.toml", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    assert!(codes(&answer).contains(&"R044") && codes(&answer).contains(&"R045"), "{answer}");
    assert!(answer["channels"][0]["left_out"].is_string() && answer["channels"][1]["left_out"].is_string(), "{answer}");
    assert_eq!(answer["channels"][2]["left_out"], Value::Null, "{answer}");
    // One channel tells one combination of two parameters.
    assert_eq!(answer["rank"], 1, "{answer}");
    stage.write("records.csv", "no table at all");
    let (answer, ending) = stage.object(&["update", "bridge.toml", "--quiet"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F130")), "{answer}");
}

/// What the records leave open: uncertainties for every channel, and a posterior of so many samples.
fn with_posterior(samples: u64) -> String {
    let channel =
        |name: &str, uncertainty: f64| format!("\n[[channel]]\nsensor = \"{name}\"\nuncertainty = {uncertainty}\n");
    let channels =
        [("crown", 0.001), ("quarter", 0.001), ("strain", 0.05)].map(|(name, one)| channel(name, one)).concat();
    format!("{BRIDGE}{SOUGHT}posterior = true\nsamples = {samples}\n{channels}")
}

#[test]
fn an_interrupted_posterior_goes_on() {
    let stage = twin("update-posterior");
    let words = ["update", "bridge.toml", "--quiet", "--json"];
    // So many samples take minutes: the interruption comes while they are drawn, or while the points of the surrogate are.
    stage.write("bridge.toml", with_posterior(1_000_000));
    let child = stage
        .command(&[&words[..], &["--out", "torn"]].concat())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let kept =
        || std::fs::read_to_string(stage.folder.join("torn/evaluations.log")).unwrap_or_default().lines().count();
    let begin = Instant::now();
    let mut last = (0, Instant::now());
    // No evaluation for a while after those of the surrogate: the sampler walks on the polynomial.
    while last.0 < 180 || last.1.elapsed() < Duration::from_secs(1) {
        assert!(begin.elapsed() < PATIENCE, "no surrogate after {PATIENCE:?}: {} evaluations", last.0);
        let now = kept();
        if now > last.0 {
            last = (now, Instant::now());
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    let told =
        std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(told.success());
    let ended = child.wait_with_output().expect("it ends");
    let cancelled = object(&String::from_utf8_lossy(&ended.stdout));
    assert_eq!((ended.status.code(), cancelled["status"].as_str()), (Some(130), Some("cancelled")), "{cancelled}");
    // Fewer samples are another question to the same model: the log answers it.
    stage.write("bridge.toml", with_posterior(300));
    let resumed = object(&stage.run(&[&words[..], &["--out", "torn", "--resume"]].concat()).stdout);
    let whole = object(&stage.run(&[&words[..], &["--out", "whole"]].concat()).stdout);
    assert!(number(&resumed, "evaluations_taken_up") >= 180.0, "{resumed}");
    assert!(number(&whole["posterior"], "effective_samples") >= 300.0, "{whole}");
    assert_eq!(without_times(resumed)["posterior"]["log_evidence"], without_times(whole)["posterior"]["log_evidence"]);
}
