//! Model updating as its users meet it: an identical twin, a kill and what it leaves, records that cannot be used.

use crate::stage::{Stage, number, numbers, object};
use crate::tiny::BRIDGE;
use serde_json::Value;
use std::cell::Cell;
use std::time::{Duration, Instant};

/// Two moduli sought, the file's own values being the start.
pub(crate) const SOUGHT: &str = r#"
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

/// A stage with a bridge and the records of its twin, whose stone has 13 GPa and whose fill 170 MPa.
pub(crate) fn twin(name: &str) -> Stage {
    let stage = Stage::new(name);
    let truth = BRIDGE.replace("\"10 GPa\"", "\"13 GPa\"").replace("\"100 MPa\"", "\"170 MPa\"");
    stage.write("truth.toml", truth);
    let (answer, ending) = stage.object(&["respond", "truth.toml", "--out", "truth", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    stage.write("records.csv", format!("# synthetic: twin\n{}", stage.read("truth/channels.csv")));
    stage.write("bridge.toml", format!("{BRIDGE}{SOUGHT}"));
    stage
}

/// How many evaluations the log of a folder of results holds.
fn evaluations(stage: &Stage, out: &str) -> usize {
    let log = stage.folder.join(out).join("evaluations.log");
    std::fs::read_to_string(log).unwrap_or_default().lines().count()
}

pub(crate) fn parameter(answer: &Value, name: &str) -> f64 {
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
    // What is left open comes without a posterior, from the derivatives at the answer.
    assert_eq!(one["uncertainty_from"], "linearised", "{one}");
    for one in one["parameters"].as_array().expect("parameters") {
        let (value, deviation) = (number(one, "value"), number(one, "standard_deviation"));
        let ends: Vec<f64> = one["interval_95"].as_array().expect("two").iter().filter_map(Value::as_f64).collect();
        assert!(deviation > 0.0 && ends[0] <= value && value <= ends[1], "{one}");
        assert!(ends[0] >= number(one, "lower") && ends[1] <= number(one, "upper"), "{one}");
    }
    assert!(one["correlation"][0][1].as_f64().is_some_and(|r| (-1.0..0.0).contains(&r)), "{one}");
    assert_eq!(one["sensitivity"].as_array().map(Vec::len), Some(2), "{one}");
    assert!(one["told"].to_string().contains("No uncertainty is stated for"), "{one}");
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
    let mut child = stage.start(&[&words[..], &["--out", "torn"]].concat());
    child.wait_for("half of the evaluations", || evaluations(&stage, "torn") >= all / 2);
    child.kill();
    let resumed = object(&stage.run(&[&words[..], &["--out", "torn", "--resume"]].concat()).stdout);
    let (taken, done) = (number(&resumed, "evaluations_taken_up"), number(&resumed, "evaluations_computed"));
    assert!(taken >= (all / 2 - 2) as f64 && done >= 1.0, "{taken} of {all} were kept, {done} were left");
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
    let mut child = stage.start(&[&words[..], &["--out", "torn"]].concat());
    let last = Cell::new((0, Instant::now()));
    // No evaluation for a while after those of the surrogate: the sampler walks on the polynomial.
    child.wait_for("the surrogate", || {
        let now = evaluations(&stage, "torn");
        if now > last.get().0 {
            last.set((now, Instant::now()));
        }
        last.get().0 >= 180 && last.get().1.elapsed() >= Duration::from_secs(1)
    });
    let (cancelled, code) = child.interrupted();
    assert_eq!((code, cancelled["status"].as_str()), (Some(130), Some("cancelled")), "{cancelled}");
    // Fewer samples are another question to the same model: the log answers it.
    stage.write("bridge.toml", with_posterior(300));
    let resumed = object(&stage.run(&[&words[..], &["--out", "torn", "--resume"]].concat()).stdout);
    let whole = object(&stage.run(&[&words[..], &["--out", "whole"]].concat()).stdout);
    assert!(number(&resumed, "evaluations_taken_up") >= 180.0, "{resumed}");
    assert!(number(&whole["posterior"], "effective_samples") >= 300.0, "{whole}");
    assert_eq!(without_times(resumed)["posterior"]["log_evidence"], without_times(whole)["posterior"]["log_evidence"]);
}
