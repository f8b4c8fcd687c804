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
    // Two rings, which finite elements do not make collapse.
    stage.run(&["new", "two", "--from", "two-ring"]);
    let text = stage.read("two/bridge.toml");
    let stiff = "cohesion = \"0 kPa\"\nnormal_stiffness = \"5 GPa/m\"\nshear_stiffness = \"2 GPa/m\"";
    let text = text.replace("cohesion = \"0 kPa\"", stiff);
    stage.write("two/fe.toml", format!("{text}\n[analysis]\nmethod = \"fe\"\nload_step = \"10 kN\"\n"));
    assert_eq!(refused(&stage, "collapse", "two/fe.toml"), Some(2));
    assert_eq!(checked(&stage, "two/fe.toml"), (Some(2), "F108".to_owned()));
    // A sample that no fill can hold.
    let text = stage.read("bridge/calibration.toml");
    let sample = text.replace("[calibration]\n", "[calibration]\nsample_size = \"3 m\"\n");
    stage.write("bridge/no-sample.toml", sample);
    assert_eq!(checked(&stage, "bridge/no-sample.toml"), (Some(2), "F108".to_owned()));
    assert_eq!(checked(&stage, "bridge/calibration.toml").0, Some(0));
    assert_eq!(checked(&stage, "bridge/case-3.toml").0, Some(0));
}

#[test]
fn a_mesh_that_is_too_large_is_told_by_its_number_at_once() {
    let stage = Stage::with_example("checked-mesh", "railway-arch");
    let text = stage.read("bridge/update.toml");
    let line = text.lines().find(|line| line.starts_with("size = ")).expect("the mesh has a size").to_owned();
    let with = |length: &str| {
        stage.write("bridge/fine.toml", text.replace(&line, &format!("size = \"{length}\"")));
        let begin = Instant::now();
        let ending = stage.run(&["check", "bridge/fine.toml"]);
        assert!(begin.elapsed() < Duration::from_secs(15), "{length} took {:?}", begin.elapsed());
        ending
    };
    let refused = with("5 mm");
    assert_eq!(refused.code, Some(2));
    assert!(refused.stderr.contains("F124") && refused.stderr.contains("more than 2000000"), "{}", refused.stderr);
    let large = with("7 mm");
    assert_eq!(large.code, Some(0), "{}", large.stderr);
    assert!(large.stdout.contains("nodes, not drawn"), "{}", large.stdout);
    assert!(!stage.names("out/fine").contains(&"mesh.svg".to_owned()));
}
