//! The loads of a file as an engineer asked for them: an axle has a width of its own, so that its load times the width of the bridge
//! is no load that anybody asked for.

use bridge::{Bridge, LoadKind};
use outcome::collapse::AskedAxles;

/// Loads of axles, in the order of the file.
pub(super) fn asked(bridge: &Bridge) -> Vec<AskedAxles> {
    let axles = bridge.loads.iter().filter_map(|load| match &load.kind {
        LoadKind::Axles { axles, effective_width, .. } => Some(AskedAxles {
            name: load.name.clone(),
            axles: axles.iter().map(|axle| axle.0).collect(),
            effective_width: *effective_width,
        }),
        _ => None,
    });
    axles.collect()
}
