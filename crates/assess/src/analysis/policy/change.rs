//! What may help a bridge, and the bridge without it.

use crate::analysis::engine::can::{self, Feature, Knows};
use crate::analysis::state::{self, Change};
use bridge::{Analysis, Bridge, Joint, Strip};
use outcome::help::Help;

/// The helps that a bridge's file describes and its plan's method can see, in the order of [`Help::ALL`].
pub(super) fn helps(bridge: &Bridge) -> Vec<Help> {
    Help::ALL.iter().copied().filter(|help| has(bridge, *help)).collect()
}

/// The bridge with only some of its helps.
pub(super) fn with_only(bridge: &Bridge, all: &[Help], kept: &[Help]) -> Bridge {
    let lost: Vec<Change> = all.iter().filter(|help| !kept.contains(help)).map(|help| Change::Without(*help)).collect();
    state::with(bridge, &lost)
}

/// As many places of lost stone are kept and left out in every set; of more, each is left out by itself.
const EVERY_SET: usize = 3;

/// The bridge with some places of lost stone and not all: one may help where another harms. With no more than one there is none such.
pub(super) fn with_some_lost_stone(bridge: &Bridge) -> Vec<Bridge> {
    let places: Vec<(usize, usize)> = bridge
        .spans
        .iter()
        .enumerate()
        .flat_map(|(span, of)| of.defects.iter().enumerate().map(move |(k, defect)| ((span, k), defect)))
        .filter(|(_, defect)| defect.kind.may_help())
        .map(|(place, _)| place)
        .collect();
    let without = |lost: &dyn Fn(usize) -> bool| {
        let mut own = bridge.clone();
        // From the last on, so that the numbers of those before it stay.
        for (number, (span, k)) in places.iter().enumerate().rev() {
            if lost(number) {
                own.spans[*span].defects.remove(*k);
            }
        }
        own
    };
    match places.len() {
        0 | 1 => Vec::new(),
        count if count <= EVERY_SET => {
            (1..(1 << count) - 1).map(|set: usize| without(&|k| set >> k & 1 == 1)).collect()
        }
        count => (0..count).map(|one| without(&|k| k == one)).collect(),
    }
}

fn has(bridge: &Bridge, help: Help) -> bool {
    let joints = joints(bridge);
    match help {
        Help::Water => bridge.cover.water.is_some() || bridge.continuum.is_some_and(|plan| plan.water_level.is_some()),
        Help::Movement => {
            bridge.plan.analysis == Analysis::Load
                && bridge.plan.support_movement.is_some_and(|movement| movement.before.is_some())
        }
        Help::FillPressure => {
            bridge.fill_pressure.is_some_and(|fill| fill.applies)
                && can::knows(bridge.plan.method, Feature::FillPressure) == Knows::Yes
                && can::answers(bridge.plan.analysis, Feature::FillPressure) == Knows::Yes
        }
        // A wall stands on the strip below it, and holds fill that is a continuum. Up to a road that is not level it has no level of its own.
        Help::Parapets => {
            let top = bridge.spandrel_wall.and_then(|wall| wall.top);
            (bridge.plan.strip != Strip::Fill || bridge.continuum.is_some())
                && bridge.cover.road.is_none()
                && top.is_some_and(|top| top > bridge.cover.depth)
        }
        Help::LostStone => bridge.spans.iter().flat_map(|span| &span.defects).any(|defect| defect.kind.may_help()),
        Help::Tension => {
            joints.iter().any(|joint| joint.tensile_strength > 0.0)
                || bridge.continuum.is_some() && soil_tension(bridge).iter().any(|tension| *tension > 0.0)
        }
        // Rigid joints that turn about an edge have no cohesion there: it counts where they crush.
        Help::Cohesion => {
            joints.iter().any(|joint| joint.cohesion > 0.0)
                && (bridge.plan.method.joints_deform() || bridge.masonry.compressive_strength.is_some())
        }
    }
}

/// Joints that are in the model.
fn joints(bridge: &Bridge) -> Vec<Joint> {
    let several = bridge.spans.iter().any(|span| span.rings.len() > 1);
    let wall = bridge.spandrel_wall.filter(|_| bridge.plan.strip != Strip::Fill).map(|wall| wall.joint);
    [Some(bridge.joint), several.then_some(bridge.ring_joint), wall].into_iter().flatten().collect()
}

/// Tensile strengths of layers and backing that are a continuum [Pa].
fn soil_tension(bridge: &Bridge) -> Vec<f64> {
    let layers = bridge.cover.layers.iter().filter(|layer| layer.continuum).filter_map(|layer| layer.tensile_strength);
    layers.chain(bridge.cover.backing.and_then(|backing| backing.tensile_strength)).collect()
}
