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
    let notes = notes::notes(notes, options, &mut findings);
    let run = table(text, options, &notes.name, &mut findings).map(|(table, plan)| {
        let mut channels = plan.channels;
        for ((channel, values), decimals) in channels.iter_mut().zip(table.values).zip(table.decimals) {
            (channel.values, channel.decimals) = (values, decimals);
        }
        let shown = table.time_decimals.map_or(0.0, |decimals| plan.clock.step(decimals));
        Recording {
            name: notes.name.clone(),
            speed: notes.speed,
            synthetic: notes.synthetic.clone(),
            notes: notes.lines,
            times: table.times,
            lines: table.lines,
            time_step_shown: shown,
            channels,
        }
    });
    Read { run, findings }
}

fn table(
    text: &str,
    options: &ReadOptions,
    run: &str,
    findings: &mut Vec<Finding>,
) -> Option<(rows::Rows, plan::Plan)> {
    let candidates = || text::lines(text).filter(|(_, line)| !text::is_blank(line) && !text::is_comment(line));
    let sample: Vec<&str> = candidates().map(|(_, line)| line).take(dialect::SAMPLE).collect();
    let mut say = |severity, code, lines: Option<[usize; 2]>, message: &str, help: &str| {
        let place = Place { run: run.to_owned(), lines, ..Place::default() };
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
    let plan = plan::plan(&head, &body, &options.mapping, run, findings)?;
    let (rows, faults) = rows::read(&body, &plan);
    let title = |column: usize| {
        let channel = plan.channels.iter().find(|channel| channel.column == column);
        channel.map_or(String::new(), crate::Channel::title)
    };
    findings.extend(faults.finish(run, title));
    findings.extend(rows.last.iter().cloned().map(|mut finding| {
        finding.place.run = run.to_owned();
        finding
    }));
    Some((rows, plan))
}
