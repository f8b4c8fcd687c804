//! One state of the bridge under what is put on it.

use super::super::AnalysisError;
use super::super::engine::rigid;
use super::super::vehicles::{Asked, Driven, Standing};
use super::Carried;
use bridge::Bridge;
use mechanics::blocks::PointForce;
use mechanics::limit::{self, Experience, Friction, Ground, Outcome, Sweeper};
use outcome::collapse::Status;
use outcome::vehicles::Case;
use structure::discretise::Discretised;
use structure::discretise::continuum::loads;
use structure::discretise::dispersal::{self, Strip};

/// The blocks under their weight, what carries them and what was learnt of it, under each combination of a rule's factors on weights; one
/// where loads are those of the file.
pub(super) struct State {
    pub bridge: Bridge,
    pub built: Vec<Discretised>,
    grounds: Vec<Ground>,
    learnt: Vec<Experience>,
    /// The vehicle that is put on it, and what it may do there; none where loads are those of the file.
    pub vehicle: Option<(Driven, Standing)>,
}

/// What stands at a place.
pub(super) struct Put {
    /// What stands on the road, and the forces that it brings onto the blocks.
    pub strips: Vec<Strip>,
    pub forces: Vec<PointForce>,
    /// Under which combination of weights.
    pub weights: usize,
    /// The friction of the state that is shown.
    pub friction: Friction,
    /// What it carries, without the factor on what the bridge carries, where that was asked.
    pub carried: Option<Carried>,
    /// Of a vehicle: the case that governs.
    pub case: Option<Case>,
    /// Of a vehicle: whether it was not asked what is carried without dilation, and that may be less.
    pub is_open: bool,
}

impl State {
    /// The bridge with a vehicle under the factors of a rule.
    pub(super) fn of_vehicle(bridge: &Bridge, driven: &Driven) -> Result<State, AnalysisError> {
        let driven = driven.on(bridge)?;
        let mut state = State::on(&driven.bridges(bridge))?;
        let standing = Standing::of_one(&driven, &state.bridge, &state.built[0]);
        state.vehicle = Some((driven, standing));
        Ok(state)
    }

    /// The bridge with its own loads, or under each combination of factors on weights.
    pub(super) fn on(bridges: &[Bridge]) -> Result<State, AnalysisError> {
        let (mut built, mut grounds) = (Vec::new(), Vec::new());
        for bridge in bridges {
            let mut d = rigid::prepared(bridge)?;
            d.loading.variable.clear();
            let settings = limit::Settings { friction: Friction::Associated, ..rigid::settings(bridge) };
            grounds.push(Ground::new(&d.model, &d.loading, &settings)?);
            built.push(d);
        }
        let learnt = bridges.iter().map(|_| Experience::default()).collect();
        Ok(State { bridge: bridges[0].clone(), built, grounds, learnt, vehicle: None })
    }

    /// Whether the blocks carry their own weight.
    pub(super) fn stands(&self) -> bool {
        self.grounds.iter().all(Ground::stands)
    }

    /// Whether places are answered by the quick method.
    pub(super) fn is_quick(&self) -> bool {
        self.grounds.iter().all(Ground::is_fast)
    }

    /// The loads of the file, moved on by an offset [m].
    pub(super) fn loads(&self, offset: f64, friction: Friction) -> Put {
        let strips: Vec<Strip> = self.bridge.loads.iter().flat_map(|load| dispersal::strips(load, offset)).collect();
        let forces = self.forces(0, &self.bridge, &strips);
        Put { strips, forces, weights: 0, friction, carried: None, case: None, is_open: false }
    }

    /// The least of what a sweep tries of the vehicle with its first axle at a place [m].
    pub(super) fn governing(&mut self, position: f64, asked: Asked) -> Put {
        let mut put = Put {
            strips: Vec::new(),
            forces: Vec::new(),
            weights: 0,
            friction: Friction::Associated,
            carried: Some(Carried::nothing(Status::UnstableUnderSelfWeight)),
            case: None,
            is_open: false,
        };
        if !self.stands() {
            return put;
        }
        let Some((driven, standing)) = &self.vehicle else { return put };
        let begun = self.grounds.iter().zip(&mut self.learnt);
        let mut sweepers: Vec<Sweeper<'_>> =
            begun.map(|(ground, learnt)| ground.sweeper_with(std::mem::take(learnt))).collect();
        let governing = standing.governing((&self.grounds, &mut sweepers), position, asked);
        self.learnt = sweepers.into_iter().map(|sweeper| sweeper.learnt).collect();
        put.carried = Some(governing.carried);
        if let Some(case) = governing.case {
            let loaded = driven.loaded(&self.bridge, &case);
            put.strips = loads(&loaded);
            put.forces = self.forces(governing.weights, &loaded, &put.strips);
            put.weights = governing.weights;
            put.friction = if governing.level { Friction::Automatic } else { Friction::Associated };
            (put.case, put.is_open) = (Some(case), governing.is_open);
        }
        put
    }

    /// The forces that strips bring onto the blocks.
    fn forces(&self, weights: usize, bridge: &Bridge, strips: &[Strip]) -> Vec<PointForce> {
        strips.iter().flat_map(|strip| self.built[weights].spread(bridge, *strip).forces).collect()
    }

    /// What is carried under the loads of the file.
    pub(super) fn carried(&mut self, put: &Put) -> Carried {
        if !self.stands() {
            return Carried::nothing(Status::UnstableUnderSelfWeight);
        }
        if put.forces.is_empty() {
            return Carried::nothing(Status::Locks);
        }
        let mut sweeper = self.grounds[0].sweeper_with(std::mem::take(&mut self.learnt[0]));
        let effect = sweeper.effect(&put.forces);
        let found = sweeper.least(&effect, put.friction);
        self.learnt[0] = sweeper.learnt;
        let dilatant = found.dilatant.lower;
        let factor = found.factor.map(|own| dilatant.map_or(own, |dilatant| own.min(dilatant)));
        Carried { status: rigid::status(found.status), factor, dilatant, slides: found.dilatant.slides }
    }

    /// Forces and mechanism of what stands at a place.
    pub(super) fn outcome(&mut self, put: &Put) -> Outcome {
        let k = put.weights;
        let mut sweeper = self.grounds[k].sweeper_with(std::mem::take(&mut self.learnt[k]));
        let effect = sweeper.effect(&put.forces);
        let outcome = sweeper.outcome(&effect, put.friction);
        self.learnt[k] = sweeper.learnt;
        outcome
    }
}
