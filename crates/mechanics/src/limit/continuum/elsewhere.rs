//! What a motion says of loads that stand elsewhere: an upper bound of their factor, without a program.
//!
//! Soil and bridge move as they did; the plates under the other loads ride on the soil. A plate is rigid and nothing holds it: of all its
//! motions that the flow rule of its contact allows, the one that lowers its load most is the line that touches the moving surface from above.
//! The work equation of the whole is then summed up anew, so that the bound is as strict as any other.

use super::bounds::Bounds;
use super::mesh::Mesh;
use super::setting::Setting;
use super::upper::{Motion, SOUND, moving, work};
use crate::ids::BlockId;
use crate::plane::{Vec2, vec2};

/// An upper bound on the factor of other loads on the same soil and the same blocks, of which the first `shared` stay and the rest are plates;
/// none where the motion of these bounds raises the loads, or where no plate rides on it.
pub fn bound_elsewhere(bounds: &Bounds, shared: usize, setting: &Setting<'_>) -> Option<f64> {
    let motion = bounds.upper.as_ref()?;
    let (mesh, parents) = bounds.mesh.divided_at(setting.soil);
    let velocities = carried(&bounds.mesh, motion, &mesh, &parents);
    let eq = &setting.equilibrium;
    let mut blocks = vec![0.0; eq.rows];
    let mut set = |block: BlockId, v: Vec2, turn: f64| {
        for (row, value) in eq.row[block].iter().zip([v.x, v.y, turn * eq.length]) {
            row.iter().for_each(|&i| blocks[i] = value);
        }
    };
    for (block, &(v, turn)) in bounds.motions.pairs().take(shared) {
        set(block, v, turn);
    }
    for (block, own) in setting.model.blocks.pairs().skip(shared) {
        let ride = ride(setting, &mesh, block, &velocities)?;
        let centre = own.outline.centroid();
        let arm = ride.at - centre;
        set(block, vec2(ride.velocity.x + ride.turn * arm.y, ride.velocity.y - ride.turn * arm.x), ride.turn);
    }
    let (found, fastest) = work(setting, &mesh, velocities, blocks, motion.panels.clone());
    let factor = found.factor + motion.doubt / (found.power * fastest);
    let sound = found.power > 0.0 && found.flow_violation <= SOUND && factor.is_finite();
    sound.then_some(factor)
}

/// The velocities of a motion at the nodes of a mesh whose triangles are pieces of its own: they are quadratic in each.
fn carried(own: &Mesh, motion: &Motion, pieces: &Mesh, parents: &[usize]) -> Vec<Vec2> {
    let mut velocities = vec![Vec2::ZERO; pieces.nodes()];
    for (t, &parent) in parents.iter().enumerate() {
        let [a, b, c] = own.corners(parent);
        let (nodes, area) = (own.nodes_of(parent), (b - a).cross(c - a));
        for node in pieces.nodes_of(t) {
            let p = pieces.node(node);
            let shares = [(b - p).cross(c - p), (c - p).cross(a - p), (a - p).cross(b - p)].map(|s| s / area);
            velocities[node] = (0..3).fold(Vec2::ZERO, |sum, k| {
                let [own, i, j] = [shares[k], shares[(k + 1) % 3], shares[(k + 2) % 3]];
                let (corner, middle) = (motion.velocities[nodes[k]], motion.velocities[nodes[3 + k]]);
                sum + corner * (own * (2.0 * own - 1.0)) + middle * (4.0 * i * j)
            });
        }
    }
    velocities
}

/// How a plate moves: the velocity of the point of its under side below its loads, and its rotation.
struct Ride {
    at: Vec2,
    velocity: Vec2,
    turn: f64,
}

/// A point of the under side of a plate: where it is, and how fast it moves upwards at least.
type Under = (f64, f64);

/// The motion of a plate that lowers its loads most; none where it has no loads, or where it stands on no edge of the mesh.
fn ride(setting: &Setting<'_>, mesh: &Mesh, block: BlockId, velocities: &[Vec2]) -> Option<Ride> {
    let loads = || setting.loading.variable.iter().filter(|load| load.block == block);
    let force: f64 = loads().map(|load| load.force.y).sum();
    let middle = loads().map(|load| load.force.y * load.at.x).sum::<f64>() / force;
    let (mut points, mut level, mut friction) = (Vec::new(), 0.0, 0.0);
    for e in 0..mesh.edges.len() {
        let Some((Some(body), contact)) = setting.body(mesh, e) else { continue };
        if body == block {
            (level, friction) = (mesh.ends(e)[0].y, contact.friction);
            points.extend(moving(mesh, e, velocities).map(|(point, v)| (point.x, v)));
        }
    }
    if points.is_empty() || !middle.is_finite() {
        return None;
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let over = |along: f64| {
        let rises: Vec<Under> = points.iter().map(|(x, v)| (*x, v.y + friction * (v.x - along).abs())).collect();
        lowest(&rises, middle)
    };
    // How low it gets is convex in how fast it slides.
    let mut ends = points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], (_, v)| [l.min(v.x), h.max(v.x)]);
    for _ in 0..SEARCHES {
        let width = (ends[1] - ends[0]) / 3.0;
        let inner = [ends[0] + width, ends[1] - width];
        if over(inner[0])?.0 <= over(inner[1])?.0 { ends[1] = inner[1] } else { ends[0] = inner[0] }
    }
    let along = 0.5 * (ends[0] + ends[1]);
    let (rise, turn) = over(along)?;
    Some(Ride { at: vec2(middle, level), velocity: vec2(along, rise), turn })
}

/// Thirds of the range of sliding velocities that are left out, one after the other.
const SEARCHES: u32 = 40;

/// The lowest line at a place that lies nowhere below any of the points, which are sorted: its height there and its slope. None where all
/// points lie to one side of the place.
fn lowest(points: &[Under], place: f64) -> Option<Under> {
    // Corners of the upper hull.
    let mut hull: Vec<Under> = Vec::with_capacity(points.len());
    for &(x, y) in points {
        if let Some(last) = hull.last_mut()
            && last.0 == x
        {
            last.1 = last.1.max(y);
            continue;
        }
        while let [.., a, b] = hull[..]
            && (b.0 - a.0) * (y - a.1) >= (x - a.0) * (b.1 - a.1)
        {
            hull.pop();
        }
        hull.push((x, y));
    }
    let pair = hull.windows(2).find(|pair| pair[0].0 <= place && place <= pair[1].0)?;
    let slope = (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
    Some((pair[0].1 + slope * (place - pair[0].0), slope))
}

#[cfg(test)]
mod tests {
    use super::lowest;

    #[test]
    fn the_lowest_line_over_points_touches_those_beside_the_place() {
        let points = [(0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (2.0, 2.0), (4.0, 0.0)];
        assert_eq!(lowest(&points, 1.0), Some((1.5, 0.5)));
        assert_eq!(lowest(&points, 3.0), Some((1.0, -1.0)));
        assert_eq!(lowest(&points, 5.0), None);
        // A hollow does not let it down.
        assert_eq!(lowest(&[(0.0, 1.0), (1.0, -5.0), (2.0, 1.0)], 0.5), Some((1.0, 0.0)));
    }
}
