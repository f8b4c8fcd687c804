//! Both bounds, on meshes that are refined where they differ.

use super::conic::Ending;
use super::lower::{Ends, Stresses, lower};
use super::mesh::Mesh;
use super::model::Continuum;
use super::report::{Pressure, motions, of_blocks, pressures};
use super::setting::Setting;
use super::triangulate::{MeshError, triangulate};
use super::upper::{Motion, jumps, share, strain_rates, upper};
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::ids::{BlockId, Table};
use crate::limit::outcome::{Outcome, Status};
use crate::limit::settings::{Friction, Settings};
use crate::plane::Vec2;
use crate::watch::Pace;
use thiserror::Error;

/// How close the bounds are wanted, and at what cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wanted {
    /// Upper over lower bound at which refinement ends.
    pub ratio: f64,
    /// Most triangles.
    pub elements: usize,
    /// Triangles of the first mesh, about.
    pub first: usize,
}

impl Default for Wanted {
    fn default() -> Wanted {
        Wanted { ratio: 1.05, elements: 4000, first: FIRST }
    }
}

/// How bounds ended. All of these are answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundsStatus {
    /// Both bounds were found; whether they are as close as wanted is seen from them.
    Bounded,
    /// The permanent loads alone are not carried: a motion proves it.
    NoEquilibrium,
    /// The loads can grow without end.
    Locks,
    /// A program was not solved on the first mesh.
    NotConverged,
    /// It was stopped before the first mesh was solved.
    Cancelled,
}

/// Why bounds cannot be asked for.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ContinuumError {
    /// The blocks.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The regions.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// One mesh and what was found on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Round {
    /// Triangles.
    pub elements: usize,
    /// Lower bound, where its program was solved.
    pub lower: Option<f64>,
    /// Upper bound, where its program was solved.
    pub upper: Option<f64>,
}

/// What was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// How it ended.
    pub status: BoundsStatus,
    /// The largest lower bound, on `mesh`.
    pub lower: Option<Stresses>,
    /// The smallest upper bound, on `mesh`.
    pub upper: Option<Motion>,
    /// The last mesh on which both were found.
    pub mesh: Mesh,
    /// By how much triangles keep the bounds apart [W/m]: dissipation less the power of the stresses of the lower bound.
    pub gaps: Vec<f64>,
    /// No more than this share of the permanent loads is carried, where a motion proves that it is less than all.
    pub share: Option<f64>,
    /// Every mesh.
    pub rounds: Vec<Round>,
    /// What the bounds say of the blocks: forces of the lower, mechanism of the upper. Without numbers where there are none.
    pub blocks: Outcome,
    /// Translation of the centroid [m] and rotation [rad] of each block, in the scale of the velocities of the soil.
    pub motions: Table<BlockId, (Vec2, f64)>,
    /// What soil exerts on the blocks at the lower bound.
    pub pressures: Vec<Pressure>,
}

impl Bounds {
    /// Upper over lower bound.
    pub fn ratio(&self) -> Option<f64> {
        let (lower, upper) = (self.lower.as_ref()?.factor, self.upper.as_ref()?.factor);
        (lower > 0.0).then_some(upper / lower)
    }

    fn take(&mut self, setting: &Setting<'_>, model: &BlockModel, mesh: Mesh, below: Stresses, above: Motion) {
        self.gaps = gaps(setting, &mesh, &below, &above);
        self.status = BoundsStatus::Bounded;
        self.blocks = of_blocks(setting, model, &below, &above);
        self.motions = motions(setting, &above);
        self.pressures = pressures(setting.soil, &mesh, &below);
        (self.lower, self.upper, self.mesh) = (Some(below), Some(above), mesh);
    }
}

/// Triangles of the first mesh, about.
pub const FIRST: usize = 300;

/// Most triangles over those of the first mesh, where no stresses are found that carry the weight.
const UNCARRIED: usize = 4;

/// Share of the gap whose triangles are divided at once. At Bridgemill 0.4, 0.6 and 0.8 take 6.0, 9.8 and 7.3 s to bounds within 2.4, 1.9 and 3.1 %.
const DIVIDED: f64 = 0.4;

/// Least and largest growth of the mesh in a round. The gap falls about as triangles multiply, so that a round aims at what is wanted.
const GROWTH: [f64; 2] = [1.3, 2.0];

/// The largest factor of the variable loads that blocks and soil carry together with what is always there, between two
/// bounds.
pub fn collapse_bounds(
    model: &BlockModel,
    loading: &Loading,
    settings: &Settings,
    soil: &Continuum,
    wanted: &Wanted,
    pace: &Pace,
) -> Result<Bounds, ContinuumError> {
    let setting = Setting::new(model, loading, settings, soil)?;
    let mut mesh = triangulate(soil, wanted.first.min(wanted.elements))?;
    let mut bounds = Bounds {
        status: BoundsStatus::NotConverged,
        lower: None,
        upper: None,
        mesh: mesh.clone(),
        gaps: Vec::new(),
        share: None,
        rounds: Vec::new(),
        blocks: without_numbers(&setting),
        motions: Table::default(),
        pressures: Vec::new(),
    };
    let mut most = None;
    loop {
        let below = lower(&setting, &mesh, pace);
        let above = upper(&setting, &mesh, pace);
        if matches!(below, Err(Ending::Cancelled)) || matches!(above, Err(Ending::Cancelled)) {
            if bounds.lower.is_none() {
                bounds.status = BoundsStatus::Cancelled;
            }
            return Ok(bounds);
        }
        bounds.rounds.push(Round {
            elements: mesh.triangles.len(),
            lower: below.as_ref().ok().map(|s| s.factor),
            upper: above.as_ref().ok().map(|m| m.factor),
        });
        let endless = matches!(below, Err(Ending::Endless));
        let (below, above) = match (below, above) {
            (Ok(below), Ok(above)) => (below, above),
            _ if endless => {
                bounds.status = BoundsStatus::Locks;
                return Ok(bounds);
            }
            (_, above) => {
                // A coarse mesh may hold no stresses that carry the weight where a finer one does.
                let finer = mesh.refined(&vec![true; mesh.triangles.len()], soil);
                let most = *most.get_or_insert(wanted.elements.max(UNCARRIED * mesh.triangles.len()));
                if bounds.lower.is_none() && finer.triangles.len() <= most {
                    mesh = finer;
                    continue;
                }
                bounds.upper = bounds.upper.or(above.ok());
                return Ok(unsolved(&setting, &mesh, bounds, pace));
            }
        };
        let met = below.factor > 0.0 && above.factor <= wanted.ratio * below.factor;
        bounds.take(&setting, model, mesh, below, above);
        let count = bounds.mesh.triangles.len();
        pace.reach((count as f64 / wanted.elements as f64).min(0.99));
        if met || count >= wanted.elements {
            return Ok(bounds);
        }
        let Some(finer) = finer(&bounds, soil, wanted) else { return Ok(bounds) };
        mesh = finer;
    }
}

/// The lower bound on a mesh that is given, of a body with other strengths or loads; none where its program was not solved. The boundary
/// must touch the same things as that for which the mesh was made.
pub fn lower_on(
    model: &BlockModel,
    loading: &Loading,
    settings: &Settings,
    soil: &Continuum,
    mesh: &Mesh,
    pace: &Pace,
) -> Result<Option<f64>, ContinuumError> {
    let setting = Setting::new(model, loading, settings, soil)?;
    Ok(lower(&setting, mesh, pace).ok().map(|field| field.factor))
}

/// The upper bound in the same way.
pub fn upper_on(
    model: &BlockModel,
    loading: &Loading,
    settings: &Settings,
    soil: &Continuum,
    mesh: &Mesh,
    pace: &Pace,
) -> Result<Option<f64>, ContinuumError> {
    let setting = Setting::new(model, loading, settings, soil)?;
    Ok(upper(&setting, mesh, pace).ok().map(|motion| motion.factor))
}

/// The joints, and nothing found.
fn without_numbers(setting: &Setting<'_>) -> Outcome {
    Outcome::without_numbers(Status::NotConverged, Friction::Associated, setting.interfaces.clone(), 0)
}

/// What is known where a program was not solved.
fn unsolved(setting: &Setting<'_>, mesh: &Mesh, mut bounds: Bounds, pace: &Pace) -> Bounds {
    if bounds.lower.is_some() {
        // An earlier mesh answered.
        return bounds;
    }
    match share(setting, mesh, pace) {
        Ok(share) if share < 1.0 - 1e-6 => {
            bounds.status = BoundsStatus::NoEquilibrium;
            bounds.share = Some(share);
        }
        Err(Ending::Cancelled) => bounds.status = BoundsStatus::Cancelled,
        _ => {}
    }
    bounds.mesh = mesh.clone();
    bounds
}

/// By how much each triangle keeps the bounds apart: what the motion dissipates there, less the power of the stresses of the lower bound.
/// The sum over all triangles and joints is the whole gap (Ciria, Peraire and Bonet 2008).
fn gaps(setting: &Setting<'_>, mesh: &Mesh, below: &Stresses, above: &Motion) -> Vec<f64> {
    let mut gaps = above.dissipation.clone();
    for t in 0..mesh.triangles.len() {
        let rates = strain_rates(mesh, t, &above.velocities);
        let twelfth = mesh.area(t) / 12.0;
        for (i, s) in below.stresses[t].iter().enumerate() {
            for (j, r) in rates.iter().enumerate() {
                let power: f64 = (0..3).map(|k| s[k] * r[k]).sum();
                gaps[t] -= twelfth * if i == j { 2.0 } else { 1.0 } * power;
            }
        }
    }
    for e in (0..mesh.edges.len()).filter(|&e| mesh.edges[e].other.is_none()) {
        let at = Ends::of(mesh, e);
        let t = mesh.edges[e].triangle;
        let ends = at.corners(mesh, t).map(|k| {
            let [xx, yy, xy] = below.stresses[t][k];
            let n = at.normal;
            let push = crate::plane::vec2(xx * n.x + xy * n.y, xy * n.x + yy * n.y);
            (push.dot(n), push.dot(n.left()))
        });
        // Linear times quadratic, by its control points: integrals of products of Bernstein's polynomials.
        for ((_, closing, sliding), weights) in jumps(setting, mesh, e, &above.velocities, &above.blocks)
            .into_iter()
            .zip([[3.0, 1.0], [2.0, 2.0], [1.0, 3.0]])
        {
            for ((pull, shear), weight) in ends.iter().zip(weights) {
                gaps[t] += at.length * weight / 12.0 * (pull * closing + shear * sliding);
            }
        }
    }
    gaps
}

/// The mesh refined where the gap is; none where nothing is left to refine.
fn finer(bounds: &Bounds, soil: &Continuum, wanted: &Wanted) -> Option<Mesh> {
    let over = bounds.ratio().map_or(f64::INFINITY, |ratio| (ratio - 1.0) / (wanted.ratio - 1.0));
    let growth = (1.1 * over).clamp(GROWTH[0], GROWTH[1]);
    let mut mesh = bounds.mesh.clone();
    let mut gaps = bounds.gaps.clone();
    let start = mesh.triangles.len();
    let target = ((start as f64 * growth) as usize).min(wanted.elements);
    while mesh.triangles.len() < target {
        let mut order: Vec<usize> = (0..gaps.len()).collect();
        order.sort_by(|&a, &b| gaps[b].total_cmp(&gaps[a]).then(a.cmp(&b)));
        let total: f64 = gaps.iter().map(|g| g.max(0.0)).sum();
        let (mut sum, mut marked) = (0.0, vec![false; gaps.len()]);
        for t in order {
            if sum >= DIVIDED * total || !(gaps[t] > 0.0) {
                break;
            }
            marked[t] = true;
            sum += gaps[t];
        }
        let next = mesh.refined(&marked, soil);
        if next.triangles.len() == mesh.triangles.len() {
            break;
        }
        // Children share what their parent had: found by their number of pieces, for pieces of one triangle follow one another.
        gaps = inherited(&mesh, &next, &gaps);
        mesh = next;
    }
    (mesh.triangles.len() > start).then_some(mesh)
}

/// The gaps of the triangles of a refined mesh, if each had its share by area. Pieces of a triangle follow one another in its place.
fn inherited(coarse: &Mesh, fine: &Mesh, gaps: &[f64]) -> Vec<f64> {
    let mut shared = Vec::with_capacity(fine.triangles.len());
    let mut next = 0;
    for (t, gap) in gaps.iter().enumerate() {
        let whole = coarse.area(t);
        let mut left = whole;
        while left > 1e-9 * whole && next < fine.triangles.len() {
            let area = fine.area(next);
            shared.push(gap * area / whole);
            left -= area;
            next += 1;
        }
    }
    shared
}
