//! A state in balance, looked at from outside: all that is taken from the solver are the poses of the blocks, the load factor and the
//! forces in the joints. Loads, lever arms, overlaps, pressures and strengths are computed here, by sums over strips.

use mechanics::blocks::{BlockModel, Interface, Loading};
use mechanics::ids::{BlockId, Id};
use mechanics::path::{Frame, JointState};
use mechanics::plane::Vec2;

/// What is wrong with a state, as shares of all forces that act.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Wrong {
    /// Largest force or moment over the blocks' size that is left over in a block.
    pub unbalanced: f64,
    /// Largest shear beyond friction and cohesion, and tension beyond the bond.
    pub beyond_strength: f64,
    /// Largest difference between a joint's compression and the pressure that its overlap makes, where it is distributed.
    pub pressure: f64,
}

impl Wrong {
    pub(crate) fn or(self, other: Wrong) -> Wrong {
        Wrong {
            unbalanced: self.unbalanced.max(other.unbalanced),
            beyond_strength: self.beyond_strength.max(other.beyond_strength),
            pressure: self.pressure.max(other.pressure),
        }
    }
}

/// Strips of a joint.
const STRIPS: usize = 4000;

/// Looks at a state of these blocks, and where asked for at the pressure in its joints.
pub(crate) fn look(
    (model, loading): (&BlockModel, &Loading),
    joints: &[Interface],
    frame: &Frame,
    (distributed, pressures): (bool, bool),
) -> Wrong {
    let mut sums = vec![(Vec2::ZERO, 0.0); model.blocks.len()];
    let mut acting = 0.0;
    let mut add = |block: BlockId, at: Vec2, force: Vec2| {
        let sum: &mut (Vec2, f64) = &mut sums[block.index()];
        sum.0 += force;
        sum.1 += (at - frame.poses[block].position).cross(force);
    };
    for (id, block) in model.blocks.pairs() {
        let weight = model.gravity * block.mass();
        acting += if block.held.is_fixed() { 0.0 } else { weight.norm() };
        add(id, frame.poses[id].position, weight);
    }
    for (forces, factor) in [(&loading.permanent, 1.0), (&loading.variable, frame.factor)] {
        for f in forces {
            acting += f.force.norm() * factor;
            add(f.block, frame.poses[f.block].place(f.at - model.blocks[f.block].outline.centroid()), f.force * factor);
        }
    }
    let mut wrong = Wrong::default();
    for (joint, face) in frame.joints.iter().zip(joints) {
        for end in &joint.ends {
            let force = joint.normal * end.compression + joint.normal.left() * end.shear;
            add(face.first, end.at, -force);
            add(face.second, end.at, force);
        }
        wrong = wrong.or(strength(model, face, joint, distributed));
        if distributed && pressures && face.points.len() > 1 {
            wrong.pressure = wrong.pressure.max(pressed(model, face, frame, joint));
        }
    }
    let size = |id: BlockId| model.blocks[id].outline.area().sqrt();
    for (id, _) in model.blocks.pairs().filter(|(_, block)| !block.held.is_fixed()) {
        let (force, moment) = sums[id.index()];
        wrong.unbalanced = wrong.unbalanced.max(force.norm()).max(moment.abs() / size(id));
    }
    let acting = f64::max(acting, f64::MIN_POSITIVE);
    Wrong {
        unbalanced: wrong.unbalanced / acting,
        beyond_strength: wrong.beyond_strength / acting,
        pressure: wrong.pressure / acting,
    }
}

/// How far the forces of a joint are beyond its strength [N/m].
fn strength(model: &BlockModel, face: &Interface, joint: &JointState, distributed: bool) -> Wrong {
    let law = model.laws.between(model.blocks[face.first].group, model.blocks[face.second].group);
    let tension = if distributed { law.tension } else { 0.0 };
    let beyond = |end: &mechanics::path::EndState| {
        let resisted = (law.friction * end.compression + law.cohesion * end.length).max(0.0);
        (end.shear.abs() - resisted).max(-end.compression - tension * end.length)
    };
    Wrong { beyond_strength: joint.ends.iter().map(beyond).fold(0.0, f64::max), ..Wrong::default() }
}

/// How far the compression of a joint is from the pressure that the overlap of its sides makes [N/m]. Where there is a bond, its history
/// is not known here: the compression lies between that of a joint without it and that of one that has all of it.
fn pressed(model: &BlockModel, face: &Interface, frame: &Frame, joint: &JointState) -> f64 {
    let law = model.laws.between(model.blocks[face.first].group, model.blocks[face.second].group);
    let centre = |id: BlockId| model.blocks[id].outline.centroid();
    let stiffness = law.normal.at((centre(face.second) - centre(face.first)).dot(face.normal).abs());
    let ends = [face.points[0], face.points[face.points.len() - 1]];
    let side = |id: BlockId| ends.map(|p| frame.poses[id].place(p - centre(id)));
    let (one, two) = (side(face.first), side(face.second));
    let along = ((one[1] - one[0]).unit() + (two[1] - two[0]).unit()).unit();
    let seen = |p: Vec2| (along.dot(p - one[0]), along.right().dot(p - one[0]));
    let line = |side: [Vec2; 2]| {
        let [(s0, h0), (s1, h1)] = side.map(seen);
        move |s: f64| h0 + (h1 - h0) * (s - s0) / (s1 - s0)
    };
    let (first, second) = (line(one), line(two));
    let from = seen(one[0]).0.max(seen(two[0]).0);
    let to = seen(one[1]).0.min(seen(two[1]).0);
    let strip = (to - from).max(0.0) / STRIPS as f64;
    let (mut least, mut most) = (0.0, 0.0);
    for k in 0..STRIPS {
        let s = from + (k as f64 + 0.5) * strip;
        let stress = (stiffness * (first(s) - second(s))).min(law.crushing);
        most += stress.max(0.0) * strip;
        least += if stress >= -law.tension { stress * strip } else { 0.0 };
    }
    let compression: f64 = joint.ends.iter().map(|end| end.compression).sum();
    (compression - most).max(least.min(most) - compression).max(0.0)
}
