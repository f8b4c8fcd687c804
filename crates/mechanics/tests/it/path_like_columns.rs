//! Like columns side by side give way together: each at the load that it has alone, whether their number is even or odd.

use super::path_known::column;
use mechanics::blocks::{Block, BlockModel, Held, Loading, PointForce};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, Id, Table};
use mechanics::path::{Ground, Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, vec2};
use mechanics::watch::Unwatched;

const BLOCKS: usize = 8;
const SIZE: (f64, f64) = (0.5, 1.5);
const HEIGHT: f64 = BLOCKS as f64 * SIZE.1;
const NORMAL: f64 = 1e9;

/// So many columns of eight blocks of a density [kg/m^3], too far apart to touch; and the block at the top of each.
fn columns(count: usize, density: f64) -> (BlockModel, Vec<BlockId>) {
    let one = column(BLOCKS, SIZE, density, (NORMAL, 1e11));
    let (group, mut blocks, mut tops) = (one.groups.pairs().next().unwrap().0, Table::default(), Vec::new());
    for place in 0..count {
        for k in 0..=BLOCKS {
            let corner = vec2(10.0 * place as f64 - 0.5 * SIZE.0, SIZE.1 * (k as f64 - 1.0));
            let outline = Polygon::rectangle(corner, SIZE.0, SIZE.1).unwrap();
            let held = if k == 0 { Held::FIXED } else { Held::FREE };
            blocks.push(Block { outline, rounding: 0.0, density, group, held });
        }
        tops.push(BlockId::new(blocks.len() - 1));
    }
    (BlockModel { blocks, ..one }, tops)
}

/// Loads [N/m] on the tops, each this far beside the axis of its column [m].
fn loads(tops: &[BlockId], of: impl Fn(usize) -> (f64, f64)) -> Vec<PointForce> {
    let on = |(k, &block): (usize, &BlockId)| {
        let (load, beside) = of(k);
        PointForce { block, at: vec2(10.0 * k as f64 + beside, HEIGHT), force: vec2(0.0, -load) }
    };
    tops.iter().enumerate().map(on).collect()
}

const DISTRIBUTED: ContactLength = ContactLength::Distributed;

fn run(model: &BlockModel, variable: Vec<PointForce>) -> Outcome {
    let program = Program { increment: 1e4, limit: 1e12, watched: (variable[0].block, variable[0].at) };
    let loading = Loading { variable, ..Loading::default() };
    collapse(model, &loading, (&Settings::new(DISTRIBUTED), &program), None, &mut Unwatched).unwrap()
}

/// Euler's load of one column, as in `path_known`.
fn euler() -> f64 {
    let turn = NORMAL * SIZE.0.powi(3) / 12.0;
    turn / SIZE.1 * (2.0 - 2.0 * (std::f64::consts::PI / (2.0 * BLOCKS as f64 + 1.0)).cos())
}

const WEIGHTLESS: f64 = 1e-6;

fn same(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// The load on the last column is as large as on the others, or larger by a hundredth or a tenth: then it buckles first. A second one at
/// the same load, or soon after, changes nothing.
#[test]
fn like_columns_buckle_at_the_load_of_one() {
    for count in 1..=4 {
        let (model, tops) = columns(count, WEIGHTLESS);
        for larger in [1.0, 1.01, 1.1] {
            let found = run(&model, loads(&tops, |k| (if k + 1 == count { larger } else { 1.0 }, 0.0)));
            assert_eq!(found.status, Status::Bifurcation, "{count} {larger}");
            // The joints are pressed by 0.1 % of a block's height.
            same(larger * found.collapse_factor.unwrap(), euler(), 1.5e-3);
        }
    }
}

/// Loads that stand beside the axis have a largest value below that of Euler, the same for one column and for many.
#[test]
fn like_columns_under_loads_beside_their_axes_carry_what_one_does() {
    let largest = |count: usize| {
        let (model, tops) = columns(count, WEIGHTLESS);
        let found = run(&model, loads(&tops, |_| (1.0, 1e-3)));
        assert_eq!(found.status, Status::LimitPoint, "{count}");
        found.collapse_factor.unwrap()
    };
    let one = largest(1);
    assert!(one < 0.995 * euler(), "{one}");
    (2..=4).for_each(|count| same(largest(count), one, 1e-4));
}

/// In a sweep of loads a state is sought beside that of a load met before: what two columns would carry only as long as neither leans is not
/// carried.
#[test]
fn a_load_of_a_sweep_is_not_carried_where_two_columns_would_buckle() {
    for count in 1..=2 {
        let (model, tops) = columns(count, WEIGHTLESS);
        let settings = Settings::new(DISTRIBUTED);
        let ground = Ground::new(&model, &Loading::default(), &settings, &mut Unwatched).unwrap();
        let mut sweeper = ground.sweeper();
        let forces = loads(&tops, |_| (1.0, 0.0));
        let program = Program { increment: 1e4, limit: 0.9 * euler(), watched: (tops[0], forces[0].at) };
        let found = sweeper.carried(&forces, (&program, &[]), &mut Unwatched);
        assert_eq!(found.status, Status::StableToLastLoad, "{count}");
        assert!(sweeper.carries(&forces, 0.95 * euler()), "{count}");
        assert!(!sweeper.carries(&forces, 1.05 * euler()), "{count}");
        let followed = sweeper.carried(&forces, (&Program { limit: 2.0 * euler(), ..program }, &[]), &mut Unwatched);
        assert_eq!(followed.status, Status::Bifurcation, "{count}");
        same(followed.last_stable_factor.unwrap(), euler(), 1.5e-3);
    }
}
