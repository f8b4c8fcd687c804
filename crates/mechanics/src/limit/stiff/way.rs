//! The way that blocks between stiff elastic joints take as a load grows, from limit to limit of their elements.
//!
//! Between two limits everything is linear, so that the way is followed without iteration: the rate of displacements, how far it leads
//! until the first element passes into another piece of its law, and on. A way is a curve that goes through each limit (Eaves 1976, on piecewise
//! linear homotopies): behind it, the element that has reached it must go on. Where that says little, the sign of the determinant tells: it changes
//! with the direction of the load.

use super::element::{Event, Piece};
use super::rates::{Rate, Tangent, dot, largest};
use super::system::System;
use crate::watch::CancelToken;

/// Displacements for each unit of the load over those of elastic blocks from which on the way leads nowhere but along a mechanism.
const RIGID: f64 = 1e7;
/// Displacements over elastic ones beyond which the way is not followed: joints a ten-thousandth as soft would still have shown a mechanism.
const FAR: f64 = 1e4;
/// The same along a mechanism: limits that are further away may be round-off of its velocities, which are known to 1e-7 in chains of a hundred blocks.
const ALONG: f64 = 1e3;
/// The same from which on a load that no longer grows by [`GROWS`] within [`STEPS`] limits for each element comes and goes. Those from chord to chord of
/// crushing are not counted: four rings of 5 m ended at 42 to 46 kN/m with more or fewer chords, and end at 46.8 to 46.9.
const WANDERS: f64 = 100.0;
const GROWS: f64 = 1e-3;
const STEPS: usize = 4;
/// Below this share of its size the speed of an element says nothing of the direction.
const SLOW: f64 = 1e-9;
/// Corrections of displacements for what round-off has left out of balance, over elastic ones.
const CORRECTED: f64 = 1e-8;
/// Room that an element must have to be passed over, over what is needed: a little more than round-off.
const ROOM: f64 = 1.0 + 1e-6;
/// Limits after which balance is looked at.
const LOOKED_AT: usize = 32;
/// Elements that are asked first for the next limit.
const RECENT: usize = 8;
/// Most limits for each element in all, without those from chord to chord and with them; a load that has come this far comes and goes as well.
const MOST: [usize; 2] = [60, 1000];

/// A state on the way.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub displacements: Vec<f64>,
    /// Elastic forces of each element, and its bond.
    pub elastic: Vec<[f64; 3]>,
    pub pieces: Vec<Piece>,
    pub factor: f64,
}

/// How a way ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// The factor that it was followed to.
    Reached,
    /// Displacements grow at one load.
    Mechanism,
    /// They are so large that they would show a mechanism; the state is that of the largest load.
    Far,
    /// The load has stopped to grow and comes and goes: the state is that of the largest load, and the motion that which leads on from it.
    Wanders,
    /// No direction, no number or too many limits.
    Lost,
}

/// A way to its end.
pub(super) struct Way {
    pub end: End,
    pub state: State,
    /// The largest factor, and the least since then.
    pub most: f64,
    pub least: f64,
    /// Velocities at the end.
    pub velocities: Vec<f64>,
    /// Limits passed, with those from chord to chord of crushing.
    pub steps: usize,
}

/// What is followed.
pub(super) struct Load<'a> {
    /// Loads that stay, in the order of the equations.
    pub constant: &'a [f64],
    /// Loads that the factor multiplies.
    pub growing: &'a [f64],
    /// Compression of each element by which the factor shifts its limits: a bond that makes the joint stronger in tension, and in shear by friction on it.
    /// Empty for none.
    pub bond: &'a [[f64; 3]],
    /// 1 where the factor begins to grow, -1 where it begins to fall.
    pub direction: f64,
    /// A factor at which the way ends.
    pub goal: Option<f64>,
    /// Displacements of elastic blocks: under what stays, and for each unit of the factor.
    pub elastic: [f64; 2],
}

impl Load<'_> {
    /// Displacements for each unit of the factor beyond which blocks move along a mechanism.
    fn rigid(&self) -> f64 {
        RIGID * self.elastic[1]
    }

    /// Adds so many times the bond.
    fn bind(&self, forces: &mut [[f64; 3]], times: f64) {
        for (forces, bond) in forces.iter_mut().zip(self.bond) {
            forces.iter_mut().zip(bond).for_each(|(force, bond)| *force += times * bond);
        }
    }

    /// Displacement of elastic blocks at a factor; without any load that of a factor of one.
    fn displacement(&self, factor: f64) -> f64 {
        match self.elastic[0] + factor.abs() * self.elastic[1] {
            0.0 => self.elastic[1],
            some => some,
        }
    }
}

pub(super) fn follow(system: &System, state: State, load: &Load, token: &CancelToken) -> Way {
    let tangent = Tangent::new(system, &state.pieces, load.growing, load.bond);
    let mut this = Follower {
        system,
        load,
        tangent,
        most: state.factor,
        least: state.factor,
        state,
        oriented: None,
        moved: Vec::new(),
        passed: None,
        by_motion: false,
        turned: None,
        room: vec![0.0; system.elements.len()],
        speeds: vec![0.0; system.elements.len()],
        recent: [0; RECENT],
        steps: 0,
        changes: 0,
    };
    let (mut best, mut grown) = (this.most, 0);
    let mut peak: Option<(State, Vec<f64>)> = None;
    loop {
        let Some((rate, direction)) = this.rate().filter(|_| !token.is_cancelled()) else {
            return this.ends(End::Lost);
        };
        let Rate { displacements: rate, speed, elastic: mut rates, .. } = rate;
        let unit = load.displacement(this.most);
        let reach = largest(&this.state.displacements);
        if load.goal.is_none() && direction < 0.0 && this.state.factor >= this.most {
            peak = Some((this.state.clone(), rate.clone()));
        }
        load.bind(&mut rates, direction);
        let rigid = speed > load.rigid();
        let far = if rigid { ALONG * unit } else { (FAR * unit - reach).max(0.0) } / speed;
        let goal = load.goal.map(|goal| (goal - this.state.factor) * direction).filter(|left| *left >= 0.0);
        let most = goal.map_or(far, |goal| goal.min(far));
        let next = this.next(&rates, most);
        if next.as_ref().is_some_and(|(element, event)| this.returns(*element, event.to)) {
            this.turned = Some(-direction);
            continue;
        }
        let after = next.as_ref().map_or(most, |(_, event)| event.after);
        if !after.is_finite() {
            return this.ends(End::Lost);
        }
        if next.is_none() && rigid && goal != Some(most) {
            return this.ends_with(End::Mechanism, rate);
        }
        this.advance(&rate, &rates, direction, after);
        let Some((element, event)) = next else {
            let reached = goal == Some(most);
            return match peak.filter(|(state, _)| !reached && state.factor > this.state.factor) {
                Some((state, rate)) => Follower { state, ..this }.ends_with(End::Far, rate),
                None => this.ends_with(if reached { End::Reached } else { End::Far }, rate),
            };
        };
        this.pass(element, event);
        if this.most > best + GROWS * best.abs() {
            (best, grown) = (this.most, this.changes);
        }
        let count = system.elements.len();
        let comes_and_goes = reach > WANDERS * unit && this.changes - grown > STEPS * count;
        let too_many = this.changes > MOST[0] * count || this.steps > MOST[1] * count;
        match peak.take_if(|_| comes_and_goes || too_many) {
            Some((state, rate)) => {
                this.state = state;
                return this.ends_with(End::Wanders, rate);
            }
            None if too_many => return this.ends(End::Lost),
            None => {}
        }
    }
}

struct Follower<'a> {
    system: &'a System,
    load: &'a Load<'a>,
    tangent: Tangent<'a>,
    state: State,
    most: f64,
    /// The least factor since the largest.
    least: f64,
    /// Direction of the factor times the sign of the determinant: the same all the way.
    oriented: Option<f64>,
    /// Displacements along the way before the last limit.
    moved: Vec<f64>,
    passed: Option<Passed>,
    /// Whether motion alone told the direction.
    by_motion: bool,
    /// The direction after motion has told the wrong one.
    turned: Option<f64>,
    /// How far the elastic forces of each element may surely go before its piece changes.
    room: Vec<f64>,
    /// How fast they go.
    speeds: Vec<f64>,
    /// Elements that have passed the last limits.
    recent: [usize; RECENT],
    /// Limits passed, and those that are no chord's.
    steps: usize,
    changes: usize,
}

/// The last limit.
struct Passed {
    element: usize,
    from: Piece,
    /// What grows beyond it.
    onward: [f64; 3],
}

impl Follower<'_> {
    /// Displacements along the way and the direction of the factor; none where no number is left.
    fn rate(&mut self) -> Option<(Rate, f64)> {
        let (mut rate, direction) = loop {
            let rate = self.tangent.rate(&self.state.pieces);
            let most = rate.speed;
            if !most.is_finite() {
                return None;
            }
            // Where the tangent is next to singular the sign of its determinant is round-off.
            let by_sign =
                (most <= self.load.rigid()).then(|| self.oriented.map_or(1.0, |oriented| oriented * rate.sign));
            let by_limit = self.by_limit(&rate.displacements, most);
            if by_sign.zip(by_limit).is_some_and(|(a, b)| a != b) && self.tangent.is_changed() {
                self.tangent.anew(&self.state.pieces);
                continue;
            }
            if self.oriented.is_none() {
                self.oriented = Some(self.load.direction * rate.sign);
                break (rate, self.load.direction);
            }
            let by_motion = || {
                let along: f64 = self.moved.iter().zip(&rate.displacements).map(|(a, b)| a * b).sum();
                if along < 0.0 { -1.0 } else { 1.0 }
            };
            let told = by_limit.or(by_sign).or(self.turned.take());
            self.by_motion = told.is_none();
            let direction = told.unwrap_or_else(by_motion);
            break (rate, direction);
        };
        rate.displacements.iter_mut().for_each(|x| *x *= direction);
        rate.elastic.iter_mut().flatten().for_each(|y| *y *= direction);
        self.moved.clone_from(&rate.displacements);
        Some((rate, direction))
    }

    /// The direction in which the element that has passed a limit goes on beyond it; none where it hardly moves.
    fn by_limit(&self, displacements: &[f64], most: f64) -> Option<f64> {
        let Passed { element, onward, .. } = *self.passed.as_ref()?;
        let mut rates = self.system.elements[element].elastic(displacements);
        if let Some(bond) = self.load.bond.get(element) {
            (0..3).for_each(|k| rates[k] += bond[k]);
        }
        let speed = dot(onward, rates);
        let size = dot(onward.map(f64::abs), self.system.elements[element].stiffness) * most;
        (speed.abs() > SLOW * size).then(|| speed.signum())
    }

    /// Whether an element goes back through the limit that it has just passed, where motion alone told the direction: it was the other one.
    fn returns(&self, element: usize, to: Piece) -> bool {
        self.by_motion && self.passed.as_ref().is_some_and(|passed| passed.element == element && passed.from == to)
    }

    /// The first element that passes a limit. Those with room are not looked at: 28 % of the time of five rings went by with them.
    fn next(&mut self, rates: &[[f64; 3]], mut most: f64) -> Option<(usize, Event)> {
        for (speed, rate) in self.speeds.iter_mut().zip(rates) {
            *speed = rate[0].abs() + rate[1].abs() + rate[2].abs();
        }
        // Who was last is often next, and then most of the others have room.
        for k in self.recent.into_iter().filter(|k| *k < rates.len()) {
            let at = (self.state.elastic[k], rates[k]);
            let event = self.system.elements[k].next(&self.system.shapes, self.state.pieces[k], at, most);
            most = event.map_or(most, |event| event.after * ROOM + f64::MIN_POSITIVE);
        }
        let mut first: Option<(usize, Event)> = None;
        for (k, element) in self.system.elements.iter().enumerate() {
            if self.room[k] > ROOM * self.speeds[k] * most {
                continue;
            }
            let elastic = self.state.elastic[k];
            self.room[k] = element.room(&self.system.shapes, self.state.pieces[k], elastic);
            if let Some(event) = element.next(&self.system.shapes, self.state.pieces[k], (elastic, rates[k]), most) {
                most = event.after;
                first = Some((k, event));
            }
        }
        first
    }

    fn advance(&mut self, rate: &[f64], rates: &[[f64; 3]], direction: f64, after: f64) {
        let state = &mut self.state;
        state.displacements.iter_mut().zip(rate).for_each(|(u, v)| *u += after * v);
        for (elastic, rates) in state.elastic.iter_mut().zip(rates) {
            elastic.iter_mut().zip(rates).for_each(|(y, rate)| *y += after * rate);
        }
        self.room.iter_mut().zip(&self.speeds).for_each(|(room, speed)| *room -= after * speed);
        state.factor += after * direction;
        self.least = if state.factor > self.most { state.factor } else { self.least.min(state.factor) };
        self.most = self.most.max(state.factor);
    }

    fn pass(&mut self, element: usize, event: Event) {
        let from = std::mem::replace(&mut self.state.pieces[element], event.to);
        let crushes_on = self.system.elements[element].goes_on_crushing(&self.system.shapes, from, event.to);
        self.changes += usize::from(!crushes_on);
        self.recent[self.steps % RECENT] = element;
        self.tangent.pass(&self.state.pieces, element);
        self.room[element] = 0.0;
        self.passed = Some(Passed { element, from, onward: event.onward });
        self.steps += 1;
        if self.steps.is_multiple_of(LOOKED_AT) {
            self.balance();
        }
    }

    /// Takes out what round-off has left out of balance.
    fn balance(&mut self) {
        let state = &mut self.state;
        let before = std::mem::replace(&mut state.elastic, self.system.elastic(&state.displacements));
        self.load.bind(&mut state.elastic, state.factor);
        let loads: Vec<f64> =
            self.load.constant.iter().zip(self.load.growing).map(|(c, g)| c + state.factor * g).collect();
        let mut left = self.system.unbalanced(&state.pieces, &state.elastic, &loads);
        let without = self.load.bond.iter().map(|bond| bond.map(|b| -state.factor * b));
        self.system.add_forces(without, &mut left);
        let more = self.tangent.balanced(&left);
        let unit = self.load.displacement(self.most);
        if largest(&more) <= CORRECTED * unit {
            state.displacements.iter_mut().zip(more).for_each(|(u, d)| *u += d);
            state.elastic = self.system.elastic(&state.displacements);
            self.load.bind(&mut state.elastic, state.factor);
        }
        for ((room, before), after) in self.room.iter_mut().zip(before).zip(&state.elastic) {
            *room -= (0..3).map(|k| (after[k] - before[k]).abs()).sum::<f64>();
        }
    }

    fn ends(self, end: End) -> Way {
        let none = vec![0.0; self.system.size];
        self.ends_with(end, none)
    }

    fn ends_with(self, end: End, rate: Vec<f64>) -> Way {
        let fastest = largest(&rate).max(f64::MIN_POSITIVE);
        let velocities = rate.iter().map(|v| v / fastest).collect();
        Way { end, state: self.state, most: self.most, least: self.least, velocities, steps: self.steps }
    }
}
