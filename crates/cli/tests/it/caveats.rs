//! What the pages of `docs/` say against a method stands in the results that it concerns; `docs/theory/limits.md` lists it.

use crate::stage::Stage;
use serde_json::Value;

fn assumes(answer: &Value, words: &str) -> bool {
    answer["assumptions"]
        .as_array()
        .is_some_and(|all| all.iter().any(|one| one.as_str().is_some_and(|text| text.contains(words))))
}

fn warns(answer: &Value, code: &str) -> bool {
    answer["warnings"].as_array().is_some_and(|all| all.iter().any(|one| one["code"] == code))
}

#[test]
fn every_collapse_says_what_a_plane_model_on_fixed_supports_leaves_out() {
    let stage = Stage::with_example("caveats-tiny", "tiny");
    let (answer, _) = stage.object(&["collapse", "bridge/bridge.toml", "--method", "limit"]);
    for words in ["spreading, settlement, bearing and scour", "under a wheel", "lean or slide outwards"] {
        assert!(assumes(&answer, words), "{words}: {}", answer["assumptions"]);
    }
    assert!(!warns(&answer, "A124"), "one ring shares nothing");
}

#[test]
fn cover_says_what_it_does_not_do() {
    let stage = Stage::with_example("caveats-cover", "two-span");
    let (answer, _) = stage.object(&["collapse", "bridge/bridge.toml", "--method", "limit"]);
    assert!(warns(&answer, "A111") && warns(&answer, "A102"), "{}", answer["warnings"]);
}

#[test]
fn loads_of_rings_that_slide_are_no_bound_and_say_so() {
    let stage = Stage::with_example("caveats-rings", "two-ring");
    let (answer, _) = stage.object(&["collapse", "bridge/bridge.toml", "--method", "limit"]);
    assert!(warns(&answer, "A124"), "{}", answer["warnings"]);
    assert!(assumes(&answer, "and no bound"), "{}", answer["assumptions"]);
}

/// The pages on the left name the caveats that the table lists, and every test that the table names exists.
#[test]
fn the_table_of_caveats_names_pages_and_tests_that_exist() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let table = std::fs::read_to_string(root.join("docs/theory/limits.md")).expect("the page");
    let mut sources = String::new();
    collect(&root.join("crates"), &mut sources);
    let mut rows = 0;
    for row in table.lines().filter(|line| line.starts_with("| [")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let page = cells[1].split(['(', ')']).nth(1).expect("a link");
        let page = page.split('#').next().expect("a path");
        assert!(root.join("docs/theory").join(page).is_file(), "{row}");
        for test in cells[4].split(',').map(|name| name.trim().trim_matches('`')) {
            assert!(sources.contains(&format!("fn {test}(")), "no test {test}: {row}");
        }
        rows += 1;
    }
    assert!(rows >= 20, "{rows} rows");
}

fn collect(folder: &std::path::Path, text: &mut String) {
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, text);
        } else if path.extension().is_some_and(|e| e == "rs") {
            text.push_str(&std::fs::read_to_string(&path).unwrap_or_default());
        }
    }
}
