//! What somebody changes of a bridge that fails.

use crate::ladder::BASE;

/// One thing that somebody changes.
pub(super) struct Change {
    /// Its kind, and what it is.
    pub kind: &'static str,
    pub name: String,
    /// The bridge file with it.
    pub text: String,
    /// A file beside it.
    pub beside: Option<(&'static str, String)>,
    /// Stages that the command skips.
    pub skip: &'static [&'static str],
    /// Words of which the head has one where the bridge is called adequate.
    pub named: Vec<String>,
}

/// The base with a ring that CS 454 turns down by half, and a light load with a factor and a source beside its vehicles.
pub(super) fn failing() -> String {
    BASE.replace("thickness = \"0.45 m\"", "thickness = \"0.30 m\"")
        .replace("axle_force = \"100 kN\"", "axle_force = \"20 kN\"")
        .replace("source = \"CS 454\"", "source = \"CS 454\"\nadequacy_factor = 1.9\nadequacy_source = \"CS 454, 7.3\"")
}

pub(super) fn change(kind: &'static str, name: impl Into<String>, text: String, named: &[&str]) -> Change {
    let named = named.iter().map(|word| (*word).to_owned()).collect();
    Change { kind, name: name.into(), text, beside: None, skip: &[], named }
}

/// Every change.
pub(super) fn changes() -> Vec<Change> {
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
    own_traffic(&base, &mut list);
    cover(&base, &mut list);
    by_file(&mut list);
    rails(&mut list);
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
        ("lanes = 2", "lanes = 2\nlane_width = \"5 m\"", "lane"),
        ("lanes = 2", "lanes = 2\nlane_width = \"20 m\"", "lane"),
        ("edge_distance = \"0.6 m\"", "edge_distance = \"2.9 m\"", "edge"),
        ("edge_distance = \"0.6 m\"", "edge_distance = \"6 m\"", "edge"),
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
    let standard = include_str!("../../../../rules/data/rules/cs-454.toml");
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

/// A light lorry of one's own that its file, or a rule file, makes the traffic of the standard.
fn own_traffic(base: &str, list: &mut Vec<Change>) {
    let source = "source = { text = \"x\", date = \"2020\", confidence = \"read\" }";
    let file = |model: &str, vehicles: &[&str], grade: &str| {
        let vehicles: String = vehicles
            .iter()
            .map(|code| {
                format!(
                    "[[vehicle]]\ncode = \"{code}\"\ntitle = \"Lorry\"\n{grade}\naxle_loads_kn = [12.0]\nspacings_m = []\n\
                     axles_may_be_dropped = true\nwheel_track_m = 1.8\ncontact_length_m = 0.3\n"
                )
            })
            .collect();
        format!(
            "code = \"light\"\ntitle = \"Normal traffic\"\nways = \"road\"\n{model}\n{source}\n{vehicles}[[under]]\nrule = \"cs-454\"\n\
             live_load = {{ value = 1.9, {source} }}\n[under.impact]\nkind = \"critical-axle\"\n[under.impact.factor]\nvalue = 1.8\n{source}\n"
        )
    };
    let of_library =
        ["single", "bogie-8", "bogie-9.5", "bogie-10", "triple-7", "triple-8"].map(|case| format!("cs454-{case}"));
    let of_library: Vec<&str> = of_library.iter().map(String::as_str).collect();
    let text = base.replace("vehicles = [\"cs-454\"]", "vehicles = [\"light\"]\nvehicle_files = [\"lorry.toml\"]");
    for model in ["", "loading = \"normal traffic\"", "loading = \"CS 454, normal traffic\"", "grades = \"weight\""] {
        for codes in [&["our-lorry"][..], &of_library] {
            let grades: &[&str] =
                if model.starts_with("grades") { &["grade = \"3 t\"", "grade = \"44 t\""] } else { &[""] };
            for grade in grades {
                let beside = Some(("lorry.toml", file(model, codes, grade)));
                let name = format!("{model} {grade} {}", codes[0]);
                list.push(Change { beside, ..change("own traffic", name, text.clone(), &["left out"]) });
            }
        }
    }
}

/// Cover through which nothing is left of an axle.
fn cover(base: &str, list: &mut Vec<Change>) {
    let deep = base.replacen("thickness = \"0.40 m\"", "thickness = \"4.0 m\"", 1);
    list.push(change("cover", "4 m of fill", deep, &["doubtful"]));
    for more in ["as = \"nothing\"", "weighs = false"] {
        let layer = format!(
            "[[cover]]\nlayer = \"fill\"\nthickness = \"3 m\"\ndensity = \"1900 kg/m^3\"\n{more}\n[carriageway]"
        );
        list.push(change("cover", more, base.replacen("[carriageway]", &layer, 1), &["doubtful"]));
    }
}

/// A bridge that fails by the file's own factor on its load, of which something is shared out, included or named.
fn by_file(list: &mut Vec<Change>) {
    let [from, to] = ["[sweep]", "[assess]"].map(|table| BASE.find(table).expect("a table"));
    let base = BASE[..from].replace("axle_force = \"100 kN\"", "axle_force = \"300 kN\"")
        + &BASE[to..].replace(
            "source = \"CS 454\"",
            "source = \"CS 454\"\nadequacy_factor = 1.9\nadequacy_source = \"CS 454, 7.3\"",
        );
    let named = ["doubtful", "carry a factor", "whole length", "model factor"];
    for (from, to) in [
        ("effective_width = \"3 m\"", "effective_width = \"6 m\""),
        ("effective_width = \"3 m\"", "effective_width = \"5 m\""),
        ("adequacy_factor = 1.9", "adequacy_factor = 1.0\nload_factor_included = 1.0001\nmodel_factor = 1.0"),
        ("adequacy_source = \"CS 454, 7.3\"", "adequacy_source = \" \"\nmodel_factor = 1.0"),
        ("adequacy_source = \"CS 454, 7.3\"", "adequacy_source = \"-\"\nmodel_factor = 1.0"),
        ("thickness = \"0.40 m\"", "thickness = \"4.0 m\""),
    ] {
        assert!(base.contains(from), "{from}");
        list.push(change("by the file", to.replace('\n', "; "), base.replacen(from, to, 1), &named));
    }
}

/// A railway bridge that EN 1991-2 turns down with its braking, of which something is left out.
fn rails(list: &mut Vec<Change>) {
    let base = include_str!("../../../../../docs/verification/ordinary/stone-10m-rail.toml");
    let [at, end] = ["braking = 0\n", "braking_reason"].map(|key| base.find(key).expect("a key"));
    let end = end + base[end..].find('\n').expect("its end") + 1;
    for braking in [
        "",
        "braking = 0\n",
        "braking = 1e-9\n",
        "braking = 0.01\n",
        "braking = 0\nbraking_reason = \"\"\n",
        "braking = 0\nbraking_reason = \" - \"\n",
        "braking = 0\nbraking_reason = \"long track\"\n",
        "braking = 0.3\n",
    ] {
        let text = format!("{}{braking}{}", &base[..at], &base[end..]);
        list.push(change("braking", braking.replace('\n', "; "), text, &["braking 0"]));
    }
}
