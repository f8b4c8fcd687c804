//! What the command says of every example, searched for slips of grammar: "1 vehicles", "[]", "braking are left out".

use crate::stage::Stage;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Verbs that end like plurals, and what follows a factor.
const NO_PLURALS: [&str; 18] = [
    "is", "was", "has", "does", "lies", "stands", "needs", "acts", "bears", "carries", "gives", "slides", "yields",
    "flows", "repeats", "times", "takes", "holds",
];

/// Slips in a text for people.
fn slips(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in text.lines() {
        // A number with a colon names what follows ("span 1: springings at"); it counts nothing.
        let words: Vec<&str> = line
            .split_whitespace()
            .map(|word| if word.ends_with(':') { ":" } else { word.trim_matches(['(', ')', ',', ';', '.']) })
            .collect();
        for pair in words.windows(2) {
            let plural = |word: &str| {
                word.len() > 3
                    && word.ends_with('s')
                    && !word.ends_with("ss")
                    && word.chars().all(|c| c.is_ascii_lowercase())
            };
            if pair[0] == "1" && plural(pair[1]) && !NO_PLURALS.contains(&pair[1]) {
                found.push(format!("`1 {}`: {line}", pair[1]));
            }
        }
        for three in words.windows(3) {
            if three[0] == "1" && ["are", "were", "have", "do"].contains(&three[2]) {
                found.push(format!("`{}`: {line}", three.join(" ")));
            }
        }
        for part in ["[]", "braking are", "traction is"] {
            if line.contains(part) {
                found.push(format!("`{part}`: {line}"));
            }
        }
    }
    found
}

/// Sentences of an answer: warnings and assumptions.
fn sentences(answer: &Value) -> Vec<&str> {
    let warnings =
        answer["warnings"].as_array().into_iter().flatten().filter_map(|warning| warning["message"].as_str());
    let assumptions = answer["assumptions"].as_array().into_iter().flatten().filter_map(Value::as_str);
    warnings.chain(assumptions).collect()
}

/// Every file of the examples that describes something.
fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let folders = std::fs::read_dir(root).expect("examples").flatten().map(|entry| entry.path());
    let inside = folders.filter_map(|folder| std::fs::read_dir(folder).ok()).flat_map(|folder| folder.flatten());
    let mut files: Vec<PathBuf> =
        inside.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    files.sort();
    files
}

#[test]
fn slips_are_found() {
    let wrong = ["a rule: 1 vehicles by", "1 joint are open", "(1 entities)", "smallest []", "braking are left out"];
    assert!(wrong.iter().all(|text| slips(text).len() == 1), "{:?}", wrong.map(slips));
    let right = [
        "1 vehicle by rule",
        "11 vehicles",
        "0.1 metres",
        "span 1 is",
        "span 1: springings at",
        "1 times as much",
        "1 joint is open",
        "2 joints are open",
    ];
    assert!(right.iter().all(|text| slips(text).is_empty()), "{:?}", right.map(slips));
}

#[test]
fn what_is_said_of_every_example_has_no_slip() {
    let stage = Stage::new("words-examples");
    let mut found = Vec::new();
    for file in files() {
        let file = file.display().to_string();
        let plain = stage.run(&["check", &file, "--out", "out"]);
        let (answer, _) = stage.object(&["check", &file, "--out", "out"]);
        found
            .extend(slips(&plain.stdout).into_iter().chain(slips(&plain.stderr)).map(|slip| format!("{file}: {slip}")));
        for sentence in sentences(&answer) {
            found.extend(slips(sentence).into_iter().map(|slip| format!("{file}: {slip}")));
            if sentence.contains("  ") {
                found.push(format!("{file}: two blanks: {sentence}"));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn what_is_said_of_one_of_each_has_no_slip() {
    let stage = Stage::with_example("words-one", "tiny");
    let ring = Stage::with_example("words-ring", "semicircle").read("bridge/ring.toml");
    stage.write("ring.toml", format!("{ring}\n[[vary]]\nquantity = \"span[1].voussoirs\"\nvalues = [40]\n"));
    stage.write("one.dxf", "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n90\n3\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n0\n20\n1\n0\nENDSEC\n0\nEOF\n");
    let mut found = Vec::new();
    for words in [
        &["collapse", "bridge/bridge.toml", "--method", "limit"][..],
        &["collapse", "bridge/bridge.toml", "--method", "path"],
        &["collapse", "bridge/bridge.toml", "--method", "limit", "--sweep"],
        // Its answer is a share of the radius, without a unit.
        &["vary", "ring.toml"],
        &["convert", "one.dxf", "one.toml"],
        &["convert", "bridge/bridge.toml", "blocks.toml"],
    ] {
        let ending = stage.run(words);
        assert!(matches!(ending.code, Some(0..=2)), "{words:?}: {}", ending.stderr);
        found.extend(
            slips(&ending.stdout).into_iter().chain(slips(&ending.stderr)).map(|slip| format!("{words:?}: {slip}")),
        );
    }
    assert!(found.is_empty(), "{found:#?}");
}
