//! Vehicles on deformable joints: beside the adequacy factor of rigid blocks, and the smaller one counts.
//!
//! At every position two cases are followed along their equilibrium paths: what governs for rigid blocks there, and all
//! that may stand there; then what was found to govern beside it, from position to position there and back. The worst
//! position is sought between the positions, and what stands there is varied: runs of axles, runs of half spans with uniform
//! loads, factors on weights, the critical axle.

use super::super::deforming::{Asked, Bound, Deforming, Followed, InService};
use super::super::engine::joints::require_stiffness;
use super::super::engine::rigid;
use super::super::parallel::{self, Stage};
use super::super::service::Service;
use super::AnalysisError;
use super::cases::{borders, reach, runs};
use super::factored::{self, Footprint, footprint};
use super::search::REFINEMENTS;
use super::twins::twins;
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use mechanics::blocks::PointForce;
use mechanics::path::Sweeper;
use mechanics::watch::{CancelToken, Watch};
use outcome::vehicles::{Case, Deformable, Direction, EnvelopePoint, PermissibleFactor, Swept, Weights};
use rules::{Pattern, Rule};
use structure::discretise::Discretised;
use structure::discretise::dispersal::{self, Strip};

/// Positions that one piece of work answers. Fixed, so that the numbers do not depend on the number of threads.
const CHUNK: usize = 24;

/// Factors of cases are not known to be better than this.
const SAME: f64 = 1e-4;

/// Rounds of variation at the worst position.
const ROUNDS: usize = 3;

/// Shares of the work at which all positions are answered, and at which what governs beside them is known.
const SHARES: [f64; 2] = [0.7, 0.8];

/// A vehicle's case on deformable joints.
#[derive(Debug, Clone)]
struct Answer {
    case: Case,
    found: Followed,
}

/// What is known of a vehicle on deformable joints.
struct Found {
    /// The least answer at every point of its envelope, and at its worst position behind them; none where nothing was found.
    answers: Vec<Option<Answer>>,
    service: Service,
}

/// Puts the factors of deformable joints beside those of rigid blocks, and the smaller one in front. Tells whether all of it
/// was done.
pub(super) fn beside(
    bridge: &Bridge,
    (rule, plan): (&Rule, &SweepPlan),
    (vehicles, weights): (&[Chosen], &[Weights]),
    (swept, step): (&mut [Swept], f64),
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    require_stiffness(bridge)?;
    let bridges: Vec<Bridge> = weights.iter().map(|w| factored::bridge(bridge, rule, w)).collect();
    let built: Vec<Discretised> = bridges.iter().map(rigid::prepared).collect::<Result<_, _>>()?;
    let mut deforming = Vec::with_capacity(built.len());
    for (own, d) in bridges.iter().zip(&built) {
        deforming.push(Deforming::new(own, d, watch)?);
    }
    let feet: Vec<Footprint> = vehicles.iter().map(|v| footprint(bridge, plan, rule, v)).collect();
    let twins = twins(vehicles, &feet);
    // As for rigid blocks, so that cases are the same.
    let range = feet.iter().map(|foot| reach(&built[0], foot.length, foot.dispersal.slope));
    let range = range.fold([f64::INFINITY, f64::NEG_INFINITY], |all, own| [all[0].min(own[0]), all[1].max(own[1])]);
    let moving = Moving {
        bridges: &bridges,
        built: &built,
        deforming: &deforming,
        weights,
        plan,
        rule,
        vehicles,
        feet: &feet,
        step,
        capacity: rule.capacity_factor(),
        borders: &borders(bridge, range),
    };
    if !deforming.iter().all(Deforming::stands) {
        let falls = deforming.iter().any(Deforming::falls);
        swept.iter_mut().for_each(|one| one.judged_with(Deformable { falls, ..Deformable::default() }));
        return Ok(true);
    }
    let own: Vec<usize> = (0..vehicles.len()).filter(|&k| twins[k].is_none()).collect();
    let mut found: Vec<Found> = (0..swept.len()).map(|k| moving.begun(k, &swept[k])).collect();
    let mut whole = moving.everywhere(&own, swept, &mut found, watch);
    for (count, &k) in own.iter().enumerate() {
        let share = |part: f64| SHARES[1] + (1.0 - SHARES[1]) * (count as f64 + part) / own.len() as f64;
        whole = whole && moving.refined(k, &mut found[k], [share(0.0), share(1.0)], watch);
    }
    for &k in &own {
        moving.put(&found[k], &mut swept[k]);
    }
    for (k, twin) in twins.iter().enumerate() {
        if let Some(twin) = twin {
            let of = swept[twin.of].clone();
            swept[k].deforms_like(&of, twin.times);
        }
    }
    Ok(whole)
}

/// What all vehicles share.
struct Moving<'a> {
    /// One for each combination of factors on weights.
    bridges: &'a [Bridge],
    built: &'a [Discretised],
    deforming: &'a [Deforming],
    weights: &'a [Weights],
    plan: &'a SweepPlan,
    rule: &'a Rule,
    vehicles: &'a [Chosen],
    feet: &'a [Footprint],
    step: f64,
    capacity: f64,
    /// Borders of half spans [m].
    borders: &'a [f64],
}

impl<'a> Moving<'a> {
    fn sweepers(&self) -> Vec<Sweeper<'a>> {
        self.deforming.iter().map(Deforming::sweeper).collect()
    }

    /// What all positions of a vehicle start from: nothing but the states in service that likely cases come to at its worst position on rigid
    /// blocks, so that loads that come to less are soon known to.
    fn begun(&self, vehicle: usize, one: &Swept) -> Found {
        let lowest = one.factor().map(|adequacy| adequacy / self.capacity);
        let mut service = Service::below(lowest.unwrap_or(f64::INFINITY));
        let worst = one.envelope.iter().filter(|point| point.adequacy.is_some());
        let worst = worst.min_by(|a, b| a.adequacy.partial_cmp(&b.adequacy).expect("numbers"));
        if let Some((worst, bound)) = worst.and_then(|worst| Some((worst, self.bound(worst, one.factor())?))) {
            let cases = self.likely(vehicle, worst);
            self.least(vehicle, &mut self.sweepers(), &cases, (bound, &mut service, true), &CancelToken::default());
        }
        Found { answers: Vec::new(), service }
    }

    /// The least answer at every point of every vehicle's envelope; none at points where nothing stands. Tells whether the work was done.
    fn everywhere(&self, own: &[usize], swept: &[Swept], found: &mut [Found], watch: &mut dyn Watch) -> bool {
        let chunks = |&k: &usize| swept[k].envelope.chunks(CHUNK).map(move |points| (k, points));
        let jobs: Vec<(usize, &[EnvelopePoint])> = own.iter().flat_map(chunks).collect();
        let steps = own.iter().map(|&k| swept[k].envelope.len() as u64).sum();
        let stage = Stage { name: "positions of vehicles on deformable joints", steps, shares: [0.0, SHARES[0]] };
        let (parts, done) = parallel::each(&jobs, &stage, watch, |(k, points), token| {
            let mut sweepers = self.sweepers();
            let mut service = found[*k].service.clone();
            let lowest = swept[*k].factor();
            let each = points.iter().map(|point| {
                let bound = self.bound(point, lowest)?;
                let asked = (bound, &mut service, true);
                let least = self.least(*k, &mut sweepers, &self.likely(*k, point), asked, token);
                token.step();
                least
            });
            let answers: Vec<Option<Answer>> = each.collect();
            let mut part = Found { answers, service };
            self.beside(*k, &mut sweepers, (points, lowest), &mut part, token);
            part
        });
        for ((k, points), part) in jobs.iter().zip(parts) {
            match part {
                Some(part) => {
                    found[*k].answers.extend(part.answers);
                    found[*k].service.merge(&part.service);
                }
                None => found[*k].answers.extend(points.iter().map(|_| None)),
            }
        }
        done && self.over_borders(own, swept, found, watch)
    }

    /// The same beside the borders of the pieces of work: between their middles.
    fn over_borders(&self, own: &[usize], swept: &[Swept], found: &mut [Found], watch: &mut dyn Watch) -> bool {
        let middles = |&k: &usize| {
            let count = swept[k].envelope.len();
            (CHUNK / 2..count).step_by(CHUNK).map(move |from| (k, from..(from + CHUNK).min(count)))
        };
        let jobs: Vec<(usize, std::ops::Range<usize>)> = own.iter().flat_map(middles).collect();
        let name = "cases beside others on deformable joints";
        let stage = Stage { name, steps: jobs.len() as u64, shares: SHARES };
        let (parts, done) = parallel::each(&jobs, &stage, watch, |(k, range), token| {
            let (answers, service) = (found[*k].answers[range.clone()].to_vec(), found[*k].service.clone());
            let mut part = Found { answers, service };
            let given = (&swept[*k].envelope[range.clone()], swept[*k].factor());
            self.beside(*k, &mut self.sweepers(), given, &mut part, token);
            token.step();
            part
        });
        for ((k, range), part) in jobs.into_iter().zip(parts) {
            if let Some(part) = part {
                found[k].answers.splice(range, part.answers);
                found[k].service.merge(&part.service);
            }
        }
        done
    }

    /// Tries at every position what governs at those beside it.
    fn beside(
        &self,
        vehicle: usize,
        sweepers: &mut [Sweeper<'_>],
        (points, lowest): (&[EnvelopePoint], Option<f64>),
        found: &mut Found,
        token: &CancelToken,
    ) {
        let Found { answers, service } = found;
        let count = points.len();
        let there_and_back = (1..count).map(|k| (k - 1, k)).chain((1..count).rev().map(|k| (k, k - 1)));
        for (from, to) in there_and_back {
            let point = &points[to];
            let alike = points[from].arrangement == point.arrangement && points[from].direction == point.direction;
            let Some(other) = answers[from].as_ref().filter(|_| alike) else { continue };
            let Some(pattern) = self.pattern(vehicle, &point.arrangement) else { continue };
            let case = self.trimmed(vehicle, &pattern, Case { position: point.position, ..other.case.clone() });
            let bound = match &answers[to] {
                Some(known) if Case { load: 0.0, ..known.case.clone() } == case => continue,
                Some(known) => Bound::below(known.found.factor * (1.0 - SAME)),
                None => match self.bound(point, lowest) {
                    Some(bound) => bound,
                    None => continue,
                },
            };
            if let Some(smaller) = self.least(vehicle, sweepers, &[case], (bound, service, false), token) {
                answers[to] = Some(smaller);
            }
        }
    }

    /// How far loads are followed at a point, where rigid blocks carry `lowest` at their worst.
    fn bound(&self, point: &EnvelopePoint, lowest: Option<f64>) -> Option<Bound> {
        let factor = |adequacy: Option<f64>| adequacy.map(|adequacy| adequacy / self.capacity);
        Bound::of(factor(point.adequacy), factor(lowest))
    }

    /// What governs for rigid blocks at a point, and all that may stand there.
    fn likely(&self, vehicle: usize, point: &EnvelopePoint) -> Vec<Case> {
        let governs = Case {
            horizontal: self.plan.braking,
            position: point.position,
            direction: point.direction,
            arrangement: point.arrangement.clone(),
            axles: point.axles,
            critical_axle: point.critical_axle,
            weights: point.weights.unwrap_or(self.weights[0]),
            uniform: point.uniform,
            load: 0.0,
        };
        let Some(pattern) = self.pattern(vehicle, &point.arrangement) else { return vec![governs] };
        let last = pattern.axles.len().checked_sub(1);
        let uniform = (!pattern.stretches.is_empty()).then(|| [self.borders[0], self.borders[self.borders.len() - 1]]);
        let all = Case { axles: last.map(|last| [0, last]), uniform, ..governs.clone() };
        let all = self.trimmed(vehicle, &pattern, all);
        if all == governs { vec![governs] } else { vec![governs, all] }
    }

    fn pattern(&self, vehicle: usize, arrangement: &str) -> Option<Pattern> {
        self.vehicles[vehicle].vehicle.patterns().into_iter().find(|pattern| pattern.label == arrangement)
    }

    /// A case without the axles that do not reach the arches, so that cases that are alike are the same.
    fn trimmed(&self, vehicle: usize, pattern: &Pattern, case: Case) -> Case {
        let foot = &self.feet[vehicle];
        let sign = if case.direction == Direction::Right { 1.0 } else { -1.0 };
        let reaches = |k: &usize| {
            let middle = case.position - sign * pattern.axles[*k].offset;
            let strip = Strip { middle, length: foot.length, force: 1.0, horizontal: 0.0, is_pressure: false };
            !dispersal::spread(strip, foot.dispersal, &self.built[0].surface, &self.built[0].extrados).forces.is_empty()
        };
        let axles = case.axles.and_then(|[first, last]| {
            let mut standing = (first..=last).filter(reaches);
            let first = standing.next()?;
            Some([first, standing.next_back().unwrap_or(first)])
        });
        Case { axles, load: 0.0, ..case }
    }

    /// The least answer of some cases below a bound. What they come to in service is added, of cases that carry the bound if that is asked.
    fn least(
        &self,
        vehicle: usize,
        sweepers: &mut [Sweeper<'_>],
        cases: &[Case],
        (mut bound, service, by_themselves): (Bound, &mut Service, bool),
        token: &CancelToken,
    ) -> Option<Answer> {
        let mut least = None;
        for case in cases {
            let Some(weights) = self.weights.iter().position(|w| *w == case.weights) else { continue };
            let (forces, load) = self.forces(vehicle, weights, case);
            let in_service = InService { known: service, position: case.position, by_themselves };
            let asked = Asked { bound, service: Some(in_service) };
            if let Some(found) = self.deforming[weights].follow(&mut sweepers[weights], &forces, asked, token) {
                bound = Bound::below(found.factor * (1.0 - SAME));
                least = Some(Answer { case: Case { load, ..case.clone() }, found });
            }
        }
        least
    }

    /// Forces of a case on the blocks, and its load [N/m].
    fn forces(&self, vehicle: usize, weights: usize, case: &Case) -> (Vec<PointForce>, f64) {
        let own = &self.bridges[weights];
        let loaded = factored::with_case(own, self.plan, self.rule, &self.vehicles[vehicle], case);
        let strips = loaded.loads.iter().flat_map(|load| dispersal::strips(load, 0.0));
        let (mut forces, mut total) = (Vec::new(), 0.0);
        for strip in strips {
            total += strip.force;
            forces.extend(self.built[weights].spread(&loaded, strip).forces);
        }
        (forces, total)
    }

    /// Seeks the worst position between the positions, then varies what stands there. What is found stands at the end of the
    /// answers. Tells whether the work was done.
    fn refined(&self, vehicle: usize, known: &mut Found, [from, to]: [f64; 2], watch: &mut dyn Watch) -> bool {
        let Some(mut best) = worst(&known.answers).cloned() else { return true };
        let count = REFINEMENTS + ROUNDS;
        let width = |round: usize| self.step * 0.1f64.powi(round as i32 + 1);
        for round in 0..count {
            let cases = match round {
                0..REFINEMENTS => {
                    let at = |k: i32| best.case.position + width(round) * f64::from(k);
                    (-10..=10).map(|k| Case { position: at(k), ..best.case.clone() }).collect()
                }
                _ => self.varied(vehicle, &best.case),
            };
            let share = |round: usize| from + (to - from) * round as f64 / count as f64;
            let stage = Stage {
                name: "worst positions of vehicles on deformable joints",
                steps: cases.len() as u64,
                shares: [share(round), share(round + 1)],
            };
            let most = best.found.factor * (1.0 - SAME);
            let service = &known.service;
            let (parts, done) = parallel::each(&cases, &stage, watch, |case, token| {
                let (one, mut service) = (std::slice::from_ref(case), service.clone());
                let asked = (Bound::below(most), &mut service, true);
                let found = self.least(vehicle, &mut self.sweepers(), one, asked, token);
                token.step();
                (found, service)
            });
            if !done {
                return false;
            }
            let mut found: Vec<Option<Answer>> = Vec::with_capacity(cases.len());
            for (answer, service) in parts.into_iter().flatten() {
                known.service.merge(&service);
                found.push(answer);
            }
            match worst(&found) {
                Some(better) => best = better.clone(),
                None if round >= REFINEMENTS => break,
                None => {}
            }
        }
        known.answers.push(Some(best));
        true
    }

    /// Cases that differ from one in one respect: its run of axles, its run of half spans with uniform loads, the factors on
    /// weights, the critical axle.
    fn varied(&self, vehicle: usize, case: &Case) -> Vec<Case> {
        let chosen = &self.vehicles[vehicle];
        let Some(pattern) = self.pattern(vehicle, &case.arrangement) else { return Vec::new() };
        let subsets = self.plan.subsets && chosen.vehicle.axles_may_be_dropped;
        let mut cases = Vec::new();
        for axles in runs(pattern.axles.len(), subsets) {
            let critical_axle = case.critical_axle.map(|k| k.clamp(axles[0], axles[1]));
            cases.push(Case { axles: Some(axles), critical_axle, ..case.clone() });
        }
        if let (Some([first, last]), Some(_)) = (case.axles, case.critical_axle) {
            cases.extend((first..=last).map(|k| Case { critical_axle: Some(k), ..case.clone() }));
        }
        cases.extend(self.weights.iter().map(|weights| Case { weights: *weights, ..case.clone() }));
        if !pattern.stretches.is_empty() && pattern.stretches.iter().all(|s| s.may_be_dropped) {
            let borders = self.borders;
            let ranges = runs(borders.len() - 1, true).into_iter().map(|[a, b]| [borders[a], borders[b + 1]]);
            cases.extend(ranges.map(|range| Case { uniform: Some(range), ..case.clone() }));
            cases.extend(case.axles.map(|_| Case { uniform: None, ..case.clone() }));
        }
        let mut distinct: Vec<Case> = Vec::with_capacity(cases.len());
        for other in cases.into_iter().map(|other| self.trimmed(vehicle, &pattern, other)) {
            if other != (Case { load: 0.0, ..case.clone() }) && !distinct.contains(&other) {
                distinct.push(other);
            }
        }
        distinct
    }

    /// Both factors at every position, and the smaller one in front.
    fn put(&self, found: &Found, one: &mut Swept) {
        let answers = &found.answers;
        let positions = one.envelope.len();
        for (point, answer) in one.envelope.iter_mut().zip(answers) {
            point.rigid = point.adequacy;
            let Some(answer) = answer else { continue };
            point.deforms(answer.found.factor * self.capacity, &answer.case);
        }
        // The worst position, where it lies between the others.
        for answer in answers.iter().skip(positions).flatten() {
            let mut point = EnvelopePoint::at(&answer.case);
            point.deforms(answer.found.factor * self.capacity, &answer.case);
            one.envelope.push(point);
        }
        let permissible = found.service.told().map(|(criterion, factor, position)| PermissibleFactor {
            criterion,
            adequacy: factor * self.capacity,
            position,
        });
        let least = worst(answers);
        one.judged_with(Deformable {
            stands: true,
            falls: false,
            adequacy: least.map(|least| least.found.factor * self.capacity),
            case: least.map(|least| least.case.clone()),
            broken_off: answers.iter().flatten().filter(|answer| answer.found.broken_off).count(),
            permissible: permissible.collect(),
        });
    }
}

fn worst(answers: &[Option<Answer>]) -> Option<&Answer> {
    answers.iter().flatten().min_by(|a, b| a.found.factor.total_cmp(&b.found.factor))
}
