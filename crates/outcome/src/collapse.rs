//! What a collapse analysis found.

mod status;

pub use status::Status;

use crate::help::NotCounted;
use crate::note::Note;
use crate::picture::{Hinge, Picture};
use crate::published::{Object, kilo, list, object};
use crate::soil::ContinuumReport;
use crate::warning::Warning;
use crate::wire::published;
use crate::words::words;
use bridge::{Analysis, ContactLength, JointContact, Method, Strip};
use serde::{Deserialize, Serialize};

published! {
    /// The load that is carried: what leads every result.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct Headline {
        /// The load that is carried, by the method that gives least, per metre of width [N/m].
        pub load: f64 [kN/m] as headline,
        /// The same on the whole width [N].
        pub whole: f64 [kN] as headline,
        /// Which method gives it, in words.
        pub from: &'static str as headline_from,
    }
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
        let (own, rigid) = match &self.by {
            // Without dilation a state in equilibrium is no bound: others may carry less.
            By::Limit(found) if found.friction != FlowRule::Associated => {
                ("limit analysis, friction without dilation", None)
            }
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

    /// A load on the whole width [N]: of both strips their sum.
    fn whole(&self, own: Option<f64>, sum: fn(&Combination) -> Option<f64>) -> Option<f64> {
        self.combination.as_ref().map_or_else(|| own.map(|load| load * self.width), sum)
    }

    fn path(&self) -> Vec<Object> {
        list(&self.picture.path, |step| step.object(self.analysis() == Analysis::SupportMovement))
    }

    fn thrust_line(&self) -> Vec<Object> {
        list(self.picture.thrust_lines.iter().flatten(), |point| point.object())
    }

    /// Whether it was stopped before it ended.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.status == Status::Cancelled
    }

    /// Load of the headline [N/m].
    pub fn carried(&self) -> Option<f64> {
        self.headline().map(|headline| headline.load)
    }
}

published! {
    /// What only the discrete element method reports.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct DemReport |dem, of: &Collapse| {
        /// The load path.
        = path: Vec<picture::Step> = of.path(),
        /// Iterations in all.
        pub iterations_total: u64,
        /// Time step used [s].
        pub time_step: f64 [s],
        /// Critical time step from the largest eigenvalue [s].
        pub critical_time_step: f64 [s],
        /// Critical time step from the one-degree-of-freedom estimate [s].
        pub single_mass_time_step: f64 [s],
        /// Damping, in words.
        pub damping: String,
        /// Which length a contact stands for.
        pub contact_length: ContactLength,
        /// What the energy account leaves unexplained, relative to the work done.
        pub energy_drift: f64,
        /// Where a run broke off: block and iteration.
        pub broken_at: Option<(String, u64)> [kept],
    }

    /// The packing of particles, at rest under its own weight.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PackingReport |packing| {
        /// Centres and radii as packed [m].
        pub grains: Vec<[f64; 3]> [kept],
        /// Share of the region that the particles cover.
        pub solid_fraction: f64,
        /// Mean number of contacts of a particle.
        pub coordination: f64,
        /// Mean stress [Pa], compression positive.
        pub mean_stress: f64 [kPa],
        /// Smallest and largest diameter [m].
        pub diameters: [f64; 2] [kept],
        /// Smallest diameter of a particle.
        = smallest_diameter: f64 [m] = packing.diameters[0],
        /// Largest diameter of a particle.
        = largest_diameter: f64 [m] = packing.diameters[1],
        /// Mean sinking of the particles when the lid was taken away and the ring let go [m].
        pub settlement: f64 [mm],
        /// Seed from which it grew; none where it was read from a file.
        pub seed: Option<u64>,
    }
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

published! {
    /// What only limit analysis reports; [`LimitReport::default`] is that of a search through many loads or shapes, which bounds none of
    /// them by itself.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct LimitReport |limit, of: &Collapse| {
        /// The flow rule that the numbers belong to.
        pub friction: FlowRule,
        /// Lower bound, recomputed from the forces [N/m].
        pub lower_bound: Option<f64> [kN/m],
        /// Upper bound, recomputed from the mechanism [N/m].
        pub upper_bound: Option<f64> [kN/m],
        /// The associated collapse load, beside the other where friction is non-associated [N/m].
        pub associated_load: Option<f64> [kN/m],
        /// The non-associated collapse load, beside the other where walls are analysed with associated friction [N/m].
        pub non_associated_load?: Option<f64> [kN/m],
        /// Load without the fill's pressure against movement [N/m]; only where the file has it act.
        pub without_fill_pressure_load?: Option<f64> [kN/m],
        /// Load with all of the fill's passive pressure [N/m], where it presses.
        pub full_fill_pressure_load?: Option<f64> [kN/m],
        /// The load in the mechanism without dilation, or the least behind the largest where loads come and go, and the largest [N/m].
        pub spread: Option<[f64; 2]> [kN/m] as non_associated_spread,
        /// Collapse load of joints that never crush [N/m]; the same as the collapse load where the file gives no strength.
        pub unlimited_strength_load: Option<f64> [kN/m],
        /// Largest out-of-balance force, relative to the permanent loads.
        pub equilibrium_residual: Option<f64>,
        /// Largest excess over the strength, relative to the permanent loads.
        pub yield_violation: Option<f64>,
        /// Iterations of the solver.
        pub iterations: u32 as solver_iterations,
        /// Whether blocks stand without dilation only as far as they are jammed, so that no load is known.
        pub jammed: bool [kept],
        /// Whether the load comes and goes between those of `spread`.
        pub comes_and_goes: bool [kept],
        /// Points of all lines of thrust.
        = thrust_line: Vec<ThrustPoint> = of.thrust_line(),
        = ..ContinuumReport = limit.continuum.as_ref().map(|soil| soil.object()),
        /// What soil that yields as a continuum adds.
        pub continuum: Option<Box<ContinuumReport>> [kept],
    }
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

published! {
    /// The load at which a state is first reached.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct Permissible {
        /// Which state.
        pub criterion: Criterion,
        /// The load [N/m]; zero where the self-weight alone brings it about.
        pub load: f64 [kN/m],
    }

    /// What only the equilibrium path reports.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct PathReport |along, of: &Collapse| {
        /// The largest load in balance.
        = peak_load: Option<f64> [kN/m] = of.last_stable_load,
        /// How it ended.
        pub ended: Ended,
        /// Where joints carry what presses them.
        pub contact: Option<JointContact>,
        /// The load path.
        = path: Vec<picture::Step> = of.path(),
        /// Loads at which states are first reached that a bridge should not come to in service.
        pub permissible: Vec<Permissible>,
        /// What joints of other stiffness would carry: `times` that of the result, `last_stable_load_kn_per_m`.
        = over_stiffness?: Option<Vec<Object>> = of.picture.over_stiffness.as_ref().map(|over| list(&over.points, |[times, load]| object! {
            times: *times,
            last_stable_load_kn_per_m: kilo(*load),
        })),
        /// How often balance was lost and found again close by, as where a hinge moves to the next joint.
        pub snaps: u32,
        /// Largest out-of-balance force of a state, relative to all forces that act.
        pub equilibrium_residual: f64,
        /// Largest shear beyond the strength of a joint's end, relative to the weight of the blocks.
        pub yield_violation: f64,
        /// Iterations of Newton's method in all.
        pub iterations_total: u32,
        /// Largest load of the path with the fill as weight alone, where it presses against movement.
        = without_fill_pressure_load?: Option<f64> [kN/m] = along.fill_pressure.map(|fill| fill.without),
        /// What movement has mobilised at the largest load, as a share of what it could.
        = fill_pressure_mobilised?: Option<f64> = along.fill_pressure.map(|fill| fill.mobilised),
        /// What fill that presses against movement does; none where the file has none.
        pub fill_pressure: Option<PathPressure> [kept],
        /// Points of all lines of thrust.
        = thrust_line: Vec<ThrustPoint> = of.thrust_line(),
    }
}

/// What fill that presses against movement does to a path.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PathPressure {
    /// Largest load of the path with the fill as weight alone [N/m]; none where it has none.
    pub without: Option<f64>,
    /// What movement has mobilised at the largest load, as a share of what it could mobilise where backs move against the fill.
    pub mobilised: f64,
}

published! {
    /// What only finite elements report.
    #[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
    pub struct FiniteReport |finite, of: &Collapse| {
        /// The load path.
        = path: Vec<picture::Step> = of.path(),
        /// Free components of displacement.
        pub equations: usize as degrees_of_freedom,
        /// Springs across each joint, the outermost at its edges.
        pub springs_per_joint: usize,
        /// Iterations of Newton's method in all.
        pub iterations_total: u64,
        /// How much farther the load moves for a little more of it at the end than at the start; none where it has no end.
        pub softening: Option<f64>,
        /// Points of all lines of thrust.
        = thrust_line: Vec<ThrustPoint> = of.thrust_line(),
    }

    /// The least thickness that stands.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct ThicknessReport |least| {
        /// Share of the given thickness that just stands, and the largest that was seen not to.
        pub factor: [f64; 2] [kept],
        /// Least thickness of all rings together at the crown of the first span [m].
        pub crown_thickness: f64 [m] as minimum_thickness,
        /// Share of the given thickness that just stands.
        = minimum_thickness_factor: f64 = least.factor[1],
        /// The largest share of it that was seen not to stand.
        = thickness_factor_that_falls: f64 = least.factor[0],
        /// The least thickness over the radius of the ring's middle line, where the intrados is a circle.
        pub over_mean_radius: Option<f64> as minimum_thickness_over_mean_radius,
    }

    /// The support movement that makes a mechanism.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct SupportReport {
        /// Last movement at which the bridge came to rest [m, or rad where only a rotation is given].
        pub last_stable: Option<f64> [m] as last_stable_movement,
        /// Smallest movement at which it collapsed.
        pub collapse: Option<f64> [m] as collapse_movement,
        /// Increment.
        pub step: f64 [m] as movement_step,
    }
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

published! {
    /// One strip's part in the load of the whole width.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Component |part| {
        /// Which strip.
        pub strip: Strip,
        /// How its analysis ended.
        pub status: Status,
        /// Its headline: the smaller of the methods [N/m].
        pub headline: Option<f64> [kN/m],
        /// The largest load that it carried [N/m].
        pub last_stable_load: Option<f64> [kN/m],
        /// Its load at collapse [N/m].
        pub collapse_load: Option<f64> [kN/m],
        /// Its width [m].
        pub width: f64 [m],
        /// Its headline on its width.
        = headline: Option<f64> [kN] = part.headline.map(|load| load * part.width),
        /// The largest load that it carried, on its width.
        = last_stable_load: Option<f64> [kN] = part.last_stable_load.map(|load| load * part.width),
        /// Its load at collapse, on its width.
        = collapse_load: Option<f64> [kN] = part.collapse_load.map(|load| load * part.width),
    }

    /// The loads of all strips, added up by their widths.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Combination {
        /// The strips.
        pub components: Vec<Component>,
        /// Sum of the strips' headlines [N].
        pub headline: Option<f64> [kN] as headline_total,
        /// Sum of the largest loads carried [N].
        pub last_stable_load: Option<f64> [kN] as last_stable_total,
        /// Sum of the collapse loads over the whole width [N].
        pub collapse_load: Option<f64> [kN] as total,
        /// What adding them up assumes.
        pub assumptions: Vec<Note>,
    }

    /// The result of a collapse analysis. Its headline is the load that is carried, by the method that gives least.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Collapse |found| {
        = schema: String = "extrados.collapse/1",
        /// How it ended.
        pub status: Status,
        /// Name of the bridge.
        pub bridge: String,
        /// By which method.
        = method: Method = found.method(),
        /// What was sought.
        = analysis: Analysis = found.analysis(),
        /// By which method, and what only this method reports.
        pub by: By [kept],
        /// What was sought.
        pub sought: Sought [kept],
        = ..Headline = found.headline().map(|headline| headline.object()),
        /// Largest load carried [N/m]; none where none is known.
        pub last_stable_load: Option<f64> [kN/m],
        /// The same on the whole width.
        = last_stable_load: Option<f64> [kN] = found.whole(found.last_stable_load, |both| both.last_stable_load),
        /// Load at collapse [N/m].
        pub collapse_load: Option<f64> [kN/m],
        /// The same on the whole width.
        = collapse_load: Option<f64> [kN] = found.whole(found.collapse_load, |both| both.collapse_load),
        = ..NotCounted = found.not_counted.told(),
        /// What may help the bridge and is not counted.
        pub not_counted: NotCounted [kept],
        /// Load step that neither came to rest nor collapsed [N/m].
        pub stalled_load?: Option<f64> [kN/m],
        /// Load increment [N/m].
        pub load_step: Option<f64> [kN/m],
        /// The same on the whole width.
        = load_step: Option<f64> [kN] = found.load_step.map(|load| load * found.width),
        /// Load of the file: a load factor of one [N/m].
        pub reference_load: f64 [kN/m],
        /// Limit load of the same blocks with infinitely stiff joints that never crush [N/m], beside a discrete element run.
        pub limit_load: Option<f64> [kN/m],
        /// The same with joints that crush, where the masonry has a strength [N/m].
        pub crushing_limit_load?: Option<f64> [kN/m],
        /// Limit load of the same rings bonded into one [N/m], beside rings on one another with friction alone between them.
        pub bonded_rings_load?: Option<f64> [kN/m],
        /// Width of the barrel [m].
        pub width: f64 [m],
        /// How often the loads of the file are carried.
        = load_factor?: Option<f64> = found.load_factor().filter(|_| found.analysis() == Analysis::Load),
        /// Axles of the file, on widths of their own.
        pub asked?: Vec<AskedAxles> as axles =
            (!found.asked.is_empty()).then(|| list(&found.asked, |asked| asked.object(found.load_factor()))),
        /// Hinges of the mechanism.
        = hinges: Vec<Hinge> = list(&found.picture.hinges, |hinge| hinge.object(found.sides(hinge))),
        /// Middles of joints that slide: `x_m`, `y_m`.
        = sliding_joints: Vec<Point> = list(&found.picture.sliding, |at| object! { x_m: at[0], y_m: at[1], }),
        /// Largest compressive stress [Pa].
        pub max_compressive_stress: Option<f64> [MPa],
        /// Number of blocks.
        pub blocks: usize,
        /// Number of particles.
        pub particles: usize,
        /// Number of contact points.
        pub contacts: usize,
        = ..DemReport = found.dem().map(|dem| dem.object(found)),
        = ..LimitReport = found.limit().map(|limit| limit.object(found)),
        = ..PathReport = found.along().map(|along| along.object(found)),
        = ..FiniteReport = found.finite().map(|finite| finite.object(found)),
        = ..ThicknessReport = found.thickness().map(|least| least.object()),
        = ..SupportReport = found.support().map(|support| support.object()),
        /// The packing of particles, where the fill is made of them.
        pub packing?: Option<PackingReport>,
        /// Both strips together, where walls are analysed beside the fill.
        pub combination?: Option<Combination>,
        /// The strip below the walls, where this is the one between them.
        pub wall_strip?: Option<Box<Collapse>>,
        /// What the result assumes.
        pub assumptions: Vec<Note>,
        /// What a reader should look at.
        pub warnings: Vec<Warning>,
        /// Tolerance of the method.
        pub tolerance: f64,
        /// Seed of whatever is random.
        pub seed: u64,
        /// Names of the blocks, in the order of the picture's shapes.
        pub block_names: Vec<String> [kept],
        /// Everything that figures and tables are made from.
        pub picture: Picture [kept],
    }

    /// Axles of a load, on a width of their own; they are carried times a factor, where it is known.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct AskedAxles |asked, carried: Option<f64>| {
        /// Name of the load.
        pub name: String,
        /// Forces of its axles as the file has them [N].
        pub axles: Vec<f64> [kN],
        /// Width of the barrel that carries an axle [m].
        pub effective_width: f64 [m],
        /// The forces that are carried.
        = carried: Option<Vec<f64>> [kN] =
            carried.map(|factor| asked.axles.iter().map(|axle| factor * axle).collect::<Vec<_>>()),
    }
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
