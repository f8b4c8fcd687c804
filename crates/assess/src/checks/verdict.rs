//! From comparisons to a verdict, by a ladder: a limit that is not met; something missing that the rule asks for, or an analysis without
//! an end; limits that are met where nobody asked for strength; the rule met.

use super::given::{given, square};
use super::{by_file, by_rule};
use crate::evidence::Evidence;
use findings::words::counted;
use outcome::checked::{Checked, Comparison, Judgement, Rung, Strength, Verdict, worst};
use outcome::warning::{self, Warning};

/// Something without which strength is not shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Open {
    /// In a few words.
    pub what: String,
    /// What to write or do.
    pub write: String,
}

impl Open {
    pub(super) fn new(what: impl Into<String>, write: impl Into<String>) -> Open {
        Open { what: what.into(), write: write.into() }
    }

    fn words(&self) -> String {
        if self.write.is_empty() { self.what.clone() } else { format!("{}: {}", self.what, self.write) }
    }
}

/// Inadequate where a limit is not met. Adequate where the file names a rule, or a factor of its own with a source, and everything that it
/// asks for was made and met. Undetermined otherwise: checks that the file gives no limit for are listed and do not count.
pub fn verdict(a: &Evidence, checked: &[Checked]) -> Verdict {
    let made: Vec<(&Checked, &Comparison)> =
        checked.iter().flat_map(|check| check.outcome.iter().flatten().map(move |one| (check, one))).collect();
    let broken: Vec<_> = made.iter().filter(|(_, finding)| !finding.met()).collect();
    let failed: Vec<&str> = (checked.iter())
        .filter(|check| check.outcome.as_ref().is_err_and(|e| e.failed))
        .map(|check| check.title.as_str())
        .collect();
    let asked = a.bridge.sweep.is_some() || a.asked.limits.adequacy_factor.is_some();
    let open = open(a, checked, &failed);
    let assessed = asked && open.is_empty();
    let comparisons = counted(made.len(), "comparison");
    let most = most(checked);
    let (headline, words) = match (broken.len(), failed.is_empty(), made.is_empty()) {
        (n @ 1.., _, _) => {
            let are = if n == 1 { "is" } else { "are" };
            (Rung::NotAdequate, format!("{n} of {comparisons} {are} not met. {most}."))
        }
        (0, false, _) => (Rung::Undetermined, format!("An analysis did not finish: {}.", failed.join(", "))),
        (0, true, true) if asked && !assessed => (Rung::Undetermined, "Nothing could be compared.".to_owned()),
        (0, true, false) if asked && !assessed => (
            Rung::Undetermined,
            format!("Every limit that was compared is met ({comparisons}), and strength is not shown. {most}."),
        ),
        (0, true, true) => (
            Rung::NothingCompared,
            "No check could be made: the file names no rule and no limits to compare with.".to_owned(),
        ),
        (0, true, false) if !asked => (
            Rung::LimitsMet,
            format!(
                "Every limit that the file gives is met ({comparisons}); it names no rule for strength, and no verdict of adequacy is given. {most}."
            ),
        ),
        (0, true, false) => {
            let square = if square(a) { " The file gives no skew: this holds for a square bridge." } else { "" };
            (Rung::Adequate, format!("Every limit is met, {comparisons} in all. {most}.{square}"))
        }
    };
    let status = match headline {
        Rung::NotAdequate => Judgement::Inadequate,
        Rung::Adequate => Judgement::Adequate,
        Rung::Undetermined | Rung::NothingCompared | Rung::LimitsMet => Judgement::Undetermined,
    };
    let undetermined = status == Judgement::Undetermined;
    let missing = match (undetermined, asked) {
        (true, true) => open.iter().map(Open::words).collect(),
        (true, false) => vec![format!("{WANTED}: {RULE}")],
        (false, _) => Vec::new(),
    };
    Verdict {
        status,
        headline,
        words,
        finished: failed.is_empty(),
        strength: Strength {
            assessed: assessed && failed.is_empty(),
            missing,
            qualifications: if made.is_empty() { Vec::new() } else { qualifications(a) },
        },
        given: given(a),
        broken_by_rule: a.bridge.sweep.is_some() && broken.iter().any(|(check, _)| check.code == by_rule::CODE),
        open: if undetermined { open.into_iter().map(|one| one.what).collect() } else { Vec::new() },
    }
}

/// What is missing where a file names nothing by which strength is judged.
const WANTED: &str = "no rule for strength";
/// How to name one.
const RULE: &str = "write rule = \"cs-454\" (roads), rule = \"nr-civ-025\" (railways), or rule_file with the factors of yours, in [sweep]; \
                    or adequacy_factor with its source in [assess]";

/// Everything without which strength is not shown: stages that were left out, and what the rule or the file's own factor lacks.
fn open(a: &Evidence, checked: &[Checked], failed: &[&str]) -> Vec<Open> {
    // What records say of the parameters counts for every check; other stages for the checks that rest on them.
    let rests = checked.iter().filter_map(|check| check.outcome.as_ref().err()?.left_out.as_deref());
    let mut skipped: Vec<&str> = a.facts.update.left_out().into_iter().chain(rests).collect();
    skipped.dedup();
    let told = |stage: &&str| {
        Open::new(format!("{stage} left out"), format!("the file asks for it; leave --skip {stage} away"))
    };
    let mut list: Vec<Open> = skipped.iter().map(told).collect();
    if a.facts.update.failed() {
        list.push(Open::new("update without a result", a.facts.update.why_not().unwrap_or_default()));
    }
    list.extend(
        failed.iter().map(|title| Open::new(format!("{title} without a result"), "see the stages of the report")),
    );
    list.extend(skew(a));
    list.extend(match (&a.bridge.sweep, a.asked.limits.adequacy_factor) {
        (Some(_), _) => by_rule::open(a, checked),
        (None, Some(_)) => by_file::open(a, checked),
        (None, None) => Vec::new(),
    });
    list
}

/// Why a skew bridge has no verdict of adequacy; none where it is square, hardly skew, or where the file names what confirms it.
fn skew(a: &Evidence) -> Option<Open> {
    let skew = a.bridge.spans.iter().map(|span| span.skew).fold(0.0, f64::max);
    let doubtful = skew > bridge::DOUBTFUL_SKEW && a.asked.limits.skew_source.is_none();
    doubtful.then(|| {
        Open::new(
            format!("skew by {:.0} degrees, for which the square model is no bound", skew.to_degrees()),
            "name the three-dimensional model or the test that confirms it as skew_source in [assess]",
        )
    })
}

/// What governs, in a sentence.
fn most(checked: &[Checked]) -> String {
    let words = worst(checked).map(|(check, finding)| {
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

/// Warnings that stand in the head in other words: numbers chosen for the reader, and factors that are listed by name.
const BESIDE: [&str; 2] = [warning::CHOSEN, warning::RECALLED_FACTOR];

/// Warnings of the analyses behind the ultimate checks, each by its title.
fn qualifications(a: &Evidence) -> Vec<String> {
    let stages =
        [a.facts.vehicles.made().map(|facts| &facts.warnings), a.facts.ultimate.made().map(|facts| &facts.warnings)];
    let mut list: Vec<String> = Vec::new();
    for code in stages.into_iter().flatten().flatten().map(Warning::code) {
        let title = findings::Card::of(code, warning::CARDS).map_or(code, |card| card.title);
        let line = format!("{title} ({code})");
        if !BESIDE.contains(&code) && !list.contains(&line) {
            list.push(line);
        }
    }
    list
}
