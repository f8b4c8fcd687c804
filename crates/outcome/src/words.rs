//! Kinds with the words that files and scripts read.

/// Enumerations whose variants are written as words: `word`, `ALL`, and the same words in files.
macro_rules! words {
    ($($(#[$meta:meta])* pub enum $Name:ident { $($(#[$about:meta])* $Variant:ident = $word:literal,)* })*) => { $(
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        pub enum $Name { $($(#[$about])* #[serde(rename = $word)] $Variant,)* }

        impl $Name {
            /// All of them.
            pub const ALL: &[$Name] = &[$($Name::$Variant),*];

            /// The word that files and scripts read.
            pub fn word(self) -> &'static str {
                match self { $($Name::$Variant => $word),* }
            }
        }

        impl std::fmt::Display for $Name {
            fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                to.pad(self.word())
            }
        }

        crate::wire::plain!($Name);
    )* };
}

pub(crate) use words;
