//! What a collapse analysis found.

use crate::help::NotCounted;
use crate::note::Note;
use crate::picture::{Hinge, Picture, Point};
use crate::warning::Warning;
use crate::words::words;
use bridge::{Analysis, ContactLength, JointContact, Method, Strip};
use serde::{Deserialize, Serialize};

words! {
    /// How an analysis ended. All of these are answers.
    #[derive(Default)]
    pub enum Status {
        /// A load was found that makes a mechanism.
        Collapsed = "collapsed",
        /// Every load up to the limit was carried.
        StableToLastLoad = "stable-to-last-load",
        /// A load step neither came to rest nor collapsed.
        Stalled = "stalled",
        /// The bridge does not stand under its own weight.
        UnstableUnderSelfWeight = "unstable-under-self-weight",
        /// The limit load is unbounded.
        Locks = "locks",
        /// A load step used up its iterations.
        StepLimit = "step-limit",
        /// The method did not reach its tolerance.
        #[default]
        NotConverged = "not-converged",
        /// Stopped by its onlooker.
        Cancelled = "cancelled",
        /// An analysis without a collapse load ended as it should.
        Completed = "completed",
    }
}

/// The load that is carried: what leads every result.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Headline {
    /// Per metre of width [N/m].
    pub load: f64,
    /// On the whole width [N].
    pub whole: f64,
    /// Which method gives it, in words.
    pub from: &'static str,
}

impl Collapse {
    /// The headline: the largest load that was carried, or the limit load of the same blocks where that is smaller; the sum of
    /// both strips where both were asked for. None where no load is known to be carried.
    pub fn headline(&self) -> Option<Headline> {
        if self.sought != Sought::Load {
            return None;
        }
        if let Some(both) = &self.combination {
            let from = "both strips by their widths";
            return both.headline.map(|whole| Headline { load: whole / self.width, whole, from });
        }
        let (own, rigid) = match self.by {
            By::Limit(_) => ("limit analysis, lower bound", None),
            By::Dem(_) => ("discrete elements, last stable step", self.limit_load),
            By::Path(_) => ("equilibrium path, largest load in balance", self.limit_load),
            By::Fe(_) => ("finite elements, largest load in balance", self.limit_load),
        };
        let others = [
            (rigid, "limit analysis, which gives less than the method that was asked for"),
            (
                self.crushing_limit_load,
                "limit analysis with joints that crush, which gives less than the method that was asked for",
            ),
        ];
        let mut least = (self.last_stable_load?, own);
        for (load, from) in others {
            if let Some(load) = load.filter(|load| *load < least.0) {
                least = (load, from);
            }
        }
        let (load, from) = least;
        Some(Headline { load, whole: load * self.width, from })
    }

    /// By which method.
    pub fn method(&self) -> Method {
        match self.by {
            By::Limit(_) => Method::Limit,
            By::Dem(_) => Method::Dem,
            By::Path(_) => Method::Path,
            By::Fe(_) => Method::Fe,
        }
    }

    /// Which analysis.
    pub fn analysis(&self) -> Analysis {
        match self.sought {
            Sought::Load => Analysis::Load,
            Sought::Thickness(_) => Analysis::Thickness,
            Sought::SupportMovement(_) => Analysis::SupportMovement,
        }
    }

    /// What only discrete elements report.
    pub fn dem(&self) -> Option<&DemReport> {
        if let By::Dem(report) = &self.by { report.as_ref() } else { None }
    }

    /// What only limit analysis reports.
    pub fn limit(&self) -> Option<&LimitReport> {
        if let By::Limit(report) = &self.by { Some(report) } else { None }
    }

    /// What only finite elements report.
    pub fn finite(&self) -> Option<&FiniteReport> {
        if let By::Fe(report) = &self.by { Some(report) } else { None }
    }

    /// What only the equilibrium path reports.
    pub fn along(&self) -> Option<&PathReport> {
        if let By::Path(report) = &self.by { Some(report) } else { None }
    }

    /// The least thickness that stands.
    pub fn thickness(&self) -> Option<ThicknessReport> {
        if let Sought::Thickness(report) = self.sought { report } else { None }
    }

    /// The support movement that makes a mechanism.
    pub fn support(&self) -> Option<SupportReport> {
        if let Sought::SupportMovement(report) = self.sought { Some(report) } else { None }
    }

    /// Names of the two blocks whose joint a hinge is.
    pub fn sides(&self, hinge: &Hinge) -> Option<[&str; 2]> {
        let [first, second] = hinge.between.map(|side| self.block_names.get(side).map(String::as_str));
        Some([first?, second?])
    }

    /// Load of the headline [N/m].
    pub fn carried(&self) -> Option<f64> {
        self.headline().map(|headline| headline.load)
    }
}

impl Status {
    /// The exit code of the command: 0 finished, 1 finished and the bridge does not stand, 3 could not finish, 130
    /// interrupted.
    pub fn exit_code(self) -> u8 {
        match self {
            Status::Collapsed | Status::StableToLastLoad | Status::Stalled | Status::Locks | Status::Completed => 0,
            Status::UnstableUnderSelfWeight => 1,
            Status::StepLimit | Status::NotConverged => 3,
            Status::Cancelled => 130,
        }
    }
}

/// What only the discrete element method reports.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DemReport {
    /// Iterations in all.
    pub iterations_total: u64,
    /// Time step used [s].
    pub time_step: f64,
    /// Critical time step from the largest eigenvalue [s].
    pub critical_time_step: f64,
    /// Critical time step from the one-degree-of-freedom estimate [s].
    pub single_mass_time_step: f64,
    /// Damping, in words.
    pub damping: String,
    /// Which length a contact stands for.
    pub contact_length: ContactLength,
    /// What the energy account leaves unexplained, relative to the work done.
    pub energy_drift: f64,
    /// Where a run broke off: block and iteration.
    pub broken_at: Option<(String, u64)>,
}

/// The packing of particles, at rest under its own weight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PackingReport {
    /// Centres and radii as packed [m].
    pub grains: Vec<[f64; 3]>,
    /// Share of the region that the particles cover.
    pub solid_fraction: f64,
    /// Mean number of contacts of a particle.
    pub coordination: f64,
    /// Mean stress [Pa], compression positive.
    pub mean_stress: f64,
    /// Smallest and largest diameter [m].
    pub diameters: [f64; 2],
    /// Mean sinking of the particles when the lid was taken away and the ring let go [m].
    pub settlement: f64,
    /// Seed from which it grew; none where it was read from a file.
    pub seed: Option<u64>,
}

words! {
    /// How joints open while they slide.
    #[derive(Default)]
    pub enum FlowRule {
        /// By the friction angle.
        #[default]
        Associated = "associated",
        /// Not at all.
        NonAssociated = "non-associated",
    }
}

/// What only limit analysis reports; [`LimitReport::default`] is that of a search through many loads or shapes, which bounds none of
/// them by itself.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct LimitReport {
    /// The flow rule that the numbers belong to.
    pub friction: FlowRule,
    /// Lower bound, recomputed from the forces [N/m].
    pub lower_bound: Option<f64>,
    /// Upper bound, recomputed from the mechanism [N/m].
    pub upper_bound: Option<f64>,
    /// The associated collapse load, beside the other where friction is non-associated [N/m].
    pub associated_load: Option<f64>,
    /// The non-associated collapse load, beside the other where walls are analysed with associated friction [N/m].
    pub non_associated_load: Option<f64>,
    /// Load without the fill's pressure against movement [N/m]; only where the file has it act.
    pub without_fill_pressure_load: Option<f64>,
    /// Load with all of the fill's passive pressure [N/m], where it presses.
    pub full_fill_pressure_load: Option<f64>,
    /// Lowest and highest non-associated load over the starts of the iteration [N/m].
    pub spread: Option<[f64; 2]>,
    /// Collapse load of joints that never crush [N/m]; the same as the collapse load where the file gives no strength.
    pub unlimited_strength_load: Option<f64>,
    /// Largest out-of-balance force, relative to the permanent loads.
    pub equilibrium_residual: Option<f64>,
    /// Largest excess over the strength, relative to the permanent loads.
    pub yield_violation: Option<f64>,
    /// Iterations of the solver.
    pub iterations: u32,
    /// Whether blocks stand without dilation only as far as they are jammed, so that no load is known.
    #[serde(default)]
    pub jammed: bool,
    /// What soil that yields as a continuum adds.
    #[serde(default)]
    pub continuum: Option<Box<crate::soil::ContinuumReport>>,
}

words! {
    /// How an equilibrium path ended.
    #[derive(Default)]
    pub enum Ended {
        /// The load passed a largest value, for joints had opened.
        LimitPoint = "limit-point",
        /// The same, for joints slid.
        Sliding = "sliding",
        /// The same, for joints crushed.
        Crushing = "crushing",
        /// The blocks may leave the path sideways at that load.
        Bifurcation = "bifurcation",
        /// Every load up to the limit was carried.
        LoadLimit = "load-limit",
        /// Not even the self-weight was carried.
        SelfWeight = "self-weight",
        /// The next balanced state was not found; the last one is kept.
        #[default]
        NotConverged = "not-converged",
        /// Stopped by its onlooker.
        Cancelled = "cancelled",
    }
}

words! {
    /// A state that a load should not reach in service.
    pub enum Criterion {
        /// The thrust leaves the middle third of a joint, which with distributed pressure begins to open then.
        MiddleThird = "out of middle third",
        /// A joint is open over half of its depth.
        HalfOpen = "a joint half open",
        /// A joint is stressed to half of its strength.
        HalfStrength = "half the strength",
        /// The stone that moves most does so twice as far as at first for a little more load.
        HalfStiffness = "half the stiffness",
    }
}

/// The load at which a state is first reached.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Permissible {
    /// Which state.
    pub criterion: Criterion,
    /// The load [N/m]; zero where the self-weight alone brings it about.
    pub load: f64,
}

/// What only the equilibrium path reports.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PathReport {
    /// How it ended.
    pub ended: Ended,
    /// Where joints carry what presses them.
    pub contact: Option<JointContact>,
    /// Loads at which states are first reached that a bridge should not come to in service.
    pub permissible: Vec<Permissible>,
    /// How often balance was lost and found again close by, as where a hinge moves to the next joint.
    pub snaps: u32,
    /// Largest out-of-balance force of a state, relative to all forces that act.
    pub equilibrium_residual: f64,
    /// Largest shear beyond the strength of a joint's end, relative to the weight of the blocks.
    pub yield_violation: f64,
    /// Iterations of Newton's method in all.
    pub iterations_total: u32,
    /// What fill that presses against movement does; none where the file has none.
    pub fill_pressure: Option<PathPressure>,
}

/// What fill that presses against movement does to a path.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PathPressure {
    /// Largest load of the path with the fill as weight alone [N/m]; none where it has none.
    pub without: Option<f64>,
    /// What movement has mobilised at the largest load, as a share of what it could mobilise where backs move against the fill.
    pub mobilised: f64,
}

/// What only finite elements report.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FiniteReport {
    /// Free components of displacement.
    pub equations: usize,
    /// Springs across each joint, the outermost at its edges.
    pub springs_per_joint: usize,
    /// Iterations of Newton's method in all.
    pub iterations_total: u64,
    /// How much farther the load moves for a little more of it at the end than at the start; none where it has no end.
    pub softening: Option<f64>,
}

/// The least thickness that stands.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ThicknessReport {
    /// Share of the given thickness that just stands, and the largest that was seen not to.
    pub factor: [f64; 2],
    /// Least thickness of all rings together at the crown of the first span [m].
    pub crown_thickness: f64,
    /// The same over the radius of the ring's middle line, where the intrados is a circle.
    pub over_mean_radius: Option<f64>,
}

/// The support movement that makes a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SupportReport {
    /// Last movement at which the bridge came to rest [m, or rad where only a rotation is given].
    pub last_stable: Option<f64>,
    /// Smallest movement at which it collapsed.
    pub collapse: Option<f64>,
    /// Increment.
    pub step: f64,
}

/// A method, and what only it reports.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum By {
    /// Limit analysis.
    Limit(LimitReport),
    /// Discrete elements; none where the run never began.
    Dem(Option<DemReport>),
    /// The equilibrium path.
    Path(PathReport),
    /// Finite elements.
    Fe(FiniteReport),
}

/// What was sought, with its answer where that is no load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sought {
    /// The load that makes a mechanism.
    Load,
    /// The least thickness that stands; none where none was found.
    Thickness(Option<ThicknessReport>),
    /// The support movement that makes a mechanism.
    SupportMovement(SupportReport),
}

/// One strip's part in the load of the whole width.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// Which strip.
    pub strip: Strip,
    /// How its analysis ended.
    pub status: Status,
    /// Its load at collapse [N/m].
    pub collapse_load: Option<f64>,
    /// The largest load that it carried [N/m].
    pub last_stable_load: Option<f64>,
    /// Its headline: the smaller of the methods [N/m].
    pub headline: Option<f64>,
    /// Its width [m].
    pub width: f64,
}

/// The loads of all strips, added up by their widths.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Combination {
    /// The strips.
    pub components: Vec<Component>,
    /// Sum of the collapse loads over the whole width [N].
    pub collapse_load: Option<f64>,
    /// Sum of the largest loads carried [N].
    pub last_stable_load: Option<f64>,
    /// Sum of the strips' headlines [N].
    pub headline: Option<f64>,
    /// What adding them up assumes.
    pub assumptions: Vec<Note>,
}

/// The result of a collapse analysis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Collapse {
    /// Name of the bridge.
    pub bridge: String,
    /// Width of the barrel [m].
    pub width: f64,
    /// By which method, and what only this method reports.
    pub by: By,
    /// What was sought.
    pub sought: Sought,
    /// How it ended.
    pub status: Status,
    /// Load at collapse [N/m].
    pub collapse_load: Option<f64>,
    /// Largest load carried [N/m].
    pub last_stable_load: Option<f64>,
    /// Load increment [N/m].
    pub load_step: Option<f64>,
    /// Load of the file: a load factor of one [N/m].
    pub reference_load: f64,
    /// Limit load of the same blocks with infinitely stiff joints that never crush [N/m], beside a discrete element run.
    pub limit_load: Option<f64>,
    /// The same with joints that crush, where the masonry has a strength [N/m].
    pub crushing_limit_load: Option<f64>,
    /// Load step that neither came to rest nor collapsed [N/m].
    pub stalled_load: Option<f64>,
    /// Hinges of the mechanism.
    pub hinges: Vec<Hinge>,
    /// Middles of joints that slide [m].
    pub sliding_joints: Vec<Point>,
    /// Largest compressive stress [Pa].
    pub max_compressive_stress: Option<f64>,
    /// Number of blocks.
    pub blocks: usize,
    /// Number of particles.
    pub particles: usize,
    /// Number of contact points.
    pub contacts: usize,
    /// Tolerance of the method.
    pub tolerance: f64,
    /// Seed of whatever is random.
    pub seed: u64,
    /// The packing of particles, where the fill is made of them.
    pub packing: Option<PackingReport>,
    /// Both strips together, where walls are analysed beside the fill.
    pub combination: Option<Combination>,
    /// The strip below the walls, where this is the one between them.
    pub wall_strip: Option<Box<Collapse>>,
    /// What may help the bridge and is not counted.
    #[serde(default)]
    pub not_counted: NotCounted,
    /// Axles of the file, on widths of their own.
    pub asked: Vec<AskedAxles>,
    /// Names of the blocks, in the order of the picture's shapes.
    pub block_names: Vec<String>,
    /// What a reader should look at.
    pub warnings: Vec<Warning>,
    /// What the result assumes.
    pub assumptions: Vec<Note>,
    /// Everything that figures and tables are made from.
    pub picture: Picture,
}

/// Axles of a load, on a width of their own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AskedAxles {
    /// Name of the load.
    pub name: String,
    /// Forces of its axles as the file has them [N].
    pub axles: Vec<f64>,
    /// Width of the barrel that carries an axle [m].
    pub effective_width: f64,
}

impl Collapse {
    /// How often the loads of the file are carried.
    pub fn load_factor(&self) -> Option<f64> {
        Some(self.carried().filter(|_| self.reference_load > 0.0)? / self.reference_load)
    }

    /// Whether loads have widths of their own, so that a load per metre times the width of the bridge is nothing that was asked for.
    pub fn has_own_widths(&self) -> bool {
        self.asked.iter().any(|asked| (asked.effective_width - self.width).abs() > 1e-9)
    }
}
