//! The parts of a picture that every analysis shares.

use super::bands::bands;
use super::defects;
use super::dimensions::dimensions;
use super::geometry::point;
use super::ground;
use bridge::Bridge;
use mechanics::blocks::Particle;
use mechanics::ids::BlockId;
use mechanics::plane::Vec2;
use outcome::picture::{ContactForce, Disc, LoadArrow, Picture, Point, Shape};
use structure::discretise::{Discretised, cover};

/// Blocks, surface and loads of a bridge as built.
pub(super) fn built(bridge: &Bridge, d: &Discretised, title: &str) -> Picture {
    let shapes = d.model.blocks.pairs().map(|(id, block)| Shape {
        outline: block.outline.vertices().iter().map(|&v| point(v)).collect(),
        role: d.origins[id].role().to_string(),
        held: block.held.is_fixed(),
    });
    // Without cover and loads there is no road to draw.
    let road = !(bridge.cover.layers.is_empty() && bridge.loads.is_empty());
    let surface = if road { cover::surface_line(bridge, &d.extrados) } else { Vec::new() };
    Picture {
        title: format!("{}: {title}", bridge.name),
        shapes: shapes.collect(),
        particles: particles(d),
        layers: layers(bridge, d),
        fill: d.fill.iter().flat_map(|fill| &fill.outline).map(|&v| point(v)).collect(),
        surface: surface.into_iter().map(point).collect(),
        wall_top: wall_top(bridge, d),
        edges: ground::edges(bridge),
        surface_loads: d
            .spreads
            .iter()
            .map(|s| ([s.strip.middle, d.surface.at(s.strip.middle)], s.strip.length))
            .collect(),
        loads: d.loading.variable.iter().map(|f| LoadArrow { at: point(f.at), force: point(f.force) }).collect(),
        bands: bands(bridge, d),
        defects: defects::marks(bridge),
        dimensions: dimensions(bridge, &d.surface),
        ..Picture::default()
    }
}

/// Upper edge of the spandrel walls: as high above the highest crown as the file says, or the road surface.
fn wall_top(bridge: &Bridge, d: &Discretised) -> Vec<Point> {
    let Some(wall) = &bridge.spandrel_wall else { return Vec::new() };
    let backs = || d.extrados.stretches.iter().filter(|stretch| !stretch.ground).flat_map(|s| [s.left, s.right]);
    let highest = backs().map(|back| back.y).fold(f64::NEG_INFINITY, f64::max);
    match (wall.top, backs().next(), backs().last()) {
        (Some(top), Some(first), Some(last)) => [first.x, last.x].map(|x| [x, highest + top]).to_vec(),
        _ => cover::surface_line(bridge, &d.extrados).into_iter().map(point).collect(),
    }
}

/// What the layers of particles are, from the extrados up.
fn layers(bridge: &Bridge, d: &Discretised) -> Vec<String> {
    let filled = bridge.cover.layers.iter().filter(|layer| layer.particles && d.fill.is_some());
    filled.map(|layer| layer.name.word().to_string()).collect()
}

/// The particles as packed, each with its layer.
fn particles(d: &Discretised) -> Vec<Disc> {
    let layers = d.fill.as_ref().map_or(&[][..], |fill| &fill.layers);
    let layer = |p: &Particle| layers.iter().position(|layer| layer.group == p.group).unwrap_or(0);
    let disc = |p: &Particle| Disc { centre: point(p.centre), radius: p.radius, layer: layer(p) };
    d.model.particles.iter().map(disc).collect()
}

/// Average stress of each block [Pa], tension positive (xx, yy, xy), from the forces on its surface: the divergence
/// theorem. Its own weight acts in the centroid and does not count; variable loads count so many times.
pub(super) fn stresses(d: &Discretised, contacts: &[ContactForce], factor: f64) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; d.model.blocks.len()];
    let mut add = |block: usize, at: Vec2, force: Vec2| {
        let arm = at - d.model.blocks.as_slice()[block].outline.centroid();
        sums[block][0] += arm.x * force.x;
        sums[block][1] += arm.y * force.y;
        sums[block][2] += 0.5 * (arm.x * force.y + arm.y * force.x);
    };
    for c in contacts {
        let normal = Vec2 { x: c.normal[0], y: c.normal[1] };
        let on_second = normal * c.compression + normal.left() * c.shear;
        let at = Vec2 { x: c.point[0], y: c.point[1] };
        add(c.blocks[1], at, on_second);
        add(c.blocks[0], at, -on_second);
    }
    let permanent = d.loading.permanent.iter().map(|load| (load, 1.0));
    for (load, factor) in permanent.chain(d.loading.variable.iter().map(|load| (load, factor))) {
        let BlockId(block) = load.block;
        add(block as usize, load.at, load.force * factor);
    }
    sums.iter().zip(d.model.blocks.iter()).map(|(s, b)| s.map(|v| v / b.outline.area())).collect()
}
