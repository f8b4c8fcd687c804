//! What a page calls that takes or gives other types than JavaScript's elsewhere. Nothing is decided here.

use crate::border::{Telling, Thrown};
use crate::document::Document;
use crate::result::Outcome;
use crate::{analyses, cards, reading};
use extrados::bridge::schema as schemas;
use js_sys::Function;
use wasm_bindgen::prelude::*;

/// What the engine knows and reads, as JSON texts.
macro_rules! texts { ($($(#[$about:meta])* $name:ident($($with:ident: &$Text:ident),*) = $value:expr;)*) => { $(
    $(#[$about])*
    #[wasm_bindgen]
    pub fn $name($($with: &$Text),*) -> String {
        $value.to_string()
    }
)* } }

texts! {
    /// The examples.
    examples() = cards::list_of_examples();
    /// The JSON Schema of bridge files.
    schema() = schemas::schema();
    /// The cards of all keys.
    keys() = cards::keys();
    /// The card of a code.
    explain(code: &str) = cards::explained(code);
    /// Every card.
    codes() = cards::codes();
    /// Materials with their values, ends and sources.
    materials() = cards::materials();
    /// Where a text says what a path names, or "null".
    place(text: &str, path: &str) = reading::place(text, path);
    /// The ten numbers of a survey.
    survey_questions() = cards::survey_questions();
}

/// The text of a bridge file with a table filled from a material of the library.
///
/// # Errors
/// Those of [`extrados::with_material`], as an exception.
#[wasm_bindgen]
pub fn with_material(text: &str, table: &str, material: &str, keys: Vec<String>) -> Result<String, Thrown> {
    let keys: Vec<&str> = keys.iter().map(String::as_str).collect();
    Ok(extrados::with_material(text, table, material, &keys)?)
}

/// Whole analyses: what each takes beside the document and who is told how far it is.
macro_rules! analysed { ($($(#[$about:meta])* $name:ident($($with:ident: $(&$Text:ident)? $($Number:ident)?),*);)*) => { $(
    $(#[$about])*
    ///
    /// # Errors
    /// Those of the function of this name in [`analyses`], as an exception.
    #[wasm_bindgen]
    pub fn $name(document: &Document, $($with: $(&$Text)? $($Number)?,)* tell: &Function) -> Result<Outcome, Thrown> {
        Ok(analyses::$name(document, $($with,)* &mut Telling::to(tell))?)
    }
)* } }

analysed! {
    /// The load that makes a mechanism.
    collapse(choice: &str);
    /// Loads or vehicles at every position.
    sweep(choice: &str, step: f64);
    /// Every named case.
    cases(choice: &str);
    /// The passage of a train.
    respond();
    /// Parameters from records.
    update();
    /// The records alone.
    judge();
    /// The collapse over ranges.
    vary(settings: &str, choice: &str);
    /// Each quantity a tenth down and up.
    tornado(paths: &str, choice: &str);
    /// The whole chain; the day as year-month-day stands in the report.
    assess(day: &str);
}
