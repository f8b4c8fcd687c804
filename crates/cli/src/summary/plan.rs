//! What a load test would tell, as two tables: positions and sensors in the order in which each adds most.

use findings::words::{counted, verb};
use outcome::note;
use outcome::plan::{LoadTestPlan, Telling};
use std::fmt::Write;

/// Columns narrower than this are widened.
const LEAST: usize = 18;

pub(crate) fn plan(plan: &LoadTestPlan) -> String {
    let mut page = String::from(
        "\nWhat the load test would tell, in the order in which each adds most to those above it; 95 % intervals of what is sought\n\n",
    );
    let heads: Vec<String> = plan.sought.iter().map(|one| format!("{} [{}]", one.name, one.unit)).collect();
    let widths: Vec<usize> = heads.iter().map(|head| head.chars().count().max(LEAST)).collect();
    let names = plan.positions.iter().chain(&plan.sensors).map(|one| one.name.chars().count());
    let first = names.max().unwrap_or(0).max("before the test".len());
    let mut row = |name: &str, told: &str, cells: &[String]| {
        let mut line = format!("  {name:<first$}  {told:>6}");
        for (cell, width) in cells.iter().zip(&widths) {
            let _ = write!(line, "  {cell:>width$}");
        }
        let _ = writeln!(page, "{}", line.trim_end());
    };
    let cells = |intervals: &[[f64; 2]]| -> Vec<String> {
        intervals.iter().map(|[low, high]| format!("{} to {}", significant(*low), significant(*high))).collect()
    };
    let before: Vec<[f64; 2]> = plan.sought.iter().map(|one| one.range).collect();
    for (what, list) in [("position", &plan.positions), ("sensor", &plan.sensors)] {
        row(what, "[bit]", &heads);
        row("before the test", "", &cells(&before));
        let told = |one: &Telling| (one.name.clone(), format!("{:.2}", one.information), cells(&one.intervals));
        for (name, bits, cells) in list.iter().map(told) {
            row(&name, &bits, &cells);
        }
        row("", "", &[]);
    }
    row("the whole test", &format!("{:.2}", plan.information), &cells(&plan.intervals));
    for (count, one) in plan.not_listed.iter().zip(["more position", "more sensor"]).filter(|(count, _)| **count > 0) {
        let _ = writeln!(
            page,
            "  {} {} less than the last of those, or nothing",
            counted(*count, one),
            verb(*count, "adds", "add")
        );
    }
    page += "\nThis assumes:\n";
    for words in note::words(&plan.assumptions) {
        let _ = writeln!(page, "  - {words}");
    }
    page
}

/// A number with three digits that matter.
fn significant(value: f64) -> String {
    let decimals = match value.abs().log10().floor() {
        magnitude if magnitude.is_finite() => (2.0 - magnitude).clamp(0.0, 9.0) as usize,
        _ => 0,
    };
    format!("{value:.decimals$}")
}
