//! What the particles amount to: out-of-balance force, energies, contacts, stresses.

use super::super::model::Model;
use super::super::outcome::{Body, ParticleContact, ParticleState};
use super::{Disc, ParticleModel, Particles, with_forces};
use crate::ids::{BlockId, ParticleId, Table};
use crate::plane::{Pose, Vec2, vec2};

/// Share of the shear that a contact can carry above which it slides: it was cut to that within rounding.
const SLIDES: f64 = 1.0 - 1e-12;

impl Particles {
    /// Sum over the particles of the out-of-balance force [N/m], moments counted at the radius of gyration.
    pub(crate) fn unbalanced(&self) -> f64 {
        let mut sum = 0.0;
        for chunk in &self.chunks {
            with_forces(chunk, &self.chunks, |_, force| {
                sum += force[0].abs() + force[1].abs() + std::f64::consts::SQRT_2 * force[2].abs();
            });
        }
        sum
    }

    /// Work of gravity since the particles were built and elastic energy [J/m], both `half` a step [s] back.
    pub(crate) fn energy(&self, model: &ParticleModel, half: f64) -> [f64; 2] {
        let [mut gravity, mut elastic] = [0.0; 2];
        for ((disc, built), weight) in self.discs.iter().zip(&model.built).zip(&model.weights) {
            let moved = vec2(disc.x - disc.vx * half - built[0], disc.y - disc.vy * half - built[1]);
            gravity += moved.dot(vec2(weight[0], weight[1]));
        }
        for chunk in &self.chunks {
            with_forces(chunk, &self.chunks, |k, force| {
                let (disc, w) = (&self.discs[chunk.first as usize + k], &model.weights[chunk.first as usize + k]);
                let of_contacts = (force[0] - w[0]) * disc.vx + (force[1] - w[1]) * disc.vy + force[2] * disc.rim;
                elastic -= half * of_contacts;
            });
            for c in &chunk.contacts {
                let (_, overlap) = meeting(&self.discs[chunk.first as usize + c.one as usize], &self.discs[c.other()]);
                let compressed = overlap.max(0.0);
                elastic += 0.5 * (c.normal_stiffness * compressed * compressed + c.shear * c.shear / c.shear_stiffness);
            }
            for l in &chunk.leans {
                elastic +=
                    0.5 * (l.compression * l.compression / l.normal_stiffness + l.shear * l.shear / l.shear_stiffness);
            }
        }
        [gravity, elastic]
    }

    /// Calls `each` with the compression [N/m] of every near pair, the distance [m] over which it acts inside the particles,
    /// and the rows of its particles.
    pub(crate) fn each_force(&self, mut each: impl FnMut(f64, f64, (usize, Option<usize>))) {
        for chunk in &self.chunks {
            for c in &chunk.contacts {
                let (i, j) = (chunk.first as usize + c.one as usize, c.other());
                let (one, two) = (&self.discs[i], &self.discs[j]);
                let (_, overlap) = meeting(one, two);
                let branch = one.radius + two.radius - overlap;
                each(c.normal_stiffness * overlap.max(0.0), branch, (i, Some(j)));
            }
            for l in &chunk.leans {
                let i = (chunk.first + l.local) as usize;
                each(l.compression, self.discs[i].radius, (i, None));
            }
        }
    }

    /// Closed contacts, in the order of memory.
    pub(crate) fn contacts(&self, model: &Model, poses: &[Pose]) -> Vec<ParticleContact> {
        let mut found = Vec::new();
        let id = |row: usize| ParticleId(model.particles.ids[row]);
        for chunk in &self.chunks {
            for c in &chunk.contacts {
                let (i, j) = (chunk.first as usize + c.one as usize, c.other());
                let (one, two) = (&self.discs[i], &self.discs[j]);
                let (normal, overlap) = meeting(one, two);
                if overlap <= 0.0 {
                    continue;
                }
                let compression = c.normal_stiffness * overlap;
                let (law, sum) = (&model.particles.laws.pairs[c.law()], one.radius + two.radius);
                let cap = law.cohesion + law.cohesion_share * sum + law.friction * compression;
                let own = model.laws.between(model.particles.group(i as u32), model.particles.group(j as u32));
                let reach = one.radius * (sum - overlap) / sum;
                found.push(ParticleContact {
                    particle: id(j),
                    partner: Body::Particle(id(i)),
                    point: one.centre() + normal * reach,
                    normal,
                    compression,
                    shear: c.shear,
                    length: own.fixed_length.unwrap_or(sum),
                    sliding: c.shear.abs() >= cap * SLIDES,
                });
            }
            for l in &chunk.leans {
                let i = (chunk.first + l.local) as usize;
                let (disc, block) = (&self.discs[i], l.block as usize);
                let at = { *l }.look(disc, &model.cores.as_slice()[block], &poses[block]);
                if at.overlap <= 0.0 {
                    continue;
                }
                let compression = l.normal_stiffness * at.overlap;
                found.push(ParticleContact {
                    particle: id(i),
                    partner: Body::Block(BlockId(l.block)),
                    point: disc.centre() - at.normal * (disc.radius - 0.5 * at.overlap),
                    normal: at.normal,
                    compression,
                    shear: l.shear,
                    length: l.length,
                    sliding: l.shear.abs() >= (l.cohesion + l.friction * compression) * SLIDES,
                });
            }
        }
        found
    }

    /// The particles one by one; stresses from the forces on their rims, `1/A sum x (x) f`.
    pub(crate) fn states(
        &self,
        model: &ParticleModel,
        contacts: &[ParticleContact],
    ) -> Table<ParticleId, ParticleState> {
        let state = |row: &u32| {
            let d = &self.discs[*row as usize];
            ParticleState {
                centre: d.centre(),
                radius: d.radius,
                angle: d.angle(),
                velocity: vec2(d.vx, d.vy),
                spin: d.rim / d.radius,
                stress: [0.0; 3],
            }
        };
        let mut states: Table<ParticleId, ParticleState> = model.rows.iter().map(state).collect();
        let add = |s: &mut ParticleState, at: Vec2, f: Vec2| {
            let x = at - s.centre;
            let share = 1.0 / (std::f64::consts::PI * s.radius * s.radius);
            s.stress[0] += x.x * f.x * share;
            s.stress[1] += x.y * f.y * share;
            s.stress[2] += 0.5 * (x.x * f.y + x.y * f.x) * share;
        };
        for c in contacts {
            add(&mut states[c.particle], c.point, c.force());
            if let Body::Particle(other) = c.partner {
                add(&mut states[other], c.point, -c.force());
            }
        }
        states
    }
}

/// Unit normal from `one` to `two` and overlap [m].
fn meeting(one: &Disc, two: &Disc) -> (Vec2, f64) {
    let apart = two.centre() - one.centre();
    (apart.unit(), one.radius + two.radius - apart.norm())
}
