//! What lies over the rings: layers, particles, voids, backing, fill that yields or presses.

use super::Joint;
use crate::cards::*;
use crate::choice::choice;
use crate::road::Road;
use crate::values::of_keys;

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

of_keys! {
    /// Water that stands in the pores of the lowest layer.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct PoreWater {
        /// In the layer it reaches no higher than the layer's upper face.
        pub level: f64 = length("level of the water above the left springing of the first span", "1.2 m"),
        pub saturated_density: f64 =
            density("density of the lowest layer with its pores full", "2050 kg/m^3").at_least(1000.0),
    }
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
        pub height: f64 = length("level of the backing's upper face above the springings", "1.5 m").positive(),
        /// The mean over the width where it fills a share of it.
        pub density: f64 = density("mass density of the backing", "2000 kg/m^3").positive(),
        pub width_share: f64 = number(
            "share of the bridge's width that it fills: haunching between internal walls, or under a part of the width",
            "0.4",
        )
        .positive_up_to(1.0)
        .default("1"),
        /// Times the share of the width.
        pub elastic_modulus: Option<f64> =
            stress("Young's modulus of the backing", "3 GPa").positive().optional("not needed for collapse"),
        pub poisson_ratio: Option<f64> =
            number("Poisson's ratio of the backing", "0.2").between(0.0, 0.4999).optional("not needed for collapse"),
        pub body ("as"): BackingBody =
            word::<BackingBody>("what the backing is in limit analysis and in the discrete element method", "blocks")
                .default(BackingBody::Weight.word()),
        pub friction_angle: Option<f64> =
            angle("angle of friction between its particles, or of backing that yields", "40 deg")
                .between(0.0, 1.5)
                .only("as", &["particles", "continuum"])
                .optional("particles: as [particle_joint] says; a continuum needs it"),
        pub cohesion: Option<f64> = stress("cohesion between its particles, or of backing that yields", "50 kPa")
            .at_least(0.0)
            .only("as", &["particles", "continuum"])
            .optional("particles: as [particle_joint] says; a continuum needs it"),
        pub tensile_strength: Option<f64> = stress("tensile strength of backing that yields", "0 kPa")
            .at_least(0.0)
            .only("as", &["continuum"])
            .optional("backing carries no tension"),
        pub compressive_strength: Option<f64> = stress("compressive strength of backing that yields", "2 MPa")
            .positive()
            .only("as", &["continuum"])
            .optional("backing does not crush"),
    }
}

of_keys! {
    /// How layers and backing that are a continuum are modelled: plane strain, limit analysis.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct ContinuumPlan {
        pub mobilised_share: f64 =
            number("share of cohesion and of the tangent of the friction angle that is mobilised at collapse", "0.6")
                .positive_up_to(1.0)
                .default("1.0"),
        pub dilatancy_angle: f64 = angle(
            "angle by which soil dilates when it shears; less than the friction angle lowers the strength after Davis",
            "0 deg",
        )
        .between(0.0, 1.5)
        .default("0 deg"),
        pub interface_friction_angle: Option<f64> =
            angle("angle of friction between soil and masonry; never more than that of the soil", "20 deg")
                .between(0.0, 1.5)
                .optional("two thirds of the soil's friction angle; backing is bonded to masonry with its own strength"),
        pub interface_cohesion: f64 =
            stress("cohesion between soil and masonry; never more than that of the soil", "0 kPa")
                .at_least(0.0)
                .default("0 kPa"),
        pub ends: FillEnds =
            word::<FillEnds>("what stands at the far ends of the fill", "slide").default(FillEnds::Slide.word()),
        pub extent: Option<f64> =
            length("how far the fill reaches behind each outer springing, from the springing's extrados", "8 m")
                .positive()
                .optional(
                    "the larger of the abutment's `top_width` and twice the height from that springing to the top of the continuum",
                ),
        pub water_level: Option<f64> =
            length("level of the water in the pores above the springings; negative below them", "-0.5 m")
                .optional("the fill is dry"),
        pub confinement: Confinement =
            word::<Confinement>("what holds the fill sideways, out of the plane", "spandrel-walls")
                .default(Confinement::PlaneStrain.word()),
        pub bound_ratio: f64 = number("wanted ratio of the upper bound to the lower bound of the load", "1.05")
            .above(1.0)
            .at_most(10.0)
            .default("1.05"),
        pub elements: usize = count("most triangles of the mesh", "4000").between(50.0, 100_000.0).default("4000"),
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
        pub applies: bool = flag("whether it acts", "true").default("true"),
        pub friction_angle: f64 = angle("angle of friction of the fill", "30 deg").between(0.0, 1.2),
        pub cohesion: f64 = stress("cohesion of the fill", "5 kPa").at_least(0.0).default("0 kPa"),
        pub mobilisation: f64 = number("share of the passive pressure of friction that movement mobilises", "0.5")
            .between(0.0, 1.0)
            .default("0.5"),
        pub cohesion_mobilisation: f64 =
            number("share of the passive pressure of cohesion", "0.05").between(0.0, 1.0).default("0.05"),
        pub least: LeastPressure =
            word::<LeastPressure>("pressure on backs that do not move against the fill", "at-rest")
                .default(LeastPressure::AtRest.word()),
        pub half_movement: f64 = number(
            "movement of a back against the fill at which half of what movement mobilises is there, as a share of the depth \
             below the top of the fill; method \"path\"",
            "0.01",
        )
        .positive_up_to(1.0)
        .default("0.02"),
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
