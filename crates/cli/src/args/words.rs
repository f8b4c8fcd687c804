//! Values on the command line: one of several words, or a number within bounds.

use bridge::choice::Choice as Words;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use outcome::validation::Predictor;
use verification::footing::Ground;

/// A word on the command line, what it means there, and what it stands for.
type Word<T> = (&'static str, &'static str, T);

/// Every word of a key of bridge files or of another list, with what is said of it there.
fn listed<T: Words>() -> impl Iterator<Item = Word<T>> {
    T::WORDS.iter().zip(T::VALUES).map(|(choice, value)| (choice.word, choice.doc, *value))
}

/// One of these words.
pub(super) fn word<T: Words + Send + Sync>() -> impl TypedValueParser<Value = T> {
    one_of(listed::<T>().collect())
}

/// A ground that yields.
pub(super) fn ground() -> impl TypedValueParser<Value = Ground> {
    one_of(listed::<Ground>().filter(|(.., ground)| *ground != Ground::Elastic).collect())
}

/// A method of `validate` by its word.
pub(super) fn predictor() -> impl TypedValueParser<Value = Predictor> {
    one_of(Predictor::ALL.iter().map(|one| (one.word(), one.about(), *one)).collect())
}

/// Takes one of these words for what it stands for.
fn one_of<T: Copy + Send + Sync + 'static>(words: Vec<Word<T>>) -> impl TypedValueParser<Value = T> {
    let known: Vec<PossibleValue> = words.iter().map(|(word, about, _)| PossibleValue::new(word).help(about)).collect();
    PossibleValuesParser::new(known)
        .map(move |said| words.iter().find(|(word, ..)| *word == said).expect("only these words pass").2)
}

pub(super) fn seconds(text: &str) -> Result<f64, String> {
    number(text, |seconds| (0.0..=1e6).contains(&seconds), "write a number of seconds, such as 2")
}

pub(super) fn times(text: &str) -> Result<f64, String> {
    number(text, |times| times > 0.0 && times <= 1e6, "write a positive number, such as 50")
}

pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    let fits = |ratio| ratio > 0.0 && ratio <= 0.1;
    number(text, fits, "the tolerance is a ratio above 0 and up to 0.1, such as 1e-5")
}

fn number(text: &str, fits: impl FnOnce(f64) -> bool, help: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number: &f64| fits(*number)).ok_or_else(|| help.to_owned())
}
