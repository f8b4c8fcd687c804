//! What a caller lends to a long piece of work: a place for finished pieces, a clock, the name of its build.

use crate::shelf::{Shelf, Unkept};

/// What a caller lends; nothing is kept and the clock stands still by default.
#[derive(Clone, Copy)]
pub struct Means<'a> {
    /// Where finished pieces are kept.
    pub shelf: &'a dyn Shelf,
    /// A clock: seconds since whenever. Times enter no result: they tell people how long something took.
    pub clock: &'a (dyn Fn() -> f64 + Sync),
    /// Which build computes: pieces of another one are not taken up, for it may find other bits.
    pub program: &'a str,
}

impl Default for Means<'_> {
    fn default() -> Self {
        Means { shelf: &Unkept, clock: &|| 0.0, program: env!("CARGO_PKG_VERSION") }
    }
}

impl Means<'_> {
    /// The key of a piece: everything that its numbers follow from, as a hash in hexadecimal digits. The debug form of the input
    /// names every field and prints every number so that it can be read back exactly.
    pub fn key(&self, piece: &str, input: &impl std::fmt::Debug) -> String {
        let mut hasher = blake3::Hasher::new();
        hasher.update(self.program.as_bytes());
        hasher.update(format!("{piece}\n{input:?}").as_bytes());
        hasher.finalize().to_hex().to_string()
    }
}
