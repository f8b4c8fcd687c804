//! Vehicles whose loads are a multiple of another's: the same cases govern both.

use super::factored::Footprint;
use crate::vehicles::Chosen;
use rules::Pattern;

/// A vehicle whose loads are a multiple of those of an earlier one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Twin {
    /// The earlier one.
    pub of: usize,
    /// How many times its loads.
    pub times: f64,
}

/// For each vehicle the first one that it is a multiple of: units of HB, numbers of RA.
pub(super) fn twins(vehicles: &[Chosen], feet: &[Footprint]) -> Vec<Option<Twin>> {
    let patterns: Vec<Vec<Pattern>> = vehicles.iter().map(|chosen| chosen.vehicle.patterns()).collect();
    let mut twins: Vec<Option<Twin>> = Vec::with_capacity(vehicles.len());
    for k in 0..vehicles.len() {
        let twin = (0..k).filter(|&of| twins[of].is_none() && feet[of] == feet[k]).find_map(|of| {
            let alike = vehicles[of].vehicle.axles_may_be_dropped == vehicles[k].vehicle.axles_may_be_dropped
                && patterns[of].len() == patterns[k].len();
            let times = patterns[k].first()?.force() / patterns[of].first()?.force();
            let multiple = patterns[k].iter().zip(&patterns[of]).all(|(this, other)| this.is_multiple(other, times));
            (alike && multiple).then_some(Twin { of, times })
        });
        twins.push(twin);
    }
    twins
}
