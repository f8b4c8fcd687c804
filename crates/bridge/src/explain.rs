//! What a code means: one card for every error and warning, with an example that raises it and one that does not. Cards stand in
//! `crates/bridge/data/messages/`, by subject.

use crate::quantity;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The card of a code about files, with lines that raise it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub struct FileCard {
    /// The code: `B…` for errors in the file, `P…` for plausibility.
    pub code: &'static str,
    /// What is found, in a line.
    pub title: &'static str,
    /// What is checked.
    pub meaning: &'static str,
    /// Why it matters.
    pub why: &'static str,
    /// Lines that raise it.
    pub wrong: &'static str,
    /// What to write instead.
    pub right: &'static str,
    /// Where the rule comes from.
    pub source: &'static str,
}

impl FileCard {
    /// What to write instead, as it is shown. A value that the file must get from its own bridge is an ellipsis before its unit: the
    /// value of another bridge is no remedy. Numbers of the wrong lines stay, for there it is the writing that is wrong.
    pub fn instead(&self) -> String {
        let doubt = self.code.starts_with('P');
        let leave_out = |number: &str| doubt || !self.wrong.replace(',', ".").contains(number);
        let line = |line: &str| match line.split_once(" = ") {
            // A constant of nature.
            Some(("gravity", _)) => line.to_owned(),
            Some((key, count)) if doubt && count.parse::<u32>().is_ok() => format!("{key} = …"),
            Some(_) => masked(line, leave_out),
            // A row of a list shows how lists are written.
            None => line.to_owned(),
        };
        self.right.trim().lines().map(line).collect::<Vec<_>>().join("\n")
    }

    /// The words above these lines.
    pub fn instead_is(&self) -> &'static str {
        if self.instead().contains('…') { "Instead, with this bridge's own value:" } else { "Instead:" }
    }
}

/// All cards, by subject.
static CARDS: LazyLock<[Vec<FileCard>; 6]> = LazyLock::new(|| {
    let texts = [
        include_str!("../data/messages/errors.toml"),
        include_str!("../data/messages/geometry.toml"),
        include_str!("../data/messages/passage.toml"),
        include_str!("../data/messages/update.toml"),
        include_str!("../data/messages/vary.toml"),
        include_str!("../data/messages/warnings.toml"),
    ];
    texts.map(|text| {
        let lists: BTreeMap<&str, Vec<FileCard>> = toml::from_str(text).expect("cards of messages");
        lists.into_values().flatten().collect()
    })
});

/// All cards one after the other.
pub fn cards() -> impl Iterator<Item = &'static FileCard> {
    CARDS.iter().flatten()
}

/// The card of a code, however it is capitalised.
pub fn explain(code: &str) -> Option<&'static FileCard> {
    cards().find(|card| card.code.eq_ignore_ascii_case(code.trim()))
}

/// A line with an ellipsis for the number of every quantity in quotes that is one to leave out.
fn masked(line: &str, leave_out: impl Fn(&str) -> bool) -> String {
    let piece = |(at, piece): (usize, &str)| match piece.split_once(' ') {
        Some((number, unit)) if at % 2 == 1 && quantity::parse(piece).is_ok() && leave_out(number) => {
            format!("… {unit}")
        }
        _ => piece.to_owned(),
    };
    line.split('"').enumerate().map(piece).collect::<Vec<_>>().join("\"")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cards_are_complete_and_in_order() {
        for list in CARDS.iter() {
            assert!(list.windows(2).all(|pair| pair[0].code < pair[1].code));
        }
        for card in cards() {
            for words in [card.title, card.meaning, card.why, card.wrong, card.source] {
                assert!(!words.is_empty(), "{}", card.code);
            }
        }
        assert_eq!(explain(" b104").map(|card| card.code), Some("B104"));
        assert_eq!(explain("B999"), None);
    }

    #[test]
    fn no_card_offers_the_value_of_another_bridge() {
        let shown = |code: &str| explain(code).expect("a card").instead();
        assert_eq!(shown("P003"), "compressive_strength = \"… MPa\"");
        assert_eq!(shown("P026"), "voussoirs = …");
        assert_eq!(shown("B401"), "[joint]\nnormal_stiffness = \"… GPa/m\"\nshear_stiffness = \"0.573 GPa/m\"");
        assert_eq!(shown("B105"), "span = \"18.30 m\"", "the reader's own number, with a point");
        for card in cards().filter(|card| card.code.starts_with('P') && !card.instead().starts_with("gravity")) {
            let shown = card.instead();
            let quantity = shown.split('"').find(|piece| crate::quantity::parse(piece).is_ok());
            assert_eq!(quantity, None, "{}", card.code);
        }
    }
}
