//! One vehicle wherever somebody puts it: at each place every case that a sweep tries there, and the least of them.

use super::beside;
use super::cases::{drives, places_apart, reach};
use super::factored::{self, Footprint, footprint, with_case};
use super::standing::Standing;
use super::weights;
use crate::analysis::AnalysisError;
use crate::analysis::moving::{Answer, DILATANCY, FAR_ABOVE, Key, Stands, Turns, least};
use crate::vehicles::{Chosen, Refused, chosen};
use bridge::{Bridge, Directions, SweepPlan};
use mechanics::limit::{Effect, Factor, Friction, Ground, Status, Sweeper};
use mechanics::watch::Unwatched;
use outcome::collapse::Status as Ended;
use outcome::note;
use outcome::vehicles::{Case, Direction, Weights};
use rules::Rule;
use structure::discretise::Discretised;

/// A vehicle with the rule whose factors its loads have.
#[derive(Debug, Clone)]
pub struct Driven {
    /// The rule.
    pub rule: Rule,
    /// The vehicle.
    pub vehicle: Chosen,
    /// Which way it drives.
    pub direction: Direction,
    /// By every share of braking that a sweep tries: the plan, and the vehicle with what stands in the lanes beside it.
    runs: Vec<(SweepPlan, Chosen)>,
    weights: Vec<Weights>,
}

impl Driven {
    /// A vehicle by its code, or the first of those that the plan moves. The plan says which rule, whose dispersal, which braking, and whether
    /// axles are left out.
    ///
    /// # Errors
    /// A vehicle or a rule that is not known, or that do not go together.
    pub fn new(bridge: &Bridge, plan: &SweepPlan, vehicle: &str, direction: Direction) -> Result<Driven, Refused> {
        let mut plan = plan.clone();
        if !vehicle.is_empty() {
            plan.vehicles = vec![vehicle.to_owned()];
        }
        let (rule, all) = chosen(bridge, &plan)?;
        let vehicle = all.into_iter().next().ok_or_else(Refused::default)?;
        let weights = weights::combinations(bridge, &rule);
        let shares: &[f64] = if plan.braking == 0.0 { &[0.0] } else { &[0.0, 1.0, -1.0] };
        let run = |share: &f64| (SweepPlan { braking: share * plan.braking, ..plan.clone() }, vehicle.clone());
        let runs = shares.iter().map(run).collect();
        Ok(Driven { rule, vehicle, direction, runs, weights })
    }

    /// The same on one state of the bridge, with what its rule puts into the lanes beside it, as in a sweep.
    ///
    /// # Errors
    /// Blocks that cannot be analysed.
    pub(in crate::analysis) fn on(&self, bridge: &Bridge) -> Result<Driven, AnalysisError> {
        let mut own = Driven { weights: weights::combinations(bridge, &self.rule), ..self.clone() };
        for (plan, vehicle) in &mut own.runs {
            let (all, step) = (vec![vehicle.clone()], places_apart(bridge, plan));
            let loaded = beside::loaded(bridge, (&own.rule, &*plan), all, (&own.weights, step), &mut Unwatched)?;
            *vehicle = loaded.into_iter().next().unwrap_or_else(|| vehicle.clone());
        }
        Ok(own)
    }

    /// The bridge under every combination of the rule's factors on weights, without loads.
    pub(in crate::analysis) fn bridges(&self, bridge: &Bridge) -> Vec<Bridge> {
        self.weights.iter().map(|weights| factored::bridge(bridge, &self.rule, weights)).collect()
    }

    /// The factored bridge with a case as its loads.
    pub(in crate::analysis) fn loaded(&self, bridge: &Bridge, case: &Case) -> Bridge {
        let run = self.runs.iter().find(|(plan, _)| plan.braking == case.horizontal).unwrap_or(&self.runs[0]);
        with_case(bridge, &run.0, &self.rule, &run.1, case)
    }

    /// Force [N] of each axle without factors, and how far it stands behind the first [m], in the first arrangement.
    pub fn axles(&self) -> Vec<(f64, f64)> {
        let first = self.vehicle.vehicle.patterns().into_iter().next();
        first.map_or(Vec::new(), |pattern| pattern.axles.iter().map(|axle| (axle.force, axle.offset)).collect())
    }

    /// How its axles stand on a bridge; braking, where it brakes.
    fn foot(&self, bridge: &Bridge) -> Footprint {
        let (plan, vehicle) = self.runs.last().unwrap_or(&self.runs[0]);
        footprint(bridge, plan, &self.rule, vehicle)
    }

    /// The factors that act, in words.
    pub fn factors(&self, bridge: &Bridge) -> String {
        let (acting, factors) = (&self.vehicle.acting, &self.rule.factors);
        let mut told =
            vec![format!("live load {}", acting.live_load.value), format!("impact {}", acting.impact.told())];
        let braking = self.foot(bridge).horizontal.abs();
        if braking != 0.0 {
            told.push(format!("braking {:.0} %", 100.0 * braking));
        }
        let others = [("condition", factors.condition.value), ("model", factors.model.value)];
        told.extend(
            others.iter().filter(|(_, factor)| *factor != 1.0).map(|(name, factor)| format!("{name} {factor}")),
        );
        format!("factors: {}", told.join(", "))
    }

    /// Which width carries an axle.
    pub fn width(&self, bridge: &Bridge) -> note::Moving {
        note::Moving::Width { across: self.foot(bridge).across }
    }
}

/// What is carried at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carried {
    /// How it ended.
    pub status: Ended,
    /// What all loads may be multiplied by: where joints slide, the lesser of the factors with and without dilation.
    pub factor: Option<f64>,
    /// The factor with dilatant friction.
    pub dilatant: Option<f64>,
    /// Whether joints slide in the mechanism with dilation.
    pub slides: bool,
}

impl Carried {
    /// No factor, and why.
    pub(in crate::analysis) fn nothing(status: Ended) -> Carried {
        Carried { status, factor: None, dilatant: None, slides: false }
    }

    /// Whether it says less of what is carried, or nothing.
    pub(in crate::analysis) fn is_worse_than(&self, other: &Carried) -> bool {
        match (self.factor, other.factor) {
            (Some(own), Some(others)) => own < others,
            // Loads that lock are carried; any other end without a factor is worse than a factor.
            (None, Some(_)) => self.status != Ended::Locks,
            (Some(_), None) => other.status == Ended::Locks,
            (None, None) => other.status == Ended::Locks && self.status != Ended::Locks,
        }
    }
}

/// What governs at a place.
pub(in crate::analysis) struct Governing {
    /// What is carried, as sweeps have it.
    pub carried: Carried,
    /// The case; none where every load is carried or nothing is known.
    pub case: Option<Case>,
    /// Its place among the combinations of weights.
    pub weights: usize,
    /// Whether its factor is that without dilation.
    pub level: bool,
    /// Whether it was not asked what is carried without dilation, and that may be less.
    pub is_open: bool,
}

/// Whether the load without dilation is asked where joints slide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::analysis) enum Asked {
    /// As a sweep does; loads of the file as an analysis by itself does.
    Carefully,
    /// Not: the answer says where it is open.
    Quickly,
}

impl Standing {
    /// What a vehicle may do on a bridge with a rule's factors, and its blocks: how it stands by every share of braking, and every arrangement of it.
    pub(in crate::analysis) fn of_one(driven: &Driven, bridge: &Bridge, d: &Discretised) -> Standing {
        let (mut feet, mut all) = (Vec::new(), Vec::new());
        let directions = match driven.direction {
            Direction::Right => Directions::Right,
            Direction::Left => Directions::Left,
        };
        for (k, (plan, vehicle)) in driven.runs.iter().enumerate() {
            let plan = &SweepPlan { directions, ..plan.clone() };
            let foot = footprint(bridge, plan, &driven.rule, vehicle);
            let own = reach(d, &foot);
            // Places are the caller's, and those of the drives are not asked.
            all.extend(drives(k, &vehicle.vehicle, plan, own, own[1] - own[0]));
            feet.push(foot);
        }
        let longest = all.iter().map(|drive| drive.pattern.length()).fold(0.0, f64::max);
        let mut standing = Standing::new((bridge, d), &driven.weights, feet, all);
        match driven.direction {
            Direction::Right => standing.range[1] += longest,
            Direction::Left => standing.range[0] -= longest,
        }
        standing
    }

    /// The least factor with the first axle at a place [m], over everything that a sweep tries there. One ground and one sweeper for each
    /// combination of weights.
    pub(in crate::analysis) fn governing(
        &self,
        (grounds, sweepers): (&[Ground], &mut [Sweeper<'_>]),
        position: f64,
        asked: Asked,
    ) -> Governing {
        let (cases, skipped) = self.tried((grounds, sweepers), position, asked);
        let (mut answered, mut open, mut locks) = (Vec::new(), Vec::new(), Vec::new());
        for (key, effect) in cases {
            let found = sweepers[key.weights].factor(&effect);
            match (found.lower, found.upper) {
                (Some(factor), Some(upper)) => {
                    let answer = Answer { key, factor, upper };
                    answered.push(Answered { answer, effect, dilatant: found });
                }
                _ if found.status == Status::Locks => locks.push((key, effect)),
                _ => open.push((key, effect)),
            }
        }
        let answers: Vec<Answer> = answered.iter().map(|case| case.answer).collect();
        // What locks with dilation may fall without, as in a sweep.
        let locks = locks.into_iter().filter(|_| asked == Asked::Carefully).max_by_key(|(key, _)| key.extent());
        let locking = locks.map(|(key, effect)| (key, sweepers[key.weights].gives_way(&effect)));
        let falls = locking.and_then(|(key, factor)| Some((key, factor?))).filter(|(_, factor)| factor.is_finite());
        let level = |(key, factor): (Key, f64), dilatant: Option<f64>| Governing {
            carried: Carried { status: Ended::Collapsed, factor: Some(factor), dilatant, slides: true },
            case: Some(self.told(&key)),
            weights: key.weights,
            level: true,
            is_open: false,
        };
        if locking.is_some_and(|(_, factor)| factor.is_none()) {
            return Governing::nothing(Ended::NotConverged);
        }
        let Some(worst) = least(&answers) else {
            let status = if open.is_empty() { Ended::Locks } else { Ended::NotConverged };
            let falls = falls.filter(|_| open.is_empty());
            return falls.map_or_else(|| Governing::nothing(status), |falls| level(falls, None));
        };
        // Where a factor above the least is proven to be carried, a case without an answer does not govern.
        let is_carried = |(key, effect): &(Key, Effect)| {
            let proven = sweepers[key.weights].proven_up_to(effect, DILATANCY * worst.factor);
            proven.is_some_and(|carried| carried > worst.factor)
        };
        if !open.iter().all(is_carried) {
            return Governing::nothing(Ended::NotConverged);
        }
        // Those that tie for the least in their order: the one that governs first.
        answered.sort_by(|a, b| a.answer.factor.total_cmp(&b.answer.factor));
        let first = answered.iter().position(|case| case.answer.key == worst.key).unwrap_or(0);
        answered[..=first].rotate_right(1);
        let may_slide = |case: &Answered| case.dilatant.slides && case.answer.factor <= DILATANCY * worst.factor;
        let (dilatant, slides) = (Some(worst.factor), answered[0].dilatant.slides);
        let mut governing = Governing {
            carried: Carried { status: Ended::Collapsed, factor: dilatant, dilatant, slides },
            case: Some(self.told(&worst.key)),
            weights: worst.key.weights,
            level: false,
            is_open: asked == Asked::Quickly && (skipped || answered.iter().any(may_slide)),
        };
        if asked == Asked::Quickly {
            return governing;
        }
        let (mut factor, mut turns) = (worst.factor, Turns::from(worst.factor));
        for Answered { answer: Answer { key, factor: dilates, .. }, effect, dilatant: with } in &answered {
            if !turns.may_govern(*dilates) {
                break;
            }
            let found = sweepers[key.weights].least_beside(effect, Friction::Automatic, *with);
            let Some(own) = found.factor else { return Governing::nothing(Ended::NotConverged) };
            turns.met(*dilates, own);
            if found.friction == Friction::NonAssociated && own < factor {
                factor = own;
                governing = level((*key, own), dilatant);
            }
        }
        falls.filter(|(_, own)| *own < factor).map_or(governing, |falls| level(falls, dilatant))
    }

    /// Every case at a place under every combination of weights. Asked quickly, cases are left out whose upper bound by the mechanisms met
    /// before lies far above the least such bound; whether any was.
    fn tried(
        &self,
        (grounds, sweepers): (&[Ground], &mut [Sweeper<'_>]),
        position: f64,
        asked: Asked,
    ) -> (Vec<(Key, Effect)>, bool) {
        let mut all = Vec::new();
        for drive in 0..self.drives.len() {
            for (key, effect) in self.cases(&mut sweepers[0], drive, position) {
                for (weights, ground) in grounds.iter().enumerate() {
                    all.push((Key { weights, ..key }, ground.taken(&effect, &grounds[0])));
                }
            }
        }
        if asked != Asked::Quickly {
            return (all, false);
        }
        let bounds: Vec<f64> = all.iter().map(|(key, effect)| sweepers[key.weights].at_most(effect)).collect();
        let most = FAR_ABOVE * bounds.iter().copied().fold(f64::INFINITY, f64::min);
        let count = all.len();
        let near: Vec<(Key, Effect)> =
            all.into_iter().zip(bounds).filter(|(_, bound)| *bound <= most).map(|(case, _)| case).collect();
        let skipped = near.len() < count;
        (near, skipped)
    }
}

/// A case with what it carries with dilation.
struct Answered {
    answer: Answer,
    effect: Effect,
    dilatant: Factor,
}

impl Governing {
    /// No case, and why.
    fn nothing(status: Ended) -> Governing {
        Governing { carried: Carried::nothing(status), case: None, weights: 0, level: false, is_open: false }
    }
}
