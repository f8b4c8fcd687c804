//! Like spans on heavy piers do not know of one another: each carries under its load what it carries alone, whether their number is even or odd.

use super::*;
use bridge::Bridge;
use mechanics::contact::ContactLength;
use mechanics::path::{Ground, Outcome, Program, Settings, Status, collapse as follow};
use mechanics::watch::Unwatched;
use std::fmt::Write;
use structure::discretise::discretise;

/// Like spans under a load each.
#[derive(Clone, Copy)]
struct Like {
    profile: &'static str,
    /// Span and rise [m].
    size: [f64; 2],
    voussoirs: usize,
    /// Normal stiffness of the joints [GPa/m].
    stiffness: f64,
    /// Width of a pier [m].
    pier: f64,
    /// Length of the load on each span [m].
    length: f64,
    /// Load on the last span, as a share of the others.
    last: f64,
    /// How far the first load lies beside its crown [m].
    beside: f64,
}

/// Loaded from springing to springing.
const LONG: Like = Like {
    profile: "segmental",
    size: [12.0, 1.2],
    voussoirs: 30,
    stiffness: 3.0,
    pier: 16.0,
    length: 12.0,
    last: 1.0,
    beside: 0.0,
};

/// Loaded about the crown, on softer joints.
const SHORT: Like = Like { size: [10.0, 1.0], voussoirs: 20, stiffness: 1.0, length: 8.0, ..LONG };

fn bridge(like: Like, count: usize) -> Bridge {
    let Like { profile, size: [span, rise], voussoirs, stiffness, pier, length, last, beside } = like;
    let mut text = String::from("[bridge]\nname = \"like spans\"\nwidth = \"1 m\"\n");
    for _ in 0..count {
        let _ = writeln!(
            text,
            "[[span]]\nprofile = \"{profile}\"\nspan = \"{span} m\"\nrise = \"{rise} m\"\nthickness = \"0.25 m\"\nvoussoirs = {voussoirs}"
        );
    }
    for _ in 1..count {
        let _ = writeln!(text, "[[pier]]\nwidth = \"{pier} m\"\nheight = \"0.5 m\"\ncourses = 1");
    }
    for k in 0..count {
        let share = if k + 1 == count { last } else { 1.0 };
        let at = (span + pier) * k as f64 + 0.5 * span + if k == 0 { beside } else { 0.0 };
        let _ = writeln!(
            text,
            "[[load]]\nkind = \"knife-edge\"\nforce = \"{share} kN/m\"\nlength = \"{length} m\"\nposition = \"{at} m\""
        );
    }
    let shear = 0.5 * stiffness;
    let _ = writeln!(
        text,
        "[joint]\nnormal_stiffness = \"{stiffness} GPa/m\"\nshear_stiffness = \"{shear} GPa/m\"\nfriction_angle = \"40 deg\"\n\
         cohesion = \"0 kPa\"\n[masonry]\ndensity = \"2200 kg/m^3\"\ncompressive_strength = \"unlimited\"\n[[cover]]\nlayer = \"fill\"\n\
         thickness = \"0.3 m\"\ndensity = \"1900 kg/m^3\"\n[dispersal]\nrule = \"none\"\n[analysis]\nmethod = \"path\""
    );
    let read = ::bridge::read(text.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}\n{text}", read.diagnostics))
}

/// The path of these spans, and the load on one of them at its end [kN/m].
fn path(like: Like, count: usize) -> (Outcome, f64) {
    let d = discretise(&bridge(like, count)).unwrap();
    let one = d.reference_load / (count as f64 - 1.0 + like.last) / 1e3;
    let program = Program { increment: 5.0 / one, limit: 1e4 / one, watched: d.watched };
    let settings = Settings::new(ContactLength::Distributed);
    let found = follow(&d.model, &d.loading, (&settings, &program), None, &mut Unwatched).unwrap();
    let carried = found.last_stable_factor.map_or(0.0, |factor| factor * one * like.last.max(1.0));
    (found, carried)
}

fn same(value: f64, reference: f64, share: f64, what: &str) {
    assert!((value / reference - 1.0).abs() <= share, "{what}: {value}, not {reference}");
}

/// Under even loads a span sways at a fork of its path. Two that sway at the same load, or at loads a little apart, leave the determinant of their
/// tangent positive.
#[test]
fn like_spans_carry_what_one_does() {
    for like in [LONG, SHORT] {
        let (alone, one) = path(like, 1);
        assert_eq!(alone.status, Status::Bifurcation);
        for count in 2..=4 {
            for last in [1.0, 1.01, 1.1, 0.9] {
                let (found, each) = path(Like { last, ..like }, count);
                assert!(matches!(found.status, Status::Bifurcation | Status::LimitPoint), "{count} {last}");
                same(each, one, 1e-3, &format!("{count} spans, the last under {last}"));
            }
        }
    }
}

/// A load that lies 10 mm beside the crown has its span sway from the beginning, and its path has a largest value instead of a fork.
#[test]
fn a_load_beside_the_crown_of_one_span_is_carried_as_by_that_span_alone() {
    for like in [LONG, SHORT].map(|like| Like { beside: 0.01, ..like }) {
        let (alone, one) = path(like, 1);
        assert_eq!(alone.status, Status::LimitPoint);
        assert!(one < path(Like { beside: 0.0, ..like }, 1).1);
        (2..=4).for_each(|count| same(path(like, count).1, one, 1e-3, &format!("{count} spans")));
    }
}

/// On piers that give, spans act on one another: then the even state of two is the same in a bridge whose loads differ by a hair.
#[test]
fn spans_on_slender_piers_carry_no_more_than_spans_whose_loads_differ_by_a_hair() {
    for pier in [0.8, 1.5, 3.0] {
        for count in 2..=4 {
            let slender = Like { pier, ..SHORT };
            let (_, even) = path(slender, count);
            let (_, uneven) = path(Like { last: 1.0 + 1e-4, ..slender }, count);
            same(even, uneven, 5e-3, &format!("{count} spans on piers of {pier} m"));
            assert!(even <= path(SHORT, 1).1 * 1.001, "{count} spans on piers of {pier} m: {even}");
        }
    }
}

/// Whether spans carry their own weight does not depend on how many they are.
#[test]
fn like_spans_stand_where_one_does() {
    let parabolic = Like { profile: "parabolic", ..SHORT };
    for (stiffness, stands) in [(0.4, false), (0.6, true)] {
        for count in 1..=4 {
            let like = Like { stiffness, ..parabolic };
            let (found, _) = path(like, count);
            assert_eq!(found.status == Status::UnstableUnderSelfWeight, !stands, "{count}: {:?}", found.status);
            let d = discretise(&bridge(like, count)).unwrap();
            let settings = Settings::new(ContactLength::Distributed);
            let ground = Ground::new(&d.model, &d.loading, &settings, &mut Unwatched).unwrap();
            assert_eq!((ground.stands(), ground.falls()), (stands, !stands), "{count}");
        }
    }
}

/// The stiffer the joints, the more is carried, by two spans as well as by one.
#[test]
fn no_load_falls_as_joints_get_stiffer() {
    for like in [SHORT, Like { length: 4.0, beside: 2.0, ..SHORT }] {
        for count in [1, 2] {
            let mut before = 0.0;
            for stiffness in [0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0] {
                let (found, each) = path(Like { stiffness, ..like }, count);
                assert_ne!(found.status, Status::NotConverged, "{stiffness}");
                assert!(each >= before * (1.0 - 2e-5), "{count} spans at {stiffness} GPa/m: {each} after {before}");
                before = each;
            }
            let most = rigid(Like { stiffness: 10.0, ..like }, count);
            assert!(most.is_none_or(|most| before < most), "{before}, rigid blocks {most:?}");
            assert_eq!(most.is_some(), like.beside > 0.0, "under even loads rigid spans lock");
        }
    }
}

/// What rigid blocks carry on each span [kN/m]; none where they lock.
fn rigid(like: Like, count: usize) -> Option<f64> {
    let found = collapse_by_limit(&bridge(like, count), &mut Unwatched).unwrap();
    found.collapse_load.map(|load| load / count as f64 / 1e3)
}

/// The loads of a sweep are judged as a single load is: two spans carry what one does.
#[test]
fn loads_that_move_are_carried_as_on_one_span() {
    let swept = |count: usize| {
        let b = bridge(SHORT, count);
        let middle = b.loads[0].position;
        let found = sweep(&b, Places::Between([middle - 0.2, middle + 0.4], 4), true, &mut Unwatched).unwrap();
        let at = |offset: f64| found.points.iter().find(|point| (point.offset - offset).abs() < 1e-9).unwrap();
        [-0.2, 0.2, 0.4].map(|offset| at(offset).deformable_factor.unwrap())
    };
    let one = swept(1);
    for (two, one) in swept(2).into_iter().zip(one) {
        same(two, one, 1e-3, "two spans");
    }
}
