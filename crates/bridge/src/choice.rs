//! Words that a key may hold, each with its value and what it means: written once, in the list of the values themselves. Reading,
//! messages, schema and reference are made from it, and whoever decides by a word matches the value, without a default.

/// A word that a field may hold.
#[derive(Debug)]
pub struct Word {
    /// As written.
    pub word: &'static str,
    /// What it means.
    pub doc: &'static str,
}

/// Values that are written as words.
pub trait Choice: Copy + 'static {
    /// The words, in the order of the reference.
    const WORDS: &'static [Word];
    /// Their values, in the same order.
    const VALUES: &'static [Self];

    /// The value of a word.
    fn named(word: &str) -> Option<Self> {
        Self::WORDS.iter().position(|known| known.word == word).map(|index| Self::VALUES[index])
    }
}

/// Values with their words: an enumeration whose line of documentation is the reference's too.
#[macro_export]
macro_rules! choice {
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[doc = $doc:literal])+ $value:ident = $word:literal,)+ }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        $vis enum $name { $($(#[doc = $doc])+ #[serde(rename = $word)] $value),+ }

        #[allow(dead_code, reason = "not every value is written back as a word")]
        impl $name {
            /// Every value.
            $vis const ALL: &'static [$name] = &[$($name::$value),+];

            /// The word in files.
            $vis const fn word(self) -> &'static str {
                match self { $($name::$value => $word),+ }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                to.pad(self.word())
            }
        }

        impl $crate::choice::Choice for $name {
            const WORDS: &'static [$crate::choice::Word] =
                &[$($crate::choice::Word { word: $word, doc: concat!($($doc),+).trim_ascii() }),+];
            const VALUES: &'static [$name] = $name::ALL;
        }
    };
}
pub(crate) use choice;
