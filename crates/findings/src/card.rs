//! The card of a code.

/// What a code means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Card {
    /// The code: a letter and three digits.
    pub code: &'static str,
    /// In a few words.
    pub title: &'static str,
    /// Why it matters, and what is done or to be done about it.
    pub text: &'static str,
}

impl Card {
    /// The card of a code among some, however the code is capitalised.
    pub fn of(code: &str, cards: &'static [Card]) -> Option<&'static Card> {
        cards.iter().find(|card| card.code.eq_ignore_ascii_case(code.trim()))
    }

    /// Whether cards stand in the order of their codes, each code once, and say something.
    pub fn are_complete(cards: &[Card]) -> bool {
        cards.windows(2).all(|pair| pair[0].code < pair[1].code)
            && cards.iter().all(|card| !card.title.is_empty() && !card.text.is_empty())
    }
}

/// Writes the list `CARDS`, one card a line: `"D101", "title", "text";`. With a name before it, `NAME = "A101", …`, the code is a
/// constant of that name too, and the title tells what it is.
#[macro_export]
macro_rules! cards {
    ($($code:literal, $title:expr, $text:expr;)*) => {
        /// Every card, in the order of the codes.
        pub const CARDS: &[$crate::Card] = &[$($crate::Card { code: $code, title: $title, text: $text }),*];
    };
    ($($(#[$meta:meta])* $name:ident = $code:literal, $title:literal, $text:literal;)*) => {
        $($(#[$meta])* #[doc = $title] pub const $name: &str = $code;)*
        $crate::cards! { $($code, $title, $text;)* }
    };
}
