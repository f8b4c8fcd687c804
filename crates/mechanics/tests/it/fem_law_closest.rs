//! Returned stress against roads that share nothing with the way back: the closest point in energy, flow rules, paths.

use crate::fem_law::{Dice, FILL, all, associated, cone, excess, invariants, principal, pyramid, size};
use mechanics::fem::law::{Cone, Four, Law, Material, Memory};

/// Any strain of one to a thousand times that at yield.
fn work(stress: &Four, strain: &Four) -> f64 {
    (0..4).map(|i| stress[i] * strain[i]).sum()
}

#[test]
fn associated_flow_finds_the_closest_point_in_energy() {
    // Of a convex set, the closest point c to t is the one for which (t - c) : C⁻¹ : (a - c) ≤ 0 with every a of the set.
    for material in associated() {
        let mut dice = Dice(11);
        let mut flows = 0;
        for _ in 0..400 {
            let strain = dice.strain();
            let answer = material.respond(&strain, &Memory::default());
            let closest = answer.stress;
            let way = answer.memory.plastic;
            flows += i32::from(answer.yields);
            // Admissible stresses far and near: anything, drawn in along the line to one that surely is.
            for trial in 0..120 {
                let reach = (size(&closest) + 1e4) * [1.0, 0.1, 1e-2, 1e-3][trial % 4];
                let other: Four = std::array::from_fn(|i| closest[i] + reach * dice.roll());
                let deep = -1e3 - 3.0 * size(&other);
                let safe = [deep, deep, deep, 0.0];
                let safe = if excess(&material, &safe) < 0.0 { safe } else { [0.0; 4] };
                let at = |share: f64| -> Four { std::array::from_fn(|i| safe[i] + share * (other[i] - safe[i])) };
                let (mut inside, mut outside) = (0.0, 1.0);
                if excess(&material, &other) <= 0.0 {
                    inside = 1.0;
                } else {
                    for _ in 0..60 {
                        let middle = 0.5 * (inside + outside);
                        if excess(&material, &at(middle)) <= 0.0 { inside = middle } else { outside = middle }
                    }
                }
                let admissible = at(inside);
                let apart: Four = std::array::from_fn(|i| admissible[i] - closest[i]);
                let gain = work(&apart, &way);
                // Rounding of the trial stress, times the flow.
                let rounding = 1e-10 * (2e8 * size(&strain) + 1e4) * size(&way);
                assert!(gain <= rounding, "{material:?} {strain:?}: {gain:e} over {rounding:e}");
            }
        }
        assert!(flows > 60, "{material:?}: {flows}");
    }
}

#[test]
fn the_apex_is_where_the_cone_ends() {
    // fem.dp.apex: c 10, φ 30°, ψ 10°, outer cone. Uniaxial tension yields at k / (1/√3 + α) = 14.85.
    let law = cone(Cone::Compression, 10.0, 30.0, 10.0);
    let uniaxial = law.strength / (1.0 / 3.0_f64.sqrt() + law.alpha);
    assert!((uniaxial - 14.85).abs() < 0.005, "{uniaxial}");
    for (share, yields) in [(1.0 - 1e-9, false), (1.0 + 1e-9, true)] {
        let strain = FILL.strain(&[share * uniaxial, 0.0, 0.0, 0.0]);
        assert_eq!(law.respond(&strain, &Memory::default()).yields, yields);
    }
    // Stretched alike in all directions, whatever the dilatancy, it stands at the apex k/3α = c cot φ for this cone.
    for dilatancy in [0.0, 10.0, 30.0] {
        let law = cone(Cone::Compression, 10.0, 30.0, dilatancy);
        let answer = law.respond(&[1e-3, 1e-3, 1e-3, 1e-7], &Memory::default());
        let apex = 10.0 / 30f64.to_radians().tan();
        for i in 0..3 {
            assert!((answer.stress[i] - apex).abs() < 1e-6 * apex);
        }
        // It does not move; a millionth of elasticity is left to the tangent, for the sake of the equations of balance.
        assert!(answer.tangent.iter().flatten().all(|t| t.abs() < 2e-6 * 50e6));
        // All strain beyond the elastic one of the apex has flowed.
        let volume: f64 = answer.memory.plastic[..3].iter().sum();
        assert!((volume - (3e-3 - apex / FILL.bulk())).abs() < 1e-8 * volume);
        // Alike for the pyramid, whose apex is the same.
        let answer = pyramid(10.0, 30.0, dilatancy).respond(&[1e-3, 1e-3, 1e-3, 1e-7], &Memory::default());
        assert!((0..3).all(|i| (answer.stress[i] - apex).abs() < 1e-6 * apex), "{answer:?}");
    }
    // No yield under any pressure.
    for law in all() {
        assert!(!law.respond(&[-1.0, -1.0, -1.0, 0.0], &Memory::default()).yields, "{law:?}");
    }
}

#[test]
fn cones_match_the_pyramid_where_they_should() {
    // fem.dp.match, derived: associated flow in plane strain.
    let expected =
        [(20.0, 0.111847, 0.921891), (30.0, 0.160128, 0.83205), (35.6, 0.183931, 0.770736), (40.0, 0.200876, 0.718183)];
    for (friction, alpha, strength) in expected {
        let law = cone(Cone::PlaneStrain, 1.0, friction, friction);
        assert!((law.alpha - alpha).abs() < 1e-6 && (law.strength - strength).abs() < 1e-6, "{law:?}");
        assert_eq!(law.alpha, law.beta);
        // The greatest cone within the pyramid is the same one: associated flow touches where it is inscribed.
        let inner = cone(Cone::Inner, 1.0, friction, friction);
        assert!((law.alpha - inner.alpha).abs() < 1e-12 && (law.strength - inner.strength).abs() < 1e-12);
    }
    // Edges of the pyramid lie on the outer two cones, and the inner one within the pyramid whatever the direction.
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let pyramid = Material::MohrCoulomb(pyramid(10e3, 30.0, 30.0));
    for great in [-50e3, 0.0, 5e3] {
        let small = (great * (1.0 + sin) - 2.0 * 10e3 * cos) / (1.0 - sin);
        let on =
            |matched: Cone, stress: Four| excess(&Material::DruckerPrager(cone(matched, 10e3, 30.0, 0.0)), &stress);
        assert!(on(Cone::Compression, [great, great, small, 0.0]).abs() < 1e-8);
        assert!(on(Cone::Extension, [great, small, small, 0.0]).abs() < 1e-8);
    }
    let inner = cone(Cone::Inner, 10e3, 30.0, 30.0);
    let (mut dice, mut least) = (Dice(5), f64::INFINITY);
    for _ in 0..4000 {
        let trial = dice.four(1e-2);
        let answer = inner.respond(&trial, &Memory::default());
        if answer.yields {
            let beyond = excess(&pyramid, &answer.stress);
            assert!(beyond < 1e-6, "{beyond}");
            least = least.min(beyond.abs() / size(&answer.stress));
        }
    }
    assert!(least < 1e-2, "touches nowhere: {least}");
}

#[test]
fn flow_dilates_by_its_angle() {
    // Plane strain on a face: volume over the difference of the principal strains is sin ψ.
    for dilatancy in [0.0_f64, 10.0, 30.0] {
        let law = pyramid(10e3, 30.0, dilatancy);
        let answer = law.respond(&[-3e-3, 2e-3, -1.0e-3, 1e-3], &Memory::default());
        let [x, y, z, shear] = answer.memory.plastic;
        assert!(answer.yields && z.abs() < 1e-14, "{answer:?}");
        assert!(((x + y) / (x - y).hypot(shear) - dilatancy.to_radians().sin()).abs() < 1e-9);
        // And of the cone: β I1 beside √J2, volume 3β for each unit of flow, whose deviator has the length 1/√2.
        let law = cone(Cone::Compression, 10e3, 30.0, dilatancy);
        let answer = law.respond(&[-3e-3, 2e-3, -1.0e-3, 1e-3], &Memory::default());
        let [x, y, z, shear] = answer.memory.plastic;
        let volume = x + y + z;
        let (_, root) = invariants(&[x, y, z, 0.5 * shear]);
        assert!(answer.yields && (volume / root - 6.0 * law.beta).abs() < 1e-9);
    }
}

#[test]
fn one_step_is_as_good_as_many_along_a_proportional_path() {
    // Along a ray the deviator keeps its direction, and so does flow on a smooth surface: exact, but for rounding. On the pyramid
    // what has flowed on the way may differ where the ray changes faces; here it stays with those it meets first.
    let laws = [
        Material::DruckerPrager(cone(Cone::Compression, 10e3, 30.0, 30.0)),
        Material::DruckerPrager(cone(Cone::Compression, 10e3, 30.0, 0.0)),
        Material::MohrCoulomb(pyramid(10e3, 30.0, 30.0)),
        Material::MohrCoulomb(pyramid(10e3, 30.0, 0.0)),
    ];
    let paths: [Four; 4] =
        [[-4e-3, 3e-3, 0.0, 1e-3], [-4e-3, 2e-3, 0.0, 0.0], [2e-3, 2e-3, -9e-3, 0.0], [0.0, 0.0, 0.0, 5e-3]];
    for law in laws {
        for path in paths {
            let once = law.respond(&path, &Memory::default());
            assert!(once.yields, "{law:?} {path:?}");
            for steps in [2, 7, 100] {
                let mut memory = Memory::default();
                let mut stress = [0.0; 4];
                for step in 1..=steps {
                    let answer = law.respond(&path.map(|e| e * f64::from(step) / f64::from(steps)), &memory);
                    (stress, memory) = (answer.stress, answer.memory);
                }
                for i in 0..4 {
                    assert!((stress[i] - once.stress[i]).abs() < 1e-9 * size(&once.stress), "{law:?} {path:?} {steps}");
                }
                assert!((memory.hardening - once.memory.hardening).abs() < 1e-9 * once.memory.hardening);
            }
        }
    }
}

#[test]
fn stress_never_jumps() {
    // Walking through strain in small steps, no stress moves by more than elasticity and flow allow; flow that is not
    // associated may amplify, never by more than this factor.
    for law in all() {
        let mut dice = Dice(19);
        for _ in 0..60 {
            let (from, to) = (dice.strain(), dice.strain());
            let at = |share: f64| -> Four { std::array::from_fn(|i| from[i] + share * (to[i] - from[i])) };
            let length = size(&std::array::from_fn(|i| to[i] - from[i]));
            let mut before = law.respond(&from, &Memory::default()).stress;
            for step in 1..=500 {
                let stress = law.respond(&at(f64::from(step) / 500.0), &Memory::default()).stress;
                let moved = size(&std::array::from_fn(|i| stress[i] - before[i]));
                assert!(moved < 10.0 * 50e6 * length / 500.0, "{law:?} {from:?} {to:?} at {step}: {moved:e}");
                before = stress;
            }
        }
    }
}

#[test]
fn order_of_principal_stresses_is_kept() {
    let mut dice = Dice(23);
    for law in all() {
        for _ in 0..500 {
            let strain = dice.strain();
            let answer = law.respond(&strain, &Memory::default());
            assert!(principal(&answer.stress).iter().all(|s| s.is_finite()));
            // Same directions: stress and strain have no shear between one another's axes.
            let twist =
                (strain[0] - strain[1]) * answer.stress[3] - 0.5 * strain[3] * (answer.stress[0] - answer.stress[1]);
            let ways =
                (strain[0] - strain[1]) * (answer.stress[0] - answer.stress[1]) + 2.0 * strain[3] * answer.stress[3];
            let rounding = 1e-11 * size(&strain) * (2e8 * size(&strain) + 1e5);
            assert!(twist.abs() <= rounding && ways >= -rounding, "{law:?} {strain:?}");
        }
    }
}
