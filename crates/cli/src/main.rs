//! `extrados`: asks the engineer's question of `assess`, and shows the answer.

mod args;
mod clock;
mod commands;
mod examples;
mod failure;
mod folder;
mod render;
mod report;
mod screen;
mod status;
mod watcher;

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(commands::run(std::env::args_os().collect()))
}
