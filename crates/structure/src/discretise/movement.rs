//! The support movement of the plan.

use super::error::DiscretiseError;
use super::origin::Origin;
use super::springings::{bridge_length, springings};
use bridge::Bridge;
use mechanics::blocks::{BlockModel, Movement};
use mechanics::ids::{BlockId, Id, Table};
use mechanics::plane::vec2;

/// The support movement of the plan, on the block that is the support. It turns about the springing's middle for an
/// abutment and about the middle of the foundation's upper face for a pier.
pub(super) fn movements(
    bridge: &Bridge,
    model: &BlockModel,
    origins: &Table<BlockId, Origin>,
) -> Result<Vec<Movement>, DiscretiseError> {
    let Some(m) = bridge.plan.support_movement else { return Ok(Vec::new()) };
    let last = bridge.spans.len();
    let is_it = |o: &Origin| match *o {
        Origin::Abutment { support } | Origin::Foundation { support } | Origin::AbutmentGround { support } => {
            support == m.support
        }
        _ => false,
    };
    let Some(block) = origins.iter().position(is_it).map(BlockId::new) else {
        return Err(DiscretiseError::NoSuchSupport { support: m.support, last });
    };
    let centre = model.blocks[block].outline.centroid();
    let pivot = match origins[block] {
        Origin::Abutment { support: 0 } => vec2(0.0, 0.0),
        Origin::Abutment { .. } => vec2(bridge_length(bridge), springings(bridge).last().map_or(0.0, |ends| ends[1].y)),
        _ => vec2(centre.x, model.blocks[block].outline.bounds().1.y),
    };
    // The centroid of a block that turns about another point also moves.
    let translation = vec2(m.horizontal, m.vertical) + (centre - pivot).left() * m.rotation;
    Ok(vec![Movement { block, translation, rotation: m.rotation }])
}
