//! Limit analysis with the loads moved over the bridge.
//!
//! Every position is answered with dilatant friction first. Cases up to twice the least factor, and those that lock, are answered
//! without dilation too, each as by an analysis of these loads by themselves, and the least counts. The worst position is then sought between
//! the positions. With the equilibrium path as the plan's method, `deformable` puts the factors of deformable joints beside them.

mod continuum;
mod deformable;

use super::engine::rigid;
use super::parallel::{self, CancelToken, Stage};
use super::vehicles::{DILATANCY, REFINEMENTS};
use super::{AnalysisError, default_stiffness, policy};
use bridge::{Bridge, LoadKind, Method};
use mechanics::blocks::PointForce;
use mechanics::limit::{self, Factor, Friction, Ground, Least, Sweeper};
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::note;
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning;
use structure::discretise::{Discretised, bridge_length, dispersal};

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
                let all = bridge.loads.iter().flat_map(|load| dispersal::strips(load, 0.0));
                let ahead: Vec<f64> = all.map(|strip| strip.middle - first).collect();
                let most = ahead.iter().copied().fold(0.0, f64::max);
                let least = ahead.iter().copied().fold(0.0, f64::min);
                let ends = [-most, bridge_length(bridge) - least];
                let count = ((ends[1] - ends[0]) / step - 1e-9).ceil().clamp(1.0, MOST_POSITIONS) as usize;
                Places::Between(ends, count + 1).list(bridge, first)
            }
        }
    }
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
    let dilatant = limit::Settings { friction: limit::Friction::Associated, ..settings };
    let ground = Ground::new(&d.model, &d.loading, &dilatant)?;
    let vehicle = bridge.loads.iter().any(|l| matches!(l.kind, LoadKind::Axles { .. }));
    let scene = Scene { bridge, d: &d, ground: &ground, settings, first, subsets: subsets && vehicle };
    let mut rows = scene.dilatant(&list, watch);
    let mut whole = rows.len() == list.len();
    whole &= scene.level(&mut rows, whole, watch);
    let step = if list.len() > 1 { list[1] - list[0] } else { 0.0 };
    let yields = structure::discretise::continuum::wanted(bridge).is_some() && bridge.plan.method == Method::Limit;
    if whole && list.len() > 1 && !yields {
        whole = scene.refined(&mut rows, step, watch);
    }
    if whole {
        scene.proven(&mut rows, watch);
    }
    let points: Vec<SweepPoint> = rows.iter().map(|row| scene.point(row)).collect();
    let not_counted = Default::default();
    let mut found =
        Sweep { points, governing: None, step, whole, not_counted, warnings: Vec::new(), assumptions: Vec::new() };
    if whole && yields {
        found.whole = continuum::instead(&scene, &rows, &mut found, watch)?;
    }
    if whole && bridge.plan.method == Method::Path {
        found.whole = deformable::beside(&scene, (&mut rows, step), &mut found, watch)?;
    }
    found.points.sort_by(|a, b| a.position.total_cmp(&b.position));
    let bounds = found.points.iter().enumerate().filter_map(|(k, p)| p.bound().map(|f| (k, f)));
    found.governing = bounds.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k);
    if !yields {
        notes(&mut found, &rows);
    }
    found.assumptions.extend(super::notes::particles_as_weight(bridge));
    found.warnings.extend(taken);
    Ok(found)
}

fn notes(found: &mut Sweep, rows: &[Row]) {
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
    if rows.iter().flat_map(|row| &row.cases).any(|case| case.level) {
        found.assumptions.push(note::Moving::WithoutDilation { times: DILATANCY }.into());
    }
    let proven = rows.iter().flat_map(|row| &row.cases).filter(|case| case.proven).count();
    if proven > 0 {
        found.assumptions.push(note::Moving::Proven { cases: proven }.into());
    }
}

/// A run of neighbouring axles at a position, and what it gave.
#[derive(Debug, Clone)]
struct Case {
    axles: [usize; 2],
    force: f64,
    forces: Vec<PointForce>,
    status: Status,
    factor: Option<f64>,
    /// The answer with dilation, once it is known.
    dilatant: Option<Factor>,
    /// Whether it was answered without dilation.
    level: bool,
    /// Whether no largest factor was found with dilation.
    unknown: bool,
    /// Whether the factor is one that is proven to be carried, where no largest one was found.
    proven: bool,
}

impl Case {
    /// Takes what the plan's friction makes of it.
    fn put(&mut self, found: &Least) {
        (self.status, self.factor) = (rigid::status(found.status), found.factor);
        self.unknown = found.dilatant.status == limit::Status::NotConverged;
        self.level = found.friction == Friction::NonAssociated;
    }
}

/// All cases at a position.
#[derive(Debug, Clone)]
struct Row {
    position: f64,
    cases: Vec<Case>,
    /// Number of axles.
    axles: usize,
}

/// Nobody knows whether these slide.
fn open(rows: &mut [Row], jobs: Vec<(usize, usize)>) {
    for (r, c) in jobs {
        let case = &mut rows[r].cases[c];
        (case.status, case.level) = (Status::Cancelled, false);
    }
}

/// What all positions share.
struct Scene<'a> {
    bridge: &'a Bridge,
    d: &'a Discretised,
    ground: &'a Ground,
    settings: limit::Settings,
    first: f64,
    subsets: bool,
}

/// Positions that are answered one after the other, each starting from the mechanisms of those before it. Fixed, so that the
/// numbers do not depend on the number of threads.
const CHUNK: usize = 8;

impl Scene<'_> {
    /// The loads at a position, unanswered.
    fn row(&self, position: f64) -> Row {
        let offset = position - self.first;
        let spreads: Vec<_> = (self.bridge.loads.iter())
            .flat_map(|load| dispersal::strips(load, offset))
            .map(|strip| self.d.spread(self.bridge, strip))
            .collect();
        let n = spreads.len();
        let runs: Vec<[usize; 2]> = match self.subsets {
            true => (0..n).flat_map(|a| (a..n).map(move |b| [a, b])).collect(),
            false => vec![[0, n - 1]],
        };
        let case = |axles: [usize; 2]| {
            let chosen = &spreads[axles[0]..=axles[1]];
            let forces: Vec<_> = chosen.iter().flat_map(|s| s.forces.iter().copied()).collect();
            let force = chosen.iter().map(|s| s.strip.force).sum();
            let (status, factor) = (Status::Locks, None);
            let [level, unknown, proven] = [false; 3];
            let case = Case { axles, force, forces, status, factor, dilatant: None, level, unknown, proven };
            (!case.forces.is_empty()).then_some(case)
        };
        Row { position, cases: runs.into_iter().filter_map(case).collect(), axles: n }
    }

    /// Answers a row with dilatant friction; none where the work does not go on.
    fn answered(&self, sweeper: &mut Sweeper<'_>, position: f64, token: &CancelToken) -> Option<Row> {
        let mut row = self.row(position);
        for case in &mut row.cases {
            if token.is_cancelled() {
                return None;
            }
            let effect = sweeper.effect(&case.forces);
            let found = sweeper.factor(&effect);
            if token.is_cancelled() {
                return None;
            }
            (case.status, case.factor) = (rigid::status(found.status), found.lower);
            case.unknown = found.status == limit::Status::NotConverged;
            case.dilatant = Some(found);
        }
        token.step();
        Some(row)
    }

    /// All positions with dilatant friction, or those answered in time.
    fn dilatant(&self, list: &[f64], watch: &mut dyn Watch) -> Vec<Row> {
        let chunks: Vec<&[f64]> = list.chunks(CHUNK).collect();
        let stage = Stage { name: "positions of the loads", steps: list.len() as u64, shares: [0.0, 0.4] };
        let (found, _) = parallel::each(&chunks, &stage, watch, |places, token| {
            let mut sweeper = self.ground.sweeper().paced(token);
            places.iter().map_while(|&place| self.answered(&mut sweeper, place, token)).collect::<Vec<Row>>()
        });
        found.into_iter().flatten().flatten().collect()
    }

    /// Cases that are to be answered without dilation: the same axles at neighbouring positions beside one another.
    fn asked(&self, rows: &[Row]) -> Vec<(usize, usize)> {
        let all = || {
            rows.iter().enumerate().flat_map(|(r, row)| row.cases.iter().enumerate().map(move |(c, case)| (r, c, case)))
        };
        let least = all().filter_map(|(_, _, case)| case.factor).fold(f64::INFINITY, f64::min);
        let asked = |case: &Case| match self.settings.friction {
            limit::Friction::Associated => false,
            limit::Friction::NonAssociated => matches!(case.status, Status::Collapsed | Status::Locks),
            limit::Friction::Automatic => {
                case.status == Status::Locks || case.factor.is_some_and(|factor| factor <= DILATANCY * least)
            }
        };
        let mut jobs: Vec<_> = all().filter(|(_, _, case)| asked(case)).map(|(r, c, _)| (r, c)).collect();
        jobs.sort_by_key(|&(r, c)| (rows[r].cases[c].axles, r));
        jobs
    }

    /// Answers cases that may govern as the plan's friction says; tells whether all of them were. Without it, they are open.
    fn level(&self, rows: &mut [Row], whole: bool, watch: &mut dyn Watch) -> bool {
        let jobs = self.asked(rows);
        if !whole {
            open(rows, jobs);
            return false;
        }
        let stage = Stage { name: "cases without dilation", steps: jobs.len() as u64, shares: [0.4, 0.9] };
        let (found, done) =
            parallel::each(&jobs, &stage, watch, |&(r, c), token| self.as_planned(&rows[r].cases[c], token));
        let mut unanswered = Vec::new();
        for ((r, c), found) in jobs.into_iter().zip(found) {
            match found.flatten() {
                Some(found) => rows[r].cases[c].put(&found),
                None => unanswered.push((r, c)),
            }
        }
        open(rows, unanswered);
        done
    }

    /// Cases of which nothing is known, where a factor above the least of the others is proven to be carried: it stands in place of the
    /// largest one.
    fn proven(&self, rows: &mut [Row], watch: &mut dyn Watch) {
        let all = rows
            .iter()
            .enumerate()
            .flat_map(|(r, row)| row.cases.iter().enumerate().map(move |(c, case)| (r, c, case)));
        let least = all.clone().filter_map(|(_, _, case)| case.factor).fold(f64::INFINITY, f64::min);
        let jobs: Vec<(usize, usize)> = all.filter(|(_, _, case)| case.unknown).map(|(r, c, _)| (r, c)).collect();
        if jobs.is_empty() || !least.is_finite() {
            return;
        }
        let stage = Stage { name: "cases without an answer", steps: jobs.len() as u64, shares: [1.0, 1.0] };
        let (found, _) = parallel::each(&jobs, &stage, watch, |&(r, c), token| {
            let mut sweeper = self.ground.sweeper().paced(token);
            let effect = sweeper.effect(&rows[r].cases[c].forces);
            sweeper.proven_up_to(&effect, DILATANCY * least)
        });
        for ((r, c), carried) in jobs.into_iter().zip(found) {
            if let Some(carried) = carried.flatten().filter(|carried| *carried > least) {
                let case = &mut rows[r].cases[c];
                (case.status, case.factor, case.proven) = (Status::Collapsed, Some(carried), true);
            }
        }
    }

    /// One case as the plan's friction says; none where the work does not go on.
    fn as_planned(&self, case: &Case, token: &CancelToken) -> Option<Least> {
        let mut sweeper = self.ground.sweeper().paced(token);
        let effect = sweeper.effect(&case.forces);
        let dilatant = case.dilatant.unwrap_or_else(|| sweeper.factor(&effect));
        let found = sweeper.least_beside(&effect, self.settings.friction, dilatant);
        token.step().then_some(found)
    }

    /// Seeks the worst position between the positions with the axles that govern, and answers it with all runs of axles. Tells whether the
    /// work was done.
    fn refined(&self, rows: &mut Vec<Row>, step: f64, watch: &mut dyn Watch) -> bool {
        let cases = rows.iter().flat_map(|row| row.cases.iter().map(move |case| (row.position, case)));
        let factors = cases.filter_map(|(position, case)| Some((position, case.axles, case.factor?)));
        let Some((started, axles, mut factor)) = factors.min_by(|a, b| a.2.total_cmp(&b.2)) else { return true };
        let (mut position, mut width) = (started, step);
        for round in 0..REFINEMENTS {
            let list: Vec<f64> = (-10..=10).map(|k| position + 0.1 * width * f64::from(k)).collect();
            let share = |round: usize| 0.9 + 0.1 * round as f64 / REFINEMENTS as f64;
            let shares = [share(round), share(round + 1)];
            let stage = Stage { name: "places beside the worst one", steps: list.len() as u64, shares };
            let (found, done) = parallel::each(&list, &stage, watch, |&place, token| {
                let case = self.row(place).cases.into_iter().find(|case| case.axles == axles);
                case.and_then(|case| self.as_planned(&case, token))
            });
            if !done {
                return false;
            }
            for (place, found) in list.into_iter().zip(found) {
                if let Some(smaller) = found.flatten().and_then(|found| found.factor)
                    && smaller < factor
                {
                    (factor, position) = (smaller, place);
                }
            }
            width *= 0.1;
        }
        if position == started {
            return true;
        }
        let (row, done) = self.answered_again(position, watch);
        rows.extend(done.then_some(row));
        done
    }

    /// Every case at one position as the plan's friction says; whether all were answered.
    fn answered_again(&self, position: f64, watch: &mut dyn Watch) -> (Row, bool) {
        let mut row = self.row(position);
        let steps = row.cases.len() as u64;
        let stage = Stage { name: "runs of axles at the worst place", steps, shares: [1.0, 1.0] };
        let (found, done) = parallel::each(&row.cases, &stage, watch, |case, token| self.as_planned(case, token));
        for (case, found) in row.cases.iter_mut().zip(found) {
            match found.flatten() {
                Some(found) => case.put(&found),
                None => (case.status, case.factor, case.level) = (Status::Cancelled, None, false),
            }
        }
        (row, done)
    }

    /// The worst case of a row.
    fn point(&self, row: &Row) -> SweepPoint {
        let worst = row.cases.iter().filter(|case| case.factor.is_some());
        let worst =
            worst.min_by(|a, b| a.factor.unwrap_or(f64::INFINITY).total_cmp(&b.factor.unwrap_or(f64::INFINITY)));
        let unanswered = |status| row.cases.iter().any(|case| case.status == status);
        let first = row.cases.first().map_or(Status::Locks, |case| case.status);
        let status = match worst {
            _ if unanswered(Status::NotConverged) => Status::NotConverged,
            _ if unanswered(Status::Cancelled) => Status::Cancelled,
            Some(case) => case.status,
            None => first,
        };
        let factor = worst.and_then(|case| case.factor);
        let answered = status == Status::Collapsed;
        SweepPoint {
            offset: row.position - self.first,
            position: row.position,
            status,
            load_factor: factor.filter(|_| answered),
            load_factor_at_most: factor.filter(|_| !answered),
            collapse_load: worst.filter(|_| answered).and_then(|case| Some(case.factor? * case.force)),
            axles: worst.map_or([0, row.axles.saturating_sub(1)], |case| case.axles),
            rigid_factor: None,
            deformable_factor: None,
            upper_factor: None,
        }
    }
}
