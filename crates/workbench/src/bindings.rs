//! What a page calls: the functions of this crate with JavaScript's types. Nothing is decided here.

// The functions that the macro makes for the host are unsafe by their nature; none is written by hand.
#![allow(unsafe_code)]
// JavaScript hands over owned texts.
#![allow(clippy::needless_pass_by_value)]

use crate::{analyses, cards, document, live, reading, records as measured, result, stepped, train};
use extrados::bridge::schema as schemas;
use extrados::{Progress, Watch, Wish};
use js_sys::{Error, Function, Reflect};
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    /// Who hears how far a long analysis is; one at a time, as functions do not overlap in a worker.
    static TELL: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// Hands progress to the page; `true` from there stops the work.
struct Telling;

impl Telling {
    fn to(function: &Function) -> Telling {
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

/// A refusal as an exception.
fn thrown(refusal: extrados::Refusal) -> JsValue {
    let error = Error::new(&refusal.message);
    error.set_name("Refusal");
    for (key, text) in [("code", refusal.code), ("help", &refusal.help)] {
        let _ = Reflect::set(&error, &JsValue::from_str(key), &JsValue::from_str(text));
    }
    error.into()
}

type Thrown<T> = Result<T, JsValue>;

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

/// A file of an example.
///
/// # Errors
/// Those of [`cards::example_file`], as an exception.
#[wasm_bindgen]
pub fn example_file(example: &str, file: &str) -> Thrown<Vec<u8>> {
    cards::example_file(example, file).map_err(thrown)
}

/// Vehicles and rules.
///
/// # Errors
/// Those of [`cards::library`], as an exception.
#[wasm_bindgen]
pub fn library() -> Thrown<String> {
    cards::library().map(|library| library.to_string()).map_err(thrown)
}

/// The text of a bridge file with a table filled from a material of the library.
///
/// # Errors
/// Those of [`extrados::with_material`], as an exception.
#[wasm_bindgen]
pub fn with_material(text: &str, table: &str, material: &str, keys: Vec<String>) -> Thrown<String> {
    let keys: Vec<&str> = keys.iter().map(String::as_str).collect();
    extrados::with_material(text, table, material, &keys).map_err(thrown)
}

/// A bridge file from answers.
///
/// # Errors
/// Those of [`cards::from_survey`], as an exception.
#[wasm_bindgen]
pub fn from_survey(answers: &str) -> Thrown<String> {
    cards::from_survey(answers).map_err(thrown)
}

/// What is wrong with answers or doubtful, each at its key.
///
/// # Errors
/// Those of [`cards::survey_findings`], as an exception.
#[wasm_bindgen]
pub fn survey_findings(answers: &str) -> Thrown<String> {
    cards::survey_findings(answers).map(|found| found.to_string()).map_err(thrown)
}

/// A block model file from a drawing.
///
/// # Errors
/// Those of [`cards::from_drawing`], as an exception.
#[wasm_bindgen]
pub fn from_dxf(name: &str, bytes: &[u8]) -> Thrown<String> {
    cards::from_drawing(name, bytes).map_err(thrown)
}

/// Measured channels.
#[wasm_bindgen]
pub fn records(name: &str, bytes: &[u8]) -> String {
    measured::records(name, bytes).to_string()
}

/// One bridge with the files beside it.
#[wasm_bindgen]
pub struct Document(document::Document);

#[wasm_bindgen]
impl Document {
    /// Of a text at a path.
    #[wasm_bindgen(constructor)]
    pub fn new(path: &str, text: &str) -> Document {
        Document(document::Document::new(path, text))
    }

    /// A file beside it.
    pub fn put(&mut self, path: &str, bytes: Vec<u8>) {
        self.0.put(path, bytes);
    }

    /// Takes a file beside it away.
    #[wasm_bindgen(js_name = drop)]
    pub fn take_away(&mut self, path: &str) {
        self.0.take_away(path);
    }

    /// Another text.
    pub fn set_text(&mut self, text: &str) {
        self.0.set_text(text);
    }

    /// The text.
    pub fn text(&self) -> String {
        self.0.text().to_owned()
    }

    /// Findings.
    pub fn reading(&self) -> String {
        self.0.reading().to_string()
    }

    /// The bridge as built.
    pub fn picture(&self) -> String {
        serde_json::to_string(&self.0.picture()).unwrap_or_else(|_| "null".to_owned())
    }

    /// The same as SVG.
    pub fn drawing(&self) -> String {
        self.0.drawing()
    }

    /// Values with units, ranges and places.
    pub fn quantities(&self) -> String {
        self.0.quantities().to_string()
    }

    /// Writes one value.
    ///
    /// # Errors
    /// Those of [`document::Document::set`], as an exception.
    pub fn set(&mut self, path: &str, literal: &str) -> Thrown<()> {
        self.0.set(path, literal).map_err(thrown)
    }
}

/// What an analysis gave.
#[wasm_bindgen(js_name = Result)]
pub struct Outcome(result::Answer);

#[wasm_bindgen(js_class = Result)]
impl Outcome {
    /// How it ended.
    #[wasm_bindgen(getter)]
    pub fn status(&self) -> String {
        self.0.status().to_owned()
    }

    /// result.json.
    #[wasm_bindgen(getter)]
    pub fn json(&self) -> String {
        self.0.json()
    }

    /// What figures are made from.
    #[wasm_bindgen(getter)]
    pub fn picture(&self) -> String {
        self.0.picture()
    }

    /// The passage.
    #[wasm_bindgen(getter)]
    pub fn passage(&self) -> String {
        self.0.whole_passage()
    }

    /// The drawings.
    #[wasm_bindgen(getter)]
    pub fn figures(&self) -> String {
        self.0.figures()
    }

    /// Names of all files.
    pub fn files(&self) -> String {
        serde_json::json!(self.0.names()).to_string()
    }

    /// One of them.
    ///
    /// # Errors
    /// Those of [`result::Answer::file`], as an exception.
    pub fn file(&self, name: &str) -> Thrown<Vec<u8>> {
        self.0.file(name).map_err(thrown)
    }

    /// All of them.
    ///
    /// # Errors
    /// Those of [`result::Answer::zip`], as an exception.
    pub fn zip(&self) -> Thrown<Vec<u8>> {
        self.0.zip().map_err(thrown)
    }
}

/// Whole analyses: what each takes beside the document and who is told how far it is.
macro_rules! analysed { ($($(#[$about:meta])* $name:ident($($with:ident: $(&$Text:ident)? $($Number:ident)?),*);)*) => { $(
    $(#[$about])*
    ///
    /// # Errors
    /// Those of the function of this name in [`analyses`], as an exception.
    #[wasm_bindgen]
    pub fn $name(document: &Document, $($with: $(&$Text)? $($Number)?,)* tell: &Function) -> Thrown<Outcome> {
        analyses::$name(&document.0, $($with,)* &mut Telling::to(tell)).map(Outcome).map_err(thrown)
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

/// What a page reads of a thing as it is: functions of its own, or properties.
macro_rules! read { ($Thing:ident: $($(#[$about:meta])* $name:ident -> $Type:ty;)*) => {
    #[wasm_bindgen]
    impl $Thing { $(
        $(#[$about])*
        pub fn $name(&self) -> $Type {
            self.0.$name()
        }
    )* }
} }

/// A load under the pointer.
#[wasm_bindgen]
pub struct Placing(live::Placing);

#[wasm_bindgen]
impl Placing {
    /// The bridge prepared once.
    ///
    /// # Errors
    /// Those of [`live::Placing::new`], as an exception.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Document, vehicle: &str, rule: &str, leftward: bool) -> Thrown<Placing> {
        live::Placing::new(&document.0, vehicle, rule, leftward).map(Placing).map_err(thrown)
    }

    /// What is put where.
    pub fn about(&self) -> String {
        self.0.about().to_string()
    }

    /// What is carried at a place, and how.
    pub fn at(&mut self, x: f64) -> Answer {
        Answer(self.0.at(x))
    }

    /// The same with dilatant friction alone.
    pub fn quickly(&mut self, x: f64) -> Answer {
        Answer(self.0.quickly(x))
    }

    /// What is carried at a place.
    pub fn factor(&mut self, x: f64) -> Vec<f64> {
        self.0.factor(x).to_vec()
    }

    /// The zone of the line of thrust.
    ///
    /// # Errors
    /// Those of [`live::Placing::zone`], as an exception.
    pub fn zone(&mut self, x: f64, factor: f64) -> Thrown<Vec<f64>> {
        self.0.zone(x, factor).map_err(thrown)
    }
}

/// What is carried at a place, for drawing.
#[wasm_bindgen]
pub struct Answer(live::Answer);

#[wasm_bindgen]
impl Answer {
    /// Everything but geometry.
    #[wasm_bindgen(getter)]
    pub fn json(&self) -> String {
        self.0.json().to_string()
    }
}

read! { Answer:
    /// Points of the lines of thrust.
    #[wasm_bindgen(getter)]
    thrust -> Vec<f64>;
    /// Where each line begins.
    #[wasm_bindgen(getter)]
    thrust_starts -> Vec<u32>;
    /// Motion of each shape.
    #[wasm_bindgen(getter)]
    mechanism -> Vec<f64>;
    /// Centroid of each shape.
    #[wasm_bindgen(getter)]
    centroids -> Vec<f64>;
    /// Forces on the blocks.
    #[wasm_bindgen(getter)]
    loads -> Vec<f64>;
    /// What stands on the road.
    #[wasm_bindgen(getter)]
    axles -> Vec<f64>;
}

/// The block engine, a few steps at a time.
#[wasm_bindgen]
pub struct Stepping(stepped::Stepping);

#[wasm_bindgen]
impl Stepping {
    /// The bridge with its loads.
    ///
    /// # Errors
    /// Those of [`stepped::Stepping::new`], as an exception.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Document, choice: &str, tell: &Function) -> Thrown<Stepping> {
        stepped::Stepping::new(&document.0, choice, &mut Telling::to(tell)).map(Stepping).map_err(thrown)
    }

    /// Goes on.
    pub fn advance(&mut self, steps: u32) -> String {
        self.0.advance(steps).to_owned()
    }

    /// Goes back, or on, to a state.
    ///
    /// # Errors
    /// Those of [`stepped::Stepping::restore`], as an exception.
    pub fn restore(&mut self, state: &[u8]) -> Thrown<()> {
        self.0.restore(state).map_err(thrown)
    }

    /// Steps so far.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> f64 {
        self.0.progress().0 as f64
    }

    /// Out-of-balance force over acting force.
    #[wasm_bindgen(getter)]
    pub fn unbalanced(&self) -> f64 {
        self.0.progress().1
    }

    /// Shapes and particles before they moved.
    pub fn picture(&self) -> String {
        serde_json::to_string(self.0.picture()).unwrap_or_else(|_| "null".to_owned())
    }
}

read! { Stepping:
    /// The state as bytes.
    state -> Vec<u8>;
    /// The load that acts.
    #[wasm_bindgen(getter)]
    load -> f64;
    /// Poses of the shapes.
    poses -> Vec<f64>;
    /// Centroids as built.
    centroids -> Vec<f64>;
    /// The particles.
    particles -> Vec<f32>;
    /// Contacts of blocks.
    contacts -> Vec<f32>;
    /// Contacts of particles.
    chains -> Vec<f32>;
    /// Stresses of the shapes.
    stresses -> Vec<f32>;
    /// Load and displacement.
    path -> Vec<f64>;
}

/// A train, a few positions at a time.
#[wasm_bindgen]
pub struct Passing(train::Passing);

#[wasm_bindgen]
impl Passing {
    /// The bridge under its own weight.
    ///
    /// # Errors
    /// Those of [`train::Passing::new`], as an exception.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &Document, tell: &Function) -> Thrown<Passing> {
        train::Passing::new(&document.0, &mut Telling::to(tell)).map(Passing).map_err(thrown)
    }

    /// Moves the train on.
    ///
    /// # Errors
    /// Those of [`train::Passing::advance`], as an exception.
    pub fn advance(&mut self, positions: u32) -> Thrown<String> {
        self.0.advance(positions).map(str::to_owned).map_err(thrown)
    }

    /// Positions in all.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> u32 {
        self.0.counts()[0] as u32
    }

    /// Positions that are done.
    #[wasm_bindgen(getter)]
    pub fn done(&self) -> u32 {
        self.0.counts()[1] as u32
    }

    /// What is recorded.
    pub fn sensors(&self) -> String {
        self.0.sensors().to_string()
    }

    /// The mesh.
    pub fn mesh(&self) -> String {
        self.0.mesh().to_string()
    }

    /// The passage as a whole.
    ///
    /// # Errors
    /// Those of [`train::Passing::finish`], as an exception.
    pub fn finish(self, tell: &Function) -> Thrown<Outcome> {
        self.0.finish(&mut Telling::to(tell)).map(Outcome).map_err(thrown)
    }
}

read! { Passing:
    /// Times and places.
    places -> Vec<f64>;
    /// Values of the sensors.
    values -> Vec<f64>;
    /// Displacements of the nodes.
    displacements -> Vec<f32>;
    /// Pairs of facing points.
    joints -> Vec<f32>;
    /// Stresses of the quadrilaterals.
    stresses -> Vec<f32>;
    /// Axles above the mesh.
    axles -> Vec<f64>;
}
