//! Checks and the verdict: what was compared with what.

use crate::facts::Reading;
use crate::given::Given;
use crate::published::object;
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

words! {
    /// Units of comparisons.
    #[derive(Default)]
    pub enum Unit {
        /// A bare number.
        #[default]
        Ratio = "",
        /// Millimetres.
        Millimetre = "mm",
        /// Megapascals.
        Megapascal = "MPa",
        /// Tonnes.
        Tonne = "t",
        /// A share of a ring's depth.
        OfTheDepth = "of the depth",
        /// A share of a strength.
        OfTheStrength = "of the strength",
        /// A share of the load at collapse.
        OfTheUltimateLoad = "of the ultimate load",
    }
}

published! {
    /// A number and its limit, of a check.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Comparison |one, check: &Checked| {
        /// Code of the check.
        = code: String = &check.code,
        /// The check in a few words.
        = title: String = &check.title,
        /// The clause that it follows, in short.
        = clause: String = &check.clause,
        /// The load that it is for.
        pub load_model: String,
        /// The number.
        pub value: f64,
        /// Its limit.
        pub limit: f64,
        /// Unit of both.
        pub unit: Unit,
        /// How much of the limit is used; above one it is not met.
        pub utilisation: f64,
        /// Whether the limit is met.
        = met: bool = one.met(),
        /// What the value must reach for a verdict, where the factors are the engineer's own and the uncertainty of the method comes on top.
        pub needed?: Option<f64> as needed_for_a_verdict,
        /// What was computed, where and how.
        pub basis: String,
        /// Position of the first axle that it belongs to [m], where there is one.
        pub position: Option<f64> [m],
        /// The columns of the railway paper's Table 7, where the check has them.
        pub columns?: Option<Columns> = one.columns.as_ref().map(|row| row.values).map(|[own, design, sum, total, whole]| object! {
            self_weight: own,
            live_load_design_cda: design,
            total_design_cda: sum,
            live_load_total_cda: total,
            total_total_cda: whole,
        }),
        /// Whether this is a check of strength: at ultimate, under factors with a source.
        pub strength: bool [kept],
    }
}

/// A row of the railway paper's Table 7.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Columns {
    /// The load.
    pub load: String,
    /// The augment of the comparison that it stands beside.
    pub reading: Reading,
    /// Self-weight, live load with design augment, their sum, live load with total augment, their sum [unit of the comparison].
    pub values: [f64; 5],
}

impl Comparison {
    /// Whether the limit is met.
    pub fn met(&self) -> bool {
        self.utilisation <= 1.0
    }
}

published! {
    /// Why a check could not be made.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    pub struct NotMade |one, check: &Checked| {
        = code: String = &check.code,
        = title: String = &check.title,
        /// In words.
        pub why: String,
        /// Whether an analysis that it rests on was asked for and failed: then nothing is settled.
        pub failed: bool as analysis_failed,
        /// The stage that it rests on, where the file asks for it and the command left it out.
        pub left_out: Option<String> [kept],
    }
}

impl NotMade {
    /// For a reason that is no failure.
    pub fn because(why: impl Into<String>) -> NotMade {
        NotMade { why: why.into(), failed: false, left_out: None }
    }

    /// For an analysis that came to no end.
    pub fn failed(why: impl Into<String>) -> NotMade {
        NotMade { why: why.into(), failed: true, left_out: None }
    }
}

/// A check and what came of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checked {
    /// Code, `C…`; its card is in the checks.
    pub code: String,
    /// In a few words.
    pub title: String,
    /// The clause that it follows, in short.
    pub clause: String,
    /// Where a bridge file says for what the value is computed, and where its limit is; empty where that is not kept.
    pub keys: [String; 2],
    /// What came of it.
    pub outcome: Result<Vec<Comparison>, NotMade>,
}

words! {
    /// A verdict in a word.
    pub enum Judgement {
        /// Everything was met, strength among it.
        Adequate = "adequate",
        /// Something was not met.
        Inadequate = "inadequate",
        /// Neither can be said.
        Undetermined = "undetermined",
    }

    /// Rungs of the ladder of verdicts.
    pub enum Rung {
        /// A limit is not met.
        NotAdequate = "Not adequate",
        /// An analysis came to no end, or something is missing that the rule asks for.
        Undetermined = "Undetermined",
        /// Nothing could be compared.
        NothingCompared = "Undetermined: nothing was compared",
        /// Limits are met, and the file asks for no check of strength.
        LimitsMet = "Limits met; strength not asked for",
        /// Limits are met, strength among them.
        Adequate = "Adequate",
    }
}

published! {
    /// The verdict.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Verdict |verdict| {
        /// What it is in a word.
        pub status: Judgement [kept],
        /// In a sentence or two.
        pub words: String as verdict,
        /// The rung of the ladder, in a few words.
        pub headline: Rung,
        /// The verdict in a line: by what it is given, and what it is to be read with.
        = head: String = verdict.head(),
        /// What stands beside it, most important first.
        = beside: Vec<String> = verdict.beside(),
        = ..Given = Some(verdict.given.object()),
        /// By what it is given, and what stands beside it.
        pub given: Given [kept],
        = ..Strength = Some(verdict.strength.object()),
        /// Whether strength was assessed, what is missing, and what qualifies it.
        pub strength: Strength [kept],
        /// Whether every analysis that a check rests on came to an end.
        pub finished: bool [kept],
        /// Whether a load case of the rule is among what is not met.
        pub broken_by_rule: bool [kept],
        /// What keeps it undetermined, each in a few words.
        pub open: Vec<String> [kept],
    }
}

/// A value and its limit with as many digits as tell them apart, three of the value at least: 1.897 of 1.9 is not 1.90 of 1.90.
pub fn told_apart(value: f64, limit: f64) -> [String; 2] {
    let whole = value.abs().max(limit.abs()).max(f64::MIN_POSITIVE).log10().floor() as i32 + 1;
    let least = (4 - whole).clamp(0, 4) as usize;
    let written = |digits: usize| [value, limit].map(|one| format!("{one:.digits$}"));
    let digits = (least..=9).find(|digits| value == limit || written(*digits)[0] != written(*digits)[1]);
    written(digits.unwrap_or(9))
}

/// The finding with the largest utilisation: indices of its check and of itself.
pub fn governing(checked: &[Checked]) -> Option<(usize, usize)> {
    let all = checked.iter().enumerate().flat_map(|(c, check)| {
        let list: &[Comparison] = check.outcome.as_ref().map_or(&[], |list| list);
        list.iter().enumerate().map(move |(k, finding)| (c, k, finding.utilisation))
    });
    let worst = all.reduce(|worst, next| if next.2 > worst.2 { next } else { worst });
    worst.map(|(check, finding, _)| (check, finding))
}

/// That check and that finding.
pub fn worst(checked: &[Checked]) -> Option<(&Checked, &Comparison)> {
    let (check, finding) = governing(checked)?;
    let check = &checked[check];
    Some((check, check.outcome.as_ref().ok()?.get(finding)?))
}

published! {
    /// Whether strength was assessed.
    #[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
    pub struct Strength {
        /// Whether an ultimate check was made under factors with a source, and none came to no end.
        pub assessed: bool as strength_assessed,
        /// What is missing, in words; empty where it was assessed.
        pub missing: Vec<String>,
        /// What qualifies a check that was made, in words.
        pub qualifications: Vec<String>,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_and_its_limit_are_told_apart() {
        let both = |value, limit| told_apart(value, limit).join(" of ");
        assert_eq!(both(1.8999, 1.9), "1.8999 of 1.9000");
        assert_eq!(both(1.9, 1.9), "1.900 of 1.900");
        assert_eq!(both(0.58, 1.25), "0.580 of 1.250");
        assert_eq!(both(123.4, 120.0), "123.4 of 120.0");
        assert_eq!(both(1.899_999_9, 1.9), "1.8999999 of 1.9000000");
        assert_eq!(both(0.0, 0.0), "0.0000 of 0.0000");
    }
}
