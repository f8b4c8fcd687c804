//! What messages propose: numbers that are right, places that are right, and no value of another bridge.

use crate::files::{CASE_1, TINY, VIADUCT, show_all};
use bridge::{as_utf8, read};

fn codes(text: &str) -> Vec<&'static str> {
    read(text.as_bytes()).diagnostics.iter().map(|finding| finding.code).collect()
}

#[test]
fn feet_and_pounds_are_read_and_never_renamed() {
    let metric = read(TINY.as_bytes()).bridge.expect("tiny");
    let wide = |words: &str| {
        let file = TINY.replacen(&format!("span = \"{}\"", quoted(TINY, "span")), &format!("span = \"{words}\""), 1);
        read(file.as_bytes()).bridge.unwrap_or_else(|| panic!("{}", show_all(&file))).spans[0].span
    };
    assert!(metric.spans[0].span > 0.0);
    // 19 ft 8 in are 236 in of 0.0254 m.
    for words in ["19 ft 8 in", "19' 8\\\"", "19ft 8in", "236 in"] {
        assert!((wide(words) - 5.9944).abs() < 1e-12, "{words}");
    }
    for (unit, key, right) in [("140 lb/ft^3", "density", 2_242.584_8), ("140 pcf", "density", 2_242.584_8)] {
        let file = TINY.replacen(&format!("{key} = \"{}\"", quoted(TINY, key)), &format!("{key} = \"{unit}\""), 1);
        let bridge = read(file.as_bytes()).bridge.unwrap_or_else(|| panic!("{}", show_all(&file)));
        assert!((bridge.masonry.density - right).abs() < 1e-3, "{unit}: {}", bridge.masonry.density);
    }
}

/// What a file has in quotes after a key.
fn quoted<'t>(text: &'t str, key: &str) -> &'t str {
    let from = text.find(&format!("{key} = \"")).expect("the key") + key.len() + 4;
    &text[from..from + text[from..].find('"').expect("its end")]
}

#[test]
fn a_number_in_an_unknown_unit_is_not_given_another_one() {
    let file = CASE_1.replace("rise = \"2.85 m\"", "rise = \"2.85 furlongs\"");
    let shown = show_all(&file);
    assert!(shown.contains("convert the number into one of these units: m, mm, cm, ft, in"), "{shown}");
    assert!(!shown.contains("2.85 m\""), "{shown}");
    let file = CASE_1.replace("rise = \"2.85 m\"", "rise = \"2.85 psi\"");
    assert!(!show_all(&file).contains("2.85 m\""), "{}", show_all(&file));
}

#[test]
fn a_key_of_another_section_is_explained_and_not_moved() {
    let pier = VIADUCT.replacen("[[pier]]\n", "[[pier]]\nthickness = \"1.5 m\"\n", 1);
    let shown = show_all(&pier);
    assert!(shown.contains("B010") && !shown.contains("move this line"), "{shown}");
    assert!(shown.contains("[[pier]] knows"), "{shown}");
}

#[test]
fn no_value_of_another_bridge_is_offered() {
    let file = CASE_1.lines().filter(|line| !line.starts_with("friction_angle")).collect::<Vec<_>>().join("\n");
    let shown = show_all(&file);
    assert!(shown.contains("add a line friction_angle = \"… deg\""), "{shown}");
    assert!(!shown.contains("35.6"), "{shown}");
    let shown = show_all(&CASE_1.replace("voussoirs = 62", "voussoirs = \"31\""));
    assert!(shown.contains("write it without quotes: voussoirs = 31"), "{shown}");
}

#[test]
fn a_slope_upside_down_is_doubted() {
    assert!(codes(&CASE_1.replace("slope = \"2:1\"", "slope = \"1:2\"")).contains(&"P025"));
    assert!(!codes(CASE_1).contains(&"P025"));
    assert!(!codes(&CASE_1.replace("slope = \"2:1\"", "slope = \"1:1\"")).contains(&"P025"));
}

#[test]
fn few_voussoirs_and_joints_between_rings_that_are_not_there_are_doubted() {
    assert!(codes(&CASE_1.replace("voussoirs = 62", "voussoirs = 3")).contains(&"P026"));
    let joint = "\n[ring_joint]\nfriction_angle = \"30 deg\"\n";
    assert!(codes(&format!("{TINY}{joint}")).contains(&"P027"), "{}", show_all(&format!("{TINY}{joint}")));
    assert!(!codes(CASE_1).contains(&"P026") && !codes(CASE_1).contains(&"P027"));
}

#[test]
fn utf_16_is_read_as_text() {
    for (mark, little) in [(true, true), (true, false), (false, true), (false, false)] {
        let units = mark.then_some(0xfeff).into_iter().chain(CASE_1.encode_utf16());
        let bytes: Vec<u8> = units.flat_map(|u| if little { u.to_le_bytes() } else { u.to_be_bytes() }).collect();
        assert_eq!(String::from_utf8(as_utf8(bytes)).unwrap(), CASE_1);
    }
    assert_eq!(as_utf8(CASE_1.as_bytes().to_vec()), CASE_1.as_bytes());
}

#[test]
fn drawings_and_workbooks_are_called_what_they_are() {
    for (bytes, code) in [
        (&b"  0\r\nSECTION\r\n  2\r\nHEADER\r\n"[..], "B217"),
        (b"AutoCAD Binary DXF\r\n\x1a\0", "B217"),
        (b"PK\x03\x04\x14\0\x06\0\x08\0", "B218"),
    ] {
        let found = read(bytes).diagnostics;
        assert_eq!(found.iter().map(|finding| finding.code).collect::<Vec<_>>(), [code]);
    }
}

#[test]
fn curly_quotes_are_named() {
    let shown = show_all(&CASE_1.replace("\"8.30 m\"", "“8.30 m”"));
    assert!(shown.contains("curly quotes; write straight ones: width = \"8.30 m\""), "{shown}");
}
