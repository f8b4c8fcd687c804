//! The fill of a bridge at rest: packed for a seed, the ring let go, before any load.

use super::AnalysisError;
use super::crowd::Halt;
use crate::analysis::engine::dem::filled::{fill, packing, without_loading_blocks};
use crate::analysis::engine::dem::settings;
use bridge::Bridge;
use mechanics::blocks::{ContactLaw, LawTable, Loading, Particle};
use mechanics::dem::{self, Model, PackingError, begin};
use mechanics::ids::{GroupId, Table};
use mechanics::plane::Vec2;
use mechanics::watch::Watch;
use structure::discretise::fill::FillRegion;
use structure::discretise::{Origin, discretise};

/// Fill at rest.
pub(super) struct SettledFill {
    /// The region it was packed into.
    pub region: FillRegion,
    /// The particles where they rest.
    pub particles: Vec<Particle>,
    /// Laws of their contacts, and the names of all groups.
    pub laws: Laws,
}

/// Who touches whom how.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Laws {
    pub table: LawTable,
    /// Names of the groups.
    pub groups: Table<GroupId, String>,
    /// Groups of particles.
    pub layers: Vec<GroupId>,
    /// The group of the walls that hold the fill.
    pub walls: GroupId,
    /// Gravity [m/s^2].
    pub gravity: Vec2,
}

impl Laws {
    /// The same with other contacts between particles.
    pub(super) fn with_contacts(&self, change: impl Fn(ContactLaw) -> ContactLaw) -> Laws {
        let mut laws = self.clone();
        for (k, &a) in self.layers.iter().enumerate() {
            for &b in &self.layers[k..] {
                laws.table.set(a, b, change(*self.table.between(a, b)));
            }
        }
        laws
    }
}

impl SettledFill {
    /// Radius of the largest particle [m].
    pub(super) fn largest(&self) -> f64 {
        self.particles.iter().map(|p| p.radius).fold(0.0, f64::max)
    }
    /// Mean diameter of the particles [m].
    pub(super) fn mean_diameter(&self) -> f64 {
        2.0 * self.particles.iter().map(|p| p.radius).sum::<f64>() / self.particles.len().max(1) as f64
    }
    /// Radius of the smallest particle [m].
    pub(super) fn smallest(&self) -> f64 {
        self.particles.iter().map(|p| p.radius).fold(f64::INFINITY, f64::min)
    }
}

/// Packs the fill for a seed, lets ring and fill come to rest under their weight.
pub(super) fn settled(bridge: &Bridge, seed: u64, watch: &mut dyn Watch) -> Result<SettledFill, Halt> {
    let mut bridge = bridge.clone();
    bridge.plan.seed = seed;
    let mut d = discretise(&bridge)?;
    let region = d.fill.clone().ok_or(AnalysisError::NoParticles)?;
    let particles = bridge.particles.as_ref().ok_or(AnalysisError::NoParticles)?;
    let grains = match packing(&bridge, &d, &region, particles, watch) {
        Ok(grains) => grains,
        Err(PackingError::Stopped) => return Err(Halt::Stopped),
        Err(error) => return Err(error.into()),
    };
    fill(&mut d, &region, &grains);
    let loading = Loading { permanent: d.loading.permanent.clone(), ..Loading::default() };
    let model = Model::new(&without_loading_blocks(&d), &loading)?;
    let settings = settings(&bridge);
    let rested = dem::rest(&model, &|| begin(&model, &settings), &settings, None, watch)?;
    match rested.status {
        dem::Status::StableToLastLoad => {}
        dem::Status::Cancelled => return Err(Halt::Stopped),
        _ => return Err(AnalysisError::FillNotAtRest { seed }.into()),
    }
    let frame = dem::frame(&model, &rested.state);
    let at = |(p, now): (&Particle, &dem::ParticleState)| Particle { centre: now.centre, ..*p };
    let walls = d.origins.pairs().find(|(_, origin)| matches!(origin, Origin::EndWall { .. }));
    let (wall, _) = walls.ok_or(AnalysisError::NoParticles)?;
    Ok(SettledFill {
        particles: d.model.particles.iter().zip(frame.particles.iter()).map(at).collect(),
        laws: Laws {
            table: d.model.laws.clone(),
            groups: d.model.groups.clone(),
            layers: region.layers.iter().map(|layer| layer.group).collect(),
            walls: d.model.blocks[wall].group,
            gravity: d.model.gravity,
        },
        region,
    })
}
