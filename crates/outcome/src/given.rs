//! By what a verdict is given, and what qualifies it: the head of an assessment, in the same words on the screen, in the report, in
//! tables and in the object for scripts.

mod record;

pub use record::{FieldTest, Record};

use crate::checked::{Rung, Verdict};
use crate::wire::{plain, published};
use findings::words::counted;
pub use rules::ChangedFactor;
use serde::{Deserialize, Serialize};
use std::fmt;

published! {
    /// By what a verdict is given, and what a reader must know beside it.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Given |given| {
        /// Code of the rule of `[sweep]`, or "file" for the factor of `[assess]`; none where strength is not asked for.
        pub by: Option<String>,
        /// The same as it is said: "CS 454".
        pub name: String as by_name,
        /// What is asked for where the vehicles stand for grades: "18 t".
        pub level: Option<String>,
        /// What is carried of grades, where that is settled and less than what is asked for: "RA2", "less than 3 t".
        pub carried: Option<String>,
        /// How many factors are to be confirmed.
        = to_confirm: usize = given.to_confirm.len(),
        /// Factors that act on this bridge and are recalled or assumed, each with its value.
        pub to_confirm: Vec<String> as factors_to_confirm,
        /// Stages that the file asks for and the command left out.
        pub skipped: Vec<String>,
        /// Codes of load cases of the rule that apply to the spans and were not moved.
        pub load_cases_left_out: Vec<String>,
        /// Doubtful values of the file, of its vehicles and of its rule: their codes.
        pub doubtful: Vec<Doubt> = given.doubtful.iter().map(|one| one.code.clone()).collect::<Vec<_>>(),
        /// Values of the file that nobody measured: paths of those whose remark begins with "assumed".
        pub assumed: Vec<String> as assumed_values,
        /// Factors that differ from those of the library's rule.
        pub changed_factors: Vec<ChangedFactor>,
        /// What the file does not give and was taken, and what it takes otherwise than usual, in words.
        pub taken: Vec<Taken> = given.taken.iter().map(ToString::to_string).collect::<Vec<_>>(),
        /// The model factor in force, where the factors are not those of a standard.
        pub model_factor: Option<ModelFactor>,
        /// What tests to collapse carried of the predictions of the same method.
        pub record: Option<Record>,
    }
}

/// Something that a verdict takes without being told, or otherwise than usual.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Taken {
    /// What, in few words: "skew not given, taken as square".
    pub what: String,
    /// What that means.
    pub how: String,
    /// What to write in the bridge file in its place; empty where nothing is missing.
    pub write: String,
    /// Whether somebody should look at the bridge for it.
    pub open: bool,
}

impl fmt::Display for Taken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.what, self.how)
    }
}

/// A doubtful value.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Doubt {
    /// Code, `P…`.
    pub code: String,
    /// What is doubtful.
    pub message: String,
}

/// A model factor with its source.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModelFactor {
    /// What a load factor is divided by.
    pub value: f64,
    /// Where it is from.
    pub source: String,
}

plain!(ChangedFactor, ModelFactor);

/// A factor that differs from the library's, in a few words.
fn changed(one: &ChangedFactor) -> String {
    format!("{} {} in place of {} (source named: {})", one.factor, one.file, one.library, one.source)
}

impl Given {
    /// Doubts, each once: several spans may give the same.
    fn doubts(&self) -> Vec<&Doubt> {
        let mut all: Vec<&Doubt> = Vec::new();
        for one in &self.doubtful {
            if !all.contains(&one) {
                all.push(one);
            }
        }
        all
    }

    /// What a verdict is to be read with, in brackets: factors to be confirmed, factors that are not the library's, how many values
    /// are doubtful, what was taken; empty where there is nothing.
    fn in_short(&self) -> String {
        let mut parts: Vec<String> = Vec::new();
        match self.to_confirm.len() {
            0 => {}
            n => parts.push(format!("{} to be confirmed", counted(n, "factor"))),
        }
        if !self.changed_factors.is_empty() {
            let names: Vec<&str> = self.changed_factors.iter().map(|one| one.factor.as_str()).collect();
            parts.push(format!("not the library's: {}", names.join(", ")));
        }
        for (count, what) in [(self.assumed.len(), "assumed value"), (self.doubts().len(), "doubtful value")] {
            if count > 0 {
                parts.push(counted(count, what));
            }
        }
        parts.extend(self.taken.iter().map(|one| one.what.clone()));
        if parts.is_empty() { String::new() } else { format!(" ({})", parts.join("; ")) }
    }
}

impl Verdict {
    /// The verdict in a line: what it is, by what, and for how many factors somebody must open a book.
    pub fn head(&self) -> String {
        let Given { name, level, .. } = &self.given;
        let level = level.as_ref().map_or(String::new(), |level| format!(" for {level}"));
        let carries = self.given.carried.as_ref().map_or(String::new(), |grade| format!(": carries {grade}"));
        let with = carries + &self.given.in_short();
        match self.headline {
            Rung::Adequate => format!("Adequate by {name}{level}{with}"),
            Rung::NotAdequate if self.broken_by_rule => format!("Not adequate by {name}{level}{with}"),
            Rung::NotAdequate | Rung::LimitsMet => self.headline.word().to_owned(),
            Rung::Undetermined | Rung::NothingCompared => match self.open.first() {
                None => self.headline.word().to_owned(),
                Some(first) => {
                    let more = match self.open.len() - 1 {
                        0 => String::new(),
                        n => format!(", and {}", counted(n, "more thing")),
                    };
                    format!("Undetermined ({first}{more})")
                }
            },
        }
    }

    /// What qualifies the verdict, most important first, each in a line.
    pub fn beside(&self) -> Vec<String> {
        let given = &self.given;
        let mut lines = Vec::new();
        let mut list = |what: String, items: &[String]| {
            if !items.is_empty() {
                lines.push(format!("{what}: {}", items.join(", ")));
            }
        };
        list("left out by the command".to_owned(), &given.skipped);
        list(format!("load cases of {} left out", given.name), &given.load_cases_left_out);
        let changed: Vec<String> = given.changed_factors.iter().map(changed).collect();
        list("factors that differ from the library's".to_owned(), &changed);
        let doubts: Vec<String> = given.doubts().iter().map(|one| format!("{} ({})", one.message, one.code)).collect();
        list("assumed in the file".to_owned(), &given.assumed);
        list("doubtful values".to_owned(), &doubts);
        lines.extend(given.taken.iter().map(Taken::to_string));
        if let Some(model) = &given.model_factor {
            lines.push(format!("model factor in force: {} ({})", model.value, model.source));
        }
        if !given.to_confirm.is_empty() {
            lines.push(format!("to be confirmed in their source: {}", given.to_confirm.join(", ")));
        }
        lines.extend(given.record.map(|record| record.words()));
        lines
    }
}
