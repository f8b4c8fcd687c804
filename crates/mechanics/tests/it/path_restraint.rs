//! Blocks that move against fill along the equilibrium path: a closed form, and a ring between its limits.

use super::dem_bridgemill::{bridgemill, program as blocks_program};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Restraint, Stiffness};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, Table};
use mechanics::limit;
use mechanics::path::{Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, vec2};
use mechanics::watch::Unwatched;

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// A block on a floor that slides against fill: what friction leaves of the push is the hyperbola of its movement.
#[test]
fn a_block_is_pushed_as_far_as_the_fill_lets_it() {
    let law = ContactLaw {
        normal: Stiffness::Given(1e9),
        shear: Stiffness::Given(1e9),
        friction: 0.5,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 1e-3,
    };
    let mut groups = Table::default();
    let group = groups.push("blocks".to_owned());
    let block = |foot: f64, held| Block {
        outline: Polygon::rectangle(vec2(-0.5, foot), 1.0, 1.0).unwrap(),
        rounding: 0.0,
        density: 2000.0,
        group,
        held,
    };
    let blocks = [block(-1.0, Held::FIXED), block(0.0, Held::FREE)].into_iter().collect();
    let model = BlockModel {
        blocks,
        particles: Table::default(),
        groups,
        laws: LawTable::uniform(1, law),
        gravity: vec2(0.0, -9.81),
    };
    let (weight, at, pushed) = (2000.0 * 9.81, vec2(0.0, 0.0), BlockId(1));
    // Movements of a thousandth of the block: it leans by as little as it is no longer over the middle of its bed.
    let [least, most, half] = [0.1 * weight, weight, 1e-4];
    let restraint =
        Restraint { block: pushed, at, direction: vec2(-1.0, 0.0), least, most, half_movement: half, against: None };
    let force = PointForce { block: pushed, at, force: vec2(1.0, 0.0) };
    let loading = Loading { variable: vec![force], restraints: vec![restraint], ..Loading::default() };
    for share in [0.25, 0.5, 0.9] {
        let limit = 0.5 * weight + least + share * (most - least);
        let program = Program { increment: 0.05 * weight, limit, watched: (pushed, at) };
        let settings = Settings::new(ContactLength::Distributed);
        let found = collapse(&model, &loading, (&settings, &program), None, &mut Unwatched).unwrap();
        assert_eq!(found.status, Status::StableToLastLoad);
        let end = found.path.last().unwrap();
        within(end.displacement.x, half * share / (1.0 - share), 1e-5);
        within(end.mobilised, share, 1e-5);
    }
    // Limit analysis knows no movement: all of it is there at once.
    let rigid = limit::collapse_load(&model, &loading, &limit::Settings::default()).unwrap().factor.unwrap();
    within(rigid, 0.5 * weight + most, 1e-6);
}

/// Bridgemill's ring with forces on its blocks that grow with their depth, half of them there after `half` [m].
fn ring(stiffness: f64, half: f64, share: f64) -> (BlockModel, Loading) {
    let (model, mut loading) = bridgemill(false, stiffness);
    let free = model.blocks.pairs().filter(|(_, block)| !block.held.is_fixed());
    let centres: Vec<_> = free.map(|(id, block)| (id, block.outline.centroid())).collect();
    let [left, right] = [0, centres.len() - 1].map(|k| centres[k].1.x);
    let top = centres.iter().map(|(_, c)| c.y).fold(f64::NEG_INFINITY, f64::max) + 0.8;
    let of = |&(block, at): &(BlockId, mechanics::plane::Vec2)| {
        let inwards = if at.x < 0.5 * (left + right) { 1.0 } else { -1.0 };
        let (least, most) = (1e3 * (top - at.y), 1e4 * (top - at.y));
        let most = least + share * (most - least);
        let direction = vec2(inwards, 0.0);
        Restraint { block, at, direction, least, most, half_movement: half, against: None }
    };
    loading.restraints = centres.iter().map(of).collect();
    (model, loading)
}

fn follow((model, loading): &(BlockModel, Loading)) -> Outcome {
    let blocks = blocks_program(None);
    let program = Program { increment: blocks.increment, limit: 5000.0, watched: blocks.watched };
    collapse(model, loading, (&Settings::new(ContactLength::Distributed), &program), None, &mut Unwatched).unwrap()
}

fn load(arch: &(BlockModel, Loading)) -> f64 {
    let found = follow(arch);
    assert_eq!(found.status, Status::LimitPoint);
    found.collapse_factor.unwrap()
}

/// The sooner fill resists, the more is carried: from what the pressure at rest leaves, which the slowest fill comes near, to less
/// than rigid blocks carry under all of it.
#[test]
fn the_load_lies_between_fill_at_rest_and_rigid_blocks_under_all_of_it() {
    let [rest, whole] = [0.0, 1.0].map(|share| load(&ring(1.0, 1.0, share)));
    assert!(whole > rest && whole < 1.05 * rest, "{rest} {whole}");
    let (model, loading) = ring(1.0, 1.0, 1.0);
    let rigid = limit::collapse_load(&model, &loading, &limit::Settings::default()).unwrap().factor.unwrap();
    let mut last = whole;
    for half in [0.3, 0.1, 0.03, 0.01, 0.003, 0.001] {
        let found = load(&ring(1.0, half, 1.0));
        assert!(found > last && found < rigid, "{half}: {last} {found} {rigid}");
        last = found;
    }
    // Stiff joints and fill that resists at once: rigid blocks, from below.
    let near = load(&ring(1e4, 1e-6, 1.0));
    assert!(near < rigid && near > 0.98 * rigid, "{near} {rigid}");
}

/// What moves against fill of its own accord feels no step: a little more of it is a little more load.
#[test]
fn the_load_follows_the_share_and_the_movement_continuously() {
    let [a, b, c] = [0.5, 0.501, 0.502].map(|share| load(&ring(1.0, 0.02, share)));
    assert!(a < b && b < c && ((c - b) / (b - a) - 1.0).abs() < 0.2, "{a} {b} {c}");
    let [a, b, c] = [0.02, 0.02004, 0.02008].map(|half| load(&ring(1.0, half, 1.0)));
    assert!(a > b && b > c && ((c - b) / (b - a) - 1.0).abs() < 0.2, "{a} {b} {c}");
}
