//! A verdict on strength needs factors with a source: what is said without them, and what is missing then.

use crate::stage::{Ending, Stage, number};
use crate::tiny::BRIDGE;
use serde_json::Value;

/// A bridge of a test with further sections, assessed without sensitivities.
fn assessed(name: &str, sections: &str) -> (Stage, Value, Ending) {
    let stage = Stage::new(name);
    stage.write("bridge.toml", format!("{BRIDGE}{sections}"));
    let words = ["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity", "--skip", "service"];
    let (answer, ending) = stage.object(&words);
    (stage, answer, ending)
}

fn missing(answer: &Value) -> String {
    answer["missing"].as_array().expect("a list").iter().filter_map(Value::as_str).collect::<Vec<_>>().join("; ")
}

fn check<'a>(answer: &'a Value, code: &str) -> Option<&'a Value> {
    answer["checks"].as_array().expect("checks").iter().find(|one| one["code"] == code)
}

/// Loads without any factor are carried by the tiny bridge several times over; still nothing says that it is safe.
#[test]
fn nominal_loads_give_no_verdict() {
    let (stage, answer, ending) = assessed("verdict-nominal", "\n[sweep]\nvehicles = [\"cs454-single\"]\n");
    assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("undetermined")), "{answer}");
    assert_eq!(answer["strength_assessed"], false);
    assert!(missing(&answer).contains("characteristic") && missing(&answer).contains("rule ="), "{answer}");
    assert!(number(&answer["vehicles"]["vehicles"][0], "adequacy") > 1.0, "the vehicle is carried");
    assert!(check(&answer, "C204").is_none(), "loads without factors pass no check");
    assert!(stage.read("out/report.html").contains("Undetermined (vehicles not compared"));
    assert_eq!(answer["head"].as_str().map(|head| head.starts_with("Undetermined (")), Some(true), "{answer}");
}

/// Factors of working stresses are 1: safety lies in stresses, and a collapse load compared with 1 has none.
#[test]
fn working_stress_rules_are_not_compared_with_collapse_at_one() {
    let sweep = "\n[sweep]\nrule = \"irs-bridge-rules\"\nvehicles = [\"25t-2008\"]\n";
    let (_, answer, ending) = assessed("verdict-working", &format!("{sweep}[assess]\nadequacy_factor = 1.0\n"));
    let adequacy = number(&answer["vehicles"]["vehicles"][0], "adequacy");
    if adequacy > 1.0 {
        assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("undetermined")), "{answer}");
    }
    assert_eq!(answer["strength_assessed"], false);
    assert!(missing(&answer).contains("irs-bridge-rules"), "{answer}");
}

/// What fails without factors fails with them.
#[test]
fn a_bridge_that_fails_under_nominal_loads_is_inadequate() {
    let sections = "\n[sweep]\nvehicles = [\"cs454-single\"]\n";
    let stage = Stage::new("verdict-nominal-fails");
    stage.write(
        "bridge.toml",
        format!("{}{sections}", BRIDGE.replace("thickness = \"0.5 m\"", "thickness = \"0.12 m\"")),
    );
    let (answer, ending) =
        stage.object(&["assess", "bridge.toml", "--skip", "sensitivity", "--skip", "service", "--skip", "collapse"]);
    assert!(answer["vehicles"]["vehicles"][0]["adequacy"].as_f64().is_none_or(|factor| factor < 1.0), "{answer}");
    assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("inadequate")), "{answer}");
    assert_eq!(check(&answer, "C204").expect("it is compared")["met"], false);
}

/// A file whose only limit is a deflection: the limit is met, and nothing is said of strength.
#[test]
fn a_deflection_alone_is_no_verdict_on_strength() {
    let stage = Stage::new("verdict-deflection");
    stage.write("bridge.toml", format!("{BRIDGE}\n[assess]\ndeflection_limit = \"5 mm\"\n"));
    let ending = stage.run(&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"]);
    assert_eq!(ending.code, Some(1), "{}", ending.stdout);
    assert!(ending.stdout.contains("Limits met; strength not asked for"), "{}", ending.stdout);
    let page = stage.read("out/report.html");
    assert!(page.contains("<strong>Limits met; strength not asked for</strong>"));
    let answer: Value = serde_json::from_str(&stage.read("out/result.json")).expect("an object");
    assert_eq!((&answer["status"], &answer["strength_assessed"]), (&"undetermined".into(), &false.into()));
    assert!(check(&answer, "C101").expect("C101")["met"] == true && !missing(&answer).is_empty());
    let codes: Vec<&str> =
        answer["warnings"].as_array().into_iter().flatten().filter_map(|w| w["code"].as_str()).collect();
    assert!(codes.contains(&"A190"), "{codes:?}");
}

/// A factor on the loads of the file counts with the document that it is from, and not without.
#[test]
fn a_factor_counts_with_its_source() {
    let bare = "\n[assess]\nadequacy_factor = 2.5\n";
    let (_, answer, ending) = assessed("verdict-bare-factor", bare);
    assert!(check(&answer, "C201").expect("C201")["met"] == true);
    assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("undetermined")), "{answer}");
    assert!(missing(&answer).contains("adequacy_source"), "{answer}");
    let sourced = format!("{bare}adequacy_source = \"brief of this test, clause 1\"\n");
    let (_, answer, ending) = assessed("verdict-sourced-factor", &sourced);
    assert_eq!((ending.code, &answer["status"]), (Some(0), &Value::from("adequate")), "{answer}");
    assert_eq!((&answer["strength_assessed"], missing(&answer).as_str()), (&true.into(), ""));
    // A factor of 1 is none, whoever says so; loads that carry their factor say which.
    let nominal = sourced.replace("2.5", "1.0");
    let (_, answer, ending) = assessed("verdict-factor-of-one", &nominal);
    assert_eq!((ending.code, &answer["status"]), (Some(1), &Value::from("undetermined")), "{answer}");
    let (_, answer, _) = assessed("verdict-factor-carried", &format!("{nominal}load_factor_included = 2.5\n"));
    assert_eq!(answer["status"], "adequate", "{answer}");
}

/// Under a rule the verdict stands, and what qualifies it stands beside it in the box and on the screen.
#[test]
fn what_qualifies_a_verdict_stands_beside_it() {
    let sweep = "\n[sweep]\nrule = \"cs-454\"\nvehicles = [\"cs-454\"]\nstep = \"0.25 m\"\n";
    let (stage, answer, _) = assessed("verdict-qualified", sweep);
    assert_eq!((&answer["strength_assessed"], &answer["by"]), (&true.into(), &"cs-454".into()), "{answer}");
    let list = |key: &str| -> Vec<String> {
        let texts = answer[key].as_array().expect("a list").iter().filter_map(Value::as_str);
        texts.map(str::to_owned).collect()
    };
    let beside = list("beside").join("; ");
    let factors = list("factors_to_confirm");
    assert!(factors.iter().any(|factor| factor == "live load of cs-454 1.9"), "{factors:?}");
    assert_eq!(answer["to_confirm"], factors.len(), "{answer}");
    let head = answer["head"].as_str().expect("a line");
    let named = format!("Adequate by CS 454 ({} factors to be confirmed", factors.len());
    assert!(head.starts_with(&named) && head.contains("skew not given"), "{head}");
    assert!(beside.contains("live load of cs-454 1.9") && beside.contains("record: 7 bridges"), "{beside}");
    let told = list("qualifications");
    assert!(told.iter().any(|words| words.contains("weight alone")), "{told:?}");
    let page = stage.read("out/report.html");
    let verdict = &page[page.find("id=\"verdict\"").expect("a box")..page.find("id=\"document\"").expect("its end")];
    let html = head.replace('"', "&#34;");
    assert!(verdict.contains(&html) && verdict.contains("live load of cs-454 1.9"), "{verdict}");
    // The rule's own line says how sure its factors are, not only how sure its title is.
    let rule = answer["vehicles"]["rule"].as_str().expect("a rule");
    assert!(rule.contains("recalled"), "{rule}");
    let shown = stage.run(&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity", "--skip", "service"]);
    assert!(shown.stdout.contains(head) && shown.stdout.lines().count() <= 20, "{}", shown.stdout);
    assert!(shown.stderr.is_empty(), "the first screen is all: {}", shown.stderr);
}

/// The ladder of verdicts is explained where somebody asks for it.
#[test]
fn the_ladder_of_verdicts_is_explained() {
    let stage = Stage::new("verdict-ladder");
    let card = stage.run(&["explain", "A190"]).stdout;
    for word in ["not adequate", "undetermined", "adequate by a named rule", "factors"] {
        assert!(card.contains(word), "{card}");
    }
}

#[test]
fn a_sweep_says_what_grade_the_bridge_has() {
    let stage = Stage::with_example("verdict-grades", "viaduct");
    let text = stage
        .read("bridge/bridge.toml")
        .replace("vehicles = [\"ra\"]", "vehicles = [\"ra8\", \"ra1\", \"en15528-a\"]\nstep = \"1 m\"");
    let text = text.replace("rule = \"nr-civ-025\"", "rule = \"characteristic\"");
    stage.write("bridge/graded.toml", text);
    let (answer, _) = stage.object(&["collapse", "bridge/graded.toml", "--sweep", "--method", "limit"]);
    let grades = answer["grades"].as_array().expect("grades");
    assert_eq!((grades.len(), grades[0]["of"].as_str()), (2, Some("Route Availability")), "{answer}");
    let factor = |k: usize| answer["vehicles"][k]["adequacy_factor"].as_f64().expect("a factor");
    let carried = |grade: &str| grades[0]["carried"].as_array().is_some_and(|all| all.contains(&grade.into()));
    assert_eq!((carried("RA8"), carried("RA1")), (factor(0) >= 1.0, factor(1) >= 1.0), "{answer}");
    assert_eq!(grades[1]["highest"].is_null(), factor(2) < 1.0, "{answer}");
}
