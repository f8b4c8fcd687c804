//! Where a path first meets states that a bridge should not come to in service.

use super::dem_bridgemill::{bridgemill, program as blocks_program};
use super::path_known::column;
use mechanics::blocks::{BlockModel, Loading, PointForce};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, Id};
use mechanics::path::{Ground, Measure, Onset, Outcome, Program, Settings, collapse};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;

fn settings(onsets: &[Onset]) -> Settings {
    Settings { onsets: onsets.to_vec(), ..Settings::new(ContactLength::Distributed) }
}

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// A block of weight `W` and width `b` on a joint without tension, so stiff that it does not lean over, under a load `P` beside its middle. The
/// resultant `W + P` lies at `e P / (W + P)`: the edge is free of stress at `b / 6` and half of the joint open at `b / 3`, and beyond the first the
/// greatest stress is two thirds of the resultant over its distance from the edge.
#[test]
fn a_column_opens_where_statics_say() {
    let (width, height, density, beside) = (0.5, 1.0, 2000.0, 0.2);
    let weight = width * height * density * 9.81;
    let model = column(1, (width, height), density, (1e14, 1e14));
    let at = vec2(beside, height);
    let loading =
        Loading { variable: vec![PointForce { block: BlockId(1), at, force: vec2(0.0, -1.0) }], ..Loading::default() };
    let load = |eccentricity: f64| weight * eccentricity / (beside - eccentricity);
    let stressed = 0.25 * width;
    let stress = (2.0 / 3.0) * (weight + load(stressed)) / (0.5 * width - stressed);
    let sought = [
        Onset { measure: Measure::Eccentricity, most: 1.0 / 6.0 },
        Onset { measure: Measure::Opened, most: 0.5 },
        Onset { measure: Measure::Stress, most: stress },
        Onset { measure: Measure::Stress, most: 1e12 },
    ];
    for increment in [0.05, 0.4] {
        let program = Program { increment: increment * weight, limit: 6.0 * weight, watched: (BlockId(1), at) };
        let found = collapse(&model, &loading, (&settings(&sought), &program), None, &mut Unwatched).unwrap();
        let [edge, half, stressed_at, never] = found.onsets[..] else { panic!("{:?}", found.onsets) };
        within(edge.unwrap(), load(width / 6.0), 1e-4);
        within(half.unwrap(), load(width / 3.0), 1e-4);
        within(stressed_at.unwrap(), load(stressed), 1e-4);
        assert_eq!(never, None);
    }
}

/// States of the ring of Bridgemill.
const SOUGHT: [Onset; 3] = [
    Onset { measure: Measure::Eccentricity, most: 0.25 },
    Onset { measure: Measure::Opened, most: 0.5 },
    Onset { measure: Measure::Softening, most: 2.0 },
];

fn program(increment: f64) -> Program {
    let blocks = blocks_program(None);
    Program { increment: increment * blocks.increment, limit: 1000.0, watched: blocks.watched }
}

fn followed((model, loading): &(BlockModel, Loading), program: &Program) -> Outcome {
    collapse(model, loading, (&settings(&SOUGHT), program), None, &mut Unwatched).unwrap()
}

/// Long steps and short ones tell the same loads, and where the ring is said to have lost half of its stiffness displacements grow twice
/// as fast as at first.
#[test]
fn states_are_met_where_they_are_however_long_the_steps() {
    let ring = bridgemill(false, 1.0);
    let fine = followed(&ring, &program(0.1));
    for increment in [0.37, 1.0, 3.0] {
        let coarse = followed(&ring, &program(increment));
        for (coarse, fine) in coarse.onsets.iter().zip(&fine.onsets) {
            within(coarse.unwrap(), fine.unwrap(), 2e-4);
        }
    }
    let stands = |limit: f64| {
        let found = followed(&ring, &Program { limit, ..program(1.0) });
        let last = found.frames[found.frames.len() - 1].clone();
        assert!((last.factor - limit).abs() < 1e-9 * limit);
        last.poses
    };
    let apart = |limits: [f64; 2]| {
        let [from, to] = limits.map(stands);
        let moved = from.iter().zip(to.iter()).map(|(from, to)| (to.position - from.position).norm());
        moved.fold(0.0, f64::max) / (limits[1] - limits[0])
    };
    let met = fine.onsets[2].unwrap();
    let first = apart([1e-4 * met, 2e-4 * met]);
    let then = apart([0.999 * met, 1.001 * met]);
    within(then, 2.0 * first, 1e-3);
}

/// What is asked below a factor is told where it is below it and not where it is not; and loads that, beside others, are said not to
/// meet a state below a factor do not meet it on their own paths.
#[test]
fn what_is_not_below_a_factor_is_left_out() {
    let (model, loading) = bridgemill(false, 1.0);
    let ground = Ground::new(&model, &loading, &settings(&SOUGHT), &mut Unwatched).unwrap();
    let mut sweeper = ground.sweeper();
    let loaded = loading.variable[0].block.index();
    let force = loading.variable.iter().fold(Vec2::ZERO, |sum, f| sum + f.force);
    let (mut spared, mut asked) = (0, 0);
    for block in loaded - 4..loaded + 8 {
        let id = BlockId::new(block);
        let at = model.blocks[id].outline.centroid();
        let forces = [PointForce { block: id, at, force }];
        let program = Program { watched: (id, at), ..program(1.0) };
        let own = ground.sweeper().carried(&forces, (&program, &[]), &mut Unwatched).onsets;
        let met: Vec<f64> = own.iter().map(|factor| factor.unwrap()).collect();
        for share in [0.9, 0.999, 1.001, 1.1] {
            let below: Vec<f64> = met.iter().map(|factor| share * factor).collect();
            let may = sweeper.may_meet(&forces, &program, &below);
            let told = ground.sweeper().carried(&forces, (&program, &below), &mut Unwatched).onsets;
            for k in 0..SOUGHT.len() {
                asked += u32::from(share < 1.0);
                spared += u32::from(!may[k]);
                assert!(share < 1.0 || may[k], "block {block}, {k} at {share}");
                match told[k] {
                    None => assert!(share < 1.0, "block {block}, {k} at {share}"),
                    Some(factor) => {
                        assert!(share > 1.0, "block {block}, {k} at {share}");
                        within(factor, met[k], 2e-4);
                    }
                }
            }
        }
        sweeper.carried(&forces, (&program, &[]), &mut Unwatched);
    }
    assert!(2 * spared > asked, "{spared} of {asked}");
}
