//! A particle that leans on a block.

use super::disc::Disc;
use crate::plane::{Core, Pose, Vec2, vec2};
use serde::{Deserialize, Serialize};

/// A particle and a block close enough to touch before the next search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(in crate::dem) struct Lean {
    /// The block, and its row in the chunk's list of blocks.
    pub block: u32,
    pub row: u32,
    /// The particle, counted from the chunk's first.
    pub local: u32,
    /// Edge of the block's core that was nearest last.
    pub edge: u32,
    /// Shear force on the particle [N/m], along the normal (from block to particle) turned left.
    pub shear: f64,
    /// Stiffness [Pa].
    pub normal_stiffness: f64,
    pub shear_stiffness: f64,
    /// Shear carried without compression [N/m], and coefficient of friction.
    pub cohesion: f64,
    pub friction: f64,
    /// Length that the contact stands for [m].
    pub length: f64,
    /// Compression now [N/m].
    pub compression: f64,
}

/// Where a particle leans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dem) struct Leaning {
    /// Unit normal from the block to the particle.
    pub normal: Vec2,
    /// Overlap [m], positive when closed.
    pub overlap: f64,
}

/// Forces of a lean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dem) struct Push {
    /// On the particle [N/m]; its opposite acts on the block.
    pub force: Vec2,
    /// Along the particle's rim [N/m], and moment on the block [N].
    pub rim: f64,
    pub moment: f64,
    /// Energy lost [J/m].
    pub dissipated: f64,
}

/// Nearest point of a core to `q`, a place in the block's frame outside or inside of it: the outward unit normal, the
/// distance from the core (negative inside) and the edge. The walk starts at `edge`: a place moves on to a neighbour at
/// most, so it mostly ends where it began.
pub(in crate::dem) fn nearest(core: &Core, q: Vec2, mut edge: usize) -> (Vec2, f64, usize) {
    let n = core.len();
    let height = |i: usize| (q - core.vertices[i]).dot(core.directions[i].right());
    for _ in 0..n {
        let from = q - core.vertices[edge];
        let along = from.dot(core.directions[edge]);
        let across = from.dot(core.directions[edge].right());
        if across < 0.0 {
            break;
        }
        if along < 0.0 {
            let before = if edge == 0 { n - 1 } else { edge - 1 };
            if (q - core.vertices[before]).dot(core.directions[before]) >= core.lengths[before] {
                return corner(from, core.directions[edge].right(), edge);
            }
            edge = before;
        } else if along > core.lengths[edge] {
            let next = core.next(edge);
            let from = q - core.vertices[next];
            if from.dot(core.directions[next]) <= 0.0 {
                return corner(from, core.directions[next].right(), next);
            }
            edge = next;
        } else {
            return (core.directions[edge].right(), across, edge);
        }
    }
    // Behind the edge's line: look at all of them.
    let highest = (1..n).fold(0, |best, i| if height(i) > height(best) { i } else { best });
    if height(highest) > 0.0 && highest != edge {
        return nearest_of_all(core, q, highest);
    }
    (core.directions[highest].right(), height(highest), highest)
}

fn corner(from: Vec2, fallback: Vec2, edge: usize) -> (Vec2, f64, usize) {
    let distance = from.norm();
    (if distance > 1e-300 { from * (1.0 / distance) } else { fallback }, distance, edge)
}

/// The same for a place outside the core, edge by edge.
fn nearest_of_all(core: &Core, q: Vec2, start: usize) -> (Vec2, f64, usize) {
    let mut best = (core.directions[start].right(), f64::INFINITY, start);
    for i in 0..core.len() {
        let from = q - core.vertices[i];
        let along = from.dot(core.directions[i]).clamp(0.0, core.lengths[i]);
        let away = from - core.directions[i] * along;
        let distance = away.norm();
        if distance < best.1 {
            best = (if distance > 1e-300 { away * (1.0 / distance) } else { core.directions[i].right() }, distance, i);
        }
    }
    best
}

impl Lean {
    /// Where the particle leans now; remembers the edge.
    #[inline]
    pub(crate) fn look(&mut self, disc: &Disc, core: &Core, pose: &Pose) -> Leaning {
        let q = pose.rotation.turn_back(disc.centre() - pose.position);
        let (normal, distance, edge) = nearest(core, q, self.edge as usize);
        self.edge = edge as u32;
        Leaning { normal: pose.rotation.turn(normal), overlap: core.radius + disc.radius - distance }
    }

    /// What the lean does after a step of `dt` [s].
    #[inline]
    pub(crate) fn resist(
        &mut self,
        disc: &Disc,
        core: &Core,
        pose: &Pose,
        velocity: &[f64; 3],
        dt: f64,
    ) -> Option<Push> {
        let at = self.look(disc, core, pose);
        if at.overlap <= 0.0 {
            if self.shear == 0.0 {
                self.compression = 0.0;
                return None;
            }
            let dissipated = 0.5 * self.shear * self.shear / self.shear_stiffness;
            self.shear = 0.0;
            self.compression = 0.0;
            return Some(Push { force: Vec2::ZERO, rim: 0.0, moment: 0.0, dissipated });
        }
        let compression = self.normal_stiffness * at.overlap;
        let arm = disc.radius - 0.5 * at.overlap;
        let from_block = disc.centre() - at.normal * arm - pose.position;
        let tangent = at.normal.left();
        let share = arm / disc.radius;
        let of_block = vec2(velocity[0], velocity[1]) + from_block.left() * velocity[2];
        let glide = (vec2(disc.vx, disc.vy) - of_block).dot(tangent) - share * disc.rim;
        let trial = self.shear - self.shear_stiffness * glide * dt;
        let cap = self.cohesion + self.friction * compression;
        let shear = trial.max(-cap).min(cap);
        let dissipated = 0.5 * (self.shear + shear) * (trial - shear) / self.shear_stiffness;
        self.shear = shear;
        self.compression = compression;
        let force = at.normal * compression + tangent * shear;
        Some(Push { force, rim: -share * shear, moment: -from_block.cross(force), dissipated })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Polygon;

    /// From every start the walk finds what a search over all edges finds.
    #[test]
    fn the_walk_finds_the_nearest_place() {
        let outline = Polygon::new(
            [(0.0, 0.0), (3.0, -0.4), (4.0, 0.6), (2.0, 1.5), (0.4, 1.0)].map(|(x, y)| vec2(x, y)).to_vec(),
        )
        .unwrap();
        let core = Core::new(&outline, 0.05).unwrap();
        for k in 0..2000 {
            let (a, r) = (f64::from(k) * 0.377, 0.2 + f64::from(k % 50) * 0.1);
            let q = vec2(r * a.cos(), r * a.sin());
            let inside = (0..core.len()).all(|i| (q - core.vertices[i]).dot(core.directions[i].right()) < 0.0);
            for edge in 0..core.len() {
                let (normal, distance, _) = nearest(&core, q, edge);
                if inside {
                    let highest = (0..core.len())
                        .map(|i| (q - core.vertices[i]).dot(core.directions[i].right()))
                        .fold(f64::NEG_INFINITY, f64::max);
                    assert!((distance - highest).abs() < 1e-12, "{q:?} {edge}");
                } else {
                    let best = nearest_of_all(&core, q, 0);
                    assert!((distance - best.1).abs() < 1e-12, "{q:?} {edge}: {distance} {}", best.1);
                    assert!((normal - best.0).norm() < 1e-9, "{q:?} {edge}");
                }
            }
        }
    }
}
