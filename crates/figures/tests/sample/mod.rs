//! Invented results in the shape of real ones, to try drawings on. No number here is a result.
#![allow(dead_code)]

pub(crate) mod soils;
pub(crate) mod studies;
pub(crate) mod updates;

use outcome::picture::*;
use std::f64::consts::PI;

type Joint = [Point; 2];

/// Every file of a collapse analysis.
pub(crate) fn all(picture: &Picture) -> Result<Vec<figures::File>, figures::RasterError> {
    let mut files = figures::written(&figures::drawings(picture))?;
    let moving = figures::animation(picture)?;
    files.extend(moving.map(|bytes| figures::File { name: "animation.png".into(), bytes }));
    files.extend(figures::paraview(picture));
    Ok(files)
}

fn shape(outline: Vec<Point>, role: &str, held: bool) -> Shape {
    Shape { outline, role: role.into(), held }
}

fn rectangle(left: f64, right: f64, low: f64, high: f64) -> Vec<Point> {
    vec![[left, low], [right, low], [right, high], [left, high]]
}

/// Two triangles for each cell of a grid so many points wide and so many cells high.
fn square_cells(wide: usize, rows: usize) -> Vec<[usize; 3]> {
    let corner = |row: usize, k: usize| row * wide + k;
    let cell = |row: usize, k: usize| {
        let (a, b) = (corner(row, k), corner(row + 1, k));
        [[a, a + 1, b + 1], [a, b + 1, b]]
    };
    (0..rows).flat_map(|row| (0..wide - 1).flat_map(move |k| cell(row, k))).collect()
}

/// Joints of a segmental ring from left to right: intrados and extrados point.
fn joints(left: f64, span: f64, rise: f64, depth: f64, thickness: f64, count: usize) -> Vec<Joint> {
    let radius = (0.25 * span * span + rise * rise) / (2.0 * rise);
    let half = if rise > 0.5 * span - 1e-9 { 0.5 * PI } else { (0.5 * span / radius).asin() };
    let centre = [left + 0.5 * span, rise - radius];
    let at = |k: usize, r: f64| {
        let angle = -half + 2.0 * half * k as f64 / count as f64;
        [centre[0] + r * angle.sin(), centre[1] + r * angle.cos()]
    };
    (0..=count).map(|k| [at(k, radius + depth), at(k, radius + depth + thickness)]).collect()
}

fn voussoirs(joints: &[Joint]) -> Vec<Shape> {
    joints.windows(2).map(|j| shape(vec![j[0][0], j[1][0], j[1][1], j[0][1]], "voussoir", false)).collect()
}

fn abutments(first: Joint, last: Joint) -> Vec<Shape> {
    let (a, b) = (first, last);
    let low = a[0][1].min(b[0][1]) - 1.2;
    vec![
        shape(vec![[a[1][0] - 1.2, low], [a[0][0], low], a[0], a[1], [a[1][0] - 1.2, a[1][1]]], "abutment", true),
        shape(vec![[b[0][0], low], [b[1][0] + 1.2, low], [b[1][0] + 1.2, b[1][1]], b[1], b[0]], "abutment", true),
    ]
}

fn centre(outline: &[Point]) -> Point {
    let n = outline.len() as f64;
    [outline.iter().map(|p| p[0]).sum::<f64>() / n, outline.iter().map(|p| p[1]).sum::<f64>() / n]
}

/// Velocity of the four-hinge mechanism with hinges at joints `at`, alternately intrados and extrados.
fn four_hinges(shapes: &[Shape], joints: &[Joint], at: [usize; 4]) -> (Vec<Motion>, Vec<Hinge>) {
    let edges = [0usize, 1, 0, 1];
    let h: Vec<Point> = at.iter().zip(edges).map(|(&k, e)| joints[k][e]).collect();
    let cross = |a: Point, b: Point| a[0] * b[1] - a[1] * b[0];
    let sub = |a: Point, b: Point| [a[0] - b[0], a[1] - b[1]];
    let (d1, d2) = (sub(h[1], h[0]), sub(h[2], h[3]));
    let t = cross(sub(h[3], h[0]), d2) / cross(d1, d2);
    let pole = [h[0][0] + t * d1[0], h[0][1] + t * d1[1]];
    let w1 = -1.0;
    let ratio = |from: Point, to: Point, hinge: Point| {
        let (a, b) = (sub(hinge, from), sub(hinge, to));
        let dot = a[0] * b[0] + a[1] * b[1];
        dot / (b[0] * b[0] + b[1] * b[1])
    };
    let w2 = w1 * ratio(h[0], pole, h[1]);
    let w3 = w2 * ratio(pole, h[3], h[2]);
    let bodies = [(0.0, h[0]), (w1, h[0]), (w2, pole), (w3, h[3]), (0.0, h[3])];
    let mut motions: Vec<Motion> = shapes
        .iter()
        .enumerate()
        .map(|(k, s)| {
            if s.held {
                return Motion::default();
            }
            let body = at.iter().filter(|&&j| j <= k).count();
            let (w, p) = bodies[body];
            let r = sub(area_centre(&s.outline), p);
            Motion { translation: [-w * r[1], w * r[0]], rotation: w }
        })
        .collect();
    let largest = motions.iter().map(|m| m.translation[0].hypot(m.translation[1])).fold(0.0, f64::max);
    for m in &mut motions {
        *m = times(*m, 1.0 / largest);
    }
    let turns = [w1, w2 - w1, w3 - w2, -w3];
    let hinges = (0..4)
        .map(|k| Hinge {
            point: h[k],
            edge: if edges[k] == 0 { HingeAt::Intrados } else { HingeAt::Extrados },
            between: [k, k + 1],
            rotation: turns[k] / largest,
        })
        .collect();
    (motions, hinges)
}

fn area_centre(outline: &[Point]) -> Point {
    let (mut area, mut sum) = (0.0, [0.0, 0.0]);
    for (k, p) in outline.iter().enumerate() {
        let q = outline[(k + 1) % outline.len()];
        let c = p[0] * q[1] - p[1] * q[0];
        area += c;
        sum = [sum[0] + c * (p[0] + q[0]), sum[1] + c * (p[1] + q[1])];
    }
    [sum[0] / (3.0 * area), sum[1] / (3.0 * area)]
}

pub(crate) fn times(m: Motion, s: f64) -> Motion {
    Motion { translation: [s * m.translation[0], s * m.translation[1]], rotation: s * m.rotation }
}

/// Share of the thickness, from the intrados, at which a line of thrust through the hinges crosses joint `k`.
fn crossing(k: usize, at: [usize; 4], count: usize) -> f64 {
    let knots: Vec<(f64, f64)> = [(0, 0.35)]
        .into_iter()
        .filter(|_| at[0] > 0)
        .chain(at.iter().zip([0.0, 1.0, 0.0, 1.0]).map(|(&k, s)| (k, s)))
        .chain([(count, 0.6)].into_iter().filter(|_| at[3] < count))
        .map(|(k, s)| (k as f64, s))
        .collect();
    let x = k as f64;
    for pair in knots.windows(2) {
        if x <= pair[1].0 {
            let t = (x - pair[0].0) / (pair[1].0 - pair[0].0);
            return pair[0].1 + (pair[1].1 - pair[0].1) * 0.5 * (1.0 - (PI * t).cos());
        }
    }
    knots[knots.len() - 1].1
}

fn thrust(joints: &[Joint], at: [usize; 4], force: f64) -> Vec<ThrustPoint> {
    let count = joints.len() - 1;
    joints
        .iter()
        .enumerate()
        .map(|(k, j)| {
            let s = 0.02 + 0.96 * crossing(k, at, count);
            let point = [j[0][0] + s * (j[1][0] - j[0][0]), j[0][1] + s * (j[1][1] - j[0][1])];
            let out = 2.0 * k as f64 / count as f64 - 1.0;
            ThrustPoint { point, thrust: force * (1.0 + 0.18 * out * out - 0.05 * out) }
        })
        .collect()
}

fn state(shapes: &[Shape], joints: &[Joint], at: [usize; 4], motions: Vec<Motion>, load: f64, peak: f64) -> Snapshot {
    let count = joints.len() - 1;
    let mut contacts = Vec::new();
    for (k, j) in joints.iter().enumerate() {
        let s = crossing(k, at, count);
        let d = [j[1][0] - j[0][0], j[1][1] - j[0][1]];
        let length = d[0].hypot(d[1]);
        let normal = [d[1] / length, -d[0] / length];
        let first = if k == 0 { count } else { k - 1 };
        let second = if k == count { count + 1 } else { k };
        for (edge, share) in [(0usize, 1.0 - s), (1, s)] {
            if share > 0.05 {
                contacts.push(ContactForce {
                    blocks: [first, second],
                    point: [
                        j[0][0] + d[0] * (0.014 + 0.972 * edge as f64),
                        j[0][1] + d[1] * (0.014 + 0.972 * edge as f64),
                    ],
                    normal,
                    compression: share * peak * 0.35,
                    shear: 0.1 * share * peak * 0.35 * (k as f64 * 0.7).sin(),
                    stress: share * peak,
                    sliding: false,
                });
            }
        }
    }
    let stresses = shapes
        .iter()
        .enumerate()
        .map(|(k, s)| {
            if s.held || k >= count {
                return [0.0; 3];
            }
            let angle = (k as f64 + 0.5) / count as f64 * 1.1 - 0.55;
            let p = -0.5 * peak * (0.75 + 0.25 * (6.3 * k as f64 / count as f64).cos());
            let (c, s) = (angle.cos(), angle.sin());
            [p * c * c, p * s * s, -p * c * s]
        })
        .collect();
    let velocities = motions.iter().map(|m| [0.1 * m.translation[0], 0.1 * m.translation[1]]).collect();
    Snapshot { load, motions, velocities, contacts, stresses, ..Snapshot::default() }
}

fn patch(joints: &[Joint], middle: f64, half: f64, force: f64) -> Vec<LoadArrow> {
    let under: Vec<Point> = joints
        .windows(2)
        .map(|j| [0.5 * (j[0][1][0] + j[1][1][0]), 0.5 * (j[0][1][1] + j[1][1][1])])
        .filter(|p| (p[0] - middle).abs() < half)
        .collect();
    let n = under.len() as f64;
    under
        .into_iter()
        .enumerate()
        .map(|(k, at)| LoadArrow { at, force: [0.0, -force / n * (0.8 + 0.4 * k as f64 / (n - 1.0).max(1.0))] })
        .collect()
}

fn path(top: f64, step: f64) -> Vec<Step> {
    let mut path: Vec<Step> = Vec::new();
    let mut load = 0.0;
    while load <= top + 1.0 {
        let share = load / (1.03 * top);
        let sink = 0.002 * share + 0.0018 * share.powi(4) / (1.02 - share);
        path.push(Step {
            load,
            displacement: [0.2 * sink, -sink],
            iterations: 5000,
            unbalanced_ratio: 1e-6,
            at_rest: true,
        });
        load += step;
    }
    path.push(Step { load, displacement: [0.05, -0.3], iterations: 20_000, unbalanced_ratio: 2e-3, at_rest: false });
    path
}

/// One segmental arch of 62 voussoirs, span 18.3 m, rise 2.85 m, ring 0.711 m.
pub(crate) fn arch() -> Picture {
    segmental("Bridgemill, case 1", 18.3, 2.85, 62, 0.711)
}

/// A semicircular arch under a point load.
pub(crate) fn tall() -> Picture {
    let mut p = segmental("Tall semicircular arch", 10.0, 5.0, 41, 0.8);
    p.surface.clear();
    p.surface_loads.clear();
    p.loads.truncate(1);
    p
}

fn segmental(title: &str, span: f64, rise: f64, count: usize, thickness: f64) -> Picture {
    let j = joints(0.0, span, rise, 0.0, thickness, count);
    let mut shapes = voussoirs(&j);
    shapes.extend(abutments(j[0], j[count]));
    let at = [0, count * 3 / 10, count * 6 / 10, count];
    let (mechanism, hinges) = four_hinges(&shapes, &j, at);
    let road = rise + thickness + 0.9;
    let moved = |s: f64| mechanism.iter().map(|&m| times(m, s)).collect::<Vec<_>>();
    let mut snapshots = Vec::new();
    for (k, s) in [0.0, 0.0009, 0.0021, 0.004].into_iter().enumerate() {
        let load = 68_273.3 * k as f64;
        snapshots.push(state(&shapes, &j, at, moved(s), load, 0.3e6 + 0.4e6 * k as f64));
    }
    for s in [0.2, 0.6, 1.1, 1.7, 2.4] {
        snapshots.push(state(&shapes, &j, at, moved(s), 216_870.0, 1.2e6));
    }
    let crown = count / 2;
    let quarter = (count as f64 * 0.36) as usize;
    Picture {
        title: title.into(),
        surface: vec![[-1.5, road], [span + 1.5, road]],
        surface_loads: vec![([0.25 * span, road], 0.75)],
        loads: patch(&j, 0.25 * span, 0.9, 204_820.0),
        mechanism: Some(mechanism.clone()),
        hinges,
        sliding: vec![],
        thrust_lines: vec![thrust(&j, at, 812_000.0)],
        path: path(204_820.0, 12_048.2),
        last_stable: Some(3),
        snapshots,
        dimensions: vec![
            DimensionLine { measure: Measure::Span, from: j[0][0], to: j[count][0] },
            DimensionLine {
                measure: Measure::Rise,
                from: j[0][0],
                to: [0.5 * span, if count.is_multiple_of(2) { j[crown][0][1] } else { rise }],
            },
            DimensionLine { measure: Measure::Thickness, from: j[quarter][0], to: j[quarter][1] },
        ],
        collapse_load: Some(216_870.0),
        shapes,
        ..Picture::default()
    }
}

/// Two rings of different numbers of voussoirs.
pub(crate) fn two_rings() -> Picture {
    let inner = joints(0.0, 8.0, 2.0, 0.0, 0.23, 40);
    let outer = joints(0.0, 8.0, 2.0, 0.23, 0.23, 42);
    let mut shapes = voussoirs(&inner);
    shapes.extend(voussoirs(&outer));
    shapes.extend(abutments([inner[0][0], outer[0][1]], [inner[40][0], outer[42][1]]));
    let (mut mechanism, hinges) = four_hinges(&shapes[..40], &inner, [0, 12, 25, 40]);
    let (above, more) = four_hinges(&shapes[40..82], &outer, [0, 13, 26, 42]);
    mechanism.extend(above);
    mechanism.extend([Motion::default(), Motion::default()]);
    let sliding = (8..32).step_by(3).map(|k| inner[k][1]).collect();
    Picture {
        title: "Two rings, separated".into(),
        mechanism: Some(mechanism),
        hinges: hinges.into_iter().chain(more).collect(),
        sliding,
        loads: patch(&outer, 2.0, 0.3, 30_000.0),
        thrust_lines: vec![thrust(&inner, [0, 12, 25, 40], 42_000.0), thrust(&outer, [0, 13, 26, 42], 38_000.0)],
        dimensions: vec![
            DimensionLine { measure: Measure::Span, from: inner[0][0], to: inner[40][0] },
            DimensionLine { measure: Measure::Rise, from: inner[0][0], to: inner[20][0] },
            DimensionLine { measure: Measure::Thickness, from: inner[14][0], to: outer[14][1] },
        ],
        collapse_load: Some(28_400.0),
        shapes,
        ..Picture::default()
    }
}

/// Three spans on slender piers.
pub(crate) fn multi_span() -> Picture {
    let (mut shapes, mut all_joints, mut left) = (Vec::new(), Vec::new(), 0.0);
    for _ in 0..3 {
        let j = joints(left, 6.0, 1.5, 0.0, 0.45, 27);
        shapes.extend(voussoirs(&j));
        all_joints.push(j);
        left += 6.0 + 1.2;
    }
    let ring_count = shapes.len();
    for n in 1..3 {
        let x = n as f64 * 7.2 - 1.2;
        for c in 0..8 {
            let (low, high) = (-4.0 + 0.5 * c as f64, -3.5 + 0.5 * c as f64);
            shapes.push(shape(rectangle(x, x + 1.2, low, high), "pier", false));
        }
        let (a, b) = (all_joints[n - 1][27], all_joints[n][0]);
        shapes.push(shape(vec![a[0], b[0], b[1], a[1]], "pier", false));
        shapes.push(shape(rectangle(x - 0.4, x + 1.6, -4.6, -4.0), "foundation", true));
    }
    shapes.extend(abutments(all_joints[0][0], all_joints[2][27]));
    let mut mechanism = vec![Motion::default(); shapes.len()];
    let mut hinges = Vec::new();
    for (n, at) in [(0usize, [0, 8, 17, 27]), (1, [0, 9, 18, 27])] {
        let (m, h) = four_hinges(&shapes[27 * n..27 * (n + 1)], &all_joints[n], at);
        mechanism[27 * n..27 * (n + 1)].copy_from_slice(&m);
        hinges.extend(h);
    }
    for k in ring_count..ring_count + 9 {
        let c = area_centre(&shapes[k].outline);
        mechanism[k] = Motion { translation: [0.05 * (c[1] + 4.0), 0.0], rotation: -0.05 };
    }
    hinges.push(Hinge { point: [7.2, -4.0], edge: HingeAt::Other, between: [0, 1], rotation: 0.05 });
    let dimension = |measure, from, to| DimensionLine { measure, from, to };
    let mut dimensions: Vec<DimensionLine> =
        all_joints.iter().map(|j| dimension(Measure::Span, j[0][0], j[27][0])).collect();
    dimensions.push(dimension(Measure::Rise, all_joints[0][0][0], [3.0, 1.5]));
    dimensions.push(dimension(Measure::Height, [6.6, -4.0], [6.6, 0.0]));
    dimensions.push(dimension(Measure::Thickness, all_joints[1][9][0], all_joints[1][9][1]));
    let load = Point::from([10.2, 2.6]);
    Picture {
        title: "Three spans on slender piers".into(),
        surface: vec![[-1.5, 2.4], [10.2, 2.6], [21.9, 2.4]],
        surface_loads: vec![(load, 0.3), ([8.4, 2.57], 0.3), ([3.0, 2.47], 2.4)],
        loads: patch(&all_joints[1], 9.0, 0.6, 80_000.0),
        mechanism: Some(mechanism),
        hinges,
        thrust_lines: all_joints.iter().map(|j| thrust(j, [0, 9, 18, 27], 150_000.0)).collect(),
        dimensions,
        collapse_load: Some(96_300.0),
        shapes,
        ..Picture::default()
    }
}

/// A dry wall that falls to the ground.
pub(crate) fn falling_wall() -> Picture {
    let mut shapes = Vec::new();
    for row in 0..10 {
        let shift = if row % 2 == 0 { 0.0 } else { 0.3 };
        for k in 0..6 {
            let x = 0.6 * f64::from(k) + shift;
            shapes.push(shape(rectangle(x, x + 0.6, 0.3 * f64::from(row), 0.3 * f64::from(row + 1)), "block", false));
        }
    }
    shapes.push(shape(rectangle(-1.0, 6.5, -0.4, 0.0), "ground", true));
    let fall = |t: f64| -> Vec<Motion> {
        shapes
            .iter()
            .map(|s| {
                let c = centre(&s.outline);
                let h = (c[1] / 3.0).powi(2);
                if s.held {
                    return Motion::default();
                }
                let drop = (0.6 * t * t * c[1]).min(0.92 * c[1] - 0.1).max(0.0);
                Motion { translation: [1.1 * t * h * c[1], -drop * h], rotation: -1.6 * t * h }
            })
            .collect()
    };
    let snapshots = [0.0, 0.05, 0.2, 0.4, 0.7, 1.0, 1.25, 1.4]
        .into_iter()
        .map(|t| Snapshot {
            load: 1_000.0 * f64::min(2.0, 10.0 * t),
            motions: fall(t),
            velocities: vec![[0.1, -1.0]; shapes.len()],
            contacts: vec![],
            stresses: vec![[-1e4, -5e4, 0.0]; shapes.len()],
            ..Snapshot::default()
        })
        .collect();
    Picture {
        title: "Dry wall".into(),
        loads: vec![LoadArrow { at: [0.3, 2.85], force: [2_000.0, 0.0] }],
        snapshots,
        last_stable: Some(1),
        shapes,
        ..Picture::default()
    }
}

/// One block on a support.
pub(crate) fn single_block() -> Picture {
    Picture {
        title: "One block".into(),
        shapes: vec![
            shape(rectangle(0.0, 0.01, 0.0, 0.02), "block", false),
            shape(rectangle(-0.01, 0.02, -0.005, 0.0), "abutment", true),
        ],
        mechanism: Some(vec![Motion { translation: [1.0, 0.0], rotation: 0.0 }, Motion::default()]),
        sliding: vec![[0.005, 0.0]],
        loads: vec![LoadArrow { at: [0.0, 0.01], force: [1.0, 0.0] }],
        ..Picture::default()
    }
}

/// The arch between end walls under particles in two layers, loaded through a block.
pub(crate) fn filled() -> Picture {
    let mut p = arch();
    p.title = "Fill as particles".into();
    let (left, right, crown, road) = (-1.6, 19.9, 3.561, 4.361);
    for (a, b) in [(left - 0.5, left), (right, right + 0.5)] {
        p.shapes.push(shape(rectangle(a, b, 0.0, road + 1.0), "wall", true));
    }
    p.shapes.push(shape(rectangle(4.2, 4.95, road, road + 0.4), "block", false));
    p.surface = vec![[left, road], [right, road]];
    p.surface_loads = vec![([4.575, road], 0.75)];
    p.loads = vec![LoadArrow { at: [4.575, road + 0.4], force: [0.0, -1e3] }];
    // The back of the ring, as high over x as the parabola through its ends and crown.
    let back = |x: f64| crown - (crown - 0.6) * ((x - 9.15) / 9.9).powi(2).min(1.0);
    p.fill = (0..=40).map(|k| left + (right - left) * f64::from(k) / 40.0).map(|x| [x, back(x)]).collect();
    p.fill.extend([[right, road], [left, road]]);
    p.layers = vec!["fill".into(), "surfacing".into()];
    for row in 0..16 {
        for column in 0..86 {
            let shift = if row % 2 == 0 { 0.0 } else { 0.125 };
            let at = [left + 0.125 + 0.25 * f64::from(column) + shift, road - 0.125 - 0.2165 * f64::from(row)];
            if at[0] < right - 0.1 && at[1] > back(at[0]) + 0.125 {
                p.particles.push(Disc {
                    centre: at,
                    radius: 0.118 + 0.007 * f64::from((row * column) % 2),
                    layer: usize::from(row < 2),
                });
            }
        }
    }
    let count = p.shapes.len();
    for (n, s) in p.snapshots.iter_mut().enumerate() {
        let sink = 0.004 * n as f64 + if n > 3 { 0.1 * (n - 3) as f64 } else { 0.0 };
        s.motions.resize(count, Motion::default());
        s.motions[count - 1].translation[1] = -sink;
        s.velocities.resize(count, [0.0, 0.0]);
        s.stresses.resize(count, [0.0; 3]);
        let near = |at: Point| (-((at[0] - 4.575).powi(2) + (at[1] - road).powi(2))).exp();
        let state = |d: &Disc| DiscState {
            centre: [
                d.centre[0] + 0.4 * sink * near(d.centre) * (d.centre[0] - 4.575),
                d.centre[1] - sink * near(d.centre),
            ],
            angle: sink,
            velocity: [0.0, -sink],
            stress: [-5e3 - 5e4 * near(d.centre), -1e4 - 1.5e5 * near(d.centre), 1e3],
        };
        s.particles = p.particles.iter().map(state).collect();
        for k in 1..p.particles.len() {
            let (a, b) = (s.particles[k - 1].centre, s.particles[k].centre);
            let way = [b[0] - a[0], b[1] - a[1]];
            let length = way[0].hypot(way[1]);
            if length < 0.3 {
                s.particle_forces.push(ParticleForce {
                    particle: k,
                    partner: Partner::Particle(k - 1),
                    point: [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])],
                    normal: [way[0] / length, way[1] / length],
                    compression: 2e3 + 4e4 * near(b),
                    shear: 100.0,
                    stress: 1e5,
                    sliding: k % 50 == 0,
                });
            }
        }
        s.particle_forces.push(ParticleForce {
            particle: 20,
            partner: Partner::Shape(count - 1),
            point: [4.575, road - sink],
            normal: [0.0, -1.0],
            compression: 6e4,
            shear: 0.0,
            stress: 4e5,
            sliding: false,
        });
    }
    p.mechanism.as_mut().unwrap().resize(count, Motion { translation: [0.0, -0.4], rotation: 0.0 });
    for k in count - 3..count - 1 {
        p.mechanism.as_mut().unwrap()[k] = Motion::default();
    }
    p
}

/// All of them with a short name.
pub(crate) fn every() -> Vec<(&'static str, Picture)> {
    vec![
        ("arch", arch()),
        ("crowded", crowded()),
        ("tall", tall()),
        ("rings", two_rings()),
        ("spans", multi_span()),
        ("wall", falling_wall()),
        ("block", single_block()),
        ("filled", filled()),
        ("soiled", soils::soiled()),
        ("two triangles", soils::two_triangles()),
        ("empty", Picture { title: "Nothing".into(), ..Picture::default() }),
    ]
}

/// Two directions of a sweep, with a gap where the load stands beside the span.
pub(crate) fn sweeps() -> Vec<figures::Sweep> {
    let curve = |shift: f64| {
        (0..=120)
            .map(|k| {
                let x = -1.0 + 20.3 * f64::from(k) / 120.0;
                let t = (x + shift) / 18.3;
                let value = 1.6 + 1.2 * (4.0 * PI * (t - 0.02)).cos() + 8.0 * (2.0 * t - 1.0).powi(8);
                (x, if (0.0..=18.3).contains(&x) { value } else { f64::INFINITY })
            })
            .collect()
    };
    vec![
        figures::Sweep { label: "travelling to the right".into(), points: curve(0.0) },
        figures::Sweep { label: "travelling to the left".into(), points: curve(0.7) },
    ]
}

/// The arch with its thickness dimensioned at the crown, above the rise, and its load there too.
pub(crate) fn crowded() -> Picture {
    let mut p = arch();
    let crown = p.dimensions[1].to;
    p.dimensions[2] = DimensionLine { measure: Measure::Thickness, from: crown, to: [crown[0], crown[1] + 0.711] };
    p.surface_loads[0].0[0] = crown[0];
    p
}
