//! What following the path reports.

use crate::blocks::Interface;
use crate::ids::{BlockId, Table};
use crate::plane::{Pose, Vec2};
use serde::{Deserialize, Serialize};

/// How the path ended. All of these are answers. Kept runs name them by their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Status {
    /// Every load up to the limit was carried.
    StableToLastLoad,
    /// The load passed a largest value: beyond it the blocks carry less.
    LimitPoint,
    /// The path lost its uniqueness below any largest load: the blocks may leave it sideways, at the same load.
    Bifurcation,
    /// The next balanced state was not found, and no fall proves that there is none; the last one is kept, and its load is
    /// carried. Without one, not even the self-weight is known to be carried.
    #[default]
    NotConverged,
    /// The blocks do not stand under their own weight: let go, they fall for good.
    UnstableUnderSelfWeight,
    /// The onlooker stopped it.
    Cancelled,
}

/// What gives way at the largest load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// Joints that open.
    Hinging,
    /// Joints that slide.
    Sliding,
    /// Joints whose stress is at the crushing strength.
    Crushing,
}

/// One balanced state, in numbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PathPoint {
    /// Load factor.
    pub factor: f64,
    /// Displacement of the watched point since it was built [m].
    pub displacement: Vec2,
    /// Largest distance of a joint's thrust from its middle, as a share of the joint's length: 0 to 0.5, and more where a bond pulls.
    pub eccentricity: f64,
    /// Largest share of a joint's length that is open, 0 to 1.
    pub opened: f64,
    /// Joints that are open over more than half of their length.
    pub hinges: u32,
    /// Joints that slide.
    pub sliding: u32,
    /// Greatest compressive stress at the edge of a joint [Pa].
    pub stress: f64,
    /// Largest share of a joint's length that is at its crushing strength, 0 to 1.
    pub crushed: f64,
    /// What fill that blocks move against adds, as a share of all that it could add there, 0 to 1; 0 where nothing moves against any.
    pub mobilised: f64,
    /// Largest shear beyond the friction and cohesion of a joint's end [N/m]; rounding alone where the law is kept.
    pub excess: f64,
    /// How far the centre of the block that moves most does for a load factor of one more, by the tangent here [m]; none where the path does
    /// not rise.
    pub rate: Option<f64>,
    /// Iterations of this step.
    pub iterations: u32,
    /// Largest out-of-balance force, relative to all acting forces.
    pub residual: f64,
}

/// One end of a joint that presses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndState {
    /// Where [m].
    pub at: Vec2,
    /// Compression [N/m], positive; negative where a bond pulls.
    pub compression: f64,
    /// Shear [N/m], positive when the force on the second block acts along the tangent.
    pub shear: f64,
    /// Length that resists shear [m].
    pub length: f64,
    /// Overlap [m]; negative where the end is open.
    pub overlap: f64,
    /// Whether it slides.
    pub sliding: bool,
}

/// One joint in a balanced state.
#[derive(Debug, Clone, PartialEq)]
pub struct JointState {
    /// Unit normal from the first to the second block.
    pub normal: Vec2,
    /// Its two ends, along `normal.left()`.
    pub ends: [EndState; 2],
    /// Greatest compressive stress [Pa].
    pub stress: f64,
    /// Share of its length that is open and without bond, 0 to 1.
    pub opened: f64,
    /// Share of its length that is at the crushing strength, 0 to 1.
    pub crushed: f64,
}

impl JointState {
    /// Compression of the whole joint [N/m].
    pub fn compression(&self) -> f64 {
        self.ends.iter().map(|end| end.compression).sum()
    }
    /// Shear of the whole joint [N/m].
    pub fn shear(&self) -> f64 {
        self.ends.iter().map(|end| end.shear).sum()
    }
    /// Where the resultant passes [m]; none where the joint carries nothing.
    pub fn resultant(&self) -> Option<Vec2> {
        let total = self.compression();
        let [a, b] = &self.ends;
        (total > 0.0).then(|| a.at + (b.at - a.at) * (b.compression / total))
    }
    /// Force on the second block [N/m].
    pub fn force(&self) -> Vec2 {
        self.normal * self.compression() + self.normal.left() * self.shear()
    }
}

/// The blocks in one balanced state.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Load factor.
    pub factor: f64,
    /// Index into the path.
    pub step: usize,
    /// Where the blocks are.
    pub poses: Table<BlockId, Pose>,
    /// The joints, in the order of the model's interfaces.
    pub joints: Vec<JointState>,
}

/// The result of following the path.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// What gives way; none where nothing did.
    pub cause: Option<Cause>,
    /// Load factor of the limit point or the bifurcation; none where there is neither.
    pub collapse_factor: Option<f64>,
    /// Largest load factor of a balanced state before the collapse; none where not even the self-weight was carried.
    pub last_stable_factor: Option<f64>,
    /// Load factors at which the states that the settings name are first met, in their order; none where one is not.
    pub onsets: Vec<Option<f64>>,
    /// The balanced states in their order; the first carries the self-weight.
    pub path: Vec<PathPoint>,
    /// Self-weight, some states on the way, the peak, and the last one.
    pub frames: Vec<Frame>,
    /// Index into `frames` of the state at the largest load.
    pub peak: Option<usize>,
    /// How the blocks move where the load no longer grows: translation [m] and rotation [rad], the fastest point of the
    /// fastest block by 1 m. Empty without a collapse.
    pub mechanism: Table<BlockId, (Vec2, f64)>,
    /// The joints as built.
    pub interfaces: Vec<Interface>,
    /// Iterations in all.
    pub iterations: u32,
    /// How often balance was lost and found again close by.
    pub snaps: u32,
}
