//! Answers of a survey sheet as values of a bridge file.

use super::Question;
use crate::Severity;
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
}

/// A length [m] in feet, with at most so many decimals.
pub(super) fn feet(metres: f64, decimals: i32) -> String {
    let foot = Dimension::Length.units().find(|unit| unit.symbol == "ft").map_or(1.0, |unit| unit.size);
    let parts = 10_f64.powi(decimals);
    format!("{} ft", (metres / foot * parts).round() / parts)
}

impl Answer {
    /// Whether it is in feet, inches or yards.
    pub(super) fn imperial(&self) -> bool {
        quantity::parse(&self.text).is_ok_and(|found| found.unit.imperial())
    }

    /// One of so many equal parts of it.
    pub(super) fn share(&self, parts: usize) -> Answer {
        let si = self.si / parts as f64;
        let text = if self.imperial() { feet(si, 6) } else { format!("{} m", (1e6 * si).round() / 1e6) };
        Answer { text, si, ..self.clone() }
    }
}

/// What the sheet says, and what of it is no value.
pub(super) struct Answers<'a> {
    said: &'a dyn Fn(&str) -> Option<String>,
    wrong: Vec<Unusable>,
}

impl<'a> Answers<'a> {
    pub(super) fn new(said: &'a dyn Fn(&str) -> Option<String>) -> Self {
        Answers { said, wrong: Vec::new() }
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
            None if question.assumed.is_empty() => {
                let help = format!("write {} with its unit, such as {}", question.key, question.example);
                self.refuse(question.key, format!("{} is missing", question.key), help)
            }
            None => {
                let value = self.value(question, question.key, question.assumed);
                Answer { assumed: "the survey says nothing".to_owned(), ..value }
            }
        }
    }

    /// The answer to a question that may be left out.
    pub(super) fn optional(&mut self, question: &Question) -> Option<Answer> {
        self.said(question.key).map(|text| self.value(question, question.key, &text))
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
                Answer { key: key.to_owned(), text, si: found.si(), assumed: String::new() }
            }
            Ok(found) => {
                let (is, want) = (found.unit.dimension.name(), wanted.name());
                self.refuse(key, format!("{key}: \"{text}\" is {is} and not {want}"), help)
            }
            Err(_) => self.refuse(key, format!("{key}: \"{text}\" is no number with a unit"), help),
        }
    }
}
