//! How equations of balance are solved.

/// What displacements do to geometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Kinematics {
    /// Balance on the geometry as it was.
    #[default]
    Small,
    /// Large displacements and rotations, small strains: each element and each spring in a frame that turns with it.
    Large,
}

/// Settings of Newton's method and of load steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Out-of-balance force over applied force (loads or reactions, whichever are larger) at which a step counts as balanced.
    pub tolerance: f64,
    /// Load steps asked for: no step is larger than one over this.
    pub load_steps: u32,
    /// Iterations allowed in one step; anew after pairs have broken in it.
    pub iteration_limit: u32,
    /// How often a step may be halved before the run gives up.
    pub cut_limit: u32,
}

impl Default for Settings {
    /// Ten load steps, 100 iterations each, as in the railway paper; out-of-balance force to 1e-6 where the paper had 1e-3.
    fn default() -> Settings {
        Settings { tolerance: 1e-6, load_steps: 10, iteration_limit: 100, cut_limit: 10 }
    }
}
