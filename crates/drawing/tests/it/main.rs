//! Drawings that another program's library wrote (`tests/data/make.py`), drawings of our own, and bytes that are none.

mod any_bytes;
mod reading;
mod refused;
mod round_trip;
mod shown;

use drawing::{Finding, Options, Read, Severity};
use std::path::Path;

/// The bytes of a committed drawing.
fn bytes(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A committed drawing, read with the defaults.
fn read(name: &str) -> Read {
    drawing::read(&bytes(name), &Options::default())
}

/// The findings on a layer of a kind.
fn on<'a>(read: &'a Read, layer: &str, severity: Severity) -> Vec<&'a Finding> {
    read.findings.iter().filter(|f| f.place.layer == layer && f.severity == severity).collect()
}

/// Area of an outline [m^2].
fn area(points: &[drawing::Point]) -> f64 {
    let n = points.len();
    0.5 * (0..n)
        .map(|i| {
            let (a, b) = (points[i], points[(i + 1) % n]);
            a[0] * b[1] - a[1] * b[0]
        })
        .sum::<f64>()
}
