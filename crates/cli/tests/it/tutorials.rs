//! What the tutorials say is what the command does: every command line is understood, quick ones are run, and their answers are
//! those of the page.

use crate::pictures::is_drawn;
use crate::stage::{Stage, number};
use std::fs;
use std::path::{Path, PathBuf};

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn page(name: &str) -> String {
    let path = docs().join("tutorials").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Fenced blocks of a page with the word behind their fence.
fn blocks(page: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open: Option<(String, String)> = None;
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (Some(_), Some(_)) => found.extend(open.take()),
            (None, Some(word)) => open = Some((word.to_owned(), String::new())),
            (Some((_, text)), None) => *text += &format!("{line}\n"),
            (None, None) => {}
        }
    }
    found
}

/// The words of a command line: quotes hold words together.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut quoted) = (vec![String::new()], false);
    for letter in line.split(" #").next().unwrap_or_default().chars() {
        match letter {
            '"' => quoted = !quoted,
            ' ' if !quoted => words.push(String::new()),
            other => words.last_mut().expect("one at least").push(other),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Every command line of a page, without the program's name.
fn commands(page: &str) -> Vec<Vec<String>> {
    let all = blocks(page).into_iter().flat_map(|(_, text)| text.lines().map(str::to_owned).collect::<Vec<_>>());
    all.filter_map(|line| line.strip_prefix("extrados ").map(words)).collect()
}

#[test]
fn every_command_line_of_every_page_is_understood() {
    let stage = Stage::new("tutorials-lines");
    let root = docs().join("..");
    let mut pages = vec![root.join("README.md"), docs().join("gallery.md")];
    for folder in ["tutorials", "input", "theory", "verification"] {
        let entries = fs::read_dir(docs().join(folder)).expect("pages").flatten();
        pages.extend(entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "md")));
    }
    let mut seen = 0;
    for path in pages {
        let text = fs::read_to_string(&path).expect("a page");
        // A block whose lines were filled like a paragraph's holds two commands in one.
        for line in blocks(&text).iter().flat_map(|(_, text)| text.lines()) {
            let command = line.split('#').next().unwrap_or_default();
            assert!(command.matches("extrados ").count() < 2, "{}: {line}", path.display());
        }
        for words in commands(&text) {
            // Words in capitals stand for something, dots for more.
            let stands_for = |word: &String| word.contains('…') || (word.len() > 2 && *word == word.to_uppercase());
            if words.iter().any(|word| stands_for(word) && !word.chars().any(|c| c.is_ascii_digit())) {
                continue;
            }
            // No file is there, so that nothing is computed: what is not understood is told before.
            let runs = ["new", "explain", "schema", "bench", "verify"].contains(&words[0].as_str());
            let line: Vec<&str> = words.iter().map(String::as_str).collect();
            if runs && words[0] != "new" {
                continue;
            }
            let (answer, ending) = stage.object(&line);
            let code = answer["errors"][0]["code"].as_str().unwrap_or_default();
            assert_ne!(code, "F107", "{}: extrados {}: {}", path.display(), words.join(" "), ending.stderr);
            let folder = stage.folder.join(words.get(1).map_or("", String::as_str));
            if words[0] == "new" {
                assert_eq!(ending.code, Some(0), "{}: {}", path.display(), ending.stderr);
                fs::remove_dir_all(folder).expect("the example goes again");
            }
            seen += 1;
        }
    }
    assert!(seen >= 20, "{seen} command lines");
}

/// The page's file, with what section 5 adds to it.
fn mill_lane(stage: &Stage) -> (String, String) {
    let page = page("first-bridge.md");
    let toml: Vec<String> =
        blocks(&page).into_iter().filter(|(word, _)| word == "toml").map(|(_, text)| text).collect();
    stage.write("mill-lane.toml", &toml[0]);
    let stiff = toml[0].replace("cohesion = \"0 kPa\"\n", &format!("cohesion = \"0 kPa\"\n{}", toml[1]));
    (page, format!("{stiff}\n[analysis]\n{}", toml[2]))
}

/// The number before a word in a page.
fn told(page: &str, before: &str, after: &str) -> f64 {
    let start = page.find(before).unwrap_or_else(|| panic!("the page does not say {before:?}")) + before.len();
    let end = page[start..].find(after).expect("the number ends") + start;
    page[start..end].trim().parse().unwrap_or_else(|_| panic!("{:?} is no number", &page[start..end]))
}

#[test]
fn the_first_bridge_is_as_its_page_tells() {
    let stage = Stage::new("tutorials-first");
    let (page, stiff) = mill_lane(&stage);
    assert_eq!(stage.run(&["check", "mill-lane.toml"]).code, Some(0));
    is_drawn(&stage.read("out/mill-lane/bridge.svg"), "mill-lane-bridge.svg");
    let text = stage.read("mill-lane.toml");
    for (slip, line) in [("rise = \"1.5 MPa\"", "rise"), ("thicknes = \"0.45 m\"", "thicknes")] {
        let key = line.trim_end_matches(" ");
        let old = if key == "rise" { "rise = \"1.5 m\"" } else { "thickness = \"0.45 m\"" };
        stage.write("slip.toml", text.replacen(old, slip, 1));
        let (answer, ending) = stage.object(&["check", "slip.toml"]);
        let at = 1 + text.lines().position(|one| one == old).expect("the line is there");
        let lines: Vec<u64> =
            answer["errors"].as_array().into_iter().flatten().filter_map(|e| e["line"].as_u64()).collect();
        assert!(ending.code == Some(2) && lines.contains(&(at as u64)), "{slip}: {}", ending.stderr);
    }
    stage.write("doubt.toml", text.replacen("rise = \"1.5 m\"", "rise = \"150 mm\"", 1));
    let (answer, ending) = stage.object(&["check", "doubt.toml"]);
    let doubted = answer["warnings"].as_array().is_some_and(|all| !all.is_empty());
    assert!(ending.code == Some(0) && doubted, "{answer}");

    let ending = stage.run(&["collapse", "mill-lane.toml", "--details"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    is_drawn(&stage.read("out/mill-lane/mechanism.svg"), "mill-lane-mechanism.svg");
    assert!(ending.stdout.contains("figures: ") && ending.stdout.contains("mechanism"), "{}", ending.stdout);
    assert_eq!(stage.run(&["collapse", "mill-lane.toml", "--sweep"]).code, Some(0));
    let names = stage.names("out/mill-lane");
    assert!(["envelope.svg", "sweep.csv"].iter().all(|name| names.contains(&(*name).to_owned())), "{names:?}");
    is_drawn(&stage.read("out/mill-lane/envelope.svg"), "mill-lane-envelope.svg");
    stage.write("mill-lane.toml", stiff);
    let (answer, ending) = stage.object(&["collapse", "mill-lane.toml", "--method", "dem", "--resolution", "1 kN/m"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    let load = told(&page, "The last stable load, ", " kN/m");
    let found = [number(&answer, "last_stable_load_kn_per_m"), number(&answer, "collapse_load_kn_per_m")];
    assert!(found.iter().any(|one| (one - load).abs() <= 1.0), "the page says {load}, the command {found:?}");
}

/// The cells of the row of a table that begins with these words.
fn row(page: &str, begins: &str) -> Vec<f64> {
    let line = page.lines().find(|line| line.starts_with(&format!("| {begins}"))).expect("the row");
    line.split('|').filter_map(|cell| cell.trim().parse().ok()).collect()
}

#[test]
fn two_methods_answer_as_their_page_tells() {
    let stage = Stage::with_example("tutorials-two", "bridgemill");
    let page = page("two-methods.md");
    let run = |more: &[&str], out: &str| {
        let words = ["collapse", "bridge/case-1.toml", "--out", out];
        let (answer, ending) = stage.object(&words.iter().chain(more).copied().collect::<Vec<_>>());
        assert_eq!(ending.code, Some(0), "{more:?}: {}", ending.stderr);
        answer
    };
    let near = |found: f64, told: f64| (found - told).abs() <= 0.006;
    let dem = run(&[], "dem");
    let cells = row(&page, "discrete elements, steps");
    assert!(near(number(&dem, "last_stable_load_kn_per_m"), cells[0]), "{cells:?} {dem}");
    assert!(near(number(&dem, "collapse_load_kn_per_m"), cells[1]), "{cells:?} {dem}");
    for (begins, more) in [
        ("limit analysis, contact points 0.691 m apart", vec!["--method", "limit"]),
        ("limit analysis, full ring", vec!["--method", "limit", "--contact-points", "full-ring"]),
    ] {
        let limit = run(&more, "limit");
        let told = row(&page, begins)[0];
        assert!(near(number(&limit, "collapse_load_kn_per_m"), told), "{told} {limit}");
    }
}

/// Runs a command line of a page as it stands there, and gives its answer.
fn answered(stage: &Stage, page: &str, line: &str) -> (serde_json::Value, Option<i32>) {
    let words = words(line.strip_prefix("extrados ").expect("a command line"));
    assert!(commands(page).contains(&words), "the page does not have {line}");
    let (answer, ending) = stage.object(&words.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(matches!(ending.code, Some(0 | 1)), "{line}: {}", ending.stderr);
    (answer, ending.code)
}

#[test]
fn settings_that_move_no_load_step_move_none() {
    let stage = Stage::new("tutorials-settings");
    let page = page("two-methods.md");
    answered(&stage, &page, "extrados new b --from bridgemill");
    let told = row(&page, "discrete elements, steps");
    for more in ["--tolerance 1e-5", "--damping adaptive", "--contact-length updated"] {
        let (answer, _) = answered(&stage, &page, &format!("extrados collapse b/case-1.toml {more}"));
        let loads = ["last_stable_load_kn_per_m", "collapse_load_kn_per_m"].map(|key| number(&answer, key));
        assert!(
            (loads[0] - told[0]).abs() <= 0.006 && (loads[1] - told[1]).abs() <= 0.006,
            "{more}: {loads:?} {told:?}"
        );
        let stress = format!("{:.1} MPa", number(&answer, "max_compressive_stress_mpa"));
        let length = if more.ends_with("updated") { "with one that follows" } else { "with a fixed contact length" };
        assert!(page.contains(&format!("{stress} {length}")), "{more}: {stress} {length}");
    }
    // The second table is of case 2.
    let second = page.split("| discrete elements |").nth(1).expect("the table of case 2");
    let cells: Vec<f64> = second
        .lines()
        .next()
        .into_iter()
        .flat_map(|line| line.split('|'))
        .filter_map(|cell| cell.trim().parse().ok())
        .collect();
    for (method, keys) in
        [("dem", &["last_stable_load_kn_per_m", "collapse_load_kn_per_m"][..]), ("limit", &["collapse_load_kn_per_m"])]
    {
        let (answer, ending) = stage.object(&["collapse", "b/case-2.toml", "--method", method]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        let found: Vec<f64> = keys.iter().map(|key| number(&answer, key)).collect();
        let told = if method == "dem" { cells.clone() } else { vec![376.35] };
        assert!(
            found.iter().zip(&told).all(|(a, b)| (a - b).abs() <= 0.05) && found.len() == told.len(),
            "{found:?} {told:?}"
        );
    }
    assert!(page.contains("| 376.35 |"));
}

#[test]
fn a_train_crosses_as_its_page_tells() {
    let stage = Stage::new("tutorials-respond");
    let page = page("respond.md");
    answered(&stage, &page, "extrados new arch --from railway-arch");
    let (answer, _) = answered(&stage, &page, "extrados respond arch/passage.toml --records slow.csv");
    assert_eq!(answer["status"], "completed", "{answer}");
    // The six channels of the railway paper, where the file has no sensors; each says its sign.
    let channels = answer["channels"].as_array().expect("channels");
    assert!(
        channels.iter().all(|one| one["about"].as_str().is_some_and(|words| words.contains("positive"))),
        "{answer}"
    );
    let first = stage.read("slow.csv").lines().next().unwrap_or_default().to_owned();
    for part in ["synthetic", "200 Hz", "0.01 mm", "0.05 microstrain", "seed 1", "passage.toml", "paper-short"] {
        assert!(first.contains(part), "{part} is not in {first}");
    }
    let names = stage.names("out/passage");
    let table = page.split("## What is written").nth(1).and_then(|rest| rest.split("\n\n").nth(1)).expect("the table");
    for name in table.lines().skip(2).filter_map(|line| line.split('|').nth(1)).flat_map(|cell| cell.split('`')) {
        let (folder, file) = name.rsplit_once('/').unwrap_or(("", name));
        let (start, end) = file.split_once('N').unwrap_or((file, ""));
        let known = match folder {
            "" => names.clone(),
            folder => stage.names(&format!("out/passage/{folder}")),
        };
        let there = known.iter().any(|one| one.starts_with(start.trim()) && one.contains(end));
        assert!(name.trim().is_empty() || name.trim() == "," || there, "{name}: {known:?}");
    }
    assert_eq!(commands(&page).len(), 3, "`respond` without --records does the same");
    is_drawn(&stage.read("out/passage/influence-lines.svg"), "passage-influence-lines.svg");
    // The drawing of a moment has ten thousand lines: the page has it in pixels, and under it the words that stand in it.
    let moment = stage.read("out/passage/moment-1-displacement.svg").replace("</text>", "\n");
    let words: Vec<&str> = moment.lines().filter_map(|line| line.rsplit_once('>')).map(|(_, words)| words).collect();
    let title = words.iter().find(|words| words.starts_with("Displacement, peak of")).expect("its title");
    assert!(page.contains(&format!("![{title}](../images/passage-moment.png)")), "make the picture anew: {title}");
}

#[test]
fn records_are_judged_as_their_page_tells() {
    let stage = Stage::new("tutorials-records");
    let page = page("update.md");
    answered(&stage, &page, "extrados new arch --from railway-arch");
    let (answer, code) = answered(&stage, &page, "extrados update arch/update.toml --records-only");
    let doubts =
        answer["records"]["findings"].as_array().expect("findings").iter().filter(|one| one["severity"] != "note");
    assert_eq!(
        (code, doubts.count() > 0),
        (Some(i32::from(answer["status"] == "inadequate")), answer["status"] == "inadequate"),
        "{answer}"
    );
    assert!(
        !answer["records"]["peaks"].as_array().expect("peaks").is_empty() && answer["records"]["dynamics"].is_object()
    );
    assert_eq!(
        (number(&answer, "evaluations"), answer["error_norm"].is_null()),
        (1.0, true),
        "the start model, and no search"
    );
}

#[test]
fn a_folder_of_bridges_is_assessed_as_its_page_tells() {
    let stage = Stage::new("tutorials-fleet");
    let page = page("assess.md");
    assert_eq!(stage.run(&["new", "bridges", "--from", "tiny"]).code, Some(0));
    stage.write("bridges/broken.toml", "[bridge]\nname = 3\n");
    let line = "extrados assess bridges/";
    let words = words(line.strip_prefix("extrados ").expect("a command"));
    assert!(commands(&page).contains(&words));
    let (answer, ending) = stage.object(&words.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!((number(&answer, "bridges"), &answer["unusable"][0]["file"]), (2.0, &"broken.toml".into()), "{answer}");
    assert_eq!(ending.code, Some(3), "a file that cannot be used leaves the fleet undetermined");
    let html = stage.read("out/bridges-fleet/fleet.html");
    assert!(html.contains("broken") && html.contains("report.html"), "broken files are rows, others have a report");
}

#[test]
fn a_bridge_is_judged_as_its_page_tells() {
    let stage = Stage::new("tutorials-assess");
    let text = page("assess.md");
    answered(&stage, &text, "extrados new arch --from railway-arch");
    let (answer, code) = answered(&stage, &text, "extrados assess arch/assess.toml --skip update");
    assert_eq!((code, answer["headline"].as_str()), (Some(1), Some("Undetermined")), "{answer}");
    let head = answer["head"].as_str().expect("a line");
    assert!(text.contains(head) && text.contains("The exit code is 1."), "{head}");
    assert!(answer["missing"].as_array().is_some_and(|words| !words.is_empty()), "{answer}");
    let checks = answer["checks"].as_array().expect("checks");
    for load in ["25t", "30t"] {
        assert!(checks.iter().any(|one| one["load_model"].as_str().is_some_and(|of| of.starts_with(load))), "{load}");
    }
    assert!(checks.iter().all(|one| one["met"] == true), "{answer}");
    let report = stage.read("out/assess/report.html").to_lowercase();
    assert!(report.contains(&head.to_lowercase()[..12]));
}

#[test]
fn moduli_are_found_as_their_page_tells() {
    let stage = Stage::new("tutorials-update");
    let text = page("update.md");
    answered(&stage, &text, "extrados new arch --from railway-arch");
    let (answer, _) = answered(&stage, &text, "extrados update arch/update.toml");
    assert_eq!(
        (answer["status"].as_str(), answer["uncertainty_from"].as_str()),
        (Some("completed"), Some("linearised"))
    );
    // The first line of the records: voussoirs, fill, haunch fill, abutment fill, mortar of the paper's Table 6, without noise.
    let truth = [13.2, 170.0, 3.0, 850.0, 0.972];
    assert!(stage.read("arch/table-6.csv").starts_with("# synthetic"));
    let found = answer["parameters"].as_array().expect("parameters").iter().map(|one| number(one, "value"));
    assert!(found.zip(truth).all(|(found, truth)| (found / truth - 1.0).abs() < 0.01), "{}", answer["parameters"]);
    for one in answer["parameters"].as_array().expect("parameters") {
        assert!(one["standard_deviation"].is_f64() && one["interval_95"].is_array(), "{one}");
        assert!(!(one["at_bound"] == true && one["converged"] == true), "{one}");
    }
    is_drawn(&stage.read("out/update/histories.svg"), "update-histories.svg");
    for name in ["result.json", "histories.csv", "evaluations.log"] {
        assert!(stage.names("out/update").contains(&name.to_owned()), "{name}");
    }
}

/// The whole of a line of the page.
fn says(page: &str, line: &str) {
    assert!(page.lines().any(|one| one == line), "the page does not have the line {line:?}");
}

#[test]
fn a_load_test_goes_as_its_page_tells() {
    let stage = Stage::new("tutorials-load-test");
    let page = page("load-test.md");
    answered(&stage, &page, "extrados new road --from road-bridge");
    let checked = stage.run(&["check", "road/bridge.toml", "--quiet"]);
    assert_eq!(checked.stderr, "", "a file of an example is not doubted");
    let told = checked.stdout.lines().skip_while(|line| !line.starts_with("  position "));
    let told: Vec<&str> = told.take_while(|line| !line.starts_with("This")).filter(|line| !line.is_empty()).collect();
    assert_eq!(told.len(), 15, "{told:?}");
    told.into_iter().for_each(|line| says(&page, line));
    let (answer, _) = answered(&stage, &page, "extrados collapse road/bridge.toml");
    assert!(page.contains(&format!("{:.3} times the loads", number(&answer, "load_factor"))), "{answer}");
    is_drawn(&stage.read("out/bridge/mechanism.svg"), "road-bridge-mechanism.svg");
    let (answer, _) = answered(&stage, &page, "extrados respond road/bridge.toml");
    let sensors = ["left quarter deflection", "crown deflection", "right quarter deflection", "crown strain"];
    let positions = answer["positions"].as_array().expect("positions");
    for position in positions {
        let cells = sensors.map(|sensor| format!("{:>12.4}", number(&position["channels"], sensor)));
        let name = position["name"].as_str().expect("a name");
        says(&page, &format!("  {name:<39}{}", cells.concat()));
    }
    let (answer, _) = answered(&stage, &page, "extrados update road/bridge.toml");
    is_drawn(&stage.read("out/bridge/residuals.svg"), "load-test-residuals.svg");
    assert!(stage.read("road/load-test.csv").starts_with("# synthetic: "));
    // The first line of the readings: what they were computed with.
    for (begins, truth) in [("stone", 11.5), ("mortar", 0.8), ("fill", 140.0)] {
        let list = answer["parameters"].as_array().expect("parameters");
        let one = list.iter().find(|one| one["name"] == begins).expect("a parameter");
        let interval: Vec<f64> =
            one["interval_95"].as_array().into_iter().flatten().filter_map(serde_json::Value::as_f64).collect();
        assert!(interval[0] < truth && truth < interval[1], "{one}");
        // The interval of the mortar is about half of its range.
        assert!(begins == "mortar" || one["identifiable"] == true, "{one}");
        let cells = row(&page, begins);
        let found = [truth, number(one, "value"), interval[0], interval[1]];
        assert!(
            cells.len() == 4 && cells.iter().zip(found).all(|(a, b)| (a / b - 1.0).abs() < 0.01),
            "{cells:?} {one}"
        );
    }
    assert!(page.contains(&format!("norm {:.4}", number(&answer, "error_norm"))), "{}", answer["error_norm"]);
    let (answer, code) = answered(&stage, &page, "extrados assess road/bridge.toml");
    let head = answer["head"].as_str().expect("a line");
    assert!(code == Some(1) && page.contains(head), "{head}");
    let judged = stage.read("out/bridge/checks.csv");
    let report = stage.read("out/bridge/report.html");
    assert!(
        report.contains("Readings of the load test") && report.contains("errors in multiples of their uncertainty")
    );
    assert_eq!(report.matches("data-name=\"read\"").count(), 24);
    // Moduli are no part of the limit load.
    answered(&stage, &page, "extrados assess road/bridge.toml --skip update");
    assert_eq!(judged, stage.read("out/bridge/checks.csv"));
}

#[test]
#[ignore = "a minute; .ci/slow"]
fn a_load_test_that_is_planned_otherwise_tells_what_its_page_says() {
    let stage = Stage::with_example("tutorials-load-test-planned", "road-bridge");
    let text = stage.read("bridge/bridge.toml");
    let found = |name: &str, text: String| {
        stage.write(&format!("bridge/{name}.toml"), text);
        let (answer, ending) = stage.object(&["update", &format!("bridge/{name}.toml")]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        answer["parameters"].as_array().expect("parameters").clone()
    };
    let told =
        |name: &str, text: String| found(name, text).iter().map(|one| one["identifiable"] == true).collect::<Vec<_>>();
    // Of stone, mortar and fill.
    let level = text.replace("deflection\" = \"0.01 mm\"", "deflection\" = \"0.1 mm\"");
    assert_eq!(told("level", level), [true, false, false]);
    let alone = format!("{text}\n[[channel]]\nsensor = \"crown strain\"\nleave_out = \"no gauge\"\n");
    assert_eq!(told("alone", alone), [false, false, true]);
    let unweighed = text.replace("common_gain_deviation = 0.05", "common_gain_deviation = 0.1");
    let unweighed = told("unweighed", unweighed);
    assert!(!unweighed[0] && !unweighed[2], "{unweighed:?}");
    let wide = text.replace("[\"3.80 m\"]", "[\"3.80 m\"]\neffective_width = \"3.3 m\"");
    let wide: Vec<f64> = found("wide", wide).iter().map(|one| number(one, "value")).collect();
    assert!(wide.iter().zip([8.7, 0.41, 88.0]).all(|(a, b)| (a / b - 1.0).abs() < 0.02), "{wide:?}");
}

/// A page that gains a command is run by a test above, or by that of `vary`.
#[test]
fn every_command_of_every_tutorial_has_a_test_that_runs_it() {
    let run = [
        // The report as PDF is set in `assess.rs`.
        ("assess.md", 4),
        ("checking.md", 0),
        ("first-bridge.md", 4),
        // The verdict before the test is that of `examples.rs`.
        ("load-test.md", 7),
        // The run is that of `pictures.rs`.
        ("pictures.md", 2),
        ("respond.md", 3),
        // Files are checked and carried in `examples.rs`, cases in `cases.rs`; the reports take minutes and more.
        ("two-bridges.md", 7),
        ("two-methods.md", 8),
        ("update.md", 3),
        ("vary.md", 4),
        ("workbench.md", 0),
    ];
    let mut pages: Vec<String> = fs::read_dir(docs().join("tutorials"))
        .expect("pages")
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".md"))
        .collect();
    pages.sort();
    assert_eq!(pages, run.map(|(name, _)| name));
    for (name, count) in run {
        assert_eq!(commands(&page(name)).len(), count, "{name}: let a test run what is new, then count it here");
    }
}

#[test]
fn verification_outside_a_clone_says_where_the_cases_are() {
    let stage = Stage::new("tutorials-verify");
    let (answer, ending) = stage.object(&["verify"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F111")), "{answer}");
    assert!(answer["errors"][0]["help"].as_str().is_some_and(|help| help.contains("clone")), "{answer}");
    stage.write("notes.md", "somebody's notes");
    let (answer, _) = stage.object(&["verify", "--manual", "notes.md"]);
    assert_eq!(answer["errors"][0]["code"], "F119", "{answer}");
    assert_eq!(stage.read("notes.md"), "somebody's notes");
}
