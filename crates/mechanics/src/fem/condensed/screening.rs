//! Screening: a cheap batched test that skips parts that are provably linear in many solutions at a time.
//!
//! The data of the test lie side by side in the order of the parts: 190 bytes of each in place of the 3 kB of a part. They hold
//! the memory that parts had when the run began. Of 18,462 parts some hundred remain to be rechecked one by one; the test of all
//! of them in 31 solutions takes 2.8 ms, and took 22 ms point by point.

use super::hourglass::HourglassBound;
use super::parts::Part;
use super::spring_check::SpringCheck;
use crate::fem::factor::Block;
use crate::fem::model::Model;
use crate::wide::wide;

/// The tests of all parts.
#[derive(Debug, Default)]
pub(super) struct Screening {
    parts: Vec<Test>,
    /// Equations and weights of the springs' openings.
    terms: Vec<(u32, f64)>,
}

/// How a part is tested.
#[derive(Debug)]
enum Test {
    /// With the ranges of its two openings among the terms.
    Spring(SpringCheck, [[u32; 2]; 2]),
    Quad(HourglassBound),
    /// Nothing is proven of it: its law has to be evaluated.
    Unproven,
}

impl Screening {
    /// Collects the tests of parts with the memory that they have now.
    pub(super) fn new(model: &Model, parts: &[Part]) -> Screening {
        let mut terms: Vec<(u32, f64)> = Vec::new();
        let mut range = |opening: &[(u32, f64)]| {
            let start = terms.len() as u32;
            terms.extend_from_slice(opening);
            [start, terms.len() as u32]
        };
        let mut tests = Vec::with_capacity(parts.len());
        for part in parts {
            tests.push(match (part.quad_check(model), part.spring_check(model)) {
                (Some(quad), _) => HourglassBound::new(&quad).map_or(Test::Unproven, Test::Quad),
                (None, Some(spring)) => Test::Spring(spring, part.openings().map(&mut range)),
                (None, None) => Test::Unproven,
            });
        }
        Screening { parts: tests, terms }
    }

    /// Finds the parts that are not proven linear in all of the first solutions of `block`, in ascending order; passes over those
    /// marked in `skip`.
    pub(super) fn unproven(&self, model: &Model, block: &Block, solutions: usize, skip: &[bool]) -> Vec<usize> {
        if has_fma() {
            wide(
                #[inline(always)]
                || self.screen::<true>(model, block, solutions, skip),
            )
        } else {
            self.screen::<false>(model, block, solutions, skip)
        }
    }

    /// The same; `FUSED` uses fused multiply-add.
    #[inline(always)]
    fn screen<const FUSED: bool>(&self, model: &Model, block: &Block, solutions: usize, skip: &[bool]) -> Vec<usize> {
        let mut parts = Vec::new();
        for (index, skipped) in skip.iter().enumerate() {
            if !skipped && !self.proves_linear::<FUSED>(index, model, block, solutions) {
                parts.push(index);
            }
        }
        parts
    }

    /// Whether a part is proven linear in all of the first solutions of `block`.
    #[inline(always)]
    fn proves_linear<const FUSED: bool>(&self, index: usize, model: &Model, block: &Block, solutions: usize) -> bool {
        match &self.parts[index] {
            Test::Quad(quad) => quad.proves_linear::<FUSED>(block, solutions),
            Test::Spring(spring, openings) => {
                let [[a, b], [c, d]] = openings.map(|range| range.map(|end| end as usize));
                spring.proves_linear(model, [&self.terms[a..b], &self.terms[c..d]], block, solutions)
            }
            Test::Unproven => false,
        }
    }
}

/// Whether the processor has a fused multiply-add.
fn has_fma() -> bool {
    #[cfg(target_arch = "x86_64")]
    return pulp::x86::V3::try_new().is_some();
    #[cfg(not(target_arch = "x86_64"))]
    false
}

#[cfg(test)]
mod tests;
