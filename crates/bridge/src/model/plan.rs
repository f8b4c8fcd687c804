//! What is asked, by which method, with which settings.

use crate::choice::choice;

/// What to analyse, and how exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Which method `collapse` uses unless it is told.
    pub method: Method,
    /// Which analysis `collapse` makes unless it is told.
    pub analysis: Analysis,
    /// Which strip of the bridge's width it is made for.
    pub strip: Strip,
    /// Load increment of the discrete element method [N/m per metre of width, total of the load].
    pub load_step: Option<f64>,
    /// Largest load tried [N/m].
    pub load_limit: Option<f64>,
    /// Collapse is refined to this resolution [N/m] below the increment.
    pub resolution: Option<f64>,
    /// Out-of-balance force at rest, relative to the acting forces.
    pub tolerance: f64,
    /// Most iterations in one load step.
    pub step_limit: u64,
    /// Damping of the discrete element method.
    pub damping: Damping,
    /// Where joints carry what presses them; none where neither the file nor the caller says.
    pub contact: Option<JointContact>,
    /// Whether the length of a contact point is updated (stress formulation) or fixed (force formulation).
    pub contact_length: ContactLength,
    /// Share of the critical time step.
    pub time_step_factor: f64,
    /// Friction rule of limit analysis.
    pub friction: Friction,
    /// Where limit analysis puts the contact points of a joint.
    pub contact_points: ContactPoints,
    /// Support movement to analyse.
    pub support_movement: Option<SupportMovement>,
    /// Seed of whatever is random.
    pub seed: u64,
}

choice! {
    /// A method for collapse.
    pub enum Method {
        /// discrete elements: deformable joints, loads in steps to collapse
        Dem = "dem",
        /// limit analysis: the exact collapse load of rigid blocks
        Limit = "limit",
        /// the equilibrium path: rigid blocks on deformable joints, past the largest load
        Path = "path",
        /// finite elements: elastic stones on joints that open and slide; one ring between fixed abutments
        Fe = "fe",
    }
}

impl Method {
    /// What it is called in a sentence.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Method::Dem => "discrete elements",
            Method::Limit => "limit analysis",
            Method::Path => "the equilibrium path",
            Method::Fe => "finite elements",
        }
    }

    /// What it asks of the stiffness of joints.
    #[must_use]
    pub const fn stiffness(self) -> StiffnessAsked {
        match self {
            Method::Limit => StiffnessAsked::None,
            Method::Path => StiffnessAsked::OrModulus,
            Method::Dem | Method::Fe => StiffnessAsked::Given,
        }
    }

    /// Whether its joints deform; those of rigid blocks do not, and their cohesion counts only where they crush.
    #[must_use]
    pub fn joints_deform(self) -> bool {
        self.stiffness() != StiffnessAsked::None
    }

    /// Whether layers of fill may be particles in it. To the others they are weight.
    #[must_use]
    pub const fn has_particles(self) -> bool {
        match self {
            Method::Dem => true,
            Method::Limit | Method::Path | Method::Fe => false,
        }
    }

    /// Whether it follows loads that move; the others are given limit analysis in its place.
    #[must_use]
    pub const fn follows_moving_loads(self) -> bool {
        match self {
            Method::Path => true,
            Method::Limit | Method::Dem | Method::Fe => false,
        }
    }
}

/// What a method asks of the stiffness of joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StiffnessAsked {
    /// Joints are rigid.
    None,
    /// The file gives it.
    Given,
    /// The file gives it, or the modulus of the units, from which one is taken.
    OrModulus,
}

choice! {
    /// A strip of the bridge's width with what stands on its rings.
    pub enum Strip {
        /// between the walls: rings and cover
        Fill = "fill",
        /// below the walls: rings and bricks, loads as forces on the uppermost course
        Wall = "wall",
        /// both strips, and their loads added up by their widths
        Both = "both",
    }
}

choice! {
    /// What is made to collapse.
    pub enum Analysis {
        /// the load that makes a mechanism
        Load = "load",
        /// the least ring thickness that stands
        Thickness = "thickness",
        /// the support movement that makes a mechanism
        SupportMovement = "support-movement",
    }
}

/// Numerical damping.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// Local, non-viscous: opposes each motion with this share of the out-of-balance force.
    Local(f64),
    /// Global viscous, mass-proportional, with this share of critical in the lowest mode.
    Viscous(f64),
    /// Global viscous with an intensity that follows the motion.
    Adaptive,
}

choice! {
    /// Where a joint carries what presses it.
    pub enum JointContact {
        /// in a contact point at each of its two ends
        Points = "points",
        /// over the whole compressed part, with a pressure that grows with the overlap
        Distributed = "distributed",
    }
}

choice! {
    /// How long a stretch a contact point stands for.
    pub enum ContactLength {
        /// kept as built (force formulation)
        Fixed = "fixed",
        /// follows the compressed part of the joint (stress formulation)
        Updated = "updated",
    }
}

choice! {
    /// Flow rule of sliding joints in limit analysis.
    pub enum Friction {
        /// sliding dilates by the friction angle: exact bounds
        Associated = "associated",
        /// sliding does not dilate: blocks followed from rest between stiff joints
        NonAssociated = "non-associated",
        /// non-associated where sliding takes part in the mechanism or lowers the load
        Automatic = "automatic",
    }
}

choice! {
    /// Where the resultant of a joint may pass.
    pub enum ContactPoints {
        /// between the rounded corners, as in the discrete element method
        Rounded = "rounded",
        /// anywhere in the full thickness
        FullRing = "full-ring",
    }
}

/// A movement of one support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupportMovement {
    /// Which support: 0 is the left abutment, then piers, the last the right abutment.
    pub support: usize,
    /// Direction to the right [m per unit].
    pub horizontal: f64,
    /// Direction up [m per unit].
    pub vertical: f64,
    /// Rotation, counter-clockwise [rad per unit].
    pub rotation: f64,
    /// Movement that has already happened before loads come, in the same unit [m]; none: the bridge stands as it was built.
    pub before: Option<f64>,
    /// Increment of the discrete element method, in the same unit [m].
    pub increment: Option<f64>,
    /// Largest movement tried [m].
    pub limit: Option<f64>,
}
