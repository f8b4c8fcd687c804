//! Fill that presses is a range, and an assessment rests on its lower end.

use crate::stage::{Stage, number};
use serde_json::Value;

const FILL: &str =
    "[fill_pressure]\nfriction_angle = \"35 deg\"\ncohesion = \"5 kPa\"\nmobilisation = 1.0\napplies = true\n\n";

/// The check of a code in an assessment.
fn check<'a>(answer: &'a Value, code: &str) -> &'a Value {
    let found = answer["checks"].as_array().and_then(|all| all.iter().find(|check| check["code"] == code));
    found.unwrap_or_else(|| panic!("{code} was not made: {answer}"))
}

/// The two numbers of a line such as "0.700 by weight alone, 1.300 with fill pressure".
fn ends(message: &str) -> [f64; 2] {
    let before = |words: &str| {
        let line = message.split(words).next().expect("a line");
        line.rsplit(' ').find(|word| !word.is_empty()).and_then(|word| word.parse().ok()).expect("a number")
    };
    [before(" by weight alone"), before(" with fill pressure")]
}

/// Checks of the file's loads and of vehicles have the values of the same file whose fill does not press; both ends are told.
#[test]
fn an_assessment_rests_on_the_lower_end_of_fill_pressure() {
    let stage = Stage::with_example("pressure", "bridgemill");
    let text = stage.read("bridge/assess.toml");
    let text = text[..text.find("[mexe]").expect("the factors of MEXE")]
        .replacen("voussoirs = 62", "voussoirs = 24", 1)
        .replacen("discrete_elements = true", "vehicles = [\"cs454-bogie-10\", \"cs454-single\"]\nstep = \"1.5 m\"", 1)
        .replacen("[dispersal]", &format!("{FILL}[dispersal]"), 1);
    assert!(text.contains("voussoirs = 24") && text.contains("step = \"1.5 m\"") && text.contains(FILL));
    stage.write("bridge/presses.toml", &text);
    stage.write("bridge/bare.toml", text.replacen("applies = true", "applies = false", 1));
    let assessed = |name: &str| {
        let ending = stage.run(&["assess", &format!("bridge/{name}.toml"), "--skip", "sensitivity", "--out", name]);
        assert!(matches!(ending.code, Some(0 | 1)), "{}", ending.stderr);
        serde_json::from_str::<Value>(&stage.read(&format!("{name}/result.json"))).expect("a result")
    };
    let [presses, bare] = ["presses", "bare"].map(assessed);
    let differ = |code: &&str| {
        let [with, without] = [&presses, &bare].map(|answer| check(answer, code));
        let same = number(with, "value") == number(without, "value");
        !same || (&with["utilisation"], &with["met"]) != (&without["utilisation"], &without["met"])
    };
    let higher: Vec<&str> = ["C201", "C202", "C204"].into_iter().filter(differ).collect();
    assert!(higher.is_empty(), "{higher:?} rest on the upper end: {presses}");
    let of = |answer: &Value| -> Vec<String> {
        let all = answer["warnings"].as_array().into_iter().flatten();
        all.filter(|w| w["code"] == "A195").map(|w| w["message"].as_str().unwrap_or_default().to_owned()).collect()
    };
    assert!(of(&bare).is_empty(), "{:?}", of(&bare));
    let said: Vec<String> = of(&presses).into_iter().filter(|line| line.contains(" by weight alone")).collect();
    assert_eq!(said.len(), 2, "the loads of the file, and vehicles: {said:?}");
    for line in &said {
        let [alone, pressing] = ends(line);
        assert!(pressing > 1.02 * alone, "the ends lie apart, so that it matters which one counts: {line}");
    }
}
