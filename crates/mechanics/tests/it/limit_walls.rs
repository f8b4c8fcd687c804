//! Walls of Ferris and Tin-Loi.

use crate::limit_models::wall;
use mechanics::limit::{Friction, Settings, Status, collapse_load};

const A: &[f64] = &[0.5, 1.0, 1.0, 1.0, 1.0, 0.5];
const B: &[f64] = &[1.0, 1.0, 1.0, 1.0, 1.0];
const P: &[f64] = &[1.0, -1.0, 1.0, -1.0, 1.0];
const Q: &[f64] = &[0.5, 0.5, -1.0, 0.5, 0.5, -1.0, 0.5, 0.5];

#[test]
fn ferris_and_tin_loi_associated() {
    let courses: [(&[&[f64]], usize, usize, f64); 3] = [
        (&[A, B, A, B, A, B], 33, 83, 0.64286),
        (&[A, B, A, B, A, B, A, B, A, B], 55, 141, 0.58),
        (&[A, B, A, P, Q, P, Q, P, A, B, A], 55, 116, 0.33195),
    ];
    for (courses, blocks, joints, expected) in courses {
        let (model, loading) = wall(courses, 0.4, 0.175, 0.65);
        let settings = Settings { friction: Friction::Associated, ..Settings::default() };
        let start = std::time::Instant::now();
        let outcome = collapse_load(&model, &loading, &settings).unwrap();
        println!(
            "{:?} {:?} {} {:?} {:?} {:e} {:e} {:e}",
            outcome.status,
            outcome.factor,
            outcome.interfaces.len(),
            outcome.upper_bound,
            start.elapsed(),
            outcome.equilibrium_residual,
            outcome.yield_violation,
            outcome.flow_violation
        );
        assert_eq!(outcome.status, Status::Solved);
        assert_eq!(model.blocks.len() - 1, blocks);
        assert_eq!(outcome.interfaces.len(), joints);
        // Five decimals are printed.
        assert!((outcome.factor.unwrap() - expected).abs() < 1e-5);
    }
}

#[test]
fn ferris_and_tin_loi_without_dilatancy() {
    // Published by Ferris and Tin-Loi: lowest factors found by a complementarity program.
    let courses: [(&[&[f64]], f64); 3] = [
        (&[A, B, A, B, A, B], 0.63982),
        (&[A, B, A, B, A, B, A, B, A, B], 0.56262),
        (&[A, B, A, P, Q, P, Q, P, A, B, A], 0.29645),
    ];
    for (courses, published) in courses {
        let (model, loading) = wall(courses, 0.4, 0.175, 0.65);
        let start = std::time::Instant::now();
        let outcome = collapse_load(&model, &loading, &Settings::default()).unwrap();
        println!(
            "{:?} {:?} {:?} {:?} {} {:?} {:e}",
            published,
            outcome.status,
            outcome.factor,
            outcome.spread,
            outcome.iterations,
            start.elapsed(),
            outcome.yield_violation
        );
    }
}
