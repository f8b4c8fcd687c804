//! Quadrilaterals that flow nowhere, in many solutions at a time: nearly all of them, nearly always.
//!
//! Eight solutions stand side by side in the processor's registers. Of a passage with 53,498 unknowns looking over took 16 % of the time while
//! every law was asked, and takes 8 % this way.

use crate::fem::dofs::HELD;
use crate::fem::element::Sample;
use crate::fem::factor::Block;
use crate::fem::law::Solid;
use crate::fem::state::Point;

/// Solutions that are looked at together.
const TOGETHER: usize = 8;

/// A quadrilateral without modes and what it remembers.
pub(super) struct Quiet<'a> {
    pub solid: &'a Solid,
    pub samples: &'a [Sample; 4],
    pub points: &'a [Point; 4],
    /// Displacements of its corners when the run began, and the equations of what is added to them.
    pub base: &'a [f64; 8],
    pub equations: &'a [u32; 8],
    pub block: &'a Block,
}

impl Quiet<'_> {
    /// Whether it surely flows in none of the solutions; where it may, its law has to be asked.
    pub fn holds(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        if let Some(v3) = pulp::x86::V3::try_new() {
            struct Wide<'a>(Quiet<'a>);
            impl pulp::NullaryFnOnce for Wide<'_> {
                type Output = bool;
                #[inline(always)]
                fn call(self) -> bool {
                    self.0.holds_everywhere()
                }
            }
            return v3.vectorize(Wide(self));
        }
        self.holds_everywhere()
    }

    #[inline(always)]
    fn holds_everywhere(&self) -> bool {
        (0..self.block.width()).step_by(TOGETHER).all(|first| self.holds_from(first))
    }

    #[inline(always)]
    fn holds_from(&self, first: usize) -> bool {
        let mut u = [[0.0; TOGETHER]; 8];
        for i in 0..8 {
            u[i] = [self.base[i]; TOGETHER];
            if self.equations[i] != HELD {
                let lanes = &self.block.of(self.equations[i])[first..first + TOGETHER];
                for lane in 0..TOGETHER {
                    u[i][lane] += lanes[lane];
                }
            }
        }
        self.samples.iter().zip(self.points).all(|(sample, point)| {
            let mut strain = [[0.0; TOGETHER]; 4];
            for a in 0..4 {
                for lane in 0..TOGETHER {
                    strain[0][lane] += sample.dx[a] * u[2 * a][lane];
                    strain[1][lane] += sample.dy[a] * u[2 * a + 1][lane];
                    strain[3][lane] += sample.dy[a] * u[2 * a][lane] + sample.dx[a] * u[2 * a + 1][lane];
                }
            }
            self.solid.surely_holds(&strain, &point.memory)
        })
    }
}
