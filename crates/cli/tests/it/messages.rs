//! What a wrong file gets: every mistake at once, each with its place and what to write instead.

use crate::stage::Stage;

const WRONG: &str = r#"[bridge]
name = "Slips"
width = "8.30 m"

[[span]]
profile = "segmental"
span = "18.30 m"
rise = "2.85 GPa"
thicknes = "0.711 m"
thickness = "0.711 m"
voussoirs = 62

[masonry]
density = 2100
compressive_strength = "unlimited"

[joint]
friction_angle = "35.6 deg"
cohesion = "0 kPa"
"#;

#[test]
fn every_mistake_is_shown_with_line_caret_and_remedy() {
    let stage = Stage::new("messages-all");
    stage.write("slips.toml", WRONG);
    let ending = stage.run(&["check", "slips.toml"]);
    assert_eq!(ending.code, Some(2));
    assert!(ending.stdout.is_empty());
    for part in [
        "error[B402]: there is no load to bring the bridge to collapse",
        "error[B104]: expected a length, found a pressure",
        "  slips.toml:8:8\n  8 | rise = \"2.85 GPa\"\n    |        ^^^^^^^^^^ rise is measured from springing to crown, on the intrados\n  help: write \"2.85 m\"",
        "slips.toml:9:1\n  9 | thicknes = \"0.711 m\"\n    | ^^^^^^^^ ",
        "slips.toml:14:11\n 14 | density = 2100\n    |           ^^^^ ",
        "slips.toml: 4 errors; the file cannot be used\n",
    ] {
        assert!(ending.stderr.contains(part), "{part}\n--- is not in ---\n{}", ending.stderr);
    }
}

#[test]
fn a_doubt_is_a_warning_with_its_place_and_the_run_goes_on() {
    let stage = Stage::with_example("messages-doubt", "tiny");
    let text = stage.read("bridge/bridge.toml").replace(", compressive_strength = \"10 MPa\"", "");
    stage.write("doubt.toml", text);
    let (answer, ending) = stage.object(&["collapse", "doubt.toml"]);
    assert_eq!(ending.code, Some(0));
    let warning = &answer["warnings"][0];
    assert_eq!((warning["code"].as_str(), warning["file"].as_str()), (Some("P010"), Some("doubt.toml")), "{warning}");
    assert!(warning["line"].is_u64() && warning["column"].is_u64());
    assert!(ending.stderr.contains("warning[P010]") && ending.stderr.contains("the file can be used"));
    let quiet = stage.run(&["collapse", "doubt.toml", "--quiet"]);
    assert!(quiet.stderr.is_empty(), "{}", quiet.stderr);
}

#[test]
fn any_bytes_get_an_answer() {
    let stage = Stage::new("messages-bytes");
    let files: [&[u8]; 6] = [b"", b"\xff\xfe\x00", b"= = =", b"\x1b[31m", b"[[span]]\nspan = [1,2", &[0u8; 3000]];
    for bytes in files {
        stage.write("odd.toml", bytes);
        let (answer, ending) = stage.object(&["check", "odd.toml"]);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(2), Some("unusable-input")), "{bytes:?}");
        assert!(answer["errors"].as_array().is_some_and(|list| !list.is_empty()));
        assert!(!ending.stderr.contains("panicked") && !ending.stderr.contains('\u{1b}'), "{}", ending.stderr);
    }
}

#[test]
fn every_code_in_a_message_has_a_card() {
    let stage = Stage::new("messages-cards");
    stage.write("slips.toml", WRONG);
    let (answer, _) = stage.object(&["check", "slips.toml"]);
    for error in answer["errors"].as_array().expect("errors") {
        let code = error["code"].as_str().expect("a code");
        assert_eq!(stage.run(&["explain", code]).code, Some(0), "{code}");
    }
}
