//! Results with nothing found yet, for analyses to fill.

use super::picture;
use bridge::{Bridge, LoadKind, Plan};
use outcome::collapse::{AskedAxles, By, Collapse, Sought, Status};
use outcome::picture::Picture;
use structure::discretise::Discretised;

/// Of a bridge, drawn as built under a title.
pub(super) fn of_bridge(bridge: &Bridge, d: &Discretised, by: By, title: &str) -> Collapse {
    Collapse {
        bridge: bridge.name.clone(),
        width: bridge.width,
        asked: asked(bridge),
        block_names: d.origins.iter().map(|o| o.name()).collect(),
        ..of_blocks(&bridge.plan, d, by, picture::built(bridge, d, title))
    }
}

/// Of blocks without a name, a metre wide.
pub(super) fn of_blocks(plan: &Plan, d: &Discretised, by: By, picture: Picture) -> Collapse {
    Collapse {
        bridge: String::new(),
        width: 1.0,
        by,
        sought: Sought::Load,
        status: Status::Completed,
        collapse_load: None,
        last_stable_load: None,
        load_step: None,
        reference_load: d.reference_load,
        limit_load: None,
        crushing_limit_load: None,
        bonded_rings_load: None,
        stalled_load: None,
        max_compressive_stress: None,
        blocks: d.model.blocks.len(),
        particles: d.model.particles.len(),
        contacts: 0,
        tolerance: plan.tolerance,
        seed: plan.seed,
        packing: None,
        combination: None,
        wall_strip: None,
        not_counted: Default::default(),
        asked: Vec::new(),
        block_names: Vec::new(),
        warnings: Vec::new(),
        assumptions: Vec::new(),
        picture,
    }
}

/// Loads of axles as an engineer asked for them, in the order of the file: an axle has a width of its own, so that its load times the width
/// of the bridge is no load that anybody asked for.
fn asked(bridge: &Bridge) -> Vec<AskedAxles> {
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
