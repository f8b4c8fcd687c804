//! The least that moving loads come to on deformable joints, the same for loads of the file and for vehicles under a rule.
//!
//! At every place likely cases are followed along their equilibrium paths; then what was found to govern beside it, from place to place there and
//! back. The worst place is sought between the places, and what stands there is varied.

use super::super::moving::{REFINEMENTS, dips};
use super::super::parallel::{self, Stage};
use super::super::service::Service;
use super::{Bound, Followed, InService, follow};
use mechanics::blocks::PointForce;
use mechanics::path::{Ground, Sweeper};
use mechanics::watch::{CancelToken, Watch};
use std::ops::Range;

/// Places that one piece of work answers. Fixed, so that the numbers do not depend on the number of threads.
const CHUNK: usize = 24;

/// Factors of cases are not known to be better than this.
const SAME: f64 = 1e-4;

/// Rounds of variation at the worst place.
const ROUNDS: usize = 3;

/// Shares of the work at which all places are answered, and at which what governs beside them is known.
const SHARES: [f64; 2] = [0.7, 0.8];

/// The places of what moves over the bridge, in order.
pub(crate) struct Places<'a> {
    /// The bridge under its own weight, by every combination of factors on it.
    pub grounds: &'a [Ground],
    /// How far loads are followed at each; none where nothing bounds them.
    pub bounds: Vec<Option<Bound>>,
    /// Distance between them [m]; none where there is one alone.
    pub step: f64,
    /// Where it is also sought at which loads the bridge comes to states that it should not come to in service: the load factor of rigid blocks at
    /// the worst place, and which place that is.
    pub in_service: Option<(f64, Option<usize>)>,
}

/// What moves over the bridge, and what may stand there.
pub(crate) trait Moves: Sync {
    /// What stands on the bridge, and where.
    type Case: Clone + PartialEq + Send + Sync;

    /// Where it is moved.
    fn places(&self) -> &Places<'_>;

    /// What probably governs at a place.
    fn likely(&self, place: usize) -> Vec<Self::Case>;

    /// The same case at another place; none where it cannot stand there.
    fn like(&self, case: &Self::Case, place: usize) -> Option<Self::Case>;

    /// The same case, moved along the bridge [m].
    fn shifted(&self, case: &Self::Case, by: f64) -> Self::Case;

    /// Cases that differ from one in one respect, at the same place.
    fn varied(&self, case: &Self::Case) -> Vec<Self::Case>;

    /// Forces of a case on the blocks, and under which combination of weights; none of a case that is no longer one.
    fn forces(&self, case: &Self::Case) -> Option<(Vec<PointForce>, usize)>;

    /// Where a case stands [m].
    fn position(case: &Self::Case) -> f64;
}

/// A case on deformable joints.
#[derive(Debug, Clone)]
pub(crate) struct Answer<C> {
    pub case: C,
    pub found: Followed,
}

/// What is known of one that moves.
pub(crate) struct Found<C> {
    /// The least answer at every place, and at the worst one between the places behind them; none where nothing was found.
    pub answers: Vec<Option<Answer<C>>>,
    pub service: Service,
}

impl<C> Found<C> {
    /// At how many places the path broke off: the last state in balance counts there.
    pub(crate) fn broken_off(&self) -> usize {
        self.answers.iter().flatten().filter(|answer| answer.found.broken_off).count()
    }
}

/// The least of all answers.
pub(crate) fn worst<C>(answers: &[Option<Answer<C>>]) -> Option<&Answer<C>> {
    answers.iter().flatten().min_by(|a, b| a.found.factor.total_cmp(&b.found.factor))
}

/// Follows everything that moves over the bridge; tells whether all of it was done.
pub(crate) fn along<M: Moves>(all: &[M], watch: &mut dyn Watch) -> (Vec<Found<M::Case>>, bool) {
    let mut found: Vec<Found<M::Case>> = all.iter().map(begun).collect();
    let mut whole = everywhere(all, &mut found, watch) && over_borders(all, &mut found, watch);
    for (count, (one, found)) in all.iter().zip(&mut found).enumerate() {
        let share = |part: f64| SHARES[1] + (1.0 - SHARES[1]) * (count as f64 + part) / all.len() as f64;
        whole = whole && refined(one, found, [share(0.0), share(1.0)], watch);
    }
    (found, whole)
}

fn sweepers<M: Moves>(one: &M) -> Vec<Sweeper<'_>> {
    one.places().grounds.iter().map(Ground::sweeper).collect()
}

/// What all places start from: nothing but the states in service that likely cases come to at the worst place on rigid blocks, so that loads that
/// come to less are soon known to.
fn begun<M: Moves>(one: &M) -> Found<M::Case> {
    let Places { bounds, in_service, .. } = one.places();
    let (lowest, worst) = in_service.unwrap_or((f64::INFINITY, None));
    let mut service = Service::below(lowest);
    if let Some((place, bound)) = worst.and_then(|place| Some((place, bounds[place]?))) {
        let asked = (bound, &mut service, true);
        least(one, &mut sweepers(one), &one.likely(place), asked, &CancelToken::default());
    }
    Found { answers: Vec::new(), service }
}

/// The least answer at every place; tells whether the work was done.
fn everywhere<M: Moves>(all: &[M], found: &mut [Found<M::Case>], watch: &mut dyn Watch) -> bool {
    let chunks = |(k, one): (usize, &M)| {
        let count = one.places().bounds.len();
        (0..count).step_by(CHUNK).map(move |from| (k, from..(from + CHUNK).min(count)))
    };
    let jobs: Vec<(usize, Range<usize>)> = all.iter().enumerate().flat_map(chunks).collect();
    let steps = all.iter().map(|one| one.places().bounds.len() as u64).sum();
    let stage = Stage { name: "positions on deformable joints", steps, shares: [0.0, SHARES[0]] };
    let (parts, done) = parallel::each(&jobs, &stage, watch, |(k, places), token| {
        let (one, mut service) = (&all[*k], found[*k].service.clone());
        let mut sweepers = sweepers(one);
        let each = places.clone().map(|place| {
            let asked = (one.places().bounds[place]?, &mut service, true);
            let least = least(one, &mut sweepers, &one.likely(place), asked, token);
            token.step();
            least
        });
        let answers: Vec<Option<Answer<M::Case>>> = each.collect();
        let mut part = Found { answers, service };
        beside(one, &mut sweepers, places, &mut part, token);
        part
    });
    for ((k, places), part) in jobs.iter().zip(parts) {
        match part {
            Some(part) => {
                found[*k].answers.extend(part.answers);
                found[*k].service.merge(&part.service);
            }
            None => found[*k].answers.extend(places.clone().map(|_| None)),
        }
    }
    done
}

/// What governs beside the borders of the pieces of work: between their middles.
fn over_borders<M: Moves>(all: &[M], found: &mut [Found<M::Case>], watch: &mut dyn Watch) -> bool {
    let middles = |(k, one): (usize, &M)| {
        let count = one.places().bounds.len();
        (CHUNK / 2..count).step_by(CHUNK).map(move |from| (k, from..(from + CHUNK).min(count)))
    };
    let jobs: Vec<(usize, Range<usize>)> = all.iter().enumerate().flat_map(middles).collect();
    let stage = Stage { name: "cases beside others on deformable joints", steps: jobs.len() as u64, shares: SHARES };
    let (parts, done) = parallel::each(&jobs, &stage, watch, |(k, places), token| {
        let (answers, service) = (found[*k].answers[places.clone()].to_vec(), found[*k].service.clone());
        let mut part = Found { answers, service };
        beside(&all[*k], &mut sweepers(&all[*k]), places, &mut part, token);
        token.step();
        part
    });
    for ((k, places), part) in jobs.into_iter().zip(parts) {
        if let Some(part) = part {
            found[k].answers.splice(places, part.answers);
            found[k].service.merge(&part.service);
        }
    }
    done
}

/// Tries at every place what governs at those beside it.
fn beside<M: Moves>(
    one: &M,
    sweepers: &mut [Sweeper<'_>],
    places: &Range<usize>,
    found: &mut Found<M::Case>,
    token: &CancelToken,
) {
    let Found { answers, service } = found;
    let count = places.len();
    let there_and_back = (1..count).map(|k| (k - 1, k)).chain((1..count).rev().map(|k| (k, k - 1)));
    for (from, to) in there_and_back {
        let Some(other) = &answers[from] else { continue };
        let Some(case) = one.like(&other.case, places.start + to) else { continue };
        let bound = match &answers[to] {
            Some(known) if known.case == case => continue,
            Some(known) => Bound::below(known.found.factor * (1.0 - SAME)),
            None => match one.places().bounds[places.start + to] {
                Some(bound) => bound,
                None => continue,
            },
        };
        if let Some(smaller) = least(one, sweepers, &[case], (bound, service, false), token) {
            answers[to] = Some(smaller);
        }
    }
}

/// The least answer of some cases below a bound. What they come to in service is added, of cases that carry the bound if that is asked.
fn least<M: Moves>(
    one: &M,
    sweepers: &mut [Sweeper<'_>],
    cases: &[M::Case],
    (mut bound, service, by_themselves): (Bound, &mut Service, bool),
    token: &CancelToken,
) -> Option<Answer<M::Case>> {
    let mut least = None;
    for case in cases {
        let Some((forces, weights)) = one.forces(case) else { continue };
        let known = one.places().in_service.map(|_| &mut *service);
        let service = known.map(|known| InService { known, position: M::position(case), by_themselves });
        if let Some(found) = follow(&mut sweepers[weights], &forces, (bound, service), token) {
            bound = Bound::below(found.factor * (1.0 - SAME));
            least = Some(Answer { case: case.clone(), found });
        }
    }
    least
}

/// Answers beside which less may be found than the least of all; places lie a step [m] apart.
fn low<M: Moves>(answers: &[Option<Answer<M::Case>>], step: f64) -> Vec<&Answer<M::Case>> {
    let loads: Vec<Option<f64>> = answers.iter().map(|answer| Some(answer.as_ref()?.found.factor)).collect();
    let position = |k: usize| answers[k].as_ref().map(|answer| M::position(&answer.case));
    // Places of another drive lie elsewhere.
    let together = |k| position(k).zip(position(k + 1)).is_some_and(|(a, b)| (a - b).abs() < 1.5 * step);
    dips(&loads, together).into_iter().filter_map(|k| answers[k].as_ref()).collect()
}

/// Seeks the worst place between the places, then varies what stands there. What is found stands at the end of the answers. Tells whether the
/// work was done.
fn refined<M: Moves>(one: &M, known: &mut Found<M::Case>, [from, to]: [f64; 2], watch: &mut dyn Watch) -> bool {
    let Some(mut best) = worst(&known.answers).cloned() else { return true };
    let step = one.places().step;
    let rounds = if step > 0.0 { REFINEMENTS } else { 0 };
    let count = rounds + ROUNDS;
    for round in 0..count {
        let cases: Vec<M::Case> = match round < rounds {
            true => {
                let width = step * 0.1f64.powi(round as i32 + 1);
                let from = if round == 0 { low::<M>(&known.answers, step) } else { vec![&best] };
                let around = |from: &Answer<M::Case>| {
                    let each = (-10..=10).map(|k| one.shifted(&from.case, width * f64::from(k)));
                    each.collect::<Vec<_>>()
                };
                from.into_iter().flat_map(around).collect()
            }
            false => one.varied(&best.case),
        };
        let share = |round: usize| from + (to - from) * round as f64 / count as f64;
        let shares = [share(round), share(round + 1)];
        let stage = Stage { name: "worst positions on deformable joints", steps: cases.len() as u64, shares };
        let most = best.found.factor * (1.0 - SAME);
        let service = &known.service;
        let (parts, done) = parallel::each(&cases, &stage, watch, |case, token| {
            let (case, mut service) = (std::slice::from_ref(case), service.clone());
            let found = least(one, &mut sweepers(one), case, (Bound::below(most), &mut service, true), token);
            token.step();
            (found, service)
        });
        if !done {
            return false;
        }
        let mut found = Vec::with_capacity(cases.len());
        for (answer, service) in parts.into_iter().flatten() {
            known.service.merge(&service);
            found.push(answer);
        }
        match worst(&found) {
            Some(better) => best = better.clone(),
            None if round >= rounds => break,
            None => {}
        }
    }
    known.answers.push(Some(best));
    true
}
