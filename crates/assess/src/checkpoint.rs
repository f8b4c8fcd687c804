//! The file of a stopped run: its state, for the input that it belongs to.
//!
//! Layout: 8 bytes magic; little-endian the format and the fingerprint of the input (u64 each); the state, as
//! [`Watch::keep`](mechanics::watch::Watch::keep) offers it; the checksum of everything before (u64).

use mechanics::kept::{FORMAT, digest};
use std::fmt::Debug;
use thiserror::Error;

const MAGIC: [u8; 8] = *b"EXTRADOS";
/// No checkpoint is longer [bytes]: what is longer is no state of a block model but damage.
pub const LONGEST: u64 = 2 << 30;

/// Why a checkpoint cannot be taken up.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// Not a checkpoint.
    #[error("this is no checkpoint")]
    Foreign,
    /// Of another program version.
    #[error("another version of this program kept it (format {format}, this one reads format {FORMAT})")]
    Version {
        /// Its format.
        format: u64,
        /// The fingerprint of its input.
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
    digest(format!("{input:?}").as_bytes())
}

/// A state as the bytes of a file.
pub fn bytes(fingerprint: u64, state: &[u8]) -> Vec<u8> {
    let mut bytes = [&MAGIC, &FORMAT.to_le_bytes(), &fingerprint.to_le_bytes(), state].concat();
    bytes.extend(digest(&bytes).to_le_bytes());
    bytes
}

/// The state in the bytes of a file that were made for the same input.
///
/// # Errors
/// Bytes that are no checkpoint, damaged, or made by another version or for another input.
pub fn state(bytes: &[u8], fingerprint: u64) -> Result<&[u8], CheckpointError> {
    let rest = bytes.strip_prefix(&MAGIC).ok_or(CheckpointError::Foreign)?;
    let (format, found, state, sum) = parts(rest).ok_or(CheckpointError::Damaged("it is cut short"))?;
    if format != FORMAT {
        return Err(CheckpointError::Version { format, found });
    }
    if digest(&bytes[..bytes.len() - 8]) != sum {
        return Err(CheckpointError::Damaged("its checksum does not fit"));
    }
    if found != fingerprint {
        return Err(CheckpointError::OtherInput { found });
    }
    Ok(state)
}

/// Format, fingerprint, state and checksum of what follows the magic; none where it is cut short.
fn parts(rest: &[u8]) -> Option<(u64, u64, &[u8], u64)> {
    let number = |bytes: &[u8; 8]| u64::from_le_bytes(*bytes);
    let (format, rest) = rest.split_first_chunk()?;
    let (found, rest) = rest.split_first_chunk()?;
    let (state, sum) = rest.split_last_chunk()?;
    Some((number(format), number(found), state, number(sum)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{bridgemill, case_two};

    #[test]
    fn a_state_comes_back_byte_for_byte_and_only_for_its_input() {
        let kept: Vec<u8> = (0..1000u32).map(|k| (k.wrapping_mul(0x9e37_79b9) >> 24) as u8).collect();
        let (mine, other) = (fingerprint(&bridgemill()), fingerprint(&case_two()));
        assert_ne!(mine, other);
        let file = bytes(mine, &kept);
        assert_eq!(state(&file, mine).unwrap(), kept);
        assert!(matches!(state(&file, other), Err(CheckpointError::OtherInput { found }) if found == mine));
    }

    #[test]
    fn every_changed_byte_and_every_cut_is_noticed() {
        let whole = bytes(7, &[1, 2, 3]);
        for k in 0..whole.len() {
            let mut changed = whole.clone();
            changed[k] ^= 0x10;
            assert!(state(&changed, 7).is_err(), "byte {k}");
            assert!(state(&whole[..k], 7).is_err(), "cut at {k}");
        }
        assert!(matches!(state(b"<svg></svg>", 7), Err(CheckpointError::Foreign)));
    }
}
