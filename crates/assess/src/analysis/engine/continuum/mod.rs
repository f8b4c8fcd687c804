//! Collapse load by limit analysis where fill and backing are a continuum that yields: two bounds.

mod beside;
pub mod moved;

use crate::analysis::engine::Engine;
use crate::analysis::engine::rigid::{cancelled, draw, loaded, settings};
use crate::analysis::geometry::point;
use crate::analysis::{AnalysisError, notes, parallel, template};
use beside::Beside;
use bridge::{Bridge, ContinuumPlan, Method};
use mechanics::blocks::{Held, ModelError};
use mechanics::limit::continuum::{
    Bounds, BoundsStatus, Like, Setting, Wanted, bound_elsewhere, closer_bounds, collapse_bounds, lower_like,
    upper_like,
};
use mechanics::limit::{Friction, Settings};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::{CancelToken, Watch};
use outcome::collapse::{By, Collapse, FlowRule, LimitReport, Status};
use outcome::picture::{Motion, Picture};
use outcome::soil::{ContinuumReport, Plate, SoilPicture, SoilPressure};
use structure::discretise::continuum::{Earth, LoadedEarth, Strength, earth, loads};
use structure::discretise::dispersal::Strip;
use structure::discretise::{Discretised, discretise};

/// Both bounds of the load on rigid blocks in soil that yields: limit analysis where the fill is a continuum.
pub struct Continuum;

impl Engine for Continuum {
    fn method(&self) -> Method {
        Method::Limit
    }

    fn load(&self, bridge: &Bridge, _: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        found(bridge, true, watch)
    }
}

/// Both bounds with the strength of the file alone: neither the range over shares of it, nor soil that dilates.
///
/// # Errors
/// A bridge without a continuum or without a load, or one of which no bounds can be asked for.
pub fn with_strength_of_the_file(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    found(bridge, false, watch)
}

fn found(bridge: &Bridge, others: bool, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let mut d = loaded(discretise(bridge)?)?;
    d.loading.movements.clear();
    let Some(earth) = earth(bridge, &d)? else { return Err(AnalysisError::NoContinuum) };
    parallel::alone("bounds of the load", true, watch, |token| whole(bridge, &d, &earth, others, token))
}

/// Both bounds and nothing beside them, with the load at a factor of one [N/m].
///
/// # Errors
/// A bridge without a continuum, or one of which no bounds can be asked for.
pub fn bounds_alone(bridge: &Bridge, token: &CancelToken) -> Result<(Bounds, f64), AnalysisError> {
    let d = discretise(bridge)?;
    let Some(earth) = earth(bridge, &d)? else { return Err(AnalysisError::NoContinuum) };
    let loaded = earth.loaded(&d, Strength::of(&earth.plan), &loads(bridge))?;
    let setting = setting(&loaded, &associated(bridge))?;
    Ok((collapse_bounds(&setting, &wanted(&earth.plan), token)?, d.reference_load))
}

/// A bridge whose loads move: its blocks and its soil, which stay.
pub struct Moving<'a> {
    d: &'a Discretised,
    /// The soil.
    pub earth: Earth,
    settings: Settings,
}

impl<'a> Moving<'a> {
    /// Makes the soil once.
    ///
    /// # Errors
    /// A bridge without a continuum, or with something that a continuum does not know.
    pub fn new(bridge: &Bridge, d: &'a Discretised) -> Result<Moving<'a>, AnalysisError> {
        let earth = earth(bridge, d)?.ok_or(AnalysisError::NoContinuum)?;
        Ok(Moving { d, earth, settings: associated(bridge) })
    }

    /// Both bounds of the factor of strips on the surface, within a ratio where the mesh that the file allows reaches it. Where none of
    /// them stands on the fill, nothing can fail.
    ///
    /// # Errors
    /// A strip without length, or regions and blocks of which no bounds can be asked for.
    pub fn bracket(&self, strips: &[Strip], ratio: f64, token: &CancelToken) -> Result<Bracket, AnalysisError> {
        let Some(loaded) = self.loaded(strips)? else { return Ok(Bracket::NOTHING) };
        let wanted = Wanted { ratio, ..wanted(&self.earth.plan) };
        Ok(Bracket::of(collapse_bounds(&setting(&loaded, &self.settings)?, &wanted, token)?))
    }

    /// A lower bound alone, on one mesh as fine as those of others, each so far to the left of the strips [m].
    ///
    /// # Errors
    /// Those of [`bracket`](Self::bracket).
    pub fn beside(
        &self,
        strips: &[Strip],
        others: &[(&Bracket, f64)],
        token: &CancelToken,
    ) -> Result<Bracket, AnalysisError> {
        let Some(loaded) = self.loaded(strips)? else { return Ok(Bracket::NOTHING) };
        let setting = setting(&loaded, &self.settings)?;
        Ok(Bracket::of(lower_like(&setting, &like(others), &wanted(&self.earth.plan), token)?))
    }

    /// An upper bound alone, on a mesh a third as fine.
    ///
    /// # Errors
    /// Those of [`bracket`](Self::bracket).
    pub fn above(
        &self,
        strips: &[Strip],
        others: &[(&Bracket, f64)],
        token: &CancelToken,
    ) -> Result<Option<f64>, AnalysisError> {
        let Some(loaded) = self.loaded(strips)? else { return Ok(None) };
        Ok(upper_like(&setting(&loaded, &self.settings)?, &like(others), &wanted(&self.earth.plan), token)?)
    }

    /// A bracket of the same strips on one finer mesh, or with the upper bound that it lacks; itself where nothing is left to refine.
    ///
    /// # Errors
    /// Those of [`bracket`](Self::bracket).
    pub fn closer(&self, strips: &[Strip], bracket: &Bracket, token: &CancelToken) -> Result<Bracket, AnalysisError> {
        let (Some(bounds), Some(loaded)) = (&bracket.bounds, self.loaded(strips)?) else { return Ok(bracket.clone()) };
        let wanted = Wanted { rounds: 1, ..wanted(&self.earth.plan) };
        Ok(Bracket::of(closer_bounds(&setting(&loaded, &self.settings)?, &wanted, bounds, token)?))
    }

    /// An upper bound of strips from the motion of others.
    ///
    /// # Errors
    /// Those of [`bracket`](Self::bracket).
    pub fn upper_from(&self, strips: &[Strip], other: &Bracket) -> Result<Option<f64>, AnalysisError> {
        let (Some(bounds), Some(loaded)) = (&other.bounds, self.loaded(strips)?) else { return Ok(None) };
        Ok(bound_elsewhere(bounds, self.d.model.blocks.len(), &setting(&loaded, &self.settings)?))
    }

    /// The soil with strips on it; none where they stand beside it.
    fn loaded(&self, strips: &[Strip]) -> Result<Option<LoadedEarth>, AnalysisError> {
        let loaded = self.earth.loaded(self.d, Strength::of(&self.earth.plan), strips)?;
        Ok((!strips.is_empty() && loaded.left_out <= 1.0 - 1e-9).then_some(loaded))
    }
}

/// The meshes of others, and how far to their right the present loads stand.
fn like<'b>(others: &[(&'b Bracket, f64)]) -> Vec<Like<'b>> {
    let mesh = |bracket: &'b Bracket| bracket.bounds.as_ref().map(|bounds| &bounds.mesh);
    others.iter().filter_map(|&(other, shift)| Some(Like { mesh: mesh(other)?, shift })).collect()
}

/// Bounds of a load factor, and how they ended. Without convergence either may stand alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Bracket {
    /// How they ended.
    pub status: Status,
    /// What is carried.
    pub lower: Option<f64>,
    /// What is not.
    pub upper: Option<f64>,
    /// The fields, from which a finer mesh is made.
    pub bounds: Option<Box<Bounds>>,
}

impl Bracket {
    /// Of loads that do not stand on the soil.
    const NOTHING: Bracket = Bracket { status: Status::Locks, lower: None, upper: None, bounds: None };

    fn of(found: Bounds) -> Bracket {
        let (lower, upper) = (found.lower.as_ref().map(|l| l.factor), found.upper.as_ref().map(|u| u.factor));
        Bracket { status: status(&found), lower, upper, bounds: Some(Box::new(found)) }
    }

    /// Triangles of its last mesh.
    pub fn elements(&self) -> usize {
        self.bounds.as_ref().map_or(0, |bounds| bounds.mesh.triangles.len())
    }
}

/// What bounds are asked of.
fn setting<'l>(loaded: &'l LoadedEarth, settings: &Settings) -> Result<Setting<'l>, ModelError> {
    Setting::new(&loaded.model, &loaded.loading, settings, &loaded.continuum)
}

/// Blocks beside a continuum slide as they dilate: so much is a convex program.
fn associated(bridge: &Bridge) -> Settings {
    Settings { friction: Friction::Associated, ..settings(bridge) }
}

fn wanted(plan: &ContinuumPlan) -> Wanted {
    Wanted { ratio: plan.bound_ratio, elements: plan.elements, ..Wanted::default() }
}

pub(in crate::analysis) fn whole(
    bridge: &Bridge,
    d: &Discretised,
    earth: &Earth,
    others: bool,
    token: &CancelToken,
) -> Result<Collapse, AnalysisError> {
    let plan = &earth.plan;
    let (settings, wanted) = (associated(bridge), wanted(plan));
    let strips = loads(bridge);
    let loaded = earth.loaded(d, Strength::of(plan), &strips)?;
    let bounds = collapse_bounds(&setting(&loaded, &settings)?, &wanted, &token.part(0, 2))?;
    let report = ContinuumReport { left_out: loaded.left_out, ..described(d, plan, &bounds) };
    let report = match others && bounds.status == BoundsStatus::Bounded {
        true => Beside { d, earth, settings, strips: &strips, bounds: &bounds, token }.reported(report)?,
        false => report,
    };
    let found = reported(bridge, d, &loaded, &bounds, report);
    Ok(if !token.is_cancelled() { found } else { cancelled(bridge, d, By::Limit(LimitReport::default())) })
}

fn described(d: &Discretised, plan: &ContinuumPlan, bounds: &Bounds) -> ContinuumReport {
    let load = |factor: Option<f64>| factor.map(|f| d.load(f));
    ContinuumReport {
        elements: bounds.mesh.triangles.len(),
        bound_ratio: bounds.ratio(),
        wanted_ratio: plan.bound_ratio,
        mobilised_share: plan.mobilised_share,
        dilatancy_angle: plan.dilatancy_angle,
        permanent_share: bounds.share,
        carried_share: bounds.carried,
        flow_violation: bounds.upper.as_ref().map(|u| u.flow_violation),
        rounds: bounds.rounds.iter().map(|r| (r.elements, load(r.lower), load(r.upper))).collect(),
        ..ContinuumReport::default()
    }
}

/// How bounds ended, for an engineer.
fn status(bounds: &Bounds) -> Status {
    match bounds.status {
        BoundsStatus::Bounded | BoundsStatus::LowerAlone => Status::Collapsed,
        BoundsStatus::NoEquilibrium => Status::UnstableUnderSelfWeight,
        BoundsStatus::Locks => Status::Locks,
        BoundsStatus::NotConverged => Status::NotConverged,
        BoundsStatus::Cancelled => Status::Cancelled,
    }
}

fn reported(
    bridge: &Bridge,
    d: &Discretised,
    loaded: &LoadedEarth,
    bounds: &Bounds,
    report: ContinuumReport,
) -> Collapse {
    let mut c = template::of_bridge(bridge, d, By::Limit(LimitReport::default()), "limit analysis with a continuum");
    // Loads stand on the soil: they reach no block by a rule.
    c.picture.loads.clear();
    if bounds.status == BoundsStatus::Bounded {
        draw(d, &bounds.blocks, &mut c.picture);
        moved(d, loaded, bounds, &mut c.picture);
    }
    c.status = status(bounds);
    // Of a bridge that does not stand the stresses carry a share of its weight, and no load.
    let stands = c.status != Status::UnstableUnderSelfWeight;
    let lower = bounds.lower.as_ref().filter(|_| stands).map(|l| d.load(l.factor));
    let upper = bounds.upper.as_ref().filter(|_| stands).map(|u| d.load(u.factor));
    if c.status == Status::Collapsed {
        (c.last_stable_load, c.limit_load, c.collapse_load) = (lower, lower, upper);
    }
    c.contacts = bounds.blocks.interfaces.iter().map(|i| i.points.len()).sum();
    c.tolerance = report.wanted_ratio - 1.0;
    c.by = By::Limit(LimitReport {
        friction: FlowRule::Associated,
        lower_bound: lower,
        upper_bound: upper,
        equilibrium_residual: bounds.lower.as_ref().map(|l| l.equilibrium_residual),
        yield_violation: bounds.lower.as_ref().map(|l| l.yield_violation),
        iterations: bounds.blocks.iterations,
        continuum: Some(Box::new(report)),
        ..LimitReport::default()
    });
    notes::continuum(bridge, d, &mut c);
    c
}

/// Soil and blocks as they move in the mechanism, in one scale, and the stresses that are carried.
fn moved(d: &Discretised, loaded: &LoadedEarth, bounds: &Bounds, drawn: &mut Picture) {
    let (Some(below), Some(above)) = (&bounds.lower, &bounds.upper) else { return };
    let count = d.model.blocks.len();
    let corners = &above.velocities[..bounds.mesh.points.len()];
    let of_blocks = bounds.motions.iter().map(|(v, _)| v.norm());
    let fastest = corners.iter().map(|v| v.norm()).chain(of_blocks).fold(f64::MIN_POSITIVE, f64::max);
    let scale = 1.0 / fastest;
    let motion = |&(v, w): &(Vec2, f64)| Motion { translation: point(v * scale), rotation: w * scale };
    drawn.mechanism = Some(bounds.motions.iter().take(count).map(motion).collect());
    let densities: Vec<f64> =
        above.dissipation.iter().enumerate().map(|(t, power)| power.max(0.0) / bounds.mesh.area(t)).collect();
    let most = densities.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let gap = bounds.gaps.iter().map(|g| g.max(0.0)).sum::<f64>().max(f64::MIN_POSITIVE);
    let plate = |(id, block): (mechanics::ids::BlockId, &mechanics::blocks::Block)| {
        let (v, w) = bounds.motions[id];
        let (low, high) = block.outline.bounds();
        let ends = [vec2(low.x, low.y), vec2(high.x, low.y)];
        let centre = block.outline.centroid();
        Plate { ends: ends.map(point), motions: ends.map(|p| point((v + (p - centre).left() * w) * scale)) }
    };
    let plates = loaded.model.blocks.pairs().skip(count).filter(|(_, b)| b.held != Held::FIXED).map(plate);
    let pressures = bounds.pressures.iter().filter(|p| (p.block.0 as usize) < count).map(|p| SoilPressure {
        block: p.block.0 as usize,
        ends: p.ends.map(point),
        pressure: p.pressure,
        shear: p.shear,
    });
    drawn.soil = Some(SoilPicture {
        points: bounds.mesh.points.iter().map(|&p| point(p)).collect(),
        triangles: bounds.mesh.triangles.clone(),
        regions: bounds.mesh.regions.clone(),
        stresses: below.stresses.clone(),
        motions: corners.iter().map(|&v| point(v * scale)).collect(),
        dissipation: densities.iter().map(|p| p / most).collect(),
        gaps: bounds.gaps.iter().map(|g| g.max(0.0) / gap).collect(),
        pressures: pressures.collect(),
        plates: plates.collect(),
    });
}
