//! A run's state as bytes, from which it resumes to the same bits.
//!
//! Layout, little-endian: 8 bytes magic, format version (u64), fingerprint of the input (u64), number of words (u64), the
//! words (u64 each), checksum of everything before (u64).

use std::fmt::Debug;
use thiserror::Error;

const MAGIC: [u8; 8] = *b"EXTRADOS";
/// Rises when the layout changes, or the state of a run.
const VERSION: u64 = 2;
/// More words than this are no state of a block model but damage: 2 GiB.
const MOST_WORDS: u64 = 1 << 28;
/// No checkpoint is longer [bytes].
pub const LONGEST: u64 = 8 * (MOST_WORDS + 5);

/// Why a checkpoint cannot be taken up.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// Not a checkpoint.
    #[error("this is no checkpoint")]
    Foreign,
    /// Of another program version.
    #[error("the checkpoint has format {found}, this program reads format {VERSION}")]
    Version {
        /// Its format.
        found: u64,
    },
    /// Cut short, or bytes changed.
    #[error("the checkpoint is damaged: {0}")]
    Damaged(&'static str),
    /// Of another bridge or plan.
    #[error("the checkpoint belongs to another bridge file or plan than the one given")]
    OtherInput {
        /// The fingerprint of that one.
        found: u64,
    },
}

/// Fingerprint of everything that decides a run: the bridge or the block model, with its plan.
pub fn fingerprint<T: Debug>(input: &T) -> u64 {
    // The debug form names every field and prints every number so that it can be read back exactly.
    checksum(format!("{input:?}").as_bytes())
}

/// FNV-1a, 64 bits (Fowler, Noll and Vo): finds damage and mix-ups, not malice.
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A state as bytes.
pub fn bytes(fingerprint: u64, words: &[u64]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(8 * (words.len() + 5));
    bytes.extend(MAGIC);
    for word in [VERSION, fingerprint, words.len() as u64].iter().chain(words) {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(checksum(&bytes).to_le_bytes());
    bytes
}

/// The state in bytes that were made for the same input.
pub fn words(bytes: &[u8], fingerprint: u64) -> Result<Vec<u64>, CheckpointError> {
    if bytes.len() < 8 || bytes[..8] != MAGIC {
        return Err(CheckpointError::Foreign);
    }
    if !bytes.len().is_multiple_of(8) || bytes.len() < 40 {
        return Err(CheckpointError::Damaged("it is cut short"));
    }
    let words: Vec<u64> =
        bytes.chunks_exact(8).map(|c| u64::from_le_bytes(c.try_into().expect("chunks of eight"))).collect();
    if words[1] != VERSION {
        return Err(CheckpointError::Version { found: words[1] });
    }
    let (body, trailer) = bytes.split_at(bytes.len() - 8);
    if words[3] > MOST_WORDS || words[3] != words.len() as u64 - 5 {
        return Err(CheckpointError::Damaged("it is cut short or something was appended"));
    }
    if checksum(body).to_le_bytes() != trailer {
        return Err(CheckpointError::Damaged("its checksum does not fit"));
    }
    if words[2] != fingerprint {
        return Err(CheckpointError::OtherInput { found: words[2] });
    }
    Ok(words[4..words.len() - 1].to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{bridgemill, case_two};

    #[test]
    fn a_state_comes_back_word_for_word_and_only_for_its_input() {
        let state: Vec<u64> = (0..1000u64).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15)).collect();
        let (mine, other) = (fingerprint(&bridgemill()), fingerprint(&case_two()));
        assert_ne!(mine, other);
        let kept = bytes(mine, &state);
        assert_eq!(words(&kept, mine).unwrap(), state);
        assert!(matches!(words(&kept, other), Err(CheckpointError::OtherInput { found }) if found == mine));
    }

    #[test]
    fn every_changed_byte_and_every_cut_is_noticed() {
        let whole = bytes(7, &[1, 2, 3]);
        for k in 0..whole.len() {
            let mut changed = whole.clone();
            changed[k] ^= 0x10;
            assert!(words(&changed, 7).is_err(), "byte {k}");
            assert!(words(&whole[..k], 7).is_err(), "cut at {k}");
        }
        assert!(matches!(words(b"<svg></svg>", 7), Err(CheckpointError::Foreign)));
    }
}
