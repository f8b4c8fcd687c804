//! What a stopped run is kept as: the bytes of its state, to the last bit, between the number of what it belongs to and a checksum. The
//! structs of a state say what is kept of them; this is the one place that makes bytes of them.

use crate::blocks::ModelError;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Rises whenever a struct that is kept changes: its bytes do not name their parts.
pub const FORMAT: u64 = 3;

/// A number for what a state belongs to: model, loading, program and settings.
pub(crate) fn fingerprint<T: Serialize>(of: &T) -> u64 {
    digest(&bytes(&(FORMAT, of)))
}

/// The bytes of a state of what `belongs` stands for.
pub(crate) fn write<T: Serialize>(belongs: u64, state: &T) -> Vec<u8> {
    let mut kept = bytes(&(belongs, state));
    kept.extend(digest(&kept).to_le_bytes());
    kept
}

/// The state that bytes hold.
///
/// # Errors
/// Bytes that are not whole, or of something else than `belongs` stands for.
pub(crate) fn read<T: DeserializeOwned>(belongs: u64, kept: &[u8]) -> Result<T, ModelError> {
    let (body, sum) = kept.split_last_chunk().ok_or(ModelError::ForeignState)?;
    let ((of, state), rest) = split::<(u64, T)>(body)?;
    let sound = digest(body) == u64::from_le_bytes(*sum) && of == belongs && rest.is_empty();
    sound.then_some(state).ok_or(ModelError::ForeignState)
}

/// Puts in front of the state of a run what an analysis of several runs must know to go on with it.
pub fn join<T: Serialize>(head: &T, state: &[u8]) -> Vec<u8> {
    [&bytes(head), state].concat()
}

/// What stands in front of a state, and the state. No more memory is taken than the bytes fill, whatever lengths they give.
///
/// # Errors
/// Bytes that do not begin with it.
pub fn split<T: DeserializeOwned>(kept: &[u8]) -> Result<(T, &[u8]), ModelError> {
    postcard::take_from_bytes(kept).map_err(|_| ModelError::ForeignState)
}

/// FNV-1a, 64 bits (Fowler, Noll and Vo): one changed byte always changes it. It finds damage and mix-ups, not malice.
pub fn digest(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn bytes<T: Serialize>(of: &T) -> Vec<u8> {
    postcard::to_extend(of, Vec::new()).expect("lists that know their lengths can be written")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers that are none, infinite or zero with a sign come back with their bits.
    #[test]
    fn a_state_comes_back_to_the_bit_and_only_for_what_it_belongs_to() {
        let state = vec![0.1, -0.0, f64::NAN, f64::NEG_INFINITY, f64::from_bits(0x7ff8_0000_0000_0007)];
        let kept = write(7, &state);
        let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(read(7, &kept).map(bits), Ok(bits(state)));
        assert_eq!(read::<Vec<f64>>(8, &kept), Err(ModelError::ForeignState));
        assert_eq!(read::<Vec<u8>>(7, &kept), Err(ModelError::ForeignState), "bytes are left over");
    }

    /// A length of billions, with a sum that fits: there are no such bytes, and no memory is asked for them.
    #[test]
    fn a_length_beyond_the_bytes_is_refused() {
        for length in [4_u64, 1 << 40, u64::MAX] {
            let kept = write(7, &(length, 1.0, 2.0));
            assert_eq!(read::<Vec<[f64; 3]>>(7, &kept), Err(ModelError::ForeignState), "{length}");
        }
    }
}
