//! The collapse load of a bridge file and a drawing of its mechanism: `cargo run --release --example collapse_with_picture`.
#![allow(clippy::print_stdout)] // Programs speak.

use extrados::{CollapseOptions, Disk, Project, Unwatched, collapse, figures};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/tiny/bridge.toml".to_owned());
    let project = Project::read(file, &Disk)?;
    let found = collapse(&project, &CollapseOptions::default(), &mut Unwatched)?;
    let carried = found.headline().map_or(0.0, |headline| headline.load);
    println!("{}: {} at {:.2} kN/m", project.bridge()?.name, found.status.word(), carried / 1e3);
    if let Some(svg) = figures::mechanism(&found.picture) {
        std::fs::create_dir_all("out")?;
        std::fs::write("out/mechanism.svg", svg)?;
        println!("drawn in out/mechanism.svg");
    }
    Ok(())
}
