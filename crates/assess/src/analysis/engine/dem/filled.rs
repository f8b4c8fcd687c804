//! Collapse of rings under fill that is particles: packed, let go, loaded.

use super::{ended, loads, report, settings};
use crate::analysis::engine::joints::require_stiffness;
use crate::analysis::engine::rigid;
use crate::analysis::engine::steps::program;
use crate::analysis::parallel::Retold;
use crate::analysis::state::{self, Change};
use crate::analysis::{AnalysisError, notes, template};
use bridge::{Bridge, Particles, Plan};
use mechanics::blocks::{Block, BlockModel, Loading, Particle};
use mechanics::dem::{self, Body, Frame, Grain, Model, PackingError, Rested, begin, pack, take_over};
use mechanics::ids::{BlockId, Table};
use mechanics::kept;
use mechanics::limit;
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::{CancelToken, Progress, Watch, Wish};
use outcome::collapse::{By, Status};
use outcome::collapse::{Collapse, PackingReport};
use structure::discretise::fill::FillRegion;
use structure::discretise::{Discretised, Origin, discretise};

/// Packs the fill, lets ring and fill come to rest, puts the loading blocks on it and raises the loads in steps until
/// the ring collapses or the fill gives way.
///
/// # Errors
/// An analysis that cannot be set up, fill that cannot be packed, a packing of another region, or a `resume` of something else.
pub fn collapse_filled(
    bridge: &Bridge,
    particles: &Particles,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let (mut d, region, plan) = begun(bridge, particles)?;
    let kept = resume.map(kept::split::<Head>).transpose()?;
    let grains = match &kept {
        Some(((grains, _), _)) => grains.clone(),
        None => match packing(bridge, &d, &region, particles, watch) {
            Ok(grains) => grains,
            Err(PackingError::Stopped) => return Ok(stopped(bridge, &d)),
            Err(error) => return Err(error.into()),
        },
    };
    fill(&mut d, &region, &grains);
    let (rested, lifts, iterations, resume) = match kept {
        // The loads are on already; so many iterations had gone by when they came.
        Some(((_, Some((lifts, iterations))), state)) => (None, lifts, iterations, Some(state)),
        kept => {
            let rested = Settled::rest(bridge, &d, &grains, kept.map(|(_, state)| state), watch)?;
            if rested.outcome.status != dem::Status::StableToLastLoad {
                return Ok(not_at_rest(bridge, &d, &region, &grains, &rested));
            }
            let (lifts, iterations) = (lifts(&d, &rested.frame()), rested.outcome.state.steps);
            (Some(rested), lifts, iterations, None)
        }
    };
    lift(&mut d, &lifts);
    let (program, load_step) = program(&plan, &d, None, &mut Vec::new())?;
    let model = Model::new(&d.model, &d.loading)?;
    let settings = settings(bridge);
    let state = || match &rested {
        Some(rested) => take_over(&model, &settings, (&rested.model, &rested.outcome.state)),
        None => begin(&model, &settings),
    };
    let kept = |state: &[u8]| kept::join(&(&grains, Some((&lifts, iterations))), state);
    let mut part = Retold { watch, kept: Some(&kept), told: Progress::clone };
    let outcome = dem::collapse_from(&model, &state, &program, &settings, resume, &mut part)?;
    let mut c = report(bridge, &d, &outcome, "discrete elements", &|factor| d.load(factor));
    loads(&outcome, &d, &mut c);
    c.load_step = Some(load_step);
    c.packing = outcome.frames.first().map(|frame| packing_report(bridge, &d, &region, &grains, frame));
    if let By::Dem(Some(dem)) = &mut c.by {
        dem.iterations_total += iterations;
    }
    notes::dem(bridge, &d, &mut c);
    notes::filled(bridge, &mut c);
    notes::crushed_under_particles(bridge, crushing_takes(bridge), &mut c);
    Ok(c)
}

/// The blocks with their loads, the region of their fill and the plan of the load steps.
fn begun(bridge: &Bridge, particles: &Particles) -> Result<(Discretised, FillRegion, Plan), AnalysisError> {
    require_stiffness(bridge)?;
    let mut d = rigid::loaded(discretise(bridge)?)?;
    d.loading.movements.clear();
    let region = d.fill.clone().ok_or(AnalysisError::NoLoad)?;
    let plan = planned(&bridge.plan)?;
    fits(&region, &particles.grains)?;
    Ok((d, region, plan))
}

/// Refuses what [`collapse_filled`] would refuse before it computes.
pub(super) fn ready(bridge: &Bridge, particles: &Particles) -> Result<(), AnalysisError> {
    let (d, region, _) = begun(bridge, particles)?;
    match packing(bridge, &d, &region, particles, &mut Stopping) {
        Ok(_) | Err(PackingError::Stopped) => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Stops a run as soon as it has begun.
struct Stopping;

impl Watch for Stopping {
    fn look(&mut self, _: &Progress) -> Wish {
        Wish::Stop
    }
}

/// The same in the hands of its caller, from the first load on: the fill is packed and at rest, the loading blocks stand on it. None where
/// the onlooker wished to stop.
///
/// # Errors
/// An analysis that cannot be set up, fill that cannot be packed or does not come to rest, or a packing of another region.
pub fn stepping(
    bridge: &Bridge,
    particles: &Particles,
    watch: &mut dyn Watch,
) -> Result<Option<(Discretised, dem::Stepping)>, AnalysisError> {
    let (mut d, region, plan) = begun(bridge, particles)?;
    let grains = match packing(bridge, &d, &region, particles, watch) {
        Ok(grains) => grains,
        Err(PackingError::Stopped) => return Ok(None),
        Err(error) => return Err(error.into()),
    };
    fill(&mut d, &region, &grains);
    let rested = Settled::rest(bridge, &d, &grains, None, watch)?;
    match rested.outcome.status {
        dem::Status::StableToLastLoad => {}
        dem::Status::Cancelled => return Ok(None),
        _ => return Err(AnalysisError::FillNotAtRest { seed: bridge.plan.seed }),
    }
    let lifts = lifts(&d, &rested.frame());
    lift(&mut d, &lifts);
    let model = Model::new(&d.model, &d.loading)?;
    let settings = settings(bridge);
    let state = take_over(&model, &settings, (&rested.model, &rested.outcome.state));
    let run = dem::Stepping::from(model, state, &program(&plan, &d, None, &mut Vec::new())?.0, &settings)?;
    Ok(Some((d, run)))
}

/// Load steps tried where the file gives no limit for a model with particles.
const MOST_STEPS: f64 = 100.0;

/// The plan of a model with particles: limit analysis cannot choose what it leaves open.
pub(super) fn planned(plan: &Plan) -> Result<Plan, AnalysisError> {
    let step = plan.load_step.ok_or(AnalysisError::Missing {
        what: "load_step",
        why: "limit analysis, from which it would be chosen, knows no particles",
    })?;
    Ok(Plan { load_limit: plan.load_limit.or(Some(MOST_STEPS * step)), ..plan.clone() })
}

/// The share that crushing takes off the limit load of the same rings under the same fill as weight.
fn crushing_takes(bridge: &Bridge) -> Option<f64> {
    bridge.masonry.compressive_strength?;
    let own = state::with(bridge, &[Change::ParticlesAsWeight, Change::LoadsThroughCover]);
    let d = rigid::prepared(&own).ok()?;
    let crushing = rigid::single(&own, &d);
    let load = |settings: &limit::Settings| rigid::solve(&d, settings, &CancelToken::default()).ok()?.factor;
    let [with, without] = [load(&crushing)?, load(&limit::Settings { crushing: false, ..crushing })?];
    Some(1.0 - with / without)
}

/// Grows the particles, or takes those of a file.
///
/// # Errors
/// Those of [`pack`]; a saved packing is always had.
pub fn packing(
    bridge: &Bridge,
    d: &Discretised,
    region: &FillRegion,
    particles: &Particles,
    watch: &mut dyn Watch,
) -> Result<Vec<Grain>, PackingError> {
    if !particles.grains.is_empty() {
        return Ok(saved(particles));
    }
    let mould = region.mould(&without_loading_blocks(d));
    Ok(pack(&mould, &region.outline, &region.recipe(bridge, particles), watch)?.grains)
}

/// The particles of a file.
fn saved(particles: &Particles) -> Vec<Grain> {
    let grain = |g: &[f64; 3]| Grain { centre: vec2(g[0], g[1]), radius: g[2] };
    particles.grains.iter().map(grain).collect()
}

/// The blocks with the particles of a file, where it was read.
///
/// # Errors
/// A bridge that cannot be cut into blocks, or a packing of another region.
pub fn as_saved(bridge: &Bridge) -> Result<Discretised, AnalysisError> {
    let mut d = discretise(bridge)?;
    if let (Some(region), Some(particles)) = (d.fill.clone(), &bridge.particles)
        && !particles.grains.is_empty()
    {
        fits(&region, &particles.grains)?;
        fill(&mut d, &region, &saved(particles));
    }
    Ok(d)
}

/// Refuses a packing of another region: the centres of its particles must lie in this one. Each is a centre and a radius [m].
///
/// # Errors
/// How many lie outside, and the first of them.
pub fn fits(region: &FillRegion, grains: &[[f64; 3]]) -> Result<(), AnalysisError> {
    let astray = |g: &&[f64; 3]| !region.holds(vec2(g[0], g[1]));
    match grains.iter().find(astray) {
        None => Ok(()),
        Some(&[x, y, _]) => Err(AnalysisError::ForeignPacking {
            astray: grains.iter().filter(astray).count(),
            count: grains.len(),
            first: [x, y],
        }),
    }
}

/// Puts the particles into the model; each belongs to the layer at its centre.
pub fn fill(d: &mut Discretised, region: &FillRegion, grains: &[Grain]) {
    let particle = |g: &Grain| {
        let layer = region.layer_at(g.centre.y);
        // A layer's density is that of the soil, voids included; a disc stands for the soil around it.
        let share = grains.iter().map(|g| std::f64::consts::PI * g.radius * g.radius).sum::<f64>() / region.area;
        Particle { centre: g.centre, radius: g.radius, density: layer.density / share, group: layer.group }
    };
    d.model.particles = grains.iter().map(particle).collect();
}

/// The model without the blocks that bring loads: they come last.
pub fn without_loading_blocks(d: &Discretised) -> BlockModel {
    let standing = d.origins.iter().filter(|o| !matches!(o, Origin::LoadingBlock { .. })).count();
    let blocks: Table<BlockId, Block> = d.model.blocks.iter().take(standing).cloned().collect();
    BlockModel { blocks, ..d.model.clone() }
}

/// A model at rest before its loads come.
struct Settled {
    model: Model,
    outcome: Rested,
}

impl Settled {
    /// Takes the lid away, lets the ring go, and waits until all rests; or goes on with that.
    fn rest(
        bridge: &Bridge,
        d: &Discretised,
        grains: &[Grain],
        resume: Option<&[u8]>,
        watch: &mut dyn Watch,
    ) -> Result<Settled, AnalysisError> {
        let loading = Loading { permanent: d.loading.permanent.clone(), ..Loading::default() };
        let model = Model::new(&without_loading_blocks(d), &loading)?;
        let settings = settings(bridge);
        let kept = |state: &[u8]| kept::join(&(grains, None::<(Vec<f64>, u64)>), state);
        let stage = "fill and ring come to rest".to_string();
        let told = |progress: &Progress| Progress { stage: stage.clone(), fraction: None, ..progress.clone() };
        let mut part = Retold { watch, kept: Some(&kept), told };
        let outcome = dem::rest(&model, &|| begin(&model, &settings), &settings, resume, &mut part)?;
        Ok(Settled { model, outcome })
    }

    fn frame(&self) -> Frame {
        dem::frame(&self.model, &self.outcome.state)
    }
}

/// How far each loading block must rise or sink to stand on the particles below it [m].
fn lifts(d: &Discretised, frame: &Frame) -> Vec<f64> {
    let blocks = d.origins.pairs().filter(|(_, o)| matches!(o, Origin::LoadingBlock { .. }));
    blocks
        .map(|(id, _)| {
            let (low, high) = d.model.blocks[id].outline.bounds();
            let below =
                frame.particles.iter().filter(|p| p.centre.x > low.x - p.radius && p.centre.x < high.x + p.radius);
            let top = below.map(|p| p.centre.y + p.radius).fold(f64::NEG_INFINITY, f64::max);
            if top.is_finite() { top - low.y } else { 0.0 }
        })
        .collect()
}

/// Moves the loading blocks, and the forces on them.
fn lift(d: &mut Discretised, lifts: &[f64]) {
    let blocks: Vec<BlockId> =
        d.origins.pairs().filter(|(_, o)| matches!(o, Origin::LoadingBlock { .. })).map(|(id, _)| id).collect();
    for (&id, &up) in blocks.iter().zip(lifts) {
        let moved = d.model.blocks[id].outline.vertices().iter().map(|v| *v + vec2(0.0, up)).collect();
        if let Ok(outline) = Polygon::new(moved) {
            d.model.blocks[id].outline = outline;
        }
        for force in d.loading.variable.iter_mut().filter(|f| f.block == id) {
            force.at.y += up;
        }
    }
}

/// What stands in front of a kept state: the grains and, where the loads are on, how far their blocks were lifted [m] and the
/// iterations until then.
type Head = (Vec<Grain>, Option<(Vec<f64>, u64)>);

/// What the particles amount to at rest under their own weight.
fn packing_report(
    bridge: &Bridge,
    d: &Discretised,
    region: &FillRegion,
    grains: &[Grain],
    frame: &Frame,
) -> PackingReport {
    let solid: f64 = grains.iter().map(|g| std::f64::consts::PI * g.radius * g.radius).sum();
    let (mut touching, mut virial) = (0usize, 0.0);
    for c in &frame.particle_contacts {
        let to_partner = |at: Vec2| (c.point - at).norm();
        virial += c.compression * to_partner(frame.particles[c.particle].centre);
        touching += 1;
        if let Body::Particle(other) = c.partner {
            virial += c.compression * to_partner(frame.particles[other].centre);
            touching += 1;
        }
    }
    let sizes = grains.iter().map(|g| 2.0 * g.radius);
    PackingReport {
        grains: grains.iter().map(|g| [g.centre.x, g.centre.y, g.radius]).collect(),
        solid_fraction: solid / region.area,
        coordination: touching as f64 / grains.len() as f64,
        mean_stress: 0.5 * virial / region.area,
        diameters: [sizes.clone().fold(f64::INFINITY, f64::min), sizes.fold(0.0, f64::max)],
        settlement: settlement(d, frame),
        seed: bridge.particles.as_ref().is_some_and(|p| p.grains.is_empty()).then_some(bridge.plan.seed),
    }
}

/// Mean sinking of the particles since they were packed [m].
fn settlement(d: &Discretised, frame: &Frame) -> f64 {
    let sunk = d.model.particles.iter().zip(frame.particles.iter()).map(|(p, now)| p.centre.y - now.centre.y);
    sunk.sum::<f64>() / d.model.particles.len().max(1) as f64
}

/// The result of a run that was stopped while particles grew.
fn stopped(bridge: &Bridge, d: &Discretised) -> Collapse {
    Collapse { status: Status::Cancelled, ..template::of_bridge(bridge, d, By::Dem(None), "discrete elements") }
}

/// The result where ring and fill did not come to rest.
fn not_at_rest(bridge: &Bridge, d: &Discretised, region: &FillRegion, grains: &[Grain], rested: &Settled) -> Collapse {
    let mut c = stopped(bridge, d);
    c.status = ended(rested.outcome.status).0;
    c.packing = Some(packing_report(bridge, d, region, grains, &rested.frame()));
    c
}
