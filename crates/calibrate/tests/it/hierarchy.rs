//! The paper's search on functions.

use crate::common::{Function, five_model, five_problem, least_squares, with};
use calibrate::misfit::Misfit;
use calibrate::search::hierarchical::{Settings, Status, Variant, search};
use calibrate::search::surface::{Case, Minimum};
use calibrate::search::{gradient, modern};
use calibrate::{Parameter, Start};

const TRUTH: [f64; 5] = [1.2, 0.8, 1.1, 0.7, 1.3];

#[test]
fn a_twin_is_found_within_the_grid_from_means_and_from_bounds() {
    for slices in [false, true] {
        let problem = five_problem(&TRUTH, Misfit { slices, ..Misfit::default() });
        with(&problem, &five_model(), |evaluator, basis| {
            for start in [Start::Means, Start::LowerBounds, Start::UpperBounds] {
                let outcome = search(evaluator, basis, &Settings { start, passes: 6, ..Settings::default() });
                let found = outcome.found.as_ref().expect("a result");
                for (value, truth) in found.point().iter().zip(TRUTH) {
                    // The truth stands on the grid, whose values are rounded by the same formula but for one place.
                    assert!((value - truth).abs() < 1e-12, "{:?} {:?}", found.point(), outcome.status);
                }
                assert!(outcome.settled && outcome.status == Status::Resolved);
                assert!(found.norm < 1e-12 && found.norm < basis.start.norm, "{}", found.norm);
                assert_eq!(found.wandered, Vec::<String>::new());
            }
        });
    }
}

#[test]
fn two_passes_come_near_and_say_that_they_have_not_settled() {
    let problem = five_problem(&TRUTH, Misfit::default());
    with(&problem, &five_model(), |evaluator, basis| {
        for start in [Start::Means, Start::LowerBounds, Start::UpperBounds] {
            let outcome = search(evaluator, basis, &Settings { start, ..Settings::default() });
            assert!(!outcome.settled && outcome.passes.len() == 2);
            assert!(outcome.passes[1].norm <= outcome.passes[0].norm);
            let found = outcome.found.unwrap();
            assert!(found.norm < basis.start.norm, "{} {}", found.norm, basis.start.norm);
            // Two steps of the grid.
            assert!(found.point().iter().zip(TRUTH).all(|(value, truth)| (value - truth).abs() < 0.2 + 1e-9));
        }
    });
}

#[test]
fn a_pass_is_what_figure_4_draws() {
    let problem = five_problem(&TRUTH, Misfit::default());
    with(&problem, &five_model(), |evaluator, basis| {
        let outcome = search(evaluator, basis, &Settings { passes: 1, ..Settings::default() });
        let pass = &outcome.passes[0];
        assert_eq!(pass.sweeps.len(), 5);
        assert!(pass.sweeps.iter().all(|sweep| sweep.values.len() == 11 && sweep.errors.len() == 11));
        let ranges: Vec<f64> = pass.ranking.iter().map(|k| pass.sweeps[*k].range()).collect();
        assert!(ranges.windows(2).all(|pair| pair[0] >= pair[1]), "{ranges:?}");
        assert!((2..=4).contains(&pass.stages.len()), "{}", pass.stages.len());
        assert_eq!(pass.stages[0].surface.parameters, [pass.ranking[0], pass.ranking[1]]);
        assert_eq!(pass.stages[0].surface.norms.len(), 121);
        for pair in pass.stages.windows(2) {
            if let Some(carried) = pair[0].carried {
                assert_eq!(pair[1].surface.parameters[0], carried);
            }
        }
        // No pair is worse than the model before it where that model stands on the grid, as means do.
        let norms: Vec<f64> = pass.stages.iter().map(|stage| stage.surface.norm()).collect();
        assert!(norms.windows(2).all(|pair| pair[1] <= pair[0] + 1e-12), "{norms:?}");
        assert!(pass.naive_norm.unwrap() > pass.norm);
        assert!(outcome.path.len() >= 2 + pass.stages.len());
        assert_eq!(outcome.found.unwrap().evaluations, evaluator.done);
    });
}

#[test]
fn a_truth_beyond_the_bound_is_unconverged_as_printed_and_frozen_as_practised() {
    let truth = [1.2, 1.9, 1.1, 0.7, 1.3];
    let problem = five_problem(&truth, Misfit::default());
    with(&problem, &five_model(), |evaluator, basis| {
        for variant in [Variant::Printed, Variant::AsPractised] {
            let outcome = search(evaluator, basis, &Settings { variant, ..Settings::default() });
            let found = outcome.found.as_ref().unwrap();
            assert_eq!(found.parameters[1].value, 1.5, "{variant:?}");
            assert!(found.parameters[1].at_bound && !found.parameters[1].converged);
            let stages = outcome.passes.iter().flat_map(|pass| &pass.stages);
            for stage in stages.filter(|stage| variant == Variant::Printed && stage.surface.parameters.contains(&1)) {
                assert_eq!(stage.carried, Some(1), "what is on its bound is carried on");
            }
            let frozen = outcome.passes.last().unwrap().frozen[1];
            assert_eq!(frozen, variant == Variant::AsPractised);
            match variant {
                Variant::Printed => assert_eq!(outcome.status, Status::Unresolved(vec![1])),
                Variant::AsPractised => assert_eq!(outcome.status, Status::Resolved),
            }
        }
    });
}

#[test]
fn both_at_bounds_is_called_failed_and_ends_inside_wider_ranges() {
    let range = |name: &str| Parameter::new(name, "", 0.5, 0.0, 1.0);
    let problem = least_squares(vec![range("x"), range("y")], &[1.5, 1.5]);
    let model = Function { channels: 2, length: 1, values: |x: &[f64]| vec![vec![x[0]], vec![x[1]]] };
    with(&problem, &model, |evaluator, basis| {
        let failed = search(evaluator, basis, &Settings::default());
        assert_eq!(failed.status, Status::BothAtBounds([0, 1]));
        assert_eq!(failed.passes[0].stages[0].surface.case, Case::BothAtBound);
        let widened = Some(vec![(0.0, 2.0); 2]);
        let wider = search(evaluator, basis, &Settings { widened, ..Settings::default() });
        assert_eq!(wider.status, Status::Resolved);
        let found = wider.found.unwrap();
        assert!(found.parameters.iter().all(|p| p.converged && (p.value - 1.5).abs() < 0.1 + 1e-9), "{found:?}");
        assert_eq!(wider.ranges, [(0.0, 2.0); 2]);
    });
}

#[test]
fn a_silent_parameter_is_left_unresolved() {
    let range = |name: &str| Parameter::new(name, "", 0.5, 0.0, 1.0);
    let problem = least_squares(vec![range("x"), range("silent"), range("y")], &[0.4, 0.6]);
    let model = Function { channels: 2, length: 1, values: |x: &[f64]| vec![vec![x[0]], vec![x[2]]] };
    with(&problem, &model, |evaluator, basis| {
        for variant in [Variant::Printed, Variant::AsPractised] {
            let outcome = search(evaluator, basis, &Settings { variant, ..Settings::default() });
            assert_eq!(outcome.status, Status::Unresolved(vec![1]), "{variant:?}");
            let found = outcome.found.unwrap();
            assert!(!found.parameters[1].converged);
            assert!((found.parameters[0].value - 0.4).abs() < 1e-12 && (found.parameters[2].value - 0.6).abs() < 1e-12);
        }
    });
}

#[test]
fn a_trough_is_decided_by_its_lower_side() {
    let curve = |norms: &[f64]| Minimum::of(&norms.iter().map(|n| Some(*n)).collect::<Vec<_>>()).unwrap();
    let inside = curve(&[0.3, 0.2, 0.1, 0.104, 0.12]);
    assert!(inside.decided && !inside.at_bound && (inside.rise - 0.02).abs() < 1e-12);
    assert!(!curve(&[0.3, 0.2, 0.1, 0.101, 0.104]).decided);
    assert!(!curve(&[1e-4, 0.0, 1e-4]).decided, "below a tenth of a per cent nothing is seen");
    let bound = curve(&[0.3, 0.2, 0.1]);
    assert!(bound.decided && bound.at_bound);
    assert!(Minimum::of(&[None, None]).is_none());
}

/// A response with a shallow valley at 0.2 and the true one at 0.8; a second parameter that shows by itself.
fn two_valleys(x: &[f64]) -> Vec<Vec<f64>> {
    let tilt = 0.15 * (0.8 - x[0]) / 0.6;
    vec![vec![1.0 + tilt + 10.0 * ((x[0] - 0.2) * (x[0] - 0.8)).powi(2)], vec![x[1] + 0.1 * x[0]]]
}

#[test]
fn from_the_poorer_valley_a_gradient_search_stays_and_the_papers_search_leaves() {
    let parameters = vec![Parameter::new("x", "", 0.1, 0.0, 1.0), Parameter::new("y", "", 0.5, 0.0, 1.0)];
    let problem = least_squares(parameters, &[1.0, 0.68]);
    let model = Function { channels: 2, length: 1, values: two_valleys };
    with(&problem, &model, |evaluator, basis| {
        let downhill = gradient::search(evaluator, basis, Start::Stated, 200).found.unwrap();
        let paper = search(evaluator, basis, &Settings { start: Start::Stated, ..Settings::default() }).found.unwrap();
        let modern = modern::search(evaluator, basis, &modern::Settings::default()).found.unwrap();
        assert!((downhill.point()[0] - 0.2).abs() < 0.1 && downhill.norm > 0.09, "{downhill:?}");
        assert!((paper.point()[0] - 0.8).abs() < 0.05 && paper.norm < 0.05, "{paper:?}");
        assert!(modern.norm < 1e-6, "{modern:?}");
    });
}
