//! Kinds of what a result says: each has its numbers and one sentence, in which loads and lists are written alike.

/// Notes of one subject: `Name { number [unit]: Type } => "sentence", its arguments;`, or `Name(number: Type)` where numbers have no name in files.
/// The sentence is the documentation too.
macro_rules! notes {
    ($(#[$meta:meta])* $Subject:ident {
        $($(#[$about:meta])* $Name:ident $({ $($field:ident $([$($unit:tt)+])? : $Type:ty),* })? $(($($value:ident : $Of:ty),*))?
            => $words:literal $(, $part:expr)*;)*
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        pub enum $Subject {
            $($(#[$about])* #[doc = $words] $Name $({ $(#[doc = concat!(stringify!($field) $(, " [", stringify!($($unit)+), "]")?)] $field: $Type,)* })? $(($($Of),*))?,)*
        }

        impl std::fmt::Display for $Subject {
            fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self { $($Subject::$Name $({ $($field),* })? $(($($value),*))? => write!(to, $words $(, $part)*),)* }
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

/// The same of warnings, which have codes.
macro_rules! coded_subjects {
    ($(#[$meta:meta])* pub enum $Name:ident { $($(#[$about:meta])* $Subject:ident,)* }) => {
        crate::sentences::subjects! { $(#[$meta])* pub enum $Name { $($(#[$about])* $Subject,)* } }

        impl $Name {
            /// Its code, `A…`.
            pub fn code(&self) -> &'static str {
                match self { $($Name::$Subject(one) => one.code(),)* }
            }
        }
    };
}

pub(crate) use {coded_subjects, notes, subjects};

/// A load as sentences have it [kN/m].
pub(crate) fn kilo(load: f64) -> String {
    format!("{:.2}", load / 1e3)
}

/// "a, b, c".
pub(crate) fn listed<T: std::fmt::Display>(all: impl IntoIterator<Item = T>) -> String {
    all.into_iter().map(|one| one.to_string()).collect::<Vec<_>>().join(", ")
}
