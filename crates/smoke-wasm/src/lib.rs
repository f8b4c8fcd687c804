//! Analyses from the bytes of a bridge file to one JSON text, in WebAssembly and elsewhere. It shows that the libraries run
//! where there are no files, no clock and no threads, and what that costs; it is no interface to rely on.

#[cfg(target_family = "wasm")]
mod exports;

use extrados::bridge::Method;
use extrados::results::published;
use extrados::{
    Choice, CollapseOptions, Memory, Project, Refusal, RespondOptions, SweepOptions, Swept, Unwatched, figures,
};
use serde_json::{Map, Value, json};

/// The load that makes a mechanism, by the method that the number names, and its drawings as SVG.
pub fn collapse(file: &[u8], method: u32) -> String {
    answer(file, |project| {
        let method = if method == DEM { Method::Dem } else { Method::Limit };
        let choice = Choice { method: Some(method), ..Choice::default() };
        let found = extrados::collapse(project, &CollapseOptions { choice, resume: None }, &mut Unwatched)?;
        let drawn = figures::drawings(&found.picture).into_iter().map(|(name, svg)| (name, svg.into()));
        let drawings: Map<String, Value> = drawn.collect();
        Ok(json!({ "result": found.object(), "drawings": drawings }))
    })
}

/// Limit analysis and discrete elements, as [`collapse`] takes them.
pub const LIMIT: u32 = 0;
/// See [`LIMIT`].
pub const DEM: u32 = 1;

/// The load at a hundred positions along the bridge.
pub fn sweep(file: &[u8]) -> String {
    answer(file, |project| {
        let bridge = project.bridge()?;
        match extrados::sweep(project, &SweepOptions::default(), &mut Unwatched)? {
            Swept::Loads(found) => Ok(json!({ "result": found.object(&bridge.name, bridge.width) })),
            Swept::Vehicles(_) => Ok(json!({ "error": "the file moves vehicles" })),
        }
    })
}

/// What sensors see as a train crosses.
pub fn respond(file: &[u8]) -> String {
    answer(file, |project| {
        let found = extrados::respond(project, &RespondOptions::default(), &mut Unwatched)?;
        Ok(json!({ "result": found.object(), "influence": published::influence_table(&found) }))
    })
}

fn answer(file: &[u8], analysis: impl FnOnce(&Project) -> Result<Value, Refusal>) -> String {
    let project = Project::read("bridge.toml", &Memory::default().with("bridge.toml", file));
    let found = project.and_then(|project| analysis(&project));
    found.unwrap_or_else(|refusal| json!({ "error": refusal.message })).to_string()
}
