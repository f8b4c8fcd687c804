//! Field tests beside their predictions.

use crate::stage::Stage;
use std::path::Path;

/// The folder of field tests of the source.
fn field_tests() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation").display().to_string()
}

#[test]
fn one_bridge_by_weight_gives_table_figure_and_object() {
    let stage = Stage::new("validate-one");
    let words = ["validate", &field_tests(), "--only", "prestwood", "--methods", "weight", "--out", "found"];
    let (answer, ending) = stage.object(&words);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{}", ending.stderr);
    assert_eq!(answer["schema"], "extrados.validate/1");
    let test = &answer["tests"][0];
    assert_eq!((test["name"].as_str(), test["test_kn"].as_f64()), (Some("prestwood"), Some(228.0)));
    let one = &test["predictions"][0];
    let [load, over] = ["prediction_kn", "prediction_over_test"].map(|key| one[key].as_f64().expect(key));
    assert!((over - load / 228.0).abs() < 1e-9 && load > 50.0 && load < 228.0, "{one}");
    let end = |key: &str, at: usize| one[key][at].as_f64().expect(key);
    assert!(end("interval_kn", 0) < load && load < end("interval_kn", 1), "{one}");
    assert!(end("interval_with_dimensions_kn", 0) <= end("interval_kn", 0), "{one}");
    assert_eq!(answer["statistics"][0]["tests"], 1);
    let files =
        ["cache", "record.json", "result.json", "tables.xlsx", "validation.csv", "validation.png", "validation.svg"];
    assert_eq!(stage.names("found"), files);
    assert!(
        stage.read("found/validation.csv").lines().nth(1).is_some_and(|row| row.starts_with("prestwood,228,weight,"))
    );
    // The complete bridge file of a prediction gives the same load by itself.
    stage.write("again.toml", one["bridge_file"].as_str().expect("a bridge file"));
    let (again, _) = stage.object(&["collapse", "again.toml"]);
    assert!((again["headline_kn"].as_f64().expect("a load") / load - 1.0).abs() < 1e-9, "{}", again["headline_kn"]);
    // For people: the careful side is said.
    let ending = stage.run(&words);
    assert!(ending.stdout.contains("weight predicts no more than the test carried, for any of 1"), "{}", ending.stdout);
}

#[test]
fn a_folder_without_tests_is_refused_in_words() {
    let stage = Stage::new("validate-none");
    let (answer, ending) = stage.object(&["validate"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F131")), "{answer}");
    assert!(answer["errors"][0]["help"].as_str().is_some_and(|help| help.contains("clone")), "{answer}");
    let (answer, ending) = stage.object(&["validate", &field_tests(), "--only", "forth"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F131")), "{answer}");
    std::fs::create_dir(stage.folder.join("arch")).expect("a folder");
    stage.write("priors.toml", std::fs::read(Path::new(&field_tests()).join("priors.toml")).expect("the priors"));
    let (answer, ending) = stage.object(&["validate", "."]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F132")), "{answer}");
    let message = answer["errors"][0]["message"].as_str().unwrap_or_default();
    assert!(message.contains("arch") && message.contains("test.toml"), "{message}");
    let (answer, ending) = stage.object(&["validate", ".", "--methods", "magic"]);
    assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some("F107")), "{answer}");
}
