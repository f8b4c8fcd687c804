//! Proof that a closed spring stays closed, for many solutions at a time.

use super::quad_check::{LANES, equation_values};
use crate::fem::factor::Block;
use crate::fem::joint::PairMemory;
use crate::fem::model::Model;

/// A spring whose stiffness in the linear system is that of its law while closed, with its memory.
#[derive(Debug)]
pub(super) struct SpringCheck {
    /// Number of its law in the model.
    pub kind: u32,
    /// Area that the spring stands for, per metre of width [m].
    pub area: f64,
    /// Memory that the law starts from.
    pub memory: PairMemory,
    /// Normal and tangential opening when the run began [m].
    pub base: [f64; 2],
}

impl SpringCheck {
    /// Whether the spring stays closed in all of the first solutions of `block`, where equations and weights of what is added to `base` are those of
    /// `openings`. `false` proves nothing: the law has to be evaluated.
    #[inline(always)]
    pub(super) fn proves_linear(
        &self,
        model: &Model,
        openings: [&[(u32, f64)]; 2],
        block: &Block,
        solutions: usize,
    ) -> bool {
        let law = &model.joints[self.kind as usize];
        let mut linear = true;
        for k in 0..solutions.div_ceil(LANES) {
            let mut opening = [[0.0; LANES]; 2];
            for i in 0..2 {
                // The order of the sum for one solution, for the same bits.
                let mut sum = [-0.0; LANES];
                for &(equation, weight) in openings[i] {
                    let values = &equation_values(block, equation)[k];
                    for lane in 0..LANES {
                        sum[lane] += weight * values[lane];
                    }
                }
                for lane in 0..LANES {
                    opening[i][lane] = self.base[i] + sum[lane];
                }
            }
            linear &= law.provably_linear(&opening, self.area, &self.memory);
        }
        linear
    }
}
