//! A survey as a file, and the file as a survey.

use super::*;
use crate::quantity;
use std::collections::BTreeMap;

fn of(answers: &[(&str, &str)]) -> Result<String, Vec<Unusable>> {
    let of = |key: &str| answers.iter().find(|(name, _)| *name == key).map(|(_, text)| (*text).to_owned());
    file("Mill Lane", &of)
}

#[test]
fn the_examples_make_a_file_without_errors_that_says_what_is_assumed() {
    let all: Vec<(&str, &str)> = QUESTIONS.iter().map(|one| (one.key, one.example)).collect();
    let five = &all[..5];
    for answers in [&all[..], five, &[five, &[("backing", "0.8 m"), ("axle", "11.5")][..]].concat()] {
        let text = of(answers).unwrap();
        let read = crate::read(text.as_bytes());
        let errors: Vec<_> = read.diagnostics.iter().filter(|one| one.severity == Severity::Error).collect();
        assert!(read.bridge.is_some() && errors.is_empty(), "{errors:?}\n{text}");
        assert_eq!(text.contains("assumed: the survey says nothing"), answers.len() < 10, "{text}");
    }
}

#[test]
fn feet_are_taken_and_slips_are_named() {
    let feet = [("span", "20 ft"), ("rise", "5 ft"), ("thickness", "18 in"), ("width", "16' 6\""), ("cover", "1.5 ft")];
    let text = of(&feet).unwrap();
    let read = crate::read(text.as_bytes());
    assert!(read.bridge.is_some());
    // What is assumed beside them is in feet as well: nobody is asked about a mixture.
    assert!(read.diagnostics.iter().all(|one| one.code != "P033"), "{:?}\n{text}", read.diagnostics);
    assert!(text.contains("width = \"16.5 ft\"\n") && text.contains("contact_length = \"0.984 ft\""), "{text}");
    let wrong = of(&[("span", "six"), ("rise", "3 kN"), ("thickness", "0.4"), ("width", "")]).unwrap_err();
    let keys: Vec<&str> = wrong.iter().map(|one| one.key.as_str()).collect();
    assert_eq!(keys, ["span", "rise", "width", "cover"]);
    let hostile = file("\"]\n[x]\\", &|key| feet.iter().find(|one| one.0 == key).map(|one| one.1.to_owned())).unwrap();
    assert!(crate::read(hostile.as_bytes()).bridge.is_some(), "{hostile}");
}

/// Every answer, of one span and of several, with every kind of number that no bridge has.
#[test]
fn a_value_out_of_range_is_a_finding_at_its_answer() {
    let of_all = |more: &[(&str, &str)], key: &str| {
        let piers = [("spans", "2"), ("pier_width", "1.5 m"), ("pier_height", "4 m")];
        let usual = QUESTIONS.iter().map(|one| (one.key, one.example)).chain(piers);
        more.iter().copied().chain(usual).find(|one| one.0 == key).map(|one| one.1.to_owned())
    };
    assert!(findings("x", &|asked| of_all(&[], asked)).is_empty());
    let keys: Vec<&str> =
        QUESTIONS.iter().chain(&PIER).map(|one| one.key).chain(["span_2", "rise_2", "thickness_2"]).collect();
    for key in keys {
        for wrong in ["-1", "-0.001", "1e9", "1e300"] {
            let found = findings("x", &|asked| of_all(&[(key, wrong)], asked));
            // What is as the first is wrong with it, and no second finding.
            assert!(!found.is_empty() && found.iter().all(|one| one.key == key), "{key} = {wrong}: {found:?}");
            assert!(found[0].message.starts_with(&format!("{key}: ")), "{found:?}");
            let is_error = found[0].severity == Severity::Error;
            assert_eq!(is_error, file("x", &|asked| of_all(&[(key, wrong)], asked)).is_err());
            assert!(is_error || !wrong.starts_with('-'), "{key} = {wrong}: {found:?}");
        }
        // Depths that a bridge may lack are left out of its file, and all others are a finding.
        let lacks = ["cover", "backing"].contains(&key);
        assert_eq!(file("x", &|asked| of_all(&[(key, "0")], asked)).is_ok(), lacks, "{key} = 0");
    }
    for (key, rare, severity) in [("density", "22", Severity::Warning), ("unit", "2 m", Severity::Warning)] {
        let found = findings("x", &|asked| of_all(&[(key, rare)], asked));
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].key == key && found[0].severity == severity, "{found:?}");
    }
}

/// What is said to be usual is what the reader takes without a question, from one end to the other.
#[test]
fn both_ends_of_what_is_usual_are_taken_without_a_question() {
    let piers = [("spans", "2"), ("pier_width", "1.5 m"), ("pier_height", "4 m")];
    let found = |key: &str, value: &str| {
        let usual = QUESTIONS.iter().map(|one| (one.key, one.example)).chain(piers);
        let given: Vec<(&str, &str)> = std::iter::once((key, value)).chain(usual).collect();
        findings("x", &|asked| given.iter().find(|one| one.0 == asked).map(|one| one.1.to_owned()))
    };
    // Shares of the span of 6 m, times of the width of 1.5 m, seven stones of its ring of 6.95 m.
    let ends = [
        ("rise", ["0.5 m", "3 m"]),
        ("thickness", ["0.15 m", "0.6 m"]),
        ("width", ["1 m", "40 m"]),
        ("cover", ["0 m", "3 m"]),
        ("unit", ["0.1 m", "0.99 m"]),
        ("density", ["1500 kg/m^3", "3000 kg/m^3"]),
        ("strength", ["0.5 MPa", "400 MPa"]),
        ("axle", ["10 kN", "450 kN"]),
        ("pier_height", ["1.5 m", "18 m"]),
        ("rings", ["1", "8"]),
        ("bond", ["0 kPa", "2000 kPa"]),
        ("fill_density", ["1000 kg/m^3", "2700 kg/m^3"]),
        ("skew", ["0 deg", "10 deg"]),
    ];
    for question in QUESTIONS.iter().chain(&PIER).chain(&MORE).filter(|one| !one.usual.is_empty()) {
        let (_, both) = ends.iter().find(|one| one.0 == question.key).unwrap();
        for end in both {
            assert_eq!(found(question.key, end), [], "{} = {end}", question.key);
        }
        let written: Vec<&str> = question.usual.split(" to ").filter(|end| quantity::parse(end).is_ok()).collect();
        assert!(written.is_empty() || written == both, "{}: {written:?}", question.usual);
    }
}

#[test]
fn weights_per_volume_and_tonnes_are_taken_as_they_are_written() {
    let five: Vec<(&str, &str)> = QUESTIONS[..5].iter().map(|one| (one.key, one.example)).collect();
    let text = of(&[&five[..], &[("density", "22 kN/m3"), ("axle", "11.5 t")]].concat()).unwrap();
    let bridge = crate::read(text.as_bytes()).bridge.unwrap_or_else(|| panic!("{text}"));
    assert!((bridge.masonry.density - 22e3 / 9.81).abs() < 1e-9, "{text}");
    assert!(text.contains("axle_force = \"11.5 t\"\n"), "{text}");
}

const VIADUCT: [(&str, &str); 9] = [
    ("span", "9.14 m"),
    ("rise", "2.44 m"),
    ("thickness", "0.46 m"),
    ("width", "8.2 m"),
    ("cover", "0.6 m"),
    ("spans", "3"),
    ("pier_width", "1.5 m"),
    ("pier_height", "5 m"),
    ("rise_3", "2.1 m"),
];

#[test]
fn spans_have_piers_between_them_and_what_nobody_measured_of_the_others_is_assumed() {
    let text = of(&VIADUCT).unwrap();
    let read = crate::read(text.as_bytes());
    let errors: Vec<_> = read.diagnostics.iter().filter(|one| one.severity == Severity::Error).collect();
    let bridge = read.bridge.unwrap_or_else(|| panic!("{errors:?}\n{text}"));
    assert_eq!((bridge.spans.len(), bridge.piers.len()), (3, 2), "{text}");
    assert_eq!(text.matches("rise = \"2.44 m\"  # assumed: as span 1").count(), 1, "{text}");
    assert!(text.contains("rise = \"2.1 m\"\n"), "{text}");
    assert_eq!(text.matches("height = \"5 m\"  # assumed: as pier 1").count(), 1, "{text}");
}

#[test]
fn nothing_is_assumed_of_the_first_pier_and_one_span_asks_for_none() {
    let of_one: Vec<_> = VIADUCT.into_iter().filter(|one| one.0 != "spans").collect();
    assert!(!of(&of_one).unwrap().contains("[[pier]]"));
    let no_pier: Vec<_> = VIADUCT.into_iter().filter(|one| !one.0.starts_with("pier")).collect();
    let keys: Vec<String> = of(&no_pier).unwrap_err().into_iter().map(|one| one.key).collect();
    assert_eq!(keys, ["pier_width", "pier_height"]);
    for (key, answer) in [("spans", "0"), ("spans", "21"), ("spans", "two"), ("rise_3", "high")] {
        let slip: Vec<_> = VIADUCT.into_iter().filter(|one| one.0 != key).chain([(key, answer)]).collect();
        let wrong = of(&slip).unwrap_err();
        assert_eq!((wrong.len(), wrong[0].key.as_str()), (1, key), "{answer}");
    }
}

#[test]
fn a_rule_goes_with_its_vehicles_or_with_all_and_no_vehicle_without_a_rule() {
    let five: Vec<(&str, &str)> = QUESTIONS[..5].iter().map(|one| (one.key, one.example)).collect();
    let with = |more: &[(&'static str, &'static str)]| of(&[&five[..], more].concat());
    assert!(!with(&[]).unwrap().contains("[sweep]"));
    let text = with(&[("rule", "cs-454"), ("vehicles", "cs454-single, hb-45")]).unwrap();
    let plan = crate::read(text.as_bytes()).bridge.and_then(|bridge| bridge.sweep).unwrap();
    assert_eq!(
        (plan.rule.as_str(), &plan.vehicles[..]),
        ("cs-454", &["cs454-single".to_owned(), "hb-45".to_owned()][..])
    );
    let all = crate::read(with(&[("rule", "cs-454")]).unwrap().as_bytes()).bridge.and_then(|bridge| bridge.sweep);
    assert_eq!(all.map(|plan| (plan.rule, plan.vehicles)), Some(("cs-454".to_owned(), Vec::new())));
    assert_eq!(with(&[("vehicles", "hb-45")]).unwrap_err()[0].key, "rule");
}

/// What a survey may know beside the ten, all at once.
const ALL: [(&str, &str); 9] = [
    ("name", "Mill Lane"),
    ("reference", "ABC1/0123"),
    ("rings", "4"),
    ("bond", "150 kPa"),
    ("fill", "old-fill"),
    ("fill_density", "19 kN/m3"),
    ("skew", "12 deg"),
    ("lost_mortar", "30 mm"),
    ("condition", "crack below the east wall"),
];

fn all() -> Vec<(&'static str, &'static str)> {
    let ten: Vec<_> = QUESTIONS.iter().map(|one| (one.key, one.example)).filter(|one| one.0 != "backing").collect();
    [&ten[..], &[("backing", "0.8 m")], &ALL].concat()
}

#[test]
fn rings_skew_fill_and_condition_are_of_the_bridge() {
    let text = of(&all()).unwrap();
    let read = crate::read(text.as_bytes());
    let bridge = read.bridge.unwrap_or_else(|| panic!("{:?}\n{text}", read.diagnostics));
    assert_eq!(bridge.spans[0].rings.len(), 4, "{text}");
    assert!((bridge.spans[0].rings[0].crown_thickness - 0.1125).abs() < 1e-9, "{text}");
    assert!((bridge.spans[0].skew.to_degrees() - 12.0).abs() < 1e-9, "{text}");
    assert!(bridge.spans[0].defects.len() == 1 && text.contains("structure_number = \"ABC1/0123\""), "{text}");
    assert!(read.diagnostics.iter().any(|one| one.code == "P060"), "a skew bridge is doubtful");
    let wrong = of(&[&all()[..5], &[("fill", "sand"), ("rings", "40"), ("skew", "12 m")]].concat()).unwrap_err();
    let keys: Vec<&str> = wrong.iter().map(|one| one.key.as_str()).collect();
    assert_eq!(keys, ["rings", "skew", "fill"], "{wrong:?}");
}

fn map(list: &[(&str, &str)]) -> BTreeMap<String, String> {
    list.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect()
}

/// Every answer comes back out of its file as it was given, and nothing that was assumed does.
#[test]
fn a_file_gives_back_the_answers_that_made_it() {
    for given in [
        all(),
        VIADUCT.to_vec(),
        [&VIADUCT[..], &[("rings", "3"), ("thickness_2", "0.5 m"), ("unit", "0.35 m")]].concat(),
        [&all()[..5], &[("spans", "1"), ("rings", "1"), ("backing", "0 m"), ("lost_mortar", "0 mm")]].concat(),
        [&all()[..5], &[("rule", "cs-454"), ("vehicles", "cs454-single,hb-45")]].concat(),
    ] {
        let text = of(&given).unwrap();
        let mut want = map(&given);
        want.entry("name".into()).or_insert("Mill Lane".into());
        let found: BTreeMap<String, String> = answers(&text).unwrap();
        let plain = |all: &BTreeMap<String, String>| -> Vec<String> {
            all.iter()
                .map(|(key, value)| format!("{key} {}", value.trim_end_matches(" mm").trim_end_matches(" m")))
                .collect()
        };
        assert_eq!(plain(&found), plain(&want), "{text}");
    }
}

/// What stands in the file besides stays, and an answer changes what it says and nothing else.
#[test]
fn an_answer_is_given_to_a_file_that_was_changed_elsewhere() {
    let text = of(&all()).unwrap();
    // As a handle or the form writes it, a remark, a table of one's own.
    let mut file = crate::edit::Document::parse(&text).unwrap();
    file.set(&crate::path::Path::parse("span[1].span").unwrap(), "\"6.4 m\"").unwrap();
    let theirs = file.text().replace("[masonry]\n", "# cores of 2024\n[masonry]\n")
        + "\n[fill_pressure]\nfriction_angle = \"30 deg\"\n";
    assert_eq!(answers(&theirs).unwrap()["span"], "6.4 m");
    let now = changed(&theirs, &map(&[("rise", "1.7 m"), ("cover", "0.7 m")])).text.unwrap();
    let found = answers(&now).unwrap();
    assert_eq!((&found["span"][..], &found["rise"][..], &found["cover"][..]), ("6.4 m", "1.7 m", "0.7 m"), "{now}");
    assert!(now.contains("# cores of 2024") && now.contains("[fill_pressure]"), "{now}");
    // Further spans come and go, with their piers; an answer is taken away.
    let several = map(&[("spans", "3"), ("pier_width", "1.5 m"), ("pier_height", "4 m")]);
    let three = changed(&now, &several).text.unwrap();
    assert_eq!(
        crate::read(three.as_bytes()).bridge.map(|bridge| (bridge.spans.len(), bridge.piers.len())),
        Some((3, 2))
    );
    assert!(three.contains("# cores of 2024"), "{three}");
    let one = changed(&three, &map(&[("spans", "1"), ("skew", ""), ("backing", "0")])).text.unwrap();
    let found = answers(&one).unwrap();
    assert!(!one.contains("[[pier]]") && !one.contains("[carriageway]") && !one.contains("[backing]"), "{one}");
    assert_eq!((&found["spans"][..], &found["backing"][..], found.get("skew")), ("1", "0", None), "{one}");
    assert!(crate::read(one.as_bytes()).bridge.is_some(), "{one}");
}

/// Nothing looks as if somebody had measured it before somebody did.
#[test]
fn a_survey_begins_with_assumptions_alone() {
    for (key, value) in [("span", "7 m"), ("rise", "5 ft")] {
        let begun = start("A bridge");
        assert_eq!(answers(&begun).unwrap(), BTreeMap::new(), "{begun}");
        assert_eq!(begun.matches("# assumed: an example to begin with").count(), 5, "{begun}");
        let now = changed(&begun, &map(&[(key, value)])).text.unwrap();
        assert_eq!(answers(&now).unwrap(), map(&[(key, value)]), "{now}");
        let read = crate::read(now.as_bytes());
        assert!(read.diagnostics.iter().all(|one| one.severity != Severity::Error && one.code != "P033"), "{now}");
    }
}

#[test]
fn an_answer_that_cannot_be_taken_says_why() {
    let text = of(&all()).unwrap();
    let refused = |text: &str, key: &str, value: &str| {
        let found = changed(text, &map(&[(key, value)]));
        assert_eq!(found.text, None, "{key} = {value}");
        (found.findings[0].key.clone(), found.findings[0].message.clone())
    };
    assert_eq!(refused(&text, "rise", "high").0, "rise");
    // What is taken away is assumed again, and marked.
    assert!(changed(&text, &map(&[("span", "")])).text.unwrap().contains("span = \"6.00 m\"  # assumed: an example"));
    assert_eq!(refused(&text, "spans", "2").0, "pier_width");
    assert!(refused(&format!("{text}[masonry"), "rise", "1.4 m").1.contains("the text of the file has an error"));
    // Another shape has no rise: it is left out, and an answer for it is refused with the reason.
    let round = text.replace("segmental", "semicircular").replace("rise = \"1.50 m\"\n", "");
    assert!(changed(&round, &BTreeMap::new()).findings.iter().all(|one| one.severity != Severity::Error));
    assert!(changed(&round, &map(&[("axle", "90 kN")])).text.is_some());
    assert!(refused(&round, "rise", "1.4 m").1.contains("changed by hand"));
}
