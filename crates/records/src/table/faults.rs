//! Faults of cells and rows, those of neighbouring lines gathered into one finding.

use crate::{Channel, Finding, Place, Recording};
use findings::Severity;

/// No fault of one column gets more findings than this; further ones are gathered into one more.
const MOST: usize = 50;

/// A kind of fault.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kind {
    pub code: &'static str,
    /// What one such cell or row is: "cell with text in place of a number".
    pub what: &'static str,
    /// What becomes of it.
    pub then: &'static str,
    pub help: &'static str,
}

#[derive(Debug, Clone)]
struct Stretch {
    kind: Kind,
    column: usize,
    rows: [usize; 2],
    lines: [usize; 2],
    time: Option<f64>,
    sample: String,
    count: usize,
}

/// Collects faults, in the order of the rows.
#[derive(Debug, Default)]
pub(super) struct Faults {
    open: Vec<Stretch>,
    closed: Vec<Stretch>,
}

impl Faults {
    /// A fault in a row of the table, counted in rows of data, on a line of the file; column 0 for the row as a whole.
    pub(super) fn add(&mut self, kind: Kind, column: usize, [row, line]: [usize; 2], time: Option<f64>, sample: &str) {
        let same = |open: &Stretch| open.kind.code == kind.code && open.column == column;
        if let Some(at) = self.open.iter().position(same) {
            let open = &mut self.open[at];
            if open.rows[1] + 1 >= row {
                open.rows[1] = row;
                open.lines[1] = line;
                open.count += 1;
                return;
            }
            let stretch = self.open.swap_remove(at);
            self.close(stretch);
        }
        let sample = sample.chars().take(24).collect();
        let stretch = Stretch { kind, column, rows: [row; 2], lines: [line; 2], time, sample, count: 1 };
        self.open.push(stretch);
    }

    fn close(&mut self, stretch: Stretch) {
        let alike = |other: &&mut Stretch| other.kind.code == stretch.kind.code && other.column == stretch.column;
        let count = self.closed.iter_mut().filter(alike).count();
        if count < MOST {
            self.closed.push(stretch);
        } else if let Some(last) = self.closed.iter_mut().rfind(alike) {
            last.lines[1] = stretch.lines[1];
            last.count += stretch.count;
        }
    }

    /// All of them as findings, by line.
    pub(super) fn finish(mut self, run: &Recording) -> impl Iterator<Item = Finding> {
        for stretch in std::mem::take(&mut self.open) {
            self.close(stretch);
        }
        self.closed.sort_by_key(|stretch| (stretch.lines[0], stretch.column, stretch.kind.code));
        let one = |stretch: Stretch| {
            let Stretch { kind, column, lines, time, sample, count, .. } = stretch;
            let shown = if sample.is_empty() { String::new() } else { format!(" (`{sample}`)") };
            let message = match count {
                1 => format!("{}{shown}: {}", kind.what, kind.then),
                _ => format!("{count} times {}, first{shown}: {}", kind.what, kind.then),
            };
            let channel = run.channels.iter().find(|channel| channel.column == column);
            let place = Place {
                run: run.name.clone(),
                lines: Some(lines),
                column: (column > 0).then_some(column),
                channel: channel.map_or(String::new(), Channel::title),
                time,
            };
            Finding::new(Severity::Warning, kind.code, place, message, kind.help)
        };
        self.closed.into_iter().map(one)
    }
}
