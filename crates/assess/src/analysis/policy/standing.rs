//! What states come to beside one another: which leads, and what it does not count.

use outcome::help::{Help, NotCounted, WithHelp};
use outcome::note::{self, Note, Size};
use outcome::warning::{self, Warning};

/// Help that changes a result by less than this share makes no difference, and is not told.
const SAME: f64 = 1e-3;

/// What a state comes to: its size, by which states are compared (more is better), and its numbers for a reader.
pub(super) struct Standing {
    pub(super) size: f64,
    pub(super) numbers: WithHelp,
}

/// The state that leads: of those that are least to round-off, the one that counts most.
pub(super) fn leading(all: &[Standing]) -> usize {
    let least = all.iter().map(|one| one.size).fold(f64::INFINITY, f64::min);
    // What is not known, or does not stand, has nothing near it.
    let near = |size: f64| size <= least || least.is_finite() && size - least <= 1e-9 * least.abs();
    (0..all.len()).rev().find(|k| near(all[*k].size)).unwrap_or(0)
}

/// Whether one is more than another, and more than round-off.
fn is_more(size: f64, than: f64) -> bool {
    size > than && (than.is_infinite() || size - than > SAME * than.abs())
}

/// What the leading state does not count, and what each state that counts more of it comes to.
pub(super) fn not_counted(all: &[Standing], lead: usize) -> NotCounted {
    let counted = &all[lead].numbers.helps;
    let adds = |one: &&Standing| {
        one.numbers.helps.iter().any(|help| !counted.contains(help)) && is_more(one.size, all[lead].size)
    };
    let with_help: Vec<WithHelp> = all.iter().filter(adds).map(|one| one.numbers.clone()).collect();
    let left_out = Help::ALL
        .iter()
        .copied()
        .filter(|help| !counted.contains(help) && with_help.iter().any(|with| with.helps.contains(help)));
    NotCounted { left_out: left_out.collect(), with_help }
}

/// What is told of help that is left out of the bridge, or of a vehicle on it; fill pressure by itself has words of its own (A195). `own`
/// is what leads.
pub(super) fn warned(
    found: &NotCounted,
    vehicle: Option<&str>,
    own: Size,
    size: fn(&WithHelp) -> Size,
) -> Option<Warning> {
    if found.left_out.iter().all(|help| *help == Help::FillPressure) {
        return None;
    }
    let with = found.with_help.iter().map(|with| (size(with), with.helps.clone())).collect();
    let (vehicle, left_out) = (vehicle.map(str::to_owned), found.left_out.clone());
    Some(warning::Loads::HelpNotCounted { vehicle, own, left_out, with }.into())
}

/// Help that hurts, and is counted.
pub(super) fn hurts(all: &[Standing], lead: usize, size: fn(&WithHelp) -> Size) -> Option<Note> {
    let counted = &all[lead].numbers.helps;
    let bare = all.iter().find(|one| one.numbers.helps.is_empty())?;
    let hurts = is_more(bare.size, all[lead].size) && !counted.is_empty();
    let [without, with] = [bare, &all[lead]].map(|one| size(&one.numbers));
    hurts.then(|| note::State::Counted { helps: counted.clone(), without, with }.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::collapse::Status;

    fn standing(helps: &[Help], size: f64) -> Standing {
        let numbers = WithHelp { helps: helps.to_vec(), status: Status::Collapsed, ..WithHelp::default() };
        Standing { size, numbers }
    }

    #[test]
    fn a_bridge_that_falls_without_its_help_is_not_led_by_it() {
        let bare = |size: f64| [standing(&[], size), standing(&[Help::Cohesion], 50.0)];
        assert_eq!(leading(&bare(f64::NEG_INFINITY)), 0);
        assert_eq!(leading(&bare(0.0)), 0);
        assert_eq!(leading(&bare(50.0 * (1.0 + 1e-10))), 1);
        assert_eq!(leading(&bare(60.0)), 1);
        let endless = [standing(&[], f64::INFINITY), standing(&[Help::Cohesion], f64::INFINITY)];
        assert_eq!(leading(&endless), 1);
        assert_eq!(not_counted(&bare(f64::NEG_INFINITY), 0).left_out, [Help::Cohesion]);
    }
}
