//! Like spans on heavy piers do not know of one another: each carries under its load what it carries alone, whether their number is even or odd.

use super::*;
use bridge::Bridge;
use mechanics::blocks::Held;
use mechanics::contact::ContactLength;
use mechanics::path::{Ground, Outcome, Program, Settings, Status, collapse as follow};
use mechanics::watch::Unwatched;
use std::fmt::Write;
use structure::discretise::{Discretised, Origin, discretise};

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
    followed(like, count, |_| ())
}

/// The same with a change to their blocks.
fn followed(like: Like, count: usize, change: impl Fn(&mut Discretised)) -> (Outcome, f64) {
    let mut d = discretise(&bridge(like, count)).unwrap();
    change(&mut d);
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

/// What two spans carry less than one is how far their pier gives: 0.112 % on 6 m, 0.094 % on 10 m, 0.083 % on 16 m, where the beds of its one course press and
/// shear. Where the pier is held it is nothing.
#[test]
fn what_like_spans_differ_by_is_how_far_their_piers_give() {
    let (_, one) = path(SHORT, 1);
    let lost = |pier: f64| 1.0 - path(Like { pier, ..SHORT }, 2).1 / one;
    let [six, ten, sixteen] = [6.0, 10.0, 16.0].map(lost);
    assert!((six - 1.12e-3).abs() < 5e-5, "{six}");
    assert!(sixteen > 0.0 && sixteen < 0.95 * ten && ten < 0.9 * six && ten < 1e-3, "{six} {ten} {sixteen}");
    for pier in [6.0, 10.0, 16.0] {
        let (_, held) = followed(Like { pier, ..SHORT }, 2, |d| {
            let piers: Vec<_> = d.origins.pairs().filter(|(_, origin)| matches!(origin, Origin::Pier { .. })).collect();
            assert_eq!(piers.len(), 1);
            let blocks: Vec<_> = piers.into_iter().map(|(block, _)| block).collect();
            blocks.into_iter().for_each(|block| d.model.blocks[block].held = Held::FIXED);
        });
        same(held, one, 3e-5, "a pier that is held");
    }
}

/// What the loads carry where they lie this far beside where the file has them [m], by a sweep.
fn swept<const N: usize>(b: &Bridge, beside: [f64; N]) -> [f64; N] {
    let middle = b.loads[0].position;
    beside.map(|beside| {
        // In company: what stands beside it in the sweep is followed too.
        let ends = [middle + beside - 0.2, middle + beside + 0.2];
        let found = sweep(b, Places::Between(ends, 3), true, &mut Unwatched).unwrap();
        let at = found.points.iter().find(|point| (point.offset - beside).abs() < 1e-9).unwrap();
        at.deformable_factor.unwrap_or_else(|| panic!("{beside}: {at:?}"))
    })
}

/// The loads of a sweep are judged as a single load is, also where rigid blocks lock and the path forks: two spans carry what one does, and a load on one side
/// of the crown what it carries on the other.
#[test]
fn loads_that_move_are_carried_as_on_one_span() {
    let beside = [-0.4, -0.2, 0.0, 0.2, 0.4];
    let one = swept(&bridge(SHORT, 1), beside);
    for (k, &place) in beside.iter().enumerate() {
        let (_, alone) = path(Like { beside: place, ..SHORT }, 1);
        same(one[k], alone, 1e-4, &format!("in a sweep, {place} m beside the crown"));
        same(one[k], one[beside.len() - 1 - k], 1e-4, "mirrored");
    }
    for count in 2..=3 {
        for (many, one) in swept(&bridge(SHORT, count), beside).into_iter().zip(one) {
            same(many, one, 1e-3, &format!("{count} spans"));
        }
    }
}

/// Two rings that slide on one another: each place of a sweep is what the load carries there alone.
#[test]
fn a_sweep_of_rings_that_slide_says_what_each_load_carries_alone() {
    let of = |beside: f64| {
        let mut b = bridge(SHORT, 1);
        let ring = b.spans[0].rings[0].clone();
        b.spans[0].rings.push(ring);
        b.ring_joint = b.joint;
        b.ring_joint.friction_angle = 35f64.to_radians();
        b.loads[0].position += beside;
        b
    };
    let beside = [0.0, 0.1, 0.3, 0.6, 2.0];
    for (in_sweep, place) in swept(&of(0.0), beside).into_iter().zip(beside) {
        let alone = collapse(&of(place), None, &mut Unwatched).unwrap().last_stable_load.unwrap() / 1e3;
        same(in_sweep, alone, 1e-2, &format!("{place} m beside the crown"));
    }
}

/// A vehicle finds its worst place on one of two like spans as on one.
#[test]
fn a_vehicle_over_two_like_spans_is_carried_as_over_one() {
    let least = |count: usize| {
        let mut b = bridge(SHORT, count);
        b.sweep = Some(bridge::SweepPlan { step: Some(0.5), ..vehicles::tests::plan(&["hb-45"]) });
        let found = vehicle_sweep(&b, &mut Unwatched).unwrap();
        found.vehicles[0].deformable.as_ref().unwrap().adequacy.unwrap()
    };
    same(least(2), least(1), 1e-3, "two spans");
}
