//! Positions of the loads on fill that yields as a continuum: both bounds at each.
//!
//! Rigid blocks with fill as weight are answered first, in milliseconds: they tell which neighbouring axles govern where. On the continuum
//! the whole vehicle and these axles are answered, and the smaller lower bound counts.

use super::{Case, Places, Row, Scene};
use crate::analysis::AnalysisError;
use crate::analysis::by_bounds::Moving;
use crate::analysis::pieces::{self, Stage};
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning::{self, Warning};
use structure::discretise::dispersal::{self, Strip};

/// Upper over lower bound to which every place is answered; those that may govern are answered again as close as the file wants. At Bridgemill
/// it takes a fourth of the time.
const COARSE: f64 = 1.2;

/// The bounds at a position, of the axles that give the smaller lower one.
struct Answer {
    axles: [usize; 2],
    force: f64,
    status: Status,
    factors: Option<[f64; 2]>,
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
    let (mut answers, mut whole) = (Vec::new(), true);
    let coarse = moving.ratio().max(COARSE);
    for answer in answered(scene, &moving, rows, &every, (coarse, [0.1, 0.7]), &mut whole, watch) {
        answers.push(answer?);
    }
    // Only places whose lower bound is below every upper one may govern.
    let upper = answers.iter().flatten().filter_map(|a| a.factors).map(|f| f[1]).fold(f64::INFINITY, f64::min);
    let may = |k: &usize| answers[*k].as_ref().and_then(|a| a.factors).is_some_and(|f| f[0] < upper);
    let close: Vec<usize> = every.into_iter().filter(may).collect();
    if whole && coarse > moving.ratio() {
        let stage = (moving.ratio(), [0.7, 1.0]);
        let found = answered(scene, &moving, rows, &close, stage, &mut whole, watch);
        for (k, answer) in close.into_iter().zip(found) {
            if let Some(answer) = answer? {
                answers[k] = Some(answer);
            }
        }
    }
    let mut points = Vec::with_capacity(rows.len());
    for (row, answer) in rows.iter().zip(answers) {
        let weight = scene.point(row);
        let Some(answer) = answer else { continue };
        points.push(SweepPoint {
            status: answer.status,
            load_factor: answer.factors.map(|f| f[0]).filter(|_| answer.status == Status::Collapsed),
            load_factor_at_most: None,
            collapse_load: answer.factors.map(|f| f[0] * answer.force),
            axles: answer.axles,
            rigid_factor: weight.load_factor,
            upper_factor: answer.factors.map(|f| f[1]),
            ..weight
        });
    }
    found.points = points;
    let unanswered = found.points.iter().filter(|p| p.load_factor.is_none()).count();
    if unanswered > 0 {
        let message = format!("no stresses were found at {unanswered} positions; what is carried there is not known");
        found.warnings.push(Warning::new(warning::POSITIONS_NOT_CONVERGED, message));
    }
    found.assumptions.push(
        "Fill yields as a continuum: each factor is a lower bound, with an upper one beside it, of the whole vehicle or of the \
         neighbouring axles that govern where fill is weight alone, whichever is smaller. Places that cannot govern are answered \
         coarsely."
            .into(),
    );
    Ok(whole)
}

/// Answers some of the rows within a ratio of the bounds.
fn answered(
    scene: &Scene<'_>,
    moving: &Moving<'_>,
    rows: &[Row],
    which: &[usize],
    (ratio, shares): (f64, [f64; 2]),
    whole: &mut bool,
    watch: &mut dyn Watch,
) -> Vec<Result<Option<Answer>, AnalysisError>> {
    let stage = Stage { name: "bounds at positions of the loads", steps: which.len() as u64, shares };
    let (answers, done) = pieces::each(which, &stage, watch, |&k, pace| {
        let row = &rows[k];
        let strips = strips(scene, row.position);
        let least =
            |a: &&Case, b: &&Case| a.factor.unwrap_or(f64::INFINITY).total_cmp(&b.factor.unwrap_or(f64::INFINITY));
        let all = [0, strips.len().saturating_sub(1)];
        let governing = row.cases.iter().filter(|case| case.factor.is_some()).min_by(least).map(|case| case.axles);
        let mut runs = vec![all];
        runs.extend(governing.filter(|axles| *axles != all));
        let mut answers = Vec::new();
        for axles in runs {
            let chosen = &strips[axles[0]..=axles[1]];
            let (status, factors) = moving.factors(chosen, ratio, pace)?;
            answers.push(Answer { axles, force: chosen.iter().map(|s| s.force).sum(), status, factors });
        }
        pace.step();
        let low = |answer: &Answer| answer.factors.map_or(f64::INFINITY, |f| f[0]);
        Ok(answers.into_iter().min_by(|a, b| low(a).total_cmp(&low(b))))
    });
    *whole &= done;
    answers.into_iter().map(|answer| answer.unwrap_or(Ok(None))).collect()
}

/// The loads of the file at a position.
fn strips(scene: &Scene<'_>, position: f64) -> Vec<Strip> {
    let offset = position - scene.first;
    scene.bridge.loads.iter().flat_map(|load| dispersal::strips(&load.kind, load.position + offset)).collect()
}

impl Places {
    /// Places for a method that takes seconds a place: as asked, and none between them.
    pub(super) const UNREFINED: &'static str =
        "The worst place is one of those asked for: none is sought between them.";
}
