//! A report of a made-up bridge, with every section filled and texts that a markup language would choke on.

use crate::world::Memory;
use serde_json::{Value, json};
use typst::layout::{Frame, FrameItem};
use typst_layout::PagedDocument;

/// Would stop the typesetter, vanish, or turn into something else, were it read as markup or code.
const HOSTILE: &str =
    "#panic(\"read as code\") *not bold* $x^2$ @nobody <label> `raw` // no comment \\ [a] {b} ~ _ \u{e9}";

fn check(met: bool, governs: bool) -> Value {
    json!({
        "code": "C101", "title": "deflection", "load": "train of 25 t", "value": "1.30", "limit": "1.25", "unit": "mm", "used": "104 %",
        "bar": 100, "met": met, "governs": governs, "basis": HOSTILE, "of": "worst of 4, 1 not met"
    })
}

/// A section of words and a table with as many columns as heads, two where it has none.
fn part(opens: bool, heads: Value) -> Value {
    let columns = heads.as_array().map_or(2, |heads| heads.len().max(2));
    let row: Vec<&str> = (0..columns)
        .map(|k| {
            if k == 1 {
                HOSTILE
            } else if k == 2 {
                ""
            } else {
                "row"
            }
        })
        .collect();
    let numbers: Vec<bool> = (0..columns).map(|k| k == 1).collect();
    json!({ "title": "A section", "words": [HOSTILE], "heads": heads, "numbers": numbers, "rows": [row, row], "opens": opens })
}

fn data() -> Value {
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"160mm\" height=\"40mm\" viewBox=\"0 0 160 40\" font-family=\"DejaVu Sans\">\
               <path d=\"M0 40 A80 80 0 0 1 160 40\" fill=\"none\" stroke=\"black\"/><text x=\"60\" y=\"30\">crown</text></svg>";
    let tall = svg.replace("height=\"40mm\" viewBox=\"0 0 160 40\"", "height=\"640mm\" viewBox=\"0 0 160 640\"");
    let drawing = json!([{ "caption": "A drawing", "svg": svg }, { "caption": HOSTILE, "svg": tall }]);
    let stage = json!({ "name": "built", "state": "made", "seconds": "0.1 s", "key": "ab".repeat(32) });
    let input = json!({ "section": "span[1]", "key": "intrados_thickness_at_the_springing", "value": "0.5 m", "remark": HOSTILE });
    let mut data = json!({
        "bridge": HOSTILE, "status": "inadequate", "headline": "Not adequate", "whole": "C101 is not met: 104\u{a0}% of its limit.",
        "missing": [HOSTILE], "beside": [HOSTILE], "qualifications": [HOSTILE, "fill acts by its weight alone (A111)"],
        "limits_source": "a test", "augment": "augment", "checks": [check(false, true), check(true, false)],
        "every": vec![check(true, false); 60], "open": [{ "code": "C102", "title": "stress", "why": HOSTILE, "failed": true }],
        "columns": [{ "what": "deflection", "cells": ["1", "2", "3", "4", "5"], "limit": "6", "unit": "mm", "place": "crown" }],
        "condition": [{ "parameter": "fill", "before": "100 MPa", "after": "170 MPa", "interval": "160 to 180", "expected": "50 to 120 MPa",
            "standing": "higher than expected", "class": "open", "words": "It was grouted.", "source": "a test" }],
        "update_words": [HOSTILE], "fit": [{ "name": "w".repeat(300), "unit": "mm", "measured": "1", "start": "2", "updated": "1",
            "shape": "0.999", "remark": "" }],
        "readings": [{ "sensor": HOSTILE, "position": HOSTILE, "unit": "mm", "read": "-0.3", "start": "-0.2", "updated": "-0.31" }],
        "runs": ["run 1: measured"], "channels": [{ "load": "train", "name": "crown", "unit": "mm", "cells": ["1", "2", "3", "4"] }],
        "loads": [["train", "25 t", "completed", HOSTILE]], "collapse": [["method", "limit"], ["ended", HOSTILE]],
        "vehicles": [{ "code": "V1", "title": HOSTILE, "adequacy": "0.9", "class": "broken", "width": "2.5", "factor": "1.9",
            "position": "3.1", "case": "one lane" }],
        "rule": "a rule", "factors": [["axles", "1.9", HOSTILE]], "discrete_elements": "0.88", "movement": [["support", "pier 1"]],
        "changes": [{ "path": "span[1].thickness", "value": "0.5 m", "less": "120 %", "more": "90 %", "turns": true }],
        "changes_words": "Utilisation of the governing check.", "findings": [["P001", HOSTILE, "line 3"]],
        "warnings": [["collapse", "A101", HOSTILE]], "assumptions": [["collapse", HOSTILE]], "inputs": vec![input; 40],
        "appendix": { "version": "0.1.0", "program": "cd".repeat(32), "file": "bridge.toml", "input": "ef".repeat(32),
            "command": "extrados assess bridge.toml --skip update", "day": "2026-11-21", "stages": [stage] },
        "figures": { "built": drawing, "update": drawing, "service": drawing, "ultimate": drawing, "vehicles": drawing, "movement": drawing, "cases": drawing }
    });
    data["front"] = json!([part(true, json!([])), part(false, json!(["", "name", "signature"]))]);
    data["cases"] = json!([part(true, json!(["case", "factor"]))]);
    data["numbers"] = json!([part(true, json!(["part", "force [kN]"]))]);
    data["back"] = json!([part(true, json!(["no.", "item", "independent value"]))]);
    data["left_out"] = json!([part(true, json!(["what", "why not", "to have it"])), part(false, json!(["why not", "checks"]))]);
    data["left_out"][1]["title"] = json!("Checks that were not made");
    data["figures"]["summary"] = json!([drawing[1]]);
    data["summary"] = json!({
        "governs": HOSTILE, "place": HOSTILE, "mechanism": HOSTILE, "vehicles": data["vehicles"], "more_vehicles": "and 2 more, all carried",
        "grades": [HOSTILE], "rule_of_thumb": HOSTILE, "checks": [check(false, true)], "more_checks": "", "next": HOSTILE, "doubts": [HOSTILE],
        "more_doubts": "and 1 more", "signatures": [["assessed", HOSTILE], ["checked", ""], ["approved", ""]]
    });
    data["inputs_words"] = json!(HOSTILE);
    data["stands"] = json!([part(false, json!(["load", "first axle at [m]"]))]);
    data
}

/// The texts of a frame in the order in which they were set.
fn texts(frame: &Frame, out: &mut String) {
    for (_, item) in frame.items() {
        match item {
            FrameItem::Text(text) => out.push_str(&text.text),
            FrameItem::Group(group) => texts(&group.frame, out),
            _ => {}
        }
    }
}

/// Pages and what stands on them, without blanks.
fn laid_out(data: &Value) -> (usize, String) {
    let world = Memory::new(data.to_string()).expect("a world");
    let set = typst::compile::<PagedDocument>(&world);
    let document = set.output.unwrap_or_else(|said| panic!("{said:?}"));
    let words: Vec<String> = set.warnings.iter().map(|one| one.message.to_string()).collect();
    assert!(words.is_empty(), "{words:?}");
    let mut text = String::new();
    for page in document.pages() {
        texts(&page.frame, &mut text);
    }
    typst::comemo::evict(0);
    (document.pages().len(), squeezed(&text))
}

/// Blanks and places where a word may be broken are no part of what is said.
fn squeezed(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace() && *c != '\u{200b}').collect()
}

#[test]
fn every_section_is_set_and_no_text_is_markup() {
    let (pages, text) = std::thread::Builder::new()
        .stack_size(crate::STACK)
        .spawn(|| laid_out(&data()))
        .expect("a thread")
        .join()
        .expect("a layout");
    assert!(pages > 3, "{pages} pages");
    for words in [
        "Not adequate",
        "104 % of its limit",
        "Checks that were not made",
        "It was grouted.",
        "Every comparison",
        "2026-11-21",
    ] {
        assert!(text.contains(&squeezed(words)), "the report does not say {words}: {text}");
    }
    let hostile = text.matches(&squeezed(HOSTILE)).count();
    assert!(hostile >= 10, "{hostile} in {text}");
    for field in [&"cd".repeat(32), &"ef".repeat(32), "extrados assess bridge.toml --skip update", "--skip"] {
        assert!(text.contains(&squeezed(field)), "the appendix does not say {field}");
    }
}

#[test]
fn the_same_strings_are_the_same_bytes() {
    let data = data();
    let first = crate::pdf(&data).expect("a PDF");
    assert!(first.starts_with(b"%PDF-"));
    assert_eq!(crate::pdf(&data).expect("a PDF"), first);
}

/// A report with nothing in it but what every report has: chapters without anything in them are not there.
#[test]
fn empty_chapters_are_left_out() {
    let mut bare = data();
    for (_, value) in bare.as_object_mut().expect("an object") {
        match value {
            Value::Array(list) => list.clear(),
            Value::Object(figures) if figures.contains_key("built") => {
                figures.values_mut().for_each(|list| *list = json!([]));
            }
            _ => {}
        }
    }
    let pdf = crate::pdf(&bare).expect("a PDF");
    assert!(pdf.starts_with(b"%PDF-"));
    let text = std::thread::Builder::new().stack_size(crate::STACK).spawn(move || laid_out(&bare).1);
    let text = text.expect("a thread").join().expect("a layout");
    for chapter in ["Condition", "Measurements and fit", "Loads in service", "Collapse"] {
        assert!(!text.contains(&squeezed(chapter)), "{chapter}: {text}");
    }
}

#[test]
fn what_cannot_be_set_is_an_answer() {
    let mut broken = data();
    broken["figures"]["built"][0]["svg"] = json!("no drawing");
    let error = crate::pdf(&broken).expect_err("no drawing");
    assert!(error.to_string().to_lowercase().contains("svg"), "{error}");
    assert!(crate::pdf(&json!({})).is_err());
}
