//! The same linear program, written down again and solved by the simplex method.

use crate::limit_models::{Ring, wall};
use mechanics::blocks::{BlockModel, Loading, PointForce, interfaces};
use mechanics::limit::{ContactPoints, Friction, Settings, collapse_load};
use mechanics::plane::Vec2;
use microlp::{ComparisonOp, OptimizationDirection, Problem, Variable};

/// Load factor with associated friction: equations in newtons and newton metres about the origin, friction as four
/// rays per contact point, so that nothing is shared with the program under test but the joints' geometry.
fn simplex(model: &BlockModel, loading: &Loading, full: bool) -> f64 {
    let unit = model.free_weight();
    let mut problem = Problem::new(OptimizationDirection::Maximize);
    let factor = problem.add_var(1.0, (0.0, f64::INFINITY));
    let blocks = model.blocks.len();
    let mut rows: Vec<[Vec<(Variable, f64)>; 3]> = vec![Default::default(); blocks];
    let mut rest = vec![[0.0; 3]; blocks];
    let parts = |at: Vec2, force: Vec2| [force.x, force.y, at.cross(force)];
    for face in interfaces(model, 1e-6).unwrap() {
        let law = model.laws.between(model.blocks[face.first].group, model.blocks[face.second].group);
        for &at in if full { &face.face } else { &face.points } {
            for side in [1.0, -1.0] {
                let ray = problem.add_var(0.0, (0.0, f64::INFINITY));
                let force = face.normal + face.normal.left() * (side * law.friction);
                for (i, v) in parts(at, force).into_iter().enumerate() {
                    rows[face.second.0 as usize][i].push((ray, v));
                    rows[face.first.0 as usize][i].push((ray, -v));
                }
            }
        }
    }
    let add = |forces: &[PointForce], into: &mut dyn FnMut(usize, usize, f64)| {
        for f in forces {
            for (i, v) in parts(f.at, f.force).into_iter().enumerate() {
                into(f.block.0 as usize, i, v / unit);
            }
        }
    };
    add(&loading.permanent, &mut |b, i, v| rest[b][i] += v);
    let mut drive = vec![[0.0; 3]; blocks];
    // Factors are of the order of the weight where a load is a unit force.
    let size: f64 = loading.variable.iter().map(|f| f.force.norm()).sum::<f64>() / unit;
    add(&loading.variable, &mut |b, i, v| drive[b][i] += v / size);
    for (id, block) in model.blocks.pairs() {
        for (i, v) in parts(block.outline.centroid(), model.gravity * block.mass()).into_iter().enumerate() {
            rest[id.0 as usize][i] += v / unit;
        }
        if !block.held.is_fixed() {
            let b = id.0 as usize;
            for i in 0..3 {
                let mut row = rows[b][i].clone();
                row.push((factor, drive[b][i]));
                problem.add_constraint(&row, ComparisonOp::Eq, -rest[b][i]);
            }
        }
    }
    problem.solve().unwrap().into_solution().unwrap().objective() / size
}

fn agree(model: &BlockModel, loading: &Loading, contact_points: ContactPoints) {
    let settings = Settings { friction: Friction::Associated, contact_points, ..Settings::default() };
    let ours = collapse_load(model, loading, &settings).unwrap().factor.unwrap();
    let theirs = simplex(model, loading, contact_points == ContactPoints::FullRing);
    // The simplex solver's own feasibility tolerance is 1e-7.
    assert!((ours / theirs - 1.0).abs() < 1e-6, "{ours} {theirs}");
}

#[test]
fn a_simplex_solver_agrees_on_bridgemill() {
    let ring = Ring::bridgemill();
    agree(&ring.model(), &ring.quarter_knife(), ContactPoints::Rounded);
    agree(&ring.model(), &ring.quarter_knife(), ContactPoints::FullRing);
}

#[test]
fn a_simplex_solver_agrees_where_joints_slide() {
    let ring = Ring { friction: 0.35, ..Ring::bridgemill() };
    agree(&ring.model(), &ring.quarter_knife(), ContactPoints::Rounded);
    let (model, loading) = wall(&[&[0.5, 1.0, 1.0, 0.5], &[1.0, 1.0, 1.0], &[0.5, 1.0, 1.0, 0.5]], 0.4, 0.175, 0.65);
    agree(&model, &loading, ContactPoints::FullRing);
}
