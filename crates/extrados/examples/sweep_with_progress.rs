//! A load at every position of a bridge, with its progress: `cargo run --release --example sweep_with_progress`.
#![allow(clippy::print_stdout, clippy::print_stderr)] // Programs speak.

use extrados::{Disk, Progress, Project, SweepOptions, Swept, Wish, sweep};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/two-span/bridge.toml".to_owned());
    let project = Project::read(file, &Disk)?;
    let mut bar = |progress: &Progress| {
        eprint!("\r{:3.0} % {:<40}", 100.0 * progress.fraction.unwrap_or(0.0), progress.stage);
        Wish::GoOn
    };
    let found = sweep(&project, &SweepOptions::default(), &mut bar)?;
    eprintln!();
    match found {
        Swept::Loads(found) => {
            let all = found.points.iter().filter_map(|point| Some((point.load_factor?, point.position)));
            let least = all.min_by(|a, b| a.0.total_cmp(&b.0));
            println!("least load factor and its position [m]: {least:.3?}");
        }
        Swept::Vehicles(found) => {
            let factors = found.vehicles.iter().filter_map(|vehicle| vehicle.factor());
            println!("least adequacy factor: {:.3}", factors.fold(f64::INFINITY, f64::min));
        }
    }
    Ok(())
}
