//! A stopped path goes on as if nothing had happened, and only from what was kept for it.

use super::dem_bridgemill::{bridgemill, program as blocks_program};
use super::dem_resume::{StopAt, damage_is_refused};
use mechanics::blocks::{BlockModel, Loading, ModelError};
use mechanics::contact::ContactLength;
use mechanics::path::{Outcome, Program, Settings, Status, collapse};
use mechanics::watch::{Progress, Unwatched, Watch, Wish};

fn program() -> Program {
    let blocks = blocks_program(None);
    Program { increment: blocks.increment, limit: 1000.0, watched: blocks.watched }
}

/// What the run was doing at each look, without its numbers.
#[derive(Default)]
struct Stages(Vec<String>);

impl Watch for Stages {
    fn look(&mut self, progress: &Progress) -> Wish {
        self.0.push(progress.stage.trim_end_matches(|c: char| c.is_ascii_digit() || ".- ".contains(c)).to_owned());
        Wish::GoOn
    }
}

fn run(arch: &(BlockModel, Loading), settings: &Settings, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Outcome {
    collapse(&arch.0, &arch.1, (settings, &program()), resume, watch).unwrap()
}

fn bits(outcome: &Outcome) -> String {
    // Debug prints the shortest text that reads back as the same number.
    format!("{outcome:?}")
}

/// Three looks of each thing that a run does: the first, one in the middle, the last.
fn places(stages: &[String]) -> Vec<u64> {
    let mut words: Vec<&String> = stages.iter().collect();
    words.sort();
    words.dedup();
    let mut places = Vec::new();
    for word in words {
        let looks: Vec<usize> = (0..stages.len()).filter(|&k| stages[k] == *word).collect();
        places.extend([looks[0], looks[looks.len() / 2], looks[looks.len() - 1]].map(|k| k as u64));
    }
    places
}

/// A ring a hundred times as heavy, on joints of 1 MPa: it falls under its own weight.
fn heavy() -> (BlockModel, Loading) {
    let mut arch = bridgemill(false, 1.0);
    arch.0.gravity = arch.0.gravity * 100.0;
    arch.0.laws.iter_mut().for_each(|law| law.crushing = 1e6);
    arch
}

/// Stiff joints of a bond that breaks on the way, now here, now there.
fn bonded() -> (BlockModel, Loading) {
    let mut arch = bridgemill(false, 10.0);
    arch.0.laws.iter_mut().for_each(|law| law.tension = 1e6);
    arch
}

/// Under its own weight, on the way up, where balance is lost and found again, and past the peak: the outcome is that of an
/// undisturbed run to the last bit; also where it is stopped again right after it was taken up.
#[test]
fn a_resumed_path_ends_in_the_same_bits() {
    let mut seen = Vec::new();
    // Joints that press at points lose their balance for a while on the way.
    let cases = [
        (ContactLength::Fixed, bridgemill(false, 1.0)),
        (ContactLength::Distributed, bridgemill(true, 1.0)),
        (ContactLength::Distributed, heavy()),
        (ContactLength::Distributed, bonded()),
    ];
    for (contact_length, arch) in cases {
        let settings = Settings::new(contact_length);
        let mut stages = Stages::default();
        let undisturbed = bits(&run(&arch, &settings, None, &mut stages));
        for stop in places(&stages.0) {
            let mut watch = StopAt::look(stop);
            assert_eq!(run(&arch, &settings, None, &mut watch).status, Status::Cancelled);
            let mut again = StopAt::look(1);
            if run(&arch, &settings, Some(&watch.kept), &mut again).status == Status::Cancelled {
                watch = again;
            }
            let resumed = run(&arch, &settings, Some(&watch.kept), &mut Unwatched);
            assert!(bits(&resumed) == undisturbed, "{contact_length:?} stopped at look {stop} of {}", stages.0.len());
        }
        seen.extend(stages.0);
    }
    for wanted in
        ["self-weight", "self-weight, let fall", "load factor", "balance lost at load factor", "past the peak"]
    {
        assert!(seen.iter().any(|stage| stage == wanted), "no run was stopped in {wanted}");
    }
}

/// States with any bit flipped, cut short, or kept for other blocks, loads, laws, settings or another program are refused by name.
#[test]
fn damaged_and_foreign_states_of_a_path_are_refused() {
    let arch = bridgemill(false, 1.0);
    let settings = Settings::new(ContactLength::Distributed);
    let mut watch = StopAt::look(20);
    run(&arch, &settings, None, &mut watch);
    let kept = watch.kept;
    let take = |(model, loading): &(BlockModel, Loading), settings: &Settings, program: &Program, kept: &[u8]| {
        collapse(model, loading, (settings, program), Some(kept), &mut StopAt::look(0)).map(|_| ())
    };
    assert_eq!(take(&arch, &settings, &program(), &kept), Ok(()));
    damage_is_refused(&kept, |kept| take(&arch, &settings, &program(), kept));
    let refused = Err(ModelError::ForeignState);
    let mut other = arch.clone();
    other.0.laws.iter_mut().for_each(|law| law.friction *= 1.01);
    assert_eq!(take(&other, &settings, &program(), &kept), refused);
    let mut other = arch.clone();
    other.1.variable[0].at.x += 0.01;
    assert_eq!(take(&other, &settings, &program(), &kept), refused);
    let points = Settings::new(ContactLength::Fixed);
    assert_eq!(take(&arch, &points, &program(), &kept), refused);
    let finer = Settings { resolution: 1e-6, ..settings.clone() };
    assert_eq!(take(&arch, &finer, &program(), &kept), refused);
    let shorter = Program { limit: 900.0, ..program() };
    assert_eq!(take(&arch, &settings, &shorter, &kept), refused);
}
