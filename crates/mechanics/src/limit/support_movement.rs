//! How far supports can move before the blocks fall.
//!
//! Rigid blocks without tension follow a moving support as a mechanism. In every increment they make the smallest
//! potential energy that contact allows: a linear program whose multipliers are the increments of all blocks,
//!
//! ```text
//! maximise  -f . (gap + opening by the supports)   subject to   B f + w = 0,   f within strength,
//! ```
//!
//! set up on the blocks where they are now. Gaps that opened before and contact points that slipped off one another by
//! the round-off of finite rotations stand in the same expression, so that errors do not add up over the increments:
//! a second program at the end of each increment settles the blocks, and each state is off by less than the square of
//! one increment's rotation times the size of a block. The blocks have fallen when no increment, however small, ends in
//! equilibrium after a small motion.

use super::collapse::{TOLERANCE, joint_forces, resultants};
use super::equilibrium::Equilibrium;
use super::joints::Joint;
use super::outcome::{Hinge, Resultant};
use super::program::{Program, Solution};
use super::settings::Settings;
use crate::blocks::{Block, BlockModel, Interface, Loading, ModelError, PointForce};
use crate::ids::{BlockId, Table};
use crate::plane::{Pose, Rotation, Vec2};
use crate::watch::CancelToken;

/// The increments of a movement, as factors of [`Loading::movements`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Increments {
    /// Largest factor to go to.
    pub largest: f64,
    /// One increment.
    pub step: f64,
    /// Where the increment is halved no further: the width of the final bracket.
    pub resolution: f64,
}

/// How a movement ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MovementStatus {
    /// The blocks fell.
    Collapsed,
    /// The blocks stood up to the largest movement.
    StandsThroughout,
    /// The blocks do not stand before any movement.
    #[default]
    NoEquilibrium,
    /// It was stopped on the way; the blocks stood as far as they came.
    Cancelled,
}

/// One state on the way.
#[derive(Debug, Clone, PartialEq)]
pub struct MovementStep {
    /// Factor of the movements.
    pub factor: f64,
    /// Force of all moved blocks together on the others [N/m].
    pub reaction: Vec2,
}

/// The blocks as they follow a moving support.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MovementOutcome {
    /// How it ended.
    pub status: MovementStatus,
    /// Largest factor of the movements at which the blocks stood.
    pub stands: f64,
    /// Smallest factor at which they fell; within the resolution of `stands`.
    pub falls: Option<f64>,
    /// The states on the way.
    pub path: Vec<MovementStep>,
    /// Where the blocks stood last.
    pub poses: Table<BlockId, Pose>,
    /// The joints as built.
    pub interfaces: Vec<Interface>,
    /// Line of thrust where the blocks stood last.
    pub resultants: Vec<Option<Resultant>>,
    /// Joints open on one side where the blocks stood last: index, contact point that stays closed, place [m],
    /// rotation [rad].
    pub hinges: Vec<Hinge>,
}

/// A step's motion counts as small up to this share of the mean joint length. The error of a step is its square.
const SMALL: f64 = 0.02;

/// Moves the supports as [`Loading::movements`] say, in increments, until the blocks fall. They carry gravity, the
/// permanent loads and `load_factor` times the variable ones. Joints slide with dilation, if at all.
///
/// # Errors
/// Nothing that is free to move, particles, or a block whose rounding leaves nothing of an edge.
pub fn support_movement(
    model: &BlockModel,
    loading: &Loading,
    load_factor: f64,
    increments: Increments,
    settings: &Settings,
    token: &CancelToken,
) -> Result<MovementOutcome, ModelError> {
    let (interfaces, Equilibrium { joints, length, .. }) = Equilibrium::of_free(model, loading, settings)?;
    let mut loads = loading.permanent.clone();
    loads.extend(loading.variable.iter().map(|f| PointForce { force: f.force * load_factor, ..*f }));
    let mut state = State {
        built: model.centroids(),
        centroids: model.centroids(),
        angles: model.blocks.iter().map(|_| 0.0).collect(),
        slipped: vec![0.0; joints.len()],
    };
    let chain = Chain { model, loading, loads: &loads, joints: &joints, token };
    let mut outcome = MovementOutcome { interfaces, ..MovementOutcome::default() };
    // The unit of length is half of the mean.
    let small = SMALL * (2.0 * length);
    let (mut factor, mut step) = (0.0, increments.step);
    while factor < increments.largest {
        let advance = step.min(increments.largest - factor);
        // Follow, then settle where that led to: there must be equilibrium at the end of an increment, not its start.
        let followed = chain.follow(&state, advance, advance).filter(|f| f.motion <= small);
        match followed.and_then(|f| chain.follow(&f.state, 0.0, advance)).filter(|f| f.motion <= small) {
            Some(followed) => {
                factor += advance;
                token.step();
                token.reach(factor / increments.largest);
                outcome.status = MovementStatus::StandsThroughout;
                outcome.stands = factor;
                outcome.path.push(MovementStep { factor, reaction: followed.reaction });
                outcome.resultants = followed.resultants;
                state = followed.state;
                step = (2.0 * step).min(increments.step);
            }
            None if token.is_cancelled() => {
                outcome.status = MovementStatus::Cancelled;
                break;
            }
            None if step > increments.resolution => step *= 0.5,
            None => {
                if !outcome.path.is_empty() {
                    outcome.status = MovementStatus::Collapsed;
                }
                outcome.falls = Some(factor + advance);
                break;
            }
        }
    }
    outcome.poses = state.poses();
    outcome.hinges = chain.hinges(&state);
    Ok(outcome)
}

/// Where the blocks are and how far their joints have slipped.
#[derive(Clone)]
struct State {
    built: Table<BlockId, Vec2>,
    centroids: Table<BlockId, Vec2>,
    angles: Table<BlockId, f64>,
    slipped: Vec<f64>,
}

impl State {
    fn poses(&self) -> Table<BlockId, Pose> {
        let each = self.centroids.iter().zip(self.angles.iter());
        each.map(|(&position, &angle)| Pose { position, rotation: Rotation::by(angle) }).collect()
    }
    /// Where a point of a block as built is now.
    fn place(&self, block: BlockId, at: Vec2) -> Vec2 {
        self.centroids[block] + Rotation::by(self.angles[block]).turn(at - self.built[block])
    }
}

/// What stays the same while the blocks move.
struct Chain<'a> {
    model: &'a BlockModel,
    loading: &'a Loading,
    loads: &'a [PointForce],
    joints: &'a [Joint],
    token: &'a CancelToken,
}

/// One increment.
struct Followed {
    state: State,
    /// Fastest motion of any contact point [m].
    motion: f64,
    reaction: Vec2,
    resultants: Vec<Option<Resultant>>,
}

/// A joint where its blocks are now, with the gaps of its points and its tangential offset [m].
struct Placed {
    joint: Joint,
    gaps: Vec<f64>,
    offset: f64,
}

impl Chain<'_> {
    fn place(&self, state: &State) -> Vec<Placed> {
        self.joints
            .iter()
            .enumerate()
            .map(|(index, joint)| {
                let turned = |block: BlockId| Rotation::by(state.angles[block]).turn(joint.normal);
                let normal = (turned(joint.first) + turned(joint.second)).unit();
                let pairs: Vec<(Vec2, Vec2)> =
                    joint.points.iter().map(|&p| (state.place(joint.first, p), state.place(joint.second, p))).collect();
                let gaps: Vec<f64> = pairs.iter().map(|(a, b)| (*b - *a).dot(normal)).collect();
                let closed = least(&gaps);
                let (a, b) = pairs[closed];
                Placed {
                    joint: Joint {
                        normal,
                        points: pairs.iter().map(|(a, b)| (*a + *b) * 0.5).collect(),
                        ..joint.clone()
                    },
                    offset: (b - a).dot(normal.left()) - state.slipped[index],
                    gaps,
                }
            })
            .collect()
    }

    /// Follows an increment of the movements; `None` when nothing keeps the blocks from falling. `scale` is an
    /// increment that says how large motions are.
    fn follow(&self, state: &State, advance: f64, scale: f64) -> Option<Followed> {
        let placed = self.place(state);
        let joints: Vec<Joint> = placed.iter().map(|p| p.joint.clone()).collect();
        let permanent = self.loads.iter().map(|f| PointForce { at: state.place(f.block, f.at), ..*f }).collect();
        let loading = Loading { permanent, ..Loading::default() };
        let equilibrium = Equilibrium::placed(self.model, state.centroids.clone(), &loading, joints);
        let equilibrium = Equilibrium { token: self.token.clone(), ..equilibrium };
        let imposed = self.imposed(advance);
        // Motions are in units of the largest imposed one, so that the program has numbers of the order of one.
        let unit = self.reference(&self.imposed(scale));
        let mut offsets = vec![0.0; equilibrium.columns.len()];
        for p in &placed {
            let (c, n) = (p.joint.column, p.gaps.len());
            let relative = |at: Vec2| {
                let of = |block: BlockId| {
                    let (v, w) = imposed[block];
                    v + (at - state.centroids[block]).left() * w
                };
                of(p.joint.second) - of(p.joint.first)
            };
            for k in 0..n {
                offsets[c + k] = p.gaps[k] + relative(p.joint.points[k]).dot(p.joint.normal);
            }
            offsets[c + n] = p.offset + relative(p.joint.points[0]).dot(p.joint.tangent());
        }
        let solution = Program {
            scaled_loads: &[],
            // `t` has no part in this program.
            cap: Some(0.0),
            objective: offsets.iter().map(|o| -o / unit).enumerate().collect(),
            ..Program::of_the_factor(&equilibrium)
        }
        .solve(TOLERANCE);
        solution.solved.then(|| self.moved((state, &placed), &equilibrium, &solution, (&imposed, unit)))
    }

    fn moved(
        &self,
        (state, placed): (&State, &[Placed]),
        equilibrium: &Equilibrium,
        solution: &Solution,
        (imposed, unit): (&Table<BlockId, (Vec2, f64)>, f64),
    ) -> Followed {
        let mut motions = equilibrium.motions(&solution.velocities);
        for (motion, (v, w)) in motions.iter_mut().zip(imposed.iter()) {
            *motion = (motion.0 * unit + *v, motion.1 * unit + *w);
        }
        let mut next = state.clone();
        for block in self.model.blocks.ids() {
            next.centroids[block] += motions[block].0;
            next.angles[block] += motions[block].1;
        }
        let forces = joint_forces(equilibrium, &solution.forces);
        let mut motion = 0.0f64;
        let mut reaction = Vec2::ZERO;
        let moved = |block: BlockId| self.loading.movements.iter().any(|m| m.block == block);
        for (index, (joint, force)) in equilibrium.joints.iter().zip(&forces).enumerate() {
            let of = |block: BlockId, at: Vec2| {
                let (v, w) = motions[block];
                v + (at - state.centroids[block]).left() * w
            };
            for &at in &joint.points {
                motion = motion.max(of(joint.first, at).norm()).max(of(joint.second, at).norm());
            }
            let total = force.compression();
            // At its limit by the solver's tolerance: the joint slips, and where it slips to is its new place.
            let limit = joint.strength.friction * total + joint.strength.cohesion;
            if force.shear.abs() >= limit - 1e-6 * equilibrium.force {
                let at = joint.points[least(&placed[index].gaps)];
                let slip = (of(joint.second, at) - of(joint.first, at)).dot(joint.tangent());
                next.slipped[index] += placed[index].offset + slip;
            }
            let on_second = joint.normal * total + joint.tangent() * force.shear;
            match (moved(joint.first), moved(joint.second)) {
                (true, false) => reaction += on_second,
                (false, true) => reaction += -on_second,
                _ => {}
            }
        }
        Followed { state: next, motion, reaction, resultants: resultants(equilibrium, &forces) }
    }

    /// Motion that is imposed on each block.
    fn imposed(&self, advance: f64) -> Table<BlockId, (Vec2, f64)> {
        let mut imposed: Table<BlockId, (Vec2, f64)> = self.model.blocks.iter().map(|_| (Vec2::ZERO, 0.0)).collect();
        for movement in &self.loading.movements {
            let (v, w) = &mut imposed[movement.block];
            *v += movement.translation * advance;
            *w += movement.rotation * advance;
        }
        imposed
    }

    /// Largest imposed motion of a block's outline [m].
    fn reference(&self, imposed: &Table<BlockId, (Vec2, f64)>) -> f64 {
        let of = |(block, &(v, w)): (&Block, &(Vec2, f64))| {
            let (low, high) = block.outline.bounds();
            v.norm() + w.abs() * 0.5 * (high - low).norm()
        };
        self.model.blocks.iter().zip(imposed.iter()).map(of).fold(f64::MIN_POSITIVE, f64::max)
    }

    fn hinges(&self, state: &State) -> Vec<Hinge> {
        let open = |(index, p): (usize, Placed)| {
            let point = least(&p.gaps);
            let rotation = state.angles[p.joint.second] - state.angles[p.joint.first];
            // Less than the resolution of one increment is no hinge.
            (rotation.abs() > 1e-6).then(|| Hinge { joint: index, point, at: p.joint.points[point], rotation })
        };
        self.place(state).into_iter().enumerate().filter_map(open).collect()
    }
}

fn least(gaps: &[f64]) -> usize {
    (0..gaps.len()).min_by(|&a, &b| gaps[a].total_cmp(&gaps[b])).unwrap_or(0)
}
