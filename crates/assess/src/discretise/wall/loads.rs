//! Loads on the uppermost course of a wall.

use crate::discretise::dispersal::{Spread, Strip, spread};
use crate::discretise::extrados::{Extrados, Stretch};
use bridge::{Dispersal, DispersalRule};
use mechanics::blocks::PointForce;
use mechanics::plane::vec2;

/// A strip as forces on the bricks of the uppermost course, whose upper faces are `road`. Without `bricks` every brick
/// carries the part of the strip that stands on it; otherwise so many bricks nearest to the strip's middle carry it as
/// evenly as leaves the resultant in its place.
pub fn on_bricks(strip: Strip, bricks: Option<usize>, road: &Extrados, surface: f64) -> Spread {
    let straight = Dispersal { rule: DispersalRule::None, slope: 1.0 };
    let by_length = spread(strip, straight, surface, road);
    let Some(count) = bricks else { return by_length };
    let middle = |s: &Stretch| 0.5 * (s.left.x + s.right.x);
    let mut nearest: Vec<&Stretch> = road.stretches.iter().collect();
    nearest.sort_by(|a, b| (middle(a) - strip.middle).abs().total_cmp(&(middle(b) - strip.middle).abs()));
    nearest.truncate(count);
    nearest.sort_by(|a, b| a.left.x.total_cmp(&b.left.x));
    let Some(forces) = shares(strip, &nearest) else { return by_length };
    Spread { forces, ..by_length }
}

/// Forces on the bricks that have the strip's resultant and differ as little as possible; none where one of them would
/// have to pull.
fn shares(strip: Strip, bricks: &[&Stretch]) -> Option<Vec<PointForce>> {
    let n = bricks.len() as f64;
    let push = |s: &Stretch, x: f64, force: f64| PointForce { block: s.block, at: s.at(x), force: vec2(0.0, -force) };
    if let [only] = bricks {
        let inside = only.left.x <= strip.middle && strip.middle <= only.right.x;
        return inside.then(|| vec![push(only, strip.middle, strip.force)]);
    }
    let middle = |s: &Stretch| 0.5 * (s.left.x + s.right.x);
    let mean = bricks.iter().map(|s| middle(s)).sum::<f64>() / n;
    let spread: f64 = bricks.iter().map(|s| (middle(s) - mean).powi(2)).sum();
    let lever = (strip.middle - mean) / spread;
    let share = |s: &Stretch| strip.force * (1.0 / n + lever * (middle(s) - mean));
    let forces: Vec<f64> = bricks.iter().map(|s| share(s)).collect();
    forces.iter().all(|&f| f >= 0.0).then(|| bricks.iter().zip(forces).map(|(s, f)| push(s, middle(s), f)).collect())
}
