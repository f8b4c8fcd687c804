//! A train that its caller moves over a bridge, position by position: `cargo run --release --example stepping_a_passage`.
#![allow(clippy::print_stdout)] // Programs speak.

use extrados::{Disk, Passing, Project, RespondOptions, Unwatched};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/railway-arch/passage.toml".to_owned());
    let mut passing = Passing::new(&Project::read(file, &Disk)?, &RespondOptions::default(), &mut Unwatched)?;
    let crown = passing.setup().sensors.iter().position(|sensor| sensor.name.contains("crown")).unwrap_or(0);
    while passing.advance(1, &mut Unwatched)?.is_none() {
        let (Some((time, place)), Some(crown)) = (passing.place(), passing.values().nth(crown)) else { continue };
        println!("{time:5.2} s, first axle at {place:6.2} m, crown {:+.4} mm", 1e3 * crown);
    }
    let moment = passing.moment()?;
    let open = moment.rows.iter().filter(|row| row.pairs.iter().any(|pair| pair.opening > 0.0)).count();
    println!("{} at the end: {open} joints are open somewhere", moment.name);
    Ok(())
}
