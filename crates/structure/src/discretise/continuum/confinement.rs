//! What spandrel walls hold: panels that bound the stress out of the plane.
//!
//! A wall of thickness `t` and height `w` stands on its bed by its weight alone. A metre of it slides outwards where the resultant of the fill's
//! pressures on it exceeds `mu gamma t w`, and tilts about its outer toe where their moment about the bed exceeds `gamma t^2 w / 2`.

use crate::discretise::Discretised;
use bridge::{Bridge, Confinement, ContinuumPlan};
use mechanics::limit::continuum::Panel;

/// Length of a panel [m], about: so much of a wall acts as one piece.
const PANEL: f64 = 1.0;

/// Panels from one end of the continuum to the other, where the plan wants them and the file has walls.
pub(super) fn panels(bridge: &Bridge, discretised: &Discretised, plan: &ContinuumPlan, ends: [f64; 2]) -> Vec<Panel> {
    let (Some(wall), Confinement::SpandrelWalls) = (&bridge.spandrel_wall, plan.confinement) else { return Vec::new() };
    let extrados = &discretised.extrados;
    let cover: f64 = bridge.cover.layers.iter().map(|layer| layer.thickness).sum();
    let crest = extrados.crown() + wall.top.unwrap_or(cover);
    // The file gives both walls together.
    let thickness = 0.5 * wall.thickness;
    let unit = wall.density * bridge.gravity * thickness;
    let friction = wall.joint.friction_angle.tan();
    let count = ((ends[1] - ends[0]) / PANEL).round().max(1.0);
    let length = (ends[1] - ends[0]) / count;
    let at = |k: f64| if k == count { ends[1] } else { ends[0] + k * length };
    (0..count as usize)
        .map(|k| {
            let ends = [at(k as f64), at(k as f64 + 1.0)];
            let [lowest, mean] = levels(discretised, ends);
            let weight = unit * length * (crest - mean).max(0.0);
            Panel { ends, foot: lowest, force: friction * weight, moment: 0.5 * thickness * weight }
        })
        .collect()
}

/// Lowest and mean level of the extrados between two places [m]; beyond the rings that of their ends.
fn levels(discretised: &Discretised, [from, to]: [f64; 2]) -> [f64; 2] {
    let stretches = &discretised.extrados.stretches;
    let level = |x: f64| {
        let on = stretches.iter().filter(|s| s.left.x <= x && x <= s.right.x).map(|s| s.at(x).y);
        let nearest = || {
            let ends = stretches.iter().flat_map(|s| [s.left, s.right]);
            ends.min_by(|a, b| (a.x - x).abs().total_cmp(&(b.x - x).abs())).map_or(0.0, |p| p.y)
        };
        on.min_by(f64::total_cmp).unwrap_or_else(nearest)
    };
    let places = (0..=SAMPLES).map(|k| level(from + (to - from) * f64::from(k) / f64::from(SAMPLES)));
    let corners = stretches.iter().flat_map(|s| [s.left, s.right]).filter(|p| from < p.x && p.x < to).map(|p| p.y);
    let sum: f64 = places.clone().sum();
    [places.chain(corners).fold(f64::INFINITY, f64::min), sum / f64::from(SAMPLES + 1)]
}

/// Places along a panel at which the extrados is looked at, less one.
const SAMPLES: i32 = 10;
