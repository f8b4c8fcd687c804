//! One joint between two blocks that may turn and slide by any amount: forces from where they are, and their tangent.
//!
//! The frame of a joint halves the angle between its two faces, so that neither block is favoured and a mirrored model
//! gives the mirrored answer.

use super::dual::{Half, Posed, whole};
use crate::blocks::{BlockModel, Interface, ModelError};
use crate::contact::{Bond, ContactLength, Ends, Number, Resistance, each};
use crate::ids::{Id, Table};
use crate::plane::{Vec2, vec2};
use serde::{Deserialize, Serialize};

/// A joint of the model as built.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Joint {
    pub first: usize,
    pub second: usize,
    /// Ends of the face relative to the centres of the two blocks, as built, along the joint and across it [m].
    pub(super) on_first: [Vec2; 2],
    pub(super) on_second: [Vec2; 2],
    /// Unit normal from the first to the second block, as built.
    pub normal: Vec2,
    /// Whether the blocks touch in one point alone.
    pub(super) pin: bool,
    pub resistance: Resistance,
}

/// What a joint remembers of the last balanced state.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
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

/// The second block as the first one sees it: how far it has moved along the joint and across it [m], and half of its turn.
pub(super) type Relative = (Vec2, Half);

/// What a joint does in one relative pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Response<T> {
    /// Force on the second block along the joint and across it, as the first block sees it [N/m], and moment about the second's centre [N].
    pub force: [T; 3],
    pub ends: Ends<T>,
    /// Shear at the two ends [N/m].
    pub shear: [T; 2],
    /// Whether an end slides.
    pub sliding: [bool; 2],
    /// Whether more of the bond breaks.
    pub cracking: bool,
    pub meeting: Meeting<T>,
}

/// How the two faces of a joint meet, in the frame that halves the angle between them: along the joint and across it, from the middle of
/// the first block's face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Meeting<T> {
    /// Centre of the second block [m].
    centre: [T; 2],
    /// Overlap at the ends of the common face, its length, and how far the second block has slid along it [m].
    pub overlap: [T; 2],
    pub length: T,
    pub glide: T,
    /// The ends, midway between the faces [m].
    pub at: [[T; 2]; 2],
}

/// How far across a line through two points lies where a place is given along, from one of the points.
#[inline(always)]
fn across<T: Number>([from, other]: [[T; 2]; 2], along: T) -> T {
    from[1] + (other[1] - from[1]) / (other[0] - from[0]) * (along - from[0])
}

impl Joint {
    /// The joints of the model's faces.
    pub(super) fn all(model: &BlockModel, interfaces: &[Interface]) -> Result<Vec<Joint>, ModelError> {
        let centres: Table<_, Vec2> = model.blocks.iter().map(|b| b.outline.centroid()).collect();
        let joint = |face: &Interface| {
            let (one, two) = (centres[face.first], centres[face.second]);
            let law = model.laws.between(model.blocks[face.first].group, model.blocks[face.second].group);
            let ends = [face.points[0], face.points[face.points.len() - 1]];
            let seen = |v: Vec2| vec2(v.dot(face.normal.left()), v.dot(face.normal));
            let (pin, length) = (face.points.len() == 1, (ends[1] - ends[0]).norm());
            if !pin && length <= 0.0 {
                return Err(ModelError::Law { what: "the length of a joint", value: length });
            }
            Ok(Joint {
                first: face.first.index(),
                second: face.second.index(),
                on_first: ends.map(|p| seen(p - one)),
                on_second: ends.map(|p| seen(p - two)),
                normal: face.normal,
                pin,
                resistance: Resistance::new(law, (two - one).dot(face.normal).abs()),
            })
        };
        interfaces.iter().map(joint).collect()
    }

    /// Length of the face as built [m].
    pub(super) fn built_length(&self) -> f64 {
        (self.on_first[1] - self.on_first[0]).norm()
    }

    /// Length that presses where nothing is open [m]: that of the face, or what a pin stands for, its given or its least length.
    pub(super) fn bearing_length(&self) -> f64 {
        let pin = self.resistance.fixed_length.unwrap_or(self.resistance.least_length);
        if self.pin { pin } else { self.built_length() }
    }

    /// Force that rounding of coordinates makes of no overlap [N/m].
    pub(super) fn rounding(&self) -> f64 {
        let arm = self.on_first.iter().chain(&self.on_second).map(|arm| arm.norm()).fold(0.0, f64::max);
        let length = self.bearing_length().max(self.resistance.least_length);
        16.0 * f64::EPSILON * arm * length * self.resistance.normal.max(self.resistance.shear)
    }

    /// Unit tangent as built: the second block slides along it when the joint's glide grows.
    pub(super) fn tangent(&self) -> Vec2 {
        self.normal.left()
    }

    /// Centre of the second block from that of the first, as built, along the joint and across it [m].
    pub(super) fn between(&self) -> Vec2 {
        self.on_first[0] - self.on_second[0]
    }

    /// Middle of the face from the centre of the first block, as built, along the joint and across it [m].
    fn middle(&self) -> Vec2 {
        (self.on_first[0] + self.on_first[1]) * 0.5
    }

    /// How the two faces meet in a relative pose.
    #[inline(always)]
    fn meet<T: Posed>(&self, (moved, turn): Relative) -> Meeting<T> {
        let middle = self.middle();
        let centre = T::of_centre(self.between() + moved - middle, turn);
        let one = each(self.on_first, |end| T::of_first(end - middle, turn));
        let two = each(self.on_second, |end| {
            let arm = T::of_second(end, turn);
            [centre[0] + arm[0], centre[1] + arm[1]]
        });
        // The common face ends where the first of the two does.
        let end = |k: usize| {
            let (own, others) = ([one[k], one[1 - k]], [two[k], two[1 - k]]);
            let beyond = two[k][0].value() - one[k][0].value();
            if self.pin {
                ((own[0][0] + others[0][0]).times(0.5), [own[0][1], others[0][1]])
            } else if if k == 0 { beyond > 0.0 } else { beyond < 0.0 } {
                (others[0][0], [across(own, others[0][0]), others[0][1]])
            } else {
                (own[0][0], [own[0][1], across(others, own[0][0])])
            }
        };
        let [(start, first), (stop, last)] = [end(0), end(1)];
        Meeting {
            centre,
            overlap: [first[0] - first[1], last[0] - last[1]],
            length: stop - start,
            glide: (two[0][0] + two[1][0]).times(0.5),
            at: [[start, (first[0] + first[1]).times(0.5)], [stop, (last[0] + last[1]).times(0.5)]],
        }
    }

    /// Forces of a relative pose; in [`Dual`](super::dual::Dual) numbers with their derivatives by what the second block moves along the
    /// joint and across it, and by its turn. `memory` is that of the last balanced state.
    #[inline(always)]
    pub(super) fn respond<T: Posed>(&self, bedding: Bedding, memory: &Memory, pose: Relative) -> Response<T> {
        let meeting = self.meet(pose);
        let Meeting { centre, overlap, length, glide, at } = meeting;
        let (ends, back) = self.pressed(bedding, overlap, length, &memory.bond);
        let law = &self.resistance;
        let cracking = self.cracks(bedding, each(overlap, |o: T| o.value()), &memory.bond).is_some();
        let moved = glide.plus(-memory.glide);
        let (mut shear, mut sliding, mut force) = ([T::of(0.0); 2], [false; 2], [T::of(0.0); 3]);
        for k in 0..2 {
            let held = T::of(memory.sheared[k]) - moved;
            let trial = ends.length[k].times(law.shear) * held;
            let strength = ends.shear_strength(k, law);
            sliding[k] = trial.value().abs() > strength.value();
            shear[k] = match (sliding[k], trial.value() < 0.0) {
                (false, _) => trial,
                (true, false) => strength,
                (true, true) => strength.times(-1.0),
            };
            let push = ends.compression[k] - back[k];
            let arm = [at[k][0] - centre[0], at[k][1] - centre[1]];
            force = [force[0] + shear[k], force[1] + push, force[2] + arm[1] * shear[k] - arm[0] * push];
        }
        let [along, across] = T::seen_by_first([force[0], force[1]], pose.1);
        Response { force: [along, across, force[2]], ends, shear, sliding, cracking, meeting }
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
    pub(super) fn cracks(&self, bedding: Bedding, overlap: [f64; 2], bond: &Bond) -> Option<Bond> {
        if bedding.pressed > 0.0 || !self.bonds(bedding.contact_length) || !bond.holds() {
            return None;
        }
        let left = self.resistance.left(overlap, bond);
        (0..2).any(|k| left.lost[k] > bond.lost[k]).then_some(left)
    }

    /// Share of the face that the bond pulls together.
    pub(super) fn pulled(&self, contact_length: ContactLength, overlap: [f64; 2], bond: &Bond) -> f64 {
        if self.bonds(contact_length) { self.resistance.pulled_share(overlap, bond) } else { 0.0 }
    }

    /// Artificial stiffness of open joints, in the tangent only: it keeps the tangent non-singular where a block is unsupported. Normal and
    /// shear [Pa], and about the middle [N].
    pub(super) fn artificial(&self) -> [f64; 3] {
        const SHARE: f64 = 1e-9;
        let length = self.built_length().max(self.resistance.least_length);
        let (normal, shear) = (self.resistance.normal * length, self.resistance.shear * length);
        [SHARE * normal, SHARE * shear, SHARE * normal * length * length / 12.0]
    }

    /// How far the second block has moved along the joint and across it [m], seen from the first one, from the motions of both since they were
    /// built: translations [m] and rotation [rad]; with half of the first one's turn.
    pub(super) fn moved(&self, first: [f64; 3], second: [f64; 3], turn: Half) -> Vec2 {
        let built = self.between();
        let by = vec2(second[0] - first[0], second[1] - first[1]);
        let by = vec2(by.dot(self.tangent()), by.dot(self.normal));
        // What the turn makes of the distance as built is small beside it: it stands by itself.
        let [sine, cosine] = whole(turn);
        let less = 2.0 * turn[0] * turn[0];
        vec2(
            cosine * by.x - sine * by.y - (less * built.x + sine * built.y),
            cosine * by.y + sine * by.x - (less * built.y - sine * built.x),
        )
    }

    /// Where a place of the response is that stands in the frame between the faces: from the centre of the first block, as built [m].
    pub(super) fn place(&self, [along, across]: [f64; 2], turn: Half) -> Vec2 {
        let [along, across] = f64::seen_by_first([along, across], turn);
        let middle = self.middle();
        self.tangent() * (middle.x + along) + self.normal * (middle.y + across)
    }

    /// How small motions of both blocks (translations [m] and rotation [rad]) slide the joint [m], and how far its ends move
    /// by its turning [m].
    pub(super) fn motion(&self, first: [f64; 3], second: [f64; 3]) -> [f64; 2] {
        let along = |motion: [f64; 3], ends: &[Vec2; 2]| {
            vec2(motion[0], motion[1]).dot(self.tangent()) + 0.5 * (ends[0].y + ends[1].y) * motion[2]
        };
        let slid = along(second, &self.on_second) - along(first, &self.on_first);
        [slid, 0.5 * self.built_length() * (second[2] - first[2])]
    }
}

#[cfg(test)]
mod tests {
    use super::super::dual::{Dual, half_of};
    use super::*;

    fn joint(second_face: [Vec2; 2]) -> Joint {
        Joint {
            first: 0,
            second: 1,
            on_first: [vec2(-0.3, 0.2), vec2(0.3, 0.2)],
            on_second: second_face,
            normal: vec2(0.6, 0.8),
            pin: false,
            resistance: Resistance {
                normal: 2e9,
                shear: 1e9,
                friction: 0.6,
                cohesion: 1e4,
                crushing: 3e6,
                tension: 0.0,
                fixed_length: None,
                least_length: 0.05,
            },
        }
    }

    /// Closed, open at either end, crushed, sliding, faces of other lengths, small and large turns: forces change with the pose as
    /// they say, by differences.
    #[test]
    fn forces_change_with_the_pose_as_they_say() {
        let bedding = Bedding { contact_length: ContactLength::Distributed, pressed: 0.0 };
        let memory = Memory { glide: 1e-4, ..Memory::default() };
        let faces = [[vec2(-0.3, -0.25), vec2(0.3, -0.25)], [vec2(-0.35, -0.25), vec2(0.2, -0.24)]];
        let mut kinds = [0; 4];
        for face in faces {
            let joint = joint(face);
            for (along, across, turn) in [
                (1e-4, -1e-3, 1e-4),
                (2e-4, -1e-3, 4.1e-3),
                (-3e-4, -5e-4, -4.3e-3),
                (0.05, -2e-3, 1e-3),
                (-0.04, -4e-3, 2e-3),
                (0.02, -0.05, 0.4),
            ] {
                let forces = |along, across, turn| {
                    joint.respond::<f64>(bedding, &memory, (vec2(along, across), half_of(turn))).force
                };
                let told = joint.respond::<Dual>(bedding, &memory, (vec2(along, across), half_of(turn)));
                let [a, b] = told.meeting.overlap.map(|o| o.value);
                kinds[0] += u32::from(a < 0.0);
                kinds[1] += u32::from(b < 0.0);
                kinds[2] += u32::from(a.max(b) * joint.resistance.normal > joint.resistance.crushing);
                kinds[3] += u32::from(told.sliding[0] || told.sliding[1]);
                for (told, alone) in told.force.iter().zip(forces(along, across, turn)) {
                    assert!((told.value - alone).abs() <= 1e-10 * alone.abs(), "{told:?}, {alone}");
                }
                let size = 1e-9;
                let step = |sign: f64, motion: usize| {
                    let by = |k: usize| if k == motion { sign * size } else { 0.0 };
                    forces(along + by(0), across + by(1), turn + by(2))
                };
                for motion in 0..3 {
                    let (later, sooner) = (step(1.0, motion), step(-1.0, motion));
                    for c in 0..3 {
                        let slope = (later[c] - sooner[c]) / (2.0 * size);
                        let off = (told.force[c].slope[motion] - slope).abs();
                        assert!(off < 1e-5 * 2e9, "{along} {across} {turn}, {motion} {c}: {off}");
                    }
                }
            }
        }
        assert!(kinds.iter().all(|&met| met > 0), "every kind is met: {kinds:?}");
    }
}
