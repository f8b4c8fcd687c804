//! What moving loads come to where joints give: each is followed along its path of equilibrium from self-weight to its peak.
//!
//! Rigid blocks bound that factor from above, so that the smaller of the two counts.

use super::by_dem::contact_length;
use super::{AnalysisError, by_path};
use bridge::{Bridge, JointContact};
use mechanics::blocks::PointForce;
use mechanics::path::{Ground, Program, Settings, Status, Sweeper};
use mechanics::plane::Vec2;
use mechanics::watch::{Pace, Watch};
use outcome::collapse::Criterion;
use structure::discretise::Discretised;

/// First step of a path, as a share of the factor that bounds it.
const FIRST_STEP: f64 = 0.15;

/// A bridge under its own weight, on joints that give.
pub(super) struct Deforming {
    ground: Ground,
    /// Least crushing strength of its joints [Pa].
    strength: f64,
    /// Weight of the free blocks [N/m].
    weight: f64,
}

/// What came of one load.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Followed {
    /// Largest factor of a balanced state.
    pub factor: f64,
    /// Whether the path broke off: it may carry more, but that is not shown.
    pub broken_off: bool,
    /// Whether the load reached the factor beyond which it is not followed.
    pub beyond: bool,
    /// Factors at which states are first met that a bridge should not come to in service.
    pub permissible: Vec<(Criterion, f64)>,
}

impl Deforming {
    /// The state under self-weight. Fill acts by its weight alone.
    pub fn new(bridge: &Bridge, d: &Discretised, watch: &mut dyn Watch) -> Result<Deforming, AnalysisError> {
        let contact = bridge.plan.contact.unwrap_or(JointContact::Distributed);
        let settings = Settings::new(contact_length(&bridge.plan, contact));
        let ground = Ground::new(&d.model, &d.loading, &settings, watch)?;
        Ok(Deforming { ground, strength: by_path::strength(d), weight: d.model.free_weight() })
    }

    /// Whether the state under self-weight was found.
    pub fn stands(&self) -> bool {
        self.ground.stands()
    }

    /// What follows loads, one after the other.
    pub fn sweeper(&self) -> Sweeper<'_> {
        self.ground.sweeper()
    }

    /// Follows a load up to its peak, or to `most` times the forces where that is known to be enough. None where the bridge does not
    /// stand, where nothing is loaded and where the work does not go on.
    pub fn follow(
        &self,
        sweeper: &mut Sweeper<'_>,
        forces: &[PointForce],
        most: Option<f64>,
        pace: &Pace,
    ) -> Option<Followed> {
        let size = |f: &PointForce| f.force.norm();
        let total: f64 = forces.iter().map(size).sum();
        let heaviest = forces.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
        let limit = most.unwrap_or(self.weight / total.max(f64::MIN_POSITIVE));
        let watched: (_, Vec2) = (heaviest.block, heaviest.at);
        let program = Program { increment: FIRST_STEP * limit, limit, watched };
        let found = sweeper.carried(forces, &program, &mut pace.clone());
        if found.status == Status::Cancelled {
            return None;
        }
        Some(Followed {
            factor: found.factor?,
            broken_off: found.status == Status::NotConverged,
            beyond: found.status == Status::StableToLastLoad,
            permissible: by_path::permissible(&found.path, self.strength),
        })
    }
}
