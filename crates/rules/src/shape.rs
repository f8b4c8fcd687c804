//! What files of vehicles and rules may say, key by key: the reader, the schema and the list in `docs/input/vehicles.md` are
//! made from it. Each table is written once, as the struct that is read of it with the card of every key (`table!`).

/// A kind of value.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Text.
    Text,
    /// A number; the key carries its unit.
    Number,
    /// true or false.
    Flag,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A list of text.
    Texts,
    /// A list of these words.
    Words(&'static [&'static str]),
    /// A list of numbers.
    Numbers,
    /// A list of lists of numbers.
    Rows,
    /// A list of distances: numbers, or tables with `from`, `to` and `step`.
    Spacings,
    /// A table.
    Table(&'static Shape),
    /// A list of tables.
    Tables(&'static Shape),
    /// A table whose `kind` says which of these it is.
    Tagged(&'static [(&'static str, &'static Shape)]),
}

/// A key.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// As written.
    pub name: &'static str,
    /// What it holds.
    pub kind: Kind,
    /// Whether it must be there.
    pub required: bool,
    /// What it is.
    pub doc: &'static str,
}

/// A table: its keys.
#[derive(Debug)]
pub struct Shape {
    /// What it is called.
    pub name: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

impl Shape {
    /// The card of a key.
    pub fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

pub(crate) const fn must(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key { name, kind, required: true, doc }
}

pub(crate) const fn may(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key { name, kind, required: false, doc }
}

/// What stands behind a key of a file.
pub(crate) trait Shaped {
    /// How it is written.
    const KIND: Kind;
}

/// What stands in a list of a file.
pub(crate) trait Listed {
    /// How such a list is written.
    const LIST: Kind;
}

impl<T: Listed> Shaped for Vec<T> {
    const KIND: Kind = T::LIST;
}

impl<T: Shaped> Shaped for Option<T> {
    const KIND: Kind = T::KIND;
}

macro_rules! kinds { ($($Type:ty: $kind:ident $(, $list:ident)?;)*) => { $(
    impl Shaped for $Type {
        const KIND: Kind = Kind::$kind;
    }
    $(impl Listed for $Type {
        const LIST: Kind = Kind::$list;
    })?
)* } }

kinds! {
    String: Text, Texts;
    f64: Number, Numbers;
    usize: Number;
    bool: Flag;
}

impl Listed for Vec<f64> {
    const LIST: Kind = Kind::Rows;
}

/// A table of a file: the struct that is read of it, and the card of each key. A line is `must key: Type, "what it is";`, or `may` where
/// the key may be left out; what serde is to know stands in square brackets, and the key in round ones where the field has another name.
/// Fields that no file has follow after `and`.
macro_rules! table {
    ($(#[$meta:meta])* pub struct $Name:ident = $called:literal {
        $($(#[$about:meta])* $need:ident $([$($serde:tt)+])? $field:ident $(($key:literal))? : $Type:ty, $doc:literal;)*
    } $(and { $($beside:tt)* })?) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, serde::Deserialize, serde::Serialize)]
        #[serde(deny_unknown_fields)]
        pub struct $Name {
            $(#[doc = $doc] $(#[$about])* $(#[serde($($serde)+)])? pub $field: $Type,)*
            $($($beside)*)?
        }

        impl $Name {
            /// The keys of its table.
            pub const SHAPE: &'static crate::shape::Shape = &crate::shape::Shape {
                name: $called,
                keys: &[$(crate::shape::$need(
                    [$($key,)? stringify!($field)][0],
                    <$Type as crate::shape::Shaped>::KIND,
                    $doc,
                )),*],
            };
        }

        impl crate::shape::Shaped for $Name {
            const KIND: crate::shape::Kind = crate::shape::Kind::Table($Name::SHAPE);
        }

        impl crate::shape::Listed for $Name {
            const LIST: crate::shape::Kind = crate::shape::Kind::Tables($Name::SHAPE);
        }
    };
}

/// A table whose `kind` says which of several it is, each with its keys as [`table!`] has them.
macro_rules! forms {
    ($(#[$meta:meta])* pub enum $Name:ident { $($(#[$about:meta])* $Form:ident = $word:literal {
        $($(#[$more:meta])* $need:ident $field:ident : $Type:ty, $doc:literal;)*
    })* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, serde::Deserialize, serde::Serialize)]
        #[serde(tag = "kind", deny_unknown_fields)]
        pub enum $Name { $(
            $(#[$about])*
            #[serde(rename = $word)]
            $Form { $(#[doc = $doc] $(#[$more])* $field: $Type,)* },
        )* }

        impl crate::shape::Shaped for $Name {
            const KIND: crate::shape::Kind = crate::shape::Kind::Tagged(&[$(($word, &crate::shape::Shape {
                name: $word,
                keys: &[
                    crate::shape::must("kind", crate::shape::Kind::Word(&[$word]), "which form"),
                    $(crate::shape::$need(stringify!($field), <$Type as crate::shape::Shaped>::KIND, $doc)),*
                ],
            })),*]);
        }
    };
}

/// An enumeration whose variants are words of files.
macro_rules! words {
    ($(#[$meta:meta])* pub enum $Name:ident { $($(#[$about:meta])* $Variant:ident = $word:literal,)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
        pub enum $Name { $($(#[$about])* #[serde(rename = $word)] $Variant,)* }

        impl $Name {
            const WORDS: &'static [&'static str] = &[$($word),*];

            /// The word in files and reports.
            pub fn word(self) -> &'static str {
                $Name::WORDS[self as usize]
            }
        }

        impl crate::shape::Shaped for $Name {
            const KIND: crate::shape::Kind = crate::shape::Kind::Word($Name::WORDS);
        }

        impl crate::shape::Listed for $Name {
            const LIST: crate::shape::Kind = crate::shape::Kind::Words($Name::WORDS);
        }
    };
}

pub(crate) use {forms, table, words};
