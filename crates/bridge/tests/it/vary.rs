//! Varying a file: a quantity gets its value, and nothing else changes.

use bridge::edit::Document;
use bridge::path::Path;
use bridge::vary::{Known, Spread, find, known, settle};
use bridge::{Bridge, read};
use proptest::prelude::*;

use crate::files::{GOOD, TINY, VIADUCT};

/// Everything but what stands at a path.
fn others(document: &Document, path: &str) -> Vec<Known> {
    known(document).into_iter().filter(|known| known.path != path).collect()
}

/// The number that a Bridge prints for a quantity is not asked for field by field: two files mean the same bridge when
/// one is edited and the other is written by hand.
#[test]
fn an_edited_file_means_what_one_written_by_hand_means() {
    let by_hand = [
        ("joint.friction_angle", "\"30 deg\"", VIADUCT.replacen("friction_angle = \"32", "friction_angle = \"30", 1)),
        ("analysis.seed", "7", format!("{TINY}\n[analysis]\nseed = 7\n")),
        ("masonry.rounding", "\"5 mm\"", TINY.replace("masonry = {", "masonry = { rounding = \"5 mm\",")),
        ("load.at", "\"1/3 span\"", TINY.replace("1/4 span", "1/3 span")),
        ("load[1].force", "\"2 kN/m\"", TINY.replace("1 kN/m", "2 kN/m")),
        ("abutment.left.height", "\"3 m\"", format!("{TINY}[abutment.left]\nheight = \"3 m\"\n")),
    ];
    for (path, value, want) in by_hand {
        let text = if want.contains("Tiny") { TINY } else { VIADUCT };
        let mut document = Document::parse(text).unwrap();
        let quantity = find(&document, path).unwrap_or_else(|slip| panic!("{path}: {slip:?}"));
        document.set(&quantity.path, value).unwrap();
        let edited = read(document.text().as_bytes());
        assert!(edited.bridge.is_some(), "{path}: {:?}", edited.diagnostics);
        assert_eq!(edited.bridge, read(want.as_bytes()).bridge, "{path}");
        assert_ne!(edited.bridge, read(text.as_bytes()).bridge, "{path} means something");
    }
}

#[test]
fn every_quantity_of_the_good_files_can_be_found_and_kept() {
    for good in GOOD {
        let document = Document::parse(good).unwrap();
        assert_eq!(document.text(), good);
        // What is taken from the library by a material's name, and no longer where it is written, is no property of the bridge.
        let bridge =
            |text: &str| read(text.as_bytes()).bridge.map(|bridge| Bridge { from_library: Vec::new(), ..bridge });
        let before = bridge(good);
        let all = known(&document);
        assert!(all.len() > 15 && all.iter().all(|known| !known.path.starts_with("vary")));
        for one in all {
            let quantity = find(&document, &one.path).unwrap_or_else(|slip| panic!("{}: {slip:?}", one.path));
            assert_eq!(
                (quantity.path.to_string(), quantity.own.as_deref()),
                (one.path.clone(), Some(one.value.as_str()))
            );
            let mut same = document.clone();
            same.set(&quantity.path, &one.value).unwrap();
            assert_eq!(before, bridge(&same.text()), "{} = {}", one.path, one.value);
            assert_eq!(same.text() == good, !one.by_default, "{}", one.path);
        }
    }
}

#[test]
fn what_leads_nowhere_says_what_there_is() {
    let document = Document::parse(VIADUCT).unwrap();
    let cases = [
        ("joint.friction_angel", "B501", "joint.friction_angle"),
        ("friction_angle", "B501", "joint.friction_angle"),
        ("span[1].ring[2].thikness", "B501", "span[1].ring[1].thickness"),
        ("joint", "B501", "joint.friction_angle = "),
        ("bridge.name", "B501", "bridge.width = "),
        ("vary[1].points", "B501", "--list"),
        ("nonsense", "B501", "the file holds quantities in bridge, span, pier"),
        ("span.rise", "B502", "span[1]"),
        ("span[7].rise", "B502", "from 1 to"),
        ("joint.cohesion[1]", "B502", "cohesion"),
        ("", "B501", "--list"),
    ];
    for (path, code, words) in cases {
        let slip = find(&document, path).unwrap_err();
        let said = format!("{} {} {}", slip.message, slip.label, slip.help);
        assert_eq!(slip.code, code, "{path}: {said}");
        assert!(said.contains(words), "{path}: {said}");
    }
}

#[test]
fn tables_in_the_file_are_read() {
    let read = read(VIADUCT.as_bytes());
    let spreads: Vec<(&str, usize)> = read
        .vary
        .iter()
        .map(|request| match &request.spread {
            Spread::List(list) => (request.quantity.as_str(), list.len()),
            Spread::Range { points, .. } => (request.quantity.as_str(), *points as usize),
        })
        .collect();
    assert_eq!(spreads, [("joint.friction_angle", 3), ("span[1].ring[2].crown_thickness", 3)]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_new_value_is_the_only_change(file in 0..GOOD.len(), which in 0..10_000_usize, factor in 0.5..2.0_f64) {
        let good = GOOD[file];
        let document = Document::parse(good).unwrap();
        let all = known(&document);
        let one = &all[which % all.len()];
        let quantity = find(&document, &one.path).unwrap();
        let relative = Spread::List(vec![format!("\"x{factor}\"")]);
        let varied = settle(&quantity, &relative);
        // Words, flags and lists have no number to be relative to.
        prop_assume!(varied.as_ref().is_ok_and(|varied| varied.values[0].number.is_some()));
        let setting = &varied.unwrap().values[0];
        let mut edited = document.clone();
        edited.set(&quantity.path, &setting.literal).unwrap();
        let path = Path::parse(&one.path).unwrap();
        prop_assert_eq!(edited.get(&path), Some(setting.literal.clone()));
        prop_assert_eq!(others(&edited, &one.path), others(&document, &one.path));
        let text = edited.text();
        let reread = Document::parse(&text).unwrap();
        prop_assert_eq!(others(&reread, &one.path), others(&document, &one.path));
        // The value is within twelve digits of what was asked for; a whole number within a half.
        let whole = setting.literal.parse::<u64>().is_ok();
        let (own, new) = (varied_number(&document, &one.path), setting.number.unwrap());
        let slack = if whole { 0.5 } else { 1e-11 * new.abs() };
        prop_assert!((new - own * factor).abs() <= slack, "{} x {} gave {}", own, factor, new);
        if !one.by_default {
            let same_head = text.bytes().zip(good.bytes()).take_while(|(a, b)| a == b).count();
            let same_tail = text.bytes().rev().zip(good.bytes().rev()).take_while(|(a, b)| a == b).count();
            let longest = one.value.len().max(setting.literal.len());
            prop_assert!(same_head + same_tail + longest >= text.len().max(good.len()), "{}", text);
        }
    }

    #[test]
    fn no_path_and_no_value_brings_the_editor_down(path in ".{0,40}", value in ".{0,20}") {
        let mut document = Document::parse(VIADUCT).unwrap();
        let _ = find(&document, &path);
        let _ = bridge::vary::parse_setting(&document, &format!("{path}={value}"));
        let _ = bridge::vary::parse_setting(&document, &format!("joint.friction_angle={value}"));
        if let Some(path) = Path::parse(&path) {
            let _ = document.set(&path, &value);
        }
    }
}

fn varied_number(document: &Document, path: &str) -> f64 {
    let quantity = find(document, path).unwrap();
    let none = Spread::List(vec![quantity.own.clone().unwrap()]);
    settle(&quantity, &none).unwrap().own.unwrap().number.unwrap()
}
