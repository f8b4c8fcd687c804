//! Verification cases as data: one folder a case, read, run and judged here, for the test harness, the command and the
//! manual alike.
//!
//! A case folder holds `case.toml` (what is expected, from where, how closely and why) and its input: `bridge.toml`, an
//! ordinary bridge file, or `blocks.toml`, bare blocks for benchmarks that are no bridges. The input may also be named
//! by `input`, relative to the folder, so that an example is its own case.

mod against;
mod blocks;
mod case;
pub mod disks;
pub mod footing;
mod judge;
pub mod kernels;
mod manual;
mod measure;
mod service;
mod tables;
pub mod validation;

pub use case::{Case, CaseError, Class, Expect, Kind, Value};
pub use judge::{Judged, Judgement, Verdict, run};
pub use manual::{manual, table};
pub use tables::{TableRow, tables};

use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Folders below `root` that hold a case, in order of their names.
///
/// # Errors
/// A folder that cannot be read.
pub fn discover(root: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    let mut open = vec![root.to_path_buf()];
    while let Some(folder) = open.pop() {
        if folder.join("case.toml").is_file() {
            found.push(folder);
            continue;
        }
        for entry in fs::read_dir(&folder)? {
            let path = entry?.path();
            if path.is_dir() {
                open.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// No file of a case is longer [bytes].
const LONGEST: u64 = 64 << 20;

/// The bytes of a plain file: what is a device or a pipe may never end.
fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    let data = fs::metadata(path)?;
    if !data.is_file() || data.len() > LONGEST {
        return Err(io::Error::other("it is no plain file of at most 64 MiB"));
    }
    let mut bytes = Vec::new();
    fs::File::open(path)?.take(LONGEST).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The same as text.
fn read_text(path: &Path) -> io::Result<String> {
    String::from_utf8(read_bytes(path)?).map_err(io::Error::other)
}
