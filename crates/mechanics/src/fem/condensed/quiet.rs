//! Quadrilaterals that flow nowhere, in many solutions at a time: nearly all of them, nearly always.
//!
//! Eight solutions stand side by side in the processor's registers. This looks at every point and knows its limit; a glance (`hourglass.rs`) comes first where
//! nothing has changed since the run began.

use crate::fem::dofs::HELD;
use crate::fem::element::Sample;
use crate::fem::factor::Block;
use crate::fem::law::Solid;
use crate::fem::many::WIDEST;
use crate::fem::state::Point;

/// Solutions that are looked at together.
pub(super) const TOGETHER: usize = 8;

/// The solutions at an equation, of a component that is held as well.
#[inline(always)]
pub(super) fn solution(block: &Block, equation: u32) -> &[[f64; TOGETHER]] {
    static HOLDS: [[f64; TOGETHER]; WIDEST / TOGETHER] = [[0.0; TOGETHER]; WIDEST / TOGETHER];
    if equation == HELD { &HOLDS } else { block.of(equation).as_chunks().0 }
}

/// A quadrilateral without modes and what it remembers.
pub(super) struct Quiet<'a> {
    pub solid: &'a Solid,
    pub samples: &'a [Sample; 4],
    pub points: &'a [Point; 4],
    /// Displacements of its corners when the run began, and the equations of what is added to them.
    pub base: &'a [f64; 8],
    pub equations: &'a [u32; 8],
}

impl Quiet<'_> {
    /// Whether it surely flows in none of the first solutions; where it may, its law has to be asked.
    #[inline(always)]
    pub fn holds(&self, block: &Block, lanes: usize) -> bool {
        for k in 0..lanes.div_ceil(TOGETHER) {
            let mut u = [[0.0; TOGETHER]; 8];
            for i in 0..8 {
                let values = &solution(block, self.equations[i])[k];
                for lane in 0..TOGETHER {
                    u[i][lane] = self.base[i] + values[lane];
                }
            }
            if !self.holds_at(&u) {
                return false;
            }
        }
        true
    }

    /// The same where its corners are displaced so.
    #[inline(always)]
    pub fn holds_at<const L: usize>(&self, u: &[[f64; L]; 8]) -> bool {
        (0..4).all(|point| self.point_holds_at(point, u))
    }

    #[inline(always)]
    fn point_holds_at<const L: usize>(&self, point: usize, u: &[[f64; L]; 8]) -> bool {
        let sample = &self.samples[point];
        let mut strain = [[0.0; L]; 4];
        for a in 0..4 {
            for lane in 0..L {
                strain[0][lane] += sample.dx[a] * u[2 * a][lane];
                strain[1][lane] += sample.dy[a] * u[2 * a + 1][lane];
                strain[3][lane] += sample.dy[a] * u[2 * a][lane] + sample.dx[a] * u[2 * a + 1][lane];
            }
        }
        self.solid.surely_holds(&strain, &self.points[point].memory)
    }
}
