//! An assessment in a few lines: the same verdict as the report's.

use crate::page::{Page, wrapped};
use ::outcome::assessment::Assessment;
use ::outcome::checked::{told_apart, worst};
use findings::words::counted;
use std::fmt::Write;

/// The verdict in a few lines, or with every comparison, the condition and what is missing; `place` says where the reports are.
pub(crate) fn assessment(a: &Assessment, place: String, details: bool) -> Page {
    let body = if details { everything(a) } else { digest(a) };
    Page { body, assumptions: Vec::new(), place }
}

/// Letters before the words of a line with a title.
const HANGING: usize = 12;
/// Lines of what stands beside a verdict on a first screen.
const MOST_BESIDE: usize = 5;

/// The verdict, what governs it, and what stands beside it.
fn digest(a: &Assessment) -> String {
    let verdict = &a.verdict;
    let mut text = wrapped(&format!("{}: {}", a.bridge, verdict.head()), 2) + "\n";
    if let Some((check, finding)) = worst(&a.checked) {
        let [value, limit] = told_apart(finding.value, finding.limit);
        let unit = if finding.unit.word().is_empty() { String::new() } else { format!(" {}", finding.unit) };
        let needed = finding.needed.map_or(String::new(), |needed| format!(", {needed:.2} for a verdict"));
        let _ = writeln!(
            text,
            "  governs   {value} where the limit is {limit}{unit}{needed}: {} ({}), {}",
            check.title, check.code, finding.load_model
        );
        let _ = writeln!(text, "            {}", finding.basis);
    }
    let made = a.checked.iter().flat_map(|check| check.outcome.iter().flatten());
    let (met, all) = made.fold((0, 0), |(met, all), one| (met + usize::from(one.met()), all + 1));
    let open = a.checked.iter().filter(|check| check.outcome.is_err()).count();
    let _ = writeln!(
        text,
        "  checks    {met} of {} met; {} not asked for or not made",
        counted(all, "comparison"),
        counted(open, "check")
    );
    if let Some(next) = a.next.first() {
        text += &wrapped(&format!("  next      {}: {}", next.action, next.what), HANGING);
    }
    let missing = &verdict.strength.missing;
    missing.iter().take(2).for_each(|words| text += &wrapped(&format!("  missing   {words}"), HANGING));
    if missing.len() > 2 {
        let _ = writeln!(text, "            and {}", counted(missing.len() - 2, "more thing"));
    }
    let beside = verdict.beside();
    for (k, words) in beside.iter().take(MOST_BESIDE).enumerate() {
        let _ = writeln!(text, "  {:<8}  {words}", if k == 0 { "beside" } else { "" });
    }
    text
}

/// The verdict, the comparisons, the condition, what is missing.
fn everything(a: &Assessment) -> String {
    let Assessment { checked, verdict, condition, .. } = a;
    let mut text = format!("{}: {}\n\n{}\n", a.bridge, verdict.head(), verdict.words);
    let beside = verdict.beside();
    for (title, list) in [
        ("missing", &verdict.strength.missing),
        ("stands beside it", &beside),
        ("what the analyses warn of", &verdict.strength.qualifications),
    ] {
        if !list.is_empty() {
            let _ = writeln!(text, "\n  {title}");
            list.iter().for_each(|words| text += &format!("    - {words}\n"));
        }
    }
    let _ = writeln!(
        text,
        "\n  {:<5}{:<27}{:<34}{:>11}{:>11}  {:<22}{:>8}",
        "", "check", "load", "value", "limit", "unit", "used"
    );
    for check in checked {
        for finding in check.outcome.iter().flatten() {
            let needed = finding.needed.filter(|_| finding.met());
            let mark = match (finding.met(), needed) {
                (false, _) => "  NOT MET".to_owned(),
                (true, Some(needed)) => format!("  {needed:.2} for a verdict"),
                (true, None) => String::new(),
            };
            let [value, limit] = told_apart(finding.value, finding.limit);
            let _ = writeln!(
                text,
                "  {:<5}{:<27}{:<34}{value:>11}{limit:>11}  {:<22}{:>6.1} %{mark}",
                check.code,
                check.title,
                finding.load_model,
                finding.unit,
                100.0 * finding.utilisation.min(1e6)
            );
        }
    }
    for check in checked {
        if let Err(why) = &check.outcome {
            let _ = writeln!(text, "  {:<5}{:<27}not made: {}", check.code, check.title, why.why);
        }
    }
    if !condition.is_empty() {
        text += "\n  condition\n";
        for one in condition {
            let value = one.after.map_or("–".to_owned(), |value| format!("{value:.4} {}", one.unit));
            let _ = writeln!(text, "    {:<20}{:<18}{}: {}", one.parameter, value, one.standing.word(), one.words);
        }
    }
    if let Some(facts) = a.facts.sensitivity.made() {
        let _ = writeln!(
            text,
            "\n  what would change {} ({:.1} % of its limit; with a tenth less, with a tenth more)",
            facts.code,
            100.0 * facts.utilisation
        );
        let percent = |value: Option<f64>| {
            value.map_or("no answer".to_owned(), |value| format!("{:.1} %", 100.0 * value.min(1e6)))
        };
        for one in facts.quantities.iter().take(6) {
            let _ = writeln!(text, "    {:<34}{:>12}{:>12}", one.path, percent(one.less), percent(one.more));
        }
    }
    if !a.next.is_empty() {
        text += "\n  what to do next (rules and their sources are in the report)\n";
        a.next.iter().for_each(|one| text += &format!("    {:<9}{}\n", one.action, one.what));
    }
    text
}
