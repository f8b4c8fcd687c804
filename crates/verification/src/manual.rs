//! The verification manual and its table, from judged cases.

use super::case::{Expect, Kind, Value};
use super::judge::{Judged, Judgement, Verdict};

/// What an expectation asks for, in words.
fn wanted(e: &Expect) -> String {
    let unit = if e.unit.is_empty() { String::new() } else { format!(" {}", e.unit) };
    match (&e.value, e.tolerance, e.relative) {
        (Some(Value::Word(word)), ..) => word.clone(),
        (Some(Value::Number(v)), Some(t), _) => format!("{v}{unit} ± {t}"),
        (Some(Value::Number(v)), None, Some(r)) => format!("{v}{unit} ± {} %", plain(100.0 * r)),
        (Some(Value::Number(v)), None, None) => format!("{v}{unit}"),
        (None, ..) => match (e.at_least, e.at_most) {
            (Some(low), Some(high)) => format!("{low} to {high}{unit}"),
            (Some(low), None) => format!("at least {low}{unit}"),
            (None, Some(high)) => format!("at most {high}{unit}"),
            (None, None) => String::new(),
        },
    }
}

/// A share in per cent without the digits that a product leaves behind its twelfth.
fn plain(percent: f64) -> f64 {
    format!("{percent:.12}").parse().unwrap_or(percent)
}

/// A number as a reader wants it: six significant digits.
fn shown(f: &Judgement) -> String {
    match f.found.parse::<f64>() {
        Ok(v) if v != 0.0 && v.is_finite() && v.fract() != 0.0 => {
            let digits = (5 - v.abs().log10().floor() as i32).clamp(0, 12) as usize;
            format!("{v:.digits$}")
        }
        _ => f.found.clone(),
    }
}

/// One line per case, for a terminal.
pub fn table(judged: &[Judged]) -> String {
    let width = judged.iter().map(|j| j.case.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for j in judged {
        let word = j.verdict.word();
        text += &format!("{:width$}  {word:18} {:7.2} s  {}\n", j.case.name, j.seconds, j.case.title);
        let unwell = !matches!(j.verdict, Verdict::Holds);
        for f in j.findings.iter().filter(|f| unwell && !f.met) {
            text += &format!("{:width$}    {}: {} for {}\n", "", f.expect.quantity, shown(f), wanted(&f.expect));
        }
        if let Verdict::Broken(reason) | Verdict::Open(reason) = &j.verdict {
            text += &format!("{:width$}    {reason}\n", "");
        }
    }
    text
}

/// The manual: cases by kind, never added up over kinds.
pub fn manual(judged: &[Judged]) -> String {
    let mut text = String::from(
        "# Verification manual\n\nGenerated from the cases in `verification/`; do not edit.\n\nEach case names its source, its \
         tolerance and the reason for it. The bite is a change of the input that makes the case fail; it is applied to \
         every quick case, so none of them can hold by accident. Kinds of evidence are kept apart: agreement with a test \
         is not agreement with a closed form, and agreement with our own past is neither.\n",
    );
    let mut kinds: Vec<Kind> = judged.iter().map(|j| j.case.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    for kind in kinds {
        text += &format!("\n## Against {}\n", kind.words());
        for j in judged.iter().filter(|j| j.case.kind == kind) {
            case(&mut text, j);
        }
    }
    text
}

fn case(text: &mut String, j: &Judged) {
    let c = &j.case;
    *text += &format!("\n### {}\n\n`{}`: **{}**. {}\n", c.title, c.name, j.verdict.word(), c.source);
    if let Verdict::Open(reason) | Verdict::Broken(reason) = &j.verdict {
        *text += &format!("\n{reason}\n");
    }
    text.push_str("\n| quantity | expected | found | | why this tolerance |\n|---|---|---|---|---|\n");
    for f in &j.findings {
        let mark = if f.met { "✓" } else { "✗" };
        *text +=
            &format!("| {} | {} | {} | {mark} | {} |\n", f.expect.quantity, wanted(&f.expect), shown(f), f.expect.why);
    }
    for erratum in &c.errata {
        *text += &format!("\nErratum: {erratum}\n");
    }
    if let Some(bite) = &c.bite {
        let changes: Vec<String> = bite.iter().map(|(k, v)| format!("`{k}` = `{v}`")).collect();
        *text += &format!("\nBite: {}\n", changes.join(", "));
    }
}
