//! Materials of the library that a bridge file names: what stands for its lines, and that it is said.

use crate::stage::Stage;
use extrados::materials;

const BRIDGE: &str = r#"[bridge]
name = "named"
width = "5 m"
[[span]]
profile = "segmental"
span = "6 m"
rise = "1.5 m"
thickness = "0.45 m"
voussoirs = 23
[[cover]]
layer = "fill"
thickness = "0.3 m"
MATERIAL_old-fill
[[cover]]
layer = "surfacing"
thickness = "0.2 m"
density = "2300 kg/m^3"
[masonry]
MATERIAL_sandstone
density = "2300 kg/m^3"
[joint]
MATERIAL_old-joints
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
kind = "patch"
pressure = "30 kPa"
length = "0.3 m"
at = "1/4 of span 1"
[analysis]
method = "limit"
[assess]
adequacy_factor = 1.0
"#;

/// The bridge with names, and the same with the values of the library written out, density of the masonry left to the file.
fn both() -> [String; 2] {
    let (mut named, mut written) = (BRIDGE.to_owned(), BRIDGE.to_owned());
    for one in materials() {
        let mark = format!("MATERIAL_{}\n", one.code);
        named = named.replace(&mark, &format!("material = \"{}\"\n", one.code));
        // A layer that is weight has no strength.
        let wanted = |key: &str| match one.code.as_str() {
            "sandstone" => key != "density",
            "old-fill" => ["density", "elastic_modulus"].contains(&key),
            _ => true,
        };
        let lines = one.values.iter().filter(|value| wanted(&value.key));
        let lines: String = lines.map(|value| format!("{} = \"{}\"\n", value.key, value.usual)).collect();
        written = written.replace(&mark, &lines);
    }
    [named, written]
}

/// A name is as good as its lines, whatever is asked; what the table writes itself stays; and every value that is taken is said and stands
/// among what is to be confirmed.
#[test]
fn a_material_by_name_is_the_material_written_out() {
    let stage = Stage::new("materials-by-name");
    let [named, written] = both();
    assert!(!named.contains("MATERIAL") && !written.contains("MATERIAL"), "{written}");
    stage.write("named.toml", &named);
    stage.write("written.toml", &written);
    for method in ["limit", "path"] {
        let load = |file| stage.object(&["collapse", file, "--method", method, "--out", "out"]).0;
        let [by_name, in_full] = ["named.toml", "written.toml"].map(load);
        assert!(by_name["collapse_load_kn_per_m"].as_f64().is_some_and(|load| load > 10.0), "{by_name}");
        assert_eq!(by_name["collapse_load_kn_per_m"], in_full["collapse_load_kn_per_m"], "{method}");
        let told =
            |object: &serde_json::Value| object["assumptions"].to_string().contains("usual values of the library");
        assert!(told(&by_name) && !told(&in_full), "{method}: {}", by_name["assumptions"]);
    }
    let judged = stage.object(&["assess", "named.toml", "--skip", "sensitivity", "--out", "judged"]).0;
    let taken = judged["taken"].to_string();
    for part in
        ["materials of the library", "cover[1].density 1950 kg/m^3 (old-fill)", "masonry.compressive_strength 10 MPa"]
    {
        assert!(taken.contains(part), "{part} is not in {taken}");
    }
    assert!(!taken.contains("masonry.density"), "{taken}");
    let report = stage.read("judged/report.html");
    let confirm = report.rsplit("To be confirmed on site").next().and_then(|rest| rest.split("<h2").next());
    assert!(
        confirm.is_some_and(|part| part.contains("not measured: library, old-joints, 27 deg to 37 deg")),
        "{confirm:?}"
    );
    // What is taken can be varied like what is written.
    let varied = ["vary", "named.toml", "--set", "masonry.compressive_strength=5MPa,10MPa", "--out", "varied"];
    let (rows, ending) = stage.object(&varied);
    assert_eq!(ending.code, Some(0), "{} {rows}", ending.stderr);
}

/// A name that there is none of is one mistake with what may be written, and not a list of keys that are missing.
#[test]
fn a_name_that_there_is_none_of_is_one_mistake() {
    let stage = Stage::new("materials-unknown");
    let [named, _] = both();
    stage.write("slip.toml", named.replace("old-joints", "old-joint").replace("\"sandstone\"", "\"old-fill\""));
    let (answer, ending) = stage.object(&["check", "slip.toml"]);
    let errors = answer["errors"].as_array().unwrap();
    let told: Vec<_> = errors.iter().map(|one| format!("{} {}", one["code"].as_str().unwrap(), one["help"])).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told.iter().all(|one| one.starts_with("B013")), "{told:?}");
    assert!(told[0].contains("\\\"sandstone\\\"") && !told[0].contains("old-joints"), "{}", told[0]);
    assert!(told[1].contains("did you mean \\\"old-joints\\\"?"), "{}", told[1]);
    assert_eq!(ending.code, Some(2));
}

/// Vehicles are enough for a question: a file without a [[load]] has its vehicles moved, as with `--sweep`.
#[test]
fn a_file_with_vehicles_and_no_load_has_its_vehicles_moved() {
    let stage = Stage::new("sweep-without-load");
    let [named, _] = both();
    let (before, after) = named.split_once("[[load]]").unwrap();
    let after = &after[after.find("[analysis]").unwrap()..];
    let file = format!("{before}[sweep]\nrule = \"cs-454\"\nvehicles = [\"cs454-single\"]\nstep = \"0.5 m\"\n{after}");
    stage.write("vehicles.toml", &file);
    let (swept, ending) = stage.object(&["collapse", "vehicles.toml", "--sweep", "--out", "swept"]);
    assert_eq!((swept["schema"].as_str(), ending.code), (Some("extrados.vehicle-sweep/1"), Some(0)), "{swept}");
    let (plain, _) = stage.object(&["collapse", "vehicles.toml", "--out", "plain"]);
    assert_eq!((&plain["schema"], &plain["vehicles"]), (&swept["schema"], &swept["vehicles"]));
    let judged = stage.object(&["assess", "vehicles.toml", "--skip", "sensitivity", "--out", "judged"]).0;
    assert!(judged["checks"].to_string().contains("cs454-single"), "{}", judged["checks"]);
    // A method that moves no vehicles does not move them by itself.
    let (refused, _) = stage.object(&["collapse", "vehicles.toml", "--method", "dem", "--out", "dem"]);
    assert_eq!(refused["errors"][0]["code"], "F108", "{refused}");
    // Neither load nor vehicle: nothing to analyse.
    stage.write("nothing.toml", format!("{before}{after}"));
    assert_eq!(stage.object(&["check", "nothing.toml"]).0["errors"][0]["code"], "B402");
}
