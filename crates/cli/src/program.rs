//! Which build runs.

use std::fs;

/// Version and bytes of the running program, as a hash in hexadecimal digits: another build may compute other bits.
pub(crate) fn hash() -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(env!("CARGO_PKG_VERSION").as_bytes());
    if let Ok(bytes) = std::env::current_exe().and_then(fs::read) {
        hasher.update(&bytes);
    }
    hasher.finalize().to_hex().to_string()
}
