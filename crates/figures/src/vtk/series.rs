//! A series of files, with the load as time.

use crate::file::File;
use crate::sheet::escape;
use outcome::picture::Picture;
use std::fmt::Write as _;

/// Time at which each snapshot stands in the series: its load [kN/m], or the support movement [mm]. ParaView takes
/// files at the same time for parts of one state, so that a snapshot whose load is not above the one before it (on
/// the way down) follows a thousandth of a unit later.
pub fn moments(picture: &Picture) -> Vec<f64> {
    let unit = if picture.moves_supports { 1e3 } else { 1e-3 };
    let mut last = f64::NEG_INFINITY;
    let mut moment = |load: f64| {
        let at = load * unit;
        last = if at > last {
            at
        } else if last.is_finite() {
            last + 1e-3
        } else {
            0.0
        };
        last
    };
    picture.snapshots.iter().map(|s| moment(s.load)).collect()
}

/// A file in the folder of ParaView files.
pub(crate) fn file(name: &str, text: String) -> File {
    File { name: format!("paraview/{name}"), bytes: text.into_bytes() }
}

/// Files of one kind, each with its number and time, and their series; nothing without a file. ParaView takes files at the same time
/// for parts of one state, so that the later one follows a millionth later.
pub(crate) fn over_time(kind: &str, texts: impl Iterator<Item = (usize, f64, String)>) -> Vec<File> {
    let mut files = Vec::new();
    let mut listed: Vec<(f64, String)> = Vec::new();
    for (k, time, text) in texts {
        let name = format!("{kind}-{k:04}.vtu");
        let after = listed.last().filter(|(last, _)| time <= *last).map(|(last, _)| last + 1e-6);
        files.push(file(&name, text));
        listed.push((after.unwrap_or(time), name));
    }
    if !listed.is_empty() {
        files.push(file(&format!("{kind}.pvd"), series(&listed)));
    }
    files
}

/// The series of files, each with its time.
fn series(files: &[(f64, String)]) -> String {
    let mut out = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<Collection>\n",
    );
    for (time, name) in files {
        let _ = writeln!(out, "<DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{}\"/>", escape(name));
    }
    out.push_str("</Collection>\n</VTKFile>\n");
    out
}
