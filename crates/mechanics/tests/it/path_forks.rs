//! A symmetric arch under even loads sways at a fork of its path: it is found however long the steps are, alone and in a sweep, and what lies past it carries
//! nothing.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::path::{Ground, Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::Unwatched;

const SPAN: f64 = 10.0;
const RISE: f64 = 1.0;
const RING: f64 = 0.25;
const BLOCKS: usize = 20;

fn radius() -> f64 {
    (SPAN * SPAN / 4.0 + RISE * RISE) / (2.0 * RISE)
}

/// A point at `radius` on the joint `k`, counted from the left springing; the crown is above zero.
fn joint(from_centre: f64, k: usize) -> Vec2 {
    let half = (0.5 * SPAN / radius()).asin();
    let angle = half * (2.0 * k as f64 / BLOCKS as f64 - 1.0);
    vec2(from_centre * angle.sin(), from_centre * angle.cos() - radius())
}

/// Rings on one another, between springings that are held.
fn arch(rings: usize) -> BlockModel {
    let law = ContactLaw {
        normal: Stiffness::Given(1e9),
        shear: Stiffness::Given(5e8),
        friction: 40f64.to_radians().tan(),
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 1e-3,
    };
    let mut groups: Table<GroupId, String> = Table::default();
    let group = groups.push("ring".to_string());
    let mut blocks = Table::default();
    for ring in 0..rings {
        let (inner, outer) = (radius() + RING * ring as f64, radius() + RING * (ring + 1) as f64);
        for k in 0..BLOCKS {
            let corners = vec![joint(inner, k), joint(inner, k + 1), joint(outer, k + 1), joint(outer, k)];
            let outline = Polygon::new(corners).unwrap();
            blocks.push(Block { outline, rounding: 0.0, density: 3600.0, group, held: Held::FREE });
        }
    }
    let outer = radius() + RING * rings as f64;
    for (k, beyond) in [(0, -1.0), (BLOCKS, 1.0)] {
        let (low, high) = (joint(radius(), k), joint(outer, k));
        let along = (high - low).left() * (-beyond / (high - low).norm() * 0.5);
        let mut corners = vec![low, high, high + along, low + along];
        if beyond > 0.0 {
            corners.reverse();
        }
        let outline = Polygon::new(corners).unwrap();
        blocks.push(Block { outline, rounding: 0.0, density: 3600.0, group, held: Held::FIXED });
    }
    BlockModel {
        blocks,
        particles: Table::default(),
        groups,
        laws: LawTable::uniform(1, law),
        gravity: vec2(0.0, -9.81),
    }
}

/// 1 kN/m over 8 m of the back, this far beside the crown [m].
fn loads(rings: usize, beside: f64) -> Vec<PointForce> {
    let outer = radius() + RING * rings as f64;
    let on = |k: usize| {
        let (a, b) = (joint(outer, k), joint(outer, k + 1));
        let (from, to) = (a.x.max(beside - 4.0), b.x.min(beside + 4.0));
        let at = a + (b - a) * ((0.5 * (from + to) - a.x) / (b.x - a.x));
        let block = BlockId::new(BLOCKS * (rings - 1) + k);
        (to > from).then(|| PointForce { block, at, force: vec2(0.0, -1e3 * (to - from) / 8.0) })
    };
    (0..BLOCKS).filter_map(on).collect()
}

fn program(increment: f64, forces: &[PointForce]) -> Program {
    Program { increment, limit: 1e5, watched: (forces[0].block, forces[0].at) }
}

fn alone(model: &BlockModel, forces: &[PointForce], increment: f64) -> Outcome {
    let loading = Loading { variable: forces.to_vec(), ..Loading::default() };
    let settings = Settings::new(ContactLength::Distributed);
    collapse(model, &loading, (&settings, &program(increment, forces)), None, &mut Unwatched).unwrap()
}

fn swept(model: &BlockModel, all: &[Vec<PointForce>], increment: f64) -> Vec<Outcome> {
    let settings = Settings::new(ContactLength::Distributed);
    let ground = Ground::new(model, &Loading::default(), &settings, &mut Unwatched).unwrap();
    let mut sweeper = ground.sweeper();
    let follow = |forces: &Vec<PointForce>| sweeper.carried(forces, (&program(increment, forces), &[]), &mut Unwatched);
    all.iter().map(follow).collect()
}

fn same(value: f64, reference: f64, share: f64, what: &str) {
    assert!((value / reference - 1.0).abs() <= share, "{what}: {value}, not {reference}");
}

/// What is told does not depend on steps, and no state that is kept lies above.
#[test]
fn a_fork_is_found_however_long_the_steps_are() {
    let (model, even) = (arch(1), loads(1, 0.0));
    let reference = alone(&model, &even, 1.0);
    assert_eq!(reference.status, Status::Bifurcation);
    let fork = reference.collapse_factor.unwrap();
    for increment in [0.3, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 300.0] {
        let one = alone(&model, &even, increment);
        // Rounding grows along the motion that gives way: where it has by then, the fork looks like a largest load.
        let ends = |status: Status| matches!(status, Status::Bifurcation | Status::LimitPoint);
        assert!(ends(one.status), "steps of {increment}: {:?}", one.status);
        same(one.collapse_factor.unwrap(), fork, 3e-5, &format!("steps of {increment}"));
        let of_sweep = &swept(&model, std::slice::from_ref(&even), increment)[0];
        assert!(ends(of_sweep.status), "steps of {increment} in a sweep: {:?}", of_sweep.status);
        same(of_sweep.last_stable_factor.unwrap(), fork, 3e-5, &format!("steps of {increment} in a sweep"));
        for path in [&one.path, &of_sweep.path] {
            assert!(path.iter().all(|point| point.factor <= fork * (1.0 + 3e-5)), "steps of {increment}");
        }
    }
}

/// A load a hair beside the crown carries a hair less, on either side, and never more than the even one, whatever was followed before it.
#[test]
fn loads_beside_the_crown_carry_less_than_the_even_one() {
    let model = arch(1);
    let fork = alone(&model, &loads(1, 0.0), 1.0).collapse_factor.unwrap();
    let beside = [0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-6, 1e-9];
    let right: Vec<_> = beside.iter().chain([&0.0]).map(|&beside| loads(1, beside)).collect();
    let left: Vec<_> = beside.iter().chain([&0.0]).map(|&beside| loads(1, -beside)).collect();
    for increment in [3.0, 20.0, 90.0] {
        let [right, left] = [&right, &left].map(|all| swept(&model, all, increment));
        let factors: Vec<f64> = right.iter().map(|found| found.last_stable_factor.unwrap()).collect();
        assert!(factors.windows(2).all(|pair| pair[0] <= pair[1] * (1.0 + 3e-5)), "{factors:?}");
        same(*factors.last().unwrap(), fork, 3e-5, "the even load after others");
        assert!(factors[0] < 0.9 * fork);
        for (k, (right, left)) in right.iter().zip(&left).enumerate() {
            same(
                left.last_stable_factor.unwrap(),
                right.last_stable_factor.unwrap(),
                5e-5,
                &format!("load {k}, mirrored"),
            );
        }
    }
}

/// Rings that slide on one another: what slides does so along the path, so that a first step of any length leads to the load of many small ones, in a sweep as
/// alone.
#[test]
fn rings_that_slide_carry_the_same_however_long_the_steps_are() {
    let model = arch(2);
    for beside in [0.0, 0.1, 0.3, 0.6, 1.0, 2.0] {
        let forces = loads(2, beside);
        let reference = alone(&model, &forces, 0.5).collapse_factor.unwrap();
        for increment in [1.0, 5.0, 20.0, 60.0, 200.0, 1000.0] {
            let what = format!("{beside} m beside the crown, steps of {increment}");
            same(alone(&model, &forces, increment).collapse_factor.unwrap(), reference, 1e-2, &what);
            let of_sweep = &swept(&model, std::slice::from_ref(&forces), increment)[0];
            assert_ne!(of_sweep.status, Status::NotConverged, "{what}");
            same(of_sweep.last_stable_factor.unwrap(), reference, 1e-2, &format!("{what}, in a sweep"));
        }
    }
}
