//! What each command answers, field by field as scripts rely on it.

use crate::stage::{Stage, number, object};
use serde_json::Value;

/// Share by which numbers of one program may differ on their way through text: none, but for the last digits that a
/// division by the width leaves.
const SAME: f64 = 1e-12;

fn near(found: f64, expected: f64, relative: f64) -> bool {
    (found - expected).abs() <= relative * expected.abs()
}

#[test]
fn discrete_elements_find_the_published_step_of_case_1() {
    let stage = Stage::with_example("answers-dem", "bridgemill");
    let (answer, ending) = stage.object(&["collapse", "bridge/case-1.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(answer["schema"], "extrados.collapse/1");
    assert_eq!(answer["status"], "collapsed");
    assert_eq!(answer["method"], "dem");
    // Load steps of 100 kN over 8.30 m; the published collapse load is the last stable step, 1700 kN (Rouxinol,
    // Providência and Lemos, case 1). Steps are exact multiples, so only rounding of the division is allowed.
    assert!(near(number(&answer, "last_stable_load_kn"), 1700.0, SAME));
    assert!(near(number(&answer, "collapse_load_kn"), 1800.0, SAME));
    assert!(near(number(&answer, "load_step_kn_per_m"), 100.0 / 8.3, SAME));
    assert!(near(number(&answer, "last_stable_load_kn_per_m"), 1700.0 / 8.3, SAME));
    assert!(number(&answer, "iterations_total") <= 140_000.0);
    assert!(number(&answer, "time_step_s") <= number(&answer, "critical_time_step_s"));
    assert_eq!(answer["damping"], "local, 0.7");
    assert_eq!(number(&answer, "tolerance"), 1e-4);
    let edges: Vec<&str> = answer["hinges"]
        .as_array()
        .expect("hinges")
        .iter()
        .map(|hinge| hinge["edge"].as_str().expect("edge"))
        .collect();
    assert_eq!(edges, ["intrados", "extrados", "intrados", "extrados"]);
    let path = answer["path"].as_array().expect("path");
    assert_eq!(path.len(), 19, "self-weight, 17 stable steps, collapse");
    for step in path {
        for key in ["load_kn_per_m", "displacement_mm", "iterations", "unbalanced_ratio"] {
            assert!(step[key].is_number(), "{key} in {step}");
        }
    }
    for key in ["blocks", "particles", "contacts", "max_compressive_stress_mpa", "seed"] {
        assert!(answer[key].is_number(), "{key}");
    }
    assert!(answer["sliding_joints"].is_array());
}

#[test]
fn the_folder_holds_result_tables_figures_and_paraview_files() {
    let stage = Stage::with_example("answers-folder", "bridgemill");
    let (answer, _) = stage.object(&["collapse", "bridge/case-1.toml", "--out", "here/there"]);
    let names = stage.names("here/there");
    for name in [
        "result.json",
        "path.csv",
        "hinges.csv",
        "bridge.svg",
        "bridge.png",
        "mechanism.svg",
        "mechanism.png",
        "stress.svg",
        "thrust-line.svg",
        "load-displacement.svg",
        "collapse.svg",
        "animation.png",
        "paraview",
    ] {
        assert!(names.iter().any(|there| there == name), "{name} is not among {names:?}");
    }
    assert!(
        names.iter().all(|name| !name.starts_with('.') && !name.ends_with(".checkpoint")),
        "left behind: {names:?}"
    );
    for name in answer["files"].as_array().expect("files") {
        let path = stage.folder.join("here/there").join(name.as_str().expect("a name"));
        assert!(path.metadata().is_ok_and(|data| data.len() > 0), "{}", path.display());
    }
    let kept = object(&stage.read("here/there/result.json"));
    assert_eq!(crate::stage::numbers(kept), crate::stage::numbers(answer));
    assert!(stage.read("here/there/path.csv").lines().count() == 20);
    assert!(stage.read("here/there/paraview/blocks.pvd").contains("<VTKFile"));
    assert!(stage.read("here/there/mechanism.svg").starts_with("<"));
}

#[test]
fn a_second_answer_takes_the_place_of_the_first() {
    let stage = Stage::with_example("answers-second", "bridgemill");
    stage.object(&["collapse", "bridge/case-1.toml", "--out", "o"]);
    stage.write("o/my-notes.txt", "mine");
    let (answer, _) = stage.object(&["collapse", "bridge/case-1.toml", "--method", "limit", "--out", "o"]);
    let names = stage.names("o");
    assert!(names.contains(&"my-notes.txt".to_owned()), "files of others stay");
    assert!(!names.contains(&"path.csv".to_owned()), "limit analysis has no load path: {names:?}");
    assert_eq!(object(&stage.read("o/result.json"))["method"], answer["method"]);
}

/// What docs/signs.md says of forces and hinges: the first block's force on the second, by normal and shear, has one horizontal part all along a
/// ring under vertical loads, and is the weight apart between its ends; hinges at the extrados turn counter-clockwise.
#[test]
fn signs_are_as_their_page_says() {
    let stage = Stage::with_example("signs", "bridgemill");
    let (answer, _) = stage.object(&["collapse", "bridge/case-1.toml", "--method", "limit", "--out", "o"]);
    let table = stage.read("o/contacts.csv");
    let mut joints = std::collections::BTreeMap::<usize, [f64; 2]>::new();
    for row in table.lines().skip(1) {
        let cell: Vec<f64> = row.split(',').take(9).map(|cell| cell.parse().expect("a number")).collect();
        let (normal, compression, shear) = ([cell[5], cell[6]], cell[7], cell[8]);
        let force = joints.entry(cell[2] as usize).or_default();
        force[0] += compression * normal[0] - shear * normal[1];
        force[1] += compression * normal[1] + shear * normal[0];
    }
    assert_eq!(joints.len(), 63);
    let (first, last) = (joints[&1], joints[&63]);
    assert!(joints.values().all(|force| near(force[0], first[0], 1e-6)), "{joints:?}");
    // Down on the left, up on the right: what both supports bear is the load and the ring's weight.
    assert!(first[1] > 300.0 && last[1] < -150.0 && first[1] - last[1] > answer["headline_kn_per_m"].as_f64().unwrap());
    for hinge in answer["hinges"].as_array().expect("hinges") {
        let sign = if hinge["edge"] == "extrados" { 1.0 } else { -1.0 };
        assert!(sign * hinge["rotation"].as_f64().expect("a rotation") > 0.0, "{hinge}");
    }
}

#[test]
fn limit_analysis_bounds_the_load_from_both_sides() {
    let stage = Stage::with_example("answers-limit", "bridgemill");
    let load = |points: &str| {
        let words = ["collapse", "bridge/case-1.toml", "--method", "limit", "--contact-points", points];
        let (answer, ending) = stage.object(&words);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("collapsed")));
        let load = number(&answer, "collapse_load_kn_per_m");
        // Both bounds are recomputed, from the forces and from the mechanism; the solver's tolerance is 1e-8.
        assert!(near(number(&answer, "lower_bound_kn_per_m"), load, 1e-6));
        assert!(near(number(&answer, "upper_bound_kn_per_m"), load, 1e-6));
        assert_eq!(answer["friction"], "associated");
        for point in answer["thrust_line"].as_array().expect("thrust line") {
            assert!(point["x_m"].is_number() && point["y_m"].is_number() && point["thrust_kn_per_m"].is_number());
        }
        load
    };
    // Independent calculations of the same arch give 219.4 with 0.691 m between contact points and 231.46 with 0.711 m;
    // half of their last digit is the tolerance.
    assert!((load("rounded") - 219.4).abs() < 0.05, "{}", load("rounded"));
    assert!((load("full-ring") - 231.46).abs() < 0.005, "{}", load("full-ring"));
}

#[test]
fn a_resolution_refines_the_collapse_load() {
    let stage = Stage::with_example("answers-resolution", "bridgemill");
    let (answer, _) = stage.object(&["collapse", "bridge/case-1.toml", "--resolution", "2 kN/m"]);
    let (stable, collapse) = (number(&answer, "last_stable_load_kn_per_m"), number(&answer, "collapse_load_kn_per_m"));
    assert!(stable >= 1700.0 / 8.3 - 1e-9 && collapse <= 1800.0 / 8.3 + 1e-9, "{stable} {collapse}");
    assert!(collapse - stable > 0.0 && collapse - stable <= 2.0 + 1e-9, "{stable} {collapse}");
}

#[test]
fn the_least_thickness_of_a_semicircle_is_milankovitchs() {
    let stage = Stage::with_example("answers-thickness", "semicircle");
    let (answer, ending) = stage.object(&["collapse", "bridge/ring.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(answer["status"], "completed");
    // 0.1075 for the continuous ring; 200 straight-sided voussoirs come within 0.2 %.
    assert!(near(number(&answer, "minimum_thickness_over_mean_radius"), 0.1075, 0.002), "{answer}");
}

#[test]
fn a_sweep_finds_the_governing_position() {
    let stage = Stage::with_example("answers-sweep", "tiny");
    let (answer, ending) = stage.object(&["collapse", "bridge/bridge.toml", "--sweep", "--sweep-step", "0.2 m"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(answer["schema"], "extrados.sweep/1");
    let positions = answer["positions"].as_array().expect("positions");
    // One more where the worst position lies between two of them.
    assert!((21..=22).contains(&positions.len()), "{}", positions.len());
    let least = positions.iter().filter_map(|one| one["load_factor"].as_f64()).fold(f64::INFINITY, f64::min);
    assert_eq!(answer["governing"]["load_factor"].as_f64(), Some(least));
    let names = stage.names("out/bridge");
    assert!(
        ["envelope.svg", "envelope.png", "sweep.csv", "result.json"]
            .iter()
            .all(|name| names.contains(&(*name).to_owned())),
        "{names:?}"
    );
}

#[test]
fn vehicles_of_the_library_and_of_a_file_are_moved_over_the_bridge() {
    let stage = Stage::with_example("answers-vehicles", "bridgemill");
    let text = stage.read("bridge/vehicles.toml");
    let own = "code = \"own\"\ntitle = \"Own\"\nways = \"road\"\n\
        source = { text = \"a plate\", date = \"2026\", confidence = \"assumed\" }\n\n[[vehicle]]\ncode = \"crane\"\n\
        title = \"Crane\"\naxle_loads_kn = [120.0, 120.0]\nspacings_m = [1.6]\naxles_may_be_dropped = true\n\
        wheel_track_m = 2.0\ncontact_length_m = 0.30\n\n[[under]]\nrule = \"characteristic\"\n\
        live_load = { value = 1.0, source = { text = \"a plate\", date = \"2026\", confidence = \"assumed\" } }\n\
        impact = { kind = \"included\", source = { text = \"a plate\", date = \"2026\", confidence = \"assumed\" } }\n";
    stage.write("bridge/crane.toml", own);
    let asked = "vehicles = [\"crane\", \"lm1\"]\nvehicle_files = [\"crane.toml\"]\nstep = \"0.6 m\"\n\n[dispersal]";
    stage.write(
        "bridge/own.toml",
        text.replacen("[dispersal]", asked, 1).replace("discrete_elements = true", "discrete_elements = false"),
    );
    let (answer, ending) = stage.object(&["collapse", "bridge/own.toml", "--sweep"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(answer["schema"], "extrados.vehicle-sweep/1");
    assert_eq!(answer["governing"]["vehicle"], "lm1");
    assert!(answer["governing"]["position_m"].is_number(), "{}", answer["governing"]);
    let vehicles = answer["vehicles"].as_array().expect("vehicles");
    assert_eq!(vehicles.len(), 2);
    for v in vehicles {
        let [lower, upper] = ["lower_bound", "upper_bound"].map(|key| v[key].as_f64().expect(key));
        assert!((upper / lower - 1.0).abs() < 1e-6, "{v}");
        assert_eq!(v["sections"].as_array().map(Vec::len), Some(5));
    }
    assert!(answer["rule"]["factors"].as_array().expect("factors").len() >= 8, "no factor is silent");
    let names = stage.names("out/own");
    let wanted = ["adequacy.svg", "envelope.svg", "mechanism.svg", "vehicles.csv", "sweep.csv", "sections.csv"];
    assert!(wanted.iter().all(|name| names.contains(&(*name).to_owned())), "{names:?}");
    // A mistake in the file of vehicles is told by file and key.
    stage.write("bridge/crane.toml", own.replace("[1.6]", "[]"));
    let (answer, ending) = stage.object(&["collapse", "bridge/own.toml", "--sweep"]);
    assert_eq!(ending.code, Some(2));
    let said = answer["errors"][0]["message"].as_str().expect("message").to_owned();
    assert!(said.contains("crane.toml") && said.contains("spacings_m"), "{said}");
}

#[test]
fn a_support_movement_ends_in_a_mechanism() {
    let stage = Stage::with_example("answers-movement", "settlement");
    for method in ["limit", "dem"] {
        let (answer, ending) = stage.object(&["collapse", "bridge/bridge.toml", "--method", method]);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("collapsed")), "{}", ending.stderr);
        assert_eq!(answer["analysis"], "support-movement");
        let (stable, collapse) = (number(&answer, "last_stable_movement_m"), number(&answer, "collapse_movement_m"));
        // Within one increment of 20 mm, which discrete elements use to the full.
        assert!(collapse > stable && collapse - stable <= 0.02 + 1e-9, "{method}: {stable} {collapse}");
        assert_eq!(answer["path"].is_array(), method == "dem");
        let table = stage.read("out/bridge/blocks.csv");
        assert!(table.starts_with("movement_m,block,"), "{method}: {}", &table[..40]);
        // Limit analysis knows resultants and no stresses: none are written or drawn.
        assert_eq!(table.lines().nth(1).is_some_and(|row| row.ends_with(",,")), method == "limit");
        assert_eq!(stage.names("out/bridge").contains(&"stress.png".to_owned()), method == "dem");
        if method == "dem" {
            // Deformable blocks slide and come to rest farther on; their last joints are another mechanism.
            continue;
        }
        // A springing that gives way outwards opens the ring below near the crown, so it turns about the extrados
        // there and about the intrados at both springings, told where they stand in the bridge as built (span 8 m).
        let hinges = answer["hinges"].as_array().expect("hinges");
        let edges: Vec<_> = hinges.iter().map(|hinge| hinge["edge"].as_str().unwrap_or("")).collect();
        assert_eq!(edges, ["intrados", "extrados", "intrados"], "{method}: {hinges:?}");
        assert!((number(&hinges[2], "x_m") - 8.0).abs() < 0.05, "{method}: {hinges:?}");
    }
}

#[test]
fn check_draws_and_computes_nothing() {
    let stage = Stage::with_example("answers-check", "two-span");
    let (answer, ending) = stage.object(&["check", "bridge/bridge.toml"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    assert_eq!(answer["spans"].as_array().map(Vec::len), Some(2));
    assert_eq!(stage.names("out/bridge"), ["bridge.png", "bridge.svg"]);
    let words = stage.run(&["check", "bridge/bridge.toml", "--quiet"]);
    assert!(words.stderr.is_empty() && words.stdout.contains("pier 1: 1.00 m wide"), "{}", words.stdout);
}

#[test]
fn check_draws_the_mesh_where_the_file_describes_one() {
    let stage = Stage::with_example("answers-mesh", "railway-arch");
    let (answer, ending) = stage.object(&["check", "bridge/passage.toml"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    assert_eq!(
        stage.names("out/passage"),
        ["bridge.png", "bridge.svg", "mesh.png", "mesh.svg", "mesh.vtu"],
        "a bridge and its mesh"
    );
    assert!(number(&answer["mesh"], "least_scaled_jacobian") > 0.5, "{}", answer["mesh"]);
    assert!(number(&answer["mesh"], "degrees_of_freedom") > 10_000.0, "{}", answer["mesh"]);
    let drawing = stage.read("out/passage/mesh.svg");
    for zone in ["voussoirs (", "pier (", "abutment (", "haunch fill (", "abutment fill (", "mortar joint"] {
        assert!(drawing.contains(zone), "the key names {zone}");
    }
}

#[test]
fn new_explain_schema_and_bench_answer() {
    let stage = Stage::new("answers-others");
    let (answer, _) = stage.object(&["new", "fresh"]);
    assert_eq!(answer["example"], "bridgemill");
    assert_eq!(answer["files"].as_array().map(Vec::len), Some(stage.names("fresh").len()));
    for code in ["B104", "p010", "A102", "C102", "D101", "R041", "F101", "collapsed"] {
        let (card, ending) = stage.object(&["explain", code]);
        assert_eq!(ending.code, Some(0), "{code}");
        assert!(card["title"].is_string() && card["text"].is_string(), "{card}");
    }
    let schema: Value = serde_json::from_str(&stage.run(&["schema"]).stdout).expect("the schema is JSON");
    assert!(schema["$schema"].is_string() && schema["properties"]["span"].is_object());
    let (bench, ending) = stage.object(&["bench", "limit", "--repeats", "2"]);
    assert_eq!((ending.code, bench["name"].as_str(), bench["repeats"].as_u64()), (Some(0), Some("limit"), Some(2)));
    assert!(number(&bench, "milliseconds") > 0.0 && bench["size"].is_number());
    let (bench, _) = stage.object(&["bench", "arch", "--repeats", "1"]);
    assert!(number(&bench, "seconds_to_collapse") > 0.0);
    let (bench, ending) = stage.object(&["bench", "disks", "--count", "300", "--repeats", "1", "--copies", "2"]);
    assert_eq!((ending.code, bench["size"].as_u64(), bench["threads"].as_u64()), (Some(0), Some(300), Some(1)));
    assert!(number(&bench, "particle_steps_per_second") > 0.0 && number(&bench, "bytes_per_particle") > 64.0);
    assert!(number(&bench, "contacts_per_particle") >= 2.0 && number(&bench, "coordination") >= 4.0);
    assert!(number(&bench, "searches") >= 1.0 && number(&bench, "share_of_copies") > 0.0);
}

#[test]
fn bench_factor_and_footing_answer() {
    let stage = Stage::new("answers-elements");
    let (bench, ending) = stage.object(&["bench", "factor", "--count", "40", "--repeats", "2"]);
    assert_eq!((ending.code, bench["name"].as_str(), bench["size"].as_u64()), (Some(0), Some("factor"), Some(800)));
    for part in ["seconds_analyse", "seconds_assembly", "seconds_factor", "seconds_solve"] {
        assert!(number(&bench, part) > 0.0, "{part}");
    }
    // 41 by 21 nodes; the base is held both ways, the sides across, and the five nodes of the footing, one of them at a side, both ways.
    assert_eq!(number(&bench, "degrees_of_freedom"), f64::from(2 * 41 * 21 - 2 * 41 - 2 * 20 - (2 * 5 - 1)));
    let (bench, ending) = stage.object(&["bench", "footing", "--count", "40", "--repeats", "1"]);
    assert_eq!((ending.code, bench["status"].as_str()), (Some(0), Some("completed")));
    assert!(number(&bench, "seconds") > 0.0 && number(&bench, "iterations_total") >= 10.0);
    let pressure = number(&bench, "mean_pressure_kpa");
    // A coarse mesh is stiffer than the 392.4 kPa of 142 elements, and far below the elastic 758 kPa.
    assert!((392.0..460.0).contains(&pressure), "{pressure}");
    let (bench, _) =
        stage.object(&["bench", "footing", "--count", "40", "--repeats", "1", "--material", "drucker-prager"]);
    assert_eq!(bench["status"], "completed");
    assert!(number(&bench, "mean_pressure_kpa") > number(&bench, "limit_pressure_kpa"));
}

#[test]
fn words_for_people_are_short_and_name_the_folder() {
    let stage = Stage::with_example("answers-words", "tiny");
    let ending = stage.run(&["collapse", "bridge/bridge.toml"]);
    assert_eq!(ending.code, Some(0));
    let whole = stage.run(&["collapse", "bridge/bridge.toml", "--details"]).stdout;
    assert!(ending.stdout.lines().count() <= 20 && ending.stderr.is_empty(), "{}", ending.stdout);
    assert!(ending.stdout.contains("carried") && ending.stdout.contains("--details"), "{}", ending.stdout);
    assert!(whole.contains("collapse load") && whole.contains("This assumes:"), "{whole}");
    assert!(ending.stdout.contains("out/bridge"));
    assert!(
        !ending.stdout.contains('\u{1b}') && !ending.stderr.contains('\u{1b}'),
        "no colours where there is no terminal"
    );
}

#[test]
fn verify_keeps_kinds_apart_and_fails_when_a_case_does() {
    let stage = Stage::new("answers-verify");
    let blocks = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification/blocks");
    let (answer, ending) = stage.object(&["verify", &blocks.to_string_lossy(), "--manual", "manual.md"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{answer}");
    assert!(answer["kinds"]["exact"]["holds"].as_u64().is_some_and(|count| count >= 4), "{answer}");
    assert!(answer["kinds"]["total"].is_null() && answer["kinds"]["experiment"].is_null(), "kinds are never added up");
    let tables = answer["tables"].as_array().expect("the load models' own tables");
    assert!(tables.len() > 8 && tables.iter().all(|table| table["agrees"] != false), "{tables:?}");
    let printed = stage.run(&["verify", &blocks.to_string_lossy()]).stdout;
    assert!(printed.contains("load models against tables") && !printed.contains("differs"), "{printed}");
    assert!(stage.read("manual.md").starts_with("# Verification manual"));
    std::fs::create_dir(stage.folder.join("case")).expect("a folder");
    for file in ["case.toml", "blocks.toml"] {
        let text = std::fs::read_to_string(blocks.join("overturning").join(file)).expect("the case is there");
        stage.write(&format!("case/{file}"), text.replace("\nvalue = 0.25", "\nvalue = 0.26"));
    }
    let (answer, ending) = stage.object(&["verify", "case"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(1), Some("inadequate")), "{answer}");
    assert_eq!(answer["cases"][0]["verdict"], "fails");
}
