//! An assessment as its users meet it: a verdict with an exit code, a report, stages that are kept, fleets.

use crate::stage::{Stage, number};
use crate::tiny::BRIDGE;
use serde_json::Value;

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
adequacy_source = "a test, clause 1"
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
    is_set_as_a_report(&page, &answer);
    let (again, _) = stage.object(&["assess", "bridge.toml", "--out", "out"]);
    let kept = states(&again).into_iter().filter(|(_, state)| state == "taken from an earlier run").count();
    assert_eq!(kept, 4, "{:?}", states(&again));
    assert_eq!((&again["checks"], &again["sensitivity"]), (&answer["checks"], &answer["sensitivity"]));
}

/// The summary comes first, what was not looked at stands in one place, every drawing is a block that no page cuts, and every hinge that
/// acts is marked.
fn is_set_as_a_report(page: &str, answer: &Value) {
    let at = |words: &str| page.find(words).unwrap_or_else(|| panic!("the report has no {words}"));
    let summary = &page[at("<main id=\"summary\"")..at("</main>")];
    assert!(at("</main>") < at("id=\"document\""), "the summary comes first");
    for words in ["id=\"verdict\"", "<svg", "assessed", "checked", "approved", "Mechanism of 4 hinges"] {
        assert!(summary.contains(words), "the summary has no {words}: {summary}");
    }
    for once in [
        "id=\"left-out\"",
        "<h3>Checks that were not made</h3>",
        "id=\"assumptions\"",
        "counter(page) \" of \" counter(pages)",
    ] {
        assert_eq!(page.matches(once).count(), 1, "{once}");
    }
    for (k, _) in page.match_indices("<svg ") {
        let before = &page[..k];
        assert!(before.rfind("<figure") > before.rfind("</figure>"), "a drawing outside a figure");
    }
    assert!(page.contains("figure, tr, li, .verdict, dl { break-inside: avoid; }"));
    let hinges = answer["collapse"]["hinges"].as_array().expect("hinges").len();
    let drawing = &page[at("aria-label=\"Mechanism at collapse")..];
    let marked = drawing[..drawing.find("</svg>").expect("its end")].matches("class=\"hinge\"").count();
    assert_eq!((hinges, marked), (4, 4));
    assert_eq!(summary.matches("class=\"hinge\"").count(), 4);
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

/// With --pdf the report is a PDF too, by the typesetter beside the command or by a browser; without either a line says what to do, and without the
/// flag nothing is said of it.
#[test]
fn the_report_as_pdf_or_the_way_to_it() {
    let stage = stage("assess-pdf", LIMITS);
    let words = ["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"];
    let file = stage.folder.join("out/report.pdf");
    let said = |ending: &std::process::Output| String::from_utf8_lossy(&ending.stdout).into_owned();
    let plain = said(&stage.command(&words).output().expect("it starts"));
    assert!(
        plain.contains("\nreport.html, checks.csv and result.json are in out") && !plain.contains("report.pdf"),
        "{plain}"
    );
    let with = |browser: Option<&str>| {
        let mut command = stage.command(&words);
        command.arg("--pdf").env("PATH", "");
        browser.map(|browser| command.env("EXTRADOS_BROWSER", browser));
        command.output().expect("it starts")
    };
    let typesetter = std::path::Path::new(env!("CARGO_BIN_EXE_extrados")).with_file_name("extrados-pdf");
    if !typesetter.exists() {
        let none = said(&with(None));
        assert!(none.contains("\nno report.pdf: put extrados-pdf of the release archive beside extrados"), "{none}");
        assert!(!file.exists());
        let wrong = said(&with(Some("/nowhere")));
        assert!(wrong.contains("no report.pdf: EXTRADOS_BROWSER names “/nowhere”"), "{wrong}");
        let fails = said(&with(Some("/bin/false")));
        assert!(fails.contains("no report.pdf: /bin/false: it wrote none") && !file.exists(), "{fails}");
    }
    let browser = std::env::var("EXTRADOS_BROWSER").unwrap_or_else(|_| "/usr/bin/chromium".to_owned());
    if !typesetter.exists() && !std::path::Path::new(&browser).exists() {
        return;
    }
    let printed =
        said(&stage.command(&words).arg("--pdf").env("EXTRADOS_BROWSER", &browser).output().expect("it starts"));
    assert!(printed.contains("\nreport.html, report.pdf, checks.csv and result.json are in out"), "{printed}");
    assert!(std::fs::read(&file).expect("report.pdf").starts_with(b"%PDF-"));
    assert!(stage.names("out").iter().all(|name| !name.contains("partial")), "{:?}", stage.names("out"));
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
    assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("undetermined")));
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
    // The records are exact: the search ends where it can no longer tell values apart. What three channels tell of the fill, at a
    // hundredth of each peak and a tenth of the loads, is 40 to 300 MPa: too wide to conclude anything from.
    assert!((number(fill, "value") - 170.0).abs() < 0.5, "{fill}");
    assert_eq!(fill["verdict"].as_str(), Some("not-told-by-the-records"), "{fill}");
    let interval = &answer["update"]["parameters"][0]["interval_95"];
    assert!(interval[0].as_f64() < Some(120.0) && interval[1].as_f64() > Some(200.0), "{interval}");
    let (own, _) =
        stage.object(&["assess", "bridge.toml", "--out", "own", "--skip", "sensitivity", "--skip", "update"]);
    assert_ne!(check(&own, "C101")["value"], check(&answer, "C101")["value"]);
    let page = stage.read("out/report.html");
    assert!(page.contains("SYNTHETIC"));
}

/// A small bridge of a fleet, with its own geometry; every fiftieth file is broken.
fn fleet_file(number: usize) -> String {
    if number % 10 == 7 {
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
    // What stands beside the bridge that names it is no bridge.
    stage.write("bridges/lorry.toml", "code = \"lorry\"\n[[vehicle]]\ncode = \"our-lorry\"\n");
    stage
}

/// Broken files are rows and stop nothing; the worst bridge stands first; a killed run is taken up to the same table.
#[test]
fn a_fleet_survives_broken_files_and_a_kill() {
    let stage = fleet("assess-fleet", 18);
    let words = ["assess", "bridges", "--out", "fleet", "--skip", "sensitivity"];
    let mut child = stage.start(&words);
    child.wait_for("the first bridges", || finished(&stage, "fleet").len() >= 3);
    child.kill();
    let torn = finished(&stage, "fleet").len();
    assert!(torn < 16, "killed when {torn} of 16 were finished");
    let (answer, ending) = stage.object(&words);
    assert_eq!(answer["bridges"], 18, "{answer}");
    let broken = answer["unusable"].as_array().expect("a list");
    let names: Vec<&str> = broken.iter().filter_map(|one| one["file"].as_str()).collect();
    assert_eq!(names, ["0007.toml", "0017.toml"]);
    assert!(broken.iter().all(|one| one["message"].as_str().is_some_and(|words| words.len() > 10)), "{broken:?}");
    assert!(matches!(ending.code, Some(1 | 3)), "{:?}", ending.code);
    let table = stage.read("fleet/fleet.csv");
    assert_eq!(table.lines().count(), 19);
    let page = stage.read("fleet/fleet.html");
    assert!(page.contains("href=\"0000/report.html\"") && stage.read("fleet/0000/report.html").contains("Bridge 0"));
    // An undisturbed run on one core ends in the same table.
    let (_, _) = stage.object(&["assess", "bridges", "--out", "calm", "--skip", "sensitivity", "--threads", "1"]);
    assert_eq!(stage.read("calm/fleet.csv"), table);
}

/// A place in a bridge file is a point of the map, with the least factor of its verdict.
#[test]
fn a_fleet_with_places_is_a_map() {
    let stage = fleet("assess-map", 2);
    let placed = fleet_file(1) + "\n[document]\nlatitude = 54.0689\nlongitude = -2.2836\n";
    stage.write("bridges/0001.toml", &placed);
    stage.object(&["assess", "bridges", "--out", "fleet", "--skip", "sensitivity"]);
    let map: serde_json::Value = serde_json::from_str(&stage.read("fleet/fleet.geojson")).expect("JSON");
    let features = map["features"].as_array().expect("features");
    assert_eq!(features.len(), 2);
    let one = features.iter().find(|one| one["properties"]["file"] == "0001.toml").expect("the bridge");
    assert_eq!(one["geometry"], serde_json::json!({ "type": "Point", "coordinates": [-2.2836, 54.0689] }));
    let (alone, _) = stage.object(&["assess", "bridges/0001.toml", "--out", "alone", "--skip", "sensitivity"]);
    let factor = one["properties"]["least_factor"].as_f64().expect("a factor");
    let values = alone["checks"].as_array().into_iter().flatten().filter_map(|check| check["value"].as_f64());
    assert!(values.clone().any(|value| value == factor), "{factor} is no value of {alone}");
    // One coordinate alone is told, and no place without both.
    stage.write("half.toml", fleet_file(1) + "\n[document]\nlatitude = 54.0689\n");
    let said = stage.run(&["check", "half.toml"]).stderr;
    assert!(said.contains("B107") && said.contains("write `longitude` as well"), "{said}");
}

/// Names of the bridges of a fleet that are finished.
fn finished(stage: &Stage, fleet: &str) -> Vec<String> {
    let names = stage.names(fleet).into_iter();
    names.filter(|name| stage.folder.join(fleet).join(name).join("result.json").exists()).collect()
}

/// Ctrl-C, and what it leaves: exit code 130, finished stages kept, and the same command ends in the undisturbed numbers.
#[cfg(unix)]
#[test]
fn an_interrupted_assessment_goes_on_where_it_was() {
    let stage = stage("assess-interrupted", LIMITS);
    // Every position by itself, and many of them: seconds in which the interruption comes.
    let slow = stage.read("bridge.toml").replace("\"0.04 s\"", "\"0.0002 s\"\npath = \"plain\"");
    stage.write("bridge.toml", slow);
    let words = ["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity", "--json"];
    let mut child = stage.start(&words);
    child.wait_for("the first stage", || stage.folder.join("out/stages/built.json").exists());
    let (cancelled, code) = child.interrupted();
    assert_eq!((code, cancelled["status"].as_str()), (Some(130), Some("cancelled")), "{cancelled}");
    assert_eq!(stage.names("out/stages"), ["built.json"], "the train was under way");
    assert!(!stage.names("out").contains(&"result.json".to_owned()), "an interrupted run publishes nothing");
    let kept = stage.read("out/stages/built.json");
    let (answer, ending) = stage.object(&words[..6]);
    assert_eq!((ending.code, &answer["status"]), (Some(0), &Value::from("adequate")), "{answer}");
    let taken: Vec<String> = states(&answer)
        .into_iter()
        .filter(|(_, state)| state == "taken from an earlier run")
        .map(|one| one.0)
        .collect();
    assert_eq!((taken, stage.read("out/stages/built.json")), (vec!["built".to_owned()], kept));
    let (calm, _) = stage.object(&["assess", "bridge.toml", "--out", "calm", "--skip", "sensitivity"]);
    for key in ["checks", "governing", "service", "collapse"] {
        assert_eq!(answer[key], calm[key], "{key}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_fleet_goes_on_where_it_was() {
    let stage = fleet("assess-fleet-interrupted", 18);
    let words = ["assess", "bridges", "--out", "fleet", "--skip", "sensitivity", "--json"];
    let mut child = stage.start(&words);
    child.wait_for("the first bridges", || finished(&stage, "fleet").len() >= 3);
    let (cancelled, code) = child.interrupted();
    assert_eq!((code, cancelled["status"].as_str()), (Some(130), Some("cancelled")), "{cancelled}");
    let torn = finished(&stage, "fleet");
    assert!((3..16).contains(&torn.len()), "{torn:?}");
    let kept = |name: &String| stage.read(&format!("fleet/{name}/stages/collapse.json"));
    let before: Vec<String> = torn.iter().map(kept).collect();
    let (answer, ending) = stage.object(&words[..6]);
    assert_eq!(answer["bridges"], 18, "{answer}");
    assert!(matches!(ending.code, Some(1 | 3)), "{:?}", ending.code);
    // The seconds that a stage took are kept with it: finished bridges were not computed again.
    assert_eq!(torn.iter().map(kept).collect::<Vec<_>>(), before);
    stage.object(&["assess", "bridges", "--out", "calm", "--skip", "sensitivity"]);
    assert_eq!(stage.read("calm/fleet.csv"), stage.read("fleet/fleet.csv"));
}

/// Slow: a thousand bridges, a hundred of them broken. `cargo test --release -p cli --test it -- --ignored a_thousand`
#[test]
#[ignore = "a thousand bridges take minutes"]
fn a_thousand_bridges() {
    let stage = fleet("assess-thousand", 1000);
    let (answer, _) = stage.object(&["assess", "bridges", "--out", "fleet", "--skip", "sensitivity"]);
    assert_eq!(answer["unusable"].as_array().map(Vec::len), Some(100));
    assert_eq!(answer["bridges"], 1000);
    // A quarter of a second of one core each; an hour is a machine that does something else.
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

/// A chapter with nothing in it is not there; why stands where everything stands that was not looked at.
#[test]
fn an_empty_chapter_is_left_out_and_said_elsewhere() {
    let stage = stage("assess-empty", LIMITS);
    let words = ["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity", "--skip", "service"];
    let _ = stage.object(&words);
    let page = stage.read("out/report.html");
    for why in ["left out by --skip service", "left out by --skip sensitivity", "the file names no [records]"] {
        assert!(page.contains(why), "the report does not say: {why}");
    }
    for chapter in ["service", "records", "condition", "changes"] {
        assert!(
            !page.contains(&format!("id=\"{chapter}\"")) && !page.contains(&format!("href=\"#{chapter}\"")),
            "{chapter}"
        );
    }
    assert!(page.contains("<h2 id=\"collapse\">") && page.contains("href=\"#collapse\""));
}
