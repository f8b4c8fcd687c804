//! A train's passage as its users meet it: the file, the trains, the refusals.

use crate::stage::Stage;

fn arch(name: &str) -> Stage {
    Stage::with_example(name, "railway-arch")
}

#[test]
fn a_train_from_a_file_is_checked_line_by_line() {
    let stage = arch("respond-train");
    let text = stage.read("bridge/passage.toml").replace("name = \"paper-short\" ", "file = \"train.csv\" ");
    stage.write("bridge/other.toml", text);
    let (answer, ending) = stage.object(&["check", "bridge/other.toml"]);
    assert_eq!(ending.code, Some(2), "{answer}");
    stage.write("bridge/train.csv", "axle_load_t,distance_m\n20.5,0\n20.5\n");
    let (answer, ending) = stage.object(&["check", "bridge/other.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F121")), "{answer}");
    assert!(answer["errors"][0]["message"].as_str().is_some_and(|words| words.contains("line 3")), "{answer}");
    stage.write("bridge/train.csv", "axle_load_t,distance_m\n20.5,0\n20.5,1.85\n");
    let (answer, ending) = stage.object(&["check", "bridge/other.toml"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    stage.write(
        "bridge/train.toml",
        "[[vehicle]]\naxle_loads = [\"20 t\"]\naxle_spacings = []\nfront_overhang = \"1 m\"\n",
    );
    stage.write("bridge/other.toml", stage.read("bridge/other.toml").replace("train.csv", "train.toml"));
    let (answer, ending) = stage.object(&["check", "bridge/other.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F121")), "{answer}");
    assert!(answer["errors"][0]["message"].as_str().is_some_and(|words| words.contains("rear_overhang")), "{answer}");
}

/// A file that only plans a passage needs no load; collapse then says what is missing.
#[test]
fn a_passage_needs_no_load() {
    let stage = arch("respond-without-load");
    let text = stage.read("bridge/passage.toml");
    let (before, after) = text.split_once("[[load]]").expect("the example has a load");
    let (_, after) = after.split_once("\n\n").expect("something follows");
    stage.write("bridge/train.toml", format!("{before}{after}"));
    let (answer, ending) = stage.object(&["check", "bridge/train.toml"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    let (answer, ending) = stage.object(&["collapse", "bridge/train.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F108")), "{answer}");
    assert!(answer["errors"][0]["message"].as_str().is_some_and(|words| words.contains("[[load]]")), "{answer}");
    stage.write("bridge/planned.toml", format!("{before}{after}\n[analysis]\nmethod = \"limit\"\n"));
    let (answer, ending) = stage.object(&["check", "bridge/planned.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("B402")), "{answer}");
}

#[test]
fn what_cannot_pass_says_why() {
    let stage = Stage::with_example("respond-refused", "bridgemill");
    let (answer, ending) = stage.object(&["respond", "bridge/case-1.toml"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F108")), "{answer}");
    assert!(answer["errors"][0]["message"].as_str().is_some_and(|words| words.contains("[train]")), "{answer}");
    let stage = arch("respond-speed");
    for wrong in ["0 km/h", "45", "45 m", "9000 km/h"] {
        let (answer, ending) = stage.object(&["respond", "bridge/passage.toml", "--speed", wrong]);
        assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F107")), "{wrong}: {answer}");
    }
}

#[test]
fn the_first_metres_of_the_example_are_solved_and_written() {
    let stage = arch("respond-first-metres");
    let text = stage.read("bridge/passage.toml");
    let short = text.replace("time_step = \"0.005 s\"", "from = \"0 m\"\nto = \"5 m\"\ntime_step = \"0.1 s\"");
    assert_ne!(short, text, "the example says its time step");
    stage.write("bridge/short.toml", short);
    let (answer, ending) = stage.object(&["respond", "bridge/short.toml", "--out", "out"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{answer} {}", ending.stderr);
    // At 12.5 m/s every 1.25 m, both ends among them.
    assert_eq!(answer["load_positions"], 5, "{answer}");
    let channels = answer["channels"].as_array().expect("channels");
    assert_eq!(channels.len(), 6, "{answer}");
    assert!(channels.iter().all(|channel| channel["peak"].as_f64().is_some_and(f64::is_finite)), "{answer}");
    // The crown sinks by some tenths of a millimetre under a bogie, as was measured (0.27 to 0.34 mm); the springings' stones are
    // pressed by 10 to 40 microstrain.
    let peak = |k: usize| channels[k]["peak"].as_f64().unwrap_or_default();
    assert!((-0.4..-0.1).contains(&peak(0)), "{answer}");
    assert!([4, 5].iter().all(|k| (-40.0..-10.0).contains(&peak(*k))), "{answer}");
    let joints = answer["open_joints"].as_u64().unwrap_or_default();
    assert!((1..=26).contains(&joints), "{joints} joints open; the loaded span has 26");
    let written = stage.names("out");
    for file in ["result.json", "channels.csv", "paraview"] {
        assert!(written.iter().any(|name| name == file), "{file} is not in {written:?}");
    }
}
