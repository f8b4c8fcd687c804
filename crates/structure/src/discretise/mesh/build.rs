//! The mesh of a bridge, from the rings outwards.

use super::arch::{Arch, End};
use super::layout::{Layout, arches, backs, layout, levels, refuse_too_fine, room_on_piers, sides, surface};
use super::patch::{Points, spaced};
use super::saddle::{self, Layer};
use super::sets::{NodeSets, Role, Seam, SpanSets, Voussoir};
use super::stations::{self, Stations};
use super::supports::{Flank, Support, support};
use super::{LEAST_JACOBIAN, MeshError, MeshOptions, Meshed, quality};
use bridge::Bridge;
use mechanics::fem::{Interface, Mesh, Quad, Quadrature};
use mechanics::ids::{InterfaceId, NodeId, QuadId, Table, ZoneId};
use mechanics::plane::{Vec2, vec2};
use std::collections::BTreeMap;

/// Rows of nodes from the bottom, each from left to right.
type Grid = Vec<Vec<NodeId>>;

/// A way to cut fill into rows whose elements all have at least this scaled Jacobian is taken; otherwise the one with the largest.
const FAIR: f64 = 0.15;

/// Meshes a bridge with other options.
///
/// # Errors
/// Those of [`super::mesh()`].
pub fn mesh_with(bridge: &Bridge, options: MeshOptions) -> Result<Meshed, MeshError> {
    let arches = arches(bridge)?;
    room_on_piers(&arches, options.size)?;
    let (surface, ballast_pressure) = surface(bridge, &arches)?;
    let mut best: Option<Meshed> = None;
    // Fill over supports is cut into rows up to the levels at which materials change, and further where the extrados is steep; the best way first.
    for [to_levels, where_steep] in [[true, true], [false, true], [true, false], [false, false]] {
        let meshed = build_by(bridge, &arches, options, [to_levels, where_steep], [surface, ballast_pressure])?;
        let value = meshed.quality.scaled_jacobian;
        if value >= FAIR {
            return Ok(meshed);
        }
        if best.as_ref().is_none_or(|known| value > known.quality.scaled_jacobian) {
            best = Some(meshed);
        }
    }
    match best {
        Some(meshed) if meshed.quality.scaled_jacobian >= LEAST_JACOBIAN => Ok(meshed),
        Some(meshed) => Err(folded(&meshed)),
        None => Err(MeshError::NoFill),
    }
}

fn build_by(
    bridge: &Bridge,
    arches: &[Arch<'_>],
    options: MeshOptions,
    [to_levels, where_steep]: [bool; 2],
    [surface, ballast_pressure]: [f64; 2],
) -> Result<Meshed, MeshError> {
    let size = options.size;
    let backs = backs(bridge, arches);
    let layers: Vec<Vec<Layer>> = (0..=arches.len())
        .map(|i| {
            let [left, right] = sides(arches, backs, i);
            let levels = if to_levels { levels(bridge, arches, i) } else { Vec::new() };
            saddle::layers(&left, &right, &levels, where_steep, size)
        })
        .collect();
    let stations: Vec<Stations> =
        stations::count(arches, &layers, size).iter().map(stations::Breaks::stations).collect();
    let layout = layout(bridge, (arches, &stations, &layers), options, surface, backs);
    refuse_too_fine(bridge, arches, &stations, &layout, options)?;

    let mut build = Build::new(bridge, options, layout);
    for (i, arch) in arches.iter().enumerate() {
        build.rings(i, arch, &stations[i]);
    }
    for i in 0..=arches.len() {
        build.support(i, arches, &stations);
    }
    build.columns();
    Ok(build.finish(ballast_pressure))
}

struct Build<'a> {
    bridge: &'a Bridge,
    options: MeshOptions,
    layout: Layout,
    nodes: Table<NodeId, Vec2>,
    /// Elements of each zone, in the order of the zones.
    zones: BTreeMap<Role, Vec<[NodeId; 4]>>,
    interfaces: Table<InterfaceId, Interface>,
    sets: NodeSets,
    /// The fill's nodes along the extrados of each span, station by station.
    backs: Vec<Vec<NodeId>>,
    /// First and last column of each ring, from intrados to extrados.
    ends: Vec<Vec<[Vec<NodeId>; 2]>>,
    /// Feet of the columns of fill, from left to right.
    feet: Vec<NodeId>,
}

impl<'a> Build<'a> {
    fn new(bridge: &'a Bridge, options: MeshOptions, layout: Layout) -> Build<'a> {
        Build {
            bridge,
            options,
            layout,
            nodes: Table::default(),
            zones: BTreeMap::new(),
            interfaces: Table::default(),
            sets: NodeSets::default(),
            backs: Vec::new(),
            ends: Vec::new(),
            feet: Vec::new(),
        }
    }

    /// Elements between the rows and columns of a grid, all of one zone.
    fn solid(&mut self, grid: &Grid, role: Role) {
        self.zones.entry(role).or_default().extend(quads_of(grid));
    }

    /// Elements of fill, each of the zone of its row, or of that in which its middle lies.
    fn fill(&mut self, grid: &Grid, of_row: impl Fn(usize) -> Option<Role>) {
        for (row, pair) in grid.windows(2).enumerate() {
            for quad in quads_of(pair) {
                let middle = quad.iter().fold(Vec2::ZERO, |sum, n| sum + self.nodes[*n]) * 0.25;
                let role = of_row(row).unwrap_or_else(|| self.layout.role(middle));
                self.zones.entry(role).or_default().push(quad);
            }
        }
    }

    /// Nodes at points, but for those that are known.
    fn grid(&mut self, points: &Points, known: impl Fn(usize, usize) -> Option<NodeId>) -> Grid {
        let mut grid = Grid::with_capacity(points.len());
        for (i, row) in points.iter().enumerate() {
            let nodes = row.iter().enumerate().map(|(j, p)| known(i, j).unwrap_or_else(|| self.nodes.push(*p)));
            grid.push(nodes.collect());
        }
        grid
    }

    fn seam(&mut self, one: Vec<NodeId>, two: Vec<NodeId>, seam: Seam) -> InterfaceId {
        let quadrature = match seam {
            Seam::Joint => self.options.joints,
            Seam::Rings | Seam::Contact => Quadrature::Nodal,
        };
        self.interfaces.push(Interface { one, two, kind: seam as usize, quadrature })
    }

    /// The rings of a span: voussoirs, the joints between them, and the fill's nodes on their backs.
    fn rings(&mut self, span: usize, arch: &Arch<'_>, stations: &Stations) {
        let across = self.options.ring_nodes;
        let mut sets = Vec::new();
        let mut joints = Vec::new();
        let mut ends = Vec::new();
        // Nodes of a ring's upper face, and those of its lower one, by voussoir: stations and nodes.
        type Face = Vec<(Vec<usize>, Vec<NodeId>)>;
        let mut lower: Option<Face> = None;
        for (ring, at) in stations.joints.iter().enumerate() {
            let mut voussoirs: Vec<Voussoir> = Vec::new();
            for pair in at.windows(2) {
                let columns = pair[0]..=pair[1];
                let points: Points = (0..across)
                    .map(|k| {
                        let depth = k as f64 / (across - 1) as f64;
                        columns.clone().map(|j| arch.at(stations.shares[j], ring, depth)).collect()
                    })
                    .collect();
                let grid = self.grid(&points, |_, _| None);
                self.solid(&grid, Role::Voussoirs(span));
                let nodes = (0..grid[0].len()).flat_map(|j| grid.iter().map(move |row| row[j])).collect();
                voussoirs.push(Voussoir { nodes, across });
            }
            let column = |v: &Voussoir, last: bool| {
                let n = v.nodes.len();
                if last { v.nodes[n - across..].to_vec() } else { v.nodes[..across].to_vec() }
            };
            let mut own = Vec::new();
            for j in 1..voussoirs.len() {
                let (one, two) = (column(&voussoirs[j], false), column(&voussoirs[j - 1], true));
                own.push(self.seam(one, two, Seam::Joint));
            }
            ends.push([column(&voussoirs[0], false), column(&voussoirs[voussoirs.len() - 1], true)]);
            let face = |of: &dyn Fn(&Voussoir) -> Vec<NodeId>| -> Face {
                at.windows(2).zip(&voussoirs).map(|(w, v)| ((w[0]..=w[1]).collect(), of(v))).collect()
            };
            let (beds, backs) = (face(&|v| v.intrados().collect()), face(&|v| v.extrados().collect()));
            if let Some(lower) = lower.take() {
                self.between_rings(&lower, &beds);
            }
            lower = Some(backs);
            sets.push(voussoirs);
            joints.push(own);
        }
        let fill: Vec<NodeId> = stations.shares.iter().map(|s| self.nodes.push(arch.extrados(*s))).collect();
        for (at, nodes) in lower.unwrap_or_default() {
            let facing = at.iter().map(|j| fill[*j]).collect();
            self.seam(nodes, facing, Seam::Contact);
        }
        self.backs.push(fill);
        self.ends.push(ends);
        let springings_at = [arch.intrados(0.0), arch.intrados(1.0)];
        self.sets.spans.push(SpanSets { voussoirs: sets, joints, springings_at });
    }

    /// Interfaces between the backs of one ring and the beds of the next, one for each pair of voussoirs that touch.
    fn between_rings(&mut self, lower: &[(Vec<usize>, Vec<NodeId>)], upper: &[(Vec<usize>, Vec<NodeId>)]) {
        for (below, backs) in lower {
            for (above, beds) in upper {
                let from = below[0].max(above[0]);
                let to = below[below.len() - 1].min(above[above.len() - 1]);
                if from < to {
                    let one = backs[from - below[0]..=to - below[0]].to_vec();
                    let two = beds[from - above[0]..=to - above[0]].to_vec();
                    self.seam(one, two, Seam::Rings);
                }
            }
        }
    }

    /// Support `i`: its masonry, its joints, and the fill on and behind it.
    fn support(&mut self, i: usize, arches: &[Arch<'_>], stations: &[Stations]) {
        let [left, right] = [i.checked_sub(1), (i < arches.len()).then_some(i)];
        let rows_to = |span: Option<usize>, end: usize| span.map_or(0, |k| stations[k].rows(end));
        let rows = rows_to(left, 1).max(rows_to(right, 0));
        // Fill's nodes up both extrados, from the springing.
        let climb = |span: Option<usize>, end: End, backs: &[Vec<NodeId>]| -> Option<Vec<NodeId>> {
            let nodes = &backs[span?];
            let last = nodes.len() - 1;
            Some((0..=rows).map(|k| if end == End::Left { nodes[k] } else { nodes[last - k] }).collect())
        };
        let up = [climb(left, End::Right, &self.backs), climb(right, End::Left, &self.backs)];
        let solid = self.masonry(i, [left, right], arches, &up);
        let role = match (left, right) {
            (Some(pier), Some(_)) => Role::Pier(pier),
            (None, _) => Role::Abutment(End::Left),
            _ => Role::Abutment(End::Right),
        };
        let grid = self.grid(&solid.points, |_, _| None);
        self.solid(&grid, role);
        self.sets.base.extend(&grid[0]);
        for (side, span) in [left, right].into_iter().enumerate() {
            if let Some(span) = span {
                self.springing(span, side, solid.skewback(&grid, side));
            }
        }

        // The fill's nodes on the masonry's top: those at the springings are there already.
        let top = solid.top(&grid);
        let last = top.len() - 1;
        let points = vec![top.iter().map(|n| self.nodes[*n]).collect::<Vec<Vec2>>()];
        let known = |j: usize| match j {
            0 => up[0].as_ref().map(|n| n[0]),
            _ if j == last => up[1].as_ref().map(|n| n[0]),
            _ => None,
        };
        let foot = self.grid(&points, |_, j| known(j)).swap_remove(0);
        self.seam(top, foot.clone(), Seam::Contact);

        let over = self.rows_of_fill(&foot, rows, &up);
        let roles: Vec<Option<Role>> = (0..rows).map(|row| self.layout.over[i].role(row)).collect();
        self.fill(&over, |row| roles[row]);
        let edge = |j: usize| over.iter().map(|row| row[j]).collect::<Vec<NodeId>>();
        if left.is_none() {
            let behind = self.behind(0, &grid, &edge(0));
            self.join_feet(behind);
        }
        self.join_feet(over[rows].clone());
        let beyond = match right {
            None => self.behind(1, &grid, &edge(last)),
            // From where rows end on this side of the span to where they end on the other.
            Some(span) => {
                let nodes = &self.backs[span];
                nodes[rows..nodes.len() - stations[span].rows(1)].to_vec()
            }
        };
        self.join_feet(beyond);
    }

    /// The masonry of a support.
    fn masonry(
        &self,
        i: usize,
        [left, right]: [Option<usize>; 2],
        arches: &[Arch<'_>],
        up: &[Option<Vec<NodeId>>; 2],
    ) -> Support {
        let size = self.options.size;
        let skewback = |span: usize, end: usize| -> Vec<Vec2> {
            let mut points: Vec<Vec2> = Vec::new();
            for ring in &self.ends[span] {
                let skip = usize::from(!points.is_empty());
                points.extend(ring[end].iter().skip(skip).map(|n| self.nodes[*n]));
            }
            points
        };
        let (low, feet) = match (left, right) {
            (Some(_), Some(_)) => {
                let pier = &self.bridge.piers[i - 1];
                let (a, b) = (arches[i - 1].intrados(1.0), arches[i].intrados(0.0));
                let (middle, half) = (0.5 * (a.x + b.x) + pier.base_offset, 0.5 * pier.base_width);
                (a.y.min(b.y) - pier.height, [middle - half, middle + half])
            }
            (None, _) => {
                let springing = arches[0].intrados(0.0);
                (springing.y - self.bridge.abutments[0].height, [self.layout.backs[0], springing.x])
            }
            _ => {
                let springing = arches[arches.len() - 1].intrados(1.0);
                (springing.y - self.bridge.abutments[1].height, [springing.x, self.layout.backs[1]])
            }
        };
        let flank = |span: Option<usize>, end: usize, other: Option<usize>| {
            let top = || arches[other.unwrap_or(0)].extrados(if end == 1 { 0.0 } else { 1.0 }).y;
            let back = || vec![vec2(self.layout.backs[1 - end], top())];
            Flank { points: span.map_or_else(back, |span| skewback(span, end)), base: feet[1 - end] }
        };
        let flanks = [flank(left, 1, right), flank(right, 0, left)];
        // As many elements as the width asks for, at the masonry's top and where rows of fill end.
        let at = |k: usize, side: usize| match &up[side] {
            Some(nodes) => self.nodes[nodes[if k == 0 { 0 } else { nodes.len() - 1 }]].x,
            None => self.layout.backs[side],
        };
        let (narrow, wide) = (at(0, 1) - at(0, 0), at(1, 1) - at(1, 0));
        let across = ((narrow * wide).max(0.0).sqrt() / size).max(wide / (1.5 * size)).max(narrow / size);
        support(&flanks[0], &flanks[1], low, (across.ceil() as usize).max(2), size)
    }

    /// The springing joints of a span on a support whose right (`side` 1) or left flank it stands on.
    fn springing(&mut self, span: usize, side: usize, skewback: Vec<NodeId>) {
        let end = 1 - side;
        let mut from = 0;
        for ring in 0..self.ends[span].len() {
            let own = self.ends[span][ring][end].clone();
            let facing = skewback[from..from + own.len()].to_vec();
            from += own.len() - 1;
            // Side `one` is to the right: the ring at its left springing, the support at its right one.
            let (one, two) = if end == 0 { (own, facing) } else { (facing, own) };
            let id = self.seam(one, two, Seam::Joint);
            let joints = &mut self.sets.spans[span].joints[ring];
            if end == 0 { joints.insert(0, id) } else { joints.push(id) }
        }
    }

    /// Rows of fill over a support, from its top to where columns begin.
    fn rows_of_fill(&mut self, foot: &[NodeId], rows: usize, up: &[Option<Vec<NodeId>>; 2]) -> Grid {
        let last = foot.len() - 1;
        let place = |build: &Build<'_>, i: usize, side: usize| match &up[side] {
            Some(nodes) => build.nodes[nodes[i]],
            None => {
                let level = up[1 - side].as_ref().map_or(0.0, |nodes| build.nodes[nodes[i]].y);
                vec2(build.layout.backs[side], level)
            }
        };
        let first: Vec<Vec2> = foot.iter().map(|n| self.nodes[*n]).collect();
        let shares: Vec<f64> = (0..=last).map(|j| j as f64 / last as f64).collect();
        let points: Points = (0..=rows)
            .map(|i| {
                if i == 0 {
                    return first.clone();
                }
                let (a, b) = (place(self, i, 0), place(self, i, 1));
                shares.iter().map(|t| a + (b - a) * *t).collect()
            })
            .collect();
        self.grid(&points, |i, j| match (i, j) {
            (0, _) => Some(foot[j]),
            (_, 0) => up[0].as_ref().map(|n| n[i]),
            _ if j == last => up[1].as_ref().map(|n| n[i]),
            _ => None,
        })
    }

    /// Fill behind an abutment, up to where columns begin: against the masonry's back, then beside the rows over it, whose outer
    /// edge is `edge`. Returns the feet of its columns, from left to right.
    fn behind(&mut self, side: usize, masonry: &Grid, edge: &[NodeId]) -> Vec<NodeId> {
        let distances = self.layout.behind.clone();
        let column = if side == 0 { 0 } else { masonry[0].len() - 1 };
        let back: Vec<NodeId> = masonry.iter().map(|row| row[column]).collect();
        let outwards = if side == 0 { -1.0 } else { 1.0 };
        let far = distances[distances.len() - 1];
        // Along each level from the back outwards; the corner on the masonry's top belongs to both parts.
        let levels: Vec<Vec2> =
            back.iter().map(|n| self.nodes[*n]).chain(edge[1..].iter().map(|n| self.nodes[*n])).collect();
        let points: Points = levels.iter().map(|p| spaced(*p, *p + vec2(outwards * far, 0.0), &distances)).collect();
        let corner = back.len() - 1;
        let mut grid = self.grid(&points, |i, j| if j == 0 && i >= corner { Some(edge[i - corner]) } else { None });
        let facing: Vec<NodeId> = grid[..=corner].iter().map(|row| row[0]).collect();
        let boundary: Vec<NodeId> = grid.iter().map(|row| row[distances.len() - 1]).collect();
        // Masonry on the right of the way walked: up the left abutment's back, down the right one's.
        let (mut one, mut two) = (back, facing);
        if side == 0 {
            grid.iter_mut().for_each(|row| row.reverse());
            self.sets.left = boundary;
        } else {
            one.reverse();
            two.reverse();
            self.sets.right = boundary;
        }
        self.seam(one, two, Seam::Contact);
        self.fill(&grid, |_| None);
        self.sets.base.extend(&grid[0]);
        grid.swap_remove(grid.len() - 1)
    }

    /// Feet of further columns, to the right of those known; the first may be the last known one.
    fn join_feet(&mut self, feet: Vec<NodeId>) {
        let skip = usize::from(self.feet.last().is_some() && self.feet.last() == feet.first());
        self.feet.extend(feet.into_iter().skip(skip));
    }

    /// Columns of fill from their feet up to the surface.
    fn columns(&mut self) {
        let feet = self.feet.clone();
        let (rows, surface) = (self.layout.rows, self.layout.surface);
        let points: Points = (0..=rows)
            .map(|i| {
                let t = i as f64 / rows as f64;
                feet.iter()
                    .map(|n| {
                        let p = self.nodes[*n];
                        vec2(p.x, if i == rows { surface } else { p.y + (surface - p.y) * t })
                    })
                    .collect()
            })
            .collect();
        let grid = self.grid(&points, |i, j| (i == 0).then(|| feet[j]));
        self.fill(&grid, |_| None);
        self.sets.surface = grid[rows].clone();
        self.sets.left.extend(grid[1..].iter().map(|row| row[0]));
        self.sets.right.extend(grid[1..].iter().map(|row| row[feet.len() - 1]));
    }

    fn finish(self, ballast_pressure: f64) -> Meshed {
        let mut mesh = Mesh {
            nodes: self.nodes,
            interfaces: self.interfaces,
            kinds: Seam::KINDS.map(str::to_owned).to_vec(),
            ..Mesh::default()
        };
        let mut roles: Table<ZoneId, Role> = Table::default();
        for (role, quads) in self.zones {
            let zone = mesh.zones.push(role.name());
            roles.push(role);
            for nodes in quads {
                mesh.quads.push(Quad { nodes, zone });
            }
        }
        let quality = quality::quality(&mesh, self.sets.held());
        Meshed {
            mesh,
            roles,
            sets: self.sets,
            options: self.options,
            quality,
            surface: self.layout.surface,
            ballast_pressure,
        }
    }
}

/// Where an element is folded, and what helps.
fn folded(meshed: &Meshed) -> MeshError {
    let Meshed { mesh, roles, quality, .. } = meshed;
    let at = quality.worst;
    let value = |q: QuadId| quality::scaled_jacobian(quality::corners(mesh, q));
    let worst = mesh.quads.ids().find(|q| !(value(*q) > quality.scaled_jacobian));
    let role = worst.map(|q| roles[mesh.quads[q].zone]);
    let help = match role {
        Some(Role::Voussoirs(_)) => "check the intrados and the thickness of the ring there",
        Some(Role::Pier(_) | Role::Abutment(_)) => "check the springings, and the width and height of the support",
        _ => "check the profiles of the spans on both sides, or give a smaller `size` in [mesh]",
    };
    MeshError::Folded {
        zone: role.map_or_else(String::new, Role::name),
        x: at.x,
        y: at.y,
        value: quality.scaled_jacobian,
        help,
    }
}

/// Elements between rows and columns, counter-clockwise, row by row.
fn quads_of(grid: &[Vec<NodeId>]) -> Vec<[NodeId; 4]> {
    let between = |pair: &[Vec<NodeId>]| -> Vec<[NodeId; 4]> {
        (1..pair[0].len()).map(|j| [pair[0][j - 1], pair[0][j], pair[1][j], pair[1][j - 1]]).collect()
    };
    grid.windows(2).flat_map(between).collect()
}
