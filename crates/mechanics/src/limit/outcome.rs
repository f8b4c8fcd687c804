//! What a limit analysis reports.

use super::settings::Friction;
use crate::blocks::Interface;
use crate::ids::{BlockId, Table};
use crate::plane::Vec2;

/// How a limit analysis ended. All of these are answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Status {
    /// The largest load factor was found.
    Solved,
    /// The blocks lock: every load factor is carried.
    Locks,
    /// The permanent loads alone are not carried.
    NoEquilibrium,
    /// The program was not solved to its tolerance; no number is reported as an answer.
    #[default]
    NotConverged,
    /// It was stopped on the way; no number is reported.
    Cancelled,
}

/// Forces of one contact point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointForces {
    /// Where [m].
    pub at: Vec2,
    /// Compression [N/m], positive.
    pub compression: f64,
    /// Shear [N/m], positive when the force on the second block acts along the tangent `normal.left()`. The shear of a
    /// joint is shared among its points in proportion to their compression.
    pub shear: f64,
}

/// Forces of one joint.
#[derive(Debug, Clone, PartialEq)]
pub struct JointForces {
    /// The contact points, in the order of the interface.
    pub points: Vec<PointForces>,
    /// Shear of the whole joint [N/m].
    pub shear: f64,
}

impl JointForces {
    /// Compression of the whole joint [N/m].
    pub fn compression(&self) -> f64 {
        self.points.iter().map(|p| p.compression).sum()
    }
}

/// Where the resultant of a joint passes: a point of the line of thrust.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resultant {
    /// Where it crosses the joint [m].
    pub at: Vec2,
    /// The force on the second block [N/m].
    pub force: Vec2,
}

/// How the two sides of a joint move apart in the mechanism, per unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointMotion {
    /// Rotation of the second block relative to the first [rad].
    pub rotation: f64,
    /// Sliding of the second block relative to the first along `normal.left()` [m].
    pub sliding: f64,
    /// Least opening over the contact points [m].
    pub opening: f64,
}

/// A joint that turns about one of its contact points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    /// Index of the interface.
    pub joint: usize,
    /// Index of the contact point that stays closed.
    pub point: usize,
    /// Where [m].
    pub at: Vec2,
    /// Rotation of the second block relative to the first [rad].
    pub rotation: f64,
}

/// The collapse mechanism, scaled so that the fastest point of the fastest block moves by 1 m.
#[derive(Debug, Clone, PartialEq)]
pub struct Mechanism {
    /// Translation of each block's centroid [m] and its rotation [rad].
    pub velocities: Table<BlockId, (Vec2, f64)>,
    /// How each joint moves.
    pub joints: Vec<JointMotion>,
    /// Joints that open about a contact point.
    pub hinges: Vec<Hinge>,
    /// Indices of the joints that slide.
    pub sliding: Vec<usize>,
}

/// The result of a limit analysis; by default one without numbers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Load factor of the variable loads at collapse; `None` unless solved.
    pub factor: Option<f64>,
    /// Load factor that the returned forces balance, recomputed from them; a lower bound for associated friction as far
    /// as `equilibrium_residual` and `yield_violation` vanish. Where the way without dilation has no end, the load
    /// factor without friction in the joints that slide, if there is one.
    pub lower_bound: Option<f64>,
    /// Load factor recomputed from the velocities of the associated mechanism by the work equation; an upper bound, for
    /// either flow rule, as far as `flow_violation` vanishes.
    pub upper_bound: Option<f64>,
    /// Largest out-of-balance force of the forces behind the lower bound, relative to all loads at that factor.
    pub equilibrium_residual: f64,
    /// Largest force by which a joint exceeds its strength, relative to all loads at that factor.
    pub yield_violation: f64,
    /// Largest velocity that the flow rule does not allow in the mechanism of the upper bound, relative to the fastest.
    pub flow_violation: f64,
    /// The joints, between which blocks and where.
    pub interfaces: Vec<Interface>,
    /// Forces of each joint; empty unless solved.
    pub forces: Vec<JointForces>,
    /// Resultant of each joint; `None` where it carries no compression. Empty unless solved.
    pub resultants: Vec<Option<Resultant>>,
    /// The mechanism: at collapse, or the one in which the permanent loads fall.
    pub mechanism: Option<Mechanism>,
    /// The flow rule that the numbers belong to: never [`Friction::Automatic`].
    pub friction: Friction,
    /// Load factor with associated friction, where it was found.
    pub associated_factor: Option<f64>,
    /// The load factor without dilation, and the largest on the way to it.
    pub spread: Option<[f64; 2]>,
    /// Whether the load comes and goes between them, so that blocks snap from state to state: the motion is then that of one of them.
    pub comes_and_goes: bool,
    /// Whether blocks stand without dilation only as far as they are jammed: by friction on compressions that self-stress alone brings about.
    /// What they carry then is not known.
    pub jammed: bool,
    /// Iterations of the solver in all.
    pub iterations: u32,
}
