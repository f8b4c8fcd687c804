//! Whole analyses as the page calls them. Nothing is decided here.

use crate::analyses;
use crate::border::{Telling, Thrown};
use crate::document::Document;
use crate::result::Outcome;
use js_sys::Function;
use wasm_bindgen::prelude::*;

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
    /// Another bridge, and this one beside it.
    compare(before: &Document, choice: &str);
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
