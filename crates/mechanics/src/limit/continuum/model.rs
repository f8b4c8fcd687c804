//! What is given: regions of soil, what stands on their boundary, where water stands.

use crate::ids::BlockId;
use crate::plane::Vec2;

/// A body of soil in plane strain that yields, beside rigid blocks. Fixed once built.
///
/// Regions share the corners of common sides. Where the boundary is no [`Side`], it is free and nothing acts on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Continuum {
    /// Regions of one soil each, next to one another, never over one another.
    pub regions: Vec<Region>,
    /// What the boundary touches and bears, stretch by stretch.
    pub sides: Vec<Side>,
    /// Water in the pores, if there is any.
    pub water: Option<Water>,
    /// What holds the soil out of its plane, side by side; soil beside none is held by whatever it needs. In plane strain the stress out of the plane
    /// lies between the two principal stresses in it, whatever holds it. Where panels hold no more than they can, the larger stress in the plane may
    /// not exceed what Mohr and Coulomb allow beside the pressure `s` on the panel: `N s + 2 c sqrt(N)` with `N = (1 + sin phi) / (1 - sin phi)` (after
    /// Cavicchi and Gambarotta 2007, who bound `s` alone). How the pressure is distributed over a panel is for the soil to decide.
    pub panels: Vec<Panel>,
}

/// A rigid panel beside the plane, on one side of soil that is as wide as it may be: pressures on it are those of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Panel {
    /// Its ends [m]. Triangles belong to the panel in which their centroid lies.
    pub ends: [f64; 2],
    /// Level about which it tilts [m], not above any soil beside it.
    pub foot: f64,
    /// Largest resultant of the pressures on it [N].
    pub force: f64,
    /// Largest moment of the pressures about its foot [N m].
    pub moment: f64,
}

/// A region of one soil.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Corners of a simple polygon, counter-clockwise [m].
    pub outline: Vec<Vec2>,
    /// What it is made of.
    pub soil: Soil,
}

/// A Mohr-Coulomb material with its weight. Compression is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Soil {
    /// Cohesion [Pa].
    pub cohesion: f64,
    /// Friction angle [rad].
    pub friction_angle: f64,
    /// Tension cut-off: largest principal stress [Pa]; infinite for none but the tip of the Mohr-Coulomb surface.
    pub tension: f64,
    /// Compressive strength: least principal stress, positive [Pa]; infinite for none.
    pub crushing: f64,
    /// Body force that is always there [N/m^3]: (0, -unit weight).
    pub weight: Vec2,
    /// Body force that is multiplied by the load factor [N/m^3].
    pub variable_weight: Vec2,
}

/// A straight stretch of the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// Its ends [m].
    pub ends: [Vec2; 2],
    /// What is there.
    pub bears: Bears,
}

/// What a stretch of the boundary touches or bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bears {
    /// Tractions on the soil [Pa], uniform: those that are always there, and those that the load factor multiplies.
    Load {
        /// Always there.
        permanent: Vec2,
        /// Multiplied by the load factor.
        variable: Vec2,
    },
    /// A rigid body: a block of the model, or ground that does not move.
    Body {
        /// The block; none for ground.
        block: Option<BlockId>,
        /// How the contact resists.
        contact: Contact,
    },
}

/// The contact of soil with a rigid body: no tension, sliding by Coulomb's law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Coefficient of friction.
    pub friction: f64,
    /// Cohesion [Pa], on what is pressed and what is not.
    pub cohesion: f64,
    /// Tensile strength [Pa]; infinite for none but the tip of Coulomb's law.
    pub tension: f64,
}

/// Water at rest in the pores below a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Water {
    /// Level [m].
    pub level: f64,
    /// Its unit weight [N/m^3].
    pub unit_weight: f64,
}

impl Water {
    /// Pore pressure at a point [Pa], positive.
    pub fn pressure(&self, at: Vec2) -> f64 {
        self.unit_weight * (self.level - at.y).max(0.0)
    }
}

impl Soil {
    /// The strength that the given shares mobilise, and how it acts where the soil dilates by an angle `dilatancy` [rad] less than
    /// its friction angle, after Davis: `tan(phi*) = beta tan(phi)`, `c* = beta c` with
    /// `beta = cos(psi) cos(phi) / (1 - sin(psi) sin(phi))`.
    pub fn reduced(&self, share: f64, dilatancy: f64) -> Soil {
        let mobilised = (self.friction_angle.tan() * share).atan();
        let beta = davis(mobilised, dilatancy.min(mobilised));
        Soil { cohesion: self.cohesion * share * beta, friction_angle: (mobilised.tan() * beta).atan(), ..*self }
    }
}

/// Davis's factor on strength for a friction angle and a dilatancy angle [rad] (Davis 1968; Sloan 2013).
pub fn davis(friction_angle: f64, dilatancy: f64) -> f64 {
    let (phi, psi) = (friction_angle, dilatancy);
    psi.cos() * phi.cos() / (1.0 - psi.sin() * phi.sin())
}
