//! Waits for the run in a thread of its own: ends the command soon after somebody asked for it, whatever the run is at, and tells
//! how far it is where no bar can be drawn.

use crate::report::Report;
use crate::signs::{self, Now, left, span};
use crate::status::Status;
use std::io::{IsTerminal, Write};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// How often the host looks up.
const TICK: Duration = Duration::from_millis(20);
/// What a run is given to come to an end by itself, with an answer of its own.
const GRACE: Duration = Duration::from_millis(700);
/// Stack of the run: as much as a main thread has, and more for files that nest deeply.
pub(crate) const STACK: usize = 32 << 20;

/// How a run ended.
pub(crate) enum Ended<T> {
    /// By itself.
    Whole(T),
    /// It was asked to stop and did not in time.
    CutOff,
    /// It broke; the reason is on stderr.
    Broken,
}

/// Runs `work` and waits for it. Every `lines` something is said of its progress.
pub(crate) fn wait<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static, lines: Option<Duration>) -> Ended<T> {
    let (sender, receiver) = mpsc::channel();
    let run = move || {
        // The host only goes first when the command is over.
        let _ = sender.send(work());
    };
    let Ok(worker) = thread::Builder::new().name("run".to_owned()).stack_size(STACK).spawn(run) else {
        return Ended::Broken;
    };
    let (clock, mut said, mut asked) = (Instant::now(), Instant::now(), None);
    loop {
        match receiver.recv_timeout(TICK) {
            Ok(answer) => return Ended::Whole(answer),
            Err(RecvTimeoutError::Disconnected) => {
                drop(worker.join());
                return Ended::Broken;
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        if signs::asked_to_stop() {
            let since = *asked.get_or_insert_with(Instant::now);
            if since.elapsed() > GRACE && !signs::is_busy() {
                return Ended::CutOff;
            }
        } else if lines.is_some_and(|every| said.elapsed() >= every) {
            said = Instant::now();
            let line = line(clock.elapsed().as_secs_f64(), &signs::now());
            let _ = writeln!(std::io::stderr().lock(), "{}", findings::visible::one_line(&line));
        }
    }
}

/// How often to say something: never where a bar is drawn, or nothing is wanted.
pub(crate) fn lines(quiet: bool, every: f64) -> Option<Duration> {
    let wanted = !quiet && every > 0.0 && !std::io::stderr().is_terminal();
    wanted.then(|| Duration::from_secs_f64(every))
}

/// A line of progress.
fn line(seconds: f64, now: &Now) -> String {
    let mut line = format!("{} so far", span(seconds));
    for words in [&now.task, &now.words].into_iter().filter(|words| !words.is_empty()) {
        line += &format!(", {words}");
    }
    let spent = now.begun.map_or(0.0, |begun| begun.elapsed().as_secs_f64());
    if let Some(share) = now.fraction.filter(|share| *share > 0.0 && *share <= 1.0) {
        line += &format!(": {:.*} %", usize::from(share < 0.01), 100.0 * share);
        if let Some(left) = left(spent, share) {
            line += &format!(", {left} left");
        }
    }
    line
}

/// The answer of a run that was cut off, with what is kept of it.
pub(crate) fn cut_off() -> Report {
    let report = Report::new(Status::Cancelled);
    match signs::now().kept {
        Some(kept) => report.with(kept.key, kept.place).saying(format!("interrupted; {}\n", kept.words)),
        None => report.saying("interrupted; nothing was written\n"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_tells_time_task_share_and_what_is_left() {
        let begun = Instant::now().checked_sub(Duration::from_secs(30));
        let now = Now { task: "vehicles".into(), words: "ra1".into(), fraction: Some(0.25), begun, kept: None };
        assert_eq!(line(95.0, &now), "1 min 35 s so far, vehicles, ra1: 25 %, about 1 min 30 s left");
        let silent = Now { task: String::new(), words: String::new(), fraction: None, begun: None, kept: None };
        assert_eq!(line(30.2, &silent), "30 s so far");
        assert_eq!(span(7320.0), "2 h 02 min");
        let slow = Now { fraction: Some(0.004), begun, ..silent };
        assert_eq!(line(30.2, &slow), "30 s so far: 0.4 %, at this pace 2 h 04 min left");
        assert_eq!((left(0.5, 0.5), left(5.0, 0.001), left(5.0, 0.0)), (None, None, None), "a guess is none");
    }
}
