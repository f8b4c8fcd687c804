//! Joints whose bond carries tension until it breaks: closed forms of a block that is turned on its bed, by the equilibrium path and
//! by the block engine, which share the law.

use super::dem_bridgemill::{bridgemill, paper, program as blocks_program};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::contact::ContactLength;
use mechanics::dem::{self, Damping};
use mechanics::ids::{BlockId, Table};
use mechanics::path::{Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, vec2};
use mechanics::watch::Unwatched;

const STIFFNESS: f64 = 1e11;
/// Breadth of the bed and height of the block [m].
const SIZE: f64 = 1.0;
const WEIGHT: f64 = 2000.0 * 9.81 * SIZE * SIZE;

/// A block bedded on another one, with its weight or without, turned by a couple: `way` is 1 or -1.
fn bedded(tension: f64, gravity: f64, way: f64) -> (BlockModel, Loading) {
    let law = ContactLaw {
        normal: Stiffness::Given(STIFFNESS),
        shear: Stiffness::Given(STIFFNESS),
        friction: 0.7,
        cohesion: 0.0,
        tension,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 1e-3,
    };
    let mut groups = Table::default();
    let group = groups.push("block".to_string());
    let mut blocks = Table::default();
    for (foot, held) in [(-SIZE, Held::FIXED), (0.0, Held::FREE)] {
        let outline = Polygon::rectangle(vec2(-0.5 * SIZE, foot), SIZE, SIZE).unwrap();
        blocks.push(Block { outline, rounding: 0.0, density: 2000.0, group, held });
    }
    let force = |y: f64, x: f64| PointForce { block: BlockId(1), at: vec2(0.0, y), force: vec2(x, 0.0) };
    let variable = vec![force(SIZE, way / SIZE), force(0.0, -way / SIZE)];
    let model = BlockModel {
        blocks,
        particles: Table::default(),
        groups,
        laws: LawTable::uniform(1, law),
        gravity: vec2(0.0, -gravity),
    };
    (model, Loading { variable, ..Loading::default() })
}

fn program(increment: f64) -> Program {
    Program { increment, limit: 1e12, watched: (BlockId(1), vec2(0.0, SIZE)) }
}

fn run((model, loading): &(BlockModel, Loading), increment: f64) -> Outcome {
    let settings = Settings { resolution: 1e-7, past: 0.5, ..Settings::new(ContactLength::Distributed) };
    collapse(model, loading, (&settings, &program(increment)), None, &mut Unwatched).unwrap()
}

fn peak(outcome: &Outcome) -> f64 {
    assert_eq!(outcome.status, Status::LimitPoint);
    outcome.collapse_factor.unwrap()
}

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// The moment of a bed turned by `turn` whose bond has broken to where the tension is its strength: what is left has the length `h`
/// with `k turn h^2 = 2 f h + 2 N`, and `M = N d / 2 - N h / 3 + f h^2 / 6`, less what the weight has moved sideways.
fn cracked(tension: f64, pressed: f64, turn: f64) -> f64 {
    let rate = STIFFNESS * turn;
    let left = (tension + (tension * tension + 2.0 * rate * pressed).sqrt()) / rate;
    0.5 * pressed * (SIZE - SIZE * turn) - pressed * left / 3.0 + tension * left * left / 6.0
}

/// Without axial force the bed cracks at `M = f d^2 / 6` and then carries less and less, down to nothing; turned the other way it does
/// the same.
#[test]
fn a_bonded_bed_cracks_at_its_strength_in_bending() {
    let tension = 1e5;
    let exact = tension * SIZE * SIZE / 6.0;
    for way in [1.0, -1.0] {
        let found = run(&bedded(tension, 0.0, way), 0.1 * exact);
        within(peak(&found), exact, 1e-6);
        let last = found.path.last().unwrap();
        assert!(last.factor < 0.1 * exact, "{last:?}");
        within(last.factor, cracked(tension, 0.0, last.displacement.x.abs() / SIZE), 1e-3);
    }
}

/// Under its weight `N` it cracks at `M = (N / d + f) d^2 / 6`. Where that is more than the `N d / 2` of a bed without bond, it is the
/// largest load, and the path falls towards that of the bed without bond.
#[test]
fn a_strong_bond_breaks_and_leaves_the_bed_without() {
    let tension = 4.0 * WEIGHT / SIZE;
    let exact = (WEIGHT / SIZE + tension) * SIZE * SIZE / 6.0;
    let found = run(&bedded(tension, 9.81, 1.0), 0.1 * exact);
    within(peak(&found), exact, 1e-5);
    let most = found.path.iter().position(|p| Some(p.factor) == found.collapse_factor).unwrap();
    let after: Vec<_> = found.path[most + 1..].iter().filter(|p| p.displacement.x < 0.01 * SIZE).collect();
    assert!(after.len() > 3);
    for point in after {
        within(point.factor, cracked(tension, WEIGHT, point.displacement.x / SIZE), 1e-4);
    }
}

/// A weaker bond breaks on the way: the load is lost for a moment and found again, and at last it is that of a bed without bond.
#[test]
fn a_weak_bond_breaks_on_the_way_and_changes_nothing_at_the_end() {
    let bare = peak(&run(&bedded(0.0, 9.81, 1.0), 0.02 * WEIGHT));
    let tension = 1.5 * WEIGHT / SIZE;
    let found = run(&bedded(tension, 9.81, 1.0), 0.02 * WEIGHT);
    within(peak(&found), bare, 1e-5);
    assert!(found.snaps > 0, "it broke without a fall");
    let broke = (WEIGHT / SIZE + tension) * SIZE * SIZE / 6.0;
    let whole = found.path.iter().filter(|p| p.opened == 0.0).map(|p| p.factor).fold(0.0, f64::max);
    within(whole, broke, 1e-5);
}

/// Both methods find the load at which a bond breaks: the block engine from below, for its blocks swing.
#[test]
fn blocks_that_swing_break_their_bond_at_the_same_load() {
    let tension = 4.0 * WEIGHT / SIZE;
    let (model, loading) = bedded(tension, 9.81, 1.0);
    let exact = (WEIGHT / SIZE + tension) * SIZE * SIZE / 6.0;
    let program = dem::Program {
        increment: 0.05 * exact,
        limit: 2.0 * exact,
        resolution: Some(0.005 * exact),
        watched: (BlockId(1), vec2(0.0, SIZE)),
    };
    let settings = paper(Damping::Adaptive, ContactLength::Distributed);
    let found = dem::collapse(&model, &loading, &program, &settings, None, &mut Unwatched).unwrap();
    let last = found.last_stable_factor.unwrap();
    assert!(last <= exact && last > 0.97 * exact, "{last} {exact}");
    // Where the crack grows without a fall, nothing is lost from the account.
    let (model, loading) = bedded(0.5 * WEIGHT / SIZE, 9.81, 1.0);
    let most = 0.45 * WEIGHT * SIZE;
    let program = dem::Program { increment: 0.1 * most, limit: most, resolution: None, ..program };
    let found = dem::collapse(&model, &loading, &program, &settings, None, &mut Unwatched).unwrap();
    assert_eq!(found.status, dem::Status::StableToLastLoad);
    assert!(
        found.energy.dissipated > 0.0 && found.energy.drift().abs() < 5e-3 * found.energy.elastic,
        "{:?}",
        found.energy
    );
}

/// An arch carries no less for a stronger bond, and hardly more for one that breaks on the way.
#[test]
fn a_bond_never_weakens_an_arch() {
    let blocks = blocks_program(None);
    let program = Program { increment: blocks.increment, limit: 1e6, watched: blocks.watched };
    let mut last = 0.0;
    for tension in [0.0, 2e5, 1e6] {
        let (mut model, loading) = bridgemill(false, 10.0);
        model.laws.iter_mut().for_each(|law| law.tension = tension);
        let settings = Settings::new(ContactLength::Distributed);
        let found = collapse(&model, &loading, (&settings, &program), None, &mut Unwatched).unwrap();
        let load = found.last_stable_factor.unwrap();
        assert!(load >= last * (1.0 - 1e-4), "{tension}: {load} after {last}");
        last = load;
    }
    assert!(last > 175.0, "a megapascal adds 3 % to 172.6: {last}");
}
