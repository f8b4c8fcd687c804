//! The continuum with a strength, and with loads on its upper face.

use super::{Against, Earth, Edge, INTERFACE_SHARE, LoadedEarth, Material, NEAR, SNAP, Strength};
use crate::discretise::dispersal::Strip;
use crate::discretise::{DiscretiseError, Discretised};
use bridge::FillEnds;
use mechanics::blocks::{Block, Held, Loading, PointForce};
use mechanics::ids::GroupId;
use mechanics::limit::continuum::{Bears, Contact, Continuum, Region, Side, Soil};
use mechanics::plane::{Polygon, Vec2, vec2};

/// Height of the plate under a load [m], for drawings.
const PLATE: f64 = 0.1;

/// Mass density of plates [kg/m^3]: nothing beside any load.
const WEIGHTLESS: f64 = 1e-6;

/// Shortest length of a load on the surface [m].
const LEAST_STRIP: f64 = 0.01;

impl Earth {
    /// The continuum with a strength, and with loads on its upper face. Wheels and beams stand on a rigid plate as long as their strip, free to
    /// sink, slide and turn: the soil decides where it presses, and the resultant stays where the load is. A pressure that must be uniform
    /// would fail at the edges of its strip before the soil below it does. Loads whose strips meet share a plate. Pressures stay uniform:
    /// a plate under one would carry it over what is weak below. Pressure of fill on backs
    /// ([`super::pressure::restraints`]) must not be added.
    ///
    /// # Errors
    /// A strip without length.
    pub fn loaded(
        &self,
        discretised: &Discretised,
        strength: Strength,
        strips: &[Strip],
    ) -> Result<LoadedEarth, DiscretiseError> {
        let plates = self.plates(strips)?;
        let mut model = discretised.model.clone();
        let mut loading = Loading { movements: discretised.loading.movements.clone(), ..Loading::default() };
        let group = model.blocks.iter().next().map_or(GroupId(0), |b| b.group);
        let mut blocks = Vec::with_capacity(plates.on.len());
        for plate in &plates.on {
            let [a, b] = plate.ends;
            let outline = Polygon::rectangle(vec2(a, self.top), b - a, PLATE)
                .map_err(|_| DiscretiseError::PointLoadOnContinuum { x: plate.at, length: b - a })?;
            let block =
                model.blocks.push(Block { outline, rounding: 0.0, density: WEIGHTLESS, group, held: Held::FREE });
            let down = |force: f64, x: f64| PointForce { block, at: vec2(x, self.top), force: vec2(0.0, -force) };
            loading.variable.push(down(plate.force, plate.at));
            if self.surcharge > 0.0 {
                loading.permanent.push(down(self.surcharge * (b - a), 0.5 * (a + b)));
            }
            blocks.push(block);
        }
        let mut regions = Vec::new();
        let mut sides: Vec<Side> = self.edges.iter().filter_map(|edge| self.side(edge, strength)).collect();
        for piece in &self.pieces {
            let mut outline = piece.outline.clone();
            if piece.surface
                && let (Some(&left), Some(&right)) = (outline.first(), outline.last())
            {
                let inner = plates.marks.iter().filter(|x| left.x + NEAR < **x && **x < right.x - NEAR);
                let at = |x: f64| left + (right - left) * ((x - left.x) / (right.x - left.x));
                outline.extend(inner.rev().map(|x| vec2(*x, at(*x).y)));
                let along: Vec<Vec2> = outline[piece.outline.len() - 1..].iter().copied().chain([left]).collect();
                let contact = self.contact(piece.material, strength);
                for pair in along.windows(2) {
                    let middle = 0.5 * (pair[0].x + pair[1].x);
                    let plate = plates.on.iter().position(|p| p.ends[0] < middle && middle < p.ends[1]);
                    let bears = match plate {
                        Some(plate) => Bears::Body { block: Some(blocks[plate]), contact },
                        None => Bears::Load {
                            permanent: vec2(0.0, -self.surcharge),
                            variable: vec2(0.0, -plates.pressure(middle)),
                        },
                    };
                    sides.push(Side { ends: [pair[0], pair[1]], bears });
                }
            }
            regions.push(Region { outline, soil: self.soil(piece.material, strength) });
        }
        let continuum = Continuum { regions, sides, water: self.water, panels: self.panels.clone() };
        Ok(LoadedEarth { continuum, model, loading, left_out: plates.left_out })
    }

    fn soil(&self, material: usize, strength: Strength) -> Soil {
        self.materials[material].soil.reduced(strength.share, strength.dilatancy)
    }

    /// A side of the boundary; none where it is free.
    fn side(&self, edge: &Edge, strength: Strength) -> Option<Side> {
        let contact = self.contact(edge.material, strength);
        let (block, contact) = match (edge.against, self.plan.ends) {
            (Against::Block(block), _) => (Some(block), contact),
            (Against::Ground, _) | (Against::End, FillEnds::Hold) => (None, contact),
            (Against::End, FillEnds::Slide) => (None, Contact { friction: 0.0, cohesion: 0.0, tension: 0.0 }),
            (Against::End, FillEnds::Free) => return None,
        };
        Some(Side { ends: edge.ends, bears: Bears::Body { block, contact } })
    }

    /// How a material resists where it touches masonry or ground. The interface is reduced as the soil is; it is never stronger.
    pub(super) fn contact(&self, material: usize, strength: Strength) -> Contact {
        let Material { soil, bonded } = self.materials[material];
        let reduced = self.soil(material, strength);
        if bonded {
            return Contact { friction: reduced.friction_angle.tan(), cohesion: reduced.cohesion, tension: 0.0 };
        }
        let whole = self.plan.interface_friction_angle.unwrap_or(INTERFACE_SHARE * soil.friction_angle);
        // What is left of one pascal of cohesion is the factor on all strength.
        let factor = Soil { cohesion: 1.0, ..soil }.reduced(strength.share, strength.dilatancy).cohesion;
        Contact {
            friction: factor * whole.min(soil.friction_angle).tan(),
            cohesion: factor * self.plan.interface_cohesion.min(soil.cohesion),
            tension: 0.0,
        }
    }

    /// The plates of strips on the upper face.
    fn plates(&self, strips: &[Strip]) -> Result<Plates, DiscretiseError> {
        let corners = self.pieces.iter().filter(|piece| piece.surface).flat_map(|piece| {
            let ends = [piece.outline.first(), piece.outline.last()];
            ends.into_iter().flatten().map(|p| p.x)
        });
        let mut marks: Vec<f64> = corners.collect();
        let (mut on, mut pressures): (Vec<Plate>, Vec<Plate>) = (Vec::new(), Vec::new());
        let (mut total, mut left_out) = (0.0, 0.0);
        for strip in strips {
            if !(strip.length >= LEAST_STRIP) {
                return Err(DiscretiseError::PointLoadOnContinuum { x: strip.middle, length: strip.length });
            }
            total += strip.force;
            let half = 0.5 * strip.length;
            let [from, to] = [strip.middle - half, strip.middle + half].map(|x| x.clamp(self.ends[0], self.ends[1]));
            let [a, b] = [from, to].map(|x| {
                let nearest = marks.iter().copied().min_by(|p, q| (p - x).abs().total_cmp(&(q - x).abs()));
                nearest.filter(|mark| (mark - x).abs() < SNAP).unwrap_or_else(|| {
                    marks.push(x);
                    x
                })
            });
            let inside = if b > a { strip.force * (to - from) / strip.length } else { 0.0 };
            left_out += strip.force - inside;
            let plate = Plate { ends: [a, b], force: inside, at: 0.5 * (from + to) };
            match strip.is_pressure {
                _ if b <= a => {}
                true => pressures.push(plate),
                false => on.push(plate),
            }
        }
        marks.sort_by(f64::total_cmp);
        marks.dedup();
        on.sort_by(|p, q| p.ends[0].total_cmp(&q.ends[0]));
        let mut merged: Vec<Plate> = Vec::with_capacity(on.len());
        for plate in on {
            match merged.last_mut() {
                Some(last) if plate.ends[0] <= last.ends[1] => last.join(plate),
                _ => merged.push(plate),
            }
        }
        // A pressure that meets a plate presses on it.
        for plate in &mut merged {
            for pressure in &pressures {
                let [a, b] = [plate.ends[0].max(pressure.ends[0]), plate.ends[1].min(pressure.ends[1])];
                if b > a {
                    plate.join(Plate { ends: [a, b], force: pressure.mean() * (b - a), at: 0.5 * (a + b) });
                }
            }
        }
        let left_out = if total > 0.0 { left_out / total } else { 0.0 };
        Ok(Plates { marks, on: merged, pressures, left_out })
    }
}

/// Plates on the upper face.
struct Plates {
    /// Corners of the upper face and ends of loads, from left to right [m].
    marks: Vec<f64>,
    /// From left to right.
    on: Vec<Plate>,
    /// Pressures that follow the ground, in the order of the loads.
    pressures: Vec<Plate>,
    /// Share of the loads that stands beyond the ends.
    left_out: f64,
}

/// A rigid plate under loads.
#[derive(Debug, Clone, Copy)]
struct Plate {
    /// Its ends [m].
    ends: [f64; 2],
    /// The resultant of its loads [N/m].
    force: f64,
    /// Where it acts [m].
    at: f64,
}

impl Plates {
    /// Sum of the pressures at a place where no plate stands [Pa].
    fn pressure(&self, x: f64) -> f64 {
        self.pressures.iter().filter(|p| p.ends[0] < x && x < p.ends[1]).map(Plate::mean).sum()
    }
}

impl Plate {
    /// Mean pressure [Pa].
    fn mean(&self) -> f64 {
        self.force / (self.ends[1] - self.ends[0])
    }
    fn join(&mut self, other: Plate) {
        let force = self.force + other.force;
        if force != 0.0 {
            self.at = (self.force * self.at + other.force * other.at) / force;
        }
        self.force = force;
        self.ends[1] = self.ends[1].max(other.ends[1]);
    }
}
