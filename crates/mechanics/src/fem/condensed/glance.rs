//! A first glance at all parts, as they were when the run began: which of them surely answer linearly in many solutions at a time. Nearly all do,
//! nearly always. What has to be known for that lies side by side in the order of the parts, 190 bytes of each in place of 3 kB. Of 18,462 parts some
//! hundred are left to be looked at; all of them in 31 solutions take 2.8 ms, and took 22 ms while points were looked at one by one.

use super::closed::Closed;
use super::hourglass::Hourglass;
use super::parts::Part;
use super::rows::widest;
use crate::fem::factor::Block;
use crate::fem::joint::PairMemory;
use crate::fem::model::Model;

/// What there is to know of each part.
#[derive(Debug, Default)]
pub(super) struct Glances {
    parts: Vec<Glance>,
    /// Equations and weights of the springs' openings.
    terms: Vec<(u32, f64)>,
}

#[derive(Debug)]
enum Glance {
    Spring(Spring),
    Quad(Hourglass),
    /// Its law has to be asked.
    Unknown,
}

/// What [`Closed`] needs.
#[derive(Debug)]
struct Spring {
    /// Where the terms of its openings begin and end.
    openings: [[u32; 2]; 2],
    base: [f64; 2],
    area: f64,
    /// Kind of its law.
    kind: u32,
    memory: PairMemory,
}

impl Glances {
    /// At parts as they are now.
    pub fn new(model: &Model, parts: &[Part]) -> Glances {
        let mut glances = Glances::default();
        for part in parts {
            let glance = match (part.quiet(model), part.closed(model)) {
                (Some(quad), _) => Hourglass::new(&quad).map_or(Glance::Unknown, Glance::Quad),
                (None, Some((kind, spring))) => glances.spring(kind, &spring),
                (None, None) => Glance::Unknown,
            };
            glances.parts.push(glance);
        }
        glances
    }

    fn spring(&mut self, kind: usize, spring: &Closed<'_>) -> Glance {
        let openings = spring.openings.map(|terms| {
            let start = self.terms.len() as u32;
            self.terms.extend_from_slice(terms);
            [start, self.terms.len() as u32]
        });
        let Closed { base, area, memory, .. } = *spring;
        Glance::Spring(Spring { openings, base, area, kind: kind as u32, memory: *memory })
    }

    /// Parts by number in ascending order, less those that are `skipped`, that may not answer linearly in one of the first solutions. They remember
    /// what they did when they were glanced at.
    pub fn doubtful(&self, model: &Model, block: &Block, lanes: usize, skipped: &[bool]) -> Vec<usize> {
        let all = All { glances: self, model, block, lanes, skipped };
        if fuses() { widest(Fused(all)) } else { all.doubtful::<false>() }
    }

    #[inline(always)]
    fn holds<const FUSED: bool>(&self, index: usize, model: &Model, block: &Block, lanes: usize) -> bool {
        match &self.parts[index] {
            Glance::Quad(quad) => quad.holds::<FUSED>(block, lanes),
            Glance::Spring(spring) => {
                let [[a, b], [c, d]] = spring.openings.map(|range| range.map(|end| end as usize));
                let openings = [&self.terms[a..b], &self.terms[c..d]];
                let law = &model.joints[spring.kind as usize];
                let Spring { base, area, memory, .. } = spring;
                Closed { law, area: *area, memory, base: *base, openings }.holds(block, lanes)
            }
            Glance::Unknown => false,
        }
    }
}

/// Whether the processor multiplies and adds at once.
fn fuses() -> bool {
    #[cfg(target_arch = "x86_64")]
    return pulp::x86::V3::try_new().is_some();
    #[cfg(not(target_arch = "x86_64"))]
    false
}

struct All<'a> {
    glances: &'a Glances,
    model: &'a Model,
    block: &'a Block,
    lanes: usize,
    skipped: &'a [bool],
}

impl All<'_> {
    #[inline(always)]
    fn doubtful<const FUSED: bool>(&self) -> Vec<usize> {
        let mut doubtful = Vec::new();
        for (index, skipped) in self.skipped.iter().enumerate() {
            if !skipped && !self.glances.holds::<FUSED>(index, self.model, self.block, self.lanes) {
                doubtful.push(index);
            }
        }
        doubtful
    }
}

/// The work on a processor that multiplies and adds at once.
struct Fused<'a>(All<'a>);

impl pulp::NullaryFnOnce for Fused<'_> {
    type Output = Vec<usize>;
    #[inline(always)]
    fn call(self) -> Vec<usize> {
        self.0.doubtful::<true>()
    }
}

#[cfg(test)]
mod tests;
