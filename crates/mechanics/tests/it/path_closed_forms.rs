//! The path of equilibrium beside exact solutions and published curves, each computed here: trusses that snap through.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::path::{Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::Unwatched;

const NORMAL: f64 = 1e9;

/// Joints of these stiffnesses that never slide; a pin stands for `pin` [m].
fn law((normal, shear): (f64, f64), pin: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(normal),
        shear: Stiffness::Given(shear),
        friction: 1e3,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: Some(pin),
        least_length: 1e-3,
    }
}

/// Free blocks and supports of `density`, with the law of joints between free blocks and that of joints at a support.
fn model(outlines: Vec<(Vec<Vec2>, Held)>, density: f64, [between, at_support]: [ContactLaw; 2]) -> BlockModel {
    let mut groups: Table<GroupId, String> = Table::default();
    let [free, fixed] = ["free", "fixed"].map(|name| groups.push(name.to_string()));
    let mut blocks = Table::default();
    for (corners, held) in outlines {
        let group = if held.is_fixed() { fixed } else { free };
        blocks.push(Block { outline: Polygon::new(corners).unwrap(), rounding: 0.0, density, group, held });
    }
    let mut laws = LawTable::uniform(2, between);
    laws.set(free, fixed, at_support);
    BlockModel { blocks, particles: Table::default(), groups, laws, gravity: vec2(0.0, -9.81) }
}

/// Density [kg/m^3] that presses joints together, and does no more.
const NEARLY_WEIGHTLESS: f64 = 1e-6;

fn run(model: &BlockModel, loading: &Loading, program: &Program) -> Outcome {
    let settings = Settings { resolution: 1e-7, ..Settings::new(ContactLength::Distributed) };
    collapse(model, loading, (&settings, program), &mut Unwatched).unwrap()
}

fn peak(outcome: &Outcome) -> f64 {
    assert_eq!(outcome.status, Status::LimitPoint);
    outcome.collapse_factor.unwrap()
}

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// A bar from `foot` to `apex`, pointed at both ends.
fn bar(foot: Vec2, apex: Vec2) -> Vec<Vec2> {
    let (middle, wide) = ((foot + apex) * 0.5, (apex - foot).unit().left() * 0.1);
    vec![foot, middle - wide, apex, middle + wide]
}

/// A block that stands across `along` and ends at a point.
fn anvil(at: Vec2, along: Vec2) -> Vec<Vec2> {
    let across = along.left() * 0.1;
    vec![at - along - across, at - across, at + across, at - along + across]
}

/// Two bars on pins, of the length `l` and the slope `s`: each pin is a spring of the stiffness `k` in every direction, so that
/// the thrust `H` shortens half the span by `3 H / 2 k`. A bar turned to the slope `t` carries `P = 2 H tan t` with
/// `H = 2 k (l cos t - l cos s) / 3`, at most `P = 4 k l sin^3 t / 3` where `cos^3 t = cos s` (von Mises 1923).
#[test]
fn a_truss_snaps_through_at_the_load_of_von_mises() {
    for rise in [0.4, 0.1] {
        let (half, pin) = (2.0_f64, 0.3);
        let (foot, apex, far) = (vec2(0.0, 0.0), vec2(half, rise), vec2(2.0 * half, 0.0));
        let axis = (apex - foot).unit();
        // The right bar has a side at the apex.
        let right = vec![apex - vec2(0.0, 0.1), far, apex + vec2(0.0, 0.1)];
        let outlines = vec![
            (anvil(foot, axis), Held::FIXED),
            (bar(foot, apex), Held::FREE),
            (right, Held::FREE),
            (anvil(far, vec2(-axis.x, axis.y)), Held::FIXED),
        ];
        let model = model(outlines, NEARLY_WEIGHTLESS, [law((NORMAL, NORMAL), pin); 2]);
        let force = |block: usize| PointForce { block: BlockId::new(block), at: apex, force: vec2(0.0, -0.5) };
        let loading = Loading { variable: vec![force(1), force(2)], ..Loading::default() };
        let program = Program { increment: 1e3, limit: 1e12, watched: (BlockId(1), apex) };
        let length = half.hypot(rise);
        let turned = (half / length).cbrt().acos();
        let exact = 4.0 / 3.0 * NORMAL * pin * length * turned.sin().powi(3);
        within(peak(&run(&model, &loading, &program)), exact, 1e-7);
    }
}

/// One bar of that truss against a block that slides along a wall: two pins, so that `P = k l sin^3 t / 2`, whichever block of a
/// pin comes first.
#[test]
fn a_bar_snaps_through_against_a_wall() {
    let (foot, apex, pin) = (vec2(0.0, 0.0), vec2(2.0, 0.4), 0.3);
    let mut outlines = vec![
        (anvil(foot, apex.unit()), Held::FIXED),
        (bar(foot, apex), Held::FREE),
        (anvil(apex, vec2(-1.0, 0.0)), Held { x: true, y: false, rotation: true }),
    ];
    for pushed in [2, 0] {
        let model = model(outlines.clone(), NEARLY_WEIGHTLESS, [law((NORMAL, NORMAL), pin); 2]);
        let force = PointForce { block: BlockId(pushed), at: apex, force: vec2(0.0, -1.0) };
        let loading = Loading { variable: vec![force], ..Loading::default() };
        let program = Program { increment: 1e3, limit: 1e12, watched: (BlockId(1), apex) };
        let turned = (apex.x / apex.norm()).cbrt().acos();
        let exact = 0.5 * NORMAL * pin * apex.norm() * turned.sin().powi(3);
        within(peak(&run(&model, &loading, &program)), exact, 1e-7);
        outlines.reverse();
    }
}

/// The same truss of bars that are bedded on faces of the width `b` and stay in contact over all of them: a joint answers a turn
/// with `k b^3 / 12` as well, so that a flat truss of half span `a` carries `2 k b a (s^2 t - t^3) / 3 + k b^3 (s - t) / 2 a`, with
/// the largest value at `t^2 = s^2 / 3 - b^2 / 4 a^2`. What is left is of the order of the slope squared and of the shear.
#[test]
fn a_flat_truss_on_bedded_joints_snaps_through() {
    let half = 2.0;
    for slope in [0.02, 0.01] {
        let (width, apex) = (0.8 * slope, vec2(half, half * slope));
        let (axis, up) = (apex.unit(), vec2(0.0, 0.5 * width));
        let across = axis.left() * (0.5 * width);
        let mirrored = |corners: &[Vec2]| corners.iter().rev().map(|p| vec2(2.0 * half - p.x, p.y)).collect();
        let support = [-across - axis, -across, across, across - axis];
        let left = [-across, apex - up, apex + up, across];
        let outlines = vec![
            (support.to_vec(), Held::FIXED),
            (left.to_vec(), Held::FREE),
            (mirrored(&left), Held::FREE),
            (mirrored(&support), Held::FIXED),
        ];
        let model = model(outlines, NEARLY_WEIGHTLESS, [law((NORMAL, 10.0 * NORMAL), width); 2]);
        let force = |block: usize| PointForce { block: BlockId::new(block), at: apex, force: vec2(0.0, -0.5) };
        let loading = Loading { variable: vec![force(1), force(2)], ..Loading::default() };
        let program = Program { increment: 1.0, limit: 1e12, watched: (BlockId(1), apex) };
        let found = run(&model, &loading, &program);
        let (stiffness, bent) = (NORMAL * width, width / (2.0 * half));
        let turned = (slope * slope / 3.0 - bent * bent).sqrt();
        let thrust = stiffness * half * (slope * slope - turned * turned) / 3.0;
        let exact = 2.0 * thrust * turned + 2.0 * stiffness * half * bent * bent * (slope - turned);
        within(peak(&found), exact, 3.0 * slope * slope);
        assert_eq!(found.path[found.frames[found.peak.unwrap()].step].opened, 0.0);
    }
}
