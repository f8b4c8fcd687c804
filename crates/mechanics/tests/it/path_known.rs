//! The equilibrium path where it is known in closed form.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::path::{Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::Unwatched;

const NORMAL: f64 = 1e9;

/// Blocks of `width` by `height` [m] and `density` on a fixed base, one on the other, on joints of these normal and shear stiffnesses [Pa/m].
pub(crate) fn column(
    count: usize,
    (width, height): (f64, f64),
    density: f64,
    (normal, shear): (f64, f64),
) -> BlockModel {
    let law = ContactLaw {
        normal: Stiffness::Given(normal),
        shear: Stiffness::Given(shear),
        friction: 10.0,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 1e-3,
    };
    let mut groups: Table<GroupId, String> = Table::default();
    let group = groups.push("column".to_string());
    let mut blocks = Table::default();
    for k in 0..=count {
        let corner = vec2(-0.5 * width, height * (k as f64 - 1.0));
        let outline = Polygon::rectangle(corner, width, height).unwrap();
        let held = if k == 0 { Held::FIXED } else { Held::FREE };
        blocks.push(Block { outline, rounding: 0.0, density, group, held });
    }
    let laws = LawTable::uniform(1, law);
    BlockModel { blocks, particles: Table::default(), groups, laws, gravity: vec2(0.0, -9.81) }
}

fn run(model: &BlockModel, at: Vec2, force: Vec2, increment: f64) -> Outcome {
    let top = BlockId::new(model.blocks.len() - 1);
    let loading = Loading { variable: vec![PointForce { block: top, at, force }], ..Loading::default() };
    let program = Program { increment, limit: 1e12, watched: (top, at) };
    let settings = Settings { resolution: 1e-7, ..Settings::new(ContactLength::Distributed) };
    collapse(model, &loading, (&settings, &program), None, &mut Unwatched).unwrap()
}

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// A block of weight `W` whose centre is `h` above its joint, pushed sideways there by `H`. Its joint answers a turn `t` with the
/// moment `W (b/2 - c/3)`, where `c = sqrt(2 W / (k t))` is pressed, the weight leans over by `h t` and is lifted by `(b/2 - c) t`.
/// To the first order the push is largest at `t^3 = W / (18 k h^2)`; the largest of the curve itself is sought by trying.
#[test]
fn a_block_that_rocks_on_a_soft_joint() {
    let (width, height, density) = (1.0, 2.0, 2000.0);
    let model = column(1, (width, height), density, (NORMAL, 1e11));
    let (weight, centre) = (width * height * density * 9.81, 0.5 * height);
    let found = run(&model, vec2(0.0, centre), vec2(1.0, 0.0), 0.01 * weight);
    let push = |turn: f64| {
        let pressed = (2.0 * weight / (NORMAL * turn)).sqrt();
        let arm = 0.5 * width * turn.cos() - pressed / 3.0 - centre * turn.sin();
        weight * arm / (centre * turn.cos() + (0.5 * width - pressed) * turn.sin())
    };
    let first = (weight / (18.0 * NORMAL * centre * centre)).cbrt();
    let largest = (500..2000).map(|k| push(first * f64::from(k) * 1e-3)).fold(0.0, f64::max);
    assert_eq!(found.status, Status::LimitPoint);
    // What is left is of the order of the turn squared, (13 mrad)^2.
    within(found.collapse_factor.unwrap(), largest, 3e-4);
}

/// A weightless block of height `h` under a load with the eccentricity `e` on a joint without tension: with `u = b/2 - e` the
/// load is largest at a turn of `u / 3h` and is then `2 k u^3 / 3 h`: the one-block column without tension (Yokel 1971 has the
/// continuous one).
#[test]
fn an_eccentric_column_without_tension() {
    let (width, height) = (0.5, 20.0);
    for eccentricity in [0.10, 0.15, 0.20] {
        let model = column(1, (width, height), 1e-6, (NORMAL, 1e11));
        let found = run(&model, vec2(eccentricity, height), vec2(0.0, -1.0), 1.0);
        let u = 0.5 * width - eccentricity;
        assert_eq!(found.status, Status::LimitPoint);
        within(found.collapse_factor.unwrap(), 2.0 * NORMAL * u.powi(3) / (3.0 * height), 3e-4);
    }
}

/// Euler's load of a column of `n` blocks that turn on their joints alone: `(2 - 2 cos(pi / (2 n + 1))) r / h` with the stiffness
/// `r = k b^3 / 12` of a joint. Nothing tells the column which way to go, so that it is a bifurcation.
#[test]
fn a_column_buckles_at_the_load_of_euler() {
    let (width, height) = (0.5_f64, 1.5);
    let turn = NORMAL * width.powi(3) / 12.0;
    for count in [8, 20] {
        let model = column(count, (width, height), 1e-6, (NORMAL, 1e11));
        let found = run(&model, vec2(0.0, height * count as f64), vec2(0.0, -1.0), 1e4);
        let euler = turn / height * (2.0 - 2.0 * (std::f64::consts::PI / (2.0 * count as f64 + 1.0)).cos());
        assert_eq!(found.status, Status::Bifurcation);
        // The joints are pressed by 0.1 % of a block's height at that load with eight blocks.
        within(found.collapse_factor.unwrap(), euler, 1.5e-3);
        // The motion that is told is the way it buckles, a quarter of a wave, and not the one that shortens it.
        let moves = |k: usize| found.mechanism[BlockId::new(k)].0;
        let (top, middle) = (moves(count), moves(count / 2));
        assert!(top.x.abs() > 100.0 * top.y.abs(), "{top:?}");
        assert!((0.2..0.32).contains(&(middle.x / top.x)), "{middle:?} {top:?}");
    }
}
