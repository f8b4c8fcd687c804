//! What a code means: one card for every error and warning, with an example that raises it and one that does not.

mod errors;
mod geometry;
mod passage;
mod update;
mod vary;
mod warnings;

/// The card of a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Card {
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

/// All cards, by subject.
pub const CARDS: [&[Card]; 6] =
    [errors::CARDS, geometry::CARDS, passage::CARDS, update::CARDS, vary::CARDS, warnings::CARDS];

/// All cards one after the other.
pub fn cards() -> impl Iterator<Item = &'static Card> {
    CARDS.into_iter().flatten()
}

/// The card of a code, however it is capitalised.
pub fn explain(code: &str) -> Option<&'static Card> {
    cards().find(|card| card.code.eq_ignore_ascii_case(code.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cards_are_complete_and_in_order() {
        for list in CARDS {
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
}
