//! Factors on the weights of a bridge.

use crate::wire::published;
use serde::{Deserialize, Serialize};

published! {
    /// Factors on the weights of one combination.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct Weights {
        /// On masonry: rings, piers, spandrel walls.
        pub masonry: f64,
        /// On fill, backing and sub-base; none where the bridge has no such weight.
        pub fill: Option<f64>,
        /// On surfacing and ballast; none where the bridge has no such weight.
        pub surfacing: Option<f64>,
    }
}

impl Weights {
    /// "weights: masonry × 1.15, fill × 1", each pair on one line.
    pub fn told(&self) -> String {
        let groups = [("masonry", Some(self.masonry)), ("fill", self.fill), ("surfacing", self.surfacing)];
        let each = groups.iter().filter_map(|(name, factor)| Some(format!("{name}\u{a0}×\u{a0}{}", (*factor)?)));
        format!("weights: {}", each.collect::<Vec<_>>().join(", "))
    }
}
