//! The search that leaves out cases far above the least, against the search that answers all of them.

use super::search::{self, Thin};
use super::weights;
use crate::samples;
use crate::vehicles::chosen;
use bridge::{Bridge, Directions, Method, Ring, Span, SweepPlan};
use mechanics::watch::Unwatched;

/// A sequence of numbers from 0 to 1 without a pattern, the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A bridge of one or two spans with dimensions, friction and vehicle drawn from a range that bridges have.
fn drawn(seed: u64) -> Bridge {
    let mut numbers = Numbers(seed);
    let mut b = samples::bridgemill();
    let length = numbers.between(4.0, 9.0);
    let thickness = length * numbers.between(0.06, 0.09);
    let ring = Ring { crown_thickness: thickness, springing_thickness: thickness, voussoirs: 23 };
    let rise = length * numbers.between(0.2, 0.35);
    b.spans = vec![Span { span: length, rise, rings: vec![ring], ..b.spans[0].clone() }];
    b.cover.layers = vec![samples::fill(numbers.between(0.3, 0.8), numbers.between(1700.0, 2100.0))];
    b.joint.friction_angle = numbers.between(20.0, 40.0).to_radians();
    b.plan.method = Method::Limit;
    let vehicle = ["cs454-bogie-10", "cs454-triple-8", "cs454-bogie-9.5"][seed as usize % 3];
    b.sweep = Some(SweepPlan {
        rule: "cs-454".into(),
        rule_file: None,
        vehicles: vec![vehicle.to_owned()],
        vehicle_files: Vec::new(),
        step: None,
        directions: Directions::Both,
        subsets: true,
        own_dispersal: false,
        discrete_elements: false,
        texts: Vec::new(),
    });
    b
}

#[test]
fn the_least_factor_is_that_of_the_full_search() {
    for seed in [1, 2, 3] {
        let b = drawn(seed);
        let plan = b.sweep.as_ref().unwrap();
        let (rule, vehicles) = chosen(&b, plan).unwrap();
        let weights = weights::combinations(&b, &rule);
        let with = |stride| {
            let thin = Thin { stride, only_slow: false };
            let step = b.spans[0].span / 40.0;
            search::thinned(&b, &rule, plan, &vehicles, &weights, step, thin, &mut Unwatched).unwrap().remove(0)
        };
        let (all, thin) = (with(1), with(search::STRIDE));
        assert!(thin.cases < all.cases, "{seed}: {} of {} cases", thin.cases, all.cases);
        let [full, least] = [&all, &thin].map(|found| found.adequacy.unwrap());
        assert!((least / full - 1.0).abs() < 1e-9, "{seed}: {least} {full}");
        let at = |found: &super::Swept| found.case.as_ref().map(|case| case.position).unwrap();
        assert!((at(&all) - at(&thin)).abs() < 1e-9, "{seed}: {} {}", at(&all), at(&thin));
    }
}
