//! From findings to a verdict, by a ladder: a limit that is not met, an analysis that came to no end, limits that are met without
//! strength being assessed, strength assessed and everything met.

use super::strength::strength;
use crate::evidence::Evidence;
use outcome::checked::{Checked, Comparison};
use outcome::checked::{Judgement, Rung};
use outcome::checked::{Verdict, governing};

/// Inadequate where a limit is not met. Undetermined where an analysis failed that a check rests on, where nothing could be
/// compared, and where limits are met but no ultimate check was made under factors with a source. Adequate otherwise: checks
/// that the file gives no limit for are listed and do not count.
pub fn verdict(a: &Evidence, checked: &[Checked]) -> Verdict {
    let made: Vec<&Comparison> = checked.iter().flat_map(|check| check.outcome.iter().flatten()).collect();
    let broken = made.iter().filter(|finding| !finding.met()).count();
    let failed: Vec<&str> = (checked.iter())
        .filter(|check| check.outcome.as_ref().is_err_and(|e| e.failed))
        .map(|check| check.title.as_str())
        .collect();
    let most = most(checked);
    let open = checked.iter().filter(|check| check.outcome.is_err()).count();
    let not_made = match open {
        0 => String::new(),
        1 => " One check was not made; the report says why.".to_owned(),
        n => format!(" {n} checks were not made; the report says why of each."),
    };
    let strength = strength(a, checked);
    let comparisons = match made.len() {
        1 => "one comparison".to_owned(),
        n => format!("{n} comparisons"),
    };
    let (status, headline, words) = match (broken, failed.is_empty(), made.is_empty()) {
        (1.., _, _) => (
            Judgement::Inadequate,
            Rung::NotAdequate,
            format!("The bridge does not meet {broken} of the {} comparisons that were made. {most}.", made.len()),
        ),
        (0, false, _) => (
            Judgement::Undetermined,
            Rung::Undetermined,
            format!("An analysis did not finish, so the verdict is undetermined: {} open.", failed.join(", ")),
        ),
        (0, true, true) => (
            Judgement::Undetermined,
            Rung::NothingCompared,
            "No check could be made: the file gives no limits to compare with, and no factors with a source."
                .to_owned(),
        ),
        (0, true, false) if !strength.assessed => (
            Judgement::Undetermined,
            Rung::LimitsMet,
            format!(
                "The bridge meets every limit that it was compared with ({comparisons}), but its safety is not shown: \
                 no ultimate check was made under factors with a source. {most}."
            ),
        ),
        (0, true, false) => (
            Judgement::Adequate,
            Rung::Adequate,
            format!("The bridge meets every limit that it was compared with, {comparisons} in all. {most}."),
        ),
    };
    Verdict { status, headline, words: words + &not_made, finished: failed.is_empty(), strength }
}

/// What governs, in a sentence.
fn most(checked: &[Checked]) -> String {
    let found = governing(checked).and_then(|(c, k)| Some((&checked[c], checked[c].outcome.as_ref().ok()?.get(k)?)));
    let words = found.map(|(check, finding)| {
        let used = 100.0 * finding.utilisation.min(1e6);
        format!("{} ({}) governs: {used:.0} % of its limit is used", check.title, finding.load_model)
    });
    words.map(|words| capital(&words)).unwrap_or_default()
}

/// A sentence begins with a capital.
fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
