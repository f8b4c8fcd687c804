//! What stands where, before any node is made: rings, levels, and the materials over each support.

use super::arch::{Arch, End};
use super::patch::growing;
use super::saddle::{Layer, Side};
use super::sets::Role;
use super::stations::Stations;
use super::{MeshError, MeshOptions};
use crate::discretise::curve::Curve;
use crate::discretise::springings::springings;
use bridge::{Bridge, LayerKind};
use mechanics::plane::Vec2;
/// Levels and places that regions share.
pub(super) struct Layout {
    /// Surface [m].
    pub(super) surface: f64,
    /// Backs of the abutments [m].
    pub(super) backs: [f64; 2],
    /// How far fill behind the abutments reaches [m].
    pub(super) extent: f64,
    /// Distances of columns behind either abutment from its back [m].
    pub(super) behind: Vec<f64>,
    /// What lies over each support, from the left.
    pub(super) over: Vec<Over>,
    /// Rows of fill between the columns' feet and the surface.
    pub(super) rows: usize,
}

/// The materials over a support, between the crowns on both sides of it.
pub(super) struct Over {
    /// Up to here [m].
    pub(super) right: f64,
    /// Levels of the upper faces of backing and haunch fill [m]; minus infinity where there is none.
    pub(super) levels: [f64; 2],
    /// Whether a row ends at each of them: elements then belong by their row, and by their middles otherwise.
    pub(super) met: [bool; 2],
    /// The levels that rows reach up to: the number of rows below each.
    pub(super) rows: Vec<(usize, Option<f64>)>,
}

impl Over {
    /// What row `row` is, where it ends at a level.
    pub(super) fn role(&self, row: usize) -> Option<Role> {
        let level = self.rows.iter().find(|(end, _)| row < *end)?.1?;
        Some(fill(|k| level <= self.levels[k]))
    }
}

impl Layout {
    /// What fill at a point is.
    pub(super) fn role(&self, at: Vec2) -> Role {
        let [left, right] = self.backs;
        if at.x < left || at.x > right {
            let (depth, end) = if at.x < left { (left - at.x, End::Left) } else { (at.x - right, End::Right) };
            return if depth < self.extent { Role::AbutmentFill(end) } else { Role::Fill };
        }
        let Some(over) = self.over.iter().find(|over| at.x <= over.right) else { return Role::Fill };
        fill(|k| !over.met[k] && at.y < over.levels[k])
    }
}

/// What lies over a support: below the first of its levels, the second, or neither.
fn fill(below: impl Fn(usize) -> bool) -> Role {
    if below(0) {
        Role::Backing
    } else if below(1) {
        Role::HaunchFill
    } else {
        Role::Fill
    }
}

/// The rings of all spans where they stand: the left springing of the first one at the origin.
pub(super) fn arches(bridge: &Bridge) -> Result<Vec<Arch<'_>>, MeshError> {
    let mut arches = Vec::new();
    for (i, (span, ends)) in bridge.spans.iter().zip(springings(bridge)).enumerate() {
        let curve = Curve::new(span, ends[0]).map_err(|misfit| MeshError::Intrados { span: i + 1, misfit })?;
        arches.push(Arch { span, curve });
    }
    Ok(arches)
}

/// Fill needs room on a pier's top: a fiftieth of an element.
pub(super) fn room_on_piers(arches: &[Arch<'_>], size: f64) -> Result<(), MeshError> {
    let least = 0.02 * size;
    for (i, pair) in arches.windows(2).enumerate() {
        let gap = pair[1].extrados(0.0).x - pair[0].extrados(1.0).x;
        if gap < least {
            return Err(MeshError::RingsMeet { support: i + 1, gap, least, wider: least - gap });
        }
    }
    Ok(())
}

/// Level of the surface [m], and the weight of the ballast on it [Pa]. Ballast on top spreads loads and is no part of the mesh.
pub(super) fn surface(bridge: &Bridge, arches: &[Arch<'_>]) -> Result<(f64, f64), MeshError> {
    const TRIED: usize = 256;
    if bridge.cover.road.is_some() {
        return Err(MeshError::RoadNotLevel);
    }
    if !bridge.cover.voids.is_empty() {
        return Err(MeshError::Voids);
    }
    if bridge.cover.internal_walls.is_some() {
        return Err(MeshError::InternalWalls);
    }
    let highest = |arch: &Arch<'_>| {
        (0..=TRIED).map(|k| arch.extrados(k as f64 / TRIED as f64).y).fold(f64::NEG_INFINITY, f64::max)
    };
    let crown = arches.iter().map(highest).fold(f64::NEG_INFINITY, f64::max);
    let ballast = bridge.cover.layers.iter().rev().take_while(|layer| layer.name == LayerKind::Ballast);
    let (mut depth, mut pressure) = (bridge.cover.depth, 0.0);
    for layer in ballast {
        depth -= layer.thickness;
        pressure += layer.thickness * layer.density * bridge.gravity;
    }
    if depth > 1e-3 { Ok((crown + depth, pressure)) } else { Err(MeshError::NoFill) }
}

/// Level of the springings on a support: halfway between both where they differ [m].
fn springing(arches: &[Arch<'_>], support: usize) -> f64 {
    let left = support.checked_sub(1).map(|k| arches[k].intrados(1.0).y);
    let right = arches.get(support).map(|arch| arch.intrados(0.0).y);
    match (left, right) {
        (Some(left), Some(right)) => 0.5 * (left + right),
        (one, other) => one.or(other).unwrap_or(0.0),
    }
}

/// Levels of the upper faces of backing and haunch fill over a support [m], where there are some.
fn faces(bridge: &Bridge, arches: &[Arch<'_>], support: usize) -> [Option<f64>; 2] {
    let heights = [bridge.cover.backing.map(|b| b.height), bridge.service.haunch_fill.map(|h| h.height)];
    heights.map(|height| Some(springing(arches, support) + height?))
}

/// Levels at which the material over a support changes, from below [m].
pub(super) fn levels(bridge: &Bridge, arches: &[Arch<'_>], support: usize) -> Vec<f64> {
    let mut levels: Vec<f64> = faces(bridge, arches, support).into_iter().flatten().collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    levels
}

/// Backs of the abutments [m].
pub(super) fn backs(bridge: &Bridge, arches: &[Arch<'_>]) -> [f64; 2] {
    let last = &arches[arches.len() - 1];
    [
        arches[0].extrados(0.0).x.min(arches[0].intrados(0.0).x) - bridge.abutments[0].top_width,
        last.extrados(1.0).x.max(last.intrados(1.0).x) + bridge.abutments[1].top_width,
    ]
}

/// What stands on both sides of support `i`.
pub(super) fn sides<'a>(arches: &'a [Arch<'a>], backs: [f64; 2], i: usize) -> [Side<'a>; 2] {
    let left = match i.checked_sub(1) {
        Some(k) => Side::Arch(&arches[k], End::Right),
        None => Side::Back(backs[0]),
    };
    let right = match arches.get(i) {
        Some(arch) => Side::Arch(arch, End::Left),
        None => Side::Back(backs[1]),
    };
    [left, right]
}

pub(super) fn layout(
    bridge: &Bridge,
    (arches, stations, layers): (&[Arch<'_>], &[Stations], &[Vec<Layer>]),
    options: MeshOptions,
    surface: f64,
    backs: [f64; 2],
) -> Layout {
    let size = options.size;
    // From the lowest base up.
    let piers = bridge.piers.iter().zip(arches.windows(2));
    let piers = piers.map(|(pier, pair)| pier.height - pair[0].intrados(1.0).y.min(pair[1].intrados(0.0).y));
    let outer = [arches[0].intrados(0.0).y, arches[arches.len() - 1].intrados(1.0).y];
    let abutments = bridge.abutments.iter().zip(outer).map(|(abutment, springing)| abutment.height - springing);
    let height = piers.chain(abutments).fold(f64::NEG_INFINITY, f64::max) + surface;
    let distance = options.side_distance.unwrap_or(2.0 * height);
    let extent = bridge.service.abutment_fill.extent.unwrap_or(f64::INFINITY);
    // Feet of the columns: the lowest, where rows end, and the highest, at the crown.
    let mut feet = [f64::INFINITY, f64::NEG_INFINITY];
    for (arch, s) in arches.iter().zip(stations) {
        for k in [s.rows(0), s.shares.len() - 1 - s.rows(1), s.crown] {
            let y = arch.extrados(s.shares[k]).y;
            feet = [feet[0].min(y), feet[1].max(y)];
        }
    }
    let (deep, shallow) = ((surface - feet[0]).max(0.0), (surface - feet[1]).max(0.0));
    let rows = ((deep * shallow).sqrt() / size).max(shallow / size).ceil().max(2.0) as usize;
    let most = 6.0 * size;
    let (first, growth) = (1.2 * size, 1.12);
    let mut behind = growing(extent.min(distance), first, growth, most);
    if extent < distance {
        let step = behind.windows(2).map(|w| w[1] - w[0]).fold(first, f64::max);
        behind.extend(growing(distance - extent, step, growth, most.max(step)).iter().skip(1).map(|d| extent + d));
    }
    Layout { surface, backs, extent, behind, over: over(bridge, arches, stations, layers), rows }
}

/// What lies over each support.
pub(super) fn over(bridge: &Bridge, arches: &[Arch<'_>], stations: &[Stations], layers: &[Vec<Layer>]) -> Vec<Over> {
    (0..=arches.len())
        .map(|i| {
            let levels = faces(bridge, arches, i).map(|level| level.unwrap_or(f64::NEG_INFINITY));
            let ends = stations.get(i).map_or_else(|| &stations[i - 1].layers[1], |right| &right.layers[0]);
            let rows: Vec<_> = ends.iter().copied().zip(layers[i].iter().map(|layer| layer.level)).collect();
            let met = levels.map(|level| rows.iter().any(|(_, reached)| *reached == Some(level)));
            let right = arches.get(i).map_or(f64::INFINITY, |arch| arch.intrados(0.5).x);
            Over { right, levels, met, rows }
        })
        .collect()
}

/// Refuses before memory is asked for.
pub(super) fn refuse_too_fine(
    bridge: &Bridge,
    arches: &[Arch<'_>],
    stations: &[Stations],
    layout: &Layout,
    options: MeshOptions,
) -> Result<(), MeshError> {
    let rings: usize = arches
        .iter()
        .zip(stations)
        .map(|(arch, s)| {
            let doubled = s.shares.len() + arch.span.rings.iter().map(|r| r.voussoirs).max().unwrap_or(0);
            doubled * options.ring_nodes * arch.span.rings.len()
        })
        .sum();
    let along: usize = stations.iter().map(|s| s.shares.len()).sum();
    let columns = along + 2 * layout.behind.len();
    // Rows over supports, their masonry and the fill behind it: elements there are about three times as long.
    let wide =
        bridge.piers.iter().map(|p| p.width.max(p.base_width)).chain(bridge.abutments.iter().map(|a| a.top_width));
    let high = bridge.piers.iter().map(|p| p.height).chain(bridge.abutments.iter().map(|a| a.height));
    let below = wide.zip(high).map(|(w, h)| w * (h + 3.0 * layout.surface) / 3.0).sum::<f64>();
    let tall = bridge.abutments.iter().map(|a| a.height + 3.0 * layout.surface).sum::<f64>() / 6.0;
    let behind = layout.behind.len() as f64 * tall / options.size;
    let others = below / (options.size * options.size) + 2.0 * behind;
    let nodes = rings.saturating_add(columns.saturating_mul(layout.rows + 1)).saturating_add(others as usize);
    let most = options.most_nodes;
    if nodes > most { Err(MeshError::TooFine { nodes, most }) } else { Ok(()) }
}
