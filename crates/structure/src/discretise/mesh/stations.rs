//! Stations: the places along a span at which nodes stand, the same in all of its rings.
//!
//! Joints of every ring, the crown and the tops of layers of rows are stations; between two of them stations follow at
//! equal steps.

use super::arch::{Arch, End};
use super::saddle::Layer;

/// Share of a voussoir within which joints of two rings are one station: thinner slivers would be all but flat.
const SLIVER: f64 = 0.05;

/// Share of a voussoir within which a layer ends at a joint.
const NEAR: f64 = 0.25;

/// A place between which stations follow at equal steps.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Break {
    share: f64,
    /// How many elements follow, up to the next.
    parts: usize,
}

/// The stations of a span while they are counted.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Breaks {
    breaks: Vec<Break>,
    /// For each ring, the breaks at which its joints stand.
    joints: Vec<Vec<usize>>,
    crown: usize,
    /// Breaks at which layers end, from each springing.
    layers: [Vec<usize>; 2],
    lengths: Vec<f64>,
}

/// The stations of a span.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stations {
    /// Shares of the arc length, from the left springing.
    pub shares: Vec<f64>,
    /// For each ring, the stations at which its joints stand, springings included.
    pub joints: Vec<Vec<usize>>,
    /// The station of the crown.
    pub crown: usize,
    /// Stations at which layers of rows end, counted from the left and from the right springing.
    pub layers: [Vec<usize>; 2],
}

impl Stations {
    /// Stations of rows at the left (`end` 0) or the right end.
    pub(super) fn rows(&self, end: usize) -> usize {
        self.layers[end].last().copied().unwrap_or(0)
    }
}

impl Breaks {
    /// The breaks of `arch`, with the layers over its left and its right support, and elements of about `size` [m].
    fn new(arch: &Arch<'_>, [left, right]: [&[Layer]; 2], size: f64) -> Breaks {
        let mut shares: Vec<f64> = Vec::new();
        let rings = &arch.span.rings;
        let mut wanted: Vec<Vec<f64>> = Vec::new();
        for ring in rings {
            let n = ring.voussoirs.max(1);
            let near = SLIVER / n as f64;
            let own = (0..=n).map(|i| insert(&mut shares, i as f64 / n as f64, near)).collect();
            wanted.push(own);
        }
        let finest = rings.iter().map(|ring| ring.voussoirs).max().unwrap_or(1) as f64;
        let crown = insert(&mut shares, 0.5, 1e-9);
        let mut top = |share: f64| insert(&mut shares, share, NEAR / finest);
        let left: Vec<f64> = left.iter().map(|layer| top(layer.shares[1])).collect();
        let right: Vec<f64> = right.iter().map(|layer| top(1.0 - layer.shares[0])).collect();
        let find = |share: f64| shares.partition_point(|s| *s < share - 1e-12);
        let joints: Vec<Vec<usize>> = wanted.iter().map(|ring| ring.iter().map(|s| find(*s)).collect()).collect();
        let crown = find(crown);
        let last = shares.len() - 1;
        // Each layer has at least one interval, and none reaches the crown.
        let climb = |side: &[f64], from: End| {
            let mut found: Vec<usize> = Vec::new();
            for &share in side {
                let index = find(share);
                let steps = if from == End::Left { index } else { last - index };
                let room = if from == End::Left { crown } else { last - crown };
                let steps = steps.max(found.last().map_or(0, |k| *k) + 1);
                if steps < room {
                    found.push(steps);
                }
            }
            found
        };
        let layers = [climb(&left, End::Left), climb(&right, End::Right)];
        let lengths: Vec<f64> = shares.windows(2).map(|w| arch.extrados_length(w[0], w[1])).collect();
        let mut breaks: Vec<Break> = shares.iter().map(|&share| Break { share, parts: 0 }).collect();
        for (k, length) in lengths.iter().enumerate() {
            let voussoir = joints.iter().any(|ring| ring.windows(2).any(|w| w[0] == k && w[1] == k + 1));
            let inside = (arch.intrados(shares[k + 1]) - arch.intrados(shares[k])).norm();
            let parts = (length.max(inside) / size - 1e-6).ceil().max(1.0) as usize;
            breaks[k].parts = parts.max(if voussoir { 2 } else { 1 });
        }
        Breaks { breaks, joints, crown, layers, lengths }
    }

    /// The intervals of a layer at an end.
    fn intervals(&self, end: End, layer: usize) -> std::ops::Range<usize> {
        let tops = &self.layers[usize::from(end == End::Right)];
        let (low, high) = (if layer == 0 { 0 } else { tops[layer - 1] }, tops[layer]);
        let last = self.breaks.len() - 1;
        if end == End::Left { low..high } else { last - high..last - low }
    }

    fn rows(&self, end: End, layer: usize) -> usize {
        self.intervals(end, layer).map(|k| self.breaks[k].parts).sum()
    }

    /// Adds elements to a layer until it has so many rows, each time where they are longest.
    fn stretch(&mut self, end: End, layer: usize, rows: usize) {
        for _ in self.rows(end, layer)..rows {
            let length = |k: usize| self.lengths[k] / self.breaks[k].parts as f64;
            let longest = self.intervals(end, layer).max_by(|a, b| length(*a).total_cmp(&length(*b)));
            if let Some(k) = longest {
                self.breaks[k].parts += 1;
            }
        }
    }

    pub(super) fn stations(&self) -> Stations {
        let mut shares = Vec::new();
        let mut first = Vec::with_capacity(self.breaks.len());
        for (k, b) in self.breaks.iter().enumerate() {
            first.push(shares.len());
            let next = self.breaks.get(k + 1).map_or(b.share, |next| next.share);
            let parts = b.parts.max(1);
            shares.extend((0..parts).map(|i| b.share + (next - b.share) * i as f64 / parts as f64));
        }
        let last = shares.len() - 1;
        let joints = self.joints.iter().map(|ring| ring.iter().map(|&k| first[k]).collect()).collect();
        let breaks = self.breaks.len() - 1;
        let left = self.layers[0].iter().map(|&k| first[k]).collect();
        let right = self.layers[1].iter().map(|&k| last - first[breaks - k]).collect();
        Stations { crown: first[self.crown], joints, layers: [left, right], shares }
    }
}

/// Makes the layers over a pier the same in number and rows, on both sides.
pub(super) fn match_rows(left: &mut Breaks, right: &mut Breaks) {
    let layers = left.layers[1].len().min(right.layers[0].len());
    left.layers[1].truncate(layers);
    right.layers[0].truncate(layers);
    for layer in 0..layers {
        let rows = left.rows(End::Right, layer).max(right.rows(End::Left, layer));
        left.stretch(End::Right, layer, rows);
        right.stretch(End::Left, layer, rows);
    }
}

/// The breaks of all spans.
pub(super) fn count(arches: &[Arch<'_>], layers: &[Vec<Layer>], size: f64) -> Vec<Breaks> {
    let mut all: Vec<Breaks> =
        arches.iter().enumerate().map(|(i, arch)| Breaks::new(arch, [&layers[i], &layers[i + 1]], size)).collect();
    for i in 1..all.len() {
        let (left, right) = all.split_at_mut(i);
        match_rows(&mut left[i - 1], &mut right[0]);
    }
    all
}

/// Puts a share into the list unless one is as near as `near`; returns the one that stands there.
fn insert(shares: &mut Vec<f64>, share: f64, near: f64) -> f64 {
    let k = shares.partition_point(|s| *s < share);
    let close = |i: usize| shares.get(i).copied().filter(|s| (s - share).abs() <= near);
    let below = k.checked_sub(1).and_then(close);
    match (below, close(k)) {
        (Some(a), Some(b)) if share - a < b - share => a,
        (_, Some(b)) => b,
        (Some(a), None) => a,
        (None, None) => {
            shares.insert(k, share);
            share
        }
    }
}
