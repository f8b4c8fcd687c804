//! Moduli of a bridge from the records of a train's passage: `cargo run --release --example update_from_records`.
#![allow(clippy::print_stdout)] // Programs speak.

use extrados::bridge::update::Search;
use extrados::{Disk, Means, Project, Unwatched, UpdateOptions, update};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/railway-arch/update.toml".to_owned());
    let project = Project::read(file, &Disk)?;
    let options = UpdateOptions { search: Some(Search::Gradient), ..UpdateOptions::default() };
    let found = update(&project, &options, &Means::default(), &mut Unwatched)?;
    println!("{} after {} evaluations", found.status.word(), found.evaluations);
    for parameter in found.found().into_iter().flat_map(|answer| &answer.parameters) {
        println!("{}: {:.3e}", parameter.name, parameter.value);
    }
    Ok(())
}
