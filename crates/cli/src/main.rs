//! `extrados`: asks the question of the crate `extrados`, and shows the answer.

mod args;
mod checkpoint;
mod commands;
mod desk;
mod failure;
mod folder;
mod host;
mod log;
mod page;
mod program;
mod quantities;
mod render;
mod report;
mod results;
mod screen;
mod shards;
mod shelf;
mod signs;
mod status;
mod summary;
mod watcher;
#[cfg(feature = "workbench")]
mod workbench;
mod workbook;

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(commands::run(std::env::args_os().collect()))
}
