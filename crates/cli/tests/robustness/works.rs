//! The commands that write results, on small bridges, and what a sound folder of results is.

use crate::stage::{Ending, Stage, numbers};
use crate::tiny::BRIDGE;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Two moduli sought, the file's own values being the start.
pub(crate) const SOUGHT: &str = r#"
[records]
place = "records.csv"
zero = false

[[parameter]]
quantity = "masonry.elastic_modulus"
name = "stone"
lower = "5 GPa"
upper = "20 GPa"

[[parameter]]
quantity = "fill.elastic_modulus"
name = "fill"
lower = "20 MPa"
upper = "300 MPa"

[update]
starts = 2
points = 5
"#;
/// A vehicle of one's own.
pub(crate) const LORRY: &str = "code = \"lorry\"\ntitle = \"Lorry\"\nways = \"road\"\n\
    source = { text = \"a plate\", date = \"2026\", confidence = \"assumed\" }\n\n[[vehicle]]\ncode = \"our-lorry\"\n\
    title = \"Lorry\"\naxle_loads_kn = [80.0, 110.0]\nspacings_m = [4.0]\naxles_may_be_dropped = true\n\
    wheel_track_m = 1.8\ncontact_length_m = 0.30\n\n[[under]]\nrule = \"cs-454\"\n\
    live_load = { value = 1.9, source = { text = \"as CS 454\", date = \"2020\", confidence = \"recalled\" } }\n\n\
    [under.impact]\nkind = \"critical-axle\"\n\
    factor = { value = 1.8, source = { text = \"as CS 454\", date = \"2001\", confidence = \"recalled\" } }\n";

/// A command that writes into a folder.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Work {
    /// Its name in tables.
    pub name: &'static str,
    /// Its words, without the folder.
    pub words: &'static [&'static str],
    /// What makes it go on where it was.
    pub resume: Option<&'static str>,
}

const fn work(name: &'static str, words: &'static [&'static str], resume: Option<&'static str>) -> Work {
    Work { name, words, resume }
}

/// Works of seconds and less.
pub(crate) const WORKS: [Work; 13] = [
    work("check", &["check", "tiny.toml"], None),
    work("collapse, limit", &["collapse", "tiny.toml", "--method", "limit"], None),
    work("collapse, path", &["collapse", "two/bridge.toml", "--method", "path"], Some("--resume")),
    work("collapse, dem", &["collapse", "mill/case-1.toml", "--keep-every", "0.02"], Some("--resume")),
    work("collapse --sweep", &["collapse", "two/bridge.toml", "--sweep", "--sweep-step", "0.5 m"], None),
    work("cases", &["cases", "cases.toml"], None),
    work("compare", &["compare", "tiny.toml", "other.toml"], None),
    work(
        "vary",
        &[
            "vary",
            "tiny.toml",
            "--method",
            "limit",
            "--set",
            "joint.friction_angle=26deg,28deg,30deg,32deg,36deg,40deg",
        ],
        None,
    ),
    work("respond", &["respond", "tiny.toml"], None),
    work("update", &["update", "update.toml"], Some("--resume")),
    work("assess", &["assess", "assess.toml"], Some("--resume")),
    work("assess of a folder", &["assess", "fleet"], Some("--resume")),
    work("validate", &["validate", "tests", "--methods", "weight"], None),
];

/// Works of many seconds.
pub(crate) const LONG: [Work; 2] = [
    work("collapse, particles", &["collapse", "fill.toml", "--keep-every", "0.1"], Some("--resume")),
    work("calibrate-fill", &["calibrate-fill", "grains.toml", "--seeds", "1"], None),
];

/// Those of some works that `EXTRADOS_WORKS` names, separated by commas; without it all.
pub(crate) fn asked_for(works: impl Iterator<Item = Work>) -> Vec<Work> {
    let asked = std::env::var("EXTRADOS_WORKS").ok();
    let names = |work: &Work| asked.as_ref().is_none_or(|names| names.split(',').any(|name| name.trim() == work.name));
    works.filter(names).collect()
}

/// A stage with everything that the works read.
pub(crate) fn prepared(name: &str) -> Stage {
    let stage = Stage::new(name);
    for (folder, example) in [("two", "two-span"), ("mill", "bridgemill"), ("drawing", "drawing")] {
        assert_eq!(stage.run(&["new", folder, "--from", example]).code, Some(0));
    }
    let truth = BRIDGE.replace("\"10 GPa\"", "\"13 GPa\"").replace("\"100 MPa\"", "\"170 MPa\"");
    stage.write("truth.toml", truth);
    assert_eq!(stage.run(&["respond", "truth.toml", "--out", "truth", "--quiet"]).code, Some(0));
    stage.write("records.csv", format!("# synthetic: twin\n{}", stage.read("truth/channels.csv")));
    let case = "\n[[case]]\nname = \"heavy\"\nmasonry_weight = 1.1\n\n[[case]]\nname = \"light\"\nfill_weight = 0.9\n";
    stage.write("tiny.toml", BRIDGE);
    stage.write("other.toml", BRIDGE.replace("\"0.5 m\"", "\"0.45 m\""));
    stage.write("cases.toml", format!("{BRIDGE}{case}"));
    stage.write("update.toml", format!("{BRIDGE}{SOUGHT}"));
    let asked = "\n[sweep]\nvehicles = [\"our-lorry\"]\nvehicle_files = [\"lorry.toml\"]\nrule = \"cs-454\"\n\
        \n[document]\n[[document.inspection]]\npart = \"barrel\"\nfinding = \"crack\"\n";
    stage.write("assess.toml", format!("{BRIDGE}{asked}"));
    stage.write("lorry.toml", LORRY);
    fs::create_dir_all(stage.folder.join("fleet")).expect("a folder");
    for (name, thickness) in [("a", "0.5 m"), ("b", "0.4 m"), ("c", "0.3 m")] {
        stage.write(&format!("fleet/{name}.toml"), BRIDGE.replace("\"0.5 m\"", &format!("\"{thickness}\"")));
    }
    let fill = include_str!("../../../../examples/bridgemill/case-3.toml");
    let fill = fill.replace("count = 1984", "count = 120").replace("load_limit = \"10 MN\"", "load_limit = \"250 kN\"");
    stage.write("fill.toml", fill);
    let grains =
        include_str!("../../../../examples/bridgemill/calibration.toml").replace("count = 1984", "count = 400");
    let (start, end) = (grains.find("compare_with").expect("moduli"), grains.find("[masonry]").expect("masonry"));
    let coarse = "multiples = [1, 4]\nsteps = 3\nignored_steps = 1\nseeds = 1\ntolerance = 0.5\n\n";
    stage.write("grains.toml", format!("{}{coarse}{}", &grains[..start], &grains[end..]));
    fs::create_dir_all(stage.folder.join("tests/prestwood")).expect("a folder");
    stage.write("tests/priors.toml", include_str!("../../../../validation/priors.toml"));
    stage.write("tests/prestwood/bridge.toml", include_str!("../../../../validation/prestwood/bridge.toml"));
    stage.write("tests/prestwood/test.toml", include_str!("../../../../validation/prestwood/test.toml"));
    stage
}

impl Work {
    /// The command line that writes into a folder.
    pub(crate) fn line<'a>(&'a self, out: &'a str, again: bool) -> Vec<&'a str> {
        let resumed = self.resume.filter(|_| again);
        self.words.iter().copied().chain(["--out", out, "--json", "--quiet"]).chain(resumed).collect()
    }
}

/// The answer of a run that nobody disturbed.
pub(crate) struct Whole {
    pub code: Option<i32>,
    numbers: Value,
    tables: Vec<(String, Vec<u8>)>,
}

impl Whole {
    /// Runs a work without disturbance.
    pub(crate) fn of(stage: &Stage, work: &Work) -> Whole {
        let _ = fs::remove_dir_all(stage.folder.join("whole"));
        let ending = stage.run(&work.line("whole", false));
        assert!(matches!(ending.code, Some(0 | 1 | 3)), "{}: {} {}", work.name, ending.stdout, ending.stderr);
        let value: Value = serde_json::from_str(&ending.stdout).expect("one object");
        Whole { code: ending.code, numbers: of_result(value), tables: tables(&stage.folder.join("whole")) }
    }

    /// In what another run of the same differs; nothing where it does not.
    pub(crate) fn differs(&self, ending: &Ending, folder: &Path) -> Option<String> {
        if ending.code != self.code {
            return Some(format!("exit code {:?} for {:?}: {}", ending.code, self.code, ending.stderr));
        }
        let Ok(value) = serde_json::from_str::<Value>(&ending.stdout) else {
            return Some(format!("no object: {}", ending.stdout));
        };
        if let Some(place) = difference(&of_result(value), &self.numbers) {
            return Some(format!("another value at {place}"));
        }
        for (name, bytes) in &self.tables {
            if fs::read(folder.join(name)).ok().as_ref() != Some(bytes) {
                return Some(format!("{name} is another one"));
            }
        }
        None
    }
}

/// Fields that tell how a result came about: what was taken up, what was computed, in what time.
const CAME_ABOUT: [&str; 7] =
    ["stages", "evaluations_taken_up", "evaluations_computed", "runs_from_cache", "cache", "cached", "seconds"];

/// What is of the result, and not of how it came about.
fn of_result(value: Value) -> Value {
    let mut value = numbers(value);
    without(&mut value, &CAME_ABOUT);
    value
}

/// Where one value first differs from another, and how.
fn difference(one: &Value, other: &Value) -> Option<String> {
    let below = |key: &str, one: Option<&Value>, other: Option<&Value>| {
        let null = Value::Null;
        difference(one.unwrap_or(&null), other.unwrap_or(&null)).map(|place| format!("{key}/{place}"))
    };
    match (one, other) {
        (Value::Object(a), Value::Object(b)) => {
            a.keys().chain(b.keys()).find_map(|key| below(key, a.get(key), b.get(key)))
        }
        (Value::Array(a), Value::Array(b)) => {
            (0..a.len().max(b.len())).find_map(|k| below(&k.to_string(), a.get(k), b.get(k)))
        }
        _ => (one != other).then(|| format!(": {one} for {other}")),
    }
}

/// The value without these keys, wherever they stand.
fn without(value: &mut Value, keys: &[&str]) {
    match value {
        Value::Object(fields) => {
            keys.iter().for_each(|key| drop(fields.remove(*key)));
            fields.values_mut().for_each(|inner| without(inner, keys));
        }
        Value::Array(items) => items.iter_mut().for_each(|inner| without(inner, keys)),
        _ => {}
    }
}

/// Tables and workbooks of a folder of results.
fn tables(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).expect("results").flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let kept = names.filter(|name| name.ends_with(".csv") || name.ends_with(".xlsx"));
    kept.map(|name| (name.clone(), fs::read(folder.join(&name)).expect("a table"))).collect()
}

/// Whether a folder holds a whole answer: its seal, and every file that the seal names; in its place, or complete on the way there.
pub(crate) fn is_sealed(folder: &Path) -> Result<bool, String> {
    let ready = folder.join(".extrados-ready");
    for (place, other) in [(folder, None), (ready.as_path(), Some(folder))] {
        let Ok(bytes) = fs::read(place.join("result.json")) else { continue };
        let value: Value = serde_json::from_slice(&bytes).map_err(|error| format!("result.json is torn: {error}"))?;
        let named = value["files"].as_array().into_iter().flatten().filter_map(Value::as_str);
        let there = |name: &str| place.join(name).is_file() || other.is_some_and(|other| other.join(name).is_file());
        return match named.into_iter().find(|name| !there(name)) {
            Some(name) => Err(format!("{name} is missing beside its seal")),
            None => Ok(true),
        };
    }
    Ok(false)
}

/// Files that are there for a while only, and outlived their run.
pub(crate) fn left_over(folder: &Path) -> Vec<String> {
    let own = format!("..{}.", folder.file_name().unwrap_or_default().to_string_lossy());
    let names = |place: &Path| {
        let entries = fs::read_dir(place).into_iter().flatten().flatten();
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect::<Vec<_>>()
    };
    let inside = names(folder).into_iter().filter(|name| name.contains(".extrados-"));
    let beside = names(folder.parent().unwrap_or(folder)).into_iter().filter(|name| name.starts_with(&own));
    inside.chain(beside).filter(|name| !name.ends_with("extrados-files.json")).collect()
}
