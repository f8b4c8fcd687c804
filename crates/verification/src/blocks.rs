//! Bare blocks from a `blocks.toml`, for published benchmarks that are no bridges. Numbers are in SI units, as their keys
//! say; the load is a number that multiplies the variable forces.
//!
//! This is the bench's own format, beside the block model file that engineers write (`crate::blocks`): it takes gravity in
//! any direction, walls and rings by rule, supports that hold some motions only, and densities next to zero, all of which
//! benchmarks need and which a survey never has.

use assess::analysis::engine::{self, rigid};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::dem;
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::limit;
use mechanics::plane::{Polygon, Vec2, vec2};
use serde::Deserialize;

/// A file of blocks.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Blocks {
    /// Acceleration of gravity [m/s^2]: straight down, unless two numbers are given.
    gravity_m_per_s2: Gravity,
    joint: Joint,
    #[serde(default)]
    block: Vec<Listed>,
    wall: Option<Wall>,
    ring: Option<Ring>,
    /// Forces that are there from the start.
    #[serde(default)]
    permanent: Vec<Force>,
    /// Forces that the load factor multiplies.
    #[serde(default)]
    variable: Vec<Force>,
    /// Every free block is pushed sideways by its weight times the load factor.
    #[serde(default)]
    sideways_weight: bool,
    analysis: Analysis,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(untagged)]
enum Gravity {
    Down(f64),
    Vector([f64; 2]),
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Joint {
    friction: f64,
    #[serde(default)]
    cohesion_pa: f64,
    #[serde(default)]
    tension_pa: f64,
    crushing_pa: Option<f64>,
    normal_stiffness_pa_per_m: Option<f64>,
    shear_stiffness_pa_per_m: Option<f64>,
    /// Length that a corner on a corner stands for; a hundredth of the smallest block's side unless given.
    least_length_m: Option<f64>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Listed {
    outline_m: Vec<[f64; 2]>,
    density_kg_per_m3: f64,
    #[serde(default)]
    rounding_m: f64,
    /// Prevented motions among "x", "y", "rotation".
    #[serde(default)]
    held: Vec<String>,
}

/// Courses of blocks from the bottom up on a fixed ground; a negative length leaves an opening.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wall {
    length_m: f64,
    height_m: f64,
    density_kg_per_m3: f64,
    #[serde(default)]
    rounding_m: f64,
    courses: Vec<Vec<f64>>,
}

/// A circular ring of flat-faced voussoirs between two fixed ones.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Ring {
    mean_radius_m: f64,
    thickness_m: f64,
    embrace_deg: f64,
    voussoirs: usize,
    density_kg_per_m3: f64,
    #[serde(default)]
    rounding_m: f64,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Force {
    block: usize,
    at_m: [f64; 2],
    force_n_per_m: [f64; 2],
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Analysis {
    method: String,
    /// "associated" unless given.
    friction: Option<String>,
    #[serde(default)]
    full_face: bool,
    increment: Option<f64>,
    limit: Option<f64>,
    resolution: Option<f64>,
    /// 0.7 unless given.
    local_damping: Option<f64>,
    /// 1e-5 unless given.
    tolerance: Option<f64>,
    /// Two million unless given.
    step_limit: Option<u64>,
    watched: Option<usize>,
}

impl Blocks {
    /// The blocks and what acts on them.
    fn model(&self) -> Result<(BlockModel, Loading), String> {
        let mut blocks: Table<BlockId, Block> = Table::default();
        let mut add = |outline: Vec<Vec2>, rounding: f64, density: f64, held: Held| -> Result<(), String> {
            let outline = Polygon::new(outline).map_err(|e| format!("block {}: {e}", blocks.len()))?;
            blocks.push(Block { outline, rounding, density, group: GroupId::new(0), held });
            Ok(())
        };
        for b in &self.block {
            let is = |word: &str| b.held.iter().any(|h| h == word);
            let held = Held { x: is("x"), y: is("y"), rotation: is("rotation") };
            let outline = b.outline_m.iter().map(|&[x, y]| vec2(x, y)).collect();
            add(outline, b.rounding_m, b.density_kg_per_m3, held)?;
        }
        if let Some(wall) = &self.wall {
            let rectangle =
                |x: f64, y: f64, w: f64, h: f64| vec![vec2(x, y), vec2(x + w, y), vec2(x + w, y + h), vec2(x, y + h)];
            let width: f64 = wall.courses.first().map_or(0.0, |c| c.iter().map(|l| l.abs() * wall.length_m).sum());
            add(rectangle(-width, -0.5, 3.0 * width, 0.5), wall.rounding_m, wall.density_kg_per_m3, Held::FIXED)?;
            for (level, course) in wall.courses.iter().enumerate() {
                let mut x = 0.0;
                for &length in course {
                    if length > 0.0 {
                        let outline = rectangle(
                            x * wall.length_m,
                            level as f64 * wall.height_m,
                            length * wall.length_m,
                            wall.height_m,
                        );
                        add(outline, wall.rounding_m, wall.density_kg_per_m3, Held::FREE)?;
                    }
                    x += length.abs();
                }
            }
        }
        if let Some(ring) = &self.ring {
            let (low, high) =
                (ring.mean_radius_m - 0.5 * ring.thickness_m, ring.mean_radius_m + 0.5 * ring.thickness_m);
            let half = 0.5 * ring.embrace_deg.to_radians();
            let at = |k: i64, r: f64| {
                let angle = -half + 2.0 * half * k as f64 / ring.voussoirs as f64;
                vec2(r * angle.sin(), r * angle.cos())
            };
            for k in -1..=ring.voussoirs as i64 {
                let held = if k < 0 || k == ring.voussoirs as i64 { Held::FIXED } else { Held::FREE };
                let outline = vec![at(k, low), at(k + 1, low), at(k + 1, high), at(k, high)];
                add(outline, ring.rounding_m, ring.density_kg_per_m3, held)?;
            }
        }
        let count = blocks.len();
        let forces = |list: &[Force]| -> Result<Vec<PointForce>, String> {
            list.iter()
                .map(|f| {
                    let [x, y] = f.at_m;
                    let [fx, fy] = f.force_n_per_m;
                    let known = f.block < count;
                    let force = PointForce { block: BlockId::new(f.block), at: vec2(x, y), force: vec2(fx, fy) };
                    known.then_some(force).ok_or(format!("there is no block {}", f.block))
                })
                .collect()
        };
        let (permanent, mut variable) = (forces(&self.permanent)?, forces(&self.variable)?);
        let gravity = match self.gravity_m_per_s2 {
            Gravity::Down(g) => vec2(0.0, -g),
            Gravity::Vector([x, y]) => vec2(x, y),
        };
        if self.sideways_weight {
            variable.extend(blocks.pairs().filter(|(_, b)| !b.held.is_fixed()).map(|(block, b)| PointForce {
                block,
                at: b.outline.centroid(),
                force: vec2(b.mass() * gravity.norm(), 0.0),
            }));
        }
        let j = &self.joint;
        let smallest = blocks.iter().map(|b| b.outline.area()).fold(f64::INFINITY, f64::min).sqrt();
        let stiffness = |k: Option<f64>| Stiffness::Given(k.unwrap_or(f64::INFINITY));
        let law = ContactLaw {
            normal: stiffness(j.normal_stiffness_pa_per_m),
            shear: stiffness(j.shear_stiffness_pa_per_m),
            friction: j.friction,
            cohesion: j.cohesion_pa,
            tension: j.tension_pa,
            crushing: j.crushing_pa.unwrap_or(f64::INFINITY),
            fixed_length: None,
            least_length: j.least_length_m.unwrap_or(0.01 * smallest),
        };
        let groups = ["blocks".to_string()].into_iter().collect();
        let model =
            BlockModel { blocks, particles: Table::default(), groups, laws: LawTable::uniform(1, law), gravity };
        Ok((model, Loading { permanent, variable, ..Loading::default() }))
    }

    /// Runs the analysis and names what came of it.
    pub(crate) fn run(&self) -> Result<serde_json::Value, String> {
        let (model, loading) = self.model()?;
        match self.analysis.method.as_str() {
            "limit" => self.limit(&model, &loading),
            "dem" => self.dem(&model, &loading),
            other => Err(format!("there is no method {other}: write \"limit\" or \"dem\"")),
        }
    }

    fn limit(&self, model: &BlockModel, loading: &Loading) -> Result<serde_json::Value, String> {
        let settings = limit::Settings {
            friction: match self.analysis.friction.as_deref().unwrap_or("associated") {
                "associated" => limit::Friction::Associated,
                "non-associated" => limit::Friction::NonAssociated,
                "automatic" => limit::Friction::Automatic,
                other => return Err(format!("there is no friction rule {other}")),
            },
            contact_points: if self.analysis.full_face {
                limit::ContactPoints::FullRing
            } else {
                limit::ContactPoints::Rounded
            },
            crushing: self.joint.crushing_pa.is_some(),
        };
        let o = limit::collapse_load(model, loading, &settings).map_err(|e| e.to_string())?;
        let (hinges, sliding) = o.mechanism.as_ref().map_or((0, 0), |m| (m.hinges.len(), m.sliding.len()));
        Ok(serde_json::json!({
            "status": rigid::status(o.status).word(),
            "load_factor": o.factor,
            "associated_factor": o.associated_factor,
            "spread_factor": o.spread,
            "lower_bound_factor": o.lower_bound,
            "upper_bound_factor": o.upper_bound,
            "equilibrium_residual": o.equilibrium_residual,
            "yield_violation": o.yield_violation,
            "blocks": model.blocks.iter().filter(|b| !b.held.is_fixed()).count(),
            "joints": o.interfaces.len(),
            "hinge_count": hinges,
            "sliding_count": sliding,
        }))
    }

    fn dem(&self, model: &BlockModel, loading: &Loading) -> Result<serde_json::Value, String> {
        let a = &self.analysis;
        let free = model.blocks.pairs().filter(|(_, b)| !b.held.is_fixed()).map(|(id, _)| id);
        let block = a.watched.map(BlockId::new).or(free.last()).ok_or("every block is held")?;
        let program = dem::Program {
            increment: a.increment.ok_or("the discrete element method needs an increment of the load factor")?,
            limit: a.limit.ok_or("the discrete element method needs a limit of the load factor")?,
            resolution: a.resolution,
            watched: (block, model.blocks[block].outline.centroid()),
        };
        let settings = dem::Settings {
            damping: dem::Damping::Local(a.local_damping.unwrap_or(0.7)),
            contact_length: dem::ContactLength::Fixed,
            tolerance: a.tolerance.unwrap_or(1e-5),
            step_limit: a.step_limit.unwrap_or(2_000_000),
            time_step_factor: 0.8,
            scaled_inertia: false,
        };
        let mut watch = mechanics::watch::Unwatched;
        let o = dem::collapse(model, loading, &program, &settings, None, &mut watch).map_err(|e| e.to_string())?;
        let (status, _) = engine::dem::ended(o.status);
        Ok(serde_json::json!({
            "status": status.word(),
            "last_stable_factor": o.last_stable_factor,
            "collapse_factor": o.collapse_factor,
            "blocks": model.blocks.iter().filter(|b| !b.held.is_fixed()).count(),
            "iterations_total": o.iterations_total,
            "max_compressive_stress_mpa": o.max_compressive_stress / 1e6,
        }))
    }
}
