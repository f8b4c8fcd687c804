//! Tables of measured channels, read. Reading never fails, whatever the bytes are: it gives what it understood, and names every
//! row and cell that it could not take.

mod clock;
mod columns;
mod dialect;
mod faults;
mod head;
mod heading;
mod mapping;
mod notes;
mod number;
mod plan;
mod rows;
mod stamp;
mod text;

pub use dialect::Dialect;
pub use mapping::{Column, Mapping, Others, ReadOptions, Source};

use crate::{Finding, Place, Recording};
use findings::Severity;

/// What came of reading.
#[derive(Debug, Clone, PartialEq)]
pub struct Read {
    /// The run as it stands in the file, not yet judged; None where nothing in the file is a table with a clock and a channel.
    pub run: Option<Recording>,
    /// Everything that was found.
    pub findings: Vec<Finding>,
}

/// Reads the table of one run.
pub fn read(bytes: &[u8], options: &ReadOptions) -> Read {
    let mut findings = Vec::new();
    if columns::is_parquet(bytes) {
        return match columns::texts(bytes) {
            Ok(texts) => understood(&texts.notes, &texts.table, options, findings),
            Err(refusal) => {
                let place = Place { run: options.name.clone(), ..Place::default() };
                findings.push(Finding::new(Severity::Error, "R005", place, refusal.message, refusal.help));
                Read { run: None, findings }
            }
        };
    }
    let text = text::decode(bytes, &options.name, &mut findings);
    understood(&text, &text, options, findings)
}

/// The run of a table, with its comment lines, which commonly stand in the same text.
fn understood(notes: &str, text: &str, options: &ReadOptions, mut findings: Vec<Finding>) -> Read {
    let run = notes::noted(notes, options, &mut findings);
    Read { run: table(text, options, run, &mut findings), findings }
}

/// The run with the clock and the channels of its table.
fn table(text: &str, options: &ReadOptions, run: Recording, findings: &mut Vec<Finding>) -> Option<Recording> {
    let candidates = || text::lines(text).filter(|(_, line)| !text::is_blank(line) && !text::is_comment(line));
    let sample: Vec<&str> = candidates().map(|(_, line)| line).take(dialect::SAMPLE).collect();
    let mut say = |severity, code, lines: Option<[usize; 2]>, message: &str, help: &str| {
        let place = Place { run: run.name.clone(), lines, ..Place::default() };
        findings.push(Finding::new(severity, code, place, message, help));
    };
    if sample.is_empty() {
        say(Severity::Error, "R001", None, "the file holds no table", "name a file with headings and rows of numbers");
        return None;
    }
    let written = dialect::seen(&sample, options.dialect);
    let head = head::head(candidates(), options, written.separator);
    if let Some((first, _)) = candidates().next().filter(|(first, _)| *first < head.line) {
        let lines = Some([first, head.line - 1]);
        say(Severity::Note, "R004", lines, "these lines stand above the headings and are not read", "");
    }
    let body = rows::Body { text, first_row: head.first_row, written };
    let plan = plan::plan(&head, &body, &options.mapping, &run.name, findings)?;
    Some(rows::read(&body, plan, run, findings))
}
