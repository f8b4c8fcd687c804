//! How the blocks move where the load no longer grows, and what gives way there.

use super::correct::norm;
use super::outcome::{Cause, PathPoint};
use super::system::State;
use super::trace::Path;
use crate::blocks::BlockModel;
use crate::ids::{BlockId, Table};
use crate::numbering::HELD;
use crate::plane::Vec2;

/// Inverse iterations: at a fork the least eigenvalue is a hundred-thousandth of the others.
const INVERSE_ITERATIONS: u32 = 8;

impl Path<'_> {
    /// The motion that takes least work in the last balanced state, by inverse iteration: the one that gives way at a fork; none where the tangent is
    /// singular.
    pub(super) fn easiest(&mut self) -> Option<Vec<f64>> {
        let state = self.state.clone();
        self.heading(&state, None)?;
        // No motion of a bridge is at right angles to numbers without a pattern.
        let mut motion: Vec<f64> = (0..self.model.equations).map(|k| 1.0 + ((7 * k) % 11) as f64).collect();
        for _ in 0..INVERSE_ITERATIONS {
            self.work.tangent.solve(&mut motion);
            let length = norm(&motion);
            motion.iter_mut().for_each(|part| *part /= length);
        }
        Some(motion)
    }

    /// The motions from one state to another, by their equations.
    pub(super) fn way(&self, from: &State, to: &State) -> Vec<f64> {
        let mut way = vec![0.0; self.model.equations];
        for (block, equations) in self.model.equation.iter().enumerate() {
            for c in (0..3).filter(|&c| equations[c] != HELD) {
                let size = if c == 2 { self.model.size } else { 1.0 };
                way[equations[c] as usize] = size * (to.motions[block][c] - from.motions[block][c]);
            }
        }
        way
    }

    /// The motion of one block in the mechanism: velocity and spin; nothing without a mechanism.
    fn motion(&self, block: usize) -> [f64; 3] {
        [0, 1, 2].map(|c| match self.model.equation[block][c] {
            HELD => 0.0,
            _ if self.mechanism.is_empty() => 0.0,
            equation if c == 2 => self.mechanism[equation as usize] / self.model.size,
            equation => self.mechanism[equation as usize],
        })
    }

    /// What gives way in the state at the largest load: joints that slide where the mechanism slides more than it turns.
    pub(super) fn cause(&self, peak: &PathPoint) -> Cause {
        let motions =
            self.model.joints.iter().map(|joint| joint.motion(self.motion(joint.first), self.motion(joint.second)));
        let (slid, turned) = motions.fold((0.0, 0.0), |sum, [slide, turn]| (sum.0 + slide.abs(), sum.1 + turn.abs()));
        if slid > turned {
            Cause::Sliding
        } else if peak.hinges < 3 && peak.crushed > 0.0 {
            Cause::Crushing
        } else {
            Cause::Hinging
        }
    }

    /// The mechanism with its fastest point moved by 1 m.
    pub(super) fn motions(&self, blocks: &BlockModel) -> Table<BlockId, (Vec2, f64)> {
        if self.mechanism.is_empty() {
            return Table::default();
        }
        let of = |block: usize| {
            let [x, y, spin] = self.motion(block);
            (Vec2 { x, y }, spin)
        };
        let motions: Table<_, _> = (0..self.model.built.len()).map(of).collect();
        blocks.to_one_metre(&motions).unwrap_or(motions)
    }
}
