//! What lies between blocks, a little elastic: a joint, or a force that answers movement.
//!
//! With the elastic forces `y = -k d` of its deformations `d`, a joint carries the compressions nearest to the elastic ones of all that it can
//! carry ([`Shape`]), and the elastic shear as far as friction on those compressions and cohesion allow it: sliding does not dilate.
//! Forces depend on where blocks are and on no other state, and they are linear in pieces.

use super::shape::{Part, Shape};
use crate::plane::vec2;

/// Whether a joint slides, and to which side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sliding {
    Sticks,
    /// Shear is at its positive limit.
    Positive,
    Negative,
}

/// A piece of the law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Piece {
    pub normal: Part,
    pub sliding: Sliding,
}

impl Piece {
    /// Nothing opens, crushes or slides.
    pub(super) const BONDED: Piece = Piece { normal: Part::Inside, sliding: Sliding::Sticks };
}

/// The next piece on a way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Event {
    /// After how much of the way.
    pub after: f64,
    pub to: Piece,
    /// Grows by the elastic forces on the way to the change and beyond.
    pub onward: [f64; 3],
}

/// Compressions that an element can have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Normal {
    /// One of them, between two bounds.
    One([f64; 2]),
    /// Two: the number of the shape and its unit.
    Two { shape: usize, unit: f64 },
}

/// An element between blocks. Forces are scaled, deformations open it.
#[derive(Debug, Clone)]
pub(super) struct Element {
    /// First of its forces among all.
    pub column: usize,
    /// How many of them there are: compressions, then the shear of a joint.
    pub forces: usize,
    /// Equations of its blocks; beside fewer than six the first of all, in which it has no part.
    pub equations: [u32; 6],
    /// Part of each force in each equation, force by force: compressions, then the shear in the third place.
    pub parts: [[f64; 6]; 3],
    /// Of compressions and of shear; no shear for a force that answers movement.
    pub stiffness: [f64; 3],
    pub normal: Normal,
    /// Coefficient of friction; infinite where nothing slides.
    pub friction: f64,
    /// Shear without compression.
    pub cohesion: f64,
}

impl Element {
    /// Whether it only goes on from one chord of crushing to the next.
    pub(super) fn goes_on_crushing(&self, shapes: &[Shape], from: Piece, to: Piece) -> bool {
        let both_crush = from.normal != Part::Inside && to.normal != Part::Inside;
        both_crush
            && from.sliding == to.sliding
            && matches!(self.normal, Normal::Two { shape, .. } if shapes[shape].crushes())
    }

    /// Elastic forces of displacements.
    pub(super) fn elastic(&self, displacements: &[f64]) -> [f64; 3] {
        let moved = self.equations.map(|equation| displacements[equation as usize]);
        std::array::from_fn(|k| {
            let opening: f64 = self.parts[k].iter().zip(moved).map(|(part, moved)| part * moved).sum();
            -self.stiffness[k] * opening
        })
    }

    /// How much bond a joint needs to be elastic under these forces: a compression at each of its contact points.
    pub(super) fn bond(&self, elastic: [f64; 3]) -> f64 {
        let points = self.forces.saturating_sub(1) as f64;
        if points == 0.0 {
            return 0.0;
        }
        let opens = elastic[..self.forces - 1].iter().fold(0.0f64, |most, force| most.max(-force));
        let slides = match self.friction {
            friction if friction.is_finite() && friction > 0.0 => {
                (elastic[2].abs() - self.cohesion) / friction - elastic[0] - elastic[1]
            }
            _ => 0.0,
        };
        opens.max(slides / points)
    }

    /// Elastic forces that are added to those of a joint by so much bond.
    pub(super) fn bound_by(&self, bond: f64) -> [f64; 3] {
        match self.forces {
            3 => [bond, bond, 0.0],
            2 => [bond, 0.0, 0.0],
            _ => [0.0; 3],
        }
    }

    /// The piece of elastic forces.
    pub(super) fn piece(&self, shapes: &[Shape], elastic: [f64; 3]) -> Piece {
        let normal = match self.normal {
            Normal::One([least, _]) if elastic[0] < least => Part::Corner(0),
            Normal::One([_, most]) if elastic[0] > most => Part::Corner(1),
            Normal::One(_) => Part::Inside,
            Normal::Two { shape, unit } => shapes[shape].nearest(vec2(elastic[0] / unit, elastic[1] / unit)),
        };
        let sticks = Piece { normal, sliding: Sliding::Sticks };
        let limit = self.limit(self.compressions(shapes, normal, elastic));
        let sliding = match elastic[2] {
            shear if shear > limit => Sliding::Positive,
            shear if -shear > limit => Sliding::Negative,
            _ => Sliding::Sticks,
        };
        Piece { sliding, ..sticks }
    }

    fn compressions(&self, shapes: &[Shape], normal: Part, elastic: [f64; 3]) -> [f64; 2] {
        match self.normal {
            Normal::One(bounds) => match normal {
                Part::Corner(which) => [bounds[which as usize], 0.0],
                _ => [elastic[0], 0.0],
            },
            Normal::Two { shape, unit } => {
                let carried = shapes[shape].drawn_back(normal, vec2(elastic[0] / unit, elastic[1] / unit));
                [carried.x * unit, carried.y * unit]
            }
        }
    }

    fn limit(&self, compressions: [f64; 2]) -> f64 {
        match self.friction.is_finite() {
            true => (self.friction * (compressions[0] + compressions[1]) + self.cohesion).max(0.0),
            false => f64::INFINITY,
        }
    }

    /// Forces of elastic ones within a piece.
    pub(super) fn carried(&self, shapes: &[Shape], piece: Piece, elastic: [f64; 3]) -> [f64; 3] {
        let [a, b] = self.compressions(shapes, piece.normal, elastic);
        let shear = match piece.sliding {
            Sliding::Sticks => elastic[2],
            Sliding::Positive => self.limit([a, b]),
            Sliding::Negative => -self.limit([a, b]),
        };
        [a, b, shear]
    }

    /// How forces change by elastic ones within a piece: row by row.
    pub(super) fn slope(&self, shapes: &[Shape], piece: Piece) -> [[f64; 3]; 3] {
        let normal = match self.normal {
            Normal::One(_) if piece.normal == Part::Inside => [[1.0, 0.0], [0.0, 0.0]],
            Normal::One(_) => [[0.0; 2]; 2],
            Normal::Two { shape, .. } => shapes[shape].slope(piece.normal),
        };
        let sign = match piece.sliding {
            Sliding::Sticks => 0.0,
            Sliding::Positive => self.friction,
            Sliding::Negative => -self.friction,
        };
        let slides = |k: usize| if sign == 0.0 { 0.0 } else { sign * (normal[0][k] + normal[1][k]) };
        let sticks = f64::from(u8::from(piece.sliding == Sliding::Sticks));
        [[normal[0][0], normal[0][1], 0.0], [normal[1][0], normal[1][1], 0.0], [slides(0), slides(1), sticks]]
    }

    /// How far elastic forces may surely go, in sum, before the piece changes.
    pub(super) fn room(&self, shapes: &[Shape], piece: Piece, elastic: [f64; 3]) -> f64 {
        let normal = match self.normal {
            Normal::One([least, most]) => match piece.normal {
                Part::Corner(0) => least - elastic[0],
                Part::Corner(_) => elastic[0] - most,
                _ => (elastic[0] - least).min(most - elastic[0]),
            },
            Normal::Two { shape, unit } => {
                unit * shapes[shape].room(piece.normal, vec2(elastic[0] / unit, elastic[1] / unit))
            }
        };
        if !(self.friction.is_finite() && self.stiffness[2] > 0.0) {
            return normal.max(0.0);
        }
        let limit = self.limit(self.compressions(shapes, piece.normal, elastic));
        let shear = match piece.sliding {
            Sliding::Sticks => limit - elastic[2].abs(),
            Sliding::Positive => elastic[2] - limit,
            Sliding::Negative => -elastic[2] - limit,
        };
        // Compressions that are drawn back change by no more than the elastic ones, and their sum by less than twice that.
        normal.min(shear / (2.0 * self.friction).max(1.0)).max(0.0)
    }

    /// The next piece within `most` of a way along which elastic forces change by `rate`.
    pub(super) fn next(
        &self,
        shapes: &[Shape],
        piece: Piece,
        (elastic, rate): ([f64; 3], [f64; 3]),
        mut most: f64,
    ) -> Option<Event> {
        let mut next = None;
        let mut meet = |after: f64, to: Piece, onward: [f64; 3], most: &mut f64| {
            if after < *most {
                *most = after;
                next = Some(Event { after, to, onward });
            }
        };
        match self.normal {
            Normal::Two { shape, unit } => {
                let scaled = |v: [f64; 3]| vec2(v[0] / unit, v[1] / unit);
                if let Some(change) = shapes[shape].next(piece.normal, scaled(elastic), scaled(rate), most) {
                    let onward = [change.onward.x, change.onward.y, 0.0];
                    meet(change.after, Piece { normal: change.to, ..piece }, onward, &mut most);
                }
            }
            Normal::One(bounds) => {
                let mut to_bound = |bound: f64, sign: f64, to: Part| {
                    let speed = sign * rate[0];
                    if speed > 0.0 {
                        let after = (sign * (bound - elastic[0]) / speed).max(0.0);
                        meet(after, Piece { normal: to, ..piece }, [sign, 0.0, 0.0], &mut most);
                    }
                };
                match piece.normal {
                    Part::Corner(0) => to_bound(bounds[0], 1.0, Part::Inside),
                    Part::Corner(_) => to_bound(bounds[1], -1.0, Part::Inside),
                    _ => {
                        to_bound(bounds[0], -1.0, Part::Corner(0));
                        to_bound(bounds[1], 1.0, Part::Corner(1));
                    }
                }
            }
        }
        if self.friction.is_finite() && self.stiffness[2] > 0.0 {
            let limit = self.limit(self.compressions(shapes, piece.normal, elastic));
            let sticks = Piece { sliding: Sliding::Sticks, ..piece };
            let [a, b, _] = self.slope(shapes, Piece { sliding: Sliding::Positive, ..piece })[2];
            // `sign` of the shear; `way` towards its limit, or back.
            let mut to_limit = |sign: f64, way: f64, to: Piece| {
                let onward = [-way * a, -way * b, way * sign];
                let speed = onward[0] * rate[0] + onward[1] * rate[1] + onward[2] * rate[2];
                if speed > 0.0 {
                    meet((way * (limit - sign * elastic[2]) / speed).max(0.0), to, onward, &mut most);
                }
            };
            match piece.sliding {
                Sliding::Sticks => {
                    to_limit(1.0, 1.0, Piece { sliding: Sliding::Positive, ..piece });
                    to_limit(-1.0, 1.0, Piece { sliding: Sliding::Negative, ..piece });
                }
                Sliding::Positive => to_limit(1.0, -1.0, sticks),
                Sliding::Negative => to_limit(-1.0, -1.0, sticks),
            }
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn element(normal: Normal, forces: usize, friction: f64) -> Element {
        let (equations, parts) = ([0; 6], [[0.0; 6]; 3]);
        Element { column: 0, forces, equations, parts, stiffness: [1.0; 3], normal, friction, cohesion: 0.05 }
    }

    /// Straight ways between forces about all limits: an element with room is passed over on them, so that none may be shorter than its room.
    #[test]
    fn no_limit_is_nearer_than_an_element_has_room() {
        let shapes = [Shape::of_tension(0.1, 0.05), Shape::of_crushing(0.1, 0.05)];
        let two = |shape| Normal::Two { shape, unit: 2.0 };
        let all = [
            element(Normal::One([-0.1, f64::INFINITY]), 2, 0.6),
            element(Normal::One([0.0, 0.4]), 1, f64::INFINITY),
            element(two(0), 3, 0.6),
            element(two(1), 3, 0.6),
            element(two(1), 3, 1.5),
        ];
        let at = |k: u32| {
            let part = |prime: u32, from: f64, to: f64| from + (to - from) * f64::from(k * prime % 101) / 101.0;
            [part(17, -0.5, 1.5), part(29, -0.5, 1.5), part(43, -1.0, 1.0)]
        };
        let (mut limits, mut with_room) = (0, 0);
        for element in &all {
            for (from, to, only) in (0..404).map(|k| (at(k), at(7 * k + 3), k as usize % 4)) {
                // One force alone, or all of them.
                let moves = |k: usize| only == 3 || only == k;
                let rate: [f64; 3] = std::array::from_fn(|k| if moves(k) { to[k] - from[k] } else { 0.0 });
                let (mut elastic, mut piece, mut left) = (from, element.piece(&shapes, from), 1.0);
                while let Some(event) = element.next(&shapes, piece, (elastic, rate), left) {
                    let gone = event.after * rate.iter().map(|r| r.abs()).sum::<f64>();
                    let room = element.room(&shapes, piece, elastic);
                    assert!(room <= gone + 1e-12, "{element:?} {piece:?} {elastic:?}: {room} {gone}");
                    (limits, with_room) = (limits + 1, with_room + u32::from(room > 0.01));
                    (0..3).for_each(|k| elastic[k] += event.after * rate[k]);
                    (piece, left) = (event.to, left - event.after);
                }
            }
        }
        assert!(limits > 10_000 && with_room > 500, "{limits} {with_room}");
    }
}
