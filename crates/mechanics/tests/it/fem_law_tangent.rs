//! Tangents against differences of stress.

use crate::fem_law::{Dice, all, size};
use mechanics::fem::law::{Four, Memory, Plane, Solid};

/// Relative disagreement of the tangent with the difference of stress over `step` along each strain, the worse of two sides
/// and the better of them.
fn disagreement(solid: &Solid, strain: &Four, old: &Memory, step: f64) -> (f64, f64) {
    let here = solid.respond(strain, old);
    let stiffness = 1.4 * 50e6;
    let mut worst: (f64, f64) = (0.0, 0.0);
    for j in 0..4 {
        if solid.plane == Plane::Stress && j == 2 {
            continue;
        }
        let stress = |by: f64| {
            let mut moved = *strain;
            moved[j] += by;
            solid.respond(&moved, old).stress
        };
        // One-sided differences of second order: at a kink of the law one of the two sides may disagree, off it neither.
        let side = |step: f64| {
            let (one, two) = (stress(step), stress(2.0 * step));
            (0..4).fold(0.0, |worst: f64, i| {
                let slope = (4.0 * one[i] - two[i] - 3.0 * here.stress[i]) / (2.0 * step);
                worst.max((slope - here.tangent[i][j]).abs() / stiffness)
            })
        };
        let (ahead, behind) = (side(step), side(-step));
        worst = (worst.0.max(ahead.max(behind)), worst.1.max(ahead.min(behind)));
    }
    worst
}

#[test]
fn tangents_are_the_slopes_of_stress() {
    for plane in [Plane::Strain, Plane::Stress] {
        for material in all() {
            let solid = Solid { material, plane };
            let mut dice = Dice(7);
            let (mut smooth, mut yielding, mut kinks) = (0, 0, 0);
            for _ in 0..3000 {
                let old = solid.respond(&dice.four(3e-4), &Memory::default()).memory;
                let strain = dice.strain();
                let scale = size(&std::array::from_fn(|i| strain[i] - old.plastic[i]));
                // The step's cube, over the square of the distance to where principal values cross, against rounding over the step, and
                // the millionth of elasticity that tangents keep.
                let (worst, best) = disagreement(&solid, &strain, &old, 1e-5 * scale);
                if worst < 2e-5 {
                    smooth += 1;
                    yielding += i32::from(solid.respond(&strain, &old).yields);
                } else {
                    // Where two pieces of the surface meet the tangent is that of one of them, or, at its very tip, of neither.
                    kinks += 1;
                    let tip = size(&solid.respond(&strain, &old).stress) <= 1e-9 * 50e6 * scale;
                    assert!(best < 2e-5 || tip, "{material:?} {strain:?}: {worst:e} {best:e}");
                }
            }
            assert!(kinks <= 60 && smooth + kinks == 3000, "{plane:?} {material:?}: {kinks} kinks");
            assert!(yielding > 400, "{plane:?} {material:?}: {yielding} of {smooth} yield");
        }
    }
}
