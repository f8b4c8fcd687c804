//! Results with nothing found yet, for analyses to fill.

use super::loads_acting::asked;
use bridge::{Bridge, Plan};
use outcome::collapse::{By, Collapse, Sought, Status};
use outcome::picture::Picture;
use structure::discretise::Discretised;

pub(super) fn of_bridge(bridge: &Bridge, d: &Discretised, by: By, picture: Picture) -> Collapse {
    Collapse {
        bridge: bridge.name.clone(),
        width: bridge.width,
        asked: asked(bridge),
        block_names: d.origins.iter().map(|o| o.name()).collect(),
        ..of_blocks(&bridge.plan, d, by, picture)
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
        stalled_load: None,
        hinges: picture.hinges.clone(),
        sliding_joints: picture.sliding.clone(),
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
