//! Every place of everything that moves, and the worst place between them.

use super::super::parallel::{self, CancelToken, Stage};
use super::place::Found;
use super::{Answer, DILATANCY, Key, Place, Scene, Stands, WithoutDilation, dips, least, spaced};
use mechanics::limit::{Friction, Least, Status, Sweeper};
use mechanics::watch::Watch;
use rayon::prelude::*;

/// Places that are answered one after the other, each starting from the mechanisms of those before it. Fixed, so that
/// the numbers do not depend on the number of threads.
const CHUNK: usize = 24;
/// Refinements of the worst position, each to a tenth.
pub(crate) const REFINEMENTS: usize = 2;

/// A drive: of which vehicle, where its first axle is moved [m], and whether another vehicle's answers count for it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line<'a> {
    pub vehicle: usize,
    pub positions: &'a [f64],
    pub alike: bool,
}

/// Answers everything that may stand at every place of every drive, and seeks the worst place of each of so many vehicles between its places,
/// which lie a step [m] apart; not where there is no step. Where the onlooker wishes to stop, vehicles that were not finished say so.
pub(crate) fn search<S: Stands>(
    scene: &Scene<'_, S>,
    (lines, vehicles): (&[Line<'_>], usize),
    step: f64,
    watch: &mut dyn Watch,
) -> Vec<Found> {
    // Shares of the work at which all places are answered with dilation and without.
    let in_turn = matches!(scene.without_dilation, WithoutDilation::InTurn(_));
    let shares = if in_turn { [0.5, 0.5] } else { [0.4, 0.9] };
    let mut found = everywhere(scene, (lines, vehicles), shares[0], watch);
    if let WithoutDilation::Everywhere(friction) = scene.without_dilation {
        let whole = found.iter().all(|one| one.whole);
        let places = found.iter_mut().flat_map(|one| &mut one.places).collect();
        let done = scene.level_everywhere((places, whole), friction, shares, watch);
        found.iter_mut().for_each(|one| one.whole &= done);
    }
    let alike: Vec<bool> = (0..vehicles).map(|k| lines.iter().any(|line| line.vehicle == k && line.alike)).collect();
    let own: Vec<usize> = (0..vehicles).filter(|&k| !alike[k]).collect();
    let stage = Stage { name: "worst positions", steps: own.len() as u64, shares: [shares[1], 1.0] };
    let (ends, _) = parallel::each(&own, &stage, watch, |&k, token| {
        let end = scene.worst(&found[k], step, token);
        token.step();
        end
    });
    for (k, end) in own.into_iter().zip(ends) {
        let end = end.unwrap_or_else(|| scene.worst(&found[k], step, &CancelToken::cancelled()));
        found[k].end(end);
    }
    found
}

/// Every place with dilation, vehicle by vehicle.
fn everywhere<S: Stands>(
    scene: &Scene<'_, S>,
    (lines, vehicles): (&[Line<'_>], usize),
    share: f64,
    watch: &mut dyn Watch,
) -> Vec<Found> {
    let mut jobs: Vec<(usize, usize, bool, &[f64])> = Vec::new();
    for (drive, line) in lines.iter().enumerate() {
        jobs.extend(line.positions.chunks(CHUNK).map(|positions| (drive, line.vehicle, line.alike, positions)));
    }
    // Vehicles that another answers take no time to speak of.
    let steps = lines.iter().filter(|line| !line.alike).map(|line| line.positions.len() as u64).sum();
    let stage = Stage { name: "positions", steps, shares: [0.0, share] };
    let (parts, _) = parallel::each(&jobs, &stage, watch, |&(drive, _, alike, positions), token| {
        scene.along((drive, alike), positions, token)
    });
    let mut found: Vec<Found> = (0..vehicles).map(|_| scene.nothing()).collect();
    for (part, &(_, vehicle, _, positions)) in parts.into_iter().zip(&jobs) {
        let of = &mut found[vehicle];
        of.whole &= part.as_ref().is_some_and(|part| part.places.len() == positions.len());
        if let Some(part) = part {
            of.add(part);
        }
    }
    found
}

impl Found {
    fn add(&mut self, part: Found) {
        self.places.extend(part.places);
        self.extremes.merge(part.extremes);
        self.cases += part.cases;
        self.slow += part.slow;
    }

    /// Takes what came of the search between the places.
    fn end(&mut self, (end, settled): (Found, Vec<Option<f64>>)) {
        self.between = end.places.len();
        self.places.extend(end.places);
        for (place, settled) in self.places.iter_mut().zip(settled) {
            place.settled = settled;
        }
        self.whole &= end.whole;
        (self.worst, self.level) = (end.worst, end.level);
    }
}

/// What lies beside an answer: so many tenths of a step [m] to either side, and of a tenth of it about the least found there.
struct Nearby {
    step: f64,
    tenths: i32,
    friction: Friction,
}

impl<S: Stands> Scene<'_, S> {
    /// Seeks the worst place between the places of a vehicle, proves what is carried where no answer was found, and asks cases without dilation
    /// in turn. What came of it, and by places the factors that are proven to be carried.
    fn worst(&self, found: &Found, step: f64, token: &CancelToken) -> (Found, Vec<Option<f64>>) {
        let governing: Vec<Answer> = found.places.iter().filter_map(|place| place.least).collect();
        let (mut end, mut sweepers) = (self.nothing(), self.sweepers(token));
        // Where cases are answered without dilation everywhere, places do not keep what locks.
        let locking = self.locking(&mut sweepers, &found.places, token);
        let Some(mut worst) = least(&governing) else {
            return (Found { level: locking, whole: !token.is_cancelled(), ..end }, Vec::new());
        };
        if step > 0.0 {
            let unanswered;
            let loads: Vec<Option<f64>> = found.places.iter().map(|place| Some(place.least?.factor)).collect();
            let low = dips(&loads, |k| found.places[k].at.drive == found.places[k + 1].at.drive);
            let low = low.into_iter().filter_map(|k| found.places[k].least).collect();
            let friction = match self.without_dilation {
                WithoutDilation::Everywhere(friction) => friction,
                WithoutDilation::InTurn(_) => Friction::Associated,
            };
            let nearby = Nearby { step, tenths: 10, friction };
            (worst, unanswered) = self.refined(&mut sweepers, (worst, low), &nearby, token);
            end.places.extend(unanswered);
            let again = self.answered_again(&mut sweepers, worst.key, token);
            let mut place = again.unwrap_or_else(|| Place::nothing(worst.key));
            worst = least(&[Some(worst), place.least].into_iter().flatten().collect::<Vec<_>>()).unwrap_or(worst);
            (place.at, place.least) = (worst.key, Some(worst));
            end.places.push(place);
        }
        if token.is_cancelled() {
            return (Found { worst: Some(worst), whole: false, ..end }, Vec::new());
        }
        let all = || found.places.iter().chain(&end.places);
        let settled = all().map(|place| self.settled(&mut sweepers, place, worst.factor)).collect();
        let sliding = all().filter_map(|place| place.slides).collect();
        let mut level = match self.without_dilation {
            WithoutDilation::InTurn(apart) => {
                let others = [spaced(governing, apart), spaced(sliding, apart)].concat();
                let level = self.in_turn(&mut sweepers, worst, others, token);
                let between = if step > 0.0 { apart } else { 0.0 };
                self.with_least_between(&mut sweepers, (worst, level), between, token)
            }
            WithoutDilation::Everywhere(_) => Vec::new(),
        };
        level.extend(locking);
        (Found { worst: Some(worst), level, whole: !token.is_cancelled(), ..end }, settled)
    }

    /// Cases without dilation, with the least of them between the places, so far apart [m], where one carries less than the worst with dilation: as far
    /// as the places beside it, that were asked where they may govern.
    fn with_least_between(
        &self,
        sweepers: &mut [Sweeper<'_>],
        (worst, mut level): (Answer, Vec<(Key, Option<f64>)>),
        apart: f64,
        token: &CancelToken,
    ) -> Vec<(Key, Option<f64>)> {
        let answer =
            |(key, factor): &(Key, Option<f64>)| Some(Answer { key: *key, factor: (*factor)?, upper: (*factor)? });
        let known: Vec<Answer> = level.iter().filter_map(answer).collect();
        if let Some(lowest) = least(&known).filter(|lowest| apart > 0.0 && lowest.factor < worst.factor) {
            let nearby = Nearby { step: 2.0 * apart, tenths: 5, friction: Friction::Automatic };
            let (between, _) = self.refined(sweepers, (lowest, vec![lowest]), &nearby, token);
            if between.factor < lowest.factor {
                level.push((between.key, Some(between.factor)));
            }
        }
        level
    }

    /// Everything at the place of a case; none where the work does not go on.
    fn answered_again(&self, sweepers: &mut [Sweeper<'_>], at: Key, token: &CancelToken) -> Option<Place> {
        let mut place = self.alone(sweepers, at, token)?;
        if let WithoutDilation::Everywhere(friction) = self.without_dilation {
            let tried = self.level(&place, friction, f64::INFINITY, token)?;
            place.take(tried);
        }
        Some(place)
    }

    /// The same by itself, with the first axle of the first drive at a position [m].
    pub(crate) fn by_itself(&self, position: f64, token: &CancelToken) -> Option<Place> {
        self.answered_again(&mut self.sweepers(token), Key::at(0, position), token)
    }

    /// The least beside some answers with the same cases, and places beside them without an answer.
    fn refined(
        &self,
        sweepers: &mut [Sweeper<'_>],
        (mut worst, mut beside): (Answer, Vec<Answer>),
        nearby: &Nearby,
        token: &CancelToken,
    ) -> (Answer, Vec<Place>) {
        let (mut tenth, mut unanswered) = (0.1 * nearby.step, Vec::new());
        for _ in 0..REFINEMENTS {
            let tenths = -nearby.tenths..=nearby.tenths;
            let around = |from: &Answer| {
                let position = |k: i32| (from.key, (from.key.position + tenth * f64::from(k), nearby.friction));
                tenths.clone().map(position).collect()
            };
            let all: Vec<(Key, (f64, Friction))> = beside.iter().flat_map::<Vec<_>, _>(around).collect();
            let asked: Vec<(Key, Least)> = match nearby.friction {
                Friction::Associated => all.iter().filter_map(|(key, at)| self.one(sweepers, key, *at)).collect(),
                // One case may take a second without dilation: each place is a piece of work of its own.
                _ => all.par_iter().filter_map(|(key, at)| self.one(&mut self.sweepers(token), key, *at)).collect(),
            };
            if token.is_cancelled() {
                break;
            }
            let mut answers = vec![worst];
            for (at, found) in asked {
                match found.factor {
                    Some(factor) => {
                        let upper = found.dilatant.upper.unwrap_or(factor);
                        answers.push(Answer { key: at, factor, upper });
                    }
                    None if found.status == Status::Locks => {}
                    None => {
                        let open = vec![(at, found.status == Status::NotConverged)];
                        unanswered.push(Place { open, ..Place::nothing(at) });
                    }
                }
            }
            worst = least(&answers).unwrap_or(worst);
            (beside, tenth) = (vec![worst], 0.1 * tenth);
        }
        (worst, unanswered)
    }

    /// What one case carries at another position as a friction says; none where it cannot stand there.
    pub(super) fn one(
        &self,
        sweepers: &mut [Sweeper<'_>],
        key: &Key,
        (position, friction): (f64, Friction),
    ) -> Option<(Key, Least)> {
        let (key, effect) = self.again(sweepers, key, position)?;
        Some((key, sweepers[key.weights].least(&effect, friction)))
    }

    /// The factor at a place with cases without an answer that cannot govern: one above the least of all others is proven to be carried with
    /// dilation, or where only the answer without is missing, blocks that rest are seen to carry it.
    fn settled(&self, sweepers: &mut [Sweeper<'_>], place: &Place, least: f64) -> Option<f64> {
        let mut lowest = place.least.map_or(f64::INFINITY, |least| least.factor);
        for (key, dilates) in &place.open {
            let carried = self.again(sweepers, key, key.position).and_then(|(key, effect)| match dilates {
                true => sweepers[key.weights].proven_up_to(&effect, DILATANCY * least),
                false => sweepers[key.weights].gives_way(&effect),
            });
            lowest = lowest.min(carried.unwrap_or(0.0));
        }
        // Where every load is carried, a number stands for it that does not govern.
        let lowest = if lowest.is_finite() { lowest } else { DILATANCY * least };
        (!place.open.is_empty() && lowest > least).then_some(lowest)
    }
}
