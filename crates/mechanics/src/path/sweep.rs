//! Many loads on the same blocks, such as a vehicle at each of its positions: the state under self-weight is sought once, and every
//! load is followed from there to its largest factor.

use super::correct::{Balanced, Constraint, balance};
use super::model::Model;
use super::near::Near;
use super::outcome::{Cause, PathPoint, Status};
use super::settings::{Program, Settings};
use super::system::{State, Workspace};
use super::trace::{End, Path};
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
}

/// Out-of-balance force of the states of one load of many, relative to all acting forces: 1e-9 in place of it changes factors by 4e-6 and
/// takes a third more iterations (1676 cases of a vehicle of 13 axles on three spans).
const TOLERANCE: f64 = 1e-6;

/// What came of one load.
#[derive(Debug, Clone, PartialEq)]
pub struct Carried {
    /// How it ended.
    pub status: Status,
    /// What gives way; none where nothing did.
    pub cause: Option<Cause>,
    /// Largest load factor of a balanced state; none where not even the self-weight is balanced.
    pub factor: Option<f64>,
    /// The balanced states in their order.
    pub path: Vec<PathPoint>,
    /// Iterations in all.
    pub iterations: u32,
}

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
        let stood = path.stand(watch).map(|balanced| (path.state, balanced)).map_err(End::status);
        let patient = settings.clone();
        Ok(Ground {
            settings: Settings { tolerance: TOLERANCE, most_trials: TRIALS, ..settings.clone() },
            model,
            patient,
            stood,
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
        let Ground { stood: Ok((stood, _)), settings, .. } = self.ground else { return false };
        if settings.contact_length != ContactLength::Distributed {
            return false;
        }
        self.model.load(forces);
        let Some(near) = self.near.most_similar(&self.model.variable, factor) else { return false };
        let mut state = State { motions: near.motions.clone(), factor, ..stood.clone() };
        if balance(&self.model, settings, Constraint::Load, &mut state, &mut self.work).is_none() {
            return false;
        }
        let Workspace { slides, cracks, tangent, .. } = &mut self.work;
        if *slides || *cracks || !tangent.factorise() || tangent.sign <= 0 {
            return false;
        }
        self.near.keep(&self.model.variable, state);
        true
    }

    /// Follows a load from self-weight up to its first largest factor: what blocks might carry beyond it, once they have moved to
    /// another state, is not sought. Where the joints press at points they leave such states at every hinge that moves to the next
    /// joint, and the path goes on from there.
    pub fn carried(&mut self, forces: &[PointForce], program: &Program, watch: &mut dyn Watch) -> Carried {
        let (state, balanced) = match &self.ground.stood {
            Ok(stood) => stood.clone(),
            Err(status) => {
                return Carried { status: *status, cause: None, factor: None, path: Vec::new(), iterations: 0 };
            }
        };
        self.model.load(forces);
        let Ground { patient, settings, .. } = self.ground;
        let mut path = Path::new(&self.model, settings, program);
        path.state = state;
        path.keeps = true;
        path.keep(balanced);
        let goes_on = |end: End| end == End::Lost || settings.contact_length != ContactLength::Distributed;
        let mut end = path.follow_up(watch);
        if matches!(end, End::Limit | End::Lost) && goes_on(end) {
            path.settings = patient;
            end = path.follow(watch);
        }
        let best = path.points.iter().max_by(|a, b| a.factor.total_cmp(&b.factor));
        let most = best.map_or(0.0, |best| best.factor * if end == End::Target { 1.0 } else { BELOW_PEAK });
        if let Some(state) = path.states.iter().rev().find(|state| state.factor <= most) {
            self.near.keep(&self.model.variable, state.clone());
        }
        let (factor, gives_way) = (best.map(|p| p.factor), best.map(|p| path.cause(p)));
        let status = end.status();
        Carried {
            status,
            cause: gives_way.filter(|_| matches!(status, Status::LimitPoint | Status::Bifurcation)),
            factor,
            iterations: path.iterations,
            path: path.points,
        }
    }
}
