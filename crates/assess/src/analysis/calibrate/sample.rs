//! A square cut out of the fill. Particles that the cut goes through are replaced by smaller ones where these find room
//! ("replacing, when possible, the partially truncated particles by smaller ones").

use super::settled::{Laws, SettledFill};
use crate::analysis::AnalysisError;
use bridge::Bridge;
use mechanics::blocks::{Block, BlockModel, Held, Particle};
use mechanics::ids::{BlockId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};
use outcome::calibration::Cut;

/// Particles of a square, seen from its lower left corner.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sample {
    /// Seed of the packing that it was cut from.
    pub seed: u64,
    /// Which of its squares, from 0.
    pub square: usize,
    /// Side [m].
    pub size: f64,
    /// The particles, centres from the lower left corner [m].
    pub particles: Vec<Particle>,
    /// Particles that the cut went through.
    pub cuts: Vec<Cut>,
    /// Radius of the smallest particle of the packing [m].
    pub smallest: f64,
    /// Mean diameter of the particles of the packing [m].
    pub mean_diameter: f64,
    /// Laws of their contacts.
    pub laws: Laws,
}

/// A rectangular block beside a sample.
pub(super) struct Part {
    /// Its lower left corner [m].
    pub low: Vec2,
    /// How wide it is [m].
    pub width: f64,
    /// How high [m].
    pub height: f64,
    /// Its density [kg/m^3].
    pub density: f64,
    /// How it is held.
    pub held: Held,
}

impl Sample {
    /// The sample among blocks, and each of them with its middle.
    pub(super) fn among(
        &self,
        parts: [Part; 4],
        laws: Laws,
    ) -> Result<(BlockModel, [(BlockId, Vec2); 4]), AnalysisError> {
        let mut blocks: Table<BlockId, Block> = Table::default();
        let mut placed = [(BlockId(0), Vec2::ZERO); 4];
        for (Part { low, width, height, density, held }, place) in parts.into_iter().zip(&mut placed) {
            // Sides are positive lengths: only a sample of next to nothing leaves no shape.
            let shapeless = |_| AnalysisError::SmallSample { size: self.size, diameter: self.mean_diameter };
            let outline = Polygon::rectangle(low, width, height).map_err(shapeless)?;
            let middle = outline.centroid();
            *place = (blocks.push(Block { outline, rounding: 0.0, density, group: laws.walls, held }), middle);
        }
        let particles = self.particles.iter().copied().collect();
        let Laws { table, groups, gravity, .. } = laws;
        Ok((BlockModel { blocks, particles, groups, laws: table, gravity }, placed))
    }

    /// Level of the highest particle's top [m].
    pub(super) fn top(&self) -> f64 {
        self.particles.iter().map(|p| p.centre.y + p.radius).fold(0.0, f64::max)
    }

    /// Cuts the square at `corner` out of the fill; `name` is its seed and number.
    pub(super) fn cut(bridge: &Bridge, fill: &SettledFill, name: (u64, usize), corner: Vec2) -> Sample {
        let size = bridge.calibration.sample_size;
        let (mut inside, mut through) = (Vec::new(), Vec::new());
        for particle in &fill.particles {
            let moved = Particle { centre: particle.centre - corner, ..*particle };
            match depth(moved.centre, size) {
                d if d >= moved.radius => inside.push(moved),
                _ if reaches_in(&moved, size) => through.push(moved),
                _ => {}
            }
        }
        let least = bridge.calibration.least_replacement * fill.smallest();
        let mut cuts = Vec::new();
        for old in through {
            let new = largest_in(&old, size, &inside).filter(|new| new.radius >= least);
            cuts.push(Cut { centre: [old.centre.x, old.centre.y], radius: old.radius, replaced: new.is_some() });
            inside.extend(new);
        }
        let (seed, square) = name;
        Sample {
            seed,
            square,
            size,
            particles: inside,
            cuts,
            smallest: fill.smallest(),
            mean_diameter: fill.mean_diameter(),
            laws: fill.laws.clone(),
        }
    }

    /// Share of the square that particles cover.
    pub(super) fn solid_fraction(&self) -> f64 {
        let covered: f64 = self.particles.iter().map(|p| std::f64::consts::PI * p.radius * p.radius).sum();
        covered / (self.size * self.size)
    }
}

/// How far inside the square a point lies [m]; negative outside.
fn depth(p: Vec2, size: f64) -> f64 {
    p.x.min(size - p.x).min(p.y).min(size - p.y)
}

/// Whether some of a particle lies in the square.
fn reaches_in(particle: &Particle, size: f64) -> bool {
    let c = particle.centre;
    let nearest = vec2(c.x.clamp(0.0, size), c.y.clamp(0.0, size));
    (c - nearest).norm() < particle.radius
}

/// The largest particle, no larger than `old`, that fits into the square where `old` was: its centre stays within `old`,
/// and it overlaps no other. None where there is no room.
fn largest_in(old: &Particle, size: f64, others: &[Particle]) -> Option<Particle> {
    let reach = 4.0 * old.radius;
    let near: Vec<&Particle> = others.iter().filter(|p| (p.centre - old.centre).norm() < reach + p.radius).collect();
    let room = |p: Vec2| {
        if (p - old.centre).norm() > old.radius {
            return f64::NEG_INFINITY;
        }
        near.iter().map(|other| (other.centre - p).norm() - other.radius).fold(depth(p, size), f64::min)
    };
    // The part of the old particle inside the square is convex: the middle between its farthest points towards the middle
    // of the square and at the edge is a start; then steps that grow the room, halved where none does.
    let edge = vec2(old.centre.x.clamp(0.0, size), old.centre.y.clamp(0.0, size));
    let inwards = vec2(0.5 * size, 0.5 * size) - edge;
    let mut at = edge + inwards * (0.25 * old.radius / inwards.norm().max(1e-300));
    let mut best = room(at);
    let mut step = 0.5 * old.radius;
    while step > 1e-6 * old.radius {
        let better = (0..DIRECTIONS)
            .map(|k| {
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(DIRECTIONS);
                let p = at + vec2(angle.cos(), angle.sin()) * step;
                (room(p), p)
            })
            .fold((best, at), |best, next| if next.0 > best.0 { next } else { best });
        if better.0 > best {
            (best, at) = better;
        } else {
            step *= 0.5;
        }
    }
    (best > 0.0).then(|| Particle { centre: at, radius: best.min(old.radius), ..*old })
}

/// Directions of a step: enough that some lead between two neighbours.
const DIRECTIONS: u32 = 16;

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::ids::GroupId;

    fn disc(x: f64, y: f64, radius: f64) -> Particle {
        Particle { centre: vec2(x, y), radius, density: 2000.0, group: GroupId(0) }
    }

    #[test]
    fn a_particle_cut_by_one_edge_leaves_room_for_a_smaller_one() {
        // Alone, it only moves inwards: its centre stays within the old one, and it stays as large.
        let alone = largest_in(&disc(0.05, 0.5, 0.1), 1.0, &[]).unwrap();
        assert!((alone.radius - 0.1).abs() < 1e-9 && alone.centre.x >= 0.1 - 1e-9, "{alone:?}");
        // With a neighbour in front, two circles and a straight wall: the new one touches wall and neighbour.
        let neighbour = disc(0.25, 0.5, 0.1);
        let new = largest_in(&disc(0.05, 0.5, 0.1), 1.0, &[neighbour]).unwrap();
        let gap = (neighbour.centre - new.centre).norm() - neighbour.radius;
        assert!((gap - new.radius).abs() < 1e-6 && (new.centre.x - new.radius).abs() < 1e-6, "{new:?} {gap}");
        assert!(new.radius >= 0.075 && new.radius <= 0.1);
    }

    #[test]
    fn a_corner_is_a_place_too_and_a_full_one_is_none() {
        let corner = largest_in(&disc(-0.02, -0.02, 0.1), 1.0, &[disc(0.15, 0.15, 0.08)]).unwrap();
        assert!(depth(corner.centre, 1.0) >= corner.radius - 1e-12 && corner.radius > 0.02, "{corner:?}");
        let full = [disc(0.0, 0.5, 0.2)];
        assert_eq!(largest_in(&disc(-0.05, 0.5, 0.1), 1.0, &full), None);
    }
}
