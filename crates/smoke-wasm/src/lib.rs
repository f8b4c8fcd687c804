//! Analyses from the bytes of a bridge file to one JSON text, in WebAssembly and elsewhere. It shows that the libraries run
//! where there are no files, no clock and no threads, and what that costs; it is no interface to rely on.

#[cfg(target_family = "wasm")]
mod exports;

use assess::analysis::{self, Places, passage};
use assess::wire;
use bridge::{Bridge, Method, Severity};
use mechanics::watch::Unwatched;
use serde_json::{Value, json};

/// The load that makes a mechanism, by the method that the number names, and its drawings as SVG.
pub fn collapse(file: &[u8], method: u32) -> String {
    answer(file, |mut bridge| {
        bridge.plan.method = if method == DEM { Method::Dem } else { Method::Limit };
        let found = analysis::collapse(&bridge, None, &mut Unwatched).map_err(|error| error.to_string())?;
        let drawings: serde_json::Map<String, Value> =
            figures::drawings(&found.picture).into_iter().map(|(name, svg)| (name, svg.into())).collect();
        Ok(json!({ "result": wire::CollapseObject::new(&found, &wire::Run::default()), "drawings": drawings }))
    })
}

/// Limit analysis and discrete elements, as [`collapse`] takes them.
pub const LIMIT: u32 = 0;
/// See [`LIMIT`].
pub const DEM: u32 = 1;

/// The load at a hundred positions along the bridge.
pub fn sweep(file: &[u8]) -> String {
    answer(file, |bridge| {
        let step = assess::discretise::bridge_length(&bridge) / 100.0;
        let found = analysis::sweep(&bridge, Places::Every(step), true, &mut Unwatched);
        let found = found.map_err(|error| error.to_string())?;
        let result = wire::SweepObject::new(&bridge.name, bridge.width, &found, &wire::Run::default());
        Ok(json!({ "result": result }))
    })
}

/// What sensors see as a train crosses.
pub fn respond(file: &[u8]) -> String {
    answer(file, |bridge| {
        let found = passage::passage(&bridge, &mut Unwatched).map_err(|error| error.to_string())?;
        Ok(json!({ "result": wire::PassageObject::new(&found), "influence": wire::influence_table(&found) }))
    })
}

fn answer(file: &[u8], analysis: impl FnOnce(Bridge) -> Result<Value, String>) -> String {
    let read = bridge::read(file);
    let found = match read.bridge {
        Some(bridge) => analysis(bridge),
        None => {
            let errors = read.diagnostics.iter().filter(|found| found.severity == Severity::Error);
            Err(errors.map(|found| found.message.as_str()).collect::<Vec<_>>().join("; "))
        }
    };
    found.unwrap_or_else(|error| json!({ "error": error })).to_string()
}
