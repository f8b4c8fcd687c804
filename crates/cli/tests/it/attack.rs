//! A failing bridge changed in one thing, three hundred times: nothing is adequate without the change in the line of the verdict.

#![allow(clippy::print_stdout)]

mod changes;

use crate::stage::Stage;
use changes::{Change, change, changes, failing};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What became of a change: its status, and whether a verdict of adequacy says nothing of it.
fn tried(k: usize, change: &Change) -> (String, bool, String) {
    let stage = Stage::new(&format!("attack-{k}"));
    stage.write("bridge.toml", &change.text);
    if let Some((file, text)) = &change.beside {
        stage.write(file, text);
    }
    let mut words = vec!["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"];
    change.skip.iter().for_each(|stage| words.extend(["--skip", stage]));
    let (answer, _) = stage.object(&words);
    let status = answer["status"].as_str().unwrap_or("none").to_owned();
    let head = answer["head"].as_str().unwrap_or_default().to_owned();
    let silent = status == "adequate" && !change.named.iter().any(|word| head.contains(word.as_str()));
    (status, silent, head)
}

/// Counts by kind and status, and what is silent.
fn attack(list: &[Change]) -> (Vec<(String, usize)>, Vec<String>) {
    let next = AtomicUsize::new(0);
    type Found = Vec<(usize, (String, bool, String))>;
    let found: Mutex<Found> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    let Some(change) = list.get(k) else { break };
                    let one = tried(k, change);
                    found.lock().expect("a list").push((k, one));
                }
            });
        }
    });
    let mut counts: Vec<(String, usize)> = Vec::new();
    let mut silent = Vec::new();
    let mut found = found.into_inner().expect("a list");
    found.sort_by_key(|(k, _)| *k);
    for (k, (status, quiet, head)) in found {
        let key = format!("{}: {status}", list[k].kind);
        match counts.iter_mut().find(|(own, _)| *own == key) {
            Some((_, count)) => *count += 1,
            None => counts.push((key, 1)),
        }
        if quiet {
            silent.push(format!("{}, {}: {head}", list[k].kind, list[k].name));
        }
    }
    (counts, silent)
}

/// A change in twenty-four, spread over all kinds.
#[test]
fn a_failing_bridge_is_not_made_adequate_in_silence() {
    let list: Vec<Change> = changes().into_iter().step_by(24).collect();
    let (_, silent) = attack(&list);
    assert!(silent.is_empty(), "{silent:#?}");
}

/// All of them; `docs/verification/attack.md` has the counts.
#[test]
#[ignore = "minutes"]
fn three_hundred_changes_make_nothing_adequate_in_silence() {
    let list = changes();
    assert!(list.len() >= 300, "{}", list.len());
    let unchanged = change("unchanged", "", failing(), &[]);
    assert_eq!(tried(list.len(), &unchanged).0, "inadequate");
    let (counts, silent) = attack(&list);
    counts.iter().for_each(|(key, count)| println!("{count:>5}  {key}"));
    println!("{:>5}  changes", list.len());
    assert!(silent.is_empty(), "{silent:#?}");
}
