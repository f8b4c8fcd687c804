//! Where vehicles stand across the bridge, as far as a plane model can say it: the width of the barrel that carries one.
//!
//! A vehicle alone in the middle is carried by the width over which its load has spread. Vehicles abreast share what lies
//! between them; one at the edge lacks what would lie beyond it. Every number of vehicles up to that of the lanes is tried,
//! in the middle and at the edge, and the arrangement with the largest force per metre of width counts.

use crate::vehicles::Chosen;
use bridge::{Bridge, Carriageway};
use outcome::vehicles::Across;
use rules::{Rule, Ways};

/// Width of the narrowest lane of a road [m]: that of two vehicles abreast (BD 21, notional lanes).
const ROAD_LANE: f64 = 2.5;
/// Distance between the middles of two tracks [m].
const TRACKS: f64 = 3.4;

/// How many vehicles may stand abreast, and how far their middles are apart [m].
pub fn lanes(bridge: &Bridge, ways: Ways) -> (usize, f64) {
    let asked = bridge.carriageway.unwrap_or_default();
    let usual = if ways == Ways::Road { ROAD_LANE } else { TRACKS };
    let apart = asked.lane_width.unwrap_or(usual);
    let fit = if ways == Ways::Road && bridge.width >= 2.0 * apart { 2 } else { 1 };
    (asked.lanes.unwrap_or(fit).max(1), apart)
}

/// The worst arrangement of a vehicle.
pub fn worst(bridge: &Bridge, rule: &Rule, chosen: &Chosen) -> Across {
    let (most, apart) = lanes(bridge, chosen.ways);
    let edge = bridge.carriageway.and_then(|asked: Carriageway| asked.edge_distance);
    let depth = bridge.cover.depth;
    let alone = rule.effective_width(chosen.vehicle.wheel_track_m, depth, f64::INFINITY).min(bridge.width);
    let overhang = rule.dispersal.overhang_at(depth);
    let share = |lane: usize| match chosen.abreast.is_empty() {
        true => 1.0,
        false => chosen.abreast.get(lane).copied().unwrap_or(0.0),
    };
    // The width that carries the first vehicle when loads of a width each stand so far apart.
    let carried = |width: f64, count: usize, at_edge: bool| {
        let lost = edge.filter(|_| at_edge).map_or(0.0, |edge| (overhang - edge).max(0.0));
        let together = (width + (count as f64 - 1.0) * apart).min(count as f64 * width) - lost;
        let shares: f64 = (0..count).map(share).sum();
        let factor = shares * chosen.acting.presence(count);
        together.min(bridge.width).max(1e-3) / factor
    };
    let counts = (1..=most).filter(|count| *count == 1 || share(count - 1) > 0.0);
    let uniform = vec![f64::INFINITY; chosen.vehicle.uniform.len()];
    let mut found = Across { abreast: 1, at_edge: false, axles: f64::INFINITY, uniform };
    for count in counts {
        for at_edge in [false, true] {
            let axles = carried(alone, count, at_edge);
            if axles < found.axles - 1e-12 {
                (found.abreast, found.at_edge, found.axles) = (count, at_edge, axles);
            }
            for (k, uniform) in chosen.vehicle.uniform.iter().enumerate() {
                let width = match uniform.width_m {
                    Some(own) => (own + rule.dispersal.width_per_depth * depth).min(bridge.width),
                    None => alone,
                };
                found.uniform[k] = found.uniform[k].min(carried(width, count, at_edge));
            }
        }
    }
    found
}
