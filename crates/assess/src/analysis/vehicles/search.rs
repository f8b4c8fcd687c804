//! Every case answered: least adequacy factors, and the worst position between the positions.

use super::super::by_limit;
use super::super::report::Status;
use super::cases::{Drive, borders, drives, reach, runs};
use super::factored::{Footprint, clipped, footprint};
use super::sections::{Extremes, Watched, watched};
use super::{AnalysisError, Case, EnvelopePoint, Swept};
use crate::discretise::Discretised;
use crate::discretise::dispersal::{Strip, spread};
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

/// One case, by numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Key {
    drive: usize,
    position: f64,
    axles: Option<[usize; 2]>,
    critical: Option<usize>,
    uniform: Option<[usize; 2]>,
}

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

/// What all cases share.
struct Scene<'a> {
    d: &'a Discretised,
    ground: &'a Ground<'a>,
    watched: &'a [Watched],
    feet: &'a [Footprint],
    drives: &'a [Drive],
    borders: &'a [f64],
    capacity: f64,
}

/// Answers every case of every vehicle.
pub fn all(
    bridge: &Bridge,
    d: &Discretised,
    rule: &Rule,
    plan: &SweepPlan,
    vehicles: &[Chosen],
    step: f64,
) -> Result<Vec<Swept>, AnalysisError> {
    let settings = limit::Settings { friction: limit::Friction::Associated, ..by_limit::settings(bridge) };
    let ground = Ground::new(&d.model, &d.loading, &settings)?;
    let watched = watched(bridge, d, &ground);
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
        ground: &ground,
        watched: &watched,
        feet: &feet,
        drives: &all_drives,
        borders: &borders,
        capacity: rule.capacity_factor(),
    };
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
        let mut sweeper = self.ground.sweeper();
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
            self.position(&mut sweeper, &mut part, position);
        }
        part
    }

    fn position(&self, sweeper: &mut Sweeper, part: &mut Part, position: f64) {
        let drive = &self.drives[part.drive];
        let mut least: Option<Answer> = None;
        for (key, effect) in self.cases(sweeper, part.drive, position) {
            part.cases += 1;
            part.extremes.look(self.ground, self.watched, &effect, || key);
            let found = sweeper.factor(&effect);
            part.slow += usize::from(found.by_interior_point);
            let (Some(factor), Some(upper)) = (found.lower, found.upper) else {
                if found.status != limit::Status::Locks {
                    part.status = by_limit::status(found.status);
                }
                continue;
            };
            let answer = Answer { key, factor, upper };
            if least.is_none_or(|l| factor < l.factor) {
                least = Some(answer);
            }
            if found.slides {
                part.sliding.push(answer);
                part.sliding.sort_by(|a, b| a.factor.total_cmp(&b.factor));
                part.sliding.truncate(SLIDING);
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
        });
    }

    /// Everything that may stand with the first axle at a position.
    fn cases(&self, sweeper: &mut Sweeper, index: usize, position: f64) -> Vec<(Key, Effect)> {
        let drive = &self.drives[index];
        let foot = &self.feet[drive.vehicle];
        // Axles that reach the arches; they are neighbours, for axles follow one another.
        let mut axles: Vec<(usize, Effect)> = Vec::new();
        for (k, axle) in drive.pattern.axles.iter().enumerate() {
            let middle = drive.axle_at(position, k);
            let strip = Strip { middle, length: foot.length, force: axle.force * foot.all / foot.width };
            if let Some(effect) = self.effect(sweeper, foot, strip) {
                axles.push((k, effect));
            }
        }
        let uniform = self.uniform(sweeper, index, position);
        let mut cases = Vec::new();
        let none: [usize; 2] = [0, 0];
        let runs_of_axles = runs(axles.len(), drive.subsets);
        let with_none = std::iter::once((None, none)).filter(|_| axles.is_empty() || drive.subsets);
        for (run, [a, b]) in runs_of_axles.into_iter().map(|r| (Some(r), r)).chain(with_none) {
            let mut stands = sweeper.nothing();
            if run.is_some() {
                axles[a..=b].iter().for_each(|(_, effect)| stands.add(effect, 1.0));
            }
            let criticals: Vec<Option<usize>> = match run {
                Some(_) if foot.critical != 1.0 => (a..=b).map(Some).collect(),
                _ => vec![None],
            };
            for critical in criticals {
                let mut with_critical = stands.clone();
                if let Some(k) = critical {
                    with_critical.add(&axles[k].1, foot.critical - 1.0);
                }
                for (pieces, effect) in &uniform {
                    if run.is_none() && pieces.is_none() {
                        continue;
                    }
                    let mut whole = with_critical.clone();
                    if let Some(effect) = effect {
                        whole.add(effect, 1.0);
                    }
                    let key = Key {
                        drive: index,
                        position,
                        axles: run.map(|[a, b]| [axles[a].0, axles[b].0]),
                        critical: critical.map(|k| axles[k].0),
                        uniform: *pieces,
                    };
                    cases.push((key, whole));
                }
            }
        }
        cases
    }

    /// Uniform loads: none, and every run of half spans; all of them where they may not be left out.
    fn uniform(&self, sweeper: &mut Sweeper, index: usize, position: f64) -> Vec<(Option<[usize; 2]>, Option<Effect>)> {
        let drive = &self.drives[index];
        if drive.pattern.stretches.is_empty() {
            return vec![(None, None)];
        }
        let droppable = drive.pattern.stretches.iter().all(|s| s.may_be_dropped);
        let pieces: Vec<Option<Effect>> =
            self.borders.windows(2).map(|pair| self.piece(sweeper, index, position, [pair[0], pair[1]])).collect();
        let count = pieces.len();
        let mut found = if droppable { vec![(None, None)] } else { Vec::new() };
        for [a, b] in runs(count, droppable) {
            // Runs that begin or end with nothing are the same as shorter ones.
            if droppable && (pieces[a].is_none() || pieces[b].is_none()) {
                continue;
            }
            let mut whole = sweeper.nothing();
            pieces[a..=b].iter().flatten().for_each(|effect| whole.add(effect, 1.0));
            found.push((Some([a, b]), Some(whole)));
        }
        found
    }

    fn piece(&self, sweeper: &mut Sweeper, index: usize, position: f64, range: [f64; 2]) -> Option<Effect> {
        let drive = &self.drives[index];
        let foot = &self.feet[drive.vehicle];
        let mut sum: Option<Effect> = None;
        let case = self.bare(index, position);
        for (from, to, force) in clipped(&drive.pattern, &case, range) {
            let strip = Strip {
                middle: 0.5 * (from + to),
                length: to - from,
                force: force * (to - from) * foot.all / foot.width,
            };
            if let Some(effect) = self.effect(sweeper, foot, strip) {
                match &mut sum {
                    Some(sum) => sum.add(&effect, 1.0),
                    None => sum = Some(effect),
                }
            }
        }
        sum
    }

    fn effect(&self, sweeper: &mut Sweeper, foot: &Footprint, strip: Strip) -> Option<Effect> {
        let spread = spread(strip, foot.dispersal, self.d.surface, &self.d.extrados);
        (!spread.forces.is_empty()).then(|| sweeper.effect(&spread.forces))
    }

    fn bare(&self, index: usize, position: f64) -> Case {
        let drive = &self.drives[index];
        Case {
            position,
            direction: drive.direction,
            arrangement: drive.pattern.label.clone(),
            axles: None,
            critical_axle: None,
            uniform: None,
            load: 0.0,
        }
    }

    /// A case in words.
    fn told(&self, key: &Key) -> Case {
        let drive = &self.drives[key.drive];
        let foot = &self.feet[drive.vehicle];
        let mut case = Case { axles: key.axles, critical_axle: key.critical, ..self.bare(key.drive, key.position) };
        if let Some([first, last]) = key.axles {
            for (k, axle) in drive.pattern.axles.iter().enumerate().take(last + 1).skip(first) {
                let critical = if key.critical == Some(k) { foot.critical } else { 1.0 };
                case.load += axle.force * critical * foot.all / foot.width;
            }
        }
        if let Some([a, b]) = key.uniform {
            let range = [self.borders[a], self.borders[b + 1]];
            case.uniform = Some(range);
            let parts = clipped(&drive.pattern, &case, range);
            case.load += parts.iter().map(|(from, to, force)| force * (to - from) * foot.all / foot.width).sum::<f64>();
        }
        case
    }

    /// The effect of one case at another position.
    fn again(&self, sweeper: &mut Sweeper, key: &Key, position: f64) -> Option<(Key, Effect)> {
        let same = |other: &Key| Key { position, ..*key } == *other;
        self.cases(sweeper, key.drive, position).into_iter().find(|(other, _)| same(other))
    }

    /// All parts of one vehicle.
    fn gathered(&self, index: usize, chosen: &Chosen, parts: Vec<Part>, step: f64) -> Swept {
        let foot = &self.feet[index];
        let mut swept = Swept {
            code: chosen.vehicle.code.clone(),
            title: chosen.vehicle.title.clone(),
            model: chosen.model.clone(),
            status: Status::Locks,
            adequacy: None,
            bounds: None,
            without_dilation: None,
            case: None,
            envelope: Vec::new(),
            sections: Vec::new(),
            effective_width: foot.width,
            load_factors: [foot.all, foot.critical],
            cases: 0,
            by_interior_point: 0,
        };
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
        let mut sweeper = self.ground.sweeper();
        let worst = self.refined(&mut sweeper, worst, step);
        swept.status = Status::Collapsed;
        let drive = &self.drives[worst.key.drive];
        swept.envelope.push(EnvelopePoint {
            arrangement: drive.pattern.label.clone(),
            direction: drive.direction,
            position: worst.key.position,
            adequacy: Some(worst.factor * self.capacity),
            axles: worst.key.axles,
        });
        swept.bounds = Some([worst.factor, worst.upper].map(|f| f * self.capacity));
        sliding.sort_by(|a, b| a.factor.total_cmp(&b.factor));
        sliding.truncate(SLIDING);
        sliding.retain(|answer| answer.factor <= DILATANCY * worst.factor);
        let mut governing = (worst.factor, worst.key);
        // The refined position comes first: it may slide too.
        for answer in std::iter::once(worst).chain(sliding) {
            let Some((key, effect)) = self.again(&mut sweeper, &answer.key, answer.key.position) else { continue };
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
        swept.case = Some(self.told(&governing.1));
        swept
    }

    /// The worst position between the positions, with the same axles.
    fn refined(&self, sweeper: &mut Sweeper, mut worst: Answer, step: f64) -> Answer {
        let mut width = step;
        for _ in 0..REFINEMENTS {
            let middle = worst.key.position;
            for k in -10..=10 {
                let position = middle + 0.1 * width * f64::from(k);
                let Some((key, effect)) = self.again(sweeper, &worst.key, position) else { continue };
                let found = sweeper.factor(&effect);
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
