//! Runs a case's input and finds the quantities it speaks of.

use super::blocks::Blocks;
use assess::analysis;
use mechanics::watch::Unwatched;
use serde_json::Value as Json;

/// The result object of an input document: a bridge where it has a `[bridge]` or a `[[span]]`, a block model where it
/// has a `[model]`, bare blocks otherwise. A bridge with a `[calibration]` is calibrated, others are made to collapse.
pub(crate) fn measure(document: &toml::Table) -> Result<Json, String> {
    if document.contains_key("model") {
        return block_model(&toml::to_string(document).map_err(|e| e.to_string())?);
    }
    if !document.contains_key("bridge") && !document.contains_key("span") {
        let blocks: Blocks = toml::Value::Table(document.clone()).try_into().map_err(|e| format!("blocks: {e}"))?;
        return blocks.run();
    }
    let text = toml::to_string(document).map_err(|e| e.to_string())?;
    let read = bridge::read(text.as_bytes());
    let Some(bridge) = read.bridge else { return Err(said(&read.diagnostics)) };
    if document.contains_key("calibration") {
        return calibrated(&bridge);
    }
    let found = analysis::collapse(&bridge, None, &mut Unwatched).map_err(|e| e.to_string())?;
    let mut object = found.object();
    object.extend(derived(&bridge, &found));
    Ok(object.into())
}

/// Errors in one line.
pub(super) fn said(diagnostics: &[bridge::Diagnostic]) -> String {
    let errors = diagnostics.iter().filter(|d| d.severity == bridge::Severity::Error);
    errors.map(|d| format!("{} {} ({})", d.code, d.message, d.label)).collect::<Vec<_>>().join("; ")
}

/// The result object of a block model file, whose drawing is named by a path that leads to it from anywhere.
fn block_model(text: &str) -> Result<Json, String> {
    let read = bridge::read_blocks(text.as_bytes());
    let Some(file) = read.file else { return Err(said(&read.diagnostics)) };
    let path = file.drawing.as_ref().map(|part| part.file.clone());
    let dxf = path.map(|path| crate::read_bytes(path.as_ref()).map_err(|e| format!("{path}: {e}"))).transpose()?;
    let assembled = structure::blocks::assemble(&file, dxf.as_deref());
    let Some(scene) = assembled.scene else {
        let errors = assembled.findings.iter().filter(|f| f.severity == drawing::Severity::Error);
        let drawn = errors.map(|f| format!("{} {} ({})", f.code, f.message, f.place));
        let told = drawn.chain([said(&assembled.diagnostics)]).collect::<Vec<_>>();
        return Err(told.join("; "));
    };
    let found = analysis::collapse_of_blocks(&scene, None, &mut Unwatched).map_err(|e| e.to_string())?;
    Ok(found.object().into())
}

/// The result object of a calibration of fill, with its status.
fn calibrated(bridge: &bridge::Bridge) -> Result<Json, String> {
    let found = analysis::calibrate::calibrate_fill(bridge, &mut Unwatched).map_err(|e| e.to_string())?;
    let mut object = found.object();
    object.insert("status".to_string(), found.verdict.word().into());
    Ok(object.into())
}

/// Quantities that cases ask for and results need not repeat.
fn derived(bridge: &bridge::Bridge, c: &outcome::collapse::Collapse) -> Vec<(String, Json)> {
    let mut found = Vec::new();
    let span = &bridge.spans[0];
    // Angle of the haunch hinge from the crown, for circles: the intrados hinge above the springings nearest to them.
    let radius = (0.25 * span.span * span.span + span.rise * span.rise) / (2.0 * span.rise);
    let angle = |p: [f64; 2]| (p[0] - 0.5 * span.span).atan2(p[1] - span.rise + radius).to_degrees().abs();
    let haunches =
        c.picture.hinges.iter().filter(|h| h.edge == outcome::picture::HingeAt::Intrados).map(|h| angle(h.point));
    if let Some(haunch) = haunches.reduce(f64::max) {
        found.push(("haunch_hinge_from_crown_deg".to_string(), haunch.into()));
    }
    let edges: Vec<&str> = c
        .picture
        .hinges
        .iter()
        .map(|h| match h.edge {
            outcome::picture::HingeAt::Intrados => "I",
            outcome::picture::HingeAt::Extrados => "E",
            outcome::picture::HingeAt::Other => "O",
        })
        .collect();
    found.push(("hinge_edges".to_string(), edges.concat().into()));
    // Walls have hinges of their own, in no order.
    let mut ring: Vec<_> = c.picture.hinges.iter().zip(&edges).filter(|(_, edge)| **edge != "O").collect();
    ring.sort_by(|a, b| a.0.point[0].total_cmp(&b.0.point[0]));
    let ring: Vec<&str> = ring.into_iter().map(|(_, edge)| *edge).collect();
    found.push(("ring_hinge_edges".to_string(), ring.concat().into()));
    if let (Some(stable), Some(bound)) = (c.last_stable_load, c.limit_load) {
        found.push(("last_stable_over_limit_load".to_string(), (stable / bound).into()));
    }
    found
}

/// A quantity of a result: keys joined by points, and rows by their number, code or name; `length` counts rows.
pub(crate) fn find<'a>(result: &'a Json, quantity: &str) -> Option<std::borrow::Cow<'a, Json>> {
    let mut at = result;
    for part in quantity.split('.') {
        at = match at {
            Json::Array(rows) if part == "length" => return Some(std::borrow::Cow::Owned(rows.len().into())),
            Json::Array(rows) => match part.parse::<usize>() {
                Ok(row) => rows.get(row)?,
                Err(_) => rows
                    .iter()
                    .find(|row| ["code", "name"].iter().any(|key| row.get(key).is_some_and(|of| of == part)))?,
            },
            Json::Object(keys) => keys.get(part)?,
            _ => return None,
        };
    }
    Some(std::borrow::Cow::Borrowed(at))
}
