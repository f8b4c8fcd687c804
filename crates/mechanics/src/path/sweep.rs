//! Many loads on the same blocks, such as a vehicle at each of its positions: the state under self-weight is sought once, and every
//! load is followed from there to its largest factor.

use super::correct::Balanced;
use super::model::Model;
use super::outcome::{Cause, PathPoint, Status};
use super::settings::{Program, Settings};
use super::system::State;
use super::trace::{End, Path};
use crate::blocks::{BlockModel, Loading, ModelError, PointForce};
use crate::contact::ContactLength;
use crate::ids::BlockId;
use crate::plane::Vec2;
use crate::watch::Watch;

/// Blocks under their own weight and the permanent forces.
#[derive(Debug, Clone)]
pub struct Ground {
    model: Model,
    settings: Settings,
    stood: Result<(State, Balanced), Status>,
}

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
        Ok(Ground { model, settings: settings.clone(), stood })
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
        Sweeper { ground: self, model: self.model.clone() }
    }
}

/// Follows one load after the other.
#[derive(Debug, Clone)]
pub struct Sweeper<'g> {
    ground: &'g Ground,
    model: Model,
}

impl Sweeper<'_> {
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
        let settings = &self.ground.settings;
        let mut path = Path::new(&self.model, settings, program);
        path.state = state;
        path.keep(balanced);
        let goes_on = |end: End| end == End::Lost || settings.contact_length != ContactLength::Distributed;
        let mut end = path.follow_up(watch);
        if matches!(end, End::Limit | End::Lost) && goes_on(end) {
            end = path.follow(watch);
        }
        let best = path.points.iter().max_by(|a, b| a.factor.total_cmp(&b.factor));
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
