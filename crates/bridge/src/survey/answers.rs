//! Answers of a survey sheet as values of a bridge file.

use super::{QUESTIONS, Question};
use crate::Severity;
use crate::material;
use crate::quantity::{self, Dimension};

/// What is wrong with an answer, or doubtful.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unusable {
    /// Which of the answers: `span`, `rise_2`.
    pub key: String,
    /// Whether it makes no file, or one that should be looked at.
    pub severity: Severity,
    /// What is wrong with it.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

/// A value as the file has it.
#[derive(Debug, Clone, Default)]
pub(super) struct Answer {
    /// The answer that it was taken from: `span`, `rise_2`.
    pub key: String,
    /// With its unit.
    pub text: String,
    /// In SI.
    pub si: f64,
    /// What the file remarks of it where nobody gave it; empty where somebody did.
    pub assumed: String,
    /// What the file remarks instead; empty for the usual remark.
    pub remark: String,
}

/// Answers by which a part is not there, with its words.
pub(super) const NOTHING: [(&str, f64, &str); 5] = [
    ("spans", 1.0, "further spans"),
    ("rings", 1.0, "further rings"),
    ("cover", 0.0, "cover"),
    ("backing", 0.0, "backing"),
    ("lost_mortar", 0.0, "joints without mortar"),
];

/// Words without what ends a text in the file.
pub(super) fn plain(words: &str, most: usize) -> String {
    words.chars().filter(|c| !c.is_control() && *c != '"' && *c != '\\').take(most).collect()
}

/// A length [m] in feet, with at most so many decimals.
pub(super) fn feet(metres: f64, decimals: i32) -> String {
    let foot = Dimension::Length.units().find(|unit| unit.symbol == "ft").map_or(1.0, |unit| unit.size);
    let parts = 10_f64.powi(decimals);
    format!("{} ft", (metres / foot * parts).round() / parts)
}

impl Answer {
    /// A share of it, in its own unit.
    pub(super) fn over(&self, count: usize) -> String {
        match quantity::parse(&self.text) {
            Ok(whole) if count > 1 => {
                let share = whole.number / count as f64;
                format!("{} {}", (share * 1e6).round() / 1e6, whole.unit.symbol)
            }
            _ => self.text.clone(),
        }
    }

    /// Whether it is in feet, inches or yards.
    pub(super) fn imperial(&self) -> bool {
        quantity::parse(&self.text).is_ok_and(|found| found.unit.imperial())
    }
}

/// What the sheet says, and what of it is no value.
pub(super) struct Answers<'a> {
    said: &'a dyn Fn(&str) -> Option<String>,
    /// Whether the example of a question stands for an answer that nobody gave yet.
    begun: bool,
    /// Whether lengths are measured in feet and inches.
    in_feet: bool,
    wrong: Vec<Unusable>,
}

impl<'a> Answers<'a> {
    pub(super) fn new(said: &'a dyn Fn(&str) -> Option<String>, begun: bool) -> Self {
        // One answer in inches among metres makes no file in feet.
        let given = QUESTIONS[..5].iter().filter_map(|one| said(one.key));
        let lengths: Vec<bool> =
            given.map(|text| quantity::parse(&text).is_ok_and(|one| one.unit.imperial())).collect();
        let in_feet = 2 * lengths.iter().filter(|feet| **feet).count() > lengths.len();
        Answers { said, begun, in_feet, wrong: Vec::new() }
    }

    /// Every answer that was none.
    pub(super) fn wrong(self) -> Vec<Unusable> {
        self.wrong
    }

    /// What is said of a question.
    pub(super) fn said(&self, key: &str) -> Option<String> {
        (self.said)(key).map(|text| text.trim().to_owned()).filter(|text| !text.is_empty())
    }

    fn refuse<T: Default>(&mut self, key: &str, message: String, help: String) -> T {
        self.wrong.push(Unusable { key: key.to_owned(), severity: Severity::Error, message, help });
        T::default()
    }

    /// The answer to a question.
    pub(super) fn of(&mut self, question: &Question) -> Answer {
        match self.said(question.key) {
            Some(text) => self.value(question, question.key, &text),
            None if self.begun && question.assumed.is_empty() => {
                self.assumed(question, question.example, "an example to begin with")
            }
            None if question.assumed.is_empty() => {
                let help = format!("write {} with its unit, such as {}", question.key, question.example);
                self.refuse(question.key, format!("{} is missing", question.key), help)
            }
            None => self.assumed(question, question.assumed, "the survey says nothing"),
        }
    }

    /// A value that nobody gave; a length in feet where the others are, so that nobody is asked about a mixture.
    fn assumed(&mut self, question: &Question, value: &str, why: &str) -> Answer {
        let value = self.value(question, question.key, value);
        let text = if self.in_feet && question.unit == "m" { feet(value.si, 3) } else { value.text.clone() };
        Answer { text, assumed: why.to_owned(), ..value }
    }

    /// The answer to a question of which nothing is ever assumed.
    pub(super) fn measured(&mut self, question: &Question) -> Answer {
        let begun = std::mem::replace(&mut self.begun, false);
        let answer = self.of(question);
        self.begun = begun;
        answer
    }

    /// The answer to a question that may stay open.
    pub(super) fn maybe(&mut self, question: &Question) -> Option<Answer> {
        self.said(question.key).map(|text| self.value(question, question.key, &text))
    }

    /// Words that the file holds as they are, but for what ends a text there.
    pub(super) fn words(&self, key: &str) -> Option<String> {
        self.said(key).map(|text| plain(&text, 400)).filter(|text| !text.is_empty())
    }

    /// A material of the library that may lie over a ring.
    pub(super) fn fill(&mut self) -> Option<String> {
        let code = self.said("fill")?;
        let known = material::materials();
        let mut fitting = known.iter().filter(|one| one.fills("cover"));
        if fitting.clone().any(|one| one.code == code) {
            return Some(code);
        }
        let codes: Vec<&str> = fitting.by_ref().map(|one| one.code.as_str()).collect();
        let help = format!("the library has {}; extrados materials describes them", codes.join(", "));
        self.refuse("fill", format!("fill: there is no fill called \"{}\"", plain(&code, 40)), help)
    }

    /// What was looked for and is not there, in words: answers that leave no other trace in the file.
    pub(super) fn nothing(&self) -> Vec<&'static str> {
        let is = |key: &str, none: f64| {
            let said = self.said(key);
            said.is_some_and(|text| quantity::parse(&text).map_or(text.parse() == Ok(none), |one| one.number == none))
        };
        NOTHING.iter().filter(|(key, none, _)| is(key, *none)).map(|(_, _, words)| *words).collect()
    }

    /// The same of the k-th span or pier, which is as the first where the sheet does not say otherwise.
    pub(super) fn of_each(&mut self, question: &Question, first: &Answer, k: usize) -> Answer {
        let key = format!("{}_{k}", question.key);
        match self.said(&key).filter(|_| k > 1) {
            Some(text) => self.value(question, &key, &text),
            None if k == 1 => first.clone(),
            None => {
                let part = if question.key.starts_with("pier") { "pier" } else { "span" };
                Answer { assumed: format!("as {part} 1"), ..first.clone() }
            }
        }
    }

    /// A number of things, from 1.
    pub(super) fn count(&mut self, question: &Question, most: usize) -> usize {
        let text = self.said(question.key).unwrap_or_else(|| question.assumed.to_owned());
        match text.parse() {
            Ok(count) if (1..=most).contains(&count) => count,
            _ => {
                let key = question.key;
                self.refuse(
                    key,
                    format!("{key}: \"{text}\" is no whole number from 1 to {most}"),
                    format!("write {key} such as 3"),
                )
            }
        }
    }

    /// The rule that the bridge is judged by, and codes of vehicles: none for all that go with the rule.
    pub(super) fn judged(&mut self) -> Option<(String, Vec<String>)> {
        let code = |text: &str| text.chars().filter(|c| c.is_alphanumeric() || ".-_".contains(*c)).collect::<String>();
        let vehicles = self.said("vehicles").unwrap_or_default();
        let vehicles: Vec<String> = vehicles.split(',').map(code).filter(|code| !code.is_empty()).collect();
        match self.said("rule") {
            Some(rule) => Some((code(&rule), vehicles)),
            None if vehicles.is_empty() => None,
            None => self.refuse("rule", "rule is missing".to_owned(), "name the rule of these vehicles".to_owned()),
        }
    }

    fn value(&mut self, question: &Question, key: &str, said: &str) -> Answer {
        let text = match said.parse::<f64>() {
            Ok(_) => format!("{said} {}", question.unit),
            Err(_) => said.to_owned(),
        };
        let help = format!("write {key} with its unit, such as {}", question.example);
        let wanted =
            quantity::parse(question.example).map(|example| example.unit.dimension).unwrap_or(Dimension::Length);
        match quantity::parse(&text).map(|found| found.of(&[wanted]).unwrap_or(found)) {
            Ok(found) if found.unit.dimension == wanted && found.si().is_finite() => {
                // Feet and inches are written with marks that end a text in the file.
                let marked = text.contains(['"', '\\']);
                // To less than a thousandth of a millimetre.
                let text = if marked { feet(found.si(), 6) } else { text };
                Answer { key: key.to_owned(), text, si: found.si(), ..Answer::default() }
            }
            Ok(found) => {
                let (is, want) = (found.unit.dimension.name(), wanted.name());
                self.refuse(key, format!("{key}: \"{text}\" is {is} and not {want}"), help)
            }
            Err(_) => {
                let point = said.replacen(',', ".", 1);
                let comma =
                    point != said && point.split_whitespace().next().is_some_and(|one| one.parse::<f64>().is_ok());
                let help = if comma { format!("decimals have a point: write {key} as {point}") } else { help };
                self.refuse(key, format!("{key}: \"{text}\" is no number with a unit"), help)
            }
        }
    }
}
