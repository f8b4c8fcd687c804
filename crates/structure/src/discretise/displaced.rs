//! A bridge in the shape to which a support that has moved brought it, before any load comes.
//!
//! Blocks follow the support as the mechanism that their weight allows (`mechanics::limit::support_movement`), which tells where each of
//! them is. Where joints opened, the faces of both blocks are brought together again in the plane halfway between them: what is left is a
//! bridge of another shape with whole joints. So the load follows the movement from that of the bridge as built on. Such a load may first
//! have to turn joints back that opened; a joint that is to stay open is a defect of its own.

use super::continuum;
use super::extrados::Stretch;
use super::{DiscretiseError, Discretised};
use bridge::{Analysis, Bridge};
use mechanics::blocks::{Interface, Loading, PointForce};
use mechanics::ids::{BlockId, Table};
use mechanics::limit::{Increments, MovementStatus, Settings, support_movement};
use mechanics::plane::{Polygon, Pose, Vec2, vec2};
use mechanics::watch::CancelToken;

/// Corners nearer to the plane of a joint than this lie in it [m]: more than what stands free where mortar is lost.
const IN_PLANE: f64 = 5e-4;

/// How far two joints may disagree about a corner that they share [m].
const SAME: f64 = 1e-6;

/// Share of a movement that is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Largest increment of the movement as a share of the shortest span, and least number of increments.
const INCREMENT: f64 = 1e-3;
const LEAST_STEPS: f64 = 8.0;

/// The bridge as its support has moved it; as it is where none has, and where the movement itself or the thickness is the question.
pub(super) fn displaced(bridge: &Bridge, d: Discretised) -> Result<Discretised, DiscretiseError> {
    let before = bridge.plan.support_movement.and_then(|movement| movement.before);
    let Some(before) = before.filter(|_| bridge.plan.analysis == Analysis::Load) else { return Ok(d) };
    let several = bridge.spans.iter().any(|span| span.rings.len() > 1);
    if several || d.road.is_some() || d.fill.is_some() || continuum::wanted(bridge).is_some() {
        return Err(DiscretiseError::MovedShape);
    }
    let shortest = bridge.spans.iter().map(|span| span.span).fold(f64::INFINITY, f64::min);
    let step = (INCREMENT * shortest).min(before / LEAST_STEPS);
    let increments = Increments { largest: before, step, resolution: 1e-3 * step };
    let loading = Loading {
        permanent: d.loading.permanent.clone(),
        movements: d.loading.movements.clone(),
        ..Loading::default()
    };
    let found = support_movement(&d.model, &loading, 0.0, increments, &Settings::default(), &CancelToken::default())
        .map_err(|_| DiscretiseError::MovedShape)?;
    // Sums of increments miss the last one by round-off, and nothing is left of it to follow.
    let arrived = found.stands >= before * (1.0 - ROUND_OFF);
    if found.status != MovementStatus::StandsThroughout && !arrived {
        return Err(DiscretiseError::FellBefore { before, stands: found.stands });
    }
    Moved { built: d.model.poses(), now: found.poses, joints: &found.interfaces }.apply(d)
}

/// Poses as built and now, and the joints as built.
struct Moved<'a> {
    built: Table<BlockId, Pose>,
    now: Table<BlockId, Pose>,
    joints: &'a [Interface],
}

impl Moved<'_> {
    /// Where a point that is fast to a block is now.
    fn rigid(&self, block: BlockId, at: Vec2) -> Vec2 {
        let built = self.built[block];
        self.now[block].place(built.rotation.turn_back(at - built.position))
    }

    /// Where a corner of a block goes: halfway between both blocks where it lies in the plane of a joint, with what is fixed where one of them
    /// is, and else with its block. The mean of two rigid motions keeps straight lines straight, so that both sides of a joint stay in touch.
    fn corner(&self, d: &Discretised, block: BlockId, at: Vec2) -> Result<Vec2, DiscretiseError> {
        let fixed = |block: BlockId| d.model.blocks[block].held.is_fixed();
        if fixed(block) {
            return Ok(self.rigid(block, at));
        }
        let in_plane = |joint: &&Interface| {
            let own = joint.first == block || joint.second == block;
            own && joint.face.len() > 1 && (at - joint.face[0]).dot(joint.normal).abs() < IN_PLANE
        };
        let mut found: Option<Vec2> = None;
        for joint in self.joints.iter().filter(in_plane) {
            let [first, second] = [joint.first, joint.second].map(|block| self.rigid(block, at));
            let to = match (fixed(joint.first), fixed(joint.second)) {
                (true, _) => first,
                (_, true) => second,
                _ => (first + second) * 0.5,
            };
            if found.is_some_and(|other| (other - to).norm() > SAME) {
                return Err(DiscretiseError::MovedShape);
            }
            found = Some(to);
        }
        Ok(found.unwrap_or_else(|| self.rigid(block, at)))
    }

    fn both(&self, d: &Discretised, block: BlockId, ends: [Vec2; 2]) -> Result<[Vec2; 2], DiscretiseError> {
        Ok([self.corner(d, block, ends[0])?, self.corner(d, block, ends[1])?])
    }

    fn apply(&self, built: Discretised) -> Result<Discretised, DiscretiseError> {
        let mut d = built.clone();
        for block in built.model.blocks.ids() {
            let vertices = built.model.blocks[block].outline.vertices();
            let outline: Result<Vec<Vec2>, _> = vertices.iter().map(|at| self.corner(&built, block, *at)).collect();
            d.model.blocks[block].outline = Polygon::new(outline?).map_err(|_| DiscretiseError::MovedShape)?;
            if let Some(faces) = &mut d.faces[block] {
                (faces.bed, faces.back) = (self.both(&built, block, faces.bed)?, self.both(&built, block, faces.back)?);
            }
        }
        let follow = |force: &mut PointForce| force.at = self.rigid(force.block, force.at);
        d.loading.permanent.iter_mut().for_each(follow);
        d.loading.variable.iter_mut().for_each(follow);
        d.spreads.iter_mut().for_each(|spread| spread.forces.iter_mut().for_each(follow));
        for point in &mut d.extrados.line {
            let covers = |stretch: &&Stretch| stretch.left.x - SAME <= point.x && point.x <= stretch.right.x + SAME;
            if let Some(own) = built.extrados.stretches.iter().find(covers) {
                *point = self.rigid(own.block, *point);
            }
        }
        d.extrados.line.sort_by(|a, b| a.x.total_cmp(&b.x));
        for stretch in &mut d.extrados.stretches {
            [stretch.left, stretch.right] = self.both(&built, stretch.block, [stretch.left, stretch.right])?;
        }
        for face in &mut d.extrados.faces {
            face.x = self.rigid(face.block, vec2(face.x, face.levels[0])).x;
        }
        d.watched.1 = self.rigid(d.watched.0, d.watched.1);
        Ok(d)
    }
}
