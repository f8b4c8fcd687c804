//! Records through every step: read, judged, prepared, their peaks tested; files with defects, and files that are mangled.

mod data;
mod defects;
mod mangled;
mod parquet;
mod peaks;
mod preparation;
mod reading;
mod round_trip;
mod size;
mod stamps;
mod table_1;
mod train;

use records::{Finding, Read, ReadOptions, Recording, Scrutiny, Series, examine};
use std::path::{Path, PathBuf};

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

/// A committed table, read with the defaults.
fn read_file(name: &str) -> Read {
    let path = path(name);
    let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    read_text(&bytes, name)
}

fn read_text(bytes: &[u8], name: &str) -> Read {
    records::read(bytes, &ReadOptions { name: name.to_owned(), ..ReadOptions::default() })
}

fn run_of(read: Read) -> Recording {
    let words: Vec<String> = read.findings.iter().map(Finding::words).collect();
    read.run.unwrap_or_else(|| panic!("no run: {words:#?}"))
}

/// Judged with the defaults.
fn judged(runs: Vec<Recording>) -> Series {
    examine(runs, &Scrutiny::default())
}

fn the<'a>(findings: &'a [Finding], code: &str) -> &'a Finding {
    let mut all = findings.iter().filter(|finding| finding.code == code);
    let words = || findings.iter().map(Finding::words).collect::<Vec<_>>();
    let first = all.next().unwrap_or_else(|| panic!("no {code}: {:#?}", words()));
    assert!(all.next().is_none(), "{code} more than once: {:#?}", words());
    first
}
