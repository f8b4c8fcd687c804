//! What a shell and `man` know of the command, made from what it says of itself.

use crate::args::Arguments;
use crate::failure;
use crate::folder;
use crate::report::Report;
use crate::status::Status;
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;
use extrados::Refusal;
use std::fs;
use std::path::Path;

/// The script that completes commands and flags, alone on stdout.
pub(super) fn completions(shell: Shell) -> Report {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "extrados", &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    Report { is_text: true, ..Report::new(Status::Completed).saying(script) }
}

/// Writes `extrados.1` and a page for every command.
pub(super) fn pages(dir: &Path) -> Result<Report, Refusal> {
    let mut command = Arguments::command().disable_help_subcommand(true);
    command.build();
    let all = command.get_subcommands().map(|one| (format!("extrados-{}", one.get_name()), one.clone()));
    let all: Vec<(String, Command)> = [("extrados".to_owned(), command.clone())].into_iter().chain(all).collect();
    fs::create_dir_all(dir).map_err(|error| failure::unwritable(dir, &error))?;
    for (name, command) in &all {
        let mut page = Vec::new();
        let named = Man::new(command.clone().version(extrados::VERSION))
            .title(name)
            .source(format!("extrados {}", extrados::VERSION));
        named.render(&mut page).map_err(|error| failure::unwritable(dir, &error))?;
        let path = dir.join(format!("{name}.1"));
        folder::write_whole(&path, &page).map_err(|error| failure::unwritable(&path, &error))?;
    }
    let names: Vec<String> = all.into_iter().map(|(name, _)| format!("{name}.1")).collect();
    let said = format!("{}: {} manual pages\n", dir.display(), names.len());
    Ok(Report::new(Status::Completed).with("folder", dir.display().to_string()).with("files", names).saying(said))
}
