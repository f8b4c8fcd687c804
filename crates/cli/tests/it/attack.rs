//! A failing bridge changed in one thing, three hundred times: nothing is adequate without the change in the line of the verdict.

#![allow(clippy::print_stdout)]

use crate::ladder::BASE;
use crate::stage::Stage;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// One thing that somebody changes.
struct Change {
    /// Its kind, and what it is.
    kind: &'static str,
    name: String,
    /// The bridge file with it.
    text: String,
    /// A file beside it.
    beside: Option<(&'static str, String)>,
    /// Stages that the command skips.
    skip: &'static [&'static str],
    /// Words of which the head has one where the bridge is called adequate.
    named: Vec<String>,
}

/// The base with a ring that CS 454 turns down by half, and a light load with a factor and a source beside its vehicles.
fn failing() -> String {
    BASE.replace("thickness = \"0.45 m\"", "thickness = \"0.30 m\"")
        .replace("axle_force = \"100 kN\"", "axle_force = \"20 kN\"")
        .replace("source = \"CS 454\"", "source = \"CS 454\"\nadequacy_factor = 1.9\nadequacy_source = \"CS 454, 7.3\"")
}

fn change(kind: &'static str, name: impl Into<String>, text: String, named: &[&str]) -> Change {
    let named = named.iter().map(|word| (*word).to_owned()).collect();
    Change { kind, name: name.into(), text, beside: None, skip: &[], named }
}

/// Every change.
fn changes() -> Vec<Change> {
    let base = failing();
    let mut list = Vec::new();
    omissions(&base, &mut list);
    units(&base, &mut list);
    for skip in [
        &["vehicles"][..],
        &["collapse"],
        &["service"],
        &["update"],
        &["cases"],
        &["support-movement"],
        &["vehicles", "collapse"],
    ] {
        list.push(Change { skip, ..change("skip", skip.join(" "), base.clone(), &["left out"]) });
    }
    load_cases(&base, &mut list);
    sweep_keys(&base, &mut list);
    own_factors(&base, &mut list);
    rule_files(&base, &mut list);
    vehicle_files(&base, &mut list);
    list
}

/// A line or a table less.
fn omissions(base: &str, list: &mut Vec<Change>) {
    let lines: Vec<&str> = base.lines().collect();
    for (k, line) in lines.iter().enumerate() {
        let end = match line.starts_with('[') {
            true => {
                lines[k + 1..].iter().position(|next| next.starts_with('[')).map_or(lines.len(), |more| k + 1 + more)
            }
            false => k + 1,
        };
        let text = [&lines[..k], &lines[end..]].concat().join("\n");
        list.push(change(
            "omission",
            format!("{line} ({k})"),
            text,
            &["not given", "doubtful", "left out", "the file's factor"],
        ));
    }
}

/// The unit of a quantity put in place of another's.
fn units(base: &str, list: &mut Vec<Change>) {
    let families = [
        &["m", "mm", "cm", "ft", "in", "yd"][..],
        &["kg/m^3", "t/m^3", "kN/m^3", "lb/ft^3", "g/cm^3"],
        &["MPa", "kPa", "GPa", "Pa", "psi", "N/mm^2"],
        &["kPa", "MPa", "GPa", "Pa"],
        &["kN", "N", "MN", "t", "lbf"],
        &["deg", "rad"],
    ];
    for (k, line) in base.lines().enumerate() {
        let Some((key, value)) = line.split_once(" = \"") else { continue };
        // Positions a quarter of a millimetre apart take an hour; steps have a list of their own.
        if key == "step" {
            continue;
        }
        let Some((number, unit)) = value.trim_end_matches('"').split_once(' ') else { continue };
        for family in families.iter().filter(|family| family[0] == unit) {
            for other in &family[1..] {
                let changed = format!("{key} = \"{number} {other}\"");
                let text: Vec<&str> =
                    base.lines().enumerate().map(|(j, own)| if j == k { changed.as_str() } else { own }).collect();
                list.push(change("unit", format!("{key} in {other}"), text.join("\n"), &["doubtful", "not given"]));
            }
        }
    }
}

/// Fewer, other and lighter vehicles; other rules.
fn load_cases(base: &str, list: &mut Vec<Change>) {
    let own = "vehicles = [\"cs-454\"]";
    let cases =
        ["single", "bogie-8", "bogie-9.5", "bogie-10", "triple-7", "triple-8"].map(|case| format!("cs454-{case}"));
    let mut with = |name: String, vehicles: String| {
        // A restriction that is carried is one of its grade, and the line of the verdict says which.
        let named = ["left out", " for "];
        list.push(change("load case", name, base.replace(own, &format!("vehicles = [{vehicles}]")), &named));
    };
    for (k, one) in cases.iter().enumerate() {
        with(one.clone(), format!("\"{one}\""));
        let others: Vec<String> =
            cases.iter().filter(|other| *other != one).map(|other| format!("\"{other}\"")).collect();
        with(format!("all but {one}"), others.join(", "));
        for other in &cases[k + 1..] {
            with(format!("{one} and {other}"), format!("\"{one}\", \"{other}\""));
        }
    }
    for code in [
        "gb-3t",
        "gb-7.5t",
        "gb-10t",
        "gb-13t",
        "gb-18t",
        "gb-26t",
        "gb-40t",
        "gb-44t",
        "gb-fire-1",
        "gb-fire-2",
        "hb-25",
        "hb-30",
        "hb-37.5",
        "hb-45",
        "sv-80",
        "sv-100",
        "sv-196",
        "hb",
        "sv",
        "gb-restrictions",
        "lm1",
        "lm71",
        "ra10",
        "hl-93",
    ] {
        with(code.to_owned(), format!("\"{code}\""));
    }
    for (rule, vehicles) in [
        ("characteristic", "cs-454"),
        ("characteristic", "gb-3t"),
        ("en-1991-2", "lm1"),
        ("en-1991-2", "lm2"),
        ("en-1991-2", "lm71"),
        ("en-1991-2", "en15528-a"),
        ("aashto-mbe", "aashto-legal"),
        ("aashto-mbe", "aashto-type-3"),
        ("aashto-mbe", "hl-93"),
        ("aashto-mbe", "hs20"),
        ("irs-bridge-rules", "25t-2008"),
        ("irs-bridge-rules", "paper-short"),
        ("nr-civ-025", "ra1"),
        ("nr-civ-025", "ra10"),
    ] {
        let text = base.replace(own, &format!("vehicles = [\"{vehicles}\"]"));
        let text = text.replace("rule = \"cs-454\"", &format!("rule = \"{rule}\""));
        list.push(change("rule", format!("{vehicles} by {rule}"), text, &["EN 1991-2", "AASHTO", "IRS", "NR/GN"]));
    }
}

/// What a sweep and a carriageway may say.
fn sweep_keys(base: &str, list: &mut Vec<Change>) {
    for (line, named) in [
        ("dispersal = \"file\"", "spread by the file"),
        ("directions = \"right\"", "one way"),
        ("directions = \"left\"", "one way"),
        ("subsets = false", "relieve"),
        ("braking = 0.0", "braking"),
        ("braking = -0.2", "braking"),
        ("braking_reason = \"none\"", "braking"),
    ] {
        let text = base.replace("step = \"0.25 m\"", &format!("step = \"0.25 m\"\n{line}"));
        list.push(change("sweep", line, text, &[named]));
    }
    for step in ["0.5 m", "1 m", "2 m", "5 m", "10 m", "100 m", "1 km", "250 mm"] {
        let text = base.replace("step = \"0.25 m\"", &format!("step = \"{step}\""));
        list.push(change("sweep", format!("step {step}"), text, &["too far apart"]));
    }
    for (from, to, named) in [
        ("lanes = 2", "lanes = 1", "lane"),
        ("lanes = 2", "lanes = 0", "lane"),
        ("lanes = 2", "lanes = 2\nlane_width = \"5 m\"", "lane_width"),
        ("lanes = 2", "lanes = 2\nlane_width = \"20 m\"", "lane_width"),
        ("edge_distance = \"0.6 m\"", "edge_distance = \"2.9 m\"", "edge_distance"),
        ("edge_distance = \"0.6 m\"", "edge_distance = \"6 m\"", "edge_distance"),
        ("skew = \"0 deg\"", "skew = \"15 deg\"", "skew"),
        ("skew = \"0 deg\"", "skew = \"45 deg\"", "skew"),
        ("skew = \"0 deg\"", "skew = \"45 deg\"\ncracks = []", "skew"),
    ] {
        list.push(change("carriageway", to, base.replace(from, to), &[named]));
    }
}

/// Factors of the file, with and without sources; tension, cohesion, water.
fn own_factors(base: &str, list: &mut Vec<Change>) {
    let assess = "adequacy_factor = 1.9\nadequacy_source = \"CS 454, 7.3\"";
    for more in [
        "adequacy_factor = 0.1\nadequacy_source = \"CS 454\"",
        "adequacy_factor = 1.0\nload_factor_included = 1.9\nadequacy_source = \"x\"",
        "adequacy_factor = 0.5\nload_factor_included = 20\nadequacy_source = \"x\"",
        "adequacy_factor = 1.1\nmodel_factor = 1.0\nadequacy_source = \"owner\"",
        "adequacy_factor = 1.9",
        "model_factor = 1.0",
        "model_factor = \"tests\"",
        "model_factor = 0.5",
        "skew_source = \"report 12\"",
        "deflection_limit = \"100 mm\"",
        "compression_limit = \"100 MPa\"\ntension_limit = \"100 MPa\"",
        "permissible_share = 1.0",
    ] {
        list.push(change("factor", more.replace('\n', "; "), base.replace(assess, more), &["model factor", "skew"]));
    }
    for (from, to) in [
        ("cohesion = \"0 kPa\"", "cohesion = \"500 kPa\""),
        ("cohesion = \"0 kPa\"", "cohesion = \"5 MPa\"\ntensile_strength = \"3 MPa\""),
        ("cohesion = \"0 kPa\"", "cohesion = \"200 kPa\"\ntensile_strength = \"50 kPa\""),
        ("cohesion = \"0 kPa\"", "cohesion = \"0 kPa\"\ntensile_strength = \"1 MPa\""),
        ("friction_angle = \"33 deg\"", "friction_angle = \"75 deg\""),
        ("compressive_strength = \"8 MPa\"", "compressive_strength = \"8000 MPa\""),
        ("compressive_strength = \"8 MPa\"", "compressive_strength = \"unlimited\""),
        ("density = \"2200 kg/m^3\"", "density = \"22000 kg/m^3\""),
        ("density = \"1900 kg/m^3\"", "density = \"19000 kg/m^3\""),
    ] {
        list.push(change(
            "material",
            to.replace('\n', "; "),
            base.replace(from, to),
            &["doubtful", "without", "strength"],
        ));
    }
}

/// The standard's rule as a file of somebody's, one factor changed.
fn rule_files(base: &str, list: &mut Vec<Change>) {
    let standard = include_str!("../../../rules/data/rules/cs-454.toml");
    let text = base.replace("rule = \"cs-454\"", "rule_file = \"rule.toml\"");
    let mut with = |name: String, rule: String| {
        let beside = Some(("rule.toml", rule));
        list.push(Change { beside, ..change("rule file", name, text.clone(), &["rule \"", "not the library's"]) });
    };
    with("as it is".into(), standard.to_owned());
    with("another code".into(), standard.replace("code = \"cs-454\"", "code = \"ours\""));
    let read = |rule: &str| rule.replace("\"recalled\"", "\"read\"").replace("\"assumed\"", "\"read\"");
    with("all read".into(), read(standard));
    let factors = [
        "masonry_weight",
        "fill_weight",
        "surfacing_weight",
        "weight_favourable",
        "live_load",
        "masonry_strength",
        "friction",
        "fill_pressure",
        "model",
        "condition",
    ];
    for factor in factors {
        for value in ["0.5", "1.0", "1.2", "2.0"] {
            let head = format!("[factors.{factor}]\nvalue = ");
            let Some(at) = standard.find(&head) else { continue };
            let end = at + head.len() + standard[at + head.len()..].find('\n').unwrap_or(0);
            let changed = format!("{}{head}{value}{}", &standard[..at], &standard[end..]);
            with(format!("{factor} {value}"), changed.clone());
            with(format!("{factor} {value}, all read"), read(&changed));
        }
    }
    for (from, to) in [
        ("value = 1.8", "value = 1.0"),
        ("kind = \"critical-axle\"", "kind = \"all-axles\""),
        ("length_per_depth = 1.0", "length_per_depth = 5.0"),
        ("width_base_m = 1.5", "width_base_m = 6.0"),
        ("length_base_m = 0.3", "length_base_m = 3.0"),
    ] {
        with(to.to_owned(), standard.replace(from, to));
    }
}

/// A lorry of somebody's own in place of the standard's axles.
fn vehicle_files(base: &str, list: &mut Vec<Change>) {
    let file = |loads: &str, distances: &str, track: &str, live_load: &str| {
        format!(
            "code = \"lorry\"\ntitle = \"Lorry\"\nways = \"road\"\nsource = {{ text = \"C&U\", date = \"1986\", confidence = \"read\" }}\n[[vehicle]]\n\
             code = \"our-lorry\"\ntitle = \"Lorry\"\naxle_loads_kn = [{loads}]\nspacings_m = [{distances}]\naxles_may_be_dropped = true\n\
             wheel_track_m = {track}\ncontact_length_m = 0.30\n[[under]]\nrule = \"cs-454\"\n\
             live_load = {{ value = {live_load}, source = {{ text = \"x\", date = \"2020\", confidence = \"recalled\" }} }}\n[under.impact]\n\
             kind = \"included\"\nsource = {{ text = \"x\", date = \"2020\", confidence = \"recalled\" }}\n"
        )
    };
    let vehicles = "vehicles = [\"our-lorry\"]\nvehicle_files = [\"lorry.toml\"]";
    let text = base.replace("vehicles = [\"cs-454\"]", vehicles);
    for live_load in ["0.5", "1.0", "1.3", "1.9", "4.5"] {
        for (loads, distances, track) in [
            ("68.7, 103.0, 57.0", "3.0, 1.3", "1.8"),
            ("7.0, 10.5, 5.8", "3.0, 1.3", "1.8"),
            ("68.7, 103.0, 57.0", "3000, 1300", "1.8"),
            ("68.7, 103.0, 57.0", "3.0, 1.3", "1800"),
            ("1.0", "", "1.8"),
        ] {
            let beside = Some(("lorry.toml", file(loads, distances, track, live_load)));
            let name = format!("{loads}, track {track}, factor {live_load}");
            list.push(Change { beside, ..change("vehicle file", name, text.clone(), &["left out"]) });
        }
    }
}

/// What became of a change: its status, and whether a verdict of adequacy says nothing of it.
fn tried(k: usize, change: &Change) -> (String, bool, String) {
    let stage = Stage::new(&format!("attack-{k}"));
    stage.write("bridge.toml", &change.text);
    if let Some((file, text)) = &change.beside {
        stage.write(file, text);
    }
    let mut words = vec!["assess", "bridge.toml", "--out", "out", "--skip", "sensitivity"];
    change.skip.iter().for_each(|stage| words.extend(["--skip", stage]));
    let (answer, _) = stage.object(&words);
    let status = answer["status"].as_str().unwrap_or("none").to_owned();
    let head = answer["head"].as_str().unwrap_or_default().to_owned();
    let silent = status == "adequate" && !change.named.iter().any(|word| head.contains(word.as_str()));
    (status, silent, head)
}

/// Counts by kind and status, and what is silent.
fn attack(list: &[Change]) -> (Vec<(String, usize)>, Vec<String>) {
    let next = AtomicUsize::new(0);
    type Found = Vec<(usize, (String, bool, String))>;
    let found: Mutex<Found> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    let Some(change) = list.get(k) else { break };
                    let one = tried(k, change);
                    found.lock().expect("a list").push((k, one));
                }
            });
        }
    });
    let mut counts: Vec<(String, usize)> = Vec::new();
    let mut silent = Vec::new();
    let mut found = found.into_inner().expect("a list");
    found.sort_by_key(|(k, _)| *k);
    for (k, (status, quiet, head)) in found {
        let key = format!("{}: {status}", list[k].kind);
        match counts.iter_mut().find(|(own, _)| *own == key) {
            Some((_, count)) => *count += 1,
            None => counts.push((key, 1)),
        }
        if quiet {
            silent.push(format!("{}, {}: {head}", list[k].kind, list[k].name));
        }
    }
    (counts, silent)
}

/// A change in twenty-four, spread over all kinds.
#[test]
fn a_failing_bridge_is_not_made_adequate_in_silence() {
    let list: Vec<Change> = changes().into_iter().step_by(24).collect();
    let (_, silent) = attack(&list);
    assert!(silent.is_empty(), "{silent:#?}");
}

/// All of them; `docs/verification/attack.md` has the counts.
#[test]
#[ignore = "minutes"]
fn three_hundred_changes_make_nothing_adequate_in_silence() {
    let list = changes();
    assert!(list.len() >= 300, "{}", list.len());
    let unchanged = change("unchanged", "", failing(), &[]);
    assert_eq!(tried(list.len(), &unchanged).0, "inadequate");
    let (counts, silent) = attack(&list);
    counts.iter().for_each(|(key, count)| println!("{count:>5}  {key}"));
    println!("{:>5}  changes", list.len());
    assert!(silent.is_empty(), "{silent:#?}");
}
