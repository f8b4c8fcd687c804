//! A path as plain words, to the last bit, so that a stopped run goes on as if nothing had happened.

use super::beyond::{Descend, Push};
use super::correct::Balanced;
use super::joint::{Joint, Memory};
use super::outcome::PathPoint;
use super::relax::Falling;
use super::restraint::{Hold, Restrained};
use super::rise::{Past, Rise};
use super::settings::Settings;
use super::stand::{LetGo, Settle};
use super::system::State;
use super::trace::{End, Heading, Path, Stage};
use crate::acting::Resultant;
use crate::contact::{Bond, ContactLength, Resistance};
use crate::digest::checksum;
use crate::words::{Words, fields};

/// First word of every encoding; changes with the layout.
const LAYOUT: u64 = 0x4558_5452_5041_0004;

fields! {
    Bond { lost }
    Memory { sheared, glide, bond }
    State { motions, factor, memory, pressed }
    Balanced { iterations, residual }
    Heading { direction, factor, stable }
    Past { distance, rate }
    LetGo { pressed, share, widest }
    Falling { from, state, drag, corrections, granted }
    Settle { fell_before, falling }
    Rise { heading, share, first, lost, past, step, before }
    Push { end, unit, coarse, falling }
    Descend { end, peak, heading, length, step }
    PathPoint { factor, displacement, eccentricity, opened, hinges, sliding, stress, crushed, mobilised, excess, rate, iterations, residual }
    Resultant { force, cross, dot }
    Resistance { normal, shear, friction, cohesion, crushing, tension, fixed_length, least_length }
    Hold { block, arm }
    Restrained { holds, direction, least, most, half }
    Joint { first, second, on_first, on_second, normal, pin, resistance }
}

impl Words for ContactLength {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(match self {
            ContactLength::Fixed => 0,
            ContactLength::Updated => 1,
            ContactLength::Distributed => 2,
        });
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        [ContactLength::Fixed, ContactLength::Updated, ContactLength::Distributed].get(usize::take(from)?).copied()
    }
}

impl Words for End {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(ENDS.iter().position(|end| end == self).unwrap_or(ENDS.len()) as u64);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        ENDS.get(usize::take(from)?).copied()
    }
}

const ENDS: [End; 6] = [End::Target, End::Limit, End::Bifurcation, End::Lost, End::Falls, End::Stopped];

impl Words for Stage {
    fn put(&self, to: &mut Vec<u64>) {
        let mut kind = |kind: u64| to.push(kind);
        match self {
            Stage::Built => kind(0),
            Stage::LetGo(_) => kind(1),
            Stage::Settle(_) => kind(2),
            Stage::Stood(_) => kind(3),
            Stage::Rise(_) => kind(4),
            Stage::Push(_) => kind(5),
            Stage::Descend(_) => kind(6),
        }
        match self {
            Stage::Built => {}
            Stage::LetGo(joints) => joints.put(to),
            Stage::Settle(settle) => settle.put(to),
            Stage::Stood(balanced) => balanced.put(to),
            Stage::Rise(rise) => rise.put(to),
            Stage::Push(push) => push.put(to),
            Stage::Descend(descend) => descend.put(to),
        }
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        Some(match u64::take(from)? {
            0 => Stage::Built,
            1 => Stage::LetGo(Words::take(from)?),
            2 => Stage::Settle(Words::take(from)?),
            3 => Stage::Stood(Words::take(from)?),
            4 => Stage::Rise(Words::take(from)?),
            5 => Stage::Push(Words::take(from)?),
            6 => Stage::Descend(Words::take(from)?),
            _ => return None,
        })
    }
}

/// Digest of all that a path depends on besides what it has come to.
pub(super) fn fingerprint(path: &Path) -> u64 {
    let mut words = vec![LAYOUT];
    let to = &mut words;
    let model = path.model;
    model.joints.put(to);
    model.restraints.put(to);
    model.built.put(to);
    model.permanent.put(to);
    model.variable.put(to);
    model.movement.put(to);
    model.equation.put(to);
    [model.rounding, model.size].put(to);
    let Settings {
        contact_length,
        touching,
        tolerance,
        most_trials,
        most_steps,
        resolution,
        past,
        fallen,
        farthest,
        onsets: _,
    } = path.settings;
    contact_length.put(to);
    [*touching, *tolerance, *resolution, *past, *fallen, *farthest].put(to);
    [*most_trials, *most_steps].put(to);
    [path.program.increment, path.program.limit].put(to);
    path.program.watched.put(to);
    checksum(&words)
}

/// The path as words; `belongs` is the [`fingerprint`] of what it belongs to. The last word is a checksum, so that damage is seen.
pub(super) fn encode(path: &Path, belongs: u64) -> Vec<u64> {
    let mut words = vec![LAYOUT, belongs];
    let to = &mut words;
    path.state.put(to);
    path.stage.put(to);
    path.length.put(to);
    path.push.put(to);
    path.points.put(to);
    path.states.put(to);
    path.iterations.put(to);
    path.mechanism.put(to);
    path.snaps.put(to);
    let sum = checksum(&words);
    words.push(sum);
    words
}

/// Puts a path to where `words` left it, if they are whole and were written for what `belongs` stands for.
pub(super) fn decode(path: &mut Path, words: &[u64], belongs: u64) -> Option<()> {
    let (&sum, mut words) = words.split_last()?;
    if sum != checksum(words) {
        return None;
    }
    let from = &mut words;
    if u64::take(from)? != LAYOUT || u64::take(from)? != belongs {
        return None;
    }
    path.state = Words::take(from)?;
    path.stage = Words::take(from)?;
    path.length = Words::take(from)?;
    path.push = Words::take(from)?;
    path.points = Words::take(from)?;
    path.states = Words::take(from)?;
    path.iterations = Words::take(from)?;
    path.mechanism = Words::take(from)?;
    path.snaps = Words::take(from)?;
    from.is_empty().then_some(())
}
