//! What a bridge file means, in SI units: the value that reading returns. Plain data, nothing computed.

mod cover;
mod edge;
mod load;
mod masonry;
mod plan;
mod span;
mod sweep;

pub use crate::calibration::{Calibration, Modulus};
pub use cover::*;
pub use edge::*;
pub use load::*;
pub use masonry::*;
pub use plan::*;
pub use span::*;
pub use sweep::*;

use crate::service::Service;

/// A bridge as its file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Bridge {
    /// Name for titles.
    pub name: String,
    /// Width of the barrel [m].
    pub width: f64,
    /// Acceleration of gravity [m/s^2].
    pub gravity: f64,
    /// Spans from left to right; at least one.
    pub spans: Vec<Span>,
    /// Piers between the spans: one fewer than spans.
    pub piers: Vec<Pier>,
    /// Left and right abutment.
    pub abutments: [Abutment; 2],
    /// Named materials of solid bodies.
    pub masonry: Masonry,
    /// Joints between voussoirs of one ring, and between voussoirs and their springings.
    pub joint: Joint,
    /// Joints between rings of one span; `joint` where the file gives none.
    pub ring_joint: Joint,
    /// Walls of coursed masonry that stand on the rings, where the file describes them.
    pub spandrel_wall: Option<SpandrelWall>,
    /// Parapets, where the file describes them.
    pub parapet: Option<Parapet>,
    /// Kerbs, where the file describes them.
    pub kerb: Option<Kerb>,
    /// How layers of the cover are filled with particles, where some are.
    pub particles: Option<Particles>,
    /// How the contact stiffness of particles is found from a wanted modulus.
    pub calibration: Calibration,
    /// What lies above the rings, from the extrados up.
    pub cover: Cover,
    /// What is placed on the road or rail, in the order of the file.
    pub loads: Vec<Load>,
    /// How loads spread through the cover.
    pub dispersal: Dispersal,
    /// What to analyse, and how exactly.
    pub plan: Plan,
    /// What only the finite element model reads.
    pub service: Service,
    /// How layers that are a continuum are modelled, where some are.
    pub continuum: Option<ContinuumPlan>,
    /// Horizontal pressure of the fill against movement, in limit analysis, where the file says so.
    pub fill_pressure: Option<FillPressure>,
    /// Where vehicles may stand across the bridge, where the file says so.
    pub carriageway: Option<Carriageway>,
    /// Vehicles that are moved over the bridge, and by which rule, where the file says so.
    pub sweep: Option<SweepPlan>,
    /// The train that crosses, and what is measured meanwhile, where the file says so.
    pub passage: Option<crate::passage::Passage>,
    /// Loads at rest, and what is measured then, where the file says so.
    pub load_test: Option<crate::load_test::LoadTest>,
    /// What the file takes from the library by the name of a material, each as "masonry.density 2250 kg/m^3 (sandstone)".
    pub from_library: Vec<String>,
}

impl Bridge {
    /// What trains or vehicles of this file roll on or stand on.
    pub fn way(&self) -> Option<&crate::passage::Way> {
        let at_rest = || self.load_test.as_ref().and_then(|test| test.way.as_ref());
        self.passage.as_ref().map(|passage| &passage.way).or_else(at_rest)
    }
}
