//! Spans, piers and abutments.

use crate::cards::*;
use crate::choice::choice;
use crate::defect::Defect;
use crate::ring::{Intrados, Misfit, Profile};
use crate::values::of_keys;

/// One span.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Shape of the intrados.
    pub profile: Profile,
    /// Horizontal distance between the springings, at the intrados [m].
    pub span: f64,
    /// Height of the crown above the springings, at the intrados [m]; where these lie at unequal levels, of the middle of the span above
    /// the straight line between them. Of a measured profile, of its highest point above the left springing.
    pub rise: f64,
    /// Level of the right springing above the left one [m].
    pub right_springing: f64,
    /// Rings from the intrados up; at least one.
    pub rings: Vec<Ring>,
    /// What is wrong with them, in the order of the file.
    pub defects: Vec<Defect>,
    /// Angle between the road and the normal of its springings [rad]: 0 where it is square. Span and profile run along the road.
    pub skew: f64,
}

impl Span {
    /// Its intrados, from the left springing.
    ///
    /// # Errors
    /// A profile that has no curve of this size.
    pub fn intrados(&self) -> Result<Intrados, Misfit> {
        Intrados::between(&self.profile, self.span, self.rise, self.right_springing)
    }
}

/// One ring of voussoirs.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Thickness at the crown [m].
    pub crown_thickness: f64,
    /// Thickness at the springings [m]; varies linearly with arc length in between.
    pub springing_thickness: f64,
    /// Number of voussoirs, equal in arc length.
    pub voussoirs: usize,
}

impl Ring {
    /// Thickness at a share of the arc length [m]: linear from springing to crown.
    pub fn thickness(&self, share: f64) -> f64 {
        let to_crown = 1.0 - (2.0 * share - 1.0).abs();
        self.springing_thickness + (self.crown_thickness - self.springing_thickness) * to_crown
    }
}

/// A pier between two spans.
#[derive(Debug, Clone, PartialEq)]
pub struct Pier {
    /// Width at the top, between the springings of its two spans [m].
    pub width: f64,
    /// Width at the bottom [m].
    pub base_width: f64,
    /// Height from the foundation to the springings, the lower one where they differ [m].
    pub height: f64,
    /// Number of courses.
    pub courses: usize,
    /// Level of the springing of the span on its right above that of the span on its left [m].
    pub step: f64,
    /// How far the middle of the bottom lies to the right of the middle of the top [m]: faces of unequal batter.
    pub base_offset: f64,
    /// Mean width across the bridge at the top and at the bottom [m], with cutwaters by their area; that of the barrel where the file gives
    /// none.
    pub across: Option<[f64; 2]>,
    /// Its cutwaters, where the file has any.
    pub cutwaters: Option<Cutwaters>,
    /// Steps of the footing, from the pier down.
    pub footings: Vec<Footing>,
}

impl Pier {
    /// A pier with plumb or evenly battered faces, as wide across as the barrel, its springings level.
    pub fn plain(width: f64, base_width: f64, height: f64, courses: usize) -> Pier {
        let (across, cutwaters, footings) = (None, None, Vec::new());
        Pier { width, base_width, height, courses, step: 0.0, base_offset: 0.0, across, cutwaters, footings }
    }
}

/// Cutwaters of a pier, all alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cutwaters {
    /// Their form in plan.
    pub shape: Cutwater,
    /// How far each reaches beyond the pier [m].
    pub length: f64,
    /// One, or one at both ends.
    pub ends: usize,
    /// Width of the pier across the bridge at the top, without them [m].
    pub between: f64,
}

impl Cutwaters {
    /// What they add to the mean width of the pier, by their area [m].
    pub fn mean(self) -> f64 {
        self.ends as f64 * self.length * self.shape.share()
    }
}

choice! {
    /// Form of a cutwater in plan.
    pub enum Cutwater {
        /// a triangle: half of the rectangle around it
        Pointed = "pointed",
        /// half an ellipse or a circle: pi / 4 of the rectangle around it
        Round = "round",
        /// a rectangle
        Square = "square",
    }
}

impl Cutwater {
    /// Its area over that of the rectangle around it.
    fn share(self) -> f64 {
        match self {
            Cutwater::Pointed => 0.5,
            Cutwater::Round => std::f64::consts::FRAC_PI_4,
            Cutwater::Square => 1.0,
        }
    }
}

of_keys! {
    /// A step of a pier's footing.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Footing {
        pub width: f64 = length("width along the road", "2.2 m").positive_up_to(100.0),
        pub height: f64 = length("height of the step", "0.5 m").positive_up_to(50.0),
        pub across: Option<f64> = length("width across the bridge", "11.0 m")
            .positive_up_to(200.0)
            .optional("as the pier's bottom, cutwaters by their area"),
    }
}

/// An abutment: a fixed springing, or blocks that stand on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Abutment {
    /// Length of its upper face, behind the springing [m].
    pub top_width: f64,
    /// Height of the block, from its springing down [m].
    pub height: f64,
    /// What stands on the ground, where it is not fixed.
    pub body: Option<AbutmentBody>,
}

choice! {
    /// How an abutment is modelled.
    pub enum AbutmentKind {
        /// a block that does not move
        Fixed = "fixed",
        /// blocks that stand on the ground by friction and can slide and overturn; limit analysis, discrete elements, path
        Blocks = "blocks",
    }
}

/// An abutment that can slide and overturn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AbutmentBody {
    /// Width of its bottom, from the plumb front face back [m]; as wide as the top where the file gives none.
    pub base_width: Option<f64>,
    /// Number of courses.
    pub courses: usize,
    /// Friction angle between it and the ground [rad]: no cohesion, no tension.
    pub ground_friction_angle: f64,
    /// Horizontal over vertical stress of the soil behind it.
    pub earth_coefficient: f64,
    /// Mass density of that soil [kg/m^3]; that of the lowest layer of the cover where the file gives none.
    pub earth_density: Option<f64>,
}
