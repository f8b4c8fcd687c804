//! Limit analyses that are stopped: how many iterations they make after the stop, and what they say.

use crate::limit_models::{Ring, wall};
use mechanics::blocks::{BlockModel, Loading, Movement};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{
    Friction, Ground, Increments, MovementStatus, Settings, Status, ThicknessStatus, collapse_load,
    collapse_load_while, minimum_thickness, support_movement,
};
use mechanics::plane::vec2;
use mechanics::watch::CancelToken;

/// Runs `work` to its end, then stopped at several shares of its iterations; each time at most one iteration more may follow.
fn stops<T: std::fmt::Debug>(work: impl Fn(&CancelToken) -> T, is_stopped: impl Fn(&T) -> bool) {
    let whole = CancelToken::default();
    let found = work(&whole);
    assert!(!is_stopped(&found), "{found:?}");
    let all = whole.iterations();
    assert!(all > 3, "{all}");
    for at in [1, all / 3, 2 * all / 3, all - 1] {
        let token = CancelToken::limited_to(at.max(1));
        let found = work(&token);
        assert!(is_stopped(&found), "stopped at {at} of {all}: {found:?}");
        assert!(token.iterations() <= at.max(1) + 1, "{} iterations, stopped at {at} of {all}", token.iterations());
    }
}

#[test]
fn a_wall_without_dilatancy_is_left_within_an_iteration() {
    const A: &[f64] = &[0.5, 1.0, 1.0, 1.0, 1.0, 0.5];
    const B: &[f64] = &[1.0, 1.0, 1.0, 1.0, 1.0];
    let (model, loading) = wall(&[A, B, A, B, A, B], 0.4, 0.175, 0.65);
    let settings = Settings::default();
    stops(
        |token| collapse_load_while(&model, &loading, &settings, token).unwrap(),
        |found| found.status == Status::Cancelled && found.factor.is_none() && found.lower_bound.is_none(),
    );
    // Asking changes no bit.
    let watched = collapse_load_while(&model, &loading, &settings, &CancelToken::default()).unwrap();
    assert_eq!(watched, collapse_load(&model, &loading, &settings).unwrap());
}

#[test]
fn a_place_of_a_sweep_is_left_within_an_exchange() {
    let ring = Ring::bridgemill();
    let loading = Loading { permanent: ring.fill(0.203, 1890.0), ..Loading::default() };
    let (model, load) = (ring.model(), ring.dispersed_knife(-4.0, 0.75, 0.478));
    for friction in [Friction::Associated, Friction::NonAssociated] {
        let ground = Ground::new(&model, &loading, &Settings { friction, ..Settings::default() }).unwrap();
        assert!(ground.is_fast());
        let place = |token: &CancelToken| {
            let mut sweeper = ground.sweeper().paced(token);
            let effect = sweeper.effect(&load);
            sweeper.least(&effect, friction)
        };
        stops(place, |found| found.status == Status::Cancelled && found.factor.is_none());
    }
}

#[test]
fn a_search_for_the_thickness_is_left_within_an_iteration() {
    let make = |thickness: f64| -> (BlockModel, Loading) {
        (Ring::semicircle(20, thickness, 2.0).model(), Loading::default())
    };
    stops(
        |token| minimum_thickness([0.05, 0.3], 1e-4, 0.0, &Settings::default(), token, make).unwrap(),
        |found| found.status == ThicknessStatus::Cancelled && found.stands.is_none() && found.falls.is_none(),
    );
}

#[test]
fn a_support_that_moves_stops_where_the_blocks_last_stood() {
    let ring = Ring::semicircle(20, 0.15, 2.0);
    let apart = Movement { block: BlockId::new(21), translation: vec2(1.0, 0.0), rotation: 0.0 };
    let loading = Loading { movements: vec![apart], ..Loading::default() };
    let increments = Increments { largest: 1.0, step: 1e-2, resolution: 1e-3 };
    stops(
        |token| support_movement(&ring.model(), &loading, 0.0, increments, &Settings::default(), token).unwrap(),
        |found| found.status == MovementStatus::Cancelled && found.falls.is_none(),
    );
}
