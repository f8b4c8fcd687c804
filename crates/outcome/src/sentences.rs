//! Kinds of what a result says: each has its numbers and one sentence, in which loads and lists are written alike.

/// Notes of one subject: `Name { number [unit]: Type } => "sentence", its arguments;`. The sentence is the documentation too.
macro_rules! notes {
    ($(#[$meta:meta])* $Subject:ident {
        $($(#[$about:meta])* $Name:ident $({ $($field:ident $([$($unit:tt)+])? : $Type:ty),* })? => $words:literal $(, $part:expr)*;)*
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        pub enum $Subject {
            $($(#[$about])* #[doc = $words] $Name $({ $(#[doc = concat!(stringify!($field) $(, " [", stringify!($($unit)+), "]")?)] $field: $Type,)* })?,)*
        }

        impl std::fmt::Display for $Subject {
            fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self { $($Subject::$Name $({ $($field),* })? => write!(to, $words $(, $part)*),)* }
            }
        }
    };
}

/// What has several subjects, each of which is a kind of it.
macro_rules! subjects {
    ($(#[$meta:meta])* pub enum $Name:ident { $($(#[$about:meta])* $Subject:ident,)* }) => {
        $(#[$meta])*
        pub enum $Name { $($(#[$about])* $Subject($Subject),)* }

        impl std::fmt::Display for $Name {
            fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self { $($Name::$Subject(one) => one.fmt(to),)* }
            }
        }

        $(impl From<$Subject> for $Name {
            fn from(one: $Subject) -> $Name {
                $Name::$Subject(one)
            }
        })*
    };
}

pub(crate) use {notes, subjects};

/// A load as sentences have it [kN/m].
pub(crate) fn kilo(load: f64) -> String {
    format!("{:.2}", load / 1e3)
}

/// "a, b, c".
pub(crate) fn listed<T: std::fmt::Display>(all: impl IntoIterator<Item = T>) -> String {
    all.into_iter().map(|one| one.to_string()).collect::<Vec<_>>().join(", ")
}
