//! Vehicles on deformable joints: beside the adequacy factor of rigid blocks, and the smaller one counts.
//!
//! Likely at a position are what governs for rigid blocks there, and all that may stand there. At the worst one are varied: runs of axles, runs of
//! half spans with uniform loads, factors on weights, the critical axle.

use super::super::deforming::along::{Found, Moves, Places, along, worst};
use super::super::deforming::{Bound, at_rest};
use super::super::engine::joints::require_stiffness;
use super::super::moving::runs;
use super::AnalysisError;
use super::cases::{borders, range};
use super::factored::{self, pattern};
use super::traffic::Traffic;
use crate::vehicles::Chosen;
use bridge::Bridge;
use mechanics::blocks::PointForce;
use mechanics::path::Ground;
use mechanics::watch::Watch;
use outcome::vehicles::{Case, Deformable, Direction, EnvelopePoint, PermissibleFactor, Swept};
use rules::Pattern;
use structure::discretise::continuum::loads;
use structure::discretise::dispersal::{self, Strip};

/// Puts the factors of deformable joints beside those of rigid blocks, and the smaller one in front. Tells whether all of it
/// was done.
pub(super) fn beside(
    bridge: &Bridge,
    traffic: &Traffic<'_>,
    (swept, step): (&mut [Swept], f64),
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    require_stiffness(bridge)?;
    let mut grounds = Vec::with_capacity(traffic.built.len());
    for (own, d) in traffic.bridges.iter().zip(&traffic.built) {
        grounds.push(at_rest(own, d, watch)?);
    }
    if !grounds.iter().all(Ground::stands) {
        let falls = grounds.iter().any(Ground::falls);
        swept.iter_mut().for_each(|one| one.judged_with(Deformable { falls, ..Deformable::default() }));
        return Ok(true);
    }
    // As for rigid blocks, so that cases are the same.
    let borders = &borders(bridge, range(&traffic.built[0], &traffic.feet))[..];
    let own = traffic.own();
    let vehicle = |&number: &usize| {
        let (swept, capacity) = (&swept[number], traffic.rule.capacity_factor());
        Vehicle { traffic, number, capacity, borders, swept, places: places(&grounds, swept, capacity, step) }
    };
    let all: Vec<Vehicle<'_>> = own.iter().map(vehicle).collect();
    let (found, whole) = along(&all, watch);
    let told: Vec<(Deformable, Vec<EnvelopePoint>)> =
        all.iter().zip(&found).map(|(one, found)| one.told(found)).collect();
    for (&k, (deformable, envelope)) in own.iter().zip(told) {
        swept[k].envelope = envelope;
        swept[k].judged_with(deformable);
    }
    traffic.told_alike(swept, Swept::deforms_like);
    Ok(whole)
}

/// One of them, with what rigid blocks carry of it. Its cases have no load: what stands at a place is its load.
struct Vehicle<'a> {
    traffic: &'a Traffic<'a>,
    /// Its place among the vehicles.
    number: usize,
    capacity: f64,
    /// Borders of half spans [m].
    borders: &'a [f64],
    swept: &'a Swept,
    places: Places<'a>,
}

/// Where a vehicle stands in its envelope, and how far it is followed there.
fn places<'a>(grounds: &'a [Ground], swept: &Swept, capacity: f64, step: f64) -> Places<'a> {
    let lowest = swept.factor().map(|adequacy| adequacy / capacity);
    let rigid: Vec<Option<f64>> = swept.envelope.iter().map(|p| p.adequacy.map(|own| own / capacity)).collect();
    let worst = rigid.iter().enumerate().filter_map(|(k, factor)| Some((k, (*factor)?)));
    let worst = worst.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k);
    let bounds = rigid.iter().map(|here| Bound::of(*here, lowest)).collect();
    Places { grounds, bounds, step, in_service: Some((lowest.unwrap_or(f64::INFINITY), worst)) }
}

impl Moves for Vehicle<'_> {
    type Case = Case;

    fn places(&self) -> &Places<'_> {
        &self.places
    }

    fn likely(&self, place: usize) -> Vec<Case> {
        let point = &self.swept.envelope[place];
        let governs = self.traffic.governing(point);
        let Some(pattern) = pattern(self.chosen(), &point.case.arrangement) else { return vec![governs] };
        let last = pattern.axles.len().checked_sub(1);
        let borders = self.borders;
        let uniform = (!pattern.stretches.is_empty()).then(|| [borders[0], borders[borders.len() - 1]]);
        let all = Case { axles: last.map(|last| [0, last]), uniform, ..governs.clone() };
        let all = self.trimmed(&pattern, all);
        if all == governs { vec![governs] } else { vec![governs, all] }
    }

    fn like(&self, case: &Case, place: usize) -> Option<Case> {
        let there = &self.swept.envelope[place].case;
        let alike = case.arrangement == there.arrangement && case.direction == there.direction;
        let pattern = pattern(self.chosen(), &there.arrangement).filter(|_| alike)?;
        Some(self.trimmed(&pattern, Case { position: there.position, ..case.clone() }))
    }

    fn shifted(&self, case: &Case, by: f64) -> Case {
        Case { position: case.position + by, ..case.clone() }
    }

    /// Its run of axles, its run of half spans with uniform loads, the factors on weights, the critical axle.
    fn varied(&self, case: &Case) -> Vec<Case> {
        let Some(pattern) = pattern(self.chosen(), &case.arrangement) else { return Vec::new() };
        let subsets = self.traffic.plan.subsets && self.chosen().vehicle.axles_may_be_dropped;
        let mut cases = Vec::new();
        for axles in runs(pattern.axles.len(), subsets) {
            let critical_axle = case.critical_axle.map(|k| k.clamp(axles[0], axles[1]));
            cases.push(Case { axles: Some(axles), critical_axle, ..case.clone() });
        }
        if let (Some([first, last]), Some(_)) = (case.axles, case.critical_axle) {
            cases.extend((first..=last).map(|k| Case { critical_axle: Some(k), ..case.clone() }));
        }
        cases.extend(self.traffic.weights.iter().map(|weights| Case { weights: *weights, ..case.clone() }));
        if !pattern.stretches.is_empty() && pattern.stretches.iter().all(|s| s.may_be_dropped) {
            let borders = self.borders;
            let ranges = runs(borders.len() - 1, true).into_iter().map(|[a, b]| [borders[a], borders[b + 1]]);
            cases.extend(ranges.map(|range| Case { uniform: Some(range), ..case.clone() }));
            cases.extend(case.axles.map(|_| Case { uniform: None, ..case.clone() }));
        }
        let mut distinct: Vec<Case> = Vec::with_capacity(cases.len());
        for other in cases.into_iter().map(|other| self.trimmed(&pattern, other)) {
            if other != *case && !distinct.contains(&other) {
                distinct.push(other);
            }
        }
        distinct
    }

    fn forces(&self, case: &Case) -> Option<(Vec<PointForce>, usize)> {
        let weights = self.traffic.weights.iter().position(|w| *w == case.weights)?;
        let (loaded, strips) = self.strips(weights, case);
        let spread = |strip: Strip| self.traffic.built[weights].spread(&loaded, strip).forces;
        Some((strips.into_iter().flat_map(spread).collect(), weights))
    }

    fn position(case: &Case) -> f64 {
        case.position
    }
}

impl Vehicle<'_> {
    fn chosen(&self) -> &Chosen {
        &self.traffic.vehicles[self.number]
    }

    /// The bridge with a case as its loads, and these where they stand.
    fn strips(&self, weights: usize, case: &Case) -> (Bridge, Vec<Strip>) {
        let Traffic { bridges, plan, rule, .. } = self.traffic;
        let loaded = factored::with_case(&bridges[weights], plan, rule, self.chosen(), case);
        let strips = loads(&loaded);
        (loaded, strips)
    }

    /// A case without the axles that do not reach the arches, so that cases that are alike are the same.
    fn trimmed(&self, pattern: &Pattern, case: Case) -> Case {
        let (foot, built) = (&self.traffic.feet[self.number], &self.traffic.built[0]);
        let sign = if case.direction == Direction::Right { 1.0 } else { -1.0 };
        let reaches = |k: &usize| {
            let middle = case.position - sign * pattern.axles[*k].offset;
            let strip = Strip { middle, length: foot.length, force: 1.0, horizontal: 0.0, is_pressure: false };
            !dispersal::spread(strip, foot.dispersal, &built.surface, &built.extrados).forces.is_empty()
        };
        let axles = case.axles.and_then(|[first, last]| {
            let mut standing = (first..=last).filter(reaches);
            let first = standing.next()?;
            Some([first, standing.next_back().unwrap_or(first)])
        });
        Case { axles, load: 0.0, ..case }
    }

    /// Both factors at every position, and the smaller one in front.
    fn told(&self, found: &Found<Case>) -> (Deformable, Vec<EnvelopePoint>) {
        let capacity = self.capacity;
        let mut envelope = self.swept.envelope.clone();
        let positions = envelope.len();
        for (point, answer) in envelope.iter_mut().zip(&found.answers) {
            point.rigid = point.adequacy;
            let Some(answer) = answer else { continue };
            point.deforms(answer.found.factor * capacity, &answer.case);
        }
        // The worst position, where it lies between the others.
        for answer in found.answers.iter().skip(positions).flatten() {
            let mut point = EnvelopePoint::at(answer.case.clone());
            point.deforms(answer.found.factor * capacity, &answer.case);
            envelope.push(point);
        }
        let permissible = found.service.told().map(|(criterion, factor, position)| PermissibleFactor {
            criterion,
            adequacy: factor * capacity,
            position,
        });
        let least = worst(&found.answers);
        let with_load = |case: &Case| {
            let weights = self.traffic.weights.iter().position(|w| *w == case.weights).unwrap_or(0);
            let load = self.strips(weights, case).1.iter().map(|strip| strip.force).sum();
            Case { load, ..case.clone() }
        };
        let deformable = Deformable {
            stands: true,
            falls: false,
            adequacy: least.map(|least| least.found.factor * capacity),
            case: least.map(|least| with_load(&least.case)),
            broken_off: found.broken_off(),
            permissible: permissible.collect(),
        };
        (deformable, envelope)
    }
}
