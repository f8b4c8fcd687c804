//! The engine of the page, natively: what crosses the border is right before it crosses.

use extrados::{Unwatched, examples};
use serde_json::{Value, json};
use workbench::document::Document;
use workbench::{analyses, cards, live, reading, records, stepped};

fn tiny() -> Document {
    Document::new("bridge.toml", include_str!("../../../../examples/tiny/bridge.toml"))
}

fn value(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// How many shapes a picture has.
fn shapes(picture: &str) -> usize {
    value(picture)["shapes"].as_array().map_or(0, Vec::len)
}

fn quantity(document: &Document, path: &str) -> Value {
    let all = value(&document.quantities());
    let found = all.as_array().and_then(|all| all.iter().find(|one| one["path"] == path));
    found.cloned().unwrap_or_else(|| panic!("{path} is none of {all}"))
}

#[test]
fn every_example_opens_draws_and_lists_its_quantities() {
    for example in examples::ALL {
        for file in example.files.iter().filter(|file| file.name.ends_with(".toml")) {
            let mut document = Document::new(file.name, file.text);
            for other in example.files.iter().filter(|other| other.name != file.name) {
                document.put(other.name, other.text.as_bytes().to_vec());
            }
            let (name, reading) = (format!("{}/{}", example.name, file.name), value(&document.reading()));
            assert_eq!(
                (&reading["usable"], &reading["refusal"]),
                (&Value::Bool(true), &Value::Null),
                "{name}: {reading}"
            );
            let shapes = shapes(&document.picture());
            let drawn = document.drawing();
            assert!(shapes > 5 && drawn.contains("<svg"), "{name}: {} shapes, {:.80}", shapes, drawn);
            if reading["kind"] == "bridge" {
                assert!(value(&document.quantities()).as_array().is_some_and(|all| all.len() > 8), "{name}");
            }
        }
    }
}

#[test]
fn a_value_is_edited_at_its_place_and_everything_else_stays() {
    let text = "# ä comment with a two-unit sign: \u{1f309}\n".to_owned()
        + include_str!("../../../../examples/bridgemill/case-1.toml");
    let mut document = Document::new("bridge.toml", &text);
    let rise = quantity(&document, "span[1].rise");
    assert_eq!((&rise["number"], &rise["unit"], &rise["by_default"]), (&2.85.into(), &"m".into(), &false.into()));
    // Offsets are those of an editor in a browser.
    let units: Vec<u16> = text.encode_utf16().collect();
    let place = ["start", "end"].map(|key| rise[key].as_u64().unwrap() as usize);
    assert_eq!(String::from_utf16_lossy(&units[place[0]..place[1]]), "\"2.85 m\"");
    document.set("span[1].rise", "3.00 m").unwrap();
    assert_eq!(document.text(), text.replace("rise = \"2.85 m\"", "rise = \"3.00 m\""));
    document.set("analysis.method", "limit").unwrap();
    assert!(document.text().contains("method = \"limit\""));
    let before = document.text().to_owned();
    for (path, literal) in [("span[7].rise", "3 m"), ("nowhere", "1"), ("span", "1"), ("bridge.name", "x")] {
        let refused = document.set(path, literal).unwrap_err();
        let refused = refused.0;
        assert!(refused.code.starts_with('B') && !refused.help.is_empty(), "{path}: {refused}");
        assert_eq!(document.text(), before);
    }
    // What is no length is found by the reader, at its place, as if it were typed.
    document.set("span[1].rise", "3 kN").unwrap();
    let reading = value(&document.reading());
    assert_eq!((&reading["usable"], &reading["findings"][0]["code"]), (&false.into(), &"B104".into()));
}

/// A path of a report leads to the value, to the table where it would stand, or nowhere.
#[test]
fn a_path_of_a_report_leads_to_its_place() {
    let text = "# ä\n[assess]\nadequacy_factor = 1.5\n\n[[sensor]]\nname = \"a\"\n[[sensor]]\nname = \"b\"\n[masonry]\ndensity = \"1 t\"\n";
    let units: Vec<u16> = text.encode_utf16().collect();
    let shown = |path: &str| {
        let place = value(&reading::place(text, path));
        let at = ["start", "end"].map(|key| place[key].as_u64().map(|at| at as usize));
        let [Some(start), Some(end)] = at else { return (String::new(), false) };
        (String::from_utf16_lossy(&units[start..end]), place["written"] == true)
    };
    assert_eq!(shown("assess.adequacy_factor"), ("1.5".to_owned(), true));
    assert_eq!(shown("masonry.density"), ("\"1 t\"".to_owned(), true));
    assert_eq!(shown("assess.onset_factor"), ("[assess]".to_owned(), false));
    assert_eq!(shown("sensor[2]"), ("[[sensor]]".to_owned(), true));
    assert!(shown("sensor").0.starts_with("[[sensor]]"));
    assert_eq!(shown("sweep.rule"), (String::new(), false));
    let second = value(&reading::place(text, "sensor[2]"))["start"].as_u64().unwrap() as usize;
    assert_eq!(second, "# ä\n[assess]\nadequacy_factor = 1.5\n\n[[sensor]]\nname = \"a\"\n".encode_utf16().count());
}

/// A table that is filled from the library has the usual values, each with its source beside it, and everything else stays.
#[test]
fn a_table_is_filled_from_the_library_with_sources_beside_the_values() {
    let before = include_str!("../../../../examples/bridgemill/case-1.toml");
    let text = extrados::with_material(before, "masonry", "granite", &["density", "compressive_strength"]).unwrap();
    let (_, masonry) = text.split_once("[masonry]").unwrap();
    let line = |key: &str| masonry.lines().find(|line| line.starts_with(key)).unwrap_or_default().to_owned();
    let density = "\"2650 kg/m^3\"  # not measured: library, granite, 2500 kg/m^3 to 3200 kg/m^3; read: SMART";
    assert!(line("density").contains(density), "{text}");
    assert!(line("compressive_strength").contains("assumed: that of squared sandstone"), "{text}");
    assert_eq!(before.lines().count(), text.lines().count());
    let usable = |text: &str| value(&Document::new("bridge.toml", text).reading())["usable"] == true;
    assert!(usable(&text), "{text}");
    for (table, material, keys) in [
        ("joint", "granite", &["density"][..]),
        ("masonry", "cheese", &["density"]),
        ("masonry", "granite", &["taste"]),
    ] {
        let refused = extrados::with_material(before, table, material, keys).unwrap_err();
        assert!(!refused.help.is_empty(), "{refused}");
    }
    // In a table on one line the remark stands behind the line.
    let tiny = include_str!("../../../../examples/tiny/bridge.toml");
    let filled = extrados::with_material(tiny, "masonry", "sandstone", &["density"]).unwrap();
    assert!(usable(&filled) && filled.contains("not measured: library, sandstone"), "{filled}");
}

/// The cards by which the editor completes say what the JSON Schema of bridge files says: the same tables, keys, words and defaults, and which
/// keys must be there.
#[test]
fn completion_and_schema_say_the_same() {
    let schema = extrados::bridge::schema::schema();
    let sections = value(&cards::keys());
    let sections = sections.as_array().unwrap();
    let mut compared = [0; 3];
    for section in sections {
        let path = section["path"].as_str().unwrap();
        let there = if path.is_empty() { &schema } else { &schema["$defs"][path] };
        let properties = there["properties"].as_object().unwrap_or_else(|| panic!("the schema has no table {path}"));
        let fields = section["fields"].as_array().unwrap();
        let keys: std::collections::BTreeSet<&str> = fields.iter().map(|one| one["key"].as_str().unwrap()).collect();
        assert_eq!(keys, properties.keys().map(String::as_str).collect(), "{path}");
        let required: Vec<&str> = there["required"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        for field in fields {
            let key = field["key"].as_str().unwrap();
            let property = &properties[key];
            let words: Vec<&str> =
                field["words"].as_array().unwrap().iter().filter_map(|one| one["word"].as_str()).collect();
            let listed: Vec<&str> =
                property["enum"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
            assert_eq!(words, listed, "{path}.{key}");
            assert!(!required.contains(&key) || field["need"] == "required", "{path}.{key}");
            assert_eq!(field["default"].is_null(), property.get("default").is_none(), "{path}.{key}");
            compared = [compared[0] + 1, compared[1] + words.len(), compared[2] + required.len()];
        }
    }
    let defined = schema["$defs"].as_object().unwrap().len();
    assert_eq!(sections.len(), defined + 1, "as many tables as definitions, and the file");
    assert!(compared[0] > 250 && compared[1] > 80 && compared[2] > 100, "{compared:?}");
}

#[test]
fn findings_stand_at_their_place() {
    let text = include_str!("../../../../examples/tiny/bridge.toml").replace("rise = \"1.0 m\"", "rise = \"1.0 kN\"");
    let document = Document::new("bridge.toml", &text);
    let reading = value(&document.reading());
    assert_eq!(reading["usable"], false);
    let finding = &reading["findings"][0];
    let units: Vec<u16> = text.encode_utf16().collect();
    let place = ["start", "end"].map(|key| finding[key].as_u64().unwrap() as usize);
    assert_eq!(String::from_utf16_lossy(&units[place[0]..place[1]]), "\"1.0 kN\"");
    assert_eq!((finding["severity"].as_str(), finding["line"].as_u64()), (Some("error"), Some(8)));
    assert!(document.picture() == "null" && document.drawing().is_empty());
    assert!(cards::explained(finding["code"].as_str().unwrap()) != "null");
    assert!(live::Placing::new(&document, "", "", false).is_err());
}

#[test]
fn hostile_texts_do_nothing_worse_than_findings() {
    let deep = format!("a = {}1{}", "[".repeat(5000), "]".repeat(5000));
    let many = "[[span]]\nspan = \"1 m\"\n".repeat(20_000);
    let name = "bridge = { name = \"<script>alert(1)</script>\", width = \"3.0 m\" }";
    let tiny = include_str!("../../../../examples/tiny/bridge.toml")
        .replace("bridge = { name = \"Tiny\", width = \"3.0 m\" }", name);
    for text in [&deep, &many, "\u{0}\u{1}", "span = 1e999", "=", "[a]\n[a]\n", &tiny] {
        let document = Document::new("bridge.toml", text);
        let reading = document.reading();
        assert!(reading.len() < 4_000_000, "{}", reading.len());
        document.quantities();
        assert!(!document.drawing().contains("<script"), "{}", document.drawing());
    }
    for bytes in [&b"0\nSECTION\n2\nENTITIES\n"[..], b"", b"\xff\xfe\x00", b"AutoCAD Binary DXF\r\n\x1a\x00"] {
        assert!(cards::from_drawing("a", bytes).is_err());
        assert!(value(&records::records("a.csv", bytes))["findings"].as_array().is_some_and(|all| !all.is_empty()));
    }
}

#[test]
fn a_survey_becomes_a_bridge_that_answers() {
    let answers = r#"{ "name": "Mill Lane", "span": "6 m", "rise": 1.5, "thickness": "450 mm", "width": "5 m", "cover": "0.5 m" }"#;
    let text = cards::from_survey(answers).unwrap();
    let document = Document::new("mill-lane.toml", &text);
    assert_eq!(value(&document.reading())["usable"], true, "{}", document.reading());
    let mut placing = live::Placing::new(&document, "", "", false).unwrap();
    let [factor, dilatant, ended, _] = placing.factor(1.5)[..] else { panic!("four numbers") };
    assert!(factor > 1.0 && factor <= dilatant && ended == 0.0, "{factor} {dilatant} {ended}");
    let questions = value(&cards::survey_questions());
    assert_eq!(["ten", "pier"].map(|list| questions[list].as_array().map(Vec::len)), [Some(10), Some(2)]);
    assert_eq!(questions["ten"][2]["usual"], "1/40 to 1/10 of the span");
    assert!(cards::from_survey("{}").unwrap_err().0.message.contains("span"));
    // The file answers, and takes an answer; another file is no survey's.
    let begun = cards::survey_start();
    let changed = value(&cards::survey_changed(&begun, r#"{ "span": "7 m" }"#).unwrap());
    assert_eq!(changed["answers"], serde_json::json!({ "span": "7 m" }));
    let refused = value(&cards::survey_changed(changed["text"].as_str().unwrap(), r#"{ "rise": "high" }"#).unwrap());
    assert!(refused["text"].is_null() && refused["findings"][0]["key"] == "rise", "{refused}");
    assert_eq!(cards::survey_changed("[bridge]\n", "{}").unwrap(), "null");
}

#[test]
fn rules_say_for_whom_they_are_and_whether_a_verdict_comes_of_them() {
    let library = value(&cards::library().unwrap());
    let of = |code: &str| {
        let rule = library["rules"].as_array().unwrap().iter().find(|rule| rule["code"] == code).unwrap();
        (rule["ways"].clone(), rule["judges"].clone())
    };
    assert_eq!(of("cs-454"), (json!(["road"]), json!(true)));
    assert_eq!(of("nr-civ-025"), (json!(["rail"]), json!(true)));
    // Working stresses, and no safety at all.
    assert_eq!(of("irs-bridge-rules"), (json!(["rail"]), json!(false)));
    assert_eq!(of("characteristic"), (json!(["road", "rail"]), json!(false)));
    // What a rule without vehicles does not take by itself.
    let by_name = |code: &str| {
        let model = library["models"].as_array().unwrap().iter().find(|model| model["code"] == code).unwrap();
        model["only_by_name"].clone()
    };
    assert_eq!(
        ["cs-454", "gb-restrictions", "lm2", "lm3"].map(by_name),
        [json!(false), json!(true), json!(false), json!(true)]
    );
}

#[test]
fn an_answer_at_a_place_has_flat_numbers_that_fit_its_picture() {
    let document = tiny();
    let mut placing = live::Placing::new(&document, "", "", false).unwrap();
    let answer = placing.at(1.0);
    let shapes = shapes(&document.picture());
    assert_eq!((answer.mechanism().len(), answer.centroids().len()), (3 * shapes, 2 * shapes));
    assert_eq!(answer.thrust().len() % 3, 0);
    assert_eq!(answer.thrust_starts(), [0]);
    assert_eq!(answer.axles().len(), 4);
    assert!(
        answer.loads().len() >= 8 && value(&answer.json())["hinges"].as_array().is_some_and(|hinges| hinges.len() >= 4)
    );
    let zone = placing.zone(1.0, 0.5 * value(&answer.json())["factor"].as_f64().unwrap()).unwrap();
    assert_eq!(zone.len(), answer.thrust().len() / 3 * 4);
    let about = value(&live::Placing::new(&document, "hl-93-truck", "", true).unwrap().about());
    assert_eq!(about["axles"].as_array().map(Vec::len), Some(3), "{about}");
}

#[test]
fn results_hold_every_file_and_an_archive_of_them() {
    let answer = analyses::collapse(&tiny(), "{}", &mut Unwatched).unwrap();
    let result: Value = serde_json::from_str(&answer.json()).unwrap();
    assert_eq!((result["schema"].as_str(), answer.status().as_str()), (Some("extrados.collapse/1"), "collapsed"));
    let names = answer.names();
    for name in ["result.json", "mechanism.svg", "model.dxf", "hinges.csv", "bridge.toml", "paraview/mechanism.vtu"] {
        assert!(names.iter().any(|one| one == name), "{name} in {names:?}");
        assert!(!answer.file(name).unwrap().is_empty());
    }
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(answer.zip().unwrap())).unwrap();
    assert_eq!(archive.len(), names.len());
    let mut inside = String::new();
    std::io::Read::read_to_string(&mut archive.by_name("result.json").unwrap(), &mut inside).unwrap();
    assert_eq!(inside, answer.json());
    assert!(answer.file("../secret").is_err());
    assert!(analyses::choice("{\"method\": \"magic\"}").unwrap_err().message.contains("magic"));
}

#[test]
fn a_tornado_moves_what_a_survey_doubts() {
    let answer = analyses::tornado(&tiny(), "[]", "{}", &mut Unwatched).unwrap();
    let result: Value = serde_json::from_str(&answer.json()).unwrap();
    assert_eq!(result["schema"], "extrados.vary/1");
    assert!(answer.names().iter().any(|name| name == "tornado.svg"), "{:?}", answer.names());
}

#[test]
fn steps_have_flat_numbers_and_can_be_taken_back() {
    let text = include_str!("../../../../examples/bridgemill/case-1.toml");
    let document = Document::new("case-1.toml", text);
    let mut run = stepped::Stepping::watched(&document, "{\"method\": \"dem\"}", &mut Unwatched).unwrap();
    let shapes = shapes(&run.picture());
    assert_eq!(run.advance(500), "");
    assert_eq!((run.poses().len(), run.centroids().len(), run.stresses().len()), (3 * shapes, 2 * shapes, 3 * shapes));
    assert!(!run.contacts().is_empty() && run.contacts().len().is_multiple_of(8) && run.particles().is_empty());
    let (state, then) = (run.state(), run.poses());
    run.advance(500);
    assert_ne!(run.poses(), then);
    run.restore(&state).unwrap();
    assert_eq!((run.poses(), run.steps()), (then, 500.0));
    assert!(run.restore(&state[8..]).is_err());
}
