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

/// Upper over lower bound to which every place is answered; those that may govern are then answered on finer meshes, one at a time: 179 s in
/// place of 234 s in one run for 51 positions of Bridgemill on one thread. With 2.0, one mesh at most places, it took 182 s.
const COARSE: f64 = 1.2;

/// A run of neighbouring axles at a position.
#[derive(Debug, Clone)]
struct Run {
    axles: [usize; 2],
    force: f64,
    found: Bracket,
    /// Whether a finer mesh gave nothing new.
    is_spent: bool,
}

/// Runs of all positions, in their order; none where a position was not answered.
type Answered = Vec<Option<Vec<Run>>>;

/// Puts bounds in place of the factors of rows that rigid blocks gave. Tells whether all positions were answered.
///
/// The least lower bound of all runs is carried everywhere, and the least upper bound is not carried somewhere. Runs whose lower bounds
/// keep these two further apart than the file wants are answered on a finer mesh, the smallest first, until there are none.
pub(super) fn instead(
    scene: &Scene<'_>,
    rows: &[Row],
    found: &mut Sweep,
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    let moving = Moving::new(scene.bridge, scene.d)?;
    let (mut places, mut whole) = begun(scene, &moving, rows, watch)?;
    while whole {
        let next = apart(&places, moving.ratio());
        if next.is_empty() {
            break;
        }
        whole = refined(scene, &moving, rows, &next, &mut places, watch)?;
    }
    let answered = rows.iter().zip(&places).filter_map(|(row, runs)| Some((row, runs.as_ref()?)));
    found.points = answered.map(|(row, runs)| point(scene.point(row), runs)).collect();
    notes(found);
    Ok(whole)
}

/// Runs refined at once: fixed, so that the numbers do not depend on the number of threads.
const AT_ONCE: usize = 4;

/// The runs, by place and number, whose lower bounds are smaller than the least upper bound of all over the wanted ratio, the smallest
/// first.
fn apart(places: &[Option<Vec<Run>>], ratio: f64) -> Vec<(usize, usize)> {
    let runs = || {
        places
            .iter()
            .enumerate()
            .flat_map(|(k, runs)| runs.iter().flatten().enumerate().map(move |(r, run)| (k, r, run)))
    };
    let least = runs().filter_map(|(_, _, run)| run.found.upper).fold(f64::INFINITY, f64::min);
    let open = |run: &Run| run.found.lower.filter(|lower| !run.is_spent && *lower < least / ratio);
    let mut open: Vec<_> = runs().filter_map(|(k, r, run)| Some((open(run)?, (k, r)))).collect();
    open.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    open.into_iter().map(|(_, place)| place).take(AT_ONCE).collect()
}

/// Answers runs on finer meshes, and tells whether all were.
fn refined(
    scene: &Scene<'_>,
    moving: &Moving<'_>,
    rows: &[Row],
    which: &[(usize, usize)],
    places: &mut [Option<Vec<Run>>],
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    let jobs: Vec<(usize, usize, &Run)> =
        (which.iter()).filter_map(|&(k, r)| Some((k, r, places.get(k)?.as_ref()?.get(r)?))).collect();
    let stage = Stage { name: "bounds at positions that may govern", steps: jobs.len() as u64, shares: [0.7, 1.0] };
    let (answers, done) = pieces::each(&jobs, &stage, watch, |&(k, _, run), pace| {
        let strips = strips(scene, rows[k].position);
        let found = moving.closer(&strips[run.axles[0]..=run.axles[1]], &run.found, pace)?;
        pace.step();
        Ok::<_, AnalysisError>(Run { is_spent: found.elements() == run.found.elements(), found, ..*run })
    });
    for (&(k, r), answer) in which.iter().zip(answers) {
        if let (Some(answer), Some(runs)) = (answer.transpose()?, &mut places[k]) {
            runs[r] = answer;
        }
    }
    Ok(done)
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

/// Answers all rows coarsely, and tells whether all were.
fn begun(
    scene: &Scene<'_>,
    moving: &Moving<'_>,
    rows: &[Row],
    watch: &mut dyn Watch,
) -> Result<(Answered, bool), AnalysisError> {
    let ratio = moving.ratio().max(COARSE);
    let stage = Stage { name: "bounds at positions of the loads", steps: rows.len() as u64, shares: [0.1, 0.7] };
    let (answers, done) = pieces::each(rows, &stage, watch, |row, pace| {
        let runs = runs(scene, moving, row, ratio, pace)?;
        pace.step();
        Ok(runs)
    });
    let places: Result<_, AnalysisError> = answers.into_iter().map(Option::transpose).collect();
    Ok((places?, done))
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
        Ok(Run { axles, force: chosen.iter().map(|s| s.force).sum(), found, is_spent: false })
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
    scene.bridge.loads.iter().flat_map(|load| dispersal::strips(load, offset)).collect()
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
        Run { axles: [0, 1], force: 10.0, found: Bracket { status, lower, upper, bounds: None }, is_spent: false }
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
    fn runs_are_refined_until_the_least_bounds_of_all_are_as_close_as_wanted() {
        let at = |lower, upper| Some(vec![run(Status::Collapsed, Some(lower), Some(upper))]);
        let mut places =
            vec![at(5.0, 6.0), at(2.0, 2.4), at(2.3, 2.7), None, at(2.1, 2.5), at(2.26, 2.6), at(2.05, 2.6)];
        places.push(Some(vec![run(Status::Locks, None, None)]));
        // The least upper bound is 2.4: what carries 2.4 / 1.05 = 2.286 keeps nothing apart.
        assert_eq!(apart(&places, 1.05), [(1, 0), (6, 0), (4, 0), (5, 0)]);
        assert_eq!(apart(&places, 1.5), []);
        // Nothing more is to be had at one of them, and the others have risen.
        places[1].as_mut().unwrap()[0].is_spent = true;
        for k in [4, 5, 6] {
            places[k] = at(2.29, 2.45);
        }
        assert_eq!(apart(&places, 1.05), []);
    }

    #[test]
    fn where_no_load_stands_on_the_fill_nothing_can_fail() {
        let found = point(weight(), &[run(Status::Locks, None, None)]);
        assert_eq!((found.status, found.bound()), (Status::Locks, None));
    }
}
