//! `extrados.collapse/1`.

use super::{Run, WarningObject, kilo};
use crate::collapse::Collapse;
use crate::picture::HingeAt;
use bridge::{Analysis, Method, Strip};
use serde::Serialize;

/// The result of a collapse analysis.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CollapseObject {
    schema: &'static str,
    status: &'static str,
    bridge: String,
    method: &'static str,
    analysis: &'static str,
    #[serde(flatten)]
    headline: Option<Headline>,
    last_stable_load_kn_per_m: Option<f64>,
    last_stable_load_kn: Option<f64>,
    collapse_load_kn_per_m: Option<f64>,
    collapse_load_kn: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stalled_load_kn_per_m: Option<f64>,
    load_step_kn_per_m: Option<f64>,
    load_step_kn: Option<f64>,
    reference_load_kn_per_m: f64,
    limit_load_kn_per_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    crushing_limit_load_kn_per_m: Option<f64>,
    width_m: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factor: Option<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    axles: Vec<Axles>,
    hinges: Vec<Hinge>,
    sliding_joints: Vec<Place>,
    max_compressive_stress_mpa: Option<f64>,
    blocks: usize,
    particles: usize,
    contacts: usize,
    #[serde(flatten)]
    dem: Option<Dem>,
    #[serde(flatten)]
    limit: Option<Limit>,
    #[serde(flatten)]
    finite: Option<Finite>,
    #[serde(flatten)]
    thickness: Option<Thickness>,
    #[serde(flatten)]
    support: Option<Support>,
    #[serde(skip_serializing_if = "Option::is_none")]
    packing: Option<Packing>,
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<Combination>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wall_strip: Option<Box<CollapseObject>>,
    assumptions: Vec<String>,
    warnings: Vec<WarningObject>,
    tolerance: f64,
    seed: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    threads: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wall_seconds: Option<f64>,
}

/// The load that is carried, by the method that gives least.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Headline {
    headline_kn_per_m: f64,
    headline_kn: f64,
    headline_from: &'static str,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Hinge {
    x_m: f64,
    y_m: f64,
    edge: &'static str,
    between: Vec<String>,
    rotation: f64,
}

/// Axles of a load as the file has them, and as they are carried.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Axles {
    name: String,
    axles_kn: Vec<f64>,
    effective_width_m: f64,
    carried_kn: Option<Vec<f64>>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Place {
    x_m: f64,
    y_m: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Dem {
    path: Vec<Step>,
    iterations_total: u64,
    time_step_s: f64,
    critical_time_step_s: f64,
    single_mass_time_step_s: f64,
    damping: String,
    contact_length: &'static str,
    energy_drift: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Step {
    #[serde(skip_serializing_if = "Option::is_none")]
    load_kn_per_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    movement_m: Option<f64>,
    displacement_mm: f64,
    displacement_x_mm: f64,
    displacement_y_mm: f64,
    iterations: u64,
    unbalanced_ratio: f64,
    at_rest: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Limit {
    friction: &'static str,
    lower_bound_kn_per_m: Option<f64>,
    upper_bound_kn_per_m: Option<f64>,
    associated_load_kn_per_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    non_associated_load_kn_per_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    without_fill_pressure_load_kn_per_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    full_fill_pressure_load_kn_per_m: Option<f64>,
    non_associated_spread_kn_per_m: Option<[f64; 2]>,
    unlimited_strength_load_kn_per_m: Option<f64>,
    equilibrium_residual: Option<f64>,
    yield_violation: Option<f64>,
    solver_iterations: u32,
    thrust_line: Vec<Thrust>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Finite {
    path: Vec<Step>,
    degrees_of_freedom: usize,
    springs_per_joint: usize,
    iterations_total: u64,
    softening: Option<f64>,
    thrust_line: Vec<Thrust>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Thrust {
    x_m: f64,
    y_m: f64,
    thrust_kn_per_m: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Thickness {
    minimum_thickness_m: f64,
    minimum_thickness_factor: f64,
    thickness_factor_that_falls: f64,
    minimum_thickness_over_mean_radius: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Support {
    last_stable_movement_m: Option<f64>,
    collapse_movement_m: Option<f64>,
    movement_step_m: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Packing {
    solid_fraction: f64,
    coordination: f64,
    mean_stress_kpa: f64,
    smallest_diameter_m: f64,
    largest_diameter_m: f64,
    settlement_mm: f64,
    seed: Option<u64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Combination {
    components: Vec<Component>,
    headline_total_kn: Option<f64>,
    last_stable_total_kn: Option<f64>,
    total_kn: Option<f64>,
    assumptions: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Component {
    strip: &'static str,
    status: &'static str,
    headline_kn_per_m: Option<f64>,
    last_stable_load_kn_per_m: Option<f64>,
    collapse_load_kn_per_m: Option<f64>,
    width_m: f64,
    headline_kn: Option<f64>,
    last_stable_load_kn: Option<f64>,
    collapse_load_kn: Option<f64>,
}

/// Axles times the factor with which the loads of the file are carried.
fn axles(c: &Collapse) -> Vec<Axles> {
    let factor = c.load_factor();
    let one = |asked: &crate::collapse::AskedAxles| Axles {
        name: asked.name.clone(),
        axles_kn: asked.axles.iter().copied().map(kilo).collect(),
        effective_width_m: asked.effective_width,
        carried_kn: factor.map(|factor| asked.axles.iter().map(|axle| kilo(factor * axle)).collect()),
    };
    c.asked.iter().map(one).collect()
}

/// The word for a method.
pub(super) fn method(method: Method) -> &'static str {
    match method {
        Method::Dem => "dem",
        Method::Limit => "limit",
        Method::Fe => "fe",
    }
}

/// The word for an analysis.
pub(super) fn analysis(analysis: Analysis) -> &'static str {
    match analysis {
        Analysis::Load => "load",
        Analysis::Thickness => "thickness",
        Analysis::SupportMovement => "support-movement",
    }
}

/// The word for a strip.
pub fn strip(strip: Strip) -> &'static str {
    match strip {
        Strip::Fill => "fill",
        Strip::Wall => "wall",
        Strip::Both => "both",
    }
}

/// The word for an edge.
pub fn edge(edge: HingeAt) -> &'static str {
    match edge {
        HingeAt::Intrados => "intrados",
        HingeAt::Extrados => "extrados",
        HingeAt::Other => "other",
    }
}

impl CollapseObject {
    /// The object for a result.
    pub fn new(c: &Collapse, run: &Run) -> CollapseObject {
        let total = |load: Option<f64>| load.map(|l| kilo(l * c.width));
        // Of both strips the whole width carries the sum.
        let both = c.combination.as_ref();
        let whole = |own: Option<f64>, sum: fn(&crate::collapse::Combination) -> Option<f64>| match both {
            Some(both) => sum(both).map(kilo),
            None => total(own),
        };
        let per_metre = |load: Option<f64>| load.map(kilo);
        let mut warnings = run.file_warnings.clone();
        warnings.extend(c.warnings.iter().map(WarningObject::from));
        CollapseObject {
            schema: "extrados.collapse/1",
            status: c.status.word(),
            bridge: c.bridge.clone(),
            method: method(c.method()),
            analysis: analysis(c.analysis()),
            headline: c.headline().map(|headline| Headline {
                headline_kn_per_m: kilo(headline.load),
                headline_kn: kilo(headline.whole),
                headline_from: headline.from,
            }),
            last_stable_load_kn_per_m: per_metre(c.last_stable_load),
            last_stable_load_kn: whole(c.last_stable_load, |both| both.last_stable_load),
            collapse_load_kn_per_m: per_metre(c.collapse_load),
            collapse_load_kn: whole(c.collapse_load, |both| both.collapse_load),
            stalled_load_kn_per_m: per_metre(c.stalled_load),
            load_step_kn_per_m: per_metre(c.load_step),
            load_step_kn: total(c.load_step),
            reference_load_kn_per_m: kilo(c.reference_load),
            limit_load_kn_per_m: per_metre(c.limit_load),
            crushing_limit_load_kn_per_m: per_metre(c.crushing_limit_load),
            width_m: c.width,
            load_factor: c.load_factor().filter(|_| c.analysis() == Analysis::Load),
            axles: axles(c),
            hinges: c
                .hinges
                .iter()
                .map(|h| Hinge {
                    x_m: h.point[0],
                    y_m: h.point[1],
                    edge: edge(h.edge),
                    between: c.sides(h).map(|sides| sides.map(str::to_owned).to_vec()).unwrap_or_default(),
                    rotation: h.rotation,
                })
                .collect(),
            sliding_joints: c.sliding_joints.iter().map(|p| Place { x_m: p[0], y_m: p[1] }).collect(),
            max_compressive_stress_mpa: c.max_compressive_stress.map(|s| s / 1e6),
            blocks: c.blocks,
            particles: c.particles,
            contacts: c.contacts,
            dem: c.dem().map(|d| Dem {
                path: path(c),
                iterations_total: d.iterations_total,
                time_step_s: d.time_step,
                critical_time_step_s: d.critical_time_step,
                single_mass_time_step_s: d.single_mass_time_step,
                damping: d.damping.clone(),
                contact_length: d.contact_length.word(),
                energy_drift: d.energy_drift,
            }),
            limit: c.limit().map(|l| Limit {
                friction: l.friction.word(),
                lower_bound_kn_per_m: per_metre(l.lower_bound),
                upper_bound_kn_per_m: per_metre(l.upper_bound),
                associated_load_kn_per_m: per_metre(l.associated_load),
                non_associated_load_kn_per_m: per_metre(l.non_associated_load),
                without_fill_pressure_load_kn_per_m: per_metre(l.without_fill_pressure_load),
                full_fill_pressure_load_kn_per_m: per_metre(l.full_fill_pressure_load),
                non_associated_spread_kn_per_m: l.spread.map(|s| s.map(kilo)),
                unlimited_strength_load_kn_per_m: per_metre(l.unlimited_strength_load),
                equilibrium_residual: l.equilibrium_residual,
                yield_violation: l.yield_violation,
                solver_iterations: l.iterations,
                thrust_line: thrust_line(c),
            }),
            finite: c.finite().map(|f| Finite {
                path: path(c),
                degrees_of_freedom: f.equations,
                springs_per_joint: f.springs_per_joint,
                iterations_total: f.iterations_total,
                softening: f.softening,
                thrust_line: thrust_line(c),
            }),
            thickness: c.thickness().map(|t| Thickness {
                minimum_thickness_m: t.crown_thickness,
                minimum_thickness_factor: t.factor[1],
                thickness_factor_that_falls: t.factor[0],
                minimum_thickness_over_mean_radius: t.over_mean_radius,
            }),
            support: c.support().map(|s| Support {
                last_stable_movement_m: s.last_stable,
                collapse_movement_m: s.collapse,
                movement_step_m: s.step,
            }),
            packing: c.packing.as_ref().map(|p| Packing {
                solid_fraction: p.solid_fraction,
                coordination: p.coordination,
                mean_stress_kpa: kilo(p.mean_stress),
                smallest_diameter_m: p.diameters[0],
                largest_diameter_m: p.diameters[1],
                settlement_mm: 1e3 * p.settlement,
                seed: p.seed,
            }),
            combination: c.combination.as_ref().map(combination),
            wall_strip: c.wall_strip.as_ref().map(|wall| {
                // What was found in the file is told once.
                let own = Run { file_warnings: Vec::new(), ..run.clone() };
                Box::new(CollapseObject::new(wall, &own))
            }),
            assumptions: c.assumptions.clone(),
            warnings,
            tolerance: c.tolerance,
            seed: c.seed,
            threads: (run.threads > 0).then_some(run.threads),
            wall_seconds: (run.threads > 0).then_some(run.wall_seconds),
        }
    }
}

/// The load path.
fn path(c: &Collapse) -> Vec<Step> {
    let moves = c.analysis() == Analysis::SupportMovement;
    let step = |s: &crate::picture::Step| Step {
        load_kn_per_m: (!moves).then(|| kilo(s.load)),
        movement_m: moves.then_some(s.load),
        displacement_mm: 1e3 * s.displacement[0].hypot(s.displacement[1]),
        displacement_x_mm: 1e3 * s.displacement[0],
        displacement_y_mm: 1e3 * s.displacement[1],
        iterations: s.iterations,
        unbalanced_ratio: s.unbalanced_ratio,
        at_rest: s.at_rest,
    };
    c.picture.path.iter().map(step).collect()
}

/// Points of all lines of thrust.
fn thrust_line(c: &Collapse) -> Vec<Thrust> {
    let points = c.picture.thrust_lines.iter().flatten();
    points.map(|t| Thrust { x_m: t.point[0], y_m: t.point[1], thrust_kn_per_m: kilo(t.thrust) }).collect()
}

fn combination(c: &crate::collapse::Combination) -> Combination {
    let component = |part: &crate::collapse::Component| Component {
        strip: strip(part.strip),
        status: part.status.word(),
        headline_kn_per_m: part.headline.map(kilo),
        last_stable_load_kn_per_m: part.last_stable_load.map(kilo),
        collapse_load_kn_per_m: part.collapse_load.map(kilo),
        width_m: part.width,
        headline_kn: part.headline.map(|load| kilo(load * part.width)),
        last_stable_load_kn: part.last_stable_load.map(|load| kilo(load * part.width)),
        collapse_load_kn: part.collapse_load.map(|load| kilo(load * part.width)),
    };
    Combination {
        components: c.components.iter().map(component).collect(),
        headline_total_kn: c.headline.map(kilo),
        last_stable_total_kn: c.last_stable_load.map(kilo),
        total_kn: c.collapse_load.map(kilo),
        assumptions: c.assumptions.clone(),
    }
}
