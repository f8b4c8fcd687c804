//! One joint between two blocks that may turn and slide by any amount: forces from where they are, and their tangent.
//!
//! The frame of a joint halves the angle between its two faces, so that neither block is favoured and a mirrored model
//! gives the mirrored answer.

use super::dual::{Angle, Dual, Half, whole};
use crate::blocks::{BlockModel, Interface, ModelError};
use crate::contact::{Bond, ContactLength, Ends, Number, Resistance, each};
use crate::ids::{Id, Table};
use crate::plane::{Vec2, vec2};

/// A joint of the model as built.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Joint {
    pub first: usize,
    pub second: usize,
    /// Ends of the face relative to the centres of the two blocks, as built [m].
    pub(super) on_first: [Vec2; 2],
    pub(super) on_second: [Vec2; 2],
    /// Unit normal from the first to the second block, as built.
    pub normal: Vec2,
    /// Whether the blocks touch in one point alone.
    pub(super) pin: bool,
    pub resistance: Resistance,
}

/// What a joint remembers of the last balanced state.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Memory {
    /// How far the two ends had been sheared elastically [m], against the tangent.
    pub sheared: [f64; 2],
    /// How far the second block had slid along the tangent [m].
    pub glide: f64,
    /// What was left of the bond.
    pub bond: Bond,
}

/// How joints answer: where they press, and by how much they are pressed together before anything acts [m], which their ends
/// push back. Nothing but the first state under self-weight is sought with joints that are pressed together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bedding {
    pub contact_length: ContactLength,
    pub pressed: f64,
}

/// The second block as the first one sees it: its displacement in the frame of the first [m], and its turn [rad].
pub(super) type Relative<T> = [T; 3];

/// What a joint does in one relative pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Response<T> {
    /// Force on the second block in the frame of the first [N/m], twice, and moment about the second's centre [N].
    pub force: [T; 3],
    pub ends: Ends<T>,
    /// Shear at the two ends [N/m].
    pub shear: [T; 2],
    /// Whether an end slides.
    pub sliding: [bool; 2],
    /// Whether more of the bond breaks.
    pub cracking: bool,
    /// Overlap at the two ends of the common face [m].
    pub overlap: [T; 2],
    /// Length of the common face [m].
    pub length: T,
    /// How far the second block has slid [m].
    pub glide: T,
    /// Where the ends are in the frame of the first block, from its centre [m].
    pub at: [[T; 2]; 2],
}

/// How the two faces of a joint meet, in the frame of the first block.
struct Meeting<T> {
    /// Unit vectors of the frame that halves the angle between the faces.
    tangent: [T; 2],
    normal: [T; 2],
    /// Centre of the second block from that of the first [m].
    apart: [T; 2],
    /// Overlap at the ends of the common face, its length, and how far the second block has slid along it [m].
    overlap: [T; 2],
    length: T,
    glide: T,
    /// The ends, midway between the faces, from the centre of the first block [m].
    at: [[T; 2]; 2],
}

fn dot<T: Number>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

impl Joint {
    /// The joints of the model's faces.
    pub fn all(model: &BlockModel, interfaces: &[Interface]) -> Result<Vec<Joint>, ModelError> {
        let centres: Table<_, Vec2> = model.blocks.iter().map(|b| b.outline.centroid()).collect();
        let joint = |face: &Interface| {
            let (one, two) = (centres[face.first], centres[face.second]);
            let law = model.laws.between(model.blocks[face.first].group, model.blocks[face.second].group);
            let ends = [face.points[0], face.points[face.points.len() - 1]];
            let (pin, length) = (face.points.len() == 1, (ends[1] - ends[0]).norm());
            if !pin && length <= 0.0 {
                return Err(ModelError::Law { what: "the length of a joint", value: length });
            }
            Ok(Joint {
                first: face.first.index(),
                second: face.second.index(),
                on_first: ends.map(|p| p - one),
                on_second: ends.map(|p| p - two),
                normal: face.normal,
                pin,
                resistance: Resistance::new(law, (two - one).dot(face.normal).abs()),
            })
        };
        interfaces.iter().map(joint).collect()
    }

    /// Length of the face as built [m].
    pub fn built_length(&self) -> f64 {
        (self.on_first[1] - self.on_first[0]).norm()
    }

    /// Length that presses where nothing is open [m]: that of the face, or what a pin stands for, its given or its least length.
    pub fn bearing_length(&self) -> f64 {
        let pin = self.resistance.fixed_length.unwrap_or(self.resistance.least_length);
        if self.pin { pin } else { self.built_length() }
    }

    /// Force that rounding of coordinates makes of no overlap [N/m].
    pub fn rounding(&self) -> f64 {
        let arm = self.on_first.iter().chain(&self.on_second).map(|arm| arm.norm()).fold(0.0, f64::max);
        let length = self.bearing_length().max(self.resistance.least_length);
        16.0 * f64::EPSILON * arm * length * self.resistance.normal.max(self.resistance.shear)
    }

    /// Unit tangent as built: the second block slides along it when the joint's glide grows.
    pub fn tangent(&self) -> Vec2 {
        self.normal.left()
    }

    /// Centre of the second block from that of the first, as built [m].
    fn between(&self) -> Vec2 {
        self.on_first[0] - self.on_second[0]
    }

    /// How the two faces meet in a relative pose.
    fn meet<T: Angle>(&self, pose: Relative<T>, turn: Half) -> Meeting<T> {
        let half = T::of(0.5);
        let (sine, cosine) = pose[2].of_half(turn);
        // The second block turns by the whole angle, which is its half twice.
        let (whole_sine, whole_cosine) = (T::of(2.0) * sine * cosine, cosine * cosine - sine * sine);
        let turned = |v: Vec2, sine: T, cosine: T| {
            let (x, y) = (T::of(v.x), T::of(v.y));
            [x * cosine - y * sine, x * sine + y * cosine]
        };
        let (tangent, normal) = (turned(self.tangent(), sine, cosine), turned(self.normal, sine, cosine));
        let apart = [pose[0] + T::of(self.between().x), pose[1] + T::of(self.between().y)];
        let middle = (self.on_first[0] + self.on_first[1]) * 0.5;
        let seen = |p: [T; 2]| {
            let from = [p[0] - T::of(middle.x), p[1] - T::of(middle.y)];
            [dot(from, tangent), dot(from, normal)]
        };
        let one = each(self.on_first, |v| seen([T::of(v.x), T::of(v.y)]));
        let two = each(self.on_second, |v| {
            let arm = turned(v, whole_sine, whole_cosine);
            seen([apart[0] + arm[0], apart[1] + arm[1]])
        });
        let (along, faces) = if self.pin {
            ([(one[0][0] + two[0][0]) * half; 2], each([one, two], |face| [face[0][1]; 2]))
        } else {
            let later = |a: T, b: T| if b.value() > a.value() { b } else { a };
            let sooner = |a: T, b: T| if b.value() < a.value() { b } else { a };
            let along = [later(one[0][0], two[0][0]), sooner(one[1][0], two[1][0])];
            let height = |face: &[[T; 2]; 2], s: T| {
                face[0][1] + (face[1][1] - face[0][1]) / (face[1][0] - face[0][0]) * (s - face[0][0])
            };
            (along, each([one, two], |face| each(along, |s| height(&face, s))))
        };
        let point = |k: usize| {
            let height = (faces[0][k] + faces[1][k]) * half;
            let part = |middle: f64, c: usize| T::of(middle) + tangent[c] * along[k] + normal[c] * height;
            [part(middle.x, 0), part(middle.y, 1)]
        };
        Meeting {
            tangent,
            normal,
            apart,
            overlap: [faces[0][0] - faces[1][0], faces[0][1] - faces[1][1]],
            length: along[1] - along[0],
            glide: (two[0][0] + two[1][0]) * half,
            at: [point(0), point(1)],
        }
    }

    /// Forces of a relative pose with its turn. `memory` is that of the last balanced state.
    pub fn respond<T: Angle>(
        &self,
        bedding: Bedding,
        memory: &Memory,
        (pose, turn): (Relative<T>, Half),
    ) -> Response<T> {
        let Meeting { tangent, normal, apart, overlap, length, glide, at } = self.meet(pose, turn);
        let (ends, back) = self.pressed(bedding, overlap, length, &memory.bond);
        let law = &self.resistance;
        let cracking = self.cracks(bedding, each(overlap, |o| o.value()), &memory.bond).is_some();
        let moved = glide - T::of(memory.glide);
        let (mut shear, mut sliding, mut force) = ([T::of(0.0); 2], [false; 2], [T::of(0.0); 3]);
        for k in 0..2 {
            let trial = T::of(law.shear) * ends.length[k] * (T::of(memory.sheared[k]) - moved);
            let strength = ends.shear_strength(k, law);
            sliding[k] = trial.value().abs() > strength.value();
            shear[k] = match (sliding[k], trial.value() < 0.0) {
                (false, _) => trial,
                (true, false) => strength,
                (true, true) => T::of(0.0) - strength,
            };
            let push = ends.compression[k] - back[k];
            let on = [normal[0] * push + tangent[0] * shear[k], normal[1] * push + tangent[1] * shear[k]];
            let arm = [at[k][0] - apart[0], at[k][1] - apart[1]];
            force = [force[0] + on[0], force[1] + on[1], force[2] + arm[0] * on[1] - arm[1] * on[0]];
        }
        Response { force, ends, shear, sliding, cracking, overlap, length, glide, at }
    }

    /// What the two ends carry, and what is pushed back where the joint is pressed together beforehand, so that one that nothing
    /// loads stays at rest. Nothing crushes then.
    fn pressed<T: Number>(&self, bedding: Bedding, overlap: [T; 2], length: T, bond: &Bond) -> (Ends<T>, [T; 2]) {
        let Bedding { contact_length, pressed } = bedding;
        if pressed <= 0.0 {
            return (self.ends(&self.resistance, contact_length, overlap, length, bond), [T::of(0.0); 2]);
        }
        let law = Resistance { crushing: f64::INFINITY, ..self.resistance };
        let ends = self.ends(&law, contact_length, overlap.map(|o| o + T::of(pressed)), length, bond);
        (ends, self.ends(&law, contact_length, [T::of(pressed); 2], length, bond).compression)
    }

    /// A pin presses in its one point.
    fn ends<T: Number>(
        &self,
        law: &Resistance,
        contact_length: ContactLength,
        overlap: [T; 2],
        length: T,
        bond: &Bond,
    ) -> Ends<T> {
        let nothing = Ends { compression: [T::of(0.0); 2], length: [T::of(0.0); 2] };
        if self.pin {
            let pin = Resistance { fixed_length: Some(self.bearing_length()), ..*law };
            let both = pin.ends(ContactLength::Fixed, overlap, length, bond);
            return Ends {
                compression: [both.compression[0], nothing.compression[1]],
                length: [both.length[0], nothing.length[1]],
            };
        }
        if length.value() > 0.0 { law.ends(contact_length, overlap, length, bond) } else { nothing }
    }

    /// Whether the joint has a bond that counts.
    fn bonds(&self, contact_length: ContactLength) -> bool {
        !self.pin && self.resistance.tension > 0.0 && contact_length == ContactLength::Distributed
    }

    /// What is left of a bond of which some breaks at this overlap; nothing where none does, or while joints are pressed together.
    pub fn cracks(&self, bedding: Bedding, overlap: [f64; 2], bond: &Bond) -> Option<Bond> {
        if bedding.pressed > 0.0 || !self.bonds(bedding.contact_length) || !bond.holds() {
            return None;
        }
        let left = self.resistance.left(overlap, bond);
        (0..2).any(|k| left.lost[k] > bond.lost[k]).then_some(left)
    }

    /// Share of the face that the bond pulls together.
    pub fn pulled(&self, contact_length: ContactLength, overlap: [f64; 2], bond: &Bond) -> f64 {
        if self.bonds(contact_length) { self.resistance.pulled_share(overlap, bond) } else { 0.0 }
    }

    /// Stiffness that an open joint is lent in tangents, and there alone, so that a block that nothing touches does not make
    /// them singular: normal and shear [Pa], and about the middle [N].
    pub fn lent(&self) -> [f64; 3] {
        const SHARE: f64 = 1e-9;
        let length = self.built_length().max(self.resistance.least_length);
        let (normal, shear) = (self.resistance.normal * length, self.resistance.shear * length);
        [SHARE * normal, SHARE * shear, SHARE * normal * length * length / 12.0]
    }

    /// The response with its derivatives.
    pub fn respond_with_tangent(
        &self,
        bedding: Bedding,
        memory: &Memory,
        (pose, turn): (Relative<f64>, Half),
    ) -> Response<Dual> {
        let variables = [Dual::variable(pose[0], 0), Dual::variable(pose[1], 1), Dual::variable(pose[2], 2)];
        self.respond(bedding, memory, (variables, turn))
    }

    /// Where the second block stands in the frame of the first, from the motions of both since they were built: translations
    /// [m] and rotation [rad]; with half of the first one's turn.
    pub fn relative(&self, first: [f64; 3], second: [f64; 3], turn: Half) -> Relative<f64> {
        let built = self.between();
        let apart = built + vec2(second[0] - first[0], second[1] - first[1]);
        let [sine, cosine] = whole(turn);
        let back = vec2(cosine * apart.x + sine * apart.y, cosine * apart.y - sine * apart.x);
        [back.x - built.x, back.y - built.y, second[2] - first[2]]
    }

    /// How small motions of both blocks (translations [m] and rotation [rad]) slide the joint [m], and how far its ends move
    /// by its turning [m].
    pub fn motion(&self, first: [f64; 3], second: [f64; 3]) -> [f64; 2] {
        let middle = |ends: &[Vec2; 2]| (ends[0] + ends[1]) * 0.5;
        let moved = |motion: [f64; 3], arm: Vec2| vec2(motion[0], motion[1]) + arm.left() * motion[2];
        let apart = moved(second, middle(&self.on_second)) - moved(first, middle(&self.on_first));
        [apart.dot(self.tangent()), 0.5 * self.built_length() * (second[2] - first[2])]
    }

    /// Centre of the second block from that of the first in a relative pose, in the frame of the first [m].
    pub fn apart(&self, pose: Relative<f64>) -> Vec2 {
        self.between() + vec2(pose[0], pose[1])
    }
}
