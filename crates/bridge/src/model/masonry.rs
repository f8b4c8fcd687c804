//! Masonry, its joints, walls over the rings.

use crate::cards::*;
use crate::choice::choice;
use crate::values::{finite, of_keys};

of_keys! {
    /// Masonry of rings and piers.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Masonry {
        pub density: f64 = density("mass density of the masonry", "2100 kg/m^3").positive(),
        pub elastic_modulus: Option<f64> = stress("Young's modulus of the masonry units", "15 GPa")
            .positive()
            .optional("unknown; needed for `mortar_…_stiffness`"),
        pub poisson_ratio: Option<f64> = number("Poisson's ratio of the masonry units", "0.2")
            .between(0.0, 0.4999)
            .optional("unknown; needed for `mortar_shear_stiffness`"),
        /// None where it is unlimited.
        pub compressive_strength: Option<f64> =
            stress_or_unlimited("compressive strength of the masonry, or \"unlimited\"", "10 MPa")
                .positive()
                .optional("crushing is not considered, and a warning says so") => finite,
        /// Half of the published rounding parameter d_r.
        pub rounding: f64 =
            length("radius of the blocks' rounded corners; contact points lie this far inside the edges", "10 mm")
                .at_least(0.0)
                .default("0 mm"),
    }
}

/// A stiffness per unit area [Pa/m]: given, or from the series rule with the modulus of the blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointStiffness {
    /// Of the whole contact, joint and half of both blocks [Pa/m].
    Contact(f64),
    /// Of the mortar joint alone [Pa/m]; the blocks come in by the series rule (Rouxinol et al., eq. 1).
    Series(f64),
}

/// A joint between blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Normal stiffness; needed by the discrete element method only.
    pub normal_stiffness: Option<JointStiffness>,
    /// Shear stiffness; needed by the discrete element method only.
    pub shear_stiffness: Option<JointStiffness>,
    /// Friction angle [rad].
    pub friction_angle: f64,
    /// Cohesion [Pa].
    pub cohesion: f64,
    /// Tensile strength [Pa].
    pub tensile_strength: f64,
    /// Length that a contact point stands for when it is kept fixed [m].
    pub fixed_length: Option<f64>,
    /// Least length of a contact point when it is updated [m].
    pub least_length: Option<f64>,
}

/// Spandrel walls: coursed masonry on the extrados, all walls of the bridge taken together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpandrelWall {
    /// Length of a brick [m].
    pub brick_length: f64,
    /// Height of a course [m].
    pub brick_height: f64,
    /// Thickness of all walls together across the bridge [m].
    pub thickness: f64,
    /// Share of a brick by which every other course is shifted.
    pub bond: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Radius of the bricks' rounded corners [m].
    pub rounding: f64,
    /// Joints between bricks, and between bricks and whatever they stand on.
    pub joint: Joint,
    /// Level of the wall's top above the highest crown's extrados [m]; the road surface where the file gives none.
    pub top: Option<f64>,
    /// How far the wall reaches behind the outer springings at the extrados [m]; to the abutments' backs where the file
    /// gives none.
    pub extent: Option<f64>,
    /// Whether fixed walls stand at both ends.
    pub end_walls: bool,
    /// Where courses are counted from.
    pub courses_from: CoursesFrom,
    /// Place of a head joint of the uppermost course [m]; the middle of the bridge where the file gives none.
    pub head_joint: Option<f64>,
    /// How many bricks of the uppermost course carry a load; none: those under it, each by its loaded length.
    pub loaded_bricks: Option<usize>,
    /// Share of a brick's height, its length or a voussoir's back, whichever is least, below which no piece is left.
    pub least_piece: f64,
}

choice! {
    /// Where the courses of a wall are counted from.
    pub enum CoursesFrom {
        /// from the wall's top down: the uppermost course is whole
        Top = "top",
        /// from the level of the springings up: the uppermost course takes what is left
        Springings = "springings",
    }
}
