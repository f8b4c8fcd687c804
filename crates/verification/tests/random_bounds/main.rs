//! Bounds of random bridges whose fill is a continuum: whatever the file can express ends in two bounds in order, with certificates that
//! hold, or in a named status, and never in a panic.
//!
//! `cargo test --release -p verification --test random_bounds` draws a few, `-- --ignored --nocapture` those that the variable
//! `EXTRADOS_RANDOM_BOUNDS` names (0..500 without it) and tells how they ended.

mod drawn;
#[path = "../random/mod.rs"]
mod random;

use assess::analysis::engine::continuum::bounds_alone;
use bridge::Severity;
use mechanics::limit::continuum::{Bounds, BoundsStatus};
use mechanics::watch::CancelToken;
use std::collections::BTreeMap;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Largest share of all loads that stresses may leave unbalanced, and by which they may exceed strength.
const FORCES: f64 = 1e-6;
/// Largest violation of the flow rule, relative to the fastest point.
const FLOW: f64 = 1e-5;

/// How a drawn file ended, in words.
fn ending(text: &str) -> Result<String, String> {
    let read = bridge::read(text.as_bytes());
    let Some(bridge) = read.bridge else {
        let errors = read.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        return Ok(format!("refused {}", errors.map(|d| d.code).collect::<Vec<_>>().join(" ")));
    };
    match bounds_alone(&bridge, &CancelToken::default()) {
        Err(error) => Ok(format!("not set up: {}", without_digits(&error.to_string()))),
        Ok((bounds, _)) => sound(&bounds).map(|()| word(&bounds).to_owned()),
    }
}

/// A message without its numbers, by which endings of one kind are counted together.
fn without_digits(message: &str) -> String {
    message.chars().filter(|c| !c.is_ascii_digit()).collect()
}

fn word(bounds: &Bounds) -> &'static str {
    match bounds.status {
        BoundsStatus::Bounded if bounds.rounds.iter().any(|r| r.lower.is_none() || r.upper.is_none()) => {
            "bounded, one mesh not solved"
        }
        BoundsStatus::Bounded => "bounded",
        BoundsStatus::LowerAlone => "a lower bound alone",
        BoundsStatus::NoEquilibrium => "proven not to stand",
        BoundsStatus::Locks => "locks",
        BoundsStatus::NotConverged => "not converged",
        BoundsStatus::Cancelled => "cancelled",
    }
}

/// What bounds claim must hold.
fn sound(bounds: &Bounds) -> Result<(), String> {
    // A bound of any mesh is one of the body: the largest lower one lies below the smallest upper one.
    let lowest = bounds.rounds.iter().filter_map(|r| r.upper).fold(f64::INFINITY, f64::min);
    let highest = bounds.rounds.iter().filter_map(|r| r.lower).fold(f64::NEG_INFINITY, f64::max);
    if highest > lowest + 1e-6 * lowest.abs() {
        return Err(format!("bounds cross: {highest} is above {lowest}"));
    }
    if let Some(below) = &bounds.lower
        && !(below.factor.is_finite() && below.equilibrium_residual <= FORCES && below.yield_violation <= FORCES)
    {
        return Err(format!("the stresses leave {:e}, {:e}", below.equilibrium_residual, below.yield_violation));
    }
    if let Some(above) = &bounds.upper
        && !(above.factor.is_finite() && above.flow_violation <= FLOW)
    {
        return Err(format!("the motion violates the flow rule by {:e}", above.flow_violation));
    }
    match bounds.status {
        BoundsStatus::Bounded if bounds.lower.is_none() || bounds.upper.is_none() => Err("bounded by nothing".into()),
        BoundsStatus::NoEquilibrium if !bounds.share.is_some_and(|share| (0.0..1.0).contains(&share)) => {
            Err(format!("it does not stand, and the share is {:?}", bounds.share))
        }
        _ => Ok(()),
    }
}

/// Draws, bounds and counts; returns how many ended how.
fn all_end(seeds: Range<u64>, elements: usize) -> BTreeMap<String, Vec<u64>> {
    let (mut endings, mut wrong) = (BTreeMap::<String, Vec<u64>>::new(), Vec::new());
    for seed in seeds {
        let text = drawn::draw(seed, elements);
        let found = catch_unwind(AssertUnwindSafe(|| ending(&text))).unwrap_or_else(|_| Err("a panic".into()));
        match found {
            Ok(word) => endings.entry(word).or_default().push(seed),
            Err(words) => wrong.push(format!("seed {seed}: {words}\n\n{text}")),
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n----\n"));
    endings
}

/// At least two thirds of what is drawn has bounds or a proof.
fn mostly_answered(endings: &BTreeMap<String, Vec<u64>>) {
    let total: usize = endings.values().map(Vec::len).sum();
    let of = |words: &[&str]| -> usize { words.iter().filter_map(|word| endings.get(*word)).map(Vec::len).sum() };
    let answered = of(&["bounded", "bounded, one mesh not solved", "proven not to stand", "locks"]);
    assert!(3 * answered >= 2 * total, "only {answered} of {total} have an answer: {endings:?}");
    assert_eq!(of(&["cancelled"]), 0);
}

#[test]
fn a_few_random_bridges_have_bounds_in_order_or_a_named_ending() {
    mostly_answered(&all_end(14..30, 450));
}

/// Two bounded bridges and one that does not stand, in all their numbers.
fn told() -> Vec<String> {
    let of = |seed| {
        let read = bridge::read(drawn::draw(seed, 450).as_bytes());
        let (bounds, _) = bounds_alone(&read.bridge.expect("a valid file"), &CancelToken::default()).expect("bounds");
        format!("{bounds:?}")
    };
    [14, 17, 23].map(of).to_vec()
}

#[test]
fn bounds_are_the_same_to_the_bit_every_time_and_on_every_thread() {
    // The mesher keeps hash maps, whose order differs from map to map.
    let elsewhere = std::thread::spawn(told);
    let here = told();
    assert!(here == elsewhere.join().expect("no panic"), "numbers differ");
}

#[test]
#[ignore = "three quarters of an hour on a busy machine"]
#[expect(clippy::print_stdout, reason = "the table of the page is made from it")]
fn many_random_bridges_have_bounds_in_order_or_a_named_ending() {
    let endings = all_end(random::seeds("EXTRADOS_RANDOM_BOUNDS", 0..500), 800);
    for (word, seeds) in &endings {
        let named = if seeds.len() <= 60 { format!(": {seeds:?}") } else { String::new() };
        println!("{:4} {word}{named}", seeds.len());
    }
    mostly_answered(&endings);
}
