//! Good files to start from, and messages as they may be shown.

use bridge::{Diagnostic, Severity};

/// Bridgemill, case 1 of Rouxinol, Providência and Lemos.
pub(crate) const CASE_1: &str = include_str!("files/case-1.toml");
/// Three spans of two rings, with everything that a plan may say.
pub(crate) const VIADUCT: &str = include_str!("files/viaduct.toml");
/// One span of every other profile.
pub(crate) const SHAPES: &str = include_str!("files/shapes.toml");
/// As little as there can be.
pub(crate) const TINY: &str = include_str!("files/tiny.toml");

/// Spandrel walls, with everything that they may say.
pub(crate) const WALLS: &str = include_str!("files/walls.toml");

/// Materials of the library by their names, in every table that may name one.
pub(crate) const NAMED: &str = include_str!("files/named.toml");

/// Fill as particles of stated diameters.
pub(crate) const PARTICLES: &str = include_str!("files/particles.toml");
/// A stated number of particles below slabs, above backing.
pub(crate) const LAYERS: &str = include_str!("files/layers.toml");
/// Fill as particles of given diameters, and all that its calibration may say.
pub(crate) const CALIBRATION: &str = include_str!("files/calibration.toml");
/// A train of its own crosses, and all that its passage may say.
pub(crate) const PASSAGE: &str = include_str!("files/passage.toml");
/// A train of the library, with as little as will do.
pub(crate) const TRAIN: &str = include_str!("files/train.toml");
/// A lorry on a road, to the left.
pub(crate) const LORRY: &str = include_str!("files/lorry.toml");
/// A single axle of a known force.
pub(crate) const AXLE: &str = include_str!("files/axle.toml");
/// A lorry, vehicles of the library and jacks at rest, with their readings.
pub(crate) const LOAD_TEST: &str = include_str!("files/load-test.toml");
/// A jack at rest, with a table of readings.
pub(crate) const LOAD_TABLE: &str = include_str!("files/load-table.toml");
/// A train from a file.
pub(crate) const TRAIN_FILE: &str = include_str!("files/train-file.toml");

/// Everything that an assessment may say.
pub(crate) const ASSESS: &str = include_str!("files/assess.toml");

/// Fill and backing as a continuum, and all that it may say.
pub(crate) const CONTINUUM: &str = include_str!("files/continuum.toml");

/// A road that is not level.
pub(crate) const CASES: &str = include_str!("files/cases.toml");
/// Springings on a gradient, and everything that piers, abutments and hollow spandrels may say.
pub(crate) const GRADIENT: &str = include_str!("files/gradient.toml");
pub(crate) const ROAD: &str = include_str!("files/road.toml");

/// Two rings with every kind of defect.
pub(crate) const DEFECTS: &str = include_str!("files/defects.toml");

/// A ring with a past: an open joint, dropped stones, a support that has moved, water in its fill, a canted track on a curve.
pub(crate) const CONDITION: &str = include_str!("files/condition.toml");

/// Everything that only the finite element model reads.
pub(crate) const SERVICE: &str = include_str!("files/service.toml");

/// All of them.
pub(crate) const GOOD: [&str; 24] = [
    CASE_1,
    GRADIENT,
    NAMED,
    CASES,
    VIADUCT,
    SHAPES,
    TINY,
    WALLS,
    PARTICLES,
    LAYERS,
    CONTINUUM,
    DEFECTS,
    CONDITION,
    ROAD,
    CALIBRATION,
    SERVICE,
    PASSAGE,
    TRAIN,
    TRAIN_FILE,
    LORRY,
    AXLE,
    LOAD_TEST,
    LOAD_TABLE,
    ASSESS,
];

/// A finding as plain text, for assertions and for reading.
pub(crate) fn show(text: &str, finding: &Diagnostic) -> String {
    let place = finding.range.position(text.as_bytes());
    let line = text.lines().nth(place.line - 1).unwrap_or("");
    let marked =
        text.get(finding.range.start..finding.range.end).unwrap_or("").chars().take_while(|c| *c != '\n').count();
    let severity = if finding.severity == Severity::Error { "error" } else { "warning" };
    let mut out = format!("{severity}[{}]: {}\n", finding.code, finding.message);
    out += &format!("  {}:{}\n", place.line, place.column);
    out +=
        &format!("  | {line}\n  | {}{} {}\n", " ".repeat(place.column - 1), "^".repeat(marked.max(1)), finding.label);
    for (title, words) in [("note", &finding.note), ("help", &finding.help)] {
        if let Some(words) = words {
            out += &format!("  {title}: {words}\n");
        }
    }
    out
}

/// All findings of a file as plain text.
pub(crate) fn show_all(text: &str) -> String {
    bridge::read(text.as_bytes()).diagnostics.iter().map(|finding| show(text, finding) + "\n").collect()
}
