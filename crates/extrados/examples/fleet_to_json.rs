//! Several bridges at once, each as the object that `extrados collapse --json` prints, within a time that the caller sets:
//! `cargo run --release --example fleet_to_json`.
#![allow(clippy::print_stdout, clippy::print_stderr)] // Programs speak.

use extrados::{Choice, CollapseOptions, Disk, Progress, Project, Refusal, Wish, bridge::Method, collapse, written};
use std::time::{Duration, Instant};

/// A bridge that takes longer than this is stopped, and says `cancelled`.
const PATIENCE: Duration = Duration::from_secs(60);

fn answer(file: &str) -> Result<String, Refusal> {
    // The same bridge with another value, read as if its file said so.
    let project = Project::read(file, &Disk)?.with(&["joint.friction_angle=32deg"])?;
    let begun = Instant::now();
    let mut watch = |_: &Progress| if begun.elapsed() > PATIENCE { Wish::Stop } else { Wish::GoOn };
    let options = CollapseOptions { choice: Choice { method: Some(Method::Limit), ..Choice::default() }, resume: None };
    let found = collapse(&project, &options, &mut watch)?;
    let (status, warnings) = (found.status.word(), written::warnings_of(&found));
    let object = written::object(&project, "extrados.collapse/1", status, found.object(), &warnings);
    let carried = found.headline().map_or(0.0, |headline| headline.load);
    eprintln!("{file}: {status}, {:.2} kN/m", carried / 1e3);
    Ok(serde_json::Value::Object(object).to_string())
}

fn main() {
    let files = ["examples/tiny/bridge.toml", "examples/two-span/bridge.toml"];
    let answers = std::thread::scope(|scope| {
        let all: Vec<_> = files.map(|file| scope.spawn(move || answer(file))).into_iter().collect();
        all.into_iter().map(|one| one.join().expect("it does not panic")).collect::<Vec<_>>()
    });
    for answer in answers {
        match answer {
            Ok(object) => println!("{object}"),
            // What is wrong, and what to write instead.
            Err(refusal) => eprintln!("{}: {}\n  help: {}", refusal.code, refusal.message, refusal.help),
        }
    }
}
