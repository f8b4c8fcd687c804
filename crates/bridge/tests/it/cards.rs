//! Every code has a card, and every card's example raises its code.

use std::collections::BTreeSet;
use std::path::Path;

use bridge::explain::cards;
use bridge::read;

use crate::files::{ASSESS, GOOD, show_all};

/// Codes in quotes in the sources, cards left out.
fn codes_raised(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            if !path.ends_with("explain") {
                codes_raised(&path, found);
            }
            continue;
        }
        if path.ends_with("explain.rs") {
            continue;
        }
        let source = std::fs::read_to_string(&path).unwrap();
        for piece in source.split('"') {
            let digits = piece.strip_prefix(['B', 'P']).unwrap_or("");
            if digits.len() == 3 && digits.bytes().all(|byte| byte.is_ascii_digit()) {
                found.insert(piece.to_owned());
            }
        }
    }
}

#[test]
fn every_code_has_a_card_and_every_card_a_code() {
    let mut raised = BTreeSet::new();
    codes_raised(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut raised);
    // Doubts about files of vehicles and rules are raised where these are read.
    codes_raised(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../rules/src"), &mut raised);
    let carded: BTreeSet<String> = cards().map(|card| card.code.to_owned()).collect();
    assert_eq!(raised, carded);
}

#[test]
fn every_card_bites() {
    // Those of block model files are tried there (blocks.rs), those of files of vehicles and rules in crates/rules/tests/plausible.rs.
    let elsewhere = |code: &str| ["P028", "P029", "P030"].contains(&code) || code.starts_with("P08");
    for card in cards().filter(|card| !elsewhere(card.code)) {
        // Some cards are about the file, not about lines in it.
        let files: Vec<Vec<u8>> = match card.code {
            "B001" => vec![b"[bridge]\nname = \"Pont de Pal\xe9\"\n".to_vec()],
            "B003" => vec![vec![b'#'; 2 << 20]],
            // A text of two hundred letters stands on no card.
            "B110" => vec![GOOD[0].replacen("name = \"", &format!("name = \"{}", "x".repeat(201)), 1).into_bytes()],
            "P034" => {
                let cover = "[[cover]]\nlayer = \"fill\"\nthickness = \"3.6 m\"\ndensity = \"1900 kg/m^3\"\n";
                vec![format!("{ASSESS}\n{cover}").into_bytes()]
            }
            // Nor one that cannot be seen.
            "B111" => vec![GOOD[0].replacen("name = \"", "name = \"\u{202e}", 1).into_bytes()],
            // Nor two thousand loads.
            "B112" => {
                let load = "[[load]]\nkind = \"knife-edge\"\nforce = \"1 kN/m\"\nlength = \"0.3 m\"\nat = \"2 m\"\n";
                vec![format!("[bridge]\nname = \"b\"\n{}", load.repeat(2000)).into_bytes()]
            }
            "B217" => vec![b"  0\nSECTION\n".to_vec()],
            "B218" => vec![b"PK\x03\x04".to_vec()],
            "B243" => vec![b"[model]\nname = \"Wall\"\n".to_vec()],
            _ => GOOD
                .iter()
                .filter(|good| good.contains(card.right))
                .map(|good| good.replacen(card.right, card.wrong, 1).into_bytes())
                .collect(),
        };
        assert!(!files.is_empty(), "{}: no good file holds what the card calls right", card.code);
        let raised = files.iter().any(|file| read(file).diagnostics.iter().any(|finding| finding.code == card.code));
        let found: String = files.iter().map(|file| show_all(&String::from_utf8_lossy(file))).collect();
        assert!(raised, "{} is not raised by its example; found\n{found}", card.code);
    }
}

#[test]
fn every_finding_says_where_and_what_to_do() {
    for card in cards() {
        for good in GOOD.iter().filter(|good| good.contains(card.right)) {
            let file = good.replacen(card.right, card.wrong, 1);
            for finding in read(file.as_bytes()).diagnostics {
                assert!(finding.range.end <= file.len() && finding.range.start <= finding.range.end);
                assert!(!finding.message.is_empty() && !finding.label.is_empty(), "{finding:?}");
                assert!(finding.help.as_ref().is_some_and(|help| !help.is_empty()), "{finding:?}");
            }
        }
    }
}
