//! Whether the analysis that a file plans can be set up: everything that it refuses before it computes, and no computing.

use super::engine::rings::RingThickness;
use super::engine::{self, can};
use super::state::{self, Change};
use super::{AnalysisError, movement};
use bridge::{Analysis, Bridge, Strip};

/// Refuses what the collapse analysis of the file's plan would refuse. A file that describes no load plans none.
///
/// # Errors
/// What the analysis would refuse.
pub fn planned(bridge: &Bridge) -> Result<(), AnalysisError> {
    let both = bridge.plan.analysis == Analysis::Load && bridge.plan.strip == Strip::Both;
    if !both {
        return one(bridge);
    }
    for strip in [Strip::Fill, Strip::Wall] {
        one(&state::with(bridge, &[Change::Strip(strip)]))?;
    }
    Ok(())
}

fn one(bridge: &Bridge) -> Result<(), AnalysisError> {
    let method = bridge.plan.method;
    if bridge.plan.analysis == Analysis::Load && bridge.loads.is_empty() {
        return Ok(());
    }
    can::refused(bridge)?;
    match bridge.plan.analysis {
        Analysis::Load => engine::by(method).ready(bridge),
        Analysis::Thickness => {
            engine::by(method).joints(bridge)?;
            RingThickness { bridge }.at(1.0).map(|_| ())
        }
        Analysis::SupportMovement => {
            movement::given(bridge)?;
            engine::by(method).joints(bridge)
        }
    }
}
