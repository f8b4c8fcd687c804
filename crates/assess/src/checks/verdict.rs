//! From findings to a verdict: everything that was checked is met, something is not, or nothing is settled.

use super::{Checked, Finding};

/// The verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// "adequate", "inadequate" or "undetermined".
    pub status: &'static str,
    /// In a sentence or two.
    pub words: String,
}

/// The finding with the largest utilisation: indices of its check and of itself.
pub fn governing(checked: &[Checked]) -> Option<(usize, usize)> {
    let all = checked.iter().enumerate().flat_map(|(c, check)| {
        let list: &[Finding] = check.outcome.as_ref().map_or(&[], |list| list);
        list.iter().enumerate().map(move |(k, finding)| (c, k, finding.utilisation))
    });
    let worst = all.reduce(|worst, next| if next.2 > worst.2 { next } else { worst });
    worst.map(|(check, finding, _)| (check, finding))
}

/// Inadequate where a limit is not met; undetermined where an analysis failed that a check rests on, or where nothing could
/// be checked; adequate otherwise: checks that the file gives no limit for are listed and do not count.
pub fn verdict(checked: &[Checked]) -> Verdict {
    let made: Vec<&Finding> = checked.iter().flat_map(|check| check.outcome.iter().flatten()).collect();
    let broken = made.iter().filter(|finding| !finding.met()).count();
    let failed: Vec<&str> =
        checked.iter().filter(|check| check.outcome.as_ref().is_err_and(|e| e.failed)).map(|c| c.card.title).collect();
    let most = governing(checked).map(|(c, k)| {
        let finding = &checked[c].outcome.as_ref().expect("a finding governs")[k];
        format!(
            "{} ({}) governs: {:.0} % of its limit is used",
            checked[c].card.title,
            finding.load_model,
            100.0 * finding.utilisation.min(1e6)
        )
    });
    let most = most.map(|words| capital(&words)).unwrap_or_default();
    let open = checked.iter().filter(|check| check.outcome.is_err()).count();
    let not_made = match open {
        0 => String::new(),
        1 => " One check was not made; the report says why.".to_owned(),
        n => format!(" {n} checks were not made; the report says why of each."),
    };
    match (broken, failed.is_empty(), made.is_empty()) {
        (1.., _, _) => Verdict {
            status: "inadequate",
            words: format!(
                "The bridge does not meet {broken} of the {} comparisons that were made. {most}.{not_made}",
                made.len()
            ),
        },
        (0, false, _) => Verdict {
            status: "undetermined",
            words: format!(
                "An analysis came to no end, so that nothing is settled: {} open.{not_made}",
                failed.join(", ")
            ),
        },
        (0, true, true) => Verdict {
            status: "undetermined",
            words: format!("No check could be made: the file gives no limits to compare with.{not_made}"),
        },
        (0, true, false) => Verdict {
            status: "adequate",
            words: format!(
                "The bridge meets every limit that it was compared with, {} comparisons in all. {most}.{not_made}",
                made.len()
            ),
        },
    }
}

/// A sentence begins with a capital.
fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
