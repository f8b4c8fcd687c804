//! What a code means: one card for every error and warning, with an example that raises it and one that does not. Cards stand in
//! `crates/bridge/data/messages/`, by subject.

mod file_card;

pub use file_card::FileCard;

use std::collections::BTreeMap;
use std::sync::LazyLock;

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
