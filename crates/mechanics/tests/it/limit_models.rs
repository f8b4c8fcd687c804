//! Block models that several tests of limit analysis share, made by hand from their published dimensions.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// A dry joint with a coefficient of friction.
pub(crate) fn dry(friction: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(1e9),
        shear: Stiffness::Given(1e8),
        friction,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 0.0,
    }
}

pub(crate) fn block(outline: Polygon, rounding: f64, density: f64, held: Held) -> Block {
    Block { outline, rounding, density, group: GroupId(0), held }
}

pub(crate) fn model(blocks: Vec<Block>, law: ContactLaw) -> BlockModel {
    BlockModel {
        blocks: blocks.into_iter().collect(),
        particles: Table::default(),
        groups: ["block".to_string()].into_iter().collect(),
        laws: LawTable::uniform(1, law),
        gravity: vec2(0.0, -9.81),
    }
}

/// A circular ring of equal flat-faced voussoirs between two held ones. Blocks 0 and `voussoirs + 1` are the supports.
pub(crate) struct Ring {
    pub intrados: f64,
    pub thickness: f64,
    pub half_angle: f64,
    pub voussoirs: usize,
    pub rounding: f64,
    pub density: f64,
    pub friction: f64,
}

impl Ring {
    /// Bridgemill: span 18.30 m and rise 2.85 m of the intrados, 62 voussoirs, ring 0.711 m, tan 35.6 degrees.
    pub(crate) fn bridgemill() -> Ring {
        let (span, rise) = (18.30f64, 2.85f64);
        let intrados = (span * span / 4.0 + rise * rise) / (2.0 * rise);
        Ring {
            intrados,
            thickness: 0.711,
            half_angle: (span / 2.0 / intrados).asin(),
            voussoirs: 62,
            rounding: 0.01,
            density: 2100.0,
            friction: 35.6f64.to_radians().tan(),
        }
    }
    /// Semicircular, of mean radius 1 m.
    pub(crate) fn semicircle(voussoirs: usize, thickness: f64, friction: f64) -> Ring {
        Ring {
            intrados: 1.0 - thickness / 2.0,
            thickness,
            half_angle: std::f64::consts::FRAC_PI_2,
            voussoirs,
            rounding: 0.0,
            density: 2000.0,
            friction,
        }
    }
    pub(crate) fn extrados(&self) -> f64 {
        self.intrados + self.thickness
    }
    /// Point of joint `k` at radius `r`; joints run from the left springing (0) to the right one; centre of the circle
    /// at the origin.
    pub(crate) fn at(&self, k: f64, r: f64) -> Vec2 {
        let angle = -self.half_angle + 2.0 * self.half_angle * k / self.voussoirs as f64;
        vec2(r * angle.sin(), r * angle.cos())
    }
    pub(crate) fn model(&self) -> BlockModel {
        let (low, high) = (self.intrados, self.extrados());
        let blocks = (-1..=self.voussoirs as i32)
            .map(|i| {
                let (a, b) = (f64::from(i), f64::from(i + 1));
                let outline = Polygon::new(vec![self.at(a, low), self.at(b, low), self.at(b, high), self.at(a, high)]);
                let held = if i < 0 || i == self.voussoirs as i32 { Held::FIXED } else { Held::FREE };
                block(outline.unwrap(), self.rounding, self.density, held)
            })
            .collect();
        model(blocks, dry(self.friction))
    }
    /// What true sectors weigh and where, as permanent forces: use with gravity switched off. The flat-faced
    /// outlines stay as geometry, their joints are the same.
    pub(crate) fn sector_weights(&self) -> Vec<PointForce> {
        let (low, high) = (self.intrados, self.extrados());
        let half = self.half_angle / self.voussoirs as f64;
        let area = half * (high * high - low * low);
        let radius = 2.0 / 3.0 * (half.sin() / half) * (high.powi(3) - low.powi(3)) / (high * high - low * low);
        (0..self.voussoirs)
            .map(|i| PointForce {
                block: BlockId::new(i + 1),
                at: self.at(i as f64 + 0.5, radius),
                force: vec2(0.0, -9.81 * self.density * area),
            })
            .collect()
    }
    /// A vertical line load on the extrados between the joints, lumped with its exact resultant and place on each
    /// voussoir's chord: total 1 between `from` and `to` [m], proportional to the given ordinates at its ends.
    pub(crate) fn lumped(&self, from: (f64, f64), to: (f64, f64)) -> Vec<PointForce> {
        let mut forces = Vec::new();
        let intensity = |x: f64| from.1 + (to.1 - from.1) * (x - from.0) / (to.0 - from.0);
        let total = 0.5 * (from.1 + to.1) * (to.0 - from.0);
        for i in 0..self.voussoirs {
            let (p, q) = (self.at(i as f64, self.extrados()), self.at(i as f64 + 1.0, self.extrados()));
            let (a, b) = (p.x.max(from.0), q.x.min(to.0));
            if a >= b {
                continue;
            }
            let (qa, qb) = (intensity(a) / total, intensity(b) / total);
            let force = 0.5 * (qa + qb) * (b - a);
            let x = a + (b - a) * (qa + 2.0 * qb) / (3.0 * (qa + qb));
            let y = p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x);
            forces.push(PointForce { block: BlockId::new(i + 1), at: vec2(x, y), force: vec2(0.0, -force) });
        }
        forces
    }
    /// The weight of fill above the extrados up to a level `cover` [m] above the crown, lumped like a line load.
    pub(crate) fn fill(&self, cover: f64, density: f64) -> Vec<PointForce> {
        let level = self.extrados() + cover;
        let column = |i: usize| {
            let (p, q) = (self.at(i as f64, self.extrados()), self.at(i as f64 + 1.0, self.extrados()));
            let (a, b) = (level - p.y, level - q.y);
            let weight = 9.81 * density * 0.5 * (a + b) * (q.x - p.x);
            let share = (a + 2.0 * b) / (3.0 * (a + b));
            let at = p + (q - p) * share;
            PointForce { block: BlockId::new(i + 1), at, force: vec2(0.0, -weight) }
        };
        (0..self.voussoirs).map(column).collect()
    }
    /// A unit knife load on the road, dispersed two down to one across on to the extrados, its intensity inverse to
    /// the depth at both ends (Rouxinol, Providência and Lemos, eq. 2).
    pub(crate) fn dispersed_knife(&self, middle: f64, length: f64, cover: f64) -> Vec<PointForce> {
        let road = self.extrados() + cover;
        let foot = |start: f64, side: f64| {
            let mut depth = cover;
            for _ in 0..200 {
                let x = start + side * depth / 2.0;
                depth = road - (self.extrados().powi(2) - x * x).sqrt();
            }
            (start + side * depth / 2.0, 1.0 / depth)
        };
        self.lumped(foot(middle - length / 2.0, -1.0), foot(middle + length / 2.0, 1.0))
    }
    /// Bridgemill's test load: 0.75 m long at the quarter of the intrados span, 0.478 m above the crown.
    pub(crate) fn quarter_knife(&self) -> Loading {
        let x = 4.575 - 9.15;
        Loading { variable: self.dispersed_knife(x, 0.75, 0.478), ..Loading::default() }
    }
}

/// A wall of courses from the bottom up; a length is in units of `unit` [m], a negative one leaves an opening. Block 0
/// is the ground. Every block is pushed sideways by its own weight times the load factor.
pub(crate) fn wall(courses: &[&[f64]], unit: f64, height: f64, friction: f64) -> (BlockModel, Loading) {
    let width: f64 = courses[0].iter().map(|l| l.abs() * unit).sum();
    let ground = Polygon::rectangle(vec2(-1.0, -0.5), width + 2.0, 0.5).unwrap();
    let mut blocks = vec![block(ground, 0.0, 1.0, Held::FIXED)];
    for (level, course) in courses.iter().enumerate() {
        let mut x = 0.0;
        for &length in *course {
            if length > 0.0 {
                let corner = vec2(x * unit, level as f64 * height);
                let outline = Polygon::rectangle(corner, length * unit, height).unwrap();
                blocks.push(block(outline, 0.0, 2000.0, Held::FREE));
            }
            x += length.abs();
        }
    }
    let model = model(blocks, dry(friction));
    let loading = Loading { variable: sideways(&model), ..Loading::default() };
    (model, loading)
}

/// The weight of every free block, turned to the right.
pub(crate) fn sideways(model: &BlockModel) -> Vec<PointForce> {
    model
        .blocks
        .pairs()
        .filter(|(_, b)| !b.held.is_fixed())
        .map(|(id, b)| PointForce {
            block: id,
            at: b.outline.centroid(),
            force: vec2(b.mass() * model.gravity.norm(), 0.0),
        })
        .collect()
}
