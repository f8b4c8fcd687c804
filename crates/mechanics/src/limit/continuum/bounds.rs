//! Both bounds, on meshes that are refined where they differ.

use super::conic::Ending;
use super::lower::{Ends, Stresses, lower, push, share_carried};
use super::mesh::Mesh;
use super::report::{Pressure, of_blocks, pressures};
use super::setting::Setting;
use super::sideways::{Sideways, linear};
use super::triangulate::{MeshError, triangulate};
use super::upper::{Motion, jumps, share, strain_rates, upper};
use crate::ids::{BlockId, Table};
use crate::limit::outcome::Outcome;
use crate::plane::Vec2;
use crate::watch::CancelToken;

/// How close the bounds are wanted, and at what cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wanted {
    /// Upper over lower bound at which refinement ends.
    pub ratio: f64,
    /// Most triangles.
    pub elements: usize,
    /// Triangles of the first mesh, about.
    pub first: usize,
    /// Most meshes.
    pub rounds: usize,
}

impl Default for Wanted {
    fn default() -> Wanted {
        Wanted { ratio: 1.05, elements: 4000, first: FIRST, rounds: usize::MAX }
    }
}

/// How bounds ended. All of these are answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BoundsStatus {
    /// Both bounds were found; whether they are as close as wanted is seen from them.
    Bounded,
    /// A lower bound alone was asked for, and was found.
    LowerAlone,
    /// The permanent loads alone are not carried: a motion proves it.
    NoEquilibrium,
    /// The loads can grow without end.
    Locks,
    /// One program or both were not solved on any mesh.
    #[default]
    NotConverged,
    /// It was stopped before both were.
    Cancelled,
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

impl Round {
    pub(super) fn of(mesh: &Mesh, lower: Option<&Stresses>, upper: Option<&Motion>) -> Round {
        let (lower, upper) = (lower.map(|stresses| stresses.factor), upper.map(|motion| motion.factor));
        Round { elements: mesh.triangles.len(), lower, upper }
    }
}

/// What was found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bounds {
    /// How it ended.
    pub status: BoundsStatus,
    /// The largest lower bound, on `mesh`. Without convergence it may stand alone.
    pub lower: Option<Stresses>,
    /// The smallest upper bound, on `mesh`. Without convergence it may stand alone.
    pub upper: Option<Motion>,
    /// The last mesh on which both were found; where there is none, the last one.
    pub mesh: Mesh,
    /// The one before it on which both were found, for work that repeats a program many times.
    pub coarser: Option<Mesh>,
    /// By how much triangles keep the bounds apart [W/m]: dissipation less the power of the stresses of the lower bound.
    pub gaps: Vec<f64>,
    /// No more than this share of the permanent loads is carried, where a motion proves that it is less than all.
    pub share: Option<f64>,
    /// This share of them is carried, where no stresses were found that carry all: of the last mesh.
    pub carried: Option<f64>,
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

    /// Nothing found yet.
    pub(super) fn begun(setting: &Setting<'_>, mesh: Mesh) -> Bounds {
        let blocks = Outcome { interfaces: setting.interfaces.clone(), ..Outcome::default() };
        Bounds { mesh, blocks, ..Bounds::default() }
    }

    fn take(&mut self, setting: &Setting<'_>, mesh: Mesh, below: Stresses, above: Motion) {
        self.gaps = gaps(setting, &mesh, &below, &above);
        self.status = BoundsStatus::Bounded;
        self.blocks = of_blocks(setting, &below, &above);
        self.motions = setting.equilibrium.motions(&above.blocks);
        self.pressures = pressures(setting.soil, &mesh, &below);
        let before = std::mem::replace(&mut self.mesh, mesh);
        self.coarser = self.lower.as_ref().and(Some(before));
        (self.lower, self.upper) = (Some(below), Some(above));
    }
}

/// Triangles of the first mesh, about.
pub const FIRST: usize = 200;

/// Most triangles over those of the first mesh, where no stresses are found that carry the weight.
const UNCARRIED: usize = 4;

/// So many times more than that the last mesh may have: one division of all triangles makes two to four of each.
const OVER: usize = 2;

/// Share of the gap whose triangles are divided at once.
const DIVIDED: f64 = 0.2;

/// Least and largest growth of the mesh in a round, and the power of the gap with which triangles multiply, so that a round aims at what is wanted.
/// At Bridgemill, to 5 %: three meshes and 3.8 s in place of four and 5.5 s with growth up to twice and in proportion to the gap.
const GROWTH: [f64; 2] = [1.3, 3.0];
const POWER: f64 = 0.6;

/// The largest factor of the variable loads that blocks and soil carry together with what is always there, between two
/// bounds.
///
/// # Errors
/// Regions that have no mesh.
pub fn collapse_bounds(setting: &Setting<'_>, wanted: &Wanted, token: &CancelToken) -> Result<Bounds, MeshError> {
    let mesh = triangulate(setting.soil, wanted.first.min(wanted.elements))?;
    let bounds = Bounds::begun(setting, mesh.clone());
    Ok(refined(setting, (bounds, mesh), wanted, token))
}

/// Bounds that were found, closer by at most as many meshes as are wanted; as they are where they are close enough, where the mesh has as
/// many triangles as it may, or where there is nothing to refine. Where a lower bound stands alone, the upper one of its mesh comes first.
///
/// # Errors
/// Those of [`collapse_bounds`].
pub fn closer_bounds(
    setting: &Setting<'_>,
    wanted: &Wanted,
    bounds: &Bounds,
    token: &CancelToken,
) -> Result<Bounds, MeshError> {
    if bounds.status == BoundsStatus::LowerAlone {
        return match (bounds.lower.clone(), upper(setting, &bounds.mesh, token)) {
            (_, Err(Ending::Cancelled)) => Ok(bounds.clone()),
            (Some(below), Ok(above)) => {
                let rounds = vec![Round::of(&bounds.mesh, Some(&below), Some(&above))];
                let mut both = Bounds { rounds, ..Bounds::begun(setting, bounds.mesh.clone()) };
                both.take(setting, bounds.mesh.clone(), below, above);
                Ok(both)
            }
            // What is carried stays proven where no motion is found.
            _ => {
                let found = collapse_bounds(setting, wanted, token)?;
                Ok(if found.status == BoundsStatus::Bounded { found } else { bounds.clone() })
            }
        };
    }
    let bounds = bounds.clone();
    let met = bounds.ratio().is_some_and(|ratio| ratio <= wanted.ratio);
    if met || bounds.status != BoundsStatus::Bounded || bounds.mesh.triangles.len() >= wanted.elements {
        return Ok(bounds);
    }
    Ok(match finer(setting, &bounds, wanted) {
        Some(mesh) => refined(setting, (bounds, mesh), wanted, token),
        None => bounds,
    })
}

/// Both bounds on a mesh, and on finer ones until they are as close as wanted.
fn refined(
    setting: &Setting<'_>,
    (mut bounds, mut mesh): (Bounds, Mesh),
    wanted: &Wanted,
    token: &CancelToken,
) -> Bounds {
    let last = bounds.rounds.len().saturating_add(wanted.rounds);
    let mut most = None;
    loop {
        let below = lower(setting, &mesh, token);
        let above = upper(setting, &mesh, token);
        if matches!(below, Err(Ending::Cancelled)) || matches!(above, Err(Ending::Cancelled)) {
            if bounds.status != BoundsStatus::Bounded {
                bounds.status = BoundsStatus::Cancelled;
            }
            return bounds;
        }
        bounds.rounds.push(Round::of(&mesh, below.as_ref().ok(), above.as_ref().ok()));
        let (below, above) = match (below, above) {
            (Ok(below), Ok(above)) => (below, above),
            (Err(Ending::Endless), _) => {
                // Loads that can grow without end say nothing of those that are always there.
                bounds.status = BoundsStatus::Locks;
                return unsolved(setting, mesh, bounds, token);
            }
            // An earlier mesh answered.
            _ if bounds.status == BoundsStatus::Bounded => return bounds,
            (below, above) => {
                let most = *most.get_or_insert(wanted.elements.max(UNCARRIED * mesh.triangles.len()));
                (bounds.lower, bounds.upper) = (below.ok(), above.ok());
                bounds = unsolved(setting, mesh, bounds, token);
                if bounds.status != BoundsStatus::NotConverged || bounds.mesh.triangles.len() >= most {
                    return bounds;
                }
                // A coarse mesh may hold no stresses that carry the weight where a finer one does, or no motion: refined where the stresses
                // that carry most of the weight are worked hardest, or everywhere where these are not known.
                let finer = match bounds.gaps.is_empty() {
                    false => finer(setting, &bounds, &Wanted { elements: most, ..*wanted }),
                    true => Some(bounds.mesh.refined(&vec![true; bounds.mesh.triangles.len()], setting.soil).0),
                };
                let Some(finer) = finer.filter(|finer| finer.triangles.len() <= OVER * most) else { return bounds };
                mesh = finer;
                continue;
            }
        };
        let met = below.factor > 0.0 && above.factor <= wanted.ratio * below.factor;
        bounds.take(setting, mesh, below, above);
        let count = bounds.mesh.triangles.len();
        token.reach((count as f64 / wanted.elements as f64).min(0.99));
        if met || count >= wanted.elements || bounds.rounds.len() >= last {
            return bounds;
        }
        let Some(finer) = finer(setting, &bounds, wanted) else { return bounds };
        mesh = finer;
    }
}

/// One of the two bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Which {
    /// Stresses: what is carried.
    Lower,
    /// A motion: what is not.
    Upper,
}

/// One bound on a mesh that is given, of a body with other strengths or loads; none where its program was not solved. The boundary must
/// touch the same things as that for which the mesh was made.
pub fn bound_on(which: Which, setting: &Setting<'_>, mesh: &Mesh, token: &CancelToken) -> Option<f64> {
    match which {
        Which::Lower => lower(setting, mesh, token).ok().map(|field| field.factor),
        Which::Upper => upper(setting, mesh, token).ok().map(|motion| motion.factor),
    }
}

/// What is known where one program or both were not solved on a mesh.
fn unsolved(setting: &Setting<'_>, mesh: Mesh, mut bounds: Bounds, token: &CancelToken) -> Bounds {
    if bounds.lower.is_none() {
        (bounds.gaps, bounds.carried) = (Vec::new(), None);
        match share(setting, &mesh, token) {
            Ok(share) if share < 1.0 - 1e-6 => {
                bounds.status = BoundsStatus::NoEquilibrium;
                bounds.share = Some(share);
            }
            Ok(_) => {
                if let Ok(field) = share_carried(setting, &mesh, token) {
                    (bounds.gaps, bounds.carried) = (field.dissipation, Some(field.factor));
                }
            }
            Err(Ending::Cancelled) => bounds.status = BoundsStatus::Cancelled,
            _ => {}
        }
    }
    bounds.mesh = mesh;
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
    gaps_beside(setting, mesh, below, above, &mut gaps);
    for e in (0..mesh.edges.len()).filter(|&e| mesh.edges[e].other.is_none()) {
        let at = Ends::of(mesh, e);
        let t = mesh.edges[e].triangle;
        let ends = at.corners(mesh, t).map(|k| {
            let traction = push(below.stresses[t][k], at.normal);
            (traction.dot(at.normal), traction.dot(at.normal.left()))
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

/// What the pressures of the lower bound on panels that give way add to the gaps.
fn gaps_beside(setting: &Setting<'_>, mesh: &Mesh, below: &Stresses, above: &Motion, gaps: &mut [f64]) {
    for (t, pressures) in below.sideways.iter().enumerate() {
        let Some(held) = Sideways::of(setting, mesh, t, &setting.soil_of(mesh, t)) else { continue };
        let ([slide, tilt], weights) = (above.panels[held.panel], linear(mesh, t, &setting.soil.panels[held.panel]));
        gaps[t] +=
            pressures.iter().zip(weights).map(|(p, [area, moment])| p * (slide * area + tilt * moment)).sum::<f64>();
    }
}

/// The mesh refined where the gap is; none where nothing is left to refine.
fn finer(setting: &Setting<'_>, bounds: &Bounds, wanted: &Wanted) -> Option<Mesh> {
    let over = bounds.ratio().map_or(f64::INFINITY, |ratio| (ratio - 1.0) / (wanted.ratio - 1.0));
    let growth = (1.1 * over).powf(POWER).clamp(GROWTH[0], GROWTH[1]);
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
        let (next, parents) = mesh.refined(&marked, setting.soil);
        if next.triangles.len() == mesh.triangles.len() {
            break;
        }
        // Pieces share what their triangle had.
        gaps = parents.iter().enumerate().map(|(k, &t)| gaps[t] * next.area(k) / mesh.area(t)).collect();
        mesh = next;
    }
    (mesh.triangles.len() > start).then_some(mesh)
}
