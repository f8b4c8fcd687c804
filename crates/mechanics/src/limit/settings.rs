//! How a limit analysis is done.

/// The flow rule of sliding joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Friction {
    /// Sliding dilates by the friction angle: one convex program, an upper bound on what real joints carry.
    #[default]
    Associated,
    /// Sliding without dilation: blocks between stiff joints, followed from rest to collapse.
    NonAssociated,
    /// Non-associated where sliding takes part in the associated mechanism.
    Automatic,
}

/// Which points of a joint carry compression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactPoints {
    /// The points where the rounded blocks touch: inset from the edges by the rounding.
    Rounded,
    /// The edges of the common face.
    FullRing,
}

/// How a limit analysis is done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// The flow rule of sliding joints.
    pub friction: Friction,
    /// Which points of a joint carry compression.
    pub contact_points: ContactPoints,
    /// Whether the finite compressive strength of the joints counts.
    pub crushing: bool,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { friction: Friction::Automatic, contact_points: ContactPoints::Rounded, crushing: false }
    }
}
