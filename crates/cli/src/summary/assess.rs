//! An assessment in a few lines: the same verdict as the report's.

use ::outcome::assessment::Assessment;
use std::fmt::Write;
use std::path::Path;

/// The verdict, the comparisons, the condition, what is missing; `report` names the reports that are written.
pub fn assessment(a: &Assessment, report: &str, folder: &Path) -> String {
    let Assessment { checked, verdict, condition, .. } = a;
    let rung = match verdict.headline.word().eq_ignore_ascii_case(verdict.status.word()) {
        true => String::new(),
        false => format!(" ({})", verdict.headline),
    };
    let mut text = format!("{}: {}{rung}\n\n{}\n", a.bridge, verdict.status.word().to_uppercase(), verdict.words);
    for (title, list) in
        [("missing", &verdict.strength.missing), ("what qualifies this verdict", &verdict.strength.qualifications)]
    {
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
            let mark = if finding.met() { "" } else { "  NOT MET" };
            let _ = writeln!(
                text,
                "  {:<5}{:<27}{:<34}{:>11.4}{:>11.4}  {:<22}{:>6.1} %{mark}",
                check.code,
                check.title,
                finding.load_model,
                finding.value,
                finding.limit,
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
    let _ = writeln!(text, "\n{report}, checks.csv and result.json are in {}", folder.display());
    text
}
