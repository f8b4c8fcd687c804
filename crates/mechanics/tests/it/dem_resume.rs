//! A stopped run goes on as if nothing had happened, and only from what was kept for it.

use crate::dem_bridgemill::{INCREMENT, bridgemill, paper, program};
use mechanics::blocks::{BlockModel, Loading, ModelError, Movement};
use mechanics::dem::{ContactLength, Damping, Outcome, Program, Settings, collapse};
use mechanics::ids::BlockId;
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Unwatched, Watch, Wish};

/// Stops at the look with this number and keeps what it was offered last.
pub(crate) struct StopAt {
    looks: u64,
    pub kept: Vec<u8>,
}

impl StopAt {
    pub(crate) fn look(number: u64) -> StopAt {
        StopAt { looks: number, kept: Vec::new() }
    }
}

impl Watch for StopAt {
    fn look(&mut self, _: &Progress) -> Wish {
        if self.looks == 0 {
            return Wish::Stop;
        }
        self.looks -= 1;
        Wish::GoOn
    }
    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        self.kept = state();
    }
}

/// Counts looks.
pub(crate) struct Looks(pub u64);

impl Watch for Looks {
    fn look(&mut self, _: &Progress) -> Wish {
        self.0 += 1;
        Wish::GoOn
    }
}

/// A short run: big steps, one refinement.
fn short() -> (BlockModel, Loading, Program, Settings) {
    let (model, loading) = bridgemill(false, 1.0);
    let program = Program { increment: 8.5 * INCREMENT, ..program(Some(0.3 * INCREMENT)) };
    (model, loading, program, paper(Damping::Local(0.7), ContactLength::Fixed))
}

fn bits(outcome: &Outcome) -> String {
    // Debug prints the shortest text that reads back as the same number.
    format!("{outcome:?}")
}

/// Stopped anywhere (self-weight, load steps, refinement after the return to the stable state) and resumed, even
/// twice, the outcome is that of the undisturbed run to the last bit.
#[test]
fn a_resumed_run_ends_in_the_same_bits() {
    let (model, loading, program, settings) = short();
    let undisturbed = collapse(&model, &loading, &program, &settings, None, &mut Unwatched).unwrap();
    let mut count = Looks(0);
    collapse(&model, &loading, &program, &settings, None, &mut count).unwrap();
    assert!(count.0 >= 8, "{}", count.0);
    for stops in [vec![0], vec![count.0 / 3], vec![count.0 / 2], vec![count.0 - 1], vec![1, 3]] {
        let mut kept: Option<Vec<u8>> = None;
        for look in stops {
            let mut watch = StopAt::look(look);
            let stopped = collapse(&model, &loading, &program, &settings, kept.as_deref(), &mut watch).unwrap();
            assert_eq!(stopped.status, mechanics::dem::Status::Cancelled);
            kept = Some(watch.kept);
        }
        let resumed = collapse(&model, &loading, &program, &settings, kept.as_deref(), &mut Unwatched).unwrap();
        assert_eq!(bits(&resumed), bits(&undisturbed));
    }
}

/// The same while supports are on their way, some of them between two looks.
#[test]
fn a_run_stopped_while_supports_move_ends_in_the_same_bits() {
    let (model, mut loading) = bridgemill(false, 1.0);
    loading.variable.clear();
    loading.movements = vec![Movement { block: BlockId(63), translation: vec2(1.0, 0.0), rotation: 0.0 }];
    let program = Program { increment: 0.03, limit: 0.03, ..program(None) };
    let settings = paper(Damping::Adaptive, ContactLength::Fixed);
    let undisturbed = collapse(&model, &loading, &program, &settings, None, &mut Unwatched).unwrap();
    for look in [0, 1] {
        let mut watch = StopAt::look(look);
        let stopped = collapse(&model, &loading, &program, &settings, None, &mut watch).unwrap();
        assert_eq!((stopped.status, stopped.path.len()), (mechanics::dem::Status::Cancelled, 1));
        let kept = Some(&watch.kept[..]);
        let resumed = collapse(&model, &loading, &program, &settings, kept, &mut Unwatched).unwrap();
        assert_eq!(bits(&resumed), bits(&undisturbed));
    }
}

/// States with any bit flipped or cut short are refused by name.
pub(crate) fn damage_is_refused(kept: &[u8], take: impl Fn(&[u8]) -> Result<(), ModelError>) {
    let refused = Err(ModelError::ForeignState);
    let mut seed = 1_u64;
    for _ in 0..500 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mut damaged = kept.to_vec();
        let place = (seed >> 33) as usize % damaged.len();
        damaged[place] ^= 1 << (seed >> 20 & 7);
        assert_eq!(take(&damaged), refused, "byte {place}");
    }
    for length in [0, 1, 7, 8, 20, 100, kept.len() - 1] {
        assert_eq!(take(&kept[..length]), refused, "{length} bytes");
    }
}

/// States with any bit flipped, cut short, or kept for other blocks, loads, laws, settings or another program are
/// refused by name.
#[test]
fn damaged_and_foreign_states_are_refused() {
    let (model, loading, program, settings) = short();
    let mut watch = StopAt::look(2);
    collapse(&model, &loading, &program, &settings, None, &mut watch).unwrap();
    let kept = watch.kept;
    let take = |model: &BlockModel, loading: &Loading, program: &Program, settings: &Settings, kept: &[u8]| {
        collapse(model, loading, program, settings, Some(kept), &mut StopAt::look(0)).map(|_| ())
    };
    assert_eq!(take(&model, &loading, &program, &settings, &kept), Ok(()));
    let refused = Err(ModelError::ForeignState);
    damage_is_refused(&kept, |kept| take(&model, &loading, &program, &settings, kept));
    let mut other = model.clone();
    other.laws.iter_mut().for_each(|law| law.friction *= 1.01);
    assert_eq!(take(&other, &loading, &program, &settings, &kept), refused);
    let mut moved = loading.clone();
    moved.variable[0].at.x += 0.01;
    assert_eq!(take(&model, &moved, &program, &settings, &kept), refused);
    let tighter = Settings { tolerance: 1e-6, ..settings.clone() };
    assert_eq!(take(&model, &loading, &program, &tighter, &kept), refused);
    let finer = Program { resolution: Some(1.0), ..program };
    assert_eq!(take(&model, &loading, &finer, &settings, &kept), refused);
}
