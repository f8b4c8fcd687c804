//! What must hold for any model.

use crate::limit_models::{Ring, sideways, wall};
use mechanics::blocks::{Loading, PointForce};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{ContactPoints, Friction, Settings, Status, collapse_load};
use mechanics::plane::vec2;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn both_bounds_meet_on_any_ring(
        half_angle in 0.3f64..1.5, thickness in 0.05f64..0.4, voussoirs in 4usize..40, friction in 0.2f64..1.5,
        rounded in 0.0f64..0.1, place in 0.05f64..0.95, lean in -0.5f64..0.5,
    ) {
        let ring = Ring {
            intrados: 5.0 * (1.0 - thickness / 2.0), thickness: 5.0 * thickness, half_angle, voussoirs,
            rounding: 0.0, density: 2000.0, friction,
        };
        // Blocks are several times longer than their rounding.
        let ring = Ring { rounding: rounded * ring.thickness.min(ring.intrados * half_angle / voussoirs as f64), ..ring };
        let model = ring.model();
        let block = BlockId::new(1 + (place * voussoirs as f64) as usize);
        let load = PointForce { block, at: model.blocks[block].outline.centroid(), force: vec2(lean * 1e3, -1e3) };
        let loading = Loading { variable: vec![load], ..Loading::default() };
        for contact_points in [ContactPoints::Rounded, ContactPoints::FullRing] {
            let settings = Settings { friction: Friction::Associated, contact_points, ..Settings::default() };
            let outcome = collapse_load(&model, &loading, &settings).unwrap();
            prop_assert!(outcome.status != Status::NotConverged);
            prop_assert_eq!(outcome.interfaces.len(), voussoirs + 1);
            if let Status::Solved = outcome.status {
                let (lower, upper) = (outcome.lower_bound.unwrap(), outcome.upper_bound.unwrap());
                // 1e-6 of the factor, or of the factor whose load is the weight of the ring.
                let size = upper.abs().max(model.free_weight() / 1e3);
                prop_assert!((upper - lower).abs() < 1e-6 * size, "{} {}", lower, upper);
                prop_assert!(outcome.equilibrium_residual < 1e-8 && outcome.yield_violation < 1e-8);
                prop_assert!(outcome.flow_violation < 1e-6);
            }
            if outcome.status != Status::Locks {
                prop_assert!(outcome.mechanism.is_some());
            }
        }
    }

    #[test]
    fn level_sliding_never_carries_more(columns in 1usize..4, rows in 1usize..5, friction in 0.2f64..0.9) {
        let (odd, even): (Vec<f64>, Vec<f64>) = (
            vec![1.0; columns + 1],
            [0.5].into_iter().chain(vec![1.0; columns]).chain([0.5]).collect(),
        );
        let courses: Vec<&[f64]> = (0..rows).map(|i| if i % 2 == 0 { &odd[..] } else { &even[..] }).collect();
        let (model, _) = wall(&courses, 0.4, 0.2, friction);
        let loading = Loading { variable: sideways(&model), ..Loading::default() };
        let outcome = collapse_load(&model, &loading, &Settings::default()).unwrap();
        prop_assert!(outcome.status == Status::Solved, "{:?}", outcome.status);
        let (factor, associated) = (outcome.factor.unwrap(), outcome.associated_factor.unwrap());
        prop_assert!(factor <= associated * (1.0 + 1e-6), "{} {}", factor, associated);
        prop_assert!(outcome.yield_violation < 1e-8);
        // The whole wall can slide on its base, whatever the flow rule.
        prop_assert!(associated <= friction * (1.0 + 1e-6));
    }
}
