//! How blocks of a file or a drawing lose what may help them: the bond of their joints.

use super::states::{State, sets};
use mechanics::blocks::ContactLaw;
use mechanics::ids::{GroupId, Id};
use outcome::help::Help;
use structure::blocks::Scene;

/// Every state of the blocks that may lead.
pub(in crate::analysis) fn states_of_blocks(scene: &Scene) -> Vec<State<Scene>> {
    let crushes = scene.materials.iter().any(|material| material.masonry.compressive_strength.is_some());
    let laws = || pairs(scene).into_iter().map(|[a, b]| scene.laws.between(a, b));
    let has = |help: &Help| match help {
        Help::Tension => laws().any(|law| law.tension > 0.0),
        Help::Cohesion => laws().any(|law| law.cohesion > 0.0) && (crushes || scene.plan.method.joints_deform()),
        Help::Water | Help::Movement | Help::FillPressure | Help::Parapets | Help::LostStone => false,
    };
    let all: Vec<Help> = Help::ALL.iter().copied().filter(has).collect();
    sets(&all).into_iter().map(|helps| State { bridge: with_only(scene, &all, &helps), helps }).collect()
}

/// Pairs of materials of blocks: what particles of soil have among themselves is theirs.
fn pairs(scene: &Scene) -> Vec<[GroupId; 2]> {
    let used = |k: &usize| scene.bodies.iter().any(|body| body.material == *k);
    let groups: Vec<GroupId> = (0..scene.materials.len()).filter(used).map(GroupId::new).collect();
    groups.iter().flat_map(|a| groups.iter().map(|b| [*a, *b])).collect()
}

fn with_only(scene: &Scene, all: &[Help], kept: &[Help]) -> Scene {
    let mut own = scene.clone();
    let lost = |help: Help| all.contains(&help) && !kept.contains(&help);
    for [a, b] in pairs(scene) {
        let law = *scene.laws.between(a, b);
        let tension = if lost(Help::Tension) { 0.0 } else { law.tension };
        let cohesion = if lost(Help::Cohesion) { 0.0 } else { law.cohesion };
        own.laws.set(a, b, ContactLaw { tension, cohesion, ..law });
    }
    own
}
