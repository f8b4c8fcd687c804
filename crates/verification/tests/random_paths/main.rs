//! Paths of random bridges: each comes to an end that has a name, none to a panic or an endless loop, and every state in balance holds
//! when it is looked at from outside the solver.
//!
//! `cargo test --release -p verification --test random_paths` draws a few, `-- --ignored --nocapture` those that the variable
//! `EXTRADOS_RANDOM_PATHS` names (0..2000 without it) and tells how they ended.

mod drawn;
mod outside;
#[path = "../random/mod.rs"]
mod random;

use bridge::{Bridge, ContactLength as PointLength, Severity};
use mechanics::contact::ContactLength;
use mechanics::path::{Cause, Outcome, Program, Settings, Status, collapse};
use mechanics::watch::CancelToken;
use outside::Wrong;
use std::collections::BTreeMap;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use structure::discretise::discretise;

/// What is left over in blocks that are said to be in balance, what strength may be passed by, as shares of all forces.
const BALANCED: f64 = 1e-7;
const WITHIN: f64 = 1e-9;
/// What the sum over strips of a joint may differ from its integral.
const SUMMED: f64 = 1e-4;

/// States of a path whose pressures are summed.
const PRESSURES: usize = 12;

/// Looks after which a path is given up: most take some hundred, walls and rings that slide thousands.
const PATIENCE: u64 = 20_000;

/// How a bridge ended.
struct Ended {
    word: String,
    wrong: Wrong,
    looks: u64,
}

fn ended(text: &str) -> Result<Ended, String> {
    let read = bridge::read(text.as_bytes());
    let Some(bridge) = read.bridge else {
        let errors = read.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        let word = format!("refused {}", errors.map(|d| d.code).collect::<Vec<_>>().join(" "));
        return Ok(Ended { word, wrong: Wrong::default(), looks: 0 });
    };
    follow(&bridge, text.ends_with("# contact points\n"))
}

fn follow(bridge: &Bridge, points: bool) -> Result<Ended, String> {
    let mut d = match discretise(bridge) {
        Ok(d) => d,
        Err(error) => {
            let word = format!("not set up: {}", error.to_string().replace(|c: char| c.is_ascii_digit(), ""));
            return Ok(Ended { word, wrong: Wrong::default(), looks: 0 });
        }
    };
    d.loading.movements.clear();
    let contact = match (points, bridge.plan.contact_length) {
        (false, _) => ContactLength::Distributed,
        (true, PointLength::Fixed) => ContactLength::Fixed,
        (true, PointLength::Updated) => ContactLength::Updated,
    };
    let weight = d.model.free_weight() / d.reference_load;
    let program = Program { increment: 0.01 * weight, limit: 20.0 * weight, watched: d.watched };
    let mut token = CancelToken::limited_to(PATIENCE);
    let settings = Settings::new(contact);
    let found = collapse(&d.model, &d.loading, (&settings, &program), None, &mut token).map_err(|e| e.to_string())?;
    let distributed = contact == ContactLength::Distributed;
    let every = found.frames.len().div_ceil(PRESSURES).max(1);
    let look = |(k, frame)| {
        let pressures = k % every == 0 || Some(k) == found.peak;
        outside::look((&d.model, &d.loading), &found.interfaces, frame, (distributed, pressures))
    };
    let wrong = found.frames.iter().enumerate().map(look).fold(Wrong::default(), Wrong::or);
    if !(wrong.unbalanced <= BALANCED && wrong.beyond_strength <= WITHIN && wrong.pressure <= SUMMED) {
        return Err(format!("{wrong:?}"));
    }
    consistent(&found)?;
    Ok(Ended { word: word(&found).to_owned(), wrong, looks: token.iterations() })
}

/// What an outcome says of itself.
fn consistent(found: &Outcome) -> Result<(), String> {
    let most = found.path.iter().map(|p| p.factor).fold(f64::NEG_INFINITY, f64::max);
    let ends = matches!(found.status, Status::LimitPoint | Status::Bifurcation);
    if ends != found.collapse_factor.is_some() || found.collapse_factor.is_some_and(|factor| factor != most) {
        return Err(format!("{:?} with {:?}, and {most} was carried", found.status, found.collapse_factor));
    }
    if found.path.len() != found.frames.len() {
        return Err("a state has no picture".into());
    }
    Ok(())
}

fn word(found: &Outcome) -> &'static str {
    match (found.status, found.cause) {
        (Status::LimitPoint, Some(Cause::Sliding)) => "limit point, sliding",
        (Status::LimitPoint, Some(Cause::Crushing)) => "limit point, crushing",
        (Status::LimitPoint, _) => "limit point, hinging",
        (Status::Bifurcation, _) => "bifurcation",
        (Status::StableToLastLoad, _) => "every load up to twenty times the weight",
        (Status::UnstableUnderSelfWeight, _) => "falls under its own weight",
        (Status::NotConverged, _) => "not converged",
        (Status::Cancelled, _) => "given up",
    }
}

/// Draws, follows, looks and counts.
#[expect(clippy::print_stdout, reason = "the table of the page is made from it")]
fn all_end(seeds: Range<u64>) {
    let (mut endings, mut failures) = (BTreeMap::<String, Vec<u64>>::new(), Vec::new());
    let (mut wrong, mut looks) = (Wrong::default(), Vec::new());
    for seed in seeds {
        let text = drawn::draw(seed);
        let found = catch_unwind(AssertUnwindSafe(|| ended(&text))).unwrap_or_else(|_| Err("a panic".into()));
        match found {
            Ok(end) => {
                wrong = wrong.or(end.wrong);
                looks.push(end.looks);
                endings.entry(end.word).or_default().push(seed);
            }
            Err(words) => failures.push(format!("seed {seed}: {words}\n\n{text}")),
        }
    }
    looks.sort_unstable();
    println!("{wrong:?}; looks: median {:?}, most {:?}", looks.get(looks.len() / 2), looks.last());
    for (word, seeds) in &endings {
        let named = if seeds.len() <= 30 { format!(": {seeds:?}") } else { String::new() };
        println!("{:5} {word}{named}", seeds.len());
    }
    assert!(failures.is_empty(), "{} wrong:\n{}", failures.len(), failures.join("\n----\n"));
    let count = |word: &str| endings.get(word).map_or(0, Vec::len);
    let refused: usize = endings.iter().filter(|(word, _)| word.starts_with("refused")).map(|(_, s)| s.len()).sum();
    let followed = looks.len() - refused;
    assert!(10 * refused <= looks.len(), "{refused} of {} files are refused: {endings:?}", looks.len());
    assert!(200 * (count("not converged") + count("given up")) <= followed + 199, "{endings:?}");
}

#[test]
fn a_few_random_paths_end_with_a_name_and_hold_from_outside() {
    all_end(0..10);
}

#[test]
#[ignore = "a quarter of an hour for five hundred"]
fn many_random_paths_end_with_a_name_and_hold_from_outside() {
    all_end(random::seeds("EXTRADOS_RANDOM_PATHS", 0..2000));
}
