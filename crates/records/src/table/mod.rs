//! Tables of measured channels, read. Reading never fails, whatever the bytes are: it gives what it understood, and names every
//! row and cell that it could not take.

mod columns;
mod dialect;
mod faults;
mod heading;
mod mapping;
mod notes;
mod number;
mod plan;
mod rows;
mod text;

pub use dialect::Dialect;
pub use mapping::{Column, Mapping, Others, Source};

use crate::{Finding, Place, Recording, Severity, Unit};
use heading::Heading;
use plan::Headings;

/// What the caller says of a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Name of the run, commonly the file's; a comment line `# run: slow` in the file counts more.
    pub name: String,
    /// Speed of the train [m/s]; counts more than a comment line `# speed: 45 km/h`.
    pub speed: Option<f64>,
    /// Which column is which channel.
    pub mapping: Mapping,
    /// How the table is written.
    pub dialect: Dialect,
}

/// What came of reading.
#[derive(Debug, Clone, PartialEq)]
pub struct Read {
    /// The run as it stands in the file, not yet judged; None where nothing in the file is a table with a clock and a channel.
    pub run: Option<Recording>,
    /// Everything that was found.
    pub findings: Vec<Finding>,
}

/// Lines that are looked at for headings, separators and decimal marks.
const SAMPLE: usize = 200;

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
        let shown = table
            .time_decimals
            .map_or(0.0, |decimals| plan.time_unit.to_si(plan.time.factor * 0.1_f64.powi(decimals.min(15) as i32)));
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
    let sample: Vec<&str> = candidates().map(|(_, line)| line).take(SAMPLE).collect();
    let mut say = |severity, code, lines: Option<[usize; 2]>, message: &str, help: &str| {
        let place = Place { run: run.to_owned(), lines, ..Place::default() };
        findings.push(Finding::new(severity, code, place, message, help));
    };
    if sample.is_empty() {
        say(Severity::Error, "R001", None, "the file holds no table", "name a file with headings and rows of numbers");
        return None;
    }
    let written = dialect::seen(&sample, options.dialect);
    let (line, headings, first_row) = head(candidates(), options, written.separator);
    if let Some((first, _)) = candidates().next().filter(|(first, _)| *first < line) {
        let lines = Some([first, line - 1]);
        say(Severity::Note, "R004", lines, "these lines stand above the headings and are not read", "");
    }
    let plan = plan::plan(&Headings { line, headings: &headings }, &options.mapping, run, findings)?;
    let (rows, faults) = rows::read(text, first_row, written, &plan);
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

/// The line of the headings (0 where there is none), the headings, and the first line that may hold data.
fn head<'a>(
    candidates: impl Iterator<Item = (usize, &'a str)>,
    options: &ReadOptions,
    separator: char,
) -> (usize, Vec<Heading>, usize) {
    let cells = |line: &str| -> Vec<String> {
        dialect::fields(line, separator).iter().map(|cell| cell.trim().to_owned()).collect()
    };
    let sample: Vec<(usize, &str)> = candidates.take(SAMPLE).collect();
    let (first_line, first) = sample.first().map_or((1, Vec::new()), |(line, text)| (*line, cells(text)));
    if !options.mapping.headed {
        let numbered = (1..=first.len()).map(|k| Heading::of(&format!("column {k}"))).collect();
        return (0, numbered, first_line);
    }
    let of = |text: &str| -> Vec<Heading> {
        let mut cells = cells(text);
        while cells.len() > 1 && cells.last().is_some_and(String::is_empty) {
            cells.pop();
        }
        cells.iter().map(|cell| Heading::of(cell)).collect()
    };
    let headed = sample.iter().position(|(_, text)| plan::clock(&of(text), &options.mapping).is_some());
    let Some(at) = headed else {
        return (first_line, first.iter().map(|cell| Heading::of(cell)).collect(), first_line + 1);
    };
    let (line, text) = sample[at];
    let mut headings = of(text);
    // Some loggers write the units on a line of their own.
    let below = sample.get(at + 1).map(|(line, text)| (*line, cells(text)));
    if let Some((units_line, units)) = below {
        // A hyphen is a unit, but also a word for nothing.
        let is_unit = |symbol: &String| Unit::named(symbol).is_some();
        let wanted = headings.iter().any(|heading| heading.symbol.is_none()) && units.len() == headings.len();
        let sure = units.iter().any(|symbol| symbol != "-" && is_unit(symbol));
        if wanted && sure && units.iter().all(|symbol| symbol.is_empty() || is_unit(symbol)) {
            for (heading, symbol) in headings.iter_mut().zip(units) {
                if heading.symbol.is_none() && !symbol.is_empty() {
                    heading.symbol = Some(symbol);
                }
            }
            return (line, headings, units_line + 1);
        }
    }
    (line, headings, line + 1)
}
