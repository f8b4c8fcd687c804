//! A bridge judged against the limits of its file, with its report as a page: `cargo run --release --example assessment_to_html`.
#![allow(clippy::print_stdout)] // Programs speak.

use extrados::{AssessOptions, Disk, Means, Project, StageName, Unwatched, assess};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/bridgemill/assess.toml".to_owned());
    let project = Project::read(file, &Disk)?;
    let command = "assessment_to_html".to_owned();
    let options = AssessOptions { skip: vec![StageName::Vehicles], command, day: "2026-01-01".to_owned() };
    let Some(done) = assess(&project, &options, &Means::default(), &mut Unwatched)? else { return Ok(()) };
    let verdict = &done.assessment.verdict;
    println!("{}: {}", done.assessment.bridge, verdict.status);
    for missing in &verdict.strength.missing {
        println!("missing: {missing}");
    }
    std::fs::create_dir_all("out")?;
    std::fs::write("out/report.html", done.html())?;
    Ok(())
}
