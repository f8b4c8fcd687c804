//! The very same programs with a polygon in place of every cone, solved by the simplex method.
//!
//! A cone `z0 >= |(z1, z2)|` cut at `z0 = 1` is a disk. A regular polygon in it gives a linear program that costs no less, a polygon about it
//! one that costs no more: the two hold the value of the conic program between them. Nothing of Clarabel takes part.

use super::super::model::{Bears, Contact, Continuum, Region, Side, Soil};
use super::super::setting::{Question, Setting};
use super::super::strengths::Strengths;
use super::super::triangulate::triangulate;
use super::super::{lower, upper};
use super::{Conic, EFFORTS, Ending, Kind};
use crate::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use crate::ids::{BlockId, GroupId, Id, Table};
use crate::limit::settings::{Friction, Settings};
use crate::plane::{Polygon, Vec2, vec2};
use crate::watch::CancelToken;
use microlp::{ComparisonOp, OptimizationDirection, Problem, Variable};
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// The least cost with a regular polygon of `edges` in place of each disk, whose corners lie at a distance `reach` from its middle: 1 for a
/// polygon in the disk, `1 / cos(pi / edges)` for one about it.
fn cost_with_polygons(program: &Conic, edges: usize, reach: f64) -> f64 {
    let mut problem = Problem::new(OptimizationDirection::Minimize);
    let mut rows: Vec<Vec<(Variable, f64)>> = vec![Vec::new(); program.right.len()];
    // Adds a variable that stands for so much of several variables of the program.
    let mut add = |low: f64, parts: &[(usize, f64)]| {
        let cost: f64 = parts.iter().map(|&(j, share)| share * program.cost[j]).sum();
        let variable = problem.add_var(cost, (low, f64::INFINITY));
        for &(j, share) in parts {
            for &(equation, v) in &program.columns[j] {
                rows[equation].push((variable, v * share));
            }
        }
    };
    for (j, kind) in program.kinds.iter().enumerate() {
        match kind {
            Kind::Free => add(f64::NEG_INFINITY, &[(j, 1.0)]),
            Kind::Positive => add(0.0, &[(j, 1.0)]),
            // The cone over a polygon holds what its corners add up to. None lies on an axis: coefficients of 1e-17 cost the simplex method minutes.
            Kind::Cone => (0..edges).for_each(|k| {
                let (sin, cos) = (TAU * (k as f64 + 0.5) / edges as f64).sin_cos();
                add(0.0, &[(j, 1.0), (j + 1, reach * cos), (j + 2, reach * sin)]);
            }),
            Kind::Member => {}
        }
    }
    for (row, right) in rows.iter().zip(&program.right) {
        problem.add_constraint(summed(row), ComparisonOp::Eq, *right);
    }
    problem.solve().unwrap().into_solution().unwrap().objective()
}

/// One coefficient for each variable.
fn summed(row: &[(Variable, f64)]) -> Vec<(Variable, f64)> {
    let mut row = row.to_vec();
    row.sort_by_key(|(variable, _)| variable.idx());
    let sums = row.chunk_by(|a, b| a.0 == b.0).map(|same| (same[0].0, same.iter().map(|(_, v)| v).sum()));
    sums.collect()
}

/// Clarabel's factor lies between those of the polygons, which differ by no more than `gap` of it.
fn lies_between(program: &Conic, edges: usize, gap: f64) {
    let found = program.solve(EFFORTS[0], &CancelToken::default());
    assert_eq!(found.ending, Ending::Solved);
    // The cost is the factor with the other sign.
    let factor: f64 = -program.cost.iter().zip(&found.variables).map(|(c, z)| c * z).sum::<f64>();
    let inside = -cost_with_polygons(program, edges, 1.0);
    let about = -cost_with_polygons(program, edges, 1.0 / (PI / edges as f64).cos());
    let size = 1e-6 * factor.abs();
    assert!(inside <= factor + size && factor <= about + size, "{inside} {factor} {about}");
    assert!(about - inside <= gap * factor, "{inside} {factor} {about}: {}", (about - inside) / factor);
}

/// Both programs of a body on its first mesh of about so many triangles.
fn both_lie_between(body: &Body, elements: usize, edges: usize, gap: f64) {
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let setting = Setting::new(&body.model, &body.loading, &settings, &body.earth).unwrap();
    let mesh = triangulate(&body.earth, elements).unwrap();
    let count = mesh.triangles.len();
    assert!((30..=50).contains(&count), "{count} triangles");
    let strengths = Strengths::of(&setting, &mesh);
    lies_between(&lower::asked(&setting, &mesh, &strengths, Question::Factor).program, edges, gap);
    lies_between(&upper::asked(&setting, &mesh, Question::Factor).program, edges, gap);
}

/// Blocks, loads and soil.
struct Body {
    model: BlockModel,
    loading: Loading,
    earth: Continuum,
}

fn model(blocks: Vec<(Vec<Vec2>, Held)>, density: f64) -> BlockModel {
    let joint = ContactLaw {
        normal: Stiffness::Given(1e9),
        shear: Stiffness::Given(1e8),
        friction: 0.6,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 0.0,
    };
    let block = |(corners, held)| Block {
        outline: Polygon::new(corners).unwrap(),
        rounding: 0.0,
        density,
        group: GroupId(0),
        held,
    };
    BlockModel {
        blocks: blocks.into_iter().map(block).collect(),
        particles: Table::default(),
        groups: ["block".to_string()].into_iter().collect(),
        laws: LawTable::uniform(1, joint),
        gravity: vec2(0.0, -9.81),
    }
}

fn touching(a: Vec2, b: Vec2, block: Option<usize>, contact: Contact) -> Side {
    Side { ends: [a, b], bears: Bears::Body { block: block.map(BlockId::new), contact } }
}

fn earth(outline: Vec<Vec2>, soil: Soil, sides: Vec<Side>) -> Continuum {
    Continuum { regions: vec![Region { outline, soil }], sides, water: None, panels: Vec::new() }
}

const SMOOTH: Contact = Contact { friction: 0.0, cohesion: 0.0, tension: f64::INFINITY };

fn soil(cohesion: f64, degrees: f64, weight: f64) -> Soil {
    Soil {
        cohesion,
        friction_angle: degrees.to_radians(),
        tension: f64::INFINITY,
        crushing: f64::INFINITY,
        weight: vec2(0.0, -weight),
        variable_weight: Vec2::ZERO,
    }
}

/// Half of a strip footing 1 m wide, to the right of its middle.
fn footing(soil: Soil) -> Body {
    let corners = [(0.0, -1.0), (1.5, -1.0), (1.5, 0.0), (0.5, 0.0), (0.0, 0.0)].map(|(x, y)| vec2(x, y));
    let [a, b, c, d, e] = corners;
    let rough = Contact { friction: soil.friction_angle.tan(), cohesion: soil.cohesion, tension: f64::INFINITY };
    let sides = vec![
        touching(a, b, None, rough),
        touching(b, c, None, SMOOTH),
        touching(d, e, Some(0), SMOOTH),
        touching(e, a, None, SMOOTH),
    ];
    let plate = [(0.0, 0.0), (0.5, 0.0), (0.5, 0.2), (0.0, 0.2)].map(|(x, y)| vec2(x, y));
    let held = Held { x: true, y: false, rotation: true };
    let variable = vec![PointForce { block: BlockId::new(0), at: vec2(0.25, 0.2), force: vec2(0.0, -0.5) }];
    Body {
        model: BlockModel { gravity: Vec2::ZERO, ..model(vec![(plate.to_vec(), held)], 1.0) },
        loading: Loading { variable, ..Loading::default() },
        earth: earth(corners.to_vec(), soil, sides),
    }
}

/// A ring of eight wedges over 90 degrees, 4 m in radius, between two that are held, under soil between plumb walls; a line load on the third.
fn arch(soil: Soil) -> Body {
    const STONES: usize = 8;
    let at = |k: f64, radius: f64| {
        let angle = FRAC_PI_4 * (2.0 * k / STONES as f64 - 1.0);
        vec2(radius * angle.sin(), radius * angle.cos())
    };
    let (inner, outer) = (3.9, 4.1);
    let wedge = |i: i32| {
        let (a, b) = (f64::from(i), f64::from(i + 1));
        let held = if (0..STONES as i32).contains(&i) { Held::FREE } else { Held::FIXED };
        (vec![at(a, inner), at(b, inner), at(b, outer), at(a, outer)], held)
    };
    let model = model((-1..=STONES as i32).map(wedge).collect(), 2200.0);
    let back: Vec<Vec2> = (0..=STONES).map(|k| at(k as f64, outer)).collect();
    let (left, right) = (back[0], back[STONES]);
    let corners = [vec2(right.x, outer + 0.6), vec2(left.x, outer + 0.6)];
    let contact = Contact { friction: 0.66 * soil.friction_angle.tan(), cohesion: 0.0, tension: 0.0 };
    let mut sides: Vec<Side> =
        back.windows(2).enumerate().map(|(k, ends)| touching(ends[0], ends[1], Some(k + 1), contact)).collect();
    sides.push(touching(right, corners[0], None, SMOOTH));
    sides.push(touching(corners[1], left, None, SMOOTH));
    let load = PointForce { block: BlockId::new(3), at: at(2.5, outer), force: vec2(0.0, -1000.0) };
    Body {
        model,
        loading: Loading { variable: vec![load], ..Loading::default() },
        earth: earth([back, corners.to_vec()].concat(), soil, sides),
    }
}

#[test]
fn polygons_hold_the_bearing_capacity_of_clay_between_them() {
    // Strength alone resists, and a polygon about a disk is 1 / cos(pi / n) times the one in it: 1.97 % for 16 edges.
    let gap = 1.0 / (PI / 16.0).cos() - 1.0;
    both_lie_between(&footing(soil(1.0, 0.0, 0.0)), 40, 16, gap * (1.0 + 1e-3));
}

#[test]
fn polygons_hold_the_bearing_capacity_of_sand_between_them() {
    // Its bearing capacity grows much faster than its strength: 6.1 % from below and 9.6 % from above.
    both_lie_between(&footing(soil(0.5, 30.0, 2.0)), 40, 16, 0.10);
}

#[test]
fn polygons_hold_the_load_of_an_arch_in_soil_between_them() {
    // The ring bears most of it: 0.6 % and 1.3 %.
    both_lie_between(&arch(soil(5e3, 32.0, 18e3)), 50, 16, 0.015);
}
