//! Limit analysis with the loads moved over the bridge.
//!
//! The loads of the file are one vehicle without factors under the search of `moving`, with an answer without dilation at every position, each as
//! by an analysis of these loads by themselves. With the equilibrium path as the plan's method, `deformable` puts the factors of deformable
//! joints beside them; on fill that yields, `continuum` puts bounds in their place.

mod continuum;
mod deformable;

use super::engine::rigid;
use super::moving::{DILATANCY, Key, Line, Place, Scene, Stands, Tried, WithoutDilation, runs, search};
use super::{AnalysisError, default_stiffness, policy};
use bridge::{Bridge, LoadKind};
use mechanics::blocks::PointForce;
use mechanics::limit::{self, Effect, Friction, Ground, Sweeper};
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::note;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning::{self, Warning};
use structure::discretise::continuum::{loads, wanted};
use structure::discretise::dispersal::{self, Strip};
use structure::discretise::{Discretised, bridge_length};

/// Where the first load's reference point stands [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Places {
    /// At one place.
    At(f64),
    /// At so many places in equal steps, both ends included; the worst one is then sought between them.
    Between([f64; 2], usize),
    /// At this distance, until every axle has crossed the bridge; the worst one is then sought between them.
    Every(f64),
}

impl Places {
    fn list(self, bridge: &Bridge, first: f64) -> Vec<f64> {
        match self {
            Places::At(place) => vec![place],
            Places::Between([from, to], count) => {
                let last = count.max(2) - 1;
                (0..=last).map(|k| from + (to - from) * k as f64 / last as f64).collect()
            }
            Places::Every(step) => {
                let ends = crossing(bridge, first);
                let count = ((ends[1] - ends[0]) / step - 1e-9).ceil().clamp(1.0, MOST_POSITIONS) as usize;
                Places::Between(ends, count + 1).list(bridge, first)
            }
        }
    }
}

/// Places of the first load's reference point [m] between which a load stands on the bridge.
pub(super) fn crossing(bridge: &Bridge, first: f64) -> [f64; 2] {
    let ahead: Vec<f64> = loads(bridge).iter().map(|strip| strip.middle - first).collect();
    let most = ahead.iter().copied().fold(0.0, f64::max);
    let least = ahead.iter().copied().fold(0.0, f64::min);
    [-most, bridge_length(bridge) - least]
}

/// More positions than this are no sweep but a slip of a unit.
const MOST_POSITIONS: f64 = 1e5;

/// Moves all loads of the file together. With `subsets`, every run of neighbouring axles is tried: an axle on the far side of an
/// arch can help it. Positions are independent, so results do not depend on the number of threads. Where the onlooker wishes
/// to stop, the positions answered by then are returned.
///
/// # Errors
/// No load, one that stands on a loading block, or a bridge that cannot be analysed.
pub fn sweep(bridge: &Bridge, places: Places, subsets: bool, watch: &mut dyn Watch) -> Result<Sweep, AnalysisError> {
    policy::swept(bridge, places, watch, &|state, places, watch| as_described(state, places, subsets, watch))
}

/// The same on one state of the bridge.
fn as_described(bridge: &Bridge, places: Places, subsets: bool, watch: &mut dyn Watch) -> Result<Sweep, AnalysisError> {
    let first = bridge.loads.first().ok_or(AnalysisError::NoLoad)?.position;
    if bridge.loads.iter().any(|load| load.block.is_some()) {
        return Err(AnalysisError::MovedBlock);
    }
    let list = places.list(bridge, first);
    let own = default_stiffness::for_paths(bridge);
    let (bridge, taken) = (own.as_ref().map_or(bridge, |own| &own.0), own.as_ref().and_then(|own| own.1.clone()));
    let mut d = rigid::prepared(bridge)?;
    d.loading.variable.clear();
    let settings = rigid::single(bridge, &d);
    let dilatant = limit::Settings { friction: Friction::Associated, ..settings };
    let grounds = [Ground::new(&d.model, &d.loading, &dilatant)?];
    let vehicle = bridge.loads.iter().any(|l| matches!(l.kind, LoadKind::Axles { .. }));
    let loads = Loads { bridge, d: &d, first, subsets: subsets && vehicle };
    let without_dilation = WithoutDilation::Everywhere(settings.friction);
    let scene = Scene { stands: &loads, grounds: &grounds, watched: &[], screen: false, seeds: &[], without_dilation };
    let step = if list.len() > 1 { list[1] - list[0] } else { 0.0 };
    let yields = wanted(bridge).is_some() && !bridge.plan.method.follows_moving_loads();
    let line = Line { vehicle: 0, positions: &list, alike: false };
    let finest = if yields { 0.0 } else { step };
    let Some(rigid) = search(&scene, (&[line], 1), finest, watch).pop() else { return Err(AnalysisError::NoLoad) };
    // Places between the positions count where they are new.
    let positions = rigid.places.len() - rigid.between;
    let is_new = |row: &Place| list.iter().all(|place| *place != row.at.position);
    let rows = rigid.places.into_iter().enumerate().filter(|(k, row)| *k < positions || is_new(row));
    let mut rows: Vec<Place> = rows.map(|(_, row)| row).collect();
    let points: Vec<SweepPoint> = rows.iter().map(|row| loads.point(row)).collect();
    let (not_counted, whole) = (Default::default(), rigid.whole);
    let mut found =
        Sweep { points, governing: None, step, whole, not_counted, warnings: Vec::new(), assumptions: Vec::new() };
    if whole && yields {
        found.whole = continuum::instead(&loads, &rows, &mut found, watch)?;
    }
    if whole && bridge.plan.method.follows_moving_loads() {
        found.whole = deformable::beside(&scene, (&mut rows, step), &mut found, watch)?;
    }
    found.points.sort_by(|a, b| a.position.total_cmp(&b.position));
    let bounds = found.points.iter().enumerate().filter_map(|(k, p)| p.bound().map(|f| (k, f)));
    found.governing = bounds.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k);
    if !yields {
        notes(&mut found, &rows);
        found.warnings.extend(comes_and_goes(&found, &rows));
    }
    found.assumptions.extend(super::notes::particles_as_weight(bridge));
    found.warnings.extend(taken);
    Ok(found)
}

fn notes(found: &mut Sweep, rows: &[Place]) {
    if !found.is_deformable() {
        found.assumptions.push(note::Moving::RigidAlone.into());
    }
    let open = found.positions_not_converged();
    if open > 0 {
        let at_most = found.worst().and_then(SweepPoint::bound);
        let told = warning::Loads::PositionsOpen { positions: open, of: found.points.len(), at_most };
        found.warnings.push(told.into());
    }
    if found.step > 0.0 {
        found.assumptions.push(note::Moving::Positions { apart: found.step }.into());
    }
    let slides = |tried: &Tried| tried.level.as_ref().is_some_and(|level| level.friction == Friction::NonAssociated);
    if rows.iter().flat_map(|row| &row.tried).any(slides) {
        found.assumptions.push(note::Moving::WithoutDilation { times: DILATANCY }.into());
    }
    let proven: usize = rows.iter().filter(|row| row.settled.is_some()).map(|row| row.open.len()).sum();
    if proven > 0 {
        found.assumptions.push(note::Moving::Proven { cases: proven }.into());
    }
}

/// Says so where the load of the worst place comes and goes.
fn comes_and_goes(found: &Sweep, rows: &[Place]) -> Option<Warning> {
    let worst = found.worst()?;
    let of_case = |tried: &Tried| {
        let level = tried.level.as_ref().filter(|_| tried.key.axles == Some(worst.axles))?;
        let (most, least, per_factor) = (level.factor?, level.falls_to?, worst.collapse_load? / worst.load_factor?);
        Some(warning::Joints::ComesAndGoes { least: per_factor * least, most: per_factor * most }.into())
    };
    rows.iter().filter(|row| row.at.position == worst.position).flat_map(|row| &row.tried).find_map(of_case)
}

/// The loads of a file as one vehicle: its axles are the loads' strips, in the order of the file.
struct Loads<'a> {
    bridge: &'a Bridge,
    d: &'a Discretised,
    /// Reference point of the first load as the file places it [m].
    first: f64,
    /// Whether every run of neighbouring axles is tried.
    subsets: bool,
}

/// A run of neighbouring axles at a position.
struct Run {
    axles: [usize; 2],
    /// What they weigh [N/m].
    force: f64,
    /// On the blocks.
    forces: Vec<PointForce>,
}

impl Loads<'_> {
    /// How many axles there are.
    fn axles(&self) -> usize {
        loads(self.bridge).len()
    }

    /// What stands on the road with the first load at a position [m].
    fn strips(&self, position: f64) -> Vec<Strip> {
        let offset = position - self.first;
        self.bridge.loads.iter().flat_map(|load| dispersal::strips(load, offset)).collect()
    }

    /// Every run with the first load at a position [m] of which anything reaches the blocks.
    fn runs(&self, position: f64) -> Vec<Run> {
        let spread = |strip| self.d.spread(self.bridge, strip);
        let spreads: Vec<_> = self.strips(position).into_iter().map(spread).collect();
        let run = |axles: [usize; 2]| {
            let chosen = &spreads[axles[0]..=axles[1]];
            let forces: Vec<_> = chosen.iter().flat_map(|s| s.forces.iter().copied()).collect();
            let force = chosen.iter().map(|s| s.strip.force).sum();
            (!forces.is_empty()).then_some(Run { axles, force, forces })
        };
        runs(spreads.len(), self.subsets).into_iter().filter_map(run).collect()
    }

    /// What a run weighs at a position [N/m].
    fn force(&self, position: f64, axles: [usize; 2]) -> f64 {
        self.runs(position).into_iter().find(|run| run.axles == axles).map_or(0.0, |run| run.force)
    }

    /// The worst case of a place.
    fn point(&self, row: &Place) -> SweepPoint {
        let ended = |status| row.tried.iter().any(|tried| tried.status() == status);
        let worst = row.least.map(|least| least.key.axles);
        let first = row.tried.first().map_or(Status::Locks, |tried| rigid::status(tried.status()));
        let status = match row.least {
            _ if row.settled.is_some() => Status::Collapsed,
            _ if !row.open.is_empty() => Status::NotConverged,
            _ if ended(limit::Status::Cancelled) => Status::Cancelled,
            Some(_) => Status::Collapsed,
            None => first,
        };
        let answered = status == Status::Collapsed;
        let factor = row.settled.or(row.least.map(|least| least.factor));
        let axles = worst.or(row.open.first().map(|(key, _)| key.axles)).flatten();
        let force = axles.map(|axles| self.force(row.at.position, axles));
        SweepPoint {
            offset: row.at.position - self.first,
            position: row.at.position,
            status,
            load_factor: factor.filter(|_| answered),
            load_factor_at_most: factor.filter(|_| !answered),
            collapse_load: factor.zip(force).filter(|_| answered).map(|(factor, force)| factor * force),
            axles: axles.filter(|_| factor.is_some()).unwrap_or([0, self.axles().saturating_sub(1)]),
            rigid_factor: None,
            deformable_factor: None,
            upper_factor: None,
        }
    }
}

impl Stands for Loads<'_> {
    fn cases(&self, sweeper: &mut Sweeper<'_>, drive: usize, position: f64) -> Vec<(Key, Effect)> {
        let case = |run: Run| (Key { axles: Some(run.axles), ..Key::at(drive, position) }, sweeper.effect(&run.forces));
        self.runs(position).into_iter().map(case).collect()
    }
}
