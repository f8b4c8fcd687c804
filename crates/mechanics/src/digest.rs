//! One number for many words: whether they are those that were kept.

/// A 64-bit digest of words, sensitive to every bit and to their order. No protection against intent.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Digest(u64);

impl Digest {
    pub fn new() -> Digest {
        Digest(0xCBF2_9CE4_8422_2325)
    }
    pub fn word(&mut self, word: u64) {
        // Each round is invertible, so that one changed word always changes the digest.
        let mixed = (self.0 ^ word).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        self.0 = (mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    }
    pub fn value(self) -> u64 {
        self.0 ^ (self.0 >> 32)
    }
}

/// Digest of `words`.
pub(crate) fn checksum(words: &[u64]) -> u64 {
    let mut digest = Digest::new();
    words.iter().for_each(|&w| digest.word(w));
    digest.value()
}
