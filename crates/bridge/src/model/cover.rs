//! What lies over the rings: layers, particles, voids, backing, fill that yields or presses.

use super::Joint;
use crate::choice::choice;
use crate::road::Road;
use crate::values::of_keys;
use serde::{Deserialize, Serialize};

/// What lies above the extrados.
#[derive(Debug, Clone, PartialEq)]
pub struct Cover {
    /// Depth from the crown's extrados to the road surface [m]: what loads disperse through. The highest crown
    /// where there are several; where the road is not level, the crown with the least.
    pub depth: f64,
    /// Layers from the extrados up.
    pub layers: Vec<Layer>,
    /// Backing above the haunches, where there is some.
    pub backing: Option<Backing>,
    /// Internal spandrel walls with what lies between them, where there are some.
    pub internal_walls: Option<InternalWalls>,
    /// Voids above the extrados, from left to right.
    pub voids: Vec<Void>,
    /// The road surface where it is not level; else it lies `depth` above the highest crown.
    pub road: Option<Road>,
    /// Water in the pores of the lowest layer.
    pub water: Option<PoreWater>,
}

/// Water that stands in the pores of the lowest layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoreWater {
    /// Its level above the left springing of the first span [m]; in the layer it reaches no higher than the layer's upper face.
    pub level: f64,
    /// Mass density of the layer below it, pores full [kg/m^3].
    pub saturated_density: f64,
}

/// A layer of the cover, from the extrados up. The lowest fills the haunches.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// What it is, as the file names it.
    pub name: LayerKind,
    /// Thickness above the crown [m].
    pub thickness: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Whether its weight acts on the ring.
    pub weighs: bool,
    /// Whether it is modelled as particles; its weight then reaches the ring through them.
    pub particles: bool,
    /// Whether it is modelled as a continuum that yields, in limit analysis. It weighs, so that other methods take it as weight.
    pub continuum: bool,
    /// Length of the slabs that it is modelled as [m], where it is.
    pub slabs: Option<f64>,
    /// Friction angle [rad] and cohesion [Pa] between its particles, where they differ from those of all; of the soil where it is a
    /// continuum, which always has both.
    pub friction_angle: Option<f64>,
    /// See above.
    pub cohesion: Option<f64>,
    /// Tensile strength of a continuum [Pa]; none: it carries no tension.
    pub tensile_strength: Option<f64>,
    /// Young's modulus [Pa].
    pub elastic_modulus: Option<f64>,
}

/// How a region is filled with particles, and how they touch.
#[derive(Debug, Clone, PartialEq)]
pub struct Particles {
    /// How many and how large.
    pub sizes: Sizes,
    /// How densely.
    pub density: Packing,
    /// A packing that was saved, relative to the bridge file.
    pub file: Option<String>,
    /// Centres and radii [m] read from that file; empty until somebody reads it.
    pub grains: Vec<[f64; 3]>,
    /// Young's modulus of the particles in the series rule [Pa].
    pub elastic_modulus: Option<f64>,
    /// Poisson's ratio in the series rule.
    pub poisson_ratio: Option<f64>,
    /// Contacts between particles.
    pub joint: Joint,
    /// Contacts of particles with blocks.
    pub block_joint: Joint,
}

/// Sizes of particles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sizes {
    /// So many, with this ratio of the largest to the smallest diameter.
    Count {
        /// How many.
        count: usize,
        /// Largest over smallest diameter.
        ratio: f64,
    },
    /// Diameters from the smallest to the largest [m].
    Diameters {
        /// Smallest [m].
        smallest: f64,
        /// Largest [m].
        largest: f64,
    },
}

/// How densely particles are packed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Packing {
    /// Until they press with the cover's weight at half its mean depth.
    OwnWeight,
    /// Until they press with this mean stress [Pa].
    Stress(f64),
    /// Until they cover this share of the region.
    SolidFraction(f64),
}

of_keys! {
    /// How the contact stiffness of particles is found from a wanted modulus of the fill: squares are cut out of the fill at
    /// rest, held below and at both sides, and pressed by a block. Rouxinol, Providência and Lemos, section 3.1.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Calibration {
        /// Modulus that the fill is to have [Pa].
        pub wanted_modulus: Option<f64>,
        /// Which modulus is compared with it.
        pub modulus: Modulus,
        /// Side of the square samples [m].
        pub sample_size: f64,
        /// Weight of the block that presses [N/m].
        pub block_weight: f64,
        /// Increment of the load on it [N/m].
        pub load_step: f64,
        /// Number of load steps.
        pub steps: usize,
        /// First load steps that the later secant leaves out.
        pub ignored_steps: usize,
        /// Multiples of the particles' contact stiffness at which moduli are measured.
        pub multiples: Vec<f64>,
        /// Moduli from elsewhere at these multiples [Pa]; empty where there are none.
        pub compare_with: Vec<f64>,
        /// How many packings samples are cut from.
        pub seeds: u64,
        /// The wanted modulus is met within this share.
        pub tolerance: f64,
        /// Smallest replacement of a cut particle over the smallest particle of the packing.
        pub least_replacement: f64,
        /// Friction angle that the fill is to have [rad].
        pub wanted_friction_angle: Option<f64>,
        /// Cohesion that the fill is to have [Pa].
        pub wanted_cohesion: Option<f64>,
        /// Pressures on the sides of the samples that are sheared [Pa].
        pub confining_pressures: Vec<f64>,
        /// How many squares are sheared.
        pub sheared_samples: usize,
    }
}

choice! {
    /// A modulus of a stress-strain curve.
    pub enum Modulus {
        /// mean of the slopes of all load steps
        Tangent = "tangent",
        /// slope from the first result to the last
        Secant = "secant",
    }
}

choice! {
    /// The four words for what lies above an arch.
    pub enum LayerKind {
        /// soil or rubble directly on the extrados
        Fill = "fill",
        /// road base
        SubBase = "sub-base",
        /// road surface
        Surfacing = "surfacing",
        /// railway ballast
        Ballast = "ballast",
    }
}

/// Internal spandrel walls: walls along the bridge between the outer ones, and voids or fill between them, as one mean weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InternalWalls {
    /// Level of their tops above the springings [m].
    pub height: f64,
    /// Mean mass density over the width [kg/m^3].
    pub density: f64,
    /// Share of the width that is masonry.
    pub share: f64,
}

/// A void in the spandrels: a relieving arch over a pier or a haunch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Void {
    /// From here to there along the bridge [m].
    pub range: [f64; 2],
    /// Levels of its floor and its roof above the left springing of the first span [m].
    pub levels: [f64; 2],
    /// Where its roof is carried, left and right of it [m].
    pub carried_to: [f64; 2],
}

of_keys! {
    /// Solid backing above the haunches, up to a level.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Backing {
        /// Level of its upper face above the springings [m].
        pub height: f64,
        /// Mass density [kg/m^3], the mean over the width where it fills a share of it.
        pub density: f64,
        /// Share of the width that it fills.
        pub width_share: f64,
        /// Young's modulus [Pa], times the share of the width.
        pub elastic_modulus: Option<f64>,
        /// Poisson's ratio.
        pub poisson_ratio: Option<f64>,
        /// How it is modelled.
        pub body: BackingBody = "as",
        /// Friction angle [rad] and cohesion [Pa] between its particles, where they differ from those of all; of the backing itself where
        /// it is a continuum, which always has both.
        pub friction_angle: Option<f64>,
        /// See above.
        pub cohesion: Option<f64>,
        /// Tensile strength of a continuum [Pa]; none: it carries no tension.
        pub tensile_strength: Option<f64>,
        /// Compressive strength of a continuum [Pa]; none: unlimited.
        pub compressive_strength: Option<f64>,
    }
}

of_keys! {
    /// How layers and backing that are a continuum are modelled: plane strain, limit analysis.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ContinuumPlan {
        /// Share of cohesion and of the tangent of the friction angle that is mobilised.
        pub mobilised_share: f64,
        /// Dilatancy angle [rad].
        pub dilatancy_angle: f64,
        /// Friction angle between soil and masonry [rad]; none: two thirds of the soil's.
        pub interface_friction_angle: Option<f64>,
        /// Cohesion between soil and masonry [Pa].
        pub interface_cohesion: f64,
        /// What stands at the far ends.
        pub ends: FillEnds,
        /// How far it reaches behind the outer springings at the extrados [m]; none: the larger of the abutment's upper face and twice
        /// the height above that springing.
        pub extent: Option<f64>,
        /// Level of the water in the pores above the springings [m]; none: dry.
        pub water_level: Option<f64>,
        /// What holds the fill out of the plane.
        pub confinement: Confinement,
        /// Wanted ratio of the upper bound to the lower bound of the load.
        pub bound_ratio: f64,
        /// Most triangles of the mesh.
        pub elements: usize,
    }
}

choice! {
    /// What holds fill that is a continuum out of its plane.
    pub enum Confinement {
        /// whatever pressure plane strain needs
        PlaneStrain = "plane-strain",
        /// no more than the weight of the spandrel walls resists before they tilt or slide outwards
        SpandrelWalls = "spandrel-walls",
    }
}

choice! {
    /// What stands at the far ends of fill that is a continuum.
    pub enum FillEnds {
        /// a smooth wall that does not move
        Slide = "slide",
        /// a wall that does not move, as rough as masonry
        Hold = "hold",
        /// nothing: the ends are free
        Free = "free",
    }
}

choice! {
    /// How backing is modelled in limit analysis and in the discrete element method.
    pub enum BackingBody {
        /// weight on the extrados
        Weight = "weight",
        /// masonry that yields, method "limit", strip "fill", under cover that is a continuum; in other methods weight
        Continuum = "continuum",
        /// circular particles below its level, with properties of their own
        Particles = "particles",
        /// blocks of masonry, joined as voussoirs are: stones with level beds on backs steeper than 45 degrees, a column on every
        /// flatter one; over an abutment's top they rest by friction alone; strip "fill"
        Blocks = "blocks",
    }
}

of_keys! {
    /// Horizontal pressure of the fill on backs that move against it, for limit analysis and for the equilibrium path.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct FillPressure {
        /// Whether it acts.
        pub applies: bool,
        /// Friction angle of the fill [rad].
        pub friction_angle: f64,
        /// Cohesion of the fill [Pa].
        pub cohesion: f64,
        /// Share of Rankine's passive pressure of friction that movement mobilises.
        pub mobilisation: f64,
        /// The same for the part of cohesion.
        pub cohesion_mobilisation: f64,
        /// Pressure that is there whatever moves.
        pub least: LeastPressure,
        /// Movement at which half of what movement mobilises is there, as a share of the depth below the top of the fill.
        pub half_movement: f64,
    }
}

choice! {
    /// Horizontal pressure of fill that nothing moves against.
    pub enum LeastPressure {
        /// at rest: 1 - sin(phi) of the vertical stress (Jaky)
        AtRest = "at-rest",
        /// Rankine's active pressure, without cohesion
        Active = "active",
        /// nothing
        None = "none",
    }
}
