//! Springs that stay closed, in many solutions at a time.

use super::quiet::{TOGETHER, solution};
use crate::fem::factor::Block;
use crate::fem::joint::{JointLaw, PairMemory};

/// A spring whose stiffness in the linear system is that of its law while it is closed, and what it remembers.
pub(super) struct Closed<'a> {
    pub law: &'a JointLaw,
    pub area: f64,
    pub memory: &'a PairMemory,
    /// Openings when the run began, and equations and weights of what is added to them.
    pub base: [f64; 2],
    pub openings: [&'a [(u32, f64)]; 2],
}

impl Closed<'_> {
    /// Whether it surely answers linearly in all of the first solutions; where it may not, its law has to be asked.
    #[inline(always)]
    pub fn holds(&self, block: &Block, lanes: usize) -> bool {
        let mut holds = true;
        for k in 0..lanes.div_ceil(TOGETHER) {
            let mut opening = [[0.0; TOGETHER]; 2];
            for i in 0..2 {
                // The same sum as that of one solution, to the bit.
                let mut sum = [-0.0; TOGETHER];
                for &(equation, weight) in self.openings[i] {
                    let values = &solution(block, equation)[k];
                    for lane in 0..TOGETHER {
                        sum[lane] += weight * values[lane];
                    }
                }
                for lane in 0..TOGETHER {
                    opening[i][lane] = self.base[i] + sum[lane];
                }
            }
            holds &= self.law.surely_holds(&opening, self.area, self.memory);
        }
        holds
    }
}
