//! The loads of the file at every position on deformable joints: beside the factor of rigid blocks, and the smaller one counts.
//!
//! At every position up to three cases are followed: the run of axles that governs for rigid blocks, all axles, and the run that
//! governed at the position before. At the worst position all runs are, once it has been sought between the positions.

use super::super::AnalysisError;
use super::super::deforming::{Asked, Bound, Deforming, Followed};
use super::super::engine::joints::require_stiffness;
use super::super::parallel::{self, Stage};
use super::super::vehicles::REFINEMENTS;
use super::{CHUNK, Case, Row, Scene};
use mechanics::path::Sweeper;
use mechanics::watch::{CancelToken, Watch};
use outcome::collapse::Status;
use outcome::note;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning;

/// Factors of cases are not known to be better than this.
const SAME: f64 = 1e-4;

/// Loads of so many times the weight of the bridge are not asked for where nothing bounds them.
const MANY: f64 = 20.0;

/// The least case of a row.
#[derive(Debug, Clone, Copy)]
struct Least {
    /// Which row.
    row: usize,
    axles: [usize; 2],
    force: f64,
    factor: f64,
    broken_off: bool,
}

/// Puts the factors of deformable joints beside those of rigid blocks. Tells whether all of it was done.
pub(super) fn beside(
    scene: &Scene<'_>,
    (rows, step): (&mut Vec<Row>, f64),
    found: &mut Sweep,
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    require_stiffness(scene.bridge)?;
    let deforming = Deforming::new(scene.bridge, scene.d, watch)?;
    if !deforming.stands() {
        let falls = deforming.falls();
        found.points.iter_mut().for_each(|point| unknown(point, falls));
        let told = if falls { warning::Loads::FallsOnDeformableJoints } else { warning::Loads::SelfWeightNotFound };
        found.warnings.push(told.into());
        return Ok(true);
    }
    let along = Along { scene, deforming: &deforming };
    let (mut least, mut whole) = along.everywhere(rows, watch);
    if whole && step > 0.0 {
        whole = along.refined(rows, &mut least, step, watch);
    }
    put(scene, rows, &least, found);
    Ok(whole)
}

fn unknown(point: &mut SweepPoint, falls: bool) {
    (point.rigid_factor, point.load_factor_at_most) = (point.load_factor, point.bound().filter(|_| !falls));
    let status = if falls { Status::UnstableUnderSelfWeight } else { Status::NotConverged };
    (point.load_factor, point.collapse_load, point.status) = (None, None, status);
}

struct Along<'a> {
    scene: &'a Scene<'a>,
    deforming: &'a Deforming,
}

impl Along<'_> {
    /// The least factor of every row, in their order.
    fn everywhere(&self, rows: &[Row], watch: &mut dyn Watch) -> (Vec<Least>, bool) {
        let jobs: Vec<(usize, &[Row])> = rows.chunks(CHUNK).enumerate().map(|(k, rows)| (k * CHUNK, rows)).collect();
        let stage = Stage { name: "positions on deformable joints", steps: rows.len() as u64, shares: [0.0, 0.9] };
        let lowest = rows.iter().filter_map(rigid).min_by(f64::total_cmp);
        let (found, done) = parallel::each(&jobs, &stage, watch, |(first, rows), token| {
            let mut sweeper = self.deforming.sweeper();
            let mut before = None;
            let each = rows.iter().enumerate().map(|(k, row)| {
                let bound = Bound::of(rigid(row), lowest).or_else(|| self.asked(row))?;
                let least = self.least(&mut sweeper, first + k, &likely(row, before), bound, token);
                before = least.map(|least| least.axles);
                token.step();
                least
            });
            each.collect::<Vec<_>>()
        });
        (found.into_iter().flatten().flatten().flatten().collect(), done)
    }

    /// How far loads are followed where rigid blocks lock at every position: as far as the file asks, and no further than many times what the bridge weighs.
    fn asked(&self, row: &Row) -> Option<Bound> {
        let force = row.cases.iter().map(|case| case.force).fold(0.0, f64::max);
        let many = MANY * self.scene.d.model.free_weight();
        let limit = self.scene.bridge.plan.load_limit.map_or(many, |limit| limit.min(many));
        (force > 0.0).then(|| Bound::below(limit / force))
    }

    /// The least factor of some cases of a row below a bound.
    fn least(
        &self,
        sweeper: &mut Sweeper<'_>,
        row: usize,
        cases: &[&Case],
        mut bound: Bound,
        token: &CancelToken,
    ) -> Option<Least> {
        let mut least = None;
        for case in cases {
            let asked = Asked { bound, service: None };
            let Some(found) = self.deforming.follow(sweeper, &case.forces, asked, token) else { continue };
            let Followed { factor, broken_off } = found;
            least = Some(Least { row, axles: case.axles, force: case.force, factor, broken_off });
            bound = Bound::below(factor * (1.0 - SAME));
        }
        least
    }

    /// Seeks the worst position between the positions with the axles that govern, then answers it with all runs of axles. Tells
    /// whether the work was done.
    fn refined(&self, rows: &mut Vec<Row>, least: &mut Vec<Least>, step: f64, watch: &mut dyn Watch) -> bool {
        let worst = |all: &[Least]| all.iter().copied().min_by(|a, b| a.factor.total_cmp(&b.factor));
        let Some(mut best) = worst(least) else { return true };
        let started = rows[best.row].position;
        let (mut position, mut width) = (started, step);
        for round in 0..REFINEMENTS {
            let places: Vec<f64> = (-10..=10).map(|k| position + 0.1 * width * f64::from(k)).collect();
            let share = |round: usize| 0.9 + 0.1 * round as f64 / REFINEMENTS as f64;
            let name = "places beside the worst one, on deformable joints";
            let stage = Stage { name, steps: places.len() as u64, shares: [share(round), share(round + 1)] };
            let (found, done) = parallel::each(&places, &stage, watch, |&place, token| {
                let row = self.scene.row(place);
                let case = row.cases.iter().find(|case| case.axles == best.axles)?;
                self.least(&mut self.deforming.sweeper(), 0, &[case], Bound::below(best.factor * (1.0 - SAME)), token)
            });
            if !done {
                return false;
            }
            for (place, answer) in places.into_iter().zip(found) {
                if let Some(answer) = answer.flatten()
                    && answer.factor < best.factor
                {
                    (best, position) = (answer, place);
                }
            }
            width *= 0.1;
        }
        if position != started {
            let (row, done) = self.scene.answered_again(position, None, watch);
            if !done {
                return false;
            }
            best.row = rows.len();
            rows.push(row);
            least.push(best);
        }
        let row = &rows[best.row];
        let stage = Stage {
            name: "runs of axles at the worst place, on deformable joints",
            steps: row.cases.len() as u64,
            shares: [1.0, 1.0],
        };
        let (found, done) = parallel::each(&row.cases, &stage, watch, |case, token| {
            self.least(
                &mut self.deforming.sweeper(),
                best.row,
                &[case],
                Bound::below(best.factor * (1.0 - SAME)),
                token,
            )
        });
        least.extend(found.into_iter().flatten().flatten());
        done
    }
}

/// The least factor of rigid blocks.
fn rigid(row: &Row) -> Option<f64> {
    row.cases.iter().filter_map(|case| case.factor).min_by(f64::total_cmp)
}

/// The run of axles that governs for rigid blocks, all axles, and the run that governed at the position before.
fn likely(row: &Row, before: Option<[usize; 2]>) -> Vec<&Case> {
    let factor = |case: &&Case| case.factor.unwrap_or(f64::INFINITY);
    let governs = row.cases.iter().min_by(|a, b| factor(a).total_cmp(&factor(b)));
    let all = row.cases.iter().max_by(|a, b| a.force.total_cmp(&b.force));
    let mut cases: Vec<&Case> = governs.into_iter().collect();
    for more in all.into_iter().chain(row.cases.iter().filter(|case| Some(case.axles) == before)) {
        if cases.iter().all(|case| case.axles != more.axles) {
            cases.push(more);
        }
    }
    cases
}

/// Both factors of every position, and what is to be said of them.
fn put(scene: &Scene<'_>, rows: &[Row], least: &[Least], found: &mut Sweep) {
    found.points = rows.iter().map(|row| scene.point(row)).collect();
    for (k, point) in found.points.iter_mut().enumerate() {
        point.rigid_factor = point.load_factor;
        let own = least.iter().filter(|least| least.row == k).min_by(|a, b| a.factor.total_cmp(&b.factor));
        let Some(own) = own else { continue };
        point.deformable_factor = Some(own.factor);
        if point.bound().is_none_or(|bound| own.factor < bound) {
            (point.axles, point.collapse_load) = (own.axles, Some(own.factor * own.force));
            match point.load_factor_at_most.is_some() {
                true => (point.load_factor_at_most, point.collapse_load) = (Some(own.factor), None),
                false => (point.load_factor, point.status) = (Some(own.factor), Status::Collapsed),
            }
        }
    }
    let open = least.iter().filter(|least| least.broken_off).count();
    if open > 0 {
        found.warnings.push(warning::Loads::PathsBrokenOff { positions: open, of: rows.len() }.into());
    }
    found.assumptions.push(note::Moving::DeformableJoints.into());
}
