//! Positions of the loads on fill that yields as a continuum: both bounds at each.
//!
//! Rigid blocks with fill as weight are answered first, in milliseconds: they tell which neighbouring axles govern where. On the continuum
//! the whole vehicle and these axles are answered, and the smaller lower bound counts.

use super::{Case, Row, Scene};
use crate::analysis::AnalysisError;
use crate::analysis::by_bounds::{Bracket, Moving};
use crate::analysis::pieces::{self, Stage};
use mechanics::watch::{Pace, Watch};
use outcome::collapse::Status;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning::{self, Warning};
use structure::discretise::dispersal::{self, Strip};

/// Upper over lower bound to which every place is answered; those with the least lower bounds are answered again as close as the file wants.
const COARSE: f64 = 1.2;

/// A run of neighbouring axles at a position.
struct Run {
    axles: [usize; 2],
    force: f64,
    found: Bracket,
}

/// Puts bounds in place of the factors of rows that rigid blocks gave. Tells whether all positions were answered.
pub(super) fn instead(
    scene: &Scene<'_>,
    rows: &[Row],
    found: &mut Sweep,
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    let moving = Moving::new(scene.bridge, scene.d)?;
    let every: Vec<usize> = (0..rows.len()).collect();
    let coarse = moving.ratio().max(COARSE);
    let (mut points, mut whole) = answered(scene, &moving, rows, &every, (coarse, [0.1, 0.7]), watch)?;
    let mut is_close = vec![coarse <= moving.ratio(); rows.len()];
    while whole {
        let next = least_coarse(&points, &is_close);
        if next.is_empty() {
            break;
        }
        let (again, done) = answered(scene, &moving, rows, &next, (moving.ratio(), [0.7, 1.0]), watch)?;
        whole = done;
        for (k, point) in next.into_iter().zip(again) {
            is_close[k] = true;
            points[k] = point.or(points[k].take());
        }
    }
    found.points = points.into_iter().flatten().collect();
    notes(found);
    Ok(whole)
}

/// Places answered at once as close as wanted: fixed, so that the numbers do not depend on the number of threads.
const AT_ONCE: usize = 4;

/// The places of the least lower bounds that are coarse and below the least close one. Closer bounds only rise: once there are none, the least
/// lower bound of all is a close one.
fn least_coarse(points: &[Option<SweepPoint>], is_close: &[bool]) -> Vec<usize> {
    let lower = |k: usize| points[k].as_ref().and_then(|p| p.load_factor);
    let (close, mut coarse): (Vec<usize>, Vec<usize>) =
        (0..points.len()).filter(|&k| lower(k).is_some()).partition(|&k| is_close[k]);
    let least = close.into_iter().filter_map(lower).fold(f64::INFINITY, f64::min);
    coarse.retain(|&k| lower(k).is_some_and(|lower| lower < least));
    coarse.sort_by(|&a, &b| lower(a).partial_cmp(&lower(b)).unwrap_or(std::cmp::Ordering::Equal).then(a.cmp(&b)));
    coarse.truncate(AT_ONCE);
    coarse
}

fn notes(found: &mut Sweep) {
    let open = found.positions_not_converged();
    if open > 0 {
        let message = format!("no bounds were found at {open} positions; what is carried there is not known");
        found.warnings.push(Warning::new(warning::POSITIONS_NOT_CONVERGED, message));
    }
    found.assumptions.push(
        "Fill yields as a continuum: each factor is a lower bound, with an upper one beside it, of the whole vehicle or of the \
         neighbouring axles that govern where fill is weight alone, whichever is smaller. Places that cannot govern are answered \
         coarsely. The worst place is one of those asked for: none is sought between them."
            .into(),
    );
}

/// Answers some of the rows within a ratio of the bounds, and tells whether all were.
fn answered(
    scene: &Scene<'_>,
    moving: &Moving<'_>,
    rows: &[Row],
    which: &[usize],
    (ratio, shares): (f64, [f64; 2]),
    watch: &mut dyn Watch,
) -> Result<(Vec<Option<SweepPoint>>, bool), AnalysisError> {
    let stage = Stage { name: "bounds at positions of the loads", steps: which.len() as u64, shares };
    let (answers, done) = pieces::each(which, &stage, watch, |&k, pace| {
        let runs = runs(scene, moving, &rows[k], ratio, pace)?;
        pace.step();
        Ok(point(scene.point(&rows[k]), &runs))
    });
    let points: Result<_, AnalysisError> = answers.into_iter().map(Option::transpose).collect();
    Ok((points?, done))
}

/// The whole vehicle, and the axles that govern where fill is weight.
fn runs(scene: &Scene<'_>, moving: &Moving<'_>, row: &Row, ratio: f64, pace: &Pace) -> Result<Vec<Run>, AnalysisError> {
    let strips = strips(scene, row.position);
    let least = |a: &&Case, b: &&Case| a.factor.unwrap_or(f64::INFINITY).total_cmp(&b.factor.unwrap_or(f64::INFINITY));
    let all = [0, strips.len().saturating_sub(1)];
    let governing = row.cases.iter().filter(|case| case.factor.is_some()).min_by(least).map(|case| case.axles);
    let axles = [all].into_iter().chain(governing.filter(|axles| *axles != all));
    let run = |axles: [usize; 2]| {
        let chosen = &strips[axles[0]..=axles[1]];
        let found = moving.bracket(chosen, ratio, pace)?;
        Ok(Run { axles, force: chosen.iter().map(|s| s.force).sum(), found })
    };
    axles.map(run).collect()
}

/// What the runs of axles at a position say of it. A run without an answer leaves the position without one: what is known is that no more
/// is carried than the least upper bound.
fn point(weight: SweepPoint, runs: &[Run]) -> SweepPoint {
    let rigid_factor = weight.load_factor;
    let upper = runs.iter().filter_map(|run| run.found.upper).min_by(f64::total_cmp);
    let of = |status: Status| runs.iter().find(move |run| run.found.status == status);
    let blank = SweepPoint {
        load_factor: None,
        load_factor_at_most: None,
        collapse_load: None,
        rigid_factor,
        upper_factor: upper,
        ..weight
    };
    let unanswered =
        [Status::UnstableUnderSelfWeight, Status::NotConverged, Status::Cancelled].into_iter().find_map(of);
    if let Some(run) = unanswered {
        let status = run.found.status;
        let at_most = upper.filter(|_| status != Status::UnstableUnderSelfWeight);
        return SweepPoint { status, axles: run.axles, load_factor_at_most: at_most, upper_factor: None, ..blank };
    }
    let carried = runs.iter().filter_map(|run| Some((run, run.found.lower?)));
    match carried.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((run, lower)) => SweepPoint {
            status: Status::Collapsed,
            axles: run.axles,
            load_factor: Some(lower),
            collapse_load: Some(lower * run.force),
            ..blank
        },
        None => SweepPoint { status: Status::Locks, ..blank },
    }
}

/// The loads of the file at a position.
fn strips(scene: &Scene<'_>, position: f64) -> Vec<Strip> {
    let offset = position - scene.first;
    scene.bridge.loads.iter().flat_map(|load| dispersal::strips(&load.kind, load.position + offset)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weight() -> SweepPoint {
        SweepPoint {
            offset: 0.0,
            position: 1.0,
            status: Status::Collapsed,
            load_factor: Some(4.0),
            load_factor_at_most: None,
            collapse_load: Some(4.0),
            axles: [0, 0],
            rigid_factor: None,
            deformable_factor: None,
            upper_factor: None,
        }
    }

    fn run(status: Status, lower: Option<f64>, upper: Option<f64>) -> Run {
        Run { axles: [0, 1], force: 10.0, found: Bracket { status, lower, upper } }
    }

    #[test]
    fn the_smaller_lower_bound_counts() {
        let runs = [run(Status::Collapsed, Some(3.0), Some(3.3)), run(Status::Collapsed, Some(2.0), Some(2.2))];
        let found = point(weight(), &runs);
        assert_eq!((found.status, found.load_factor, found.upper_factor), (Status::Collapsed, Some(2.0), Some(2.2)));
        assert_eq!((found.collapse_load, found.rigid_factor), (Some(20.0), Some(4.0)));
    }

    #[test]
    fn a_run_of_axles_without_an_answer_leaves_the_position_without_one() {
        let runs = [run(Status::NotConverged, None, Some(1.5)), run(Status::Collapsed, Some(2.0), Some(2.2))];
        let found = point(weight(), &runs);
        assert_eq!((found.status, found.load_factor), (Status::NotConverged, None));
        assert_eq!((found.load_factor_at_most, found.collapse_load), (Some(1.5), None));
    }

    #[test]
    fn soil_that_does_not_stand_carries_nothing_anywhere() {
        let runs = [run(Status::Collapsed, Some(2.0), Some(2.2)), run(Status::UnstableUnderSelfWeight, None, None)];
        let found = point(weight(), &runs);
        assert_eq!((found.status, found.bound()), (Status::UnstableUnderSelfWeight, None));
    }

    #[test]
    fn places_are_answered_closely_until_the_least_bound_is_a_close_one() {
        let at = |factor: Option<f64>| Some(SweepPoint { load_factor: factor, ..weight() });
        let mut points: Vec<_> = [5.0, 2.0, 3.0, 2.5, 2.8, 2.1].map(|factor| at(Some(factor))).into();
        points.push(at(None));
        let mut is_close = vec![false; points.len()];
        assert_eq!(least_coarse(&points, &is_close), [1, 5, 3, 4]);
        // Two of them have risen above the others.
        for (k, factor) in [(1, 2.4), (5, 2.45), (3, 2.55), (4, 2.9)] {
            (points[k], is_close[k]) = (at(Some(factor)), true);
        }
        assert!(least_coarse(&points, &is_close).is_empty());
        points[2] = at(Some(2.3));
        assert_eq!(least_coarse(&points, &is_close), [2]);
    }

    #[test]
    fn where_no_load_stands_on_the_fill_nothing_can_fail() {
        let found = point(weight(), &[run(Status::Locks, None, None)]);
        assert_eq!((found.status, found.bound()), (Status::Locks, None));
    }
}
