//! `extrados`: asks the engineer's question of `assess`, and shows the answer.

mod args;
mod cache;
mod checkpoint;
mod clock;
mod commands;
mod examples;
mod failure;
mod folder;
mod host;
mod quantities;
mod render;
mod report;
mod results;
mod screen;
mod signs;
mod status;
mod summary;
mod watcher;

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(commands::run(std::env::args_os().collect()))
}
