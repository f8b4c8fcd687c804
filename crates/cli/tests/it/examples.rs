//! Every example runs, and its key number is what its own words say.

use crate::stage::{Stage, number};
use std::path::Path;

/// Example, file, status, key and number; the share by which it may differ, with the reason.
const KEYS: &[(&str, &str, &str, &str, f64, f64)] = &[
    // A published load step: exact but for the division by the width.
    ("bridgemill", "case-1.toml", "collapsed", "last_stable_load_kn", 1700.0, 1e-12),
    ("bridgemill", "case-2.toml", "collapsed", "last_stable_load_kn", 2700.0, 1e-12),
    // Both bounds of limit analysis, by a program of its own and by another; docs/verification/fill-pressure.md.
    ("prestwood", "limit.toml", "collapsed", "collapse_load_kn", 101.14, 1e-3),
    // Between both bounds on meshes of 6,000 triangles, 233.7 and 238.0 kN/m; here they are 5 % apart.
    ("bridgemill", "continuum.toml", "collapsed", "last_stable_load_kn_per_m", 233.7, 1.5e-2),
    ("prestwood", "continuum.toml", "collapsed", "last_stable_load_kn_per_m", 31.3, 2e-2),
    ("bridgemill", "vehicles.toml", "collapsed", "reference_load_kn_per_m", 29.86, 1e-3),
    // 0.709 of 480.9 kN/m, as the sweep of assess.toml has it with the third axle, most of which stands beside the bridge.
    ("bridgemill", "hb-45.toml", "collapsed", "collapse_load_kn_per_m", 341.2, 1e-3),
    // The same ring, drawn with another program's library: the same load step.
    ("drawing", "bridge.toml", "collapsed", "last_stable_load_kn", 1700.0, 1e-12),
    // Along the equilibrium path, below both limit loads of the same blocks (164.9 and, with joints that crush, 143.0).
    ("viaduct", "bridge.toml", "collapsed", "last_stable_load_kn_per_m", 125.1, 1e-3),
    // 3.629 of the test lorry's rear axle, 104 kN on 2.25 m, as docs/tutorials/load-test.md tells.
    ("road-bridge", "bridge.toml", "collapsed", "load_factor", 3.629, 1e-3),
    // Milankovitch's continuous ring; 200 straight voussoirs are within 0.2 %.
    ("semicircle", "ring.toml", "completed", "minimum_thickness_over_mean_radius", 0.1075, 2e-3),
];

/// Files that take most of a minute are only read and drawn here; slow cases of `verification/` run those of Bridgemill, and
/// `respond.rs` goes through the first metres of the passage.
const SLOW: &[(&str, &str)] = &[
    ("bridgemill", "case-3.toml"),
    ("bridgemill", "case-4.toml"),
    ("bridgemill", "whole.toml"),
    ("bridgemill", "calibration.toml"),
    ("prestwood", "particles.toml"),
    ("railway-arch", "passage.toml"),
    ("railway-arch", "update.toml"),
    ("railway-arch", "update-table-1.toml"),
    ("railway-arch", "second-twin.toml"),
    ("railway-arch", "update-second-twin.toml"),
    ("railway-arch", "assess.toml"),
    // Four rings that slide on one another: half a minute of iteration.
    ("skew-railway", "bridge.toml"),
];

/// Half a minute each, and shorter tests go the same way.
const LATE: &[(&str, &str)] =
    &[("bridgemill", "continuum.toml"), ("prestwood", "continuum.toml"), ("defects", "bridge.toml")];

/// Each file of each example runs once, and those whose number is known give it.
#[test]
fn every_example_runs_and_gives_its_number() {
    each_runs(|one| !LATE.contains(one));
}

#[test]
#[ignore = "half a minute each; .ci/slow"]
fn late_examples_run_and_give_their_numbers() {
    each_runs(|one| LATE.contains(one));
}

fn each_runs(wanted: impl Fn(&(&str, &str)) -> bool) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let (mut count, mut known) = (0, 0);
    for example in std::fs::read_dir(root).expect("examples").flatten().filter(|entry| entry.path().is_dir()) {
        let name = example.file_name().to_string_lossy().into_owned();
        let stage = Stage::with_example(&format!("run-{name}"), &name);
        let files = stage.names("bridge");
        for file in files.iter().filter(|file| file.ends_with(".toml") && wanted(&(name.as_str(), file.as_str()))) {
            let command = if SLOW.contains(&(name.as_str(), file.as_str())) { "check" } else { "collapse" };
            let (answer, ending) =
                stage.object(&[command, &format!("bridge/{file}"), "--out", &file.replace(".toml", "")]);
            assert_eq!(ending.code, Some(0), "{name}/{file}: {} {}", answer["status"], ending.stderr);
            count += 1;
            for (_, _, status, key, value, room) in KEYS.iter().filter(|one| one.0 == name && one.1 == file) {
                assert_eq!(answer["status"], *status, "{name}/{file}");
                let found = number(&answer, key);
                assert!((found - value).abs() <= room * value, "{name}/{file}: {key} = {found}, not {value}");
                known += 1;
            }
        }
    }
    assert!(count >= LATE.len(), "{count} files");
    let keys = KEYS.iter().filter(|one| wanted(&(one.0, one.1)));
    assert_eq!(known, keys.count(), "every number belongs to a file that runs");
}

/// The assessed examples end in what they can say, with a report. Without its vehicles, which its file asks for, Bridgemill has no
/// verdict; the railway arch has none either way, since its rule is one of working stresses. The railway arch crosses in a minute on a slow machine and its records
/// take minutes: here it crosses with its own moduli for a few positions about the peak of the first crown.
#[test]
fn assessed_examples_have_a_verdict() {
    let stage = Stage::with_example("assess-bridgemill", "bridgemill");
    let (answer, ending) =
        stage.object(&["assess", "bridge/assess.toml", "--skip", "vehicles", "--skip", "sensitivity"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(1), Some("undetermined")), "{}", ending.stderr);
    assert_eq!(answer["headline"], "Undetermined");
    assert_eq!(answer["skipped"], serde_json::json!(["vehicles"]), "{answer}");
    let open = answer["not_made"].as_array().expect("a list");
    assert!(open.iter().any(|one| one["code"] == "C301" && one["why"].as_str().is_some_and(|w| w.contains("6.42"))));
    let stage = Stage::with_example("assess-railway", "railway-arch");
    let text = stage.read("bridge/assess.toml");
    let short = text.replace("speed = \"45 km/h\"", "from = \"3.5 m\"\nto = \"6.5 m\"\nspeed = \"45 km/h\"");
    assert_ne!(text, short);
    stage.write("bridge/short.toml", short);
    let words = [
        "assess",
        "bridge/short.toml",
        "--skip",
        "update",
        "--skip",
        "sensitivity",
        "--skip",
        "vehicles",
        "--skip",
        "collapse",
    ];
    let (answer, ending) = stage.object(&words);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(1), Some("undetermined")), "{}", ending.stderr);
    assert_eq!((&answer["headline"], &answer["strength_assessed"]), (&"Undetermined".into(), &false.into()));
    let augment = &answer["service"]["augment"];
    // Table 7 of the railway paper: a total CDA of 0.817, a design CDA of 0.56 to 0.60 by its columns.
    assert!((number(augment, "total") - 0.817).abs() < 5e-4 && (0.56..0.60).contains(&number(augment, "design")));
    assert_eq!(
        answer["checks"].as_array().map_or(0, |list| list.iter().filter(|one| one["code"] == "C101").count()),
        4
    );
}

/// What a load test of the road bridge is expected to read, and what the bridge is judged to carry before it.
#[test]
fn a_road_bridge_says_what_to_expect_and_what_it_carries() {
    let stage = Stage::with_example("road-bridge", "road-bridge");
    let (answer, ending) = stage.object(&["respond", "bridge/bridge.toml"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    let positions = answer["positions"].as_array().expect("positions");
    let expected = |position: usize, sensor: &str| number(&positions[position]["channels"], sensor);
    assert_eq!(positions.len(), 6);
    for (position, sensor, value) in [
        (0, "left quarter deflection", -0.2269),
        (1, "crown deflection", -0.2922),
        (2, "right quarter deflection", -0.3254),
        (1, "crown strain", 23.80),
    ] {
        assert!((expected(position, sensor) / value - 1.0).abs() < 1e-3, "{position}, {sensor}: {answer}");
    }
    // The lorry turned round is the mirror image.
    let mirrored = expected(2, "right quarter deflection") - expected(5, "left quarter deflection");
    assert!(mirrored.abs() < 1e-8, "{mirrored}");
    let (answer, ending) = stage.object(&[
        "assess",
        "bridge/bridge.toml",
        "--skip",
        "update",
        "--skip",
        "sensitivity",
        "--out",
        "verdict",
    ]);
    assert_eq!((ending.code, answer["headline"].as_str()), (Some(1), Some("Not adequate")), "{}", ending.stderr);
    assert!(answer["head"].as_str().is_some_and(|head| head.contains("carries 18 t")), "{}", answer["head"]);
    assert!((number(&answer["governing"], "utilisation") - 1.2291).abs() < 1e-3, "{}", answer["governing"]);
}

#[test]
fn two_spans_fail_at_less_than_one_and_two_rings_less_than_one_ring() {
    let stage = Stage::with_example("examples-compare", "two-span");
    let load = |file: &str| number(&stage.object(&["collapse", file, "--method", "limit"]).0, "collapse_load_kn_per_m");
    let text = stage.read("bridge/bridge.toml");
    let single = text.replace("repeat = 2\n", "");
    let (start, end) = (single.find("[[pier]]").expect("pier"), single.find("[masonry]").expect("masonry"));
    stage.write("single.toml", format!("{}{}", &single[..start], &single[end..]));
    assert!(load("bridge/bridge.toml") < 0.95 * load("single.toml"), "the pier takes part");

    let rings = Stage::with_example("examples-rings", "two-ring").read("bridge/bridge.toml");
    let (start, end) = (rings.find("[[span.ring]]").expect("rings"), rings.find("[masonry]").expect("masonry"));
    let (joint, cover) = (rings.find("[ring_joint]").expect("ring joint"), rings.find("[[cover]]").expect("cover"));
    let one = "thickness = \"0.430 m\"\nvoussoirs = 40\n\n";
    stage.write("two-rings.toml", &rings);
    stage.write("one-ring.toml", format!("{}{one}{}{}", &rings[..start], &rings[end..joint], &rings[cover..]));
    assert!(load("two-rings.toml") < 0.95 * load("one-ring.toml"), "separation weakens");
}
