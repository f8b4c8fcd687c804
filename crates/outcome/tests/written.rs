//! A page and types that are made from the keys of results: `EXTRADOS_WRITE_DOCS=1 cargo test -p outcome --test written` writes them anew.

use bridge::Method;
use outcome::wire::Key;
use outcome::{
    assessment, calibration, checked, collapse, condition, help, passage, picture, plan, study, sweep, update,
    validation, vehicles,
};

/// A struct and its keys; a command's object by the name of its schema, others by their own or another title.
type Told = (&'static str, &'static str, fn(&mut Vec<Key>));

macro_rules! told { ($($module:ident::$Name:ident $(= $title:literal)?,)*) => {
    &[$((concat!(stringify!($module), "::", stringify!($Name)), [$($title,)? stringify!($Name)][0], $module::$Name::keys)),*]
} }

/// Objects of commands; Python has a class for each of the first seven.
const RESULTS: &[Told] = told! {
    collapse::Collapse = "extrados.collapse/1", sweep::Sweep = "extrados.sweep/1", vehicles::VehicleSweep = "extrados.vehicle-sweep/1",
    passage::Passage = "extrados.respond/1", update::Update = "extrados.update/1", study::Study = "extrados.vary/1",
    assessment::Assessment = "extrados.assess/1", validation::Validation = "extrados.validate/1",
    calibration::CalibrationReport = "extrados.calibrate-fill/1",
};

/// Objects within them.
const WITHIN: &[Told] = told! {
    help::WithHelp, picture::Hinge, picture::ThrustPoint, assessment::Step, picture::Step = "Load step", collapse::AskedAxles, collapse::Permissible,
    collapse::PackingReport, collapse::Combination, collapse::Component, sweep::SweepPoint, vehicles::Swept, vehicles::Case,
    vehicles::Weights, vehicles::EnvelopePoint, vehicles::PermissibleFactor, vehicles::SectionEnvelope, vehicles::Extreme, vehicles::Graded,
    vehicles::ByDiscreteElements, passage::SensorRecord, passage::Moment, update::SearchLine, update::RunUsed, plan::LoadTestPlan = "Load test plan", plan::Telling, checked::Comparison,
    condition::Condition, validation::Tested, validation::Prediction, validation::Bias, validation::LeftOut, calibration::At,
    calibration::Measured, calibration::Sheared,
};

/// Types that are objects, with keys that stand where they are published; other types without keys here are words.
const OBJECTS: &str = "ChangedFactor Columns ModelFactor Object Point PosteriorReport Record RecordsUsed Rule Source Spread Statics Value \
                       Varied Warning";

/// Type of a value by its type in Rust: in words, and in Python.
fn types(rust: &str) -> [String; 2] {
    let within = |start: &str| rust.strip_prefix(start)?.strip_suffix([']', '>']);
    if let Some([words, python]) = within("Option<").map(types) {
        return [words + " or null", python + " | None"];
    }
    if let Some(inner) = within("Box<") {
        return types(inner);
    }
    if let Some([words, python]) = within("Vec<").or_else(|| within("[")?.split(';').next()).map(types) {
        return [format!("list ({words})"), format!("list[{python}]")];
    }
    let named = |one: &&Told| one.0 == rust || one.0.rsplit("::").next() == Some(rust);
    let object = "dict[str, Any]";
    let [words, python] = match rust {
        "f64" => ["number", "float"],
        "u32" | "u64" | "usize" => ["whole number", "int"],
        "bool" => ["true or false", "bool"],
        _ if OBJECTS.split(' ').any(|one| one == rust) || rust.starts_with('(') => ["object", object],
        _ => match RESULTS.iter().chain(WITHIN).find(named) {
            Some(told) => return [format!("[{}](#{})", told.1, anchor(told.1)), object.to_owned()],
            None => ["text", "str"],
        },
    };
    [words, python].map(str::to_owned)
}

fn anchor(title: &str) -> String {
    title.to_lowercase().replace(['.', '/'], "").replace(' ', "-")
}

/// Keys, each once, with what they mean in their published units, and these.
fn keys((.., of): &Told) -> Vec<(Key, String, String)> {
    let (mut all, mut once) = (Vec::new(), Vec::<(Key, String, String)>::new());
    of(&mut all);
    for key in all {
        if once.iter().all(|known| known.0.name != key.name) {
            let si = ["N/m", "N", "m", "Pa", "s", "rad", "m/s", "SI"].map(|unit| format!(" [{unit}]"));
            let about = si.iter().fold(key.about.to_owned(), |about, unit| about.replace(unit, ""));
            let unit = if key.unit.is_empty() { String::new() } else { format!(" [{}]", key.unit) };
            once.push((key, about, unit));
        }
    }
    once
}

fn page() -> String {
    let mut page = String::from(
        "# Keys of results\n\n<!-- Made from the results themselves: EXTRADOS_WRITE_DOCS=1 cargo test -p outcome --test written -->\n\nEvery object also has \
         what [the command](command.md#one-object) adds to it. What is \"where it applies\" is left out elsewhere.\n",
    );
    for told in RESULTS.iter().chain(WITHIN) {
        page += &format!("\n## {}\n\n| key | value | |\n|---|---|---|\n", told.1);
        for (key, about, unit) in keys(told) {
            let applies = if key.optional { ", where it applies" } else { "" };
            page += &format!("| `{}` | {}{unit}{applies} | {about} |\n", key.name, types(key.of)[0]);
        }
    }
    page
}

/// Keys that every result of Python has.
const COMMON: [&str; 5] = ["schema", "status", "bridge", "assumptions", "warnings"];

fn classes() -> String {
    let mut text = String::from(
        "\"\"\"Fields of results. Made from the results themselves: EXTRADOS_WRITE_DOCS=1 cargo test -p outcome --test written\"\"\"\n\nfrom \
         __future__ import annotations\n\nfrom typing import Any, Literal\n",
    );
    let all = |of: fn(Method) -> &'static str, between: &str| {
        Method::ALL.iter().map(|one| of(*one)).collect::<Vec<_>>().join(between)
    };
    text += &format!("\nMethod = Literal[\"{}\"]\n", all(Method::word, "\", \""));
    text += &format!("\"\"\"Methods: {}.\"\"\"\n", all(Method::name, ", "));
    for told in &RESULTS[..7] {
        let name = told.0.rsplit("::").next().unwrap_or(told.0);
        text += &format!("\n\nclass {name}:\n    \"\"\"Fields of `{}`.\"\"\"\n\n", told.1);
        for (key, about, unit) in keys(told).iter().filter(|told| !COMMON.contains(&told.0.name.as_str())) {
            text += &format!("    {}: {}\n", key.name, types(key.of)[1]);
            if !about.is_empty() {
                text += &format!("    \"\"\"{}{unit}.\"\"\"\n", about.trim_end_matches('.'));
            }
        }
    }
    text
}

#[test]
fn the_page_and_the_types_are_as_the_results_are() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for (place, fresh) in [("docs/results.md", page()), ("python/extrados/_keys.py", classes())] {
        let path = root.join(place);
        if std::env::var_os("EXTRADOS_WRITE_DOCS").is_some() {
            std::fs::write(&path, &fresh).expect("it is written");
        }
        let written = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(written == fresh, "{place} is out of date: EXTRADOS_WRITE_DOCS=1 cargo test -p outcome --test written");
    }
}
