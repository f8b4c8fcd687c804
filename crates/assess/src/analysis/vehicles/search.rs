//! Every case answered: least adequacy factors, and the worst position between the positions.

use super::super::by_limit;
use super::super::report::Status;
use super::cases::{borders, drives, reach};
use super::factored::{self, Footprint, footprint};
use super::sections::{Extremes, watched};
use super::standing::{Key, Scene};
use super::weights::Weights;
use super::{AnalysisError, EnvelopePoint, Swept};
use crate::discretise::Discretised;
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use mechanics::limit::{self, Effect, Ground, Sweeper};
use rayon::prelude::*;
use rules::Rule;

/// Positions that are answered one after the other, each starting from the mechanisms of those before it. Fixed, so that
/// the numbers do not depend on the number of threads.
const CHUNK: usize = 24;
/// Cases in which joints slide that are answered again without dilation, for each vehicle.
const SLIDING: usize = 3;
/// Cases in which joints slide count from this multiple of the least factor down: dilatancy is worth up to half of an
/// associated load in walls of blocks (docs/theory/limit-analysis.md), less in arches.
const DILATANCY: f64 = 2.0;
/// Refinements of the worst position, each to a tenth.
const REFINEMENTS: usize = 2;

/// An answered case.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Answer {
    key: Key,
    factor: f64,
    upper: f64,
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
    status: Status,
}

/// Answers every case of every vehicle under every combination of factors on weights.
pub fn all(
    bridge: &Bridge,
    rule: &Rule,
    plan: &SweepPlan,
    vehicles: &[Chosen],
    weights: &[Weights],
    step: f64,
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
    let feet: Vec<Footprint> = vehicles.iter().map(|v| footprint(bridge, plan, rule, &v.vehicle)).collect();
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
    };
    if let Some(falls) = grounds.iter().position(|ground| !ground.stands()) {
        return Ok(vehicles.iter().zip(&feet).map(|(v, foot)| fallen(v, foot, weights[falls])).collect());
    }
    let jobs: Vec<(usize, &[f64])> = all_drives
        .iter()
        .enumerate()
        .flat_map(|(k, drive)| drive.positions.chunks(CHUNK).map(move |positions| (k, positions)))
        .collect();
    let parts: Vec<Part> = jobs.par_iter().map(|(drive, positions)| scene.part(*drive, positions)).collect();
    let mut of_vehicle: Vec<Vec<Part>> = vehicles.iter().map(|_| Vec::new()).collect();
    for part in parts {
        of_vehicle[all_drives[part.drive].vehicle].push(part);
    }
    let each: Vec<(usize, Vec<Part>)> = of_vehicle.into_iter().enumerate().collect();
    Ok(each.into_par_iter().map(|(k, parts)| scene.gathered(k, &vehicles[k], parts, step)).collect())
}

impl Scene<'_> {
    /// Positions of one drive, one after the other.
    fn part(&self, drive: usize, positions: &[f64]) -> Part {
        let mut sweepers: Vec<Sweeper> = self.grounds.iter().map(Ground::sweeper).collect();
        let mut part = Part {
            drive,
            envelope: Vec::with_capacity(positions.len()),
            worst: None,
            sliding: Vec::new(),
            extremes: Extremes::new(self.watched),
            cases: 0,
            slow: 0,
            status: Status::Locks,
        };
        for &position in positions {
            self.position(&mut sweepers, &mut part, position);
        }
        part
    }

    fn position(&self, sweepers: &mut [Sweeper], part: &mut Part, position: f64) {
        let drive = &self.drives[part.drive];
        let mut least: Option<Answer> = None;
        for (key, effect) in self.cases(&mut sweepers[0], part.drive, position) {
            for (weights, sweeper) in sweepers.iter_mut().enumerate() {
                let key = Key { weights, ..key };
                let answer = self.answer(sweeper, part, key, &self.under(&effect, weights));
                if let Some(answer) = answer
                    && least.is_none_or(|l| answer.factor < l.factor)
                {
                    least = Some(answer);
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
            adequacy: least.map(|l| l.factor * self.capacity),
            axles: least.and_then(|l| l.key.axles),
            weights: least.map(|l| self.weights[l.key.weights]),
        });
    }

    /// One case under one combination of weights.
    fn answer(&self, sweeper: &mut Sweeper, part: &mut Part, key: Key, effect: &Effect) -> Option<Answer> {
        part.cases += 1;
        part.extremes.look(&self.grounds[key.weights], self.watched, effect, || key);
        let found = sweeper.factor(effect);
        part.slow += usize::from(found.by_interior_point);
        let (Some(factor), Some(upper)) = (found.lower, found.upper) else {
            if found.status != limit::Status::Locks {
                part.status = by_limit::status(found.status);
            }
            return None;
        };
        let answer = Answer { key, factor, upper };
        if found.slides {
            part.sliding.push(answer);
            part.sliding.sort_by(|a, b| a.factor.total_cmp(&b.factor));
            part.sliding.truncate(SLIDING);
        }
        Some(answer)
    }

    /// All parts of one vehicle.
    fn gathered(&self, index: usize, chosen: &Chosen, parts: Vec<Part>, step: f64) -> Swept {
        let foot = &self.feet[index];
        let mut swept = blank(chosen, foot);
        let mut extremes = Extremes::new(self.watched);
        let (mut worst, mut sliding): (Option<Answer>, Vec<Answer>) = (None, Vec::new());
        for part in parts {
            swept.envelope.extend(part.envelope);
            swept.cases += part.cases;
            swept.by_interior_point += part.slow;
            if part.status != Status::Locks {
                swept.status = part.status;
            }
            extremes.merge(part.extremes);
            sliding.extend(part.sliding);
            if let Some(answer) = part.worst
                && worst.is_none_or(|w| answer.factor < w.factor)
            {
                worst = Some(answer);
            }
        }
        swept.sections = extremes.told(self.watched, |key| self.told(key));
        let Some(worst) = worst else { return swept };
        let mut sweepers: Vec<Sweeper> = self.grounds.iter().map(Ground::sweeper).collect();
        let worst = self.refined(&mut sweepers, worst, step);
        swept.status = Status::Collapsed;
        let drive = &self.drives[worst.key.drive];
        swept.envelope.push(EnvelopePoint {
            arrangement: drive.pattern.label.clone(),
            direction: drive.direction,
            position: worst.key.position,
            adequacy: Some(worst.factor * self.capacity),
            axles: worst.key.axles,
            weights: Some(self.weights[worst.key.weights]),
        });
        swept.bounds = Some([worst.factor, worst.upper].map(|f| f * self.capacity));
        sliding.sort_by(|a, b| a.factor.total_cmp(&b.factor));
        sliding.truncate(SLIDING);
        sliding.retain(|answer| answer.factor <= DILATANCY * worst.factor);
        let mut governing = (worst.factor, worst.key);
        // The refined position comes first: it may slide too.
        for answer in std::iter::once(worst).chain(sliding) {
            let Some((key, effect)) = self.again(&mut sweepers, &answer.key, answer.key.position) else { continue };
            let sweeper = &mut sweepers[key.weights];
            if !sweeper.factor(&effect).slides {
                continue;
            }
            if let Some(level) = sweeper.level_factor(&effect) {
                let adequacy = level * self.capacity;
                swept.without_dilation = Some(swept.without_dilation.map_or(adequacy, |old| old.min(adequacy)));
                if level < governing.0 {
                    governing = (level, key);
                }
            }
        }
        swept.adequacy = Some(governing.0 * self.capacity);
        swept.weights = Some(self.weights[governing.1.weights]);
        swept.case = Some(self.told(&governing.1));
        swept
    }

    /// The worst position between the positions, with the same axles and weights.
    fn refined(&self, sweepers: &mut [Sweeper], mut worst: Answer, step: f64) -> Answer {
        let mut width = step;
        for _ in 0..REFINEMENTS {
            let middle = worst.key.position;
            for k in -10..=10 {
                let position = middle + 0.1 * width * f64::from(k);
                let Some((key, effect)) = self.again(sweepers, &worst.key, position) else { continue };
                let found = sweepers[key.weights].factor(&effect);
                if let (Some(factor), Some(upper)) = (found.lower, found.upper)
                    && factor < worst.factor
                {
                    worst = Answer { key, factor, upper };
                }
            }
            width *= 0.1;
        }
        worst
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
        bounds: None,
        without_dilation: None,
        case: None,
        weights: None,
        envelope: Vec::new(),
        sections: Vec::new(),
        effective_width: foot.width,
        load_factors: [foot.all, foot.critical],
        cases: 0,
        by_interior_point: 0,
    }
}

/// A vehicle over a bridge that does not carry its own weight with these factors.
fn fallen(chosen: &Chosen, foot: &Footprint, weights: Weights) -> Swept {
    Swept { status: Status::UnstableUnderSelfWeight, weights: Some(weights), ..blank(chosen, foot) }
}
