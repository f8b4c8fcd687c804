//! How cases ended, by kind and command.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::process::Output;

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum End {
    /// With an answer (exit codes 0 and 1).
    Answered,
    /// The input was refused (2).
    Refused,
    /// It could not finish (3).
    Unfinished,
    /// It was interrupted (130, or killed on purpose).
    Interrupted,
    /// It was asked to end after the time that a case is given, and ended.
    Slow,
    /// It panicked, was ended by a signal of its own, or did not end when it was asked to.
    Broken,
    /// A result that stood was lost, or the next run gave another one.
    Lost,
}

const ALL: [(End, &str); 7] = [
    (End::Answered, "answered"),
    (End::Refused, "refused"),
    (End::Unfinished, "not finished"),
    (End::Interrupted, "interrupted"),
    (End::Slow, "stopped after its time"),
    (End::Broken, "panics"),
    (End::Lost, "results lost"),
];

impl End {
    /// By the exit code of a command that nobody interrupted.
    pub(crate) fn of(output: &Output) -> End {
        match output.status.code() {
            Some(0 | 1) => End::Answered,
            Some(2) => End::Refused,
            Some(3) => End::Unfinished,
            Some(130) => End::Interrupted,
            _ => End::Broken,
        }
    }
}

/// Counts, and a note of each case that should not be.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    rows: BTreeMap<[String; 2], BTreeMap<End, usize>>,
    faults: Vec<String>,
}

impl Tally {
    pub(crate) fn count(&mut self, kind: &str, command: &str, end: End) {
        *self.rows.entry([kind.to_owned(), command.to_owned()]).or_default().entry(end).or_insert(0) += 1;
    }

    /// Counts a case that should not be, and keeps what is known of it.
    pub(crate) fn fault(&mut self, kind: &str, command: &str, end: End, what: String) {
        self.count(kind, command, end);
        self.faults.push(format!("{kind}, {command}: {what}"));
    }

    pub(crate) fn merge(&mut self, other: Tally) {
        for (key, ends) in other.rows {
            let row = self.rows.entry(key).or_default();
            ends.into_iter().for_each(|(end, count)| *row.entry(end).or_insert(0) += count);
        }
        self.faults.extend(other.faults);
    }

    pub(crate) fn cases(&self) -> usize {
        self.rows.values().flat_map(BTreeMap::values).sum()
    }

    /// The table for docs/verification/robustness.md; columns in which nothing was counted are left out, but for the last two.
    pub(crate) fn table(&self) -> String {
        let of = |row: &BTreeMap<End, usize>, end: &End| row.get(end).copied().unwrap_or(0);
        let shown: Vec<&(End, &str)> = ALL
            .iter()
            .filter(|(end, _)| *end >= End::Broken || self.rows.values().any(|row| of(row, end) > 0))
            .collect();
        let heads: Vec<&str> = shown.iter().map(|(_, head)| *head).collect();
        let mut text = format!(
            "| what | command | cases | {} |\n|---|---|{}\n",
            heads.join(" | "),
            "--:|".repeat(1 + heads.len())
        );
        let mut line = |name: &[String; 2], row: &BTreeMap<End, usize>| {
            let cells: Vec<String> = shown.iter().map(|(end, _)| of(row, end).to_string()).collect();
            let cases: usize = row.values().sum();
            let _ = writeln!(text, "| {} | {} | {cases} | {} |", name[0], name[1], cells.join(" | "));
        };
        let mut all: BTreeMap<End, usize> = BTreeMap::new();
        for (name, row) in &self.rows {
            line(name, row);
            row.iter().for_each(|(end, count)| *all.entry(*end).or_insert(0) += count);
        }
        line(&["all".to_owned(), String::new()], &all);
        text
    }

    /// Shows the table, and fails where anything broke or was lost.
    pub(crate) fn settle(&self, title: &str) {
        println!("\n### {title}\n\n{}", self.table());
        assert!(self.cases() > 0, "{title}: nothing was tried");
        assert!(self.faults.is_empty(), "{title}:\n{}", self.faults.join("\n"));
    }
}

#[test]
fn a_panic_is_counted_and_told() {
    let mut tally = Tally::default();
    tally.count("a bridge file", "check", End::Refused);
    tally.fault("a bridge file", "check", End::Broken, "seed 7".to_owned());
    assert_eq!(tally.cases(), 2);
    assert!(tally.table().contains("| a bridge file | check | 2 | 1 | 1 | 0 |"), "{}", tally.table());
    assert!(std::panic::catch_unwind(|| tally.settle("try")).is_err());
}
