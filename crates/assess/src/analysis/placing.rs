//! Interactive load placement: the bridge is prepared once, then solved for any position of its loads or of a vehicle.
//!
//! Limit analysis of rigid rings, as in a sweep and by itself: the least of the loads with and without dilation. The mechanisms that one
//! place has taught are kept for the next, which makes neighbours quick; answers do not depend on it beyond round-off. Of a vehicle every case counts that a sweep tries at that place: the answer there is
//! the sweep's. `state` answers one state of the bridge.

mod state;

use super::engine::rigid;
use super::sweep::crossing;
pub use super::vehicles::Carried;
use super::vehicles::{Asked, Driven};
use super::{AnalysisError, geometry, notes, policy};
use bridge::Bridge;
use mechanics::limit::{self, Friction, Outcome};
use outcome::collapse::{FlowRule, Status};
use outcome::help::Help;
use outcome::note::{self, Note};
use outcome::picture::{LoadArrow, Picture, Point};
use outcome::vehicles::Case;
use state::{Put, State};
use structure::discretise::continuum;

/// A bridge that waits for its loads.
pub struct Placing {
    /// In every state without help that may come and go: the worst counts.
    states: Vec<State>,
    /// What the file describes of such help.
    helps: Vec<Help>,
    /// Reference point of the file's first load [m].
    first: f64,
    friction: Friction,
    capacity: f64,
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
    /// Of a vehicle: which axles and uniform loads stand, which axle is the critical one, under which weights.
    pub case: Option<Case>,
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
        Placing::on(bridge, first, 1.0, |state| State::on(std::slice::from_ref(state)))
    }

    /// The bridge with a vehicle under the factors of a rule.
    ///
    /// # Errors
    /// A vehicle or a rule that is not known, blocks that cannot be analysed.
    pub fn vehicle(bridge: &Bridge, driven: &Driven) -> Result<Placing, AnalysisError> {
        Placing::on(bridge, 0.0, driven.rule.capacity_factor(), |state| State::of_vehicle(state, driven))
    }

    fn on(
        bridge: &Bridge,
        first: f64,
        capacity: f64,
        put_on: impl Fn(&Bridge) -> Result<State, AnalysisError>,
    ) -> Result<Placing, AnalysisError> {
        let (bridges, helps) = without_help(bridge);
        let states = bridges.iter().map(put_on).collect::<Result<Vec<_>, _>>()?;
        let friction = rigid::single(&states[0].bridge, &states[0].built[0]).friction;
        Ok(Placing { states, helps, first, friction, capacity })
    }

    /// Places at which a load acts on the arches [m]: of the first axle, or of the reference point of the first load.
    pub fn range(&self) -> [f64; 2] {
        let state = &self.states[0];
        if let Some((_, standing)) = &state.vehicle {
            return standing.range;
        }
        crossing(&state.bridge, self.first)
    }

    /// What is dragged.
    pub fn driven(&self) -> Option<&Driven> {
        self.states[0].vehicle.as_ref().map(|(driven, _)| driven)
    }

    /// The factors that act, in words; the loads of a file have none.
    pub fn factors(&self) -> String {
        self.driven().map_or(NOMINAL.to_owned(), |driven| driven.factors(&self.states[0].bridge))
    }

    /// Whether the blocks carry their own weight.
    pub fn stands(&self) -> bool {
        self.states.iter().all(State::stands)
    }

    /// Whether places are answered by the quick method; where not, each takes as long as an analysis by itself.
    pub fn is_quick(&self) -> bool {
        self.states.iter().all(State::is_quick)
    }

    /// What is assumed.
    pub fn assumptions(&self) -> Vec<Note> {
        let mut said: Vec<Note> = vec![note::Moving::RigidAlone.into()];
        if let Some(driven) = self.driven() {
            said.push(note::Moving::CasesAtPlaces.into());
            said.push(driven.width(&self.states[0].bridge).into());
        }
        if continuum::wanted(&self.states[0].bridge).is_some() {
            said.push(note::Soil::AsWeightOfPlaces.into());
        }
        if !self.helps.is_empty() {
            said.push(note::State::NotCounted { helps: self.helps.clone() }.into());
        }
        said.extend(notes::particles_as_weight(&self.states[0].bridge));
        said
    }

    /// What stands with the loads at a place [m], in the state that carries least, and which state that is.
    fn least(&mut self, position: f64, asked: Asked) -> (usize, Put) {
        let friction = if asked == Asked::Quickly { Friction::Associated } else { self.friction };
        let several = self.states.len() > 1;
        let (offset, mut worst) = (position - self.first, None::<(usize, Put)>);
        for (k, state) in self.states.iter_mut().enumerate() {
            let mut put = match state.vehicle {
                Some(_) => state.governing(position, asked),
                None => state.loads(offset, friction),
            };
            if several && put.carried.is_none() {
                put.carried = Some(state.carried(&put));
            }
            let is_worse = |known: &Put| {
                let both = put.carried.zip(known.carried);
                both.is_some_and(|(own, known)| own.is_worse_than(&known))
            };
            if worst.as_ref().is_none_or(|(_, known)| is_worse(known)) {
                worst = Some((k, put));
            }
        }
        worst.expect("a bridge has a state")
    }

    /// A factor on the loads, with that on what the bridge carries.
    fn times(&self, factor: Option<f64>) -> Option<f64> {
        factor.map(|factor| factor * self.capacity)
    }

    /// What is carried with the loads at a place [m]: the same as by an analysis of that place by itself.
    pub fn carried(&mut self, position: f64) -> Carried {
        let (k, put) = self.least(position, Asked::Carefully);
        let found = put.carried.unwrap_or_else(|| self.states[k].carried(&put));
        Carried { factor: self.times(found.factor), dilatant: self.times(found.dilatant), ..found }
    }

    /// The same with forces, lines of thrust and mechanism.
    pub fn put(&mut self, position: f64) -> Placed {
        self.placed(position, Asked::Carefully)
    }

    /// The same with dilatant friction alone, where loads move too fast for the one without; the answer says where that is open.
    pub fn put_quickly(&mut self, position: f64) -> Placed {
        let mut placed = self.placed(position, Asked::Quickly);
        if self.driven().is_none() {
            let locks = placed.status == Status::Locks && !placed.picture.loads.is_empty();
            placed.is_open = match self.friction {
                Friction::Associated => false,
                Friction::NonAssociated => true,
                Friction::Automatic => !placed.picture.sliding.is_empty() || locks,
            };
        }
        placed
    }

    fn placed(&mut self, position: f64, asked: Asked) -> Placed {
        let (k, put) = self.least(position, asked);
        let outcome = self.states[k].outcome(&put);
        let state = &self.states[k];
        let d = &state.built[put.weights];
        // Of loads of the file the number is that of the state that is drawn; of a vehicle that of the search for its case.
        let found = match put.carried.filter(|_| state.vehicle.is_some()) {
            Some(found) => found,
            None if put.forces.is_empty() => Carried::nothing(Status::Locks),
            None => Carried {
                status: rigid::status(outcome.status),
                factor: lesser(&outcome),
                dilatant: outcome.associated_factor,
                slides: false,
            },
        };
        let mut picture = Picture::default();
        if let Some(mechanism) = &outcome.mechanism {
            rigid::draw_mechanism(d, &outcome.interfaces, mechanism, &mut picture);
        }
        picture.thrust_lines = rigid::thrust_lines(d, &outcome.interfaces, &outcome.resultants);
        let arrow = |at, force| LoadArrow { at: geometry::point(at), force: geometry::point(force) };
        picture.loads = put.forces.iter().map(|force| arrow(force.at, force.force)).collect();
        let strips = put.strips.iter();
        Placed {
            position,
            status: found.status,
            factor: self.times(found.factor),
            dilatant: self.times(found.dilatant),
            bounds: [self.times(outcome.lower_bound), self.times(outcome.upper_bound)],
            flow: rigid::flow_rule(outcome.friction),
            is_open: put.is_open,
            reference: strips.clone().map(|strip| strip.force).sum(),
            picture,
            strips: strips
                .map(|strip| ([strip.middle, d.surface.at(strip.middle)], strip.length, strip.force))
                .collect(),
            case: put.case,
        }
    }

    /// Of each joint of the rings in turn the lowest and the highest place [m] of its resultant under so many times the loads at a place;
    /// none where the loads are not carried. Every joint is two programs: this takes longer than an answer.
    ///
    /// # Errors
    /// Blocks that cannot be analysed.
    pub fn zone(&mut self, position: f64, factor: f64) -> Result<Vec<Vec<[Point; 2]>>, AnalysisError> {
        let (k, put) = self.least(position, Asked::Carefully);
        let d = &self.states[k].built[put.weights];
        let loading = mechanics::blocks::Loading { variable: put.forces, ..d.loading.clone() };
        let settings = limit::Settings { friction: Friction::Associated, ..rigid::settings(&self.states[k].bridge) };
        let zone = limit::thrust_zone(&d.model, &loading, factor / self.capacity, &settings)?;
        let reach = zone.interfaces.iter().zip(&zone.reach).filter_map(|(joint, reach)| {
            let ends = reach.as_ref()?.map(geometry::point);
            Some((joint.first, joint.second, ends))
        });
        Ok(geometry::lines(d, reach))
    }
}

/// The states of the bridge of which the least counts, and what its file describes of help that may come and go. Strength that may be lost only
/// adds, so that no state counts it.
fn without_help(bridge: &Bridge) -> (Vec<Bridge>, Vec<Help>) {
    let states = policy::states_of_moving(bridge);
    let helps = states.last().map_or_else(Vec::new, |described| described.helps.clone());
    let weak = states.into_iter().filter(|state| !state.counts_strength());
    (weak.map(|state| state.bridge).collect(), helps)
}

/// What is said of the factors on loads of the file.
const NOMINAL: &str = "nominal: the loads as the file gives them, without factors of a rule";

/// The factor of the state that is shown, or the one with dilation where that is less.
fn lesser(outcome: &Outcome) -> Option<f64> {
    let factor = outcome.factor?;
    Some(outcome.associated_factor.map_or(factor, |dilatant| factor.min(dilatant)))
}
