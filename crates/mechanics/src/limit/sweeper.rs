//! Many loads on one model, one after the other: everything that does not depend on the load is made once, and the
//! mechanism of one load is the start for the next.

use super::bounds;
use super::boxed::{Bounded, greatest_between};
use super::collapse::{Found, largest_factor_of_carried, outcome};
use super::compliance::Stiffness;
use super::equilibrium::Equilibrium;
use super::ground::{Effect, Ground, Reduced, sum_of_sizes};
use super::level::{WithDilation, without_dilation};
use super::mechanism::mechanism;
use super::outcome::{Outcome, Status};
use super::program::Solution;
use super::proven::carried_up_to;
use super::reduced::tangents;
use super::settings::Friction;
use super::simplex::{Corner, Ended, Member, Start};
use super::stiff::WithoutDilation;
use crate::blocks::PointForce;
use crate::watch::CancelToken;

/// Bounds that differ by more than this, relative, are left to the interior-point method: far above the round-off of a
/// refined corner, far below the 1e-6 to which both bounds must agree.
const GAP: f64 = 1e-9;
/// Force by which a joint may lie outside its parabola, scaled: as far as the interior-point method leaves it.
const OUTSIDE: f64 = 1e-10;
/// Most rounds of tangents for one load; each squares the distance to the parabolas.
const ROUNDS: usize = 40;
/// Mechanisms that are kept as starts.
const KEPT: usize = 48;
/// Tangents beyond the rows that every load has; with more, those of no kept mechanism are dropped. The search looks at every
/// row, and without a bound a sweep of joints that crush gathers tens of thousands.
const TANGENTS: usize = 300;
/// Largest velocity against the flow rule, relative to the fastest, with which a motion bounds other loads.
const FLOWS: f64 = 1e-6;

/// A load factor and how sure it is; by default none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Factor {
    /// How it ended.
    pub status: Status,
    /// Factor of the returned forces; a lower bound.
    pub lower: Option<f64>,
    /// Factor of the mechanism by the work equation; an upper bound.
    pub upper: Option<f64>,
    /// Whether joints slide in the mechanism.
    pub slides: bool,
    /// Exchanges of the simplex method, or iterations of the interior-point method.
    pub iterations: usize,
    /// Whether the interior-point method had to help.
    pub by_interior_point: bool,
}

/// The least of what is carried with dilation and without it, as an analysis of the load by itself has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Least {
    /// With dilation.
    pub dilatant: Factor,
    /// How it ended.
    pub status: Status,
    /// The factor; none unless solved.
    pub factor: Option<f64>,
    /// The flow rule that the factor belongs to.
    pub friction: Friction,
    /// Where the load without dilation comes and goes, and the factor is its largest: the least since then.
    pub falls_to: Option<f64>,
}

impl Ground {
    /// A sweep over loads. Results do not depend on other sweepers of the same ground.
    pub fn sweeper(&self) -> Sweeper<'_> {
        self.sweeper_with(Experience::default())
    }

    /// The same with what an earlier sweeper of this ground learnt.
    pub fn sweeper_with(&self, learnt: Experience) -> Sweeper<'_> {
        // Also where the fast method has nothing to work on: what joints carry is told all the same.
        let elastic = Stiffness::alike(&self.equilibrium);
        let reduced = learnt.reduced.or_else(|| self.reduced.clone()).filter(|_| elastic.is_some());
        let learnt = Experience { reduced, ..learnt };
        Sweeper { ground: self, elastic, learnt, token: CancelToken::default() }
    }
}

/// What a sweeper has learnt: mechanisms to start from, motions to bound loads by. It belongs to its ground.
#[derive(Default)]
pub struct Experience {
    reduced: Option<Reduced>,
    /// Mechanisms: rows with their multipliers, and the basis.
    kept: Vec<Kept>,
    next: usize,
    /// Motions that were given at the beginning.
    given: Vec<Moved>,
    /// Motions of loads that the interior-point method answered.
    moved: Vec<Moved>,
    oldest: usize,
}

/// A mechanism to start from.
struct Kept {
    mechanism: Vec<(usize, f64)>,
    /// What the mechanism needs of a load: the right sides of its rows times their multipliers.
    resistance: f64,
    start: Start,
}

/// A motion that the interior-point method found, and what it needs of a load.
struct Moved {
    velocities: Vec<f64>,
    resistance: f64,
}

impl Moved {
    /// Upper bound of a load's factor; infinite where the load does not drive the motion.
    fn bound(&self, load: &[f64], least: f64) -> f64 {
        let work: f64 = load.iter().zip(&self.velocities).map(|(p, u)| p * u).sum();
        if work > least { self.resistance / work } else { f64::INFINITY }
    }
}

/// Share of a load's size, times the fastest velocity of a motion, that the load must do in work to be bounded by it.
const DRIVES: f64 = 1e-9;

/// How far the fast method came with a load.
enum Reached {
    /// The best corner, and the factor of the load over its last unknown.
    Corner(Corner, f64),
    /// The load is carried however large it is.
    Locks,
}

/// Answers loads one after the other.
pub struct Sweeper<'a> {
    ground: &'a Ground,
    elastic: Option<Stiffness<'a>>,
    /// What it has learnt, for [`Ground::sweeper_with`].
    pub learnt: Experience,
    token: CancelToken,
}

impl Sweeper<'_> {
    /// Asks whether to go on; factors and forces that it finds after the end are none.
    #[must_use]
    pub fn paced(mut self, token: &CancelToken) -> Self {
        self.token = token.clone();
        self
    }

    /// What a load does.
    pub fn effect(&mut self, load: &[PointForce]) -> Effect {
        let ground = self.ground;
        let scaled = ground.scaled(load);
        let columns = ground.equilibrium.columns.len();
        let forces = self.elastic.as_mut().and_then(|elastic| {
            let size = sum_of_sizes(&scaled);
            if size == 0.0 {
                return Some(vec![0.0; columns]);
            }
            let unit: Vec<f64> = scaled.iter().map(|p| p / size).collect();
            elastic.balance(&unit).map(|forces| forces.iter().map(|f| f * size).collect())
        });
        let balanced = forces.is_some();
        let forces = forces.unwrap_or_else(|| vec![0.0; columns]);
        let elastic = ground.bedded.as_ref().map_or_else(|| forces.clone(), |bedded| bedded.relaxed(&forces));
        Effect { load: scaled, forces, elastic, balanced }
    }

    /// The effect of no load.
    pub fn nothing(&self) -> Effect {
        let equilibrium = &self.ground.equilibrium;
        let none = vec![0.0; equilibrium.columns.len()];
        Effect { load: vec![0.0; equilibrium.rows], forces: none.clone(), elastic: none, balanced: true }
    }

    /// The factor at which a load makes a mechanism, with dilatant friction.
    pub fn factor(&mut self, effect: &Effect) -> Factor {
        match self.corner(effect) {
            Some(reached) => self.quickly(&reached),
            None => self.slowly(effect),
        }
    }

    /// What the fast method found.
    fn quickly(&self, reached: &Reached) -> Factor {
        match reached {
            _ if self.token.is_cancelled() => Factor { status: Status::Cancelled, ..Factor::default() },
            Reached::Corner(corner, scale) => Factor {
                status: Status::Solved,
                lower: corner.z.last().map(|z| z.max(0.0) * scale),
                upper: Some(corner.upper.max(0.0) * scale),
                slides: self.slides(corner),
                iterations: corner.pivots,
                by_interior_point: false,
            },
            Reached::Locks => Factor { status: Status::Locks, ..Factor::default() },
        }
    }

    /// The same by the interior-point method.
    fn slowly(&mut self, effect: &Effect) -> Factor {
        let (equilibrium, found) = self.by_interior_point(effect);
        if self.token.is_cancelled() {
            return Factor { status: Status::Cancelled, ..Factor::default() };
        }
        let (solved, solution) = (found.status == Status::Solved, &found.solution);
        let scale = equilibrium.factor_scale;
        let mechanism = mechanism(&self.ground.model, &equilibrium, &solution.velocities);
        let upper = || bounds::least_upper(&equilibrium, &solution.forces, &solution.velocities).factor * scale;
        self.learn(&solution.velocities);
        Factor {
            status: found.status,
            lower: solved.then_some(solution.factor * scale),
            upper: solved.then(upper),
            slides: solved && mechanism.is_some_and(|m| !m.sliding.is_empty()),
            iterations: found.iterations as usize,
            by_interior_point: true,
        }
    }

    /// The factor by the friction that is asked for: with [`Friction::Automatic`] the least of those with and without dilation, as an
    /// analysis of the load by itself has it.
    pub fn least(&mut self, effect: &Effect, friction: Friction) -> Least {
        let dilatant = self.factor(effect);
        self.least_beside(effect, friction, dilatant)
    }

    /// The same where the factor with dilation is known.
    pub fn least_beside(&mut self, effect: &Effect, friction: Friction, mut dilatant: Factor) -> Least {
        // That a load is endless is asked twice.
        if dilatant.status == Status::Locks && !dilatant.by_interior_point && friction != Friction::Associated {
            dilatant = self.slowly(effect);
        }
        let Factor { status, lower, slides, .. } = dilatant;
        let dilates = Least { dilatant, status, factor: lower, friction: Friction::Associated, falls_to: None };
        if friction == Friction::Associated || !matches!(status, Status::Solved | Status::Locks) {
            return dilates;
        }
        let equilibrium = self.loaded(effect);
        let scale = equilibrium.factor_scale;
        let beside = WithDilation { status, factor: lower.unwrap_or(0.0) / scale, slides };
        let level = without_dilation(&equilibrium, &beside, &self.ground.stands.at_rest);
        if self.token.is_cancelled() {
            let dilatant = Factor { status: Status::Cancelled, ..Factor::default() };
            return Least { dilatant, status: Status::Cancelled, factor: None, ..dilates };
        }
        if !level.governs(friction, &beside) {
            return dilates;
        }
        let (status, factor, falls_to) = match level {
            WithoutDilation::Load { solution, spread, comes_and_goes } => {
                (Status::Solved, Some(solution.factor * scale), comes_and_goes.then_some(spread[0] * scale))
            }
            WithoutDilation::Locks => (Status::Locks, None, None),
            WithoutDilation::Jammed | WithoutDilation::Unsettled => (Status::NotConverged, None, None),
        };
        Least { status, factor, friction: Friction::NonAssociated, falls_to, ..dilates }
    }

    /// A factor up to `most` that is proven to be carried with dilation, also where no largest one was found.
    pub fn proven_up_to(&self, effect: &Effect, most: f64) -> Option<f64> {
        let equilibrium = self.loaded(effect);
        let scale = equilibrium.factor_scale;
        let roomy = self.ground.stands.roomy(&equilibrium)?;
        Some(carried_up_to(&equilibrium, roomy, most / scale)? * scale)
    }

    /// The factor at which blocks that rest between stiff joints give way without dilation, however they were put together; infinite where they
    /// carry any load, none where the way there has no end.
    pub fn gives_way(&self, effect: &Effect) -> Option<f64> {
        let equilibrium = self.loaded(effect);
        let stood = self.ground.stands.at_rest.stood(&equilibrium)?;
        match stood.under(&equilibrium, 0.0) {
            WithoutDilation::Load { solution, .. } => Some(solution.factor.max(0.0) * equilibrium.factor_scale),
            WithoutDilation::Locks => Some(f64::INFINITY),
            WithoutDilation::Jammed | WithoutDilation::Unsettled => None,
        }
    }

    /// Upper bound of a load's factor by the mechanisms of loads that were answered before; infinite where none bounds it.
    pub fn at_most(&self, effect: &Effect) -> f64 {
        let least = DRIVES * sum_of_sizes(&effect.load);
        let moved = self.learnt.given.iter().chain(&self.learnt.moved).map(|moved| moved.bound(&effect.load, least));
        let kept = self.learnt.reduced.as_ref().and_then(|reduced| {
            let size = sum_of_sizes(&effect.load);
            self.least_kept(&reduced.lasts(0, effect, size)).map(|(factor, _)| factor / size)
        });
        moved.fold(kept.unwrap_or(f64::INFINITY), f64::min)
    }

    /// The same by the motion that was learnt last.
    pub fn at_most_by_newest(&self, effect: &Effect) -> f64 {
        let least = DRIVES * sum_of_sizes(&effect.load);
        self.newest().map_or(f64::INFINITY, |moved| moved.bound(&effect.load, least))
    }

    /// The scaled velocities that were learnt last.
    pub fn newest_motion(&self) -> Option<&[f64]> {
        self.newest().map(|moved| &moved.velocities[..])
    }

    fn newest(&self) -> Option<&Moved> {
        let newest = (self.learnt.oldest + self.learnt.moved.len()).checked_sub(1)?;
        self.learnt.moved.get(newest % KEPT)
    }

    /// Learns scaled velocities of the same blocks, also those found under other weights, to bound loads by.
    pub fn learn(&mut self, velocities: &[f64]) {
        let Some(moved) = self.moved_as(velocities) else { return };
        if self.learnt.moved.len() < KEPT {
            self.learnt.moved.push(moved);
        } else {
            self.learnt.moved[self.learnt.oldest] = moved;
            self.learnt.oldest = (self.learnt.oldest + 1) % KEPT;
        }
    }

    /// Takes scaled velocities that are never given up for newer ones.
    pub fn take(&mut self, all: &[Vec<f64>]) {
        let taken: Vec<Moved> = all.iter().filter_map(|velocities| self.moved_as(velocities)).collect();
        self.learnt.given.extend(taken);
    }

    /// A motion and what it needs; none where joints do what they may not, or where nothing moves.
    fn moved_as(&self, velocities: &[f64]) -> Option<Moved> {
        let fastest = velocities.iter().fold(0.0f64, |most, u| most.max(u.abs()));
        let velocities: Vec<f64> = velocities.iter().map(|u| u / fastest).collect();
        let needs = bounds::resistance(&self.ground.equilibrium, &velocities);
        let bounds = fastest > 0.0 && needs.violation <= FLOWS && needs.factor.is_finite();
        bounds.then_some(Moved { velocities, resistance: needs.factor })
    }

    /// Forces, resultants and mechanism at the factor of [`Sweeper::least`] by this friction.
    pub fn outcome(&mut self, effect: &Effect, friction: Friction) -> Outcome {
        let Ground { model, interfaces, stands, .. } = self.ground;
        let (equilibrium, found) = self.found(effect);
        outcome(model, &equilibrium, interfaces.clone(), &found, friction, &stands.at_rest)
    }

    /// Scaled velocities of the mechanism at that factor.
    pub fn motion(&mut self, effect: &Effect) -> Vec<f64> {
        self.found(effect).1.solution.velocities
    }

    fn found(&mut self, effect: &Effect) -> (Equilibrium, Found) {
        match self.corner(effect) {
            Some(Reached::Corner(corner, _)) => (self.loaded(effect), self.solution(effect, &corner)),
            Some(Reached::Locks) | None => self.by_interior_point(effect),
        }
    }

    /// How far the fast method comes; none where that is nowhere.
    fn corner(&mut self, effect: &Effect) -> Option<Reached> {
        let size = sum_of_sizes(&effect.load);
        if !effect.balanced || !(size > 0.0) || !size.is_finite() {
            return None;
        }
        let mut last = self.learnt.reduced.as_ref()?.lasts(0, effect, size);
        let bounding = self.least_kept(&last).map(|(_, index)| index);
        let mut start = bounding.map(|index| self.learnt.kept[index].start.clone());
        let count = self.ground.equilibrium.restraints.len();
        for round in 0..ROUNDS {
            let reduced = self.learnt.reduced.as_ref()?;
            let bounded = Bounded { first: reduced.standing - 2 * count, count };
            let corner = match greatest_between(&reduced.rows, bounded, &last, start.as_ref(), &self.token) {
                Ended::Best(corner) => corner,
                // Tangents of joints that crush may still be missing. No load is endless that a known mechanism bounds.
                Ended::Unbounded if !self.ground.equilibrium.crushes() && bounding.is_none() => {
                    return Some(Reached::Locks);
                }
                Ended::Unbounded | Ended::Lost => return None,
            };
            let factor = corner.z.last().copied()?;
            if (corner.upper - factor).abs() > GAP * (1.0 + factor.abs()) {
                return None;
            }
            let forces = reduced.forces(effect, &corner.z, 1.0 / size);
            let more = tangents(&self.ground.equilibrium, &forces, OUTSIDE * (1.0 + factor.abs()));
            if more.is_empty() {
                let is_new = round > 0 || corner.pivots > 0;
                let corner = self.tidied(corner);
                if is_new {
                    self.keep(&corner);
                }
                return Some(Reached::Corner(corner, 1.0 / size));
            }
            let reduced = self.learnt.reduced.as_mut()?;
            let first = reduced.limits.len();
            reduced.extend(more);
            last.extend(reduced.lasts(first, effect, size));
            start = Some(reduced.sharpened(corner.start, first, &last));
        }
        None
    }

    /// The least upper bound by a kept mechanism of the factor of a load with this last column, and which it is.
    fn least_kept(&self, last: &[f64]) -> Option<(f64, usize)> {
        let (mut least, mut best) = (f64::INFINITY, None);
        for (index, Kept { mechanism, resistance, .. }) in self.learnt.kept.iter().enumerate() {
            let work: f64 = mechanism.iter().map(|&(k, y)| y * last[k]).sum();
            if work > DRIVES && resistance / work < least {
                (least, best) = (resistance / work, Some(index));
            }
        }
        best.map(|index| (least, index))
    }

    fn keep(&mut self, corner: &Corner) {
        let Some(reduced) = &self.learnt.reduced else { return };
        let mechanism: Vec<(usize, f64)> = corner.basis.iter().copied().filter(|m| m.1 > 0.0).collect();
        let resistance = mechanism.iter().map(|&(k, y)| y * reduced.rows.b[k]).sum();
        let kept = Kept { mechanism, resistance, start: corner.start.clone() };
        if self.learnt.kept.len() < KEPT {
            self.learnt.kept.push(kept);
        } else {
            self.learnt.kept[self.learnt.next] = kept;
            self.learnt.next = (self.learnt.next + 1) % KEPT;
        }
    }

    /// Drops tangents where there are many, and names the rows of the corner anew.
    fn tidied(&mut self, mut corner: Corner) -> Corner {
        let Some(reduced) = self.learnt.reduced.as_mut().filter(|r| r.limits.len() > r.standing + TANGENTS) else {
            return corner;
        };
        let mut wanted = vec![false; reduced.limits.len()];
        let bases = self.learnt.kept.iter().map(|kept| &kept.start.members).chain([&corner.start.members]);
        for member in bases.flatten() {
            if let Member::Row(k) = member {
                wanted[*k] = true;
            }
        }
        let places = reduced.keep(|k| wanted[k]);
        let rename = |members: &mut Vec<Member>, rows: &mut Vec<(usize, f64)>| {
            for member in members.iter_mut() {
                if let Member::Row(k) = member {
                    *k = places[*k].unwrap_or(*k);
                }
            }
            for (k, _) in rows.iter_mut() {
                *k = places[*k].unwrap_or(*k);
            }
        };
        for kept in &mut self.learnt.kept {
            rename(&mut kept.start.members, &mut kept.mechanism);
        }
        rename(&mut corner.start.members, &mut corner.basis);
        corner
    }

    fn slides(&self, corner: &Corner) -> bool {
        let largest = corner.basis.iter().map(|m| m.1).fold(0.0, f64::max);
        let limits = self.learnt.reduced.as_ref().map_or(&[][..], |r| &r.limits[..]);
        corner.basis.iter().any(|&(k, y)| limits[k].slides && y > 1e-6 * largest)
    }

    /// The loads' equilibrium with this effect as the variable load.
    fn loaded(&self, effect: &Effect) -> Equilibrium {
        let mut equilibrium = self.ground.equilibrium.clone();
        let size = sum_of_sizes(&effect.load);
        equilibrium.token = self.token.clone();
        equilibrium.factor_scale = if size > 0.0 { 1.0 / size } else { 1.0 };
        equilibrium.variable = effect.load.iter().map(|p| p * equilibrium.factor_scale).collect();
        equilibrium
    }

    fn by_interior_point(&self, effect: &Effect) -> (Equilibrium, Found) {
        let equilibrium = self.loaded(effect);
        let found = largest_factor_of_carried(&equilibrium, &self.ground.stands);
        (equilibrium, found)
    }

    /// Forces and velocities of a corner.
    fn solution(&mut self, effect: &Effect, corner: &Corner) -> Found {
        let equilibrium = &self.ground.equilibrium;
        let mut solution = Solution {
            solved: true,
            forces: vec![0.0; equilibrium.columns.len()],
            factor: corner.z.last().copied().unwrap_or(0.0),
            velocities: vec![0.0; equilibrium.rows],
            iterations: corner.pivots as u32,
        };
        if let (Some(reduced), Some(elastic)) = (&self.learnt.reduced, &mut self.elastic) {
            solution.forces = reduced.forces(effect, &corner.z, 1.0 / sum_of_sizes(&effect.load));
            let mut deformations = vec![0.0; equilibrium.columns.len()];
            for &(k, y) in &corner.basis {
                for (c, v) in reduced.limits[k].entries() {
                    deformations[c] += y * v;
                }
            }
            solution.velocities = elastic.motion(&deformations);
        }
        Found { status: Status::Solved, iterations: solution.iterations, solution }
    }
}
