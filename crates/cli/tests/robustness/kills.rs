//! Runs that are killed, asked to end, or put beside one another.

#![cfg(unix)]

use crate::stage::{Ending, Stage};
use crate::tally::{End, Tally};
use crate::works::{LONG, WORKS, Whole, Work, asked_for, is_sealed, left_over, prepared};
use crate::{Draws, number};
use serde_json::Value;
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Before a command has read its words it listens to nothing: SIGTERM ends it there as it ends any program, and there is nothing to lose.
const WAKES: Duration = Duration::from_millis(250);

/// How a run is disturbed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sign {
    Kill,
    Terminate,
}

/// Starts a work and disturbs it after a while; none where it ended before.
fn disturbed(stage: &Stage, words: &[&str], sign: Sign, after: Duration) -> (Output, bool) {
    let mut child = stage.command(words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    std::thread::sleep(after);
    let early = child.try_wait().expect("it can be asked").is_some();
    if !early {
        match sign {
            Sign::Kill => child.kill().expect("it is running"),
            Sign::Terminate => {
                let id = child.id().to_string();
                // It may have ended meanwhile.
                let _ = Command::new("kill").args(["-TERM", &id]).stderr(Stdio::null()).status();
            }
        }
    }
    (child.wait_with_output().expect("it ends"), early)
}

/// Disturbs a work again and again in one folder; every so often it is run to its end, and must give what the undisturbed run gave.
fn torment(stage: &Stage, work: &Work, sign: Sign, times: u64, draws: &mut Draws, tally: &mut Tally) {
    let begin = Instant::now();
    let whole = Whole::of(stage, work);
    let span = begin.elapsed();
    let kind = if sign == Sign::Kill { "SIGKILL" } else { "SIGTERM" };
    let folder = stage.folder.join("o");
    let _ = std::fs::remove_dir_all(&folder);
    let mut stood = false;
    for time in 0..times {
        // Half of them near the end, where results are written.
        let share = if draws.below(2) == 0 {
            draws.below(1000) as f64 / 1000.0
        } else {
            0.75 + draws.below(300) as f64 / 1000.0
        };
        let (output, early) = disturbed(stage, &work.line("o", time > 0), sign, span.mul_f64(share));
        let asleep = !early && span.mul_f64(share) < WAKES && output.status.signal() == Some(15);
        let ended = match (early, sign) {
            (true, _) => End::of(&output),
            (false, Sign::Kill) => End::Interrupted,
            (false, Sign::Terminate) if asleep => End::Interrupted,
            (false, Sign::Terminate) => End::of(&output),
        };
        let told = sign == Sign::Kill || asleep || serde_json::from_slice::<Value>(&output.stdout).is_ok();
        let fault = |end: End, what: String| (end, format!("{what} ({kind} {time}, after {share:.3} of {span:?})"));
        let found = match is_sealed(&folder) {
            _ if ended == End::Broken => Err(fault(End::Broken, String::from_utf8_lossy(&output.stderr).into_owned())),
            _ if !told => Err(fault(End::Broken, "no object on stdout".to_owned())),
            Err(what) => Err(fault(End::Lost, what)),
            Ok(false) if stood => Err(fault(End::Lost, "the answer that stood is gone".to_owned())),
            Ok(sealed) => {
                stood = sealed;
                Ok(ended)
            }
        };
        match found {
            Ok(end) => tally.count(kind, work.name, end),
            Err((end, what)) => tally.fault(kind, work.name, end, what),
        }
        if time % 3 == 2 || time + 1 == times {
            let ending: Ending = stage.run(&work.line("o", true));
            let left = left_over(&folder);
            match whole.differs(&ending, &folder) {
                Some(what) => tally.fault("the run after it", work.name, End::Lost, format!("{what} ({kind} {time})")),
                None if !left.is_empty() => {
                    tally.fault("the run after it", work.name, End::Lost, format!("{left:?} stay ({kind} {time})"));
                }
                None => tally.count("the run after it", work.name, End::Answered),
            }
            stood = work.words[0] != "check";
            // Now and then from an empty folder.
            if draws.below(2) == 0 {
                let _ = std::fs::remove_dir_all(&folder);
                stood = false;
            }
        }
    }
}

/// Starts a work several times at once in one folder: one at least comes to its end, the others are refused.
fn crowded(stage: &Stage, work: &Work, tally: &mut Tally) {
    const AT_ONCE: usize = 4;
    let whole = Whole::of(stage, work);
    let folder = stage.folder.join("crowd");
    let words = work.line("crowd", false);
    let start = |_| stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let children: Vec<_> = (0..AT_ONCE).map(start).collect();
    let mut finished = 0;
    for child in children {
        let ending: Ending = child.wait_with_output().expect("it ends").into();
        match ending.code {
            Some(2) if ending.stdout.contains("F148") => tally.count("at once", work.name, End::Refused),
            _ => {
                finished += 1;
                match whole.differs(&ending, &folder).filter(|_| ending.code != whole.code) {
                    Some(what) => tally.fault("at once", work.name, End::Lost, what),
                    None => tally.count("at once", work.name, End::Answered),
                }
            }
        }
    }
    let sound = if work.words[0] == "check" { Ok(true) } else { is_sealed(&folder) };
    if finished == 0 || sound != Ok(true) || !left_over(&folder).is_empty() {
        let what = format!("{finished} finished, {sound:?}, {:?}", left_over(&folder));
        tally.fault("at once", work.name, End::Lost, what);
    }
}

fn run(name: &str, works: &[Work], times: u64, seed: u64) -> Tally {
    let stage = prepared(name);
    let (mut tally, mut draws) = (Tally::default(), Draws(seed));
    for work in works {
        torment(&stage, work, Sign::Kill, times, &mut draws, &mut tally);
        torment(&stage, work, Sign::Terminate, times.div_ceil(2), &mut draws, &mut tally);
        crowded(&stage, work, &mut tally);
    }
    tally
}

#[test]
fn robustness_a_few_runs_are_killed() {
    let few = [WORKS[1], WORKS[3], WORKS[7]];
    run("robustness-few-kills", &few, 2, 11).settle("Runs that were disturbed");
}

/// Every command that writes results.
#[test]
#[ignore = "minutes"]
fn robustness_runs_of_every_command_are_killed() {
    let times = number("EXTRADOS_KILLS", 24);
    let works = asked_for(WORKS.into_iter().chain(LONG));
    run("robustness-kills", &works, times, number("EXTRADOS_SEED", 1)).settle("Runs that were disturbed");
}
