//! The floor of the continuum as a chain of sides, and how levels cut regions off it.
//!
//! A chain runs from the upper left corner down the left end, along the extrados to the right and up the right end. Each level in turn cuts
//! off what lies between the chain and the level, and takes the place of that part of the chain. Corners within a millimetre of a level
//! count as lying on it, so that no region is thinner.

use super::{Against, NEAR, SNAP};
use crate::discretise::Discretised;
use crate::discretise::extrados::{Face, Stretch};
use mechanics::ids::BlockId;
use mechanics::plane::{Vec2, vec2};

/// What a side of the chain bears against; none between two regions.
type Tag = Option<Against>;

/// Sides one after the other, never to the left, with the continuum above them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    pub points: Vec<Vec2>,
    /// One fewer than points.
    pub tags: Vec<Tag>,
}

impl Chain {
    pub(super) fn from(start: Vec2) -> Chain {
        Chain { points: vec![start], tags: Vec::new() }
    }

    pub(super) fn last(&self) -> Vec2 {
        self.points[self.points.len() - 1]
    }

    /// Goes on to a point; one that is the last already adds nothing.
    pub(super) fn to(&mut self, point: Vec2, tag: Tag) {
        if (point - self.last()).norm() > NEAR {
            self.points.push(point);
            self.tags.push(tag);
        }
    }

    pub(super) fn sides(&self) -> impl Iterator<Item = ([Vec2; 2], Tag)> {
        self.points.windows(2).map(|pair| [pair[0], pair[1]]).zip(self.tags.iter().copied())
    }

    /// Middle between its ends [m].
    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.points[0].x + self.last().x)
    }

    /// Takes back what lies to the right of `x`.
    pub(super) fn back_to(&mut self, x: f64) {
        while self.points.len() > 1 && self.last().x > x + NEAR {
            let (Some(beyond), Some(tag)) = (self.points.pop(), self.tags.pop()) else { return };
            let before = self.last();
            if before.x < x {
                self.to(before + (beyond - before) * ((x - before.x) / (beyond.x - before.x)), tag);
            }
        }
    }

    /// Adds a corner wherever a side crosses a level.
    pub(super) fn cross(&mut self, level: f64) {
        let mut crossed = Chain::from(self.points[0]);
        for ([a, b], tag) in self.sides() {
            let (from, to) = (a.y - level, b.y - level);
            if from.min(to) < -SNAP && from.max(to) > SNAP {
                crossed.to(vec2(a.x + (b.x - a.x) * (from / (from - to)), level), tag);
            }
            crossed.to(b, tag);
        }
        *self = crossed;
    }

    /// Cuts off what lies below a level, in regions that end at the places `cuts`, too; the upper side that closes each is left out.
    pub(super) fn raise(&mut self, level: f64, cuts: &[f64]) -> Vec<Chain> {
        self.cross(level);
        let below = |p: &Vec2| p.y < level - SNAP;
        let mut raised = Chain::from(self.points[0]);
        let mut pieces = Vec::new();
        let mut k = 0;
        while k + 1 < self.points.len() {
            if !below(&self.points[k + 1]) {
                raised.to(self.points[k + 1], self.tags[k]);
                k += 1;
                continue;
            }
            // Both ends of the chain are at the top.
            let rest = self.points[k + 1..].iter().position(|p| !below(p));
            let end = rest.map_or(self.points.len() - 1, |rest| k + 1 + rest);
            let run = Chain { points: self.points[k..=end].to_vec(), tags: self.tags[k..end].to_vec() };
            if run.last().x - run.points[0].x < SNAP {
                // A slot too narrow for a region.
                raised.to(run.last(), self.tags[k]);
            } else {
                for piece in run.parts(level, cuts) {
                    raised.to(piece.last(), None);
                    pieces.push(piece);
                }
            }
            k = end;
        }
        *self = raised;
        pieces
    }

    /// The parts between the places of vertical cuts up to a level.
    pub(super) fn parts(&self, level: f64, cuts: &[f64]) -> Vec<Chain> {
        let (from, to) = (self.points[0].x + SNAP, self.last().x - SNAP);
        let mut parts = Vec::new();
        let mut rest = self.clone();
        for &x in cuts.iter().filter(|x| from < **x && **x < to) {
            let Some(foot) = rest.points.iter().position(|p| (p.x - x).abs() < NEAR) else { continue };
            let head = vec2(x, level);
            let mut part = Chain { points: rest.points[..=foot].to_vec(), tags: rest.tags[..foot].to_vec() };
            part.to(head, None);
            parts.push(part);
            let mut next = Chain::from(head);
            next.to(rest.points[foot], None);
            rest.points[foot + 1..].iter().zip(&rest.tags[foot..]).for_each(|(p, tag)| next.to(*p, *tag));
            rest = next;
        }
        parts.push(rest);
        parts
    }
}

/// The chain from the upper left corner along the extrados to the upper right one; none where the extrados reaches the top.
pub(super) fn floor(discretised: &Discretised, ends: [f64; 2], ground: [f64; 2], top: f64) -> Option<Chain> {
    let extrados = &discretised.extrados;
    let inside = |s: &&Stretch| s.right.x > ends[0] + SNAP && s.left.x < ends[1] - SNAP;
    let clipped = |s: &Stretch| {
        let (left, right) = (s.left.x.max(ends[0]), s.right.x.min(ends[1]));
        let at = |x: f64, end: Vec2| if x == end.x { end } else { s.at(x) };
        Stretch { left: at(left, s.left), right: at(right, s.right), ..*s }
    };
    let stretches: Vec<Stretch> = extrados.stretches.iter().filter(inside).map(clipped).collect();
    let (first, last) = (stretches.first()?, stretches.last()?);
    if stretches.iter().any(|s| s.left.y.max(s.right.y) > top - SNAP) {
        return None;
    }
    let mut chain = Chain::from(vec2(ends[0], top));
    let end = Some(Against::End);
    let level = if first.left.x - ends[0] > SNAP { ground[0] } else { first.left.y };
    chain.to(vec2(ends[0], level), end);
    if first.left.x - ends[0] > SNAP {
        chain.to(vec2(first.left.x, level), Some(Against::Ground));
    }
    let mut before = first.block;
    for stretch in &stretches {
        let mut left = stretch.left;
        if left.x < chain.last().x - NEAR {
            // A back that overhangs is no part of the extrados: what is above shadows what is below.
            if left.y > chain.last().y {
                chain.back_to(left.x);
            } else if stretch.right.x > chain.last().x + NEAR {
                left = stretch.at(chain.last().x);
            } else {
                continue;
            }
        }
        join(&mut chain, left, [before, stretch.block], &extrados.faces);
        chain.to(stretch.right, Some(Against::Block(stretch.block)));
        before = stretch.block;
    }
    if ends[1] - last.right.x > SNAP {
        join(&mut chain, vec2(last.right.x, ground[1]), [before; 2], &extrados.faces);
        chain.to(vec2(ends[1], ground[1]), Some(Against::Ground));
    }
    chain.to(vec2(ends[1], top), end);
    Some(chain)
}

/// Goes on to the next stretch, which need not begin where the last ended: a step belongs to the higher of the two blocks, or to
/// those whose faces stand there.
pub(super) fn join(chain: &mut Chain, to: Vec2, [before, after]: [BlockId; 2], faces: &[Face]) {
    let from = chain.last();
    let tag = |block: BlockId| Some(Against::Block(block));
    let upper = if to.y > from.y { after } else { before };
    let mut levels = vec![from.y, to.y];
    let here = |face: &&Face| (face.x - from.x).abs() < SNAP;
    if (to.x - from.x).abs() < NEAR {
        let between = |y: &f64| *y > from.y.min(to.y) + NEAR && *y < from.y.max(to.y) - NEAR;
        levels.extend(faces.iter().filter(here).flat_map(|face| face.levels).filter(between));
    }
    levels.sort_by(f64::total_cmp);
    if to.y < from.y {
        levels.reverse();
    }
    for pair in levels.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        let stands = |face: &&Face| here(face) && face.levels[0] < middle && middle < face.levels[1];
        let block = faces.iter().find(stands).map_or(upper, |face| face.block);
        chain.to(if pair[1] == to.y { to } else { vec2(from.x, pair[1]) }, tag(block));
    }
}
