//! Loads on the uppermost course of a wall.

use crate::discretise::cover::Surface;
use crate::discretise::dispersal::{Spread, Strip, spread};
use crate::discretise::extrados::{Extrados, Stretch};
use bridge::{Dispersal, DispersalRule};
use mechanics::blocks::PointForce;
use mechanics::plane::vec2;

/// A strip as forces on the bricks of the uppermost course, whose upper faces are `road`. Without `bricks` every brick
/// carries the part of the strip that stands on it; otherwise so many bricks nearest to the strip's middle carry it as
/// evenly as leaves the resultant in its place.
pub fn on_bricks(strip: Strip, bricks: Option<usize>, road: &Extrados, surface: &Surface) -> Spread {
    let straight = Dispersal { rule: DispersalRule::None, slope: 1.0 };
    let by_length = spread(strip, straight, surface, road);
    let Some(count) = bricks else { return by_length };
    let middle = |s: &Stretch| 0.5 * (s.left.x + s.right.x);
    let mut nearest: Vec<&Stretch> = road.stretches.iter().collect();
    nearest.sort_by(|a, b| (middle(a) - strip.middle).abs().total_cmp(&(middle(b) - strip.middle).abs()));
    nearest.truncate(count);
    nearest.sort_by(|a, b| a.left.x.total_cmp(&b.left.x));
    let Some(mut forces) = shares(strip, &nearest) else { return by_length };
    strip.pull(&mut forces, surface);
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

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::ids::BlockId;

    /// Bricks of 0.6 m from x = 0 on.
    fn road() -> Extrados {
        let brick = |k: u32| Stretch {
            block: BlockId(k),
            left: vec2(0.6 * f64::from(k), 1.0),
            right: vec2(0.6 * f64::from(k + 1), 1.0),
            ground: false,
        };
        Extrados {
            stretches: (0..20).map(brick).collect(),
            line: vec![vec2(0.0, 1.0), vec2(12.0, 1.0)],
            ..Extrados::default()
        }
    }

    #[test]
    fn bricks_carry_the_whole_load_where_it_stands() {
        for count in [None, Some(1), Some(2), Some(3), Some(5)] {
            for middle in [4.2, 4.575, 4.79, 5.1] {
                let strip = Strip { middle, length: 0.75, force: 1e3, horizontal: 0.0, is_pressure: false };
                let s = on_bricks(strip, count, &road(), &Surface::level(1.0));
                let down: f64 = s.forces.iter().map(|f| -f.force.y).sum();
                let moment: f64 = s.forces.iter().map(|f| -f.force.y * f.at.x).sum();
                // Round-off only.
                assert!((down - 1e3).abs() < 1e-9, "{count:?} at {middle}");
                assert!((moment - 1e3 * middle).abs() < 1e-8, "{count:?} at {middle}");
                assert!(s.forces.iter().all(|f| f.force.y <= 0.0));
                assert!(count.is_none_or(|count| s.forces.len() == count));
            }
        }
    }

    #[test]
    fn two_bricks_beside_a_head_joint_carry_half_each() {
        let s = on_bricks(
            Strip { middle: 4.8, length: 0.75, force: 1e3, horizontal: 0.0, is_pressure: false },
            Some(2),
            &road(),
            &Surface::level(1.0),
        );
        let forces: Vec<f64> = s.forces.iter().map(|f| -f.force.y).collect();
        assert!(forces.len() == 2 && forces.iter().all(|f| (f - 500.0).abs() < 1e-9), "{forces:?}");
    }
}
