//! Every case answered: least adequacy factors, and the worst position between the positions.

use super::super::engine::rigid;
use super::super::parallel::{self, CancelToken, Stage};
use super::AnalysisError;
use super::cases::{borders, drives, reach};
use super::factored::{self, Footprint, footprint};
use super::least::{Answer, least};
use super::sections::{Extremes, Watched, watched};
use super::seeds::seeds;
use super::standing::{Key, Scene};
use super::turns::Turns;
use super::twins::twins;
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use mechanics::limit::{self, Effect, Friction, Ground, Sweeper};
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::vehicles::Weights;
use outcome::vehicles::{Case, EnvelopePoint, Swept};
use rules::Rule;
use structure::discretise::Discretised;

/// Positions that are answered one after the other, each starting from the mechanisms of those before it. Fixed, so that
/// the numbers do not depend on the number of threads.
const CHUNK: usize = 24;
/// Where cases are slow, one is left out whose upper bound by the mechanisms met before is this many times above the least factor
/// at its position, and as many times more as such bounds lay above the answers at the position before.
pub(super) const FAR_ABOVE: f64 = 1.25;
/// How many times too high bounds are taken to be before any was held against an answer.
const LOOSE: f64 = 2.0;
/// Bounds are held against answers up to this multiple of the least factor; what lies above does not count.
const NEAR: f64 = 2.0;
/// Cases in which joints slide count from this multiple of the least factor down: dilatancy is worth up to half of an
/// associated load in walls of blocks (docs/theory/limit-analysis.md), less in arches.
pub(crate) const DILATANCY: f64 = 2.0;
/// Refinements of the worst position, each to a tenth.
pub(crate) const REFINEMENTS: usize = 2;

/// Result of one load case.
enum CaseResult {
    /// A load factor.
    Factor(Answer),
    /// Every load is carried.
    Locks,
    /// Nothing is known.
    Open,
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

/// What came of some positions of one drive.
struct Part {
    drive: usize,
    envelope: Vec<EnvelopePoint>,
    /// What governs at each position where anything does.
    governing: Vec<Answer>,
    /// The lowest case in which joints slide at each position where they do.
    sliding: Vec<Answer>,
    /// Cases without an answer.
    open: Vec<Open>,
    extremes: Extremes<Key>,
    cases: usize,
    slow: usize,
}

/// A case of which no largest factor was found.
#[derive(Debug, Clone, Copy)]
struct Open {
    key: Key,
    /// The least factor of the others at its position.
    least: Option<f64>,
}

impl Part {
    /// Nothing of a drive yet.
    fn of(drive: usize, watched: &[Watched]) -> Part {
        let extremes = Extremes::new(watched);
        Part {
            drive,
            envelope: Vec::new(),
            governing: Vec::new(),
            sliding: Vec::new(),
            open: Vec::new(),
            extremes,
            cases: 0,
            slow: 0,
        }
    }
}

/// Share of the work that all positions are; the rest seeks the worst ones.
const POSITIONS: f64 = 0.8;

/// Answers every case of every vehicle under every combination of factors on weights, with or without cases left out by a `screen`.
/// Where the onlooker wishes to stop, vehicles that were not finished say so.
pub(super) fn all(
    bridge: &Bridge,
    (rule, plan): (&Rule, &SweepPlan),
    (vehicles, weights): (&[Chosen], &[Weights]),
    (step, screen): (f64, bool),
    watch: &mut dyn Watch,
) -> Result<Vec<Swept>, AnalysisError> {
    let bridges: Vec<Bridge> = weights.iter().map(|w| factored::bridge(bridge, rule, w)).collect();
    let bridge = &bridges[0];
    let built: Vec<Discretised> = bridges.iter().map(rigid::prepared).collect::<Result<_, _>>()?;
    let settings = limit::Settings { friction: limit::Friction::Associated, ..rigid::settings(bridge) };
    let mut grounds = Vec::with_capacity(built.len());
    for d in &built {
        grounds.push(Ground::new(&d.model, &d.loading, &settings)?);
    }
    let d = &built[0];
    let watched = watched(bridge, d, &grounds[0]);
    let feet: Vec<Footprint> = vehicles.iter().map(|v| footprint(bridge, plan, rule, v)).collect();
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut all_drives = Vec::new();
    for (k, (chosen, foot)) in vehicles.iter().zip(&feet).enumerate() {
        let own = reach(d, foot.length, foot.dispersal.slope);
        range = [range[0].min(own[0]), range[1].max(own[1])];
        all_drives.extend(drives(k, &chosen.vehicle, plan, own, step));
    }
    let borders = borders(bridge, range);
    let twins = twins(vehicles, &feet);
    let seeds = match screen && !grounds[0].is_fast() {
        true => parallel::alone("mechanisms to begin with", false, watch, |token| {
            seeds(bridge, d, &grounds[0], &feet[0], token)
        }),
        false => Vec::new(),
    };
    let scene = Scene {
        d,
        grounds: &grounds,
        weights,
        watched: &watched,
        feet: &feet,
        drives: &all_drives,
        borders: &borders,
        capacity: rule.capacity_factor(),
        screen,
        twins: &twins,
        seeds: &seeds,
    };
    if let Some(falls) = grounds.iter().position(|ground| !ground.stands()) {
        return Ok(vehicles.iter().zip(&feet).map(|(v, foot)| fallen(v, foot, weights[falls])).collect());
    }
    let jobs: Vec<(usize, &[f64])> = all_drives
        .iter()
        .enumerate()
        .flat_map(|(k, drive)| drive.positions.chunks(CHUNK).map(move |positions| (k, positions)))
        .collect();
    // Vehicles that another answers take no time to speak of.
    let own = all_drives.iter().filter(|drive| twins[drive.vehicle].is_none());
    let steps = own.map(|drive| drive.positions.len() as u64).sum();
    let stage = Stage { name: "positions of vehicles", steps, shares: [0.0, POSITIONS] };
    let (parts, _) =
        parallel::each(&jobs, &stage, watch, |(drive, positions), token| scene.part(*drive, positions, token));
    let mut of_vehicle: Vec<Parts> = vehicles.iter().map(|_| Parts { parts: Vec::new(), whole: true }).collect();
    for (part, (drive, positions)) in parts.into_iter().zip(&jobs) {
        let of = &mut of_vehicle[all_drives[*drive].vehicle];
        of.whole &= part.as_ref().is_some_and(|part| part.envelope.len() == positions.len());
        of.parts.extend(part);
    }
    let each: Vec<(usize, Parts)> = of_vehicle.into_iter().enumerate().collect();
    let own: Vec<&(usize, Parts)> = each.iter().filter(|(k, _)| twins[*k].is_none()).collect();
    let stage = Stage { name: "worst positions of vehicles", steps: own.len() as u64, shares: [POSITIONS, 1.0] };
    let (found, _) =
        parallel::each(&own, &stage, watch, |(k, parts), token| scene.gathered(*k, &vehicles[*k], parts, step, token));
    let mut swept: Vec<Option<Swept>> = vehicles.iter().map(|_| None).collect();
    for (found, (k, parts)) in found.into_iter().zip(own) {
        swept[*k] =
            Some(found.unwrap_or_else(|| scene.gathered(*k, &vehicles[*k], parts, step, &CancelToken::cancelled())));
    }
    for (k, parts) in &each {
        if let Some(twin) = twins[*k] {
            swept[*k] = swept[twin.of].as_ref().map(|of| scene.like(of, twin.times, &vehicles[*k], &feet[*k], parts));
        }
    }
    Ok(swept.into_iter().flatten().collect())
}

/// What came of the positions of one vehicle.
struct Parts {
    parts: Vec<Part>,
    /// Whether all of them were answered.
    whole: bool,
}

impl Scene<'_> {
    /// Positions of one drive, one after the other.
    fn part(&self, drive: usize, positions: &[f64], token: &CancelToken) -> Part {
        let mut sweepers: Vec<Sweeper> = self.grounds.iter().map(|ground| ground.sweeper().paced(token)).collect();
        sweepers.iter_mut().for_each(|sweeper| sweeper.take(self.seeds));
        let mut part = Part::of(drive, self.watched);
        let (mut looseness, mut slow) = (LOOSE, !self.grounds[0].is_fast());
        for &position in positions {
            let before = part.slow;
            let bounds = (self.screen && slow).then_some(looseness);
            match self.position(&mut sweepers, &mut part, position, bounds, token) {
                Some(found) => looseness = found,
                None => break,
            }
            if self.twins[self.drives[drive].vehicle].is_none() {
                token.step();
            }
            slow = part.slow > before;
        }
        part
    }

    /// Answers one position, but for slow cases that need no answer: those whose bound, though `looseness` times too high, still lies far
    /// above the least; None asks for no bounds. Gives how many times the bounds lay above the answers here. None where the work does not go on: a position that
    /// is broken off is not told.
    fn position(
        &self,
        sweepers: &mut [Sweeper],
        part: &mut Part,
        position: f64,
        looseness: Option<f64>,
        token: &CancelToken,
    ) -> Option<f64> {
        let mut waiting = self.waiting(sweepers, part, position, looseness.is_some());
        let (mut lowest, mut open) = (f64::INFINITY, Vec::new());
        let mut answered: Vec<(usize, Answer)> = Vec::with_capacity(waiting.len());
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
            let by_interior_point = part.slow;
            let met = self.answer(&mut sweepers[key.weights], part, key, &effect);
            if token.is_cancelled() {
                return None;
            }
            match met {
                CaseResult::Factor(answer) => {
                    bounded.push([at_most, answer.factor]);
                    answered.push((order, answer));
                    lowest = lowest.min(answer.factor);
                }
                CaseResult::Locks => {}
                CaseResult::Open => open.push(key),
            }
            if part.slow > by_interior_point {
                share_newest(sweepers, key.weights);
                for other in waiting.iter_mut().filter(|_| looseness.is_some()) {
                    let bound = sweepers[other.key.weights].at_most_by_newest(&other.effect);
                    other.at_most = other.at_most.min(bound);
                }
            }
        }
        answered.sort_by_key(|(order, _)| *order);
        let least = least(&answered.into_iter().map(|(_, answer)| answer).collect::<Vec<_>>());
        part.governing.extend(least);
        let converged = open.is_empty();
        part.open.extend(open.into_iter().map(|key| Open { key, least: least.map(|least| least.factor) }));
        let empty = Key { drive: part.drive, weights: 0, position, axles: None, critical: None, uniform: None };
        part.envelope.push(EnvelopePoint {
            converged,
            adequacy: least.filter(|_| converged).map(|l| l.factor * self.capacity),
            weights: least.map(|l| self.weights[l.key.weights]),
            ..self.point(&least.map_or(empty, |l| l.key))
        });
        let near = least.map_or(0.0, |least| NEAR * least.factor);
        let times = bounded.iter().filter(|[_, factor]| *factor <= near).map(|[bound, factor]| bound / factor);
        Some(times.fold(1.0, f64::max))
    }

    /// Every case at a position that is to be answered, after a look at what it does to the watched joints: none of a vehicle whose
    /// answers are those of another.
    fn waiting(&self, sweepers: &mut [Sweeper], part: &mut Part, position: f64, bounds: bool) -> Vec<Waiting> {
        let mut waiting = Vec::new();
        let answered_by_another = self.twins[self.drives[part.drive].vehicle].is_some();
        for (key, effect) in self.cases(&mut sweepers[0], part.drive, position) {
            for (weights, sweeper) in sweepers.iter().enumerate() {
                let key = Key { weights, ..key };
                let effect = self.under(&effect, weights);
                part.extremes.look(&self.grounds[weights], self.watched, &effect, || key);
                if !answered_by_another {
                    let at_most = if bounds { sweeper.at_most(&effect) } else { f64::INFINITY };
                    waiting.push(Waiting { order: waiting.len(), key, effect, at_most });
                }
            }
        }
        // In reverse, so that the next one is taken from the end.
        waiting.reverse();
        waiting
    }

    /// One case under one combination of weights.
    fn answer(&self, sweeper: &mut Sweeper, part: &mut Part, key: Key, effect: &Effect) -> CaseResult {
        part.cases += 1;
        let found = sweeper.factor(effect);
        part.slow += usize::from(found.by_interior_point);
        let (Some(factor), Some(upper)) = (found.lower, found.upper) else {
            return if found.status == limit::Status::Locks { CaseResult::Locks } else { CaseResult::Open };
        };
        let answer = Answer { key, factor, upper };
        if found.slides {
            match part.sliding.last_mut().filter(|last| last.key.position == key.position) {
                Some(last) if last.factor <= factor => {}
                Some(last) => *last = answer,
                None => part.sliding.push(answer),
            }
        }
        CaseResult::Factor(answer)
    }

    /// All parts of one vehicle. An adequacy factor stands only where every position was answered and the worst one sought.
    fn gathered(&self, index: usize, chosen: &Chosen, all: &Parts, step: f64, token: &CancelToken) -> Swept {
        let foot = &self.feet[index];
        let mut swept = blank(chosen, foot);
        let mut extremes = Extremes::new(self.watched);
        let (mut governing, mut sliding): (Vec<Answer>, Vec<Answer>) = (Vec::new(), Vec::new());
        let mut open: Vec<Open> = Vec::new();
        for part in &all.parts {
            swept.envelope.extend(part.envelope.iter().cloned());
            swept.cases += part.cases;
            swept.by_interior_point += part.slow;
            extremes.merge(part.extremes.clone());
            sliding.extend(&part.sliding);
            governing.extend(&part.governing);
            open.extend(&part.open);
        }
        swept.sections = extremes.told(self.watched, |key| self.told(key));
        let Some(worst) = least(&governing) else {
            swept.end(all.whole, None);
            return swept;
        };
        let mut sweepers: Vec<Sweeper> = self.grounds.iter().map(|ground| ground.sweeper().paced(token)).collect();
        let (worst, mut unanswered) = self.refined(&mut sweepers, worst, step, token);
        let again = self.answered_again(&mut sweepers, &worst, token);
        let worst = least(&[vec![worst], again.governing].concat()).unwrap_or(worst);
        unanswered.extend(again.open);
        open.extend(&unanswered);
        swept.envelope.extend(unanswered.into_iter().map(|key| EnvelopePoint {
            adequacy: None,
            converged: false,
            ..self.point(&key.key)
        }));
        swept.envelope.push(EnvelopePoint { adequacy: Some(worst.factor * self.capacity), ..self.point(&worst.key) });
        swept.bounds = Some([worst.factor, worst.upper].map(|f| f * self.capacity));
        self.settle(&mut sweepers, &mut swept, &open, worst.factor);
        // The refined position comes first: it may slide too.
        let mut others = [governing, sliding, again.sliding].concat();
        others.sort_by(|a, b| a.factor.total_cmp(&b.factor));
        others.dedup_by(|a, b| a.key == b.key);
        let (mut governing, mut turns) = ((worst.factor, worst.key), Turns::from(worst.factor));
        for answer in std::iter::once(worst).chain(others) {
            if token.is_cancelled() || !turns.may_govern(answer.factor) {
                break;
            }
            let Some((key, effect)) = self.again(&mut sweepers, &answer.key, answer.key.position) else { continue };
            let found = sweepers[key.weights].least(&effect, Friction::Automatic);
            if token.is_cancelled() {
                break;
            }
            if let Some(own) = found.factor {
                turns.met(answer.factor, own);
            }
            if found.friction == Friction::Associated {
                continue;
            }
            let level = found.factor.map(|level| level * self.capacity);
            swept.slides_at(&self.point(&key), level);
            if let Some(adequacy) = level {
                swept.without_dilation = Some(swept.without_dilation.map_or(adequacy, |old| old.min(adequacy)));
                if adequacy < governing.0 * self.capacity {
                    governing = (adequacy / self.capacity, key);
                }
            }
        }
        swept.weights = Some(self.weights[governing.1.weights]);
        swept.case = Some(self.told(&governing.1));
        swept.end(all.whole && !token.is_cancelled(), Some(governing.0 * self.capacity));
        token.step();
        swept
    }

    /// Cases without an answer that cannot govern: a factor above the least of all others is proven to be carried. Their positions count as
    /// answered, by no more than that.
    fn settle(&self, sweepers: &mut [Sweeper], swept: &mut Swept, open: &[Open], least: f64) {
        for at in open.chunk_by(|a, b| a.key.position == b.key.position && a.key.drive == b.key.drive) {
            let mut lowest = at[0].least.unwrap_or(f64::INFINITY);
            for Open { key, .. } in at {
                let carried = self
                    .again(sweepers, key, key.position)
                    .and_then(|(key, effect)| sweepers[key.weights].proven_up_to(&effect, DILATANCY * least));
                lowest = lowest.min(carried.unwrap_or(0.0));
            }
            if lowest > least {
                swept.is_settled(&self.point(&at[0].key), lowest * self.capacity);
            }
        }
    }

    /// A vehicle whose loads are so many times those of one that was answered: the same cases govern, by factors that are so many
    /// times smaller. What its loads do to the watched joints is its own.
    fn like(&self, of: &Swept, times: f64, chosen: &Chosen, foot: &Footprint, all: &Parts) -> Swept {
        let mut extremes = Extremes::new(self.watched);
        all.parts.iter().for_each(|part| extremes.merge(part.extremes.clone()));
        let less = |factor: Option<f64>| factor.map(|factor| factor / times);
        Swept {
            status: if all.whole { of.status } else { Status::Cancelled },
            adequacy: less(of.adequacy).filter(|_| all.whole),
            adequacy_at_most: less(of.adequacy_at_most.or(of.adequacy.filter(|_| !all.whole))),
            positions_not_converged: of.positions_not_converged,
            bounds: of.bounds.map(|both| both.map(|bound| bound / times)),
            without_dilation: less(of.without_dilation),
            case: of.case.clone().map(|case| Case { load: case.load * times, ..case }),
            weights: of.weights,
            envelope: of
                .envelope
                .iter()
                .map(|point| EnvelopePoint { adequacy: less(point.adequacy), ..point.clone() })
                .collect(),
            sections: extremes.told(self.watched, |key| self.told(key)),
            by_interior_point: of.by_interior_point,
            ..blank(chosen, foot)
        }
    }

    /// A case's place in the envelope, without its factor.
    fn point(&self, key: &Key) -> EnvelopePoint {
        EnvelopePoint::at(&self.placed(key))
    }

    /// The worst position between the positions with every case: beside the positions another one may govern.
    fn answered_again(&self, sweepers: &mut [Sweeper], worst: &Answer, token: &CancelToken) -> Part {
        let mut part = Part::of(worst.key.drive, self.watched);
        let bounds = (self.screen && !self.grounds[0].is_fast()).then_some(LOOSE);
        // A place that is broken off is not told: the vehicle is not finished then.
        let _ = self.position(sweepers, &mut part, worst.key.position, bounds, token);
        part
    }

    /// The worst position between the positions, with the same axles and weights, and those that were not answered.
    fn refined(
        &self,
        sweepers: &mut [Sweeper],
        mut worst: Answer,
        step: f64,
        token: &CancelToken,
    ) -> (Answer, Vec<Open>) {
        let (mut width, mut open) = (step, Vec::new());
        for _ in 0..REFINEMENTS {
            let mut answers = vec![worst];
            for k in -10..=10 {
                let position = worst.key.position + 0.1 * width * f64::from(k);
                let Some((key, effect)) = self.again(sweepers, &worst.key, position) else { continue };
                let found = sweepers[key.weights].factor(&effect);
                if token.is_cancelled() {
                    break;
                }
                match (found.lower, found.upper) {
                    (Some(factor), Some(upper)) => answers.push(Answer { key, factor, upper }),
                    _ if found.status != limit::Status::Locks => open.push(Open { key, least: None }),
                    _ => {}
                }
            }
            worst = least(&answers).unwrap_or(worst);
            width *= 0.1;
        }
        (worst, open)
    }
}

/// The case to answer next: the one with the least bound, those without a bound in their order, last.
fn next(waiting: &[Waiting]) -> Option<usize> {
    let last = waiting.len().checked_sub(1)?;
    Some((0..last).rev().fold(last, |best, k| if waiting[k].at_most < waiting[best].at_most { k } else { best }))
}

/// What was learnt under some weights bounds loads under all of them.
fn share_newest(sweepers: &mut [Sweeper], from: usize) {
    let Some(motion) = sweepers[from].newest_motion().map(<[f64]>::to_vec) else { return };
    for (k, sweeper) in sweepers.iter_mut().enumerate() {
        if k != from {
            sweeper.learn(&motion);
        }
    }
}

/// A vehicle of which nothing is known yet.
fn blank(chosen: &Chosen, foot: &Footprint) -> Swept {
    Swept {
        code: chosen.vehicle.code.clone(),
        title: chosen.vehicle.title.clone(),
        model: chosen.model.clone(),
        grade: chosen.grade.clone(),
        status: Status::Locks,
        adequacy: None,
        adequacy_at_most: None,
        positions_not_converged: 0,
        bounds: None,
        without_dilation: None,
        case: None,
        weights: None,
        envelope: Vec::new(),
        sections: Vec::new(),
        effective_width: foot.across.axles,
        across: foot.across.clone(),
        load_factors: [foot.all(), foot.critical],
        span_factors: foot.spans.iter().map(|span| span.axles).collect(),
        acting: chosen.acting.clone(),
        source: chosen.source.clone(),
        cases: 0,
        by_interior_point: 0,
        rigid: None,
        deformable: None,
        not_counted: Default::default(),
    }
}

/// A vehicle over a bridge that does not carry its own weight with these factors.
fn fallen(chosen: &Chosen, foot: &Footprint, weights: Weights) -> Swept {
    Swept { status: Status::UnstableUnderSelfWeight, weights: Some(weights), ..blank(chosen, foot) }
}
