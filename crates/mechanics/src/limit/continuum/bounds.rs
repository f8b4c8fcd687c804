//! Both bounds, on meshes that are refined where they differ.

use super::conic::Ending;
use super::lower::{Ends, Stresses, lower};
use super::mesh::Mesh;
use super::model::Continuum;
use super::report::{Pressure, motions, of_blocks, pressures};
use super::setting::{Question, Setting};
use super::triangulate::{MeshError, triangulate};
use super::upper::{Motion, jumps, strain_rates, upper};
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
        Wanted { ratio: 1.05, elements: 4000, first: 300 }
    }
}

/// How bounds ended. All of these are answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundsStatus {
    /// Both bounds were found; whether they are as close as wanted is seen from them.
    Bounded,
    /// The permanent loads alone are not carried by any stresses found, on the finest mesh.
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
    /// Share of the permanent loads that is carried, where they are not.
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

/// Share of the gap whose triangles are divided in a round.
const DIVIDED: f64 = 0.6;

/// Least growth of the mesh in a round: fewer triangles more are not worth a solution.
const GROWTH: f64 = 1.5;

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
    loop {
        let below = lower(&setting, &mesh, Question::Factor, pace);
        let above = upper(&setting, &mesh, Question::Factor, pace);
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
        let (Ok(below), Ok(above)) = (below, above) else {
            return Ok(unsolved(&setting, &mesh, bounds, pace));
        };
        let met = below.factor > 0.0 && above.factor <= wanted.ratio * below.factor;
        bounds.take(&setting, model, mesh, below, above);
        let count = bounds.mesh.triangles.len();
        pace.reach((count as f64 / wanted.elements as f64).min(0.99));
        if met || count >= wanted.elements {
            return Ok(bounds);
        }
        let Some(finer) = finer(&bounds, soil, wanted.elements) else { return Ok(bounds) };
        mesh = finer;
    }
}

/// Both bounds on a mesh that is given, of a body with other strengths or loads. Its boundary must touch the same things as that for which the
/// mesh was made.
pub fn bounds_on(
    model: &BlockModel,
    loading: &Loading,
    settings: &Settings,
    soil: &Continuum,
    mesh: &Mesh,
    pace: &Pace,
) -> Result<Bounds, ContinuumError> {
    let setting = Setting::new(model, loading, settings, soil)?;
    let below = lower(&setting, mesh, Question::Factor, pace);
    let above = upper(&setting, mesh, Question::Factor, pace);
    let round = Round {
        elements: mesh.triangles.len(),
        lower: below.as_ref().ok().map(|s| s.factor),
        upper: above.as_ref().ok().map(|m| m.factor),
    };
    let cancelled = matches!(below, Err(Ending::Cancelled)) || matches!(above, Err(Ending::Cancelled));
    let status = match (&below, &above) {
        (Ok(_), Ok(_)) => BoundsStatus::Bounded,
        _ if cancelled => BoundsStatus::Cancelled,
        _ => BoundsStatus::NotConverged,
    };
    let mut bounds = Bounds {
        status,
        lower: None,
        upper: None,
        mesh: mesh.clone(),
        gaps: Vec::new(),
        share: None,
        rounds: vec![round],
        blocks: without_numbers(&setting),
        motions: Table::default(),
        pressures: Vec::new(),
    };
    match (below, above) {
        (Ok(below), Ok(above)) => bounds.take(&setting, model, mesh.clone(), below, above),
        (below, above) => (bounds.lower, bounds.upper) = (below.ok(), above.ok()),
    }
    Ok(bounds)
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
    match lower(setting, mesh, Question::Share, pace) {
        Ok(field) if field.factor < 1.0 - 1e-6 => {
            bounds.status = BoundsStatus::NoEquilibrium;
            bounds.share = Some(field.factor);
            bounds.mesh = mesh.clone();
            bounds.lower = Some(field);
        }
        Err(Ending::Cancelled) => bounds.status = BoundsStatus::Cancelled,
        _ => {}
    }
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
fn finer(bounds: &Bounds, soil: &Continuum, most: usize) -> Option<Mesh> {
    let mut mesh = bounds.mesh.clone();
    let mut gaps = bounds.gaps.clone();
    let start = mesh.triangles.len();
    let target = ((start as f64 * GROWTH) as usize).min(most);
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
