//! An assessment as its users meet it: a verdict with an exit code, a report, stages that are kept, fleets.

use crate::stage::{Stage, number};
use serde_json::Value;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// A bridge under one wagon of ten tonnes, of a hundred elements; what is compared stands in [`LIMITS`].
const BRIDGE: &str = r#"bridge = { name = "Tiny", width = "4 m" } # a bridge of a test
span = { profile = "segmental", span = "4 m", rise = "1 m", thickness = "0.5 m", voussoirs = 9 }
abutment = { top_width = "1 m", height = "1 m" }
joint = { friction_angle = "35 deg", cohesion = "0 kPa" }
load = { kind = "knife-edge", force = "10 kN/m", length = "0.3 m", at = "1/4 of span 1" }

[masonry]
density = "2200 kg/m^3"        # weighed
elastic_modulus = "10 GPa"
poisson_ratio = 0.2
compressive_strength = "10 MPa"

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

/// Everything that can be compared on it.
const LIMITS: &str = r#"
[assess]
rule = "irs-bridge-rules"
source = "a test"
deflection_limit = "5 mm"
compression_limit = "5 MPa"
tension_limit = "2 MPa"
joint_shear_limit = "2 MPa"
adequacy_factor = 1.5
permissible_share = 0.9
load_cycles = 1e6

[[service_load]]
name = "heavy"
axle_load = "12 t"

[mexe]
barrel_factor = 1.2
fill_factor = 0.7
width_factor = 0.9
depth_factor = 1.0
mortar_factor = 0.9
condition_factor = 0.9
axle_load = "11.5 t"
"#;

/// A machine that needs longer than this for a second's work is not going to finish.
const PATIENCE: Duration = Duration::from_secs(120);

fn stage(name: &str, limits: &str) -> Stage {
    let stage = Stage::new(name);
    stage.write("bridge.toml", format!("{BRIDGE}{limits}"));
    stage
}

fn check<'a>(answer: &'a Value, code: &str) -> &'a Value {
    let list = answer["checks"].as_array().expect("checks");
    list.iter().find(|one| one["code"] == code).unwrap_or_else(|| panic!("no {code}"))
}

fn states(answer: &Value) -> Vec<(String, String)> {
    let list = answer["stages"].as_array().expect("stages");
    let text = |one: &Value, key: &str| one[key].as_str().expect("text").to_owned();
    list.iter().map(|one| (text(one, "name"), text(one, "state"))).collect()
}

/// Verdict, exit code, object and report say the same; a second run takes every stage up and ends in the same numbers.
#[test]
fn a_bridge_is_judged_and_every_stage_is_kept() {
    let stage = stage("assess-tiny", LIMITS);
    let (answer, ending) = stage.object(&["assess", "bridge.toml", "--out", "out"]);
    assert_eq!((ending.code, &answer["status"]), (Some(0), &Value::from("adequate")), "{answer}");
    for code in ["C101", "C102", "C103", "C105", "C201", "C202", "C203", "C301"] {
        let found = check(&answer, code);
        assert!(found["met"] == true && number(found, "utilisation") > 0.0, "{found}");
    }
    assert!(answer["governing"]["code"].is_string() && answer["sensitivity"]["quantities"][0]["path"].is_string());
    // The design augment of 4 m under a cushion of 0.4 m: 0.95 of full, lessened by 0.4 / 1.8.
    let augment = &answer["service"]["augment"];
    assert!((number(augment, "total") - 0.95).abs() < 1e-12);
    assert!((number(augment, "design") - 0.95 * (1.0 - 0.4 / 1.8)).abs() < 1e-12);
    let page = stage.read("out/report.html");
    for words in ["Adequate", "weighed", "C101", "irs-bridge-rules", "bridge.toml", "<svg"] {
        assert!(page.contains(words), "the report does not say {words}");
    }
    for outside in ["<script", "<link", "<img", "@import", "src="] {
        assert!(!page.contains(outside), "the report needs something beside it: {outside}");
    }
    let (again, _) = stage.object(&["assess", "bridge.toml", "--out", "out"]);
    let kept = states(&again).into_iter().filter(|(_, state)| state == "taken from an earlier run").count();
    assert_eq!(kept, 4, "{:?}", states(&again));
    assert_eq!((&again["checks"], &again["sensitivity"]), (&answer["checks"], &answer["sensitivity"]));
}

/// The live part of a column is the passage's own number times one and the augment.
#[test]
fn columns_are_those_of_the_passage() {
    let stage = stage("assess-columns", &LIMITS.replace("axle_load = \"12 t\"", "source = \"as it is\""));
    let (passage, _) = stage.object(&["respond", "bridge.toml", "--out", "respond"]);
    let (answer, _) = stage.object(&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"]);
    let crown = &passage["channels"][0];
    let columns = &check(&answer, "C101")["columns"];
    let design = number(&answer["service"]["augment"], "design");
    let live = (1.0 + design) * number(crown, "minimum");
    assert!((number(columns, "live_load_design_cda") - live).abs() < 1e-9 * live.abs(), "{columns}");
    assert!((number(columns, "self_weight") - number(crown, "self_weight")).abs() < 1e-9);
}

#[test]
fn a_limit_that_is_not_met_is_exit_code_one() {
    let stage = stage("assess-broken", &LIMITS.replace("\"5 mm\"", "\"0.001 mm\""));
    let (answer, ending) = stage.object(&["assess", "bridge.toml", "--skip", "sensitivity"]);
    assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("inadequate")));
    assert_eq!(check(&answer, "C101")["met"], false);
    assert!(stage.read("out/bridge/report.html").contains("Not adequate"));
}

/// With the feature report.pdf says the verdict that the page says; without it a warning says how to have it.
#[test]
fn the_report_as_pdf_or_the_way_to_it() {
    let stage = stage("assess-pdf", LIMITS);
    let (answer, ending) = stage.object(&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let file = stage.folder.join("out/report.pdf");
    let warnings = answer["warnings"].as_array().expect("a list");
    let told = warnings.iter().find(|one| one["code"] == "A161");
    if !cfg!(feature = "pdf") {
        assert!(told.is_some_and(|one| one["message"].as_str().is_some_and(|words| words.contains("--features pdf"))));
        assert!(!file.exists());
        return;
    }
    assert!(ending.stderr.is_empty() || !ending.stderr.contains("A161"), "{}", ending.stderr);
    let printed = stage.run(&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"]).stdout;
    assert!(printed.contains("report.html, report.pdf, checks.csv and result.json are in"), "{printed}");
    assert!(told.is_none() && std::fs::read(&file).expect("report.pdf").starts_with(b"%PDF-"), "{warnings:?}");
    // Texts of a PDF are glyphs of a font; poppler reads them where it is installed, and the typesetter's own tests in any case.
    let Ok(read) = std::process::Command::new("pdftotext").arg(&file).arg("-").output() else { return };
    let text = String::from_utf8_lossy(&read.stdout);
    // Every page ends in a form feed.
    assert!(text.matches('\u{c}').count() > 1, "{text}");
    for words in ["Adequate", "C101", "weighed", "Every comparison", "extrados assess bridge.toml"] {
        assert!(text.contains(words), "report.pdf does not say {words}: {text}");
    }
}

/// Axles of 300 t on loose fill: no balance is found, the rest stands, nothing is settled.
#[test]
fn a_stage_that_fails_leaves_the_rest_and_says_so() {
    let stage = Stage::new("assess-fails");
    let limits = LIMITS.replace("\"12 t\"", "\"300 t\"");
    stage.write("bridge.toml", format!("{}{limits}", BRIDGE.replace("\"50 kPa\"", "\"0.01 kPa\"")));
    let (answer, ending) = stage.object(&["assess", "bridge.toml", "--skip", "sensitivity"]);
    assert_eq!((ending.code, &answer["status"]), (Some(3), &Value::from("undetermined")), "{:?}", states(&answer));
    assert!(check(&answer, "C201")["met"] == true && answer["service"].is_null());
    let codes: Vec<&str> =
        answer["warnings"].as_array().into_iter().flatten().filter_map(|one| one["code"].as_str()).collect();
    assert!(codes.contains(&"A160"), "{codes:?}");
}

#[test]
fn a_file_without_limits_is_undetermined_and_says_what_to_write() {
    let stage = stage("assess-open", "");
    let (answer, ending) = stage.object(&["assess", "bridge.toml"]);
    assert_eq!((ending.code, &answer["status"]), (Some(3), &Value::from("undetermined")));
    let open = answer["not_made"].as_array().expect("a list");
    assert!(open.iter().any(|one| one["why"].as_str().is_some_and(|why| why.contains("deflection_limit"))), "{open:?}");
}

/// Records of a twin: the update runs, its parameters are judged, and the assessed bridge has its values.
#[test]
fn records_lead_to_a_condition() {
    let stage = Stage::new("assess-update");
    stage.write("truth.toml", BRIDGE.replace("\"100 MPa\"", "\"170 MPa\""));
    let (_, ending) = stage.object(&["respond", "truth.toml", "--out", "truth", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    stage.write("records.csv", format!("# synthetic: twin\n{}", stage.read("truth/channels.csv")));
    let sought = r#"
[records]
place = "records.csv"
zero = false

[[parameter]]
quantity = "fill.elastic_modulus"
name = "fill"
lower = "20 MPa"
upper = "300 MPa"

[update]
starts = 1

[[expected]]
parameter = "fill"
lower = "50 MPa"
upper = "120 MPa"
above = "It was grouted."
"#;
    stage.write("bridge.toml", format!("{BRIDGE}{LIMITS}{sought}"));
    let (answer, ending) = stage.object(&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let fill = &answer["condition"][0];
    // The records are exact: the search ends where it can no longer tell values apart.
    assert!((number(fill, "value") - 170.0).abs() < 0.5, "{fill}");
    assert_eq!(
        (fill["verdict"].as_str(), fill["words"].as_str()),
        (Some("higher-than-expected"), Some("It was grouted."))
    );
    let (own, _) =
        stage.object(&["assess", "bridge.toml", "--out", "own", "--skip", "sensitivity", "--skip", "update"]);
    assert_ne!(check(&own, "C101")["value"], check(&answer, "C101")["value"]);
    let page = stage.read("out/report.html");
    assert!(page.contains("SYNTHETIC") && page.contains("It was grouted."));
}

/// A small bridge of a fleet, with its own geometry; every fiftieth file is broken.
fn fleet_file(number: usize) -> String {
    if number % 50 == 7 {
        return match number % 3 {
            0 => "bridge = [".to_owned(),
            1 => "[bridge]\nname = \"half a file\"\n".to_owned(),
            _ => "\u{1}\u{2} no bridge".to_owned(),
        };
    }
    let (span, rise) = (4.0 + (number % 7) as f64, 1.0 + 0.1 * (number % 5) as f64);
    let thickness = 0.3 + 0.02 * (number % 11) as f64;
    format!(
        "[bridge]\nname = \"Bridge {number}\"\nwidth = \"4 m\"\n\n[[span]]\nprofile = \"segmental\"\nspan = \"{span} m\"\n\
         rise = \"{rise} m\"\nthickness = \"{thickness:.2} m\"\nvoussoirs = 21\n\n[masonry]\ndensity = \"2200 kg/m^3\"\n\
         compressive_strength = \"8 MPa\"\n\n[joint]\nfriction_angle = \"33 deg\"\ncohesion = \"0 kPa\"\n\n\
         [[load]]\nkind = \"knife-edge\"\nforce = \"{} kN/m\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n\n\
         [assess]\nadequacy_factor = 1.5\n",
        5 + number % 9
    )
}

fn fleet(name: &str, count: usize) -> Stage {
    let stage = Stage::new(name);
    std::fs::create_dir_all(stage.folder.join("bridges")).expect("a folder");
    for number in 0..count {
        stage.write(&format!("bridges/{number:04}.toml"), fleet_file(number));
    }
    stage
}

/// Broken files are rows and stop nothing; the worst bridge stands first; a killed run is taken up to the same table.
#[test]
fn a_fleet_survives_broken_files_and_a_kill() {
    let stage = fleet("assess-fleet", 60);
    let words = ["assess", "bridges", "--out", "fleet", "--skip", "sensitivity"];
    let mut child =
        stage.command(&words).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program starts");
    let begun = Instant::now();
    while stage.names("fleet").len() < 8 && begun.elapsed() < PATIENCE {
        if child.try_wait().expect("a status").is_some() {
            break;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let _ = child.kill();
    let _ = child.wait();
    let (answer, ending) = stage.object(&words);
    assert_eq!(answer["bridges"], 60, "{answer}");
    let broken = answer["unusable"].as_array().expect("a list");
    let names: Vec<&str> = broken.iter().filter_map(|one| one["file"].as_str()).collect();
    assert_eq!(names, ["0007.toml", "0057.toml"]);
    assert!(broken.iter().all(|one| one["message"].as_str().is_some_and(|words| words.len() > 10)), "{broken:?}");
    assert!(matches!(ending.code, Some(1 | 3)), "{:?}", ending.code);
    let table = stage.read("fleet/fleet.csv");
    assert_eq!(table.lines().count(), 61);
    let page = stage.read("fleet/fleet.html");
    assert!(page.contains("href=\"0000/report.html\"") && stage.read("fleet/0000/report.html").contains("Bridge 0"));
    // An undisturbed run on one core ends in the same table.
    let (_, _) = stage.object(&["assess", "bridges", "--out", "calm", "--skip", "sensitivity", "--threads", "1"]);
    assert_eq!(stage.read("calm/fleet.csv"), table);
}

/// Ctrl-C, and what it leaves: exit code 130, finished stages kept, and the same command ends in the undisturbed numbers.
#[cfg(unix)]
#[test]
fn an_interrupted_assessment_goes_on_where_it_was() {
    let stage = stage("assess-interrupted", LIMITS);
    let words = ["assess", "bridge.toml", "--out", "out", "--json"];
    let ends = interrupted(&stage, &words, "out");
    let (answer, ending) = stage.object(&words[..4]);
    assert_eq!((ending.code, &answer["status"]), (Some(0), &Value::from("adequate")), "{answer}");
    let (calm, _) = stage.object(&["assess", "bridge.toml", "--out", "calm"]);
    for key in ["checks", "governing", "sensitivity", "collapse"] {
        assert_eq!(answer[key], calm[key], "{key}");
    }
    // Where it was stopped in time, nothing was published, and it says so.
    if let Some(cancelled) = ends {
        assert_eq!(cancelled["status"], "cancelled", "{cancelled}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_fleet_goes_on_where_it_was() {
    let stage = fleet("assess-fleet-interrupted", 40);
    let words = ["assess", "bridges", "--out", "fleet", "--skip", "sensitivity", "--json"];
    let ends = interrupted(&stage, &words, "fleet");
    let (answer, ending) = stage.object(&words[..6]);
    assert_eq!(answer["bridges"], 40, "{answer}");
    assert!(matches!(ending.code, Some(1 | 3)), "{:?}", ending.code);
    stage.object(&["assess", "bridges", "--out", "calm", "--skip", "sensitivity"]);
    assert_eq!(stage.read("calm/fleet.csv"), stage.read("fleet/fleet.csv"));
    if let Some(cancelled) = ends {
        assert_eq!(cancelled["status"], "cancelled", "{cancelled}");
    }
}

/// Starts the command, sends SIGINT as soon as the folder of results holds something, and gives what it printed; none where
/// it had ended before.
#[cfg(unix)]
fn interrupted(stage: &Stage, words: &[&str], out: &str) -> Option<Value> {
    let mut child =
        stage.command(words).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("the program starts");
    let begun = Instant::now();
    while !stage.folder.join(out).read_dir().is_ok_and(|mut list| list.next().is_some()) && begun.elapsed() < PATIENCE {
        if child.try_wait().expect("a status").is_some() {
            return None;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    let _ = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    let output = child.wait_with_output().expect("it ends");
    if matches!(output.status.code(), Some(0 | 1 | 3)) {
        return None;
    }
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    assert!(!stage.folder.join(out).join("result.json").exists(), "an interrupted run publishes nothing");
    Some(crate::stage::object(&String::from_utf8_lossy(&output.stdout)))
}

/// Slow: a thousand bridges, twenty of them broken. `cargo test --release -p cli --test it -- --ignored a_thousand`
#[test]
#[ignore = "a thousand bridges take about a minute"]
fn a_thousand_bridges() {
    let stage = fleet("assess-thousand", 1000);
    let (answer, _) = stage.object(&["assess", "bridges", "--out", "fleet", "--skip", "sensitivity"]);
    assert_eq!(answer["unusable"].as_array().map(Vec::len), Some(20));
    assert_eq!(answer["bridges"], 1000);
    // Both cores of a small machine need under a minute; an hour is a machine that does something else.
    assert!(number(&answer, "wall_seconds") < 3600.0);
}

/// A rule and a vehicle that the library lacks are found before anything is computed, both at once, each with its line.
#[test]
fn names_that_the_library_lacks_are_findings_with_a_place() {
    let stage = stage("assess-names", &LIMITS.replace("irs-bridge-rules", "irs-bridge-rule"));
    let whole = stage.read("bridge.toml") + "\n[sweep]\nrule = \"characteristic\"\nvehicles = [\"lm71\", \"hb-55\"]\n";
    stage.write("bridge.toml", &whole);
    for command in ["assess", "check", "collapse"] {
        let (answer, ending) = stage.object(&[command, "bridge.toml"]);
        assert_eq!((ending.code, &answer["status"]), (Some(2), &Value::from("unusable-input")), "{command}");
        for (word, remedy) in [("irs-bridge-rule", "irs-bridge-rules"), ("hb-55", "hb-45")] {
            let line = 1 + whole.lines().position(|line| line.contains(&format!("\"{word}\""))).expect("a line");
            let said = ending.stderr.contains(&format!("bridge.toml:{line}:")) && ending.stderr.contains(remedy);
            assert!(said, "{command}, {word}: {}", ending.stderr);
        }
    }
}

/// What was left out is no lack of records: each section says why it is empty.
#[test]
fn an_empty_section_of_the_report_says_why() {
    let stage = stage("assess-empty", LIMITS);
    let words = ["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity", "--skip", "service"];
    let _ = stage.object(&words);
    let page = stage.read("out/report.html");
    for why in ["No train crossed: left out by --skip service", "holds: the file names no [records]"] {
        assert!(page.contains(why), "the report does not say: {why}");
    }
    assert!(page.contains("No sensitivities were made: left out by --skip sensitivity"));
}
