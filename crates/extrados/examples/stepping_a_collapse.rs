//! A collapse that its caller moves on and looks at: `cargo run --release --example stepping_a_collapse`.
#![allow(clippy::print_stdout)] // Programs speak.

use extrados::{Choice, Disk, Project, Stepping};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/bridgemill/case-1.toml".to_owned());
    let mut run = Stepping::new(&Project::read(file, &Disk)?, &Choice::default())?;
    while run.advance(20_000).is_none() {
        let frame = run.frame();
        let fastest = frame.velocities.iter().map(|(velocity, _)| velocity.norm()).fold(0.0, f64::max);
        println!(
            "{:>7} steps, {:>6.1} kN/m, {} contacts, fastest block {:.1e} m/s",
            frame.iterations,
            run.load() / 1e3,
            frame.contacts.len(),
            fastest
        );
    }
    println!("the load is {:.1} kN/m at the end", run.load() / 1e3);
    Ok(())
}
