//! One file per command. Each gives a [`Report`] or says why it could not; it is shown once, by `answer.rs`.

mod answer;
mod assess;
mod bench;
mod calibrate;
mod cases;
mod check;
mod collapse;
mod compare;
mod convert;
mod explain;
mod materials;
mod merge;
mod model;
mod new;
mod respond;
mod schema;
mod shell;
mod source;
mod update;
mod validate;
mod vary;
mod vehicles;
mod verify;
mod workbench;

use crate::args::{Arguments, Command};
use crate::desk::Desk;
use crate::failure;
use crate::host::{self, Ended};
use crate::render::{self, Paint};
use crate::report::Report;
use crate::screen::Screen;
use crate::signs;
use crate::status::Status;
use answer::{failed, speak};
use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches};
use extrados::Refusal;
pub(crate) use new::examples_of_new;
use std::ffi::OsString;
use std::path::Path;
use std::time::Instant;

/// Runs the command line and gives the exit code.
pub(crate) fn run(words: Vec<OsString>) -> u8 {
    let clock = Instant::now();
    let parsed = Arguments::command().try_get_matches_from(&words);
    let parsed = parsed.and_then(|said| Ok((Arguments::from_arg_matches(&said)?, said)));
    let (Arguments { command, speech }, said) = match parsed {
        Ok(parsed) => parsed,
        Err(error) => return misspoken(&words, &error, clock),
    };
    let schema = format!("extrados.{}/1", said.subcommand_name().unwrap_or("command"));
    let words: Vec<String> = words.iter().map(|word| word.to_string_lossy().into_owned()).collect();
    let mut desk = Desk { screen: Screen::new(speech.json, speech.quiet), clock, schema, words };
    // Speeds are compared core by core.
    let unasked = u16::from(matches!(command, Command::Bench(_)));
    let threads = usize::from(speech.threads.unwrap_or(unasked));
    // Only fails when a pool is there already; then its size is the one that `threads` reports.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(host::STACK).build_global();
    signs::listen();
    let lines = host::lines(speech.quiet, speech.progress_every);
    let schema = desk.schema.clone();
    let work = move || {
        let answer = obey(&mut desk, &command);
        (desk, answer)
    };
    let (mut desk, answer) = match host::wait(work, lines) {
        Ended::Whole(done) => done,
        Ended::CutOff => {
            let desk = Desk { screen: Screen::new(speech.json, speech.quiet), clock, schema, words: Vec::new() };
            (desk, Ok(host::cut_off()))
        }
        Ended::Broken => return BROKEN,
    };
    let code = match answer {
        Ok(answer) => speak(&mut desk, &answer),
        Err(failure) => {
            desk.screen.remark(&render::failure(&failure, &Paint::for_stderr()));
            speak(&mut desk, &failed(&failure))
        }
    };
    match desk.screen.failed.take() {
        Some(error) => {
            let failure = failure::not_written(Path::new("the standard output"), &error);
            desk.screen.remark(&render::failure(&failure, &Paint::for_stderr()));
            code.max(failure::status(&failure).exit_code())
        }
        None => code,
    }
}

/// The exit code of a program that broke, as Rust's own.
const BROKEN: u8 = 101;

fn obey(desk: &mut Desk, command: &Command) -> Result<Report, Refusal> {
    match command {
        Command::New(arguments) => new::run(desk, arguments),
        Command::Check(arguments) => check::run(desk, arguments),
        Command::Collapse(arguments) => collapse::run(desk, arguments),
        Command::Cases(arguments) => cases::run(desk, arguments),
        Command::Compare(arguments) => compare::run(desk, arguments),
        Command::Convert(arguments) => convert::run(desk, arguments),
        Command::Vary(arguments) => vary::run(desk, arguments),
        Command::Respond(arguments) => respond::run(desk, arguments),
        Command::Assess(arguments) => assess::run(desk, arguments),
        Command::Update(arguments) => update::run(desk, arguments),
        Command::CalibrateFill(arguments) => calibrate::run(desk, arguments),
        Command::Merge { dirs, out } => merge::run(desk, dirs, out),
        Command::Explain { words } => explain::run(words),
        Command::Vehicles { name } => vehicles::run(name.as_deref()),
        Command::Materials { name } => materials::run(name.as_deref()),
        Command::Schema(arguments) => Ok(schema::run(arguments)),
        Command::Verify(arguments) => verify::run(desk, arguments),
        Command::Validate(arguments) => validate::run(desk, arguments),
        Command::Workbench(arguments) => workbench::run(desk, arguments),
        Command::Bench(arguments) => bench::run(desk, arguments),
        Command::Completions { shell } => Ok(shell::completions(*shell)),
        Command::Man { dir } => shell::pages(dir),
    }
}

/// A command line that cannot be understood, or one that asks for help.
fn misspoken(words: &[OsString], error: &clap::Error, clock: Instant) -> u8 {
    let json = words.iter().any(|word| word == "--json");
    let mut screen = Screen::new(json, false);
    let text = error.render();
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        screen.result(&text.to_string());
        return Status::Completed.exit_code();
    }
    let coloured = console::colors_enabled_stderr() && console::user_attended_stderr();
    screen.remark(&if coloured { text.ansi().to_string() } else { text.to_string() });
    // Up to the first blank line: which arguments are missing and which values are known stand below the first.
    let plain = text.to_string();
    let lines: Vec<&str> = plain.lines().take_while(|line| !line.trim().is_empty()).map(str::trim).collect();
    let message = lines.join(" ").trim_start_matches("error: ").to_owned();
    let failure = Refusal::new("F107", message, "extrados --help lists commands and options");
    let mut desk = Desk { screen, clock, schema: "extrados.command/1".to_owned(), words: Vec::new() };
    speak(&mut desk, &failed(&failure))
}
