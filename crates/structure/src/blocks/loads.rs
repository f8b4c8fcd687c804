//! Loads find their blocks.

use super::{Body, Force, Said};
use bridge::blocks::{BlockFile, BodyLoad, Target};

/// A point acts on a block that it misses by less than this [m]: coordinates are typed with three decimals.
const NEAR: f64 = 1e-3;

/// The forces of all loads; a load that finds no free block is said.
pub(super) fn forces(file: &BlockFile, bodies: &[Body], said: &mut Said) -> Vec<Force> {
    let mut forces = Vec::new();
    for load in &file.loads {
        let force = |body: usize, at: [f64; 2], share: f64| Force {
            name: load.name.clone(),
            body,
            at,
            force: load.force.map(|component| component * share),
            permanent: load.permanent,
        };
        match &load.target {
            Target::Point(at) => forces.extend(at_point(load, *at, bodies, said).map(|body| force(body, *at, 1.0))),
            Target::Block(name) => {
                forces.extend(named(load, name, bodies, said).map(|body| {
                    let centre = centroid(&bodies[body].outline).1;
                    force(body, centre, 1.0)
                }));
            }
            Target::Layer(layer) => {
                let mass = |body: &Body| file.materials[body.material].masonry.density * centroid(&body.outline).0;
                let on = |body: &&Body| !body.held && body.layer.to_uppercase() == layer.to_uppercase();
                let total: f64 = bodies.iter().filter(on).map(mass).sum();
                if total <= 0.0 {
                    let message = format!("{}: there is no free block on layer {layer}", load.name);
                    said.error("D404", load.range, message, "finds no block", "name another layer".into());
                }
                for (k, body) in bodies.iter().enumerate().filter(|(_, body)| on(body)) {
                    forces.push(force(k, centroid(&body.outline).1, mass(body) / total));
                }
            }
        }
    }
    forces
}

/// The free block at a point: the one that holds it deepest, the first where two do alike.
fn at_point(load: &BodyLoad, at: [f64; 2], bodies: &[Body], said: &mut Said) -> Option<usize> {
    let depth = |k: usize| depth(&bodies[k].outline, at);
    let nearest = |held: bool| {
        let of = (0..bodies.len()).filter(|&k| bodies[k].held == held);
        of.fold(None, |best: Option<usize>, k| match best {
            Some(b) if depth(b) >= depth(k) => Some(b),
            _ => Some(k),
        })
    };
    let (free, held) = (nearest(false)?, nearest(true));
    if depth(free) >= -NEAR {
        return Some(free);
    }
    let (message, help) = match held.filter(|&k| depth(k) >= -NEAR) {
        Some(k) => (
            format!("{} acts on {}, which is a support", load.name, bodies[k].name),
            format!("move it onto a free block: the nearest is {}", bodies[free].name),
        ),
        None => (
            format!("{}: there is no block at ({}, {}) m", load.name, at[0], at[1]),
            format!("the nearest is {}, {:.4} m away", bodies[free].name, -depth(free)),
        ),
    };
    said.error("D404", load.range, message, "finds no block", help);
    None
}

fn named(load: &BodyLoad, name: &str, bodies: &[Body], said: &mut Said) -> Option<usize> {
    let found = bodies.iter().position(|body| body.name == name);
    match found {
        Some(k) if !bodies[k].held => Some(k),
        Some(_) => {
            let message = format!("{} acts on {name}, which is a support", load.name);
            said.error("D404", load.range, message, "finds no free block", "name a free block".into());
            None
        }
        None => {
            let message = format!("{}: there is no block called {name}", load.name);
            let help = "blocks of a drawing are called after their layer and counted from 1, such as \"RING 1\"".into();
            said.error("D404", load.range, message, "finds no block", help);
            None
        }
    }
}

/// How deep a point lies inside a convex outline [m]; negative outside.
fn depth(points: &[[f64; 2]], at: [f64; 2]) -> f64 {
    let n = points.len();
    let edge = |i: usize| {
        let (p, q) = (points[i], points[(i + 1) % n]);
        let (dx, dy, x, y) = (q[0] - p[0], q[1] - p[1], at[0] - p[0], at[1] - p[1]);
        let length = dx.hypot(dy);
        // To the left of the edge, and how far from its nearest point.
        let along = ((x * dx + y * dy) / length).clamp(0.0, length);
        ((dx * y - dy * x) / length, (x - along * dx / length).hypot(y - along * dy / length))
    };
    let inside = (0..n).map(|i| edge(i).0).fold(f64::INFINITY, f64::min);
    if inside >= 0.0 { inside } else { -(0..n).map(|i| edge(i).1).fold(f64::INFINITY, f64::min) }
}

/// Area [m^2] and centroid [m] of an outline.
pub(super) fn centroid(points: &[[f64; 2]]) -> (f64, [f64; 2]) {
    let (n, o) = (points.len(), points[0]);
    let (mut area, mut moment) = (0.0, [0.0; 2]);
    for i in 0..n {
        let shift = |p: [f64; 2]| [p[0] - o[0], p[1] - o[1]];
        let (a, b) = (shift(points[i]), shift(points[(i + 1) % n]));
        let cross = a[0] * b[1] - a[1] * b[0];
        area += 0.5 * cross;
        moment = [moment[0] + cross * (a[0] + b[0]) / 6.0, moment[1] + cross * (a[1] + b[1]) / 6.0];
    }
    (area, [o[0] + moment[0] / area, o[1] + moment[1] / area])
}
