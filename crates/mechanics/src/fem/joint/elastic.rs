//! A joint that only deforms.

use super::{PairLaw, PairMemory, PairResponse, PairState};

/// Linear in both directions, in tension as in compression.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticJoint {
    /// Normal stiffness per area [Pa/m].
    pub normal: f64,
    /// Tangential stiffness per area [Pa/m].
    pub tangential: f64,
}

impl PairLaw for ElasticJoint {
    fn respond(&self, opening: [f64; 2], _area: f64, old: &PairMemory) -> PairResponse {
        PairResponse {
            traction: [self.normal * (opening[0] - old.crush), self.tangential * (opening[1] - old.slip)],
            tangent: [[self.normal, 0.0], [0.0, self.tangential]],
            memory: PairMemory { state: PairState::Closed, ..*old },
            state: PairState::Closed,
        }
    }
}
