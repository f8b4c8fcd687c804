//! Every case answered: least adequacy factors, and the worst position between the positions.

use super::super::by_limit;
use super::super::pieces::{self, Pace, Stage};
use super::super::report::Status;
use super::cases::{borders, drives, reach};
use super::factored::{self, Footprint, footprint};
use super::sections::{Extremes, watched};
use super::standing::{Key, Scene};
use super::weights::Weights;
use super::{AnalysisError, Direction, EnvelopePoint, Swept};
use crate::discretise::Discretised;
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use mechanics::limit::{self, Effect, Ground, Sweeper};
use mechanics::watch::Watch;
use rules::Rule;

/// Positions that are answered one after the other, each starting from the mechanisms of those before it. Fixed, so that
/// the numbers do not depend on the number of threads.
const CHUNK: usize = 24;
/// Where cases are slow, all of them are answered at every so manyth position only.
pub const STRIDE: usize = 6;
/// A case that is this many times above the least at both such positions is not answered between them, where cases are slow: an
/// axle moves by a tenth of the span meanwhile.
pub const FAR_ABOVE: f64 = 1.5;
/// Cases in which joints slide that are answered again without dilation, for each vehicle.
const SLIDING: usize = 3;
/// Cases in which joints slide count from this multiple of the least factor down: dilatancy is worth up to half of an
/// associated load in walls of blocks (docs/theory/limit-analysis.md), less in arches.
pub const DILATANCY: f64 = 2.0;
/// Refinements of the worst position, each to a tenth.
pub const REFINEMENTS: usize = 2;

/// An answered case.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Answer {
    key: Key,
    factor: f64,
    upper: f64,
}

/// What came of one case.
enum Met {
    /// A load factor.
    Factor(Answer),
    /// Every load is carried.
    Locks,
    /// Nothing is known.
    Open,
}

impl Met {
    /// The factor; none is known of what is open, and there is none of what locks.
    fn factor(&self) -> f64 {
        match self {
            Met::Factor(answer) => answer.factor,
            Met::Locks => f64::INFINITY,
            Met::Open => 0.0,
        }
    }
}

/// What was met at a position near by.
struct Near {
    met: Vec<(Key, f64)>,
    /// Whether the interior-point method had to help.
    slow: bool,
}

impl Near {
    /// Whether a case stood there and was far above the least.
    fn leaves_out(&self, key: &Key) -> bool {
        let known = self.met.iter().map(|(_, factor)| *factor).filter(|factor| *factor > 0.0);
        let least = known.fold(f64::INFINITY, f64::min);
        let there = self.met.iter().find(|(other, _)| Key { position: key.position, ..*other } == *key);
        there.is_some_and(|(_, factor)| *factor > FAR_ABOVE * least)
    }
}

/// What came of some positions of one drive.
struct Part {
    drive: usize,
    envelope: Vec<EnvelopePoint>,
    worst: Option<Answer>,
    /// The lowest cases in which joints slide, best first.
    sliding: Vec<Answer>,
    extremes: Extremes<Key>,
    cases: usize,
    slow: usize,
}

/// Share of the work that all positions are; the rest seeks the worst ones.
const POSITIONS: f64 = 0.8;

/// Answers every case of every vehicle under every combination of factors on weights. Where the onlooker wishes to stop, vehicles
/// that were not finished say so.
pub fn all(
    bridge: &Bridge,
    rule: &Rule,
    plan: &SweepPlan,
    vehicles: &[Chosen],
    weights: &[Weights],
    step: f64,
    watch: &mut dyn Watch,
) -> Result<Vec<Swept>, AnalysisError> {
    thinned(bridge, rule, plan, vehicles, weights, step, Thin { stride: STRIDE, only_slow: true }, watch)
}

/// Where all cases of a position are answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Thin {
    /// At every so manyth position.
    pub stride: usize,
    /// And at the others too, unless cases are slow there.
    pub only_slow: bool,
}

/// The same with all cases at some positions only.
#[allow(clippy::too_many_arguments)]
pub(super) fn thinned(
    bridge: &Bridge,
    rule: &Rule,
    plan: &SweepPlan,
    vehicles: &[Chosen],
    weights: &[Weights],
    step: f64,
    thin: Thin,
    watch: &mut dyn Watch,
) -> Result<Vec<Swept>, AnalysisError> {
    let bridges: Vec<Bridge> = weights.iter().map(|w| factored::bridge(bridge, rule, w)).collect();
    let bridge = &bridges[0];
    let built: Vec<Discretised> = bridges.iter().map(by_limit::prepared).collect::<Result<_, _>>()?;
    let settings = limit::Settings { friction: limit::Friction::Associated, ..by_limit::settings(bridge) };
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
    let scene = Scene {
        d,
        grounds: &grounds,
        weights,
        watched: &watched,
        feet: &feet,
        drives: &all_drives,
        borders: &borders,
        capacity: rule.capacity_factor(),
        thin,
    };
    if let Some(falls) = grounds.iter().position(|ground| !ground.stands()) {
        return Ok(vehicles.iter().zip(&feet).map(|(v, foot)| fallen(v, foot, weights[falls])).collect());
    }
    let jobs: Vec<(usize, &[f64])> = all_drives
        .iter()
        .enumerate()
        .flat_map(|(k, drive)| drive.positions.chunks(CHUNK).map(move |positions| (k, positions)))
        .collect();
    let steps = all_drives.iter().map(|drive| drive.positions.len() as u64).sum();
    let stage = Stage { name: "positions of vehicles", steps, shares: [0.0, POSITIONS] };
    let (parts, _) = pieces::each(&jobs, &stage, watch, |(drive, positions), pace| scene.part(*drive, positions, pace));
    let mut of_vehicle: Vec<Parts> = vehicles.iter().map(|_| Parts { parts: Vec::new(), whole: true }).collect();
    for (part, (drive, positions)) in parts.into_iter().zip(&jobs) {
        let of = &mut of_vehicle[all_drives[*drive].vehicle];
        of.whole &= part.as_ref().is_some_and(|part| part.envelope.len() == positions.len());
        of.parts.extend(part);
    }
    let each: Vec<(usize, Parts)> = of_vehicle.into_iter().enumerate().collect();
    let stage = Stage { name: "worst positions of vehicles", steps: each.len() as u64, shares: [POSITIONS, 1.0] };
    let (found, _) =
        pieces::each(&each, &stage, watch, |(k, parts), pace| scene.gathered(*k, &vehicles[*k], parts, step, pace));
    let unsought = |(k, parts): &(usize, Parts)| scene.gathered(*k, &vehicles[*k], parts, step, &Pace::at_its_end());
    Ok(found.into_iter().zip(&each).map(|(found, parts)| found.unwrap_or_else(|| unsought(parts))).collect())
}

/// What came of the positions of one vehicle.
struct Parts {
    parts: Vec<Part>,
    /// Whether all of them were answered.
    whole: bool,
}

impl Scene<'_> {
    /// Positions of one drive, one after the other.
    fn part(&self, drive: usize, positions: &[f64], pace: &Pace) -> Part {
        let mut sweepers: Vec<Sweeper> = self.grounds.iter().map(Ground::sweeper).collect();
        let mut part = Part {
            drive,
            envelope: Vec::with_capacity(positions.len()),
            worst: None,
            sliding: Vec::new(),
            extremes: Extremes::new(self.watched),
            cases: 0,
            slow: 0,
        };
        self.positions(&mut sweepers, &mut part, positions, pace);
        // In the order in which the vehicle comes to them.
        part.envelope.sort_by(|a, b| a.position.total_cmp(&b.position));
        if self.drives[drive].direction == Direction::Left {
            part.envelope.reverse();
        }
        part
    }

    /// Every so manyth position and the last one first; between them, slow cases far above the least at both are not answered.
    /// None where the work does not go on.
    fn positions(&self, sweepers: &mut [Sweeper], part: &mut Part, positions: &[f64], pace: &Pace) -> Option<()> {
        let last = positions.len().checked_sub(1)?;
        let mut before: Option<(usize, Near)> = None;
        for end in (0..last).step_by(self.thin.stride).chain([last]) {
            let slow = part.slow;
            let met = self.position(sweepers, part, positions[end], &[], pace)?;
            let near = Near { met, slow: part.slow > slow };
            let near = match before.take() {
                None => near,
                Some((from, old)) => {
                    let ends = [old, near];
                    let thin =
                        if !self.thin.only_slow || ends.iter().all(|near| near.slow) { &ends[..] } else { &[][..] };
                    for &position in &positions[from + 1..end] {
                        self.position(sweepers, part, position, thin, pace)?;
                    }
                    let [_, near] = ends;
                    near
                }
            };
            before = Some((end, near));
        }
        Some(())
    }

    /// Answers one position, but for cases that need no answer beside what is `near`; gives what was met. None where the work
    /// does not go on: a position that is broken off is not told.
    fn position(
        &self,
        sweepers: &mut [Sweeper],
        part: &mut Part,
        position: f64,
        near: &[Near],
        pace: &Pace,
    ) -> Option<Vec<(Key, f64)>> {
        let drive = &self.drives[part.drive];
        let (mut least, mut converged): (Option<Answer>, bool) = (None, true);
        let mut all = Vec::new();
        for (key, effect) in self.cases(&mut sweepers[0], part.drive, position) {
            for (weights, sweeper) in sweepers.iter_mut().enumerate() {
                if !pace.goes_on() {
                    return None;
                }
                let key = Key { weights, ..key };
                let effect = self.under(&effect, weights);
                part.extremes.look(&self.grounds[weights], self.watched, &effect, || key);
                if !near.is_empty() && near.iter().all(|near| near.leaves_out(&key)) {
                    continue;
                }
                let met = self.answer(sweeper, part, key, &effect);
                all.push((key, met.factor()));
                match met {
                    Met::Factor(answer) if least.is_none_or(|l| answer.factor < l.factor) => least = Some(answer),
                    Met::Factor(_) | Met::Locks => {}
                    Met::Open => converged = false,
                }
            }
        }
        if let Some(answer) = least
            && part.worst.is_none_or(|worst| answer.factor < worst.factor)
        {
            part.worst = Some(answer);
        }
        part.envelope.push(EnvelopePoint {
            arrangement: drive.pattern.label.clone(),
            direction: drive.direction,
            position,
            converged,
            adequacy: least.filter(|_| converged).map(|l| l.factor * self.capacity),
            axles: least.and_then(|l| l.key.axles),
            weights: least.map(|l| self.weights[l.key.weights]),
        });
        pace.step();
        Some(all)
    }

    /// One case under one combination of weights.
    fn answer(&self, sweeper: &mut Sweeper, part: &mut Part, key: Key, effect: &Effect) -> Met {
        part.cases += 1;
        let found = sweeper.factor(effect);
        part.slow += usize::from(found.by_interior_point);
        let (Some(factor), Some(upper)) = (found.lower, found.upper) else {
            return if found.status == limit::Status::Locks { Met::Locks } else { Met::Open };
        };
        let answer = Answer { key, factor, upper };
        if found.slides {
            part.sliding.push(answer);
            part.sliding.sort_by(|a, b| a.factor.total_cmp(&b.factor));
            part.sliding.truncate(SLIDING);
        }
        Met::Factor(answer)
    }

    /// All parts of one vehicle. An adequacy factor stands only where every position was answered and the worst one sought.
    fn gathered(&self, index: usize, chosen: &Chosen, all: &Parts, step: f64, pace: &Pace) -> Swept {
        let foot = &self.feet[index];
        let mut swept = blank(chosen, foot);
        let mut extremes = Extremes::new(self.watched);
        let (mut worst, mut sliding): (Option<Answer>, Vec<Answer>) = (None, Vec::new());
        for part in &all.parts {
            swept.envelope.extend(part.envelope.iter().cloned());
            swept.cases += part.cases;
            swept.by_interior_point += part.slow;
            extremes.merge(part.extremes.clone());
            sliding.extend(&part.sliding);
            if let Some(answer) = part.worst
                && worst.is_none_or(|w| answer.factor < w.factor)
            {
                worst = Some(answer);
            }
        }
        swept.sections = extremes.told(self.watched, |key| self.told(key));
        let Some(worst) = worst else {
            swept.end(all.whole, None);
            return swept;
        };
        let mut sweepers: Vec<Sweeper> = self.grounds.iter().map(Ground::sweeper).collect();
        let (worst, unanswered) = self.refined(&mut sweepers, worst, step, pace);
        swept.envelope.extend(unanswered.into_iter().map(|key| EnvelopePoint {
            adequacy: None,
            converged: false,
            ..self.point(&key)
        }));
        swept.envelope.push(EnvelopePoint { adequacy: Some(worst.factor * self.capacity), ..self.point(&worst.key) });
        swept.bounds = Some([worst.factor, worst.upper].map(|f| f * self.capacity));
        sliding.sort_by(|a, b| a.factor.total_cmp(&b.factor));
        sliding.truncate(SLIDING);
        sliding.retain(|answer| answer.factor <= DILATANCY * worst.factor);
        let mut governing = (worst.factor, worst.key);
        // The refined position comes first: it may slide too.
        for answer in std::iter::once(worst).chain(sliding) {
            if !pace.goes_on() {
                break;
            }
            let Some((key, effect)) = self.again(&mut sweepers, &answer.key, answer.key.position) else { continue };
            let sweeper = &mut sweepers[key.weights];
            if !sweeper.factor(&effect).slides {
                continue;
            }
            let level = sweeper.level_factor(&effect).map(|level| level * self.capacity);
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
        swept.end(all.whole && pace.goes_on(), Some(governing.0 * self.capacity));
        pace.step();
        swept
    }

    /// A case's place in the envelope, without its factor.
    fn point(&self, key: &Key) -> EnvelopePoint {
        let drive = &self.drives[key.drive];
        EnvelopePoint {
            arrangement: drive.pattern.label.clone(),
            direction: drive.direction,
            position: key.position,
            converged: true,
            adequacy: None,
            axles: key.axles,
            weights: Some(self.weights[key.weights]),
        }
    }

    /// The worst position between the positions, with the same axles and weights, and those that were not answered.
    fn refined(&self, sweepers: &mut [Sweeper], mut worst: Answer, step: f64, pace: &Pace) -> (Answer, Vec<Key>) {
        let (mut width, mut open) = (step, Vec::new());
        for _ in 0..REFINEMENTS {
            let middle = worst.key.position;
            for k in -10..=10 {
                if !pace.goes_on() {
                    return (worst, open);
                }
                let position = middle + 0.1 * width * f64::from(k);
                let Some((key, effect)) = self.again(sweepers, &worst.key, position) else { continue };
                let found = sweepers[key.weights].factor(&effect);
                match (found.lower, found.upper) {
                    (Some(factor), Some(upper)) if factor < worst.factor => worst = Answer { key, factor, upper },
                    (None, _) if found.status != limit::Status::Locks => open.push(key),
                    _ => {}
                }
            }
            width *= 0.1;
        }
        (worst, open)
    }
}

/// A vehicle of which nothing is known yet.
fn blank(chosen: &Chosen, foot: &Footprint) -> Swept {
    Swept {
        code: chosen.vehicle.code.clone(),
        title: chosen.vehicle.title.clone(),
        model: chosen.model.clone(),
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
    }
}

/// A vehicle over a bridge that does not carry its own weight with these factors.
fn fallen(chosen: &Chosen, foot: &Footprint, weights: Weights) -> Swept {
    Swept { status: Status::UnstableUnderSelfWeight, weights: Some(weights), ..blank(chosen, foot) }
}
