//! Reading a drawing: from bytes to outlines and circles, with every finding.

use crate::Point;
use crate::finding::{Finding, Findings, Place};
use crate::options::{Options, is_ignored};
use crate::shapes::{Drawing, Outline};
use crate::units::{Header, numbered};
use crate::{chain, entities, entity, outline, overlap, sieve};
use findings::Severity;
use std::collections::BTreeSet;

/// What reading gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Read {
    /// What was understood. Whether it can be used is for the findings.
    pub drawing: Drawing,
    /// Every finding.
    pub findings: Vec<Finding>,
}

impl Read {
    /// Whether no finding is an error.
    pub fn is_usable(&self) -> bool {
        self.findings.iter().all(|finding| finding.severity != Severity::Error)
    }
}

/// Reads a drawing from the bytes of a DXF file.
pub fn read(bytes: &[u8], options: &Options) -> Read {
    let mut findings = Findings::default();
    let drawing = understand(bytes, options, &mut findings).unwrap_or_default();
    Read { drawing, findings: findings.finish() }
}

fn understand(bytes: &[u8], options: &Options, findings: &mut Findings) -> Option<Drawing> {
    let sieved = sieve::sieve(bytes, findings)?;
    let unit = unit(sieved.header, options, findings);
    let content = entity::content(sieved.records, sieved.hidden_layers);
    let drawn = entities::expand(&content, unit, options, findings);
    let mut left_out = sieved.left_out;
    for (layer, _) in &drawn.points {
        *left_out.entry((layer.clone(), "POINT".to_owned())).or_insert(0) += 1;
    }
    for ((layer, kind), count) in left_out.iter().filter(|((layer, _), _)| !is_ignored(options, layer)) {
        let place = Place { layer: layer.clone(), ..Place::default() };
        let message = format!(
            "{count} of kind {kind} left out: only lines, arcs, polylines, circles, ellipses, splines \
                               and block references become outlines"
        );
        findings.warning("D104", place, message, "draw what is meant to be a block as a closed polyline");
    }
    let mut layers = layers(&drawn);
    let closed = chain::close(drawn.strands, options, findings);
    layers.retain(|layer| !closed.lines.contains(layer) || drawn.circles.iter().any(|circle| circle.layer == *layer));
    let outlines: Vec<Outline> =
        closed.outlines.into_iter().flat_map(|strand| outline::check(strand, options, findings)).collect();
    overlap::check(&outlines, findings);
    if layers.is_empty() && !findings.list.iter().any(|f| f.severity == Severity::Error) {
        let help = "export the outlines of the blocks; see also what was left out";
        findings.error("D101", Place::default(), "there is no outline and no circle in the drawing", help);
    }
    Some(Drawing { outlines, circles: drawn.circles, layers, unit })
}

/// A curve that was drawn without being an outline: one open line, or single points.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// Its points [m]: those of the line, with curves as chords, or the single points.
    pub points: Vec<Point>,
    /// Every finding; one that is an error says why the points cannot be used.
    pub findings: Vec<Finding>,
}

/// The one open line of a drawing, such as an intrados from springing to springing, or its single points; none of a drawing with outlines, circles or
/// several open lines, which is a drawing of blocks.
pub fn trace(bytes: &[u8], options: &Options) -> Option<Trace> {
    let mut findings = Findings::default();
    let sieved = sieve::sieve(bytes, &mut findings)?;
    let unit = unit(sieved.header, options, &mut findings);
    let content = entity::content(sieved.records, sieved.hidden_layers);
    let drawn = entities::expand(&content, unit, options, &mut findings);
    let is_line = chain::is_one_line(&drawn.strands, options);
    if !drawn.circles.is_empty() || !(is_line || (drawn.strands.is_empty() && drawn.points.len() > 1)) {
        return None;
    }
    let on_line = drawn.strands.into_iter().flat_map(|strand| strand.points);
    let points: Vec<Point> =
        if is_line { on_line.collect() } else { drawn.points.into_iter().map(|one| one.1).collect() };
    Some(Trace { points, findings: findings.finish() })
}

/// Every layer on which something is drawn, in order of first use.
fn layers(drawn: &entities::Strands) -> Vec<String> {
    let layers = drawn.strands.iter().map(|s| &s.place.layer).chain(drawn.circles.iter().map(|c| &c.layer));
    let mut known = BTreeSet::new();
    layers.filter(|layer| known.insert(layer.as_str())).cloned().collect()
}

/// Metres in one unit of the drawing: what the caller says, else the header.
fn unit(header: Header, options: &Options, findings: &mut Findings) -> f64 {
    let known = header.unit.and_then(numbered);
    match (options.unit, known, header.unit) {
        (Some(said), Some((symbol, metres)), _) if (said - metres).abs() > 1e-9 * said => {
            let message = format!("the header says {symbol}, the unit stated for this drawing is {said} m");
            findings.warning("D108", Place::default(), message, "take `unit` out if the header is right");
            said
        }
        (Some(said), _, _) => said,
        (None, Some((symbol, metres)), _) => {
            if let Some(other) = header.contradiction() {
                let message = format!("the header says two things: $INSUNITS {symbol}, and {other}; {symbol} is taken");
                let help = "see whether a known length comes out right; if not, state the unit, such as unit = \"mm\" or --unit mm";
                findings.warning("D111", Place::default(), message, help);
            }
            metres
        }
        (None, None, number) => {
            let message = match number {
                None => "the drawing does not say in which unit it is drawn: its header has no $INSUNITS".to_owned(),
                Some(0) => "the drawing does not say in which unit it is drawn: $INSUNITS is 0".to_owned(),
                Some(other) => format!("no bridge is drawn in the unit of this drawing ($INSUNITS is {other})"),
            };
            findings.error("D102", Place::default(), message, "state the unit, such as unit = \"mm\" or --unit mm");
            1.0
        }
    }
}
