//! Many loads on the same blocks, such as a vehicle at each of its positions: the state under self-weight is sought once, and every
//! load is followed from there to its largest factor.

use super::correct::{Balanced, Constraint, balance};
use super::first_met::fastest;
use super::frame::point;
use super::model::Model;
use super::near::Near;
use super::outcome::{Outcome, Status};
use super::settings::{Program, Settings};
use super::system::{State, Workspace, assemble, load_of};
use super::trace::Path;
use crate::banded::Banded;
use crate::blocks::{BlockModel, Loading, ModelError, PointForce};
use crate::contact::ContactLength;
use crate::ids::BlockId;
use crate::plane::Vec2;
use crate::watch::Watch;

/// The same for the trial states of a step: most need 4 or 5, and the ones beyond a corner of the path that are not found took up to
/// 86 of them, half of the work.
const TRIALS: u32 = 20;

/// Where a load has a largest factor, the state at this share of it serves as one that similar loads start from: at the peak itself it is
/// about to fall.
const BELOW_PEAK: f64 = 0.97;

/// Blocks under their own weight and the permanent forces.
#[derive(Debug, Clone)]
pub struct Ground {
    model: Model,
    /// As given, and as they do for one load of many.
    patient: Settings,
    settings: Settings,
    stood: Result<(State, Balanced), Status>,
    /// The tangent there, factorised; none where it is singular.
    at_rest: Option<Banded>,
}

/// Out-of-balance force of the states of one load of many, relative to all acting forces: 1e-9 in place of it changes factors by 4e-6 and
/// takes a third more iterations (1676 cases of a vehicle of 13 axles on three spans).
const TOLERANCE: f64 = 1e-6;

impl Ground {
    /// Finds the state under self-weight. Variable forces count for nothing here.
    ///
    /// # Errors
    /// A model that cannot be analysed.
    pub fn new(
        blocks: &BlockModel,
        loading: &Loading,
        settings: &Settings,
        watch: &mut dyn Watch,
    ) -> Result<Ground, ModelError> {
        let bare = Loading { variable: Vec::new(), ..loading.clone() };
        let model = Model::new(blocks, &bare, settings)?;
        let program = Program { increment: 1.0, limit: 0.0, watched: (BlockId(0), Vec2::ZERO) };
        let mut path = Path::new(&model, settings, &program);
        let stood = path.stand(watch);
        assemble(&model, settings, &path.state, &mut path.work);
        let at_rest = path.work.tangent.factorise().then(|| path.work.tangent.clone());
        let stood = stood.map(|balanced| (path.state, balanced));
        Ok(Ground {
            settings: Settings { tolerance: TOLERANCE, most_trials: TRIALS, ..settings.clone() },
            model,
            patient: settings.clone(),
            stood,
            at_rest,
        })
    }

    /// Whether the state under self-weight was found.
    pub fn stands(&self) -> bool {
        self.stood.is_ok()
    }

    /// Whether the blocks, let go under their own weight, were seen to fall.
    pub fn falls(&self) -> bool {
        self.stood.as_ref().err() == Some(&Status::UnstableUnderSelfWeight)
    }

    /// What follows loads, one after the other.
    pub fn sweeper(&self) -> Sweeper<'_> {
        Sweeper { ground: self, model: self.model.clone(), near: Near::default(), work: Workspace::new(&self.model) }
    }
}

/// Follows one load after the other.
#[derive(Debug, Clone)]
pub struct Sweeper<'g> {
    ground: &'g Ground,
    model: Model,
    near: Near,
    work: Workspace,
}

impl Sweeper<'_> {
    /// Whether a load is balanced in a state beside that of a similar load which was met before: most often the same vehicle a little
    /// further on. `false` says that none was found there, and no more: the load is to be followed then.
    ///
    /// Nothing slides and no bond breaks between the state under self-weight and the one found, so that it does not matter how the
    /// load came to be. That the path from self-weight leads there is not shown: whoever judges by a load follows it.
    pub fn carries(&mut self, forces: &[PointForce], factor: f64) -> bool {
        self.model.load(forces);
        self.beside(factor).is_some()
    }

    /// Whether each of the states that the settings name may be met below its factor in `below`, judged by such a state at that factor: what has not
    /// been met there is taken not to be met below. Where no such state is found it may.
    pub fn may_meet(&mut self, forces: &[PointForce], program: &Program, below: &[f64]) -> Vec<bool> {
        let Ground { stood: Ok((stood, _)), settings, at_rest: Some(at_rest), .. } = self.ground else {
            return vec![true; below.len()];
        };
        self.model.load(forces);
        let mut grown = load_of(&self.model, stood, &mut self.work);
        at_rest.solve(&mut grown);
        let first = fastest(&self.model, &grown);
        // From the largest factor down: what has not been met there has not been met below.
        let mut may: Vec<bool> = below.iter().map(|&below| below > 0.0).collect();
        let mut order: Vec<usize> = (0..below.len()).filter(|&k| below[k].is_finite()).collect();
        order.sort_by(|&a, &b| below[b].total_cmp(&below[a]));
        for k in order {
            if !may[k] {
                continue;
            }
            let Some(state) = self.beside(below[k]) else { continue };
            let mut found = point(&self.model, (settings, program), &state, (0, 0.0));
            let mut grown = self.work.growing.clone();
            self.work.tangent.solve(&mut grown);
            found.rate = Some(fastest(&self.model, &grown));
            for (other, onset) in settings.onsets.iter().enumerate() {
                if below[other] <= below[k] && onset.excess(&found, Some(first)) <= 0.0 {
                    may[other] = false;
                }
            }
        }
        may
    }

    /// A balanced state of the present load beside that of a similar one, with its tangent factorised in the workspace.
    fn beside(&mut self, factor: f64) -> Option<State> {
        let Ground { stood: Ok((stood, _)), settings, .. } = self.ground else { return None };
        if settings.contact_length != ContactLength::Distributed {
            return None;
        }
        let near = self.near.most_similar(&self.model.variable, factor)?;
        let mut state = State { motions: near.motions.clone(), factor, ..stood.clone() };
        balance(&self.model, settings, Constraint::Load, &mut state, &mut self.work)?;
        let work = &mut self.work;
        if work.slides || work.cracks || !work.is_stable() || !work.tangent.factorise() {
            return None;
        }
        self.near.keep(&self.model.variable, state.clone());
        Some(state)
    }

    /// Follows a load from self-weight up to its first largest factor: what blocks might carry beyond it, once they have moved to
    /// another state, is not sought, unless that happens within the first increment. Where the joints press at points they leave such states at every hinge that moves to the next
    /// joint, and the path goes on from there.
    ///
    /// Of each state that the settings name it is told where the path first meets it, if that is below a factor that is given for it; where
    /// none is, anywhere. Frames and mechanism are left out.
    pub fn carried(
        &mut self,
        forces: &[PointForce],
        (program, below): (&Program, &[f64]),
        watch: &mut dyn Watch,
    ) -> Outcome {
        let (state, balanced) = match &self.ground.stood {
            Ok(stood) => stood.clone(),
            Err(status) => {
                return Outcome { status: *status, ..Outcome::default() };
            }
        };
        self.model.load(forces);
        let Ground { patient, settings, .. } = self.ground;
        let mut path = Path::new(&self.model, settings, program);
        path.state = state;
        path.keeps = true;
        path.keep(balanced);
        let mut status = path.follow_up(watch);
        // Blocks that hold each other by friction may slip at the first touch of a load, and come to rest.
        let slips = path.points.iter().all(|point| point.factor < program.increment);
        let goes_on = slips || settings.contact_length != ContactLength::Distributed;
        if status == Status::NotConverged || status == Status::LimitPoint && goes_on {
            path.settings = patient;
            status = path.follow(watch);
        }
        let factor = |&k: &usize| path.points[k].factor;
        let peak = (0..path.points.len()).max_by(|a, b| factor(a).total_cmp(&factor(b))).unwrap_or(0);
        let best = path.points.get(peak);
        let most =
            best.map_or(0.0, |best| best.factor * if status == Status::StableToLastLoad { 1.0 } else { BELOW_PEAK });
        if let Some(state) = path.states[..=peak].iter().rev().find(|state| state.factor <= most) {
            self.near.keep(&self.model.variable, state.clone());
        }
        let (factor, gives_way) = (best.map(|p| p.factor), best.map(|p| path.cause(p)));
        let onsets = path.onsets(below);
        Outcome {
            status,
            cause: gives_way.filter(|_| matches!(status, Status::LimitPoint | Status::Bifurcation)),
            last_stable_factor: factor,
            onsets,
            iterations: path.iterations,
            snaps: path.snaps,
            path: path.points,
            ..Outcome::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::{Block, ContactLaw, Held, LawTable, Stiffness};
    use crate::ids::{GroupId, Table};
    use crate::plane::{Polygon, vec2};
    use crate::watch::Unwatched;

    /// A block of 0.5 m by 20 m that weighs next to nothing on a soft joint without tension, and a load beside its middle.
    fn leaning() -> (BlockModel, PointForce) {
        let law = ContactLaw {
            normal: Stiffness::Given(1e9),
            shear: Stiffness::Given(1e9),
            friction: 10.0,
            cohesion: 0.0,
            tension: 0.0,
            crushing: f64::INFINITY,
            fixed_length: None,
            least_length: 1e-3,
        };
        let mut groups: Table<GroupId, String> = Table::default();
        let group = groups.push("column".to_string());
        let mut blocks = Table::default();
        for (held, bottom) in [(Held::FIXED, -20.0), (Held::FREE, 0.0)] {
            let outline = Polygon::rectangle(vec2(-0.25, bottom), 0.5, 20.0).unwrap();
            blocks.push(Block { outline, rounding: 0.0, density: 1.0, group, held });
        }
        let laws = LawTable::uniform(1, law);
        let model = BlockModel { blocks, particles: Table::default(), groups, laws, gravity: vec2(0.0, -9.81) };
        (model, PointForce { block: BlockId(1), at: vec2(0.15, 20.0), force: vec2(0.0, -1.0) })
    }

    /// Past the largest load there are balanced states that fall: a load is not carried in one of them, and is where the block still stands.
    #[test]
    fn a_state_that_falls_carries_nothing() {
        let (model, force) = leaning();
        let settings = Settings::new(ContactLength::Distributed);
        let ground = Ground::new(&model, &Loading::default(), &settings, &mut Unwatched).unwrap();
        let program = Program { increment: 1e3, limit: 1e12, watched: (force.block, force.at) };
        let mut sweeper = ground.sweeper();
        sweeper.model.load(&[force]);
        let held = sweeper.model.clone();
        let mut path = Path::new(&held, &settings, &program);
        path.keeps = true;
        let balanced = path.stand(&mut Unwatched).unwrap_or_else(|_| panic!("it stands"));
        path.keep(balanced);
        assert_eq!(path.follow(&mut Unwatched), Status::LimitPoint);
        let states = path.states.clone();
        let peak = (0..states.len()).max_by(|&a, &b| states[a].factor.total_cmp(&states[b].factor)).unwrap();
        let past = states[peak + 1..].iter().find(|state| state.factor < 0.999 * states[peak].factor).unwrap();
        let before = states[..peak].iter().rev().find(|state| state.factor < 0.999 * states[peak].factor).unwrap();
        for (state, carried) in [(past, false), (before, true)] {
            let mut own = sweeper.clone();
            own.near.keep(&held.variable, state.clone());
            assert_eq!(own.carries(&[force], state.factor), carried);
        }
    }
}
