//! Cases answered without dilation: everywhere, or in turn as long as one may govern.

use super::super::parallel::{self, CancelToken, Stage};
use super::{Answer, DILATANCY, Key, Place, Scene, Stands, Tried, Turns};
use mechanics::limit::{Friction, Least, Status, Sweeper};
use mechanics::watch::Watch;
use rayon::prelude::*;

impl<S: Stands> Scene<'_, S> {
    /// Answers at every place the cases that may govern as a friction says; tells whether all of them were. Where the work does not go on,
    /// they are open.
    pub(super) fn level_everywhere(
        &self,
        (places, whole): (Vec<&mut Place>, bool),
        friction: Friction,
        shares: [f64; 2],
        watch: &mut dyn Watch,
    ) -> bool {
        let all = places.iter().flat_map(|place| &place.tried);
        let least = all.filter_map(|tried| tried.dilatant.lower).fold(f64::INFINITY, f64::min);
        let mut asked: Vec<&mut Place> = places
            .into_iter()
            .filter(|place| place.tried.iter().any(|tried| tried.is_asked(friction, least)))
            .collect();
        let steps = asked.len() as u64;
        let stage = Stage { name: "places without dilation", steps, shares };
        let (found, done) = match whole {
            true => parallel::each(&asked, &stage, watch, |place, token| {
                let tried = self.level(place, friction, least, token);
                token.step();
                tried
            }),
            false => (asked.iter().map(|_| None).collect(), false),
        };
        for (place, found) in asked.iter_mut().zip(found) {
            let tried = found.flatten().unwrap_or_else(|| {
                let open = |tried: &Tried| match tried.is_asked(friction, least) {
                    true => Tried { level: Some(cancelled(tried)), ..tried.clone() },
                    false => tried.clone(),
                };
                place.tried.iter().map(open).collect()
            });
            place.take(tried);
        }
        done
    }

    /// The cases at a place, those that may govern beside a least factor as a friction says; none where the work does not go on.
    pub(super) fn level(
        &self,
        place: &Place,
        friction: Friction,
        least: f64,
        token: &CancelToken,
    ) -> Option<Vec<Tried>> {
        let mut sweepers = self.sweepers(token);
        let cases = self.stands.cases(&mut sweepers[0], place.at.drive, place.at.position);
        let answered = |tried: &Tried| {
            let own = Key { weights: 0, ..tried.key };
            let Some((_, effect)) = cases.iter().find(|(key, _)| *key == own) else { return tried.clone() };
            if !tried.is_asked(friction, least) {
                return tried.clone();
            }
            let effect = self.under(effect, tried.key.weights);
            let mut sweeper = self.grounds[tried.key.weights].sweeper().paced(token);
            Tried { level: Some(sweeper.least_beside(&effect, friction, tried.dilatant)), ..tried.clone() }
        };
        let tried: Vec<Tried> = place.tried.par_iter().map(answered).collect();
        (!token.is_cancelled()).then_some(tried)
    }

    /// Cases from the least factor with dilation up, as long as one may govern: each with what it carries without, none where that is not
    /// known. Cases that do not slide are left out.
    pub(super) fn in_turn(
        &self,
        sweepers: &mut [Sweeper<'_>],
        worst: Answer,
        mut others: Vec<Answer>,
        token: &CancelToken,
    ) -> Vec<(Key, Option<f64>)> {
        others.sort_by(|a, b| a.factor.total_cmp(&b.factor));
        others.dedup_by(|a, b| a.key == b.key);
        let (mut turns, mut level) = (Turns::from(worst.factor), Vec::new());
        for answer in std::iter::once(worst).chain(others) {
            if !turns.may_govern(answer.factor) || token.is_cancelled() {
                break;
            }
            let Some((_, found)) = self.one(sweepers, &answer.key, (answer.key.position, Friction::Automatic)) else {
                break;
            };
            if token.is_cancelled() {
                break;
            }
            if let Some(own) = found.factor {
                turns.met(answer.factor, own);
            }
            if found.friction != Friction::Associated {
                level.push((answer.key, found.factor));
            }
        }
        level
    }

    /// The same of cases that lock with dilation: of neighbours that lock, from those beside others inwards until one locks without it too.
    pub(super) fn locking(
        &self,
        sweepers: &mut [Sweeper<'_>],
        places: &[Place],
        token: &CancelToken,
    ) -> Vec<(Key, Option<f64>)> {
        let mut level = Vec::new();
        for way in ways(places) {
            for key in way {
                let found = self.again(sweepers, &key, key.position).filter(|_| !token.is_cancelled());
                let Some((key, effect)) = found else { return level };
                match sweepers[key.weights].gives_way(&effect) {
                    Some(f64::INFINITY) => break,
                    factor => level.push((key, factor)),
                }
            }
        }
        level
    }
}

/// Cases that lock at neighbouring places of a drive, from both ends inwards but for the ends of the drive, where loads leave the bridge; each by
/// itself where all of a drive locks.
fn ways(places: &[Place]) -> Vec<Vec<Key>> {
    let mut ways = Vec::new();
    for drive in places.chunk_by(|a, b| a.at.drive == b.at.drive) {
        let mut from = 0;
        for run in drive.chunk_by(|a, b| a.locks.is_some() == b.locks.is_some()) {
            let keys: Vec<Key> = run.iter().filter_map(|place| place.locks).collect();
            let (is_first, is_last) = (from == 0, from + run.len() == drive.len());
            from += run.len();
            if is_first && is_last {
                ways.extend(keys.iter().map(|key| vec![*key]));
                continue;
            }
            if !is_last {
                ways.push(keys.iter().rev().copied().collect());
            }
            if !is_first {
                ways.push(keys);
            }
        }
    }
    ways
}

impl Tried {
    /// Whether it may govern without dilation beside a least factor.
    fn is_asked(&self, friction: Friction, least: f64) -> bool {
        let locks = self.dilatant.status == Status::Locks;
        match friction {
            Friction::Associated => false,
            Friction::NonAssociated => locks || self.dilatant.status == Status::Solved,
            Friction::Automatic => locks || self.dilatant.lower.is_some_and(|factor| factor <= DILATANCY * least),
        }
    }
}

/// Nobody knows whether a case slides.
fn cancelled(tried: &Tried) -> Least {
    let (dilatant, factor) = (tried.dilatant, tried.dilatant.lower);
    Least { dilatant, status: Status::Cancelled, factor, friction: Friction::Associated, falls_to: None }
}
