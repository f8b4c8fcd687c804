//! Looks on a run: draws its progress, passes on that somebody asked to stop, keeps its checkpoint.

use crate::checkpoint::Checkpoint;
use crate::signs;
pub(crate) use crate::signs::asked_to_stop;
use extrados::{Progress, Refusal, Watch, Wish};
use findings::visible::one_line;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::time::{Duration, Instant};

/// Steps of the bar.
const BAR: u64 = 1_000_000;

/// Looks on one run, and keeps its checkpoint every so often.
pub(crate) struct Watcher<'a> {
    pub spectator: &'a mut Spectator,
    pub checkpoint: &'a Checkpoint,
    pub keep_every: Duration,
    /// When a checkpoint of this run was kept last.
    pub kept: Option<Instant>,
    /// What kept a checkpoint from being written.
    pub trouble: Option<Refusal>,
}

/// Draws progress, and tells how far it is.
pub(crate) struct Spectator(ProgressBar);

/// Lets work be looked on; draws its progress unless that is unwanted.
pub(crate) fn watched<T>(quiet: bool, work: impl FnOnce(&mut Spectator) -> T) -> T {
    let mut spectator = Spectator(bar(quiet, BAR));
    let done = work(&mut spectator);
    spectator.0.finish_and_clear();
    done
}

impl Watch for Spectator {
    fn begin(&mut self, part: &str) {
        signs::begin(part);
    }

    fn look(&mut self, progress: &Progress) -> Wish {
        if let Some(fraction) = progress.fraction {
            self.0.set_position((fraction.clamp(0.0, 1.0) * BAR as f64) as u64);
        }
        let words = match progress.steps {
            0 => progress.stage.clone(),
            steps => format!("{}, {steps} steps", progress.stage),
        };
        signs::tell(&words, progress.fraction);
        self.0.set_message(one_line(&words).into_owned());
        silent(progress)
    }
}

/// Looks on, draws nothing, hears Ctrl-C.
pub(crate) fn silent(_: &Progress) -> Wish {
    if asked_to_stop() { Wish::Stop } else { Wish::GoOn }
}

/// A piece of work is done that is as large as so many.
pub(crate) fn counted_by(bar: &ProgressBar, pieces: u64, what: &str) {
    bar.inc(pieces);
    let share = bar.position() as f64 / bar.length().unwrap_or(1).max(1) as f64;
    bar.set_message(one_line(what).into_owned());
    signs::tell(&format!("last done: {what}"), Some(share));
}

/// A piece of work is done.
pub(crate) fn counted(bar: &ProgressBar, what: &str) {
    bar.inc(1);
    let (done, all) = (bar.position(), bar.length().unwrap_or(1).max(1));
    signs::tell(&format!("{done} of {all} {what}"), Some(done as f64 / all as f64));
}

/// A bar of so many pieces of work on stderr; nothing is drawn where that is no terminal.
pub(crate) fn bar(quiet: bool, length: u64) -> ProgressBar {
    let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(length), target);
    // The template is a constant that a test reads; without it the plain bar does.
    if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
        bar.set_style(style.with_key("left", |state: &ProgressState, words: &mut dyn std::fmt::Write| {
            let told = signs::left(state.elapsed().as_secs_f64(), f64::from(state.fraction()));
            let _ = words.write_str(&told.map_or(String::new(), |left| format!(", {left} left")));
        }));
    }
    bar
}

const TEMPLATE: &str = "{elapsed:>4} {wide_bar} {percent:>3} %{left}  {msg}";

impl Watch for Watcher<'_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        self.spectator.look(progress)
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        let due = self.kept.is_none_or(|kept| kept.elapsed() >= self.keep_every);
        if !due && !asked_to_stop() {
            return;
        }
        match self.checkpoint.keep(&state()) {
            Ok(()) => {
                self.kept = Some(Instant::now());
                signs::keeps("checkpoint", self.checkpoint.path(), self.checkpoint.words());
            }
            Err(failure) => self.trouble = Some(failure),
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_bar_can_be_drawn() {
        assert!(indicatif::ProgressStyle::with_template(super::TEMPLATE).is_ok());
    }
}
