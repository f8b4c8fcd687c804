//! A force that answers movement: fill that a block is pushed against.
//!
//! Fill resists the more the further it is pushed. Between the force that is there anyway and the largest one a hyperbola is taken
//! (Duncan and Mokwa 2001, with the largest force as its asymptote), so that movement alone decides what is mobilised:
//!
//! `P(u) = least + (most - least) u / (u + h)` for `u > 0`, and `least` for `u <= 0`,
//!
//! with the movement `u` against the force since the blocks were built [m] and the movement `h` at which half of the difference is
//! there [m]. It has no memory: a back that returns finds the force that it had there.

use super::system::State;
use crate::blocks::{Loading, ModelError};
use crate::ids::Id;
use crate::plane::{Vec2, vec2};
use serde::Serialize;

/// Where a restraint acts on a block, seen from its centre as built [m].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct Hold {
    pub block: usize,
    pub arm: Vec2,
}

/// A restraint as the path sees it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct Restrained {
    pub holds: [Option<Hold>; 2],
    pub direction: Vec2,
    pub least: f64,
    pub most: f64,
    pub half: f64,
}

/// What a restraint does to the one or two blocks that it acts on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Held {
    /// The blocks; the force on the second is opposite.
    pub blocks: [Option<usize>; 2],
    /// Force along x and y [N/m] and moment about the centre [N] on each.
    pub forces: [[f64; 3]; 2],
    /// Derivatives of the six forces by the six motions.
    pub slope: [[f64; 6]; 6],
}

impl Restrained {
    /// The restraints of a loading.
    ///
    /// # Errors
    /// A block that is not there, or a movement that is no positive number.
    pub(super) fn all(loading: &Loading, built: &[Vec2]) -> Result<Vec<Restrained>, ModelError> {
        let hold = |block: crate::ids::BlockId, at: Vec2| match built.get(block.index()) {
            Some(&centre) => Ok(Hold { block: block.index(), arm: at - centre }),
            None => Err(ModelError::Unknown { what: "block", id: block.0 }),
        };
        let of = |r: &crate::blocks::Restraint| {
            if !(r.half_movement > 0.0) {
                return Err(ModelError::Law {
                    what: "movement that mobilises half of a restraint",
                    value: r.half_movement,
                });
            }
            let against = r.against.map(|(block, at)| hold(block, at)).transpose()?;
            let holds = [Some(hold(r.block, r.at)?), against];
            Ok(Restrained { holds, direction: r.direction, least: r.least, most: r.most, half: r.half_movement })
        };
        loading.restraints.iter().map(of).collect()
    }

    /// The blocks that it acts on.
    pub(super) fn blocks(&self) -> [Option<usize>; 2] {
        self.holds.map(|hold| hold.map(|hold| hold.block))
    }

    /// Force [N/m] and its derivative by a movement [m] against it.
    pub(super) fn force(&self, movement: f64) -> [f64; 2] {
        let rest = self.most - self.least;
        if movement <= 0.0 {
            return [self.least, 0.0];
        }
        let whole = movement + self.half;
        [self.least + rest * movement / whole, rest * self.half / (whole * whole)]
    }

    /// What a movement against it adds in a state, and all that it could add [N/m]; none where the blocks move away.
    pub(super) fn added(&self, state: &State) -> Option<[f64; 2]> {
        let movement = self.movement(state);
        (movement > 0.0).then(|| [self.force(movement)[0] - self.least, self.most - self.least])
    }

    /// Movement against it since the blocks were built [m].
    pub(super) fn movement(&self, state: &State) -> f64 {
        let moved = |hold: Option<Hold>| hold.map_or(Vec2::ZERO, |hold| displaced(hold, state.motions[hold.block]).0);
        -self.direction.dot(moved(self.holds[0]) - moved(self.holds[1]))
    }

    /// Its forces in a state, with their derivatives.
    pub(super) fn on(&self, state: &State) -> Held {
        let [force, rate] = self.force(self.movement(state));
        let d = self.direction;
        let mut held = Held { blocks: self.blocks(), forces: [[0.0; 3]; 2], slope: [[0.0; 6]; 6] };
        // Direction of the force in the motions of either block, and how the movement against it grows with each motion.
        let mut along = [0.0; 6];
        for (side, sign) in [(0, 1.0), (1, -1.0)] {
            let Some(hold) = self.holds[side] else { continue };
            let (_, arm) = displaced(hold, state.motions[hold.block]);
            let moment = arm.x * d.y - arm.y * d.x;
            let here = [sign * d.x, sign * d.y, sign * moment];
            held.forces[side] = here.map(|part| force * part);
            along[3 * side..3 * side + 3].copy_from_slice(&here);
            // The arm turns with the block, the force keeps its direction.
            held.slope[3 * side + 2][3 * side + 2] = -force * sign * (arm.y * d.y + arm.x * d.x);
        }
        for row in 0..6 {
            for column in 0..6 {
                held.slope[row][column] -= rate * along[row] * along[column];
            }
        }
        held
    }
}

/// Displacement of a point of a block, and its arm about the centre then [m].
fn displaced(hold: Hold, motion: [f64; 3]) -> (Vec2, Vec2) {
    let (sine, cosine) = motion[2].sin_cos();
    let arm = vec2(cosine * hold.arm.x - sine * hold.arm.y, sine * hold.arm.x + cosine * hold.arm.y);
    (vec2(motion[0], motion[1]) + arm - hold.arm, arm)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn between() -> Restrained {
        let hold = |block, x, y| Some(Hold { block, arm: vec2(x, y) });
        let direction = vec2(0.8, -0.6);
        Restrained { holds: [hold(0, 0.7, 0.4), hold(1, -0.3, 0.5)], direction, least: 2.0, most: 11.0, half: 0.03 }
    }

    fn state(motions: [[f64; 3]; 2]) -> State {
        State { motions: motions.to_vec(), factor: 0.0, memory: Vec::new(), pressed: 0.0 }
    }

    #[test]
    fn half_of_the_difference_is_there_at_half_the_movement_and_nothing_more_where_it_moves_away() {
        let r = between();
        assert_eq!(r.force(-1.0), [2.0, 0.0]);
        assert!((r.force(0.03)[0] - 6.5).abs() < 1e-12);
        assert!((r.force(1e9)[0] - 11.0).abs() < 1e-6);
    }

    #[test]
    fn its_derivatives_are_those_of_its_forces() {
        let r = between();
        let motions = [[-0.02, 0.013, 0.2], [0.017, -0.01, -0.3]];
        assert!(r.movement(&state(motions)) > 0.01, "{}", r.movement(&state(motions)));
        let slope = r.on(&state(motions)).slope;
        let step = 1e-6;
        for column in 0..6 {
            let [more, less] = [step, -step].map(|by| {
                let mut moved = motions;
                moved[column / 3][column % 3] += by;
                r.on(&state(moved)).forces
            });
            for row in 0..6 {
                let numeric = (more[row / 3][row % 3] - less[row / 3][row % 3]) / (2.0 * step);
                assert!(
                    (slope[row][column] - numeric).abs() < 1e-5,
                    "{row} {column}: {} {numeric}",
                    slope[row][column]
                );
            }
        }
    }

    #[test]
    fn what_it_does_to_one_block_it_does_to_the_other_in_reverse() {
        let held = between().on(&state([[-0.02, 0.013, 0.2], [0.017, -0.01, -0.3]]));
        assert!((0..2).all(|c| held.forces[0][c] == -held.forces[1][c]), "{held:?}");
    }
}
