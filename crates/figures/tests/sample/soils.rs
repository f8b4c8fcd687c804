//! Bridges under fill that yields as a continuum. No number here is a result.

use super::{segmental, shape, square_cells};
use outcome::picture::*;
use outcome::soil::{Plate, SoilPicture, SoilPressure};
use std::f64::consts::PI;

/// Level of the upper face, and where it ends [m].
const TOP: f64 = 5.4;
const ENDS: [f64; 2] = [-3.4, 11.4];
/// Where the load stands [m].
const LOAD: [f64; 2] = [1.7, 2.5];

/// A semicircular ring under fill, whose sway mechanism pushes the fill up on one side.
pub(crate) fn soiled() -> Picture {
    under_fill(1, 16)
}

/// The same with so many columns over each voussoir and so many rows.
pub(crate) fn under_fill(columns: usize, rows: usize) -> Picture {
    let mut picture = segmental("Semicircular arch under fill that yields", 8.0, 4.0, 30, 0.5);
    picture.surface = vec![[ENDS[0], TOP], [ENDS[1], TOP]];
    picture.surface_loads = vec![([0.5 * (LOAD[0] + LOAD[1]), TOP], LOAD[1] - LOAD[0])];
    picture.loads.clear();
    picture.path.clear();
    picture.snapshots.clear();
    picture.last_stable = None;
    let motions = picture.mechanism.clone().unwrap();
    // From the left end along the ground, over the backs, and along the ground.
    let mut floor: Vec<(Point, Option<usize>)> = Vec::new();
    let fine = |list: &mut Vec<(Point, Option<usize>)>, from: Point, to: Point, parts: usize, block: Option<usize>| {
        for k in 0..parts {
            let t = k as f64 / parts as f64;
            list.push(([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])], block));
        }
    };
    let first = picture.shapes[0].outline[3];
    let last = picture.shapes[29].outline[2];
    fine(&mut floor, [ENDS[0], first[1]], first, 12 * columns, None);
    for k in 0..30 {
        fine(&mut floor, picture.shapes[k].outline[3], picture.shapes[k].outline[2], columns, Some(k));
    }
    fine(&mut floor, last, [ENDS[1], last[1]], 12 * columns, None);
    floor.push(([ENDS[1], last[1]], None));
    picture.soil = Some(soil(&picture.shapes, &motions, &floor, rows));
    picture
}

fn soil(shapes: &[Shape], motions: &[Motion], floor: &[(Point, Option<usize>)], rows: usize) -> SoilPicture {
    let wide = floor.len();
    let points: Vec<Point> = (0..=rows)
        .flat_map(|row| {
            let t = row as f64 / rows as f64;
            floor.iter().map(move |([x, y], _)| [*x, y + t * (TOP - y)])
        })
        .collect();
    let triangles = square_cells(wide, rows);
    let still = Motion::default();
    // A wedge below the load goes down with the ring, one above the far haunch goes up with it, the rest stands.
    let step = |distance: f64| 0.5 * (1.0 + (distance / 0.06).tanh());
    let moves: Vec<Point> = (0..points.len())
        .map(|k| {
            let [x, y] = points[k];
            let block = floor[k % wide].1.map_or(still, |b| motions[b]);
            let sinks = step(x - LOAD[0] + 0.45 * (TOP - y)) * step(LOAD[1] - x + 0.3 * (TOP - y));
            let rises = step(x - 4.6 - 0.5 * (TOP - y) + 0.5) * step(7.0 + 0.8 * (y - 3.0) - x);
            let share = (sinks + rises).min(1.0);
            let [u, v] = block.translation;
            [share * u.abs().max(0.3) * if rises > sinks { 0.6 } else { 0.35 }, share * v]
        })
        .collect();
    let rate = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|k| points[k]);
        let twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let gradient = |f: [f64; 3]| {
            [
                ((f[1] - f[0]) * (c[1] - a[1]) - (f[2] - f[0]) * (b[1] - a[1])) / twice,
                ((f[2] - f[0]) * (b[0] - a[0]) - (f[1] - f[0]) * (c[0] - a[0])) / twice,
            ]
        };
        let (u, v) = (gradient(t.map(|k| moves[k][0])), gradient(t.map(|k| moves[k][1])));
        (u[0] - v[1]).hypot(u[1] + v[0])
    };
    let rates: Vec<f64> = triangles.iter().map(rate).collect();
    let most = rates.iter().copied().fold(0.0, f64::max);
    let stress = |[x, y]: Point| {
        let depth = TOP - y;
        // Weight with a coefficient of earth pressure that grows on the passive side, and the load as a line.
        let k = 0.4 + 1.6 * step((x - 5.5) / 10.0);
        let (dx, r2) = (x - 2.1, (x - 2.1).powi(2) + (depth + 0.35).powi(2));
        let bulb = 2.0 * 180e3 / (PI * r2) * (depth + 0.35) / r2.sqrt() / r2.sqrt();
        let [sin, cos] = [dx / r2.sqrt(), (depth + 0.35) / r2.sqrt()];
        let far = if x < -2.6 { 3e3 } else { 0.0 };
        let (xx, yy) = (-18e3 * k * depth + far, -18e3 * depth);
        [xx - bulb * sin * sin, yy - bulb * cos * cos, bulb * sin * cos]
    };
    let pressures = (0..wide - 1).filter_map(|k| {
        let (ends, block) = ([floor[k].0, floor[k + 1].0], floor[k].1?);
        let way = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        let long = way[0].hypot(way[1]);
        let (t, n) = ([way[0] / long, way[1] / long], [-way[1] / long, way[0] / long]);
        let on = |p: Point, d: [f64; 2]| {
            let [xx, yy, xy] = stress(p);
            let pull = [xx * n[0] + xy * n[1], xy * n[0] + yy * n[1]];
            pull[0] * d[0] + pull[1] * d[1]
        };
        Some(SoilPressure { block, ends, pressure: ends.map(|p| -on(p, n)), shear: ends.map(|p| on(p, t)) })
    });
    let plate = Plate { ends: [[LOAD[0], TOP], [LOAD[1], TOP]], motions: [[0.2, -0.7], [0.2, -0.75]] };
    assert!(shapes.len() == motions.len());
    SoilPicture {
        regions: triangles.iter().map(|t| usize::from(t[0] / wide >= rows / 2)).collect(),
        stresses: triangles.iter().map(|t| t.map(|k| stress(points[k]))).collect(),
        dissipation: rates.iter().map(|r| r / most).collect(),
        gaps: vec![1.0 / triangles.len() as f64; triangles.len()],
        pressures: pressures.collect(),
        plates: vec![plate],
        motions: moves,
        points,
        triangles,
    }
}

/// Two triangles over a block that slides out below them.
pub(crate) fn two_triangles() -> Picture {
    let points = vec![[0.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let soil = SoilPicture {
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        regions: vec![0, 0],
        stresses: vec![[[-4e3, -20e3, 0.0]; 3], [[-2e3, -10e3, 1e3]; 3]],
        motions: vec![[0.5, 0.0], [0.5, 0.0], [0.0, 0.0], [0.0, 0.0]],
        dissipation: vec![1.0, 0.0],
        gaps: vec![0.75, 0.25],
        pressures: vec![SoilPressure {
            block: 0,
            ends: [[0.0, 1.0], [1.0, 1.0]],
            pressure: [12_340.0, 20_000.0],
            shear: [0.0, -3e3],
        }],
        plates: vec![Plate { ends: [[0.2, 2.0], [0.8, 2.0]], motions: [[0.0, -0.1]; 2] }],
        points,
    };
    Picture {
        title: "Two triangles".into(),
        shapes: vec![
            shape(vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], "block", false),
            shape(vec![[-0.5, -0.5], [1.5, -0.5], [1.5, 0.0], [-0.5, 0.0]], "abutment", true),
        ],
        mechanism: Some(vec![Motion { translation: [1.0, 0.0], rotation: 0.0 }, Motion::default()]),
        sliding: vec![[0.5, 0.0]],
        collapse_load: Some(12_000.0),
        soil: Some(soil),
        ..Picture::default()
    }
}
