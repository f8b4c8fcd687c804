//! Loads that move, on every state of a bridge: at each position the least counts.
//!
//! States that count no strength which may be lost are moved over whole, since what helps at one position may hurt at another. Strength only
//! adds: it is asked for at the governing position alone, and at every other state as well, so that what helps is told there.

use super::super::AnalysisError;
use super::super::parallel::portion;
use super::super::sweep::Places;
use super::standing::{Standing, hurts, leading, not_counted, warned};
use super::states::{State, states_of_moving};
use bridge::Bridge;
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::help::{Help, WithHelp};
use outcome::note::Size;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning;

/// A sweep of one state.
type Method<'a> = &'a dyn Fn(&Bridge, Places, &mut dyn Watch) -> Result<Sweep, AnalysisError>;

/// Positions closer than this are the same [m].
const SAME_PLACE: f64 = 1e-9;

/// Moves loads over a bridge with what helps it left out.
pub(crate) fn swept(
    bridge: &Bridge,
    places: Places,
    watch: &mut dyn Watch,
    method: Method<'_>,
) -> Result<Sweep, AnalysisError> {
    let states = states_of_moving(bridge);
    if states.len() == 1 {
        return method(bridge, places, watch);
    }
    let whole: Vec<&State<Bridge>> = states.iter().filter(|state| !state.counts_strength()).collect();
    let parts = whole.len() as f64;
    let mut runs = Vec::with_capacity(whole.len());
    for (k, state) in whole.iter().enumerate() {
        let part = &mut portion(watch, [k as f64 / parts, (k + 1) as f64 / parts]);
        let run = method(&state.bridge, places, part)?;
        if !run.whole {
            return Ok(run);
        }
        runs.push(run);
    }
    let least = |run: &Sweep| run.points.iter().map(size).fold(f64::INFINITY, f64::min);
    let base = (0..runs.len()).fold(0, |best, k| if least(&runs[k]) < least(&runs[best]) { k } else { best });
    let mut found = runs[base].clone();
    for run in runs.iter().filter(|run| !std::ptr::eq(*run, &runs[base])) {
        run.points.iter().for_each(|point| take(point, &mut found.points));
    }
    let Some(place) = governing(&found.points).map(|k| found.points[k].position) else {
        found.governing = None;
        return Ok(found);
    };
    let mut standings = Vec::with_capacity(states.len());
    for state in &states {
        let run = whole.iter().position(|other| other.helps == state.helps).map(|k| &runs[k]);
        let own = run.and_then(|run| run.points.iter().find(|point| (point.position - place).abs() <= SAME_PLACE));
        let point = match own {
            Some(own) => Some(own.clone()),
            None => {
                method(&state.bridge, Places::At(place), &mut portion(watch, [1.0, 1.0]))?.points.into_iter().next()
            }
        };
        let Some(point) = point else { continue };
        if run.is_some() {
            take(&point, &mut found.points);
        }
        standings.push(standing(&state.helps, &point));
    }
    found.points.sort_by(|a, b| a.position.total_cmp(&b.position));
    found.governing = governing(&found.points);
    tell(&standings, &mut found);
    Ok(found)
}

/// What is not counted at the governing position.
fn tell(standings: &[Standing], found: &mut Sweep) {
    let lead = leading(standings);
    let Some(own) = standings.get(lead) else { return };
    found.not_counted = not_counted(standings, lead);
    found.warnings.extend(warned(&found.not_counted, None, told(&own.numbers), told));
    found.assumptions.extend(hurts(standings, lead, told));
    if let Some(with) = found.not_counted.with(Help::FillPressure) {
        let told = warning::Cover::PressureInSweep { bare: own.numbers.factor, with: with.factor };
        found.warnings.push(told.into());
    }
}

/// The number of a state.
fn told(of: &WithHelp) -> Size {
    match of.factor {
        Some(factor) => Size::LoadFactor(factor, of.last_stable_load),
        None => Size::NoLoadFactor(of.status),
    }
}

fn standing(helps: &[Help], point: &SweepPoint) -> Standing {
    let numbers = WithHelp {
        helps: helps.to_vec(),
        status: point.status,
        last_stable_load: point.collapse_load,
        factor: point.bound(),
        ..WithHelp::default()
    };
    Standing { size: size(point), numbers }
}

/// The size by which positions are compared: loads that nothing makes fall are most, what is not known is least.
fn size(point: &SweepPoint) -> f64 {
    match (point.bound(), point.status) {
        (Some(factor), _) => factor,
        (None, Status::Locks) => f64::INFINITY,
        (None, _) => f64::NEG_INFINITY,
    }
}

/// Takes a point of another state: where it is worse than that of the same position it stands in its place, and where one of both was not
/// answered, the position is not.
fn take(point: &SweepPoint, points: &mut Vec<SweepPoint>) {
    let same = |known: &&mut SweepPoint| (known.position - point.position).abs() <= SAME_PLACE;
    let Some(known) = points.iter_mut().find(same) else {
        points.push(point.clone());
        return;
    };
    let is_open = |point: &SweepPoint| matches!(point.status, Status::NotConverged | Status::Cancelled);
    let open = [&*known, point].into_iter().find(|one| is_open(one)).map(|one| one.status);
    if size(point) < size(known) {
        *known = point.clone();
    }
    if let Some(status) = open.filter(|_| known.status != Status::UnstableUnderSelfWeight) {
        known.load_factor_at_most = known.bound();
        (known.status, known.load_factor, known.collapse_load) = (status, None, None);
    }
}

/// The position with the least load factor, or the least bound on it.
fn governing(points: &[SweepPoint]) -> Option<usize> {
    let bounds = points.iter().enumerate().filter_map(|(k, point)| Some((k, point.bound()?)));
    bounds.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k)
}
