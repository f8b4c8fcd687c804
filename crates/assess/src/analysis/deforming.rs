//! What moving loads come to where joints give: each is followed along its equilibrium path from self-weight to its peak.
//!
//! Rigid blocks bound that factor from above, so that the smaller of the two counts. [`along`] goes over the bridge with them.

pub(super) mod along;

use super::AnalysisError;
use super::engine::joints::contact_length;
use super::engine::path;
use super::service::{self, SOUGHT, Service};
use bridge::{Bridge, JointContact};
use mechanics::blocks::PointForce;
use mechanics::path::{Ground, Program, Settings, Status, Sweeper};
use mechanics::plane::Vec2;
use mechanics::watch::{CancelToken, Watch};
use structure::discretise::Discretised;

/// First step of a path, as a share of the factor that bounds it.
const FIRST_STEP: f64 = 0.15;

/// Paths are followed so far beyond the factor of rigid blocks that a state in balance there would be seen.
const BEYOND: f64 = 1.02;

/// Loads far above the least factor of rigid blocks do not govern: paths are followed to this multiple of it.
const FAR: f64 = 4.0;

/// How far a load is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bound {
    factor: f64,
    /// Whether rigid blocks carry no more.
    rigid: bool,
}

impl Bound {
    /// The bound where rigid blocks carry `here`, and `least` at their worst position; none where neither is known.
    pub(super) fn of(here: Option<f64>, least: Option<f64>) -> Option<Bound> {
        let here = here.map(|here| Bound { factor: BEYOND * here, rigid: true });
        let least = least.map(|least| Bound { factor: FAR * least, rigid: false });
        here.into_iter().chain(least).min_by(|a, b| a.factor.total_cmp(&b.factor))
    }

    /// Only what is smaller counts.
    pub(super) fn below(factor: f64) -> Bound {
        Bound { factor, rigid: false }
    }
}

/// What came of one load.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Followed {
    /// Largest factor of a balanced state.
    pub factor: f64,
    /// Whether the path broke off: it may carry more, but that is not shown.
    pub broken_off: bool,
}

/// The states that a load brings about in service.
pub(super) struct InService<'a> {
    /// What is known of other loads. What this one comes to is added.
    pub known: &'a mut Service,
    /// Where the load stands [m].
    pub position: f64,
    /// Whether it is followed for these states also where it carries the bound.
    pub by_themselves: bool,
}

/// A bridge under its own weight, on deformable joints. Fill acts by its weight alone.
pub(super) fn at_rest(bridge: &Bridge, d: &Discretised, watch: &mut dyn Watch) -> Result<Ground, AnalysisError> {
    let contact = bridge.plan.contact.unwrap_or(JointContact::Distributed);
    let onsets = service::sought(path::strength(d));
    let settings = Settings { onsets, ..Settings::new(contact_length(&bridge.plan, contact)) };
    Ok(Ground::new(&d.model, &d.loading, &settings, watch)?)
}

/// Follows a load up to its peak, to a bound for the load that it carries, and for what it comes to in service where that counts. None where the
/// peak is not below the bound (what rigid blocks carry is told), where the bridge does not stand, where nothing is loaded and where the work does
/// not go on. A load that carries the bound is followed as far as it may bring a state about at less than is known.
pub(super) fn follow(
    sweeper: &mut Sweeper<'_>,
    forces: &[PointForce],
    (bound, service): (Bound, Option<InService<'_>>),
    token: &CancelToken,
) -> Option<Followed> {
    let below = service.as_ref().map_or([0.0; SOUGHT], |service| service.known.factors);
    let size = |f: &PointForce| f.force.norm();
    let heaviest = forces.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let watched: (_, Vec2) = (heaviest.block, heaviest.at);
    let to = |limit: f64| Program { increment: FIRST_STEP * limit, limit, watched };
    let governs = bound.rigid || !sweeper.carries(forces, bound.factor);
    let limit = if governs {
        bound.factor
    } else if service.as_ref().is_some_and(|service| service.by_themselves) {
        let may = sweeper.may_meet(forces, &to(bound.factor), &below);
        let least = below.iter().zip(may).filter(|(_, may)| *may).map(|(factor, _)| *factor);
        least.reduce(f64::max)?.min(bound.factor)
    } else {
        return None;
    };
    let found = sweeper.carried(forces, (&to(limit), &below), &mut token.clone());
    if found.status == Status::Cancelled {
        return None;
    }
    if let Some(InService { known, position, .. }) = service {
        known.take(&found.onsets, position);
    }
    if !governs || found.status == Status::StableToLastLoad && !bound.rigid {
        return None;
    }
    Some(Followed { factor: found.last_stable_factor?, broken_off: found.status == Status::NotConverged })
}
