//! Files that are not what a command expects: read where they can be, called by their name where not.

use crate::stage::Stage;
use crate::tiny::BRIDGE;

#[test]
fn a_bridge_file_in_utf_16_is_read() {
    let stage = Stage::new("utf-16");
    let bytes: Vec<u8> = std::iter::once(0xfeff).chain(BRIDGE.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    std::fs::write(stage.folder.join("bridge.toml"), bytes).expect("a file");
    let (answer, ending) = stage.object(&["check", "bridge.toml", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{answer}");
}

#[test]
fn a_drawing_and_a_workbook_are_called_what_they_are() {
    let stage = Stage::new("wrong-kind");
    stage.write("bridge.dxf", "  0\nSECTION\n  2\nHEADER\n  0\nENDSEC\n  0\nEOF\n");
    stage.write("bridge.xlsx", "PK\u{3}\u{4}not text");
    for (file, code) in [("bridge.dxf", "B217"), ("bridge.xlsx", "B218")] {
        let (answer, ending) = stage.object(&["check", file, "--quiet"]);
        assert_eq!((ending.code, answer["errors"][0]["code"].as_str()), (Some(2), Some(code)), "{answer}");
    }
}

/// Commands that ask about a bridge say of a block model file what it is, and not which keys of a bridge it lacks.
#[test]
fn a_block_model_is_called_what_it_is_by_commands_that_ask_about_a_bridge() {
    let stage = Stage::with_example("wrong-blocks", "drawing");
    for command in [&["assess"][..], &["cases"], &["vary", "--set", "bridge.width=4m..5m:2"], &["respond"], &["update"]]
    {
        let words: Vec<&str> =
            command[..1].iter().chain(&["bridge/bridge.toml"]).chain(&command[1..]).copied().collect();
        let (answer, ending) = stage.object(&words);
        let codes: Vec<_> = answer["errors"].as_array().expect("errors").iter().map(|one| &one["code"]).collect();
        assert_eq!((ending.code, codes), (Some(2), vec![&"B243".into()]), "{answer}");
    }
    assert_eq!(stage.run(&["check", "bridge/bridge.toml"]).code, Some(0));
}
