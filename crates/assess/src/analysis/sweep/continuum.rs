//! Positions of the loads on fill that yields as a continuum: both bounds at each.
//!
//! Rigid blocks with fill as weight are answered first, in milliseconds: they tell which neighbouring axles govern where. On the continuum
//! the whole vehicle and these axles are answered, and the smaller lower bound counts.

use super::{Loads, Place};
use crate::analysis::AnalysisError;
use crate::analysis::engine::continuum::Moving;
use crate::analysis::engine::continuum::moved::{self, Answer, Asked};
use crate::analysis::parallel::portion;
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::note;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning;

/// A run of neighbouring axles at a position.
#[derive(Debug, Clone)]
struct Run {
    /// The place of its row.
    place: usize,
    axles: [usize; 2],
    force: f64,
}

/// Puts bounds in place of the factors of rows that rigid blocks gave. Tells whether all positions were answered.
pub(super) fn instead(
    loads: &Loads<'_>,
    rows: &[Place],
    found: &mut Sweep,
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    let body = [Moving::new(loads.bridge, loads.d)?];
    let (runs, asked) = runs(loads, rows);
    let (answers, whole) = moved::all(&body, &asked, body[0].earth.plan.bound_ratio, &mut portion(watch, [0.1, 1.0]))?;
    let mut places: Vec<Option<Vec<(&Run, Answer)>>> = rows.iter().map(|_| Some(Vec::new())).collect();
    for (run, answer) in runs.iter().zip(answers) {
        // A position is answered where all of its runs are.
        match (answer, &mut places[run.place]) {
            (Some(answer), Some(place)) => place.push((run, answer)),
            (None, place) => *place = None,
            (Some(_), None) => {}
        }
    }
    let answered = rows.iter().zip(&places).filter_map(|(row, runs)| Some((row, runs.as_ref()?)));
    found.points = answered.map(|(row, runs)| point(loads.point(row), runs)).collect();
    notes(found);
    Ok(whole)
}

fn notes(found: &mut Sweep) {
    let open = found.positions_not_converged();
    if open > 0 {
        found.warnings.push(warning::Yielding::PositionsOpen { positions: open }.into());
    }
    found.assumptions.push(note::Soil::InSweep.into());
}

/// The whole vehicle at every position, and the axles that govern there where fill is weight.
fn runs(loads: &Loads<'_>, rows: &[Place]) -> (Vec<Run>, Vec<Asked>) {
    let (mut runs, mut asked): (Vec<Run>, Vec<Asked>) = (Vec::new(), Vec::new());
    let mut kinds: Vec<[usize; 2]> = Vec::new();
    for (place, row) in rows.iter().enumerate() {
        let strips = loads.strips(row.at.position);
        let all = [0, strips.len().saturating_sub(1)];
        let governing = row.least.and_then(|least| least.key.axles);
        for axles in [all].into_iter().chain(governing.filter(|axles| *axles != all)) {
            let kind = kinds.iter().position(|kind| *kind == axles).unwrap_or_else(|| {
                kinds.push(axles);
                kinds.len() - 1
            });
            let chosen = strips[axles[0]..=axles[1]].to_vec();
            runs.push(Run { place, axles, force: chosen.iter().map(|s| s.force).sum() });
            asked.push(Asked { body: 0, row: kind, position: row.at.position, strips: chosen });
        }
    }
    (runs, asked)
}

/// What the runs of axles at a position say of it. A run without an answer leaves the position without one: what is known is that no more
/// is carried than the least upper bound.
fn point(weight: SweepPoint, runs: &[(&Run, Answer)]) -> SweepPoint {
    let rigid_factor = weight.load_factor;
    let upper = runs.iter().filter_map(|(_, answer)| answer.upper()).min_by(f64::total_cmp);
    let of = |status: Status| runs.iter().find(move |(_, answer)| answer.found.status == status);
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
    if let Some((run, answer)) = unanswered {
        let status = answer.found.status;
        let at_most = upper.filter(|_| status != Status::UnstableUnderSelfWeight);
        return SweepPoint { status, axles: run.axles, load_factor_at_most: at_most, upper_factor: None, ..blank };
    }
    let carried = runs.iter().filter_map(|(run, answer)| Some((run, answer.found.lower?)));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::engine::continuum::Bracket;

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

    const RUN: Run = Run { place: 0, axles: [0, 1], force: 10.0 };

    fn run(status: Status, lower: Option<f64>, upper: Option<f64>) -> (&'static Run, Answer) {
        (&RUN, Answer::of(Bracket { status, lower, upper, bounds: None }))
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
    fn where_no_load_stands_on_the_fill_nothing_can_fail() {
        let found = point(weight(), &[run(Status::Locks, None, None)]);
        assert_eq!((found.status, found.bound()), (Status::Locks, None));
    }
}
