//! The loads of the file at every position on deformable joints: beside the factor of rigid blocks, and the smaller one counts.
//!
//! Likely at a position are the run of axles that governs for rigid blocks, and all axles. At the worst one every run is followed.

use super::super::AnalysisError;
use super::super::deforming::along::{Found, Moves, Places, along};
use super::super::deforming::{Bound, at_rest};
use super::super::engine::joints::require_stiffness;
use super::super::moving::{Place, Scene};
use super::super::parallel::{self, Stage};
use super::Loads;
use mechanics::blocks::PointForce;
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::note;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning;

/// Loads of so many times the weight of the bridge are not asked for where nothing bounds them.
const MANY: f64 = 20.0;

/// Puts the factors of deformable joints beside those of rigid blocks. Tells whether all of it was done.
pub(super) fn beside(
    scene: &Scene<'_, Loads<'_>>,
    (rows, step): (&mut Vec<Place>, f64),
    found: &mut Sweep,
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    let loads = scene.stands;
    require_stiffness(loads.bridge)?;
    let grounds = [at_rest(loads.bridge, loads.d, watch)?];
    if !grounds[0].stands() {
        let falls = grounds[0].falls();
        found.points.iter_mut().for_each(|point| unknown(point, falls));
        let told = if falls { warning::Loads::FallsOnDeformableJoints } else { warning::Loads::SelfWeightNotFound };
        found.warnings.push(told.into());
        return Ok(true);
    }
    let lowest = rows.iter().filter_map(rigid).min_by(f64::total_cmp);
    let bounds = rows.iter().map(|row| Bound::of(rigid(row), lowest).or_else(|| asked(loads, row))).collect();
    let places = Places { grounds: &grounds, bounds, step, in_service: None };
    let (mut all, mut whole) = along(&[Moved { loads, rows, places }], watch);
    let Some(own) = all.pop() else { return Ok(false) };
    // The worst position, where it lies between the others.
    if let Some(best) = own.answers.get(rows.len()).and_then(Option::as_ref).map(|best| best.case)
        && rows.iter().all(|row| row.at.position != best.position)
    {
        let stage = Stage { name: "runs of axles at the worst place", steps: 1, shares: [1.0, 1.0] };
        let (row, done) = parallel::each(&[best.position], &stage, watch, |&at, token| scene.by_itself(at, token));
        rows.extend(row.into_iter().flatten().flatten());
        whole &= done;
    }
    put(loads, rows, &own, found);
    Ok(whole)
}

/// How far loads are followed where rigid blocks lock at every position: as far as the file asks, and no further than many times what the bridge weighs.
fn asked(loads: &Loads<'_>, row: &Place) -> Option<Bound> {
    let force = loads.runs(row.at.position).iter().map(|run| run.force).fold(0.0, f64::max);
    let many = MANY * loads.d.model.free_weight();
    let limit = loads.bridge.plan.load_limit.map_or(many, |limit| limit.min(many));
    (force > 0.0).then(|| Bound::below(limit / force))
}

fn unknown(point: &mut SweepPoint, falls: bool) {
    (point.rigid_factor, point.load_factor_at_most) = (point.load_factor, point.bound().filter(|_| !falls));
    let status = if falls { Status::UnstableUnderSelfWeight } else { Status::NotConverged };
    (point.load_factor, point.collapse_load, point.status) = (None, None, status);
}

/// A run of neighbouring axles at a position [m].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stood {
    position: f64,
    axles: [usize; 2],
}

struct Moved<'a> {
    loads: &'a Loads<'a>,
    rows: &'a [Place],
    places: Places<'a>,
}

impl Moves for Moved<'_> {
    type Case = Stood;

    fn places(&self) -> &Places<'_> {
        &self.places
    }

    fn likely(&self, place: usize) -> Vec<Stood> {
        let row = &self.rows[place];
        let position = row.at.position;
        let runs = self.loads.runs(position);
        let all = runs.iter().max_by(|a, b| a.force.total_cmp(&b.force)).map(|run| run.axles);
        let governs = row.least.map_or(runs.first().map(|run| run.axles), |least| least.key.axles);
        let mut stood: Vec<Stood> = governs.into_iter().chain(all).map(|axles| Stood { position, axles }).collect();
        stood.dedup();
        stood
    }

    fn like(&self, stood: &Stood, place: usize) -> Option<Stood> {
        let position = self.rows[place].at.position;
        let stands = self.loads.runs(position).iter().any(|run| run.axles == stood.axles);
        stands.then_some(Stood { position, ..*stood })
    }

    fn shifted(&self, stood: &Stood, by: f64) -> Stood {
        Stood { position: stood.position + by, ..*stood }
    }

    fn varied(&self, stood: &Stood) -> Vec<Stood> {
        let runs = self.loads.runs(stood.position).into_iter();
        runs.map(|run| Stood { axles: run.axles, ..*stood }).filter(|other| other != stood).collect()
    }

    fn forces(&self, stood: &Stood) -> Option<(Vec<PointForce>, usize)> {
        let mut runs = self.loads.runs(stood.position).into_iter();
        runs.find(|run| run.axles == stood.axles).map(|run| (run.forces, 0))
    }

    fn position(stood: &Stood) -> f64 {
        stood.position
    }
}

/// The least factor of rigid blocks.
fn rigid(row: &Place) -> Option<f64> {
    row.least.map(|least| least.factor)
}

/// Both factors of every position, and what is to be said of them.
fn put(loads: &Loads<'_>, rows: &[Place], own: &Found<Stood>, found: &mut Sweep) {
    found.points = rows.iter().map(|row| loads.point(row)).collect();
    for (point, row) in found.points.iter_mut().zip(rows) {
        point.rigid_factor = point.load_factor;
        let here = own.answers.iter().flatten().filter(|answer| answer.case.position == row.at.position);
        let Some(least) = here.min_by(|a, b| a.found.factor.total_cmp(&b.found.factor)) else { continue };
        let (factor, axles) = (least.found.factor, least.case.axles);
        let force = loads.force(row.at.position, axles);
        point.deformable_factor = Some(factor);
        if point.bound().is_none_or(|bound| factor < bound) {
            (point.axles, point.collapse_load) = (axles, Some(factor * force));
            match point.load_factor_at_most.is_some() {
                true => (point.load_factor_at_most, point.collapse_load) = (Some(factor), None),
                false => (point.load_factor, point.status) = (Some(factor), Status::Collapsed),
            }
        }
    }
    let open = own.broken_off();
    if open > 0 {
        found.warnings.push(warning::Loads::PathsBrokenOff { positions: open, of: rows.len() }.into());
    }
    found.assumptions.push(note::Moving::DeformableJoints.into());
}
