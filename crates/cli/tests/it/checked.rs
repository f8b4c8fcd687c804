//! `check` refuses what the command that a file is made for would refuse, and is quick whatever a file asks for.

use crate::stage::Stage;
use std::time::{Duration, Instant};

/// The exit code and the code of the first error.
fn checked(stage: &Stage, file: &str) -> (Option<i32>, String) {
    let (answer, ending) = stage.object(&["check", file]);
    (ending.code, answer["errors"][0]["code"].as_str().unwrap_or_default().to_owned())
}

fn refused(stage: &Stage, command: &str, file: &str) -> Option<i32> {
    stage.object(&[command, file, "--out", "run"]).1.code
}

#[test]
fn what_the_planned_command_refuses_is_refused() {
    let stage = Stage::with_example("checked-planned", "bridgemill");
    // Particles without the load step that cannot be chosen for them.
    let text = stage.read("bridge/case-3.toml");
    let step = text.lines().find(|line| line.starts_with("load_step")).expect("case 3 has a load step");
    stage.write("bridge/no-step.toml", text.replace(step, ""));
    assert_eq!(checked(&stage, "bridge/no-step.toml"), (Some(2), "F108".to_owned()));
    assert_eq!(refused(&stage, "collapse", "bridge/no-step.toml"), Some(2));
    // A sample that no fill can hold.
    let text = stage.read("bridge/calibration.toml");
    stage.write("bridge/no-sample.toml", text.replace("[calibration]\n", "[calibration]\nsample_size = \"3 m\"\n"));
    assert_eq!(checked(&stage, "bridge/no-sample.toml"), (Some(2), "F108".to_owned()));
    assert_eq!(checked(&stage, "bridge/calibration.toml").0, Some(0));
    assert_eq!(checked(&stage, "bridge/case-3.toml").0, Some(0));
}

#[test]
fn a_mesh_that_is_too_large_is_refused_by_its_number_at_once() {
    let stage = Stage::with_example("checked-mesh", "railway-arch");
    let text = stage.read("bridge/update.toml");
    let size = text.lines().find(|line| line.starts_with("size = ")).map(str::to_owned);
    let with = |length: &str| match &size {
        Some(line) => text.replace(line, &format!("size = \"{length}\"")),
        None => format!("{text}\n[mesh]\nsize = \"{length}\"\n"),
    };
    for (length, code) in [("2 mm", Some(2)), ("20 mm", Some(0))] {
        stage.write("bridge/fine.toml", with(length));
        let begin = Instant::now();
        let (answer, ending) = stage.object(&["check", "bridge/fine.toml"]);
        assert_eq!(ending.code, code, "{length}: {answer}");
        assert!(begin.elapsed() < Duration::from_secs(12), "{length} took {:?}", begin.elapsed());
        if code == Some(2) {
            let message = answer["errors"][0]["message"].as_str().unwrap_or_default().to_owned();
            assert!(
                message.contains("nodes") && message.chars().filter(char::is_ascii_digit).count() > 10,
                "{message}"
            );
        }
    }
}
