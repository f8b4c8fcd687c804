//! Everything that may stand at a place, answered with dilation.

use super::super::parallel::CancelToken;
use super::least::{Answer, least};
use super::sections::Extremes;
use super::{Key, Scene, Stands, WithoutDilation};
use mechanics::limit::{Effect, Factor, Least, Status, Sweeper};

/// Where cases are slow, one is left out whose upper bound by the mechanisms met before is this many times above the least factor
/// at its position, and as many times more as such bounds lay above the answers at the position before.
pub(crate) const FAR_ABOVE: f64 = 1.25;
/// How many times too high bounds are taken to be before any was held against an answer.
const LOOSE: f64 = 2.0;
/// Bounds are held against answers up to this multiple of the least factor; what lies above does not count.
const NEAR: f64 = 2.0;

/// A case that was asked, where all of them are kept.
#[derive(Debug, Clone)]
pub(crate) struct Tried {
    pub key: Key,
    pub dilatant: Factor,
    /// What the plan's friction makes of it, once that is known.
    pub level: Option<Least>,
}

impl Tried {
    /// How it ended, as far as it is known.
    pub(crate) fn status(&self) -> Status {
        self.level.as_ref().map_or(self.dilatant.status, |level| level.status)
    }

    /// The factor that counts.
    pub(crate) fn factor(&self) -> Option<f64> {
        self.level.as_ref().map_or(self.dilatant.lower, |level| level.factor)
    }

    pub(super) fn answer(&self) -> Option<Answer> {
        let factor = self.factor()?;
        Some(Answer { key: self.key, factor, upper: self.dilatant.upper.unwrap_or(factor) })
    }
}

/// One place of a drive.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// Drive and position; nothing stands there.
    pub at: Key,
    /// What governs, where anything does.
    pub least: Option<Answer>,
    /// Cases without an answer, and whether that is so with dilation already: what they carry may be proven then.
    pub open: Vec<(Key, bool)>,
    /// Every case that was asked, where cases are answered without dilation everywhere.
    pub tried: Vec<Tried>,
    /// The lowest case in which joints slide.
    pub slides: Option<Answer>,
    /// Of the cases that lock the one with most on the bridge: without dilation it may fall.
    pub locks: Option<Key>,
    /// The factor that is proven to be carried by all cases without an answer, where it stands in place of theirs.
    pub settled: Option<f64>,
}

/// What came of some places of one drive, or of one vehicle.
pub(crate) struct Found {
    /// Every place in order; of a vehicle then places without an answer beside the worst one, and the worst one.
    pub places: Vec<Place>,
    /// How many of them lie between the positions.
    pub between: usize,
    pub extremes: Extremes,
    /// How many cases were asked, and of how many the interior-point method had to help.
    pub cases: usize,
    pub slow: usize,
    /// Whether all of it was done.
    pub whole: bool,
    /// The least with dilation, or as the plan's friction says where that was asked everywhere.
    pub worst: Option<Answer>,
    /// Cases that were asked in turn, with what they carry without dilation.
    pub level: Vec<(Key, Option<f64>)>,
}

/// A case that is still to be answered.
struct Waiting {
    /// Its place among the cases of the position.
    order: usize,
    key: Key,
    effect: Effect,
    /// Upper bound of its factor by the mechanisms met so far.
    at_most: f64,
}

impl<S: Stands> Scene<'_, S> {
    /// Nothing yet.
    pub(super) fn nothing(&self) -> Found {
        let (places, extremes, level) = (Vec::new(), Extremes::new(self.watched), Vec::new());
        Found { places, between: 0, extremes, cases: 0, slow: 0, whole: true, worst: None, level }
    }

    /// Places of one drive, one after the other; `alike` where another vehicle's answers count for it.
    pub(super) fn along(&self, (drive, alike): (usize, bool), positions: &[f64], token: &CancelToken) -> Found {
        let mut sweepers = self.sweepers(token);
        sweepers.iter_mut().for_each(|sweeper| sweeper.take(self.seeds));
        let mut part = self.nothing();
        let (mut looseness, mut slow) = (LOOSE, !self.grounds[0].is_fast());
        for &position in positions {
            let before = part.slow;
            let bounds = (self.screen && slow).then_some(looseness);
            let waiting = self.waiting(&mut sweepers, &mut part, (drive, position), (bounds.is_some(), alike));
            match self.place(&mut sweepers, &mut part, (Key::at(drive, position), waiting), bounds, token) {
                Some(found) => looseness = found,
                None => break,
            }
            if !alike {
                token.step();
            }
            slow = part.slow > before;
        }
        part
    }

    /// One place by itself; none where the work does not go on.
    pub(super) fn alone(&self, sweepers: &mut [Sweeper<'_>], at: Key, token: &CancelToken) -> Option<Place> {
        let mut part = self.nothing();
        let bounds = (self.screen && !self.grounds[0].is_fast()).then_some(LOOSE);
        let waiting = self.waiting(sweepers, &mut part, (at.drive, at.position), (bounds.is_some(), false));
        self.place(sweepers, &mut part, (Key::at(at.drive, at.position), waiting), bounds, token)?;
        part.places.pop()
    }

    /// Answers what waits at one place, but for slow cases that need no answer: those whose bound, though `looseness` times too high, still
    /// lies far above the least; None asks for no bounds. Gives how many times the bounds lay above the answers here. None where the work does
    /// not go on: a place that is broken off is not told.
    fn place(
        &self,
        sweepers: &mut [Sweeper<'_>],
        part: &mut Found,
        (at, mut waiting): (Key, Vec<Waiting>),
        looseness: Option<f64>,
        token: &CancelToken,
    ) -> Option<f64> {
        let mut lowest = f64::INFINITY;
        let mut asked: Vec<(usize, Tried)> = Vec::with_capacity(waiting.len());
        let mut bounded: Vec<[f64; 2]> = Vec::new();
        while let Some(next) = next(&waiting) {
            if token.is_cancelled() {
                return None;
            }
            let Waiting { order, key, effect, at_most } = waiting.remove(next);
            let margin = FAR_ABOVE * looseness.unwrap_or(f64::INFINITY);
            if at_most.is_finite() && lowest.is_finite() && at_most > margin * lowest {
                continue;
            }
            part.cases += 1;
            let dilatant = sweepers[key.weights].factor(&effect);
            if token.is_cancelled() {
                return None;
            }
            if let Some(factor) = dilatant.lower {
                bounded.push([at_most, factor]);
                lowest = lowest.min(factor);
            }
            if dilatant.by_interior_point {
                part.slow += 1;
                share_newest(sweepers, key.weights);
                for other in waiting.iter_mut().filter(|_| looseness.is_some()) {
                    let bound = sweepers[other.key.weights].at_most_by_newest(&other.effect);
                    other.at_most = other.at_most.min(bound);
                }
            }
            asked.push((order, Tried { key, dilatant, level: None }));
        }
        let sliding = asked.iter().filter(|(_, tried)| tried.dilatant.slides).filter_map(|(_, tried)| tried.answer());
        let slides = sliding.min_by(|a, b| a.factor.total_cmp(&b.factor));
        asked.sort_by_key(|(order, _)| *order);
        let locking = asked.iter().map(|(_, tried)| tried).filter(|tried| tried.dilatant.status == Status::Locks);
        let locks = locking.map(|tried| tried.key).max_by_key(Key::extent);
        let mut place = Place { slides, locks, ..Place::nothing(at) };
        place.take(asked.into_iter().map(|(_, tried)| tried).collect());
        let near = place.least.map_or(0.0, |least| NEAR * least.factor);
        let times = bounded.iter().filter(|[_, factor]| *factor <= near).map(|[bound, factor]| bound / factor);
        let times = times.fold(1.0, f64::max);
        match self.without_dilation {
            WithoutDilation::InTurn(_) => place.tried = Vec::new(),
            WithoutDilation::Everywhere(_) => place.locks = None,
        }
        part.places.push(place);
        Some(times)
    }

    /// Every case at a place that is to be answered, after a look at what it does to the watched joints: none of a vehicle whose
    /// answers are those of another.
    fn waiting(
        &self,
        sweepers: &mut [Sweeper<'_>],
        part: &mut Found,
        (drive, position): (usize, f64),
        (bounds, alike): (bool, bool),
    ) -> Vec<Waiting> {
        let mut waiting = Vec::new();
        for (key, effect) in self.stands.cases(&mut sweepers[0], drive, position) {
            for (weights, sweeper) in sweepers.iter().enumerate() {
                let key = Key { weights, ..key };
                let effect = self.under(&effect, weights);
                part.extremes.look(&self.grounds[weights], self.watched, &effect, key);
                if !alike {
                    let at_most = if bounds { sweeper.at_most(&effect) } else { f64::INFINITY };
                    waiting.push(Waiting { order: waiting.len(), key, effect, at_most });
                }
            }
        }
        // In reverse, so that the next one is taken from the end.
        waiting.reverse();
        waiting
    }
}

impl Place {
    /// A place at which nothing was asked.
    pub(super) fn nothing(at: Key) -> Place {
        Place { at, least: None, open: Vec::new(), tried: Vec::new(), slides: None, locks: None, settled: None }
    }

    /// Takes what came of every case.
    pub(super) fn take(&mut self, tried: Vec<Tried>) {
        let answers: Vec<Answer> = tried.iter().filter_map(Tried::answer).collect();
        let open = tried.iter().filter(|tried| tried.status() == Status::NotConverged);
        self.open = open.map(|tried| (tried.key, tried.dilatant.status == Status::NotConverged)).collect();
        (self.least, self.tried) = (least(&answers), tried);
    }
}

/// The case to answer next: the one with the least bound, those without a bound in their order, last.
fn next(waiting: &[Waiting]) -> Option<usize> {
    let last = waiting.len().checked_sub(1)?;
    Some((0..last).rev().fold(last, |best, k| if waiting[k].at_most < waiting[best].at_most { k } else { best }))
}

/// What was learnt under some weights bounds loads under all of them.
fn share_newest(sweepers: &mut [Sweeper<'_>], from: usize) {
    let Some(motion) = sweepers[from].newest_motion().map(<[f64]>::to_vec) else { return };
    for (k, sweeper) in sweepers.iter_mut().enumerate() {
        if k != from {
            sweeper.learn(&motion);
        }
    }
}
