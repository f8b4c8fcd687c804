//! Loads under somebody's hand: the bridge is prepared once, and answers wherever its loads or a vehicle are put.
//!
//! Limit analysis of rigid rings, as in a sweep and by itself: the least of the loads with and without dilation. What one
//! place has taught is kept for the next, which makes neighbours quick; answers do not depend on it beyond round-off.

use super::vehicles::Driven;
use super::{AnalysisError, by_limit, places, policy};
use bridge::Bridge;
use mechanics::blocks::PointForce;
use mechanics::limit::{self, Experience, Friction, Ground, Level, Outcome, Starts};
use outcome::collapse::{FlowRule, Status};
use outcome::help::Help;
use outcome::picture::{LoadArrow, Picture, Point};
use structure::discretise::dispersal::{self, Strip};
use structure::discretise::{Discretised, continuum};

/// A bridge that waits for its loads.
pub struct Placing {
    bridge: Bridge,
    /// Under each combination of a rule's factors on weights, and in every state without help that may come and go: the worst counts.
    stands: Vec<Stand>,
    /// What the file describes of such help.
    helps: Vec<Help>,
    driven: Option<Driven>,
    /// Reference point of the file's first load [m].
    first: f64,
    friction: Friction,
    capacity: f64,
}

/// The blocks under their weight.
struct Stand {
    d: Discretised,
    ground: Ground<'static>,
    learnt: Experience,
    /// The end of the last iteration without dilation, against which others are held.
    near: Option<Level>,
}

/// What is carried at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carried {
    /// How it ended.
    pub status: Status,
    /// What all loads may be multiplied by: where joints slide, the lesser of the factors with and without dilation.
    pub factor: Option<f64>,
    /// The factor with dilatant friction.
    pub dilatant: Option<f64>,
    /// Whether joints slide in the mechanism with dilation.
    pub slides: bool,
}

/// What is carried at a place, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Of the first axle, or of the reference point of the first load [m].
    pub position: f64,
    /// How it ended.
    pub status: Status,
    /// What all loads may be multiplied by.
    pub factor: Option<f64>,
    /// The factor with dilatant friction.
    pub dilatant: Option<f64>,
    /// Factors that forces balance and that a mechanism allows.
    pub bounds: [Option<f64>; 2],
    /// The flow rule that factor, forces and mechanism belong to.
    pub flow: FlowRule,
    /// Whether joints slide, or lock, with dilation, and it was not asked what is carried without: the factor may be too high.
    pub is_open: bool,
    /// Load of a factor of one [N/m].
    pub reference: f64,
    /// Lines of thrust, mechanism, hinges, joints that slide, forces on the blocks at a factor of one; no blocks.
    pub picture: Picture,
    /// What stands on the road: middle [m], length [m] and force [N/m] of each strip.
    pub strips: Vec<(Point, f64, f64)>,
}

impl Placing {
    /// The bridge with its own loads, which move together.
    ///
    /// # Errors
    /// A bridge without loads, loads that cannot be moved, blocks that cannot be analysed.
    pub fn loads(bridge: &Bridge) -> Result<Placing, AnalysisError> {
        let first = bridge.loads.first().ok_or(AnalysisError::NoLoad)?.position;
        if bridge.loads.iter().any(|load| load.block.is_some()) {
            return Err(AnalysisError::MovedBlock);
        }
        let (states, helps) = states(bridge);
        let stands = states.iter().map(Stand::new).collect::<Result<Vec<_>, _>>()?;
        let friction = by_limit::single(bridge, &stands[0].d).friction;
        Ok(Placing { bridge: bridge.clone(), stands, helps, driven: None, first, friction, capacity: 1.0 })
    }

    /// The bridge with a vehicle, all of whose axles and uniform loads stand, under the factors of a rule.
    ///
    /// # Errors
    /// A vehicle or a rule that is not known, blocks that cannot be analysed.
    pub fn vehicle(bridge: &Bridge, driven: Driven) -> Result<Placing, AnalysisError> {
        let (states, helps) = states(bridge);
        let bridges: Vec<Bridge> = states.iter().flat_map(|state| driven.bridges(state)).collect();
        let stands = bridges.iter().map(Stand::new).collect::<Result<Vec<_>, _>>()?;
        let capacity = driven.rule.capacity_factor();
        let friction = by_limit::single(&bridges[0], &stands[0].d).friction;
        Ok(Placing { bridge: bridges[0].clone(), stands, helps, driven: Some(driven), first: 0.0, friction, capacity })
    }

    /// Places at which a load acts on the arches [m]: of the first axle, or of the reference point of the first load.
    pub fn range(&self) -> [f64; 2] {
        let d = &self.stands[0].d;
        if let Some(driven) = &self.driven {
            return driven.range(d);
        }
        let all = self.bridge.loads.iter().flat_map(|load| dispersal::strips(load, 0.0));
        let ahead: Vec<f64> = all.map(|strip| strip.middle - self.first).collect();
        let most = ahead.iter().copied().fold(0.0, f64::max);
        let least = ahead.iter().copied().fold(0.0, f64::min);
        [-most, structure::discretise::bridge_length(&self.bridge) - least]
    }

    /// What is dragged.
    pub fn driven(&self) -> Option<&Driven> {
        self.driven.as_ref()
    }

    /// Whether the blocks carry their own weight.
    pub fn stands(&self) -> bool {
        self.stands.iter().all(|stand| stand.ground.stands())
    }

    /// Whether places are answered by the quick method; where not, each takes as long as an analysis by itself.
    pub fn is_quick(&self) -> bool {
        self.stands.iter().all(|stand| stand.ground.is_fast())
    }

    /// What is assumed, in words.
    pub fn assumptions(&self) -> Vec<String> {
        let mut said = vec![super::sweep::RIGID.to_owned()];
        if self.driven.is_some() {
            said.push(WHOLE.to_owned());
        }
        if continuum::wanted(&self.bridge).is_some() {
            said.push("Layers that are a continuum in the file are weight alone here.".to_owned());
        }
        if !self.helps.is_empty() {
            said.push(format!("What may come and go is not counted where it helps: {}.", Help::all_told(&self.helps)));
        }
        if self.stands[0].d.fill.is_some() {
            said.push("Layers that are particles in the file take no part here.".to_owned());
        }
        said
    }

    /// What stands where, and the bridge that says how it spreads.
    fn standing(&self, position: f64) -> (Bridge, Vec<Strip>) {
        let (bridge, offset) = match &self.driven {
            Some(driven) => (driven.placed(&self.bridge, position), 0.0),
            None => (self.bridge.clone(), position - self.first),
        };
        let strips = bridge.loads.iter().flat_map(|load| dispersal::strips(load, offset)).collect();
        (bridge, strips)
    }

    /// What is carried with the loads at a place [m].
    pub fn carried(&mut self, position: f64) -> Carried {
        let (bridge, strips) = self.standing(position);
        let (friction, capacity) = (self.friction, self.capacity);
        let all = self.stands.iter_mut().map(|stand| stand.carried(&stand.forces(&bridge, &strips), friction));
        let worst = all.reduce(|a, b| if b.is_worse_than(&a) { b } else { a });
        let times = |factor: Option<f64>| factor.map(|factor| factor * capacity);
        let found = worst.unwrap_or(Carried { status: Status::Locks, factor: None, dilatant: None, slides: false });
        Carried { factor: times(found.factor), dilatant: times(found.dilatant), ..found }
    }

    /// The same with forces, lines of thrust and mechanism.
    pub fn put(&mut self, position: f64) -> Placed {
        self.placed(position, self.friction)
    }

    /// The same with dilatant friction alone, where loads move too fast for the iteration without; the answer says where that is open.
    pub fn put_quickly(&mut self, position: f64) -> Placed {
        let mut placed = self.placed(position, Friction::Associated);
        let slides =
            !placed.picture.sliding.is_empty() || (placed.status == Status::Locks && !placed.picture.loads.is_empty());
        placed.is_open = match self.friction {
            Friction::Associated => false,
            Friction::NonAssociated => true,
            Friction::Automatic => slides,
        };
        placed
    }

    fn placed(&mut self, position: f64, friction: Friction) -> Placed {
        let (bridge, strips) = self.standing(position);
        // Of several combinations of weights and states the one that carries least is shown.
        let mut worst: Option<(usize, Carried)> = None;
        if self.stands.len() > 1 {
            for (k, stand) in self.stands.iter_mut().enumerate() {
                let found = stand.carried(&stand.forces(&bridge, &strips), friction);
                if worst.as_ref().is_none_or(|(_, known)| found.is_worse_than(known)) {
                    worst = Some((k, found));
                }
            }
        }
        let stand = &mut self.stands[worst.map_or(0, |(k, _)| k)];
        let forces = stand.forces(&bridge, &strips);
        let outcome = stand.outcome(&forces, friction);
        let times = |factor: Option<f64>| factor.map(|factor| factor * self.capacity);
        let mut picture = Picture::default();
        if let Some(mechanism) = &outcome.mechanism {
            by_limit::draw_mechanism(&stand.d, &outcome.interfaces, mechanism, &mut picture);
        }
        picture.thrust_lines = by_limit::thrust_lines(&stand.d, &outcome.interfaces, &outcome.resultants);
        picture.loads = forces
            .iter()
            .map(|force| LoadArrow { at: places::point(force.at), force: places::point(force.force) })
            .collect();
        let (status, factor) = match forces.is_empty() {
            true => (Status::Locks, None),
            false => (by_limit::status(outcome.status), lesser(&outcome)),
        };
        Placed {
            position,
            status,
            factor: times(factor),
            dilatant: times(outcome.associated_factor),
            bounds: [times(outcome.lower_bound), times(outcome.upper_bound)],
            flow: by_limit::flow_rule(outcome.friction),
            is_open: false,
            reference: strips.iter().map(|strip| strip.force).sum(),
            picture,
            strips: strips
                .iter()
                .map(|strip| ([strip.middle, stand.d.surface.at(strip.middle)], strip.length, strip.force))
                .collect(),
        }
    }

    /// Of each joint of the rings in turn the lowest and the highest place of its resultant under so many times the loads at a place;
    /// none where the loads are not carried. Every joint is two programs: this takes longer than an answer.
    ///
    /// # Errors
    /// Blocks that cannot be analysed.
    pub fn zone(&self, position: f64, factor: f64) -> Result<Vec<Vec<[Point; 2]>>, AnalysisError> {
        let (bridge, strips) = self.standing(position);
        let stand = &self.stands[0];
        let d = &stand.d;
        let loading = mechanics::blocks::Loading { variable: stand.forces(&bridge, &strips), ..d.loading.clone() };
        let settings = limit::Settings { friction: Friction::Associated, ..by_limit::settings(&self.bridge) };
        let zone = limit::thrust_zone(&d.model, &loading, factor / self.capacity, &settings)?;
        let reach = zone.interfaces.iter().zip(&zone.reach).filter_map(|(joint, reach)| {
            let ends = reach.as_ref()?.map(places::point);
            Some((joint.first, joint.second, ends))
        });
        Ok(places::lines(d, reach))
    }
}

impl Carried {
    /// Whether it says less of what is carried, or nothing.
    fn is_worse_than(&self, other: &Carried) -> bool {
        match (self.factor, other.factor) {
            (Some(own), Some(others)) => own < others,
            // Loads that lock are carried; any other end without a factor is worse than a factor.
            (None, Some(_)) => self.status != Status::Locks,
            (Some(_), None) => other.status == Status::Locks,
            (None, None) => other.status == Status::Locks && self.status != Status::Locks,
        }
    }
}

/// The states of the bridge of which the least counts, and what its file describes of help that may come and go. Strength that may be lost only
/// adds, so that no state counts it.
fn states(bridge: &Bridge) -> (Vec<Bridge>, Vec<Help>) {
    let states = policy::states_of_moving(bridge);
    let helps = states.last().map_or_else(Vec::new, |described| described.helps.clone());
    let weak = states.into_iter().filter(|state| !state.counts_strength());
    (weak.map(|state| state.bridge).collect(), helps)
}

/// What is said of a vehicle that stands with all of its axles.
const WHOLE: &str = "The vehicle stands with all of its axles and uniform loads, in its first arrangement. A sweep also leaves out those that \
                     help, and may find much less: it gives the verdict.";

/// The factor of the state that is shown, or the one with dilation where that is less.
fn lesser(outcome: &Outcome) -> Option<f64> {
    let factor = outcome.factor?;
    Some(outcome.associated_factor.map_or(factor, |dilatant| factor.min(dilatant)))
}

impl Stand {
    fn new(bridge: &Bridge) -> Result<Stand, AnalysisError> {
        let mut d = by_limit::prepared(bridge)?;
        d.loading.variable.clear();
        let settings = limit::Settings { friction: Friction::Associated, ..by_limit::settings(bridge) };
        let ground = Ground::owning(d.model.clone(), &d.loading, &settings)?;
        Ok(Stand { d, ground, learnt: Experience::default(), near: None })
    }

    /// The forces that strips bring onto the blocks.
    fn forces(&self, bridge: &Bridge, strips: &[Strip]) -> Vec<PointForce> {
        strips.iter().flat_map(|strip| self.d.spread(bridge, *strip).forces).collect()
    }

    fn carried(&mut self, forces: &[PointForce], friction: Friction) -> Carried {
        if !self.ground.stands() {
            let status = Status::UnstableUnderSelfWeight;
            return Carried { status, factor: None, dilatant: None, slides: false };
        }
        if forces.is_empty() {
            return Carried { status: Status::Locks, factor: None, dilatant: None, slides: false };
        }
        let mut sweeper = self.ground.sweeper_with(std::mem::take(&mut self.learnt));
        let effect = sweeper.effect(forces);
        let found = sweeper.least(&effect, friction, Starts::Every, self.near.as_ref());
        self.learnt = sweeper.learnt();
        let dilatant = found.dilatant.lower;
        let factor = found.factor.map(|own| dilatant.map_or(own, |dilatant| own.min(dilatant)));
        self.near = found.level.or(self.near.take());
        Carried { status: by_limit::status(found.status), factor, dilatant, slides: found.dilatant.slides }
    }

    fn outcome(&mut self, forces: &[PointForce], friction: Friction) -> Outcome {
        let mut sweeper = self.ground.sweeper_with(std::mem::take(&mut self.learnt));
        let effect = sweeper.effect(forces);
        let (outcome, level) = sweeper.outcome_by(&effect, friction, self.near.as_ref());
        self.learnt = sweeper.learnt();
        self.near = level.or(self.near.take());
        outcome
    }
}
