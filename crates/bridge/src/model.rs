//! What a bridge file means, in SI units: the value that reading returns. Plain data, nothing computed.

use crate::choice::choice;
use crate::defect::Defect;
use crate::diagnostic::TextRange;
use crate::fields::FILE;
use crate::findings::Findings;
use crate::ring::{Intrados, Misfit, Profile};
use crate::road::Road;
use crate::service::Service;
use crate::tree::Table;
use serde::{Deserialize, Serialize};

/// A bridge as its file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Bridge {
    /// Name for titles.
    pub name: String,
    /// Width of the barrel [m].
    pub width: f64,
    /// Acceleration of gravity [m/s^2].
    pub gravity: f64,
    /// Spans from left to right; at least one.
    pub spans: Vec<Span>,
    /// Piers between the spans: one fewer than spans.
    pub piers: Vec<Pier>,
    /// Left and right abutment.
    pub abutments: [Abutment; 2],
    /// Named materials of solid bodies.
    pub masonry: Masonry,
    /// Joints between voussoirs of one ring, and between voussoirs and their springings.
    pub joint: Joint,
    /// Joints between rings of one span; `joint` where the file gives none.
    pub ring_joint: Joint,
    /// Walls of coursed masonry that stand on the rings, where the file describes them.
    pub spandrel_wall: Option<SpandrelWall>,
    /// How layers of the cover are filled with particles, where some are.
    pub particles: Option<Particles>,
    /// How the contact stiffness of particles is found from a wanted modulus.
    pub calibration: Calibration,
    /// What lies above the rings, from the extrados up.
    pub cover: Cover,
    /// What is placed on the road or rail, in the order of the file.
    pub loads: Vec<Load>,
    /// How loads spread through the cover.
    pub dispersal: Dispersal,
    /// What to analyse, and how exactly.
    pub plan: Plan,
    /// What only the finite element model reads.
    pub service: Service,
    /// How layers that are a continuum are modelled, where some are.
    pub continuum: Option<ContinuumPlan>,
    /// Horizontal pressure of the fill against movement, in limit analysis, where the file says so.
    pub fill_pressure: Option<FillPressure>,
    /// Where vehicles may stand across the bridge, where the file says so.
    pub carriageway: Option<Carriageway>,
    /// Vehicles that are moved over the bridge, and by which rule, where the file says so.
    pub sweep: Option<SweepPlan>,
    /// The train that crosses, and what is measured meanwhile, where the file says so.
    pub passage: Option<crate::passage::Passage>,
}

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

/// A step of a pier's footing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footing {
    /// Width along the bridge [m].
    pub width: f64,
    /// Height [m].
    pub height: f64,
    /// Width across the bridge [m]; that of the pier's bottom where the file gives none.
    pub across: Option<f64>,
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

/// Masonry of rings and piers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Masonry {
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Young's modulus [Pa].
    pub elastic_modulus: Option<f64>,
    /// Poisson's ratio.
    pub poisson_ratio: Option<f64>,
    /// Compressive strength [Pa]; none: unlimited.
    pub compressive_strength: Option<f64>,
    /// Radius of the blocks' rounded corners [m] (half of the published rounding parameter d_r).
    pub rounding: f64,
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

impl Default for Calibration {
    fn default() -> Calibration {
        by_cards(crate::fields::calibration::calibration)
    }
}

/// What a part is of which a file says nothing, for which every key needs a default on its card.
pub(crate) fn by_cards<T>(read: impl FnOnce(&Table<'_>, &mut Findings) -> Option<T>) -> T {
    let file = Table::absent(&FILE, TextRange::new(0, 0));
    read(&file, &mut Findings::default()).expect("cards with defaults")
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
    pub body: BackingBody,
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

/// Vehicles that are moved over the bridge by limit analysis.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepPlan {
    /// The rule of the library, unless a file is given.
    pub rule: String,
    /// A file with a rule, relative to the bridge file.
    pub rule_file: Option<String>,
    /// Vehicles, load models or trains of the library, by their codes; empty for all.
    pub vehicles: Vec<String>,
    /// Files of vehicles, relative to the bridge file.
    pub vehicle_files: Vec<String>,
    /// Distance between positions [m]; from the spans where the file gives none.
    pub step: Option<f64>,
    /// Which ways vehicles drive.
    pub directions: Directions,
    /// Whether every run of neighbouring axles is tried.
    pub subsets: bool,
    /// Whether loads spread by the file's [dispersal] in place of the rule's.
    pub own_dispersal: bool,
    /// Force along the bridge as a share of each axle and uniform load, to the right and to the left: braking and traction.
    pub braking: f64,
    /// Whether the file writes that share, be it 0.
    pub braking_given: bool,
    /// Why it is what it is, as the file says.
    pub braking_reason: Option<String>,
    /// Whether the governing case is made by discrete elements too.
    pub discrete_elements: bool,
    /// Names and texts of the files, the rule's first; empty until somebody reads them.
    pub texts: Vec<(String, String)>,
}

/// Where vehicles may stand across the bridge, and what divides its barrel.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Carriageway {
    /// How many vehicles may stand abreast: lanes of a road, tracks of a railway.
    pub lanes: Option<usize>,
    /// Distance between the middles of two of them [m].
    pub lane_width: Option<f64>,
    /// Distance from an edge of the barrel to the middle of the nearest wheel or rail [m].
    pub edge_distance: Option<f64>,
    /// Angle between the bridge's axis and the normal of its springings [rad], of spans that give none of their own: 0 for a square bridge.
    pub skew: Option<f64>,
    /// Distances of longitudinal cracks through the barrel from one of its edges, from the least [m].
    pub cracks: Vec<f64>,
    /// What moves the resultant of a vehicle sideways.
    pub sideways: Sideways,
}

/// What moves the resultant of a vehicle away from the middle between its wheels or rails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sideways {
    /// Radius of the curve and speed on it [m, m/s].
    pub curve: Option<(f64, f64)>,
    /// Level of the outer rail above the inner one [m].
    pub cant: f64,
    /// Force across the bridge as a share of the weight, to either side.
    pub side_force: f64,
    /// Height above the rail or the road at which both act [m].
    pub height: f64,
    /// Distance between the middles of both rails, or of the wheels on an axle [m].
    pub gauge: f64,
}

impl Default for Sideways {
    fn default() -> Sideways {
        Sideways { curve: None, cant: 0.0, side_force: 0.0, height: GRAVITY_HEIGHT, gauge: GAUGE }
    }
}

/// Least distance between places of a sweep [m]: closer ones tell nothing more, and a slip in the unit would take days.
pub const LEAST_STEP: f64 = 1e-3;

/// Height of a vehicle's centre of gravity above the rail [m], where the file gives none.
pub const GRAVITY_HEIGHT: f64 = 1.8;
/// Distance between the middles of both rails [m], where the file gives none.
pub const GAUGE: f64 = 1.5;

impl Sideways {
    /// Largest distance of the resultant from the middle between the rails [m], and whether it is that of a vehicle that moves: with speed v on
    /// radius r, cant c, gauge s and side force w at height h it is h (|v^2 / (g r) - c / s| + w); standing, h (c / s + w).
    pub fn eccentricity(&self, gravity: f64) -> (f64, bool) {
        let outwards = self.curve.map_or(0.0, |(radius, speed)| speed * speed / (gravity * radius));
        let inwards = self.cant / self.gauge;
        let [moving, standing] =
            [(outwards - inwards).abs(), inwards].map(|share| self.height * (share + self.side_force));
        if moving > standing { (moving, true) } else { (standing, false) }
    }
}

/// The strips that longitudinal cracks leave of a barrel so wide, from one edge to the other [m].
pub fn strips(width: f64, cracks: &[f64]) -> Vec<[f64; 2]> {
    let inner = cracks.iter().copied().filter(|crack| *crack > 0.0 && *crack < width);
    let borders: Vec<f64> = std::iter::once(0.0).chain(inner).chain([width]).collect();
    borders.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Width of the widest of them [m].
pub fn widest_strip(width: f64, cracks: &[f64]) -> f64 {
    strips(width, cracks).iter().map(|[from, to]| to - from).fold(0.0, f64::max)
}

choice! {
    /// Which ways vehicles drive.
    pub enum Directions {
        /// to the right and to the left
        Both = "both",
        /// to the right
        Right = "right",
        /// to the left
        Left = "left",
    }
}

/// A load on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What it is called.
    pub name: String,
    /// Its shape.
    pub kind: LoadKind,
    /// Position of its reference point (middle of a knife edge or patch, first axle of a pattern) along the
    /// bridge, from the left springing of the first span, at the intrados [m].
    pub position: f64,
    /// The block that brings it onto the surface, where there is one.
    pub block: Option<LoadingBlock>,
    /// Force along the bridge as a share of the load, to the right positive: braking, traction, wind along the road.
    pub horizontal: f64,
    /// Whether a pressure acts over its whole length; otherwise it may be shorter, where that does more harm.
    pub whole_length: bool,
}

/// A rigid block of the load's length that stands on the surface, held against rotation and sideways movement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadingBlock {
    /// Its weight [N/m]; counted in the load.
    pub weight: f64,
}

/// Shape and size of a load. Forces are vertical, downwards positive.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// A strip across the whole width: total force per metre of width [N/m] over `length` [m] along the bridge.
    KnifeEdge {
        /// Force [N/m].
        force: f64,
        /// Length along the bridge [m].
        length: f64,
    },
    /// A pressure [Pa] over `length` [m] along the bridge, across the whole width.
    Patch {
        /// Pressure [Pa].
        pressure: f64,
        /// Length along the bridge [m].
        length: f64,
    },
    /// Axles, each a total force [N] over the effective width, at offsets from the reference point, to the left
    /// (a vehicle that drives to the right).
    Axles {
        /// Force [N] and offset behind the first axle [m].
        axles: Vec<(f64, f64)>,
        /// Length of a wheel's footprint along the bridge [m].
        contact_length: f64,
        /// Width of the barrel that carries one axle [m].
        effective_width: f64,
    },
}

/// How a load spreads from the surface to the extrados.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dispersal {
    /// Which rule.
    pub rule: DispersalRule,
    /// Vertical to horizontal slope on each side (2 means 2 vertical to 1 horizontal).
    pub slope: f64,
}

choice! {
    /// The rule by which pressure is distributed over the dispersed length.
    pub enum DispersalRule {
        /// straight down onto the extrados
        None = "none",
        /// uniform over the dispersed length
        Uniform = "uniform",
        /// intensity at the ends inversely proportional to their depth (Rouxinol, Providência and Lemos, eq. 2)
        InverseDepth = "inverse-depth",
        /// Boussinesq's strip, cut off at the slope and scaled to the whole force
        Boussinesq = "boussinesq",
    }
}

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
        /// sliding does not dilate: iterative correction
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
