//! What passes between signals, the run and the thread that waits for it. Signals reach a program, not a part of it: this is the
//! one global state.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

static STOP: AtomicBool = AtomicBool::new(false);
static BUSY: AtomicUsize = AtomicUsize::new(0);
static NOW: Mutex<Now> =
    Mutex::new(Now { task: String::new(), words: String::new(), fraction: None, begun: None, kept: None });

/// What the run does just now.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Now {
    /// Which part of the command, such as a stage of an assessment; empty where there is one only.
    pub task: String,
    /// What it last said.
    pub words: String,
    /// Share of the part that is done, where it can be told.
    pub fraction: Option<f64>,
    /// When the part began.
    pub begun: Option<Instant>,
    pub kept: Option<Kept>,
}

/// What stays of a run that is cut off.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Kept {
    /// Its key in the object: "checkpoint", "cache", "log".
    pub key: &'static str,
    /// Where it is.
    pub place: String,
    /// The same for people.
    pub words: String,
}

/// Listens to Ctrl-C, to termination and to a terminal that closes: the first asks the run to stop, the second ends the command at
/// once.
pub(crate) fn listen() {
    let heard = ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::SeqCst) {
            std::process::exit(i32::from(crate::status::Status::Cancelled.exit_code()));
        }
    });
    // Without a handler a signal ends the command as the system does; the last checkpoint stands either way.
    drop(heard);
}

/// Whether the command was asked to stop.
pub(crate) fn asked_to_stop() -> bool {
    STOP.load(Ordering::SeqCst)
}

/// Files are being moved into their place as long as this lives: the command ends after that and not in between.
pub(crate) struct Busy(());

/// Says that files are being moved.
pub(crate) fn busy() -> Busy {
    BUSY.fetch_add(1, Ordering::SeqCst);
    Busy(())
}

/// Whether files are being moved.
pub(crate) fn is_busy() -> bool {
    BUSY.load(Ordering::SeqCst) > 0
}

impl Drop for Busy {
    fn drop(&mut self) {
        BUSY.fetch_sub(1, Ordering::SeqCst);
    }
}

fn lock() -> MutexGuard<'static, Now> {
    NOW.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the run does just now.
pub(crate) fn now() -> Now {
    lock().clone()
}

/// Begins a part of the command.
pub(crate) fn begin(task: &str) {
    let mut now = lock();
    (now.task, now.words, now.fraction, now.begun) = (task.to_owned(), String::new(), None, Some(Instant::now()));
}

/// A share that falls by more than this is that of another part.
const FALL: f64 = 0.05;

/// Tells what is being done.
pub(crate) fn tell(words: &str, fraction: Option<f64>) {
    let mut now = lock();
    let fell = now.fraction.zip(fraction).is_some_and(|(old, new)| new < old - FALL);
    if fell || now.begun.is_none() {
        now.begun = Some(Instant::now());
    }
    words.clone_into(&mut now.words);
    now.fraction = fraction;
}

/// Tells what stays should the run be cut off.
pub(crate) fn keeps(key: &'static str, place: &std::path::Path, words: impl Into<String>) {
    lock().kept = Some(Kept { key, place: place.display().to_string(), words: words.into() });
}

/// How long the rest of a piece of work takes that has come so far in so many seconds; nothing where nobody can tell yet.
pub(crate) fn left(spent: f64, share: f64) -> Option<String> {
    let rest = spent * (1.0 - share) / share;
    match share {
        0.02..=1.0 if spent > 1.0 => Some(format!("about {}", span(rest))),
        // Of long work the first pieces tell the size.
        1e-9..0.02 if spent > 10.0 => Some(format!("at this pace {}", span(rest))),
        _ => None,
    }
}

/// Minutes and seconds.
pub(crate) fn span(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{whole} s"),
        60..3600 => format!("{} min {:02} s", whole / 60, whole % 60),
        _ => format!("{} h {:02} min", whole / 3600, whole / 60 % 60),
    }
}
