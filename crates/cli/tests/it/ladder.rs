//! Verdicts that nobody can flatter: one change of a bridge that CS 454 turns down, or passes, and what is said then.

use crate::stage::{Ending, Stage};
use serde_json::Value;

/// A road bridge of 5 m, everything that CS 454 asks for.
pub(crate) const BASE: &str = r#"[bridge]
name = "Base"
width = "6.0 m"
[[span]]
profile = "segmental"
span = "5.0 m"
rise = "1.25 m"
thickness = "0.45 m"
voussoirs = 31
[masonry]
density = "2200 kg/m^3"
compressive_strength = "8 MPa"
[joint]
friction_angle = "33 deg"
cohesion = "0 kPa"
[[cover]]
layer = "fill"
thickness = "0.40 m"
density = "1900 kg/m^3"
[[cover]]
layer = "surfacing"
thickness = "0.10 m"
density = "2300 kg/m^3"
[carriageway]
lanes = 2
edge_distance = "0.6 m"
skew = "0 deg"
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
name = "axle"
kind = "axle"
axle_force = "100 kN"
contact_length = "0.3 m"
effective_width = "3 m"
at = "1/4 of span 1"
[sweep]
rule = "cs-454"
vehicles = ["cs-454"]
step = "0.25 m"
[assess]
source = "CS 454"
"#;

/// The base with a change, assessed; further words of the command.
fn judged(name: &str, changes: &[[&str; 2]], files: &[(&str, &str)], words: &[&str]) -> (Stage, Value, Ending) {
    let stage = Stage::new(name);
    let mut text = BASE.to_owned();
    for [from, to] in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    stage.write("bridge.toml", text);
    files.iter().for_each(|(file, text)| stage.write(file, *text));
    let command = [&["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"], words].concat();
    let (answer, ending) = stage.object(&command);
    (stage, answer, ending)
}

fn head(answer: &Value) -> &str {
    answer["head"].as_str().unwrap_or_default()
}

/// A ring that CS 454 turns down.
const THIN: [&str; 2] = ["thickness = \"0.45 m\"", "thickness = \"0.30 m\""];
/// A load of the file that any bridge carries, with a factor that names a source.
const LIGHT: [[&str; 2]; 2] = [
    ["axle_force = \"100 kN\"", "axle_force = \"20 kN\""],
    ["source = \"CS 454\"", "source = \"CS 454\"\nadequacy_factor = 1.9\nadequacy_source = \"CS 454, 7.3\""],
];

/// The standard's own factors are met, and no factor of the program comes on top: adequate, by name.
#[test]
fn a_sound_bridge_passes_by_the_standard() {
    let (_, answer, ending) = judged("ladder-base", &[], &[], &[]);
    assert_eq!((ending.code, &answer["status"], &answer["by"]), (Some(0), &"adequate".into(), &"cs-454".into()));
    assert!(head(&answer).starts_with("Adequate by CS 454 (") && head(&answer).contains("to be confirmed"), "{answer}");
    assert_eq!(answer["record"]["tests"], 7, "{answer}");
    // With the model factor of tests, on purpose, it is part of the limit.
    let asked = [["source = \"CS 454\"", "source = \"CS 454\"\nmodel_factor = \"tests\""]];
    let (_, answer, ending) = judged("ladder-tests", &asked, &[], &[]);
    assert_eq!((ending.code, &answer["status"]), (Some(1), &"inadequate".into()), "{answer}");
    assert_eq!(answer["checks"][0]["limit"], 1.9, "{answer}");
}

/// A stage that the file asks for and the command leaves out: nothing is adequate, and the head, the object and the table of a fleet say so.
#[test]
fn a_stage_that_is_skipped_passes_nothing() {
    let changes = [&[THIN][..], &LIGHT].concat();
    let (_, answer, _) = judged("ladder-thin", &changes, &[], &[]);
    assert_eq!(answer["status"], "inadequate", "{answer}");
    let (stage, answer, ending) = judged("ladder-skipped", &changes, &[], &["--skip", "vehicles"]);
    assert_eq!((ending.code, &answer["status"]), (Some(1), &"undetermined".into()), "{answer}");
    assert_eq!(answer["skipped"], serde_json::json!(["vehicles"]));
    assert!(head(&answer).contains("vehicles left out"), "{answer}");
    std::fs::create_dir(stage.folder.join("fleet")).expect("a folder");
    stage.write("fleet/bridge.toml", stage.read("bridge.toml"));
    stage.run(&["assess", "fleet", "--out", "fleet-out", "--skip", "vehicles", "--skip", "sensitivity"]);
    assert!(stage.read("fleet-out/fleet.csv").contains(head(&answer)), "{}", stage.read("fleet-out/fleet.csv"));
}

/// One thing that the rule asks for is missing: open, and the head says what.
#[test]
fn a_rule_without_one_thing_that_it_asks_for_is_open() {
    let vehicles = "vehicles = [\"cs-454\"]";
    for (name, change, words) in [
        ("one", [vehicles, "vehicles = [\"cs454-single\"]"], "load cases of CS 454 left out"),
        ("strength", ["compressive_strength = \"8 MPa\"", ""], "no compressive strength"),
        ("unlimited", ["\"8 MPa\"", "\"unlimited\""], "no compressive strength"),
        ("dispersal", ["step =", "dispersal = \"file\"\nstep ="], "loads spread by the file"),
        ("way", ["step =", "directions = \"right\"\nstep ="], "one way only"),
        ("runs", ["step =", "subsets = false\nstep ="], "axles that relieve"),
        ("step", ["step = \"0.25 m\"", "step = \"2 m\""], "positions too far apart"),
        ("rule", ["rule = \"cs-454\"", "rule = \"characteristic\""], "vehicles not compared"),
        ("skew", ["skew = \"0 deg\"", "skew = \"30 deg\""], "skew by 30 degrees"),
    ] {
        let (_, answer, ending) = judged(&format!("ladder-open-{name}"), &[change], &[], &["--skip", "collapse"]);
        assert_eq!((ending.code, &answer["status"]), (Some(1), &"undetermined".into()), "{name}: {answer}");
        assert!(head(&answer).contains(words), "{name}: {}", head(&answer));
    }
}

/// A lorry of the engineer's own under a factor of its own: safety is that of the factor that acted, whatever the rule has.
#[test]
fn the_factor_that_acts_counts() {
    let lorry = |live_load: &str, loads: &str| {
        format!(
            "code = \"lorry\"\ntitle = \"Lorry\"\nways = \"road\"\nsource = {{ text = \"C&U\", date = \"1986\", confidence = \"read\" }}\n\
             [[vehicle]]\ncode = \"our-lorry\"\ntitle = \"Lorry 44 t\"\naxle_loads_kn = [{loads}]\nspacings_m = [3.0, 1.3]\n\
             axles_may_be_dropped = true\nwheel_track_m = 1.80\ncontact_length_m = 0.30\n[[under]]\nrule = \"cs-454\"\n\
             live_load = {{ value = {live_load}, source = {{ text = \"our letter\", date = \"2020\", confidence = \"recalled\" }} }}\n\
             [under.impact]\nkind = \"included\"\nsource = {{ text = \"x\", date = \"2020\", confidence = \"recalled\" }}\n"
        )
    };
    let named =
        [["vehicles = [\"cs-454\"]", "vehicles = [\"cs-454\", \"our-lorry\"]\nvehicle_files = [\"lorry.toml\"]"]];
    let with = |name: &str, text: String| judged(name, &named, &[("lorry.toml", &text)], &["--skip", "collapse"]).1;
    let answer = with("ladder-under-one", lorry("1.0", "68.7, 103.0, 57.0"));
    assert_eq!(answer["status"], "undetermined", "{answer}");
    assert!(head(&answer).contains("live loads without safety: our-lorry 1"), "{}", head(&answer));
    let answer = with("ladder-under-less", lorry("1.3", "68.7, 103.0, 57.0"));
    assert!(head(&answer).contains("not the library's: live load"), "{}", head(&answer));
    let beside = answer["beside"].to_string();
    assert!(beside.contains("our letter"), "{beside}");
    // Tonnes as kilonewtons are doubtful, and the line of the verdict says so.
    let answer = with("ladder-under-tonnes", lorry("1.9", "7.0, 10.5, 5.8"));
    assert!(answer["status"] != "adequate" || head(&answer).contains("doubtful value"), "{answer}");
    assert!(!answer["doubtful"].as_array().expect("codes").is_empty(), "{answer}");
}

/// A lorry of one's own is not the normal traffic of a standard, whatever its file, or an own rule of the standard's name, calls it.
#[test]
fn a_vehicle_of_ones_own_stands_for_no_standard() {
    let source = "source = { text = \"x\", date = \"2020\", confidence = \"read\" }";
    let lorry = |model: &str, vehicle: &str| {
        format!(
            "code = \"light\"\ntitle = \"Normal traffic\"\nways = \"road\"\n{model}\n{source}\n[[vehicle]]\ncode = \"v-light\"\n\
             title = \"Lorry\"\n{vehicle}\naxle_loads_kn = [12.0]\nspacings_m = []\naxles_may_be_dropped = true\n\
             wheel_track_m = 1.8\ncontact_length_m = 0.3\n[[under]]\nrule = \"cs-454\"\nlive_load = {{ value = 1.9, {source} }}\n\
             [under.impact]\nkind = \"critical-axle\"\n[under.impact.factor]\nvalue = 1.8\n{source}\n"
        )
    };
    let rule =
        include_str!("../../../rules/data/rules/cs-454.toml").replace("models = [\"cs-454\"", "models = [\"light\"");
    let own = ["vehicles = [\"cs-454\"]", "vehicles = [\"light\"]\nvehicle_files = [\"v.toml\"]"];
    let under = ["rule = \"cs-454\"", "rule_file = \"r.toml\""];
    let cases = [
        ("ladder-own", lorry("", ""), vec![own]),
        ("ladder-own-loading", lorry("loading = \"normal traffic\"", ""), vec![own]),
        ("ladder-own-grades", lorry("grades = \"weight\"", "grade = \"44 t\""), vec![own]),
        ("ladder-own-rule", lorry("loading = \"normal traffic\"", ""), vec![own, under]),
        (
            "ladder-own-code",
            lorry("loading = \"CS 454, normal traffic\"", "").replace("v-light", "cs454-single"),
            vec![own],
        ),
    ];
    for (name, text, changes) in cases {
        let files = [("v.toml", text.as_str()), ("r.toml", rule.as_str())];
        let (_, answer, ending) = judged(name, &changes, &files, &["--skip", "collapse"]);
        assert_eq!(
            (ending.code, &answer["status"]),
            (Some(1), &"undetermined".into()),
            "{name}: {answer} {}",
            ending.stderr
        );
        assert!(head(&answer).contains("left out"), "{name}: {}", head(&answer));
        let left_out = answer["load_cases_left_out"].as_array().expect("codes");
        assert!(left_out.contains(&"cs454-single".into()), "{name}: {left_out:?}");
    }
}

/// A value and its limit are written with digits that tell them apart.
#[test]
fn a_load_just_below_its_limit_is_told_from_it() {
    let stage = Stage::new("ladder-digits");
    let at = BASE.find("[sweep]").expect("a sweep");
    let text = BASE[..at].to_owned() + "[assess]\nadequacy_factor = 1.9\nadequacy_source = \"x\"\n";
    stage.write("bridge.toml", &text);
    let (answer, _) = stage.object(&["assess", "bridge.toml", "--skip", "sensitivity"]);
    let value = answer["checks"][0]["value"].as_f64().expect("a factor");
    let force = 100.0 * value / 1.899_9;
    stage.write("bridge.toml", text.replace("\"100 kN\"", &format!("\"{force} kN\"")));
    let shown = stage.run(&["assess", "bridge.toml", "--skip", "sensitivity"]).stdout;
    assert!(shown.contains("Not adequate") && shown.contains("1.8999 where the limit is 1.9000"), "{shown}");
}

/// The page of ordinary bridges: sound ones pass by their standard, weak ones fail, and none is left open. Every sixth one.
#[test]
fn ordinary_bridges_are_judged_as_their_page_tells() {
    judged_as_told("ladder-ordinary", 6);
}

#[test]
#[ignore = "a minute; .ci/slow"]
fn twelve_ordinary_bridges_are_judged_as_their_page_tells() {
    judged_as_told("ladder-ordinary-all", 1);
}

fn judged_as_told(name: &str, step: usize) {
    let page = include_str!("../../../../docs/verification/ordinary-bridges.md");
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/verification/ordinary");
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| "))
        .map(|row| row.trim_end_matches(" |").split(" | ").collect::<Vec<_>>())
        .filter(|row| folder.join(format!("{}.toml", row[0])).is_file())
        .collect();
    assert_eq!(rows.len(), 12);
    let stage = Stage::new(name);
    for row in rows.into_iter().step_by(step) {
        let [name, rule, governs, adequacy, _, status] = row[..] else { panic!("{row:?}") };
        stage.write("bridge.toml", std::fs::read(folder.join(format!("{name}.toml"))).expect("a bridge"));
        let words = ["assess", "bridge.toml", "--out", name, "--skip", "sensitivity", "--skip", "collapse"];
        let (answer, ending) = stage.object(&words);
        assert_eq!(ending.code, Some(u8::from(status != "adequate").into()), "{name}: {}", ending.stderr);
        assert_eq!(
            (&answer["status"], &answer["governing"]["load_model"]),
            (&status.into(), &governs.into()),
            "{name}"
        );
        assert!(head(&answer).contains(rule), "{name}: {}", head(&answer));
        let found = 1.0 / answer["governing"]["utilisation"].as_f64().expect("a share");
        let told: f64 = adequacy.parse().expect("a number");
        assert!((found - told).abs() < 1e-3, "{name}: {found}");
    }
}
