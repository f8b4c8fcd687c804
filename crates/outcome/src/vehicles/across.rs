//! How vehicles stand across the bridge.

use crate::wire::published;
use serde::{Deserialize, Serialize};

published! {
    /// How vehicles stand across the bridge where that is worst.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Across {
        /// How many stand abreast.
        pub abreast: usize as vehicles_abreast,
        /// Whether the outermost one stands at the edge.
        pub at_edge: bool,
        /// Width of the barrel that carries the axles of the first vehicle [m]: the force per metre of width is that of its
        /// axle over this width, whatever stands beside it, multiple presence included.
        pub axles: f64 [kept],
        /// The same for each of its uniform loads, in their order, each in the arrangement that is worst for it [m].
        pub uniform: Vec<f64> [kept],
        /// The strip between longitudinal cracks that is loaded most, from one edge of the barrel [m]; none where the barrel is whole, or
        /// where its cracks make nothing worse.
        pub strip: Option<[f64; 2]> [m] as strip_between_cracks,
        /// Where lines of wheels or rails stand across, from the same edge [m].
        pub wheels: Vec<f64> [m] as wheel_lines,
        /// How the width of the axles was found, in words.
        pub derivation: String as effective_width_derivation,
        /// The vehicle of another kind that stands in the lanes beside it; empty where these are empty, or hold vehicles of the same kind.
        pub beside: String [kept],
    }
}

impl Across {
    /// In words: "2 vehicles abreast, the outer one at the edge".
    pub fn told(&self) -> String {
        if let Some([from, to]) = self.strip {
            let who =
                if self.abreast == 1 { "one vehicle".to_owned() } else { format!("{} vehicles abreast", self.abreast) };
            return format!("{who} on the strip {from:.2} to {to:.2} m between longitudinal cracks");
        }
        if !self.beside.is_empty() {
            let edge = if self.at_edge { ", the outer one at the edge" } else { "" };
            let lanes = if self.abreast > 2 { "lanes" } else { "lane" };
            return format!("one vehicle with {} in the {lanes} beside{edge}", self.beside);
        }
        match (self.abreast, self.at_edge) {
            (1, false) => "one vehicle in the middle of the barrel".to_owned(),
            (1, true) => "one vehicle at the edge of the barrel".to_owned(),
            (count, false) => format!("{count} vehicles abreast"),
            (count, true) => format!("{count} vehicles abreast, the outer one at the edge"),
        }
    }
}
