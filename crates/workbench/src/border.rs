//! The border to JavaScript: who is told how far an analysis is, what is thrown, how the module begins and breaks.

use extrados::{Progress, Refusal, Watch, Wish};
use js_sys::{Error, Function, Reflect};
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    /// Who hears how far a long analysis is; one at a time, as functions do not overlap in a worker.
    static TELL: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// Hands progress to the page; `true` from there stops the work.
pub(crate) struct Telling;

impl Telling {
    pub(crate) fn to(function: &Function) -> Telling {
        TELL.with(|tell| tell.replace(Some(function.clone())));
        Telling
    }
}

impl Watch for Telling {
    fn look(&mut self, progress: &Progress) -> Wish {
        let fraction = JsValue::from_f64(progress.fraction.unwrap_or(f64::NAN));
        let said = TELL.with(|tell| {
            let tell = tell.borrow();
            tell.as_ref()
                .and_then(|tell| tell.call2(&JsValue::NULL, &JsValue::from_str(&progress.stage), &fraction).ok())
        });
        if said.and_then(|said| said.as_bool()) == Some(true) { Wish::Stop } else { Wish::GoOn }
    }
}

/// A refusal on its way to the page, where it is an exception.
#[derive(Debug)]
pub struct Thrown(pub Refusal);

impl<E: Into<Refusal>> From<E> for Thrown {
    fn from(error: E) -> Thrown {
        Thrown(error.into())
    }
}

impl From<Thrown> for JsValue {
    fn from(Thrown(refusal): Thrown) -> JsValue {
        let error = Error::new(&refusal.message);
        error.set_name("Refusal");
        for (key, text) in [("code", refusal.code), ("help", &refusal.help)] {
            let _ = Reflect::set(&error, &JsValue::from_str(key), &JsValue::from_str(text));
        }
        error.into()
    }
}

/// Begins: panics are told to this function before they end the instance.
#[wasm_bindgen]
pub fn start(on_panic: Function) {
    thread_local! {
        static ON_PANIC: RefCell<Option<Function>> = const { RefCell::new(None) };
    }
    ON_PANIC.with(|known| known.replace(Some(on_panic)));
    std::panic::set_hook(Box::new(|panic| {
        let words = JsValue::from_str(&panic.to_string());
        ON_PANIC
            .with(|known| known.try_borrow().ok().and_then(|known| known.as_ref()?.call1(&JsValue::NULL, &words).ok()));
    }));
}

/// The version.
#[wasm_bindgen]
pub fn build() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// Panics, for the test of what a page does then.
#[wasm_bindgen]
pub fn fail(words: &str) {
    panic!("{words}");
}
