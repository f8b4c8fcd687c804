//! The loads of the file at every position on deformable joints: beside the factor of rigid blocks, and the smaller one counts.
//!
//! Likely at a position are the run of axles that governs for rigid blocks, and all axles. At the worst one every run is followed.

use super::super::AnalysisError;
use super::super::deforming::along::{Found, Moves, Places, along};
use super::super::deforming::{Bound, Deforming};
use super::super::engine::joints::require_stiffness;
use super::{Case, Row, Scene};
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
    scene: &Scene<'_>,
    (rows, step): (&mut Vec<Row>, f64),
    found: &mut Sweep,
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    require_stiffness(scene.bridge)?;
    let deforming = [Deforming::new(scene.bridge, scene.d, watch)?];
    if !deforming[0].stands() {
        let falls = deforming[0].falls();
        found.points.iter_mut().for_each(|point| unknown(point, falls));
        let told = if falls { warning::Loads::FallsOnDeformableJoints } else { warning::Loads::SelfWeightNotFound };
        found.warnings.push(told.into());
        return Ok(true);
    }
    let lowest = rows.iter().filter_map(rigid).min_by(f64::total_cmp);
    let bounds = rows.iter().map(|row| Bound::of(rigid(row), lowest).or_else(|| asked(scene, row))).collect();
    let places = Places { deforming: &deforming, bounds, step, in_service: None };
    let (mut all, mut whole) = along(&[Loads { scene, rows, places }], watch);
    let Some(own) = all.pop() else { return Ok(false) };
    // The worst position, where it lies between the others.
    if let Some(best) = own.answers.get(rows.len()).and_then(Option::as_ref).map(|best| best.case)
        && rows.iter().all(|row| row.position != best.position)
    {
        let (row, done) = scene.answered_again(best.position, watch);
        rows.push(row);
        whole &= done;
    }
    put(scene, rows, &own, found);
    Ok(whole)
}

/// How far loads are followed where rigid blocks lock at every position: as far as the file asks, and no further than many times what the bridge weighs.
fn asked(scene: &Scene<'_>, row: &Row) -> Option<Bound> {
    let force = row.cases.iter().map(|case| case.force).fold(0.0, f64::max);
    let many = MANY * scene.d.model.free_weight();
    let limit = scene.bridge.plan.load_limit.map_or(many, |limit| limit.min(many));
    (force > 0.0).then(|| Bound::below(limit / force))
}

fn unknown(point: &mut SweepPoint, falls: bool) {
    (point.rigid_factor, point.load_factor_at_most) = (point.load_factor, point.bound().filter(|_| !falls));
    let status = if falls { Status::UnstableUnderSelfWeight } else { Status::NotConverged };
    (point.load_factor, point.collapse_load, point.status) = (None, None, status);
}

/// A run of neighbouring axles at a position [m].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Run {
    position: f64,
    axles: [usize; 2],
}

struct Loads<'a> {
    scene: &'a Scene<'a>,
    rows: &'a [Row],
    places: Places<'a>,
}

impl Loads<'_> {
    fn row(&self, position: f64) -> Row {
        self.rows.iter().find(|row| row.position == position).cloned().unwrap_or_else(|| self.scene.row(position))
    }
}

impl Moves for Loads<'_> {
    type Case = Run;

    fn places(&self) -> &Places<'_> {
        &self.places
    }

    fn likely(&self, place: usize) -> Vec<Run> {
        let row = &self.rows[place];
        let factor = |case: &&Case| case.factor.unwrap_or(f64::INFINITY);
        let governs = row.cases.iter().min_by(|a, b| factor(a).total_cmp(&factor(b)));
        let all = row.cases.iter().max_by(|a, b| a.force.total_cmp(&b.force));
        let mut runs: Vec<Run> =
            governs.into_iter().chain(all).map(|case| Run { position: row.position, axles: case.axles }).collect();
        runs.dedup();
        runs
    }

    fn like(&self, run: &Run, place: usize) -> Option<Run> {
        let row = &self.rows[place];
        let stands = row.cases.iter().any(|case| case.axles == run.axles);
        stands.then_some(Run { position: row.position, ..*run })
    }

    fn shifted(&self, run: &Run, by: f64) -> Run {
        Run { position: run.position + by, ..*run }
    }

    fn varied(&self, run: &Run) -> Vec<Run> {
        let cases = self.row(run.position).cases.into_iter();
        cases.map(|case| Run { axles: case.axles, ..*run }).filter(|other| other != run).collect()
    }

    fn forces(&self, run: &Run) -> Option<(Vec<PointForce>, usize)> {
        let mut cases = self.row(run.position).cases.into_iter();
        cases.find(|case| case.axles == run.axles).map(|case| (case.forces, 0))
    }

    fn position(run: &Run) -> f64 {
        run.position
    }
}

/// The least factor of rigid blocks.
fn rigid(row: &Row) -> Option<f64> {
    row.cases.iter().filter_map(|case| case.factor).min_by(f64::total_cmp)
}

/// Both factors of every position, and what is to be said of them.
fn put(scene: &Scene<'_>, rows: &[Row], own: &Found<Run>, found: &mut Sweep) {
    found.points = rows.iter().map(|row| scene.point(row)).collect();
    for (point, row) in found.points.iter_mut().zip(rows) {
        point.rigid_factor = point.load_factor;
        let here = own.answers.iter().flatten().filter(|answer| answer.case.position == row.position);
        let Some(least) = here.min_by(|a, b| a.found.factor.total_cmp(&b.found.factor)) else { continue };
        let (factor, axles) = (least.found.factor, least.case.axles);
        let force = row.cases.iter().find(|case| case.axles == axles).map_or(0.0, |case| case.force);
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
