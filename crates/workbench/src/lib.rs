//! The engine of the workbench: Extrados behind functions that a page calls in a worker. `workbench/PROTOCOL.md` says what crosses the
//! border and how; this crate is no interface for other programs, which take the crate `extrados`.
//!
//! Everything here works on texts and numbers and runs natively too. What bears `#[wasm_bindgen]` is what the page calls; [`border`]
//! alone speaks to JavaScript.

// The functions that the macro makes for the host are unsafe by their nature; none is written by hand.
#![allow(unsafe_code)]

pub mod analyses;
pub mod bindings;
pub mod border;
pub mod cards;
pub mod document;
pub mod live;
pub mod reading;
pub mod records;
pub mod result;
pub mod stepped;
pub mod train;

use extrados::Refusal;

/// Several refusals as one, which is what an exception can carry.
pub(crate) fn one(refusals: Vec<Refusal>) -> Refusal {
    let code = refusals.first().map_or("F108", |first| first.code);
    let message: Vec<&str> = refusals.iter().map(|refusal| refusal.message.as_str()).collect();
    let help = refusals.first().map_or("", |first| first.help.as_str());
    Refusal::new(code, message.join("; "), help)
}
