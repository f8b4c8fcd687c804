//! Proof that a quadrilateral does not yield, point by point, for many solutions at a time.
//!
//! Eight solutions stand side by side in the processor's registers. The test is exact up to its margin; the cheaper bound of
//! `hourglass.rs` comes first where the memory of a quadrilateral has not changed since the run began.

use crate::fem::dofs::HELD;
use crate::fem::element::Sample;
use crate::fem::factor::Block;
use crate::fem::law::Solid;
use crate::fem::many::WIDEST;
use crate::fem::state::Point;

/// Solutions that are tested together.
pub(super) const LANES: usize = 8;

/// Gives the values of an equation [m] in all solutions, by groups of [`LANES`]; zeros for the equation of a held component.
#[inline(always)]
pub(super) fn equation_values(block: &Block, equation: u32) -> &[[f64; LANES]] {
    static HELD_VALUES: [[f64; LANES]; WIDEST / LANES] = [[0.0; LANES]; WIDEST / LANES];
    if equation == HELD { &HELD_VALUES } else { block.of(equation).as_chunks().0 }
}

/// A quadrilateral without incompatible modes, with the memory of its points.
pub(super) struct QuadCheck<'a> {
    /// Law of its points.
    pub solid: &'a Solid,
    /// Its integration points: gradients and areas.
    pub samples: &'a [Sample; 4],
    /// State of these points, with the memory that the law starts from.
    pub points: &'a [Point; 4],
    /// Displacements of its corners when the run began [m].
    pub base: &'a [f64; 8],
    /// Equations of the displacements that are added to `base`.
    pub equations: &'a [u32; 8],
}

impl QuadCheck<'_> {
    /// Whether no point yields in any of the first solutions of `block`. `false` proves nothing: the law has to be evaluated.
    #[inline(always)]
    pub(super) fn proves_linear(&self, block: &Block, solutions: usize) -> bool {
        for k in 0..solutions.div_ceil(LANES) {
            let mut u = [[0.0; LANES]; 8];
            for i in 0..8 {
                let values = &equation_values(block, self.equations[i])[k];
                for lane in 0..LANES {
                    u[i][lane] = self.base[i] + values[lane];
                }
            }
            if !self.proves_linear_at(&u) {
                return false;
            }
        }
        true
    }

    /// Whether no point yields at any of `L` displacements of the corners [m], by components.
    #[inline(always)]
    pub(super) fn proves_linear_at<const L: usize>(&self, u: &[[f64; L]; 8]) -> bool {
        (0..4).all(|point| self.proves_point_linear_at(point, u))
    }

    #[inline(always)]
    fn proves_point_linear_at<const L: usize>(&self, point: usize, u: &[[f64; L]; 8]) -> bool {
        let sample = &self.samples[point];
        let mut strain = [[0.0; L]; 4];
        for a in 0..4 {
            for lane in 0..L {
                strain[0][lane] += sample.dx[a] * u[2 * a][lane];
                strain[1][lane] += sample.dy[a] * u[2 * a + 1][lane];
                strain[3][lane] += sample.dy[a] * u[2 * a][lane] + sample.dx[a] * u[2 * a + 1][lane];
            }
        }
        self.solid.provably_linear(&strain, &self.points[point].memory)
    }
}
