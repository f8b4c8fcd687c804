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
