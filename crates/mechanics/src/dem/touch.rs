//! One pair of blocks that may touch: its features, what its contact points remember, and the forces they exert.

use super::end::end;
use crate::blocks::ContactLaw;
use crate::contact::{Bond, ContactLength, Resistance};
use crate::plane::{Core, Meeting, Pose, Vec2, vec2};
use serde::{Deserialize, Serialize};

/// What a contact point remembers.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Memory {
    /// Shear force [N/m], positive when it acts on the incident block along the reference edge.
    pub shear: f64,
    /// Overlap that crushing has taken away for good [m].
    pub crushed: f64,
    /// Length the point stands for [m].
    pub length: f64,
    /// Compression now [N/m].
    pub compression: f64,
    /// Whether the contact still has its tensile strength.
    pub bonded: bool,
    /// Whether it is closed now.
    pub closed: bool,
    /// Whether it slides now.
    pub sliding: bool,
}

/// Velocities of the two blocks of a touch: translations [m/s] and rotation [rad/s].
pub(super) type Velocities<'a> = (&'a [f64; 3], &'a [f64; 3]);

/// What a touch does to its two blocks in one step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Reaction {
    /// Force on block `two` [N/m]; its opposite acts on `one`.
    pub force: Vec2,
    /// Moments about the two centres of mass [N].
    pub on_one: f64,
    pub on_two: f64,
    /// Energy lost [J/m].
    pub dissipated: f64,
}

/// A pair of blocks close enough to touch.
///
/// For two faces, `one` owns the reference edge and `two` the incident one; for two corners they are simply the two
/// blocks. All geometry is in the blocks' own frames, so a step needs no search.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Touch {
    pub one: u32,
    pub two: u32,
    /// How many points there are: two for faces, one for corners.
    pub count: u32,
    /// As [`meet`](crate::plane::meet) gave it for the pair (lower id, higher id).
    pub meeting: Meeting,
    pub memory: [Memory; 2],
    /// The longest that a point of the joint may come to stand for [m]: half the distance between its two points when
    /// they were last looked at, at least the least length; the given length where one is given.
    pub half_joint: f64,
    /// Elastic energy of a distributed pressure [J/m]; none where points press.
    pub stored: Option<f64>,
    /// What is left of the bond under a distributed pressure; points remember their own.
    pub bond: Bond,
    /// Unit vector of the reference edge, in the frame of `one`.
    direction: Vec2,
    /// Start of the reference edge (or the corner) of `one`: along the edge, and outwards across it.
    along: f64,
    across: f64,
    edge_length: f64,
    /// Ends of the incident edge (or the corner) in the frame of `two`, as met along the reference edge.
    low: Vec2,
    high: Vec2,
    radius_one: f64,
    radii: f64,
    /// Stiffnesses per unit area [Pa/m].
    pub normal_stiffness: f64,
    pub shear_stiffness: f64,
    friction: f64,
    cohesion: f64,
    tension: f64,
    crushing: f64,
    pub least_length: f64,
}

/// Where the points of a touch are now, seen along the reference edge: `s` runs along `direction` from the edge's
/// start, and the normal is `direction` turned right.
#[derive(Debug, Clone, Copy)]
pub(super) struct Points {
    /// Unit tangent; the normal, from `one` to `two`, is `direction.right()`.
    pub direction: Vec2,
    /// Start of the edge relative to the centre of `one`, along and across the edge [m].
    along: f64,
    across: f64,
    /// Centre of `two` relative to the centre of `one`, along and across the edge [m].
    between: Vec2,
    /// Place of each point along the edge [m].
    s: [f64; 2],
    /// Direction in which each point pushes `two`, along and across the edge, and the height above the core's edge at
    /// which the tangential part of it acts.
    pushes: [Vec2; 2],
    heights: [f64; 2],
    /// Overlap [m], positive when closed.
    pub overlap: [f64; 2],
    radius_one: f64,
}

impl Points {
    /// Unit normal from `one` to `two`.
    pub(super) fn normal(&self) -> Vec2 {
        self.direction.right()
    }
    /// Force on `two` per unit of compression at point `k`.
    pub(super) fn push(&self, k: usize) -> Vec2 {
        self.normal() * self.pushes[k].y + self.direction * self.pushes[k].x
    }
    /// Distance between the two points along the edge [m].
    pub(super) fn stretch(&self) -> f64 {
        self.s[1] - self.s[0]
    }
    /// Point `k` [m], midway between the two surfaces, for `one` placed at `centre`.
    pub(super) fn at(&self, k: usize, centre: Vec2) -> Vec2 {
        centre + self.direction * (self.along + self.s[k]) + self.normal() * (self.across + self.lift(k))
    }
    /// Height of point `k` above the core's edge [m].
    #[inline(always)]
    fn lift(&self, k: usize) -> f64 {
        self.radius_one - 0.5 * self.overlap[k]
    }
}

impl Touch {
    /// A touch of the pair (`a`, `b`), `a < b`, with nothing remembered.
    pub(super) fn new(
        ids: (u32, u32),
        meeting: Meeting,
        cores: (&Core, &Core),
        law: &ContactLaw,
        distance: f64,
    ) -> Touch {
        let (a, b) = cores;
        let flipped = matches!(meeting, Meeting::Face { flipped: true, .. });
        let (one, two, r, i) = if flipped { (ids.1, ids.0, b, a) } else { (ids.0, ids.1, a, b) };
        let (start, direction, edge_length, low, high, count) = match meeting {
            Meeting::Face { reference, incident, .. } => {
                let (e, k) = (reference as usize, incident as usize);
                (r.vertices[e], r.directions[e], r.lengths[e], i.vertices[i.next(k)], i.vertices[k], 2)
            }
            Meeting::Corner { first, second } => {
                let (p, q) = (a.vertices[first as usize], b.vertices[second as usize]);
                (p, vec2(1.0, 0.0), 0.0, q, q, 1)
            }
        };
        Touch {
            one,
            two,
            count,
            meeting,
            memory: [Memory::default(); 2],
            half_joint: law.least_length,
            stored: None,
            bond: Bond::GONE,
            along: start.dot(direction),
            across: start.dot(direction.right()),
            direction,
            edge_length,
            low,
            high,
            radius_one: r.radius,
            radii: a.radius + b.radius,
            normal_stiffness: law.normal.at(distance),
            shear_stiffness: law.shear.at(distance),
            friction: law.friction,
            cohesion: law.cohesion,
            tension: law.tension,
            crushing: law.crushing,
            least_length: law.least_length,
        }
    }

    /// Lower and higher id.
    pub(super) fn ids(&self) -> (u32, u32) {
        (self.one.min(self.two), self.one.max(self.two))
    }

    /// Where the points are now.
    #[inline(always)]
    pub(super) fn points(&self, one: &Pose, two: &Pose) -> Points {
        if self.count == 1 {
            return self.corner_points(one, two);
        }
        let direction = one.rotation.turn(self.direction);
        let normal = direction.right();
        let apart = two.position - one.position;
        let between = vec2(apart.dot(direction), apart.dot(normal));
        // Rotation of `two` seen from the edge: first row along it, second row across it.
        let (c2, s2) = (two.rotation.cos, two.rotation.sin);
        let row_s = vec2(direction.x * c2 + direction.y * s2, direction.y * c2 - direction.x * s2);
        let row_g = vec2(normal.x * c2 + normal.y * s2, normal.y * c2 - normal.x * s2);
        let (from_s, from_g) = (between.x - self.along, between.y - self.across);
        let (low_s, low_g) = (from_s + row_s.dot(self.low), from_g + row_g.dot(self.low));
        let (high_s, high_g) = (from_s + row_s.dot(self.high), from_g + row_g.dot(self.high));
        let slope = (high_g - low_g) / (high_s - low_s).max(1e-300);
        let low = end(low_s, low_g, slope, self.edge_length);
        let high = end(self.edge_length - high_s, high_g, -slope, self.edge_length);
        Points {
            direction,
            along: self.along,
            across: self.across,
            between,
            s: [low.inset, self.edge_length - high.inset],
            pushes: [low.push, vec2(-high.push.x, high.push.y)],
            heights: [low.height, high.height],
            overlap: [self.radii - low.distance, self.radii - high.distance],
            radius_one: self.radius_one,
        }
    }

    fn corner_points(&self, one: &Pose, two: &Pose) -> Points {
        let arm = one.rotation.turn(self.direction * self.along + self.direction.right() * self.across);
        let corner = one.position + arm;
        let apart = two.place(self.low) - corner;
        let distance = apart.norm();
        let normal = if distance > 1e-300 { apart * (1.0 / distance) } else { vec2(0.0, 1.0) };
        let direction = normal.left();
        let centres = two.position - one.position;
        Points {
            direction,
            along: arm.dot(direction),
            across: arm.dot(normal),
            between: vec2(centres.dot(direction), centres.dot(normal)),
            s: [0.0; 2],
            pushes: [vec2(0.0, 1.0); 2],
            heights: [0.0; 2],
            overlap: [self.radii - distance; 2],
            radius_one: self.radius_one,
        }
    }

    /// Lengths that the two points stand for in the stress formulation [m]: half the joint each where the other end
    /// holds, in compression or by its bond; where the other end is open, half the part that is compressed or bonded, so
    /// that the linear stress over a compressed part and the point force agree. Never more than half the joint, never
    /// below the least length.
    #[inline]
    fn update_lengths(&mut self, points: &Points) {
        let half = if self.count == 1 { 0.0 } else { 0.5 * points.stretch() };
        // The opening that a bond still carries [m].
        let carried = |m: &Memory| if m.bonded { self.tension / self.normal_stiffness } else { 0.0 };
        let reach = [carried(&self.memory[0]), carried(&self.memory[1])];
        let part = |k: usize, other: usize| {
            let (here, there) = (points.overlap[k], points.overlap[other]);
            if there >= 0.0 || there + reach[other] > 0.0 {
                return half;
            }
            // Overlap is linear along the joint; it falls to what the bond here carries at this share of the joint.
            let share = (here + reach[k]) / (here - there);
            if here > there { half * share.clamp(0.0, 1.0) } else { half }
        };
        let lengths = [part(0, 1), part(1, 0)];
        for (memory, length) in self.memory.iter_mut().zip(lengths) {
            memory.length = length.max(self.least_length);
        }
    }

    /// What the touch does to its blocks after a step of `dt` in which they moved with the given velocities.
    ///
    /// Arms cross the edge's axes without trigonometry: with `n` and `d` the normal and the tangent, a point `s`
    /// along the edge and `h` above it has `arm x n = -(along + s)` and `arm x d = across + h` about the centre of
    /// `one`.
    #[inline(always)]
    pub(super) fn resist<const UPDATED: bool>(
        &mut self,
        bodies: (&Pose, &Pose),
        velocities: Velocities,
        dt: f64,
    ) -> Option<Reaction> {
        let points = self.points(bodies.0, bodies.1);
        let open = points.overlap[0] <= 0.0 && points.overlap[1] <= 0.0;
        if open && self.tension <= 0.0 {
            if !(self.memory[0].closed || self.memory[1].closed) {
                return None;
            }
            return Some(Reaction { dissipated: self.forget(), ..Reaction::default() });
        }
        if UPDATED {
            self.update_lengths(&points);
        }
        let (v1, v2) = velocities;
        let relative = vec2(v2[0] - v1[0], v2[1] - v1[1]);
        let glide = relative.dot(points.direction);
        let (mut compression, mut shear) = (0.0, 0.0);
        let mut reaction = Reaction::default();
        // Always two rounds, so that the loop is unrolled; an open or missing point costs one comparison.
        for k in 0..2 {
            if points.overlap[k] <= 0.0 && self.tension <= 0.0 || k == 1 && self.count == 1 {
                reaction.dissipated += self.open(k);
                continue;
            }
            let Some((n, s)) =
                self.point_force(k, &points, (glide, relative), (v1[2], v2[2]), (dt, &mut reaction.dissipated))
            else {
                continue;
            };
            let one_n = -(points.along + points.s[k]);
            let one_d = points.across + points.lift(k);
            let (push, height) = (points.pushes[k], points.across + points.heights[k]);
            let (across, along) = (n * push.y, n * push.x);
            compression += across;
            shear += s + along;
            reaction.on_one -= across * one_n + s * one_d + along * height;
            reaction.on_two += across * (one_n + points.between.x)
                + s * (one_d - points.between.y)
                + along * (height - points.between.y);
        }
        reaction.force = points.normal() * compression + points.direction * shear;
        Some(reaction)
    }

    /// The same for a pressure that is spread over the compressed part of a common face. A corner presses in its point.
    pub(super) fn resist_distributed(
        &mut self,
        bodies: (&Pose, &Pose),
        velocities: Velocities,
        dt: f64,
    ) -> Option<Reaction> {
        if self.count == 1 {
            return self.resist::<true>(bodies, velocities, dt);
        }
        let points = self.points(bodies.0, bodies.1);
        let law = self.resistance();
        let length = points.stretch().max(0.0);
        let mut reaction = Reaction::default();
        if law.tension > 0.0 && self.bond.holds() {
            // What breaks loses the energy that it holds at its strength.
            let left = law.left(points.overlap, &self.bond);
            let unbroken = Resistance { tension: f64::INFINITY, ..law };
            let energy = |bond: &Bond| unbroken.energy(points.overlap, length, bond);
            reaction.dissipated += energy(&self.bond) - energy(&left);
            self.bond = left;
        }
        let ends = law.ends(ContactLength::Distributed, points.overlap, length, &self.bond);
        self.stored = Some(law.energy(points.overlap, length, &self.bond));
        let (v1, v2) = velocities;
        let glide = vec2(v2[0] - v1[0], v2[1] - v1[1]).dot(points.direction);
        let (mut compression, mut shear) = (0.0, 0.0);
        for k in 0..2 {
            let (n, now) = (ends.compression[k], ends.length[k]);
            if now <= 0.0 {
                // What a bond held is in the account already.
                self.memory[k].compression = self.memory[k].compression.max(0.0);
                reaction.dissipated += self.open(k);
                continue;
            }
            let one_n = -(points.along + points.s[k]);
            let one_d = points.across + points.lift(k);
            let slip_rate = glide + v2[2] * (one_d - points.between.y) - v1[2] * one_d;
            let memory = &mut self.memory[k];
            let stiffness = law.shear * now;
            // What is sheared stays so where the compressed part grows or shrinks; its energy goes with the length.
            let sheared = if memory.closed { memory.shear / (law.shear * memory.length) } else { 0.0 };
            let released =
                if memory.closed { 0.5 * law.shear * sheared * sheared * (memory.length - now) } else { 0.0 };
            let trial = stiffness * (sheared - slip_rate * dt);
            let cap = ends.shear_strength(k, &law);
            let force = trial.clamp(-cap, cap);
            reaction.dissipated += released - 0.5 * (stiffness * sheared + force) * (force - trial) / stiffness;
            *memory = Memory {
                shear: force,
                compression: n,
                length: now,
                closed: true,
                sliding: trial.abs() > cap,
                ..Memory::default()
            };
            compression += n;
            shear += force;
            reaction.on_one -= n * one_n + force * one_d;
            reaction.on_two += n * (one_n + points.between.x) + force * (one_d - points.between.y);
        }
        reaction.force = points.normal() * compression + points.direction * shear;
        Some(reaction)
    }

    /// The law of the pair with the numbers of this touch.
    fn resistance(&self) -> Resistance {
        Resistance {
            normal: self.normal_stiffness,
            shear: self.shear_stiffness,
            friction: self.friction,
            cohesion: self.cohesion,
            crushing: self.crushing,
            tension: self.tension,
            fixed_length: None,
            least_length: self.least_length,
        }
    }

    /// Compression and shear of point `k`, or nothing if it is open.
    #[inline(always)]
    fn point_force(
        &mut self,
        k: usize,
        points: &Points,
        (glide, relative): (f64, Vec2),
        spins: (f64, f64),
        (dt, dissipated): (f64, &mut f64),
    ) -> Option<(f64, f64)> {
        let memory = &mut self.memory[k];
        let length = memory.length;
        let mut stress = self.normal_stiffness * (points.overlap[k] - memory.crushed);
        let least = if memory.bonded { -self.tension } else { 0.0 };
        if stress <= least {
            *dissipated += self.open(k);
            return None;
        }
        if stress > self.crushing {
            let crushed = points.overlap[k] - self.crushing / self.normal_stiffness;
            *dissipated += self.crushing * length * (crushed - memory.crushed);
            memory.crushed = crushed;
            stress = self.crushing;
        }
        let mut compression = stress * length;
        // A point that closed or will open within one step pushes for a part of the step only; with this force it gives
        // back just the energy that its overlap holds.
        let opens = 2.0 * compression < memory.compression;
        if (opens || !memory.closed) && least == 0.0 {
            let one_n = -(points.along + points.s[k]);
            let spin = spins.1 * (one_n + points.between.x) - spins.0 * one_n;
            let moved = (relative.dot(points.normal()) + spin).abs() * dt;
            let overlap = points.overlap[k] - memory.crushed;
            if overlap < moved {
                compression *= 0.5 * (1.0 + overlap / moved);
            }
        }
        let one_d = points.across + points.lift(k);
        let slip_rate = glide + spins.1 * (one_d - points.between.y) - spins.0 * one_d;
        let stiffness = self.shear_stiffness * length;
        let trial = memory.shear - stiffness * slip_rate * dt;
        let cap = self.cohesion * length + self.friction * compression.max(0.0);
        memory.sliding = trial.abs() > cap;
        let shear = if memory.sliding {
            let shear = trial.clamp(-cap, cap);
            // What the spring cannot hold slides, against the mean of the old and the new force.
            *dissipated -= 0.5 * (memory.shear + shear) * (shear - trial) / stiffness;
            shear
        } else {
            trial
        };
        memory.shear = shear;
        memory.compression = compression;
        memory.closed = true;
        Some((compression, shear))
    }

    /// Opens point `k`; returns the elastic shear energy that is lost with it [J/m].
    #[inline]
    pub(super) fn open(&mut self, k: usize) -> f64 {
        let m = &mut self.memory[k];
        // What never touched has no bond either.
        m.bonded = false;
        if !m.closed {
            return 0.0;
        }
        let lost = if m.length > 0.0 { 0.5 * m.shear * m.shear / (self.shear_stiffness * m.length) } else { 0.0 };
        m.shear = 0.0;
        // A bond that breaks in tension loses its normal energy too.
        let broken = m.compression.min(0.0);
        let lost = if broken < 0.0 { lost + 0.5 * broken * broken / (self.normal_stiffness * m.length) } else { lost };
        m.compression = 0.0;
        m.closed = false;
        m.sliding = false;
        lost
    }

    /// Elastic energy of the closed points [J/m].
    pub(super) fn elastic_energy(&self) -> f64 {
        let of_points = |m: &Memory| match self.stored {
            Some(_) => 0.0,
            None => m.compression * m.compression / self.normal_stiffness,
        };
        let closed = self.memory.iter().filter(|m| m.closed && m.length > 0.0);
        let each = closed.map(|m| 0.5 * (of_points(m) + m.shear * m.shear / self.shear_stiffness) / m.length);
        self.stored.unwrap_or(0.0) + each.sum::<f64>()
    }

    /// Opens both points for good; returns the elastic shear energy lost with them [J/m].
    pub(super) fn forget(&mut self) -> f64 {
        self.open(0) + self.open(1)
    }
}
