//! Bounds of loads at many places: the least of all is wanted closely, the rest only so far as they prove that they are not the least.
//!
//! Every eighth place of a row is refined until both bounds are known. The mesh of a place between two of these is made as fine as theirs (of a row
//! of few places as that of the nearest), and its lower bound alone is sought: mostly that settles that it does not govern. What the bridge does
//! at one place is also a motion for loads at another: an upper bound that costs next to nothing; where soil fails below the loads and leaves
//! the bridge behind it says nothing, and a coarse mesh gives one. Places that neither settles are refined one mesh at a time, the least lower
//! bound first.

use super::{Bracket, Moving};
use crate::analysis::AnalysisError;
use crate::analysis::parallel::{self, Stage, portion};
use mechanics::watch::Watch;
use structure::discretise::dispersal::Strip;

/// Loads at a place.
#[derive(Debug, Clone)]
pub(in crate::analysis) struct Asked {
    /// Under which weights: the number of the body that they stand on.
    pub body: usize,
    /// Loads that differ from one another in their place alone have one number.
    pub row: usize,
    /// The place [m].
    pub position: f64,
    /// The loads there.
    pub strips: Vec<Strip>,
}

/// What was found of them.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct Answer {
    /// Its bounds on a mesh of its own.
    pub found: Bracket,
    /// An upper bound from the motion of loads at another place, or of a coarse mesh.
    elsewhere: Option<f64>,
    /// Whether a finer mesh gave nothing new.
    is_spent: bool,
}

impl Answer {
    pub(crate) fn of(found: Bracket) -> Answer {
        Answer { found, elsewhere: None, is_spent: false }
    }
    /// What is not.
    pub(crate) fn upper(&self) -> Option<f64> {
        [self.found.upper, self.elsewhere].into_iter().flatten().min_by(f64::total_cmp)
    }
    /// Whether its own motion is known.
    fn moves(&self) -> bool {
        self.found.upper.is_some() && self.found.bounds.is_some()
    }
}

/// Answers in the order of what was asked; none where work was broken off before.
pub(in crate::analysis) type Answers = Vec<Option<Answer>>;

/// Upper over lower bound to which every eighth place is answered before any is refined: one or two meshes.
const COARSE: f64 = 1.2;
/// One place in so many is refined by itself.
const STRIDE: usize = 8;
/// Places refined at once: fixed, so that the numbers do not depend on the number of threads.
const AT_ONCE: usize = 4;

/// Bounds at all places: the least lower bound of all is carried everywhere and the least upper one is not carried somewhere, and these two are
/// within a ratio where the meshes that the file allows reach it. Tells whether all was done. Places of a row are in their order.
pub(in crate::analysis) fn all(
    bodies: &[Moving<'_>],
    asked: &[Asked],
    ratio: f64,
    watch: &mut dyn Watch,
) -> Result<(Answers, bool), AnalysisError> {
    let mut work = Work { bodies, asked, answers: vec![None; asked.len()] };
    let seeds = seeds(asked);
    let own =
        |_: &Work<'_>, k: usize, token: &_| bodies[asked[k].body].bracket(&asked[k].strips, ratio.max(COARSE), token);
    let mut done = work.answered("bounds at every eighth place", &seeds, &mut portion(watch, [0.0, 0.3]), own)?;
    done = done && work.refined(ratio, &mut portion(watch, [0.3, 0.4]))?;
    let others: Vec<usize> = (0..asked.len()).filter(|k| !seeds.contains(k)).collect();
    if done {
        let like = |work: &Work<'_>, k: usize, token: &_| {
            bodies[asked[k].body].beside(&asked[k].strips, &work.apart_from(k, &seeds), token)
        };
        done = work.answered("lower bounds between them", &others, &mut portion(watch, [0.4, 0.7]), like)?;
    }
    done = done && work.bounded_above(false, &mut portion(watch, [0.7, 0.72]))?;
    done = done && work.refined(ratio, &mut portion(watch, [0.72, 0.9]))?;
    done = done && work.bounded_above(true, &mut portion(watch, [0.9, 1.0]))?;
    Ok((work.answers, done))
}

/// Every eighth place of each row, and its last. A row of fewer places, as of axles that govern here and there, has none where its body has a longer
/// one: meshes of that serve it.
fn seeds(asked: &[Asked]) -> Vec<usize> {
    let mut found = Vec::new();
    let mut rows: Vec<usize> = asked.iter().map(|one| one.row).collect();
    rows.sort_unstable();
    rows.dedup();
    let rows: Vec<Vec<usize>> =
        rows.into_iter().map(|row| (0..asked.len()).filter(|&k| asked[k].row == row).collect()).collect();
    for of in &rows {
        let is_long = |other: &&Vec<usize>| other.len() >= STRIDE && asked[other[0]].body == asked[of[0]].body;
        if of.len() < STRIDE && rows.iter().any(|other| is_long(&other)) {
            continue;
        }
        found.extend(of.iter().copied().step_by(STRIDE));
        found.extend(of.last().copied().filter(|_| !(of.len() - 1).is_multiple_of(STRIDE)));
    }
    found.sort_unstable();
    found
}

struct Work<'a> {
    bodies: &'a [Moving<'a>],
    asked: &'a [Asked],
    answers: Answers,
}

impl Work<'_> {
    /// Answers some places, and tells whether all were.
    fn answered(
        &mut self,
        name: &str,
        which: &[usize],
        watch: &mut dyn Watch,
        of: impl Fn(&Self, usize, &parallel::CancelToken) -> Result<Bracket, AnalysisError> + Sync,
    ) -> Result<bool, AnalysisError> {
        let stage = Stage { name, steps: which.len() as u64, shares: [0.0, 1.0] };
        let this = &*self;
        let (found, done) = parallel::each(which, &stage, watch, |&k, token| {
            let bracket = of(this, k, token)?;
            token.step();
            Ok::<_, AnalysisError>(bracket)
        });
        for (&k, answer) in which.iter().zip(found) {
            if let Some(found) = answer.transpose()? {
                let before = self.answers[k].take();
                let elements = before.as_ref().map(|before| (before.found.elements(), before.moves()));
                let own = Answer::of(found);
                let is_spent = elements == Some((own.found.elements(), own.moves()));
                self.answers[k] = Some(Answer { is_spent, elsewhere: before.and_then(|one| one.elsewhere), ..own });
            }
        }
        Ok(done)
    }

    /// Refines the places that keep the least bounds of all further apart than wanted, the smallest first; whether all was done.
    fn refined(&mut self, ratio: f64, watch: &mut dyn Watch) -> Result<bool, AnalysisError> {
        loop {
            let next = apart(&self.answers, ratio);
            if next.is_empty() {
                return Ok(true);
            }
            let closer = |this: &Work<'_>, k: usize, token: &_| {
                let one = &this.asked[k];
                // Only answered places are refined.
                let before = this.answers[k].as_ref().map_or(&Bracket::NOTHING, |answer| &answer.found);
                this.bodies[one.body].closer(&one.strips, before, token)
            };
            if !self.answered("bounds at places that may govern", &next, watch, closer)? {
                return Ok(false);
            }
        }
    }

    /// Puts upper bounds beside places that have none of their own: from motions at neighbouring places, and where these say little, `by_program`
    /// on a coarse mesh.
    fn bounded_above(&mut self, by_program: bool, watch: &mut dyn Watch) -> Result<bool, AnalysisError> {
        let lacks =
            |k: &usize| self.answers[*k].as_ref().is_some_and(|a| a.found.lower.is_some() && a.found.upper.is_none());
        let which: Vec<usize> = (0..self.asked.len()).filter(lacks).collect();
        let moving: Vec<usize> =
            (0..self.asked.len()).filter(|&k| self.answers[k].as_ref().is_some_and(Answer::moves)).collect();
        let stage = Stage { name: "upper bounds beside lower ones", steps: which.len() as u64, shares: [0.0, 1.0] };
        let this = &*self;
        let (found, done) = parallel::each(&which, &stage, watch, |&k, token| {
            let (one, body) = (&this.asked[k], &this.bodies[this.asked[k].body]);
            let before = this.answers[k].as_ref();
            let mut least = before.and_then(|answer| answer.elsewhere);
            let others = this.apart_from(k, &moving);
            for (other, _) in &others {
                let upper = body.upper_from(&one.strips, other)?;
                least = [least, upper].into_iter().flatten().min_by(f64::total_cmp);
            }
            let lower = before.and_then(|answer| answer.found.lower).unwrap_or(0.0);
            if by_program && least.is_none_or(|least| least > COARSE * lower) {
                let upper = body.above(&one.strips, &others, token)?;
                least = [least, upper].into_iter().flatten().min_by(f64::total_cmp);
            }
            token.step();
            Ok::<_, AnalysisError>(least)
        });
        for (&k, upper) in which.iter().zip(found) {
            if let (Some(upper), Some(answer)) = (upper.transpose()?, &mut self.answers[k]) {
                answer.elsewhere = upper;
            }
        }
        Ok(done)
    }

    /// Of some places, what was found at those next to a place in its row, and how far they lie to its left [m].
    fn apart_from(&self, k: usize, of: &[usize]) -> Vec<(&Bracket, f64)> {
        let distance = |j: usize| self.asked[k].position - self.asked[j].position;
        self.beside(k, of).into_iter().filter_map(|j| Some((&self.answers[j].as_ref()?.found, distance(j)))).collect()
    }

    /// Of some places, those next to a place on its left and on its right in its row; where that has none, the nearest of its body.
    fn beside(&self, k: usize, of: &[usize]) -> Vec<usize> {
        let own = &self.asked[k];
        let row = || of.iter().copied().filter(|&j| j != k && self.asked[j].row == own.row);
        let (left, right) = (row().filter(|&j| j < k).max(), row().filter(|&j| j > k).min());
        let apart = |j: usize| (self.asked[j].position - own.position).abs();
        let others = of.iter().copied().filter(|&j| j != k && self.asked[j].body == own.body);
        let nearest = || others.min_by(|&i, &j| apart(i).total_cmp(&apart(j)).then(i.abs_diff(k).cmp(&j.abs_diff(k))));
        match [left, right] {
            [None, None] => nearest().into_iter().collect(),
            both => both.into_iter().flatten().collect(),
        }
    }
}

/// The places whose lower bounds are smaller than the least upper bound of all over the wanted ratio, the smallest first.
fn apart(answers: &[Option<Answer>], ratio: f64) -> Vec<usize> {
    let all = || answers.iter().enumerate().filter_map(|(k, answer)| Some((k, answer.as_ref()?)));
    let least = all().filter_map(|(_, answer)| answer.upper()).fold(f64::INFINITY, f64::min);
    let open = |answer: &Answer| answer.found.lower.filter(|lower| !answer.is_spent && *lower < least / ratio);
    let mut open: Vec<_> = all().filter_map(|(k, answer)| Some((open(answer)?, k))).collect();
    open.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    open.into_iter().map(|(_, k)| k).take(AT_ONCE).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::collapse::Status;

    fn at(lower: f64, upper: f64) -> Option<Answer> {
        let found = Bracket { status: Status::Collapsed, lower: Some(lower), upper: Some(upper), bounds: None };
        Some(Answer::of(found))
    }

    #[test]
    fn places_are_refined_until_the_least_bounds_of_all_are_as_close_as_wanted() {
        let mut places =
            vec![at(5.0, 6.0), at(2.0, 2.4), at(2.3, 2.7), None, at(2.1, 2.5), at(2.26, 2.6), at(2.05, 2.6)];
        places.push(Some(Answer::of(Bracket::NOTHING)));
        // The least upper bound is 2.4: what carries 2.4 / 1.05 = 2.286 keeps nothing apart.
        assert_eq!(apart(&places, 1.05), [1, 6, 4, 5]);
        assert!(apart(&places, 1.5).is_empty());
        // Nothing more is to be had at one of them, and the others have risen.
        places[1].as_mut().unwrap().is_spent = true;
        for k in [4, 5, 6] {
            places[k] = at(2.29, 2.45);
        }
        assert!(apart(&places, 1.05).is_empty());
        // An upper bound from another place counts as any other.
        places[0].as_mut().unwrap().elsewhere = Some(2.2);
        places[1].as_mut().unwrap().is_spent = false;
        assert_eq!(apart(&places, 1.05), [1]);
    }

    /// Bridgemill under soil so strong that the ring fails, and under its own soil, which fails below the load.
    fn bridgemill(cohesion: &str) -> bridge::Bridge {
        let text = include_str!("../../../../../../examples/bridgemill/continuum.toml");
        let text = text.replace("\"10 kPa\"", cohesion);
        let read = bridge::read(text.as_bytes());
        read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
    }

    #[test]
    fn the_motion_of_loads_at_one_place_bounds_loads_at_another() {
        let bridge = bridgemill("\"200 kPa\"");
        let d = structure::discretise::discretise(&bridge).unwrap();
        let moving = Moving::new(&bridge, &d).unwrap();
        let at = |offset: f64| {
            bridge
                .loads
                .iter()
                .flat_map(|l| structure::discretise::dispersal::strips(l, offset))
                .collect::<Vec<Strip>>()
        };
        let [here, near, there] =
            [0.0, -0.2, 0.4].map(|offset| moving.bracket(&at(offset), 1.2, &parallel::CancelToken::default()).unwrap());
        let (lower, upper) = (there.lower.unwrap(), here.upper.unwrap());
        // The same place: the plate rides as it did.
        let same = moving.upper_from(&at(0.0), &here).unwrap().unwrap();
        assert!((same / upper - 1.0).abs() < 1e-4, "{same} {upper}");
        // Towards the springing the plate sinks less than it did, and the bound is 1.1 times the place's own; towards the crown it rides on what
        // its neighbour heaves up.
        let [left, right] = [-0.2, 0.4].map(|offset| moving.upper_from(&at(offset), &here).unwrap().unwrap());
        assert!(
            near.lower.unwrap() < left && left < 1.2 * near.upper.unwrap(),
            "{left} {:?} {:?}",
            near.lower,
            near.upper
        );
        assert!(1.05 * same < left && lower < right, "{same} {left} {lower} {right}");
        // A mesh as fine as that of the neighbour has a lower bound no worse than its own but for a little, and an upper one above it.
        let like = [(&here, 0.4)];
        let beside = moving.beside(&at(0.4), &like, &parallel::CancelToken::default()).unwrap();
        let above = moving.above(&at(0.4), &like, &parallel::CancelToken::default()).unwrap().unwrap();
        assert!(beside.lower.unwrap() > 0.9 * lower && beside.upper.is_none(), "{:?} {lower}", beside.lower);
        assert!(beside.lower.unwrap() < there.upper.unwrap() && lower < above, "{above}");
    }

    #[test]
    fn every_eighth_place_of_a_row_and_its_last_are_refined_by_themselves() {
        let row = |row: usize, count: usize| {
            (0..count).map(move |k| Asked { body: 0, row, position: k as f64, strips: Vec::new() })
        };
        let asked: Vec<Asked> = row(0, 18).chain(row(1, 2)).chain(row(2, 9)).collect();
        assert_eq!(seeds(&asked), [0, 8, 16, 17, 20, 28]);
        // The short row is served by what is answered nearest to it.
        let work = Work { bodies: &[], asked: &asked, answers: vec![None; asked.len()] };
        assert_eq!([work.beside(18, &seeds(&asked)), work.beside(4, &seeds(&asked))], [vec![20], vec![0, 8]]);
        // Alone it has its own.
        let alone: Vec<Asked> = row(1, 2).collect();
        assert_eq!(seeds(&alone), [0, 1]);
    }
}
